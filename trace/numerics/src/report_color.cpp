// SPDX-License-Identifier: MIT
// The fourth job of the report: what the colors of the vertices mix to in the pixels of a triangle.
// All methods are asked about the same pixels, those of the exact top-left fill.

#include "job_builder.h"
#include "placed_triangles.h"
#include "report_adaptive.h"

#include <rastertrace/core/draw/paint/fill.h>
#include <rastertrace/core/raster/mixed_colors.h>
#include <rastertrace/trace/text/method_names.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <optional>

namespace rastertrace {

namespace {

/// A triangle with colors, ready to be mixed. Without area it has no pixels.
template <typename Scalar> struct ColorPiece {
    std::array<Vec<Scalar, 2>, 3> positions;
    std::array<Color, 3> colors;
    std::array<DepthOf<Scalar>, 3> inverse_w;
};
template <typename Scalar> struct ColorInput {
    std::vector<ColorPiece<Scalar>> pieces;
    SampleOffset<Scalar> offset;
};

template <typename Scalar>
ColorInput<CountedOf<Scalar>> counting_copy_of(const ColorInput<Scalar>& input) {
    ColorInput<CountedOf<Scalar>> result;
    result.offset = {as_counted(input.offset.x()), as_counted(input.offset.y())};
    for (const ColorPiece<Scalar>& piece : input.pieces) {
        auto& copy = result.pieces.emplace_back();
        copy.colors = piece.colors;
        for (std::size_t i = 0; i < 3; ++i) {
            copy.positions[i] = {as_counted(piece.positions[i].x),
                                 as_counted(piece.positions[i].y)};
            copy.inverse_w[i] = piece.inverse_w[i];
        }
    }
    return result;
}

class ColorJob {
public:
    ColorJob(const Scene& scene, const ReportOptions& options) : scene_(scene), options_(options) {}

    JobReport measured() {
        const bool has_colors =
            std::any_of(scene_.vertices.begin(), scene_.vertices.end(),
                        [](const SceneVertex& vertex) { return vertex.color.has_value(); });
        if (!has_colors || !scene_.has(PrimitiveKind::triangle))
            return nothing_of(ReportJob::color, "the scene has no triangle with colored vertices");
        const bool in_perspective = is_perspective(scene_.projection.type);
        const Scene exact = scene_with(ScalarKind::exact);
        const std::string refusal = refusal_in_words(exact);
        if (!refusal.empty())
            return nothing_of(ReportJob::color, refusal);
        *pieces_ = exact_spans(scene_);
        fragments_ = pixels_in(*pieces_);
        if (fragments_ == 0)
            return nothing_of(ReportJob::color, "no pixel of the canvas is covered");
        for (const ColorRounding rounding : {ColorRounding::nearest, ColorRounding::truncate})
            find_exact(exact, rounding, in_perspective);

        JobReport& report = builder_.report();
        report.unit = "fragment";
        report.units = fragments_;
        report.reference = in_perspective
                               ? "colors mixed as in space, in rationals, rounded to 8 bits"
                               : "colors mixed as on the screen, in rationals, rounded to 8 bits";
        report.measures = {
            {"levels",
             "largest error of a channel",
             "of 255",
             {},
             unseen_level,
             "one level, which an eye can hardly tell from the next"},
            {"wrong_pixels", "pixels off by a level or more / fragments", "", "fragments"}};
        add_scalars<false>("on the screen (affine)", ColorRounding::nearest);
        if (in_perspective) {
            add_scalars<true>("in space, divided in each pixel", ColorRounding::nearest);
            add_scalars<true>("in space, cut off, against what is cut off exactly",
                              ColorRounding::truncate);
            add_intervals(ScalarKind::single_precision, "float");
            add_intervals(ScalarKind::double_precision, "double");
        } else {
            add_scalars<false>("on the screen, cut off, against what is cut off exactly",
                               ColorRounding::truncate);
        }
        return builder_.finish(options_);
    }

private:
    /// What all are compared with. Clipping makes vertices whose colors are rounded alike.
    void find_exact(Scene exact, ColorRounding rounding, bool in_perspective) {
        exact.method.color_rounding = rounding;
        const Plan plan = plan_for(exact);
        with_scalar(plan, [&]<typename Scalar>() {
            if constexpr (!std::same_as<Scalar, Interval>) {
                const auto input = input_of<Scalar>(exact, plan);
                exact_[rounding] = in_perspective ? mixed<true>(*input, *pieces_, rounding)
                                                  : mixed<false>(*input, *pieces_, rounding);
            }
        });
    }

    Scene scene_with(ScalarKind scalar) const {
        Scene scene = plain_scene(scene_, scalar);
        scene.method.shade = Shade::interpolate;
        scene.method.fill = Fill::top_left;
        scene.method.sample.reset();
        return scene;
    }

    /// The pieces of a scene in one kind of scalar. Nothing, if clipping has left other pieces than
    /// in exact arithmetic.
    template <typename Scalar>
    std::shared_ptr<ColorInput<Scalar>> input_of(const Scene& scene, const Plan& plan) const {
        auto input = std::make_shared<ColorInput<Scalar>>();
        input->offset = sample_offset<Scalar>(sample_of(scene.method), plan.denominator);
        std::vector<std::size_t> primitives;
        for_each_placed_triangle<Scalar>(scene, plan, [&](const Piece<Scalar>& triangle) {
            input->pieces.push_back({triangle.positions, triangle.colors, triangle.inverse_w});
            primitives.push_back(triangle.primitive);
        });
        if (!are_those_of(*pieces_, primitives))
            return nullptr;
        return input;
    }

    /// The colors of all pixels of all triangles, mixed by core.
    template <bool in_perspective, typename Scalar>
    static std::vector<Color> mixed(const ColorInput<Scalar>& input,
                                    const std::vector<SpansOfPiece>& pieces,
                                    ColorRounding rounding) {
        std::vector<Color> colors;
        for (std::size_t i = 0; i < input.pieces.size(); ++i) {
            const ColorPiece<Scalar>& piece = input.pieces[i];
            const Barycentric<Scalar> barycentric(Triangle<Scalar>{piece.positions});
            const bool has_area = barycentric.area2() != scalar_from<Scalar>(0);
            const MixedColors<Scalar> paint{piece.colors, barycentric, input.offset,
                                            piece.inverse_w, rounding};
            for (const PieceSpan& span : pieces[i].spans)
                for (int x = span.from; x <= span.to; ++x)
                    colors.push_back(has_area ? paint.template at<in_perspective>({x, span.y})
                                              : piece.colors[0]);
        }
        return colors;
    }

    /// The same, divided only in every `interval`th pixel of a row.
    template <typename D>
    static std::vector<Color> divided(const ColorInput<D>& input,
                                      const std::vector<SpansOfPiece>& pieces, int interval) {
        std::vector<Color> colors;
        for (std::size_t i = 0; i < input.pieces.size(); ++i) {
            const ColorPiece<D>& piece = input.pieces[i];
            const D area2 = Barycentric<D>(Triangle<D>{piece.positions}).area2();
            if (area2 == scalar_from<D>(0)) {
                for (const PieceSpan& span : pieces[i].spans)
                    colors.insert(colors.end(), static_cast<std::size_t>(span.to - span.from + 1),
                                  piece.colors[0]);
                continue;
            }
            const auto over_w = [&](std::uint8_t (Color::*channel)() const) {
                std::array<D, 3> values;
                for (std::size_t k = 0; k < 3; ++k)
                    values[k] = scalar_from<D>((piece.colors[k].*channel)()) * piece.inverse_w[k];
                return ScreenPlane<D>(piece.positions, values, area2);
            };
            const std::array planes{over_w(&Color::red), over_w(&Color::green),
                                    over_w(&Color::blue)};
            const ScreenPlane<D> inverse_w(piece.positions, piece.inverse_w, area2);
            for (const PieceSpan& span : pieces[i].spans) {
                const PerspectiveRow<D, 3> row(planes, inverse_w,
                                               scalar_from<D>(span.y) + input.offset.y(),
                                               input.offset.x(), interval);
                row.walk(span.from, span.to, [&colors](int, const std::array<D, 3>& values) {
                    const auto level = [](const D& value) {
                        return level_of(value, ColorRounding::nearest);
                    };
                    colors.emplace_back(level(values[0]), level(values[1]), level(values[2]));
                });
            }
        }
        return colors;
    }

    /// How far off the colors are from exact ones that are rounded alike.
    std::vector<ErrorValue> errors_of(const std::vector<Color>& colors,
                                      ColorRounding rounding) const {
        const std::vector<Color>& exact = exact_.at(rounding);
        int largest = 0;
        std::uint64_t wrong = 0;
        for (std::size_t i = 0; i < colors.size(); ++i) {
            const auto off = [&](std::uint8_t (Color::*channel)() const) {
                return std::abs((colors[i].*channel)() - (exact[i].*channel)());
            };
            const int here = std::max({off(&Color::red), off(&Color::green), off(&Color::blue)});
            largest = std::max(largest, here);
            wrong += here > 0 ? 1 : 0;
        }
        return {{static_cast<double>(largest)}, ErrorValue::ratio(wrong, fragments_)};
    }

    /// Measures what `mix(input)` makes of a kind of scalar; `stage` says where it mixes.
    template <typename Mix>
    void add(ScalarKind scalar, Setting setting, ColorStage stage, ColorRounding rounding,
             const Mix& mix) {
        Scene scene = scene_with(scalar);
        scene.method.color_rounding = rounding;
        const std::string refusal = refusal_in_words(scene);
        if (!refusal.empty())
            return builder_.add_failure(std::move(setting), refusal);
        const Plan plan = plan_for(scene);
        with_scalar(plan, [&]<typename Scalar>() {
            if constexpr (std::same_as<Scalar, Interval>) {
                add_adaptive(scene, plan, std::move(setting), stage);
            } else {
                const auto input = input_of<Scalar>(scene, plan);
                if (!input)
                    return builder_.add_failure(std::move(setting), clipped_otherwise);
                setting.errors = errors_of(mix(*input, *pieces_), rounding);
                setting.work =
                    work_of([&] { keep(mix(counting_copy_of(*input), *pieces_)); }, fragments_);
                builder_.add(
                    std::move(setting),
                    [input, mix, pieces = pieces_] { keep(mix(*input, *pieces)); }, fragments_);
            }
        });
    }

    /// The colors of all pixels as `adaptive` mixes them. Adds the triangles that take rationals to
    /// `left_open`.
    static std::vector<Color> mixed_adaptively(const AdaptiveTriangles& input,
                                               const std::vector<SpansOfPiece>& pieces,
                                               ColorStage stage, ColorRounding rounding,
                                               std::uint64_t& left_open) {
        std::vector<Color> colors;
        for (std::size_t i = 0; i < input.placed.size(); ++i) {
            const AdaptiveTriangles::Placed& one = input.placed[i];
            const auto mix = [&]<typename Scalar>(const Piece<Scalar>& piece, auto&& take) {
                const Barycentric<Scalar> barycentric(Triangle<Scalar>{piece.positions});
                const bool has_area = barycentric.area2() != scalar_from<Scalar>(0);
                const MixedColors<Scalar> paint{
                    piece.colors, barycentric,
                    sample_offset<Scalar>(sample_of(input.scene.method), 1), piece.inverse_w,
                    rounding};
                for (const PieceSpan& span : pieces[i].spans)
                    for (int x = span.from; x <= span.to; ++x)
                        take(!has_area ? piece.colors[0]
                             : stage == ColorStage::perspective
                                 ? paint.template at<true>({x, span.y})
                                 : paint.template at<false>({x, span.y}));
            };
            const auto add = [&colors](Color color) { colors.push_back(color); };
            if (one.is_decided([&](const auto& piece) { mix(piece, [](Color) {}); })) {
                mix(one.doubles, add);
            } else {
                ++left_open;
                mix(one.exact, add);
            }
        }
        return colors;
    }

    void add_adaptive(const Scene& scene, const Plan& plan, Setting setting, ColorStage stage) {
        const auto input = std::make_shared<AdaptiveTriangles>(scene, plan);
        if (!are_those_of(*pieces_, input->primitives()))
            return builder_.add_failure(std::move(setting), clipped_otherwise);
        const ColorRounding rounding = scene.method.color_rounding;
        std::uint64_t left_open = 0;
        const auto colors = mixed_adaptively(*input, *pieces_, stage, rounding, left_open);
        Setting adaptive = adaptive_setting(fragments_, left_open,
                                            "tries each triangle in intervals, then mixes in "
                                            "doubles; one with a level left open in "
                                            "rationals");
        adaptive.never_errs = setting.never_errs;
        adaptive.errors = errors_of(colors, rounding);
        builder_.add(
            std::move(adaptive),
            [input, pieces = pieces_, stage, rounding] {
                std::uint64_t ignored = 0;
                keep(mixed_adaptively(*input, *pieces, stage, rounding, ignored));
            },
            fragments_);
    }

    template <bool in_perspective> void add_scalars(std::string_view name, ColorRounding rounding) {
        builder_.begin_curve(std::string(name), "scalar", rounding == ColorRounding::truncate);
        for (const ScalarSetting& scalar : scalar_settings()) {
            // Of the grids, the one that is drawn on.
            if (scalar.bits && std::int64_t{1} << *scalar.bits != fixed_grid)
                continue;
            Setting setting = named_setting(scalar.name);
            setting.never_errs =
                scalar.never_errs() && in_perspective == is_perspective(scene_.projection.type);
            add(scalar.kind, std::move(setting),
                in_perspective ? ColorStage::perspective : ColorStage::affine, rounding,
                [rounding](const auto& input, const auto& pieces) {
                    return mixed<in_perspective>(input, pieces, rounding);
                });
        }
    }

    void add_intervals(ScalarKind scalar, std::string_view name) {
        builder_.begin_curve(fmt::format("in space, {}", name), "divided every so many pixels");
        for (const int interval : divide_intervals)
            add(scalar, interval_setting(interval, "pixel"), ColorStage::perspective,
                ColorRounding::nearest,
                [interval]<typename Scalar>(const ColorInput<Scalar>& input, const auto& pieces) {
                    // Only floats and doubles are asked for.
                    if constexpr (std::same_as<DepthOf<Scalar>, Scalar>)
                        return divided(input, pieces, interval);
                    else
                        return std::vector<Color>();
                });
    }

    const Scene& scene_;
    const ReportOptions& options_;
    std::shared_ptr<std::vector<SpansOfPiece>> pieces_ =
        std::make_shared<std::vector<SpansOfPiece>>();
    std::uint64_t fragments_ = 0;
    std::map<ColorRounding, std::vector<Color>> exact_; ///< of each of them
    JobBuilder builder_{ReportJob::color};
};

} // namespace

JobReport measure_color(const Scene& scene, const ReportOptions& options) {
    return ColorJob(scene, options).measured();
}

} // namespace rastertrace
