// SPDX-License-Identifier: MIT
#include "commands/driven_program.h"

#include "app/load.h"
#include "app/run_program.h"
#include "commands/diff_report.h"

#include <rastertrace/trace/picture/picture_diff.h>
#include <rastertrace/trace/picture/picture_trace.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/input_file.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <utility>

namespace rastertrace {

namespace {

/// The texts that a program may read.
struct SceneText {
    std::string_view placeholder;
    std::string_view ending;
    std::string (*write)(const FuzzScene& scene);
};
constexpr std::array scene_texts{SceneText{"{scene}", ".json", scene_json},
                                 SceneText{"{triangles}", ".txt", triangles_text}};
constexpr std::string_view out_placeholder = "{out}";

const SceneText& text_for(std::string_view placeholder) {
    return *std::ranges::find(scene_texts, placeholder, &SceneText::placeholder);
}

/// A text with another in the place of each `from`.
std::string replaced(std::string text, std::string_view from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

/// `ended by signal 11: ...`, with the last line that it printed.
std::string how_it_ended(const FinishedRun& run) {
    constexpr int by_signal = 128;
    const std::string lines = run.err.substr(0, run.err.find_last_not_of('\n') + 1);
    const std::string last = lines.substr(lines.rfind('\n') + 1);
    const bool is_signal = run.exit_status > by_signal;
    return fmt::format("{} {}{}{}", is_signal ? "ended by signal" : "exit status",
                       run.exit_status - (is_signal ? by_signal : 0), last.empty() ? "" : ": ",
                       shortened(printable(last), 200));
}

/// The first difference in one line: of a step its sentence in both.
std::string first_line_of(const TraceDiff& found) {
    if (!found.first && found.picture && !found.picture->pixels.empty()) {
        const PixelDifference& one = found.picture->pixels.front();
        return fmt::format("pixel ({}, {}): {}, yours: {}", one.pixel.x, one.pixel.y,
                           one.a ? "drawn by " + printable(one.a->primitive) : "not drawn",
                           !one.b   ? "not drawn"
                           : !one.a ? "drawn"
                                    : "drawn in another color");
    }
    if (!found.first)
        return "the end records differ";
    return fmt::format("{}{}, yours: {}",
                       found.first->primitive.empty() ? ""
                                                      : printable(found.first->primitive) + ": ",
                       sentence_of(found.first->a), sentence_of(found.first->b));
}

} // namespace

namespace {

/// True if the pictures differ only where the reference has held two equal depths against each other.
bool are_ties(const TraceDiff& found, const Trace& reference) {
    if (!found.picture || found.picture->pixels.empty())
        return false;
    const auto is_tie = [&reference](const PixelDifference& one) {
        for (std::size_t n = 1; n <= reference.size(); ++n)
            if (const auto step = reference.step(n); step.kind() == StepKind::depth)
                if (const auto test = step.as<DepthStep>(); test.x == one.pixel.x &&
                                                            test.y == one.pixel.y &&
                                                            test.depth.text() == test.stored.text())
                    return true;
        return false;
    };
    return std::ranges::all_of(found.picture->pixels, is_tie);
}

} // namespace

std::string_view words_of(DrivenFinding::Kind kind) {
    constexpr std::array<std::string_view, 5> words{
        "decides otherwise",
        "decides otherwise, where two depths are equal: a tie, which a right renderer may decide "
        "either way if its numbers round",
        "does not end well", "hangs", "gives no answer"};
    return words[static_cast<std::size_t>(kind)];
}

DrivenProgram::DrivenProgram(std::vector<std::string> words, const ComparisonOptions& comparison,
                             std::chrono::seconds time)
    : words_(std::move(words)), options_(comparison.options()), time_(time),
      background_(comparison.background()) {
    const auto has = [this](std::string_view placeholder) {
        return std::ranges::any_of(words_, [placeholder](const std::string& word) {
            return word.find(placeholder) != std::string::npos;
        });
    };
    for (const SceneText& text : scene_texts)
        if (has(text.placeholder) && placeholder_.empty())
            placeholder_ = text.placeholder;
        else if (has(text.placeholder))
            throw problem_of("",
                             fmt::format("fuzz: expected one text of the scene, found {} and {}",
                                         placeholder_, text.placeholder));
    if (words_.empty() || placeholder_.empty())
        throw problem_of(
            "",
            "fuzz: expected a program behind --, with {scene} or {triangles} among its arguments",
            "like: rastertrace fuzz -- ./mine {scene}");
    has_out_ = has(out_placeholder);
    for (const std::string& word : words_) // what runs is not overwritten
        (void)InputFile::open(word, InputFile::Kind::regular_file);
    // A foreign rasterizer tells what it likes to, in the order in which it draws.
    options_.compares_common = true;
    options_.compares_order = false;
    const std::vector<std::string> more = split_at(ignored(), ',');
    options_.ignored.insert(options_.ignored.end(), more.begin(), more.end());
}

std::string DrivenProgram::scene_text(const FuzzScene& scene) const {
    return text_for(placeholder_).write(scene);
}

std::string_view DrivenProgram::ending() const {
    return text_for(placeholder_).ending;
}

Result<std::string> DrivenProgram::reference(const FuzzScene& scene) const {
    try {
        const Source source{"scene.json", scene_json(scene), {}};
        const auto [drawn, plan, remarks] = value_or_throw(read_scene(source, every_stage_kept()));
        std::string text;
        StringOutput output(text);
        write_trace(drawn, plan, {.layout = TraceLayout::jsonl, .filter = {}}, output);
        return text;
    } catch (const Problem& problem) {
        return problem;
    }
}

std::vector<std::string> DrivenProgram::words_for(const std::string& scene,
                                                  const std::string& out) const {
    std::vector<std::string> words;
    for (const std::string& word : words_)
        words.push_back(replaced(replaced(word, placeholder_, scene), out_placeholder, out));
    return words;
}

DrivenProgram::Answer DrivenProgram::run(const FuzzScene& scene) const {
    const TemporaryFolder folder("rastertrace-fuzz");
    const std::filesystem::path file = folder.path() / fmt::format("scene{}", ending());
    const std::string out = (folder.path() / "out").string();
    // Not where outputs of a page that is checked go: the program reads it.
    if (!(std::ofstream(file, std::ios::binary) << scene_text(scene) << std::flush))
        throw problem_of_system(file.string(), "could not be written", errno);
    std::vector<std::string> words = words_for(file.string(), out);
    Answer answer{.run = run_program({.path = words.front(),
                                      .words = words,
                                      .environment = own_environment(),
                                      .most_output = InputLimits{}.bytes,
                                      .time = time_,
                                      .has_own_group = true})};
    std::error_code error;
    if (!has_out_)
        answer.bytes = Source{"its answer", std::move(answer.run.out), {}};
    else if (std::filesystem::exists(out, error))
        answer.bytes = read_bytes(out, {});
    return answer;
}

void DrivenProgram::learn_colors(FuzzKind kind) const {
    FuzzScene probe{.kind = kind, .width = 16, .height = 16};
    const std::int64_t w = kind == FuzzKind::clip ? 8 : 1; // in the view
    for (const std::int64_t at : {1, 5}) {
        const auto vertex = [w](std::int64_t x, std::int64_t y) {
            return FuzzVertex{x * fuzz_unit, y * fuzz_unit, fuzz_unit, w * fuzz_unit};
        };
        probe.primitives.push_back(
            {.name = fmt::format("T{}", at),
             .vertices = {vertex(at, at), vertex(at + 2, at), vertex(at, at + 2)},
             .color = at == 1 ? Color(230, 25, 75) : Color(60, 180, 75)});
        if (kind == FuzzKind::lines)
            probe.primitives.back().vertices.pop_back();
    }
    const auto bytes = run(probe).bytes;
    const auto picture = bytes ? read_picture(bytes.value()) : bytes.problem();
    if (!picture || !picture.value().has_colors)
        return;
    std::vector<Color> pixels(picture.value().pixels.begin(), picture.value().pixels.end());
    const Color most = most_frequent(pixels);
    if (!background_)
        background_ = most;
    std::erase(pixels, most);
    takes_colors_ =
        pixels.empty() || std::ranges::count(pixels, pixels.front()) != std::ssize(pixels);
}

std::optional<DrivenFinding> DrivenProgram::difference(const FuzzScene& scene,
                                                       const std::string& reference) const {
    Answer answer = run(scene);
    const FinishedRun& finished = answer.run;
    using Kind = DrivenFinding::Kind;
    if (finished.is_too_long)
        return DrivenFinding{Kind::hangs, "", fmt::format("not done after {} s", time_.count())};
    if (finished.is_too_large)
        return DrivenFinding{Kind::no_answer, "", "it prints without end"};
    if (finished.exit_status != 0)
        return DrivenFinding{Kind::crashes, printable(finished.err), how_it_ended(finished)};
    if (!answer.bytes)
        return DrivenFinding{Kind::no_answer, "", "its {out}: " + answer.bytes.problem().message};
    Source& theirs = answer.bytes.value();
    if (has_out_ && theirs.view().empty())
        return DrivenFinding{Kind::no_answer, "", "it has not written its {out}"};
    theirs.name = "its answer";
    return compared(reference, std::move(theirs), scene.kind);
}

std::string DrivenProgram::ignored() const {
    std::string ignored = "header,end,primitive.name,primitive.vertices";
    if (text_for(placeholder_).write == triangles_text)
        ignored += ",vertex,edge,scanline.left_edge,scanline.right_edge,depth.side_of,depth.beside,"
                   "depth.behind";
    return takes_colors_ ? ignored : ignored + ",primitive.color,pixel.color";
}

std::string DrivenProgram::remarks() const {
    std::string text = remark_.empty() ? "" : remark_ + "\n";
    if (!takes_colors_)
        text += "its pictures have one color for all primitives: which of them is in front was not "
                "compared\n";
    return text;
}

std::optional<DrivenFinding> DrivenProgram::compared(const std::string& reference, Source theirs,
                                                     FuzzKind kind) const {
    using Kind = DrivenFinding::Kind;
    try {
        const Trace expected = value_or_throw(read_trace({"reference", reference}));
        TraceDiff found;
        const bool is_trace_answer = is_trace(theirs);
        if (is_trace_answer) {
            found = diff(expected, value_or_throw(read_trace(std::move(theirs))), options_);
        } else if (picture_format(theirs)) {
            PictureDiffOptions how = picture_options(options_);
            how.name = theirs.name;
            std::call_once(has_learnt_colors_, [&] { learn_colors(kind); });
            how.background = background_;
            how.compares_colors = how.compares_colors && takes_colors_;
            found = diff_with_picture(expected, value_or_throw(read_picture(theirs)), how);
        } else {
            return DrivenFinding{Kind::no_answer, "",
                                 "expected a trace or a picture, found neither"};
        }
        if (!found.damage.empty())
            return DrivenFinding{Kind::no_answer, "", to_text(found.damage.front())};
        if (found.is_same) {
            const std::scoped_lock lock(mutex_);
            for (const std::string& one : found.remarks)
                if (one.starts_with("compared:") &&
                    std::pair(one.size(), one) > std::pair(remark_.size(), remark_))
                    remark_ = one;
            return std::nullopt;
        }
        if (!is_trace_answer) // why our drawing has that pixel, or has not
            found.explanation = explanation_of_first_pixel(found, expected);
        return DrivenFinding{are_ties(found, expected) ? Kind::ties : Kind::differs,
                             diff_text(found), first_line_of(found)};
    } catch (const Problem& problem) {
        return DrivenFinding{Kind::no_answer, "", to_text(problem)};
    }
}

} // namespace rastertrace
