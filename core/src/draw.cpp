// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/draw.h>

#include "draw_scalar.h"

namespace rastertrace {

Image draw(const Scene& scene, const Plan& plan, const Listener& listener, Fallbacks* fallbacks) {
    return with_scalar(
        plan, [&]<typename Scalar>() { return draw_in<Scalar>(scene, plan, listener, fallbacks); });
}

} // namespace rastertrace
