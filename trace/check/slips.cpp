// SPDX-License-Identifier: MIT
#include "slips.h"

#include <rastertrace/core/numbers/irrational.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

namespace rastertrace {

namespace {

using Vec2 = Vec<Rational, 2>;
using Vec3 = Vec<Rational, 3>;

/// Collects what a formula comes to with a mistake in it, and leaves out what is right all the same.
class Results {
public:
    explicit Results(const Formula& formula) : right_(value_of(formula)) {}

    void add(Values values, std::string detail = {}) {
        if (!values.empty() && values != right_)
            results_.push_back({std::move(values), std::move(detail)});
    }
    void add(const std::optional<Rational>& value) {
        if (value)
            add(Values{*value});
    }
    void add(const Vec3& v) { add(Values{v.x, v.y, v.z}); }
    void add_formula(const Formula& formula, std::string detail = {}) {
        add(value_of(formula), std::move(detail));
    }

    const Values& right() const { return right_; }
    std::vector<SlipResult> take() { return std::move(results_); }

private:
    Values right_;
    std::vector<SlipResult> results_;
};

/// The formula, if it is of this form.
template <typename Form> const Form* as(const Formula& formula) {
    return std::get_if<Form>(&formula.of);
}

/// above / below, if there is such a number.
std::optional<Rational> divided(const Rational& above, const Rational& below) {
    return sgn(below) == 0 ? std::nullopt : std::optional<Rational>(above / below);
}

Rational truncated(const Rational& number) {
    return Rational(mpz_class(number.get_num() / number.get_den()));
}

Values negated(Values values) {
    for (Rational& value : values)
        value = -value;
    return values;
}

std::vector<SlipResult> dx_dy_inverted(const Formula& formula) {
    Results results(formula);
    if (const auto* edge = as<Slope>(formula))
        results.add(divided(edge->to.y - edge->from.y, edge->to.x - edge->from.x));
    if (const auto* lerp = as<Lerp>(formula))
        if (const auto slope = lerp->slope(); slope && sgn(*slope) != 0) {
            results.add(lerp->d1 + (lerp->i - lerp->i1) / *slope);
            results.add(lerp->d2 + (lerp->i - lerp->i2) / *slope);
        }
    return results.take();
}

/// A number rounded to so many digits behind the point, a half away from 0.
Rational rounded_to_digits(const Rational& number, unsigned digits) {
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, digits);
    const Rational scaled = abs(number) * power + Rational(1, 2);
    return sgn(number) * Rational(mpz_class(scaled.get_num() / scaled.get_den())) / power;
}

std::vector<SlipResult> slope_rounded_first(const Formula& formula) {
    Results results(formula);
    const auto* const lerp = as<Lerp>(formula);
    const auto slope = lerp == nullptr ? std::nullopt : lerp->slope();
    constexpr unsigned most_digits = 3;
    for (unsigned digits = 0; slope && digits <= most_digits; ++digits) {
        const Rational rounded = rounded_to_digits(*slope, digits);
        const std::string detail = digits == 0   ? "to a whole number"
                                   : digits == 1 ? "to 1 digit"
                                                 : fmt::format("to {} digits", digits);
        results.add({lerp->d1 + rounded * (lerp->i - lerp->i1)}, detail);
        results.add({lerp->d2 + rounded * (lerp->i - lerp->i2)}, detail);
    }
    return results.take();
}

std::vector<SlipResult> pixel_for_end(const Formula& formula) {
    Results results(formula);
    if (as<Lerp>(formula) && !results.right().empty()) {
        const Rational& x = results.right().front();
        for (const Rounding rounding : {Rounding::floor, Rounding::nearest})
            results.add(
                RoundedEnd{.x = x, .rule = {.rounding = rounding}}.by({.rounding = rounding}));
    }
    return results.take();
}

std::vector<SlipResult> start_and_step_exchanged(const Formula& formula) {
    Results results(formula);
    if (const auto* lerp = as<Lerp>(formula))
        if (const auto slope = lerp->slope()) {
            results.add(*slope + lerp->d1 * (lerp->i - lerp->i1));
            results.add(divided(lerp->d1 - lerp->d2, lerp->i1 - lerp->i2).value_or(*slope) +
                        lerp->d2 * (lerp->i - lerp->i2));
        }
    return results.take();
}

std::vector<SlipResult> neighbor_row(const Formula& formula) {
    Results results(formula);
    for (const int rows : {1, -1}) {
        if (const auto* lerp = as<Lerp>(formula)) {
            Lerp beside = *lerp;
            beside.i += rows;
            results.add_formula({beside});
        }
        if (const auto* weights = as<Weights>(formula)) {
            Weights beside = *weights;
            beside.sample.y += rows;
            results.add_formula({beside});
        }
    }
    return results.take();
}

std::vector<SlipResult> corner_for_center(const Formula& formula) {
    Results results(formula);
    const Rational half(1, 2);
    if (const auto* lerp = as<Lerp>(formula); lerp && lerp->i.get_den() == 2) {
        Lerp at_corner = *lerp;
        at_corner.i -= half;
        results.add_formula({at_corner});
    }
    if (const auto* triangle = as<Weights>(formula);
        triangle && triangle->sample.y.get_den() == 2) {
        Weights at_corner = *triangle;
        at_corner.sample = {triangle->sample.x - half, triangle->sample.y - half};
        results.add_formula({at_corner});
    }
    return results.take();
}

/// The same with another rule for what is rounded.
void put_rounded(Results& results, const Formula& formula, const SpanRounding& rule) {
    if (const auto* end = as<RoundedEnd>(formula))
        results.add(end->by(rule));
    if (const auto* place = as<RoundedPlace>(formula))
        results.add(place->by(rule));
    if (const auto* row = as<InRow>(formula)) {
        InRow other = *row;
        other.from.rule = other.to.rule = rule;
        results.add_formula({other});
    }
}

/// The rule that a formula rounds by.
std::optional<Rounding> rounding_of(const Formula& formula) {
    if (const auto* end = as<RoundedEnd>(formula))
        return end->rule.rounding;
    if (const auto* place = as<RoundedPlace>(formula))
        return place->rule.rounding;
    if (const auto* row = as<InRow>(formula))
        return row->from.rule.rounding;
    return std::nullopt;
}

/// One rule instead of the textbook's, which takes the whole number below at both ends.
template <Rounding rounding> std::vector<SlipResult> instead_of_floor(const Formula& formula) {
    Results results(formula);
    if (rounding_of(formula) == Rounding::floor)
        put_rounded(results, formula, {.rounding = rounding});
    return results.take();
}

std::vector<SlipResult> another_rounding(const Formula& formula) {
    Results results(formula);
    for (const Rounding rounding : {Rounding::floor, Rounding::nearest, Rounding::truncate,
                                    Rounding::inside, Rounding::half_open})
        for (const Ties ties : {Ties::start, Ties::up, Ties::away, Ties::even})
            if (rounding_of(formula) != Rounding::floor)
                put_rounded(results, formula, {.rounding = rounding, .ties = ties});
    return results.take();
}

std::vector<SlipResult> integer_division(const Formula& formula) {
    Results results(formula);
    if (as<Slope>(formula) && !results.right().empty())
        results.add(truncated(results.right().front()));
    if (const auto* lerp = as<Lerp>(formula))
        if (const auto slope = lerp->slope()) {
            Lerp whole = *lerp;
            whole.step = truncated(*slope);
            results.add_formula({whole});
        }
    if (const auto* product = as<MatrixTimes>(formula)) {
        MatrixTimes whole = *product;
        for (auto& row : whole.rows)
            for (Rational& factor : row)
                factor = truncated(factor);
        results.add_formula({whole});
    }
    return results.take();
}

/// The coordinates of a point in another order.
void exchange(Results& results, const Values& values, std::size_t i, std::size_t j) {
    if (std::max(i, j) >= values.size())
        return;
    Values exchanged = values;
    std::swap(exchanged[i], exchanged[j]);
    results.add(std::move(exchanged));
}

/// True of a formula for a point or a vector.
bool gives_vector(const Formula& formula) {
    return as<TakenOver>(formula) || as<FaceNormal>(formula) || as<Centroid>(formula) ||
           as<Toward>(formula) || as<MatrixTimes>(formula) || as<DividedByW>(formula);
}

std::vector<SlipResult> y_for_z(const Formula& formula) {
    Results results(formula);
    if (gives_vector(formula) && results.right().size() >= 3)
        exchange(results, results.right(), 1, 2);
    return results.take();
}

std::vector<SlipResult> coordinates_exchanged(const Formula& formula) {
    Results results(formula);
    if (!gives_vector(formula) && !as<Weights>(formula) && !as<RoundedPlace>(formula))
        return {};
    exchange(results, results.right(), 0, 1);
    exchange(results, results.right(), 0, 2);
    if (as<Weights>(formula))
        exchange(results, results.right(), 1, 2);
    return results.take();
}

std::vector<SlipResult> view_turned_round(const Formula& formula) {
    Results results(formula);
    const bool has_view = as<Toward>(formula) || as<FaceDot>(formula) || as<FaceCosine>(formula);
    if (has_view) {
        results.add(negated(results.right()));
    }
    if (const auto* face = as<IsCulled>(formula))
        results.add_formula({IsCulled{-face->dot, face->hides_back}});
    return results.take();
}

std::vector<SlipResult> normal_for_view(const Formula& formula) {
    Results results(formula);
    if (const auto* toward = as<Toward>(formula)) {
        const Vec3& n = toward->normal;
        results.add(n);
        results.add(Vec3{n.x, n.z, n.y}); // with y for z as well (T0, figures 22 to 24)
    }
    if (const auto* face = as<FaceDot>(formula))
        results.add_formula({FaceDot{face->normal, face->normal}});
    if (const auto* face = as<FaceCosine>(formula))
        results.add_formula({FaceCosine{face->normal, face->normal}});
    return results.take();
}

std::vector<SlipResult> corner_for_centroid(const Formula& formula) {
    Results results(formula);
    if (const auto* toward = as<Toward>(formula))
        for (const Vec3& corner : toward->corners)
            results.add(toward->to - corner);
    if (const auto* face = as<Centroid>(formula))
        for (const Vec3& corner : face->corners)
            results.add(corner);
    return results.take();
}

std::vector<SlipResult> not_divided(const Formula& formula) {
    Results results(formula);
    if (const auto* face = as<Centroid>(formula)) {
        const Vec3 mean = Centroid{face->corners}.value();
        const Rational count = static_cast<long>(face->corners.size());
        const Vec3 sum{mean.x * count, mean.y * count, mean.z * count};
        results.add(sum);
        results.add(Vec3{sum.x / 2, sum.y / 2, sum.z / 2});
    }
    if (const auto* division = as<DividedByW>(formula))
        results.add(Values{division->point[0], division->point[1], division->point[2]});
    if (const auto* edge = as<Slope>(formula))
        results.add(edge->to.x - edge->from.x);
    if (const auto* lerp = as<Lerp>(formula); lerp && !lerp->step)
        results.add(lerp->d1 + (lerp->d2 - lerp->d1) * (lerp->i - lerp->i1));
    if (const auto* triangle = as<Weights>(formula)) {
        const auto& [a, b, c] = triangle->corners;
        const Rational area = doubled_area(a, b, c);
        Values undivided = results.right();
        for (Rational& weight : undivided)
            weight *= area;
        results.add(std::move(undivided));
    }
    return results.take();
}

std::vector<SlipResult> cosine_of_dot_only(const Formula& formula) {
    Results results(formula);
    const auto* face = as<FaceCosine>(formula);
    if (face == nullptr || results.right().empty())
        return {};
    const Rational product = dot(face->normal, face->view);
    const Rational normals = dot(face->normal, face->normal);
    const Rational views = dot(face->view, face->view);
    results.add(product);
    results.add(divided(product, square_root(normals)));
    results.add(divided(product, square_root(views)));
    results.add(divided(product, normals * views));
    results.add(divided(product, abs(product))); // N . E / |N . E| (T1)
    return results.take();
}

std::vector<SlipResult> angle_for_cosine(const Formula& formula) {
    Results results(formula);
    if (as<FaceCosine>(formula) && !results.right().empty()) {
        const double radians =
            std::acos(std::clamp(nearest_double(results.right().front()), -1.0, 1.0));
        results.add(Rational(radians));
        results.add(Rational(radians * 180 / std::numbers::pi));
    }
    return results.take();
}

std::vector<SlipResult> complement_of_angle(const Formula& formula) {
    Results results(formula);
    if (as<FaceCosine>(formula) && !results.right().empty()) {
        const Rational& cosine = results.right().front();
        if (abs(cosine) <= 1)
            results.add(square_root(1 - cosine * cosine));
    }
    return results.take();
}

std::vector<SlipResult> only_z_divided(const Formula& formula) {
    Results results(formula);
    if (const auto* division = as<DividedByW>(formula))
        if (const auto z = division->value(2)) {
            results.add(Values{division->point[0], division->point[1], *z});
            results.add(Values{*division->value(0), *division->value(1), division->point[2]});
        }
    return results.take();
}

std::vector<SlipResult> z_for_inverse_z(const Formula& formula) {
    Results results(formula);
    const auto inverted = [&results](const Values& values) {
        if (!values.empty())
            results.add(divided(1, values.front()));
    };
    if (const auto* lerp = as<Lerp>(formula); lerp && lerp->is_inverse_z) {
        inverted(results.right());
        if (sgn(lerp->d1) != 0 && sgn(lerp->d2) != 0) {
            const Formula of_z{Lerp{.d1 = 1 / lerp->d1,
                                    .i1 = lerp->i1,
                                    .d2 = 1 / lerp->d2,
                                    .i2 = lerp->i2,
                                    .i = lerp->i}};
            results.add_formula(of_z);
            inverted(value_of(of_z));
        }
    }
    if (const auto* mixed = as<MixedDepth>(formula)) {
        inverted(results.right());
        MixedDepth of_z = *mixed;
        for (Rational& depth : of_z.depths) {
            if (sgn(depth) == 0)
                return results.take();
            depth = 1 / depth;
        }
        results.add_formula({of_z});
        inverted(value_of({of_z}));
        // A straight line of z over the whole triangle, whatever fills it.
        Rational of_corners = 0;
        for (std::size_t i = 0; i < mixed->corner_depths.size(); ++i) {
            if (sgn(mixed->corner_depths[i]) == 0)
                return results.take();
            of_corners += mixed->corner_weights[i] / mixed->corner_depths[i];
        }
        results.add(of_corners);
        inverted({of_corners});
    }
    if (const auto* test = as<DepthComparison>(formula))
        if (sgn(test->depth) != 0 && sgn(test->stored) != 0)
            results.add_formula(
                {DepthComparison{1 / test->depth, 1 / test->stored, test->larger_passes}});
    return results.take();
}

std::vector<SlipResult> three_corners(const Formula& formula) {
    Results results(formula);
    if (const auto* face = as<FaceNormal>(formula); face && face->corners.size() > 3)
        results.add_formula({FaceNormal{{face->corners.begin(), face->corners.begin() + 3}}});
    if (const auto* face = as<Centroid>(formula); face && face->corners.size() > 3)
        results.add_formula({Centroid{{face->corners.begin(), face->corners.begin() + 3}}});
    return results.take();
}

std::vector<SlipResult> c_minus_a(const Formula& formula) {
    Results results(formula);
    if (const auto* edge = as<Slope>(formula); edge && edge->other) {
        results.add_formula({Slope{edge->from, *edge->other}});
        results.add_formula({Slope{*edge->other, edge->to}});
    }
    if (const auto* lerp = as<Lerp>(formula); lerp && lerp->other) {
        const auto& [d, i] = *lerp->other;
        results.add_formula({Lerp{.d1 = lerp->d1, .i1 = lerp->i1, .d2 = d, .i2 = i, .i = lerp->i}});
        results.add_formula({Lerp{.d1 = d, .i1 = i, .d2 = lerp->d2, .i2 = lerp->i2, .i = lerp->i}});
    }
    if (const auto* face = as<FaceNormal>(formula)) {
        const Vec3& a = face->corners[0];
        const Vec3& b = face->corners[1];
        const Vec3& c = face->corners[2];
        results.add(cross(b, c));     // nothing taken away
        results.add(cross(b - a, c)); // only from one of them
        results.add(cross(b, c - a));
        results.add(cross(b - a, a - c)); // A - C
    }
    return results.take();
}

/// A sum of products with one of them left out, or with the other sign.
void put_sums(Results& results, const std::vector<std::vector<Rational>>& sums,
              const Rational& instead) {
    const Values& right = results.right(); // what the sums come to
    std::size_t most_terms = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        most_terms = std::max(most_terms, sums[i].size());
        for (const Rational& term : sums[i]) {
            Values values = right;
            values[i] += (instead - 1) * term;
            results.add(std::move(values));
        }
    }
    // The same term of every component: a translation, say.
    for (std::size_t k = 0; k < most_terms; ++k) {
        Values values = right;
        for (std::size_t i = 0; i < sums.size(); ++i)
            if (k < sums[i].size())
                values[i] += (instead - 1) * sums[i][k];
        results.add(std::move(values));
    }
}

std::vector<std::vector<Rational>> terms_of(const Formula& formula) {
    std::vector<std::vector<Rational>> sums;
    if (const auto* product = as<MatrixTimes>(formula))
        for (const auto& row : product->rows) {
            sums.emplace_back();
            for (std::size_t k = 0; k < 4; ++k)
                sums.back().push_back(row[k] * product->point[k]);
        }
    if (const auto* face = as<FaceDot>(formula))
        sums = {std::vector<Rational>{face->normal.x * face->view.x, face->normal.y * face->view.y,
                                      face->normal.z * face->view.z}};
    if (const auto* face = as<FaceNormal>(formula); face && face->corners.size() == 3) {
        const Vec3 u = face->corners[1] - face->corners[0];
        const Vec3 v = face->corners[2] - face->corners[0];
        sums = {{u.y * v.z, -(u.z * v.y)}, {u.z * v.x, -(u.x * v.z)}, {u.x * v.y, -(u.y * v.x)}};
    }
    if (const auto* toward = as<Toward>(formula))
        sums = {{toward->to.x, -toward->centroid.x},
                {toward->to.y, -toward->centroid.y},
                {toward->to.z, -toward->centroid.z}};
    if (const auto* lerp = as<Lerp>(formula))
        if (const auto slope = lerp->slope())
            sums = {std::vector<Rational>{lerp->d1, *slope * lerp->i, -(*slope * lerp->i1)}};
    if (const auto* mixed = as<MixedDepth>(formula); mixed && !mixed->gives_inverse) {
        sums.emplace_back();
        for (std::size_t i = 0; i < mixed->depths.size(); ++i)
            sums.back().push_back(mixed->weights[i] * mixed->depths[i]);
    }
    return sums;
}

std::vector<SlipResult> term_dropped(const Formula& formula) {
    Results results(formula);
    put_sums(results, terms_of(formula), 0);
    return results.take();
}

/// A LERP whose step is (d2 - d2) / (i2 - i1) (T0).
std::vector<SlipResult> slope_of_zero(const Formula& formula) {
    Results results(formula);
    if (const auto* lerp = as<Lerp>(formula))
        results.add(lerp->d1);
    return results.take();
}

std::vector<SlipResult> sign(const Formula& formula) {
    Results results(formula);
    const Values& right = results.right();
    if (as<IsCulled>(formula) || as<InRow>(formula) || as<DepthComparison>(formula) ||
        as<BresenhamDecisions>(formula) || right.empty())
        return {};
    // That all of it is turned round has its own name where there is a view.
    const bool has_view = as<Toward>(formula) || as<FaceDot>(formula) || as<FaceCosine>(formula);
    if (!has_view)
        results.add(negated(right));
    const bool has_components = right.size() > 1;
    for (std::size_t i = 0; has_components && i < right.size(); ++i) {
        Values one = right;
        one[i] = -one[i];
        results.add(std::move(one));
    }
    put_sums(results, terms_of(formula), -1);
    // A minus lost while typing one of the numbers in.
    if (const auto* edge = as<Slope>(formula))
        for (Rational Vec2::*axis : {&Vec2::x, &Vec2::y})
            for (Vec2 Slope::*end : {&Slope::from, &Slope::to}) {
                Slope other = *edge;
                other.*end.*axis = -(other.*end.*axis);
                results.add_formula({other});
            }
    if (const auto* lerp = as<Lerp>(formula)) {
        for (Rational Lerp::*input : {&Lerp::d1, &Lerp::i1, &Lerp::d2, &Lerp::i2, &Lerp::i}) {
            Lerp other = *lerp;
            other.*input = -(other.*input);
            results.add_formula({other});
        }
        if (const auto slope = lerp->slope()) {
            Lerp other = *lerp;
            other.step = -*slope;
            results.add_formula({other});
        }
    }
    return results.take();
}

std::vector<SlipResult> rows_for_columns(const Formula& formula) {
    Results results(formula);
    const auto* product = as<MatrixTimes>(formula);
    if (product == nullptr || product->rows.size() != 4)
        return {};
    MatrixTimes transposed = *product;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 4; ++k)
            transposed.rows[i][k] = product->rows[k][i];
    results.add_formula({transposed});
    return results.take();
}

std::vector<SlipResult> tie_the_other_way(const Formula& formula) {
    Results results(formula);
    if (const auto* line = as<BresenhamDecisions>(formula)) {
        BresenhamDecisions other = *line;
        other.steps_at_ties = !other.steps_at_ties;
        results.add_formula({other});
    }
    return results.take();
}

std::vector<SlipResult> factor_2_dropped(const Formula& formula) {
    Results results(formula);
    const auto* line = as<BresenhamDecisions>(formula);
    if (line == nullptr)
        return {};
    for (const auto& [at_start, in_steps] : {std::pair(1, 2), std::pair(2, 1), std::pair(1, 1)}) {
        BresenhamDecisions other = *line;
        other.factor_at_start = at_start;
        other.factor_in_steps = in_steps;
        results.add_formula({other});
    }
    return results.take();
}

std::vector<SlipResult> dx_and_dy_exchanged(const Formula& formula) {
    Results results(formula);
    if (const auto* line = as<BresenhamDecisions>(formula)) {
        BresenhamDecisions other = *line;
        std::swap(other.major, other.minor);
        results.add_formula({other});
    }
    return results.take();
}

/// The decisions with other steps.
std::vector<SlipResult>
decided_otherwise(const Formula& formula,
                  std::initializer_list<std::array<std::optional<Rational>, 3>> others) {
    Results results(formula);
    for (const auto& [start, straight, diagonal] : others) {
        BresenhamDecisions other = *as<BresenhamDecisions>(formula);
        other.other_start = start;
        other.other_straight = straight;
        other.other_diagonal = diagonal;
        results.add_formula({other});
    }
    return results.take();
}

std::vector<SlipResult> steps_exchanged(const Formula& formula) {
    const auto* const line = as<BresenhamDecisions>(formula);
    return line == nullptr
               ? std::vector<SlipResult>{}
               : decided_otherwise(formula, {{std::nullopt, line->diagonal(), line->straight()}});
}

std::vector<SlipResult> diagonal_of_one_axis(const Formula& formula) {
    const auto* const line = as<BresenhamDecisions>(formula);
    return line == nullptr
               ? std::vector<SlipResult>{}
               : decided_otherwise(formula,
                                   {{std::nullopt, std::nullopt, line->straight()},
                                    {std::nullopt, std::nullopt, Rational(-2 * line->major)}});
}

std::vector<SlipResult> start_of_other_axis(const Formula& formula) {
    const auto* const line = as<BresenhamDecisions>(formula);
    return line == nullptr ? std::vector<SlipResult>{}
                           : decided_otherwise(formula, {{Rational(2 * line->major - line->minor),
                                                          std::nullopt, std::nullopt}});
}

/// dx and dy with their signs, in an octant whose lines rise.
std::vector<SlipResult> octant_ignored(const Formula& formula) {
    Results results(formula);
    const auto* const line = as<BresenhamDecisions>(formula);
    if (line == nullptr)
        return {};
    for (const int sign_of_major : {1, -1})
        for (const int sign_of_minor : {1, -1})
            for (const bool is_exchanged : {false, true}) {
                BresenhamDecisions other = *line;
                other.major = sign_of_major * line->major;
                other.minor = sign_of_minor * line->minor;
                if (is_exchanged)
                    std::swap(other.major, other.minor);
                if (sign_of_major + sign_of_minor < 2) // else the lines rise
                    results.add_formula({other});
            }
    return results.take();
}

std::vector<SlipResult> shifted_list(const Formula& formula) {
    Results results(formula);
    const Values& right = results.right();
    if (as<BresenhamDecisions>(formula) == nullptr || right.size() < 2)
        return {};
    results.add(Values(right.begin() + 1, right.end()));
    Values late{right.front()};
    late.insert(late.end(), right.begin(), right.end());
    results.add(std::move(late));
    return results.take();
}

// Matrices.

using Factor = MatrixTimes::Factor;

/// The product of factors times the point of `times`, as many components of it.
Values product_of(const std::vector<Factor>& factors, const MatrixTimes& times) {
    MatrixTimes::Row point = times.point;
    for (auto factor = factors.rbegin(); factor != factors.rend(); ++factor) {
        MatrixTimes::Row moved;
        for (std::size_t i = 0; i < 4; ++i)
            moved[i] = std::inner_product(factor->rows[i].begin(), factor->rows[i].end(),
                                          point.begin(), Rational(0));
        point = moved;
    }
    return {point.begin(), point.begin() + static_cast<std::ptrdiff_t>(times.rows.size())};
}

/// What comes of other factors, one of which is changed at a time.
template <typename Change>
std::vector<SlipResult> with_other_factors(const Formula& formula, std::string_view name,
                                           const Change& change) {
    Results results(formula);
    const auto* const times = as<MatrixTimes>(formula);
    for (std::size_t i = 0; times != nullptr && i < times->factors.size(); ++i) {
        std::vector<Factor> factors = times->factors;
        if (factors[i].name == name && change(factors[i].rows))
            results.add(product_of(factors, *times));
    }
    return results.take();
}

std::vector<SlipResult> turned_the_other_way(const Formula& formula) {
    return with_other_factors(formula, "rotate", [](std::array<MatrixTimes::Row, 4>& rows) {
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < i; ++k)
                std::swap(rows[i][k], rows[k][i]);
        return true;
    });
}

/// The rotation about the same axis by an angle whose degrees were taken for radians.
std::vector<SlipResult> degrees_for_radians(const Formula& formula) {
    return with_other_factors(formula, "rotate", [](std::array<MatrixTimes::Row, 4>& rows) {
        const auto entry = [&rows](std::size_t i, std::size_t k) {
            return nearest_double(rows[i][k]);
        };
        const std::array axis{(entry(2, 1) - entry(1, 2)) / 2, (entry(0, 2) - entry(2, 0)) / 2,
                              (entry(1, 0) - entry(0, 1)) / 2};
        const double sine = std::hypot(axis[0], axis[1], axis[2]);
        const double cosine = (entry(0, 0) + entry(1, 1) + entry(2, 2) - 1) / 2;
        if (sine == 0)
            return false;
        const double degrees =
            std::round(std::atan2(sine, cosine) * 180 / std::numbers::pi * 1e6) / 1e6;
        const double other_sine = std::sin(degrees);
        const double other_cosine = std::cos(degrees);
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const double a = axis[i] / sine;
                const double b = axis[k] / sine;
                const double turn =
                    i == k ? 0 : axis[3 - i - k] / sine * ((k + 1) % 3 == i ? 1 : -1);
                rows[i][k] = Rational((i == k ? other_cosine : 0) + (1 - other_cosine) * a * b +
                                      other_sine * turn);
            }
        return true;
    });
}

std::vector<SlipResult> factors_exchanged(const Formula& formula) {
    Results results(formula);
    const auto* const times = as<MatrixTimes>(formula);
    for (std::size_t i = 1; times != nullptr && i < times->factors.size(); ++i) {
        std::vector<Factor> factors = times->factors;
        std::swap(factors[i - 1], factors[i]);
        results.add(product_of(factors, *times),
                    fmt::format("{} before {}", factors[i].name, factors[i - 1].name));
    }
    return results.take();
}

/// W/2 for (W - 1)/2.
std::vector<SlipResult> size_for_last_pixel(const Formula& formula) {
    const auto* const times = as<MatrixTimes>(formula);
    if (times == nullptr || !times->is_viewport)
        return {};
    return with_other_factors(formula, "scale", [](std::array<MatrixTimes::Row, 4>& rows) {
        bool is_changed = false;
        for (std::size_t i = 0; i < 2; ++i)
            if (abs(rows[i][i]) > 1) {
                rows[i][i] += Rational(sgn(rows[i][i])) / 2;
                is_changed = true;
            }
        return is_changed;
    });
}

constexpr Slip table[] = {
    {"truncate-for-floor", "rounding toward 0", "rounding down",
     "left of x = 0, rows begin and end one pixel too far right", 80,
     instead_of_floor<Rounding::truncate>},
    {"nearest-for-floor", "rounding to the nearest", "rounding down",
     "half of the ends lie one pixel too far right", 50, instead_of_floor<Rounding::nearest>},
    {"inside-for-floor", "only the pixels between the ends", "rounding down at both ends",
     "rows begin one pixel too late", 30, instead_of_floor<Rounding::inside>},
    {"half-open-for-floor", "leaving out the right end", "rounding down at both ends",
     "rows end one pixel too early", 30, instead_of_floor<Rounding::half_open>},
    {"dx-dy-inverted", "(y2 - y1) / (x2 - x1)", "(x2 - x1) / (y2 - y1)",
     "steep edges lie flat, flat ones are steep", 70, dx_dy_inverted},
    {"z-for-inverse-z", "z itself, or z in a straight line", "1/z in a straight line",
     "what is in the middle lies too far away", 60, z_for_inverse_z},
    {"start-and-step-exchanged", "adding the start again and again to the step",
     "adding the step again and again to the start", "the numbers grow too fast", 20,
     start_and_step_exchanged},
    {"steps-exchanged", "2 dy after a diagonal step, 2 (dy - dx) after a straight one",
     "2 dy after a straight step, 2 (dy - dx) after a diagonal one", "d runs away", 20,
     steps_exchanged},
    {"diagonal-of-one-axis", "2 dy, or -2 dx, after a diagonal step", "2 (dy - dx)",
     "d only grows, or only falls", 15, diagonal_of_one_axis},
    {"start-of-other-axis", "d = 2 dx - dy to begin with", "d = 2 dy - dx",
     "the first steps are wrong", 15, start_of_other_axis},
    {"factor-2-dropped", "dy", "2 dy", "the line steps too late", 20, factor_2_dropped},
    {"dx-and-dy-exchanged", "the shorter direction", "the longer one", "steep lines have gaps", 20,
     dx_and_dy_exchanged},
    {"octant-ignored", "the signs of dx and dy left in", "their sizes, and the octant's own steps",
     "only lines of the first octant are right", 20, octant_ignored},
    {"shifted-list", "a list that begins one step too early or too late", "d before each step",
     "each number stands beside the wrong step", 20, shifted_list},
    {"tie-the-other-way", "d = 0 decided the other way", "the scene's own rule for d = 0",
     "the line differs where it passes midway between two pixels", 30, tie_the_other_way},
    {"y-for-z", "z in the place of y", "y", "what points away points up", 20, y_for_z},
    {"view-turned-round", "from the eye to the face", "from the face to the eye",
     "what is turned away is drawn, what is turned to the eye is culled", 40, view_turned_round},
    {"cosine-of-dot-only", "the dot product alone", "the dot product divided by both lengths",
     "cosines beyond 1", 30, cosine_of_dot_only},
    {"normal-for-view", "the normal once more", "the view", "no face is turned away", 10,
     normal_for_view},
    {"corner-for-center", "a pixel's own x and y", "its center, 1/2 further",
     "the picture is moved by half a pixel", 40, corner_for_center},
    {"corner-for-centroid", "a corner", "the centroid",
     "faces near the silhouette are culled wrongly", 15, corner_for_centroid},
    {"turned-the-other-way", "turning clockwise", "turning counter-clockwise",
     "the object is turned to the other side", 30, turned_the_other_way},
    {"degrees-for-radians", "the number of degrees taken for radians", "degrees",
     "the angle seems to be any", 30, degrees_for_radians},
    {"factors-exchanged", "matrices in the other order", "the order of the scene",
     "what was to turn about itself turns about the origin", 30, factors_exchanged},
    {"size-for-last-pixel", "W and H", "W - 1 and H - 1",
     "the right and the upper edge are cut off", 30, size_for_last_pixel},
    {"rows-for-columns", "the columns of the matrix taken for rows", "its rows",
     "turned the other way, and moved nowhere", 20, rows_for_columns},
    {"not-divided", "leaving out a division", "dividing", "numbers that are too large", 30,
     not_divided},
    {"only-z-divided", "dividing z alone by w, or x and y alone", "dividing x, y and z by w",
     "the picture has no perspective, or the depths have none", 15, only_z_divided},
    {"slope-rounded-first", "rounding the slope before it was used", "rounding at the end",
     "the further from the start, the further off", 40, slope_rounded_first},
    {"neighbor-row", "taking the row or column beside", "this one", "the table is moved by one row",
     20, neighbor_row},
    {"sign", "losing or adding a minus", "keeping each sign", "mirrored", 60, sign},
    {"term-dropped", "leaving out a term of the sum", "all terms", "moved by a constant", 20,
     term_dropped},
    {"slope-of-zero", "d2 - d2 in the slope", "d2 - d1", "every row has the number of the first",
     25, slope_of_zero},
    {"three-corners", "three corners of a polygon", "all of its corners",
     "the normal of a bent face leans", 70, three_corners},
    {"c-minus-a", "another corner", "the edge's own corner", "the edge of another pair of vertices",
     15, c_minus_a},
    {"pixel-for-end", "the pixel", "the exact end of the row",
     "whole numbers where fractions belong", 10, pixel_for_end},
    {"integer-division", "a quotient cut off to a whole number", "the quotient itself",
     "slopes below 1 are 0", 20, integer_division},
    {"coordinates-exchanged", "two coordinates exchanged", "x, y, z in this order",
     "mirrored at a diagonal", 15, coordinates_exchanged},
    {"angle-for-cosine", "the angle", "its cosine", "numbers beyond 1", 15, angle_for_cosine},
    {"complement-of-angle", "the sine, as of 90 degrees less the angle", "the cosine of the angle",
     "bright where it should be dark", 5, complement_of_angle},
    {"another-rounding", "another rule for rounding", "the scene's own", "ends one pixel beside",
     30, another_rounding},
};

} // namespace

std::string meaning_of(const Slip& slip, std::string_view detail) {
    return fmt::format("{}{}{}{} instead of {}", slip.done, detail.empty() ? "" : " (", detail,
                       detail.empty() ? "" : ")", slip.instead_of);
}

std::span<const Slip> slips() {
    return table;
}

const Slip* find_slip(std::string_view name) {
    const auto* const found = std::find_if(std::begin(table), std::end(table),
                                           [&](const Slip& slip) { return slip.name == name; });
    return found == std::end(table) ? nullptr : found;
}

} // namespace rastertrace
