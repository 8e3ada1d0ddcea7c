// SPDX-License-Identifier: MIT
// `rastertrace diff FOLDER FOLDER`: each file with the one of its name in the other folder.

#include "app/load.h"
#include "commands/diff_command.h"
#include "commands/diff_report.h"

#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <system_error>

namespace rastertrace {

namespace {

/// How names of traces, scenes and pictures end.
constexpr std::array<std::string_view, 7> endings{".json", ".jsonl", ".png", ".ppm",
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
            if (std::ranges::any_of(endings, [&](auto end) { return name.ends_with(end); }))
                files[name][i] = true;
    if (std::ranges::find(files, in_both, &FilesOfBoth::value_type::second) == files.end())
        throw problem_of("", "diff: nothing to compare: the folders have no file of one name",
                         fmt::format("compared are files that end in {}", joined(endings, ", ")));
    return files;
}

/// The lines of a text, each with blanks in front.
std::string indented(const std::string& text) {
    std::string lines;
    for (const std::string& line : split_at(text.substr(0, text.find_last_not_of('\n') + 1), '\n'))
        lines += line.empty() ? "\n" : "    " + line + "\n";
    return lines;
}

} // namespace

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

} // namespace rastertrace
