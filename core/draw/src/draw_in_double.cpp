// SPDX-License-Identifier: MIT
#include "draw_in.h"
#include "draw_scalar.h"

namespace rastertrace {

template Image draw_in<double>(const Scene&, const Plan&, const Listener&, Fallbacks*);
template class ScreenDrawing<double>;

} // namespace rastertrace
