// SPDX-License-Identifier: MIT
#pragma once

// What tests of what is told in Portuguese have in common.
//
//     const TellingIn portuguese(Language::portuguese);
//     split("linha y=2: -1 a 3").words;  // "linha"

#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/text.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <string_view>

namespace rastertrace {

/// Tells steps in a language as long as it lives.
class TellingIn {
public:
    explicit TellingIn(Language language) { tell_steps_in(language); }
    ~TellingIn() { tell_steps_in(Language::english); }
    TellingIn(const TellingIn&) = delete;
    TellingIn& operator=(const TellingIn&) = delete;
};

/// The words of a text, and its digits. A word has two letters at least, the first of them small, and nothing but
/// letters: names of vertices are capitals, and names of faces and colors have digits or dots in them.
struct Split {
    std::set<std::string> words;
    std::string digits;
};
inline Split split(const std::string& text) {
    Split found;
    for (std::string word : split_at(text, ' ')) {
        for (const char byte : word)
            if (std::isdigit(static_cast<unsigned char>(byte)) != 0)
                found.digits += byte;
        while (!word.empty() &&
               std::string_view("(),:;|").find(word.back()) != std::string_view::npos)
            word.pop_back();
        word.erase(0, std::min(word.find_first_not_of('('), word.size()));
        const auto is_letter = [](char byte) {
            return std::isalpha(static_cast<unsigned char>(byte)) != 0;
        };
        if (word.size() >= 2 && std::all_of(word.begin(), word.end(), is_letter) &&
            std::islower(static_cast<unsigned char>(word.front())) != 0)
            found.words.insert(word);
    }
    return found;
}

/// Words of English sentences that are neither Portuguese nor words of traces.
inline const std::set<std::string> english_words{
    "about", "above", "along",   "and",    "any",   "are",  "at",    "below",  "beyond",
    "both",  "but",   "by",      "corner", "cover", "does", "drawn", "end",    "from",
    "goes",  "has",   "have",    "hides",  "is",    "it",   "its",   "leaves", "lies",
    "line",  "more",  "neither", "not",    "of",    "off",  "on",    "row",    "rows",
    "seen",  "steps", "that",    "the",    "there", "they", "to",    "told",   "trace",
    "was",   "what",  "where",   "which",  "why",   "with"};

} // namespace rastertrace
