// SPDX-License-Identifier: MIT
#include "draw_piece.h"
#include "draw_scalar.h"
#include "screen_drawing_in.h"

#include <rastertrace/core/draw/paint/numbered_depths.h>

namespace rastertrace {

template Image draw_in<Rational>(const Scene&, const Plan&, const Listener&, Fallbacks*);
template class ScreenDrawing<Rational>;

// What `adaptive` draws in them.
template void draw_piece(const Piece<Rational>&, SceneDrawing<Rational, NumberedDepths>&,
                         const ListenerSink&);
template void draw_piece(const Piece<Rational>&, SceneDrawing<Rational, NumberedDepths>&,
                         const SkipSink&);

} // namespace rastertrace
