// SPDX-License-Identifier: MIT
#include <rastertrace/numerics/drawing.h>

#include <rastertrace/core/draw.h>
#include <rastertrace/core/sink.h>

namespace rastertrace {

Image drawn(const Scene& scene, const Plan& plan, Fallbacks* fallbacks) {
    return with_scalar(
        plan, [&]<typename Scalar>() { return draw<Scalar>(scene, plan, NullSink{}, fallbacks); });
}

} // namespace rastertrace
