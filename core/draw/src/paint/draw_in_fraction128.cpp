// SPDX-License-Identifier: MIT
#include "paint/draw_in.h"
#include "paint/draw_scalar.h"

namespace rastertrace {

template Image draw_in<Fraction128>(const Scene&, const Plan&, const Listener&, Fallbacks*);

} // namespace rastertrace
