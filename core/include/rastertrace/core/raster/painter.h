// SPDX-License-Identifier: MIT
#pragma once

// The painter's algorithm: far triangles are drawn first, and near ones cover them. It is wrong
// where triangles overlap in a cycle or intersect, and where the sorting key does not give their
// order.
//
// Source: T0, with every triangle drawn, not only the nearest.
//
//     painter_order<double>(std::array{2.0, 5.0, 3.0});  // 1, 2, 0

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/raster/choices.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace rastertrace {

/// The distance that a face is sorted by, from those of its vertices.
template <typename Scalar> Scalar painter_key(PainterKey key, std::span<const Scalar> distances) {
    switch (key) {
    case PainterKey::nearest:
        return *std::min_element(distances.begin(), distances.end());
    case PainterKey::farthest:
        return *std::max_element(distances.begin(), distances.end());
    case PainterKey::mean:
        break;
    }
    const Scalar count = scalar_from<Scalar>(static_cast<Index>(distances.size()));
    Scalar sum = distances[0];
    for (const Scalar& distance : distances.subspan(1))
        sum = sum + distance;
    require_finite(sum);
    if constexpr (std::floating_point<Scalar>)
        if (!std::isfinite(sum)) {
            sum = distances[0] / count;
            for (const Scalar& distance : distances.subspan(1))
                sum += distance / count;
            return sum;
        }
    return sum / count;
}

/// The indices of these distances from the eye, the farthest first. Equal distances keep their
/// order.
template <typename Scalar>
std::vector<std::size_t> painter_order(std::span<const Scalar> distances) {
    std::vector<std::size_t> order(distances.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [distances](std::size_t a, std::size_t b) {
        return distances[b] < distances[a];
    });
    return order;
}

} // namespace rastertrace
