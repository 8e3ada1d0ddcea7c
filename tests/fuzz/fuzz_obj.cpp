// SPDX-License-Identifier: MIT
// Any bytes as an OBJ file: what is wrong with them is said safely, and a mesh that can be read is
// whole, and the same when it is written plainly and read again.

#include "check.h"

#include <rastertrace/trace/scene/obj_file.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace rastertrace::fuzz {

namespace {

/// Every face has its corners, and every corner its vertex.
void check_whole(const ObjMesh& mesh) {
    check(mesh.faces() > 0, "a mesh has no faces");
    std::size_t corners = 0;
    for (std::size_t i = 0; i < mesh.faces(); ++i) {
        check(mesh.face(i).size() >= 3, "a face has fewer than three corners");
        for (const std::uint32_t corner : mesh.face(i))
            check(corner < mesh.vertices.size(), "a corner has no vertex");
        corners += mesh.face(i).size();
    }
    check(corners == mesh.corners.size(), "a corner has no face");
}

/// The shortest decimal that is read as this double.
std::string shortest(double value) {
    check(std::isfinite(value), "a coordinate is not finite");
    std::array<char, 32> text;
    const auto written = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), written.ptr};
}

/// The coordinates, rounded to doubles.
std::vector<double> doubles_of(const ObjMesh& mesh) {
    std::vector<double> doubles;
    for (const auto& vertex : mesh.vertices)
        for (const Number& coordinate : vertex)
            doubles.push_back(coordinate.nearest_double());
    return doubles;
}

void write_and_read_back(const ObjMesh& mesh) {
    std::string text;
    const std::vector<double> doubles = doubles_of(mesh);
    for (std::size_t i = 0; i < doubles.size(); ++i)
        text += (i % 3 == 0 ? "\nv " : " ") + shortest(doubles[i]);
    for (std::size_t i = 0; i < mesh.faces(); ++i) {
        text += "\nf";
        for (const std::uint32_t corner : mesh.face(i))
            text += " " + std::to_string(std::size_t{corner} + 1);
    }
    const auto again = read_obj({"again.obj", text});
    check(static_cast<bool>(again), "a mesh that was written cannot be read");
    check(doubles_of(again.value()) == doubles, "a mesh that was written has other vertices");
    check(again.value().corners == mesh.corners, "a mesh that was written has other corners");
    check(again.value().face_ends == mesh.face_ends, "a mesh that was written has other faces");
}

/// How a line ends makes no difference.
void check_line_ends(const Source& source, const Result<ObjMesh>& mesh) {
    if (source.text.find('\r') != std::string::npos)
        return;
    Source other{.name = source.name, .text = {}};
    for (const char c : source.text)
        other.text += c == '\n' ? std::string("\r\n") : std::string(1, c);
    const auto again = read_obj(other);
    check(static_cast<bool>(again) == static_cast<bool>(mesh), "a line end is taken for a fault");
    if (mesh) {
        check(doubles_of(again.value()) == doubles_of(mesh.value()), "a line end moves a vertex");
        check(again.value().corners == mesh.value().corners, "a line end moves a corner");
    } else {
        check(again.problem().message == mesh.problem().message, "a line end changes a message");
    }
}

} // namespace

} // namespace rastertrace::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace rastertrace;
    const Source source = fuzz::source_of("fuzz.obj", data, size);
    const auto mesh = read_obj(source);
    fuzz::check_line_ends(source, mesh);
    if (mesh) {
        fuzz::check_whole(mesh.value());
        fuzz::write_and_read_back(mesh.value());
    } else {
        fuzz::check_message(mesh.problem());
    }
    return 0;
}
