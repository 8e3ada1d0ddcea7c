// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/scene/triangulate.h>

#include "ear_cutter.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>

namespace rastertrace {

namespace {

// The coordinates of a face, written over one denominator, are whole numbers: `Whole`. The components
// of its normal are sums of products of two. For nearly all meshes, std::int64_t and Int128 do.
// Others need mpz_class for both.

/// Coordinates in std::int64_t have at most this many bits, so that the normal (Int128) times one
/// of them fits in two Int128 (height_of).
constexpr int most_bits_of_grid = 59;

/// Twice the area in each of the three planes: the sum of (y1 - y2)(z1 + z2) over all edges, and so
/// on (M. E. Newell, in Sutherland, Sproull and Schumacker, A Characterization of Ten
/// Hidden-Surface Algorithms, 1974).
template <typename Whole>
std::array<ProductOf<Whole>, 3> newells_normal(std::span<const std::array<Whole, 3>> corners) {
    std::array<ProductOf<Whole>, 3> normal{};
    const auto* from = &corners.back();
    for (const auto& to : corners) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t y = (axis + 1) % 3;
            const std::size_t z = (axis + 2) % 3;
            const Whole difference = (*from)[y] - to[y];
            const Whole sum = (*from)[z] + to[z];
            normal[axis] += ProductOf<Whole>(difference) * sum;
        }
        from = &to;
    }
    return normal;
}

/// The axis of the normal's largest component; of equal ones z, then y.
template <typename Product> std::size_t largest_axis(const std::array<Product, 3>& normal) {
    const auto size = [&normal](std::size_t axis) -> Product {
        return normal[axis] < 0 ? Product(-normal[axis]) : normal[axis];
    };
    std::size_t largest = 2;
    for (const std::size_t axis : {1U, 0U})
        if (size(axis) > size(largest))
            largest = axis;
    return largest;
}

/// normal . (to - from), exactly.
mpz_class height_of(const std::array<mpz_class, 3>& to, const std::array<mpz_class, 3>& from,
                    const std::array<mpz_class, 3>& normal) {
    mpz_class height = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        height += normal[axis] * (to[axis] - from[axis]);
    return height;
}

/// The same of up to 192 bits, as a double that is 0 only if the product is.
double height_of(const std::array<std::int64_t, 3>& to, const std::array<std::int64_t, 3>& from,
                 const std::array<Int128, 3>& normal) {
    // The upper half of the normal is multiplied by itself.
    Int128 upper = 0;
    Int128 lower = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Int128 way = to[axis] - from[axis];
        upper += static_cast<std::int64_t>(normal[axis] >> 64) * way;
        lower += static_cast<Int128>(static_cast<std::uint64_t>(normal[axis])) * way;
    }
    // What then remains of the lower half is at most half a unit of the upper one: they cannot
    // cancel.
    const auto rest = static_cast<std::int64_t>(lower);
    upper += (lower - rest) >> 64;
    return static_cast<double>(upper) * 0x1p64 + static_cast<double>(rest);
}

/// span / (|normal| denominator).
double length_along(const std::array<Int128, 3>& normal, double span, std::int64_t denominator) {
    const Vec<double, 3> n{static_cast<double>(normal[0]), static_cast<double>(normal[1]),
                           static_cast<double>(normal[2])};
    return span / (std::sqrt(dot(n, n)) * static_cast<double>(denominator));
}

/// The same of numbers beyond the doubles: each is a number below 1 times a power of two.
double length_along(const std::array<mpz_class, 3>& normal, const mpz_class& span,
                    const mpz_class& denominator) {
    std::array<double, 3> components{};
    std::array<long, 3> powers{};
    for (std::size_t i = 0; i < 3; ++i)
        components[i] = mpz_get_d_2exp(&powers[i], normal[i].get_mpz_t());
    const long power = *std::max_element(powers.begin(), powers.end());
    double square = 0;
    for (std::size_t i = 0; i < 3; ++i)
        square += std::pow(std::scalbln(components[i], powers[i] - power), 2);
    long of_span = 0;
    long of_denominator = 0;
    const double quotient = mpz_get_d_2exp(&of_span, span.get_mpz_t()) /
                            mpz_get_d_2exp(&of_denominator, denominator.get_mpz_t());
    return std::scalbln(quotient / std::sqrt(square), of_span - of_denominator - power);
}

/// How far the corners lie apart along the normal.
template <typename Whole>
void measure_plane(std::span<const std::array<Whole, 3>> corners,
                   const std::array<ProductOf<Whole>, 3>& normal, const Whole& denominator,
                   Triangulation& result) {
    using Height = decltype(height_of(corners[0], corners[0], normal));
    Height lowest = 0;
    Height highest = 0;
    for (const auto& corner : corners.subspan(1)) {
        const Height height = height_of(corner, corners[0], normal);
        if (height < lowest)
            lowest = height;
        if (height > highest)
            highest = height;
    }
    result.is_planar = lowest == highest;
    if (!result.is_planar)
        result.off_plane = length_along(normal, Height(highest - lowest), denominator) / 2;
}

Rational fraction(Int128 number) {
    return exact(Fraction<Int128>(number));
}
Rational fraction(const mpz_class& number) {
    return number;
}

/// Newell's normal; its largest component is dropped; convex? then the fan; simple? then ears.
template <typename Whole>
Triangulation cut_face(std::span<const std::array<Whole, 3>> corners, const Whole& denominator) {
    Triangulation result;
    const auto normal = newells_normal(corners);
    const std::size_t axis = largest_axis(normal);
    if (normal[axis] == 0) {
        result.form = FaceForm::no_area;
        return result;
    }
    measure_plane<Whole>(corners, normal, denominator, result);

    Polygon<Whole> polygon(corners, axis, normal[axis] < 0);
    if (is_convex(polygon))
        return result;
    polygon.rank_corners();
    if (const auto meeting = first_meeting(polygon)) {
        result.form = FaceForm::crossed;
        result.meeting = {polygon.corners[meeting->front()].index_in_face,
                          polygon.corners[meeting->back()].index_in_face};
        return result;
    }
    result.form = FaceForm::concave;
    const Rational square = fraction(denominator) * fraction(denominator);
    result.ears = {.normal = {fraction(normal[0]) / square, fraction(normal[1]) / square,
                              fraction(normal[2]) / square},
                   .dropped = axis,
                   .triangles = cut_ears(polygon)};
    for (auto& triangle : result.ears->triangles)
        for (std::size_t& corner : triangle)
            corner = polygon.corners[corner].index_in_face;
    return result;
}

std::array<const Number*, 3> coordinates_of(const SceneVertex& vertex) {
    return {&vertex.x, &vertex.y, &vertex.z};
}

mpz_class power_of_ten_of_any_size(int exponent) {
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(exponent));
    return power;
}

/// The denominator of numbers of any size: the least common one of their fractions, times a power
/// of ten for their decimals. `nullopt` if the first has too many bits.
std::optional<mpz_class> common_denominator(std::span<const SceneVertex> vertices,
                                            std::span<const std::size_t> face) {
    int places = 0; // behind the point
    mpz_class of_fractions = 1;
    for (const std::size_t vertex : face)
        for (const Number* const number : coordinates_of(vertices[vertex]))
            if (const auto decimal = number->as_decimal())
                places = std::max(places, -decimal->exponent);
            else if (of_fractions = lcm(of_fractions, number->exact().get_den());
                     mpz_sizeinbase(of_fractions.get_mpz_t(), 2) > most_bits_of_face)
                return std::nullopt;
    return of_fractions * power_of_ten_of_any_size(places);
}

/// A face whose numbers need not fit on the grid of its mesh.
Triangulation cut_face_of_any_size(std::span<const SceneVertex> vertices,
                                   std::span<const std::size_t> face) {
    const auto denominator = common_denominator(vertices, face);
    if (!denominator)
        return {.form = FaceForm::too_fine};
    std::vector<std::array<mpz_class, 3>> corners(face.size());
    for (std::size_t k = 0; k < face.size(); ++k)
        for (std::size_t i = 0; i < 3; ++i)
            corners[k][i] =
                Rational(coordinates_of(vertices[face[k]])[i]->exact() * *denominator).get_num();
    return cut_face<mpz_class>(corners, *denominator);
}

} // namespace

Triangulation FaceCutter::cut(std::span<const std::size_t> face) {
    if (!std::exchange(has_begun_, true))
        put_on_grid();

    corners_.clear();
    for (const std::size_t vertex : face) {
        const std::size_t index = vertex - first_; // beyond the end for what lies before `first_`
        if (index >= grid_.size())
            return cut_face_of_any_size(vertices_, face);
        corners_.push_back(grid_[index]);
    }
    const int bits_of_sums = 2 * (bits_ + 1) + static_cast<int>(std::bit_width(face.size()));
    if (bits_of_sums > 126)
        return cut_face_of_any_size(vertices_, face);
    return cut_face<std::int64_t>(corners_, denominator_);
}

void FaceCutter::put_on_grid() {
    const auto vertices = vertices_.subspan(first_);
    for (const SceneVertex& vertex : vertices)
        for (const Number* const number : coordinates_of(vertex)) {
            const auto denominator = number->denominator();
            if (!number->as_decimal() || !denominator)
                return;
            denominator_ = std::max(denominator_, *denominator);
        }

    grid_.reserve(vertices.size());
    std::uint64_t all_bits = 0;
    for (const SceneVertex& vertex : vertices) {
        GridPoint3& point = grid_.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            const auto whole = coordinates_of(vertex)[i]->numerator_over(denominator_);
            if (!whole)
                return grid_.clear();
            point[i] = *whole;
            all_bits |= static_cast<std::uint64_t>(*whole < 0 ? ~*whole : *whole);
        }
    }
    bits_ = static_cast<int>(std::bit_width(all_bits));
    if (bits_ > most_bits_of_grid)
        grid_.clear();
}

} // namespace rastertrace
