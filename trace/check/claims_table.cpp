// SPDX-License-Identifier: MIT
// Claims in a table, line by line.

#include "claims_table.h"

#include "claim_fields.h"
#include "claim_forms.h"
#include "claims_columns.h"

#include <rastertrace/trace/text/byte_order_mark.h>
#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/text.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

constexpr std::string_view caption = "\\caption{";

/// True of a line of Markdown or LaTeX that says how a table looks.
bool is_layout(std::string_view line) {
    constexpr std::array<std::string_view, 9> commands{"\\begin{",    "\\end{",    "\\hline",
                                                       "\\toprule",   "\\midrule", "\\bottomrule",
                                                       "\\centering", "\\label{",  "```"};
    return std::any_of(commands.begin(), commands.end(),
                       [line](std::string_view command) { return line.starts_with(command); });
}

/// Reads the lines of a table.
class TableReader {
public:
    explicit TableReader(Claims& claims) : claims_(claims) {}

    void read() {
        read_lines();
        if (commas_.is_seen) { // by a line that others may stand before
            commas_.is_decimal = true;
            claims_ = {
                .source = std::move(claims_.source), .is_table = true, .has_decimal_comma = true};
            has_round_ = false;
            table_.reset();
            is_in_unknown_table_ = false;
            turned_to_ = 0;
            read_lines();
        }
    }

private:
    void read_lines() {
        const std::string_view text = claims_.source.text;
        std::size_t begin = size_of_mark(text);
        for (std::size_t number = 1; begin < text.size() || in_picture_; ++number) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            try {
                read_line(number, std::min(begin, text.size()), end);
            } catch (Problem& problem) {
                take_problem(std::move(problem), number, begin, end);
            }
            begin = end + 1;
        }
    }

    /// A line that cannot be read is a claim that is not understood; of a picture, all of it is.
    void take_problem(Problem problem, std::size_t number, std::size_t begin, std::size_t end) {
        const std::string_view text = claims_.source.text;
        const bool is_of_picture = std::exchange(in_picture_, in_picture_ && begin < text.size());
        if (!is_of_picture)
            claims_.claims.push_back({.line = number,
                                      .offset = begin,
                                      .text = in_one_line(text.substr(begin, end - begin)),
                                      .step = {},
                                      .fields = {},
                                      .picture = {}});
        if (problem.hint.empty())
            problem.hint = table_ ? "a cell holds a number, like 25/8 or -0.25, or ? if it is open"
                                  : form_of("");
        if (std::optional<Problem>& known = claims_.claims.back().problem; !known)
            known = std::move(problem);
    }

    void read_line(std::size_t number, std::size_t begin, std::size_t end) {
        if (in_picture_)
            return read_row(begin, end);
        if (begin < turned_to_)
            return;
        const std::string_view text = claims_.source.text;
        if (table_ && table_->read_row(claims_.source, begin, end, number, commas_, claims_.claims))
            return;
        table_.reset();
        if (is_layout(without_blanks(text.substr(begin, end - begin))))
            return;
        const bool is_blank = without_blanks(text.substr(begin, end - begin)).empty();
        if (is_blank || is_in_unknown_table_) {
            is_in_unknown_table_ = is_in_unknown_table_ && !is_blank;
            return;
        }
        std::size_t last = end;
        if (ClaimColumns::turned(claims_.source, begin, last, number, commas_, claims_.claims)) {
            turned_to_ = last;
            return;
        }
        is_in_unknown_table_ = true; // unless its head is known, or there is none
        table_ = ClaimColumns::headed(claims_.source, begin, end, title_);
        is_in_unknown_table_ = false;
        title_ = title_over_table(begin, end);
        if (table_ || !title_.empty())
            return;
        ClaimLine line(claims_.source, begin, end, commas_);
        if (line.at_end())
            return;
        if (line.take("scene", ":"))
            return read_scene(line);
        if (line.take("round", ":"))
            return read_round(line);
        Claim claim{.line = number,
                    .offset = line.peek().offset,
                    .text = in_one_line(line.text()),
                    .step = {},
                    .fields = {},
                    .picture = {}};
        if (line.take("picture", ":")) {
            line.expect_end();
            claim.step = "picture";
            in_picture_ = true;
        } else {
            for (Claim& one : read_claim(line, std::move(claim)))
                claims_.claims.push_back(std::move(one));
            return;
        }
        claims_.claims.push_back(std::move(claim));
    }

    /// The name that stands alone in the line over a table, as a heading or the caption of LaTeX; "" if there is none.
    std::string title_over_table(std::size_t begin, std::size_t end) const {
        const std::string_view text = claims_.source.text;
        std::string_view name = without_blanks(text.substr(begin, end - begin));
        name.remove_prefix(std::min(name.find_first_not_of("# "), name.size()));
        if (name.starts_with(caption) && name.ends_with('}'))
            name = name.substr(caption.size(), name.size() - caption.size() - 1);
        if (name.ends_with(':'))
            name.remove_suffix(1);
        const std::string title = plain_text(name);
        if (!is_one_word(title))
            return "";
        for (std::size_t next = end + 1; next < text.size();) {
            const std::size_t behind = std::min(text.find('\n', next), text.size());
            const std::string_view line = without_blanks(text.substr(next, behind - next));
            if (!line.empty() && !is_layout(line))
                return ClaimColumns::headed(claims_.source, next, behind, "") ? title : "";
            next = behind + 1;
        }
        return "";
    }

    /// A row of a picture; a blank line ends it.
    void read_row(std::size_t begin, std::size_t end) {
        std::vector<std::string>& rows = claims_.claims.back().picture;
        const std::string_view text = claims_.source.text;
        const std::string_view row = without_blanks(text.substr(begin, end - begin));
        const auto fail = [&](std::string message, std::string hint) {
            throw problem_at(claims_.source, static_cast<std::size_t>(row.data() - text.data()),
                             std::move(message), std::move(hint));
        };
        in_picture_ = !row.empty();
        if (!in_picture_ && rows.empty())
            fail("expected the rows of a picture, found none", "");
        if (!in_picture_)
            return;
        rows.emplace_back(row);
        if (const auto fault = fault_in_last_row(rows))
            fail(*fault, "a picture ends with a blank line");
    }

    void read_scene(ClaimLine& line) {
        if (!claims_.scene.empty())
            line.fail_at_begin("expected one line `scene:`, found another");
        claims_.scene_offset = line.peek().offset;
        claims_.scene = line.rest();
        if (claims_.scene.empty())
            line.fail(line.peek(), "the name of a scene file");
    }

    void read_round(ClaimLine& line) {
        if (has_round_)
            line.fail_at_begin("expected one line `round:`, found another");
        has_round_ = true;
        const ClaimWord word = line.next();
        if (!word.is("nearest") && !word.is("truncate"))
            line.fail(word, "nearest or truncate",
                      did_you_mean(word.text, {"nearest", "truncate"}));
        claims_.only_rounds = word.is("nearest");
        line.expect_end();
    }

    Claims& claims_;
    CommaUse commas_;
    std::optional<ClaimColumns> table_; ///< that the last line belongs to
    std::string title_;                 ///< of the table that begins in the next line
    bool is_in_unknown_table_ = false;  ///< its head was refused: to a blank line, nothing is read
    std::size_t turned_to_ = 0;         ///< the end of a table that lies on its side
    bool in_picture_ = false;
    bool has_round_ = false;
};

} // namespace

void read_claims_table(Claims& claims) {
    TableReader(claims).read();
}

std::string name_in_table(std::string_view name) {
    const auto words = first_words();
    const bool is_read_otherwise = !english_word(name).empty() || name.ends_with('\'') ||
                                   name.starts_with("n_") || name.starts_with("m_");
    const bool is_plain = is_one_word(name) && name != open_value && name != "color" &&
                          !is_read_otherwise &&
                          std::find(words.begin(), words.end(), name) == words.end() &&
                          json_quoted(name).size() == name.size() + 2; // nothing escaped
    return is_plain ? std::string(name) : json_quoted(name);
}

} // namespace rastertrace
