// SPDX-License-Identifier: MIT
#include <rastertrace/figures/drawing.h>

#include "font.h"

#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <type_traits>
#include <utility>

namespace rastertrace {

namespace {

/// Of letters of fixed width, in ems: DejaVu Sans Mono has 0.602.
constexpr double fixed_advance = 0.61;

/// The nth of the roles from `first` to `last`, from 0; behind the last one comes the first again.
Role nth_role(Role first, Role last, std::size_t n) {
    const auto number = [](Role role) { return static_cast<std::size_t>(role); };
    return static_cast<Role>(number(first) + n % (number(last) - number(first) + 1));
}

void move(Place& place, Place by) {
    place = {place.x + by.x, place.y + by.y};
}

void move(std::vector<Path>& paths, Place by) {
    for (Path& path : paths)
        for (Place& place : path)
            move(place, by);
}

void move(Shape& shape, Place by) {
    std::visit(
        [by](auto& one) {
            using One = std::remove_reference_t<decltype(one)>;
            if constexpr (std::is_same_v<One, Areas>)
                for (Rectangle& rectangle : one.rectangles)
                    move(rectangle.corner, by);
            else if constexpr (std::is_same_v<One, Dots>)
                for (Place& center : one.centers)
                    move(center, by);
            else if constexpr (std::is_same_v<One, Pixels>)
                move(one.corner, by);
            else if constexpr (std::is_same_v<One, Label>)
                move(one.at, by);
            else
                move(one.paths, by);
        },
        shape);
}

std::size_t memory_of_shape(const Shape& shape) {
    return sizeof shape + std::visit(
                              [](const auto& one) {
                                  using One = std::remove_cvref_t<decltype(one)>;
                                  if constexpr (std::is_same_v<One, Areas>)
                                      return one.rectangles.size() * sizeof(Rectangle);
                                  else if constexpr (std::is_same_v<One, Dots>)
                                      return one.centers.size() * sizeof(Place);
                                  else if constexpr (std::is_same_v<One, Pixels>)
                                      return one.colors.size() * sizeof(Color);
                                  else if constexpr (std::is_same_v<One, Label>)
                                      return one.text.size();
                                  else {
                                      std::size_t bytes = one.paths.size() * sizeof(Path);
                                      for (const Path& path : one.paths)
                                          bytes += path.size() * sizeof(Place);
                                      return bytes;
                                  }
                              },
                              shape);
}

} // namespace

Role face_role(std::size_t n) {
    return nth_role(Role::face_1, Role::face_8, n);
}

Role curve_role(std::size_t n) {
    return nth_role(Role::curve_1, Role::curve_12, n);
}

void place(Drawing&& part, Place corner, Drawing& sheet) {
    for (Shape& shape : part.shapes)
        move(shape, corner);
    sheet.shapes.insert(sheet.shapes.end(), std::make_move_iterator(part.shapes.begin()),
                        std::make_move_iterator(part.shapes.end()));
}

std::size_t memory_of(const Drawing& drawing) {
    std::size_t bytes = sizeof drawing + drawing.title.size() + drawing.description.size();
    for (const Shape& shape : drawing.shapes)
        bytes += memory_of_shape(shape);
    return bytes;
}

std::string decimal(double value) {
    constexpr int hundred = 100;
    const auto hundredths = static_cast<long long>(std::llround(value * hundred));
    const long long whole = std::llabs(hundredths) / hundred;
    const long long rest = std::llabs(hundredths) % hundred;
    std::string text = fmt::format("{}{}", hundredths < 0 ? "-" : "", whole);
    if (rest != 0)
        text += rest % 10 == 0 ? fmt::format(".{}", rest / 10) : fmt::format(".{:02}", rest);
    return text;
}

void add_arrow(Place from, Place to, Role role, double head_length, std::vector<Shape>& shapes) {
    const double dx = to.x - from.x;
    const double dy = to.y - from.y;
    const double length = std::sqrt(dx * dx + dy * dy);
    if (length == 0)
        return;
    constexpr double most = 0.6; // of the arrow, so that a short one has a shaft
    const double head = std::min(head_length, most * length);
    const double along_x = dx / length * head;
    const double along_y = dy / length * head;
    const Place neck{to.x - along_x, to.y - along_y};
    constexpr double slimness = 0.4; // of half the head's width to its length
    shapes.push_back(Lines{.role = role, .paths = {{from, neck}}});
    shapes.push_back(
        Polygons{.role = role,
                 .paths = {{to,
                            {neck.x - slimness * along_y, neck.y + slimness * along_x},
                            {neck.x + slimness * along_y, neck.y - slimness * along_x}}}});
}

std::string typeset(std::string_view typed) {
    if (typed.size() < 2)
        return std::string(typed); // a sign alone stays as it is
    // A line may end with a sign, or go on with one.
    const std::string padded = fmt::format(" {} ", typed);
    const std::string_view text = padded;
    constexpr std::array<std::pair<std::string_view, std::string_view>, 4> signs{
        {{" -> ", " → "}, {" <= ", " ≤ "}, {" >= ", " ≥ "}, {" - ", " − "}}};
    const auto is_one_of = [](std::string_view all, char c) {
        return all.find(c) != std::string_view::npos;
    };
    std::string set;
    for (std::size_t i = 0; i < text.size();) {
        const auto sign = std::find_if(signs.begin(), signs.end(), [&](const auto& one) {
            return text.substr(i).starts_with(one.first);
        });
        if (sign != signs.end()) {
            set += sign->second.substr(0, sign->second.size() - 1);
            i += sign->first.size() - 1; // the blank behind it may be before the next sign
            continue;
        }
        const bool is_minus = text[i] == '-' && i + 1 < text.size() &&
                              is_one_of(".0123456789(abcdefghijklmnopqrstuvwxyz", text[i + 1]) &&
                              is_one_of(" (,", text[i - 1]);
        set += is_minus ? std::string_view("−") : text.substr(i, 1);
        ++i;
    }
    return set.substr(1, set.size() - 2);
}

namespace {

/// The formula that a text begins with; "" if it begins with none.
std::string_view formula_at(std::string_view text) {
    const auto is_blank = [&](std::size_t i) { return text[i] == ' '; };
    if (text.size() < 3 || text[0] != '$' || is_blank(1))
        return {};
    int open = 0; // braces
    for (std::size_t i = 1; i < text.size(); ++i) {
        if (text[i] == '\\') {
            ++i; // what stands behind it is no sign of its own
        } else if (text[i] == '$') {
            const bool has_digit = i + 1 < text.size() && '0' <= text[i + 1] && text[i + 1] <= '9';
            return open == 0 && i > 1 && !is_blank(i - 1) && !has_digit ? text.substr(0, i + 1)
                                                                        : std::string_view();
        } else if (text[i] == '%') {
            return {}; // a comment
        } else {
            open += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
        }
        if (open < 0)
            return {};
    }
    return {};
}

} // namespace

std::vector<TextPart> parts_with_formulas(std::string_view text) {
    std::vector<TextPart> parts(1);
    while (!text.empty()) {
        if (const std::string_view formula = formula_at(text); !formula.empty()) {
            parts.push_back({std::string(formula), true});
            parts.emplace_back();
            text.remove_prefix(formula.size());
            continue;
        }
        if (text.starts_with("\\$"))
            text.remove_prefix(1);
        parts.back().text += text.front();
        text.remove_prefix(1);
    }
    std::erase_if(parts, [](const TextPart& part) { return part.text.empty(); });
    return parts;
}

std::string shown_text(const Label& label) {
    if (label.is_fixed_width)
        return label.text;
    if (!label.has_formulas)
        return typeset(label.text);
    std::string text;
    for (const TextPart& part : parts_with_formulas(label.text))
        text += part.text;
    return typeset(text);
}

double width_of(std::string_view typed, double size, bool is_bold) {
    double ems = 0;
    const std::string set = typeset(typed);
    std::string_view text = set;
    while (!text.empty()) {
        const std::size_t length = first_code_point(text).length;
        const char32_t character = first_code_point(text).value;
        const auto advance = advance_of(character, is_bold ? Typeface::bold : Typeface::regular);
        ems += advance.value_or(fixed_advance *
                                static_cast<double>(columns_in(text.substr(0, length))));
        text.remove_prefix(length);
    }
    return ems * size;
}

std::size_t letters_in(double width, double size) {
    return static_cast<std::size_t>(std::max(width / (fixed_advance * size), 1.0));
}

} // namespace rastertrace
