// SPDX-License-Identifier: MIT
#include "step_decoder.h"

#include "field_type.h"
#include "trace.h"

#include <rastertrace/trace/text/json_scanner.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <variant>

namespace rastertrace {

namespace {

/// Of so many digits, every number fits an Index.
constexpr std::ptrdiff_t most_digits_of_index = 18;

constexpr std::uint64_t in_each_byte(std::uint64_t byte) {
    return byte * 0x0101'0101'0101'0101;
}

/// The high bit of each byte that is no digit.
std::uint64_t no_digits_in(std::uint64_t bytes) {
    // '0' to '9' are 0x30 to 0x39: below, the subtraction borrows; above, the sum carries. Only the first such byte is
    // asked for, and none before it borrows or carries into it.
    return ((bytes - in_each_byte('0')) | (bytes + in_each_byte(0x7F - '9')) | bytes) &
           in_each_byte(0x80);
}

/// The high bit of each byte that a plain string does not have: a quotation mark, an escape, a control character, a
/// part of a character beyond ASCII. Exact up to the first of them.
std::uint64_t no_plain_text_in(std::uint64_t bytes) {
    const auto zeros_in = [](std::uint64_t word) { return (word - in_each_byte(1)) & ~word; };
    return (zeros_in(bytes ^ in_each_byte('"')) | zeros_in(bytes ^ in_each_byte('\\')) |
            (bytes - in_each_byte(0x20)) | bytes) &
           in_each_byte(0x80);
}

constexpr bool is_plain(unsigned char byte) {
    return 0x20 <= byte && byte < 0x80 && byte != '"' && byte != '\\';
}

/// The first of eight bytes has to be the lowest of the word.
constexpr bool looks_at_eight = std::endian::native == std::endian::little;

std::uint64_t eight_bytes_at(const char* text) {
    std::uint64_t bytes;
    std::memcpy(&bytes, text, sizeof bytes);
    return bytes;
}

/// Where the digits at the front of a text end. Always inlined: most of a trace is digits.
[[gnu::always_inline]] inline const char* end_of_digits(const char* at, const char* end) {
    while (looks_at_eight && end - at >= 8) {
        const std::uint64_t others = no_digits_in(eight_bytes_at(at));
        if (others != 0)
            return at + std::countr_zero(others) / 8;
        at += 8;
    }
    return at + count_digits_one_by_one({at, static_cast<std::size_t>(end - at)});
}

/// The place in the text that is decoded. Each take_... goes on if it finds what it looks for; else the step is left to
/// the reader of JSON, and it does not matter where the cursor is.
class Cursor {
public:
    explicit Cursor(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

    const char* at() const { return at_; }

    bool take(char c) {
        if (at_ == end_ || *at_ != c)
            return false;
        ++at_;
        return true;
    }

    /// Always inlined: a literal of known size is compared without a call of memcmp.
    [[gnu::always_inline]] bool take(std::string_view literal) {
        if (static_cast<std::size_t>(end_ - at_) < literal.size() ||
            std::memcmp(at_, literal.data(), literal.size()) != 0)
            return false;
        at_ += literal.size();
        return true;
    }

    /// Passes digits and tells how many there were.
    std::size_t pass_digits() {
        const char* const begin = std::exchange(at_, end_of_digits(at_, end_));
        return static_cast<std::size_t>(at_ - begin);
    }

    /// Takes a string in quotes that says what stands in it.
    bool take_plain_string() {
        if (!take('"'))
            return false;
        while (looks_at_eight && end_ - at_ >= 8) {
            const std::uint64_t others = no_plain_text_in(eight_bytes_at(at_));
            if (others != 0) {
                at_ += std::countr_zero(others) / 8;
                return take('"');
            }
            at_ += 8;
        }
        while (at_ != end_ && is_plain(static_cast<unsigned char>(*at_)))
            ++at_;
        return take('"');
    }

    /// Takes digits that a number may begin with: 0, or others that do not begin with it.
    bool take_whole_part() { return take('0') || pass_digits() > 0; }

    /// The same, with what they say. False if they are too many for an Index.
    bool take_whole(Index& value) {
        const char* const begin = at_;
        value = 0;
        if (take('0'))
            return true;
        for (; at_ != end_ && '0' <= *at_ && *at_ <= '9'; ++at_) {
            if (at_ - begin == most_digits_of_index)
                return false;
            value = 10 * value + (*at_ - '0');
        }
        return at_ != begin;
    }

private:
    const char* at_;
    const char* end_;
};

bool take_value(Cursor& text, Index& value, FieldNeed /*need*/) {
    const bool is_negative = text.take('-');
    Index magnitude = 0;
    if (!text.take_whole(magnitude))
        return false;
    value = is_negative ? -magnitude : magnitude;
    return magnitude <= farthest_index + 1 && !(is_negative && magnitude == 0);
}

bool take_value(Cursor& text, std::optional<Index>& value, FieldNeed need) {
    return take_value(text, value.emplace(), need);
}

/// 25/8 or 3, without quotes.
bool take_fraction(Cursor& text) {
    text.take('-');
    return text.take_whole_part() &&
           (!text.take('/') || (!text.take('0') && text.pass_digits() > 0));
}

bool take_decimal(Cursor& text) {
    const char* const begin = text.at();
    text.take('-');
    if (!text.take_whole_part() || (text.take('.') && text.pass_digits() == 0))
        return false;
    bool may_be_large = text.at() - begin > static_cast<std::ptrdiff_t>(longest_plain_number);
    if (text.take('e')) {
        const bool is_small = text.take('-');
        if (!is_small)
            text.take('+');
        const std::size_t digits = text.pass_digits();
        if (digits == 0)
            return false;
        may_be_large = may_be_large || (!is_small && digits > longest_plain_exponent);
    }
    return !may_be_large;
}

bool take_value(Cursor& text, TracedNumber& value, FieldNeed need) {
    const char* const begin = text.at();
    const bool is_number =
        text.take('"') ? take_fraction(text) && text.take('"')
                       : take_decimal(text) || (need == FieldNeed::or_null && text.take("null"));
    value = TracedNumber(std::string_view(begin, static_cast<std::size_t>(text.at() - begin)));
    return is_number;
}

bool take_value(Cursor& text, TracedFlag& value, FieldNeed /*need*/) {
    const char* const begin = text.at();
    const bool is_flag = text.take("true") || text.take("false");
    value = TracedFlag(std::string_view(begin, static_cast<std::size_t>(text.at() - begin)));
    return is_flag;
}

/// #rrggbb or #rrggbbaa.
bool take_value(Cursor& text, TracedColor& value, FieldNeed /*need*/) {
    const char* const begin = text.at();
    if (!text.take_plain_string())
        return false;
    const std::string_view json(begin, static_cast<std::size_t>(text.at() - begin));
    value = TracedColor(json);
    const std::string_view digits = json.substr(2, json.size() - 3);
    return json[1] == '#' && (digits.size() == 6 || digits.size() == 8) &&
           digits.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
}

/// A name, or the word of an enumeration.
template <typename Text> bool take_value(Cursor& text, Text& value, FieldNeed /*need*/) {
    const char* const begin = text.at();
    const bool is_string = text.take_plain_string();
    value = Text({begin, static_cast<std::size_t>(text.at() - begin)});
    return is_string;
}

template <typename Value>
bool take_value(Cursor& text, TracedList<Value>& list, FieldNeed /*need*/) {
    const char* const begin = text.at();
    if (!text.take('['))
        return false;
    if (!text.take(']')) {
        Value value;
        do {
            if (!take_value(text, value, FieldNeed::none))
                return false;
        } while (text.take(','));
        if (!text.take(']'))
            return false;
    }
    list = TracedList<Value>(std::string_view(begin, static_cast<std::size_t>(text.at() - begin)));
    return true;
}

/// Takes a field if the text goes on with it. False if it has another value, or if the kind needs it.
template <typename Row, typename Step> bool take_field(Cursor& text, Step& step) {
    return text.take(front_of_field<Row>) ? take_value(text, Row::in(step), Row::need)
                                          : Row::need != FieldNeed::required;
}

template <typename Step, typename... Rows>
bool take_fields(Cursor& text, Step& step, FieldTable<Rows...> /*table*/) {
    return (take_field<Rows>(text, step) && ...) && text.take('}');
}

/// Takes what follows front_of_step.
template <typename Step> bool take_rest_of(Cursor& text, Step& step) {
    return text.take(step_names[static_cast<std::size_t>(Step::step_kind)]) && text.take('"') &&
           take_fields(text, step, typename Step::Fields{});
}

template <typename Step> bool take_rest_of_any(Cursor& text, AnyStep& step) {
    return take_rest_of(text, step.emplace<Step>());
}

void set(Index& value, std::string_view json) {
    value = whole_in(json).value_or(0);
}
void set(std::optional<Index>& value, std::string_view json) {
    value = whole_in(json);
}
template <typename Value> void set(Value& value, std::string_view json) {
    value = Value(json);
}

/// A step whatever its text looks like.
template <typename Step, typename... Rows>
Step step_in(std::string_view json, FieldTable<Rows...> /*table*/) {
    Step step;
    JsonScanner fields(json);
    while (fields.next_field()) {
        const auto set_if_named = [&](auto row) {
            const bool is_it = fields.key() == row.name;
            if (is_it)
                set(row.in(step), fields.value());
            return is_it;
        };
        (set_if_named(Rows{}) || ...);
    }
    return step;
}

/// A kind of step, found by two letters of its name.
struct KindOfStep {
    StepKind kind{};
    bool (*take)(Cursor& text, AnyStep& step) = nullptr;
};

constexpr std::size_t places_for_kinds = 64;
constexpr std::size_t place_of(char first, char third) {
    return (static_cast<std::size_t>(first) + static_cast<std::size_t>(third) * 6) %
           places_for_kinds;
}

template <std::size_t... kind> constexpr auto kinds_by_place(std::index_sequence<kind...> /*all*/) {
    std::array<KindOfStep, places_for_kinds> kinds{};
    const auto add = [&kinds](std::string_view name, KindOfStep one) {
        auto& place = kinds[place_of(name[0], name[2])];
        if (place.take != nullptr)
            throw "two kinds have one place";
        place = one;
    };
    (add(step_names[kind], {static_cast<StepKind>(kind),
                            take_rest_of_any<std::variant_alternative_t<kind, AnyStep>>}),
     ...);
    return kinds;
}

constexpr auto kinds = kinds_by_place(std::make_index_sequence<step_kinds>{});

} // namespace

std::size_t count_digits_one_by_one(std::string_view text) {
    std::size_t count = 0;
    while (count < text.size() && '0' <= text[count] && text[count] <= '9')
        ++count;
    return count;
}

std::size_t count_digits(std::string_view text) {
    const char* const end = end_of_digits(text.data(), text.data() + text.size());
    return static_cast<std::size_t>(end - text.data());
}

bool take_step(std::string_view& text, AnyStep& step) {
    constexpr std::size_t shortest_name = 3;
    Cursor rest(text);
    if (text.size() < front_of_step.size() + shortest_name || !rest.take(front_of_step))
        return false;
    const KindOfStep& kind = kinds[place_of(rest.at()[0], rest.at()[2])];
    if (kind.take == nullptr || !kind.take(rest, step))
        return false;
    text.remove_prefix(static_cast<std::size_t>(rest.at() - text.data()));
    return true;
}

namespace {

template <std::size_t... kind>
AnyStep step_in_text(std::string_view json, std::size_t wanted,
                     std::index_sequence<kind...> /*all*/) {
    AnyStep any;
    const auto read = [&any, json]<typename Step>(Step) {
        any = step_in<Step>(json, typename Step::Fields{});
        return true;
    };
    static_cast<void>(
        ((kind == wanted && read(std::variant_alternative_t<kind, AnyStep>{})) || ...));
    return any;
}

} // namespace

AnyStep step_in_text(std::string_view json, StepKind kind) {
    return step_in_text(json, static_cast<std::size_t>(kind),
                        std::make_index_sequence<step_kinds>{});
}

} // namespace rastertrace
