// SPDX-License-Identifier: MIT
#include <rastertrace/numerics/drawing.h>

#include <rastertrace/core/draw/draw.h>

namespace rastertrace {

Image drawn(const Scene& scene, const Plan& plan) {
    return draw(scene, plan);
}

} // namespace rastertrace
