// SPDX-License-Identifier: MIT
#pragma once

// The languages in which steps are told: their sentences (describe.h) and workings (working.h), what explain.h answers
// about them, what is found about claims (check.h), how two traces differ (diff.h), what stands around a frame and all
// that the player says. Messages, help and the words of the file formats are English in all of them.
//
//     tell_steps_in(Language::portuguese);
//     describe_step(replay);  // "aresta BC: horizontal, não tem dx/dy"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace rastertrace {

enum class Language : std::uint8_t { english, portuguese };

inline constexpr std::size_t language_count = 2;

/// English words that the catalogue of each other language has a row for (languages/pt.json). Behind ## stands which of
/// several meanings they have, which nobody is told: `right##verdict`. What has no row is told as it is.
class Words {
public:
    constexpr Words(std::string_view english) : english_(english) {} // NOLINT: words are a text
    constexpr Words(const char* english) : english_(english) {}      // NOLINT

    std::string_view in(Language language) const;

private:
    std::string_view english_;
};

/// The codes of ISO 639: en, pt.
std::vector<std::string_view> language_codes();
std::string_view code_of(Language language);
std::optional<Language> language_with_code(std::string_view code);

/// The language that this process tells steps in, English if none was set. Like setlocale(3), it is set once, before
/// anything is told.
Language language_of_steps();
void tell_steps_in(Language language);

/// A word that a trace holds, like `camera`, `culled` or `near`, or a reason of explain.h, in the language of steps; any
/// other text stays as it is.
std::string_view in_language_of_steps(std::string_view word);

} // namespace rastertrace
