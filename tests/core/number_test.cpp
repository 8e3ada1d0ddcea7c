// SPDX-License-Identifier: MIT
#include "picture.h"

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cstdlib>
#include <limits>
#include <string>

namespace rastertrace {
namespace {

std::string exact_text(std::string_view text) {
    return number(text).exact().get_str();
}

NumberFault fault(std::string_view text) {
    return std::get<NumberFault>(parse_number(text));
}

TEST(Number, IsExactlyWhatWasTyped) {
    EXPECT_EQ(exact_text("0.1"), "1/10");
    EXPECT_EQ(exact_text("-4"), "-4");
    EXPECT_EQ(exact_text("25/8"), "25/8");
    EXPECT_EQ(exact_text("-6/8"), "-3/4");
    EXPECT_EQ(exact_text("010/08"), "5/4") << "decimal digits, whatever stands in front";
    EXPECT_EQ(exact_text("1e3"), "1000");
    EXPECT_EQ(exact_text("-1.50E-2"), "-3/200");
    EXPECT_EQ(exact_text("-0"), "0");
    EXPECT_EQ(exact_text("0e999999999999"), "0");
    EXPECT_EQ(exact_text("123456789012345678901234567890"), "123456789012345678901234567890");
    EXPECT_EQ(exact_text("0.1234567890123456789012345"),
              "246913578024691357802469/2000000000000000000000000");
}

TEST(Number, SaysWhatIsWrongWithAText) {
    for (const char* text : {"", "-", "+1", " 1", "1 ", "1.", ".5", "1e", "1e+", "0x10", "1/", "/2",
                             "1/-2", "1.5/2", "nan", "inf", "1,5", "--1", "1/2/3"})
        EXPECT_EQ(fault(text), NumberFault::malformed) << text;
    EXPECT_EQ(fault("1/0"), NumberFault::zero_denominator);
    EXPECT_EQ(fault("0/000"), NumberFault::zero_denominator);
    EXPECT_EQ(fault("1/" + std::string(longest_number, '7')), NumberFault::too_long);
    EXPECT_EQ(fault("1e999"), NumberFault::too_large);
    EXPECT_EQ(fault("-1.8e308"), NumberFault::too_large);
    EXPECT_EQ(fault("1e99999999999999999999"), NumberFault::too_large);
    EXPECT_EQ(fault("1e9223372036854775807"), NumberFault::too_large);
    EXPECT_EQ(fault("0.12e-9223372036854775807"), NumberFault::too_small);
    EXPECT_EQ(fault("1e-400"), NumberFault::too_small);
    EXPECT_EQ(fault("1e-99999999999999999999"), NumberFault::too_small);
    EXPECT_EQ(fault("1/1" + std::string(400, '0')), NumberFault::too_small);
}

TEST(Number, ReachesBothEndsOfDouble) {
    EXPECT_EQ(number("1.7976931348623157e308").nearest_double(),
              std::numeric_limits<double>::max());
    EXPECT_EQ(number("4.9406564584124655e-324").nearest_double(),
              std::numeric_limits<double>::denorm_min());
    EXPECT_EQ(number("2.2250738585072014e-308").nearest_double(),
              std::numeric_limits<double>::min());
}

TEST(Number, RoundsAFractionToTheNearestDouble) {
    EXPECT_EQ(number("1/3").nearest_double(), 1.0 / 3.0);
    EXPECT_EQ(number("-2/3").nearest_double(), -2.0 / 3.0);
    // Halfway between two doubles: the even one. 2^53 + 1 lies between 2^53 and 2^53 + 2.
    EXPECT_EQ(number("9007199254740993/1").nearest_double(), 9007199254740992.0);
    EXPECT_EQ(number("9007199254740995/1").nearest_double(), 9007199254740996.0);
    EXPECT_EQ(number("18014398509481987/2").nearest_double(), 9007199254740994.0);
}

RC_GTEST_PROP(Number, OfADecimalIsTheDoubleThatTheCLibraryReads, ()) {
    const auto digits = *rc::gen::arbitrary<std::int64_t>();
    const int exponent = *rc::gen::inRange(-320, 280);
    const std::string text = std::to_string(digits) + "e" + std::to_string(exponent);
    const auto parsed = parse_number(text);
    if (const auto* value = std::get_if<Number>(&parsed)) {
        const double read = std::strtod(text.c_str(), nullptr);
        RC_ASSERT(value->nearest_double() == read);
        RC_ASSERT(nearest_double(value->exact()) == read);
    }
}

// Over all of the doubles, also those that are not normal.
RC_GTEST_PROP(Number, HalfwayBetweenTwoDoublesIsTheEvenOne, ()) {
    const auto lower = std::bit_cast<double>(
        *rc::gen::inRange<std::uint64_t>(0, std::bit_cast<std::uint64_t>(1.7e308)));
    const double upper = std::nextafter(lower, std::numeric_limits<double>::infinity());
    const mpq_class middle = (mpq_class(lower) + mpq_class(upper)) / 2;
    mpq_class little(1, mpz_class(1) << 1200);
    little.canonicalize();
    const bool is_lower_even = std::bit_cast<std::uint64_t>(lower) % 2 == 0;
    RC_ASSERT(nearest_double(middle) == (is_lower_even ? lower : upper));
    RC_ASSERT(nearest_double(middle - little) == lower);
    RC_ASSERT(nearest_double(-middle - little) == -upper);
}

RC_GTEST_PROP(Number, OfAFractionIsNoFartherThanItsNeighbors, ()) {
    const auto above = *rc::gen::arbitrary<std::int64_t>();
    const auto below = *rc::gen::positive<std::int64_t>();
    const Number value = number(std::to_string(above) + "/" + std::to_string(below));
    const double nearest = value.nearest_double();
    const mpq_class distance = abs(value.exact() - mpq_class(nearest));
    for (const double toward : {-1e300, 1e300})
        RC_ASSERT(distance <= abs(value.exact() - mpq_class(std::nextafter(nearest, toward))));
}

RC_GTEST_PROP(Number, IsItsNumeratorOverItsDenominator, ()) {
    const auto digits = *rc::gen::inRange<std::int64_t>(-1000000, 1000001);
    const int exponent = *rc::gen::inRange(-9, 9);
    const Number value = Number::decimal(digits, exponent);
    const auto denominator = value.denominator();
    RC_ASSERT(denominator.has_value());
    const auto numerator = value.numerator_over(*denominator * 3);
    RC_ASSERT(numerator.has_value());
    mpq_class quotient(static_cast<long>(*numerator), static_cast<long>(*denominator * 3));
    quotient.canonicalize();
    RC_ASSERT(quotient == value.exact());
}

} // namespace
} // namespace rastertrace
