// SPDX-License-Identifier: MIT
#include "refusal.h"

#include <rastertrace/trace/text/method_names.h>

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace rastertrace {

Refusal refusal_of(const Scene& scene, const Unfit& unfit) {
    const auto at = [&scene](std::size_t vertex, const std::array<double, 2>& place) {
        if (!std::isfinite(place[0]) || !std::isfinite(place[1]))
            return fmt::format("vertex {}", scene.vertices[vertex].name);
        return fmt::format("vertex {} at ({}, {}){}", scene.vertices[vertex].name, place[0],
                           place[1], scene.has_pipeline() ? " on the screen" : "");
    };
    const std::string from = at(unfit.from, unfit.from_at);
    const std::string to = at(unfit.to, unfit.to_at);
    const std::string scalar = value_in_force(*find_method_key("scalar"), scene);
    const std::string hint = decides_exactly(scene.method)
                                 ? ""
                                 : R"(with "method": {"scalar": "exact"} nothing overflows)";
    using What = Unfit::What;
    switch (unfit.what) {
    case What::matrix:
        return {fmt::format("expected a model, camera, projection and viewport whose matrices "
                            "fit in {}, found an entry beyond the largest number",
                            scalar),
                hint};
    case What::position:
        return {fmt::format("expected a vertex that has a place on the screen in {}, found "
                            "{}: beyond the largest number",
                            scalar, to),
                hint};
    case What::coordinate:
        return {fmt::format("expected coordinates up to {:.3g} for {}, found {}", unfit.limit,
                            scalar, to),
                hint};
    case What::coordinate_of_weights:
        return {fmt::format("expected coordinates up to {:.3g} for weights in {}, found {}",
                            unfit.limit, scalar, to),
                hint};
    case What::area_of_weights:
        return {fmt::format("expected a triangle whose weights fit in a {}, found one from "
                            "{} to {} that is almost without area",
                            scalar, from, to),
                hint};
    case What::coordinate_of_fixed:
        return {
            fmt::format("expected coordinates up to {:.0f} for fixed, found {}", unfit.limit, to),
            hint};
    case What::coordinate_of_snap:
        return {fmt::format("expected coordinates below {:.0f} to snap, found {}", unfit.limit, to),
                {}};
    case What::coordinate_of_line:
        return {fmt::format("expected coordinates up to {:.0f} for Bresenham's line, found "
                            "{}",
                            unfit.limit, to),
                {}};
    case What::edge_of_fan:
        return {fmt::format("expected edges of at most {:.0f} pixels for the fan, which "
                            "draws a line for each, found {} and {}",
                            unfit.limit, from, to),
                {}};
    case What::face:
        return {
            fmt::format("expected a face whose normal, times its view or its light, fits in {}, "
                        "found that of vertex {} beyond the largest number",
                        scalar, scene.vertices[unfit.from].name),
            hint};
    case What::depth:
        return {fmt::format("expected a distance above 0 for 1/distance, found vertex {} "
                            "at distance {}",
                            scene.vertices[unfit.to].name, unfit.to_at[0]),
                R"(with "depth": "linear-z" any distance will do)"};
    case What::depth_times_size:
        return {fmt::format("expected a depth whose product with a coordinate fits in a {}, "
                            "found that of vertex {}",
                            scalar, scene.vertices[unfit.to].name),
                hint};
    case What::slope:
        return {fmt::format("expected an edge whose slope dx/dy fits in a {}, found {} and "
                            "{}",
                            scalar, from, to),
                hint};
    }

    return {};
}

} // namespace rastertrace
