// SPDX-License-Identifier: MIT
// `rastertrace diff`: what two traces do differently.

#include "commands.h"
#include "diff_json.h"
#include "load.h"

#include <rastertrace/trace/describe.h>
#include <rastertrace/trace/diff.h>
#include <rastertrace/trace/frame.h>
#include <rastertrace/trace/text.h>

#include <fmt/core.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>

namespace rastertrace {

namespace {

/// What git gives instead of a file that is not there.
constexpr std::string_view no_file = "/dev/null";

SceneOptions options_of(const DiffCommand& command) {
    return {.method = command.method, .limits = command.input, .frames = command.frames};
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
    const TraceText text_a = trace_text(std::move(a), path_a, options);
    const TraceText text_b = trace_text(std::move(b), path_b, options);
    return diff(text_a, text_b, command.options);
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
    found.name_b += " with " + command.against;
    return found;
}

ExitStatus tell(const DiffCommand& command, const TraceDiff& found) {
    print(command.json ? diff_json(found) : diff_text(found));
    for (const Problem& problem : found.damage)
        print_error(fmt::format("rastertrace: {}\n", to_text(problem)));
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
    if (!command.json)
        print(fmt::format("rastertrace diff {}{}\n", printable(name),
                          is_renamed ? ", now " + printable(new_name) : ""));
    if (words.size() == 1) {
        print("not merged\n");
        return exit_fine;
    }
    const std::string old_file = path_of_git(words[1]);
    const std::string new_file = path_of_git(words[4]);
    if (old_file == no_file || new_file == no_file) {
        print(old_file == no_file ? "a new file\n" : "a file that is no longer there\n");
        return exit_fine;
    }
    try {
        TraceDiff found = diff_of_files(old_file, new_file, command);
        found.name_a = name + ", before";
        found.name_b = new_name + ", now";
        tell(command, found);
    } catch (const Problem& problem) {
        print(fmt::format("cannot be compared: {}\n", to_text(problem)));
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
            text += printable(trace.step(primitive).text("name")) + ": ";
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
        print(fmt::format("cannot be read: {}\n", to_text(problem)));
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
    return tell(command, command.against.empty()
                             ? diff_of_files(command.files[0], command.files[1], command)
                             : diff_of_methods(command));
}

} // namespace rastertrace
