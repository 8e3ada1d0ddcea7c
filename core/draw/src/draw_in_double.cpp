// SPDX-License-Identifier: MIT
#include "draw_piece.h"
#include "draw_scalar.h"
#include "screen_drawing_in.h"

#include <rastertrace/core/draw/paint/numbered_depths.h>

namespace rastertrace {

template Image draw_in<double>(const Scene&, const Plan&, const Listener&, Fallbacks*);
template class ScreenDrawing<double>;

// What `adaptive` draws in them.
template void draw_piece(const Piece<double>&, SceneDrawing<double, NumberedDepths>&,
                         const ListenerSink&);
template void draw_piece(const Piece<double>&, SceneDrawing<double, NumberedDepths>&,
                         const SkipSink&);

} // namespace rastertrace
