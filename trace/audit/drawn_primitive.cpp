// SPDX-License-Identifier: MIT
#include "drawn_primitive.h"

namespace rastertrace {

void DrawnPixels::give_to(DrawnPrimitive& primitive) {
    put_in_order(pixels_);
    primitive.pixels = PixelSet(pixels_);
    if (!hidden_.empty()) {
        hidden_.insert(hidden_.end(), pixels_.begin(), pixels_.end());
        put_in_order(hidden_);
        primitive.covered = PixelSet(hidden_);
    }
    pixels_.clear();
    hidden_.clear();
}

} // namespace rastertrace
