// SPDX-License-Identifier: MIT
#include "picture.h"
#include "told_problem.h"

#include <rastertrace/trace/scene/obj_file.h>
#include <rastertrace/trace/text/input.h>

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <tiny_obj_loader.h>

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

namespace fs = std::filesystem;
using namespace std::string_literals;

using Corners = std::vector<std::uint32_t>;

/// What is said about an OBJ file with this text.
std::string complaint(const std::string& text) {
    const auto mesh = read_obj({"model.obj", text});
    return mesh ? "no complaint" : to_text(mesh.problem());
}

void expect_complaint(const std::string& text, const std::string& message,
                      const std::string& hint = "") {
    EXPECT_EQ(complaint(text), told_problem(text, message, hint));
}

ObjMesh mesh_in(const std::string& text) {
    const auto mesh = read_obj({"model.obj", text});
    EXPECT_TRUE(mesh) << to_text(mesh.problem());
    return mesh ? mesh.value() : ObjMesh{};
}

std::vector<Corners> faces_of(const ObjMesh& mesh) {
    std::vector<Corners> faces;
    for (std::size_t i = 0; i < mesh.faces(); ++i)
        faces.emplace_back(mesh.face(i).begin(), mesh.face(i).end());
    return faces;
}

/// The faces of a file that goes on like this after four vertices, two texture coordinates and a
/// normal, on eight lines.
const std::string four_vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                  "vt 0 0\nvt 1 1\nvn 0 0 1\n\n";

std::vector<Corners> faces_after_four(const std::string& text) {
    return faces_of(mesh_in(four_vertices + text));
}
std::string complaint_after_four(const std::string& text) {
    return complaint(four_vertices + text);
}

/// The exact x of a vertex whose x is typed like this.
std::string exact_x(const std::string& typed) {
    const ObjMesh mesh = mesh_in("v " + typed + " 0 0\nf 1 1 1\n");
    return mesh.vertices.empty() ? "none" : mesh.vertices[0][0].exact().get_str();
}

std::string complaint_about_x(const std::string& typed) {
    return complaint("v " + typed + " 0 0\nf 1 1 1\n");
}

/// Held in the same way, not just of the same value: the same digits and exponent.
bool are_same(const Number& a, const Number& b) {
    return a.exact() == b.exact() && a.denominator() == b.denominator();
}

TEST(ObjFile, SmallestMesh) {
    const ObjMesh mesh = mesh_in("v 0 0 0\nv 1 0 0\nv 0 .5 -2\nf 1 2 3\n");
    ASSERT_EQ(mesh.vertices.size(), 3u);
    EXPECT_EQ(mesh.vertices[2][0].exact().get_str(), "0");
    EXPECT_EQ(mesh.vertices[2][1].exact().get_str(), "1/2");
    EXPECT_EQ(mesh.vertices[2][2].exact().get_str(), "-2");
    EXPECT_EQ(mesh.faces(), 1u);
    EXPECT_EQ(faces_of(mesh), (std::vector<Corners>{{0, 1, 2}}));
}

TEST(ObjFile, NumbersAreExactlyWhatWasTyped) {
    EXPECT_EQ(exact_x("1"), "1");
    EXPECT_EQ(exact_x("-0.5"), "-1/2");
    EXPECT_EQ(exact_x(".5"), "1/2");
    EXPECT_EQ(exact_x("-.5"), "-1/2");
    EXPECT_EQ(exact_x("1."), "1");
    EXPECT_EQ(exact_x("+1"), "1");
    EXPECT_EQ(exact_x("+.25"), "1/4");
    EXPECT_EQ(exact_x("-0.000000"), "0");
    EXPECT_EQ(exact_x("0.1"), "1/10");
    EXPECT_EQ(exact_x("007.50"), "15/2");
    EXPECT_EQ(exact_x("1e-3"), "1/1000");
    EXPECT_EQ(exact_x("+1.e+3"), "1000");
    EXPECT_EQ(exact_x("-.5E1"), "-5");
    EXPECT_EQ(exact_x("999999999999999999"), "999999999999999999") << "18 digits";
    EXPECT_EQ(exact_x("1000000000000000000"), "1000000000000000000") << "19 digits";
    EXPECT_EQ(exact_x("1234567890123456789.5"), "2469135780246913579/2") << "20 digits";
    EXPECT_EQ(exact_x("18446744073709551617"), "18446744073709551617") << "2^64 + 1";
    EXPECT_EQ(exact_x("0." + std::string(30, '0') + "1"), "1/1" + std::string(31, '0'));
    EXPECT_EQ(exact_x("1." + std::string(500, '0')), "1");
}

TEST(ObjFile, IndexForms) {
    EXPECT_EQ(faces_after_four("f 1 2 3"), (std::vector<Corners>{{0, 1, 2}}));
    EXPECT_EQ(faces_after_four("f 1/1 2/2 3/1"), (std::vector<Corners>{{0, 1, 2}}));
    EXPECT_EQ(faces_after_four("f 1//1 2//1 3//1"), (std::vector<Corners>{{0, 1, 2}}));
    EXPECT_EQ(faces_after_four("f 1/1/1 2/2/1 3/1/1"), (std::vector<Corners>{{0, 1, 2}}));
}

// An index is a whole number, which zeros in front do not change; tinyobjloader reads the same.
TEST(ObjFile, LeadingZerosChangeNoNumber) {
    const std::string plain = "v 0 0 0\nv 12.5 0 0\nv 0 -30 0\nf 1 -2 3\n";
    const std::string zeros = "v 00 0 -00.0\nv 0012.5 00e1 0\nv 0 -003e01 0\nf 01 -02 003\n";
    const ObjMesh expected = read_obj({"plain.obj", plain}).value();
    const auto mesh = read_obj({"zeros.obj", zeros});
    ASSERT_TRUE(mesh) << to_text(mesh.problem());
    EXPECT_EQ(mesh.value().corners, expected.corners);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(mesh.value().vertices[i][k].exact(), expected.vertices[i][k].exact());
}

TEST(ObjFile, NegativeIndicesCountFromTheLastVertexSoFar) {
    EXPECT_EQ(faces_after_four("f -1 -2 -3"), (std::vector<Corners>{{3, 2, 1}}));
    EXPECT_EQ(faces_after_four("f -4/-2/-1 -3/-1/-1 2/1/1"), (std::vector<Corners>{{0, 1, 1}}));
    EXPECT_EQ(faces_after_four("f -1 -2 -3\nv 5 5 5\nf -1 -2 -3\n"),
              (std::vector<Corners>{{3, 2, 1}, {4, 3, 2}}));
}

TEST(ObjFile, PolygonsStayWhole) {
    EXPECT_EQ(faces_after_four("f 1 2 3 4\nf 4 3 2\nf 1 2 3 4 1 2 3\n"),
              (std::vector<Corners>{{0, 1, 2, 3}, {3, 2, 1}, {0, 1, 2, 3, 0, 1, 2}}));
}

TEST(ObjFile, LinesEndAndGoOn) {
    const std::vector<Corners> one_face{{0, 1, 2}};
    EXPECT_EQ(faces_after_four("f 1 2 3"), one_face) << "no line end";
    EXPECT_EQ(faces_after_four("f 1 2 3\r\n"), one_face);
    EXPECT_EQ(faces_after_four("f 1 2 3\r"), one_face) << "cut within a line end";
    EXPECT_EQ(faces_after_four("\t f\t1  2 3 \t\n \n\n"), one_face);
    EXPECT_EQ(faces_after_four("f \\\n1 2 \\\r\n3\n"), one_face);
    EXPECT_EQ(faces_after_four("f 1\\\n2\\\n3\\\n"), one_face) << "words end at a line end";
    EXPECT_EQ(faces_after_four("g a \\\nf 1 2\nf 1 2 3\n"), one_face) << "skipped with its group";
    EXPECT_EQ(faces_after_four("# here \\\nf 1 2 3\n"), one_face) << "a comment does not go on";
    EXPECT_EQ(faces_after_four("f 1 2 3 # corners\n#f 3 2 1\n#\n"), one_face);
    EXPECT_EQ(faces_of(mesh_in("\xEF\xBB\xBFv 0 0 0\r\nf 1 1 1\r\n")).size(), 1u);
}

TEST(ObjFile, WhatIsSkipped) {
    const std::string skipped = "mtllib a.mtl\no cube\ng a b\ng\nusemtl red \xFF\ns off\ns 1\n"
                                "p 1\nl 1 2 99\nvt 0\nvt 0 0 0\n";
    EXPECT_EQ(faces_after_four(skipped + "f 1 2 3"), (std::vector<Corners>{{0, 1, 2}}));
    const ObjMesh mesh = mesh_in("v 1 2 3 1.0\nv 1 2 3 0.5 .5 1\nf 1 2 2\n");
    ASSERT_EQ(mesh.vertices.size(), 2u);
    EXPECT_TRUE(are_same(mesh.vertices[0][2], mesh.vertices[1][2])) << "weight and color";
}

TEST(ObjFile, CurvesAndDisplayAreSkippedAndToldOnceAFile) {
    // The trimmed surface of the manual, and a face.
    const std::string surface =
        "# a surface\n"
        "vp -0.675 1.85 3\ncstype rat bspline\ndeg 3 3\nbmat u 1 0 \\\n 0 1\n"
        "step 2 2\ncurv 0 1 1 2\ncurv2 1 2\nsurf 0 1 0 1 1 2 3\nparm u 0 1\n"
        "trim 0 1 1\nhole 0 1 1\nscrv 0 1 1\nsp 1\nend\ncon 1 0 1 1 2 0 1 1\n"
        "mg 1 0.5\nbevel on\nc_interp on\nd_interp on\nlod 5\n"
        "maplib a.mla\nusemap off\nshadow_obj a.obj\ntrace_obj a.obj\n"
        "ctech cparm 1\nstech cparma 1 1\ncall a.obj\ncsh -ls\n"
        "bsp 1\nbzp 1\ncdc 1\ncdp 1\nres 1 1\n";
    const auto mesh = read_obj({"model.obj", four_vertices + surface + "f 1 2 3\n"});
    ASSERT_TRUE(mesh) << to_text(mesh.problem());
    EXPECT_EQ(faces_of(mesh.value()), (std::vector<Corners>{{0, 1, 2}}));
    ASSERT_EQ(mesh.value().remarks.size(), 1u);
    EXPECT_EQ(to_text(mesh.value().remarks[0]),
              "model.obj:10:1: remark: expected vertices and faces, found 33 statements of curves, "
              "surfaces or display, skipped; the first is vp\n"
              "vp -0.675 1.85 3\n"
              "^\n"
              "hint: only what f lists is drawn");
    EXPECT_EQ(mesh_in(four_vertices + "lod 1\nf 1 2 3\n").remarks[0].message,
              "remark: expected vertices and faces, found 1 statement of curves, surfaces or "
              "display, skipped; the first is lod");
    EXPECT_TRUE(mesh_in(four_vertices + "g a\nf 1 2 3\n").remarks.empty());
    expect_complaint(four_vertices + "curv3 0 1\nf 1 2 3\n",
                     "model.obj:9:1: expected a statement out of v, vt, vn, f, l, p, g, o, s, "
                     "usemtl, mtllib, found \"curv3\"");
    EXPECT_EQ(complaint("v 0 0 0\ncurv 0 1 1 1\n"),
              "model.obj:3:1: expected at least one face, found none\n"
              "hint: a face of three vertices: f 1 2 3");
}

TEST(ObjFile, UnknownStatement) {
    expect_complaint("v 0 0 0\n  xyz 1 2\n", "model.obj:2:3: expected a statement out of v, vt, "
                                             "vn, f, l, p, g, o, s, usemtl, mtllib, found \"xyz\"");
    EXPECT_EQ(complaint("v 0 0 0\n\\"),
              "model.obj:2:1: expected a statement out of v, vt, vn, f, l, p, g, "
              "o, s, usemtl, mtllib, found \"\\\"\n"
              "\\\n"
              "^");
    EXPECT_EQ(complaint("v 0 0 0\rv 1 1 1\rf 1 1 1\r"),
              "model.obj:1:7: expected a number, found \"0<U+000D>v\"\n"
              "v 0 0 0\n"
              "      ^")
        << "a carriage return alone is no line end";
    EXPECT_EQ(complaint("v 0 0 0\n\0\x1B[2J"s), "model.obj:2:1: expected text, found a zero byte");
}

// A scene from somebody else might name a file that holds a secret.
TEST(ObjFile, OfWhatIsNoObjFileNothingIsQuoted) {
    constexpr std::string_view hint =
        "\nhint: its statements are v, vt, vn, f, l, p, g, o, s, usemtl, mtllib";
    EXPECT_EQ(complaint("root:$6$salt$hash:19000:0\n"),
              "model.obj:1:1: expected an OBJ file, found a line that is none of it" +
                  std::string(hint));
    EXPECT_EQ(complaint("# a comment\ng group\n\n password=1234\n"),
              "model.obj:4:2: expected an OBJ file, found a line that is none of it" +
                  std::string(hint));
}

TEST(ObjFile, MissingFaces) {
    EXPECT_EQ(complaint(""), "model.obj:1:1: expected at least one face, found none\n"
                             "hint: a face of three vertices: f 1 2 3");
    EXPECT_EQ(complaint("v 0 0 0\nv 1 0 0\n"),
              "model.obj:3:1: expected at least one face, found none\n"
              "hint: a face of three vertices: f 1 2 3");
    expect_complaint("v 0 0 0\nl 1 2", "model.obj:2:6: expected at least one face, found none",
                     "a face of three vertices: f 1 2 3");
    EXPECT_EQ(complaint("l 1 2"), "model.obj:1:6: expected at least one face, found none\n"
                                  "hint: a face of three vertices: f 1 2 3");
}

TEST(ObjFile, NumbersThatAreNone) {
    expect_complaint("v 0 nan 0\n", "model.obj:1:5: expected a number, found \"nan\"");
    for (const std::string typed :
         {"nan", "NaN", "inf", "-inf", "infinity", "0x10", "1/2",     ".",
          "+",   "-",   "+.",  "-.e5", "e5",       "1e",   "1e+",     "1.5.5",
          "--1", "+-1", "1,5", "1f",   "1#",       "1\\",  "\xC2\xA0"})
        EXPECT_EQ(complaint_about_x(typed), "model.obj:1:3: expected a number, found \"" + typed +
                                                "\"\nv " + typed + " 0 0\n  ^")
            << typed;
    expect_complaint("v 0 0 0\nvt 1 x\n", "model.obj:2:6: expected a number, found \"x\"");
    expect_complaint("v 0 0 0 1 nan 0\n", "model.obj:1:11: expected a number, found \"nan\"");
}

TEST(ObjFile, NumbersOutOfRange) {
    EXPECT_EQ(complaint_about_x("-1e999"),
              "model.obj:1:3: expected a number up to 1.797e308, found \"-1e999\"\n"
              "v -1e999 0 0\n"
              "  ^");
    EXPECT_EQ(complaint_about_x("+1e-400"),
              "model.obj:1:3: expected 0 or a number from 4.941e-324 on, found \"+1e-400\"\n"
              "v +1e-400 0 0\n"
              "  ^");
    EXPECT_EQ(complaint_about_x(std::string(1101, '0')),
              "model.obj:1:3: expected a number of at most 1100 characters, found "
              "\"0000000000000000000000000000000000000...\"\n"
              "v 0000000000000000000000000000000000000000...\n"
              "  ^");
    EXPECT_EQ(exact_x(std::string(1100, '0')), "0");
}

TEST(ObjFile, WeightsAndColorsAreThoseOfTheirVertices) {
    const auto mesh =
        read_obj({"model.obj", "v 0 0 0\nv 1 0 0 1 0 .5\nv 0 1 0 2\nv 1 1 0 1\nf 1 2 3 4\n"});
    ASSERT_TRUE(mesh);
    const std::vector<Number> weights{1, 1, 2, 1};
    const Color white(255, 255, 255);
    const std::vector<Color> colors{white, Color(255, 0, 128), white, white};
    EXPECT_TRUE(mesh.value().weights == weights);
    EXPECT_TRUE(mesh.value().colors == colors);
    const auto plain = read_obj({"model.obj", "v 0 0 0 1\nv 1 0 0 1.0\nv 0 1 0\nf 1 2 3\n"});
    ASSERT_TRUE(plain);
    EXPECT_TRUE(plain.value().weights.empty());
    EXPECT_TRUE(plain.value().colors.empty());
}

TEST(ObjFile, NumbersTooFewOrTooMany) {
    expect_complaint("v 0 0\n", "model.obj:1:1: expected v with 3, 4 or 6 numbers, found 2");
    expect_complaint(" v 0 0 0 1 1 # five\n",
                     "model.obj:1:2: expected v with 3, 4 or 6 numbers, found 5");
    expect_complaint("v 0 0 0 1 1 1 1\n",
                     "model.obj:1:1: expected v with 3, 4 or 6 numbers, found 7");
    expect_complaint("v 1 2 3 0 0.5 1.01\n",
                     "model.obj:1:15: expected a channel from 0 to 1, found \"1.01\"");
    expect_complaint("vt\n", "model.obj:1:1: expected vt with 1 to 3 numbers, found 0");
    expect_complaint("vt 1 2 3 4\n", "model.obj:1:1: expected vt with 1 to 3 numbers, found 4");
    expect_complaint("vn 1 2\n", "model.obj:1:1: expected vn with 3 numbers, found 2");
}

TEST(ObjFile, CornersTooFew) {
    expect_complaint(four_vertices + "f 1 2 # 3\n",
                     "model.obj:9:1: expected f with 3 corners or more, found 2");
    expect_complaint(four_vertices + "f",
                     "model.obj:9:1: expected f with 3 corners or more, found 0");
}

TEST(ObjFile, CornersThatAreNone) {
    for (const std::string typed : {"x", "1.5", "+1", "-", "1/", "1//", "1/1/", "1/1/1/", "1/1/1/1",
                                    "1///1", "/1", "//1", "1x", "9x", "1/1x", "1//1x", "1\\", "1#"})
        EXPECT_EQ(complaint_after_four("f 2 " + typed + " 3\n"),
                  "model.obj:9:5: expected a corner like 1, 1/1, 1//1 or 1/1/1, found \"" + typed +
                      "\"\nf 2 " + typed + " 3\n    ^")
            << typed;
}

TEST(ObjFile, IndicesOutOfRange) {
    const std::string hint = "\nhint: 1 is the first in the file, -1 the last before this line";
    for (const std::string index : {"0", "-0", "5", "-5", "99999999999999999999",
                                    "-99999999999999999999", "-9223372036854775808", "4294967297"})
        EXPECT_EQ(complaint_after_four("f 2 " + index + " 3\n"),
                  "model.obj:9:5: expected the index of a vertex (4 so far), found " + index +
                      "\nf 2 " + index + " 3\n    ^" + hint)
            << index;
    EXPECT_EQ(complaint_after_four("f 2/1 3/3 4/1\n"),
              "model.obj:9:9: expected the index of a texture coordinate (2 so far), found 3\n"
              "f 2/1 3/3 4/1\n"
              "        ^" +
                  hint);
    EXPECT_EQ(complaint_after_four("f 2//1 3//-2 4//1\n"),
              "model.obj:9:11: expected the index of a normal (1 so far), found -2\n"
              "f 2//1 3//-2 4//1\n"
              "          ^" +
                  hint);
    EXPECT_EQ(complaint_after_four("f 2/1/1 3/2/0 4/1/1\n"),
              "model.obj:9:13: expected the index of a normal (1 so far), found 0\n"
              "f 2/1/1 3/2/0 4/1/1\n"
              "            ^" +
                  hint);
    EXPECT_EQ(complaint("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 1 1 0\n"),
              "model.obj:1:3: expected the index of a vertex (0 so far), found 1\n"
              "f 1 2 3\n"
              "  ^" +
                  hint)
        << "a face uses vertices that are there already";
}

/// Texts of random meshes, and what should be read from them.
struct RandomMesh {
    std::string text;
    std::vector<std::array<std::string, 3>> vertices; ///< as parse_number understands them
    std::vector<Corners> faces;
};

/// A decimal of up to 20 digits, in one of the forms of an OBJ file.
std::string random_number(std::string& usual) {
    const auto whole = *rc::gen::arbitrary<std::uint32_t>();
    const std::string behind = std::to_string(*rc::gen::arbitrary<std::uint32_t>());
    const std::string zeros(*rc::gen::inRange<std::size_t>(0, 4), '0');
    const std::string exponent =
        *rc::gen::element(""s, ""s, "e-3"s, "E+2"s, "e" + std::to_string(whole % 290));
    const bool negative = *rc::gen::arbitrary<bool>();

    struct Form {
        std::string typed, usual;
    };
    const std::string front = std::to_string(whole);
    const Form form = *rc::gen::element(
        Form{front, front}, Form{front + ".", front}, Form{"." + behind + zeros, "0." + behind},
        Form{front + "." + zeros + behind, front + "." + zeros + behind},
        Form{zeros + front + "." + behind + zeros, front + "." + behind});
    usual = (negative ? "-" : "") + form.usual + exponent;
    return (negative ? "-" : *rc::gen::element(""s, "+"s)) + form.typed + exponent;
}

RandomMesh random_mesh() {
    RandomMesh mesh;
    const auto blank = [] { return *rc::gen::element(" "s, " "s, "\t"s, "  "s, " \\\n"s); };
    const auto line_end = [] {
        return *rc::gen::element("\n"s, "\r\n"s, " # say\n"s, "\n\ng a\n"s);
    };

    // Vertices and faces take turns, so that negative indices mean something else each time.
    const int rounds = *rc::gen::inRange(1, 4);
    for (int round = 0; round < rounds; ++round) {
        const int new_vertices = *rc::gen::inRange(1, 6);
        for (int i = 0; i < new_vertices; ++i) {
            mesh.text += "v";
            for (std::string& coordinate : mesh.vertices.emplace_back())
                mesh.text += blank() + random_number(coordinate);
            mesh.text += line_end() + "vt 0.5 .5" + line_end() + "vn 0 1 0" + line_end();
        }
        const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
        const int new_faces = *rc::gen::inRange(1, 4);
        for (int i = 0; i < new_faces; ++i) {
            Corners& face = mesh.faces.emplace_back(*rc::gen::inRange<std::size_t>(3, 7));
            const int form = *rc::gen::inRange(0, 4);
            mesh.text += "f";
            for (std::uint32_t& corner : face) {
                corner = *rc::gen::inRange<std::uint32_t>(0, count);
                const std::string index =
                    *rc::gen::element(std::to_string(std::int64_t{corner} + 1),
                                      std::to_string(std::int64_t{corner} - count));
                mesh.text += blank() + index;
                if (form == 1 || form == 3)
                    mesh.text += "/" + index;
                if (form == 2 || form == 3)
                    mesh.text += (form == 2 ? "//" : "/") + index;
            }
            mesh.text += line_end();
        }
    }
    return mesh;
}

RC_GTEST_PROP(ObjFile, OfARandomMeshIsThatMesh, ()) {
    const RandomMesh random = random_mesh();
    const auto read = read_obj({"random.obj", random.text});
    RC_ASSERT(static_cast<bool>(read));
    const ObjMesh& mesh = read.value();
    RC_ASSERT(mesh.vertices.size() == random.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            RC_ASSERT(are_same(mesh.vertices[i][axis], number(random.vertices[i][axis])));
    RC_ASSERT(faces_of(mesh) == random.faces);
}

RC_GTEST_PROP(ObjFile, OfAnyBytesIsAMeshOrAComplaint, (const std::string& bytes)) {
    const std::string text = four_vertices + "f 1 2 3 " + bytes;
    const auto mesh = read_obj({"random.obj", text});
    if (!mesh)
        RC_ASSERT(mesh.problem().line >= 9);
}

/// How many doubles lie between two: 0 if they are the same.
double distance_in_ulps(double a, double b) {
    const double larger = std::max(std::abs(a), std::abs(b));
    const double ulp = std::nextafter(larger, std::numeric_limits<double>::infinity()) - larger;
    return std::abs(a - b) / ulp;
}

// tinyobjloader adds the digits behind the point one after the other, so it may be off by half an
// ulp for each, and by a little for the power of ten: 4 ulp are enough for 6 digits.
RC_GTEST_PROP(ObjFile, AgreesWithTinyobjloader, ()) {
    std::ostringstream text;
    const auto vertices = *rc::gen::inRange<std::uint32_t>(1, 10);
    for (std::uint32_t i = 0; i < vertices; ++i) {
        text << "v";
        for (int axis = 0; axis < 3; ++axis) {
            const auto behind = std::to_string(*rc::gen::inRange(0, 1000000));
            text << ' ' << *rc::gen::element("", "-") << *rc::gen::inRange(0, 100000) << '.'
                 << std::string(6 - behind.size(), '0') << behind;
        }
        text << "\nvt 0.25 0.5\nvn 0 0 1\n";
    }
    const auto faces = *rc::gen::inRange(1, 6);
    for (int i = 0; i < faces; ++i) {
        text << "f";
        const std::string behind = *rc::gen::element("", "/1", "//-1", "/-1/1");
        const auto corners = *rc::gen::inRange(3, 7);
        for (int corner = 0; corner < corners; ++corner) {
            const auto place = *rc::gen::inRange<std::int64_t>(0, vertices);
            text << ' ' << *rc::gen::element(place + 1, place - vertices) << behind;
        }
        text << "\n";
    }

    tinyobj::ObjReaderConfig as_is;
    as_is.triangulate = false;
    tinyobj::ObjReader other;
    RC_ASSERT(other.ParseFromString(text.str(), "", as_is));
    const auto read = read_obj({"random.obj", text.str()});
    RC_ASSERT(static_cast<bool>(read));
    const ObjMesh& mesh = read.value();

    const auto& coordinates = other.GetAttrib().vertices;
    RC_ASSERT(coordinates.size() == 3 * mesh.vertices.size());
    for (std::size_t i = 0; i < coordinates.size(); ++i)
        RC_ASSERT(distance_in_ulps(mesh.vertices[i / 3][i % 3].nearest_double(), coordinates[i]) <=
                  4);
    RC_ASSERT(other.GetShapes().size() == 1u);
    const tinyobj::mesh_t& shape = other.GetShapes()[0].mesh;
    RC_ASSERT(shape.indices.size() == mesh.corners.size());
    for (std::size_t i = 0; i < mesh.corners.size(); ++i)
        RC_ASSERT(shape.indices[i].vertex_index == static_cast<int>(mesh.corners[i]));
    RC_ASSERT(shape.num_face_vertices.size() == mesh.faces());
    for (std::size_t i = 0; i < mesh.faces(); ++i)
        RC_ASSERT(std::size_t{shape.num_face_vertices[i]} == mesh.face(i).size());
}

const fs::path models = fs::path(RASTERTRACE_EXAMPLES) / "models";
const fs::path make_models = fs::path(RASTERTRACE_EXAMPLES) / "../scripts/make-models.sh";

std::string text_of(const fs::path& path) {
    const auto source = read_named_file(path.string(), {});
    EXPECT_TRUE(source) << to_text(source.problem());
    return source ? source.value().text : "";
}

/// Runs scripts/make-models.sh in a folder of its own; gives its exit status.
class MakeModels : public testing::Test {
protected:
    MakeModels() {
        std::string pattern = (fs::temp_directory_path() / "rastertrace-XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
    }
    ~MakeModels() override { fs::remove_all(folder_); }

    int make(const std::string& arguments) const {
        const std::string command =
            "cd '" + folder_.string() + "' && '" + make_models.string() + "' " + arguments;
        return WEXITSTATUS(std::system(command.c_str()));
    }

    fs::path folder_;
};

TEST_F(MakeModels, AreWhatTheScriptMakes) {
    ASSERT_EQ(make("."), 0);
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(folder_)) {
        const fs::path name = entry.path().filename();
        EXPECT_EQ(text_of(entry.path()), text_of(models / name))
            << name << ": to renew it, run scripts/make-models.sh";
        ++files;
    }
    EXPECT_EQ(files, 4u);
}

TEST_F(MakeModels, RefuseBadUsage) {
    for (const char* arguments :
         {"torus 3", "torus 2 3", "torus 3 2", "torus x 3", "torus 3 ''", "torus 3 10001",
          "torus 3 3 3", "a b", "--help", "''", "cube 3 3"})
        EXPECT_EQ(make(arguments + " 2>usage"s), 2) << arguments;
    EXPECT_EQ(text_of(folder_ / "usage"),
              "usage: scripts/make-models.sh [FOLDER]\n"
              "       scripts/make-models.sh torus|head [RINGS SIDES]    (each from 3 to 10000)\n");
}

TEST_F(MakeModels, TorusOfAnySize) {
    ASSERT_EQ(make("torus 24 12 >torus.obj"), 0);
    EXPECT_EQ(text_of(folder_ / "torus.obj"), text_of(models / "torus.obj"));
    ASSERT_EQ(make("torus >torus.obj"), 0);
    EXPECT_EQ(text_of(folder_ / "torus.obj"), text_of(models / "torus.obj"));
    ASSERT_EQ(make("torus 7 3 >torus.obj"), 0);
    const ObjMesh mesh = mesh_in(text_of(folder_ / "torus.obj"));
    EXPECT_EQ(mesh.vertices.size(), 21u);
    EXPECT_EQ(mesh.faces(), 21u);
}

/// How often each edge is used, from one vertex to another.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses_of_edges(const ObjMesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const Corners& face : faces_of(mesh))
        for (std::size_t i = 0; i < face.size(); ++i)
            ++uses[{face[i], face[(i + 1) % face.size()]}];
    return uses;
}

/// What a closed mesh encloses, as tetrahedra between the origin and its triangles. Positive if
/// its faces are counter-clockwise seen from outside.
double volume_of(const ObjMesh& mesh) {
    const auto at = [&mesh](std::uint32_t vertex, std::size_t axis) {
        return mesh.vertices[vertex][axis].nearest_double();
    };
    double six_volumes = 0;
    for (const Corners& face : faces_of(mesh))
        for (std::size_t i = 2; i < face.size(); ++i)
            for (std::size_t x = 0; x < 3; ++x) {
                const std::size_t y = (x + 1) % 3;
                const std::size_t z = (x + 2) % 3;
                six_volumes += at(face[0], x) * (at(face[i - 1], y) * at(face[i], z) -
                                                 at(face[i - 1], z) * at(face[i], y));
            }
    return six_volumes / 6;
}

/// What there is to know about a closed mesh.
struct Facts {
    std::size_t vertices, faces;
    int euler_characteristic; ///< vertices - edges + faces: 2, and 2 less for each hole
    double volume;
};

void expect_closed(const ObjMesh& mesh, const Facts& facts) {
    EXPECT_EQ(mesh.vertices.size(), facts.vertices);
    EXPECT_EQ(mesh.faces(), facts.faces);

    // Each edge is used twice: once from one end, and once from the other.
    const auto uses = uses_of_edges(mesh);
    for (const auto& [edge, count] : uses) {
        EXPECT_EQ(count, 1) << edge.first + 1 << " to " << edge.second + 1;
        EXPECT_TRUE(uses.contains({edge.second, edge.first}))
            << edge.second + 1 << " to " << edge.first + 1;
    }
    const int edges = static_cast<int>(uses.size()) / 2;
    EXPECT_EQ(static_cast<int>(mesh.vertices.size()) - edges + static_cast<int>(mesh.faces()),
              facts.euler_characteristic);
    EXPECT_NEAR(volume_of(mesh), facts.volume, 1e-5) << "coordinates have six places";
}

TEST(Models, AreClosedAndFaceOutward) {
    // A tube of 12 flat sides has the area 6 r^2 sin 30 deg. Pappus turns it by 2 pi R, and 24
    // straight steps turn it by 24 R sin 15 deg.
    const double sine_of_15_degrees = (std::sqrt(6) - std::sqrt(2)) / 4;
    const double torus = 24 * sine_of_15_degrees * 6 * 0.4 * 0.4 * 0.5;
    // Measured by a few lines of Python; the ball has 4/3 pi = 4.19.
    const double icosphere = 4.047044;
    for (const auto& [name, facts] : {std::pair<std::string, Facts>{"cube.obj", {8, 12, 2, 8}},
                                      {"tetrahedron.obj", {4, 4, 2, 8.0 / 3}},
                                      {"torus.obj", {288, 288, 0, torus}},
                                      {"icosphere.obj", {162, 320, 2, icosphere}}}) {
        SCOPED_TRACE(name);
        expect_closed(mesh_in(text_of(models / name)), facts);
    }
}

// 180 rings: one a degree, the crown at 90. The volume was summed up by a few lines of Python.
TEST_F(MakeModels, AHeadIsClosedAndItsMouthLiesBehindItsLips) {
    ASSERT_EQ(make("head 180 12 >head.obj"), 0);
    const ObjMesh mesh = mesh_in(text_of(folder_ / "head.obj"));
    expect_closed(mesh, {179 * 12 + 2, 2 * 179 * 12, 2, 3.061912});

    const auto depth_at = [&mesh](int degrees) { // of the vertex in the middle of the face
        return mesh.vertices[static_cast<std::size_t>(90 - degrees - 1) * 12 + 1][2]
            .nearest_double();
    };
    EXPECT_GT(depth_at(-21), depth_at(-27) + 0.2) << "the upper lip";
    EXPECT_GT(depth_at(-33), depth_at(-27) + 0.2) << "the lower lip";
    EXPECT_GT(depth_at(1), depth_at(-21)) << "the nose";
}

} // namespace
} // namespace rastertrace
