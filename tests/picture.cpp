// SPDX-License-Identifier: MIT

#include "picture.h"

namespace rastertrace {

Image draw_as_planned(const Scene& scene) {
    const Plan plan = plan_for(scene);
    return with_scalar(plan,
                       [&]<typename Scalar>() { return draw<Scalar>(scene, plan, NullSink{}); });
}

Image draw_watched(const Scene& scene, const std::function<void(const AnyStep&)>& watch) {
    const Plan plan = plan_for(scene);
    const auto sink = [&watch](const auto& step) { watch(&step); };
    return with_scalar(plan, [&]<typename Scalar>() { return draw<Scalar>(scene, plan, sink); });
}

} // namespace rastertrace
