// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/scene/camera.h>

#include <array>
#include <cstddef>

namespace rastertrace {

CameraAxes<Rational> axes_of(const Camera& camera) {
    return camera_axes<Rational>(exact(camera.position), exact(camera.look_at), exact(camera.up));
}

bool is_zero(const Vec<Rational, 3>& vector) {
    return vector.x == 0 && vector.y == 0 && vector.z == 0;
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

std::vector<MatrixFactor<Rational>> factors_of(const Camera& camera, ViewAxis axis) {
    const auto& [right, up, back] = axes_of(camera);
    const auto factors = view<Rational>({unit_vector(right), unit_vector(up), unit_vector(back)},
                                        exact(camera.position), axis);
    return {factors.begin(), factors.end()};
}

Matrix<Rational> view_matrix(const Camera& camera, ViewAxis axis) {
    Matrix<Rational> view = factors_of(camera, axis).front().matrix;
    const CameraAxes<Rational> axes = axes_of(camera);
    const Vec<Rational, 3> position = exact(camera.position);
    const std::array rows{axes.right, axes.up,
                          axis == ViewAxis::minus_z ? axes.back : Vec<Rational, 3>{} - axes.back};
    for (std::size_t i = 0; i < rows.size(); ++i)
        view.rows[i][3] = over_root(-dot(rows[i], position), dot(rows[i], rows[i]));
    return view;
}

} // namespace rastertrace
