// SPDX-License-Identifier: MIT
// `rastertrace diff`: what two traces do differently.

#include "command.h"
#include "commands.h"
#include "diff_json.h"
#include "diff_report.h"
#include "load.h"
#include "option_values.h"
#include "progress.h"
#include "shared_options.h"

#include <rastertrace/trace/audit/redo.h>
#include <rastertrace/trace/compare/diff.h>
#include <rastertrace/trace/compare/diff_rules.h>
#include <rastertrace/trace/picture/picture_diff.h>
#include <rastertrace/trace/record/frame.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// What git gives instead of a file that is not there.
constexpr std::string_view no_file = "/dev/null";

SceneOptions options_of(const DiffCommand& command) {
    return {.method = command.method,
            .limits = command.input,
            .frames = command.frames,
            .is_quiet = command.is_quiet};
}

/// Marks, on one side, the sentences of steps that tell something else than their numbers give, as `show` does.
void mark_wrong_sentences(const TraceText& text, std::vector<DiffStep>& before,
                          std::optional<DiffStep>& differing, std::vector<DiffStep>& after) {
    if (text.size() > largest_marked_trace)
        return;
    std::string json(text.size(), '\0');
    json.resize(text.read(0, json));
    Result<Trace> trace = read_trace(Source{text.name(), std::move(json)});
    if (!trace)
        return;
    mark_wrong_steps(trace.value());
    const auto mark = [&trace](DiffStep& step) {
        step.sentence += what_numbers_give(trace.value(), step.number);
    };
    std::for_each(before.begin(), before.end(), mark);
    if (differing)
        mark(*differing);
    std::for_each(after.begin(), after.end(), mark);
}

/// With the rules that the team shares. Their method is about scenes alone.
DiffCommand with_rules(const DiffCommand& command) {
    const auto rules = command.rules.empty()
                           ? rules_beside(command.files.front(), command.input)
                           : std::optional(read_rules(command.rules, command.input));
    DiffCommand asked = command;
    if (!rules)
        return asked;
    asked.options = joined_options(rules->options, command.options);
    asked.method_of_rules = rules->method;
    return asked;
}

/// The method for one of the files: the choices of the rules, overridden by those of the command.
SceneOptions options_for(const OpenedTrace& opened, const DiffCommand& command) {
    SceneOptions options = options_of(command);
    if (is_scene(opened))
        options.method.insert(options.method.begin(), command.method_of_rules.begin(),
                              command.method_of_rules.end());
    return options;
}

/// What a picture shows otherwise than the trace or scene at `path` draws it, with the explanation of a pixel.
TraceDiff diff_of_picture(const std::string& path, const Picture& picture,
                          const std::string& picture_path, bool is_picture_first,
                          const DiffCommand& command) {
    PictureDiffOptions how = picture_options(command.options);
    how.name = picture_path;
    how.is_picture_first = is_picture_first;
    how.background = command.background;
    OpenedTrace opened = open_trace(path, command.input);
    SceneOptions options = options_for(opened, command);
    const bool is_drawn = is_scene(opened);
    if (!is_drawn)
        refuse_scene_options({path, {}, {}}, options);
    TraceDiff found = diff_with_picture(trace_text(std::move(opened), path, options), picture, how);
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
        const TraceDiff moved = diff_with_picture(
            trace_text(open_trace(path, command.input), path, other), picture, how);
        if (const std::uint64_t left = count_pixels(moved); left * explains <= differing)
            found.remarks.push_back(
                said({"with --sample {}: then {}", "com --sample {}: então {}"}, sample,
                     left == 0 ? said({"no pixels differ", "nenhum pixel difere"})
                               : counted_differences(left, {"pixel", "pixel"})));
    }
    return found;
}

/// Compares two files. Options that say how to draw are about those that are scenes.
TraceDiff diff_of_files(const std::string& path_a, const std::string& path_b,
                        const DiffCommand& command) {
    if (path_a == "-" && path_b == "-")
        throw problem_of("standard input", "expected one of the two there, found both");
    OpenedTrace a = open_trace(path_a, command.input);
    OpenedTrace b = open_trace(path_b, command.input);
    const SceneOptions options = options_of(command);
    if (!is_scene(a) && !is_scene(b))
        refuse_scene_options({path_a, {}, {}}, options);
    const SceneOptions options_a = options_for(a, command);
    const SceneOptions options_b = options_for(b, command);
    const TraceText text_a = trace_text(std::move(a), path_a, options_a);
    const TraceText text_b = trace_text(std::move(b), path_b, options_b);
    TraceDiff found = diff(text_a, text_b, command.options);
    if (found.first) {
        mark_wrong_sentences(text_a, found.before_a, found.first->a, found.after_a);
        mark_wrong_sentences(text_b, found.before_b, found.first->b, found.after_b);
    }
    return found;
}

/// Compares a scene with itself, drawn by another method.
TraceDiff diff_of_methods(const DiffCommand& command) {
    const std::string& path = command.files.front();
    if (path == "-")
        throw problem_of("standard input", "expected a file with --against, which reads it twice");
    DiffCommand other = command;
    const auto changes = value_or_throw(parse_method({"--against", command.against}));
    other.method.insert(other.method.end(), changes.begin(), changes.end());
    const auto text_by = [&path](const DiffCommand& method) {
        OpenedTrace opened = open_trace(path, method.input);
        if (!is_scene(opened))
            refuse_scene_options({path, {}, {}}, options_of(method));
        return trace_text(std::move(opened), path, options_of(method));
    };
    // That the method differs is what was asked for.
    other.options.ignored.emplace_back("header");
    TraceDiff found = diff(text_by(command), text_by(other), other.options);
    found.name_b += said({" with {}", " com {}"}, command.against);
    return found;
}

std::string report_of(const DiffCommand& command, const TraceDiff& found) {
    switch (command.format) {
    case DiffFormat::json:
        return diff_json(found);
    case DiffFormat::markdown:
        return diff_markdown(found, command.pictures);
    case DiffFormat::junit:
        return diff_junit(found);
    case DiffFormat::text:
        break;
    }
    return diff_in_color(diff_text(found), output_colors(command.color));
}

/// Compares two files of any kind.
TraceDiff diff_of_inputs(const std::string& path_a, const std::string& path_b,
                         const DiffCommand& command) {
    const auto a = picture_in_file(path_a, command.input);
    const auto b = picture_in_file(path_b, command.input);
    if (a && !b)
        return diff_of_picture(path_b, *a, path_a, true, command);
    if (b && !a)
        return diff_of_picture(path_a, *b, path_b, false, command);
    return diff_of_files(path_a, path_b, command);
}

/// The same with the goldens that are accepted besides the first file.
TraceDiff diff_with_others(const DiffCommand& command) {
    TraceDiff found = diff_of_inputs(command.files[0], command.files[1], command);
    if (!found.is_same && found.damage.empty())
        for (const std::string& other : other_goldens(command.files[0]))
            if (TraceDiff accepted = diff_of_inputs(other, command.files[1], command);
                accepted.is_same && accepted.damage.empty()) {
                accepted.remarks.push_back(
                    said({"{} is accepted besides {}", "{} é aceito além de {}"}, printable(other),
                         printable(command.files[0])));
                return accepted;
            }
    return found;
}

ExitStatus tell(const DiffCommand& command, const TraceDiff& found) {
    print(report_of(command, found));
    for (const Problem& problem : found.damage)
        print_error(problem);
    if (!found.damage.empty())
        return exit_bad_input;
    return found.is_same ? exit_fine : exit_difference;
}

/// The path of a file that git names: "-" is no standard input if there is such a file.
std::string path_of_git(const std::string& name) {
    return name == "-" && std::filesystem::exists(name) ? "./-" : name;
}

/// Compares as git asks for it: the name, the old file with its hash and mode, the new one, and a new name, if it has
/// one; of a file that is not merged the name alone. Git gives up all that is left to compare if a status is not 0, so
/// that what cannot be read is told in its place.
ExitStatus tell_git(const DiffCommand& command) {
    constexpr std::size_t place_of_new_name = 7;
    const std::vector<std::string>& words = command.files;
    const std::string& name = words[0];
    const bool is_renamed = words.size() > place_of_new_name;
    const std::string new_name = is_renamed ? words[place_of_new_name] : name;
    if (command.format == DiffFormat::text)
        print(fmt::format("rastertrace diff {}{}\n", printable(name),
                          is_renamed ? said({", now {}", ", agora {}"}, printable(new_name)) : ""));
    if (words.size() == 1) {
        print(said({"not merged\n", "não mesclado\n"}));
        return exit_fine;
    }
    const std::string old_file = path_of_git(words[1]);
    const std::string new_file = path_of_git(words[4]);
    if (old_file == no_file || new_file == no_file) {
        print(old_file == no_file
                  ? said({"a new file\n", "um arquivo novo\n"})
                  : said({"a file that is no longer there\n", "um arquivo que já não existe\n"}));
        return exit_fine;
    }
    try {
        TraceDiff found = diff_of_files(old_file, new_file, command);
        found.name_a = name + said({", before", ", antes"});
        found.name_b = new_name + said({", now", ", agora"});
        tell(command, found);
    } catch (const Problem& problem) {
        print(said({"cannot be compared: {}\n", "não pode ser comparado: {}\n"}, to_text(problem)));
    }
    return exit_fine;
}

/// The lines that git compares by itself: the method, then each step in words, with the primitive that it is of.
void print_lines_of(const Trace& trace) {
    constexpr std::size_t enough = 1 << 16;
    Replay replay(trace, {.depths = true});
    std::string text;
    for (const auto& [key, value] : trace.method)
        text += fmt::format("{}: {}\n", printable(key), printable(value));
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        replay.go_to(n);
        const std::size_t primitive = replay.primitive();
        if (primitive != 0 && primitive != n)
            text += printable(name_in(trace.step(primitive)).text()) + ": ";
        text += describe_step(replay) + "\n";
        if (text.size() > enough) {
            print(text);
            text.clear();
        }
    }
    for (const Problem& problem : trace.damage)
        text += to_text(problem) + "\n";
    print(text);
}

/// The same for git, which shows nothing more at all if a status is not 0.
ExitStatus print_lines(const DiffCommand& command) {
    try {
        print_lines_of(load_trace(path_of_git(command.files.front()), options_of(command)));
    } catch (const Problem& problem) {
        print(said({"cannot be read: {}\n", "não pode ser lido: {}\n"}, to_text(problem)));
    }
    return exit_fine;
}

} // namespace

int run(const DiffCommand& command) {
    switch (command.arguments) {
    case DiffCommand::Arguments::git:
        return tell_git(command);
    case DiffCommand::Arguments::textconv:
        return print_lines(command);
    case DiffCommand::Arguments::two:
        break;
    }
    const DiffCommand asked = with_rules(command);
    if (!asked.against.empty())
        return tell(asked, diff_of_methods(asked));
    if (std::error_code error; std::filesystem::is_directory(asked.files[0], error) &&
                               std::filesystem::is_directory(asked.files[1], error))
        return diff_folders(command);
    std::optional<Progress> progress(std::in_place, reading_of("diff", asked.files));
    const TraceDiff found = diff_with_others(asked);
    progress.reset();
    return tell(asked, found);
}

TraceDiff compared(const DiffCommand& command) {
    return diff_with_others(with_rules(command));
}

namespace {

class DiffCommandLine final : public Command {
public:
    CommandAbout about() const override {
        return {"diff", "Say what two traces do differently",
                "rastertrace diff golden.json scene.json\n\n"
                "Steps are found by their primitive and what they are about, numbers compared by "
                "value.\n"
                "Primitives are found by name and vertices, or by one of the two.\n"
                "With git, where .gitattributes has *.trace.json diff=trace:\n"
                "  git config diff.trace.command \"rastertrace diff --git\"\n"
                "or, as lines of text:\n"
                "  git config diff.trace.textconv \"rastertrace diff --textconv\""};
    }

    void add_to(OptionList& options) override {
        traces_ = options
                      .option("traces", command_.files,
                              "Two traces, or scenes, which are drawn first; - for "
                              "standard input; or two folders of them",
                              "A B")
                      .required();
        options.option("--against", command_.against,
                       "Compare the only scene with itself, drawn by another method, like "
                       "scalar=double",
                       "METHOD");
        comparison_.add_to(options);
        options.option("--rules", command_.rules,
                       "What the team has agreed on, like {\"ignore\": [\"header\"], "
                       "\"tolerance\": [\"4ulp\"]}; if not given, rastertrace-rules.json beside A",
                       "FILE");
        options.flag("--git", is_git_,
                     "Take the arguments that git gives to an external diff command; always "
                     "exit status 0");
        options.flag("--textconv", is_textconv_,
                     "Write the lines of one trace that git is to compare");
        options.option("--format", format_, "How to print", "NAME")
            .values({"text", "json", "markdown", "junit"});
        options.flag("--json", is_json_, "Short for --format json");
        options.option("--pictures", command_.pictures,
                       "With markdown: where to write the pictures that it shows", "FOLDER");
        options.option("--color", color_, "Colors", "WHEN").values(color_choices);
        options.language();
        drawing_.add_to(options, Holds::steps);
    }

    /// How many words at the end of the command line git has put there for `--git` or `--textconv`.
    /// They are names of files, which may look like options; what somebody has configured stands in
    /// front of them.
    std::size_t count_plain_words(std::span<const char* const> words) const override {
        const auto is_for_git = [](std::string_view word) {
            return word == "--git" || word == "--textconv";
        };
        const auto end = words.end();
        const auto option = std::find_if(words.begin(), end, is_for_git);
        if (end - option < 2)
            return 0;
        const auto is_hash = [](std::string_view word) {
            return word == "." ||
                   (word.size() >= 4 && word.find_first_not_of("0123456789abcdef") == word.npos);
        };
        const auto is_mode = [](std::string_view word) {
            return word == "." ||
                   (word.size() == 6 && word.find_first_not_of("01234567") == word.npos);
        };
        // Name, old file, its hash and mode, new file, its hash and mode; then perhaps a new name, and
        // what has changed.
        const bool is_git = *option == std::string_view("--git");
        if (is_git)
            for (const int count : {7, 8, 9})
                if (end - option > count && is_hash(end[2 - count]) && is_mode(end[3 - count]) &&
                    is_hash(end[5 - count]) && is_mode(end[6 - count]))
                    return static_cast<std::size_t>(count);
        // One name. As long as it is no option to look at, it can stand anywhere.
        const std::string_view last = end[-1];
        const bool looks_like_option = last.starts_with('-') || last.starts_with('[');
        return looks_like_option && (is_git || std::filesystem::exists(last)) ? 1 : 0;
    }

    void take_plain_words(std::span<const char* const> words) override {
        git_words_.assign(words.begin(), words.end());
        traces_->required(words.empty());
    }

    void read() override {
        const std::vector<std::string_view> formats{"text", "json", "markdown", "junit"};
        command_.format = value_of<DiffFormat>("--format", format_, formats)
                              .value_or(is_json_ ? DiffFormat::json : DiffFormat::text);
        command_.color = color_choice_of(color_);
        if (is_git_)
            command_.arguments = DiffCommand::Arguments::git;
        if (is_textconv_)
            command_.arguments = DiffCommand::Arguments::textconv;
        command_.options = comparison_.options();
        command_.background = comparison_.background();
        drawing_.read_into(command_);
        command_.files.insert(command_.files.end(), git_words_.begin(), git_words_.end());
        check_diff_files();
    }

    int run() override { return rastertrace::run(command_); }

private:
    /// How many files there have to be.
    void check_diff_files() const {
        const std::size_t count = command_.files.size();
        const auto fail = [count](std::string_view expected) {
            throw problem_of("", fmt::format("diff: expected {}, found {}", expected, count));
        };
        constexpr std::size_t git_arguments = 7;
        if (is_git_ && count != 1 && count < git_arguments)
            fail("the seven arguments of git, or the name of a file that is not merged");
        else if (is_textconv_ && count != 1)
            fail("one file with --textconv");
        else if (!is_git_ && !is_textconv_ && !command_.against.empty() && count != 1)
            fail("one scene with --against");
        else if (!is_git_ && !is_textconv_ && command_.against.empty() && count != 2)
            fail("two files");
    }

    DiffCommand command_;
    std::optional<AddedOption> traces_;
    std::vector<std::string> git_words_; ///< files, from the end of the command line
    ComparisonOptions comparison_;
    bool is_git_ = false;
    bool is_textconv_ = false;
    std::string format_;
    std::string color_;
    bool is_json_ = false;
    DrawingOptions drawing_;
};

} // namespace

std::unique_ptr<Command> diff_command() {
    return std::make_unique<DiffCommandLine>();
}

} // namespace rastertrace
