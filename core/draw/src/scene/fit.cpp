// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/scene/fit.h>

#include <rastertrace/core/numbers/irrational.h>

#include <algorithm>

namespace rastertrace {

namespace {

// Numbers of few digits.

/// A unit of the third digit of a positive value: 10^(e - 2) where 10^e <= value < 10^(e + 1).
Rational step_of(const Rational& value) {
    const auto digits = [](const mpz_class& number) {
        return mpz_sizeinbase(number.get_mpz_t(), 10);
    };
    Rational power = 1;
    mpz_ui_pow_ui(power.get_num_mpz_t(), 10, digits(value.get_num()));
    mpz_ui_pow_ui(power.get_den_mpz_t(), 10, digits(value.get_den()));
    power.canonicalize();
    // Both counts of digits can be too large by 1.
    while (power > value)
        power /= 10;
    while (power * 10 <= value)
        power *= 10;
    return power / 100;
}

/// The largest multiple of `step` that is not above the value.
Rational rounded_down(const Rational& value, const Rational& step) {
    const Rational steps = value / step;
    mpz_class whole;
    mpz_fdiv_q(whole.get_mpz_t(), steps.get_num_mpz_t(), steps.get_den_mpz_t());
    return step * whole;
}

Rational rounded_up(const Rational& value, const Rational& step) {
    return -rounded_down(-value, step);
}

/// The nearest multiple of `step`.
Rational rounded(const Rational& value, const Rational& step) {
    return rounded_down(value + step / 2, step);
}

Rational middle_of(const Rational& low, const Rational& high) {
    return (low + high) / 2;
}

Number number_of(const Rational& value) {
    return value.get_den() == 1 && value.get_num().fits_slong_p() ? Number(value.get_num().get_si())
                                                                  : Number::fraction(value);
}

/// The square root of a positive number, or a little more: less than 2^-60 of it.
Rational root_from_above(const Rational& square) {
    // sqrt(p/q) = sqrt(p q) / q, with at least 64 bits.
    const mpz_class product = square.get_num() * square.get_den();
    constexpr mp_bitcnt_t more_bits = 64;
    const mpz_class shifted = product << (2 * more_bits);
    mpz_class root = sqrt(shifted);
    if (root * root < shifted)
        ++root;
    return quotient_of(root, square.get_den() << more_bits);
}

// What can be seen.

/// How far an axis is shown to both sides of the center, in canonical units.
Rational half_of(const Viewport& viewport, int extent) {
    if (viewport.type == ViewportType::pixels)
        return 1;
    const Rational pixels = std::max<Rational>((extent - 1) / 2, Rational(1, 2));
    return viewport.type == ViewportType::pixels_per_unit
               ? Rational(pixels / abs(viewport.pixels_per_unit.exact()))
               : pixels;
}

/// `half` canonical units to each side of the middle, where low..high is a unit to each side.
Extent scaled(const Number& low, const Number& high, const Rational& half) {
    const Rational middle = middle_of(low.exact(), high.exact());
    const Rational reach = half * (high.exact() - low.exact()) / 2;
    return {middle - reach, middle + reach};
}

Extent divided(const Extent& interval, const Rational& by) {
    return {interval.low / by, interval.high / by};
}

Extent intersection(const Extent& a, const Extent& b) {
    return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

// Where the camera stands.

/// The eye's distance from the sphere's center, and the center's from the middle of the view.
struct Standpoint {
    Rational distance;
    Rational x;
    Rational y;
};

/// An axis of a perspective: the least distance at which its two sides leave a sphere of this
/// radius whole, and the sphere's center there.
struct Sides {
    const Extent& slopes;
    const Rational& radius;
    Rational low_root = root_from_above(1 + slopes.low * slopes.low);
    Rational high_root = root_from_above(1 + slopes.high * slopes.high);

    Rational distance() const {
        return radius * (low_root + high_root) / (slopes.high - slopes.low);
    }
    /// The middle of the possible centers; 0 if both sides are alike.
    Rational center_at(const Rational& distance) const {
        return ((slopes.low + slopes.high) * distance + radius * (low_root - high_root)) / 2;
    }
};

/// Where a camera sees all of a sphere of this radius; x and y are multiples of `step`.
Standpoint standpoint(const ViewVolume& volume, const Rational& radius, const Rational& step) {
    if (!volume.is_perspective)
        return {volume.far ? rounded(middle_of(volume.near, *volume.far), step) : 2 * radius,
                rounded(middle_of(volume.x.low, volume.x.high), step),
                rounded(middle_of(volume.y.low, volume.y.high), step)};
    const Sides x{volume.x, radius};
    const Sides y{volume.y, radius};
    const Rational least = std::max<Rational>({x.distance(), y.distance(), volume.near + radius});
    const Rational distance = rounded_up(least, step_of(least));
    return {distance, rounded(x.center_at(distance), step), rounded(y.center_at(distance), step)};
}

Numbers3 numbers_of(const Vec<Rational, 3>& point) {
    return {number_of(point.x), number_of(point.y), number_of(point.z)};
}

} // namespace

void include(std::optional<Box>& box, const Vec<Rational, 3>& point) {
    if (!box)
        box = Box{point, point};
    for (Rational Vec<Rational, 3>::*const axis :
         {&Vec<Rational, 3>::x, &Vec<Rational, 3>::y, &Vec<Rational, 3>::z}) {
        if (point.*axis < box->low.*axis)
            box->low.*axis = point.*axis;
        if (point.*axis > box->high.*axis)
            box->high.*axis = point.*axis;
    }
}

Vec<Rational, 3> center_of(const Box& box) {
    const Vec<Rational, 3> size = box.high - box.low;
    const Rational largest = std::max<Rational>({size.x, size.y, size.z});
    if (largest == 0)
        return box.low;
    const Rational step = step_of(largest);
    return {rounded(middle_of(box.low.x, box.high.x), step),
            rounded(middle_of(box.low.y, box.high.y), step),
            rounded(middle_of(box.low.z, box.high.z), step)};
}

ViewVolume view_volume(const Projection& projection, const Viewport& viewport,
                       const Canvas& canvas) {
    const Rational half_x = half_of(viewport, canvas.width);
    const Rational half_y = half_of(viewport, canvas.height);
    ViewVolume volume{.is_perspective = is_perspective(projection.type),
                      .x = {-half_x, half_x},
                      .y = {-half_y, half_y},
                      .near = near_of(projection).value_or(0),
                      .far = far_of(projection)};
    switch (projection.type) {
    case ProjectionType::pinhole:
    case ProjectionType::view_plane:
        volume.x = divided(volume.x, projection.distance.exact());
        volume.y = divided(volume.y, projection.distance.exact());
        break;
    case ProjectionType::frustum:
        if (projection.fov_y) {
            const Rational scale = cotangent_of_degrees(projection.fov_y->exact() / 2);
            volume.x = divided(volume.x, scale * canvas.height / canvas.width);
            volume.y = divided(volume.y, scale);
        } else {
            volume.x = divided(scaled(projection.left, projection.right, half_x), volume.near);
            volume.y = divided(scaled(projection.bottom, projection.top, half_y), volume.near);
        }
        break;
    case ProjectionType::orthographic:
        volume.x = scaled(projection.left, projection.right, half_x);
        volume.y = scaled(projection.bottom, projection.top, half_y);
        break;
    case ProjectionType::clip_space:
    case ProjectionType::none:
        break;
    }
    return volume;
}

ViewVolume intersection(const ViewVolume& a, const ViewVolume& b) {
    return {.is_perspective = a.is_perspective,
            .x = intersection(a.x, b.x),
            .y = intersection(a.y, b.y),
            .near = std::max(a.near, b.near),
            .far = !a.far   ? b.far
                   : !b.far ? a.far
                            : std::min(a.far, b.far)};
}

std::variant<FittedCamera, FitFault> fitted_camera(const Vec<Rational, 3>& center,
                                                   const Rational& square, const ViewVolume& volume,
                                                   ViewAxis axis) {
    if (square == 0)
        return FitFault::one_place;
    if (volume.x.low >= volume.x.high || volume.y.low >= volume.y.high)
        return FitFault::no_view;

    // Rounding may move the view by a step, which is added to the radius.
    const Rational exact_radius = root_from_above(square);
    const Rational step = step_of(exact_radius);
    const Rational radius = rounded_up(exact_radius, step) + step;
    const Rational reach =
        std::max<Rational>({abs(center.x), abs(center.y), abs(center.z)}) + radius;
    if (exact_radius < Rational(smallest_fit) || reach > Rational(largest_fit))
        return FitFault::size;

    const auto [distance, x, y] = standpoint(volume, radius, step);
    if (distance > Rational(largest_fit))
        return FitFault::size;

    // An eye at the center, or beyond it, looks as far ahead as the sphere reaches.
    const int back = axis == ViewAxis::minus_z ? 1 : -1; // world z against the view
    const Rational ahead = distance > 0 ? distance : radius;
    const Vec<Rational, 3> eye{center.x - x, center.y - y, center.z + back * distance};
    const Rational nearest = distance - radius;
    const Rational farthest = distance + radius;
    return FittedCamera{
        .camera = {.position = numbers_of(eye),
                   .look_at = numbers_of({eye.x, eye.y, eye.z - back * ahead})},
        .near = number_of(nearest > 0 ? rounded_down(nearest, step_of(nearest)) : nearest),
        .far = number_of(farthest > 0 ? rounded_up(farthest, step_of(farthest)) : farthest)};
}

} // namespace rastertrace
