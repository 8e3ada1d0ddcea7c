// SPDX-License-Identifier: MIT
#pragma once

// A number of a step, whatever Scalar the scene is drawn with.
//
//     [](const ScanlineSpanned<>& step) { step.left.to_double(); step.left.text(); }

#include <rastertrace/core/numbers/conversion.h>

#include <string>

namespace rastertrace {

/// A number as the algorithm had it. A Rational is referred to, not copied: a Quantity is valid
/// during the call that it is handed to. `exact()` and `to_double()` are values to keep.
class Quantity {
public:
    Quantity() = default;
    Quantity(float value) : held_(value) {}             // NOLINT: a number is a quantity
    Quantity(double value) : held_(value) {}            // NOLINT
    Quantity(const Fraction64& value) : held_(value) {} // NOLINT
    Quantity(const Rational& value) : held_(&value) {}  // NOLINT
    Quantity(Rational&&) = delete;                      // the reference would dangle

    /// The nearest double.
    double to_double() const;

    /// The number itself. It must be finite.
    Rational exact() const;

    /// As a trace writes it, without quotes: "3.125", or "25/8" where fractions are drawn with.
    std::string text() const;

    /// The number if it is a Rational, else null.
    const Rational* rational() const {
        const auto* const held = std::get_if<const Rational*>(&held_);
        return held ? *held : nullptr;
    }

    /// Calls `use` with the number in its own type.
    template <typename Use> decltype(auto) visit(Use&& use) const {
        // Doubles are the most frequent, and need no table.
        if (const auto* const number = std::get_if<double>(&held_))
            return use(*number);
        return std::visit(
            [&use]<typename Held>(const Held& held) -> decltype(auto) {
                if constexpr (std::same_as<Held, const Rational*>)
                    return use(*held);
                else
                    return use(held);
            },
            held_);
    }

    /// True if both are the same number, of whatever type.
    friend bool operator==(const Quantity& a, const Quantity& b) { return a.exact() == b.exact(); }

private:
    std::variant<double, float, Fraction64, const Rational*> held_;
};

inline double to_double(const Quantity& quantity) {
    return quantity.to_double();
}

} // namespace rastertrace
