// SPDX-License-Identifier: MIT
#include "completion.h"

#include "load.h"

#include <rastertrace/core/draw/model/mistakes.h>
#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

namespace rastertrace {

namespace {

constexpr std::string_view files = ":files";

/// The names in the first of the words that is the file of a scene; none if no word is one.
std::vector<std::string> names_in_file(NamesOf what, std::span<const std::string> words) {
    std::vector<std::string> names;
    for (const std::string& word : words) {
        std::error_code error;
        if (!std::filesystem::is_regular_file(word, error))
            continue;
        try {
            const Scene scene = InputFrames(word, {}).scene(1).scene;
            if (what == NamesOf::vertices)
                for (const auto& vertex : scene.vertices)
                    names.push_back(vertex.name);
            else
                for (const ScenePrimitive& primitive : scene.primitives)
                    names.push_back(primitive.name);
        } catch (const Problem&) {
            continue; // a trace, or nothing that can be read
        }
        break;
    }
    return names;
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
    return row.type.find(",...") != std::string::npos || row.type == "KINDS" ||
           row.type == "METHOD";
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
    if (names == std::vector<std::string>{std::string(files)})
        return names;
    std::erase_if(names, [word](const std::string& name) { return !name.starts_with(word); });
    for (std::string& name : names)
        name.insert(0, list_before);
    return names;
}

std::vector<std::string> completed_value(const OptionRow& row, std::string_view word,
                                         std::span<const std::string> before) {
    const std::size_t comma = is_list(row) ? word.rfind(',') : std::string_view::npos;
    const std::size_t begin = comma == std::string_view::npos ? 0 : comma + 1;
    return beginning_with(word.substr(begin), word.substr(0, begin),
                          names_for(row, word.substr(begin), before));
}

/// All names of options that begin with the word.
std::vector<std::string> completed_option(const CommandTable& command, std::string_view word) {
    std::vector<std::string> names{"-h", "--help"};
    for (const OptionRow& row : command.options)
        if (!row.is_argument())
            for (std::string& name : row.all_names())
                names.push_back(std::move(name));
    return beginning_with(word, "", std::move(names));
}

} // namespace

std::vector<std::string> completions(std::span<const std::string> words,
                                     const std::vector<CommandGroup>& groups) {
    if (words.empty())
        return {};
    const std::string& word = words.back();
    const auto before = words.first(words.size() - 1);
    std::vector<std::string> names;
    const CommandTable* command = nullptr;
    for (const CommandGroup& group : groups)
        for (const CommandTable* one : group.commands) {
            names.push_back(one->about.name);
            if (!before.empty() && before.front() == one->about.name)
                command = one;
        }
    if (before.empty()) {
        names = beginning_with(word, "", std::move(names));
        return names.empty() ? std::vector{std::string(files)} : names; // a file is shown
    }
    if (command == nullptr)
        return {};
    if (word.starts_with('-'))
        return completed_option(*command, word);
    const OptionRow* argument = nullptr;
    for (const OptionRow& row : command->options) {
        const auto all = row.all_names();
        if (row.is_argument())
            argument = argument == nullptr ? &row : argument;
        else if (!row.type.empty() && std::find(all.begin(), all.end(), before.back()) != all.end())
            return completed_value(row, word, before);
    }
    if (argument == nullptr)
        return {};
    return argument->type == "COMMAND" ? beginning_with(word, "", std::move(names))
                                       : completed_value(*argument, word, before);
}

namespace {

constexpr std::string_view bash_script = R"(# bash completion for rastertrace
_rastertrace() {
    local IFS=$'\n' found
    found=$(rastertrace help --complete -- "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
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
    found=("${(@f)$(rastertrace help --complete -- "${(@)words[2,CURRENT]}" 2>/dev/null)}")
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
    set -l found (rastertrace help --complete -- $words[2..-1] (commandline -ct) 2>/dev/null)
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
