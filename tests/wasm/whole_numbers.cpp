// SPDX-License-Identifier: MIT
// Prints what <gmpxx.h> answers to random questions. It is compiled twice, with GMP and with the module's own
// viewer-cli/page/gmp/gmpxx.h, and both must print the same (same_output.sh).

#include "random_choice.h"

#include <gmpxx.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>

namespace {

using rastertrace::Random;

/// A whole number of 0 to 400 bits, often with long runs of equal bits: there long division goes its rare ways.
mpz_class whole_number(Random& random) {
    mpz_class number = 0;
    const int runs = random.whole(0, 20);
    for (int i = 0; i < runs; ++i) {
        const int length = random.whole(1, 20);
        const int bits = random.pick({0, (1 << length) - 1, random.whole(0, (1 << length) - 1)});
        number = (number << static_cast<unsigned>(length)) + bits;
    }
    return random.chance(2) ? mpz_class(-number) : number;
}

mpz_class divisor(Random& random) {
    const mpz_class number = whole_number(random);
    return number == 0 ? mpz_class(7) : number;
}

mpq_class fraction(Random& random) {
    const mpz_class above = whole_number(random);
    mpq_class value(above, divisor(random));
    value.canonicalize();
    return value;
}

void print(const char* what, const std::string& text) {
    std::printf("%s %s\n", what, text.c_str());
}
void print(const char* what, const mpz_class& number) {
    print(what, number.get_str());
}
void print(const char* what, const mpq_class& number) {
    print(what, number.get_str());
}
void print(const char* what, double number) {
    std::printf("%s %a\n", what, number);
}
void print(const char* what, std::int64_t number) {
    print(what, std::to_string(number));
}

int sign(int order) {
    return order < 0 ? -1 : order > 0 ? 1 : 0;
}

void ask_of_whole_numbers(Random& random) {
    const mpz_class a = whole_number(random);
    const mpz_class b = divisor(random);
    const auto bits = static_cast<unsigned>(random.whole(0, 150));
    print("a", a);
    print("b", b);
    print("a + b", mpz_class(a + b));
    print("a - b", mpz_class(a - b));
    print("a * b", mpz_class(a * b));
    print("a / b", mpz_class(a / b));
    print("a % b", mpz_class(a % b));
    print("a b / b", mpz_class(a * b / b));
    print("a << bits", mpz_class(a << bits));
    print("a >> bits", mpz_class(a >> bits));
    print("sqrt", mpz_class(sqrt(mpz_class(abs(a)))));
    print("cmp", std::int64_t{sign(cmp(a, b))});
    print("sgn", std::int64_t{sgn(a)});
    print("read", mpz_class(a.get_str(), 10));
    print("fits", std::int64_t{a.fits_slong_p()});
    const mpz_class low = a % (mpz_class(1) << 63);
    print("fits", std::int64_t{low.fits_slong_p()});
    print("get_si", std::int64_t{low.get_si()});
    print("-", mpz_class(-a));

    mpz_class result;
    mpz_fdiv_q(result.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
    print("fdiv_q", result);
    mpz_cdiv_q(result.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
    print("cdiv_q", result);
    print("lcm", mpz_class(lcm(a, b)));
    print("fdiv_ui", static_cast<std::int64_t>(mpz_fdiv_ui(a.get_mpz_t(), 1 + bits)));
    mpz_ui_pow_ui(result.get_mpz_t(), 1 + bits, bits / 8);
    print("ui_pow_ui", result);
    print("digits", static_cast<std::int64_t>(mpz_sizeinbase(a.get_mpz_t(), 10)));
    print("bits", static_cast<std::int64_t>(mpz_sizeinbase(a.get_mpz_t(), 2)));
    print("square", std::int64_t{mpz_perfect_square_p(a.get_mpz_t()) != 0});
    result = a * a;
    print("square", std::int64_t{mpz_perfect_square_p(result.get_mpz_t()) != 0});
    long exponent = 0;
    print("get_d_2exp", mpz_get_d_2exp(&exponent, a.get_mpz_t()));
    print("get_d_2exp", std::int64_t{exponent});
    if (a != 0) {
        const mpz_class three = 3;
        result = a * 81;
        print("remove", static_cast<std::int64_t>(
                            mpz_remove(result.get_mpz_t(), result.get_mpz_t(), three.get_mpz_t())));
        print("remove", result);
    }
}

void ask_of_fractions(Random& random) {
    const mpq_class a = fraction(random);
    mpq_class b = fraction(random);
    if (b == 0)
        b = mpq_class(5, 3);
    print("a", a);
    print("b", b);
    print("a + b", mpq_class(a + b));
    print("a - b", mpq_class(a - b));
    print("a - a", mpq_class(a - a));
    print("a * b", mpq_class(a * b));
    print("a / b", mpq_class(a / b));
    print("abs", mpq_class(abs(a)));
    print("cmp", std::int64_t{sign(cmp(a, b))});
    print("sgn", std::int64_t{sgn(a)});
    print("equal", std::int64_t{a == b});
    print("get_d", a.get_d());

    // Doubles of every size, the smallest too.
    const double near = std::ldexp(static_cast<double>(random.whole(-1 << 30, 1 << 30)) + 0.1,
                                   random.whole(-1100, 900));
    print("of double", mpq_class(near));
    mpq_class beside = mpq_class(near) * (1 + mpq_class(random.whole(-9, 9), 10007));
    print("get_d", beside.get_d());
    print("cut off", mpz_class(mpq_class(near)));
}

} // namespace

int main() {
    Random random(20261123);
    for (int i = 0; i < 5000; ++i) {
        ask_of_whole_numbers(random);
        ask_of_fractions(random);
    }
    for (const double value : {0.0, 1.0, -0.5, std::numeric_limits<double>::max(),
                               std::numeric_limits<double>::denorm_min()}) {
        print("of double", mpq_class(value));
        print("get_d", mpq_class(value).get_d());
    }
    print("lowest", mpz_class(std::numeric_limits<std::int64_t>::min()));
    return 0;
}
