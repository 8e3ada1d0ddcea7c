// SPDX-License-Identifier: MIT
#pragma once

// Which algorithm draws, on which numbers, with which conventions: what a scene's "method" says.
//
//     Method method{.scalar = ScalarKind::exact, .rounding = Rounding::truncate};

#include <rastertrace/core/edge.h>
#include <rastertrace/core/rounding.h>

namespace rastertrace {

/// The numbers to draw with.
enum class ScalarKind {
    double_precision, ///< IEEE 754 binary64
    exact,            ///< fractions of whole numbers; nothing is ever rounded but to a pixel
};

/// The algorithm that fills triangles.
enum class Fill {
    scanline, ///< row by row, the long edge against the two short ones joined
};

/// The choices of a scene, with their defaults.
struct Method {
    ScalarKind scalar = ScalarKind::double_precision;
    Fill fill = Fill::scanline;
    Rounding rounding = Rounding::floor;
    Ties ties = Ties::up;
    LerpForm lerp = LerpForm::direct;
};

} // namespace rastertrace
