// SPDX-License-Identifier: MIT
// What `rastertrace figure` lets an author choose: the picture in space, notes, styles, sizes, letters, languages.

#include "program.h"

#include <algorithm>
#include <cstddef>
#include <regex>
#include <string>

namespace rastertrace {
namespace {

class FigureLooks : public ProgramTest {
protected:
    /// Of the first triangle.
    Outcome figure(const std::string& arguments) const {
        return run("figure $examples/t0-fill/first-triangle.json " + arguments);
    }

    /// The message of a figure that is refused.
    std::string refusal(const std::string& arguments) const {
        const Outcome told = figure(arguments);
        EXPECT_EQ(told.status, 2) << arguments;
        return told.err;
    }

    std::string svg(const std::string& arguments) const {
        return figure("--step \"scanline y=2\" --format svg -o - " + arguments).out;
    }
};

/// What a pattern finds first in a text, in its first group, as a number; 0 if it finds nothing.
double number_by(const char* pattern, const std::string& text) {
    std::smatch found;
    return std::regex_search(text, found, std::regex(pattern)) ? std::stod(found[1]) : 0;
}

// --- in space, notes, styles --------------------------------------------------------------------

TEST_F(FigureLooks, ThePictureInSpaceHasNoPixels) {
    const std::string beside = "hint: --with space shows the picture in space beside the pixels\n";
    EXPECT_EQ(refusal("--view space --region 0,0,3,3 -o x.svg"),
              "rastertrace: --view space: expected no --region, found one\n" + beside);
    EXPECT_EQ(refusal("--view space --bare -o x.svg"),
              "rastertrace: --view space: expected no --bare, found one\n" + beside);
    EXPECT_EQ(
        run("figure $examples/t4-pipeline/six-spaces.json --view space --with row -o x.svg").err,
        "rastertrace: --with row: expected title, step, caption or working in the picture in "
        "space, found a part of pixels\n"
        "hint: --with space shows that picture beside the pixels\n");
    EXPECT_EQ(refusal("--view space -o x.html"),
              "rastertrace: --view space: expected one of svg, png, tex, gif, found html\n"
              "hint: a page has the picture in space beside the pixels\n");
    for (const std::string eye : {"0,0,0", "1,2", "back", "1,2,nan"})
        EXPECT_EQ(refusal("--view space --eye " + eye + " -o x.svg"),
                  "rastertrace: --eye: expected corner, front, side, top, or a direction x,y,z "
                  "other than 0,0,0, found \"" +
                      eye + "\"\n");
}

TEST_F(FigureLooks, NotesPointToPlaces) {
    for (const std::string note : {"3,2", "3: a", "3,2:", "a,2: b", "1e9,2: far"})
        EXPECT_EQ(refusal("--note '" + note + "' -o x.svg"),
                  "rastertrace: --note: expected a place and words, like \"3,2: the tie goes up\", "
                  "found \"" +
                      note + "\"\n");
    EXPECT_THAT(figure("--note '-4,-3: the first: B' --note '2,5: the top' --format svg -o -").out,
                AllOf(HasSubstr(">the first: B</text>"), HasSubstr(">the top</text>")));
}

TEST_F(FigureLooks, FramesOfAStepInSpaceStandOnASheet) {
    EXPECT_EQ(refusal("--sheet spaces -o x.svg"),
              "rastertrace: --sheet spaces: expected a vertex step, found none\n");
    EXPECT_EQ(refusal("--sheet ears --step 1 -o x.svg"),
              "rastertrace: --sheet ears: expected a triangulate step, found another\n");
    EXPECT_EQ(refusal("--sheet ears -o x.txt").substr(0, 46),
              "rastertrace: --sheet: expected a format of dra");
    EXPECT_THAT(run("figure $examples/faces/arrow.json --sheet ears --format svg -o -"),
                Prints(HasSubstr(">5. EFA: what is left</text>")));
}

// --- sizes --------------------------------------------------------------------------------------

TEST_F(FigureLooks, WidthAndHeightAreThoseOfThePicture) {
    const std::string usual = svg("");
    const double width = number_by("<svg [^>]* width=\"([0-9.]+)\"", usual);
    const double height = number_by("<svg [^>]* height=\"([0-9.]+)\"", usual);
    ASSERT_GT(width, 0);
    const std::string high = svg("--height 1000");
    EXPECT_EQ(number_by("<svg [^>]* height=\"([0-9.]+)\"", high), 1000);
    EXPECT_NEAR(number_by("<svg [^>]* width=\"([0-9.]+)\"", high), 1000 * width / height, 0.01);
    EXPECT_EQ(high.substr(high.find(" viewBox")), usual.substr(usual.find(" viewBox")));
    // With both, it fits into them.
    EXPECT_EQ(svg("--height 1000 --width 5000"), high);
    EXPECT_EQ(number_by("<svg [^>]* width=\"([0-9.]+)\"", svg("--height 5000 --width 100")), 100);
}

TEST_F(FigureLooks, ABitmapHasAsManyPixelsAsWereAskedFor) {
    const auto at = [](const std::string& bytes, std::size_t place) {
        return static_cast<std::size_t>(static_cast<unsigned char>(bytes.at(place)));
    };
    for (std::size_t size = 37; size < 2000; size = 3 * size / 2) {
        const std::string number = std::to_string(size);
        const std::string png = figure("--format png -o - --width " + number).out;
        EXPECT_EQ(256 * at(png, 18) + at(png, 19), size); // IHDR: width, then height
        const std::string gif = figure("--format gif -o - --every last --height " + number).out;
        EXPECT_EQ(at(gif, 8) + 256 * at(gif, 9), size); // of the logical screen
    }
}

TEST_F(FigureLooks, ATexIsAsLargeInMillimeters) {
    const std::string pattern = "\\clip \\(0,0\\) rectangle \\([0-9.]+,([0-9.]+)\\)";
    for (const std::string height : {"20", "60", "200"}) {
        const std::string tex = figure("--format tex -o - --height " + height).out;
        const double unit = number_by("\\[x=([0-9.]+)mm", tex);
        EXPECT_NEAR(unit * number_by(pattern.c_str(), tex), std::stod(height), 0.01);
        EXPECT_GT(number_by("rectangle \\(([0-9.]+),", tex), 0.9 * number_by(pattern.c_str(), tex));
    }
    const std::string usual = figure("--format tex -o -").out;
    EXPECT_LE(number_by("\\[x=([0-9.]+)mm", usual) * number_by("rectangle \\(([0-9.]+),", usual),
              120.01);
}

// Letters are \scriptsize at least: a wide figure is drawn with larger ones, not with some that cover one another.
TEST_F(FigureLooks, LettersOfATexHaveTheRoomThatTheyTake) {
    constexpr double mm_per_unit = 25.4 / 96;
    for (const std::string wide :
         {"", "--every scanline --sheet 3x3", "--every scanline --sheet 3x9", "--width 60"})
        EXPECT_GT(number_by("\\[x=([0-9.]+)mm", figure("--format tex -o - " + wide).out),
                  0.85 * mm_per_unit)
            << wide;
    const Outcome ears = run("figure $examples/faces/arrow.json --sheet ears --format tex -o -");
    EXPECT_NEAR(number_by("\\[x=([0-9.]+)mm", ears.out), mm_per_unit, 0.01);
}

TEST_F(FigureLooks, SizesThatAreNone) {
    for (const std::string wrong : {"-1", "0", "nan", "6000"})
        for (const std::string option : {"--width", "--height"})
            EXPECT_EQ(refusal(option + " " + wrong + " -o x.svg"),
                      "rastertrace: " + option +
                          ": expected a number above 0, at most 5000, found \"" + wrong + "\"\n");
    EXPECT_EQ(refusal("--width 100 --scale 2 -o x.png"),
              "rastertrace: --scale: expected no --width or --height, found one\n"
              "hint: --width says how wide the picture is, --scale how wide a unit\n");
    EXPECT_EQ(refusal("--height 100 -o x.txt"),
              "rastertrace: --width and --height: expected one of svg, png, tex, gif, found txt\n");
    EXPECT_EQ(figure("--bare --width 170 -o x.png").status, 0);
}

// --- words --------------------------------------------------------------------------------------

TEST_F(FigureLooks, FormulasOfAnAuthorStayInLatex) {
    const auto tex = [this](const std::string& arguments) {
        const std::string all = figure("--format tex -o - " + arguments).out;
        return all.substr(
            std::min(all.find("\\node[rt-label,text=rt-rounding"), all.rfind("\\node")));
    };
    EXPECT_THAT(tex(R"(--caption 'As $N \cdot L$ says - it is')"),
                HasSubstr(R"({\footnotesize As\ $N \cdot L$\ says $-$ it is};)"));
    EXPECT_THAT(tex(R"(--note '2,5: $\frac{1}{2}$')"), HasSubstr(R"( $\frac{1}{2}$};)"));
    // A formula is not broken over lines.
    const std::string long_words =
        "many words before a formula that would be broken in its middle ";
    EXPECT_THAT(tex("--caption '" + long_words + "$a + b + c + d + e + f + g$'"),
                HasSubstr("$a + b + c + d + e + f + g$};"));
    EXPECT_THAT(tex(R"(--caption 'The $x$-axis')"), HasSubstr(R"(The\ $x$-{}axis};)"));
    // What is none: a dollar alone, prices, nothing between two, braces without a partner, a comment; and words of the scene.
    const std::string dollar = R"($\$$)";
    EXPECT_THAT(tex("--caption 'it costs 5 $'"), HasSubstr(" it costs 5 " + dollar + "};"));
    EXPECT_THAT(tex("--caption 'from $5, $6 to $7'"),
                HasSubstr(" from " + dollar + "5,{} " + dollar + "6 to " + dollar + "7};"));
    EXPECT_THAT(tex(R"(--caption 'costs \$5 or \$6$')"),
                HasSubstr(" costs " + dollar + "5 or " + dollar + "6" + dollar + "};"));
    EXPECT_THAT(tex("--caption '$$'"), HasSubstr(" " + dollar + dollar + "};"));
    EXPECT_THAT(tex("--caption '$}{$'"), Not(HasSubstr("$}{$")));
    EXPECT_THAT(tex("--caption '$a%b$'"), HasSubstr(R"($a\%b$)"));
    EXPECT_THAT(svg(R"(--caption 'costs \$5')"), HasSubstr(">costs $5</text>"));
    EXPECT_THAT(figure("--format tex -o - --title '$a$'").out, HasSubstr("$\\$$a$\\$$};"));
}

TEST_F(FigureLooks, WordsAreInTheLanguageThatWasChosen) {
    const auto in_portuguese = [this](const std::string& arguments) {
        return run("figure --language pt --format svg -o - " + arguments).out;
    };
    EXPECT_THAT(
        in_portuguese(
            "$examples/t4-pipeline/six-spaces.json --view space --step 'vertex name=C space=clip'"),
        AllOf(HasSubstr(">olho</text>"), HasSubstr(">passo ")));
    EXPECT_THAT(in_portuguese("$examples/t0-hidden/two-depths.json --view depth --with legend"),
                HasSubstr(">mais distante</text>"));
    EXPECT_THAT(in_portuguese("$examples/faces/arrow.json --sheet ears"),
                HasSubstr(">5. EFA: o que resta</text>"));
    EXPECT_THAT(in_portuguese("$examples/t0-hidden/two-depths.json --with plot --step "
                              "'scanline y=2 in=ABC'"),
                HasSubstr("linha y = "));
}

} // namespace
} // namespace rastertrace
