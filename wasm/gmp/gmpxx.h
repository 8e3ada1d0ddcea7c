// SPDX-License-Identifier: MIT
#pragma once

// The part of GMP's <gmpxx.h> that rastertrace uses, for the WebAssembly module: there is no GMP there.
// Whole numbers of any size, and fractions of them in lowest terms; digits of 32 bits, and the schoolbook's
// algorithms (Knuth, The Art of Computer Programming, volume 2, section 4.3.1). Names, arguments and results
// are those of GMP's manual; `long` has 64 bits here, as it has where GMP is used.
//
//     const mpq_class slope(3, 4);
//     mpq_class(slope * 2 - 5).get_str()   // -7/2

#include <algorithm>
#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using mp_bitcnt_t = std::uint64_t;

/// The digits of a whole number without its sign, the lowest first. Up to 256 bits take no memory elsewhere.
class mp_limbs_t {
public:
    mp_limbs_t() = default;
    explicit mp_limbs_t(std::size_t size) : size_(size), many_(size > few_.size() ? size : 0) {}
    mp_limbs_t(const mp_limbs_t&) = default;
    mp_limbs_t(mp_limbs_t&& other) noexcept { swap(other); }
    mp_limbs_t& operator=(const mp_limbs_t&) = default;
    mp_limbs_t& operator=(mp_limbs_t&& other) noexcept {
        swap(other);
        return *this;
    }

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    std::uint32_t* begin() { return many_.empty() ? few_.data() : many_.data(); }
    std::uint32_t* end() { return begin() + size_; }
    const std::uint32_t* begin() const { return many_.empty() ? few_.data() : many_.data(); }
    const std::uint32_t* end() const { return begin() + size_; }
    std::uint32_t& operator[](std::size_t i) { return begin()[i]; }
    std::uint32_t operator[](std::size_t i) const { return begin()[i]; }
    std::uint32_t back() const { return end()[-1]; }

    /// Keeps the lowest digits, and of these none that is 0 above all others.
    void keep(std::size_t size) {
        const std::uint32_t* const digits = begin();
        for (size_ = size; size_ > 0 && digits[size_ - 1] == 0;)
            --size_;
    }

    void swap(mp_limbs_t& other) noexcept {
        std::swap(size_, other.size_);
        std::swap(few_, other.few_);
        many_.swap(other.many_);
    }

    friend bool operator==(const mp_limbs_t& a, const mp_limbs_t& b) {
        return a.size_ == b.size_ && std::equal(a.begin(), a.end(), b.begin());
    }

private:
    std::size_t size_ = 0;
    std::array<std::uint32_t, 8> few_{};
    std::vector<std::uint32_t> many_; ///< all of them, if they are more; else empty
};

/// A whole number of any size.
class mpz_class {
public:
    mpz_class() = default;
    template <std::integral Integer>
    mpz_class(Integer value) : is_negative_(value < 0), digits_(2) { // NOLINT
        static_assert(sizeof value <= 8);
        const auto bits = static_cast<std::uint64_t>(value);
        const std::uint64_t size = is_negative_ ? 0 - bits : bits;
        digits_[0] = static_cast<std::uint32_t>(size);
        digits_[1] = static_cast<std::uint32_t>(size >> 32);
        digits_.keep(2);
    }
    /// Decimal digits, with a `-` in front or not; nothing else is looked at.
    explicit mpz_class(std::string_view decimal, int base = 10);
    explicit mpz_class(const std::string& decimal, int base = 10)
        : mpz_class(std::string_view(decimal), base) {}
    /// The fraction is cut off.
    explicit mpz_class(double value);
    explicit mpz_class(const class mpq_class& value);
    mpz_class(const mpz_class&) = default;
    mpz_class(mpz_class&& other) noexcept { swap(other); }
    mpz_class& operator=(const mpz_class&) = default;
    mpz_class& operator=(mpz_class&& other) noexcept {
        swap(other);
        return *this;
    }

    const mpz_class* get_mpz_t() const { return this; }
    mpz_class* get_mpz_t() { return this; }

    std::string get_str() const;
    double get_d() const; ///< rounded toward 0
    /// True if the number has a place in 64 bits, with its sign.
    bool fits_slong_p() const;
    /// The number, if it has.
    std::int64_t get_si() const;
    std::uint64_t get_ui() const { return static_cast<std::uint64_t>(get_si()); }

    void swap(mpz_class& other) noexcept {
        std::swap(is_negative_, other.is_negative_);
        digits_.swap(other.digits_);
    }

    friend mpz_class operator+(const mpz_class& a, const mpz_class& b);
    friend mpz_class operator-(const mpz_class& a, const mpz_class& b);
    friend mpz_class operator*(const mpz_class& a, const mpz_class& b);
    friend mpz_class operator/(const mpz_class& a, const mpz_class& b); ///< toward 0
    friend mpz_class operator%(const mpz_class& a, const mpz_class& b); ///< has the sign of `a`
    friend mpz_class operator<<(const mpz_class& a, mp_bitcnt_t bits);
    friend mpz_class operator>>(const mpz_class& a, mp_bitcnt_t bits); ///< rounds down
    friend mpz_class operator-(mpz_class a) {
        a.is_negative_ = !a.digits_.empty() && !a.is_negative_;
        return a;
    }
    mpz_class& operator+=(const mpz_class& b) { return *this = *this + b; }
    mpz_class& operator-=(const mpz_class& b) { return *this = *this - b; }
    mpz_class& operator*=(const mpz_class& b) { return *this = *this * b; }
    mpz_class& operator/=(const mpz_class& b) { return *this = *this / b; }
    mpz_class& operator%=(const mpz_class& b) { return *this = *this % b; }
    mpz_class& operator++() { return *this += 1; }

    friend std::strong_ordering operator<=>(const mpz_class& a, const mpz_class& b);
    friend bool operator==(const mpz_class& a, const mpz_class& b) = default;
    friend bool operator==(const mpz_class& a, double b);

    friend int sgn(const mpz_class& a) { return a.is_negative_ ? -1 : a.digits_.empty() ? 0 : 1; }
    friend mpz_class abs(mpz_class a) {
        a.is_negative_ = false;
        return a;
    }

    /// How many binary digits the number has, without its sign; 0 for 0.
    mp_bitcnt_t bits() const;

private:
    using Digits = mp_limbs_t;

    mpz_class(bool is_negative, Digits digits)
        : is_negative_(is_negative && !digits.empty()), digits_(std::move(digits)) {}

    /// Quotient toward 0, and rest; throws if `below` is 0.
    static std::pair<mpz_class, mpz_class> divided(const mpz_class& above, const mpz_class& below);

    static Digits sum(const Digits& a, const Digits& b);
    static Digits difference(const Digits& a, const Digits& b); ///< `a` must not be below `b`
    static Digits product(const Digits& a, const Digits& b);
    static std::strong_ordering order(const Digits& a, const Digits& b);
    static std::uint64_t low_64_bits(const Digits& digits);
    static std::uint32_t divide_by_digit(Digits& above, std::uint32_t below); ///< gives the rest
    static std::pair<Digits, Digits> quotient_and_rest(Digits above, Digits below);

    bool is_negative_ = false; ///< never of 0
    Digits digits_;
};

inline int cmp(const mpz_class& a, const mpz_class& b) {
    const auto order = a <=> b;
    return order < 0 ? -1 : order > 0 ? 1 : 0;
}
mpz_class gcd(mpz_class a, mpz_class b);
mpz_class lcm(const mpz_class& a, const mpz_class& b);
mpz_class sqrt(const mpz_class& a); ///< rounded down; `a` must not be negative

/// A fraction. Operators take and give fractions in lowest terms, with a denominator above 0.
class mpq_class {
public:
    mpq_class() = default;
    template <std::integral Integer> mpq_class(Integer value) : above_(value) {} // NOLINT
    mpq_class(mpz_class value) : above_(std::move(value)) {}                     // NOLINT
    mpq_class(double value);                                                     // NOLINT
    mpq_class(mpz_class above, mpz_class below)
        : above_(std::move(above)), below_(std::move(below)) {} ///< as they are; see canonicalize
    mpq_class(const mpq_class&) = default;
    mpq_class(mpq_class&& other) noexcept : mpq_class() { swap(other); }
    mpq_class& operator=(const mpq_class&) = default;
    mpq_class& operator=(mpq_class&& other) noexcept {
        swap(other);
        return *this;
    }

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

    void swap(mpq_class& other) noexcept {
        above_.swap(other.above_);
        below_.swap(other.below_);
    }

    friend mpq_class operator+(const mpq_class& a, const mpq_class& b);
    friend mpq_class operator-(const mpq_class& a, const mpq_class& b);
    friend mpq_class operator*(const mpq_class& a, const mpq_class& b);
    friend mpq_class operator/(const mpq_class& a, const mpq_class& b);
    friend mpq_class operator-(mpq_class a) {
        a.above_ = -std::move(a.above_);
        return a;
    }
    mpq_class& operator+=(const mpq_class& b) { return *this = *this + b; }
    mpq_class& operator-=(const mpq_class& b) { return *this = *this - b; }
    mpq_class& operator*=(const mpq_class& b) { return *this = *this * b; }
    mpq_class& operator/=(const mpq_class& b) { return *this = *this / b; }

    friend std::strong_ordering operator<=>(const mpq_class& a, const mpq_class& b);
    friend bool operator==(const mpq_class& a, const mpq_class& b) = default;

    friend int sgn(const mpq_class& a) { return sgn(a.above_); }
    friend mpq_class abs(mpq_class a) {
        a.above_ = abs(std::move(a.above_));
        return a;
    }

private:
    mpz_class above_;
    mpz_class below_ = 1;
};

inline int cmp(const mpq_class& a, const mpq_class& b) {
    const auto order = a <=> b;
    return order < 0 ? -1 : order > 0 ? 1 : 0;
}

// Functions of GMP's C interface. A result may be one of the arguments.

void mpz_ui_pow_ui(mpz_class* result, std::uint64_t base, std::uint64_t exponent);
void mpz_fdiv_q(mpz_class* quotient, const mpz_class* above, const mpz_class* below);
void mpz_cdiv_q(mpz_class* quotient, const mpz_class* above, const mpz_class* below);
std::uint64_t mpz_fdiv_ui(const mpz_class* above, std::uint64_t below);
mp_bitcnt_t mpz_remove(mpz_class* result, const mpz_class* from, const mpz_class* factor);
/// For a base of 2 or 10; of 10 it may be 1 too large, as in GMP for others than powers of two.
std::size_t mpz_sizeinbase(const mpz_class* number, int base);
bool mpz_perfect_square_p(const mpz_class* number);
/// d and exponent with 1/2 <= |d| < 1: the number, rounded toward 0, is d x 2^exponent.
double mpz_get_d_2exp(long* exponent, const mpz_class* number);
