// SPDX-License-Identifier: MIT
// The second job of the report: which pixels the triangles of the scene have.

#include "covered_pixels.h"
#include "job_builder.h"
#include "placed_triangles.h"
#include "report_adaptive.h"

#include <rastertrace/core/draw/paint/fill.h>
#include <rastertrace/core/raster/flat_painter.h>
#include <rastertrace/trace/text/method_names.h>

#include <fmt/core.h>

#include <algorithm>
#include <memory>

namespace rastertrace {

namespace {

/// The triangles of a scene in the numbers of its plan, ready to be filled again and again.
template <typename Scalar> struct PlacedTriangles {
    std::vector<Piece<Scalar>> triangles;
    Image image;
    SampleGrid<Scalar> grid;

    PlacedTriangles(const Scene& scene, const Plan& plan)
        : triangles(triangles_to_fill<Scalar>(scene, plan)), image(scene.canvas),
          grid(sample_grid<Scalar>(scene, plan)) {}
};

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
            exact_.push_back(counted_pixels(exact, plan_for(exact)).pixels);
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
                builder_.add_failure(std::move(setting), refusal);
                continue;
            }
            add(std::move(setting), scene, scalar, exact);
        }
    }

    ErrorValue wrong_pixels(const PixelSets& pixels, const PixelSets& exact) const {
        return ErrorValue::ratio(differing(pixels, exact), perimeter_of(exact, scene_.canvas));
    }

    /// Measures one scalar.
    void add(Setting setting, const Scene& scene, const ScalarSetting& scalar,
             const PixelSets& exact) {
        const Plan plan =
            scalar.bits ? plan_for(scene, std::int64_t{1} << *scalar.bits) : plan_for(scene);
        with_scalar(plan, [&]<typename Scalar>() {
            if constexpr (std::same_as<Scalar, Interval>) {
                add_adaptive(scene, plan, setting.never_errs, exact);
            } else {
                const auto placed = std::make_shared<PlacedTriangles<Scalar>>(scene, plan);
                const CountedPixels counted = counted_pixels(scene, plan);
                setting.work = counted.work;
                setting.errors = {wrong_pixels(counted.pixels, exact)};
                if (scalar.bits)
                    setting.wrong_when_snapped =
                        differing(counted.pixels, pixels_when_snapped(scene, plan));
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
        SampleGrid<Interval> trial_grid;
        SampleGrid<double> grid;
        SampleGrid<Rational> exact_grid;

        AdaptiveFill(const Scene& scene, const Plan& plan)
            : triangles(scene, plan), image(scene.canvas),
              trial_grid(sample_grid<Interval>(scene, plan)),
              grid(sample_grid<double>(scene, plan)),
              exact_grid(sample_grid<Rational>(scene, plan)) {}

        /// Fills a triangle once intervals decide all about it, or with rationals. True if it took
        /// these.
        template <typename Sink> bool fill_one(const AdaptiveTriangles::Placed& one, Sink& sink) {
            const auto fill_in = [&]<typename Scalar>(const Piece<Scalar>& piece,
                                                      const SampleGrid<Scalar>& on, auto& into) {
                fill(Triangle<Scalar>{piece.positions}, piece.colors, triangles.scene.method, on,
                     image.canvas(), into);
            };
            const NullSink none;
            const bool is_decided = one.is_decided(
                [&](const Piece<Interval>& piece) { fill_in(piece, trial_grid, none); });
            if (is_decided)
                fill_in(one.doubles, grid, sink);
            else
                fill_in(one.exact, exact_grid, sink);
            return !is_decided;
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
            auto& of_triangle = pixels[one.exact.primitive];
            const std::size_t before = of_triangle.size();
            PixelSink sink{scene.canvas, of_triangle};
            fallbacks += filling->fill_one(one, sink) ? 1 : 0;
            tested += pixels_tested(scene, sink, of_triangle.size() - before);
        }
        sort_sets(pixels);
        Setting setting =
            adaptive_setting(tested, fallbacks,
                             fmt::format("tries each triangle in intervals, then fills it in "
                                         "doubles; {} of {} left open, and "
                                         "filled in rationals",
                                         fallbacks, filling->triangles.placed.size()));
        setting.never_errs = never_errs;
        setting.errors = {wrong_pixels(pixels, exact)};
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
