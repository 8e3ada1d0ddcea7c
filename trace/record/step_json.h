// SPDX-License-Identifier: MIT
#pragma once

// Steps as lines of JSON: the table of a step (traced_steps.h) with a value for each field that it has.
// docs/trace-format.md describes them.
//
//     step_json(ScanlineStep{.y = 2, ...});  // {"step":"scanline","y":2,...}

#include "traced_steps.h"

#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/double_texts.h>
#include <rastertrace/trace/text/format_number.h>

#include <fmt/core.h>

#include <cstddef>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

namespace rastertrace::step_json_parts {

// How much room a value takes at most, and what is written of it.

inline std::size_t room_of(std::string_view text) {
    return text.size();
}
inline std::size_t room_of(Index /*number*/) {
    return room_for(Index{});
}
inline std::size_t room_of(const std::optional<Index>& /*number*/) {
    return room_for(Index{});
}
inline std::size_t room_of(const TracedFlag& flag) {
    return flag.json().size();
}
inline std::size_t room_of(const TracedValue& value) {
    return value.json().size();
}
inline std::size_t room_of(const TracedNumber& number) {
    return number.visit([]<typename Held>(const Held& held) -> std::size_t {
        if constexpr (std::is_same_v<Held, std::string_view>)
            return held.size();
        else
            return room_for(Fraction64{});
    });
}
inline std::size_t room_of(const TracedColor& color) {
    constexpr std::size_t longest = 11; // "#rrggbbaa" in quotes
    return color.visit([]<typename Held>(const Held& held) -> std::size_t {
        if constexpr (std::is_same_v<Held, std::string_view>)
            return held.size();
        else
            return longest;
    });
}
template <typename Value> std::size_t room_of(const TracedList<Value>& list) {
    return list.visit([]<typename Held>(const Held& held) -> std::size_t {
        std::size_t room = 2;
        if constexpr (std::is_same_v<Held, std::string_view>)
            room = held.size();
        else if constexpr (!std::is_same_v<Held, std::monostate>)
            for (const Value& value : held)
                room += room_of(value) + 1;
        return room;
    });
}

/// Appends to memory. Texts of doubles that come again are remembered, if somebody does.
struct Appender {
    char* out;
    DoubleTexts* texts = nullptr;

    void add(std::string_view text) {
        std::memcpy(out, text.data(), text.size());
        out += text.size();
    }
    void add(Index number) { out = format_number(out, number); }
    void add(const std::optional<Index>& number) { add(*number); }
    void add(const TracedFlag& flag) { add(flag.json()); }
    void add(const TracedValue& value) { add(value.json()); }
    void add(const TracedNumber& number) {
        number.visit([this]<typename Held>(const Held& held) {
            if constexpr (std::is_same_v<Held, std::string_view>)
                add(held);
            else if constexpr (std::is_same_v<Held, double>)
                out = texts != nullptr ? texts->append(out, held) : format_number(out, held);
            else if constexpr (!std::is_same_v<Held, std::monostate>)
                out = format_number(out, held);
        });
    }
    void add(const TracedColor& color) {
        color.visit([this]<typename Held>(const Held& held) {
            if constexpr (std::is_same_v<Held, std::string_view>) {
                add(held);
            } else if constexpr (std::is_same_v<Held, Color>) {
                *out++ = '"';
                add(std::string_view(to_text(held)));
                *out++ = '"';
            }
        });
    }
    template <typename Value> void add(const TracedList<Value>& list) {
        list.visit([this]<typename Held>(const Held& held) {
            if constexpr (std::is_same_v<Held, std::string_view>) {
                add(held);
            } else if constexpr (!std::is_same_v<Held, std::monostate>) {
                char before = '[';
                for (const Value& value : held) {
                    *out++ = std::exchange(before, ',');
                    add(value);
                }
                if (held.empty())
                    *out++ = '[';
                *out++ = ']';
            }
        });
    }
};

/// True of a field that the step has.
template <typename Value> bool is_there(const Value& value) {
    if constexpr (std::is_same_v<Value, Index>)
        return true;
    else if constexpr (std::is_same_v<Value, TracedFlag>)
        return value.is_there();
    else
        return static_cast<bool>(value);
}

template <typename Row, typename Step> std::size_t room_of_field(const Step& step) {
    return is_there(Row::in(step)) ? front_of_field<Row>.size() + room_of(Row::in(step)) : 0;
}
template <typename Row, typename Step> void add_field(Appender& to, const Step& step) {
    if (!is_there(Row::in(step)))
        return;
    to.add(front_of_field<Row>);
    to.add(Row::in(step));
}

template <typename Step>
inline constexpr std::string_view name_of_step =
    step_names[static_cast<std::size_t>(Step::step_kind)];

template <typename Step, typename... Rows>
std::size_t room_of_fields(const Step& step, FieldTable<Rows...> /*table*/) {
    return (room_of_field<Rows>(step) + ...);
}
template <typename Step, typename... Rows>
void add_fields(Appender& to, const Step& step, FieldTable<Rows...> /*table*/) {
    (add_field<Rows>(to, step), ...);
}

template <typename Value> std::string json_of(const Value& value) {
    std::string json(room_of(value), '\0');
    Appender to{json.data()};
    to.add(value);
    json.resize(static_cast<std::size_t>(to.out - json.data()));
    return json;
}

template <typename Step, typename... Rows>
std::optional<std::string> field_of(const Step& step, std::string_view name,
                                    FieldTable<Rows...> /*table*/) {
    std::optional<std::string> found;
    const auto look_at = [&](auto row) {
        if (row.name == name && is_there(row.in(step)))
            found = json_of(row.in(step));
    };
    (look_at(Rows{}), ...);
    return found;
}

} // namespace rastertrace::step_json_parts

namespace rastertrace {

/// The most bytes that a step takes.
template <typename Step> std::size_t room_for_step(const Step& step) {
    using namespace step_json_parts;
    return front_of_step.size() + name_of_step<Step>.size() + 2 +
           room_of_fields(step, typename Step::Fields{});
}

/// Writes a step to `out`, which has room for it; returns the place behind it.
template <typename Step>
char* write_step(char* out, const Step& step, DoubleTexts* texts = nullptr) {
    using namespace step_json_parts;
    Appender to{out, texts};
    to.add(front_of_step);
    to.add(name_of_step<Step>);
    *to.out++ = '"';
    add_fields(to, step, typename Step::Fields{});
    *to.out++ = '}';
    return to.out;
}

/// The JSON of a field, or nothing if the step has no such field.
template <typename Step>
std::optional<std::string> field_of_step(const Step& step, std::string_view name) {
    using namespace step_json_parts;
    return name == "step" ? std::optional(fmt::format("\"{}\"", name_of_step<Step>))
                          : field_of(step, name, typename Step::Fields{});
}

template <typename Step> std::string step_json(const Step& step) {
    std::string json(room_for_step(step), '\0');
    json.resize(static_cast<std::size_t>(write_step(json.data(), step) - json.data()));
    return json;
}

} // namespace rastertrace
