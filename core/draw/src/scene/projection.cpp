// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/scene/projection.h>

#include <rastertrace/core/draw/scene/model.h>
#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/core/transform/projection.h>

namespace rastertrace {

bool is_rounded(const Projection& projection) {
    return projection.type == ProjectionType::frustum && projection.fov_y &&
           projection.fov_y->exact() != 90;
}

std::optional<Rational> near_of(const Projection& projection) {
    if (projection.near)
        return projection.near->exact();
    if (projection.type == ProjectionType::pinhole || projection.type == ProjectionType::view_plane)
        return Rational(projection.distance.exact() / near_part_of_distance);
    return std::nullopt;
}

std::optional<Rational> far_of(const Projection& projection) {
    return projection.far ? std::optional(projection.far->exact()) : std::nullopt;
}

std::vector<MatrixFactor<Rational>> factors_of(const Projection& projection, const Canvas& canvas) {
    const ViewSides<Rational> sides{projection.left.exact(), projection.right.exact(),
                                    projection.bottom.exact(), projection.top.exact()};
    const ViewRange<Rational> range{near_of(projection), far_of(projection)};
    const auto all = [](const auto& factors) {
        return std::vector<MatrixFactor<Rational>>(factors.begin(), factors.end());
    };
    switch (projection.type) {
    case ProjectionType::orthographic:
        return all(orthographic(sides, range));
    case ProjectionType::pinhole:
        return {{"perspective", pinhole<Rational>(projection.distance.exact())}};
    case ProjectionType::view_plane:
        return all(view_plane<Rational>(projection.distance.exact()));
    case ProjectionType::frustum:
        if (projection.fov_y)
            return {{"perspective",
                     frustum_of_view<Rational>(cotangent_of_degrees(projection.fov_y->exact() / 2),
                                               Rational(canvas.width) / canvas.height, range)}};
        return {{"perspective", frustum(sides, range)}};
    case ProjectionType::none:
        break;
    }
    return {};
}

Matrix<Rational> projection_matrix(const Projection& projection, const Canvas& canvas) {
    return product_of(factors_of(projection, canvas));
}

std::vector<ClipPlane<Rational>> clip_planes(const Projection& projection,
                                             const Rational& half_width,
                                             const Rational& half_height, const Rational& guard) {
    std::vector<ClipPlane<Rational>> planes;
    if (is_perspective(projection.type)) {
        const Rational distance_of_w =
            projection.type == ProjectionType::view_plane ? projection.distance.exact() : 1;
        planes.push_back({"near", {0, 0, 0, distance_of_w}, -*near_of(projection)});
        if (const auto far = far_of(projection))
            planes.push_back({"far", {0, 0, 0, -distance_of_w}, *far});
    } else if (projection.type == ProjectionType::orthographic && projection.near &&
               projection.far) {
        planes.push_back({"near", {0, 0, 1, 0}, 1});
        planes.push_back({"far", {0, 0, -1, 0}, 1});
    }
    if (projection.type != ProjectionType::none) {
        planes.push_back({"left", {1, 0, 0, guard * half_width}, 0});
        planes.push_back({"right", {-1, 0, 0, guard * half_width}, 0});
        planes.push_back({"bottom", {0, 1, 0, guard * half_height}, 0});
        planes.push_back({"top", {0, -1, 0, guard * half_height}, 0});
    }
    return planes;
}

} // namespace rastertrace
