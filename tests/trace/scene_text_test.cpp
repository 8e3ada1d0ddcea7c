// SPDX-License-Identifier: MIT
// Scenes that are not JSON, the text of `fuzz` and OBJ files: the scene that they become, and what is wrong with them.

#include "traces.h"

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rastertrace {
namespace {

/// The picture of a scene's text.
std::vector<Color> colors_of(const std::string& text) {
    const auto read = read_scene({"scene", text});
    if (!read) {
        ADD_FAILURE() << to_text(read.problem());
        return {};
    }
    const Image image = draw(read.value().scene, read.value().plan);
    return {image.colors().begin(), image.colors().end()};
}

/// `line:column: message` of what a text is refused with; "" if it is a scene.
std::string fault_of(const std::string& text) {
    const auto read = read_scene({"t", text});
    return read ? "" : to_text(read.problem()).substr(2, to_text(read.problem()).find('\n') - 2);
}

TEST(TrianglesText, IsTheSceneThatItSays) {
    const std::string text = "\xEF\xBB\xBF# a comment\r\ncanvas 20 14\r\n\ttri A 1 1 0 18 2.5 0 9 "
                             "12 0 # the first\r\n\r\nline L 0 0 0 7 3 0";
    const std::string scene =
        R"({"canvas":{"width":20,"height":14,"origin":"top-left"},"vertices":{"A":[1,1,0],)"
        R"("B":[18,2.5,0],"C":[9,12,0],"D":[0,0,0],"E":[7,3,0]},"triangles":["ABC"],"lines":["DE"]})";
    EXPECT_TRUE(is_foreign_scene({"t", text}));
    EXPECT_FALSE(is_foreign_scene({"t", scene}));
    EXPECT_TRUE(colors_of(text) == colors_of(scene));

    const std::string in_clip_space = "canvas 20 14\nclip C -1 -1 0 1 1.6 -1 0.4 2 0 1/2 0 1";
    const std::string clip_scene =
        R"({"canvas":{"width":20,"height":14,"origin":"top-left"},"vertices":{"A":[-1,-1,0,1],)"
        R"("B":[1.6,-1,0.4,2],"C":[0,"1/2",0,1]},"triangles":["ABC"]})";
    EXPECT_TRUE(colors_of(in_clip_space) == colors_of(clip_scene));
}

TEST(TrianglesText, IsRefusedAtThePlaceOfItsFault) {
    const std::string canvas = "canvas 8 8\n";
    EXPECT_EQ(fault_of(canvas + "texture 1\n"),
              "2:1: expected a statement out of canvas, tri, line, clip, found \"texture\"");
    EXPECT_EQ(fault_of(canvas + "line L 1 2,5 3 0 0 0\n"),
              "2:10: expected a number, found \"2,5\"");
    EXPECT_EQ(fault_of(canvas + "line L 1 nan 3 0 0 0\n"),
              "2:10: expected a number, found \"nan\"");
    EXPECT_EQ(fault_of(canvas + "tri A 0 0 0 1 0\n"),
              "2:1: expected a name and 9 numbers behind tri, found 6 words");
    EXPECT_EQ(fault_of("canvas 0 8\n"),
              "1:8: expected a whole number from 1 to 16384, found \"0\"");
    EXPECT_EQ(fault_of("canvas 8 8 8\n"), "1:12: expected 2 words behind canvas, found 3");
    EXPECT_EQ(fault_of(canvas), "2:1: expected at least one primitive, found none");
    EXPECT_EQ(fault_of(canvas + "line L 0 0 0 1 1 0\n" + std::string(3, '\t') + "canvas"),
              "3:10: expected 2 words behind canvas, found 0");
}

/// What is wrong with the scene that a text becomes is told of that.
TEST(TrianglesText, WhatCannotBeDrawnIsToldOfTheScene) {
    const std::string fault = fault_of("canvas 8 8\nclip C 0 0 0 0 1 0 0 1 0 1 0 1\n");
    EXPECT_EQ(fault.starts_with(" as a scene:"), false) << fault;
    EXPECT_NE(fault.find("which is no place"), std::string::npos) << fault;
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
