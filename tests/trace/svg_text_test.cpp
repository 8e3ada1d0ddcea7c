// SPDX-License-Identifier: MIT
// SVG and OBJ files as scenes: the scene that they become, and what is wrong with them.

#include "drawn_colors.h"
#include "traces.h"

#include <rastertrace/trace/scene/course_text.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rastertrace {
namespace {

/// `line:column: message` of what an SVG of 9 x 9 pixels is refused with; "" if it is a scene.
std::string fault_in_svg(const std::string& inside, const std::string& more = {}) {
    const std::string text = "<svg width=\"9\" height=\"9\"" + more + ">\n" + inside + "</svg>";
    return fault_of(text);
}

TEST(SvgText, IsTheSceneThatItSays) {
    const std::string svg =
        "\xEF\xBB\xBF<?xml version=\"1.0\"?>\r\n<!-- by hand --><!DOCTYPE svg PUBLIC \"-//W3C//DTD "
        "SVG 1.1//EN\" "
        "\"svg11.dtd\">\n<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:i=\"i\" viewBox=\"1 2 20 "
        "14\">"
        "<title>A &amp; B</title><i:more><i:path d=\"M0\"/></i:more>"
        "<g fill=\"#f00\" style=\"stroke : none\"><g><polygon points=\"2,3 11,4.5 6-1\"/></g>"
        "<polygon fill=\"lime\" points=\"8 8 16,8\n16 13 12 10, 8 13\" fill-rule=\"evenodd\"/></g>"
        "<rect x=\"15\" y=\"3px\" width=\"4\" height=\"3.5\" fill=\"none\" stroke=\"blue\"/>"
        "<line x1=\"2\" y1=\"15\" x2=\"20\" y2=\"12\" stroke=\"#333\" stroke-width=\"3\"/></svg>";
    const std::string scene =
        R"({"canvas":{"width":20,"height":14,"origin":"top-left"},"vertices":{"A":[1,1],"B":[10,2.5],"C":[5,-3],)"
        R"("D":[7,6],"E":[15,6],"F":[15,11],"G":[11,8],"H":[7,11],"I":[14,1],"J":[18,1],"K":[18,4.5],"L":[14,4.5],)"
        R"("M":[1,13],"N":[19,10]},"polygons":[{"vertices":"ABC","color":"red"},{"vertices":"DEFGH","color":"lime"}],)"
        R"("lines":[{"vertices":"IJ","color":"blue"},{"vertices":"JK","color":"blue"},{"vertices":"KL","color":"blue"},)"
        R"({"vertices":"LI","color":"blue"},{"vertices":"MN","color":"#333"}],)"
        R"("method":{"sample":"center","rounding":"half-open","fill_rule":"even-odd"}})";
    EXPECT_TRUE(is_foreign_scene({"t", svg}));
    EXPECT_TRUE(colors_of(svg) == colors_of(scene));
}

/// Edge functions, where there are only triangles: each sample of a shared edge once.
TEST(SvgText, OfTrianglesIsFilledBySamples) {
    const auto read =
        read_scene({"t", R"(<svg width="8" height="8"><polygon points="0 0 8 0 8 8"/>)"
                         R"(<polygon points="0 0 8 8 0 8"/></svg>)"});
    ASSERT_TRUE(read);
    const Trace trace = trace_of(read.value().scene);
    std::size_t pixels = 0;
    for (std::size_t n = 1; n <= trace.size(); ++n)
        pixels += trace.kind_of(n) == StepKind::pixel ? 1 : 0;
    EXPECT_EQ(pixels, 64U);
    EXPECT_EQ(trace.method_value("fill"), "top-left");
}

TEST(SvgText, FaultsHaveTheirPlaces) {
    const std::string rect = R"(<rect width="2" height="2"/>)";
    EXPECT_EQ(fault_in_svg(rect), "");
    EXPECT_EQ(fault_in_svg("<script>x</script>"),
              "2:1: expected an element out of svg, which contains "
              "all, g, polygon, polyline, rect, line, found "
              "\"script\"");
    EXPECT_EQ(fault_in_svg("<g\ttransform='scale(2)'/>"),
              "2:15: expected coordinates without a transform, found \"scale(2)\"");
    EXPECT_EQ(fault_in_svg("<polygon points=\"1,2 3,4 x,6\"/>"),
              "2:26: expected a number, found \"x\"");
    EXPECT_EQ(fault_in_svg("<polygon points=\"1,2 3\"/>"),
              "2:18: expected an x and a y for each point, found 3 numbers");
    EXPECT_EQ(fault_in_svg("<rect y=\"1e400\"/>"), "2:10: expected a number, found \"1e400\"");
    EXPECT_EQ(fault_in_svg("<rect rx=\"1\"/>"),
              "2:11: expected a rect without round corners, found \"1\"");
    EXPECT_EQ(fault_in_svg("<g style=\"fill:url(#a)\"/>"),
              "2:11: expected none, a color like #f00, or a name of CSS 2.1, found \"url(#a)\"");
    EXPECT_EQ(fault_in_svg(rect, " opacity=\".5\""),
              "1:36: expected opaque colors, an opacity of 1, found \".5\"");
    EXPECT_EQ(fault_in_svg("<rect"),
              "2:6: expected well-formed XML, found: not well-formed (invalid token)");
    EXPECT_EQ(fault_in_svg("&lt;&x;"), "2:5: expected well-formed XML, found: undefined entity");
    EXPECT_EQ(fault_in_svg("<svg/>").substr(0, 15), "2:1: expected a");
    EXPECT_EQ(fault_in_svg(""), "2:7: expected a polygon, polyline, rect or line, found none");
    EXPECT_EQ(fault_in_svg("<polygon points='0 0 5 0 5 5 0 5'/>"
                           "<polygon fill-rule='evenodd' points='0 0 5 0 5 5 0 5'/>"),
              "2:36: expected one fill-rule for all polygons, found both");
    for (const std::string whole :
         {"<svg width='9'/>", "<svg width='0' height='9'/>", "<svg viewBox='0 0 9'/>", "<",
          "<html/>", "<!DOCTYPE svg [<!ENTITY a 'b'>]><svg width='9' height='9'>&a;</svg>",
          "<svg width='16385' height='9'/>", "<svg width='9' height='-1e300'/>"})
        EXPECT_FALSE(read_scene({"t", whole})) << whole;
}

TEST(SvgText, GroupsMayBeNestedAsDeepAsTheyAre) {
    std::string deep;
    for (int i = 0; i < 200'000; ++i)
        deep += "<g>";
    deep += R"(<rect width="2" height="2"/>)";
    for (int i = 0; i < 200'000; ++i)
        deep += "</g>";
    EXPECT_EQ(fault_in_svg(deep), "");
    EXPECT_NE(fault_in_svg(deep + "</g>"), "");
}

TEST(ObjScene, IsInClipSpaceIfItsVerticesHaveAW) {
    const std::string obj = "# by hand\r\nv -1 -.8 0 1\nv 1.6 -1. +0.4 2\nv 0 9e-1 0\nf 1 2 -1\n";
    const std::string scene =
        R"({"canvas":{"width":64,"height":48},"vertices":{"A":[-1,-0.8,0,1],"B":[1.6,-1,0.4,2],"C":[0,0.9,0,1]},)"
        R"("triangles":["ABC"]})";
    EXPECT_TRUE(is_foreign_scene({"t", obj}));
    EXPECT_FALSE(is_foreign_scene({"t", "v screen: 2, 5"})); // a claim
    EXPECT_FALSE(is_foreign_scene({"t", ""}));
    EXPECT_TRUE(colors_of(obj) == colors_of(scene));
}

TEST(ObjScene, HasTheColorsOfItsVerticesAndACameraThatFits) {
    const std::string obj = "o a\nv -1 -1 0 1 0 0\nv 1 -1 0 0 1 0\nv 0 1 1 0 0 1\nf 1 2 3\n";
    const std::string scene =
        R"({"canvas":{"width":64,"height":48},"vertices":{"A":[-1,-1,0],"B":[1,-1,0],"C":[0,1,1]},)"
        R"("colors":{"A":"#f00","B":"#0f0","C":"#00f"},"triangles":["ABC"],"camera":"fit"})";
    EXPECT_TRUE(colors_of(obj) == colors_of(scene));
}

} // namespace
} // namespace rastertrace
