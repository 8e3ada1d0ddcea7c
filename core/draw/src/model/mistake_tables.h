// SPDX-License-Identifier: MIT
#pragma once

// The parts of the table of mistakes, and what they share.

#include <rastertrace/core/draw/model/mistakes.h>

#include <optional>

namespace rastertrace {

std::span<const Mistake> mistakes_of_rows();
std::span<const Mistake> mistakes_of_samples();
std::span<const Mistake> mistakes_of_lines();
std::span<const Mistake> mistakes_of_space();

inline bool fills_by_rows(const Scene& scene) {
    return scene.has(PrimitiveKind::triangle) &&
           traits_of(scene.method.fill).rule == PixelRule::row_ends;
}
inline bool fills_by_samples(const Scene& scene) {
    return scene.has(PrimitiveKind::triangle) &&
           traits_of(scene.method.fill).rule == PixelRule::samples;
}
inline bool has_triangles(const Scene& scene) {
    return scene.has(PrimitiveKind::triangle);
}

/// Rows from edge to edge: of triangles, or of polygons.
inline bool fills_rows(const Scene& scene) {
    return fills_by_rows(scene) || scene.has(PrimitiveKind::polygon);
}
inline bool rounds_by(const Scene& scene, Rounding rounding) {
    return fills_rows(scene) && span_rounding(scene.method).rounding == rounding;
}
inline bool rounds_down(const Scene& scene) {
    return rounds_by(scene, Rounding::floor);
}
inline bool is_half_open(const Scene& scene) {
    return rounds_by(scene, Rounding::half_open);
}

/// The extent of the vertices as typed; nullopt if a matrix moves them, so that it is not that of the picture.
struct TypedBox {
    Rational width, height; ///< from the least to the largest
    Rational farthest_x;    ///< from 0
};
std::optional<TypedBox> typed_box(const Scene& scene);

/// True if a way in x times one in y may be beyond 16 bits.
inline bool has_large_products(const Scene& scene) {
    const auto box = typed_box(scene);
    return !box || box->width * box->height >= 32768;
}
/// True if an x may be beyond the 16 bits before the point.
inline bool has_far_x(const Scene& scene) {
    const auto box = typed_box(scene);
    return !box || box->farthest_x >= 32768;
}

/// A number cut off to a whole one.
inline Rational cut(const Rational& x) {
    return truncate_index(x);
}

/// A whole number as a variable of so many bits holds it.
inline Index wrapped(Index x, int bits) {
    const Index size = Index{1} << bits;
    const Index rest = ((x % size) + size) % size;
    return rest < size / 2 ? rest : rest - size;
}

} // namespace rastertrace
