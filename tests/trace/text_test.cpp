// SPDX-License-Identifier: MIT
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/text.h>

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {
namespace {

using namespace std::string_literals;

TEST(Printable, ShowsWhatATerminalWouldObey) {
    EXPECT_EQ(printable("A\x1b]0;x\a"), "A<U+001B>]0;x<U+0007>");
    EXPECT_EQ(printable("\xC2\x9B"), "<U+009B>")
        << "a control sequence introducer in one character";
    EXPECT_EQ(printable("\xE2\x80\xAE"), "<U+202E>") << "right-to-left override";
    EXPECT_EQ(printable("a\nb\0c"s), "a<U+000A>b<U+0000>c");
    EXPECT_EQ(printable("\xFF\xC3"), "<0xFF><0xC3>");
    EXPECT_EQ(printable("\xED\xA0\x80"), "<0xED><0xA0><0x80>") << "half of a surrogate pair";
    EXPECT_EQ(printable("\xC0\x80"), "<0xC0><0x80>") << "overlong";
    EXPECT_EQ(printable("é 三"), "é 三");
}

TEST(Printable, ShowsWhatNobodySees) {
    for (const auto& [text, shown] : std::vector<std::pair<std::string, std::string>>{
             {"A\u200B", "A<U+200B>"},      // a blank of no width
             {"A\u2060", "A<U+2060>"},      // a joiner of words
             {"A\u00AD", "A<U+00AD>"},      // a soft hyphen
             {"A\u3164", "A<U+3164>"},      // fillers
             {"A\u115F", "A<U+115F>"},      //
             {"A\U000E0041", "A<U+E0041>"}, // a tag
             {"A\uFE0F", "A<U+FE0F>"},      // a selector of variants
             {"A\uFFF9", "A<U+FFF9>"},      // the mark of an annotation
             {"A\uFFFE", "A<U+FFFE>"},      // no character at all
             {"A\U0010FFFF", "A<U+10FFFF>"}})
        EXPECT_EQ(printable(text), shown);
    EXPECT_EQ(printable("e\u0301 \u05D0 \u00A0"), "e\u0301 \u05D0 \u00A0");
}

TEST(Columns, AreThoseOfATerminal) {
    EXPECT_EQ(columns_in("abc"), 3u);
    EXPECT_EQ(columns_in("三角"), 4u) << "wide";
    EXPECT_EQ(columns_in("e\u0301"), 1u) << "combining";
    EXPECT_EQ(columns_in("\xFF"), 1u);
    EXPECT_EQ(first_columns("三角形", 5), "三角") << "no half of a character";
    EXPECT_EQ(first_columns("e\u0301x", 1), "e\u0301") << "with what belongs to it";
    EXPECT_EQ(shortened("三角形です", 10), "三角形です");
    EXPECT_EQ(shortened("三角形です", 9), "三角形...");
    EXPECT_EQ(padded("三", 4), "三  ");
    EXPECT_EQ(padded("三角形", 4), "三角形");
}

RC_GTEST_PROP(Printable, NeverHoldsAControlByte, (const std::string& text)) {
    for (const char c : printable(text)) {
        const auto byte = static_cast<unsigned char>(c);
        RC_ASSERT(byte >= 0x20 && byte != 0x7F);
    }
}

TEST(JsonQuoted, EscapesQuotesControlsAndBadBytes) {
    EXPECT_EQ(json_quoted("a\"b\\c\n\t\x1b"), R"("a\"b\\c\n\t\u001b")");
    EXPECT_EQ(json_quoted("\xC2\x9B\x7F\xE2\x80\xA8"), R"("\u009b\u007f\u2028")");
    EXPECT_EQ(json_quoted("\xFF"), R"("\ufffd")");
    EXPECT_EQ(json_quoted("é"), "\"é\"");
    // Outside of the first 2^16 characters, JSON has two escapes for one (RFC 8259, section 7).
    EXPECT_EQ(json_quoted("\u200B\U000E0041\u202E"), R"("\u200b\udb40\udc41\u202e")");
    EXPECT_EQ(json_quoted("\U0001F600"), "\"\U0001F600\"");
}

TEST(Shortened, CutsAtCharacters) {
    EXPECT_EQ(shortened("abcdef", 6), "abcdef");
    EXPECT_EQ(shortened("abcdefg", 6), "abc...");
    EXPECT_EQ(shortened("ééééééé", 6), "ééé...");
    EXPECT_EQ(shortened("abc", 2), "...");
}

TEST(Wrapped, BreaksBetweenWords) {
    using Lines = std::vector<std::string>;
    EXPECT_EQ(wrapped("one two three", 7), (Lines{"one two", "three"}));
    EXPECT_EQ(wrapped("incomprehensible", 7), Lines{"incomprehensible"});
    EXPECT_TRUE(wrapped("", 7).empty());
}

TEST(Joined, PutsTheSeparatorBetween) {
    EXPECT_EQ(joined(std::vector<std::string>{"a", "b", "c"}, ", "), "a, b, c");
    EXPECT_EQ(joined(std::vector<std::string_view>{"", "b"}, "-"), "-b");
    EXPECT_EQ(joined(std::vector<std::string>{}, ", "), "");
}

TEST(NearestWord, FindsSlipsAndNothingElse) {
    EXPECT_EQ(nearest_word("trinagles", {"triangles", "vertices"}), "triangles");
    EXPECT_EQ(nearest_word("exat", {"double", "exact"}), "exact");
    EXPECT_EQ(nearest_word("shw", {"show", "stats"}), "show");
    EXPECT_EQ(nearest_word("frobnicate", {"show", "stats"}), "");
    EXPECT_EQ(nearest_word(std::string(100000, 'x'), {"show"}), "");
    EXPECT_EQ(nearest_word("C", {"A", "B"}), "") << "every letter is another one";
}

TEST(DidYouMean, KnowsWhatOtherProgramsCallIt) {
    EXPECT_EQ(did_you_mean("target", {"position", "look_at", "up"}), "did you mean look_at?");
    EXPECT_EQ(did_you_mean("z-buffer", {"painter", "linear-z", "inverse-z"}),
              "did you mean linear-z or inverse-z?");
    EXPECT_EQ(did_you_mean("target", {"position", "up"}), "") << "where it is not known";
    EXPECT_EQ(did_you_mean("target", {"targets", "look_at"}), "did you mean look_at?");
    EXPECT_EQ(did_you_mean("shw", {"show", "stats"}, "\""), "did you mean \"show\"?");
}

TEST(ColorText, ReadsAndWrites) {
    EXPECT_EQ(parse_color("red"), (Color{255, 0, 0, 255}));
    EXPECT_EQ(parse_color("orange"), (Color{255, 165, 0, 255}));
    EXPECT_EQ(parse_color("#ff8000"), (Color{255, 128, 0, 255}));
    EXPECT_EQ(parse_color("#FF800040"), (Color{255, 128, 0, 64}));
    for (const char* text :
         {"", "#", "#ff80", "#ff800", "#ff80000", "#gg0000", "#+f0000", "reddish"})
        EXPECT_FALSE(parse_color(text)) << text;
    EXPECT_EQ(to_text(Color{255, 128, 0, 255}), "#ff8000");
    EXPECT_EQ(to_text(Color{255, 128, 0, 64}), "#ff800040");
}

} // namespace
} // namespace rastertrace
