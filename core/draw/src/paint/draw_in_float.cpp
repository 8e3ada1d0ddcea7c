// SPDX-License-Identifier: MIT
#include "paint/draw_in.h"
#include "paint/draw_scalar.h"

namespace rastertrace {

template Image draw_in<float>(const Scene&, const Plan&, const Listener&, Fallbacks*);

} // namespace rastertrace
