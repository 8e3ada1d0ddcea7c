// SPDX-License-Identifier: MIT
#include <rastertrace/core/transform/camera.h>
#include <rastertrace/core/transform/projection.h>
#include <rastertrace/core/transform/transform.h>
#include <rastertrace/core/transform/viewport.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {

// matrix.h

namespace {

/// A matrix as whole numbers over one denominator. Products of many stay cheap: fractions would be
/// reduced in each of their sums.
struct WholeMatrix {
    std::array<std::array<mpz_class, 4>, 4> above;
    mpz_class below = 1;
};

WholeMatrix whole(const Matrix<Rational>& matrix) {
    WholeMatrix result;
    for (const auto& row : matrix.rows)
        for (const Rational& entry : row)
            result.below = lcm(result.below, entry.get_den());
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            result.above[i][j] =
                matrix.rows[i][j].get_num() * mpz_class(result.below / matrix.rows[i][j].get_den());
    return result;
}

WholeMatrix operator*(const WholeMatrix& a, const WholeMatrix& b) {
    WholeMatrix product;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            product.above[i][j] = a.above[i][0] * b.above[0][j] + a.above[i][1] * b.above[1][j] +
                                  a.above[i][2] * b.above[2][j] + a.above[i][3] * b.above[3][j];
    product.below = a.below * b.below;
    return product;
}

} // namespace

Matrix<Rational> product_of(std::span<const MatrixFactor<Rational>> factors) {
    WholeMatrix product = whole(identity<Rational>());
    for (const MatrixFactor<Rational>& factor : factors)
        product = product * whole(factor.matrix);

    Matrix<Rational> matrix;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            matrix.rows[i][j] = quotient_of(product.above[i][j], product.below);
    return matrix;
}

// transform.h

Vec<Rational, 3> exact(const Numbers3& numbers) {
    return {numbers[0].exact(), numbers[1].exact(), numbers[2].exact()};
}

namespace {

/// A number divided by the square root of another one; rounded once.
Rational over_root(const Rational& number, const Rational& square) {
    return sgn(number) * square_root(number * number / square);
}

} // namespace

Vec<Rational, 3> unit_vector(const Vec<Rational, 3>& vector) {
    const Rational square = dot(vector, vector);
    return {over_root(vector.x, square), over_root(vector.y, square), over_root(vector.z, square)};
}

bool has_irrational_length(const Vec<Rational, 3>& vector) {
    return !has_rational_root(dot(vector, vector));
}

bool is_rounded(const ModelStep& step) {
    const auto* rotate = std::get_if<Rotate>(&step);
    if (rotate == nullptr)
        return false;
    const Rational degrees = rotate->degrees.exact();
    return !is_quarter_turn(degrees) ||
           (sine_of_degrees(degrees) != 0 && has_irrational_length(exact(rotate->axis)));
}

Matrix<Rational> matrix_of(const Scale& scale) {
    const auto by = exact(scale.by);
    return diagonal<Rational>(by.x, by.y, by.z, 1);
}

Matrix<Rational> matrix_of(const Translate& translate) {
    return translation<Rational>(exact(translate.by));
}

Matrix<Rational> matrix_of(const Rotate& rotate) {
    const Rational degrees = rotate.degrees.exact();
    const Rational sine = sine_of_degrees(degrees);
    const Rational cosine = cosine_of_degrees(degrees);
    const Vec<Rational, 3> axis = exact(rotate.axis);
    const Vec<Rational, 3> unit = unit_vector(axis);
    const Rational square = dot(axis, axis);
    const std::array<Rational, 3> v{axis.x, axis.y, axis.z};
    const std::array<std::array<Rational, 3>, 3> cross{
        {{0, -unit.z, unit.y}, {unit.z, 0, -unit.x}, {-unit.y, unit.x, 0}}};
    Matrix<Rational> matrix = identity<Rational>();
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            matrix.rows[i][j] = Rational((i == j ? cosine : Rational(0)) +
                                         (1 - cosine) * v[i] * v[j] / square + sine * cross[i][j]);
    return matrix;
}

Matrix<Rational> matrix_of(const Shear& shear) {
    return {{{{1, shear.xy.exact(), shear.xz.exact(), 0},
              {shear.yx.exact(), 1, shear.yz.exact(), 0},
              {shear.zx.exact(), shear.zy.exact(), 1, 0},
              {0, 0, 0, 1}}}};
}

namespace {

std::string_view name_of(const Scale&) {
    return "scale";
}
std::string_view name_of(const Translate&) {
    return "translate";
}
std::string_view name_of(const Rotate&) {
    return "rotate";
}
std::string_view name_of(const Shear&) {
    return "shear";
}

} // namespace

std::vector<MatrixFactor<Rational>> factors_of(std::span<const ModelStep> steps) {
    std::vector<MatrixFactor<Rational>> factors;
    for (const ModelStep& step : steps)
        factors.push_back(std::visit(
            [](const auto& one) {
                return MatrixFactor<Rational>{name_of(one), matrix_of(one)};
            },
            step));
    std::reverse(factors.begin(), factors.end());
    return factors;
}

// camera.h

CameraAxes axes_of(const Camera& camera) {
    const auto back = exact(camera.position) - exact(camera.look_at);
    const auto right = cross(exact(camera.up), back);
    return {right, cross(back, right), back};
}

bool is_zero(const Vec<Rational, 3>& vector) {
    return vector.x == 0 && vector.y == 0 && vector.z == 0;
}

CameraFault fault_of(const Camera& camera) {
    const CameraAxes axes = axes_of(camera);
    return is_zero(axes.back)    ? CameraFault::looks_at_itself
           : is_zero(axes.right) ? CameraFault::up_along_view
                                 : CameraFault::none;
}

bool is_rounded(const Camera& camera) {
    const CameraAxes axes = axes_of(camera);
    return has_irrational_length(axes.right) || has_irrational_length(axes.up) ||
           has_irrational_length(axes.back);
}

std::vector<MatrixFactor<Rational>> factors_of(const Camera& camera, ViewAxis axis) {
    const CameraAxes axes = axes_of(camera);
    const auto x = unit_vector(axes.right);
    const auto y = unit_vector(axes.up);
    const auto back = unit_vector(axes.back);
    const int sign = axis == ViewAxis::minus_z ? 1 : -1;
    const Matrix<Rational> rotation{{{{x.x, x.y, x.z, 0},
                                      {y.x, y.y, y.z, 0},
                                      {sign * back.x, sign * back.y, sign * back.z, 0},
                                      {0, 0, 0, 1}}}};
    return {{"rotate", rotation},
            {"translate", translation<Rational>(Vec<Rational, 3>{} - exact(camera.position))}};
}

Matrix<Rational> view_matrix(const Camera& camera, ViewAxis axis) {
    Matrix<Rational> view = factors_of(camera, axis).front().matrix;
    const CameraAxes axes = axes_of(camera);
    const Vec<Rational, 3> position = exact(camera.position);
    const std::array rows{axes.right, axes.up,
                          axis == ViewAxis::minus_z ? axes.back : Vec<Rational, 3>{} - axes.back};
    for (std::size_t i = 0; i < rows.size(); ++i)
        view.rows[i][3] = over_root(-dot(rows[i], position), dot(rows[i], rows[i]));
    return view;
}

// projection.h

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
    const Rational d = projection.distance.exact();
    const Rational left = projection.left.exact();
    const Rational right = projection.right.exact();
    const Rational bottom = projection.bottom.exact();
    const Rational top = projection.top.exact();
    const auto near = near_of(projection);
    const auto far = far_of(projection);
    switch (projection.type) {
    case ProjectionType::orthographic: {
        const bool has_depth = near && far;
        const Rational z_scale = has_depth ? Rational(-2 / (*far - *near)) : Rational(-1);
        const Rational z_middle = has_depth ? Rational(-(*far + *near) / 2) : Rational(0);
        return {{"scale", diagonal<Rational>(2 / (right - left), 2 / (top - bottom), z_scale, 1)},
                {"translate",
                 translation<Rational>({-(left + right) / 2, -(bottom + top) / 2, -z_middle})}};
    }
    case ProjectionType::pinhole:
        return {{"perspective", {{{{d, 0, 0, 0}, {0, d, 0, 0}, {0, 0, 1, -d}, {0, 0, 1, 0}}}}}};
    case ProjectionType::view_plane:
        return {{"perspective", {{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, -1 / d, 1}}}}},
                {"translate", translation<Rational>({0, 0, d})}};
    case ProjectionType::frustum: {
        // Infinitely far is the limit of the finite formulas.
        const Rational z_scale = far ? Rational(-(*far + *near) / (*far - *near)) : Rational(-1);
        const Rational z_shift =
            far ? Rational(-2 * *far * *near / (*far - *near)) : Rational(-2 * *near);
        if (projection.fov_y) {
            const Rational scale = cotangent_of_degrees(projection.fov_y->exact() / 2);
            return {{"perspective",
                     {{{{scale * canvas.height / canvas.width, 0, 0, 0},
                        {0, scale, 0, 0},
                        {0, 0, z_scale, z_shift},
                        {0, 0, -1, 0}}}}}};
        }
        return {{"perspective",
                 {{{{2 * *near / (right - left), 0, (right + left) / (right - left), 0},
                    {0, 2 * *near / (top - bottom), (top + bottom) / (top - bottom), 0},
                    {0, 0, z_scale, z_shift},
                    {0, 0, -1, 0}}}}}};
    }
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

// viewport.h

std::vector<MatrixFactor<Rational>> factors_of(const Viewport& viewport, const Canvas& canvas) {
    std::vector<MatrixFactor<Rational>> factors;
    switch (viewport.type) {
    case ViewportType::fit: {
        const Rational lowest_y = std::min(canvas.top(), canvas.bottom());
        if (canvas.left() != 0 || lowest_y != 0)
            factors.push_back(
                {"translate", translation<Rational>({canvas.left(), lowest_y, Rational(0)})});
        factors.push_back({"scale", diagonal<Rational>(Rational(canvas.width - 1) / 2,
                                                       Rational(canvas.height - 1) / 2, 1, 1)});
        factors.push_back({"translate", translation<Rational>({1, 1, 0})});
        if (canvas.down() > 0)
            factors.push_back({"flip", diagonal<Rational>(1, -1, 1, 1)});
        break;
    }
    case ViewportType::pixels_per_unit: {
        const Rational scale = viewport.pixels_per_unit.exact();
        factors.push_back({"scale", diagonal<Rational>(scale, scale, 1, 1)});
        break;
    }
    case ViewportType::none:
        break;
    }
    return factors;
}

Matrix<Rational> viewport_matrix(const Viewport& viewport, const Canvas& canvas) {
    return product_of(factors_of(viewport, canvas));
}

Rational half_extent(const Viewport& viewport, int extent) {
    switch (viewport.type) {
    case ViewportType::fit:
        return 1;
    case ViewportType::pixels_per_unit:
        return Rational(extent) / (2 * abs(viewport.pixels_per_unit.exact()));
    case ViewportType::none:
        break;
    }
    return extent;
}

} // namespace rastertrace
