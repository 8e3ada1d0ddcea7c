// SPDX-License-Identifier: MIT
#pragma once

// What a scene says of its spaces: models, a camera, a projection and a viewport, and the matrices
// of transform/ for them in exact numbers. What is irrational in a matrix is the nearest double, or
// has as many `digits` as are asked for; each Scalar then rounds each entry once.
//
//     Model({Scale{{2, 2, 2}}, Translate{{0, 0, 4}}}).matrix();  // scales first, then moves
//     view_matrix({.position = {0, 0, 4}}, ViewAxis::minus_z);   // moves the world by (0, 0, -4)

#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/transform/camera.h>
#include <rastertrace/core/transform/viewport.h>

#include <initializer_list>
#include <span>
#include <utility>
#include <variant>

namespace rastertrace {

template <typename Scalar> struct ClipPlane; // raster/clip.h

/// x, y and z as typed.
using Numbers3 = std::array<Number, 3>;

Vec<Rational, 3> exact(const Numbers3& numbers);

bool is_zero(const Vec<Rational, 3>& vector);

/// A matrix written as whole numbers over one denominator. Fractions would be reduced in each sum.
struct WholeMatrix {
    Matrix<mpz_class> numerators;
    mpz_class denominator = 1;
};

WholeMatrix over_one_denominator(const Matrix<Rational>& matrix);

/// The product of the factors in this order, so that the last one moves a point first. Of none, the
/// identity.
Matrix<Rational> product_of(std::span<const MatrixFactor<Rational>> factors);

/// The matrix with each entry rounded to a Scalar.
template <typename Scalar> Matrix<Scalar> rounded(const Matrix<Rational>& exact) {
    return mapped<Scalar>(exact, nearest_scalar<Scalar>);
}

/// Multiplies x, y and z each by its own number.
struct Scale {
    Numbers3 by;
    friend bool operator==(const Scale&, const Scale&) = default;
};

/// Adds to x, y and z.
struct Translate {
    Numbers3 by;
    friend bool operator==(const Translate&, const Translate&) = default;
};

/// Turns about an axis through the origin; counter-clockwise as seen from the axis's tip.
struct Rotate {
    Numbers3 axis; ///< of any length but 0
    Number degrees;
    RootDigits digits = RootDigits::of_double; ///< of the matrix
    friend bool operator==(const Rotate&, const Rotate&) = default;
};

/// Adds to each coordinate multiples of the others: x grows by xy y + xz z, and so on.
struct Shear {
    Number xy, xz, yx, yz, zx, zy;
    friend bool operator==(const Shear&, const Shear&) = default;
};

/// A step of a model.
using ModelStep = std::variant<Scale, Translate, Rotate, Shear>;

/// True if the matrix of this step is not exact.
bool is_rounded(const ModelStep& step);

/// The factors of a model: the first step moves a point first, so it is the last factor.
MatrixFactors<Rational> factors_of(std::span<const ModelStep> steps);

/// The steps of a model, from object space to the world, and their matrix.
class Model {
public:
    Model(std::initializer_list<ModelStep> steps) : Model(std::vector<ModelStep>(steps)) {}
    Model(std::vector<ModelStep> steps = {}) // NOLINT: steps are a model
        : steps_(std::move(steps)), matrix_(product_of(factors_of(steps_))) {}

    const std::vector<ModelStep>& steps() const { return steps_; }
    const Matrix<Rational>& matrix() const { return matrix_; }

private:
    std::vector<ModelStep> steps_;
    Matrix<Rational> matrix_;
};

/// Where the eye is and where it looks.
struct Camera {
    Numbers3 position{0, 0, 0};
    Numbers3 look_at{0, 0, -1};
    Numbers3 up{0, 1, 0};                      ///< any direction that is not the view's
    RootDigits digits = RootDigits::of_double; ///< of the matrix
};

/// The axes of a camera, of any length.
CameraAxes<Rational> axes_of(const Camera& camera, ViewAxis axis = ViewAxis::minus_z);

/// What is wrong with a camera.
enum class CameraFault { none, looks_at_itself, up_along_view };

CameraFault fault_of(const Camera& camera);

/// True if the matrix of this camera is not exact.
bool is_rounded(const Camera& camera);

/// The rotation and the translation of a camera, which must have no fault.
MatrixFactors<Rational> factors_of(const Camera& camera, ViewAxis axis);

/// The product of the factors. Where the length of an axis is irrational, the shift -position .
/// axis is divided by it last, and rounded once: a position at right angles to the axis gives 0.
Matrix<Rational> view_matrix(const Camera& camera, ViewAxis axis);

enum class ProjectionType {
    none,
    orthographic,
    pinhole,
    view_plane,
    frustum,
    clip_space, ///< vertices have been projected before they were typed
};

/// How the camera's space is projected. What a type does not use is not read.
struct Projection {
    ProjectionType type = ProjectionType::none;
    Number distance = 1;              ///< pinhole, view-plane: from the eye to the view plane
    std::optional<Number> fov_y = {}; ///< frustum: the vertical field of view in degrees, or
    Number left = -1;                 ///< these, at the distance `near`
    Number right = 1;
    Number bottom = -1;
    Number top = 1;
    std::optional<Number> near = {}; ///< orthographic: none clips nothing
    std::optional<Number> far = {};  ///< none is infinitely far
    bool z_from_zero = false;        ///< clip space: 0 <= z <= w is in view, not -w <= z <= w
    RootDigits digits = RootDigits::of_double; ///< of the matrix
};

inline bool is_perspective(ProjectionType type) {
    return type == ProjectionType::pinhole || type == ProjectionType::view_plane ||
           type == ProjectionType::frustum || type == ProjectionType::clip_space;
}

inline ViewAxis view_axis_of(ProjectionType type) {
    return type == ProjectionType::pinhole ? ViewAxis::plus_z : ViewAxis::minus_z;
}

/// True if the matrix is not exact.
bool is_rounded(const Projection& projection);

/// The nearest distance from the eye that is shown; `nullopt` if everything is. A pinhole or a view
/// plane without `near` shows nothing nearer than 1/1000 of the view plane's distance: what lies at
/// the eye itself cannot be projected.
std::optional<Rational> near_of(const Projection& projection);

std::optional<Rational> far_of(const Projection& projection);

/// The factors of a projection: two of a view plane and of an orthographic one, one of the others.
/// The canvas gives the frustum of a field of view its width.
MatrixFactors<Rational> factors_of(const Projection& projection, const Canvas& canvas);

/// The planes of a projection. Near and far are distances from the eye, which in a perspective are
/// a multiple of w, so that the rounding of z does not matter; of vertices typed in clip space they
/// are -w <= z <= w and w > 0, as the other planes also accept (0, 0, 0, 0), which is no point. The
/// four sides stand `guard` x (half the canvas) away from the middle: the fill drops what lies
/// nearer pixel by pixel; what lies beyond would be too far out for it.
std::vector<ClipPlane<Rational>> clip_planes(const Projection& projection,
                                             const Rational& half_width,
                                             const Rational& half_height, const Rational& guard);

/// True if what is in view has a canonical z of -1 (near) to 1 (far).
inline bool has_canonical_z(const Projection& projection) {
    return projection.type == ProjectionType::frustum ||
           projection.type == ProjectionType::clip_space ||
           (projection.type == ProjectionType::orthographic && projection.near);
}

enum class ViewportType {
    none,   ///< canonical coordinates are pixels
    pixels, ///< all of -1..1 is on the canvas
    pixels_per_unit,
};

struct Viewport {
    ViewportType type = ViewportType::none;
    Number pixels_per_unit = 1;
    PixelRange pixels = PixelRange::centers;
    bool is_y_down = false; ///< y = 1 is at the bottom of the picture
    std::optional<DepthRange<Number>> depths = {};

    /// True if the nearest depth is the largest.
    bool has_reversed_depths() const {
        return depths && depths->near.exact() > depths->far.exact();
    }
};

/// The factors of a viewport.
MatrixFactors<Rational> factors_of(const Viewport& viewport, const Canvas& canvas);

/// Half of a canvas of this width or height in canonical units; all of it without a viewport.
Rational half_extent(const Viewport& viewport, int extent);

} // namespace rastertrace
