// SPDX-License-Identifier: MIT
// The second job of the report: which pixels the triangles of the scene have.

#include "job_builder.h"
#include "placed_triangles.h"
#include "report_adaptive.h"

#include <rastertrace/core/draw/filtered/filtered.h>
#include <rastertrace/core/draw/paint/fill.h>
#include <rastertrace/core/raster/flat_painter.h>
#include <rastertrace/trace/text/method_names.h>

#include <fmt/core.h>

#include <algorithm>
#include <memory>

namespace rastertrace {

namespace {

/// Keeps the pixels that are drawn, and counts those that are asked for.
struct PixelSink {
    const Canvas& canvas;
    std::vector<std::size_t>& pixels;
    std::uint64_t tested = 0;

    template <typename Step> void operator()(const Step&) {}
    void operator()(const PixelPlotted& step) { pixels.push_back(canvas.offset_of(step.pixel)); }
    template <typename Scalar> void operator()(const SampleTested<Scalar>& sample) {
        ++tested;
        if (sample.is_inside)
            pixels.push_back(canvas.offset_of(sample.pixel));
    }
    template <typename Scalar> void operator()(const ScanlineSpanned<Scalar>& span) {
        const Index last = std::min<Index>(span.to, canvas.right());
        for (Index x = std::max<Index>(span.from, canvas.left()); x <= last; ++x)
            pixels.push_back(canvas.offset_of({static_cast<int>(x), span.y}));
    }

    /// What is worked out only to be told would be counted as work.
    template <typename Step> bool takes() const { return false; }
};

/// The pixels of each primitive, in order, each once.
using PixelSets = std::vector<std::vector<std::size_t>>;

void sort_sets(PixelSets& sets) {
    for (auto& pixels : sets) {
        std::sort(pixels.begin(), pixels.end());
        pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
    }
}

/// The triangles of a scene in the numbers of its plan, ready to be filled again and again.
template <typename Scalar> struct PlacedTriangles {
    std::vector<Piece<Scalar>> triangles;
    Image image;
    SampleGrid<Scalar> grid;

    PlacedTriangles(const Scene& scene, const Plan& plan)
        : image(scene.canvas), grid(sample_grid<Scalar>(scene, plan)) {
        for_each_placed_triangle<Scalar>(scene, plan, [this](const Piece<Scalar>& triangle) {
            if (!triangle.is_skipped)
                triangles.push_back(triangle);
        });
    }
};

/// A triangle in numbers that count.
template <typename Number, typename Scalar>
Triangle<Number> counting_copy_of(const Piece<Scalar>& triangle) {
    Triangle<Number> result;
    for (std::size_t i = 0; i < 3; ++i)
        result.vertices[i] = {as_counted(triangle.positions[i].x),
                              as_counted(triangle.positions[i].y)};
    return result;
}

class CoverageJob {
public:
    CoverageJob(const Scene& scene, const ReportOptions& options)
        : scene_(scene), options_(options) {}

    JobReport measured() {
        if (!scene_.has(PrimitiveKind::triangle))
            return nothing_of(ReportJob::coverage, "the scene has no triangle to fill");
        std::vector<Fill> fills{scene_.method.fill};
        if (fills.front() != Fill::top_left)
            fills.push_back(Fill::top_left);

        // Each fill is right or wrong by its own rule: what it draws in exact arithmetic.
        for (const Fill fill : fills) {
            const Scene exact = scene_with(fill, ScalarKind::exact);
            const std::string refusal = refusal_in_words(exact);
            if (!refusal.empty())
                return nothing_of(ReportJob::coverage, refusal);
            exact_.push_back(pixels_of(exact, plan_for(exact)));
            if (size_of(exact_.back()) == 0)
                return nothing_of(ReportJob::coverage, "no pixel of the canvas is covered");
        }

        JobReport& report = builder_.report();
        report.unit = "covered pixel";
        report.units = size_of(exact_.front());
        report.reference = "the same fill in rationals, on the scene as typed";
        report.measures = {
            {"wrong_pixels", "wrong pixels / perimeter pixels", "", "perimeter pixels"}};
        for (std::size_t i = 0; i < fills.size(); ++i)
            add_fill(fills[i], exact_[i]);
        return builder_.finish(options_);
    }

private:
    Scene scene_with(Fill fill, ScalarKind scalar) const {
        Scene scene = plain_scene(scene_, scalar);
        if (fill != scene.method.fill)
            scene.method.sample.reset();
        scene.method.fill = fill;
        return scene;
    }

    void add_fill(Fill fill, const PixelSets& exact) {
        Method named;
        named.fill = fill;
        const std::string fill_name(find_method_key("fill")->get(named));
        std::string curve;
        for (const ScalarSetting& scalar : scalar_settings()) {
            const Scene scene = scene_with(fill, scalar.kind);
            const std::string name =
                fmt::format("{}, {}", fill_name, scalar.bits ? "fixed point" : "scalars");
            if (name != curve)
                builder_.begin_curve(name, scalar.bits ? "bits behind the point" : "scalar");
            curve = name;
            Setting setting = scalar.bits ? bits_setting(*scalar.bits) : named_setting(scalar.name);
            setting.never_errs = scalar.never_errs();
            const std::string refusal = refusal_in_words(scene);
            if (!refusal.empty()) {
                builder_.add_failure(setting.name, setting.label, refusal);
                continue;
            }
            add(std::move(setting), scene, scalar, exact);
        }
    }

    /// Measures one scalar.
    void add(Setting setting, const Scene& scene, const ScalarSetting& scalar,
             const PixelSets& exact) {
        const Plan plan =
            scalar.bits ? plan_for(scene, std::int64_t{1} << *scalar.bits) : plan_for(scene);
        with_scalar(plan, [&]<typename Scalar>() {
            if constexpr (std::same_as<Scalar, Adaptive>) {
                add_adaptive(scene, plan, setting.never_errs, exact);
            } else {
                const auto placed = std::make_shared<PlacedTriangles<Scalar>>(scene, plan);
                PixelSets pixels = count(*placed, scene, setting.work.emplace());
                setting.errors = {ErrorValue::ratio(differing(pixels, exact), perimeter_of(exact))};
                if (scalar.bits)
                    setting.wrong_when_snapped =
                        differing(pixels, pixels_when_snapped(scene, *placed));
                builder_.add(
                    std::move(setting),
                    [placed, method = scene.method] {
                        const FlatPainter painter(placed->image, Color{}, NullSink{});
                        for (const auto& triangle : placed->triangles)
                            fill(Triangle<Scalar>{triangle.positions}, triangle.colors, method,
                                 placed->grid, placed->image.canvas(), painter);
                        keep(placed->image);
                    },
                    size_of(exact));
            }
        });
    }

    /// The triangles of `adaptive`, ready to be filled again and again.
    struct AdaptiveFill {
        AdaptiveTriangles triangles;
        Image image;
        SampleGrid<Adaptive> grid;
        SampleGrid<Rational> exact_grid;
        CertainRows rows = {};

        AdaptiveFill(const Scene& scene, const Plan& plan)
            : triangles(scene, plan), image(scene.canvas), grid(sample_grid<Adaptive>(scene, plan)),
              exact_grid(sample_grid<Rational>(scene, plan)) {}

        /// Fills a triangle once all about it is certain, and with rationals if doubles leave
        /// something open. True if it took these.
        template <typename Sink> bool fill_one(const AdaptiveTriangles::Placed& one, Sink& sink) {
            const Method& method = triangles.scene.method;
            const auto fill_filtered = [&](auto& into) {
                fill(Triangle<Adaptive>{one.filtered->positions}, one.filtered->colors, method,
                     grid, image.canvas(), into);
            };
            rows.clear();
            const bool is_certain = one.filtered && !left_open_by([&] { fill_filtered(rows); });
            if (is_certain)
                rows.paint_with(sink, fill_filtered);
            else
                fill(Triangle<Rational>{one.exact.positions}, one.exact.colors, method, exact_grid,
                     image.canvas(), sink);
            return !is_certain;
        }
    };

    void add_adaptive(const Scene& scene, const Plan& plan, bool never_errs,
                      const PixelSets& exact) {
        const auto filling = std::make_shared<AdaptiveFill>(scene, plan);
        PixelSets pixels(scene.primitives.size());
        std::uint64_t tested = 0;
        std::uint64_t fallbacks = 0;
        for (const auto& one : filling->triangles.placed) {
            if (one.exact.is_skipped)
                continue;
            auto& of_triangle = pixels[one.index.primitive];
            const std::size_t before = of_triangle.size();
            PixelSink sink{scene.canvas, of_triangle};
            fallbacks += filling->fill_one(one, sink) ? 1 : 0;
            tested += pixels_tested(scene, sink, of_triangle.size() - before);
        }
        sort_sets(pixels);
        Setting setting = adaptive_setting(
            tested, fallbacks,
            fmt::format(
                "certifies all rows of a triangle before it paints one; {} of {} left open, and "
                "filled in rationals",
                fallbacks, filling->triangles.placed.size()));
        setting.never_errs = never_errs;
        setting.errors = {ErrorValue::ratio(differing(pixels, exact), perimeter_of(exact))};
        builder_.add(
            std::move(setting),
            [filling] {
                const FlatPainter painter(filling->image, Color{}, NullSink{});
                for (const auto& one : filling->triangles.placed)
                    if (!one.exact.is_skipped)
                        filling->fill_one(one, painter);
                keep(filling->image);
            },
            size_of(exact));
    }

    /// The fills that go by rows ask only for the pixels that they draw.
    static std::uint64_t pixels_tested(const Scene& scene, const PixelSink& sink,
                                       std::uint64_t drawn) {
        return traits_of(scene.method.fill).tests_box ? sink.tested : drawn;
    }

    /// Fills everything in numbers that count; returns the pixels.
    template <typename Scalar>
    static PixelSets count(const PlacedTriangles<Scalar>& placed, const Scene& scene, Work& work) {
        using Number = CountedOf<Scalar>;
        const SampleOffset<Scalar>& offset = placed.grid.offset();
        const SampleGrid<Number> grid({as_counted(offset.x()), as_counted(offset.y())},
                                      scene.canvas);
        PixelSets sets(scene.primitives.size());
        for (const auto& triangle : placed.triangles) {
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

    static PixelSets pixels_of(const Scene& scene, const Plan& plan) {
        return with_scalar(plan, [&]<typename Scalar>() {
            Work work;
            if constexpr (std::same_as<Scalar, Adaptive>)
                return PixelSets();
            else
                return count(PlacedTriangles<Scalar>(scene, plan), scene, work);
        });
    }

    /// What exact arithmetic makes of triangles that have been snapped: a scene of just these.
    template <typename Scalar>
    static PixelSets pixels_when_snapped(const Scene& scene,
                                         const PlacedTriangles<Scalar>& placed) {
        Scene snapped;
        snapped.canvas = scene.canvas;
        snapped.method = scene.method;
        snapped.method.scalar = ScalarKind::exact;
        snapped.method.cull = Cull::none;
        snapped.method.snap = Snap::none;
        std::vector<std::size_t> numbers;
        for (const auto& triangle : placed.triangles) {
            const std::size_t first = snapped.vertices.size();
            for (const auto& position : triangle.positions)
                snapped.vertices.push_back(
                    {.name = {}, .x = number_of(position.x), .y = number_of(position.y)});
            snapped.primitives.push_back(
                {.name = {}, .vertices = {first, first + 1, first + 2}, .color = {}});
            numbers.push_back(triangle.primitive);
        }
        const PixelSets pieces = pixels_of(snapped, plan_for(snapped));
        PixelSets sets(scene.primitives.size());
        for (std::size_t i = 0; i < pieces.size(); ++i)
            sets[numbers[i]].insert(sets[numbers[i]].end(), pieces[i].begin(), pieces[i].end());
        sort_sets(sets);
        return sets;
    }
    static Number number_of(const Rational& x) { return Number::fraction(x); }
    template <typename Integer> static Number number_of(const Fraction<Integer>& x) {
        return Number::fraction(exact(x));
    }
    static Number number_of(double x) { return Number::fraction(Rational(x)); }

    static std::uint64_t size_of(const PixelSets& sets) {
        std::uint64_t size = 0;
        for (const auto& pixels : sets)
            size += pixels.size();
        return size;
    }

    /// How many pixels one has and the other has not, primitive by primitive.
    static std::uint64_t differing(const PixelSets& a, const PixelSets& b) {
        std::uint64_t count = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            std::vector<std::size_t> difference;
            std::set_symmetric_difference(a[i].begin(), a[i].end(), b[i].begin(), b[i].end(),
                                          std::back_inserter(difference));
            count += difference.size();
        }
        return count;
    }

    /// How many pixels of primitives have a neighbor, beside, above or below, that is not theirs.
    std::uint64_t perimeter_of(const PixelSets& sets) const {
        const auto width = static_cast<std::size_t>(scene_.canvas.width);
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

    const Scene& scene_;
    const ReportOptions& options_;
    std::vector<PixelSets> exact_; ///< of each fill
    JobBuilder builder_{ReportJob::coverage};
};

} // namespace

JobReport measure_coverage(const Scene& scene, const ReportOptions& options) {
    return CoverageJob(scene, options).measured();
}

} // namespace rastertrace
