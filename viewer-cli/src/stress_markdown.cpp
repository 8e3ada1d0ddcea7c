// SPDX-License-Identifier: MIT
#include "stress_markdown.h"

#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/numerics/stress.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string_view>

namespace rastertrace {

namespace {

/// Text in a line of a page, as it is: what stands between backquotes is code already.
std::string in_page(std::string_view text) {
    std::string line;
    bool is_code = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const char next = i + 1 < text.size() ? text[i + 1] : ' ';
        if (c == '`')
            is_code = !is_code;
        if (is_code)
            line += c;
        else if (c == '<')
            line += "&lt;"; // not every reader knows a backslash before it
        else if (c == '&')
            line += "&amp;";
        else if (c == '*' || c == '_' || c == '\\' || (c == ']' && (next == '(' || next == '[')))
            line += {'\\', c};
        else
            line += c;
    }
    return line;
}

/// The same where a line or an item of a list begins: it begins no item of a list, and no heading.
std::string in_item(std::string_view text) {
    std::string item = in_page(text);
    const std::size_t mark = std::min(item.find_first_not_of("0123456789"), item.size() - 1);
    const bool is_ordinal = mark > 0 && (item[mark] == '.' || item[mark] == ')') &&
                            (mark + 1 == item.size() || item[mark + 1] == ' ');
    if (is_ordinal || (mark == 0 && std::string_view("+-#>").find(item[0]) != std::string::npos))
        item.insert(mark, 1, '\\');
    return item;
}

/// True if a text begins with a word, not with a formula: "a sliver", "floor: 49", but not "n = 3".
bool begins_with_word(std::string_view text) {
    const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
    const auto end = static_cast<std::size_t>(
        std::find_if_not(text.begin(), text.end(), is_letter) - text.begin());
    const std::string_view rest = text.substr(end);
    if (rest.size() < 2)
        return end > 1;
    if (end == 1)
        return text[0] == 'a' && rest[0] == ' ' && is_letter(rest[1]);
    return end > 1 && (rest[0] == ' ' || rest[0] == ',' || rest[0] == ':') &&
           std::string_view("=.").find(rest[1]) == std::string_view::npos;
}

/// A text as a sentence of a page.
std::string as_sentence(std::string_view text) {
    std::string sentence(text);
    if (begins_with_word(text))
        sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    if (!sentence.ends_with('.') && !sentence.ends_with(".)"))
        sentence += '.';
    return in_item(sentence);
}

/// The heading of a case, and the anchor that it has on GitHub.
std::string heading_of(const StressCase& about) {
    return fmt::format("{}: {}", about.id, about.title);
}
std::string anchor_of(const StressCase& about) {
    std::string anchor;
    for (const char c : heading_of(about))
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_')
            anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (c == ' ')
            anchor += '-';
    return anchor;
}

/// What is wrong or refused of one method.
struct Failing {
    std::string_view method;
    std::string what;    ///< "590 rows wrong, at most 0.024 px"
    std::string scalars; ///< with which it is so
    std::size_t scalar_count;
};

/// What a case has wrong or refused: an item for each method; nothing if all is right.
std::string failing_items(const RunCase& one) {
    if (one.count(Verdict::refused) == one.rows.size())
        return "\nAll of it is refused, with every scalar.\n";
    std::vector<Failing> all;
    for (const StressRow& row : one.rows) {
        if (verdict_of(row) != Verdict::wrong && verdict_of(row) != Verdict::refused)
            continue;
        const std::string what =
            verdict_of(row) == Verdict::refused ? "refused" : described_error(row);
        const auto same = std::find_if(all.begin(), all.end(), [&](const Failing& other) {
            return other.method == row.method && other.what == what;
        });
        if (same == all.end()) {
            all.push_back({row.method, what, row.scalar, 1});
        } else {
            same->scalars += ", " + row.scalar;
            ++same->scalar_count;
        }
    }
    std::string items;
    std::string_view method;
    for (const Failing& failing : all) {
        items += failing.method != method ? fmt::format("\n- {}: ", in_item(failing.method)) : "; ";
        method = failing.method;
        const bool is_every = failing.scalar_count == find_method_key("scalar")->values.size();
        items += fmt::format("{} ({})", in_page(failing.what),
                             is_every ? "every scalar" : in_page(failing.scalars));
    }
    return items.empty() ? items : items + '\n';
}

std::string as_markdown(const RunCase& one) {
    const StressCase& about = *one.about;
    return fmt::format("\n### {}\n\n{}{}\n\n{}\n{}", in_page(heading_of(about)),
                       as_sentence(about.input), about.scenes().empty() ? " No scene." : "",
                       as_sentence(about.holds), failing_items(one));
}

} // namespace

std::string as_markdown(const std::vector<RunCase>& cases) {
    std::string text = counted(cases.size(), "case") + ".\n";
    std::string_view family;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (family_of(*cases[i].about) != family) {
            family = family_of(*cases[i].about);
            std::string title(family);
            title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
            text += fmt::format("\n## {}\n\n", title);
            for (std::size_t k = i; k < cases.size() && family_of(*cases[k].about) == family; ++k)
                text += fmt::format("{}[{}](#{})", k == i ? "" : ", ", cases[k].about->id,
                                    anchor_of(*cases[k].about));
            text += '\n';
        }
        text += as_markdown(cases[i]);
    }
    return text;
}

} // namespace rastertrace
