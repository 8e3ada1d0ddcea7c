// SPDX-License-Identifier: MIT
// The undecided pieces: drawn with rationals, into a picture whose depths and colors are filtered
// doubles.

#include "draw_in.h"

namespace rastertrace {

template void draw_piece(const Piece<Rational>&, SceneDrawing<Rational, Adaptive>&,
                         const NullSink&);
template void draw_piece(const Piece<Rational>&, SceneDrawing<Rational, Adaptive>&,
                         const ListenerSink&);

} // namespace rastertrace
