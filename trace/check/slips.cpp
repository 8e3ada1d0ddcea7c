// SPDX-License-Identifier: MIT
#include "slip_results.h"

#include <rastertrace/core/draw/model/mistakes.h>
#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/trace/tell/mistake_text.h>
#include <rastertrace/trace/tell/step_text.h>

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

Rational truncated(const Rational& number) {
    return Rational(mpz_class(number.get_num() / number.get_den()));
}

Values negated(Values values) {
    for (Rational& value : values)
        value = -value;
    return values;
}

/// A line whose slope is inverted, with the b that was right, or the one that goes with it.
void add_inverted_form(SlipResults& results, const LineForm& line) {
    if (results.right().empty())
        return;
    const auto m = divided(1, results.right().front());
    if (!m)
        return;
    const auto& [x, y] =
        line.is_of_y ? std::pair(line.from.y, line.from.x) : std::pair(line.from.x, line.from.y);
    results.add(Values{*m, results.right().back()});
    results.add(Values{*m, y - *m * x});
}

std::vector<SlipResult> dy_dx_inverted(const Formula& formula) {
    SlipResults results(formula);
    if (const auto* line = as_form<LineForm>(formula); line && !line->is_of_y)
        add_inverted_form(results, *line);
    return results.take();
}

std::vector<SlipResult> dx_dy_inverted(const Formula& formula) {
    SlipResults results(formula);
    if (const auto* edge = as_form<Slope>(formula))
        results.add(divided(edge->to.y - edge->from.y, edge->to.x - edge->from.x));
    if (const auto* line = as_form<LineForm>(formula); line && line->is_of_y)
        add_inverted_form(results, *line);
    if (const auto* lerp = as_form<Lerp>(formula))
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

/// A number cut off to a whole level.
std::vector<SlipResult> byte_cast(const Formula& formula) {
    SlipResults results(formula);
    if (const auto* mixed = as_form<MixedColor>(formula)) {
        MixedColor other = *mixed;
        other.is_cut = !other.is_cut;
        results.add_formula({other});
    }
    return results.take();
}

std::vector<SlipResult> color_by_other_share(const Formula& formula) {
    SlipResults results(formula);
    if (const auto* mixed = as_form<MixedColor>(formula); mixed && !mixed->other_weights.empty()) {
        MixedColor other = *mixed;
        std::swap(other.weights, other.other_weights);
        results.add_formula({other});
    }
    return results.take();
}

/// T4 has the whole distance over that to the end.
std::vector<SlipResult> share_the_other_way(const Formula& formula) {
    SlipResults results(formula);
    const Values& right = results.right();
    if (as_form<TakenOver>(formula) && right.size() == 1) { // the share itself
        results.add(Rational(1 - right.front()));
        results.add(divided(1, right.front()));
        results.add(divided(1, 1 - right.front()));
    }
    if (const auto* mixed = as_form<MixedColor>(formula); mixed && mixed->weights.size() == 2) {
        MixedColor other = *mixed;
        std::swap(other.weights[0], other.weights[1]);
        results.add_formula({other});
    }
    return results.take();
}

std::vector<SlipResult> slope_rounded_first(const Formula& formula) {
    SlipResults results(formula);
    const auto* const lerp = as_form<Lerp>(formula);
    const auto slope = lerp == nullptr ? std::nullopt : lerp->slope();
    constexpr unsigned most_digits = 3;
    for (unsigned digits = 0; slope && digits <= most_digits; ++digits) {
        const Rational rounded = rounded_to_digits(*slope, digits);
        const std::string detail =
            digits == 0 ? said("to a whole number") : said("to {}", said_count(digits, "digit"));
        results.add({lerp->d1 + rounded * (lerp->i - lerp->i1)}, detail);
        results.add({lerp->d2 + rounded * (lerp->i - lerp->i2)}, detail);
    }
    return results.take();
}

std::vector<SlipResult> pixel_for_end(const Formula& formula) {
    SlipResults results(formula);
    if (as_form<Lerp>(formula) && !results.right().empty()) {
        const Rational& x = results.right().front();
        for (const Rounding rounding : {Rounding::floor, Rounding::nearest})
            results.add(
                RoundedEnd{.x = x, .rule = {.rounding = rounding}}.by({.rounding = rounding}));
    }
    return results.take();
}

std::vector<SlipResult> start_and_step_exchanged(const Formula& formula) {
    SlipResults results(formula);
    if (const auto* lerp = as_form<Lerp>(formula))
        if (const auto slope = lerp->slope()) {
            results.add(*slope + lerp->d1 * (lerp->i - lerp->i1));
            results.add(divided(lerp->d1 - lerp->d2, lerp->i1 - lerp->i2).value_or(*slope) +
                        lerp->d2 * (lerp->i - lerp->i2));
        }
    return results.take();
}

std::vector<SlipResult> neighbor_row(const Formula& formula) {
    SlipResults results(formula);
    for (const int rows : {1, -1}) {
        if (const auto* lerp = as_form<Lerp>(formula)) {
            Lerp beside = *lerp;
            beside.i += rows;
            results.add_formula({beside});
        }
        if (const auto* end = as_form<RoundedEnd>(formula)) {
            RoundedEnd beside = *end;
            beside.x += rows * end->per_row;
            results.add_formula({beside});
        }
        if (const auto* weights = as_form<Weights>(formula)) {
            Weights beside = *weights;
            beside.sample.y += rows;
            results.add_formula({beside});
        }
    }
    return results.take();
}

std::vector<SlipResult> corner_for_center(const Formula& formula) {
    SlipResults results(formula);
    const Rational half(1, 2);
    if (const auto* sample = as_form<InTriangle>(formula);
        sample && sample->weights.sample.y.get_den() == 2) {
        InTriangle at_corner = *sample;
        at_corner.weights.sample = {sample->weights.sample.x - half,
                                    sample->weights.sample.y - half};
        results.add_formula({at_corner});
    }
    if (const auto* lerp = as_form<Lerp>(formula); lerp && lerp->i.get_den() == 2) {
        Lerp at_corner = *lerp;
        at_corner.i -= half;
        results.add_formula({at_corner});
    }
    if (const auto* triangle = as_form<Weights>(formula);
        triangle && triangle->sample.y.get_den() == 2) {
        Weights at_corner = *triangle;
        at_corner.sample = {triangle->sample.x - half, triangle->sample.y - half};
        results.add_formula({at_corner});
    }
    return results.take();
}

/// The same with another rule for what is rounded.
void put_rounded(SlipResults& results, const Formula& formula, const SpanRounding& rule) {
    if (const auto* end = as_form<RoundedEnd>(formula))
        results.add(end->by(rule));
    if (const auto* place = as_form<RoundedPlace>(formula))
        results.add(place->by(rule));
    if (const auto* row = as_form<InRow>(formula)) {
        InRow other = *row;
        other.from.rule = other.to.rule = rule;
        results.add_formula({other});
    }
}

/// The rule that a formula rounds by.
std::optional<Rounding> rounding_of(const Formula& formula) {
    if (const auto* end = as_form<RoundedEnd>(formula))
        return end->rule.rounding;
    if (const auto* place = as_form<RoundedPlace>(formula))
        return place->rule.rounding;
    if (const auto* row = as_form<InRow>(formula))
        return row->from.rule.rounding;
    return std::nullopt;
}

/// One rule instead of the textbook's, which takes the whole number below at both ends.
template <Rounding rounding> std::vector<SlipResult> instead_of_floor(const Formula& formula) {
    SlipResults results(formula);
    if (rounding_of(formula) == Rounding::floor)
        put_rounded(results, formula, {.rounding = rounding});
    return results.take();
}

std::vector<SlipResult> another_rounding(const Formula& formula) {
    SlipResults results(formula);
    for (const Rounding rounding : {Rounding::floor, Rounding::nearest, Rounding::truncate,
                                    Rounding::inside, Rounding::half_open})
        for (const Ties ties : {Ties::start, Ties::up, Ties::away, Ties::even})
            if (rounding_of(formula) != Rounding::floor)
                put_rounded(results, formula, {.rounding = rounding, .ties = ties});
    return results.take();
}

std::vector<SlipResult> integer_division(const Formula& formula) {
    SlipResults results(formula);
    if (as_form<Slope>(formula) && !results.right().empty())
        results.add(truncated(results.right().front()));
    if (const auto* lerp = as_form<Lerp>(formula))
        if (const auto slope = lerp->slope()) {
            Lerp whole = *lerp;
            whole.step = truncated(*slope);
            results.add_formula({whole});
        }
    if (const auto* product = as_form<MatrixTimes>(formula)) {
        MatrixTimes whole = *product;
        for (auto& row : whole.rows)
            for (Rational& factor : row)
                factor = truncated(factor);
        results.add_formula({whole});
    }
    return results.take();
}

/// The coordinates of a point in another order.
void exchange(SlipResults& results, const Values& values, std::size_t i, std::size_t j) {
    constexpr std::size_t most_coordinates = 4; // a matrix is no point
    if (std::max(i, j) >= values.size() || values.size() > most_coordinates)
        return;
    Values exchanged = values;
    std::swap(exchanged[i], exchanged[j]);
    results.add(std::move(exchanged));
}

/// True of a formula for a point or a vector.
bool gives_vector(const Formula& formula) {
    return as_form<TakenOver>(formula) || as_form<FaceNormal>(formula) ||
           as_form<Centroid>(formula) || as_form<Toward>(formula) ||
           as_form<MatrixTimes>(formula) || as_form<DividedByW>(formula);
}

std::vector<SlipResult> y_for_z(const Formula& formula) {
    SlipResults results(formula);
    if (gives_vector(formula) && results.right().size() >= 3)
        exchange(results, results.right(), 1, 2);
    return results.take();
}

std::vector<SlipResult> coordinates_exchanged(const Formula& formula) {
    SlipResults results(formula);
    if (!gives_vector(formula) && !as_form<Weights>(formula) && !as_form<RoundedPlace>(formula))
        return {};
    exchange(results, results.right(), 0, 1);
    exchange(results, results.right(), 0, 2);
    if (as_form<Weights>(formula))
        exchange(results, results.right(), 1, 2);
    return results.take();
}

std::vector<SlipResult> view_turned_round(const Formula& formula) {
    SlipResults results(formula);
    const bool has_view =
        as_form<Toward>(formula) || as_form<FaceDot>(formula) || as_form<FaceCosine>(formula);
    if (has_view) {
        results.add(negated(results.right()));
    }
    if (const auto* face = as_form<IsCulled>(formula))
        results.add_formula({IsCulled{-face->dot, face->hides_back}});
    return results.take();
}

std::vector<SlipResult> normal_for_view(const Formula& formula) {
    SlipResults results(formula);
    if (const auto* toward = as_form<Toward>(formula)) {
        const Vec3& n = toward->normal;
        results.add(n);
        results.add(Vec3{n.x, n.z, n.y}); // with y for z as well (T0, figures 22 to 24)
    }
    if (const auto* face = as_form<FaceDot>(formula))
        results.add_formula({FaceDot{face->normal, face->normal}});
    if (const auto* face = as_form<FaceCosine>(formula))
        results.add_formula({FaceCosine{face->normal, face->normal}});
    return results.take();
}

std::vector<SlipResult> corner_for_centroid(const Formula& formula) {
    SlipResults results(formula);
    if (const auto* toward = as_form<Toward>(formula))
        for (const Vec3& corner : toward->corners)
            results.add(toward->to - corner);
    if (const auto* face = as_form<Centroid>(formula))
        for (const Vec3& corner : face->corners)
            results.add(corner);
    return results.take();
}

std::vector<SlipResult> not_divided(const Formula& formula) {
    SlipResults results(formula);
    if (const auto* face = as_form<Centroid>(formula)) {
        const Vec3 mean = Centroid{face->corners}.value();
        const Rational count = static_cast<long>(face->corners.size());
        const Vec3 sum{mean.x * count, mean.y * count, mean.z * count};
        results.add(sum);
        results.add(Vec3{sum.x / 2, sum.y / 2, sum.z / 2});
    }
    if (const auto* division = as_form<DividedByW>(formula))
        results.add(Values{division->point[0], division->point[1], division->point[2]});
    if (const auto* edge = as_form<Slope>(formula))
        results.add(edge->to.x - edge->from.x);
    if (const auto* lerp = as_form<Lerp>(formula); lerp && !lerp->step)
        results.add(lerp->d1 + (lerp->d2 - lerp->d1) * (lerp->i - lerp->i1));
    if (const auto* triangle = as_form<Weights>(formula)) {
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
    SlipResults results(formula);
    const auto* face = as_form<FaceCosine>(formula);
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
    SlipResults results(formula);
    if (as_form<FaceCosine>(formula) && !results.right().empty()) {
        const double radians =
            std::acos(std::clamp(nearest_double(results.right().front()), -1.0, 1.0));
        results.add(Rational(radians));
        results.add(Rational(radians * 180 / std::numbers::pi));
    }
    return results.take();
}

std::vector<SlipResult> only_z_divided(const Formula& formula) {
    SlipResults results(formula);
    if (const auto* division = as_form<DividedByW>(formula))
        if (const auto z = division->value(2)) {
            results.add(Values{division->point[0], division->point[1], *z});
            results.add(Values{*division->value(0), *division->value(1), division->point[2]});
        }
    return results.take();
}

std::vector<SlipResult> z_for_inverse_z(const Formula& formula) {
    SlipResults results(formula);
    const auto inverted = [&results](const Values& values) {
        if (!values.empty())
            results.add(divided(1, values.front()));
    };
    if (const auto* lerp = as_form<Lerp>(formula); lerp && lerp->is_inverse_z) {
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
    if (const auto* mixed = as_form<MixedDepth>(formula)) {
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
    if (const auto* test = as_form<DepthComparison>(formula))
        if (sgn(test->depth) != 0 && sgn(test->stored) != 0)
            results.add_formula(
                {DepthComparison{1 / test->depth, 1 / test->stored, test->larger_passes}});
    return results.take();
}

std::vector<SlipResult> three_corners(const Formula& formula) {
    SlipResults results(formula);
    if (const auto* face = as_form<FaceNormal>(formula); face && face->corners.size() > 3)
        results.add_formula({FaceNormal{{face->corners.begin(), face->corners.begin() + 3}}});
    if (const auto* face = as_form<Centroid>(formula); face && face->corners.size() > 3)
        results.add_formula({Centroid{{face->corners.begin(), face->corners.begin() + 3}}});
    return results.take();
}

std::vector<SlipResult> c_minus_a(const Formula& formula) {
    SlipResults results(formula);
    // Both coordinates of another corner, or one alone: dx of one edge over dy of another.
    if (const auto* edge = as_form<Slope>(formula); edge && edge->other)
        for (const Vec2& other :
             {*edge->other, Vec2{edge->other->x, edge->to.y}, Vec2{edge->to.x, edge->other->y}})
            results.add_formula({Slope{edge->from, other}});
    if (const auto* edge = as_form<Slope>(formula); edge && edge->other)
        for (const Vec2& other :
             {*edge->other, Vec2{edge->other->x, edge->from.y}, Vec2{edge->from.x, edge->other->y}})
            results.add_formula({Slope{other, edge->to}});
    if (const auto* lerp = as_form<Lerp>(formula); lerp && lerp->other) {
        const auto& [d, i] = *lerp->other;
        results.add_formula({Lerp{.d1 = lerp->d1, .i1 = lerp->i1, .d2 = d, .i2 = i, .i = lerp->i}});
        results.add_formula({Lerp{.d1 = d, .i1 = i, .d2 = lerp->d2, .i2 = lerp->i2, .i = lerp->i}});
        for (const auto& [dd, di] :
             {std::pair(Rational(d - lerp->d1), Rational(lerp->i2 - lerp->i1)),
              std::pair(Rational(lerp->d2 - lerp->d1), Rational(i - lerp->i1))}) {
            Lerp mixed = *lerp;
            mixed.step = divided(dd, di);
            if (mixed.step)
                results.add_formula({mixed});
        }
    }
    if (const auto* face = as_form<FaceNormal>(formula)) {
        const Vec3& a = face->corners[0];
        const Vec3& b = face->corners[1];
        const Vec3& c = face->corners[2];
        for (const Vec3& wrong : {cross(b, c),                             // nothing taken away
                                  cross(b - a, c),                         // only from one of them
                                  cross(b, c - a), cross(b - a, a - c)}) { // A - C
            results.add(wrong);
            const Values components{wrong.x, wrong.y, wrong.z};
            for (std::size_t i = 0; i < 3; ++i) {
                Values one = results.right();
                one[i] = components[i];
                results.add(std::move(one));
            }
        }
    }
    return results.take();
}

/// A sum of products with one of them left out, or with the other sign.
void put_sums(SlipResults& results, const std::vector<std::vector<Rational>>& sums,
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
    if (const auto* product = as_form<MatrixTimes>(formula))
        for (const auto& row : product->rows) {
            sums.emplace_back();
            for (std::size_t k = 0; k < 4; ++k)
                sums.back().push_back(row[k] * product->point[k]);
        }
    if (const auto* face = as_form<FaceDot>(formula))
        sums = {std::vector<Rational>{face->normal.x * face->view.x, face->normal.y * face->view.y,
                                      face->normal.z * face->view.z}};
    if (const auto* face = as_form<FaceNormal>(formula); face && face->corners.size() == 3) {
        const Vec3 u = face->corners[1] - face->corners[0];
        const Vec3 v = face->corners[2] - face->corners[0];
        sums = {{u.y * v.z, -(u.z * v.y)}, {u.z * v.x, -(u.x * v.z)}, {u.x * v.y, -(u.y * v.x)}};
    }
    if (const auto* toward = as_form<Toward>(formula))
        sums = {{toward->to.x, -toward->centroid.x},
                {toward->to.y, -toward->centroid.y},
                {toward->to.z, -toward->centroid.z}};
    if (const auto* lerp = as_form<Lerp>(formula))
        if (const auto slope = lerp->slope())
            sums = {std::vector<Rational>{lerp->d1, *slope * lerp->i, -(*slope * lerp->i1)}};
    if (const auto* line = as_form<LineForm>(formula))
        if (const Values right = value_of(formula); !right.empty()) {
            const auto& [x, y] = line->is_of_y ? std::pair(line->from.y, line->from.x)
                                               : std::pair(line->from.x, line->from.y);
            sums = {{}, {y, -(right.front() * x)}}; // b = y1 - m x1
        }
    if (const auto* mixed = as_form<MixedDepth>(formula); mixed && !mixed->gives_inverse) {
        sums.emplace_back();
        for (std::size_t i = 0; i < mixed->depths.size(); ++i)
            sums.back().push_back(mixed->weights[i] * mixed->depths[i]);
    }
    return sums;
}

std::vector<SlipResult> term_dropped(const Formula& formula) {
    SlipResults results(formula);
    put_sums(results, terms_of(formula), 0);
    return results.take();
}

/// A LERP whose step is (d2 - d2) / (i2 - i1) (T0).
std::vector<SlipResult> slope_of_zero(const Formula& formula) {
    SlipResults results(formula);
    if (const auto* lerp = as_form<Lerp>(formula))
        results.add(lerp->d1);
    return results.take();
}

std::vector<SlipResult> sign(const Formula& formula) {
    SlipResults results(formula);
    const Values& right = results.right();
    if (as_form<IsCulled>(formula) || as_form<InRow>(formula) ||
        as_form<DepthComparison>(formula) || as_form<BresenhamDecisions>(formula) || right.empty())
        return {};
    // That all of it is turned round has its own name where there is a view.
    const bool has_view =
        as_form<Toward>(formula) || as_form<FaceDot>(formula) || as_form<FaceCosine>(formula);
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
    if (const auto* edge = as_form<Slope>(formula))
        for (Rational Vec2::*axis : {&Vec2::x, &Vec2::y})
            for (Vec2 Slope::*end : {&Slope::from, &Slope::to}) {
                Slope other = *edge;
                other.*end.*axis = -(other.*end.*axis);
                results.add_formula({other});
            }
    if (const auto* lerp = as_form<Lerp>(formula)) {
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

std::vector<SlipResult> edge_the_other_way(const Formula& formula) {
    SlipResults results(formula);
    if (const auto* sample = as_form<InTriangle>(formula)) {
        InTriangle other = *sample;
        other.has_its_edge = !other.has_its_edge;
        results.add_formula({other});
    }
    return results.take();
}

constexpr Words scenes_own_rule("the scene's own rule");

constexpr Slip other_slips[] = {
    {"truncate-for-floor", as_mistake, as_mistake, as_mistake, 150,
     instead_of_floor<Rounding::truncate>},
    {"nearest-for-floor", as_mistake, as_mistake, as_mistake, 120,
     instead_of_floor<Rounding::nearest>},
    {"inside-for-floor", as_mistake, as_mistake, as_mistake, 80,
     instead_of_floor<Rounding::inside>},
    {"half-open-for-floor", as_mistake, as_mistake, as_mistake, 80,
     instead_of_floor<Rounding::half_open>},
    {"dx-dy-inverted", as_mistake, as_mistake, as_mistake, 70, dx_dy_inverted},
    {"dy-dx-inverted", "(x2 - x1) / (y2 - y1)", "(y2 - y1) / (x2 - x1)",
     "steep edges lie flat, flat ones are steep", 70, dy_dx_inverted},
    {"edge-the-other-way", "a sample on an edge decided the other way", scenes_own_rule,
     "pixels on edges are missing, or drawn twice", 800, edge_the_other_way},
    {"byte-cast", "cutting a level off to a whole number, or rounding it", scenes_own_rule,
     as_mistake, 40, byte_cast},
    {"color-by-distance", "the color by the distance, or by the steps on the screen",
     scenes_own_rule, as_mistake, 20, color_by_other_share},
    {"share-the-other-way", "the share from the other end, or 1 over it",
     "the share from the first end", "the colors run the wrong way", 60, share_the_other_way},
    {"z-for-inverse-z", "z itself, or z in a straight line", "1/z in a straight line", as_mistake,
     60, z_for_inverse_z},
    {"start-and-step-exchanged", as_mistake, as_mistake, as_mistake, 20, start_and_step_exchanged},
    {"y-for-z", "z in the place of y", "y", "what points away points up", 20, y_for_z},
    {"view-turned-round", as_mistake, as_mistake, as_mistake, 40, view_turned_round},
    {"cosine-of-dot-only", "the dot product alone", "the dot product divided by both lengths",
     as_mistake, 80, cosine_of_dot_only},
    {"normal-for-view", "the normal once more", "the view", "no face is turned away", 10,
     normal_for_view},
    {"corner-for-center", as_mistake, as_mistake, as_mistake, 40, corner_for_center},
    {"corner-for-centroid", "a corner", "the centroid",
     "faces near the silhouette are culled wrongly", 15, corner_for_centroid},
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
    {"slope-of-zero", as_mistake, as_mistake, as_mistake, 25, slope_of_zero},
    {"three-corners", "three corners of a polygon", "all of its corners",
     "the normal of a bent face leans", 150, three_corners},
    {"c-minus-a", "another corner", "the edge's own corner", "the edge of another pair of vertices",
     15, c_minus_a},
    {"pixel-for-end", "the pixel", "the exact end of the row",
     "whole numbers where fractions belong", 18, pixel_for_end},
    {"integer-division", as_mistake, as_mistake, as_mistake, 20, integer_division},
    {"coordinates-exchanged", "two coordinates exchanged", "x, y, z in this order",
     "mirrored at a diagonal", 15, coordinates_exchanged},
    {"angle-for-cosine", "the angle", "its cosine", "numbers beyond 1", 15, angle_for_cosine},
    {"another-rounding", "another rule for rounding", "the scene's own", "ends one pixel beside",
     30, another_rounding},
};

std::string meaning_of(const Words& done, const Words& instead_of, std::string_view detail) {
    const Language language = language_of_steps();
    return said("{}{}{}{} instead of {}", done.in(language), detail.empty() ? "" : " (", detail,
                detail.empty() ? "" : ")", instead_of.in(language));
}

} // namespace

std::string meaning_of(const Slip& slip, std::string_view detail) {
    return meaning_of(slip.done, slip.instead_of, detail);
}

std::string meaning_of(std::string_view name) {
    if (const Slip* const slip = find_slip(name))
        return meaning_of(*slip);
    const Mistake* const mistake = find_mistake(name);
    return mistake == nullptr   ? ""
           : mistake->is_rule() ? std::string(Words(mistake->says).in(language_of_steps()))
                                : meaning_of(Words(mistake->says), Words(mistake->should), {});
}

std::span<const Slip> slips() {
    static const std::vector<Slip> all = [] {
        std::vector<Slip> rows(std::begin(other_slips), std::end(other_slips));
        for (const std::span<const Slip> more : {slips_of_lines(), slips_of_matrices()})
            rows.insert(rows.end(), more.begin(), more.end());
        for (Slip& row : rows)
            if (const Mistake* const mistake = find_mistake(row.name)) {
                if (row.done.in(Language::english).empty())
                    row.done = Words(mistake->says);
                if (row.instead_of.in(Language::english).empty())
                    row.instead_of = Words(mistake->should);
                if (row.symptom.empty())
                    row.symptom = mistake->symptom;
            }
        return rows;
    }();
    return all;
}

const Slip* find_slip(std::string_view name) {
    const auto all = slips();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Slip& slip) { return slip.name == name; });
    return found == all.end() ? nullptr : &*found;
}

} // namespace rastertrace
