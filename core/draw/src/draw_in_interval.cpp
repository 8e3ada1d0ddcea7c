// SPDX-License-Identifier: MIT
#include "draw_piece.h"

#include <rastertrace/core/draw/paint/numbered_depths.h>

namespace rastertrace {

// What `adaptive` tries in them.
template void draw_piece(const Piece<Interval>&, SceneDrawing<Interval, NumberedDepths>&,
                         const ListenerSink&);
template void draw_piece(const Piece<Interval>&, SceneDrawing<Interval, NumberedDepths>&,
                         const NullSink&);

} // namespace rastertrace
