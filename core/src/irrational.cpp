// SPDX-License-Identifier: MIT
#include <rastertrace/core/numbers/irrational.h>

#include <rastertrace/core/numbers/number.h>

#include <algorithm>

namespace rastertrace {

mpq_class quotient_of(const mpz_class& above, const mpz_class& below) {
    mpq_class quotient(above, below);
    quotient.canonicalize();
    return quotient;
}

namespace {

/// Numbers below are whole multiples of 2^-bits. With most_bits, the smallest double still has 600.
constexpr unsigned most_bits = 1728;

mpz_class fixed_one(unsigned bits) {
    return mpz_class(1) << bits;
}

/// arctan(1/n) = 1/n - 1/(3 n^3) + 1/(5 n^5) - ...
mpz_class arctangent_of_inverse(unsigned long n) {
    mpz_class power = fixed_one(most_bits) / n;
    mpz_class sum = power;
    for (unsigned long i = 3; power != 0; i += 2) {
        power /= -static_cast<long>(n * n);
        sum += power / i;
    }
    return sum;
}

/// Machin's formula: pi = 16 arctan(1/5) - 4 arctan(1/239). A multiple of 2^-most_bits.
const mpz_class& fixed_pi() {
    static const mpz_class pi = 16 * arctangent_of_inverse(5) - 4 * arctangent_of_inverse(239);
    return pi;
}

/// The sum of first, first * -x^2/(i (i + 1)), ...: the series of the cosine (first = 1, i = 1) and
/// of the sine (first = x, i = 2).
mpz_class alternating_series(const mpz_class& first, const mpz_class& x, unsigned long i,
                             unsigned bits) {
    mpz_class term = first;
    mpz_class sum = first;
    for (; term != 0; i += 2) {
        term = (((term * x) >> bits) * x) >> bits;
        term /= -static_cast<long>(i * (i + 1));
        sum += term;
    }
    return sum;
}

/// So many bits that the smaller of sine and cosine of a share of a quarter turn has enough of them.
unsigned bits_for(const mpq_class& share, RootDigits digits) {
    constexpr unsigned in_limb = 64;
    const unsigned needed = digits == RootDigits::many ? many_binary_digits + in_limb : 256;
    const mpq_class smaller = std::min(share, mpq_class(1 - share));
    const auto size = [](const mpz_class& whole) {
        return static_cast<unsigned>(mpz_sizeinbase(whole.get_mpz_t(), 2));
    };
    const unsigned above = size(smaller.get_num());
    const unsigned below = size(smaller.get_den());
    const unsigned zeros = sgn(smaller) == 0 || below < above ? 0 : below - above;
    return std::min(most_bits, (needed + zeros + in_limb - 1) / in_limb * in_limb);
}

/// The sine of an angle: exact where it is a fraction (0, 1/2, 1 and their opposites), else with more bits than are
/// asked for.
mpq_class sine(const mpq_class& degrees, RootDigits digits) {
    // Quarter turns are taken off exactly; an angle from 0 to 90 degrees is left.
    mpz_class quarters;
    const mpq_class in_quarters = degrees / 90;
    mpz_fdiv_q(quarters.get_mpz_t(), in_quarters.get_num_mpz_t(), in_quarters.get_den_mpz_t());
    const mpq_class rest = in_quarters - quarters;
    const auto quadrant = mpz_fdiv_ui(quarters.get_mpz_t(), 4);
    const bool is_cosine = quadrant % 2 != 0;    // of the rest
    if (rest == mpq_class(is_cosine ? 2 : 1, 3)) // the sine of 30 degrees, the cosine of 60
        return {quadrant < 2 ? 1 : -1, 2};
    const unsigned bits = bits_for(rest, digits);
    const mpz_class pi = fixed_pi() >> (most_bits - bits);
    const mpz_class radians = pi * rest.get_num() / (2 * rest.get_den());

    const mpz_class size = is_cosine ? alternating_series(fixed_one(bits), radians, 1, bits)
                                     : alternating_series(radians, radians, 2, bits);
    return quotient_of(quadrant < 2 ? size : mpz_class(-size), fixed_one(bits));
}

mpq_class rounded_to(RootDigits digits, const mpq_class& number) {
    return digits == RootDigits::many ? number : mpq_class(nearest_double(number));
}

} // namespace

bool is_quarter_turn(const mpq_class& degrees) {
    return mpq_class(degrees / 90).get_den() == 1;
}

mpq_class sine_of_degrees(const mpq_class& degrees, RootDigits digits) {
    return rounded_to(digits, sine(degrees, digits));
}

mpq_class cosine_of_degrees(const mpq_class& degrees, RootDigits digits) {
    return sine_of_degrees(degrees + 90, digits);
}

mpq_class cotangent_of_degrees(const mpq_class& degrees, RootDigits digits) {
    return rounded_to(digits, sine(degrees + 90, digits) / sine(degrees, digits));
}

mpq_class pi() {
    return quotient_of(fixed_pi(), fixed_one(most_bits));
}

bool has_rational_root(const mpq_class& square) {
    return mpz_perfect_square_p(square.get_num_mpz_t()) != 0 &&
           mpz_perfect_square_p(square.get_den_mpz_t()) != 0;
}

mpq_class square_root(const mpq_class& square, RootDigits digits) {
    if (has_rational_root(square))
        return {sqrt(square.get_num()), sqrt(square.get_den())};

    // In units so small that the root has twice the bits that are needed, and is rounded once.
    const long needed = digits == RootDigits::many ? 2L * many_binary_digits : 128;
    const auto bits = [](const mpz_class& whole) {
        return static_cast<long>(mpz_sizeinbase(whole.get_mpz_t(), 2));
    };
    const long shift = std::max(needed + (bits(square.get_den()) - bits(square.get_num())) / 2, 0L);
    const auto scale = static_cast<mp_bitcnt_t>(shift);
    const mpz_class root = sqrt(mpz_class((square.get_num() << 2 * scale) / square.get_den()));
    return rounded_to(digits, quotient_of(root, mpz_class(1) << scale));
}

} // namespace rastertrace
