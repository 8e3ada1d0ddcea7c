// SPDX-License-Identifier: MIT
#include "language.h"

#include "json_document.h"
#include "named_value.h"

#include <array>
#include <atomic>
#include <functional>
#include <map>
#include <string>

namespace rastertrace {

std::string
pt_json(); // languages/pt.json, as the build has put it into the program (cmake/embed.cmake)

namespace {

constexpr std::array<std::string_view, language_count> codes{"en", "pt"};

std::atomic<Language> language_in_use{Language::english};

/// The rows of a catalogue, by the English words.
using Catalogue = std::map<std::string, std::string, std::less<>>;

const Catalogue& catalogue() {
    static const Catalogue rows = [] {
        const Source source{.name = "pt.json", .text = pt_json()};
        const auto document = parse_json(source);
        Catalogue read;
        for (const auto& [key, value] : document.value().root().members())
            read.emplace(key.text, value.text);
        return read;
    }();
    return rows;
}

} // namespace

std::vector<std::string_view> language_codes() {
    return {codes.begin(), codes.end()};
}

std::string_view code_of(Language language) {
    return codes[static_cast<std::size_t>(language)];
}

std::optional<Language> language_with_code(std::string_view code) {
    return value_named<Language>(codes, code);
}

Language language_of_steps() {
    return language_in_use;
}

void tell_steps_in(Language language) {
    language_in_use = language;
}

std::string_view Words::in(Language language) const {
    if (language != Language::english)
        if (const auto found = catalogue().find(english_); found != catalogue().end())
            return found->second;
    return english_.substr(0, english_.find("##"));
}

std::string_view in_language_of_steps(std::string_view word) {
    if (word == "behind the eye") // or beside it: w = 0
        return Words("not in front of the eye").in(language_of_steps());
    if (language_of_steps() == Language::english)
        return word;
    const auto found = catalogue().find(std::string(word) + "##trace");
    return found == catalogue().end() ? word : std::string_view(found->second);
}

} // namespace rastertrace
