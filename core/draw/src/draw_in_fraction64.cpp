// SPDX-License-Identifier: MIT
#include "draw_piece.h"
#include "draw_scalar.h"
#include "screen_drawing_in.h"

namespace rastertrace {

template Image draw_in<Fraction64>(const Scene&, const Plan&, const Listener&, Fallbacks*);
template class ScreenDrawing<Fraction64>;

} // namespace rastertrace
