// SPDX-License-Identifier: MIT
#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/double_texts.h>
#include <rastertrace/trace/text/format_number.h>

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

template <typename Number> std::string text_of(const Number& value) {
    std::string text(room_for(value) + 16, '?');
    const char* const end = format_number(text.data(), value);
    EXPECT_LE(static_cast<std::size_t>(end - text.data()), room_for(value));
    return text.substr(0, static_cast<std::size_t>(end - text.data()));
}

std::string shortest(double value) {
    std::array<char, 32> buffer;
    return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

TEST(FormatNumber, WritesIntegersLikeTheStandardLibrary) {
    for (const std::int64_t value :
         {std::int64_t{0}, std::int64_t{9}, std::int64_t{10}, std::int64_t{99}, std::int64_t{100},
          std::int64_t{999}, std::int64_t{1000}, std::int64_t{9999}, std::int64_t{10000},
          std::int64_t{-1}, std::int64_t{-10}, std::int64_t{-9999}, std::int64_t{-123456},
          std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()})
        EXPECT_EQ(text_of(value), std::to_string(value));
}

TEST(FormatNumber, WritesNegativeZeroAsZero) {
    EXPECT_EQ(text_of(-0.0), "0");
}

TEST(FormatNumber, WritesEveryMultipleOfOneIn1024InItsShortestForm) {
    for (int units = -2'000'000; units <= 2'000'000; units += units % 7 == 0 ? 1 : 3)
        ASSERT_EQ(text_of(units / 1024.0), units == 0 ? "0" : shortest(units / 1024.0));
}

TEST(FormatNumber, WritesRoundAndLargeNumbersInTheirShortestForm) {
    for (double value = 1; value < 1e20; value *= 10)
        for (const double factor : {1.0, -1.0, 1.5, 2.0, 12.0, 123.0, 1.0009765625})
            ASSERT_EQ(text_of(value * factor), shortest(value * factor));
    for (const double value : {99999.0, 100000.0, 100000.5, 120000.0, 1e6, 4e9, 3999999999.0,
                               4000000001.0, 1e22, 1.7976931348623157e308, 5e-324})
        ASSERT_EQ(text_of(value), shortest(value));
}

RC_GTEST_PROP(FormatNumber, WritesAnyDoubleInItsShortestForm, (std::uint64_t bits)) {
    const auto value = std::bit_cast<double>(bits);
    RC_PRE(std::isfinite(value) && value != 0);
    RC_ASSERT(text_of(value) == shortest(value));
}

RC_GTEST_PROP(FormatNumber, WritesFractionsInLowestTerms, (std::int32_t above)) {
    const auto below = *rc::gen::inRange<std::int64_t>(1, 100000);
    mpq_class value(above, static_cast<long>(below));
    value.canonicalize();
    const std::string expected = "\"" + value.get_str() + "\"";
    RC_ASSERT(text_of(Fraction64{above, below}) == expected);
    RC_ASSERT(text_of(value) == expected);
}

TEST(FormatNumber, WritesTheLargestFractions) {
    const std::int64_t largest = std::numeric_limits<std::int64_t>::max();
    EXPECT_EQ(text_of(Fraction64{-largest, 2}), "\"-9223372036854775807/2\"");
    EXPECT_EQ(text_of(Fraction64{1, largest}), "\"1/9223372036854775807\"");
    EXPECT_EQ(text_of(Fraction64{-25, 8}), "\"-25/8\"");
    EXPECT_EQ(text_of(Fraction64{24, 8}), "\"3\"");
    EXPECT_EQ(text_of(Fraction64{0, 8}), "\"0\"");
}

RC_GTEST_PROP(DoubleTexts, AreThoseOfFormatNumberHoweverOftenTheyComeAgain,
              (const std::vector<std::uint64_t>& some)) {
    DoubleTexts texts;
    const auto write = [&texts](double value) {
        std::array<char, room_for(0.0)> text{};
        return std::string(text.data(), texts.append(text.data(), value));
    };
    // Numbers near each other, and more than there are places.
    for (const std::uint64_t bits : some)
        for (std::uint64_t i = 0; i < 2000; ++i) {
            const auto value = std::bit_cast<double>(bits + i * i);
            if (!std::isfinite(value))
                continue;
            RC_ASSERT(write(value) == text_of(value));
            RC_ASSERT(write(-value) == text_of(-value));
            RC_ASSERT(write(value) == text_of(value));
        }
}

// Decimals between two doubles, however small, large or long; fractions; 0 without a sign.
RC_GTEST_PROP(TracedNumbers, AreReadAsTheDoubleNearestToWhatIsWritten,
              (std::uint64_t bits, std::string more)) {
    const auto value = std::bit_cast<double>(bits);
    if (!std::isfinite(value))
        return;
    for (char& digit : more)
        digit = static_cast<char>('0' + static_cast<unsigned char>(digit) % 10);
    std::string text = shortest(value);
    if (const std::size_t exponent = text.find('e'); text.find('.') != text.npos)
        text.insert(std::min(exponent, text.size()), more);
    for (const std::string& json : {text, '"' + text + '"', text + "/3"}) {
        const TracedNumber number(json);
        const auto exact = number.exact();
        RC_ASSERT(number.nearest_double() ==
                  (exact ? std::optional(nearest_double(*exact)) : std::nullopt));
    }
    RC_ASSERT(std::signbit(*TracedNumber("-0.0").nearest_double()) == false);
}

} // namespace
} // namespace rastertrace
