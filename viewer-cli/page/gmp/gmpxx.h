// SPDX-License-Identifier: MIT
#pragma once

// The part of GMP's <gmpxx.h> that rastertrace uses, for the WebAssembly module: there is no GMP there.
// The whole numbers are Boost.Multiprecision's. Names, arguments and results are those of GMP's manual;
// `long` has 64 bits here, as it has where GMP is used.
//
//     const mpq_class slope(3, 4);
//     mpq_class(slope * 2 - 5).get_str()   // -7/2

#include <boost/multiprecision/cpp_int.hpp>

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

using mp_bitcnt_t = std::uint64_t;

/// A whole number of any size. Up to 256 bits take no memory elsewhere.
class mpz_class {
    using Number = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<256>,
                                                 boost::multiprecision::et_off>;

public:
    mpz_class() = default;
    template <std::integral Integer> mpz_class(Integer value) : number_(value) {} // NOLINT
    /// Decimal digits, with a `-` in front or not; nothing else is looked at.
    explicit mpz_class(const std::string& decimal, int base = 10);
    /// The fraction is cut off.
    explicit mpz_class(double value) : number_(value) {}
    explicit mpz_class(const class mpq_class& value);

    const mpz_class* get_mpz_t() const { return this; }
    mpz_class* get_mpz_t() { return this; }

    std::string get_str() const { return number_.str(); }
    double get_d() const; ///< rounded toward 0
    /// True if the number has a place in 64 bits, with its sign.
    bool fits_slong_p() const;
    /// The number, if it has.
    std::int64_t get_si() const { return static_cast<std::int64_t>(number_); }
    std::uint64_t get_ui() const { return static_cast<std::uint64_t>(number_); }

    friend mpz_class operator+(const mpz_class& a, const mpz_class& b) {
        return a.number_ + b.number_;
    }
    friend mpz_class operator-(const mpz_class& a, const mpz_class& b) {
        return a.number_ - b.number_;
    }
    friend mpz_class operator*(const mpz_class& a, const mpz_class& b) {
        return a.number_ * b.number_;
    }
    friend mpz_class operator/(const mpz_class& a, const mpz_class& b) {
        return a.number_ / b.number_;
    }
    friend mpz_class operator%(const mpz_class& a, const mpz_class& b) {
        return a.number_ % b.number_;
    }
    friend mpz_class operator<<(const mpz_class& a, mp_bitcnt_t bits) { return a.number_ << bits; }
    friend mpz_class operator>>(const mpz_class& a, mp_bitcnt_t bits) { return a.number_ >> bits; }
    friend mpz_class operator-(const mpz_class& a) { return -a.number_; }
    mpz_class& operator+=(const mpz_class& b) { return *this = *this + b; }
    mpz_class& operator-=(const mpz_class& b) { return *this = *this - b; }
    mpz_class& operator*=(const mpz_class& b) { return *this = *this * b; }
    mpz_class& operator/=(const mpz_class& b) { return *this = *this / b; }
    mpz_class& operator%=(const mpz_class& b) { return *this = *this % b; }
    mpz_class& operator++() { return *this += 1; }

    friend int cmp(const mpz_class& a, const mpz_class& b) { return a.number_.compare(b.number_); }
    friend std::strong_ordering operator<=>(const mpz_class& a, const mpz_class& b) {
        return cmp(a, b) <=> 0;
    }
    friend bool operator==(const mpz_class& a, const mpz_class& b) { return cmp(a, b) == 0; }
    friend bool operator==(const mpz_class& a, double b);

    friend int sgn(const mpz_class& a) { return a.number_.sign(); }
    friend mpz_class abs(const mpz_class& a) { return abs(a.number_); }
    friend mpz_class gcd(const mpz_class& a, const mpz_class& b) {
        return gcd(a.number_, b.number_);
    }
    friend mpz_class lcm(const mpz_class& a, const mpz_class& b) {
        return lcm(a.number_, b.number_);
    }
    friend mpz_class sqrt(const mpz_class& a) { return sqrt(a.number_); } ///< rounded down
    friend void mpz_ui_pow_ui(mpz_class* result, std::uint64_t base, unsigned exponent) {
        result->number_ = pow(Number(base), exponent);
    }

    /// How many binary digits the number has, without its sign; 0 for 0.
    mp_bitcnt_t bits() const { return number_ == 0 ? 0 : msb(abs(number_)) + mp_bitcnt_t{1}; }

private:
    mpz_class(Number number) : number_(std::move(number)) {} // NOLINT

    Number number_;
};

/// A fraction. Operators take and give fractions in lowest terms, with a denominator above 0.
class mpq_class {
public:
    mpq_class() = default;
    template <std::integral Integer> mpq_class(Integer value) : above_(value) {} // NOLINT
    mpq_class(mpz_class value) : above_(std::move(value)) {}                     // NOLINT
    mpq_class(double value);                                                     // NOLINT
    mpq_class(mpz_class above, mpz_class below)
        : above_(std::move(above)), below_(std::move(below)) {} ///< as they are; see canonicalize

    const mpz_class& get_num() const { return above_; }
    const mpz_class& get_den() const { return below_; }
    mpz_class& get_num() { return above_; }
    mpz_class& get_den() { return below_; }
    const mpz_class* get_num_mpz_t() const { return &above_; }
    const mpz_class* get_den_mpz_t() const { return &below_; }
    mpz_class* get_num_mpz_t() { return &above_; }
    mpz_class* get_den_mpz_t() { return &below_; }

    /// Brings the fraction to lowest terms.
    void canonicalize();

    std::string get_str() const; ///< `25/8`, `3`
    double get_d() const;        ///< rounded toward 0

    friend mpq_class operator+(const mpq_class& a, const mpq_class& b);
    friend mpq_class operator-(const mpq_class& a, const mpq_class& b);
    friend mpq_class operator*(const mpq_class& a, const mpq_class& b);
    friend mpq_class operator/(const mpq_class& a, const mpq_class& b);
    friend mpq_class operator-(const mpq_class& a) { return {-a.above_, a.below_}; }
    mpq_class& operator+=(const mpq_class& b) { return *this = *this + b; }
    mpq_class& operator-=(const mpq_class& b) { return *this = *this - b; }
    mpq_class& operator*=(const mpq_class& b) { return *this = *this * b; }
    mpq_class& operator/=(const mpq_class& b) { return *this = *this / b; }

    friend int cmp(const mpq_class& a, const mpq_class& b);
    friend std::strong_ordering operator<=>(const mpq_class& a, const mpq_class& b) {
        return cmp(a, b) <=> 0;
    }
    friend bool operator==(const mpq_class& a, const mpq_class& b) = default;

    friend int sgn(const mpq_class& a) { return sgn(a.above_); }
    friend mpq_class abs(const mpq_class& a) { return {abs(a.above_), a.below_}; }

private:
    mpz_class above_;
    mpz_class below_ = 1;
};

// Functions of GMP's C interface. A result may be one of the arguments.

void mpz_fdiv_q(mpz_class* quotient, const mpz_class* above, const mpz_class* below);
void mpz_cdiv_q(mpz_class* quotient, const mpz_class* above, const mpz_class* below);
std::uint64_t mpz_fdiv_ui(const mpz_class* above, std::uint64_t below);
mp_bitcnt_t mpz_remove(mpz_class* result, const mpz_class* from, const mpz_class* factor);
/// For a base of 2 or 10; of 10 it may be 1 too large, as in GMP for others than powers of two.
std::size_t mpz_sizeinbase(const mpz_class* number, int base);
bool mpz_perfect_square_p(const mpz_class* number);
/// d and exponent with 1/2 <= |d| < 1: the number, rounded toward 0, is d x 2^exponent.
double mpz_get_d_2exp(long* exponent, const mpz_class* number);
