// SPDX-License-Identifier: MIT
// The options of every command. The only file that knows CLI11.

#include "command_line.h"

#include "commands.h"
#include "environment.h"
#include "load.h"
#include "player_screen.h"

#include <rastertrace/numerics/stress.h>
#include <rastertrace/trace/language.h>
#include <rastertrace/trace/method_names.h>
#include <rastertrace/trace/named_value.h>
#include <rastertrace/trace/problem.h>
#include <rastertrace/trace/stage_name.h>
#include <rastertrace/trace/text.h>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <exception>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

constexpr std::string_view welcome = R"(rastertrace: a rasterizer you can watch think

It draws a scene, writes down every decision with its numbers, and shows them.

  rastertrace show examples/t0-fill/first-triangle.json --every scanline
  rastertrace trace examples/t0-fill/first-triangle.json -o first.trace.json

`rastertrace --help` lists the commands, `rastertrace show --help` explains one.
)";

constexpr std::string_view exit_statuses =
    "Exit status: 0 fine; 1 a difference or a broken rule; 2 bad usage or input; 3 the system "
    "failed.";

/// An option's value that does not fit, in words.
[[noreturn]] void refuse(std::string_view option, std::string_view expected, std::string_view found,
                         std::string hint = {}) {
    throw problem_of("", fmt::format("{}: expected {}, found \"{}\"", option, expected, found),
                     std::move(hint));
}

template <typename Integer> std::optional<Integer> whole_in(std::string_view text) {
    Integer value = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (read.ec != std::errc{} || read.ptr != text.data() + text.size())
        return std::nullopt;
    return value;
}

/// What a list of names stands for, each once.
template <typename Value>
std::vector<Value> list_in(std::string_view option, std::string_view what, std::string_view text,
                           const std::vector<std::string_view>& names,
                           std::optional<Value> (*named)(std::string_view)) {
    std::vector<Value> values;
    for (const std::string& word : split_at(text, ',')) {
        const auto value = named(word);
        if (!value)
            refuse(option, fmt::format("{} out of {}", what, joined(names, ",")), word,
                   did_you_mean(word, names));
        if (std::find(values.begin(), values.end(), *value) == values.end())
            values.push_back(*value);
    }
    return values;
}

Region region_in(const std::string& text) {
    std::vector<int> numbers;
    for (const std::string& word : split_at(text, ','))
        if (const auto number = whole_in<int>(word))
            numbers.push_back(*number);
    if (numbers.size() != 4 || split_at(text, ',').size() != 4)
        refuse("--region", "two corners as x0,y0,x1,y1, like -4,-3,2,5", text);
    if (numbers[0] > numbers[2] || numbers[1] > numbers[3])
        refuse("--region", "the smaller x and y first", text,
               fmt::format("--region {},{},{},{}", std::min(numbers[0], numbers[2]),
                           std::min(numbers[1], numbers[3]), std::max(numbers[0], numbers[2]),
                           std::max(numbers[1], numbers[3])));
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

/// 4,2, or (4, 2) as it is printed.
std::optional<Pixel> pixel_in(std::string_view text) {
    text = without_blanks(text);
    if (text.starts_with('(') && text.ends_with(')'))
        text = text.substr(1, text.size() - 2);
    const auto words = split_at(text, ',');
    const auto x = whole_in<int>(without_blanks(words.front()));
    const auto y = words.size() == 2 ? whole_in<int>(without_blanks(words.back())) : std::nullopt;
    return x && y ? std::optional(Pixel{*x, *y}) : std::nullopt;
}

ColorChoice color_choice_in(const std::string& text) {
    if (text == "always")
        return ColorChoice::always;
    if (text == "never")
        return ColorChoice::never;
    if (text != "auto")
        refuse("--color", "auto, always or never", text);
    return ColorChoice::automatic;
}

/// --fan-passes for fan_passes.
std::string option_named(std::string_view key) {
    std::string option = "--" + std::string(key);
    std::replace(option.begin(), option.end(), '_', '-');
    return option;
}

/// One option per key of the method: --scalar, --fill, ...
class MethodOptions {
public:
    void add_to(CLI::App& command) {
        for (const MethodKey& key : method_keys())
            command
                .add_option(option_of(key), values_[std::string(key.name)],
                            fmt::format("{}: {}", key.meaning, joined(key.values, ", ")))
                ->type_name("NAME")
                ->group("Method, instead of what the scene says");
        command
            .add_option("--keep", keep_,
                        fmt::format("Run these stages even if the scene does not need them: {}",
                                    joined(stage_names(), ",")))
            ->type_name("STAGE,...");
        command.add_flag("--full", full_, "Run every stage that the method has");
    }

    MethodOverrides overrides() const {
        MethodOverrides overrides;
        for (const MethodKey& key : method_keys()) {
            const std::string& value = values_.at(std::string(key.name));
            if (value.empty())
                continue;
            Method scratch;
            if (!key.set(scratch, value))
                refuse(option_of(key), fmt::format("one of {}", joined(key.values, ", ")), value,
                       did_you_mean(value, key.values));
            overrides.emplace_back(key.name, value);
        }
        if (!keep_.empty())
            for (const Stage stage : list_in("--keep", "stages", keep_, stage_names(), stage_named))
                overrides.emplace_back("keep", name_of(stage));
        if (full_)
            for (const std::string_view stage : stage_names())
                overrides.emplace_back("keep", stage);
        return overrides;
    }

private:
    static std::string option_of(const MethodKey& key) { return option_named(key.name); }

    std::map<std::string, std::string> values_;
    std::string keep_;
    bool full_ = false;
};

/// How far the files that are read are trusted: --max-input, --allow-outside; how much of them is held: --max-steps.
class InputOptions {
public:
    /// Of a command that holds the steps of a trace.
    void add_to_holder(CLI::App& command) {
        add_to(command);
        command
            .add_option("--max-steps", max_steps_,
                        "The most steps of a trace to hold; 10 million if not given. Pixels of a "
                        "row that follow one another in a trace that is drawn count as one")
            ->type_name("N");
    }

    void add_to(CLI::App& command) {
        command
            .add_option("--max-input", max_input_,
                        "The largest scene or OBJ file to read, in kB, MB or GB; 256MB if not "
                        "given. A trace may have any size")
            ->type_name("SIZE");
        command.add_flag("--allow-outside", limits_.allow_outside,
                         "Read OBJ files that lie outside of the scene's folder too");
    }

    InputLimits limits() const {
        InputLimits limits = limits_;
        if (!max_input_.empty())
            limits.bytes = size_in(max_input_);
        if (!max_steps_.empty())
            limits.steps = count_in(max_steps_);
        return limits;
    }

private:
    static std::size_t size_in(const std::string& text) {
        constexpr std::array<std::pair<std::string_view, std::size_t>, 3> units{
            {{"kB", 1'000}, {"MB", 1'000'000}, {"GB", 1'000'000'000}}};
        for (const auto& [unit, bytes] : units) {
            if (!text.ends_with(unit))
                continue;
            const auto count = whole_in<std::size_t>(text.substr(0, text.size() - unit.size()));
            if (count && *count > 0 && *count <= std::numeric_limits<std::size_t>::max() / bytes)
                return *count * bytes;
        }
        refuse("--max-input", "a size in kB, MB or GB, like 512MB", text);
    }

    static std::size_t count_in(const std::string& text) {
        if (const auto count = whole_in<std::size_t>(text); count && *count > 0)
            return *count;
        refuse("--max-steps", "a number of steps, from 1", text);
    }

    std::string max_input_;
    std::string max_steps_;
    InputLimits limits_;
};

/// Which frame of a scene whose numbers vary: --vary, --frame.
class FrameOptions {
public:
    /// `without` is what happens without --frame.
    void add_to(CLI::App& command, std::string_view without) {
        command
            .add_option("--vary", vary_,
                        "Let a number of the scene vary from frame to frame, like "
                        "/camera/position/2=4:1:7 (from 4 to 1 in 7 steps) or =4,3,1; may be "
                        "given again")
            ->type_name("POINTER=VALUES")
            ->take_all()
            ->allow_extra_args(false);
        command
            .add_option("--frame", frame_,
                        fmt::format("The frame of a scene that varies, from 1; {}", without))
            ->type_name("N");
    }

    FrameChoice choice() const {
        FrameChoice choice;
        for (const std::string& one : vary_) {
            const std::size_t equals = one.find_last_of('=');
            if (equals == std::string::npos)
                refuse("--vary", "POINTER=FROM:TO:STEPS or a list of values", one,
                       "like /camera/position/2=4:1:7");
            choice.vary.push_back({one.substr(0, equals), one.substr(equals + 1)});
        }
        if (!frame_.empty()) {
            choice.frame = whole_in<std::size_t>(frame_);
            if (choice.frame.value_or(0) < 1)
                refuse("--frame", "the number of a frame, from 1", frame_);
        }
        return choice;
    }

private:
    std::vector<std::string> vary_;
    std::string frame_;
};

constexpr std::string_view first_frame = "1 if not given";

/// The list of keys is as wide as a page.
constexpr std::size_t key_columns = 79;

constexpr std::string_view trace_input =
    "A trace, or a scene, which is drawn first; - for standard input";

/// The words of the command line. A file without a command is shown; no command has a point or a
/// slash in its name.
std::vector<const char*> words_with_command(int count, const char* const* arguments) {
    std::vector<const char*> words(arguments, arguments + count);
    const std::string_view first = words[1];
    if (!first.starts_with('-') && first.find_first_of("./") != std::string_view::npos)
        words.insert(words.begin() + 1, "show");
    return words;
}

/// The program's commands, and what to do once the command line has been read.
class Program {
public:
    Program() {
        app_.require_subcommand(1);
        app_.set_help_flag("-h,--help", "Print this help and exit");
        app_.set_version_flag("-V,--version", std::string("rastertrace ") + RASTERTRACE_VERSION);
        app_.footer("Example: rastertrace show examples/t0-fill/first-triangle.json\n"
                    "A file without a command is shown.\n" +
                    std::string(exit_statuses));
        add_trace();
        add_show();
        add_play();
        add_figure();
        add_explain();
        add_stats();
        add_check();
        add_diff();
        add_validate();
        add_plan();
        add_stress();
        add_report();
        add_renew();
        add_help();
    }

    int run(int count, const char* const* arguments) {
        if (count < 2) {
            print_error(welcome);
            return exit_bad_input;
        }
        const std::vector<const char*> words = words_with_command(count, arguments);
        count = static_cast<int>(words.size());
        arguments = words.data();
        const int words_of_git = count_words_of_git(count, arguments);
        count -= words_of_git;
        git_words_.assign(arguments + count, arguments + count + words_of_git);
        diff_traces_->required(words_of_git == 0);
        try {
            refuse_empty_words(count, arguments);
            refuse_unknown_command(arguments[1]);
            app_.parse(count, arguments);
            choose_language();
            return action_();
        } catch (const CLI::CallForHelp&) {
            print_help(chosen());
        } catch (const CLI::CallForVersion&) {
            print(fmt::format("rastertrace {}\n", RASTERTRACE_VERSION));
        } catch (const CLI::ParseError& error) {
            return complain(error, count, arguments);
        }
        return exit_fine;
    }

private:
    CLI::App& add_command(const std::string& name, const std::string& meaning,
                          const std::string& example) {
        CLI::App& command = *app_.add_subcommand(name, meaning);
        command.footer("Example: " + example);
        return command;
    }

    void add_language(CLI::App& command) {
        command
            .add_option("--language", language_,
                        fmt::format("Tell steps in this language: {}; what RASTERTRACE_LANGUAGE "
                                    "says if not given",
                                    joined(language_codes(), ", ")))
            ->type_name("CODE");
    }

    /// Never by the locale: a command prints the same on every machine.
    void choose_language() const {
        constexpr const char* variable = "RASTERTRACE_LANGUAGE";
        const bool is_option = !language_.empty();
        const auto language =
            one_of(is_option ? "--language" : variable,
                   is_option ? language_ : std::string(environment_variable(variable)),
                   language_codes(), language_with_code);
        if (language)
            tell_steps_in(*language);
    }

    void add_trace() {
        CLI::App& command =
            add_command("trace", "Draw a scene and write its trace, or a part of a trace",
                        "rastertrace trace examples/t0-fill/first-triangle.json --only "
                        "scanline -o rows.json");
        command
            .add_option("scene", trace_.scene,
                        "A scene, or a trace to cut down; - for standard input")
            ->required()
            ->type_name("SCENE");
        command
            .add_option("-o,--output", trace_.output,
                        "Write to this file (.jsonl: JSON Lines) instead of standard output")
            ->type_name("FILE");
        command.add_option("--format", format_, "json or jsonl, whatever the file's name")
            ->type_name("NAME");
        command
            .add_option(
                "--only", only_,
                fmt::format("Write only these kinds of step: {}", joined(step_kind_names(), ",")))
            ->type_name("KIND,...");
        command.add_option("--region", region_, "Write only steps that touch these pixels")
            ->type_name("x0,y0,x1,y1");
        command
            .add_option("--primitive", trace_.filter.primitive,
                        "Write only the steps of this primitive and its parts")
            ->type_name("NAME");
        trace_method_.add_to(command);
        trace_input_.add_to(command);
        trace_frames_.add_to(command, "without it, -o writes a file for each");
        command.callback([this] {
            if (!format_.empty() && format_ != "json" && format_ != "jsonl")
                refuse("--format", "json or jsonl", format_);
            if (!format_.empty())
                trace_.layout = format_ == "json" ? TraceLayout::json : TraceLayout::jsonl;
            if (!only_.empty())
                trace_.filter.only =
                    list_in("--only", "kinds of step", only_, step_kind_names(), step_kind_named);
            if (!region_.empty())
                trace_.filter.region = region_in(region_);
            trace_.method = trace_method_.overrides();
            trace_.input = trace_input_.limits();
            trace_.frames = trace_frames_.choice();
            action_ = [this] { return rastertrace::run(trace_); };
        });
    }

    void add_view_to(CLI::App& command) {
        command
            .add_option(
                "--view", view_,
                fmt::format("What a cell shows: {}; if none is given, what the scene is about",
                            joined(view_names(), ", ")))
            ->type_name("NAME");
    }

    void add_show() {
        CLI::App& command = add_command(
            "show", "Print frames of a trace as text",
            "rastertrace show examples/t0-fill/first-triangle.json --every scanline\n\n"
            "In a frame, . is empty, # plotted, @ plotted by the step shown, x tested and not "
            "drawn, a letter a\nvertex; --view faces, shade, depth, writes or coverage show more.\n"
            "STEP is a number, first, last, or a kind of step with what it has:\n"
            "14, scanline, \"scanline y=2\", \"depth x=3 y=2 fail\", \"face culled\", \"pixel "
            "in=ABC\"");
        command.add_option("trace", show_.trace, std::string(trace_input))
            ->required()
            ->type_name("TRACE");
        CLI::Option_group* const which =
            command.add_option_group("Which frames", "One of these; --last if none is given");
        which->require_option(0, 1);
        which->add_option("--step", step_, "After this step, from 0")->type_name("STEP");
        which->add_flag("--last", last_, "After the last step");
        which
            ->add_option("--every", every_,
                         "After every such step, together with the pixels that belong to it")
            ->type_name("STEP");
        which->add_flag("--all", all_, "After every step");
        command.add_flag("--bare", show_.bare, "Only the grid: . empty, # plotted, top row first");
        add_view_to(command);
        command.add_option("--region", show_region_, "Show only these pixels")
            ->type_name("x0,y0,x1,y1");
        command.add_flag("--overview", show_.is_overview,
                         "Show all of the canvas, many pixels to a cell");
        command.add_flag(
            "--frames", show_.has_frames,
            "With --every: a frame for each step, also of kinds that are told as a table");
        command.add_flag("--working", show_.has_working,
                         "Write out how the numbers of a step come of one another");
        command
            .add_option(
                "--format", table_format_,
                fmt::format("With --every: the steps as {}", joined(table_format_names(), ", ")))
            ->type_name("NAME");
        command.add_flag("--json", is_json_table_, "With --every: short for --format json");
        command.add_option("--color", color_, "auto, always or never: colors, on a terminal")
            ->type_name("WHEN");
        add_language(command);
        show_method_.add_to(command);
        show_input_.add_to_holder(command);
        show_frames_.add_to(command, "all if not given");
        command.callback([this] {
            if (!step_.empty())
                show_.which = ShowCommand::Which::step;
            if (!every_.empty())
                show_.which = ShowCommand::Which::every;
            show_.selector = step_ + every_; // one of them, at most
            if (all_)
                show_.which = ShowCommand::Which::all;
            show_.view = one_of("--view", view_, view_names(), view_named);
            if (!show_region_.empty())
                show_.region = region_in(show_region_);
            if (show_.bare && show_.is_overview)
                refuse("--overview", "a frame, without --bare", "--bare");
            if (show_.bare && show_.has_working)
                refuse("--bare", "only the grid, without --working", "--bare");
            if (show_.region && show_.is_overview)
                refuse("--overview", "no --region beside it", show_region_);
            if (is_json_table_) {
                if (!table_format_.empty())
                    refuse("--json", "no --format beside it", table_format_);
                if (show_.which != ShowCommand::Which::every || show_.bare ||
                    show_.asks_for_frames())
                    refuse("--json", "--every beside it, and no grid", "--json");
                table_format_ = "json";
            }
            if (!table_format_.empty()) {
                show_.format = table_format_named(table_format_);
                if (!show_.format)
                    refuse("--format", fmt::format("one of {}", joined(table_format_names(), ", ")),
                           table_format_, did_you_mean(table_format_, table_format_names()));
                if (show_.which != ShowCommand::Which::every)
                    refuse("--format", "--every beside it", table_format_);
                if (show_.has_working && show_.format != TableFormat::table)
                    refuse("--working", "sentences, without --format " + table_format_,
                           "--working");
                if (show_.bare || show_.asks_for_frames())
                    refuse("--format",
                           "a table, without --bare, --frames, --view, --region and --overview",
                           table_format_);
            }
            if (!color_.empty())
                show_.color = color_choice_in(color_);
            show_.method = show_method_.overrides();
            show_.input = show_input_.limits();
            show_.frames = show_frames_.choice();
            action_ = [this] { return rastertrace::run(show_); };
        });
    }

    void add_play() {
        CLI::App& command = add_command(
            "play", "Go through a trace step by step, forward and back, in the terminal",
            "rastertrace play examples/t0-fill/first-triangle.json --step \"scanline y=2\"\n\n"
            "rastertrace play --keys lists the keys, and ? does while it plays.");
        CLI::Option* const trace =
            command.add_option("trace", play_.trace, std::string(trace_input))->type_name("TRACE");
        command.add_flag("--keys", lists_keys_, "List the keys, and play nothing")->excludes(trace);
        command
            .add_option("--step", play_.step, "Begin at this step; before the first if not given")
            ->type_name("STEP");
        add_view_to(command);
        command
            .add_option(
                "--memory", memory_,
                fmt::format("Megabytes for pictures that are kept for going back, {} if not given",
                            Snapshots::usual_bytes / 1'000'000))
            ->type_name("N");
        command.add_option("--color", color_, "auto, always or never: colors")->type_name("WHEN");
        command
            .add_option("--print", screen_size_,
                        "Print the first screen of a terminal of that size, and play nothing")
            ->type_name("COLUMNSxLINES");
        add_language(command);
        play_method_.add_to(command);
        play_input_.add_to_holder(command);
        play_frames_.add_to(command, "all if not given");
        command.callback([this] {
            if (lists_keys_) {
                action_ = [] {
                    print(joined(player_help(key_columns), "\n") + "\n");
                    return exit_fine;
                };
                return;
            }
            if (play_.trace.empty())
                refuse("TRACE", "a trace or a scene to play", "none");
            play_.view = one_of("--view", view_, view_names(), view_named);
            if (!memory_.empty()) {
                constexpr std::size_t most_megabytes = 1'000'000;
                const auto megabytes = whole_in<std::size_t>(memory_);
                if (megabytes.value_or(0) < 1 || *megabytes > most_megabytes)
                    refuse("--memory", "a number of megabytes from 1 to 1000000", memory_);
                play_.bytes = *megabytes * 1'000'000;
            }
            if (!color_.empty())
                play_.color = color_choice_in(color_);
            if (!screen_size_.empty())
                play_.screen = screen_size_in(screen_size_);
            play_.method = play_method_.overrides();
            play_.input = play_input_.limits();
            play_.frames = play_frames_.choice();
            action_ = [this] { return rastertrace::run(play_); };
        });
    }

    /// 80x24
    static TextSize screen_size_in(const std::string& text) {
        constexpr std::size_t most = 1000;
        const auto parts = split_at(text, 'x');
        const auto columns = whole_in<std::size_t>(parts.front());
        const auto lines = whole_in<std::size_t>(parts.back());
        const auto is_fine = [](std::optional<std::size_t> size) {
            return size && 1 <= *size && *size <= most;
        };
        if (parts.size() != 2 || !is_fine(columns) || !is_fine(lines))
            refuse("--print", "columns and lines from 1 to 1000, as in 80x24", text);
        return {*columns, *lines};
    }

    void add_figure() {
        std::string list;
        for (const FigurePartRow& row : figure_parts())
            list += fmt::format("  {:<12} {}\n", row.name, row.shows);
        CLI::App& command = add_command(
            "figure", "Draw frames as figures for a page, a book or a talk",
            "rastertrace figure examples/t0-fill/first-triangle.json --step \"scanline y=2\" -o "
            "row.svg\n\n"
            "An .html is a page to click through, forward and back, with all steps.\n\n"
            "What a figure can show (PART), for --with and --without:\n" +
                list);
        command.add_option("trace", figure_.trace, std::string(trace_input))
            ->required()
            ->type_name("TRACE");
        command
            .add_option("-o,--output", figure_.output,
                        fmt::format("The file; its name ends in one of {}; - for standard output",
                                    joined(endings_in<FigureFormat>(figure_endings), ", ")))
            ->required()
            ->type_name("FILE");
        command
            .add_option("--format", figure_format_,
                        "svg, png, tex, txt, cast, gif or html, whatever the file's name")
            ->type_name("NAME");
        CLI::Option_group* const which = command.add_option_group(
            "Which frames", "One of these; if none is given, the last one, and of a .gif, "
                            ".cast or --animate each row, pixel of a line and vertex");
        which->require_option(0, 1);
        which
            ->add_option(
                "--step", figure_step_,
                "After this step, together with the pixels that belong to it; of an .html, the "
                "step that it begins at")
            ->type_name("STEP");
        which
            ->add_option("--until", figure_until_,
                         "Before this step, which is not told: an exercise")
            ->type_name("STEP");
        which
            ->add_option("--every", figure_every_,
                         "After every such step: a file for each, but for --sheet, --animate, .gif "
                         "and .cast")
            ->type_name("STEP");
        command
            .add_option("--sheet", figure_sheet_,
                        "Frames side by side, like 3x4: 3 columns, 4 rows")
            ->type_name("CxR");
        command.add_flag("--animate", figure_.is_animated, "All frames in one .svg, which moves");
        command
            .add_option("--seconds", figure_seconds_,
                        "How long each frame is seen; by default all of them take 20, and one at "
                        "most 1")
            ->type_name("N");
        command.add_option("--with", figure_with_, "Show these parts too")->type_name("PART,...");
        command.add_option("--without", figure_without_, "Leave these parts out")
            ->type_name("PART,...");
        command.add_option("--title", figure_.options.title, "This title instead of the scene's")
            ->type_name("TEXT");
        command
            .add_option("--caption", figure_.options.caption,
                        "This text instead of the step's sentence; none for no text")
            ->type_name("TEXT");
        command
            .add_option(
                "--view", figure_view_,
                fmt::format("What the color of a pixel means: {}; if none is given, what the scene "
                            "is about",
                            joined(figure_views(), ", ")))
            ->type_name("NAME");
        command
            .add_option("--against", figure_.against,
                        "Compare the pixels with those of another trace or scene, or of the same "
                        "scene by another METHOD (key=value,...)")
            ->type_name("TRACE|METHOD");
        command.add_option("--region", figure_region_, "Show only these pixels")
            ->type_name("x0,y0,x1,y1");
        command
            .add_option("--palette", figure_palette_,
                        "Colors of faces: distinct (for every kind of color vision) or scene")
            ->type_name("NAME");
        command
            .add_option("--theme", figure_theme_,
                        "auto (in an .svg as the reader has set it), light, dark or print (grays)")
            ->type_name("NAME");
        command
            .add_option("--cell", figure_cell_,
                        "The side of a pixel, in units; by default by the canvas")
            ->type_name("PX");
        command
            .add_option("--scale", figure_scale_,
                        "Of a .png or .gif: pixels of a unit; 2 and 1 if not given")
            ->type_name("N");
        command.add_option("--width", figure_width_, "Of a .tex: millimeters")->type_name("MM");
        command.add_flag(
            "--bare", figure_.is_bare,
            "Only the pixels in their own colors, one unit each if --cell is not given");
        add_language(command);
        figure_method_.add_to(command);
        figure_input_.add_to_holder(command);
        figure_frames_.add_to(command, "all if not given");
        command.callback([this] { set_figure(); });
    }

    /// A number above 0, at most `most`.
    static std::optional<double> size_in(std::string_view option, const std::string& text,
                                         double most) {
        if (text.empty())
            return std::nullopt;
        const auto value = nearest_double_in(text);
        if (!value || !(*value > 0) || *value > most)
            refuse(option, fmt::format("a number above 0, at most {:g}", most), text);
        return value;
    }

    /// What one of several names stands for, as `named` has it; nothing if there is none.
    template <typename Named>
    static auto one_of(std::string_view option, const std::string& text,
                       const std::vector<std::string_view>& names, const Named& named)
        -> decltype(named(std::string_view())) {
        if (text.empty())
            return std::nullopt;
        const auto value = named(text);
        if (!value)
            refuse(option, fmt::format("one of {}", joined(names, ", ")), text,
                   did_you_mean(text, names));
        return value;
    }

    /// The same where the names are in the order of the values.
    template <typename Value>
    static std::optional<Value> one_of(std::string_view option, const std::string& text,
                                       const std::vector<std::string_view>& names) {
        return one_of(option, text, names,
                      [&names](std::string_view name) { return value_named<Value>(names, name); });
    }

    /// The views that have colors.
    static std::vector<std::string_view> figure_views() {
        std::vector<std::string_view> names = view_names();
        std::erase_if(names,
                      [](std::string_view name) { return view_named(name) == View::coverage; });
        return names;
    }

    void set_figure() {
        using Which = FigureCommand::Which;
        if (!figure_step_.empty())
            figure_.which = Which::step;
        if (!figure_until_.empty())
            figure_.which = Which::until;
        if (!figure_every_.empty())
            figure_.which = Which::every;
        figure_.selector = figure_step_ + figure_until_ + figure_every_; // one of them, at most

        std::vector<std::string_view> part_names;
        for (const FigurePartRow& row : figure_parts())
            part_names.push_back(row.name);
        FigureOptions& options = figure_.options;
        if (!figure_with_.empty())
            options.with = list_in("--with", "parts", figure_with_, part_names, figure_part_named);
        if (!figure_without_.empty())
            options.without =
                list_in("--without", "parts", figure_without_, part_names, figure_part_named);
        for (const FigurePart part : options.with)
            if (std::find(options.without.begin(), options.without.end(), part) !=
                options.without.end())
                refuse("--without", "parts that are not in --with", figure_without_);
        if (options.caption == "none") {
            options.caption.reset();
            options.without.push_back(FigurePart::caption);
        }
        options.view = one_of("--view", figure_view_, figure_views(), view_named);
        if (options.view == View::coverage) // tells numbers, not colors
            refuse("--view", fmt::format("one of {}", joined(figure_views(), ", ")), figure_view_);
        if (!figure_region_.empty())
            options.region = region_in(figure_region_);
        options.palette =
            one_of("--palette", figure_palette_, face_palette_names(), face_palette_named)
                .value_or(FacePalette::distinct);
        constexpr double largest_cell = 1000;
        options.cell = size_in("--cell", figure_cell_, largest_cell);

        FigureStyle& style = figure_.style;
        style.theme =
            one_of("--theme", figure_theme_, theme_names(), theme_named).value_or(Theme::automatic);
        constexpr double largest_scale = 100;
        style.scale = size_in("--scale", figure_scale_, largest_scale);
        constexpr double largest_width = 5000;
        style.width_mm = size_in("--width", figure_width_, largest_width);
        constexpr double longest = 600;
        style.seconds = size_in("--seconds", figure_seconds_, longest);
        constexpr double shortest = 0.02; // of a GIF, as browsers play it
        if (style.seconds && *style.seconds < shortest)
            refuse("--seconds", fmt::format("at least {:g}", shortest), figure_seconds_);

        if (figure_.is_bare) {
            for (const FigurePartRow& row : figure_parts())
                if (row.part != FigurePart::pixels)
                    options.without.push_back(row.part);
            options.view = options.view.value_or(View::shade);
            options.cell = options.cell.value_or(1);
            style.scale = style.scale.value_or(1);
        }
        if (!figure_format_.empty())
            figure_.format =
                one_of("--format", figure_format_, figure_format_names(), figure_format_named);
        if (!figure_sheet_.empty())
            figure_.sheet = sheet_in(figure_sheet_);
        figure_.method = figure_method_.overrides();
        figure_.input = figure_input_.limits();
        figure_.frames = figure_frames_.choice();
        action_ = [this] { return rastertrace::run(figure_); };
    }

    static FigureCommand::Sheet sheet_in(const std::string& text) {
        const auto words = split_at(text, 'x');
        if (words.size() == 2) {
            const auto columns = whole_in<std::size_t>(words[0]);
            const auto rows = whole_in<std::size_t>(words[1]);
            constexpr std::size_t most = 100;
            if (columns && rows && 0 < *columns && *columns <= most && 0 < *rows && *rows <= most)
                return {*columns, *rows};
        }
        refuse("--sheet", "columns and rows, like 3x4, each from 1 to 100", text);
    }

    void add_explain() {
        CLI::App& command = add_command(
            "explain", "Say why a pixel, a row, a face, ... is as it is",
            "rastertrace explain examples/t0-fill/first-triangle.json --pixel 4,2\n\n"
            "Of a pixel: who drew it, and what kept all others out, with the numbers. --against\n"
            "rounding=truncate asks the same under another method, and tells the first decision\n"
            "that differs.");
        command.add_option("trace", explain_.trace, std::string(trace_input))
            ->required()
            ->type_name("TRACE");
        CLI::Option_group* const what = command.add_option_group("What is asked", "One of these");
        what->require_option(1);
        what->add_option("--pixel", explain_pixel_, "Who drew it, and why others did not")
            ->type_name("X,Y");
        what->add_option("--scanline", explain_row_, "Both ends of the row")->type_name("Y");
        const auto add_text = [&](const char* name, const char* meaning, const char* type) {
            what->add_option(name, explain_texts_[name], meaning)->type_name(type);
        };
        add_text("--face", "How it is turned, lit and clipped, and what is seen of it", "NAME");
        add_text("--vertex", "Where it is, from space to space", "NAME");
        add_text("--edge", "How it is set up, and the rows that end at it", "NAME");
        add_text("--pair", "Who has each pixel along the edge of two triangles", "NAME,NAME");
        add_text("--step", "One step: a number, or like \"scanline y=2\"", "STEP");
        command
            .add_option("--against", explain_.against,
                        "Ask the same of the scene drawn by another method, like "
                        "rounding=truncate,sample=center")
            ->type_name("METHOD");
        command.add_option("--format", explain_format_, "text or json")->type_name("NAME");
        command.add_flag("--json", explain_.json, "Short for --format json");
        add_language(command);
        explain_method_.add_to(command);
        explain_input_.add_to_holder(command);
        explain_frames_.add_to(command, first_frame);
        command.callback([this] {
            if (!explain_format_.empty() && explain_format_ != "text" && explain_format_ != "json")
                refuse("--format", "text or json", explain_format_);
            explain_.json = explain_.json || explain_format_ == "json";
            explain_.question = explain_question();
            explain_.method = explain_method_.overrides();
            explain_.input = explain_input_.limits();
            explain_.frames = explain_frames_.choice();
            action_ = [this] { return rastertrace::run(explain_); };
        });
    }

    /// What `explain` is asked.
    Question explain_question() const {
        if (!explain_pixel_.empty()) {
            const auto pixel = pixel_in(explain_pixel_);
            if (!pixel)
                refuse("--pixel", "a pixel as x,y, like 4,2", explain_pixel_);
            return {.about = Topic::pixel, .pixel = *pixel};
        }
        if (!explain_row_.empty()) {
            const auto y = whole_in<int>(explain_row_);
            if (!y)
                refuse("--scanline", "the y of a row, like 2", explain_row_);
            return {.about = Topic::scanline, .pixel = {0, *y}};
        }
        for (const Topic topic :
             {Topic::face, Topic::vertex, Topic::edge, Topic::pair, Topic::step}) {
            const auto text = explain_texts_.find("--" + std::string(name_of(topic)));
            if (text != explain_texts_.end() && !text->second.empty())
                return {.about = topic, .text = text->second};
        }
        return {};
    }

    void add_stats() {
        CLI::App& command = add_command("stats", "Count the steps, pixels and writes of a trace",
                                        "rastertrace stats examples/t0-fill/first-triangle.json");
        command.add_option("trace", stats_.trace, std::string(trace_input))
            ->required()
            ->type_name("TRACE");
        command.add_flag("--json", stats_.json, "Print JSON");
        command
            .add_option("--fail-on", fail_on_,
                        fmt::format("End with status 1 if there are any of these, with 2 if that "
                                    "cannot be judged: {}",
                                    joined(finding_names(), ",")))
            ->type_name("NAME,...");
        stats_method_.add_to(command);
        stats_input_.add_to_holder(command);
        stats_frames_.add_to(command, first_frame);
        command.callback([this] {
            if (!fail_on_.empty())
                stats_.fail_on =
                    list_in("--fail-on", "findings", fail_on_, finding_names(), finding_named);
            stats_.method = stats_method_.overrides();
            stats_.input = stats_input_.limits();
            stats_.frames = stats_frames_.choice();
            action_ = [this] { return rastertrace::run(stats_); };
        });
    }

    static std::vector<std::string_view> finding_names() {
        std::vector<std::string_view> names;
        for (const StatsFinding finding : stats_findings)
            names.push_back(name_of(finding));
        return names;
    }
    static std::optional<StatsFinding> finding_named(std::string_view name) {
        for (const StatsFinding finding : stats_findings)
            if (name_of(finding) == name)
                return finding;
        return std::nullopt;
    }

    void add_check() {
        CLI::App& command = add_command(
            "check", "Say which line of a worked example is wrong, and why",
            "rastertrace check examples/claims/t0-rows.claims\n\n"
            "Claims are lines like these, in a file; docs/check.md has all of them:\n"
            "y=2: -1/4, 25/8 -> -1..3     (3,2): on     A screen: 2, 5     normal ABC: 0, 0, -4\n"
            "Exit status 1: a claim is wrong.");
        command
            .add_option("file", check_.files,
                        "A scene or a trace, then files of claims; or only claims that name their "
                        "scenes; - for standard input")
            ->required()
            ->type_name("[SCENE] CLAIMS");
        command
            .add_option("--format", check_format_,
                        "text, json, junit, or csv: one line for each file")
            ->type_name("NAME");
        command.add_flag("--json", is_json_check_, "Short for --format json");
        command.add_flag("--no-answers", has_no_answers_,
                         "Tell only which claims are right and which are wrong");
        command.add_flag("--template", check_.is_template,
                         "Write the claims file of a scene with ? in place of every number");
        add_language(command);
        check_method_.add_to(command);
        check_input_.add_to_holder(command);
        check_frames_.add_to(command, first_frame);
        command.callback([this] {
            read_check_format();
            check_.has_answers = !has_no_answers_;
            check_.method = check_method_.overrides();
            check_.input = check_input_.limits();
            check_.frames = check_frames_.choice();
            action_ = [this] { return rastertrace::run(check_); };
        });
    }

    void read_check_format() {
        if (is_json_check_ && !check_format_.empty())
            refuse("--json", "no --format beside it", check_format_);
        if (is_json_check_)
            check_format_ = "json";
        const std::vector<std::string_view> names{"text", "json", "junit", "csv"};
        check_.format =
            one_of<CheckFormat>("--format", check_format_, names).value_or(CheckFormat::text);
        if (!check_.is_template)
            return;
        if (check_.files.size() > 1)
            refuse("--template", "one scene, without claims", check_.files[1]);
        if (has_no_answers_ || !check_format_.empty())
            refuse("--template", "no --format, --json or --no-answers beside it", check_format_);
    }

    void add_validate() {
        CLI::App& command = add_command(
            "validate", "Say whether files are scenes, traces or claims that can be used",
            "rastertrace validate examples/t0-fill/first-triangle.json\n\n"
            "What a file is, is found by its content. Exit status 2: one of them is not valid.\n"
            "--schema prints the JSON Schema of a kind of file, for an editor:\n"
            "rastertrace validate --schema scene > scene.schema.json");
        command.add_option("file", validate_.files, "The files; - for standard input")
            ->type_name("FILE");
        command
            .add_option(
                "--kind", validate_kind_,
                fmt::format("What each file has to be: {}", joined(schema_kind_names(), ", ")))
            ->type_name("NAME");
        command.add_option("--format", validate_format_, "text or json")->type_name("NAME");
        command.add_flag("--json", is_json_validation_, "Short for --format json");
        command
            .add_option(
                "--schema", validate_schema_,
                fmt::format("Print a schema instead: {}", joined(schema_kind_names(), ", ")))
            ->type_name("NAME");
        validate_input_.add_to_holder(command);
        command.callback([this] {
            validate_.kind = schema_kind_in("--kind", validate_kind_);
            validate_.schema = schema_kind_in("--schema", validate_schema_);
            if (validate_.schema && !validate_.files.empty())
                refuse("--schema", "no file beside it", validate_.files.front());
            if (!validate_.schema && validate_.files.empty())
                throw problem_of("", "validate: expected a file, found none",
                                 "- is standard input; --schema NAME prints a schema");
            if (std::count(validate_.files.begin(), validate_.files.end(), "-") > 1)
                refuse("validate", "standard input once", "-");
            if (is_json_validation_ && !validate_format_.empty())
                refuse("--json", "no --format beside it", validate_format_);
            if (!validate_format_.empty() && validate_format_ != "text" &&
                validate_format_ != "json")
                refuse("--format", "text or json", validate_format_);
            validate_.json = is_json_validation_ || validate_format_ == "json";
            validate_.input = validate_input_.limits();
            action_ = [this] { return rastertrace::run(validate_); };
        });
    }

    /// The kind of file that an option names, if it was given.
    static std::optional<SchemaKind> schema_kind_in(std::string_view option,
                                                    const std::string& name) {
        const auto kind = schema_kind_named(name);
        if (!kind && !name.empty())
            refuse(option, fmt::format("one of {}", joined(schema_kind_names(), ", ")), name,
                   did_you_mean(name, schema_kind_names()));
        return kind;
    }

    void add_plan() {
        CLI::App& command =
            add_command("plan", "Say which stages of drawing a scene needs, and why",
                        "rastertrace plan examples/t4-pipeline/behind-the-eye.json");
        command.add_option("scene", plan_.scene, "A scene; - for standard input")
            ->required()
            ->type_name("SCENE");
        command.add_flag("--json", plan_.json, "Print JSON");
        plan_method_.add_to(command);
        plan_input_.add_to(command);
        plan_frames_.add_to(command, first_frame);
        command.callback([this] {
            plan_.method = plan_method_.overrides();
            plan_.input = plan_input_.limits();
            plan_.frames = plan_frames_.choice();
            action_ = [this] { return rastertrace::run(plan_); };
        });
    }

    void add_stress() {
        CLI::App& command = add_command(
            "stress", "Run the stiff and extreme cases, or look for cliffs in a scene",
            "rastertrace stress --case S1\n"
            "         rastertrace stress --case S1 --scene | rastertrace show -\n"
            "         rastertrace stress examples/t0-fill/first-triangle.json\n\n"
            "Each row of a case is one scalar and one method: right; within its stated bound; "
            "wrong\n"
            "by a count; or refused. What is documented to be wrong must be wrong by just that. "
            "Exit\n"
            "status 1: a row is not as documented. How the program bears bad files, full disks "
            "and\n"
            "odd terminals (R1 to R12 of the catalogue) is tested elsewhere: it is no arithmetic.");
        command
            .add_option(
                "scene", stress_.scene,
                "A scene; - for standard input. Is it near any cliff, and does a scalar fall?")
            ->type_name("SCENE");
        command
            .add_option(
                "--case", stress_.cases,
                "Only these cases, in full: L1 to L13, S1 to S14, C1 to C18, Z1 to Z14, P1 to "
                "P12, X1 to X9")
            ->type_name("ID,...")
            ->delimiter(',')
            ->allow_extra_args(false);
        stress_scene_ = command
                            .add_option("--scene", stress_number_,
                                        "Print the scene of the case, or its Nth scene, to draw it")
                            ->type_name("[N]")
                            ->expected(0, 1);
        command.add_flag("--quick", stress_.quick, "Every case, the longest with one scalar only");
        command.add_flag("--json", stress_.json, "Print JSON");
        command.add_flag("--markdown", stress_.markdown,
                         "Print the cases as entries of a page, with what is wrong or refused");
        stress_method_.add_to(command);
        stress_input_.add_to(command);
        stress_frames_.add_to(command, first_frame);
        command.callback([this] {
            stress_.method = stress_method_.overrides();
            stress_.input = stress_input_.limits();
            stress_.frames = stress_frames_.choice();
            check_stress();
            action_ = [this] { return rastertrace::run(stress_); };
        });
    }

    /// Which options of `stress` go together.
    void check_stress() {
        const bool has_scene = !stress_.scene.empty();
        if (has_scene && !stress_.cases.empty())
            refuse("--case", "cases, or a scene, not both", stress_.scene,
                   find_stress_case(stress_.scene) != nullptr
                       ? fmt::format("several cases are one word: --case {},{}",
                                     joined(stress_.cases, ","), stress_.scene)
                       : "");
        if (stress_.markdown && (has_scene || stress_.json))
            refuse("--markdown", "cases to print as entries of a page",
                   has_scene ? stress_.scene : "--json");
        for (const auto& [key, value] : stress_.method) {
            if (!has_scene)
                refuse(option_named(key), "a scene to draw by another method", "none",
                       "the cases of the catalogue have their own methods");
            if (key == "scalar")
                refuse("--scalar", "no scalar: the scene is drawn with each", value);
        }
        if (!has_scene && (!stress_.frames.vary.empty() || stress_.frames.frame))
            refuse(stress_.frames.frame ? "--frame" : "--vary", "a scene whose numbers vary",
                   "none");
        if (stress_scene_->count() == 0)
            return;
        if (has_scene || stress_.cases.size() != 1)
            refuse("--scene", "one case whose scene to print",
                   fmt::format("{}", joined(stress_.cases, ",")), "say --case S1 --scene");
        stress_.scene_number = 1;
        if (!stress_number_.empty()) {
            stress_.scene_number = whole_in<std::size_t>(stress_number_);
            if (!stress_.scene_number)
                refuse("--scene", "the number of a scene, from 1", stress_number_);
        }
    }

    void add_report() {
        CLI::App& command =
            add_command("report", "Measure error against run time, for every method and scalar",
                        "rastertrace report examples/numerics/friendly.json --quick --jobs edge");
        command.add_option("scene", report_.scenes, "Scenes; - for standard input")
            ->required()
            ->type_name("SCENE...");
        command
            .add_option("-o,--output", report_.outputs,
                        "Write to this file instead of standard output: .svg, .html, .json, .csv "
                        "or .txt; may be given again")
            ->type_name("FILE")
            ->take_all()
            ->allow_extra_args(false);
        command
            .add_option("--format", report_format_,
                        "text, json, csv, svg or html, whatever the file's name")
            ->type_name("NAME");
        command
            .add_option("--jobs", report_jobs_text_,
                        fmt::format("Measure only these jobs: {}", joined(job_names(), ",")))
            ->type_name("JOB,...");
        command.add_flag("--quick", report_.quick, "Take seconds, not minutes; times are rough");
        report_method_.add_to(command);
        report_input_.add_to(command);
        report_frames_.add_to(command, first_frame);
        command.callback([this] {
            const std::vector<std::string_view> formats{"text", "json", "csv", "svg", "html"};
            report_.format = one_of<ReportFormat>("--format", report_format_, formats);
            if (!report_jobs_text_.empty())
                report_.jobs =
                    list_in("--jobs", "jobs", report_jobs_text_, job_names(), report_job_named);
            report_.method = report_method_.overrides();
            report_.input = report_input_.limits();
            report_.frames = report_frames_.choice();
            action_ = [this] { return rastertrace::run(report_); };
        });
    }

    static std::vector<std::string_view> job_names() {
        std::vector<std::string_view> names;
        for (const ReportJob job : report_jobs())
            names.push_back(name_of(job));
        return names;
    }

    void add_diff() {
        CLI::App& command = add_command(
            "diff", "Say what two traces do differently",
            "rastertrace diff golden.json scene.json\n\n"
            "Steps are found by their primitive and what they are about, numbers compared by "
            "value.\n"
            "With git: git config diff.trace.command \"rastertrace diff --git\", or\n"
            "diff.trace.textconv \"rastertrace diff --textconv\", and *.trace.json diff=trace in\n"
            ".gitattributes.");
        diff_traces_ = command
                           .add_option("traces", diff_.files,
                                       "Two traces, or scenes, which are drawn first; - for "
                                       "standard input")
                           ->required()
                           ->type_name("A B");
        command
            .add_option("--against", diff_.against,
                        "Compare the only scene with itself, drawn by another method, like "
                        "scalar=double")
            ->type_name("METHOD");
        command
            .add_option("--tolerance", diff_tolerances_,
                        "How far apart numbers may be: scanline.left=1e-9, depth=4ulp, or 4ulp for "
                        "all; a list, and may be given again")
            ->type_name("KIND.FIELD=AMOUNT")
            ->take_all()
            ->allow_extra_args(false);
        command
            .add_option("--ignore", diff_ignored_,
                        "Leave out kinds of steps, fields, or header: sample,pixel.color,header")
            ->type_name("NAMES");
        command.add_option("--only", diff_only_, "Compare these kinds of steps alone")
            ->type_name("KINDS");
        command.add_flag("--git", diff_is_git_,
                         "Take the arguments that git gives to an external diff command; always "
                         "exit status 0");
        command.add_flag("--textconv", diff_is_textconv_,
                         "Write the lines of one trace that git is to compare");
        command.add_option("--format", diff_format_, "text or json")->type_name("NAME");
        command.add_flag("--json", diff_.json, "Short for --format json");
        add_language(command);
        diff_method_.add_to(command);
        diff_input_.add_to_holder(command);
        diff_frames_.add_to(command, first_frame);
        command.callback([this] {
            read_diff_options();
            action_ = [this] { return rastertrace::run(diff_); };
        });
    }

    /// How many words at the end of the command line git has put there for `diff --git` or `--textconv`. They are names
    /// of files, which may look like options; what somebody has configured stands in front of them.
    static int count_words_of_git(int count, const char* const* arguments) {
        if (count < 3 || arguments[1] != std::string_view("diff"))
            return 0;
        const auto is_for_git = [](std::string_view word) {
            return word == "--git" || word == "--textconv";
        };
        const char* const* const end = arguments + count;
        const char* const* const option = std::find_if(arguments + 2, end, is_for_git);
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
        // Name, old file, its hash and mode, new file, its hash and mode; then perhaps a new name, and what has changed.
        const bool is_git = *option == std::string_view("--git");
        if (is_git)
            for (const int words : {7, 8, 9})
                if (end - option > words && is_hash(end[2 - words]) && is_mode(end[3 - words]) &&
                    is_hash(end[5 - words]) && is_mode(end[6 - words]))
                    return words;
        // One name. As long as it is no option to look at, it can stand anywhere.
        const std::string_view last = end[-1];
        const bool looks_like_option = last.starts_with('-') || last.starts_with('[');
        return looks_like_option && (is_git || std::filesystem::exists(last)) ? 1 : 0;
    }

    void read_diff_options() {
        if (!diff_format_.empty() && diff_format_ != "text" && diff_format_ != "json")
            refuse("--format", "text or json", diff_format_);
        diff_.json = diff_.json || diff_format_ == "json";
        if (diff_is_git_)
            diff_.arguments = DiffCommand::Arguments::git;
        if (diff_is_textconv_)
            diff_.arguments = DiffCommand::Arguments::textconv;
        for (const std::string& list : diff_tolerances_)
            for (const std::string& one : split_at(list, ','))
                diff_.options.tolerances.push_back(parse_tolerance(one));
        if (!diff_ignored_.empty())
            diff_.options.ignored = split_at(diff_ignored_, ',');
        if (!diff_only_.empty())
            diff_.options.only = split_at(diff_only_, ',');
        diff_.method = diff_method_.overrides();
        diff_.input = diff_input_.limits();
        diff_.frames = diff_frames_.choice();
        diff_.files.insert(diff_.files.end(), git_words_.begin(), git_words_.end());
        check_diff_files();
    }

    /// How many files there have to be.
    void check_diff_files() const {
        const std::size_t count = diff_.files.size();
        const auto fail = [count](std::string_view expected) {
            throw problem_of("", fmt::format("diff: expected {}, found {}", expected, count));
        };
        constexpr std::size_t git_arguments = 7;
        if (diff_is_git_ && count != 1 && count < git_arguments)
            fail("the seven arguments of git, or the name of a file that is not merged");
        else if (diff_is_textconv_ && count != 1)
            fail("one file with --textconv");
        else if (!diff_is_git_ && !diff_is_textconv_ && !diff_.against.empty() && count != 1)
            fail("one scene with --against");
        else if (!diff_is_git_ && !diff_is_textconv_ && diff_.against.empty() && count != 2)
            fail("two files");
    }

    void add_renew() {
        CLI::App& command = add_command(
            "renew", "Run the commands on Markdown pages again and put their output there",
            "rastertrace renew docs/pages.md --check\n\n"
            "In a fenced code block, a line that begins with `$ rastertrace ` is a command; what\n"
            "follows, to the next line that begins with `$ ` or to the end of the block, is its\n"
            "output. A command that has to fail says so: $ rastertrace show bad.json # exit 2");
        command
            .add_option("page", renew_.pages,
                        "Markdown files; their commands run in the current folder")
            ->required()
            ->type_name("FILE");
        command
            .add_option("-o,--output", renew_.output,
                        "Write the only page to this file, and leave it as it is")
            ->type_name("FILE");
        command.add_flag("--check", renew_.check,
                         "Write no page and no other file; tell where one is not as its commands "
                         "print it, with exit status 1");
        command.add_flag("--allow-outside", renew_.allow_outside,
                         "Let commands read and write files outside of the current folder too: "
                         "only for pages that you trust");
        command
            .add_option("--timeout", renew_time_,
                        "Seconds that a command may take, 60 if not given")
            ->type_name("SECONDS");
        command.callback([this] {
            for (const std::string& page : renew_.pages)
                if (page == "-")
                    refuse("renew", "the names of pages", page);
            if (renew_.output == "-")
                refuse("--output", "the name of a file", "-");
            if (!renew_.output.empty() && (renew_.check || renew_.pages.size() > 1))
                refuse("--output", "one page, and no --check", renew_.output);
            constexpr int most_seconds = 1'000'000;
            if (!renew_time_.empty()) {
                const auto seconds = whole_in<int>(renew_time_);
                if (seconds.value_or(0) < 1 || *seconds > most_seconds)
                    refuse("--timeout", "a number of seconds from 1 to 1000000", renew_time_);
                renew_.time = std::chrono::seconds(*seconds);
            }
            action_ = [this] { return rastertrace::run(renew_); };
        });
    }

    void add_help() {
        CLI::App& command = add_command("help", "Explain a command", "rastertrace help show");
        command.add_option("command", help_about_, "The command")->type_name("COMMAND");
        command.callback([this] {
            action_ = [this] {
                if (help_about_.empty()) {
                    print_help(app_);
                    return exit_fine;
                }
                refuse_unknown_command(help_about_);
                print_help(*app_.get_subcommand(help_about_));
                return exit_fine;
            };
        });
    }

    void print_help(const CLI::App& command) const {
        print(command.help(&command == &app_ ? "" : app_.get_name()));
    }

    /// The command that was named, or the program as a whole.
    const CLI::App& chosen() const {
        const auto commands = app_.get_subcommands();
        return commands.empty() ? app_ : *commands.front();
    }

    /// A word without a letter, of which a script made too little: no file, name or number is "".
    static void refuse_empty_words(int count, const char* const* arguments) {
        for (int i = 1; i < count; ++i) {
            const std::string_view word = arguments[i];
            if (word.empty())
                refuse(i == 1 ? "rastertrace" : arguments[i - 1], "a word behind it", word);
            if (word.starts_with("--") && word.ends_with('='))
                refuse(word.substr(0, word.size() - 1), "a value", "");
        }
    }

    void refuse_unknown_command(std::string_view word) const {
        std::vector<std::string> names;
        for (const CLI::App* command : app_.get_subcommands({}))
            names.push_back(command->get_name());
        if (word.starts_with('-') || std::find(names.begin(), names.end(), word) != names.end())
            return;
        throw problem_of(
            "",
            fmt::format("expected a command out of {}, found \"{}\"", joined(names, ", "), word),
            did_you_mean(word, {names.begin(), names.end()}));
    }

    int complain(const CLI::ParseError& error, int count, const char* const* arguments) const {
        const CLI::App& command = chosen();
        const bool is_command = &command != &app_;
        std::string message = error.what();
        std::string hint;

        // An option that does not exist: say which, and which one is near.
        std::vector<std::string> options;
        for (const CLI::Option* option : command.get_options())
            for (const std::string& name : option->get_lnames())
                options.push_back("--" + name);
        for (const CLI::App* group : command.get_subcommands({}))
            for (const CLI::Option* option : group->get_options())
                for (const std::string& name : option->get_lnames())
                    options.push_back("--" + name);
        for (int i = 1; i < count; ++i) {
            const std::string word = split_at(arguments[i], '=').front();
            if (!word.starts_with("--") || word == "--" ||
                std::find(options.begin(), options.end(), word) != options.end())
                continue;
            message = fmt::format("{}: no such option", word);
            hint = did_you_mean(word, {options.begin(), options.end()});
            break;
        }
        const auto is_condition = [](std::string_view word) {
            return !word.starts_with('-') && word.find('=') != std::string_view::npos;
        };
        if (hint.empty() &&
            error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError) &&
            std::any_of(arguments + 1, arguments + count, is_condition))
            hint = R"(a step of several words goes in quotes: "scanline y=2")";
        const std::string name =
            is_command ? "rastertrace " + command.get_name() : std::string("rastertrace");
        print_error(fmt::format("{}: {}\n{}see {} --help\n", name, printable(message),
                                hint.empty() ? "" : fmt::format("hint: {}\n", printable(hint)),
                                name));
        return exit_bad_input;
    }

    CLI::App app_{"A rasterizer you can watch think", "rastertrace"};
    std::function<int()> action_;

    TraceCommand trace_;
    std::string format_;
    std::string only_;
    std::string region_;
    MethodOptions trace_method_;
    std::string language_; ///< of show, play, figure, explain, check, diff
    InputOptions trace_input_;
    FrameOptions trace_frames_;

    FigureCommand figure_;
    std::string figure_step_;
    std::string figure_until_;
    std::string figure_every_;
    std::string figure_format_;
    std::string figure_with_;
    std::string figure_without_;
    std::string figure_view_;
    std::string figure_region_;
    std::string figure_palette_;
    std::string figure_theme_;
    std::string figure_sheet_;
    std::string figure_cell_;
    std::string figure_scale_;
    std::string figure_width_;
    std::string figure_seconds_;
    MethodOptions figure_method_;
    InputOptions figure_input_;
    FrameOptions figure_frames_;

    PlayCommand play_;
    bool lists_keys_ = false;
    std::string screen_size_;
    std::string memory_;
    MethodOptions play_method_;
    InputOptions play_input_;
    FrameOptions play_frames_;

    ShowCommand show_;
    std::string step_;
    std::string view_;
    std::string show_region_;
    std::string color_;
    std::string table_format_;
    bool is_json_table_ = false;
    std::string every_;
    bool last_ = false;
    bool all_ = false;
    MethodOptions show_method_;
    InputOptions show_input_;
    FrameOptions show_frames_;

    DiffCommand diff_;
    CLI::Option* diff_traces_ = nullptr;
    std::vector<std::string> git_words_; ///< files, from the end of the command line
    std::vector<std::string> diff_tolerances_;
    std::string diff_ignored_;
    std::string diff_only_;
    bool diff_is_git_ = false;
    bool diff_is_textconv_ = false;
    std::string diff_format_;
    MethodOptions diff_method_;
    InputOptions diff_input_;
    FrameOptions diff_frames_;
    ExplainCommand explain_;
    std::string explain_pixel_;
    std::string explain_row_;
    std::map<std::string, std::string> explain_texts_; ///< --face, --vertex, ...
    std::string explain_format_;
    MethodOptions explain_method_;
    InputOptions explain_input_;
    FrameOptions explain_frames_;

    StatsCommand stats_;
    std::string fail_on_;
    MethodOptions stats_method_;
    InputOptions stats_input_;
    FrameOptions stats_frames_;

    CheckCommand check_;
    std::string check_format_;
    bool is_json_check_ = false;
    bool has_no_answers_ = false;
    MethodOptions check_method_;
    InputOptions check_input_;
    FrameOptions check_frames_;

    ValidateCommand validate_;
    std::string validate_kind_;
    std::string validate_schema_;
    std::string validate_format_;
    bool is_json_validation_ = false;
    InputOptions validate_input_;

    PlanCommand plan_;
    MethodOptions plan_method_;
    InputOptions plan_input_;
    FrameOptions plan_frames_;

    StressCommand stress_;
    std::string stress_number_;
    CLI::Option* stress_scene_ = nullptr;
    MethodOptions stress_method_;
    InputOptions stress_input_;
    FrameOptions stress_frames_;
    ReportCommand report_;
    std::string report_format_;
    std::string report_jobs_text_;
    MethodOptions report_method_;
    InputOptions report_input_;
    FrameOptions report_frames_;

    RenewCommand renew_;
    std::string renew_time_;

    std::string help_about_;
};

} // namespace

int run_command_line(int count, const char* const* arguments) noexcept {
    try {
        try {
            Program program;
            return program.run(count, arguments);
        } catch (const Problem& problem) {
            print_error(fmt::format("rastertrace: {}\n", to_text(problem)));
            return problem.cause == Problem::Cause::system ? exit_system : exit_bad_input;
        }
    } catch (const std::exception& failure) {
        // What the C++ library cannot do; no input should lead here.
        print_error("rastertrace: ");
        print_error(failure.what());
        print_error("\n");
        return exit_system;
    }
}

} // namespace rastertrace
