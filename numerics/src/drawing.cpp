// SPDX-License-Identifier: MIT
#include <rastertrace/numerics/drawing.h>

#include <rastertrace/core/draw/draw.h>

namespace rastertrace {

Image drawn(const Scene& scene, const Plan& plan, Fallbacks* fallbacks) {
    return draw(scene, plan, {}, fallbacks);
}

} // namespace rastertrace
