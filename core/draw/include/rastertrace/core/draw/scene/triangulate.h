// SPDX-License-Identifier: MIT
#pragma once

// How a face of more than three corners becomes triangles: a convex one is the fan from its first
// corner, any other simple one is cut into ears (G. H. Meisters, Polygons Have Ears, 1975; J.
// O'Rourke, Computational Geometry in C, chapter 1). Nothing is rounded: every decision is the sign
// of a whole number.
//
//     FaceCutter cutter(scene.vertices);
//     const Triangulation cut = cutter.cut(face);  // indices of vertices, in the author's order
//     if (cut.ears)
//         for (const auto& [a, b, c] : cut.ears->triangles)  // indices in the face

#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/numbers/rational.h>
#include <rastertrace/core/numbers/vec.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rastertrace {

/// What a face is, seen along the axis that its normal is nearest to.
enum class FaceForm {
    convex,  ///< corners on the line between their neighbors included
    concave, ///< simple, and not convex
    crossed, ///< not simple: two edges meet that are no neighbors, or neighbors that turn back
    no_area, ///< it has no normal
    too_fine ///< the denominator of its fractions has more than `most_bits_of_face` bits
};

/// The most bits of a denominator over which all fractions of a face are written.
inline constexpr std::size_t most_bits_of_face = 32768;

/// The name of a coordinate: 0 is x.
constexpr char axis_name(std::size_t axis) {
    return "xyz"[axis];
}

/// A concave face in triangles. Corners are meant by their places in it, from 0.
struct Ears {
    Vec<Rational, 3> normal; ///< Newell's: its length is twice the area
    std::size_t dropped;     ///< the axis of its largest component, along which the face is seen
    /// In the order in which they were cut: the corner before the ear, the ear, the one after it.
    /// The last one is what was left.
    std::vector<std::array<std::size_t, 3>> triangles;
};

/// What is known about a face.
struct Triangulation {
    FaceForm form = FaceForm::convex;
    bool is_planar = true;         ///< exactly
    double off_plane = 0;          ///< else half of what its corners span along the normal
    std::optional<Ears> ears = {}; ///< of a concave face

    /// Of a crossed face: the first corner whose edge to the next one meets another edge that
    /// begins later, and where the first of those begins.
    std::array<std::size_t, 2> meeting = {};
};

/// Cuts the faces of a mesh. It refers to the vertices, and keeps what it needs for the next face.
class FaceCutter {
public:
    /// `first` is the first vertex of the mesh; a face may have others, which takes more time.
    explicit FaceCutter(std::span<const SceneVertex> vertices, std::size_t first = 0)
        : vertices_(vertices), first_(first) {}

    /// `face` has at least three corners: indices in the vertices.
    Triangulation cut(std::span<const std::size_t> face);

private:
    /// Three numbers over the denominator of the mesh.
    using GridPoint3 = std::array<std::int64_t, 3>;

    /// Writes the mesh over one power of ten, if all of it is decimals that fit in 64 bits with
    /// room for sums of products.
    void put_on_grid();

    std::span<const SceneVertex> vertices_;
    std::size_t first_;
    bool has_begun_ = false;          ///< from the first face on, the grid is known
    std::vector<GridPoint3> grid_;    ///< the vertices from `first_` on; empty if one does not fit
    std::int64_t denominator_ = 1;    ///< of the grid
    int bits_ = 0;                    ///< of its largest number
    std::vector<GridPoint3> corners_; ///< of the current face
};

} // namespace rastertrace
