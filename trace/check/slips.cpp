// SPDX-License-Identifier: MIT
#include "slips.h"

#include <rastertrace/core/numbers/irrational.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
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

    void add(Values values) {
        if (!values.empty() && values != right_)
            results_.push_back(std::move(values));
    }
    void add(const std::optional<Rational>& value) {
        if (value)
            add(Values{*value});
    }
    void add(const Vec3& v) { add(Values{v.x, v.y, v.z}); }
    void add_formula(const Formula& formula) { add(value_of(formula)); }

    const Values& right() const { return right_; }
    std::vector<Values> take() { return std::move(results_); }

private:
    Values right_;
    std::vector<Values> results_;
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

std::vector<Values> dx_dy_inverted(const Formula& formula) {
    Results results(formula);
    if (const auto* edge = as<Slope>(formula))
        results.add(divided(edge->to.y - edge->from.y, edge->to.x - edge->from.x));
    if (const auto* lerp = as<Lerp>(formula))
        if (const auto slope = lerp->slope(); slope && sgn(*slope) != 0)
            results.add(lerp->d1 + (lerp->i - lerp->i1) / *slope);
    return results.take();
}

std::vector<Values> start_and_step_exchanged(const Formula& formula) {
    Results results(formula);
    if (const auto* lerp = as<Lerp>(formula))
        if (const auto slope = lerp->slope()) {
            results.add(*slope + lerp->d1 * (lerp->i - lerp->i1));
            results.add(divided(lerp->d1 - lerp->d2, lerp->i1 - lerp->i2).value_or(*slope) +
                        lerp->d2 * (lerp->i - lerp->i2));
        }
    return results.take();
}

std::vector<Values> neighbor_row(const Formula& formula) {
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

std::vector<Values> corner_for_center(const Formula& formula) {
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
template <Rounding rounding> std::vector<Values> instead_of_floor(const Formula& formula) {
    Results results(formula);
    if (rounding_of(formula) == Rounding::floor)
        put_rounded(results, formula, {.rounding = rounding});
    return results.take();
}

std::vector<Values> another_rounding(const Formula& formula) {
    Results results(formula);
    for (const Rounding rounding : {Rounding::floor, Rounding::nearest, Rounding::truncate,
                                    Rounding::inside, Rounding::half_open})
        for (const Ties ties : {Ties::start, Ties::up, Ties::away, Ties::even})
            if (rounding_of(formula) != Rounding::floor)
                put_rounded(results, formula, {.rounding = rounding, .ties = ties});
    return results.take();
}

std::vector<Values> integer_division(const Formula& formula) {
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

std::vector<Values> y_for_z(const Formula& formula) {
    Results results(formula);
    if (gives_vector(formula) && results.right().size() >= 3)
        exchange(results, results.right(), 1, 2);
    return results.take();
}

std::vector<Values> coordinates_exchanged(const Formula& formula) {
    Results results(formula);
    if (!gives_vector(formula) && !as<Weights>(formula) && !as<RoundedPlace>(formula))
        return {};
    exchange(results, results.right(), 0, 1);
    exchange(results, results.right(), 0, 2);
    if (as<Weights>(formula))
        exchange(results, results.right(), 1, 2);
    return results.take();
}

std::vector<Values> view_turned_round(const Formula& formula) {
    Results results(formula);
    const bool has_view = as<Toward>(formula) || as<FaceDot>(formula) || as<FaceCosine>(formula);
    if (has_view) {
        results.add(negated(results.right()));
    }
    if (const auto* face = as<IsCulled>(formula))
        results.add_formula({IsCulled{-face->dot, face->hides_back}});
    return results.take();
}

std::vector<Values> normal_for_view(const Formula& formula) {
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

std::vector<Values> corner_for_centroid(const Formula& formula) {
    Results results(formula);
    if (const auto* toward = as<Toward>(formula))
        for (const Vec3& corner : toward->corners)
            results.add(toward->to - corner);
    if (const auto* face = as<Centroid>(formula))
        for (const Vec3& corner : face->corners)
            results.add(corner);
    return results.take();
}

std::vector<Values> not_divided(const Formula& formula) {
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

std::vector<Values> cosine_of_dot_only(const Formula& formula) {
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

std::vector<Values> angle_for_cosine(const Formula& formula) {
    Results results(formula);
    if (as<FaceCosine>(formula) && !results.right().empty()) {
        const double radians =
            std::acos(std::clamp(nearest_double(results.right().front()), -1.0, 1.0));
        results.add(Rational(radians));
        results.add(Rational(radians * 180 / std::numbers::pi));
    }
    return results.take();
}

std::vector<Values> z_for_inverse_z(const Formula& formula) {
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
    }
    if (const auto* test = as<DepthComparison>(formula))
        if (sgn(test->depth) != 0 && sgn(test->stored) != 0)
            results.add_formula(
                {DepthComparison{1 / test->depth, 1 / test->stored, test->larger_passes}});
    return results.take();
}

std::vector<Values> three_corners(const Formula& formula) {
    Results results(formula);
    if (const auto* face = as<FaceNormal>(formula); face && face->corners.size() > 3)
        results.add_formula({FaceNormal{{face->corners.begin(), face->corners.begin() + 3}}});
    if (const auto* face = as<Centroid>(formula); face && face->corners.size() > 3)
        results.add_formula({Centroid{{face->corners.begin(), face->corners.begin() + 3}}});
    return results.take();
}

std::vector<Values> c_minus_a(const Formula& formula) {
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

std::vector<Values> term_dropped(const Formula& formula) {
    Results results(formula);
    put_sums(results, terms_of(formula), 0);
    if (const auto* lerp = as<Lerp>(formula))
        results.add(lerp->d1); // a LERP whose step is d2 - d2 (T0)
    return results.take();
}

std::vector<Values> sign(const Formula& formula) {
    Results results(formula);
    const Values& right = results.right();
    if (as<IsCulled>(formula) || as<InRow>(formula) || as<DepthComparison>(formula) ||
        right.empty())
        return {};
    results.add(negated(right));
    const bool has_components = right.size() > 1 && !as<BresenhamDecisions>(formula);
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

std::vector<Values> rows_for_columns(const Formula& formula) {
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

std::vector<Values> tie_the_other_way(const Formula& formula) {
    Results results(formula);
    if (const auto* line = as<BresenhamDecisions>(formula)) {
        BresenhamDecisions other = *line;
        other.steps_at_ties = !other.steps_at_ties;
        results.add_formula({other});
    }
    return results.take();
}

std::vector<Values> factor_2_dropped(const Formula& formula) {
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

std::vector<Values> dx_and_dy_exchanged(const Formula& formula) {
    Results results(formula);
    if (const auto* line = as<BresenhamDecisions>(formula)) {
        BresenhamDecisions other = *line;
        std::swap(other.major, other.minor);
        results.add_formula({other});
    }
    return results.take();
}

constexpr Slip table[] = {
    {"truncate-for-floor", "rounded toward 0 where the rule is down",
     instead_of_floor<Rounding::truncate>},
    {"nearest-for-floor", "rounded to the nearest where the rule is down",
     instead_of_floor<Rounding::nearest>},
    {"inside-for-floor", "only pixels inside where the rule is down at both ends",
     instead_of_floor<Rounding::inside>},
    {"half-open-for-floor", "without the right end where the rule is down at both ends",
     instead_of_floor<Rounding::half_open>},
    {"dx-dy-inverted", "(y2 - y1) / (x2 - x1) where (x2 - x1) / (y2 - y1) belongs", dx_dy_inverted},
    {"start-and-step-exchanged", "the start added again and again to the step",
     start_and_step_exchanged},
    {"y-for-z", "y and z exchanged", y_for_z},
    {"view-turned-round", "from the eye to the face instead of from the face to the eye",
     view_turned_round},
    {"z-for-inverse-z", "z taken where 1/z belongs, or the other way round", z_for_inverse_z},
    {"cosine-of-dot-only", "the dot product not divided by both lengths", cosine_of_dot_only},
    {"normal-for-view", "the normal used once more as the view", normal_for_view},
    {"corner-for-center", "a pixel's own x and y where its center, 1/2 further, belongs",
     corner_for_center},
    {"corner-for-centroid", "a corner taken where the centroid belongs", corner_for_centroid},
    {"tie-the-other-way", "d = 0 decided the other way", tie_the_other_way},
    {"factor-2-dropped", "dy where 2 dy belongs", factor_2_dropped},
    {"dx-and-dy-exchanged", "the longer direction taken for the shorter one", dx_and_dy_exchanged},
    {"not-divided", "a division left out", not_divided},
    {"neighbor-row", "the row above or below, or the column beside", neighbor_row},
    {"sign", "a minus lost, or one too many", sign},
    {"term-dropped", "a term of the sum left out", term_dropped},
    {"three-corners", "three corners of a polygon taken for all", three_corners},
    {"c-minus-a", "C - A taken where C - B belongs: another corner", c_minus_a},
    {"integer-division", "a quotient cut off to a whole number", integer_division},
    {"rows-for-columns", "the matrix turned over: its columns taken for rows", rows_for_columns},
    {"coordinates-exchanged", "two coordinates exchanged", coordinates_exchanged},
    {"angle-for-cosine", "the angle told where its cosine belongs", angle_for_cosine},
    {"another-rounding", "rounded by another rule than the scene has", another_rounding},
};

} // namespace

std::span<const Slip> slips() {
    return table;
}

const Slip* find_slip(std::string_view name) {
    const auto* const found = std::find_if(std::begin(table), std::end(table),
                                           [&](const Slip& slip) { return slip.name == name; });
    return found == std::end(table) ? nullptr : found;
}

} // namespace rastertrace
