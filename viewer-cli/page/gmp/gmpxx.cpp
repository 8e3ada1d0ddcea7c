// SPDX-License-Identifier: MIT
#include "gmpxx.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

// Whole numbers.

mpz_class::mpz_class(const std::string& decimal, int) {
    // A 0 in front would mean octal digits.
    const bool is_negative = decimal.starts_with('-');
    const std::size_t first = decimal.find_first_not_of('0', is_negative ? 1 : 0);
    number_ = first == std::string::npos ? Number(0) : Number(decimal.substr(first));
    if (is_negative)
        number_ = -number_;
}

mpz_class::mpz_class(const mpq_class& value) : mpz_class(value.get_num() / value.get_den()) {}

double mpz_class::get_d() const {
    long exponent = 0;
    const double significand = mpz_get_d_2exp(&exponent, this);
    return std::scalbln(significand, exponent);
}

bool mpz_class::fits_slong_p() const {
    using Limits = std::numeric_limits<std::int64_t>;
    return Limits::min() <= number_ && number_ <= Limits::max();
}

bool operator==(const mpz_class& a, double b) {
    return std::trunc(b) == b && a == mpz_class(b);
}

// Fractions.

mpq_class::mpq_class(double value) {
    if (!std::isfinite(value))
        throw std::domain_error("no fraction is infinite");
    // The significand is a whole number of 53 bits.
    int exponent = 0;
    const double significand = std::frexp(value, &exponent);
    above_ = static_cast<std::int64_t>(std::ldexp(significand, 53));
    exponent -= 53;
    (exponent >= 0 ? above_ : below_) *= mpz_class(1)
                                         << static_cast<mp_bitcnt_t>(std::abs(exponent));
    canonicalize();
}

void mpq_class::canonicalize() {
    if (sgn(below_) == 0)
        throw std::domain_error("division by zero");
    const mpz_class divisor = gcd(above_, below_) * sgn(below_);
    if (divisor != 1) {
        above_ /= divisor;
        below_ /= divisor;
    }
}

std::string mpq_class::get_str() const {
    return below_ == 1 ? above_.get_str() : above_.get_str() + "/" + below_.get_str();
}

double mpq_class::get_d() const {
    if (sgn(above_) == 0)
        return 0;
    // A quotient of 64 or 65 bits; what is cut off with the rest lies toward 0.
    const auto shift =
        static_cast<std::int64_t>(below_.bits()) - static_cast<std::int64_t>(above_.bits()) + 64;
    const mpz_class quotient = shift >= 0 ? (above_ << static_cast<mp_bitcnt_t>(shift)) / below_
                                          : above_ / (below_ << static_cast<mp_bitcnt_t>(-shift));
    long exponent = 0;
    double significand = mpz_get_d_2exp(&exponent, &quotient);
    exponent -= static_cast<long>(shift);
    // A double near to 0 has fewer bits: these are cut off too.
    constexpr long least = std::numeric_limits<double>::min_exponent;
    if (exponent < least) {
        const int bits = 53 - static_cast<int>(std::min(least - exponent, 53L));
        significand = std::ldexp(std::trunc(std::ldexp(significand, bits)), -bits);
    }
    return std::scalbln(significand, exponent);
}

int cmp(const mpq_class& a, const mpq_class& b) {
    return a.below_ == b.below_ ? cmp(a.above_, b.above_)
                                : cmp(a.above_ * b.below_, b.above_ * a.below_);
}

mpq_class operator+(const mpq_class& a, const mpq_class& b) {
    mpq_class result = a.below_ == b.below_ ? mpq_class(a.above_ + b.above_, a.below_)
                                            : mpq_class(a.above_ * b.below_ + b.above_ * a.below_,
                                                        a.below_ * b.below_);
    if (result.below_ != 1)
        result.canonicalize();
    return result;
}

mpq_class operator-(const mpq_class& a, const mpq_class& b) {
    return a + -b;
}

mpq_class operator*(const mpq_class& a, const mpq_class& b) {
    mpq_class result(a.above_ * b.above_, a.below_ * b.below_);
    if (result.below_ != 1)
        result.canonicalize();
    return result;
}

mpq_class operator/(const mpq_class& a, const mpq_class& b) {
    mpq_class result(a.above_ * b.below_, a.below_ * b.above_);
    result.canonicalize();
    return result;
}

// Functions of GMP's C interface.

void mpz_fdiv_q(mpz_class* quotient, const mpz_class* above, const mpz_class* below) {
    const mpz_class rest = *above % *below;
    const int too_large = sgn(rest) * sgn(*below) < 0 ? 1 : 0;
    *quotient = *above / *below - too_large;
}

void mpz_cdiv_q(mpz_class* quotient, const mpz_class* above, const mpz_class* below) {
    const mpz_class negative = -*above;
    mpz_fdiv_q(quotient, &negative, below);
    *quotient = -*quotient;
}

std::uint64_t mpz_fdiv_ui(const mpz_class* above, std::uint64_t below) {
    const mpz_class rest = *above % below;
    return mpz_class(sgn(rest) < 0 ? rest + below : rest).get_ui();
}

mp_bitcnt_t mpz_remove(mpz_class* result, const mpz_class* from, const mpz_class* factor) {
    const mpz_class divisor = *factor;
    mpz_class rest = *from;
    mp_bitcnt_t count = 0;
    for (; sgn(rest) != 0 && sgn(rest % divisor) == 0; ++count)
        rest /= divisor;
    *result = std::move(rest);
    return count;
}

std::size_t mpz_sizeinbase(const mpz_class* number, int base) {
    const mp_bitcnt_t bits = std::max<mp_bitcnt_t>(number->bits(), 1);
    if (base == 2)
        return static_cast<std::size_t>(bits);
    // The logarithm of 2, as GMP has it: times 2^64, rounded down.
    const mpz_class logarithm_of_2 = std::uint64_t{0x4d104d427de7fbcc};
    return static_cast<std::size_t>(mpz_class((logarithm_of_2 * bits) >> 64).get_ui()) + 1;
}

bool mpz_perfect_square_p(const mpz_class* number) {
    if (sgn(*number) < 0)
        return false;
    const mpz_class root = sqrt(*number);
    return root * root == *number;
}

double mpz_get_d_2exp(long* exponent, const mpz_class* number) {
    // The highest 53 bits are a double.
    const mp_bitcnt_t bits = number->bits();
    const mpz_class size = abs(*number);
    const mpz_class highest = bits > 53 ? size >> (bits - 53) : size;
    int of_highest = 0;
    const double significand = std::frexp(static_cast<double>(highest.get_si()), &of_highest);
    *exponent = static_cast<long>(bits);
    return sgn(*number) < 0 ? -significand : significand;
}
