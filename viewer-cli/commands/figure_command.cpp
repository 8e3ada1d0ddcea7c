// SPDX-License-Identifier: MIT
// `rastertrace figure`: figures of frames for a page, a book or a talk.

#include "commands/figure_command.h"
#include "app/load.h"
#include "app/progress.h"
#include "commands/figure_checks.h"
#include "commands/figure_file.h"
#include "commands/figure_page.h"
#include "frames/frame_files.h"
#include "frames/frame_text.h"

#include <rastertrace/figures/figure.h>
#include <rastertrace/figures/gif.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/selector.h>
#include <rastertrace/trace/tell/shown_steps.h>
#include <rastertrace/trace/tell/working.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// A film whose frames have more pixels of the canvas than that takes minutes, and memory for all of them.
void refuse_large_film(const Canvas& canvas, const std::optional<Region>& region,
                       std::size_t frames) {
    constexpr std::size_t most = std::size_t{1} << 26;
    const auto length = [](int first, int last) {
        return static_cast<std::size_t>(last - first) + 1;
    };
    const std::size_t pixels = region
                                   ? length(region->x0, region->x1) * length(region->y0, region->y1)
                                   : length(1, canvas.width) * length(1, canvas.height);
    if (frames > 1 && frames > most / pixels)
        throw problem_of(
            "",
            fmt::format("expected at most {} pixels of the canvas in a film, found {} "
                        "frames of {}",
                        most, frames, pixels),
            "--region takes a part of the canvas; --every chooses what is a frame, like "
            "--every primitive; --step shows one step");
}

/// The frames of a trace that a figure was asked of.
std::vector<FigureFrame> frames_of(const Trace& trace, const FigureCommand& command) {
    using Which = FigureCommand::Which;
    const auto one = [&](const char* option) {
        const Selector selector = value_or_throw(parse_selector({option, command.selector}, trace));
        return value_or_throw(matching_step(selector, trace, "say which, or use --every"));
    };
    switch (command.which) {
    case Which::last:
        break;
    case Which::film: {
        constexpr std::size_t most = 500;
        std::vector<FigureFrame> frames;
        for (const ShownSteps& steps : film_of(trace, most))
            frames.push_back({.steps = steps});
        if (frames.size() > most)
            throw problem_of(
                "",
                fmt::format("expected at most {} rows, pixels of lines and vertices to "
                            "film, found more",
                            most),
                "--every chooses what is a frame, like --every primitive; --step "
                "shows one step");
        refuse_large_film(trace.canvas, command.figure.region, frames.size());
        if (!frames.empty())
            return frames;
        break;
    }
    case Which::step: {
        const std::size_t n = one("--step");
        return {{.steps = {n, end_of(trace, n)}}};
    }
    case Which::until: {
        const std::size_t n = one("--until");
        if (n == 0)
            throw problem_of("", "--until: expected a step, from 1, found 0");
        return {{.steps = {n, n}, .is_question = true}};
    }
    case Which::every: {
        std::vector<FigureFrame> frames;
        const Selector selector =
            value_or_throw(parse_selector({"--every", command.selector}, trace));
        for (const std::size_t n : value_or_throw(matching_steps(selector, trace)))
            frames.push_back({.steps = {n, end_of(trace, n)}});
        return frames;
    }
    }
    return {{.steps = {0, trace.size()}}};
}

Region all_of(const Canvas& canvas) {
    return {canvas.left(), std::min(canvas.top(), canvas.bottom()), canvas.right(),
            std::max(canvas.top(), canvas.bottom())};
}

bool has_pixel(const Frame& frame, const Region& region) {
    const Canvas& canvas = frame.image.canvas();
    for (int y = region.y0; y <= region.y1; ++y)
        for (int x = region.x0; x <= region.x1; ++x)
            if (frame.drawn_by[canvas.offset_of({x, y})] != 0)
                return true;
    return false;
}

/// The trace that the picture is compared with.
Trace other_trace(const FigureCommand& command, const InputFrames& input, std::size_t frame) {
    if (command.against.find('=') != std::string::npos)
        return input.trace_by(frame, value_or_throw(parse_method({"--against", command.against})));
    return load_trace(command.against, {.limits = command.scenes.limits});
}

/// A trace, its frames, and who draws them.
class TraceFigures {
public:
    TraceFigures(const FigureCommand& command, InputFrames& input, std::size_t frame)
        : command_(command), trace_(input.trace(frame)), frames_(frames_of(trace_, command)) {
        FigureOptions options = command.figure;
        if (options.region)
            check_region(*options.region, trace_.canvas);
        if (!command.against.empty()) {
            against_ = other_trace(command, input, frame);
            if (against_->canvas != trace_.canvas)
                throw problem_of("", "--against: expected a trace with the same canvas, found "
                                     "another one");
            options.against = &*against_;
            options.against_name =
                against_->title == trace_.title ? command.against : against_->title;
        }
        if (input.is_sequence())
            options.title =
                fmt::format("{}, {}", options.title.value_or(trace_.title), input.label(frame));
        maker_ = std::make_unique<FigureMaker>(trace_, frames_, options);
    }

    void set_letter_scale(double scale) { maker_->set_letter_scale(scale); }

    std::size_t count() const { return frames_.size(); }
    const Trace& trace() const { return trace_; }

    /// About how many bytes it takes: of a step its text, of a pixel what replays remember.
    std::size_t memory() const {
        constexpr std::size_t of_step = 150;
        constexpr std::size_t of_pixel = 100;
        const std::size_t steps = trace_.size() + (against_ ? against_->size() : 0);
        const auto pixels = static_cast<std::size_t>(trace_.canvas.width) *
                            static_cast<std::size_t>(trace_.canvas.height);
        return of_step * steps + of_pixel * pixels;
    }

    Drawing drawing(std::size_t n) { return maker_->figure(n); }

    /// What would show something if the last frame, and so each, has no pixel; "" if it has one.
    std::string hint_for_none() const {
        const FigureFrame& last = frames_.back();
        const Frame frame = frame_after(trace_, last.steps.last - (last.is_question ? 1 : 0));
        const Canvas& canvas = trace_.canvas;
        if (has_pixel(frame, command_.figure.region.value_or(all_of(canvas))))
            return {};
        if (has_pixel(frame, all_of(canvas)))
            return "without --region, the figure has the pixels outside of it";
        if (has_pixel(frame_after(trace_, trace_.size()), all_of(canvas)))
            return fmt::format("without {}, the figure has the pixels of later steps",
                               command_.which == FigureCommand::Which::until   ? "--until"
                               : command_.which == FigureCommand::Which::every ? "--every"
                                                                               : "--step");
        return "without --bare, the figure has grid, edges and vertices";
    }

    /// The same frame as `show` prints it. Faces that have had letters in another scene of the
    /// sequence keep them.
    std::string text(std::size_t n, FaceGroups& lettered) {
        const FigureFrame& frame = frames_[n];
        const View view = command_.figure.view.value_or(default_view(trace_));
        if (!replay_) {
            replay_.emplace(trace_, parts_for(view, trace_));
            if (view == View::faces) {
                replay_->go_to(trace_.size());
                faces_ = lettered = lettered_faces(*replay_, lettered);
            }
        }
        FrameText about{.caption = printable(command_.figure.caption.value_or("")),
                        .first_step = frame.steps.first,
                        .last_step = frame.steps.last,
                        .view = view,
                        .region = command_.figure.region,
                        .faces = &faces_};
        if (frame.is_question) {
            about.first_step = about.last_step = frame.steps.first - 1;
        } else {
            if (frame.steps.first == 0)
                about.first_step = about.last_step;
            replay_->go_to(about.first_step);
            if (!command_.figure.caption)
                about.caption = describe_step(*replay_);
            const auto& with = command_.figure.with;
            if (std::find(with.begin(), with.end(), FigurePart::working) != with.end())
                about.working = working_of(*replay_);
        }
        replay_->go_to(about.last_step);
        return frame_text(*replay_, about, {});
    }

private:
    const FigureCommand& command_;
    Trace trace_;
    std::optional<Trace> against_;
    std::vector<FigureFrame> frames_;
    std::unique_ptr<FigureMaker> maker_;
    std::optional<Replay> replay_; ///< of frames as text
    FaceGroups faces_;
};

/// All frames that were asked for: of one trace, or of each in a sequence.
class AllFigures {
public:
    AllFigures(const FigureCommand& command, InputFrames& input)
        : command_(command), input_(input) {
        bool is_empty = command.is_bare; // no frame so far has a pixel
        std::string hint;
        for (std::size_t scene = input.first(); scene <= input.last(); ++scene) {
            TraceFigures& figures = of(scene);
            status_ = std::max(status_, report_damage(figures.trace()));
            for (std::size_t n = 0; n < figures.count(); ++n)
                places_.push_back({scene, n});
            if (is_empty) {
                hint = figures.hint_for_none();
                is_empty = !hint.empty();
            }
        }
        if (is_empty)
            print_error(fmt::format(
                "rastertrace: {}\n",
                to_text(
                    problem_of("", "remark: expected pixels for --bare, found none drawn", hint))));
    }

    std::size_t count() const { return places_.size(); }

    /// How far it has come, for another thread.
    std::uint64_t drawn() const { return drawn_; }
    ExitStatus status() const { return status_; }
    std::string title() { return of(input_.first()).trace().title; }

    Drawing drawing(std::size_t i) {
        Drawing drawn = of(places_[i].scene).drawing(places_[i].frame);
        drawn_ = i + 1;
        return drawn;
    }
    std::string text(std::size_t i) {
        return of(places_[i].scene).text(places_[i].frame, lettered_);
    }

    /// As wide as the widest one, of the first, the last and one between.
    double width() {
        double width = 0;
        for (const std::size_t i : {std::size_t{0}, count() / 2, count() - 1})
            width = std::max(width, drawing(i).width);
        return width;
    }

    /// From now on, figures have letters of this size; see FigureOptions.
    void set_letter_scale(double scale) {
        letter_scale_ = scale;
        if (figures_)
            figures_->set_letter_scale(scale);
        for (auto& [scene, figures] : kept_)
            figures->set_letter_scale(scale);
    }

    FigureFrames frames_of_one_size() {
        return of_one_size(count(), [this](std::size_t i) { return drawing(i); });
    }

private:
    struct PlaceInSequence {
        std::size_t scene;
        std::size_t frame;
    };

    TraceFigures& of(std::size_t scene) {
        if (const auto kept = kept_.find(scene); kept != kept_.end())
            return *kept->second;
        if (!figures_ || scene_ != scene) {
            figures_.reset(); // two at a time are not needed
            figures_ = std::make_unique<TraceFigures>(command_, input_, scene);
            if (letter_scale_)
                figures_->set_letter_scale(*letter_scale_);
            scene_ = scene;
        }
        const std::size_t taken = figures_->memory();
        if (taken > room_)
            return *figures_;
        room_ -= taken;
        return *(kept_[scene] = std::move(figures_));
    }

    const FigureCommand& command_;
    InputFrames& input_;
    std::size_t scene_ = 0; ///< that figures_ are of
    std::atomic<std::uint64_t> drawn_ = 0;
    std::unique_ptr<TraceFigures> figures_;
    std::map<std::size_t, std::unique_ptr<TraceFigures>> kept_; ///< so that no scene is drawn twice
    std::size_t room_ = 200'000'000;                            ///< for more of them, in bytes
    std::optional<double> letter_scale_;                        ///< none: 1
    std::vector<PlaceInSequence> places_;
    FaceGroups lettered_;
    ExitStatus status_ = exit_fine;
};

FigureFormat format_of(const FigureCommand& command) {
    if (command.format)
        return *command.format;
    if (const auto format = format_by_ending<FigureFormat>(command.output, figure_endings))
        return *format;
    refuse_ending(command.output, endings_in<FigureFormat>(figure_endings));
}

bool is_animation(const FigureCommand& command, FigureFormat format) {
    return command.is_animated || format == FigureFormat::gif;
}

/// True of a .tex: letters are chosen so that they have room.
bool chooses_letters(const FigureCommand& command, FigureFormat format) {
    return format == FigureFormat::tex && !command.is_bare;
}

/// The contents of the files to write: one, or one for each frame or sheet.
class FigureFiles {
public:
    FigureFiles(const FigureCommand& command, FigureFormat format, AllFigures& figures)
        : command_(command), format_(format), figures_(figures) {
        if (command.sheet) {
            frames_ = figures.frames_of_one_size();
            const std::size_t each = command.sheet->columns * command.sheet->rows;
            count_ = (figures.count() + each - 1) / each;
        } else if (is_animation(command, format)) {
            constexpr std::size_t most = most_gif_frames;
            if (figures.count() > most)
                throw problem_of("",
                                 fmt::format("expected at most {} frames that follow one another, "
                                             "found {}",
                                             most, figures.count()),
                                 "--every with a rarer step, like scanline or \"pixel y=2\", makes "
                                 "fewer");
            frames_ = figures.frames_of_one_size();
            count_ = 1;
        } else {
            count_ = figures.count();
        }
    }

    std::size_t count() const { return count_; }

    /// The content of a file, from 0.
    std::string content(std::size_t i) {
        if (command_.sheet) {
            const std::size_t each = command_.sheet->columns * command_.sheet->rows;
            const std::size_t last = std::min((i + 1) * each, figures_.count()) - 1;
            return figure_in(
                format_,
                contact_sheet(frames_, i * each, last, command_.sheet->columns, figures_.title()),
                command_.style);
        }
        if (is_animation(command_, format_))
            return animation_in(format_, frames_, command_.style);
        if (format_ == FigureFormat::txt)
            return figures_.text(i);
        return figure_in(format_, figures_.drawing(i), command_.style);
    }

private:
    const FigureCommand& command_;
    FigureFormat format_;
    AllFigures& figures_;
    FigureFrames frames_;
    std::size_t count_ = 0;
};

/// Writes the frames of one step in space, on a sheet. Throws a Problem.
ExitStatus write_space_frames(const FigureCommand& command, FigureFormat format) {
    InputFrames input(command.trace, command.scenes);
    if (input.is_sequence())
        throw problem_of("", "--sheet: expected one scene, found a sequence",
                         "--frame N takes one");
    const Trace trace = input.trace(input.first());
    std::optional<std::size_t> step;
    if (command.which == FigureCommand::Which::step) {
        const Selector selector =
            value_or_throw(parse_selector({"--step", command.selector}, trace));
        step = value_or_throw(matching_step(selector, trace, "say which"));
    }
    const ExitStatus status = report_damage(trace);
    const auto draw = [&](double letter_scale) {
        return space_frames(trace, *command.frames_in_space, step, command.figure.eye,
                            letter_scale);
    };
    const Drawing drawing = draw(
        chooses_letters(command, format)
            ? letter_scale_for_tex([&](double scale) { return draw(scale).width; }, command.style)
            : 1);
    const std::string bytes = figure_in(format, drawing, command.style);
    if (command.output == "-")
        print(bytes);
    else
        write_file(command.output, bytes);
    return status;
}

} // namespace

int FigureCommand::run() {
    const FigureFormat chosen = format_of(*this);
    check_format(*this, chosen);
    if (frames_in_space)
        return write_space_frames(*this, chosen);
    if (chosen == FigureFormat::html) {
        const Progress progress({.doing = "drawing a page"});
        return write_page(*this);
    }
    InputFrames input(trace, scenes);
    // A sequence is a film already.
    if (which == Which::last && !sheet && is_animation(*this, chosen) && !input.is_sequence())
        which = Which::film;
    AllFigures figures(*this, input);
    std::optional<Progress> progress;
    if (figures.count() > 1)
        progress.emplace(
            LongWork{.doing = "figure", .unit = "frames", .total = figures.count(), .done = [&] {
                         return figures.drawn();
                     }});
    if (chooses_letters(*this, chosen)) {
        const std::size_t columns = sheet ? std::min(sheet->columns, figures.count()) : 1;
        figures.set_letter_scale(letter_scale_for_tex(
            [&](double scale) {
                figures.set_letter_scale(scale);
                return static_cast<double>(columns) * figures.width();
            },
            style));
    }
    FigureFiles files(*this, chosen, figures);
    if (output == "-") {
        if (files.count() > 1)
            throw problem_of(
                "", fmt::format("expected one figure for standard output, found {}", files.count()),
                "--output FILE writes a file for each, --sheet CxR some side by side");
        const std::string bytes = files.content(0);
        progress.reset();
        print(bytes);
    } else if (files.count() == 1) {
        write_file(output, files.content(0));
    } else {
        FrameFiles outputs(output, files.count());
        for (std::size_t i = 0; i < files.count(); ++i)
            outputs.open(i + 1).write(files.content(i));
        outputs.commit();
    }
    return figures.status();
}

} // namespace rastertrace
