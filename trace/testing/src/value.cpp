// SPDX-License-Identifier: MIT
#include <rastertrace/testing.h>

#include <array>
#include <charconv>
#include <concepts>
#include <cstddef>
#include <utility>
#include <variant>

namespace rastertrace::matchers {

namespace {

/// The shortest decimal that reads back as this number.
template <std::floating_point Float> std::string shortest(Float number) {
    constexpr std::size_t longest = 32; // 17 digits, signs, point and exponent
    std::array<char, longest> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
    return {buffer.data(), end.ptr};
}

std::optional<Number> number_in(const std::string& text) {
    auto parsed = parse_number(text, NumberSize::any);
    if (auto* const number = std::get_if<Number>(&parsed))
        return std::move(*number);
    return std::nullopt;
}

} // namespace

Value::Value(double number) : text_(shortest(number)) {}

Value::Value(float number) : text_(shortest(number)) {}

std::string Value::text() const {
    return tolerance_ > 0 ? text_ + " +- " + shortest(tolerance_) : text_;
}

std::optional<Number> Value::number() const {
    return number_in(text_);
}

bool Value::is(const std::string& told) const {
    const auto expected = number();
    const auto found = number_in(told);
    return expected && found && abs(found->exact() - expected->exact()) <= mpq_class(tolerance_);
}

Value about(Value value, double tolerance) {
    value.tolerance_ = tolerance;
    return value;
}

} // namespace rastertrace::matchers
