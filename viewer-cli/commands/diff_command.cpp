// SPDX-License-Identifier: MIT
// `rastertrace diff`: what two traces, or the files of two folders, do differently.

#include "app/command.h"
#include "app/exit_status.h"
#include "app/load.h"
#include "app/option_values.h"
#include "app/progress.h"
#include "app/shared_options.h"
#include "commands/diff_report.h"
#include "frames/terminal_text.h"

#include <rastertrace/trace/audit/redo.h>
#include <rastertrace/trace/compare/diff.h>
#include <rastertrace/trace/compare/other_goldens.h>
#include <rastertrace/trace/picture/picture_diff.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// How two files, or two folders, are compared.
struct FileComparison {
    DiffOptions options;
    std::optional<Color> background; ///< of a picture: what is not drawn
    SceneOptions scenes;
};

// Two files.

/// Marks, on one side, the sentences of steps that tell something else than their numbers give, as `show` does.
void mark_wrong_sentences(Trace& trace, std::vector<DiffStep>& before,
                          std::optional<DiffStep>& differing, std::vector<DiffStep>& after) {
    if (trace.source().view().size() > largest_marked_trace)
        return;
    mark_wrong_steps(trace);
    const auto mark = [&trace](DiffStep& step) {
        step.sentence += what_numbers_give(trace, step.number);
    };
    std::for_each(before.begin(), before.end(), mark);
    if (differing)
        mark(*differing);
    std::for_each(after.begin(), after.end(), mark);
}

/// What a picture shows otherwise than the trace or scene at `path` draws it, with the explanation of a pixel.
TraceDiff diff_of_picture(const std::string& path, const Picture& picture,
                          const std::string& picture_path, bool is_picture_first,
                          const FileComparison& how) {
    PictureDiffOptions picture_how = picture_options(how.options);
    picture_how.name = picture_path;
    picture_how.is_picture_first = is_picture_first;
    picture_how.background = how.background;
    Source source = load_input(path, how.scenes.limits);
    SceneOptions options = how.scenes;
    const bool is_drawn = !is_trace(source);
    if (!is_drawn)
        refuse_scene_options(source, options);
    TraceDiff found =
        diff_with_picture(trace_to_compare(std::move(source), path, options), picture, picture_how);
    const std::uint64_t differing = count_pixels(found);
    if (differing == 0)
        return found;
    found.explanation = explanation_of_first_pixel(found, load_trace(path, options));

    // Samples half a pixel away may explain most of it.
    constexpr std::uint64_t explains = 4;
    for (const std::string_view sample : {"integer", "center"}) {
        if (!is_drawn)
            break;
        SceneOptions other = options;
        other.method.emplace_back("sample", sample);
        const TraceDiff moved =
            diff_with_picture(trace_to_compare(load_input(path, how.scenes.limits), path, other),
                              picture, picture_how);
        if (const std::uint64_t left = count_pixels(moved); left * explains <= differing)
            found.remarks.push_back(
                said("with --sample {}: then {}", sample,
                     left == 0 ? said("no pixels differ") : counted_differences(left, "pixel")));
    }
    return found;
}

/// Compares two traces or scenes. Options that say how to draw are about those that are scenes.
TraceDiff diff_of_traces(const std::string& path_a, const std::string& path_b,
                         const FileComparison& how) {
    if (path_a == "-" && path_b == "-")
        throw problem_of("standard input", "expected one of the two there, found both");
    Source source_a = load_input(path_a, how.scenes.limits);
    Source source_b = load_input(path_b, how.scenes.limits);
    const SceneOptions& options = how.scenes;
    const bool draws_a = !is_trace(source_a);
    const bool draws_b = !is_trace(source_b);
    if (!draws_a && !draws_b)
        refuse_scene_options(source_a, options);
    Trace given = trace_to_compare(std::move(draws_a ? source_b : source_a),
                                   draws_a ? path_b : path_a, options);
    // A foreign trace, which says nothing of stages, may tell what the scene does not need.
    SceneOptions other_options = options;
    if (how.options.compares_common && draws_a != draws_b &&
        given.header_json.find("\"stages\"") == std::string::npos)
        std::ranges::copy(every_stage_kept(), std::back_inserter(other_options.method));
    Trace other = trace_to_compare(std::move(draws_a ? source_a : source_b),
                                   draws_a ? path_a : path_b, other_options);
    Trace& a = draws_a ? other : given;
    Trace& b = draws_a ? given : other;
    TraceDiff found = diff(a, b, how.options);
    if (found.first) {
        mark_wrong_sentences(a, found.before_a, found.first->a, found.after_a);
        mark_wrong_sentences(b, found.before_b, found.first->b, found.after_b);
    }
    return found;
}

/// Compares two files of any kind.
TraceDiff diff_of_inputs(const std::string& path_a, const std::string& path_b,
                         const FileComparison& how) {
    const auto a = picture_in_file(path_a, how.scenes.limits);
    const auto b = picture_in_file(path_b, how.scenes.limits);
    if (a && !b)
        return diff_of_picture(path_b, *a, path_a, true, how);
    if (b && !a)
        return diff_of_picture(path_a, *b, path_b, false, how);
    return diff_of_traces(path_a, path_b, how);
}

/// What two files do differently, with the goldens that are accepted besides the first. Throws a Problem.
TraceDiff diff_of_files(const std::string& path_a, const std::string& path_b,
                        const FileComparison& how) {
    TraceDiff found = diff_of_inputs(path_a, path_b, how);
    if (!found.is_same && found.damage.empty())
        for (const std::string& other : other_goldens(path_a))
            if (TraceDiff accepted = diff_of_inputs(other, path_b, how);
                accepted.is_same && accepted.damage.empty()) {
                accepted.remarks.push_back(
                    said("{} is accepted besides {}", printable(other), printable(path_a)));
                return accepted;
            }
    return found;
}

// Two folders: each file with the one of its name in the other folder.

/// How names of traces, scenes and pictures end.
constexpr std::array<std::string_view, 7> compared_endings{".json", ".jsonl", ".png", ".ppm",
                                                           ".pgm",  ".pbm",   ".tga"};

/// The files in a folder and its folders, as paths from it, by name; none whose name, or whose folder's, begins with a
/// dot. Links that lead to nothing are among them: who opens them says so. Throws a Problem.
std::vector<std::string> files_below(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (std::filesystem::recursive_directory_iterator entry(folder, error), end;
         !error && entry != end; entry.increment(error)) {
        if (entry->path().filename().string().starts_with('.'))
            entry.disable_recursion_pending();
        else if (std::error_code of_link; entry->is_regular_file(of_link) || of_link)
            names.push_back(entry->path().lexically_relative(folder).generic_string());
    }
    if (error) {
        Problem problem = problem_of(
            folder, fmt::format("expected a folder of traces, found that it cannot be read: {}",
                                error.message()));
        problem.cause = cause_of_open_error(error.value());
        throw problem;
    }
    std::ranges::sort(names);
    return names;
}

/// Which of the two folders have a file, by its name.
using FilesOfBoth = std::map<std::string, std::array<bool, 2>>;
constexpr std::array in_both{true, true};

FilesOfBoth files_of(const std::vector<std::string>& folders) {
    FilesOfBoth files;
    for (std::size_t i = 0; i < folders.size(); ++i)
        for (const std::string& name : files_below(folders[i]))
            if (std::ranges::any_of(compared_endings,
                                    [&](auto end) { return name.ends_with(end); }))
                files[name][i] = true;
    if (std::ranges::find(files, in_both, &FilesOfBoth::value_type::second) == files.end())
        throw problem_of(
            "", "diff: nothing to compare: the folders have no file of one name",
            fmt::format("compared are files that end in {}", joined(compared_endings, ", ")));
    return files;
}

/// The lines of a text, each with blanks in front.
std::string indented(const std::string& text) {
    std::string lines;
    for (const std::string& line : split_at(text.substr(0, text.find_last_not_of('\n') + 1), '\n'))
        lines += line.empty() ? "\n" : "    " + line + "\n";
    return lines;
}

/// Compares the files of two folders that have one name; prints JSON, or text. Throws a Problem if there are none.
ExitStatus diff_folders(const std::vector<std::string>& folders, FileComparison how, bool as_json,
                        ColorChoice color) {
    how.scenes.is_quiet = true;
    const FilesOfBoth files = files_of(folders);
    std::size_t differing = 0, unread = 0;
    std::string text;
    std::vector<JsonText> json;
    const auto tell = [&](const std::string& name, std::string_view key, const JsonText& value,
                          const std::string& words) {
        json.push_back(JsonText{{"name", name}, {key, value}});
        text += fmt::format("{}: {}\n", printable(name), words);
    };
    for (const auto& [name, places] : files) {
        std::vector<std::string> paths;
        for (const std::string& folder : folders)
            paths.push_back((std::filesystem::path(folder) / name).string());
        try {
            if (places != in_both) {
                ++differing;
                tell(name, "only", places[0] ? "a" : "b",
                     places[0] ? said("only in a") : said("only in b"));
            } else if (const TraceDiff found = diff_of_files(paths[0], paths[1], how);
                       !found.damage.empty()) {
                throw found.damage.front();
            } else if (!found.is_same) {
                ++differing;
                const std::string lines =
                    diff_in_color(without_kinds(diff_text(found)), output_colors(color));
                tell(name, "diff", diff_json(found), diff_summary(found) + "\n" + indented(lines));
            }
        } catch (const Problem& problem) {
            if (problem.cause == Problem::Cause::system)
                throw;
            ++unread;
            print_error(problem);
            tell(name, "problem", to_text(problem), said("cannot be read"));
        }
    }
    const ExitStatus status = unread > 0      ? exit_bad_input
                              : differing > 0 ? exit_difference
                                              : exit_fine;
    if (as_json) {
        print(JsonText{{"compared", files.size()},
                       {"differ", differing},
                       {"unread", unread},
                       {"files", JsonText::lines(json)}}
                  .line());
        return status;
    }
    text += said("{} compared, {}", files.size(), differing) +
            (differing == 1 ? said(" differs") : said(" differ"));
    if (unread > 0)
        text += said(", {} cannot be read", unread);
    print(text + "\n");
    return status;
}

// The command.

class DiffCommand final : public Command {
public:
    CommandAbout about() const override {
        return {"diff", "Say what two traces do differently",
                "rastertrace diff golden.json scene.json\n\n"
                "Steps are found by their primitive and what they are about, numbers compared by "
                "value.\n"
                "Primitives are found by name and vertices, or by one of the two.\n"
                "Of two folders, files of the same name are compared."};
    }

    void add_to(OptionList& options) override {
        options
            .option("traces", files_,
                    "Two traces, or scenes, which are drawn first; - for standard input; or two "
                    "folders of them",
                    "A B")
            .required();
        options.option("--against", against_,
                       "Compare the only scene with itself, drawn by another method, like "
                       "scalar=double",
                       "METHOD");
        comparison_.add_to(options);
        options.option("--format", format_, "How to print", "NAME").values({"text", "json"});
        options.flag("--json", json_, "Short for --format json");
        options.option("--color", color_name_, "Colors", "WHEN").values(color_choices);
        options.language();
        drawing_.add_to(options, Holds::steps);
    }

    void read() override {
        json_ = is_json(format_, json_);
        color_ = color_choice_of(color_name_);
        how_.options = comparison_.options();
        how_.background = comparison_.background();
        how_.scenes = drawing_.scene_options();
        const std::size_t count = files_.size();
        if (count != (against_.empty() ? 2 : 1))
            throw problem_of(
                "",
                fmt::format("diff: expected {}, found {}",
                            against_.empty() ? "two files" : "one scene with --against", count));
    }

    int run() override {
        if (!against_.empty())
            return tell(diff_of_methods());
        std::error_code error;
        if (std::filesystem::is_directory(files_[0], error))
            return diff_folders(files_, how_, json_, color_);
        if (error && cause_of_open_error(error.value()) == Problem::Cause::system)
            throw problem_of_system(files_[0], "could not be read", error.value());
        std::optional<Progress> progress(std::in_place, reading_of("diff", files_));
        const TraceDiff found = diff_of_files(files_[0], files_[1], how_);
        progress.reset();
        return tell(found);
    }

private:
    /// Compares a scene with itself, drawn by another method.
    TraceDiff diff_of_methods() const {
        const std::string& path = files_.front();
        if (path == "-")
            throw problem_of("standard input",
                             "expected a file with --against, which reads it twice");
        FileComparison other = how_;
        std::ranges::copy(value_or_throw(parse_method({"--against", against_})),
                          std::back_inserter(other.scenes.method));
        const auto trace_by = [&path](const SceneOptions& scenes) {
            Source source = load_input(path, scenes.limits);
            if (is_trace(source))
                refuse_scene_options(source, scenes);
            return trace_to_compare(std::move(source), path, scenes);
        };
        // That the method differs is what was asked for.
        other.options.ignored.emplace_back("header");
        TraceDiff found = diff(trace_by(how_.scenes), trace_by(other.scenes), other.options);
        found.name_b += said(" with {}", against_);
        return found;
    }

    ExitStatus tell(const TraceDiff& found) const {
        print(json_ ? diff_json(found).line()
                    : diff_in_color(diff_text(found), output_colors(color_)));
        for (const Problem& problem : found.damage)
            print_error(problem);
        if (!found.damage.empty())
            return exit_bad_input;
        return found.is_same ? exit_fine : exit_difference;
    }

    std::vector<std::string> files_; ///< two scenes or traces; or one scene, and `against_`
    std::string against_;            ///< METHOD: the only scene, drawn by another one
    ComparisonOptions comparison_;
    FileComparison how_;
    std::string format_;
    bool json_ = false;
    std::string color_name_;
    ColorChoice color_ = ColorChoice::automatic;
    DrawingOptions drawing_;
};

} // namespace

std::unique_ptr<Command> diff_command() {
    return std::make_unique<DiffCommand>();
}

} // namespace rastertrace
