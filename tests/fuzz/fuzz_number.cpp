// SPDX-License-Identifier: MIT
// Any bytes as a number: its nearest double is the nearest by exact comparison and by the C
// library, and its ways to be a fraction say the same.

#include "check.h"

#include <rastertrace/core/numbers/number.h>

#include <gmpxx.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <variant>

namespace rastertrace::fuzz {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// No neighbor of `nearest` is nearer; at the same distance, `nearest` is the even one.
void check_nearest(const mpq_class& exact, double nearest) {
    check(std::isfinite(nearest), "the nearest double is not finite");
    const mpq_class distance = abs(exact - mpq_class(nearest));
    for (const double neighbor :
         {std::nextafter(nearest, -infinity), std::nextafter(nearest, infinity)}) {
        if (!std::isfinite(neighbor))
            continue;
        const int nearer = cmp(distance, mpq_class(abs(exact - mpq_class(neighbor))));
        const bool is_even = std::bit_cast<std::uint64_t>(nearest) % 2 == 0;
        check(nearer < 0 || (nearer == 0 && is_even), "a neighbor of the nearest double is nearer");
    }
}

/// Over its own denominator, and three times that, the number is still the same number.
void check_fraction(const Number& number, const mpq_class& exact) {
    const auto denominator = number.denominator();
    if (!denominator)
        return;
    check(*denominator > 0, "the denominator is not positive");
    for (const std::int64_t factor : {1, 3}) {
        std::int64_t below = 0;
        if (__builtin_mul_overflow(*denominator, factor, &below))
            continue;
        const mpq_class above = exact * mpz_class(static_cast<long>(below));
        check(above.get_den() == 1, "the denominator does not suit the number");
        const auto numerator = number.numerator_over(below);
        if (numerator)
            check(above == static_cast<long>(*numerator), "the numerator is another");
        else
            check(!above.get_num().fits_slong_p(), "a numerator that fits was not found");
    }
}

/// The value of the text by other code: GMP's for fractions, the C library's for decimals.
void check_against_text(const Number& number, const std::string& text) {
    if (text.find('/') == std::string::npos) {
        check(number.nearest_double() == std::strtod(text.c_str(), nullptr),
              "strtod reads another number");
        return;
    }
    mpq_class value(text, 10);
    value.canonicalize();
    check(number.exact() == value, "GMP reads another fraction");
}

void check_fault(NumberFault fault, const std::string& text) {
    if (text.find('/') != std::string::npos)
        return;
    const double value = std::abs(std::strtod(text.c_str(), nullptr));
    if (fault == NumberFault::too_large)
        check(value >= std::numeric_limits<double>::max(), "too large, but strtod can read it");
    if (fault == NumberFault::too_small)
        check(value <= std::numeric_limits<double>::denorm_min(),
              "too small, but strtod can read it");
    check(fault != NumberFault::zero_denominator, "a decimal has a denominator");
}

} // namespace

} // namespace rastertrace::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace rastertrace;
    const std::string text(data, data + size);
    const auto parsed = parse_number(text);
    if (const auto* number = std::get_if<Number>(&parsed)) {
        const mpq_class exact = number->exact();
        fuzz::check_nearest(exact, number->nearest_double());
        fuzz::check_fraction(*number, exact);
        fuzz::check_against_text(*number, text);
    } else {
        fuzz::check_fault(std::get<NumberFault>(parsed), text);
    }
    return 0;
}
