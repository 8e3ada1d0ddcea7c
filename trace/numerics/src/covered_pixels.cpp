// SPDX-License-Identifier: MIT

#include "covered_pixels.h"
#include "placed_triangles.h"

#include <rastertrace/core/draw/paint/fill.h>

#include <concepts>
#include <iterator>

namespace rastertrace {

std::uint64_t pixels_tested(const Scene& scene, const PixelSink& sink, std::uint64_t drawn) {
    return traits_of(scene.method.fill).tests_box ? sink.tested : drawn;
}

void sort_sets(PixelSets& sets) {
    for (auto& pixels : sets) {
        std::sort(pixels.begin(), pixels.end());
        pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
    }
}

namespace {

/// A triangle in numbers that count.
template <typename Number, typename Scalar>
Triangle<Number> counting_copy_of(const Piece<Scalar>& triangle) {
    Triangle<Number> result;
    for (std::size_t i = 0; i < 3; ++i)
        result.vertices[i] = {as_counted(triangle.positions[i].x),
                              as_counted(triangle.positions[i].y)};
    return result;
}

/// Fills everything in numbers that count; returns the pixels.
template <typename Scalar> PixelSets count(const Scene& scene, const Plan& plan, Work& work) {
    using Number = CountedOf<Scalar>;
    const SampleOffset<Scalar> offset = sample_grid<Scalar>(scene, plan).offset();
    const SampleGrid<Number> grid({as_counted(offset.x()), as_counted(offset.y())}, scene.canvas);
    PixelSets sets(scene.primitives.size());
    for (const auto& triangle : triangles_to_fill<Scalar>(scene, plan)) {
        auto& pixels = sets[triangle.primitive];
        const std::size_t before = pixels.size();
        PixelSink sink{scene.canvas, pixels};
        const auto counting_triangle = counting_copy_of<Number>(triangle);
        {
            const Counting counting(work);
            fill(counting_triangle, triangle.colors, scene.method, grid, scene.canvas, sink);
        }
        work.pixels_tested += pixels_tested(scene, sink, pixels.size() - before);
    }
    sort_sets(sets);
    return sets;
}

Number number_of(const Rational& x) {
    return Number::fraction(x);
}
template <typename Integer> Number number_of(const Fraction<Integer>& x) {
    return Number::fraction(exact(x));
}
Number number_of(double x) {
    return Number::fraction(Rational(x));
}

} // namespace

CountedPixels counted_pixels(const Scene& scene, const Plan& plan) {
    CountedPixels counted;
    with_scalar(plan, [&]<typename Scalar>() {
        if constexpr (!std::same_as<Scalar, Interval>)
            counted.pixels = count<Scalar>(scene, plan, counted.work);
    });
    return counted;
}

PixelSets pixels_when_snapped(const Scene& scene, const Plan& plan) {
    // A scene of just these triangles, and which of the scene's they are.
    Scene snapped;
    snapped.canvas = scene.canvas;
    snapped.method = scene.method;
    snapped.method.scalar = ScalarKind::exact;
    snapped.method.cull = Cull::none;
    snapped.method.snap = Snap::none;
    std::vector<std::size_t> numbers;
    with_scalar(plan, [&]<typename Scalar>() {
        if constexpr (!std::same_as<Scalar, Interval>)
            for (const auto& triangle : triangles_to_fill<Scalar>(scene, plan)) {
                const std::size_t first = snapped.vertices.size();
                for (const auto& position : triangle.positions)
                    snapped.vertices.push_back(
                        {.name = {}, .x = number_of(position.x), .y = number_of(position.y)});
                snapped.primitives.push_back(
                    {.name = {}, .vertices = {first, first + 1, first + 2}, .color = {}});
                numbers.push_back(triangle.primitive);
            }
    });
    const PixelSets pieces = counted_pixels(snapped, plan_for(snapped)).pixels;
    PixelSets sets(scene.primitives.size());
    for (std::size_t i = 0; i < pieces.size(); ++i)
        sets[numbers[i]].insert(sets[numbers[i]].end(), pieces[i].begin(), pieces[i].end());
    sort_sets(sets);
    return sets;
}

std::uint64_t size_of(const PixelSets& sets) {
    std::uint64_t size = 0;
    for (const auto& pixels : sets)
        size += pixels.size();
    return size;
}

std::uint64_t differing(const PixelSets& a, const PixelSets& b) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::vector<std::size_t> difference;
        std::set_symmetric_difference(a[i].begin(), a[i].end(), b[i].begin(), b[i].end(),
                                      std::back_inserter(difference));
        count += difference.size();
    }
    return count;
}

std::uint64_t perimeter_of(const PixelSets& sets, const Canvas& canvas) {
    const auto width = static_cast<std::size_t>(canvas.width);
    std::uint64_t count = 0;
    for (const auto& pixels : sets)
        for (const std::size_t pixel : pixels) {
            const auto has = [&pixels](std::size_t other) {
                return std::binary_search(pixels.begin(), pixels.end(), other);
            };
            const std::size_t column = pixel % width;
            const bool is_inner = column > 0 && column + 1 < width && pixel >= width &&
                                  has(pixel - 1) && has(pixel + 1) && has(pixel - width) &&
                                  has(pixel + width);
            count += is_inner ? 0 : 1;
        }
    return count;
}

} // namespace rastertrace
