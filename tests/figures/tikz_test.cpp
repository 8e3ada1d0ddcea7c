// SPDX-License-Identifier: MIT
// Pictures for TeX. That pdflatex takes them is for tikz.sh to see.

#include "figures/hostile_drawing.h"

#include <rastertrace/figures/tikz.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

using testing::HasSubstr;
using testing::Not;

Drawing sheet(std::vector<Shape> shapes) {
    return {.width = 40, .height = 20, .title = "A test", .shapes = std::move(shapes)};
}

/// The part between the sheet and the end.
std::string body_of(const Drawing& drawing, Theme theme = Theme::light) {
    const auto tex = tikz_of(drawing, theme, 80);
    if (!tex)
        return to_text(tex.problem());
    const std::string sheet_line = "\\fill[rt-paper] (0,0) rectangle (40,20);\n";
    const std::size_t begin = tex.value().find(sheet_line) + sheet_line.size();
    return tex.value().substr(begin, tex.value().find("\\end{tikzpicture}") - begin);
}

TEST(Tikz, IsAPictureToPutIn) {
    const auto tex =
        tikz_of({.width = 40,
                 .height = 20,
                 .title = "A line",
                 .description = "From corner to corner.",
                 .shapes = {Lines{.role = Role::other_edge, .paths = {{{0, 0}, {40, 20}}}},
                            Label{.at = {1.5, 19}, .text = "50 %"}}},
                Theme::light, 80);
    ASSERT_TRUE(tex);
    EXPECT_EQ(tex.value(), R"(% A line
% From corner to corner.
% To be put into a document that has \usepackage{tikz}: \input{FILE}
\begingroup
% Packages for languages let some signs be commands. Here they are signs.
\catcode33 12\catcode34 12\catcode39 12\catcode45 12\catcode58 12\catcode59 12\catcode60 12
\catcode61 12\catcode62 12\catcode63 12\catcode94 7\catcode96 12\catcode124 12
\begin{tikzpicture}[x=2mm,y=-2mm,line join=round]
\definecolor{rt-paper}{HTML}{FFFFFF}
\definecolor{rt-other-edge}{HTML}{444A52}
\definecolor{rt-text}{HTML}{111111}
\tikzset{rt-line other-edge/.style={draw=rt-other-edge,line width=2mm,dash pattern=on 8mm off 6mm}}
\tikzset{rt-label/.style={inner sep=0pt,outer sep=0pt,font=\normalfont}}
\ifcsname rastertracestyle\endcsname\csname rastertracestyle\endcsname\fi
\clip (0,0) rectangle (40,20);
\fill[rt-paper] (0,0) rectangle (40,20);
\draw[rt-line other-edge] (0,0) -- (40,20);
\node[rt-label,text=rt-text,scale=2.2872,anchor=base west] at (1.5,19) {\Huge 50 \%};
\end{tikzpicture}%
\endgroup
)");
}

TEST(Tikz, HasAllShapes) {
    EXPECT_EQ(body_of(sheet(
                  {Areas{.role = Role::face_1, .rectangles = {{{1, 2}, 3, 4}, {{5, 5}, 1, 1}}}})),
              "\\fill[rt-face-1] (1,2) rectangle (4,6)\n"
              "  (5,5) rectangle (6,6);\n");
    EXPECT_EQ(body_of(sheet({Pixels{.corner = {2, 3},
                                    .side = 2,
                                    .columns = 3,
                                    .colors = {Color(1, 2, 3), Color(1, 2, 3), no_color, no_color,
                                               Color(255, 0, 0, 51), Color(1, 2, 3)}}})),
              "\\fill[rt-010203] (2,3) rectangle (6,5)\n"
              "  (6,5) rectangle (8,7);\n"
              "\\fill[rt-FF0000,fill opacity=0.2] (4,5) rectangle (6,7);\n");
    EXPECT_EQ(body_of(sheet({Lines{.role = Role::inside,
                                   .paths = {{{0, 0}, {1, 1}, {2, 0}}, {{3, 3}, {4, 4}}},
                                   .are_closed = true}})),
              "\\draw[rt-line inside,draw opacity=0.27] (0,0) -- (1,1) -- (2,0) -- cycle\n"
              "  (3,3) -- (4,4) -- cycle;\n");
    EXPECT_EQ(body_of(sheet({Polygons{.role = Role::vertex, .paths = {{{0, 0}, {9, 0}, {0, 9}}}}})),
              "\\fill[rt-vertex] (0,0) -- (9,0) -- (0,9) -- cycle;\n");
    EXPECT_EQ(body_of(sheet({Dots{.radius = 1.5, .centers = {{1, 2}, {3, 4}}}})),
              "\\fill[rt-vertex] (1,2) circle[radius=3mm]\n"
              "  (3,4) circle[radius=3mm];\n");
    EXPECT_EQ(
        body_of(sheet(
            {Label{.role = Role::strong_text,
                   .at = {1, 2},
                   .text = "a",
                   .size = 5,
                   .anchor = Anchor::middle,
                   .is_bold = true,
                   .is_turned = true,
                   .has_rim = true},
             Label{.at = {1, 2}, .text = "a  <", .anchor = Anchor::end, .is_fixed_width = true}})),
        "\\node[rt-label,text=rt-strong-text,scale=1.1436,rotate=90,fill=rt-paper,"
        "inner sep=3mm,anchor=base] at (1,2) {\\Huge \\bfseries a};\n"
        "\\node[rt-label,text=rt-text,scale=2.2872,anchor=base east] at (1,2) "
        "{\\Huge \\ttfamily a \\ \\char60{}};\n");
}

TEST(Tikz, LeavesOutWhatIsNotOnTheSheet) {
    EXPECT_EQ(
        body_of(sheet({Areas{.rectangles = {{{-1e6, 5}, 2e6, 1}, {{1e6, 0}, 5, 5}, {{3, 3}, 0, 9}}},
                       Lines{.paths = {{{-1e6, 10}, {1e6, 10}},
                                       {{1e6, 0}, {1e6, 9}},
                                       {{10, -1e6}, {10, 5}, {1e6, 5}, {20, 5}},
                                       {{3, 3}},
                                       {}}},
                       Polygons{.role = Role::vertex,
                                .paths = {{{-1e6, -1e6}, {1e6, -1e6}, {1e6, 1e6}, {-1e6, 1e6}},
                                          {{100, 0}, {200, 0}, {100, 9}}}},
                       Dots{.centers = {{1e6, 1e6}}}, Dots{.radius = 1e6, .centers = {{1, 1}}},
                       Dots{.radius = 0, .centers = {{1, 1}}}, Label{.at = {-1e6, 0}, .text = "x"},
                       Label{.at = {1, 1}, .text = ""}})),
        "\\fill[rt-plotted] (-20,5) rectangle (60,6);\n"
        "\\draw[rt-line true-edge] (-20,10) -- (60,10)\n"
        "  (10,-20) -- (10,5) -- (60,5) -- (20,5);\n"
        "\\fill[rt-vertex] (60,-20) -- (60,40) -- (-20,40) -- (-20,-20) -- cycle;\n"
        "\\fill[rt-vertex] (1,1) circle[radius=240mm];\n");
}

TEST(Tikz, SlantedLinesGoOnWhereTheyLeave) {
    EXPECT_EQ(
        body_of(sheet({Lines{.paths = {{{0, 10}, {240, 50}}, {{-90, 0}, {10, 20}}}},
                       Polygons{.role = Role::vertex, .paths = {{{0, 0}, {240, 40}, {0, 4}}}}})),
        "\\draw[rt-line true-edge] (0,10) -- (60,20)\n"
        "  (-20,14) -- (10,20);\n"
        "\\fill[rt-vertex] (0,0) -- (60,10) -- (60,13) -- (0,4) -- cycle;\n");
}

TEST(Tikz, LongLinesAreInPartsThatMeet) {
    Path path;
    for (int i = 0; i < 1500; ++i)
        path.push_back({i % 40 * 1.0, i % 7 * 1.0});
    const std::string body = body_of(sheet({Lines{.paths = {path}}}));
    EXPECT_EQ(std::count(body.begin(), body.end(), '('), 1501);
    EXPECT_THAT(
        body,
        HasSubstr(
            "(39,5);\n\\draw[rt-line true-edge] (39,5) -- (0,6)")); // places 999, 999 and 1000
}

TEST(TexEscaped, ObeysNothing) {
    const std::vector<std::pair<std::string, std::string>> texts{
        {"50 % of {a_1}", "50 \\% of $\\{$a\\_1$\\}$"},
        {"\\end{x}", "$\\backslash$end$\\{$x$\\}$"},
        {"$5 & #6", "$\\$$5 \\& \\#6"},
        {"a^b~c", "a\\textasciicircum{}b\\textasciitilde{}c"},
        {"^^M", "\\textasciicircum{}\\textasciicircum{}M"},
        {"a -- b --- c", "a -{}-{} b -{}-{}-{} c"},
        {"<<a>>", "$<$$<$a$>$$>$"},
        {"?` !`", "?{}`{} !{}`{}"},
        {"A'' B``", "A'{}'{} B`{}`{}"},
        {"\"a\"", "{\\ttfamily\\char34}a{\\ttfamily\\char34}"},
        {",,a|b", ",{},{}a$|$b"},
        {"a\nb\x1b", "a$<$U+000A$>$b$<$U+001B$>$"},
        {"\xff", "$<$0xFF$>$"},
        {"\u202Ex", "$<$U+202E$>$x"},
        {"é ñ Ç ß", "é ñ Ç ß"},
        {"½ × 3 ≤ −1", "$\\frac12$ $\\times$ 3 $\\leq$ $-$1"},
        {"א", "{\\scriptsize U+05D0\\,}"},
        {"\U0001F600", "{\\scriptsize U+1F600\\,}"},
        {"α", "{\\scriptsize U+03B1\\,}"},
        {" a  b ", "\\ a \\ b\\ "},
        {"", ""},
    };
    for (const auto& [text, expected] : texts)
        EXPECT_EQ(tex_escaped(text), expected);
}

TEST(TexEscaped, FractionsAreMathematicsAndSoAreNames) {
    EXPECT_EQ(tex_escaped("x = 2 \u2212 25/8 = \u22129/8"),
              "x = 2 $-$ $\\frac{25}{8}$ = $-$$\\frac{9}{8}$");
    EXPECT_EQ(tex_escaped("1/2/3, a1/2, 1/2a, 0.1/2, 1/2.5, 1/, /2"),
              "1/2/3,{} a1/2,{} 1/2a,{} 0.1/2,{} 1/2.5,{} 1/,{} /2");
    EXPECT_EQ(tex_escaped("AB, P1: x=3, max XYZW", TexFont::with_names),
              "$AB$,{} $P_{1}$: $x$=3,{} max $XYZW$");
    EXPECT_EQ(tex_escaped("First Ab aB B2b TRIANGLE xy", TexFont::with_names),
              "First Ab aB B2b TRIANGLE xy");
    EXPECT_EQ(tex_escaped("AB 1/2", TexFont::fixed_width), "AB 1/2");
}

TEST(Tikz, LettersAreThoseOfTheDocument) {
    const Drawing drawing = sheet({Label{.at = {1, 2}, .text = "a", .size = 10}});
    for (const auto& [width_mm, command] :
         {std::pair(1.0, "\\scriptsize "), std::pair(40 * 8.0 / 10 / 2.8453, "\\footnotesize "),
          std::pair(40 / 2.8453, "\\normalsize "), std::pair(40 * 1.2 / 2.8453, "\\large ")}) {
        const auto tex = tikz_of(drawing, Theme::light, width_mm);
        ASSERT_TRUE(tex);
        EXPECT_THAT(tex.value(), HasSubstr(std::string("] at (1,2) {") + command + "a};"));
    }
}

TEST(Tikz, FramesAreOverlays) {
    const std::vector<Drawing> frames{sheet({Label{.at = {1, 2}, .text = "a"}}),
                                      sheet({Label{.at = {1, 2}, .text = "b"}})};
    const auto tex = tikz_of(frames, Theme::light, 40);
    ASSERT_TRUE(tex);
    EXPECT_THAT(tex.value(), HasSubstr("\\only<1>{%\n\\node"));
    EXPECT_THAT(tex.value(), HasSubstr(" a};\n}%\n\\only<2>{%\n\\node"));
    EXPECT_THAT(tex.value(), HasSubstr(" b};\n}%\n\\end{tikzpicture}"));
}

TEST(TexEscaped, InFixedWidthAllSignsAreAsWideAsLetters) {
    EXPECT_EQ(tex_escaped("a_1 {x} \"-\" 5 − 3", TexFont::fixed_width),
              "a\\char95{}1 \\char123{}x\\char125{} \\char34{}\\char45{}\\char34{} 5 "
              "\\makebox[0.5em]{$-$} 3");
    EXPECT_EQ(tex_escaped("'", TexFont::fixed_width), "\\makebox[0.5em]{'{}}");
}

// Whatever comes in, TeX gets letters that it knows, and braces and dollars in pairs.
TEST(TexEscaped, LeavesNoCommandOfTheText) {
    const std::regex harmless(
        R"((\\[a-zA-Z]+|\\[%&#_{}$ ,]|[A-Za-z0-9 .:;=+*/()@\[\]'`,?!-]|[{}$^<>|_]|[\xC2-\xC5][\x80-\xBF])*)");
    for (const std::string& text : hostile_texts())
        for (const TexFont font :
             {TexFont::proportional, TexFont::with_names, TexFont::fixed_width}) {
            const std::string tex = tex_escaped(text, font);
            EXPECT_TRUE(std::regex_match(tex, harmless)) << tex;
            EXPECT_THAT(tex, Not(HasSubstr("\\end")));
            EXPECT_THAT(tex, Not(HasSubstr("\\input")));
            EXPECT_THAT(tex, Not(HasSubstr("^^")));
            EXPECT_THAT(tex, Not(HasSubstr("--")));
        }
}

TEST(Tikz, CommentsStayOnTheirLine) {
    const std::string tex = tikz_of(hostile_drawing(), Theme::light, 80).value();
    EXPECT_THAT(tex, testing::StartsWith("% Title<U+000A>\\end{document} ^^M <&> <0xFF>\n"
                                         "% First line<U+000D><U+000A>second line \\bye\n"
                                         "% To be put into a document"));
}

std::string message_of(const Result<std::string>& result) {
    return result ? "none" : to_text(result.problem());
}

TEST(Tikz, SaysWhatTexCannotHold) {
    Pixels pixels{.corner = {0, 0}, .side = 1, .columns = 200};
    for (std::size_t i = 0; i < 20'000; ++i)
        pixels.colors.push_back({static_cast<std::uint8_t>(i % 251), 0, 0});
    EXPECT_EQ(message_of(tikz_of(sheet({pixels}), Theme::light, 80)), "none");
    EXPECT_EQ(message_of(tikz_of(sheet({pixels, Areas{.rectangles = {{{0, 0}, 1, 1}}}}),
                                 Theme::light, 80)),
              "expected a picture that fits into TeX's memory, found more than 40000 places (a "
              "rectangle counts as two, a dot as four, a label as twenty)\n"
              "hint: a .png holds any picture; --region takes a part of it");
    const auto fits = [](const Shape& shape, std::size_t count) {
        return static_cast<bool>(
            tikz_of(sheet(std::vector<Shape>(count, shape)), Theme::light, 80));
    };
    const Path path(40'000, Place{1, 1});
    EXPECT_TRUE(fits(Lines{.paths = {path}}, 1));
    EXPECT_FALSE(fits(Lines{.paths = {path, {{0, 0}, {1, 1}}}}, 1));
    EXPECT_TRUE(fits(Dots{.centers = {{1, 1}}}, 10'000));
    EXPECT_FALSE(fits(Dots{.centers = {{1, 1}}}, 10'001));
    EXPECT_TRUE(fits(Label{.at = {1, 1}, .text = "a"}, 2'000));
    EXPECT_FALSE(fits(Label{.at = {1, 1}, .text = "a"}, 2'001));
    EXPECT_EQ(message_of(tikz_of(sheet({}), Theme::light, 5001)),
              "expected a picture of at most 5000 x 5000 mm for TeX, found 5001 x 2500.5 mm");
    EXPECT_EQ(message_of(tikz_of(sheet({}), Theme::light, 0)),
              "expected a picture of at most 5000 x 5000 mm for TeX, found 0 x 0 mm");
    EXPECT_EQ(
        message_of(tikz_of({.width = 16'001, .height = 10, .title = "wide"}, Theme::light, 80)),
        "expected a sheet of at most 16000 x 16000 units for TeX, found 16001 x 10\n"
        "hint: a .png holds any picture; --region takes a part of it");
}

TEST(Tikz, IsTheSameEachTime) {
    EXPECT_EQ(tikz_of(hostile_drawing(), Theme::light, 80).value(),
              tikz_of(hostile_drawing(), Theme::light, 80).value());
}

} // namespace
} // namespace rastertrace
