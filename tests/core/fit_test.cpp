// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/scene/fit.h>

#include "random_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <variant>

namespace rastertrace {
namespace {

/// The decimal digits of a number from the first to the last that is not 0.
std::size_t digits_of(const Number& number) {
    Rational value = abs(number.exact());
    while (value.get_den() != 1)
        value *= 10;
    std::string digits = value.get_str();
    digits.erase(digits.find_last_not_of('0') + 1);
    return digits.size();
}

/// Where a place lies for a camera, of which z is the distance.
Vec<Rational, 3> seen_by(const Camera& camera, ViewAxis axis, const Vec<Rational, 3>& place) {
    const Vec<Rational, 4> at =
        view_matrix(camera, axis) * Vec<Rational, 4>{place.x, place.y, place.z, Rational(1)};
    return {at.x, at.y, axis == ViewAxis::minus_z ? Rational(-at.z) : at.z};
}

TEST(Fit, TheCubeIsSeenFromInFrontOfIt) {
    // A cube of side 2 around the origin: the sphere has a radius of sqrt(3), 1.74 + 0.01 with room.
    const ViewVolume volume =
        view_volume({.type = ProjectionType::frustum, .fov_y = 90, .near = Number::decimal(1, -1)},
                    {.type = ViewportType::pixels}, {20, 10});
    EXPECT_EQ(volume.y, (Extent{-1, 1}));
    EXPECT_EQ(volume.x, (Extent{-2, 2}));
    const auto fitted =
        std::get<FittedCamera>(fitted_camera({0, 0, 0}, 3, volume, ViewAxis::minus_z));
    // 1.75 sqrt(2) = 2.4748...
    EXPECT_EQ(fitted.camera.position[2].exact(), Number::decimal(248, -2).exact());
    EXPECT_EQ(fitted.camera.position[0].exact(), 0);
    EXPECT_EQ(fitted.near.exact(), Number::decimal(73, -2).exact());
    EXPECT_EQ(fitted.far.exact(), Number::decimal(423, -2).exact());

    const auto from_behind =
        std::get<FittedCamera>(fitted_camera({0, 0, 0}, 3, volume, ViewAxis::plus_z));
    EXPECT_EQ(from_behind.camera.position[2].exact(), Number::decimal(-248, -2).exact());
}

// Of any projection, as far as the sides go: whole, and no farther away than by the roundings.
TEST(Fit, TheSphereTouchesASideAndNoneCutsIt) {
    Random random(7);
    const auto number = [&random](int low, int high) {
        return Number::decimal(random.whole(low, high), random.pick({-2, -1, 0, 1}));
    };
    for (int i = 0; i < 2000; ++i) {
        Projection projection{
            .type = random.pick({ProjectionType::pinhole, ProjectionType::view_plane,
                                 ProjectionType::frustum, ProjectionType::orthographic}),
            .distance = number(1, 50)};
        projection.left = random.whole(-9, 4);
        projection.right = random.whole(5, 12);
        projection.bottom = random.whole(-9, -1);
        projection.top = random.whole(0, 9);
        if (projection.type == ProjectionType::frustum) {
            projection.near = number(1, 9);
            if (random.chance(2))
                projection.fov_y = random.whole(1, 179);
        }
        const Canvas canvas{random.whole(3, 99), random.whole(3, 99)};
        const Viewport viewport{.type = random.chance(2) ? ViewportType::pixels
                                                         : ViewportType::pixels_per_unit,
                                .pixels_per_unit = number(1, 99)};
        const ViewVolume volume = view_volume(projection, viewport, canvas);
        const ViewAxis axis = view_axis_of(projection.type);
        const Vec<Rational, 3> center{random.whole(-99, 99), random.whole(-9, 9),
                                      random.whole(-99, 99)};
        const Rational radius = number(1, 999).exact();

        const auto result = fitted_camera(center, radius * radius, volume, axis);
        ASSERT_TRUE(std::holds_alternative<FittedCamera>(result)) << i;
        const Camera& camera = std::get<FittedCamera>(result).camera;
        ASSERT_EQ(fault_of(camera), CameraFault::none) << i;
        const Vec<Rational, 3> seen = seen_by(camera, axis, center);

        // How far inside of each of the four sides the center lies, in squares of the radius.
        Rational nearest_side = 1000;
        const auto check = [&](const Extent& side, const Rational& at) {
            const Rational from_low = at - side.low * seen.z;
            const Rational from_high = side.high * seen.z - at;
            ASSERT_TRUE(from_low > 0 && from_high > 0) << i;
            for (const Rational& square :
                 {Rational(from_low * from_low / (1 + side.low * side.low)),
                  Rational(from_high * from_high / (1 + side.high * side.high))}) {
                ASSERT_GE(square, radius * radius) << i;
                nearest_side = std::min<Rational>(nearest_side, square / (radius * radius));
            }
        };
        if (!volume.is_perspective) {
            // Nothing moves the sides: the center is in their middle, but for the rounding.
            EXPECT_LE(abs(2 * seen.x - volume.x.low - volume.x.high), radius / 50) << i;
            EXPECT_LE(abs(2 * seen.y - volume.y.low - volume.y.high), radius / 50) << i;
            continue;
        }
        check(volume.x, seen.x);
        check(volume.y, seen.y);
        const bool is_kept_away = seen.z - radius < volume.near * 103 / 100 + radius / 20;
        EXPECT_TRUE(is_kept_away || nearest_side <= Rational(28, 25))
            << i << ": farther away than it has to be";
    }
}

TEST(Fit, NumbersHaveThreeDigits) {
    const ViewVolume volume{.x = {-1, 1}, .y = {-1, 1}};
    for (const Rational& square : {Rational(2), Rational(1, 3), Rational("98765432100000000000000"),
                                   Rational(1, mpz_class("70000000000000000000000"))}) {
        const auto fitted =
            std::get<FittedCamera>(fitted_camera({0, 0, 0}, square, volume, ViewAxis::minus_z));
        for (const Number& number : {fitted.camera.position[2], fitted.near, fitted.far})
            EXPECT_LE(digits_of(number), 3u) << number.exact();
    }
    // The middle of 0 to 1/3 in x, and of 0 to 2 in y.
    const Vec<Rational, 3> center = center_of({{0, 0, 0}, {Rational(1, 3), 2, Rational(2, 7)}});
    EXPECT_EQ(center.x, Number::decimal(17, -2).exact());
    EXPECT_EQ(center.y, 1);
    EXPECT_EQ(center.z, Number::decimal(14, -2).exact());
}

TEST(Fit, WhatHasNoSizeOrNoViewHasNoCamera) {
    const ViewVolume volume{.x = {-1, 1}, .y = {-1, 1}};
    const auto fault = [](const Vec<Rational, 3>& center, const Rational& square,
                          const ViewVolume& seen) {
        return std::get<FitFault>(fitted_camera(center, square, seen, ViewAxis::minus_z));
    };
    EXPECT_EQ(fault({0, 0, 0}, 0, volume), FitFault::one_place);
    const Rational huge(mpz_class("1" + std::string(301, '0')));
    EXPECT_EQ(fault({0, 0, 0}, huge * huge, volume), FitFault::size);
    EXPECT_EQ(fault({huge, 0, 0}, 1, volume), FitFault::size);
    EXPECT_EQ(fault({0, 0, 0}, 1 / (huge * huge), volume), FitFault::size);
    EXPECT_EQ(fault({0, 0, 0}, 1, intersection(volume, {.x = {2, 3}, .y = {-1, 1}})),
              FitFault::no_view);
}

TEST(Fit, ABoxHoldsEveryPlace) {
    std::optional<Box> box;
    include(box, {1, 2, 3});
    EXPECT_EQ(center_of(*box).y, 2) << "one place is its own center, whatever its digits";
    include(box, {-1, 5, 3});
    include(box, {0, 3, -7});
    EXPECT_EQ(box->low.x, -1);
    EXPECT_EQ(box->high.y, 5);
    EXPECT_EQ(box->low.z, -7);
}

} // namespace
} // namespace rastertrace
