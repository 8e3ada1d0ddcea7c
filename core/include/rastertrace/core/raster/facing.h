// SPDX-License-Identifier: MIT
#pragma once

// Which way a face is turned: to the eye or away.
//
// The normal of P1, P2, P3 is n = (P2 - P1) x (P3 - P1): outward on a solid whose faces run
// counter-clockwise as seen from outside, in right-handed space. The view leads from the face to
// the eye, and the front is seen if n . view > 0. Taken from the eye to the face, the same test has
// the opposite sign: the mistake of T0's text, where wrong numbers hid a wrong sign.
//
// Sources: T1 (hidden surfaces, normal . toward-the-eye, 0 is culled); T0 with its figures 22 to 28
// put right.
//
//     is_culled(Cull::back, dot(normal, view));

#include <rastertrace/core/numbers/index.h>
#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/choices.h>

#include <cstddef>
#include <span>

namespace rastertrace {

/// The normal of a face with these corners: at a right angle to it, as long as twice its area. The
/// sum of (P2 - P1) x (P3 - P1) over the triangles of the fan from its first corner, which is
/// Newell's normal: it is right for a concave polygon, and of corners in no plane their mean.
///
/// Source: Sutherland, Sproull and Schumacker 1974 (Newell's normal).
template <typename Scalar> Vec<Scalar, 3> normal_of(std::span<const Vec<Scalar, 3>> corners) {
    const Vec<Scalar, 3>& first = corners[0];
    Vec<Scalar, 3> normal = cross(corners[1] - first, corners[2] - first);
    for (std::size_t i = 3; i < corners.size(); ++i)
        normal = normal + cross(corners[i - 1] - first, corners[i] - first);
    return normal;
}

/// The mean of a face's corners.
template <typename Scalar> Vec<Scalar, 3> centroid_of(std::span<const Vec<Scalar, 3>> corners) {
    Vec<Scalar, 3> sum = corners[0];
    for (const Vec<Scalar, 3>& corner : corners.subspan(1))
        sum = sum + corner;
    const Scalar count = scalar_from<Scalar>(static_cast<Index>(corners.size()));
    return {Scalar(sum.x / count), Scalar(sum.y / count), Scalar(sum.z / count)};
}

template <typename Scalar> bool has_no_length(const Vec<Scalar, 3>& vector) {
    const Scalar zero = scalar_from<Scalar>(0);
    const bool surely_has_some = surely_differ(vector.x, zero) || surely_differ(vector.y, zero) ||
                                 surely_differ(vector.z, zero);
    return !surely_has_some && vector.x == zero && vector.y == zero && vector.z == zero;
}

/// True if a face with this normal . view is not drawn.
template <typename Scalar> bool is_culled(Cull cull, const Scalar& dot) {
    const Scalar zero = scalar_from<Scalar>(0);
    switch (cull) {
    case Cull::back:
    case Cull::light:
        return !(zero < dot);
    case Cull::front:
        return !(dot < zero);
    case Cull::both:
        return true;
    case Cull::none:
        break;
    }
    return false;
}

} // namespace rastertrace
