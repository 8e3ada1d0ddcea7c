// SPDX-License-Identifier: MIT
#include "formula.h"

#include "sheet.h"
#include "step_text.h"

#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/core/raster/facing.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace rastertrace {

namespace {

Values components(const Vec3& v) {
    return {v.x, v.y, v.z};
}

Values truth(bool value) {
    return {Rational(value ? 1 : 0)};
}

Values value(const TakenOver& number) {
    return number.values;
}

Values value(const Slope& edge) {
    const auto slope = Lerp{.d1 = edge.from.x,
                            .i1 = edge.from.y,
                            .d2 = edge.to.x,
                            .i2 = edge.to.y,
                            .i = edge.from.y}
                           .slope();
    return slope ? Values{*slope} : Values{};
}

Values value(const Lerp& lerp) {
    return {lerp.value()};
}

Values value(const RoundedEnd& end) {
    return {end.by(end.rule)};
}

Values value(const RoundedPlace& place) {
    return place.by(place.rule);
}

Values value(const InRow& row) {
    return truth(row.from.by(row.from.rule) <= row.x && row.x <= row.to.by(row.to.rule));
}

Values value(const FaceNormal& face) {
    return components(face.value());
}

Values value(const Centroid& face) {
    return components(face.value());
}

Values value(const FacePlane& plane) {
    Values of = components(plane.normal);
    of.push_back(plane.constant());
    return of;
}

Values value(const Toward& toward) {
    return components(toward.to - toward.centroid);
}

Values value(const FaceDot& face) {
    return {face.value()};
}

Values value(const FaceCosine& face) {
    const auto cosine = face.value();
    if (!cosine)
        return {};
    return {face.is_intensity ? std::max(*cosine, Rational(0)) : *cosine};
}

Values value(const IsCulled& face) {
    return truth(face.hides_back ? sgn(face.dot) <= 0 : sgn(face.dot) >= 0);
}

Values value(const MatrixTimes& product) {
    Values of;
    for (std::size_t row = 0; row < product.rows.size(); ++row)
        of.push_back(product.value(row));
    return of;
}

Values value(const DividedByW& division) {
    Values of;
    for (std::size_t i = 0; i < 3; ++i)
        if (auto component = division.value(i))
            of.push_back(std::move(*component));
    return of;
}

Values value(const BresenhamDecisions& line) {
    constexpr std::size_t most_steps = 1000; // no hand works more out
    Values of;
    if (line.steps > most_steps)
        return of;
    Rational d = line.start();
    for (std::size_t i = 0; i < line.steps; ++i) {
        of.push_back(d);
        d = line.next(d);
    }
    return of;
}

Values value(const LinePixels& line) {
    Vec2 at = line.from;
    Values of{at.x, at.y};
    for (const Rational& d : value(line.decisions)) {
        const Vec2& step = line.decisions.is_diagonal(d) ? line.diagonal : line.straight;
        at = {at.x + step.x, at.y + step.y};
        of.insert(of.end(), {at.x, at.y});
    }
    return of;
}

Values value(const LineForm& line) {
    const auto form = slope_form_of({line.from, line.to}, !line.is_of_y);
    return form ? Values{form->m, form->b} : Values{};
}

Values value(const InclusiveCount& count) {
    return {count.last - count.first + 1};
}

Values value(const MixedColor& mixed) {
    Values levels;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        Rational level = mixed.is_cut ? Rational(0) : Rational(1, 2);
        for (std::size_t i = 0; i < mixed.corners.size(); ++i)
            level += mixed.weights[i] * mixed.corners[i].of[channel];
        levels.emplace_back(mpz_class(level.get_num() / level.get_den()));
    }
    return levels;
}

Values value(const MixedDepth& mixed) {
    const Rational depth = mixed.depth();
    if (!mixed.gives_inverse)
        return {depth};
    return sgn(depth) == 0 ? Values{} : Values{1 / depth};
}

Values value(const DepthComparison& test) {
    return truth(test.larger_passes ? test.depth > test.stored : test.depth < test.stored);
}

Values value(const Weights& triangle) {
    const auto weights = triangle.value();
    return weights ? Values(weights->begin(), weights->end()) : Values{};
}

Values value(const InTriangle& sample) {
    const auto weights = sample.weights.value();
    if (!weights)
        return {};
    const int least = sgn(*std::min_element(weights->begin(), weights->end()));
    return truth(least > 0 || (least == 0 && sample.has_its_edge));
}

} // namespace

std::optional<Rational> Lerp::slope() const {
    if (step)
        return step;
    return i1 == i2 ? std::nullopt : std::optional<Rational>((d2 - d1) / (i2 - i1));
}

Rational Lerp::value() const {
    const auto quotient = slope();
    return quotient ? Rational(d1 + *quotient * (i - i1)) : d1;
}

std::string Lerp::written_out(const Rational& result) const {
    const std::string start = plus(text(d1));
    return fmt::format("({} {})/({} {}) ({} {}) {} = {} {} = {}", text(d2), minus(text(d1)),
                       text(i2), minus(text(i1)), text(i), minus(text(i1)), start,
                       product(*slope(), i - i1), start, text(result));
}

Vec3 FaceNormal::value() const {
    return normal_of<Rational>(corners);
}

std::string cross_written_out(const Vec3& a, const Vec3& b) {
    return fmt::format("({} - {}, {} - {}, {} - {})", product(a.y, b.z), product(a.z, b.y),
                       product(a.z, b.x), product(a.x, b.z), product(a.x, b.y), product(a.y, b.x));
}

std::string FaceNormal::written_out() const {
    std::string terms;
    for (std::size_t i = 2; i < corners.size(); ++i)
        terms += (i == 2 ? "" : " + ") +
                 cross_written_out(corners[i - 1] - corners[0], corners[i] - corners[0]);
    return terms;
}

Vec3 Centroid::value() const {
    return centroid_of<Rational>(corners);
}

Rational FacePlane::constant() const {
    return -dot(normal, corner);
}

std::string FacePlane::written_out() const {
    return fmt::format("{} x {} y {} z {} = 0", text(normal.x), plus(text(normal.y)),
                       plus(text(normal.z)), minus(text(dot(normal, corner))));
}

Rational FaceDot::value() const {
    return dot(normal, view);
}

std::string FaceDot::written_out() const {
    return fmt::format("{} + {} + {} = {}", product(normal.x, view.x), product(normal.y, view.y),
                       product(normal.z, view.z), text(value()));
}

std::optional<Rational> FaceCosine::value(RootDigits digits) const {
    const Rational squares = FaceDot{normal, normal}.value() * FaceDot{view, view}.value();
    if (!std::isnormal(nearest_double(squares)))
        return std::nullopt;
    return Rational(dot.value_or(FaceDot{normal, view}.value()) / square_root(squares, digits));
}

std::string FaceCosine::written_out(std::string_view name_of_view) const {
    const double cosine = std::clamp(nearest_double(*value()), -1.0, 1.0);
    return fmt::format("{} / (|normal| |{}|) = {}",
                       text(dot.value_or(FaceDot{normal, view}.value())), name_of_view,
                       six_places(cosine));
}

Rational MatrixTimes::value(std::size_t row) const {
    return std::inner_product(rows[row].begin(), rows[row].end(), point.begin(), Rational(0));
}

std::string MatrixTimes::written_out(std::size_t row) const {
    const auto& entries = rows[row];
    return fmt::format("{} + {} + {} + {}", product(entries[0], point[0]),
                       product(entries[1], point[1]), product(entries[2], point[2]),
                       product(entries[3], point[3]));
}

std::optional<Rational> DividedByW::value(std::size_t component) const {
    return sgn(point[3]) == 0 ? std::nullopt : std::optional<Rational>(point[component] / point[3]);
}

Rational BresenhamDecisions::start() const {
    if (other_start)
        return *other_start;
    return factor_at_start * minor - major;
}

Rational BresenhamDecisions::straight() const {
    if (other_straight)
        return *other_straight;
    return factor_in_steps * minor;
}

Rational BresenhamDecisions::diagonal() const {
    if (other_diagonal)
        return *other_diagonal;
    return factor_in_steps * Rational(minor - major);
}

bool BresenhamDecisions::is_diagonal(const Rational& d) const {
    return sgn(d) > 0 || (sgn(d) == 0 && steps_at_ties);
}

Rational BresenhamDecisions::next(const Rational& d) const {
    return d + (is_diagonal(d) ? diagonal() : straight());
}

std::string BresenhamDecisions::written_out(const Rational& d) const {
    const Rational after = next(d);
    return fmt::format("{} {} = {}", text(d), plus(text(after - d)), text(after));
}

Rational MixedDepth::depth() const {
    return std::inner_product(weights.begin(), weights.end(), depths.begin(), Rational(0));
}

std::string MixedDepth::written_out(const Rational& result) const {
    std::string terms;
    for (std::size_t i = 0; i < weights.size(); ++i)
        terms += (i == 0 ? "" : " + ") + product(weights[i], depths[i]);
    return fmt::format("{} = {}", terms, text(result));
}

Vec3 Weights::xs() const {
    const auto& [a, b, c] = corners;
    return {b.x - a.x, c.x - a.x, a.x - sample.x};
}

Vec3 Weights::ys() const {
    const auto& [a, b, c] = corners;
    return {b.y - a.y, c.y - a.y, a.y - sample.y};
}

Vec3 Weights::areas() const {
    return cross(xs(), ys());
}

std::optional<std::array<Rational, 3>> Weights::value() const {
    const auto [of_b, of_c, whole] = areas();
    if (sgn(whole) == 0)
        return std::nullopt;
    const Rational u = of_b / whole;
    const Rational v = of_c / whole;
    return {{1 - u - v, u, v}};
}

std::string Weights::written_out() const {
    return fmt::format("{} x {} = {}", text(xs()), text(ys()), text(areas()));
}

Rational RoundedEnd::by(const SpanRounding& other) const {
    return Rational(is_last ? last_pixel(x, other) : first_pixel(x, other));
}

Values RoundedPlace::by(const SpanRounding& other) const {
    Values rounded;
    for (const Rational& x : at)
        rounded.emplace_back(first_pixel(x, other));
    return rounded;
}

namespace {

/// Words in the language of steps.
std::string_view told(const Words& words) {
    return words.in(language_of_steps());
}

FormulaRule rule(const TakenOver&) {
    return {told("nothing moves the vertex between these spaces"), told("(x, y, z) as before")};
}
FormulaRule rule(const Slope&) {
    return {told("how far an edge goes in x for one row"), "dx/dy = (x2 - x1) / (y2 - y1)"};
}
FormulaRule rule(const Lerp&) {
    return {told("on the line from one vertex to the other, at this row or column"),
            "d = (d2 - d1) / (i2 - i1) (i - i1) + d1"};
}
FormulaRule rule(const RoundedEnd& end) {
    switch (end.rule.rounding) {
    case Rounding::floor:
        return {told("an end of a row is rounded down to its pixel"), "floor(x)"};
    case Rounding::nearest:
        return {told("an end of a row is rounded to the nearest pixel"), "floor(x + 1/2)"};
    case Rounding::truncate:
        return {told("an end of a row is rounded toward 0 to its pixel"),
                told("x without its fraction")};
    case Rounding::inside:
        return {told("a row has the pixels between its ends"), told("ceil(left), floor(right)")};
    case Rounding::half_open:
        break;
    }
    return {told("a row has the pixels from its left end on, up to the one before its right end"),
            told("ceil(left), ceil(right) - 1")};
}
FormulaRule rule(const RoundedPlace&) {
    return {told("a vertex becomes a pixel: each of its coordinates is rounded"),
            "(round(x), round(y))"};
}
FormulaRule rule(const InRow&) {
    return {told("a row has the pixels from its first to its last"), told("first <= x <= last")};
}
FormulaRule rule(const FaceNormal&) {
    return {told("the normal is at right angles to two sides"), "(B - A) x (C - A)"};
}
FormulaRule rule(const Centroid&) {
    return {told("the mean of the corners"), "(A + B + C) / 3"};
}
FormulaRule rule(const FacePlane&) {
    return {told("a plane is its normal and a point"),
            told("A x + B y + C z + D = 0, D = -(normal . corner)")};
}
FormulaRule rule(const Toward&) {
    return {told("from the centroid of the face to the eye, or to the light"),
            told("eye - centroid")};
}
FormulaRule rule(const FaceDot&) {
    return {told("the sum of the products of the components"), "nx vx + ny vy + nz vz"};
}
FormulaRule rule(const FaceCosine&) {
    return {told("the dot product, divided by both lengths"),
            told("normal . view / (|normal| |view|)")};
}
FormulaRule rule(const IsCulled& face) {
    return face.hides_back ? FormulaRule{told("a face that is turned away from the eye is culled"),
                                         told("normal . view <= 0")}
                           : FormulaRule{told("a face that is turned to the eye is culled"),
                                         told("normal . view >= 0")};
}
FormulaRule rule(const MatrixTimes&) {
    return {told("a row of the matrix times the point"), "m1 x + m2 y + m3 z + m4 w"};
}
FormulaRule rule(const DividedByW&) {
    return {told("each coordinate is divided by w"), "(x/w, y/w, z/w)"};
}
FormulaRule rule(const BresenhamDecisions&) {
    return {told("above 0, d steps diagonally, else straight on"),
            told("d = 2 dy - dx; then + 2 dy, or diagonally + 2 (dy - dx)")};
}
FormulaRule rule(const LinePixels& line) {
    return rule(line.decisions);
}
FormulaRule rule(const LineForm& line) {
    return line.is_of_y ? FormulaRule{told("a line by its slope dx/dy, and its x where y = 0"),
                                      "x = m y + b, m = (x2 - x1) / (y2 - y1), b = x1 - m y1"}
                        : FormulaRule{told("a line by its slope dy/dx, and its y where x = 0"),
                                      "y = m x + b, m = (y2 - y1) / (x2 - x1), b = y1 - m x1"};
}
FormulaRule rule(const InclusiveCount&) {
    return {told("the first and the last count, too"), told("last - first + 1")};
}
FormulaRule rule(const MixedColor& mixed) {
    return {told("each color by its weight, channel by channel, then a whole level"),
            mixed.is_cut ? "floor(w1 c1 + w2 c2 + ...)" : "floor(w1 c1 + w2 c2 + ... + 1/2)"};
}
FormulaRule rule(const MixedDepth&) {
    return {told("the depths at the ends or corners, each by its weight"), "w1 d1 + w2 d2 + ..."};
}
FormulaRule rule(const DepthComparison& test) {
    return test.larger_passes
               ? FormulaRule{told("the nearer one passes: the larger 1/z"), told("depth > stored")}
               : FormulaRule{told("the nearer one passes: the smaller z"), told("depth < stored")};
}
FormulaRule rule(const Weights&) {
    return {told("the areas that the sample makes with two corners each, divided by the whole"),
            told("(ABx, ACx, PAx) x (ABy, ACy, PAy), divided by its third component")};
}
FormulaRule rule(const InTriangle&) {
    return {told("a sample lies in a triangle if none of its weights is negative"),
            "w1, w2, w3 >= 0"};
}

} // namespace

FormulaRule rule_of(const Formula& formula) {
    return std::visit([](const auto& of) { return rule(of); }, formula.of);
}

Values value_of(const Formula& formula) {
    return std::visit([](const auto& of) { return value(of); }, formula.of);
}

} // namespace rastertrace
