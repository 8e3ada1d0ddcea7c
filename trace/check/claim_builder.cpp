// SPDX-License-Identifier: MIT
#include "claim_builder.h"

#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace rastertrace {

namespace {

/// The words for true and false that only a table of claims has; of those that mean the same, the first is said.
constexpr auto words_of_table =
    std::to_array<VerdictWord>({{"on", "plotted", "true", "on"},
                                {"drawn", "plotted", "true"},
                                {"plotted", "plotted", "true"},
                                {"filled", "plotted", "true"},
                                {"black", "plotted", "true"},
                                {"yes", "plotted", "true"},
                                {"set", "plotted", "true"},
                                {"lit", "plotted", "true"},
                                {"painted", "plotted", "true"},
                                {"off", "plotted", "false", "off"},
                                {"empty", "plotted", "false"},
                                {"blank", "plotted", "false"},
                                {"white", "plotted", "false"},
                                {"no", "plotted", "false"},
                                {"unset", "plotted", "false"},
                                {"unlit", "plotted", "false"},
                                {"visible", "visible", "true", "visible"},
                                {"seen", "visible", "true"},
                                {"hidden", "visible", "false", "hidden"},
                                {"passes", "pass", "true", "passes"},
                                {"fails", "pass", "false", "fails"}});

/// Values that are no verdict: `none` and `one` for a step that is missing or claimed, `outside` for a pixel that a
/// primitive does not reach.
constexpr std::array words_for_no_value{Words("none"), Words("one"), Words("outside")};

/// The first word for which that holds, those of tables first; or nullptr.
template <typename Holds> const VerdictWord* find_verdict_word(const Holds& holds) {
    const auto own = std::find_if(words_of_table.begin(), words_of_table.end(), holds);
    if (own != words_of_table.end())
        return &*own;
    const auto shared = std::find_if(verdict_words.begin(), verdict_words.end(), holds);
    return shared == verdict_words.end() ? nullptr : &*shared;
}

} // namespace

const VerdictWord* find_verdict(const ClaimWord& word, std::string_view field) {
    return find_verdict_word(
        [&](const VerdictWord& known) { return known.field == field && word.is(known.word); });
}

void ClaimBuilder::read_verdict(std::string_view field, std::string_view expected) {
    const ClaimWord word = line_.next();
    if (const VerdictWord* const verdict = find_verdict(word, field))
        put_value(*verdict, word);
    else if (word.is(open_value))
        put(field, word);
    else
        line_.fail(word, expected);
}

void ClaimBuilder::begin(std::string_view step, const std::optional<ClaimWord>& primitive) {
    claim_.step = step;
    if (primitive)
        put("in", *primitive);
}

void ClaimBuilder::put_value(const VerdictWord& verdict, const ClaimWord& word) {
    put(verdict.field, {.text = std::string(verdict.value), .offset = word.offset});
}

void ClaimBuilder::put_list(std::string_view name, const std::vector<ClaimWord>& words) {
    if (words.empty())
        line_.fail(line_.peek(), fmt::format("a value for {}", name));
    const ClaimField field = field_named(name);
    ClaimedField claimed{.name = std::string(name),
                         .values = {},
                         .is_list = field.is_list,
                         .offset = words.front().offset};
    for (const ClaimWord& word : words) {
        if (word.is_mark || word.text.empty())
            line_.fail(word, fmt::format("a value for {}", name));
        // That a quantity is a number has been seen when it was read.
        const auto expected =
            field.type == FieldType::quantity ? std::nullopt : expected_instead(field, word.text);
        if (expected)
            line_.fail(word, *expected);
        claimed.values.push_back(word.text);
    }
    claimed.goes_on = claimed.is_list && line_.ends_in_dots();
    claim_.fields.push_back(std::move(claimed));
}

ClaimField ClaimBuilder::field_named(std::string_view name) const {
    ClaimField found;
    for (const ClaimField& field : claim_fields_of(*step_kind_named(claim_.step)))
        if (field.name == name && !found.is_list)
            found = field;
    return found;
}

void ClaimBuilder::read_place() {
    const auto [x, y] = point();
    put("x", x);
    put("y", y);
}

std::array<ClaimWord, 2> ClaimBuilder::point() {
    const bool has_brackets = line_.take("(");
    if (!has_brackets && !typed_value(line_.peek().text))
        line_.fail(line_.peek(), "a pixel, like (3,2)");
    ClaimWord x = line_.key();
    if (!line_.take(";") && !line_.take("|"))
        line_.expect(",", "a comma between x and y");
    ClaimWord y = line_.key();
    if (has_brackets)
        line_.expect(")", "`)` behind x and y");
    return {std::move(x), std::move(y)};
}

std::string_view word_for_value(std::string_view field, std::string_view value) {
    const VerdictWord* const known = find_verdict_word(
        [&](const VerdictWord& word) { return word.field == field && word.value == value; });
    if (known != nullptr)
        return known->told.in(language_of_steps());
    for (const Words& word : words_for_no_value)
        if (word.in(Language::english) == value)
            return word.in(language_of_steps());
    return value;
}

} // namespace rastertrace
