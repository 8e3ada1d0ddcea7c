// SPDX-License-Identifier: MIT
#include <rastertrace/core/numbers/quantity.h>

#include <array>
#include <charconv>

namespace rastertrace {

double Quantity::to_double() const {
    return visit([](const auto& number) { return rastertrace::to_double(number); });
}

Rational Quantity::exact() const {
    return visit([]<typename Scalar>(const Scalar& number) -> Rational {
        if constexpr (is_fraction<Scalar>)
            return rastertrace::exact(number);
        else
            return Rational(number);
    });
}

std::string Quantity::text() const {
    return visit([]<typename Scalar>(const Scalar& number) -> std::string {
        if constexpr (is_fraction<Scalar>) {
            return rastertrace::exact(number).get_str();
        } else if constexpr (std::same_as<Scalar, Rational>) {
            return number.get_str();
        } else {
            std::array<char, 32> text{};
            const Scalar shown = number == 0 ? 0 : number; // without the sign of -0
            const auto end = std::to_chars(text.data(), text.data() + text.size(), shown);
            return {text.data(), end.ptr};
        }
    });
}

} // namespace rastertrace
