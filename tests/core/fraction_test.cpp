// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/paint/divisor.h>
#include <rastertrace/core/numbers/conversion.h>

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

namespace rastertrace {
namespace {

mpq_class exact(const Fraction64& x) {
    mpq_class value(static_cast<long>(x.numerator), static_cast<long>(x.denominator));
    value.canonicalize();
    return value;
}

rc::Gen<Fraction64> fraction() {
    return rc::gen::map(rc::gen::pair(rc::gen::inRange<std::int64_t>(-30000, 30001),
                                      rc::gen::inRange<std::int64_t>(1, 1000)),
                        [](const auto& parts) {
                            return Fraction64{parts.first, parts.second};
                        });
}

RC_GTEST_PROP(Fraction, CalculatesLikeARational, ()) {
    const Fraction64 a = *fraction(), b = *fraction();
    RC_ASSERT(exact(a + b) == exact(a) + exact(b));
    RC_ASSERT(exact(a - b) == exact(a) - exact(b));
    RC_ASSERT(exact(a * b) == exact(a) * exact(b));
    RC_ASSERT((a < b) == (exact(a) < exact(b)));
    RC_ASSERT((a == b) == (exact(a) == exact(b)));
    if (b.numerator != 0) {
        RC_ASSERT(exact(a / b) == exact(a) / exact(b));
        RC_ASSERT((a / b).denominator > 0);
    }
}

TEST(Fraction, KeepsItsDenominatorInSumsAndLosesItInQuotients) {
    const Fraction64 sum = Fraction64{1, 8} + Fraction64{5, 8};
    EXPECT_EQ(sum.denominator, 8);
    const Fraction64 quotient = Fraction64{3, 8} / Fraction64{-5, 8};
    EXPECT_EQ(quotient.numerator, -3);
    EXPECT_EQ(quotient.denominator, 5);
}

RC_GTEST_PROP(FloorAndCeil, AreTheSameForEveryScalar, ()) {
    // On eighths, which every scalar holds exactly.
    const auto eighths = *rc::gen::inRange<std::int64_t>(-1000, 1001);
    const Index below = eighths >= 0 ? eighths / 8 : -((-eighths + 7) / 8);
    const Index above = eighths % 8 == 0 ? below : below + 1;
    const double as_double = static_cast<double>(eighths) / 8;
    mpq_class as_rational(static_cast<long>(eighths), 8);
    as_rational.canonicalize();
    RC_ASSERT(floor_index(as_double) == below);
    RC_ASSERT(floor_index(Fraction64{eighths, 8}) == below);
    RC_ASSERT(floor_index(as_rational) == below);
    RC_ASSERT(ceil_index(as_double) == above);
    RC_ASSERT(ceil_index(Fraction64{eighths, 8}) == above);
    RC_ASSERT(ceil_index(as_rational) == above);
}

TEST(FloorAndCeil, StayWithinTheFarthestIndex) {
    EXPECT_EQ(floor_index(1e300), farthest_index);
    EXPECT_EQ(floor_index(-1e300), -farthest_index);
    EXPECT_EQ(ceil_index(-1e300), -farthest_index);
    EXPECT_EQ(floor_index(Rational("100000000000000000000000000")), farthest_index);
    EXPECT_EQ(floor_index(Rational("-100000000000000000000000000/3")), -farthest_index);
    EXPECT_EQ(floor_index(Fraction64{std::int64_t{1} << 60}), farthest_index);
    EXPECT_EQ(floor_index(-0.0), 0);
    EXPECT_EQ(floor_index(-5e-324), -1);
}

RC_GTEST_PROP(Divisor, QuotientsAreExact, ()) {
    // The hardest numbers lie next to a multiple of the divisor; quotients go up to 2^49.
    const int divisor_bits = *rc::gen::inRange(0, 63);
    const auto value = *rc::gen::inRange<std::int64_t>(
        std::int64_t{1} << std::max(divisor_bits - 1, 0), (std::int64_t{1} << divisor_bits) + 1);
    const int quotient_bits = *rc::gen::inRange(0, std::min(49, 62 - divisor_bits) + 1);
    const auto farthest = std::int64_t{1} << quotient_bits;
    const auto quotient = *rc::gen::inRange<std::int64_t>(-farthest, farthest);
    const auto rest = *rc::gen::element<std::int64_t>(0, value - 1, value / 2);
    const auto found = Divisor<std::int64_t>(value).divide(quotient * value + rest);
    RC_ASSERT(found.quotient == quotient);
    RC_ASSERT(found.rest == rest);
}

} // namespace
} // namespace rastertrace
