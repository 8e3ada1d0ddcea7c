// SPDX-License-Identifier: MIT
#include <rastertrace/core/numbers/quantity.h>

#include <array>
#include <charconv>

namespace rastertrace {

namespace {

std::string shortest(std::floating_point auto value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value == 0 ? 0 : value);
    return {text.data(), end.ptr};
}

} // namespace

double Quantity::to_double() const {
    return visit([](const auto& number) { return rastertrace::to_double(number); });
}

Rational Quantity::exact() const {
    return visit([]<typename Scalar>(const Scalar& number) -> Rational {
        if constexpr (std::same_as<Scalar, Rational>)
            return number;
        else if constexpr (std::floating_point<Scalar>)
            return Rational(static_cast<double>(number));
        else
            return rastertrace::exact(number);
    });
}

std::string Quantity::text() const {
    return visit([]<typename Scalar>(const Scalar& number) -> std::string {
        if constexpr (std::same_as<Scalar, Rational>)
            return number.get_str();
        else if constexpr (std::floating_point<Scalar>)
            return shortest(number);
        else
            return rastertrace::exact(number).get_str();
    });
}

} // namespace rastertrace
