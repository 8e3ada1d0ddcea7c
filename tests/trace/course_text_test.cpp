// SPDX-License-Identifier: MIT
// Scenes in the texts of courses: the scene that they become, and what is wrong with them.

#include "drawn_colors.h"
#include "traces.h"

#include <rastertrace/trace/scene/course_text.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rastertrace {
namespace {

TEST(CourseText, OfCs418IsTheSceneThatItSays) {
    const std::string text = "\xEF\xBB\xBF# a comment\r\npng 20 14 out.png\r\n\txyzw -1 -.8 0 1\r\n"
                             "rgb 255 0 0 # red from here on\r\nxyzw 1.6 -1. +0.4 2\r\n\r\n"
                             "xyz 0 9e-1 0\r\ntri 1 2 -1";
    const std::string scene =
        R"({"canvas":{"width":20,"height":14,"origin":"top-left"},"vertices":{"A":[-1,-0.8,0,1],)"
        R"("B":[1.6,-1,0.4,2],"C":[0,0.9,0,1]},"colors":{"A":"#ffffff","B":"red","C":"red"},)"
        R"("triangles":["ABC"],"viewport":{"pixels":"edges","y":"down"},"method":{"rows":"half-open",)"
        R"("rounding":"half-open","lerp":"incremental","color_rounding":"truncate","depth":"none","shade":"affine"}})";
    EXPECT_TRUE(is_foreign_scene({"t", text}));
    EXPECT_FALSE(is_foreign_scene({"t", scene}));
    EXPECT_TRUE(colors_of(text) == colors_of(scene));

    // The later form of the same.
    const std::string arrays = "png 20 14 out.png\nposition 4 -1 -.8 0 1 1.6 -1 .4 2 0 .9 0 1\n"
                               "color 3 1 1 1 1 0 0 1 0 0\ndrawArraysTriangles 0 3\n";
    EXPECT_TRUE(colors_of(arrays) == colors_of(scene));

    std::string in_space = scene;
    in_space.replace(in_space.find("affine"), 6, "interpolate");
    EXPECT_TRUE(colors_of(text + "\nhyp") == colors_of(in_space));
    EXPECT_FALSE(colors_of(text) == colors_of(in_space));
}

TEST(CourseText, OfCs130IsTheSceneThatItSays) {
    const std::string begin = "size 20 14\nvertex_shader color\nfragment_shader gouraud\n";
    const std::string vertices = "v 0.5 0.25 0.5 1 0 0\nv -0.75 -0.5 -0.5 0 1 0\n"
                                 "v 0.75 -0.75 -0.5 0 0 1\nv 0.9 0.9 0 1 1 1\n";
    const auto scene = [](const std::string& triangles, const std::string& colors) {
        return R"({"canvas":{"width":20,"height":14,"origin":"top-left"},"vertices":{"A":[0.5,0.25,0.5,1],)"
               R"("B":[-0.75,-0.5,-0.5,1],"C":[0.75,-0.75,-0.5,1],"D":[0.9,0.9,0,1]},)" +
               colors + R"("triangles":[)" + triangles +
               R"(],"viewport":{"pixels":"edges-half"},"method":{"fill":"barycentric",)"
               R"("sample":"integer","inside_tolerance":0.001,"depth":"ndc-z"}})";
    };
    const std::string mixed =
        R"("colors":{"A":"#ff0000","B":"#00ff00","C":"#0000ff","D":"#ffffff"},)";
    EXPECT_TRUE(colors_of(begin + "vertex_data ssssss\n" + vertices + "render triangle\n") ==
                colors_of(scene(R"("ABC")", mixed)));
    EXPECT_TRUE(colors_of(begin + "vertex_data ssssss\n" + vertices + "render fan\n") ==
                colors_of(scene(R"("ABC","ACD")", mixed)));
    EXPECT_TRUE(colors_of(begin + "vertex_data ssssss\n" + vertices + "render strip\n") ==
                colors_of(scene(R"("ABC","BCD")", mixed)));
    EXPECT_TRUE(
        colors_of(begin + "vertex_data ffffff\n" + vertices + "render strip\n") ==
        colors_of(scene(
            R"({"vertices":"ABC","color":"#ff0000"},{"vertices":"BCD","color":"#00ff00"})", "")));
    EXPECT_TRUE(
        colors_of("size 20 14\nvertex_shader trivial\nfragment_shader blue\nvertex_data fff\n"
                  "v .5 .25 .5\nv -.75 -.5 -.5\nv .75 -.75 -.5\nrender triangle\n") ==
        colors_of(scene(R"({"vertices":"ABC","color":"#0000ff"})", "")));
}

TEST(CourseText, IsRefusedAtThePlaceOfItsFault) {
    const std::string png = "png 8 8 f\n";
    const std::string three = png + "xy 0 0\nxy 1 0\nxy 0 1\n";
    EXPECT_EQ(fault_of(png + "texture 1\n"),
              "2:1: expected a statement out of png, xy, xyz, xyzw, rgb, tri, position, color, "
              "drawArraysTriangles, depth, hyp, found \"texture\"");
    EXPECT_EQ(fault_of(png + "xyzw 1 2 3\n"), "2:11: expected 4 words behind xyzw, found 3");
    EXPECT_EQ(fault_of(png + "xyz 1 2 3 4\n"), "2:11: expected 3 words behind xyz, found 4");
    EXPECT_EQ(fault_of(png + "xyz 1 2,5 3\n"), "2:7: expected a number, found \"2,5\"");
    EXPECT_EQ(fault_of(png + "xyz 1 nan 3\n"), "2:7: expected a number, found \"nan\"");
    EXPECT_EQ(fault_of(png + "rgb 1 256 3\n"),
              "2:7: expected a whole number from 0 to 255, found \"256\"");
    EXPECT_EQ(fault_of("png 0 8 f\n"), "1:5: expected a whole number from 1 to 16384, found \"0\"");
    EXPECT_EQ(fault_of(three + "tri 1 2 4\n"),
              "5:9: expected a whole number from -3 to 3, found \"4\"");
    EXPECT_EQ(fault_of(three + "tri 1 0 2\n"),
              "5:7: expected a vertex from 1 to 3, or from -1 back, found \"0\"");
    EXPECT_EQ(fault_of(three), "5:1: expected at least one triangle, found none");
    EXPECT_EQ(fault_of(png + "drawArraysTriangles 0 3\n"),
              "2:1: expected a position first, found \"drawArraysTriangles\"");
    EXPECT_EQ(fault_of(png + "position 3 1 2 3 4\n"),
              "2:18: expected position of 3 numbers each, found 4 numbers");
    EXPECT_EQ(fault_of(png + "position 2 0 0 1 0 0 1\ncolor 3 1 1 1\ndrawArraysTriangles 0 3\n"),
              "4:1: expected a color for vertex 1, found \"drawArraysTriangles\"");
    EXPECT_EQ(fault_of(png + "position 2 0 0 1 0 0 1\ndrawArraysTriangles 0 4\n"),
              "3:23: expected a whole number from 0 to 3, found \"4\"");
    EXPECT_EQ(fault_of("size 8 8\nvertex_shader transform\n"),
              "2:15: expected the vertex shader trivial or color, found \"transform\"");
    EXPECT_EQ(fault_of("size 8 8\nrender cube\n"),
              "2:8: expected triangle, fan or strip, found \"cube\"");
    EXPECT_EQ(fault_of("size 8 8\nvertex_data fxf\n"),
              "2:13: expected three letters or more out of f, s and n, found \"fxf\"");
    EXPECT_EQ(fault_of(three + "tri 1 2 3\n" + std::string(3, '\t') + "png"),
              "6:7: expected 3 words behind png, found 0");
}

/// What is wrong with the scene that a text becomes is told of that.
TEST(CourseText, WhatCannotBeDrawnIsToldOfTheScene) {
    const std::string fault = fault_of("png 8 8 f\nxyzw 0 0 0 0\nxy 1 0\nxy 0 1\ntri 1 2 3\n");
    EXPECT_EQ(fault.starts_with(" as a scene:"), false) << fault;
    EXPECT_NE(fault.find("which is no place"), std::string::npos) << fault;
}

} // namespace
} // namespace rastertrace
