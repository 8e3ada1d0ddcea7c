// SPDX-License-Identifier: MIT
#include "claims_columns.h"

#include "claim_forms.h"

#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace rastertrace {

namespace {

/// A word over a column, without blanks and marks, and the field of a step that stands in the column.
struct Head {
    std::string_view word;
    std::string_view field;
};
constexpr auto heads = std::to_array<Head>({
    {"y", "y"},
    {"row", "y"},
    {"scanline", "y"},
    {"left", "left"},
    {"xl", "left"},
    {"xleft", "left"},
    {"leftend", "left"},
    {"leftx", "left"},
    {"right", "right"},
    {"xr", "right"},
    {"xright", "right"},
    {"rightend", "right"},
    {"rightx", "right"},
    {"from", "from"},
    {"first", "from"},
    {"firstpixel", "from"},
    {"to", "to"},
    {"last", "to"},
    {"lastpixel", "to"},
    {"pixels", "pixels"},
    {"leftdepth", "left_depth"},
    {"zl", "left_depth"},
    {"rightdepth", "right_depth"},
    {"zr", "right_depth"},
    {"d", "d"},
    {"dk", "d"},
    {"p", "d"},
    {"pk", "d"},
    {"decision", "d"},
    {"k", ""},
    {"i", ""},
    {"step", ""},
    {"xy", "place"},
    {"xk+1yk+1", "place"},
    {"xkyk", "place"},
    {"pixel", "place"},
    {"edge", "edge"},
    {"dxdy", "dx_dy"},
    {"slope", "dx_dy"},
    {"vertex", "name"},
    {"face", "name"},
    {"triangle", "name"},
    {"space", "space"},
    {"x", "x"},
    {"z", "z"},
    {"w", "w"},
    {"normal", "normal"},
    {"view", "view"},
    {"dot", "dot"},
    {"normalview", "dot"},
    {"cosine", "cosine"},
    {"culled", "culled"},
    {"verdict", "culled"},
    {"plotted", "plotted"},
    {"drawn", "plotted"},
    {"color", "color"},
});

/// A head as it is compared: p_k, $p_k$ and P k are pk.
std::string plain_head(std::string_view typed) {
    std::string word;
    for (const char c : typed)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+')
            word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return word;
}

const Head* head_of(std::string_view typed) {
    const std::string word = plain_head(typed);
    const auto* const known = std::find_if(heads.begin(), heads.end(),
                                           [&word](const Head& head) { return head.word == word; });
    return known == heads.end() ? nullptr : known;
}

/// What parts the cells of a line; '\0' if it is no line of a table.
char separator_in(std::string_view line) {
    for (const char one : {'\t', '&', '|', ';', ','})
        if (line.find(one) != std::string_view::npos)
            return one;
    return '\0';
}

/// A line of a table that holds no row: |---|---| and \hline.
bool is_rule(std::string_view line) {
    return line.starts_with('\\') || line.find_first_not_of("|-:+ ") == std::string_view::npos;
}

/// Where a vertex is; without its space, that is found by who has the scene (check.cpp).
void add_coordinates(Claim& claim, std::vector<std::string> coordinates) {
    const bool has_space = claim.find("space") != nullptr;
    if (!has_space)
        claim.step = "decide";
    for (ClaimedField& field : claim.fields)
        if (field.name == "name" && !has_space)
            field.name = "in";
    claim.fields.push_back({.name = has_space ? "at" : "d",
                            .values = std::move(coordinates),
                            .is_list = true,
                            .offset = claim.offset});
}

} // namespace

/// Separators in brackets and in quotes part nothing. Blanks and quotes around a cell do not belong to it, but for those
/// of a name with escapes.
std::vector<ClaimColumns::Cell> ClaimColumns::cells_of(std::string_view text, std::size_t begin,
                                                       std::size_t end) const {
    if (is_latex_)
        end = begin + std::min(text.substr(begin, end - begin).find("\\\\"), end - begin);
    std::vector<Cell> cells{{begin, begin}};
    int depth = 0;
    bool is_quoted = false;
    for (std::size_t at = begin; at < end; ++at) {
        const char c = text[at];
        is_quoted = is_quoted != (c == '"');
        depth += c == '(' || c == '[' ? 1 : c == ')' || c == ']' ? -1 : 0;
        if (c == separator_ && !is_quoted && depth <= 0)
            cells.push_back({at + 1, at + 1});
        else
            cells.back().end = at + 1;
    }
    for (Cell& cell : cells) {
        std::string_view typed = without_blanks(text.substr(cell.begin, cell.end - cell.begin));
        const bool has_escapes = typed.find("\\u") != std::string_view::npos;
        if (typed.size() > 1 && typed.front() == '"' && typed.back() == '"' && !has_escapes)
            typed = typed.substr(1, typed.size() - 2);
        cell.begin =
            typed.empty() ? cell.begin : static_cast<std::size_t>(typed.data() - text.data());
        cell.end = cell.begin + typed.size();
    }
    // | y | left | has nothing before the first bar and behind the last.
    if (separator_ == '|' && cells.size() > 2 && cells.front().begin == cells.front().end)
        cells.erase(cells.begin());
    if (separator_ == '|' && cells.size() > 1 && cells.back().begin == cells.back().end)
        cells.pop_back();
    return cells;
}

bool ClaimColumns::has(std::string_view field) const {
    return std::find(columns_.begin(), columns_.end(), field) != columns_.end();
}

/// The kind of step that has such columns.
std::string_view ClaimColumns::step_of_columns() const {
    if (has("d"))
        return "decide";
    if (has("dx_dy"))
        return "edge";
    if (has("normal") || has("view") || has("dot") || has("cosine") || has("culled"))
        return "face";
    if (has("name") && has("x"))
        return "vertex";
    if (has("y") && (has("left") || has("right") || has("from") || has("to") || has("pixels") ||
                     has("left_depth")))
        return "scanline";
    if ((has("x") && has("y")) || has("place"))
        return "pixel";
    return "";
}

std::optional<ClaimColumns> ClaimColumns::headed(const Source& source, std::size_t begin,
                                                 std::size_t end, const std::string& title) {
    const std::string_view text = source.text;
    ClaimColumns table;
    table.separator_ = separator_in(text.substr(begin, end - begin));
    table.is_latex_ = table.separator_ == '&';
    table.title_ = title;
    if (table.separator_ == '\0')
        return std::nullopt;
    const auto cells = table.cells_of(text, begin, end);
    const auto head_at = [&](const Cell& cell) {
        return head_of(text.substr(cell.begin, cell.end - cell.begin));
    };
    // One head that is known makes a table, if no line of claims looks so.
    const bool is_line =
        text.substr(begin, end - begin).find_first_of("=:") != std::string_view::npos;
    const auto known = std::count_if(cells.begin(), cells.end(), head_at);
    if (is_line || cells.size() < 2 || known == 0 || head_at(cells.front()) == nullptr)
        return std::nullopt;
    for (const Cell& cell : cells) {
        const Head* const head = head_at(cell);
        if (head == nullptr) {
            const std::string typed(text.substr(cell.begin, cell.end - cell.begin));
            std::vector<std::string_view> words;
            for (const Head& one : heads)
                words.push_back(one.word);
            throw problem_at(
                source, cell.begin,
                fmt::format("expected what the column holds, like y, left, right, p_k or (x, y), "
                            "found {}",
                            typed.empty() ? "nothing" : shortened(printable(typed), 40)),
                did_you_mean(plain_head(typed), words));
        }
        table.columns_.push_back(head->field);
    }
    table.step_ = table.step_of_columns();
    if (table.step_.empty())
        throw problem_at(source, cells.front().begin,
                         "expected columns that say what was worked out, like `y, left, right`, "
                         "`k, p_k, (x, y)` or "
                         "`vertex, x, y`, found others");
    return table;
}

bool ClaimColumns::read_row(const Source& source, std::size_t begin, std::size_t end,
                            std::size_t line, CommaUse& commas, std::vector<Claim>& claims) {
    const std::string_view text = source.text;
    const std::string_view row = without_blanks(text.substr(begin, end - begin));
    if (is_rule(row) && !row.empty())
        return true;
    if (row.empty() || row.find(separator_) == std::string_view::npos)
        return false;
    const auto cells = cells_of(text, begin, end);
    if (cells.size() != columns_.size())
        throw problem_at(source, begin,
                         fmt::format("expected {} cells, as the head of the table has, found {}",
                                     columns_.size(), cells.size()));
    const auto offset_of_row = static_cast<std::size_t>(row.data() - text.data());
    const auto new_claim = [&](std::string_view step) {
        return Claim{.line = line,
                     .offset = offset_of_row,
                     .text = std::string(row),
                     .step = std::string(step),
                     .fields = {},
                     .picture = {}};
    };
    Claim claim = new_claim(step_);
    if (!title_.empty())
        claim.fields.push_back({.name = coordinates_in_space(title_) == 0 ? "in" : "space",
                                .values = {title_},
                                .offset = offset_of_row});
    std::vector<std::string> coordinates;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        // A comma in the cell of a table is that of a decimal, if no comma parts the cells.
        CommaUse in_cell{.is_decimal = separator_ != ',' || commas.is_decimal};
        ClaimLine cell(source, cells[i].begin, cells[i].end, in_cell);
        const std::string_view field = columns_[i];
        if (field.empty() || (cell.at_end() && field == "place"))
            continue;
        Claim pixel = new_claim("pixel");
        Claim& about = field == "place" && step_ == "decide" ? pixel : claim;
        if (step_ == "vertex" && field.size() == 1)
            coordinates.push_back(cell.at_end() ? std::string(open_value) : cell.one_number().text);
        else if (field == "place")
            read_pixel_cell(cell, about);
        else
            read_cell(cell, about, field);
        if (field == "place" && about.find("plotted") == nullptr)
            about.fields.push_back(
                {.name = "plotted", .values = {"true"}, .offset = cells[i].begin});
        commas.is_seen = commas.is_seen || in_cell.is_seen;
        if (&about == &pixel)
            claims.push_back(std::move(pixel));
    }
    if (!coordinates.empty())
        add_coordinates(claim, coordinates);
    if (step_ != "decide") {
        claims.push_back(std::move(claim));
        return true;
    }
    // All d of a line are one claim.
    const ClaimedField* const d = claim.find("d");
    if (d == nullptr)
        return true;
    if (!decisions_) {
        decisions_ = claims.size();
        claims.push_back(std::move(claim));
        return true;
    }
    for (ClaimedField& field : claims[*decisions_].fields)
        if (field.name == "d")
            field.values.insert(field.values.end(), d->values.begin(), d->values.end());
    return true;
}

} // namespace rastertrace
