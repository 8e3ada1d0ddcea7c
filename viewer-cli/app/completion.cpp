// SPDX-License-Identifier: MIT
#include "app/completion.h"

#include "app/load.h"

#include <rastertrace/core/draw/model/mistakes.h>
#include <rastertrace/trace/explain/explain.h>
#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <utility>

namespace rastertrace {

namespace {

constexpr std::string_view files = ":files";

bool is_of_files(const std::vector<std::string>& names) {
    return names.size() == 1 && names.front() == files;
}

/// A file that is larger is not drawn for a word.
constexpr std::uintmax_t most_bytes_read = 1'000'000;

/// The names in the first of the words that is the file of a scene or trace; none if no word is one.
std::vector<std::string> names_in_file(NamesOf what, std::span<const std::string> words) {
    constexpr std::array<std::pair<NamesOf, Topic>, 4> topics{{{NamesOf::faces, Topic::face},
                                                               {NamesOf::vertices, Topic::vertex},
                                                               {NamesOf::edges, Topic::edge},
                                                               {NamesOf::triangles, Topic::pair}}};
    for (const std::string& word : words) {
        std::error_code error;
        if (!std::filesystem::is_regular_file(word, error) ||
            std::filesystem::file_size(word, error) > most_bytes_read)
            continue;
        try {
            for (const auto& [names, topic] : topics)
                if (names == what)
                    return names_to_ask(load_trace(word), topic);
            std::vector<std::string> names;
            for (const ScenePrimitive& primitive : load_scene(word).scene.primitives)
                names.push_back(primitive.name);
            return names;
        } catch (const Problem&) {
            continue; // nothing that can be read
        }
    }
    return {};
}

/// `rounding=`, and behind it the values of rounding.
std::vector<std::string> choices_of_method(std::string_view word) {
    std::vector<std::string> choices;
    const std::size_t equals = word.find('=');
    for (const MethodKey& key : method_keys())
        if (equals == std::string_view::npos)
            choices.push_back(fmt::format("{}=", key.name));
        else if (word.substr(0, equals) == key.name)
            for (const std::string_view value : key.values)
                choices.push_back(fmt::format("{}={}", key.name, value));
    return choices;
}

bool is_list(const OptionRow& row) {
    return row.type.find(',') != std::string::npos || row.type == "KINDS" || row.type == "METHOD";
}

/// The names that an option takes; of a list, the one that the word ends with.
std::vector<std::string> names_for(const OptionRow& row, std::string_view word,
                                   std::span<const std::string> before) {
    if (!row.values.empty())
        return row.values;
    if (row.names_of == NamesOf::mistakes) {
        std::vector<std::string> names;
        for (const Mistake& mistake : mistakes())
            names.emplace_back(mistake.name);
        return names;
    }
    if (row.names_of != NamesOf::nothing)
        return names_in_file(row.names_of, before);
    if (row.type == "METHOD")
        return choices_of_method(word);
    if (row.type == "STEP" || row.type == "KINDS") {
        const auto kinds = step_kind_names();
        std::vector<std::string> names(kinds.begin(), kinds.end());
        if (row.type == "STEP")
            names.insert(names.end(), {"first", "last"});
        return names;
    }
    for (const std::string_view of_files : {"FILE", "FOLDER", "SCENE", "TRACE", "CLAIMS"})
        if (row.type.find(of_files) != std::string::npos)
            return {std::string(files)};
    return {};
}

/// Those that begin with the word, with what stands before it in a list.
std::vector<std::string> beginning_with(std::string_view word, std::string_view list_before,
                                        std::vector<std::string> names) {
    if (is_of_files(names))
        return names;
    std::erase_if(names, [word](const std::string& name) { return !name.starts_with(word); });
    for (std::string& name : names)
        name.insert(0, list_before);
    return names;
}

std::vector<std::string> completed_value(const OptionRow& row, std::string_view word,
                                         std::span<const std::string> before) {
    const std::size_t begin = is_list(row) ? word.rfind(',') + 1 : 0; // npos + 1 is 0
    const std::string_view list_before = word.substr(0, begin);
    auto names =
        beginning_with(word.substr(begin), list_before, names_for(row, word.substr(begin), before));
    std::erase_if(names, [list_before](const std::string& name) {
        const auto given = split_at(list_before, ',');
        return std::find(given.begin(), given.end(), name.substr(list_before.size())) !=
               given.end();
    });
    return names;
}

/// The option of this name that takes a value; nullptr if there is none.
const OptionRow* option_with_value(const CommandTable& command, const std::string& name) {
    for (const OptionRow& row : command.options) {
        const auto all = row.all_names();
        if (!row.is_argument() && !row.type.empty() &&
            std::find(all.begin(), all.end(), name) != all.end())
            return &row;
    }
    return nullptr;
}

/// All names of options that begin with the word; the values of `--fill=`.
std::vector<std::string> completed_option(const CommandTable& command, const std::string& word,
                                          std::span<const std::string> before) {
    if (const std::size_t equals = word.find('='); equals != std::string::npos) {
        const OptionRow* const row = option_with_value(command, word.substr(0, equals));
        auto values = row == nullptr ? std::vector<std::string>()
                                     : completed_value(*row, word.substr(equals + 1), before);
        if (is_of_files(values))
            return {};
        for (std::string& value : values)
            value.insert(0, word.substr(0, equals + 1));
        return values;
    }
    std::vector<std::string> names{"-h", "--help"};
    for (const OptionRow& row : command.options)
        if (!row.is_argument())
            for (std::string& name : row.all_names())
                names.push_back(std::move(name));
    return beginning_with(word, "", std::move(names));
}

} // namespace

namespace {

/// What the last word can become, with what it already has.
std::vector<std::string> completed_word(std::span<const std::string> words,
                                        const std::vector<CommandGroup>& groups) {
    const std::string& word = words.back();
    const auto before = words.first(words.size() - 1);
    std::vector<std::string> names;
    for (const CommandGroup& group : groups)
        for (const CommandTable* command : group.commands)
            names.push_back(command->about.name);
    if (before.empty()) {
        if (word.starts_with('-'))
            names = {"-h", "--help", "-V", "--version"};
        names = beginning_with(word, "", std::move(names));
        return names.empty() ? std::vector{std::string(files)} : names;
    }
    const bool is_command = std::find(names.begin(), names.end(), before.front()) != names.end();
    std::error_code error;
    if (!is_command && !std::filesystem::is_regular_file(before.front(), error))
        return {};
    // A file without a command is shown.
    const CommandTable& command = table_of(is_command ? before.front() : "show", groups);
    if (word.starts_with('-'))
        return completed_option(command, word, before);
    if (const OptionRow* const row = option_with_value(command, before.back()))
        return completed_value(*row, word, before);
    for (const OptionRow& row : command.options)
        if (row.is_argument()) {
            if (row.type != "COMMAND")
                return completed_value(row, word, before);
            names.emplace_back("conventions"); // `help` explains them too
            return beginning_with(word, "", std::move(names));
        }
    return {};
}

/// bash takes `--fill=two` for three words.
std::vector<std::string> joined_at_equals(std::span<const std::string> words) {
    std::vector<std::string> joined;
    bool is_behind_equals = false;
    for (const std::string& word : words) {
        if (!joined.empty() && (word == "=" || is_behind_equals))
            joined.back() += word;
        else
            joined.push_back(word);
        is_behind_equals = word == "=";
    }
    return joined;
}

} // namespace

std::vector<std::string> completions(std::span<const std::string> words,
                                     const std::vector<CommandGroup>& groups) {
    if (words.empty())
        return {};
    const std::vector<std::string> joined = joined_at_equals(words);
    std::vector<std::string> names = completed_word(joined, groups);
    if (joined.size() < words.size() && !is_of_files(names)) {
        const std::size_t typed = words.back() == "=" ? 0 : words.back().size();
        for (std::string& name : names)
            name.erase(0, joined.back().size() - typed);
    }
    return names;
}

namespace {

constexpr std::string_view bash_script = R"(# bash completion for rastertrace
_rastertrace() {
    local IFS=$'\n' found
    found=$(rastertrace help -- "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
    if [ "$found" = :files ]; then
        COMPREPLY=($(compgen -f -- "${COMP_WORDS[COMP_CWORD]}"))
        compopt -o filenames
    else
        COMPREPLY=($found)
    fi
}
complete -F _rastertrace rastertrace
)";

constexpr std::string_view zsh_script = R"(#compdef rastertrace
_rastertrace() {
    local -a found
    found=("${(@f)$(rastertrace help -- "${(@)words[2,CURRENT]}" 2>/dev/null)}")
    if [[ "$found" == :files ]]; then
        _files
    else
        compadd -Q -- $found
    fi
}
if [ "$funcstack[1]" = _rastertrace ]; then
    _rastertrace "$@"
else
    compdef _rastertrace rastertrace
fi
)";

constexpr std::string_view fish_script = R"(# fish completion for rastertrace
function __rastertrace_complete
    set -l words (commandline -opc)
    set -l found (rastertrace help -- $words[2..-1] (commandline -ct) 2>/dev/null)
    if test "$found" = :files
        __fish_complete_path (commandline -ct)
    else
        printf '%s\n' $found
    end
end
complete -c rastertrace -f -a '(__rastertrace_complete)'
)";

constexpr std::array<std::pair<std::string_view, std::string_view>, 3> scripts{
    {{"bash", bash_script}, {"zsh", zsh_script}, {"fish", fish_script}}};

} // namespace

std::vector<std::string_view> completed_shells() {
    std::vector<std::string_view> names;
    for (const auto& [name, script] : scripts)
        names.push_back(name);
    return names;
}

std::string_view completion_script(std::string_view shell) {
    return std::find_if(scripts.begin(), scripts.end(),
                        [shell](const auto& one) { return one.first == shell; })
        ->second;
}

} // namespace rastertrace
