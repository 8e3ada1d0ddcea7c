// SPDX-License-Identifier: MIT
#pragma once

// A mesh from a Wavefront OBJ file: its vertices exactly as typed, and its faces. The format is that
// of the Advanced Visualizer manual, appendix B1, read strictly: what is no statement of it is refused.
// Texture coordinates and normals are checked and then left out; curves and surfaces are skipped.
//
//     v 0 0 0
//     v 1 0 0
//     v 0 .5 0           # and w, or red green blue of 0 to 1
//     f 1 2 3            # also 1/1, 1//1 and 1/1/1; -1 is the last vertex before this line
//
//     const auto mesh = read_obj(source);  // an ObjMesh, or the Problem and its place

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/text/problem.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rastertrace {

/// A mesh as an OBJ file lists it.
struct ObjMesh {
    std::vector<std::array<Number, 3>> vertices; ///< as typed
    std::vector<float> units;                    ///< of each, its coarsest: see typed_digits.h
    std::vector<Number> weights;                 ///< w of each; none if all are 1
    std::vector<Color> colors;                   ///< of each; none if the file has none
    std::vector<std::uint32_t> corners;          ///< places in `vertices`, face after face
    std::vector<std::uint32_t> face_ends;        ///< for each face, where its corners end
    std::vector<Problem> remarks;                ///< on what the file has and the mesh has not

    std::size_t faces() const { return face_ends.size(); }

    /// How many there are if each face is cut into triangles.
    std::size_t triangles() const { return corners.size() - 2 * faces(); }

    /// The corners of face `i`, three or more, in the order of the file.
    std::span<const std::uint32_t> face(std::size_t i) const {
        const std::size_t begin = i == 0 ? 0 : face_ends[i - 1];
        return std::span(corners).subspan(begin, face_ends[i] - begin);
    }
};

/// Reads an OBJ file of at least one face. Groups, materials, smoothing, lines and points are
/// skipped; so are curves, surfaces and what is for display, with a remark.
Result<ObjMesh> read_obj(const Source& source);

/// A scene of such a file alone, as a scene file: in clip space if its vertices have a w, else seen by a camera that
/// fits.
Result<Source> scene_of_obj(const Source& source);

} // namespace rastertrace
