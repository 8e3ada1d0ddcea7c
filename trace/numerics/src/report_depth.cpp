// SPDX-License-Identifier: MIT
// The third job of the report: which triangle is seen in a pixel, and how deep it lies there. All
// methods are asked about the same pixels, those of the exact top-left fill.

#include "job_builder.h"
#include "placed_triangles.h"
#include "report_adaptive.h"

#include <rastertrace/core/draw/list/drawing_order.h>
#include <rastertrace/core/draw/paint/fill.h>
#include <rastertrace/core/draw/paint/numbered_depths.h>
#include <rastertrace/core/transform/matrix.h>
#include <rastertrace/trace/text/method_names.h>

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <tuple>

namespace rastertrace {

namespace {

/// A triangle on the screen, in the numbers that depths are worked out in.
template <typename D> struct DepthPiece {
    Triangle<D> triangle;
    std::array<D, 3> depths;
};

/// What a method needs to find depths: the pieces, and how depths are compared.
template <typename D> struct DepthInput {
    std::vector<DepthPiece<D>> pieces;
    DepthRule<D> rule;
};

template <typename D> DepthInput<Counted<D>> counting_copy_of(const DepthInput<D>& input) {
    DepthInput<Counted<D>> result;
    for (const DepthPiece<D>& piece : input.pieces) {
        auto& copy = result.pieces.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            copy.triangle.vertices[i] = {piece.triangle.vertices[i].x,
                                         piece.triangle.vertices[i].y};
            copy.depths[i] = piece.depths[i];
        }
    }
    result.rule.larger_passes = input.rule.larger_passes;
    if (input.rule.cleared)
        result.rule.cleared = *input.rule.cleared;
    return result;
}

/// Which piece is seen in each pixel: its place in the list, plus 1.
using Winners = std::vector<std::uint32_t>;

/// Everything there is to know about the pixels of a scene.
struct DepthScene {
    Canvas canvas;
    std::vector<SpansOfPiece> pieces;
    std::uint64_t fragments = 0;
    Winners winners;

    /// The depths of the fragments, in the order of the spans: what each kind of buffer should hold.
    std::vector<ExactValue> distance;
    std::vector<ExactValue> inverse_distance;
    std::vector<ExactValue> ndc;
    /// Is 1/z (in a perspective) or z what is linear on the screen, and how much of it is one of ndc?
    bool is_inverse_linear = true;
    std::optional<double> per_ndc;
};

class DepthJob {
public:
    DepthJob(const Scene& scene, const ReportOptions& options) : scene_(scene), options_(options) {}

    JobReport measured() {
        if (scene_.depth() == Depth::none)
            return nothing_of(ReportJob::depth, "the scene has no depth");
        shared_ = std::make_shared<DepthScene>();
        shared_->canvas = scene_.canvas;
        shared_->is_inverse_linear =
            is_perspective(scene_.projection.type) || scene_.depth() == Depth::inverse_z;
        const Depth right = shared_->is_inverse_linear ? Depth::inverse_z : Depth::linear_z;
        const Scene exact = scene_with(right, ScalarKind::exact);
        const std::string refusal = refusal_in_words(exact);
        if (!refusal.empty())
            return nothing_of(ReportJob::depth, refusal);
        shared_->pieces = exact_spans(scene_);
        shared_->fragments = pixels_in(shared_->pieces);
        if (shared_->fragments == 0)
            return nothing_of(ReportJob::depth, "no pixel of the canvas is covered");
        find_exact(right);

        JobReport& report = builder_.report();
        report.unit = "fragment";
        report.units = shared_->fragments;
        report.reference = shared_->is_inverse_linear
                               ? "1/z in rationals, on the pixels of the exact top-left fill"
                               : "z in rationals, on the pixels of the exact top-left fill";
        report.measures = {{"wrong_winners", "pixels with the wrong winner / pixels covered", "",
                            "pixels covered"},
                           {"inverse_z_error",
                            "largest relative error of 1/z",
                            "",
                            {},
                            unseen_inverse_z,
                            "what rounding to a float may change"}};
        std::vector<Depth> kinds{Depth::inverse_z, Depth::linear_z};
        if (scene_.projection.type != ProjectionType::none)
            kinds.push_back(Depth::ndc_z);
        for (const Depth kind : kinds)
            add_scalars(kind);
        for (const Depth kind : kinds)
            add_buffers(kind);
        add_accumulated(right, ScalarKind::single_precision, "float");
        add_accumulated(right, ScalarKind::double_precision, "double");
        add_painter();
        return builder_.finish(options_);
    }

private:
    Scene scene_with(Depth depth, ScalarKind scalar) const {
        Scene scene = plain_scene(scene_, scalar);
        scene.method.depth = depth;
        scene.method.depth_compare = DepthCompare::automatic;
        scene.method.fill = Fill::top_left;
        scene.method.sample.reset();
        return scene;
    }

    static std::string name_of_depth(Depth depth) {
        Method method;
        method.depth = depth;
        return std::string(find_method_key("depth")->get(method));
    }

    /// The pieces of a scene, in the numbers that its scalar has for depths. Nothing, if clipping has
    /// left other pieces than in exact arithmetic.
    template <typename Scalar>
    std::shared_ptr<DepthInput<DepthOf<Scalar>>> input_of(const Scene& scene,
                                                          const Plan& plan) const {
        using D = DepthOf<Scalar>;
        auto input = std::make_shared<DepthInput<D>>();
        input->rule = depth_rule<D>(scene);
        std::vector<std::size_t> primitives;
        for_each_placed_triangle<Scalar>(scene, plan, [&](const Piece<Scalar>& triangle) {
            input->pieces.push_back(
                {{depth_positions(Triangle<Scalar>{triangle.positions})}, triangle.depths});
            primitives.push_back(triangle.primitive);
        });
        if (!are_those_of(shared_->pieces, primitives))
            return nullptr;
        return input;
    }

    /// Calls `visit(row, span, number)` with the turned depths of each row of the piece with this number.
    template <typename D, typename Visit>
    static void visit_rows(const std::array<Vec<D, 2>, 3>& at, const std::array<D, 3>& depths,
                           bool larger_passes, const DepthScene& shared, std::size_t number,
                           Visit&& visit) {
        const auto plane = TriangleDepth<D>(at, depths, larger_passes).plane({D(0.5), D(0.5)});
        for (const PieceSpan& span : shared.pieces[number].spans)
            visit(plane.on_row(span.y), span, number);
    }

    /// The same of all pieces.
    template <typename D, typename Visit>
    static void for_each_row(const DepthInput<D>& input, const DepthScene& shared, Visit&& visit) {
        for (std::size_t i = 0; i < input.pieces.size(); ++i)
            visit_rows<D>(input.pieces[i].triangle.vertices, input.pieces[i].depths,
                          input.rule.larger_passes, shared, i, visit);
    }

    static DepthRegion whole(const Canvas& canvas) {
        return {
            .left = canvas.left(), .top_row = 0, .width = canvas.width, .height = canvas.height};
    }

    /// What is seen, and the exact depths.
    void find_exact(Depth right) {
        const auto exact_depths = [this](Depth kind, auto&& keep_depth) {
            const Scene scene = scene_with(kind, ScalarKind::exact);
            const Plan plan = plan_for(scene);
            const auto input = input_of<Rational>(scene, plan);
            for_each_row(*input, *shared_,
                         [&](const DepthRow<Rational>& row, const PieceSpan& span, std::size_t) {
                             for (int x = span.from; x <= span.to; ++x)
                                 keep_depth(turned(row.at(x), input->rule.larger_passes));
                         });
            return input;
        };
        const auto input = exact_depths(right, [&](const Rational& depth) {
            // The other one is its reciprocal. In a perspective, clipping leaves neither of them 0.
            const Rational other = depth == 0 ? Rational(0) : Rational(1 / depth);
            shared_->inverse_distance.emplace_back(shared_->is_inverse_linear ? depth : other);
            shared_->distance.emplace_back(shared_->is_inverse_linear ? other : depth);
        });
        shared_->winners = run_buffer(*input, *shared_, DirectDepths{}, DepthStore{});
        if (scene_.projection.type == ProjectionType::none)
            return;
        const auto ndc = exact_depths(
            Depth::ndc_z, [&](const Rational& depth) { shared_->ndc.emplace_back(depth); });
        // What is linear on the screen is linear in the other: two depths tell how steep.
        const Rational& first_ndc = ndc->pieces[0].depths[0];
        const Rational& first_right = input->pieces[0].depths[0];
        for (std::size_t i = 0; i < ndc->pieces.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k)
                if (const Rational step = ndc->pieces[i].depths[k] - first_ndc; step != 0)
                    shared_->per_ndc =
                        nearest_double(Rational((input->pieces[i].depths[k] - first_right) / step));
    }

    /// The whole work of a depth buffer. `depths_of(row)` gives the depths of a row, pixel by pixel, and
    /// `store` has the code that a cell holds of a depth.
    template <typename D, typename DepthsOf, typename Store>
    static Winners run_buffer(const DepthInput<D>& input, const DepthScene& shared,
                              const DepthsOf& depths_of, const Store& store) {
        const auto& [larger_passes, cleared] = input.rule;
        const bool is_open = !cleared; // any depth passes against a clear cell
        std::vector codes(shared.canvas.area(),
                          store.code_of(turned(cleared.value_or(D()), larger_passes)));
        Winners winners(codes.size());
        for_each_row(input, shared,
                     [&](const DepthRow<D>& row, const PieceSpan& span, std::size_t piece) {
                         auto* const cells = row_of(codes, shared.canvas, span.y);
                         std::uint32_t* const seen = row_of(winners, shared.canvas, span.y);
                         const auto number = static_cast<std::uint32_t>(piece + 1);
                         auto depths = depths_of(row);
                         for (int x = span.from; x <= span.to; ++x) {
                             auto code = store.code_of(depths.at(x));
                             if ((is_open && seen[x] == 0) || code < cells[x]) {
                                 cells[x] = std::move(code);
                                 seen[x] = number;
                             }
                         }
                     });
        return winners;
    }

    /// Each pixel's depth by itself, as core has it.
    struct DirectDepths {
        template <typename D> const DepthRow<D>& operator()(const DepthRow<D>& row) const {
            return row;
        }
    };
    /// The depths of a row accumulated.
    struct AccumulatedDepths {
        int interval;
        template <typename D> ReseededDepths<D> operator()(const DepthRow<D>& row) const {
            return {row, interval};
        }
    };

    /// A cell that holds depths as they are.
    struct DepthStore {
        template <typename D> D code_of(D depth) const { return depth; }
        template <typename D> D depth_of(D stored) const { return stored; }
    };

    /// The row at this height of what each pixel has, from x = 0 on.
    template <typename Value>
    static Value* row_of(std::vector<Value>& values, const Canvas& canvas, int y) {
        return values.data() + canvas.row_of(y) * canvas.width - canvas.left();
    }

    /// How many pixels show another primitive than in exact arithmetic.
    ErrorValue wrong_winners(const Winners& winners) const {
        const auto primitive_of = [this](std::uint32_t winner) {
            return winner == 0 ? 0 : shared_->pieces[winner - 1].primitive + 1;
        };
        std::uint64_t wrong = 0;
        std::uint64_t covered = 0;
        for (std::size_t i = 0; i < winners.size(); ++i) {
            const std::size_t exact = primitive_of(shared_->winners[i]);
            covered += exact == 0 ? 0 : 1;
            wrong += primitive_of(winners[i]) == exact ? 0 : 1;
        }
        return ErrorValue::ratio(wrong, covered);
    }

    /// The relative error of 1/z of a fragment, if the buffer holds `depth` for it: with d what it
    /// should hold, |d' - d| is one of 1/z, of z or of what is linear in one of these.
    std::optional<double> inverse_z_error(Depth kind, std::size_t fragment, double depth) const {
        const double z = std::abs(shared_->distance[fragment].near);
        const double inverse = std::abs(shared_->inverse_distance[fragment].near);
        if (z == 0 || (kind == Depth::ndc_z && !shared_->per_ndc))
            return std::nullopt;
        const double error = exact_of(kind)[fragment].error_of(depth);
        if (kind == Depth::ndc_z)
            return error * std::abs(*shared_->per_ndc) / (shared_->is_inverse_linear ? inverse : z);
        return error / (kind == Depth::inverse_z ? inverse : std::abs(depth));
    }

    static void keep_larger(std::optional<double>& largest, const std::optional<double>& error) {
        if (error && !(largest && *error <= *largest))
            largest = error;
    }

    /// The largest of these, of the depths that a buffer holds.
    template <typename D, typename DepthsOf, typename Store>
    ErrorValue largest_error(Depth kind, const DepthInput<D>& input, const DepthsOf& depths_of,
                             const Store& store) const {
        std::optional<double> largest;
        std::size_t fragment = 0;
        for_each_row(
            input, *shared_, [&](const DepthRow<D>& row, const PieceSpan& span, std::size_t) {
                auto depths = depths_of(row);
                for (int x = span.from; x <= span.to; ++x) {
                    const auto stored = store.depth_of(store.code_of(depths.at(x)));
                    keep_larger(largest, error_of(kind, fragment++,
                                                  turned(stored, input.rule.larger_passes)));
                }
            });
        return {largest};
    }
    template <typename D>
    std::optional<double> error_of(Depth kind, std::size_t fragment, const D& depth) const {
        if constexpr (std::same_as<D, Rational>) {
            // Exact numbers are wrong only in a buffer of the wrong kind.
            const ExactValue found(depth);
            const ExactValue& exact = exact_of(kind)[fragment];
            if (found.near == exact.near && found.rest == exact.rest)
                return 0;
            return inverse_z_error(kind, fragment, found.near);
        } else {
            return inverse_z_error(kind, fragment, static_cast<double>(depth));
        }
    }
    const std::vector<ExactValue>& exact_of(Depth kind) const {
        return kind == Depth::ndc_z       ? shared_->ndc
               : kind == Depth::inverse_z ? shared_->inverse_distance
                                          : shared_->distance;
    }

    /// Calls `use(input)` with the input of a kind of depth in a kind of scalar, or adds a failure
    /// for the setting.
    template <typename Use> void with_input(const Scene& scene, Setting setting, Use&& use) {
        const std::string refusal = refusal_in_words(scene);
        if (!refusal.empty())
            return builder_.add_failure(std::move(setting), refusal);
        const Plan plan = plan_for(scene);
        with_scalar(plan, [&]<typename Scalar>() {
            if constexpr (std::same_as<Scalar, Interval>)
                add_adaptive(scene, plan, std::move(setting));
            else if (const auto input = input_of<Scalar>(scene, plan))
                use(std::move(setting), input);
            else
                builder_.add_failure(std::move(setting), clipped_otherwise);
        });
    }

    /// True if depths of this kind are linear on the screen, whatever the scene's triangles are. Another
    /// kind may be right in this picture by luck, and is never advised.
    bool is_right(Depth kind) const {
        return kind == Depth::ndc_z || (kind == Depth::inverse_z) == shared_->is_inverse_linear;
    }

    void add_scalars(Depth kind) {
        builder_.begin_curve(name_of_depth(kind), "scalar", !is_right(kind));
        for (const ScalarSetting& scalar : scalar_settings()) {
            // Depths of fixed-point vertices are doubles; the grid that is drawn on will do.
            if (scalar.bits && std::int64_t{1} << *scalar.bits != fixed_grid)
                continue;
            Setting scalar_setting = named_setting(scalar.name);
            scalar_setting.never_errs = is_right(kind) && scalar.never_errs();
            with_input(scene_with(kind, scalar.kind), std::move(scalar_setting),
                       [&]<typename D>(Setting setting, std::shared_ptr<DepthInput<D>> input) {
                           add_buffer(kind, std::move(setting), input, DirectDepths{}, as_they_are);
                       });
        }
    }

    /// The depth buffer of `adaptive`.
    static NumberedDepths buffer_of(const AdaptiveTriangles& input, const DepthScene& shared) {
        return {whole(shared.canvas), depth_rule<Rational>(input.scene),
                [&input](std::uint32_t piece, std::size_t side, int x, int row) {
                    return exact_depth(input.scene, input.placed[piece].exact, side,
                                       {x, input.scene.canvas.y_of(row)});
                }};
    }

    /// Calls `visit(row, span, piece)` with the depths of each row of each piece. They come from a
    /// plane in doubles, after intervals have found how far these may be off; or in rationals, where
    /// intervals leave it open whether a triangle has area. Returns how often.
    template <typename Visit>
    static std::uint64_t for_each_adaptive_row(const AdaptiveTriangles& input,
                                               const DepthScene& shared, NumberedDepths& buffer,
                                               Visit&& visit) {
        std::uint64_t left_open = 0;
        for (std::size_t i = 0; i < input.placed.size(); ++i) {
            const AdaptiveTriangles::Placed& one = input.placed[i];
            const auto rows_of = [&]<typename Scalar>(const Piece<Scalar>& piece, auto&& take) {
                visit_rows<DepthOf<Scalar>>(depth_positions(Triangle<Scalar>{piece.positions}),
                                            piece.depths, buffer.larger_passes(), shared, i, take);
            };
            buffer.begin(static_cast<std::uint32_t>(i));
            buffer.try_out(false);
            const bool is_decided = one.is_decided([&](const Piece<Interval>& piece) {
                rows_of(piece, [&](const auto& row, const PieceSpan& span, std::size_t) {
                    const int line = static_cast<int>(shared.canvas.row_of(span.y));
                    keep_nearer(buffer, line, {span.from, span.to}, row, [](int) {});
                });
            });
            buffer.draw();
            if (is_decided) {
                rows_of(one.doubles, visit);
            } else {
                ++left_open;
                buffer.begin(static_cast<std::uint32_t>(i));
                rows_of(one.exact, visit);
            }
        }
        return left_open;
    }

    /// The whole work of the depth buffer of `adaptive`. Adds what took rationals to `fallbacks`.
    static Winners run_adaptive(const AdaptiveTriangles& input, const DepthScene& shared,
                                std::uint64_t& fallbacks) {
        NumberedDepths buffer = buffer_of(input, shared);
        Winners winners(shared.canvas.area());
        fallbacks += for_each_adaptive_row(
            input, shared, buffer, [&](const auto& row, const PieceSpan& span, std::size_t piece) {
                const int line = static_cast<int>(shared.canvas.row_of(span.y));
                std::uint32_t* const seen = row_of(winners, shared.canvas, span.y);
                const auto number = static_cast<std::uint32_t>(piece + 1);
                keep_nearer(buffer, line, {span.from, span.to}, row,
                            [seen, number](int x) { seen[x] = number; });
            });
        fallbacks += buffer.exact_tests();
        return winners;
    }

    /// `adaptive` decides as exact numbers do; what its buffer holds are doubles.
    void add_adaptive(const Scene& scene, const Plan& plan, Setting setting) {
        const auto input = std::make_shared<AdaptiveTriangles>(scene, plan);
        if (!are_those_of(shared_->pieces, input->primitives()))
            return builder_.add_failure(std::move(setting), clipped_otherwise);
        std::uint64_t fallbacks = 0;
        const Winners winners = run_adaptive(*input, *shared_, fallbacks);
        Setting adaptive = adaptive_setting(shared_->fragments, fallbacks,
                                            "finds in intervals how far doubles may be off; where "
                                            "two depths meet, rationals decide");
        adaptive.never_errs = setting.never_errs;
        adaptive.errors = {wrong_winners(winners), largest_error(scene.depth(), *input)};
        builder_.add(
            std::move(adaptive),
            [input, shared = shared_] {
                std::uint64_t ignored = 0;
                keep(run_adaptive(*input, *shared, ignored));
            },
            shared_->fragments);
    }

    /// The largest error of the doubles that `adaptive` tests.
    ErrorValue largest_error(Depth kind, const AdaptiveTriangles& input) const {
        NumberedDepths buffer = buffer_of(input, *shared_);
        std::optional<double> largest;
        std::size_t fragment = 0;
        for_each_adaptive_row(
            input, *shared_, buffer, [&](const auto& row, const PieceSpan& span, std::size_t) {
                for (int x = span.from; x <= span.to; ++x) {
                    const double depth = to_double(buffer.turned(row.at(x)));
                    keep_larger(largest, inverse_z_error(kind, fragment++, depth));
                }
            });
        return {largest};
    }

    static constexpr auto as_they_are = [](const auto&) { return DepthStore{}; };

    /// `make_store(input)` makes the cells for depths, and for depths that are counted.
    template <typename D, typename DepthsOf, typename MakeStore>
    void add_buffer(Depth kind, Setting setting, std::shared_ptr<DepthInput<D>> input,
                    const DepthsOf& depths_of, const MakeStore& make_store) {
        const auto store = make_store(*input);
        setting.errors = {wrong_winners(run_buffer(*input, *shared_, depths_of, store)),
                          largest_error(kind, *input, depths_of, store)};
        setting.work = work_of(
            [&] {
                const auto counting = counting_copy_of(*input);
                keep(run_buffer(counting, *shared_, depths_of, make_store(counting)));
            },
            shared_->fragments);
        builder_.add(
            std::move(setting),
            [input, shared = shared_, depths_of, store] {
                keep(run_buffer(*input, *shared, depths_of, store));
            },
            shared_->fragments);
    }

    /// Of depths that are worked out in double; no other input is asked for.
    template <typename MakeStore>
    void add_stored(Depth kind, const Setting& setting, const MakeStore& make_store) {
        with_input(scene_with(kind, ScalarKind::double_precision), setting,
                   [&]<typename D>(Setting one, std::shared_ptr<DepthInput<D>> input) {
                       if constexpr (std::same_as<D, double>)
                           add_buffer(kind, std::move(one), input, DirectDepths{}, make_store);
                   });
    }

    /// Buffers of whole numbers, from the near plane to the far one, and of floats. Depths are
    /// worked out in double.
    void add_buffers(Depth kind) {
        builder_.begin_curve(fmt::format("{}, stored", name_of_depth(kind)), "bits of the buffer",
                             !is_right(kind));
        for (const int bits : depth_buffer_bits)
            add_stored(kind, bits_setting(bits),
                       [this, kind, bits]<typename D>(const DepthInput<D>& input) {
                           const auto [nearest, farthest] = ends_of(kind, input);
                           return DepthCodes<D>(D(nearest), D(farthest), bits);
                       });
        add_stored(kind, named_setting("float"), [](const auto&) { return FloatStore{}; });
    }

    /// Floats as a buffer holds them.
    struct FloatStore {
        template <typename D> float code_of(const D& depth) const {
            return static_cast<float>(static_cast<double>(depth));
        }
        double depth_of(float stored) const { return static_cast<double>(stored); }
    };

    /// The depth that lies on the near plane, or on the far one. `nullopt` if there is no such plane,
    /// or in clip space, where only z/w is known there.
    std::optional<double> depth_of_plane(Depth kind, bool is_near) const {
        const Projection& projection = scene_.projection;
        const auto distance = is_near ? near_of(projection) : far_of(projection);
        if (kind == Depth::linear_z && distance)
            return nearest_double(*distance);
        if (kind == Depth::inverse_z && distance && sgn(*distance) > 0)
            return nearest_double(1 / *distance);
        const bool is_in_clip_space = projection.type == ProjectionType::clip_space;
        if (kind != Depth::ndc_z || !(distance || is_in_clip_space))
            return std::nullopt;
        Vec<Rational, 4> clip{0, 0, is_near ? projection.z_from_zero ? 0 : -1 : 1, 1};
        if (!is_in_clip_space) {
            const bool goes_up = view_axis_of(projection.type) == ViewAxis::plus_z;
            clip.z = goes_up ? *distance : Rational(-*distance);
            clip = product_of(factors_of(projection, scene_.canvas)) * clip;
        }
        const Vec<Rational, 4> canonical{0, 0, Rational(clip.z / clip.w), 1};
        return nearest_double(
            (product_of(factors_of(scene_.viewport, scene_.canvas)) * canonical).z);
    }

    /// The turned depths of the first and the last code of whole numbers: those of the near and the
    /// far plane. Without a near plane, that of the nearest vertex; without a far one, what the buffer
    /// is cleared to, or else the farthest vertex.
    template <typename D>
    std::array<double, 2> ends_of(Depth kind, const DepthInput<D>& input) const {
        const auto near = depth_of_plane(kind, true);
        auto far = depth_of_plane(kind, false);
        if (!far && input.rule.cleared)
            far = static_cast<double>(*input.rule.cleared);
        constexpr double infinity = std::numeric_limits<double>::infinity();
        std::array<double, 2> of_vertices{infinity, -infinity};
        for (const DepthPiece<D>& piece : input.pieces)
            for (const D& depth : piece.depths) {
                const double one = turned(static_cast<double>(depth), input.rule.larger_passes);
                of_vertices = {std::min(of_vertices[0], one), std::max(of_vertices[1], one)};
            }
        return {near ? turned(*near, input.rule.larger_passes) : of_vertices[0],
                far ? turned(*far, input.rule.larger_passes) : of_vertices[1]};
    }

    /// Depths accumulated from pixel to pixel.
    void add_accumulated(Depth kind, ScalarKind scalar, std::string_view name) {
        builder_.begin_curve(fmt::format("{} += slope, {}", name_of_depth(kind), name),
                             "begun anew every so many pixels");
        for (const int interval : reseed_intervals)
            with_input(scene_with(kind, scalar), interval_setting(interval, "pixel"),
                       [&]<typename D>(Setting setting, std::shared_ptr<DepthInput<D>> input) {
                           add_buffer(kind, std::move(setting), input, AccumulatedDepths{interval},
                                      as_they_are);
                       });
    }

    /// The painter has no depth in a pixel: the last one drawn is seen. It is never advised: triangles
    /// that cut each other have no order.
    void add_painter() {
        builder_.begin_curve("painter", "sorted by the distance that is", true);
        const MethodKey& key = *find_method_key("painter_key");
        for (const std::string_view name : key.values) {
            Scene scene = scene_with(Depth::painter, ScalarKind::double_precision);
            key.set(scene.method, name);
            Setting setting = named_setting(name);
            const std::string refusal = refusal_in_words(scene);
            if (!refusal.empty()) {
                builder_.add_failure(std::move(setting), refusal);
                continue;
            }
            std::vector<double> distances;
            for (const auto& vertex : geometry_of<double>(scene).vertices)
                distances.push_back(vertex.distance);
            const auto run = [scene, distances, shared = shared_,
                              pieces_of = pieces_of_primitives()] {
                return painted(order_by(scene, distances), pieces_of, *shared);
            };
            setting.errors = {wrong_winners(run()), {}};
            setting.work = work_of(
                [&] {
                    keep(order_by(
                        scene, std::vector<Counted<double>>(distances.begin(), distances.end())));
                },
                shared_->fragments);
            builder_.add(
                std::move(setting), [run] { keep(run()); }, shared_->fragments);
        }
    }

    /// The pieces of each primitive, by their places.
    using PiecesOf = std::map<std::size_t, std::vector<std::size_t>>;
    PiecesOf pieces_of_primitives() const {
        PiecesOf pieces_of;
        for (std::size_t i = 0; i < shared_->pieces.size(); ++i)
            pieces_of[shared_->pieces[i].primitive].push_back(i);
        return pieces_of;
    }

    template <typename Scalar>
    static PainterOrder<Scalar> order_by(const Scene& scene, const std::vector<Scalar>& distances) {
        return sorted_by_distance(
            scene, keys_of_faces<Scalar>(scene, [&](std::size_t vertex) -> const Scalar& {
                return distances[vertex];
            }));
    }

    /// Each pixel's winner where the pieces are painted one over the other.
    template <typename Order>
    static Winners painted(const Order& order, const PiecesOf& pieces_of,
                           const DepthScene& shared) {
        Winners winners(shared.canvas.area());
        for (const std::size_t primitive : order.primitives)
            if (const auto found = pieces_of.find(primitive); found != pieces_of.end())
                for (const std::size_t piece : found->second)
                    for (const PieceSpan& span : shared.pieces[piece].spans) {
                        std::uint32_t* const seen = row_of(winners, shared.canvas, span.y);
                        std::fill(seen + span.from, seen + span.to + 1,
                                  static_cast<std::uint32_t>(piece + 1));
                    }
        return winners;
    }

    const Scene& scene_;
    const ReportOptions& options_;
    std::shared_ptr<DepthScene> shared_;
    JobBuilder builder_{ReportJob::depth};
};

} // namespace

JobReport measure_depth(const Scene& scene, const ReportOptions& options) {
    return DepthJob(scene, options).measured();
}

} // namespace rastertrace
