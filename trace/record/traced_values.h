// SPDX-License-Identifier: MIT
#pragma once

// What the fields of steps hold in a trace. A value that was read is the text that stands there, decoded by who asks for it;
// of a scene that was drawn, a number, a color or a list is what the drawing had. Names and texts are referred to: a value
// is valid as long as its trace. One that its step does not have is absent.
//
//     TracedNumber("\"25/8\"").exact();  // 25/8
//     TracedNumber(0.1).json();          // 0.1

#include <rastertrace/core/draw/scene/algorithms.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/steps.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace rastertrace {

/// A value that stands in a trace as its text. Only the beginning is held: JSON itself tells where a value ends. It is
/// there if its field is, whatever it holds.
class TracedValue {
public:
    TracedValue() = default;

    /// The value begins at json.data(), and must be followed by the text that it stands in, or by a null character.
    explicit TracedValue(std::string_view json) : json_(json.data()) {}

    explicit operator bool() const { return json_ != nullptr; }

    /// As it stands in the trace; "" of one that is not there.
    std::string_view json() const;

    /// What a string says, or else the value as it stands; "" of one that is not there.
    std::string text() const;

    friend bool operator==(const TracedValue& a, const TracedValue& b) {
        return a.json_ == b.json_ || a.json() == b.json();
    }

private:
    const char* json_ = nullptr;
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

/// True or false; in the trace of a foreign rasterizer perhaps something else.
class TracedFlag {
public:
    TracedFlag() = default;
    explicit TracedFlag(std::string_view json)
        : held_(json == "true"    ? Held::yes
                : json == "false" ? Held::no
                                  : Held::other) {}
    explicit TracedFlag(bool value) : held_(value ? Held::yes : Held::no) {}

    explicit operator bool() const = delete; ///< which question would that be?
    bool is_there() const { return held_ != Held::absent; }
    bool is_true() const { return held_ == Held::yes; }
    bool is_false() const { return held_ == Held::no; }

    /// true or false; "" of anything else.
    std::string_view json() const {
        return is_true() ? "true" : is_false() ? "false" : std::string_view();
    }
    std::string text() const { return std::string(json()); }

    friend bool operator==(const TracedFlag&, const TracedFlag&) = default;

private:
    enum class Held : std::uint8_t { absent, no, yes, other };
    Held held_ = Held::absent;
};

/// The words that a trace has for the values of an enumeration. One that is not among them, of a foreign rasterizer,
/// is none of the enumeration.
std::string_view quoted_word_of(PrimitiveKind kind); // as it stands in a trace
std::string_view quoted_word_of(Space space);
std::string_view quoted_word_of(Move move);
std::string_view quoted_word_of(SkipReason reason);
template <typename Enum> std::string_view word_of(Enum value) {
    const std::string_view quoted = quoted_word_of(value);
    return quoted.substr(1, quoted.size() - 2);
}

template <typename Enum> class TracedWord : public TracedText {
public:
    using TracedText::TracedText;

    friend bool operator==(const TracedWord& a, Enum value) {
        return static_cast<const TracedText&>(a) == word_of(value);
    }
};

/// The properties of a primitive; none of a kind that is not ours.
inline std::optional<PrimitiveTraits> traits_of(const TracedWord<PrimitiveKind>& kind) {
    const auto* const found = std::find_if(all_primitives.begin(), all_primitives.end(),
                                           [&kind](PrimitiveKind one) { return kind == one; });
    return found == all_primitives.end() ? std::nullopt : std::optional(traits_of(*found));
}

/// True of a kind whose inside is drawn.
inline bool is_filled(const TracedWord<PrimitiveKind>& kind) {
    const auto traits = traits_of(kind);
    return traits && traits->thickness == Thickness::face;
}

/// A number, 3.125 or, known exactly, "25/8"; null where there is no such number; NaN, inf or -inf in the trace of a
/// foreign rasterizer.
class TracedNumber {
public:
    TracedNumber() = default;
    explicit TracedNumber(std::string_view json)
        : text_(json.data()), more_(static_cast<std::uint32_t>(json.size())), form_(Form::text) {}
    explicit TracedNumber(double number) : real_(number), form_(Form::real) {}
    explicit TracedNumber(float number) : real_(number), form_(Form::single) {}
    explicit TracedNumber(Index number) : whole_(number), form_(Form::whole) {}

    /// A fraction in lowest terms whose denominator is below 2^32.
    TracedNumber(Index numerator, std::uint32_t denominator)
        : whole_(numerator), more_(denominator), form_(Form::fraction) {}

    static TracedNumber null() { return TracedNumber(std::string_view("null")); }

    explicit operator bool() const { return form_ != Form::absent; }

    /// True for a number, or for what is in the place of one; false for null.
    bool has_number() const { return *this && *this != null(); }

    /// As it stands in the trace; "" of one that is not there.
    std::string json() const;

    /// The same without quotes.
    std::string text() const;

    /// The number as it is written; nothing for what is no finite number.
    std::optional<Rational> exact() const;

    /// The nearest double of it.
    std::optional<double> nearest_double() const;

    /// What a double or, of floats, a float stores of it; nothing for what has to be looked at closely.
    std::optional<double> stored_double(bool is_float) const;

    /// True if a trace writes both alike.
    friend bool operator==(const TracedNumber& a, const TracedNumber& b) {
        if (a.form_ != b.form_)
            return a.json() == b.json();
        return a.form_ == Form::text ? a.as_text() == b.as_text()
               : a.form_ == Form::real || a.form_ == Form::single
                   ? a.real_ == b.real_
                   : a.whole_ == b.whole_ && a.more_ == b.more_;
    }

    /// Calls `use` with what it holds: a text, a double, a float, an Index, a Fraction64, or std::monostate.
    template <typename Use> decltype(auto) visit(Use&& use) const {
        switch (form_) {
        case Form::text:
            return use(as_text());
        case Form::real:
            return use(real_);
        case Form::single:
            return use(static_cast<float>(real_));
        case Form::whole:
            return use(whole_);
        case Form::fraction:
            return use(Fraction64{whole_, more_});
        case Form::absent:
            break;
        }
        return use(std::monostate());
    }

private:
    enum class Form : std::uint8_t { absent, text, real, single, whole, fraction };

    std::string_view as_text() const { return {text_, more_}; }

    union {
        const char* text_ = nullptr;
        double real_; ///< of a float, too
        Index whole_; ///< also the numerator of a fraction
    };
    std::uint32_t more_ = 0; ///< bytes of the text, or the denominator
    Form form_ = Form::absent;
};

/// #rrggbb, with the trace's own spelling.
class TracedColor {
public:
    TracedColor() = default;
    explicit TracedColor(std::string_view json)
        : text_(json.data()), size_(static_cast<std::uint16_t>(std::min<std::size_t>(
                                  json.size(), std::numeric_limits<std::uint16_t>::max()))),
          form_(Form::text) {}
    explicit TracedColor(Color color) : color_(color), form_(Form::color) {}

    explicit operator bool() const { return form_ != Form::absent; }

    std::string json() const; ///< as it stands in the trace; "" of one that is not there
    std::string text() const; ///< without quotes
    std::optional<Color> color() const;

    friend bool operator==(const TracedColor& a, const TracedColor& b) {
        return a.json() == b.json();
    }

    /// Calls `use` with what it holds: a text, a Color, or std::monostate.
    template <typename Use> decltype(auto) visit(Use&& use) const {
        return form_ == Form::text    ? use(std::string_view(text_, size_))
               : form_ == Form::color ? use(color_)
                                      : use(std::monostate());
    }

private:
    enum class Form : std::uint8_t { absent, text, color };

    const char* text_ = nullptr;
    Color color_;
    std::uint16_t size_ = 0; ///< of the text; no color is longer
    Form form_ = Form::absent;
};

/// The values of a JSON array, as they stand in it; none of what is no array.
std::vector<std::string_view> elements_of(std::string_view json);

/// A list of values, or of such lists.
template <typename Value> class TracedList {
public:
    TracedList() = default;
    explicit TracedList(std::string_view json)
        : data_(json.data()), size_(static_cast<std::uint32_t>(json.size())), form_(Form::text) {}
    explicit TracedList(std::span<const Value> values)
        : data_(values.data()), size_(static_cast<std::uint32_t>(values.size())),
          form_(Form::values) {}

    explicit operator bool() const { return form_ != Form::absent; }

    /// As it stands in the trace; "" of one that is not there.
    std::string json() const {
        return visit([]<typename Held>(const Held& held) -> std::string {
            if constexpr (std::is_same_v<Held, std::string_view>) {
                return std::string(held);
            } else if constexpr (std::is_same_v<Held, std::monostate>) {
                return {};
            } else {
                std::string json = "[";
                for (const Value& value : held)
                    json.append(json.size() > 1 ? "," : "").append(value.json());
                return json + "]";
            }
        });
    }

    /// What it says, if it is none.
    std::string text() const { return TracedValue(json()).text(); }

    /// Each as Value::text() gives it; nothing of what is no list.
    std::vector<std::string> texts() const {
        std::vector<std::string> texts;
        for (const Value& value : values())
            texts.push_back(value.text());
        return texts;
    }

    std::vector<Value> values() const {
        return visit([]<typename Held>(const Held& held) -> std::vector<Value> {
            std::vector<Value> values;
            if constexpr (std::is_same_v<Held, std::string_view>)
                for (const std::string_view value : elements_of(held))
                    values.push_back(Value(value));
            else if constexpr (!std::is_same_v<Held, std::monostate>)
                values.assign(held.begin(), held.end());
            return values;
        });
    }

    friend bool operator==(const TracedList& a, const TracedList& b) {
        return a.json() == b.json();
    }

    /// Calls `use` with what it holds: a text, a span of values, or std::monostate.
    template <typename Use> decltype(auto) visit(Use&& use) const {
        return form_ == Form::text ? use(std::string_view(static_cast<const char*>(data_), size_))
               : form_ == Form::values
                   ? use(std::span<const Value>(static_cast<const Value*>(data_), size_))
                   : use(std::monostate());
    }

private:
    enum class Form : std::uint8_t { absent, text, values };

    const void* data_ = nullptr;
    std::uint32_t size_ = 0; ///< bytes of the text, or values
    Form form_ = Form::absent;
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
