// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/scene/transforms.h>

#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/core/raster/clip.h>
#include <rastertrace/core/transform/model.h>
#include <rastertrace/core/transform/projection.h>
#include <rastertrace/core/transform/viewport.h>

#include <algorithm>

namespace rastertrace {

Vec<Rational, 3> exact(const Numbers3& numbers) {
    return {numbers[0].exact(), numbers[1].exact(), numbers[2].exact()};
}

bool is_zero(const Vec<Rational, 3>& vector) {
    return vector.x == 0 && vector.y == 0 && vector.z == 0;
}

WholeMatrix over_one_denominator(const Matrix<Rational>& matrix) {
    mpz_class denominator = 1;
    for (const auto& row : matrix.rows)
        for (const Rational& entry : row)
            denominator = lcm(denominator, entry.get_den());
    return {mapped<mpz_class>(matrix,
                              [&denominator](const Rational& entry) {
                                  return mpz_class(entry.get_num() *
                                                   mpz_class(denominator / entry.get_den()));
                              }),
            denominator};
}

Matrix<Rational> product_of(std::span<const MatrixFactor<Rational>> factors) {
    WholeMatrix product{.numerators = identity<mpz_class>()};
    for (const MatrixFactor<Rational>& factor : factors) {
        const auto [numerators, denominator] = over_one_denominator(factor.matrix);
        product.numerators = product.numerators * numerators;
        product.denominator *= denominator;
    }
    return mapped<Rational>(product.numerators, [&product](const mpz_class& entry) {
        return quotient_of(entry, product.denominator);
    });
}

namespace {

/// number / sqrt(square): exactly if the root is rational.
Rational over_root(const Rational& number, const Rational& square, RootDigits digits) {
    return sgn(number) * square_root(number * number / square, digits);
}

/// A vector of length 1 in the direction of `vector`, which must not be 0: exactly if its length is
/// rational.
Vec<Rational, 3> unit_vector(const Vec<Rational, 3>& vector, RootDigits digits) {
    const Rational square = dot(vector, vector);
    return {over_root(vector.x, square, digits), over_root(vector.y, square, digits),
            over_root(vector.z, square, digits)};
}

bool has_irrational_length(const Vec<Rational, 3>& vector) {
    return !has_rational_root(dot(vector, vector));
}

// Models.

MatrixFactor<Rational> factor_of(const Scale& scale) {
    return {"scale", scaling<Rational>(exact(scale.by))};
}

MatrixFactor<Rational> factor_of(const Translate& translate) {
    return {"translate", translation<Rational>(exact(translate.by))};
}

MatrixFactor<Rational> factor_of(const Rotate& rotate) {
    const Rational degrees = rotate.degrees.exact();
    const Vec<Rational, 3> axis = exact(rotate.axis);
    return {"rotate", rotation<Rational>(axis, unit_vector(axis, rotate.digits),
                                         sine_of_degrees(degrees, rotate.digits),
                                         cosine_of_degrees(degrees, rotate.digits))};
}

MatrixFactor<Rational> factor_of(const Shear& by) {
    return {"shear", shear<Rational>({by.xy.exact(), by.xz.exact(), by.yx.exact(), by.yz.exact(),
                                      by.zx.exact(), by.zy.exact()})};
}

} // namespace

bool is_rounded(const ModelStep& step) {
    const auto* rotate = std::get_if<Rotate>(&step);
    if (rotate == nullptr)
        return false;
    const Rational degrees = rotate->degrees.exact();
    // Half turns need no sine, and so no length of the axis.
    return !is_quarter_turn(degrees) ||
           (sine_of_degrees(degrees) != 0 && has_irrational_length(exact(rotate->axis)));
}

MatrixFactors<Rational> factors_of(std::span<const ModelStep> steps) {
    MatrixFactors<Rational> factors;
    for (const ModelStep& step : steps)
        factors.push_back(std::visit([](const auto& kind) { return factor_of(kind); }, step));
    std::reverse(factors.begin(), factors.end());
    return factors;
}

// The camera.

CameraAxes<Rational> axes_of(const Camera& camera, ViewAxis axis) {
    return camera_axes<Rational>(exact(camera.position), exact(camera.look_at), exact(camera.up),
                                 axis);
}

CameraFault fault_of(const Camera& camera) {
    const CameraAxes<Rational> axes = axes_of(camera);
    return is_zero(axes.back)    ? CameraFault::looks_at_itself
           : is_zero(axes.right) ? CameraFault::up_along_view
                                 : CameraFault::none;
}

bool is_rounded(const Camera& camera) {
    const CameraAxes<Rational> axes = axes_of(camera);
    return has_irrational_length(axes.right) || has_irrational_length(axes.up) ||
           has_irrational_length(axes.back);
}

MatrixFactors<Rational> factors_of(const Camera& camera, ViewAxis axis) {
    const auto& [x, y, z] = axes_of(camera, axis);
    return view<Rational>({unit_vector(x, camera.digits), unit_vector(y, camera.digits),
                           unit_vector(z, camera.digits)},
                          exact(camera.position));
}

Matrix<Rational> view_matrix(const Camera& camera, ViewAxis axis) {
    Matrix<Rational> view = factors_of(camera, axis).front().matrix;
    const auto& [x, y, z] = axes_of(camera, axis);
    const Vec<Rational, 3> position = exact(camera.position);
    const std::array rows{x, y, z};
    for (std::size_t i = 0; i < rows.size(); ++i)
        view.rows[i][3] = over_root(-dot(rows[i], position), dot(rows[i], rows[i]), camera.digits);
    return view;
}

// The projection.

bool is_rounded(const Projection& projection) {
    return projection.type == ProjectionType::frustum && projection.fov_y &&
           projection.fov_y->exact() != 90;
}

std::optional<Rational> near_of(const Projection& projection) {
    if (projection.near)
        return projection.near->exact();
    if (projection.type == ProjectionType::pinhole || projection.type == ProjectionType::view_plane)
        return Rational(projection.distance.exact() / 1000);
    return std::nullopt;
}

std::optional<Rational> far_of(const Projection& projection) {
    return projection.far ? std::optional(projection.far->exact()) : std::nullopt;
}

MatrixFactors<Rational> factors_of(const Projection& projection, const Canvas& canvas) {
    const ViewSides<Rational> sides{projection.left.exact(), projection.right.exact(),
                                    projection.bottom.exact(), projection.top.exact()};
    const ViewRange<Rational> range{near_of(projection), far_of(projection)};
    switch (projection.type) {
    case ProjectionType::orthographic:
        return orthographic(sides, range);
    case ProjectionType::pinhole:
        return {{"perspective", pinhole<Rational>(projection.distance.exact())}};
    case ProjectionType::view_plane:
        return view_plane<Rational>(projection.distance.exact());
    case ProjectionType::frustum:
        if (projection.fov_y)
            return {{"perspective",
                     frustum_of_view<Rational>(
                         cotangent_of_degrees(projection.fov_y->exact() / 2, projection.digits),
                         Rational(canvas.width) / canvas.height, range)}};
        return {{"perspective", frustum(sides, range)}};
    case ProjectionType::clip_space:
    case ProjectionType::none:
        break;
    }
    return {};
}

std::vector<ClipPlane<Rational>> clip_planes(const Projection& projection,
                                             const Rational& half_width,
                                             const Rational& half_height, const Rational& guard) {
    std::vector<ClipPlane<Rational>> planes;
    if (projection.type == ProjectionType::clip_space) {
        planes.push_back({"near", {0, 0, 1, projection.z_from_zero ? 0 : 1}, 0});
        planes.push_back({"far", {0, 0, -1, 1}, 0});
    } else if (is_perspective(projection.type)) {
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
    if (projection.type ==
        ProjectionType::clip_space) // cuts off (0, 0, 0, 0), which all others let in
        planes.push_back({"w", {0, 0, 0, 1}, 0, true});
    return planes;
}

// The viewport.

MatrixFactors<Rational> factors_of(const Viewport& viewport, const Canvas& canvas) {
    switch (viewport.type) {
    case ViewportType::pixels: {
        std::optional<DepthRange<Rational>> depths;
        if (viewport.depths)
            depths = {viewport.depths->near.exact(), viewport.depths->far.exact(),
                      viewport.depths->lowest_z};
        return viewport_factors<Rational>({.left = canvas.left(),
                                           .lowest_y = std::min(canvas.top(), canvas.bottom()),
                                           .width = canvas.width,
                                           .height = canvas.height,
                                           .is_turned = (canvas.down() > 0) != viewport.is_y_down},
                                          viewport.pixels, depths);
    }
    case ViewportType::pixels_per_unit: {
        const Rational scale = viewport.pixels_per_unit.exact();
        return {{"scale", scaling<Rational>({scale, scale, 1})}};
    }
    case ViewportType::none:
        break;
    }
    return {};
}

Rational half_extent(const Viewport& viewport, int extent) {
    switch (viewport.type) {
    case ViewportType::pixels:
        return 1;
    case ViewportType::pixels_per_unit:
        return Rational(extent) / (2 * abs(viewport.pixels_per_unit.exact()));
    case ViewportType::none:
        break;
    }
    return extent;
}

} // namespace rastertrace
