// SPDX-License-Identifier: MIT
#pragma once

// The parts of the table of mistakes, and what they share.

#include <rastertrace/core/draw/model/mistakes.h>

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
