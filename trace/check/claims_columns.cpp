// SPDX-License-Identifier: MIT
#include "claims_columns.h"

#include "claim_fields.h"
#include "claim_forms.h"
#include "typed_number.h"

#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <variant>

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
    {"k", "k"},
    {"i", "k"},
    {"step", ""},
    {"xy", "place"},
    {"xk+1yk+1", "place"},
    {"xkyk", "place"},
    {"pixel", "place"},
    {"round", "place"},
    {"rounded", "place"},
    {"roundxy", "place"},
    {"roundx", "place_x"},
    {"roundedx", "place_x"},
    {"xrounded", "place_x"},
    {"roundy", "place_y"},
    {"roundedy", "place_y"},
    {"yrounded", "place_y"},
    {"ymin", "y_min"},
    {"ymax", "y_max"},
    {"xmin", "x_start"},
    {"1m", "dx_dy"},
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

/// A head as it is compared: p_k, $p_k$ and P k are pk, x_\text{left} is xleft, and linha is row.
std::string plain_head(std::string_view typed) {
    std::string plain(english_word(without_blanks(typed)));
    if (plain.empty())
        plain = typed;
    for (const std::string_view command : {"\\text", "\\mathrm"})
        for (std::size_t at = 0; (at = plain.find(command)) != std::string::npos;)
            plain.erase(at, command.size());
    std::string word;
    for (const char c : plain)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+')
            word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return word;
}

/// The field in the column of a head: one of the table, or of a step, whose names `show` prints.
std::optional<std::string_view> field_of_head(std::string_view typed) {
    const std::string word = plain_head(typed);
    const auto* const known = std::find_if(heads.begin(), heads.end(),
                                           [&word](const Head& head) { return head.word == word; });
    if (known != heads.end())
        return known->field;
    for (const std::string_view kind : claim_kinds())
        for (const ClaimField& field : claim_fields_of(*step_kind_named(kind)))
            if (plain_head(field.name) == word)
                return field.name;
    return std::nullopt;
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

/// The kind of step whose fields are these heads, all of them, as `show` prints them; "" if there is none.
std::string_view printed_step(const std::vector<std::string>& heads) {
    for (const std::string_view kind : claim_kinds()) {
        std::vector<std::string> names{"step"};
        for (const StepField& field : fields_of(*step_kind_named(kind)))
            names.emplace_back(field.name);
        if (names == heads)
            return kind;
    }
    return "";
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
    if (has("dx_dy") || has("y_min") || has("y_max"))
        return "edge";
    if (has("normal") || has("view") || has("dot") || has("cosine") || has("culled"))
        return "face";
    if (has("x") && has("y") && (has("place") || has("place_x") || has("place_y")))
        return "along";
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
        return field_of_head(text.substr(cell.begin, cell.end - cell.begin));
    };
    // One head that is known makes a table, if no line of claims looks so.
    const bool is_line =
        text.substr(begin, end - begin).find_first_of("=:") != std::string_view::npos;
    const bool is_comment = without_blanks(text.substr(begin, end - begin)).starts_with('#');
    if (is_line || is_comment || cells.size() < 2 || !head_at(cells.front()))
        return std::nullopt;
    std::vector<std::string> typed_heads;
    for (const Cell& cell : cells)
        typed_heads.emplace_back(text.substr(cell.begin, cell.end - cell.begin));
    if (const std::string_view step = printed_step(typed_heads); !step.empty()) {
        table.step_ = step;
        table.is_printed_ = true;
        table.columns_.assign(cells.size(), "");
        const auto& fields = fields_of(*step_kind_named(step));
        for (std::size_t i = 0; i < fields.size(); ++i)
            table.columns_[i + 1] = fields[i].name;
        return table;
    }
    for (const Cell& cell : cells) {
        const auto field = head_at(cell);
        if (!field) {
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
        table.columns_.push_back(*field);
    }
    table.step_ = table.step_of_columns();
    if (table.step_.empty())
        throw problem_at(source, cells.front().begin,
                         "expected columns that say what was worked out, like `y, left, right`, "
                         "`k, p_k, (x, y)` or "
                         "`vertex, x, y`, found others");
    return table;
}

std::optional<ClaimColumns> ClaimColumns::turned(const Source& source, std::size_t begin,
                                                 std::size_t& end, std::size_t line,
                                                 CommaUse& commas, std::vector<Claim>& claims) {
    const std::string_view text = source.text;
    ClaimColumns table;
    table.separator_ = separator_in(text.substr(begin, end - begin));
    std::vector<std::vector<Cell>> columns; // of the turned table: a row of the text each
    std::string all_heads;
    for (std::size_t at = begin, behind = end; table.separator_ != '\0' && at < text.size();) {
        auto cells = table.cells_of(text, at, behind);
        const auto is_number = [&](const Cell& cell) {
            const auto read = number_at(text.substr(cell.begin, cell.end - cell.begin), {});
            return std::holds_alternative<TypedNumber>(read);
        };
        const auto head = field_of_head(
            text.substr(cells.front().begin, cells.front().end - cells.front().begin));
        if (!head || cells.size() < 2 ||
            (!columns.empty() && cells.size() != columns[0].size() + 1) ||
            !std::all_of(cells.begin() + 1, cells.end(), is_number))
            break;
        table.columns_.push_back(*head);
        columns.emplace_back(cells.begin() + 1, cells.end());
        end = behind;
        at = behind + 1;
        behind = std::min(text.find('\n', at), text.size());
    }
    table.step_ = table.step_of_columns();
    if (columns.size() < 2 || table.step_.empty())
        return std::nullopt;
    for (std::size_t i = 0; i < columns[0].size(); ++i) {
        std::vector<Cell> row;
        for (const auto& column : columns)
            row.push_back(column[i]);
        table.read_cells(source, row, row.front().begin, line, commas, claims);
    }
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
    read_cells(source, cells, static_cast<std::size_t>(row.data() - text.data()), line, commas,
               claims);
    return true;
}

void ClaimColumns::read_cells(const Source& source, const std::vector<Cell>& cells,
                              std::size_t offset_of_row, std::size_t line, CommaUse& commas,
                              std::vector<Claim>& claims) {
    const std::size_t row_end = std::min(source.text.find('\n', offset_of_row), source.text.size());
    const std::string row(
        without_blanks(source.text.substr(offset_of_row, row_end - offset_of_row)));
    const auto new_claim = [&](std::string_view step) {
        return Claim{.line = line,
                     .offset = offset_of_row,
                     .text = row,
                     .step = std::string(step),
                     .fields = {},
                     .picture = {}};
    };
    Claim claim = new_claim(step_);
    if (!title_.empty())
        claim.fields.push_back({.name = coordinates_in_space(title_) == 0 ? "in" : "space",
                                .values = {title_},
                                .offset = offset_of_row});
    std::vector<std::string> coordinates, point, place;
    const std::size_t row_in_table = rows_++;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        // A comma in the cell of a table is that of a decimal, if no comma parts the cells.
        CommaUse in_cell{.is_decimal = separator_ != ',' || commas.is_decimal};
        ClaimLine cell(source, cells[i].begin, cells[i].end, in_cell);
        const std::string_view field = columns_[i];
        const bool is_left_out =
            ((cell.at_end() || cell.peek().is("null")) && (field == "place" || is_printed_)) ||
            (is_printed_ && claim.find(field) != nullptr);
        if (field.empty() || is_left_out)
            continue;
        const auto number = [&cell] {
            return cell.at_end() ? std::string(open_value) : cell.one_number().text;
        };
        const bool is_axis = field == "x" || field == "y";
        if (step_ == "vertex" && field.size() == 1 && !is_printed_) {
            coordinates.push_back(number());
        } else if (step_ == "along" && is_axis && !is_printed_) {
            point.push_back(number());
        } else if (step_ == "edge" && field == "x") {
            read_cell(cell, claim, "x_start");
        } else if (step_ == "decide" && is_axis && !is_printed_) {
            place.push_back(number());
        } else if (field == "place_x" || field == "place_y") {
            place.push_back(number());
        } else if (field == "place" && (step_ == "decide" || step_ == "along")) {
            Claim pixel = new_claim("pixel");
            read_pixel_cell(cell, pixel);
            place = {pixel.fields[0].values[0], pixel.fields[1].values[0]};
        } else if (field == "place") {
            read_pixel_cell(cell, claim);
            if (claim.find("plotted") == nullptr)
                claim.fields.push_back(
                    {.name = "plotted", .values = {"true"}, .offset = cells[i].begin});
        } else if (field == "k") {
            claim.fields.push_back({.name = "k", .values = {number()}, .offset = cells[i].begin});
        } else {
            read_cell(cell, claim, field);
            if (step_ == "decide" && field == "d")
                claim.fields.back().is_list = false; // of this step
        }
        commas.is_seen = commas.is_seen || in_cell.is_seen;
    }
    if (!coordinates.empty())
        add_coordinates(claim, coordinates);
    const auto put_two = [&](std::string_view name, std::vector<std::string>& values) {
        if (values.size() == 2)
            claim.fields.push_back({.name = std::string(name),
                                    .values = std::move(values),
                                    .is_list = true,
                                    .offset = offset_of_row});
    };
    claim.is_printed = is_printed_;
    put_two("xy", point);
    put_two("place", place);
    if (step_ == "decide" && !is_printed_)
        count_step(claim, row_in_table);
    else
        std::erase_if(claim.fields, [](const ClaimedField& field) { return field.name == "k"; });
    claims.push_back(std::move(claim));
}

/// Bresenham's steps count from 0, or from 1 if the first row does; without a column for that, rows do.
void ClaimColumns::count_step(Claim& claim, std::size_t row) {
    const auto k =
        claim.find("k") == nullptr ? std::nullopt : typed_value(claim.find("k")->values.front());
    if (row == 0 && k && k->value == 1)
        first_step_ = 1;
    const Rational step = k ? Rational(k->value - first_step_) : Rational(static_cast<long>(row));
    std::erase_if(claim.fields, [](const ClaimedField& field) { return field.name == "k"; });
    claim.fields.insert(claim.fields.begin(),
                        {.name = "k", .values = {step.get_str()}, .offset = claim.offset});
}

} // namespace rastertrace
