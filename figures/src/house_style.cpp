// SPDX-License-Identifier: MIT
#include <rastertrace/figures/house_style.h>

#include <rastertrace/figures/theme.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/json_reader.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

constexpr std::array role_keys{
    JsonKey{"color", "color", "Of its lines, areas, dots and words"},
    JsonKey{"width", "number", "Of its lines, in units"},
    JsonKey{"radius", "number", "Of its dots, in units"},
};

class StyleReader {
public:
    explicit StyleReader(const Source& source) : json_{source} {}

    HouseStyle read() const {
        auto document = parse_json(json_.source);
        if (!document)
            throw document.problem();
        const JsonValue root = document.value().root();
        if (root.kind != JsonValue::Kind::object)
            json_.fail_expecting(root, R"(a style, like {"true-edge": {"color": "#003366"}})");
        HouseStyle style;
        for (const auto& [key, value] : root.members()) {
            if (key.text == "decimal")
                style.has_decimal_comma = is_comma(value);
            else
                style.roles[role_in(key)] = role_style_in(value);
        }
        return style;
    }

private:
    bool is_comma(const JsonValue& value) const {
        const std::string sign = json_.string_in(value, R"("." or ",")");
        if (sign != "." && sign != ",")
            json_.fail_expecting(value, R"("." or ",")");
        return sign == ",";
    }

    Role role_in(const JsonValue& key) const {
        std::vector<std::string_view> names;
        for (const Role role : roles()) {
            if (name_of(role) == key.text)
                return role;
            names.push_back(name_of(role));
        }
        json_.fail_expecting(key, "decimal, or the role of a shape, as an .svg has it",
                             did_you_mean(key.text, names, "\""));
    }

    RoleStyle role_style_in(const JsonValue& value) const {
        constexpr std::string_view expected = R"(a style, like {"color": "#003366", "width": 2})";
        if (value.kind != JsonValue::Kind::object)
            json_.fail_expecting(value, expected);
        json_.allow_keys(value, role_keys);
        RoleStyle style;
        if (const auto color = value.find("color")) {
            style.color = parse_color(json_.string_in(*color, "a color, like \"#003366\""));
            if (!style.color)
                json_.fail_expecting(*color, "a color, like \"#003366\"");
        }
        style.width = size_in(value, "width");
        style.radius = size_in(value, "radius");
        return style;
    }

    std::optional<double> size_in(const JsonValue& value, std::string_view key) const {
        const auto found = value.find(key);
        if (!found)
            return std::nullopt;
        constexpr double most = 100;
        const auto size =
            found->kind == JsonValue::Kind::number ? nearest_double_in(found->text) : std::nullopt;
        if (!size || !(*size > 0) || *size > most)
            json_.fail_expecting(*found, fmt::format("a number above 0, at most {:g}", most));
        return size;
    }

    JsonReader json_;
};

bool is_digit_at(std::string_view text, std::size_t i) {
    return i < text.size() && '0' <= text[i] && text[i] <= '9';
}

/// "0.5" is "0,5", and "(0.5, 1)" is "(0,5; 1)".
std::string with_decimal_commas(std::string_view text) {
    std::string result;
    bool has_any = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_point =
            text[i] == '.' && i > 0 && is_digit_at(text, i - 1) && is_digit_at(text, i + 1);
        has_any = has_any || is_point;
        result += is_point ? ',' : text[i];
    }
    for (std::size_t at = result.find(", "); has_any && at != std::string::npos;
         at = result.find(", ", at + 1))
        result[at] = ';';
    return result;
}

void set_decimal_commas(Label& label) {
    if (!label.has_formulas) {
        label.text = with_decimal_commas(label.text);
        return;
    }
    std::string text;
    for (const TextPart& part : parts_with_formulas(label.text))
        text += part.is_formula ? part.text : with_decimal_commas(part.text);
    label.text = text;
}

} // namespace

Result<HouseStyle> house_style_in(const Source& source) {
    try {
        return StyleReader(source).read();
    } catch (const Problem& problem) {
        return problem;
    }
}

void apply(const HouseStyle& style, Drawing& drawing) {
    for (Shape& shape : drawing.shapes)
        std::visit(
            [&style](auto& one) {
                using One = std::decay_t<decltype(one)>;
                if constexpr (!std::is_same_v<One, Pixels>) {
                    if constexpr (std::is_same_v<One, Label>)
                        if (style.has_decimal_comma)
                            set_decimal_commas(one);
                    const auto found = style.roles.find(one.role);
                    if (found == style.roles.end())
                        return;
                    if (!one.color)
                        one.color = found->second.color;
                    if constexpr (std::is_same_v<One, Lines>)
                        one.width = found->second.width;
                    if constexpr (std::is_same_v<One, Dots>)
                        one.radius = found->second.radius.value_or(one.radius);
                }
            },
            shape);
}

} // namespace rastertrace
