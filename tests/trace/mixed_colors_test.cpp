// SPDX-License-Identifier: MIT
// Colors in a perspective and of cut edges. Right values are from 1/z, which is linear on the screen, and of clipped
// triangles from homogeneous coordinates: a pixel (X, Y, 1) is a sum of the vertices' (x, y, w), and its color the mean of
// theirs by the same parts (Olano and Greer 1997).

#include "claims_support.h"
#include "random_choice.h"
#include "traces.h"

#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/trace/audit/redo.h>
#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/working.h>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

using ::testing::IsSupersetOf;

Frame picture_of(const std::string& scene) {
    const Trace trace = trace_of(scene_in(scene));
    return frame_after(trace, trace.size());
}

std::size_t pixel_in_column(const Trace& trace, Index x) {
    for (std::size_t n = 1; n <= trace.size(); ++n)
        if (trace.kind_of(n) == StepKind::pixel && x_in(trace.step(n)) == x)
            return n;
    return 0;
}

// ---- Lines in a perspective ---------------------------------------------------------------------

/// From z = 2 to z = 10. In column 5, half way on the screen, 1/z = (1/2 + 1/10)/2 = 3/10, so z = 10/3, and the share of p2
/// is (1/20)/(3/10) = 1/6: 255 (5/6) = 212.5 of red, 42.5 of green.
std::string line_scene(const std::string& method, const std::string& what = "lines",
                       const std::string& names = R"(["p1","p2"])") {
    return R"({"canvas":{"width":10,"height":10,"origin":"top-left"},"vertices":{"p1":[-1,-1,2],)"
           R"("p2":[7,1,10],"p3":[7,1,10]},"colors":{"p1":"#ff0000","p2":"#00ff00","p3":"#00ff00"},)"
           R"("projection":{"type":"pinhole","distance":1},"viewport":{"pixels":"edges"},")" +
           what + R"(":[)" + names + R"(],"method":{"sample":"center")" + method + "}}";
}

TEST(ColorsInSpace, OfALineAreMixedByOneOverZ) {
    const auto color = [](const std::string& method, const std::string& what = "lines",
                          const std::string& names = R"(["p1","p2"])") {
        const Trace trace = trace_of(scene_in(line_scene(method, what, names)));
        return trace.step(pixel_in_column(trace, 5)).as<PixelStep>().color.text();
    };
    for (const std::string line : {"bresenham", "naive", "dda", "diamond-exit"})
        for (const std::string scalar : {"double", "adaptive", "exact"}) {
            const std::string method = fmt::format(R"(,"line":"{}","scalar":"{}")", line, scalar);
            EXPECT_EQ(color(method), "#d52b00") << method;
            EXPECT_EQ(color(method + R"(,"from":"low")", "lines", R"(["p2","p1"])"), "#d52b00");
            EXPECT_EQ(color(method, "outlines", R"(["p1","p2","p3"])"), "#d52b00") << method;
        }
    EXPECT_EQ(color(R"(,"color_lerp":"axis")"), "#808000");
    // sqrt(13) of sqrt(45) to the end.
    EXPECT_EQ(color(R"(,"color_lerp":"distance")"), "#897600");
    EXPECT_EQ(color(R"(,"shade":"affine")"), "#808000");
}

/// Line and triangle lie on one row of samples.
TEST(ColorsInSpace, OfALineAreThoseOfATriangleWithThatEdge) {
    Random random(16);
    int compared = 0;
    for (int run = 0; run < 60; ++run) {
        const auto vertex = [&](int x, int y) { // on the screen in eighths of half a canvas
            const int z = random.whole(1, 9);
            return fmt::format(R"(["{}/16","{}/16",{}])", x * z, y * z, z);
        };
        const int y = 15 - 2 * random.whole(3, 12);
        const std::string start = fmt::format(
            R"({{"canvas":{{"width":16,"height":16,"origin":"top-left"}},)"
            R"("vertices":{{"A":{},"B":{},"C":{}}},"colors":{{"A":"#ff1000","B":"#0020ff",)"
            R"("C":"#40ff00"}},"projection":{{"type":"pinhole","distance":1}},)"
            R"("viewport":{{"pixels":"edges"}},)",
            vertex(random.whole(-15, -3), y), vertex(random.whole(3, 15), y),
            vertex(random.whole(-9, 9), y > 0 ? -15 : 15));
        const std::string end = R"("method":{"sample":"center","scalar":"exact","depth":"none")";
        const Frame line = picture_of(start + R"("lines":["AB"],)" + end + "}}");
        const Frame triangle =
            picture_of(start + R"("triangles":["ABC"],)" + end + R"(,"fill":"barycentric"}})");
        for (std::size_t i = 0; i < line.drawn_by.size(); ++i)
            if (line.drawn_by[i] != 0 && triangle.drawn_by[i] != 0) {
                EXPECT_TRUE(line.image.colors()[i] == triangle.image.colors()[i])
                    << run << ' ' << i;
                ++compared;
            }
    }
    EXPECT_GT(compared, 200);
}

/// In a perspective a fan has in each pixel the color that any other fill has there.
TEST(ColorsInSpace, OfAFanAreThoseOfOtherFills) {
    const auto drawn = [](const std::string& fill) {
        return picture_of(
            R"({"canvas":{"width":20,"height":20},"vertices":{"A":[-1,-1,3],"B":[3,-2,8],)"
            R"("C":[0,1,4]},"colors":{"A":"#ff0000","B":"#00ff00","C":"#0000ff"},)"
            R"("triangles":["ABC"],"projection":{"type":"pinhole","distance":1},)"
            R"("viewport":{"pixels_per_unit":24},"method":{"depth":"none","scalar":"exact","fill":")" +
            fill + R"("}})");
    };
    const Frame fan = drawn("fan");
    const Frame others = drawn("barycentric");
    int compared = 0;
    for (std::size_t i = 0; i < fan.drawn_by.size(); ++i)
        if (fan.drawn_by[i] != 0 && others.drawn_by[i] != 0) {
            EXPECT_TRUE(fan.image.colors()[i] == others.image.colors()[i]) << i;
            ++compared;
        }
    EXPECT_GT(compared, 40);
}

TEST(ColorsInSpace, AreToldWorkedOutAndChecked) {
    const std::string scene = line_scene(R"(,"scalar":"exact")");
    const Trace trace = trace_of(scene_in(scene));
    EXPECT_EQ(trace.method.word_of("color_lerp"), "space");
    Replay replay(trace);
    replay.go_to(pixel_in_column(trace, 5));
    EXPECT_THAT(describe_step(replay), ::testing::HasSubstr("#d52b00 (1/6 of the color of p2)"));
    EXPECT_THAT(working_of(replay),
                IsSupersetOf({"1/2 of the way from p1 to p2 on the screen",
                              "weights of p1, p2: 1/2, 1/2, divided by z = 2, 10: 1/4, 1/20, "
                              "together 3/10",
                              "divided by 3/10: 5/6 of p1, 1/6 of p2",
                              "red = 0.833333 (255) + 0.166667 (0) = 212.5 -> 213"}));

    const auto checked = check_claims(scene, "(5,6): share 1/6\n(5,6): color #d52b00\n"
                                             "(5,6): color #808000\n")
                             .claims;
    EXPECT_EQ(checked.at(0).fields.at(0).verdict, ClaimVerdict::right);
    EXPECT_EQ(checked.at(1).fields.at(0).verdict, ClaimVerdict::right);
    ASSERT_EQ(checked.at(2).fields.at(0).verdict, ClaimVerdict::wrong);
    EXPECT_EQ(checked.at(2).fields.at(0).slips.at(0).name, "color-by-distance");
}

TEST(ColorsInSpace, AreDoneAgain) {
    for (const std::string scalar : {"float", "double", "fixed", "adaptive", "exact"})
        for (const std::string line : {"bresenham", "naive", "dda", "diamond-exit"})
            for (const std::string what : {"lines", "outlines"}) {
                const std::string method =
                    fmt::format(R"(,"line":"{}","scalar":"{}")", line, scalar);
                std::string text = trace_text(scene_in(line_scene(
                    method, what, what == "lines" ? R"(["p1","p2"])" : R"(["p1","p2","p3"])")));
                const Redone right = redo(sound_trace(text));
                EXPECT_EQ(right.wrong, 0U) << method << right.first.what;
                const Trace trace = sound_trace(text);
                const std::string color =
                    trace.step(pixel_in_column(trace, 5)).as<PixelStep>().color.text();
                text.replace(text.find(color + "\"},"), 7, "#d62f00");
                EXPECT_EQ(redo(readable_trace(text)).first.what, "pixel: color") << method;
            }
}

// ---- Cut edges ----------------------------------------------------------------------------------

using Place = std::array<int, 4>; ///< x, y, z, w

/// The exact levels of red, green and blue at a canonical place, of corners in these primary colors; nothing outside.
std::optional<std::array<Rational, 3>> levels_at(const std::array<Place, 3>& corners,
                                                 const Rational& x, const Rational& y) {
    const auto cross_w = [](const auto& a, const auto& b) {
        return std::array<Rational, 3>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                       a[0] * b[1] - a[1] * b[0]};
    };
    std::array<std::array<Rational, 3>, 3> rows;
    for (std::size_t i = 0; i < 3; ++i)
        rows[i] = {corners[i][0], corners[i][1], corners[i][3]};
    std::array<Rational, 3> parts;
    Rational sum;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto normal = cross_w(rows[(i + 1) % 3], rows[(i + 2) % 3]);
        const Rational whole =
            normal[0] * rows[i][0] + normal[1] * rows[i][1] + normal[2] * rows[i][2];
        if (whole == 0)
            return std::nullopt;
        parts[i] = (normal[0] * x + normal[1] * y + normal[2]) / whole;
        if (parts[i] < 0)
            return std::nullopt;
        sum += parts[i];
    }
    return std::array<Rational, 3>{255 * parts[0] / sum, 255 * parts[1] / sum,
                                   255 * parts[2] / sum};
}

TEST(CutColors, AreNumbersUntilAPixelIsWritten) {
    Random random(17);
    int compared = 0;
    for (int run = 0; run < 150; ++run) {
        std::array<Place, 3> corners;
        for (Place& place : corners)
            place = {random.whole(-6, 6), random.whole(-6, 6), random.whole(-3, 3),
                     random.whole(-3, 7)};
        std::string vertices;
        for (std::size_t i = 0; i < 3; ++i)
            vertices += fmt::format(R"({}"{}":[{},{},{},{}])", i == 0 ? "" : ",", "ABC"[i],
                                    corners[i][0], corners[i][1], corners[i][2], corners[i][3]);
        if (vertices.find("[0,0,0,0]") != std::string::npos)
            continue;
        const Frame frame = picture_of(
            R"({"canvas":{"width":12,"height":12,"origin":"top-left"},"vertices":{)" + vertices +
            R"(},"colors":{"A":"#ff0000","B":"#00ff00","C":"#0000ff"},"triangles":["ABC"],)"
            R"("viewport":{"pixels":"edges","y":"down"},)"
            R"("method":{"fill":"top-left","scalar":"exact","depth":"none"}})");
        for (int y = 0; y < 12; ++y)
            for (int x = 0; x < 12; ++x) {
                const auto offset = static_cast<std::size_t>(12 * y + x);
                const auto exact =
                    levels_at(corners, Rational(2 * x + 1) / 12 - 1, Rational(2 * y + 1) / 12 - 1);
                if (frame.drawn_by[offset] == 0 || !exact)
                    continue;
                const Color color = frame.image.colors()[offset];
                const std::array levels{color.red(), color.green(), color.blue()};
                for (std::size_t i = 0; i < 3; ++i)
                    EXPECT_EQ(Index{levels[i]}, nearest_index((*exact)[i], Ties::up))
                        << run << ": " << x << ", " << y;
                ++compared;
            }
    }
    EXPECT_GT(compared, 500);
}

/// 71.4 of each channel in (3, 3): C is white, the others black.
const std::string white_above =
    R"({"canvas":{"width":8,"height":8,"origin":"bottom-left"},"vertices":{"A":[-1,-1,0,1],)"
    R"("B":[1,-1,0,1],"C":[0,2,3,2]},"colors":{"A":"black","B":"black","C":"white"},)"
    R"("triangles":["ABC"],"convention":"opengl","method":{"scalar":")";

TEST(CutColors, AreToldAndDoneAgain) {
    for (const std::string scalar : {"float", "double", "fixed", "adaptive", "exact"}) {
        std::string text = trace_text(scene_in(white_above + scalar + "\"}}"));
        const Trace trace = sound_trace(text);
        const Frame frame = frame_after(trace, trace.size());
        EXPECT_TRUE(frame.image.at({3, 3}) == (Color{71, 71, 71})) << scalar;
        const Redone redone = redo(trace);
        EXPECT_EQ(redone.wrong, 0U) << scalar << redone.first.what;
        EXPECT_GT(redone.count.at("pixel: color"), 20U);
    }
    std::string text = trace_text(scene_in(white_above + "exact\"}}"));
    const std::size_t levels = text.find(R"("levels":)");
    ASSERT_NE(levels, std::string::npos);
    text.replace(text.find(R"("0")", levels), 3, R"("9")");
    EXPECT_EQ(redo(readable_trace(text)).first.what, "primitive: colors");
}

} // namespace
} // namespace rastertrace
