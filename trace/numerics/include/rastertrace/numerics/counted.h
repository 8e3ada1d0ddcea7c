// SPDX-License-Identifier: MIT
#pragma once

// Numbers that count what is done with them. An algorithm that is a template over its numbers runs on
// them as it is, so what is counted is what it does.
//
//     Work work;
//     {
//         const Counting counting(work);
//         Edge<Counted<double>> edge = edge_between(...);
//     }
//     work.divides;  // 1

#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/fraction.h>

#include <compare>
#include <concepts>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

namespace rastertrace {

/// What was done, in operations on the numbers that the method calculates with: those of exact
/// numbers are operations on numerators and denominators, or on rationals.
struct Work {
    std::uint64_t adds = 0; ///< and subtractions
    std::uint64_t multiplies = 0;
    std::uint64_t divides = 0;     ///< and remainders
    std::uint64_t comparisons = 0; ///< of numbers of the method's kind
    std::uint64_t pixels_tested = 0;
    /// Of `adaptive`: pieces, and depth tests of pixels, that took exact numbers.
    std::uint64_t exact_fallbacks = 0;
    bool has_operations = true; ///< false where the operations, the first four, were not counted

    friend bool operator==(const Work&, const Work&) = default;
};

/// While it lives, Counted numbers of this thread add to a Work. A number has no room for a pointer
/// to its tally: it would not be calculated with as the number itself is.
class Counting {
public:
    explicit Counting(Work& work) : before_(std::exchange(tally_, &work)) {}
    Counting(const Counting&) = delete;
    Counting& operator=(const Counting&) = delete;
    ~Counting() { tally_ = before_; }

    static void count(std::uint64_t Work::*kind) {
        if (tally_ != nullptr)
            ++(tally_->*kind);
    }

private:
    inline static thread_local Work* tally_ = nullptr;
    Work* before_;
};

/// What `run` does with numbers that count, in so many pixels.
template <typename Run> Work work_of(Run&& run, std::uint64_t pixels_tested = 0) {
    Work work;
    const Counting counting(work);
    run();
    work.pixels_tested = pixels_tested;
    return work;
}

/// Whole numbers: indices, numerators, denominators.
template <typename T>
concept Whole = std::integral<T> || std::same_as<T, Int128>;

/// A T that counts. Negation and rounding are not counted: they move no digits.
template <typename T> class Counted {
public:
    Counted() = default;
    Counted(const T& value) : value_(value) {} // NOLINT: it is the number
    /// From another kind of number: a count, an index.
    template <typename U>
    requires(std::is_arithmetic_v<U> && !std::same_as<U, T>) Counted(U value)
        : value_(static_cast<T>(value)) {} // NOLINT: numbers are written as numbers

    const T& value() const { return value_; }

    template <typename U>
    requires std::is_arithmetic_v<U>
    explicit operator U() const { return static_cast<U>(value_); }

    friend Counted operator-(const Counted& a) { return T(-a.value_); }
    friend Counted operator+(const Counted& a, const Counted& b) {
        Counting::count(&Work::adds);
        return T(a.value_ + b.value_);
    }
    friend Counted operator-(const Counted& a, const Counted& b) {
        Counting::count(&Work::adds);
        return T(a.value_ - b.value_);
    }
    friend Counted operator*(const Counted& a, const Counted& b) {
        Counting::count(&Work::multiplies);
        return T(a.value_ * b.value_);
    }
    friend Counted operator/(const Counted& a, const Counted& b) {
        Counting::count(&Work::divides);
        return T(a.value_ / b.value_);
    }
    friend Counted operator%(const Counted& a, const Counted& b) requires Whole<T> {
        Counting::count(&Work::divides);
        return T(a.value_ % b.value_);
    }
    friend Counted operator&(const Counted& a, const Counted& b) requires Whole<T> {
        return T(a.value_ & b.value_);
    }
    friend Counted operator>>(const Counted& a, int bits) requires Whole<T> {
        return T(a.value_ >> bits);
    }
    Counted& operator+=(const Counted& b) { return *this = *this + b; }
    Counted& operator-=(const Counted& b) { return *this = *this - b; }

    friend bool operator==(const Counted& a, const Counted& b) {
        Counting::count(&Work::comparisons);
        return a.value_ == b.value_;
    }
    friend bool operator<(const Counted& a, const Counted& b) {
        Counting::count(&Work::comparisons);
        return a.value_ < b.value_;
    }
    friend bool operator>(const Counted& a, const Counted& b) { return b < a; }
    friend bool operator<=(const Counted& a, const Counted& b) { return !(b < a); }
    friend bool operator>=(const Counted& a, const Counted& b) { return !(a < b); }
    friend std::strong_ordering operator<=>(const Counted& a, const Counted& b) requires Whole<T> {
        Counting::count(&Work::comparisons);
        return a.value_ <=> b.value_;
    }

private:
    T value_{};
};

/// Rounding asks the number itself.
template <typename T> struct NumberTraits<Counted<T>> : PlainNumber<Counted<T>> {
    static Index floor(const Counted<T>& x) { return floor_index(x.value()); }
};

/// Depths of what is drawn in fractions are doubles, counted or not: the nearest ones.
template <typename T> struct NumberTraits<Fraction<Counted<T>>> : FractionNumber<Counted<T>> {
    using Depth = Counted<double>;
    static Depth depth(const Fraction<Counted<T>>& x) {
        return to_double(Fraction<T>{x.numerator.value(), x.denominator.value()});
    }
};

/// The type that counts what is done in numbers of type Scalar. Fractions count what is done to
/// their numerators and denominators.
template <typename Scalar> struct CountedType { using type = Counted<Scalar>; };
template <typename Integer> struct CountedType<Fraction<Integer>> {
    using type = Fraction<Counted<Integer>>;
};
template <typename Scalar> using CountedOf = typename CountedType<Scalar>::type;

/// A number that counts, of this value.
template <typename Scalar> CountedOf<Scalar> as_counted(const Scalar& value) {
    return value;
}
template <typename Integer> Fraction<Counted<Integer>> as_counted(const Fraction<Integer>& value) {
    return {value.numerator, value.denominator};
}

} // namespace rastertrace
