// SPDX-License-Identifier: MIT
#pragma once

// The values that the fields of a step hold: as they stand in the trace, and decoded by who asks for that. Each is a
// view, valid as long as its trace; absent where the step has no such field.
//
//     const auto row = step.as<ScanlineStep>();
//     row.left.text();   // "25/8"
//     row.left.exact();  // 25/8

#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/steps.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/json_scanner.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// What all of them have. A value is there if its field is, whatever it holds.
class TracedValue {
public:
    TracedValue() = default;
    explicit TracedValue(std::string_view json) : json_(json) {}

    explicit operator bool() const { return json_.data() != nullptr; }

    /// As it stands in the trace; "" of one that is not there.
    std::string_view json() const { return json_; }

    /// What a string says, or else the value as it stands; "" of one that is not there.
    std::string text() const { return plain_text(json_); }

    friend bool operator==(const TracedValue& a, const TracedValue& b) = default;

private:
    std::string_view json_;
};

/// A name.
class TracedText : public TracedValue {
public:
    using TracedValue::TracedValue;

    friend bool operator==(const TracedText& a, std::string_view text) {
        // Nearly no name has an escape, which only text() undoes.
        const std::string_view json = a.json();
        return json.find('\\') != std::string_view::npos ? a.text() == text
               : json.starts_with('"')                   ? json.substr(1, json.size() - 2) == text
                                                         : json == text;
    }
};

/// A number, 3.125 or, known exactly, "25/8"; null where there is no such number; NaN, inf or -inf in the trace of a
/// foreign rasterizer.
class TracedNumber : public TracedValue {
public:
    using TracedValue::TracedValue;

    /// True for a number, or for what is in the place of one; false for null.
    bool has_number() const { return *this && json() != "null"; }

    /// The number as it is written; nothing for what is no finite number.
    std::optional<Rational> exact() const;

    /// The nearest double of it.
    std::optional<double> nearest_double() const;
};

/// True or false.
class TracedFlag : public TracedValue {
public:
    using TracedValue::TracedValue;

    explicit operator bool() const = delete; ///< which question would that be?
    bool is_true() const { return json() == "true"; }
    bool is_false() const { return json() == "false"; }
};

/// #rrggbb, with the trace's own spelling.
class TracedColor : public TracedValue {
public:
    using TracedValue::TracedValue;

    std::optional<Color> color() const { return parse_color(text()); }
};

/// The words that a trace has for the values of an enumeration. One that is not among them, of a foreign rasterizer,
/// is none of the enumeration.
std::string_view word_of(PrimitiveKind kind);
std::string_view word_of(Space space);
std::string_view word_of(Move move);
std::string_view word_of(SkipReason reason);

template <typename Enum> class TracedWord : public TracedText {
public:
    using TracedText::TracedText;

    friend bool operator==(const TracedWord& a, Enum value) {
        return static_cast<const TracedText&>(a) == word_of(value);
    }
};

/// A list of values, or of such lists.
template <typename Value> class TracedList : public TracedValue {
public:
    using TracedValue::TracedValue;

    /// Each as Value::text() gives it; nothing of what is no list.
    std::vector<std::string> texts() const {
        std::vector<std::string> result;
        JsonScanner elements(json_of_list());
        while (elements.next_element())
            result.push_back(plain_text(elements.value()));
        return result;
    }

    std::vector<Value> values() const {
        std::vector<Value> result;
        JsonScanner elements(json_of_list());
        while (elements.next_element())
            result.push_back(Value(elements.value()));
        return result;
    }

private:
    std::string_view json_of_list() const { return *this ? json() : std::string_view("[]"); }
};

/// The same of a list of lists: its rows, each as TracedList::texts() gives it.
template <typename Value>
std::vector<std::vector<std::string>> text_rows(const TracedList<TracedList<Value>>& list) {
    std::vector<std::vector<std::string>> rows;
    for (const TracedList<Value>& row : list.values())
        rows.push_back(row.texts());
    return rows;
}

} // namespace rastertrace
