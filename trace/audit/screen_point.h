// SPDX-License-Identifier: MIT
#pragma once

// Points of the screen as a trace gives them, exactly.
//
//     const Coordinate x(0.5), y(mpq_class(1, 3));
//     x < y;          // exact
//     y.nearest();    // 0.3333333333333333

#include <gmpxx.h>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <unordered_map>

namespace rastertrace {

/// A coordinate: nearly always a double, else a fraction.
class Coordinate {
public:
    Coordinate() = default;
    explicit Coordinate(double value) : nearest_(value) {}
    explicit Coordinate(const mpq_class& value);

    /// The nearest double; infinite for what is beyond all doubles.
    double nearest() const { return nearest_; }
    bool is_double() const { return !fraction_; }
    mpq_class exact() const { return fraction_ ? *fraction_ : mpq_class(nearest_); }

    friend std::strong_ordering operator<=>(const Coordinate& a, const Coordinate& b) {
        return a.nearest_ < b.nearest_          ? std::strong_ordering::less
               : a.nearest_ > b.nearest_        ? std::strong_ordering::greater
               : a.is_double() && b.is_double() ? std::strong_ordering::equal
                                                : cmp(a.exact(), b.exact()) <=> 0;
    }
    friend bool operator==(const Coordinate& a, const Coordinate& b) { return (a <=> b) == 0; }

private:
    double nearest_ = 0;
    std::shared_ptr<const mpq_class> fraction_; ///< of what is no double
};

/// An exact point of the screen, in the scene's coordinates.
struct ScreenPoint {
    Coordinate x;
    Coordinate y;

    /// The order of points along any line.
    friend auto operator<=>(const ScreenPoint&, const ScreenPoint&) = default;
};

/// Numbers points from 0 on: equal ones have the same number.
class PointNumbers {
public:
    std::uint32_t of(const ScreenPoint& point) {
        const auto next = static_cast<std::uint32_t>(numbers_.size());
        return numbers_.emplace(point, next).first->second;
    }

private:
    struct Hash {
        std::size_t operator()(const ScreenPoint& point) const {
            const std::hash<double> hash;
            constexpr std::size_t odd = 0x9E3779B1; // 2^32 over the golden ratio
            return (hash(point.x.nearest()) * odd) ^ hash(point.y.nearest());
        }
    };
    std::unordered_map<ScreenPoint, std::uint32_t, Hash> numbers_;
};

} // namespace rastertrace
