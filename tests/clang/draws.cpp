// SPDX-License-Identifier: MIT
// Draws with every scalar, so that clang++ sees the insides of the templates. With a sink that keeps
// steps, write_trace.cpp does.

#include <rastertrace/core/draw.h>
#include <rastertrace/core/plan.h>

namespace rastertrace {

Image drawn_with_its_scalar(const Scene& scene);

Image drawn_with_its_scalar(const Scene& scene) {
    const Plan plan = plan_for(scene);
    return with_scalar(plan,
                       [&]<typename Scalar>() { return draw<Scalar>(scene, plan, NullSink{}); });
}

} // namespace rastertrace
