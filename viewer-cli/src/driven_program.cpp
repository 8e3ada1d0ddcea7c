// SPDX-License-Identifier: MIT
#include "driven_program.h"

#include "diff_report.h"
#include "load.h"
#include "temporary_folder.h"

#include <rastertrace/trace/picture/picture_diff.h>
#include <rastertrace/trace/picture/picture_trace.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
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
std::string ending_of(const FinishedRun& run) {
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

std::string_view words_of(DrivenFinding::Kind kind) {
    constexpr std::array<std::string_view, 4> words{"decides otherwise", "does not end well",
                                                    "hangs", "gives no answer"};
    return words[static_cast<std::size_t>(kind)];
}

DrivenProgram::DrivenProgram(std::vector<std::string> words, const ComparisonOptions& comparison,
                             std::chrono::seconds time)
    : words_(std::move(words)), options_(comparison.options()),
      asked_background_(comparison.background()), time_(time) {
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
        const auto [drawn, plan, remarks] = value_or_throw(read_scene(source, scene.method));
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

/// Runs the program on a scene; `answer` gets what it answers, "" if it has not written its {out}.
FinishedRun DrivenProgram::run(const FuzzScene& scene, std::string& answer) const {
    const TemporaryFolder folder("rastertrace-fuzz");
    const std::filesystem::path file = folder.path() / fmt::format("scene{}", ending());
    const std::string out = (folder.path() / "out").string();
    write_file(file.string(), scene_text(scene));
    std::vector<std::string> words = words_for(file.string(), out);
    FinishedRun finished = run_program({.path = words.front(),
                                        .words = words,
                                        .environment = own_environment(),
                                        .most_output = InputLimits{}.bytes,
                                        .time = time_,
                                        .has_own_group = true});
    answer = finished.out;
    if (has_out_) {
        const auto source = read_bytes(out, {});
        answer = source ? std::string(source.value().view()) : "";
    }
    return finished;
}

std::optional<Color> DrivenProgram::background() const {
    if (asked_background_)
        return asked_background_;
    std::call_once(has_run_probe_, [this] {
        constexpr std::int64_t near = fuzz_unit;
        constexpr std::int64_t far = 3 * fuzz_unit;
        const FuzzScene probe{.width = 8,
                              .height = 8,
                              .primitives = {{.name = "T1",
                                              .vertices = {{near, near, near, fuzz_unit},
                                                           {far, near, near, fuzz_unit},
                                                           {near, far, near, fuzz_unit}},
                                              .color = Color(230, 25, 75)}}};
        std::string answer;
        run(probe, answer);
        const auto picture = read_picture({"its answer", std::move(answer), {}});
        if (picture && picture.value().has_colors)
            found_background_ =
                most_frequent({picture.value().pixels.begin(), picture.value().pixels.end()});
    });
    return found_background_;
}

std::optional<DrivenFinding> DrivenProgram::difference(const FuzzScene& scene,
                                                       const std::string& reference) const {
    std::string answer;
    const FinishedRun finished = run(scene, answer);
    using Kind = DrivenFinding::Kind;
    if (finished.is_too_long)
        return DrivenFinding{Kind::hangs, "", fmt::format("not done after {} s", time_.count())};
    if (finished.is_too_large)
        return DrivenFinding{Kind::no_answer, "", "it prints without end"};
    if (finished.exit_status != 0)
        return DrivenFinding{Kind::crashes, printable(finished.err), ending_of(finished)};
    if (has_out_ && answer.empty())
        return DrivenFinding{Kind::no_answer, "", "it has not written its {out}"};
    return compared(reference, std::move(answer));
}

std::string DrivenProgram::ignored() const {
    const std::string ignored = "header,end,primitive.name,primitive.vertices";
    return text_for(placeholder_).write != triangles_text
               ? ignored
               : ignored + ",primitive.color,pixel.color,vertex,edge,scanline.left_edge,"
                           "scanline.right_edge,depth.side_of,depth.beside,depth.behind";
}

std::optional<DrivenFinding> DrivenProgram::compared(const std::string& reference,
                                                     std::string answer) const {
    using Kind = DrivenFinding::Kind;
    try {
        const TraceText expected(Source{"reference", reference, {}});
        Source theirs{"its answer", std::move(answer), {}};
        TraceDiff found;
        if (is_trace(theirs)) {
            found = diff(expected, TraceText(std::move(theirs)), options_);
        } else if (picture_format(theirs)) {
            PictureDiffOptions how = picture_options(options_);
            how.name = theirs.name;
            how.background = background();
            found = diff_with_picture(expected, value_or_throw(read_picture(theirs)), how);
            if (!found.is_same) // why our drawing has that pixel, or has not
                found.explanation = explanation_of_first_pixel(
                    found, value_or_throw(read_trace({"reference", reference, {}})));
        } else {
            return DrivenFinding{Kind::no_answer, "",
                                 "expected a trace or a picture, found neither"};
        }
        if (!found.damage.empty())
            return DrivenFinding{Kind::no_answer, "", to_text(found.damage.front())};
        if (found.is_same)
            return std::nullopt;
        return DrivenFinding{Kind::differs, diff_text(found), first_line_of(found)};
    } catch (const Problem& problem) {
        return DrivenFinding{Kind::no_answer, "", to_text(problem)};
    }
}

} // namespace rastertrace
