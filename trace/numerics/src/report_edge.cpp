// SPDX-License-Identifier: MIT
// The first job of the report: x of every edge in every row of pixels (rows are whole numbers of y,
// and the pixel is floor(x), as the textbook has it).

#include "job_builder.h"

#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/raster/fill_scanline.h>
#include <rastertrace/numerics/knobs.h>

#include <fmt/core.h>

#include <bit>
#include <concepts>
#include <memory>
#include <numeric>

namespace rastertrace {

namespace {

/// An edge from its upper end to its lower one, and the rows of the canvas that it passes.
struct ExactEdge {
    Edge<Rational> edge;
    Vec<Rational, 2> end;
    int first_y = 0;
    int rows = 0;
};

/// The same in the numbers of a method.
template <typename Ends> struct EdgeInput {
    Ends ends;
    int first_y = 0;
    int rows = 0;
};
template <typename Scalar> struct ScalarEnds { Vertex<Scalar> from, to; };

template <typename Scalar>
ScalarEnds<CountedOf<Scalar>> counting_copy_of(const ScalarEnds<Scalar>& ends) {
    const auto vertex = [](const Vertex<Scalar>& one) {
        return Vertex<CountedOf<Scalar>>{{as_counted(one.position.x), as_counted(one.position.y)}};
    };
    return {vertex(ends.from), vertex(ends.to)};
}
template <typename Integer>
WholeEdge<Counted<Integer>> counting_copy_of(const WholeEdge<Integer>& edge) {
    return {edge.x1, edge.y1, edge.x2, edge.y2, edge.unit};
}

/// The numbers of rounding methods: what is asked of a walk in every row is its pixel.
template <typename Scalar, typename Walk> struct ScalarWalk {
    Walk walk;
    Scalar x{};

    Index pixel_on_row(int y) {
        x = walk.x_on_row(y);
        return floor_index(x);
    }
};
template <typename Integer> struct FixedWalk {
    FixedPointWalk<Integer> walk;
    Integer unit;

    Index pixel_on_row(int) {
        walk.step();
        return walk.pixel();
    }
};
template <typename Integer> struct ExactWalk {
    QuotientWalk<Integer> walk;
    bool has_begun = false;

    Index pixel_on_row(int) {
        if (has_begun)
            walk.step();
        has_begun = true;
        return static_cast<Index>(walk.pixel());
    }
};

/// The x that a walk has reached.
template <typename Scalar, typename Walk> Scalar x_of(const ScalarWalk<Scalar, Walk>& walk) {
    return walk.x;
}
template <typename Integer, typename Walk>
Rational x_of(const ScalarWalk<Fraction<Integer>, Walk>& walk) {
    return exact(walk.x);
}
template <typename Integer> Rational x_of(const FixedWalk<Integer>& walk) {
    return exact(Fraction<Integer>(walk.walk.x(), walk.unit));
}
template <typename Integer> Rational x_of(const ExactWalk<Integer>& walk) {
    return exact(Fraction<Integer>(walk.walk.pixel())) +
           exact(Fraction<Integer>(walk.walk.rest(), walk.walk.whole()));
}

class EdgeJob {
public:
    EdgeJob(const Scene& scene, const ReportOptions& options)
        : options_(options), canvas_(scene.canvas) {
        find_edges(scene);
        for (const ExactEdge& edge : edges_) {
            for (int i = 0; i < edge.rows; ++i) {
                const Rational x = x_at(edge, i);
                pixels_.push_back(floor_index(x));
                exact_.emplace_back(x);
            }
        }
    }

    JobReport measured() {
        if (edges_.empty())
            return nothing_of(ReportJob::edge, "the scene has no edge that passes a row of pixels");
        JobReport& report = builder_.report();
        report.unit = "row";
        report.units = pixels_.size();
        report.reference = "x1 + (dx/dy) (y - y1) in rationals, and its floor";
        report.measures = {{"wrong_rows", "rows with a wrong pixel / rows", "", "rows"},
                           {"x_error",
                            "largest |x - exact|",
                            "px",
                            {},
                            unseen_x,
                            "half a step of the grid of graphics hardware"}};
        add_direct();
        add_weighted();
        add_accumulated<float>("float");
        add_accumulated<double>("double");
        add_fixed_point();
        add_quotients();
        return builder_.finish(options_);
    }

private:
    /// The sides of everything that has sides, with nothing rounded.
    void find_edges(const Scene& scene) {
        const Scene exact = plain_scene(scene, ScalarKind::exact);
        const int down = canvas_.down();
        const auto add = [&](const Vec<Rational, 2>& p, const Vec<Rational, 2>& q) {
            if (p.y == q.y)
                return;
            const bool p_is_upper = down > 0 ? p.y < q.y : q.y < p.y;
            const auto& upper = p_is_upper ? p : q;
            const auto& lower = p_is_upper ? q : p;
            const Index first = std::max<Index>(canvas_.row_of(first_row_below(upper.y, down)), 0);
            const Index last =
                std::min<Index>(canvas_.row_of(last_row_above(lower.y, down)), canvas_.height - 1);
            if (last < first)
                return;
            edges_.push_back({edge_between(Vertex<Rational>{upper}, Vertex<Rational>{lower}), lower,
                              canvas_.y_of(static_cast<int>(first)),
                              static_cast<int>(last - first + 1)});
        };
        const auto add_piece = [&](const auto& piece) {
            std::array<Vec<Rational, 2>, 3> at;
            for (std::size_t i = 0; i < piece.count; ++i)
                at[i] = {scalar_from<Rational>(piece.positions[i].x, 1),
                         scalar_from<Rational>(piece.positions[i].y, 1)};
            // A line has one side, a triangle and an outline three.
            for (std::size_t i = 0; i + 1 < piece.count; ++i)
                add(at[i], at[i + 1]);
            if (piece.count == 3)
                add(at[2], at[0]);
        };
        const AnyScreenList list = screen_list_for(exact);
        if (const auto* typed = std::get_if<TypedVertices>(&list))
            for_each_piece(exact, *typed, add_piece);
        else
            for_each_piece(exact, std::get<ScreenList<Rational>>(list), add_piece);
    }

    Rational x_at(const ExactEdge& edge, int row) const {
        return edge.edge.x_at(Rational(edge.first_y + canvas_.down() * row));
    }

    /// Calls `visit(walk, edge, i)` with each edge's walk; `make` makes it.
    template <typename Inputs, typename Make, typename Visit>
    static void for_each_walk(const Inputs& inputs, const Make& make, Visit&& visit) {
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            auto walk = make(inputs[i]);
            visit(walk, inputs[i], i);
        }
    }

    /// Calls `visit(pixel)` with each pixel of each edge's walk.
    template <typename Inputs, typename Make, typename Visit>
    static void for_each_pixel(const Inputs& inputs, const Make& make, int down, Visit&& visit) {
        for_each_walk(inputs, make, [&](auto& walk, const auto& input, std::size_t) {
            for (int i = 0; i < input.rows; ++i)
                visit(walk.pixel_on_row(input.first_y + down * i));
        });
    }

    /// Measures one method in one setting: how far off it is, what it does, how long it takes.
    template <typename Inputs, typename Make>
    void add(Setting setting, std::shared_ptr<Inputs> inputs, const Make& make) {
        setting.errors = errors_of(*inputs, make);
        setting.work = counted_work(*inputs, make);
        builder_.add(
            std::move(setting),
            [inputs, make, down = canvas_.down()] {
                Index sum = 0;
                for_each_pixel(*inputs, make, down, [&sum](Index pixel) { sum += pixel; });
                keep(sum);
            },
            pixels_.size());
    }

    /// Rows with a wrong pixel, and the largest error of x.
    template <typename Inputs, typename Make>
    std::vector<ErrorValue> errors_of(const Inputs& inputs, const Make& make) const {
        std::uint64_t wrong = 0;
        double largest = 0;
        std::size_t row = 0;
        for_each_walk(inputs, make, [&](auto& walk, const auto& input, std::size_t edge) {
            for (int i = 0; i < input.rows; ++i, ++row) {
                wrong +=
                    walk.pixel_on_row(input.first_y + canvas_.down() * i) == pixels_[row] ? 0 : 1;
                const auto x = x_of(walk);
                double error = 0;
                if constexpr (std::floating_point<std::remove_cvref_t<decltype(x)>>)
                    error = exact_[row].error_of(static_cast<double>(x));
                else
                    error = std::abs(nearest_double(x - x_at(edges_[edge], i)));
                // A largest error that is no number stays one.
                largest = error <= largest ? largest : error;
            }
        });
        return {ErrorValue::ratio(wrong, pixels_.size()), {largest}};
    }

    template <typename Inputs, typename Make>
    Work counted_work(const Inputs& inputs, const Make& make) const {
        using Input = typename Inputs::value_type;
        using Ends = decltype(counting_copy_of(std::declval<Input>().ends));
        std::vector<EdgeInput<Ends>> counting_inputs;
        for (const Input& input : inputs)
            counting_inputs.push_back({counting_copy_of(input.ends), input.first_y, input.rows});
        return work_of([&] {
            for_each_pixel(counting_inputs, make, canvas_.down(), [](Index pixel) { keep(pixel); });
        });
    }

    /// The edges in floating point or rationals; none if one of them does not fit.
    template <typename Scalar>
    std::shared_ptr<std::vector<EdgeInput<ScalarEnds<Scalar>>>> inputs_of() const {
        auto inputs = std::make_shared<std::vector<EdgeInput<ScalarEnds<Scalar>>>>();
        const auto vertex = [](const Vec<Rational, 2>& at) {
            return Vertex<Scalar>{{nearest_scalar<Scalar>(at.x), nearest_scalar<Scalar>(at.y)}};
        };
        for (const ExactEdge& edge : edges_) {
            inputs->push_back(
                {{vertex(edge.edge.start), vertex(edge.end)}, edge.first_y, edge.rows});
            if constexpr (std::floating_point<Scalar>) {
                const auto& [from, to] = inputs->back().ends;
                if (!std::isfinite(from.position.x) || !std::isfinite(to.position.x) ||
                    !std::isfinite(to.position.x - from.position.x) ||
                    !std::isfinite(to.position.y - from.position.y) ||
                    !std::isfinite(edge_between(from, to).dx_dy))
                    return nullptr;
            }
        }
        return inputs;
    }
    template <typename Scalar> static std::string overflow() {
        return std::same_as<Scalar, float> ? "an edge or its slope is beyond the largest float"
                                           : "an edge or its slope is beyond the largest double";
    }

    /// The walk of core, direct.
    template <typename Scalar> auto direct_walk() const {
        return [down = canvas_.down()](const auto& input) {
            using Number = std::remove_cvref_t<decltype(input.ends.from.position.x)>;
            return ScalarWalk<Number, EdgeWalk<Number>>{EdgeWalk<Number>(
                edge_between(input.ends.from, input.ends.to), LerpForm::direct, down)};
        };
    }

    void add_direct() {
        builder_.begin_curve("x1 + a (y - y1)", "scalar");
        add_scalar<float>("float", direct_walk<float>());
        add_scalar<double>("double", direct_walk<double>());
        const Setting setting = exact_setting(named_setting("exact"));
        if (fit_of_edges() == Fit::in_64)
            add(setting, fraction_inputs(), direct_walk<Fraction64>());
        else
            add(setting, inputs_of<Rational>(), direct_walk<Rational>());
    }

    template <typename Scalar, typename Make>
    void add_scalar(std::string_view name, const Make& make) {
        if (auto inputs = inputs_of<Scalar>())
            add(named_setting(name), std::move(inputs), make);
        else
            builder_.add_failure(named_setting(name), overflow<Scalar>());
    }

    void add_weighted() {
        builder_.begin_curve("(1 - t) x1 + t x2", "scalar");
        const auto make = [](const auto& input) {
            using Number = std::remove_cvref_t<decltype(input.ends.from.position.x)>;
            return ScalarWalk<Number, WeightedWalk<Number>>{
                WeightedWalk<Number>(input.ends.from.position, input.ends.to.position)};
        };
        add_scalar<float>("float", make);
        add_scalar<double>("double", make);
    }

    template <typename Scalar> void add_accumulated(std::string_view name) {
        builder_.begin_curve(fmt::format("x += a, {}", name), "begun anew every so many rows");
        const auto inputs = inputs_of<Scalar>();
        for (const int interval : reseed_intervals) {
            Setting setting = interval_setting(interval, "row");
            if (!inputs) {
                builder_.add_failure(std::move(setting), overflow<Scalar>());
                continue;
            }
            add(std::move(setting), inputs, [interval, down = canvas_.down()](const auto& input) {
                using Number = std::remove_cvref_t<decltype(input.ends.from.position.x)>;
                return ScalarWalk<Number, ReseededWalk<Number>>{ReseededWalk<Number>(
                    edge_between(input.ends.from, input.ends.to), down, interval)};
            });
        }
    }

    void add_fixed_point() {
        builder_.begin_curve("x += a, fixed point", "bits behind the point");
        for (const int bits : subpixel_bits) {
            Setting setting = bits_setting(bits);
            auto inputs = fixed_inputs(bits);
            if (!inputs) {
                builder_.add_failure(std::move(setting),
                                     "an edge, or its slope times its height, needs more than 64 "
                                     "bits");
                continue;
            }
            add(std::move(setting), std::move(inputs),
                [bits, down = canvas_.down()](const auto& input) {
                    using Integer = std::remove_cvref_t<decltype(input.ends.x1)>;
                    return FixedWalk<Integer>{
                        FixedPointWalk<Integer>(input.ends, down, input.first_y, bits),
                        input.ends.unit};
                });
        }
    }

    /// The edges snapped to 1/2^bits; none if 64 bits do not hold what is worked out of them.
    std::shared_ptr<std::vector<EdgeInput<WholeEdge<std::int64_t>>>> fixed_inputs(int bits) const {
        const std::int64_t unit = std::int64_t{1} << bits;
        auto inputs = std::make_shared<std::vector<EdgeInput<WholeEdge<std::int64_t>>>>();
        for (const ExactEdge& edge : edges_) {
            const auto x1 = nearest_numerator(edge.edge.start.x, unit);
            const auto y1 = nearest_numerator(edge.edge.start.y, unit);
            const auto x2 = nearest_numerator(edge.end.x, unit);
            const auto y2 = nearest_numerator(edge.end.y, unit);
            if (!x1 || !y1 || !x2 || !y2)
                return nullptr;
            const auto magnitude = [](Int128 value) { return value < 0 ? -value : value; };
            const Int128 limit = Int128{1} << 62;
            const Int128 scaled = magnitude(Int128{*x2} - *x1) * unit;
            const Int128 slope = *y1 == *y2 ? 0 : scaled / magnitude(Int128{*y2} - *y1) + 1;
            const Int128 height = magnitude(Int128{edge.first_y} * unit - *y1) + unit;
            if (scaled >= limit || slope >= limit || height >= limit || slope * height >= limit)
                return nullptr;
            inputs->push_back({{*x1, *y1, *x2, *y2, unit}, edge.first_y, edge.rows});
        }
        return inputs;
    }

    /// Which whole numbers hold everything that is worked out of an exact edge: with |n| < 2^b over a
    /// denominator below 2^d, x1 dy + dx (y D - y1) < 2^(2b + d + 4).
    enum class Fit { in_64, in_128, beyond };
    Fit fit_of_edges() const {
        std::size_t most = 0;
        for (const ExactEdge& edge : edges_) {
            const mpz_class unit = unit_of(edge);
            std::size_t bits = mpz_sizeinbase(unit.get_mpz_t(), 2) + 15; // of a row of the canvas
            for (const Rational* value :
                 {&edge.edge.start.x, &edge.edge.start.y, &edge.end.x, &edge.end.y}) {
                const mpz_class whole(*value * unit);
                bits = std::max(bits, mpz_sizeinbase(whole.get_mpz_t(), 2));
            }
            most = std::max(most, 2 * bits + 2 * mpz_sizeinbase(unit.get_mpz_t(), 2) + 8);
        }
        return most < 64 ? Fit::in_64 : most < 128 ? Fit::in_128 : Fit::beyond;
    }

    /// The least common denominator of an edge's coordinates.
    static mpz_class unit_of(const ExactEdge& edge) {
        mpz_class unit = lcm(edge.edge.start.x.get_den(), edge.edge.start.y.get_den());
        unit = lcm(unit, edge.end.x.get_den());
        return lcm(unit, edge.end.y.get_den());
    }
    template <typename Integer> static WholeEdge<Integer> whole_edge(const ExactEdge& edge) {
        const mpz_class unit = unit_of(edge);
        const auto whole = [&unit](const Rational& value) -> Integer {
            const mpz_class scaled(value * unit);
            if constexpr (sizeof(Integer) == sizeof(long)) {
                return scaled.get_si();
            } else {
                mpz_class high;
                mpz_class low;
                mpz_fdiv_q_2exp(high.get_mpz_t(), scaled.get_mpz_t(), 62);
                mpz_fdiv_r_2exp(low.get_mpz_t(), scaled.get_mpz_t(), 62);
                return (Integer{high.get_si()} << 62) + low.get_si();
            }
        };
        return {whole(edge.edge.start.x), whole(edge.edge.start.y), whole(edge.end.x),
                whole(edge.end.y), whole(Rational(1))};
    }

    std::shared_ptr<std::vector<EdgeInput<ScalarEnds<Fraction64>>>> fraction_inputs() const {
        auto inputs = std::make_shared<std::vector<EdgeInput<ScalarEnds<Fraction64>>>>();
        for (const ExactEdge& edge : edges_) {
            const auto [x1, y1, x2, y2, unit] = whole_edge<std::int64_t>(edge);
            inputs->push_back({{{{{x1, unit}, {y1, unit}}}, {{{x2, unit}, {y2, unit}}}},
                               edge.first_y,
                               edge.rows});
        }
        return inputs;
    }

    void add_quotients() {
        builder_.begin_curve("pixel and rest, whole numbers", "bits of a number");
        switch (fit_of_edges()) {
        case Fit::in_64:
            return add_quotient<std::int64_t>(64);
        case Fit::in_128:
            return add_quotient<Int128>(128);
        case Fit::beyond:
            break;
        }
        builder_.add_failure(bits_setting(128), "an edge needs more than 128 bits");
    }
    template <typename Integer> void add_quotient(int bits) {
        auto inputs = std::make_shared<std::vector<EdgeInput<WholeEdge<Integer>>>>();
        for (const ExactEdge& edge : edges_)
            inputs->push_back({whole_edge<Integer>(edge), edge.first_y, edge.rows});
        add(exact_setting(bits_setting(bits)), std::move(inputs),
            [down = canvas_.down()](const auto& input) {
                using Number = std::remove_cvref_t<decltype(input.ends.x1)>;
                return ExactWalk<Number>{QuotientWalk<Number>(input.ends, down, input.first_y)};
            });
    }

    const ReportOptions& options_;
    Canvas canvas_;
    std::vector<ExactEdge> edges_;
    std::vector<Index> pixels_;     ///< of each row of each edge
    std::vector<ExactValue> exact_; ///< x there
    JobBuilder builder_{ReportJob::edge};
};

} // namespace

JobReport measure_edges(const Scene& scene, const ReportOptions& options) {
    return EdgeJob(scene, options).measured();
}

} // namespace rastertrace
