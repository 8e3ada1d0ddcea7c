// SPDX-License-Identifier: MIT
// Mistakes that are made on purpose, in random scenes, and named. They are made here, from the numbers of the
// trace, and not by the table that is to find them.

#include "claims_support.h"
#include "effort.h"
#include "random_choice.h"
#include "random_scene.h"
#include "traces.h"

#include <rastertrace/core/draw/model/mistakes.h>
#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/check/slips.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/told_samples.h>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

/// A claim with a mistake in it.
struct Planted {
    std::string slip;
    std::string claim; ///< JSON
};

std::vector<Rational> rationals(const TracedList<TracedNumber>& list) {
    std::vector<Rational> numbers;
    for (const TracedNumber& number : list.values())
        numbers.push_back(*number.exact());
    return numbers;
}

std::string quoted(const Rational& number) {
    return '"' + number.get_str() + '"';
}

std::string quoted(const std::vector<Rational>& numbers) {
    std::string text;
    for (const Rational& number : numbers)
        text += (text.empty() ? "[" : ",") + quoted(number);
    return text + "]";
}

/// A trace, and which step of a kind a mistake is made in.
struct Place {
    const Trace& trace;
    std::size_t n;
    std::size_t primitive; ///< its step; 0 for none

    template <typename Step> Step step() const { return trace.step(n).as<Step>(); }
    PrimitiveStep owner() const { return trace.step(primitive).as<PrimitiveStep>(); }

    /// The corner of the primitive with this name.
    std::vector<Rational> corner(char name) const {
        const auto names = owner().vertices.texts();
        const auto at = owner().at.values();
        for (std::size_t i = 0; i < names.size() && i < at.size(); ++i)
            if (names[i] == std::string(1, name))
                return rationals(at[i]);
        return {};
    }

    std::string in() const { return R"("in":")" + owner().name.text() + R"(",)"; }

    std::string row_claim(const std::string& field, const Rational& value) const {
        return R"({"step":"scanline",)" + in() + R"("y":)" +
               std::to_string(step<ScanlineStep>().y) + ",\"" + field + "\":" + quoted(value) + "}";
    }
    std::string face_claim(const std::string& field, const std::string& value) const {
        return R"({"step":"face","name":")" + step<FaceStep>().name.text() + "\",\"" + field +
               "\":" + value + "}";
    }
};

using Result = std::optional<Planted>;

/// The LERP of a row's left end: x1, y1, x2, y2 and y, if it has an edge that climbs.
struct RowEnd {
    Rational x1, y1, x2, y2, y;
    Rational slope() const { return (x2 - x1) / (y2 - y1); }
    Rational x() const { return x1 + slope() * (y - y1); }
};
std::optional<RowEnd> left_end(const Place& place) {
    const auto row = place.step<ScanlineStep>();
    const std::string edge = row.left_edge.text();
    if (edge.size() != 2)
        return std::nullopt;
    const auto from = place.corner(edge[0]);
    const auto to = place.corner(edge[1]);
    if (from.empty() || to.empty() || from[1] == to[1])
        return std::nullopt;
    const Rational offset = told_samples(place.trace).triangles.x();
    return RowEnd{from[0], from[1], to[0], to[1], Rational(row.y) + offset};
}

Result planted_row(const Place& place, const std::string& slip, const Rational& wrong) {
    return place.step<ScanlineStep>().left.exact() == wrong
               ? std::nullopt
               : Result({slip, place.row_claim("left", wrong)});
}

Result invert_slope(const Place& place) {
    const auto end = left_end(place);
    if (!end || end->x1 == end->x2)
        return std::nullopt;
    return planted_row(place, "dx-dy-inverted", end->x1 + (end->y - end->y1) / end->slope());
}

Result exchange_start_and_step(const Place& place) {
    const auto end = left_end(place);
    return end ? planted_row(place, "start-and-step-exchanged",
                             end->slope() + end->x1 * (end->y - end->y1))
               : std::nullopt;
}

Result take_the_row_above(const Place& place) {
    const auto end = left_end(place);
    return end ? planted_row(place, "neighbor-row", end->x() + end->slope()) : std::nullopt;
}

Result forget_the_start(const Place& place) {
    const auto end = left_end(place);
    return end ? planted_row(place, "term-dropped", end->slope() * (end->y - end->y1))
               : std::nullopt;
}

Result lose_the_minus(const Place& place) {
    return planted_row(place, "sign", -*place.step<ScanlineStep>().left.exact());
}

Result cut_off(const Place& place) {
    const Rational x =
        told_samples(place.trace).triangles.in_columns(*place.step<ScanlineStep>().left.exact());
    const std::string rounding = place.trace.method.word_of("rounding");
    if (place.trace.method.word_of("fill") == "top-left" || // it asks samples
        rounding.substr(0, rounding.find('+')) != "floor" || sgn(x) >= 0 || x.get_den() == 1)
        return std::nullopt;
    const mpz_class toward_zero = x.get_num() / x.get_den();
    return Planted{"truncate-for-floor", place.row_claim("from", Rational(toward_zero))};
}

/// dx/dy of an edge whose other corners somebody takes: `wrong` gets both ends of the edge, and the third corner.
Result take_for_slope(const Place& place, const auto& wrong) {
    const auto step = place.step<EdgeStep>();
    const std::string edge = step.edge.text();
    const auto names = place.owner().vertices.texts();
    if (edge.size() != 2 || names.size() != 3 || !step.dx_dy.has_number())
        return std::nullopt;
    for (const std::string& name : names) {
        if (name.size() != 1 || edge.find(name) != std::string::npos)
            continue;
        const auto from = place.corner(edge[0]);
        const auto to = place.corner(edge[1]);
        const auto other = place.corner(name[0]);
        if (from.empty() || to.empty() || other.empty() || from[1] == other[1])
            return std::nullopt;
        const Rational slope = wrong(from, to, other);
        if (slope == step.dx_dy.exact())
            return std::nullopt;
        return Planted{"c-minus-a", R"({"step":"edge",)" + place.in() + R"("edge":")" + edge +
                                        R"(","dx_dy":)" + quoted(slope) + "}"};
    }
    return std::nullopt;
}

/// An edge of a triangle from its upper end to the third corner.
Result take_another_corner(const Place& place) {
    return take_for_slope(place, [](const auto& from, const auto& /*to*/, const auto& other) {
        return Rational((other[0] - from[0]) / (other[1] - from[1]));
    });
}

/// dx of an edge over dy of the one from its upper end to the third corner.
Result take_dy_of_another_edge(const Place& place) {
    return take_for_slope(place, [](const auto& from, const auto& to, const auto& other) {
        return Rational((to[0] - from[0]) / (other[1] - from[1]));
    });
}

/// y = m x + b with b = y1.
Result forget_m_x_in_b(const Place& place) {
    const std::string edge = place.step<EdgeStep>().edge.text();
    if (edge.size() != 2)
        return std::nullopt;
    const auto from = place.corner(edge[0]);
    const auto to = place.corner(edge[1]);
    if (from.empty() || to.empty() || from[0] == to[0] || from[1] == to[1] || sgn(from[0]) == 0)
        return std::nullopt;
    const Rational m = (to[1] - from[1]) / (to[0] - from[0]);
    return Planted{"term-dropped", R"({"step":"edge",)" + place.in() + R"("edge":")" + edge +
                                       R"(","y_form":)" + quoted({m, from[1]}) + "}"};
}

Result exchange_y_and_z(const Place& place) {
    auto normal = rationals(place.step<FaceStep>().normal);
    if (normal.size() != 3 || normal[1] == normal[2])
        return std::nullopt;
    std::swap(normal[1], normal[2]);
    return Planted{"y-for-z", place.face_claim("normal", quoted(normal))};
}

Result turn_the_view_round(const Place& place) {
    const Rational dot = *place.step<FaceStep>().dot.exact();
    if (sgn(dot) == 0)
        return std::nullopt;
    return Planted{"view-turned-round", place.face_claim("dot", quoted(-dot))};
}

Result forget_the_lengths(const Place& place) {
    const auto step = place.step<FaceStep>();
    const Rational dot = *step.dot.exact();
    if (step.cosine.json() == "null" || dot == 0)
        return std::nullopt;
    return Planted{"cosine-of-dot-only", place.face_claim("cosine", quoted(dot))};
}

std::string vertex_claim(const VertexStep& step, const std::vector<Rational>& at) {
    return R"({"step":"vertex","name":")" + step.name.text() + R"(","space":")" +
           step.space.text() + R"(","at":)" + quoted(at) + "}";
}

/// The step before, which is of the same vertex in the space that it comes from.
std::vector<Rational> place_before(const Place& place) {
    if (place.trace.kind_of(place.n - 1) != StepKind::vertex)
        return {};
    const auto before = place.trace.step(place.n - 1).as<VertexStep>();
    const bool is_same = before.name == place.step<VertexStep>().name;
    return is_same ? rationals(before.at) : std::vector<Rational>{};
}

Result forget_to_divide(const Place& place) {
    const auto step = place.step<VertexStep>();
    auto clip = place_before(place);
    if (step.space != Space::canonical || clip.size() != 4)
        return std::nullopt;
    clip.pop_back();
    if (clip == rationals(step.at))
        return std::nullopt;
    return Planted{"not-divided", vertex_claim(step, clip)};
}

/// A translation that is forgotten in y.
Result forget_to_move(const Place& place) {
    const std::map<std::string, std::string> matrices{
        {"world", "model"}, {"camera", "view"}, {"screen", "viewport"}};
    const auto vertex = place.step<VertexStep>();
    const auto name = matrices.find(vertex.space.text());
    auto at = rationals(vertex.at);
    if (name == matrices.end() || place_before(place).empty())
        return std::nullopt;
    std::optional<Rational> moved;
    int found = 0;
    for (std::size_t n = 1; n <= place.trace.size(); ++n)
        if (place.trace.kind_of(n) == StepKind::matrix) {
            const auto matrix = place.trace.step(n).as<MatrixStep>();
            if (matrix.name != name->second)
                continue;
            moved = rationals(matrix.rows.values()[1])[3];
            ++found;
        }
    if (found != 1 || sgn(*moved) == 0)
        return std::nullopt;
    at[1] -= *moved;
    return Planted{"term-dropped", vertex_claim(vertex, at)};
}

Result take_z_for_its_inverse(const Place& place) {
    const auto step = place.step<DepthStep>();
    const Rational depth = *step.depth.exact();
    const std::string fill = place.trace.method.word_of("fill");
    if (place.trace.method.word_of("depth") != "inverse-z" || sgn(depth) == 0 || abs(depth) == 1 ||
        place.owner().kind != PrimitiveKind::triangle || depth.get_den() == 1 ||
        place.trace.method.word_of("depth_at") == "rounded-ends")
        return std::nullopt;
    return Planted{"z-for-inverse-z", R"({"step":"depth",)" + place.in() + R"("x":)" +
                                          std::to_string(step.x) + R"(,"y":)" +
                                          std::to_string(step.y) + R"(,"depth":)" +
                                          quoted(1 / depth) + "}"};
}

/// True of the first decision of a line: before it stands the line's first pixel.
bool is_first_of_line(const Place& place) {
    return place.primitive != 0 && place.n <= place.primitive + 2;
}

/// A line whose d = 0 goes the other way.
Result decide_ties_otherwise(const Place& place) {
    if (!is_first_of_line(place))
        return std::nullopt; // not the first of its line
    std::vector<Rational> right;
    for (std::size_t n = place.n; n <= place.trace.size(); ++n) {
        if (place.trace.kind_of(n) == StepKind::primitive)
            break;
        if (place.trace.kind_of(n) == StepKind::decide)
            right.push_back(*place.trace.step(n).as<DecideStep>().d.exact());
    }
    // d begins at 2 minor - major, and each step adds 2 minor, or 2 (minor - major).
    const auto ends = place.owner().at.values();
    const auto from = rationals(ends[0]);
    const auto to = rationals(ends[1]);
    const auto nearest = [](const Rational& number) {
        const Rational shifted = number + Rational(1, 2);
        mpz_class floor;
        mpz_fdiv_q(floor.get_mpz_t(), shifted.get_num_mpz_t(), shifted.get_den_mpz_t());
        return Rational(floor);
    };
    const Rational dx = abs(nearest(to[0]) - nearest(from[0]));
    const Rational dy = abs(nearest(to[1]) - nearest(from[1]));
    const Rational major = std::max(dx, dy);
    const Rational minor = std::min(dx, dy);
    if (right.size() != major.get_num().get_ui())
        return std::nullopt; // the canvas does not have all of it
    const bool steps_at_ties = place.trace.method.word_of("ties").ends_with("step");
    std::vector<Rational> wrong;
    Rational d = 2 * minor - major;
    for (std::size_t i = 0; i < right.size(); ++i) {
        wrong.push_back(d);
        const bool is_diagonal = sgn(d) > 0 || (sgn(d) == 0 && !steps_at_ties);
        d += is_diagonal ? Rational(2 * (minor - major)) : Rational(2 * minor);
    }
    if (wrong == right)
        return std::nullopt;
    return Planted{"tie-the-other-way",
                   R"({"step":"decide",)" + place.in() + R"("d":)" + quoted(wrong) + "}"};
}

Result round_the_slope(const Place& place) {
    const auto end = left_end(place);
    if (!end)
        return std::nullopt;
    const Rational scaled = abs(end->slope()) * 100 + Rational(1, 2);
    const Rational rounded =
        sgn(end->slope()) * Rational(mpz_class(scaled.get_num() / scaled.get_den())) / 100;
    return planted_row(place, "slope-rounded-first", end->x1 + rounded * (end->y - end->y1));
}

Result invert_slope_from_the_other_end(const Place& place) {
    const auto end = left_end(place);
    if (!end || end->x1 == end->x2)
        return std::nullopt;
    return planted_row(place, "dx-dy-inverted", end->x2 + (end->y - end->y2) / end->slope());
}

Result divide_only_z(const Place& place) {
    const auto step = place.step<VertexStep>();
    auto clip = place_before(place);
    if (step.space != Space::canonical || clip.size() != 4 || clip[3] == 1)
        return std::nullopt;
    clip[2] = clip[2] / clip[3];
    clip.pop_back();
    if (clip == rationals(step.at))
        return std::nullopt;
    return Planted{"only-z-divided", vertex_claim(step, clip)};
}

/// d of a whole line that begins here, of slope from 0 to 1 or its mirror images; empty of one that leaves the canvas.
std::vector<Rational> decisions_here(const Place& place, Rational& major, Rational& minor) {
    std::vector<Rational> right;
    if (!is_first_of_line(place))
        return right; // not the first of its line
    for (std::size_t n = place.n;
         n <= place.trace.size() && place.trace.kind_of(n) != StepKind::primitive; ++n)
        if (place.trace.kind_of(n) == StepKind::decide)
            right.push_back(*place.trace.step(n).as<DecideStep>().d.exact());
    if (right.size() < 3)
        return {};
    // d begins at 2 minor - major of a line of as many steps.
    major = static_cast<long>(right.size());
    minor = (right[0] + major) / 2;
    return minor.get_den() == 1 && sgn(minor) >= 0 && minor <= major ? right
                                                                     : std::vector<Rational>{};
}

Result planted_decisions(const Place& place, const std::string& slip,
                         const std::vector<Rational>& right, const std::vector<Rational>& wrong) {
    const bool is_right = // or nothing
        wrong.size() <= right.size() && std::equal(wrong.begin(), wrong.end(), right.begin());
    if (is_right)
        return std::nullopt;
    return Planted{slip, R"({"step":"decide",)" + place.in() + R"("d":)" + quoted(wrong) + "}"};
}

/// The decisions with other sums: the start, after a straight step, after a diagonal one.
std::vector<Rational> decided(std::size_t count, Rational d, const Rational& straight,
                              const Rational& diagonal) {
    std::vector<Rational> all;
    for (std::size_t i = 0; i < count; ++i) {
        all.push_back(d);
        d += sgn(d) > 0 ? diagonal : straight;
    }
    return all;
}

/// d with another sum, of a line from 0 to 1 or its mirror images.
Result decide_by(const Place& place, const std::string& slip, const auto& wrong) {
    Rational major;
    Rational minor;
    const auto right = decisions_here(place, major, minor);
    const auto ours = decided(right.size(), 2 * minor - major, 2 * minor, 2 * (minor - major));
    if (right.empty() || ours != right) // its ties step, or another octant
        return std::nullopt;
    return planted_decisions(place, slip, right, wrong(right.size(), major, minor));
}

Result exchange_the_steps(const Place& place) {
    return decide_by(place, "steps-exchanged",
                     [](std::size_t count, const Rational& major, const Rational& minor) {
                         return decided(count, 2 * minor - major, 2 * (minor - major), 2 * minor);
                     });
}

Result begin_with_the_other_axis(const Place& place) {
    return decide_by(place, "start-of-other-axis",
                     [](std::size_t count, const Rational& major, const Rational& minor) {
                         return decided(count, 2 * major - minor, 2 * minor, 2 * (minor - major));
                     });
}

Result shift_the_list(const Place& place) {
    Rational major;
    Rational minor;
    auto right = decisions_here(place, major, minor);
    if (right.empty())
        return std::nullopt;
    return planted_decisions(place, "shifted-list", right, {right.begin() + 1, right.end()});
}

mpz_class floor_of(const Rational& number) {
    mpz_class below;
    mpz_fdiv_q(below.get_mpz_t(), number.get_num_mpz_t(), number.get_den_mpz_t());
    return below;
}

/// A pixel at an end of a row whose rule is floor(x).
Result planted_pixel(const Place& place, const std::string& slip, const std::string& field,
                     const Rational& wrong) {
    const auto row = place.step<ScanlineStep>();
    const std::string rounding = place.trace.method.word_of("rounding");
    if (place.trace.method.word_of("fill") == "top-left" || // it asks samples
        rounding.substr(0, rounding.find('+')) != "floor" ||
        wrong == Rational(field == "from" ? row.from : row.to))
        return std::nullopt;
    return Planted{slip, place.row_claim(field, wrong)};
}

/// An end of the row, as the columns of pixels count it.
Rational end_in_columns(const Place& place, bool is_left) {
    const auto row = place.step<ScanlineStep>();
    return told_samples(place.trace)
        .triangles.in_columns(*(is_left ? row.left : row.right).exact());
}

Result round_to_nearest(const Place& place) {
    return planted_pixel(place, "nearest-for-floor", "from",
                         Rational(floor_of(end_in_columns(place, true) + Rational(1, 2))));
}

Result take_only_pixels_between(const Place& place) {
    return planted_pixel(place, "inside-for-floor", "from",
                         Rational(-floor_of(-end_in_columns(place, true))));
}

Result leave_out_the_right_end(const Place& place) {
    return planted_pixel(place, "half-open-for-floor", "to",
                         Rational(-floor_of(-end_in_columns(place, false)) - 1));
}

Result take_the_pixel_for_the_end(const Place& place) {
    const Rational x = *place.step<ScanlineStep>().left.exact();
    return planted_row(place, "pixel-for-end", Rational(floor_of(x)));
}

Result take_no_slope(const Place& place) {
    const auto end = left_end(place);
    return end ? planted_row(place, "slope-of-zero", end->x1) : std::nullopt;
}

Result divide_whole_numbers(const Place& place) {
    const auto end = left_end(place);
    if (!end)
        return std::nullopt;
    const Rational slope = end->slope();
    const Rational whole(mpz_class(slope.get_num() / slope.get_den()));
    return planted_row(place, "integer-division", end->x1 + whole * (end->y - end->y1));
}

Result leave_out_the_last_pixel(const Place& place) {
    const auto row = place.step<ScanlineStep>();
    return row.to < row.from ? std::nullopt
                             : Result({"last-pixel", place.row_claim("pixel_count",
                                                                     Rational(row.to - row.from))});
}

Result count_the_middle_row_twice(const Place& place) {
    std::set<Index> rows;
    for (std::size_t n = place.n + 1;
         n <= place.trace.size() && place.trace.kind_of(n) != StepKind::primitive; ++n)
        if (place.trace.kind_of(n) == StepKind::pixel || place.trace.kind_of(n) == StepKind::depth)
            rows.insert(*y_in(place.trace.step(n)));
    const bool has_gaps =
        rows.empty() || *rows.rbegin() - *rows.begin() + 1 != static_cast<Index>(rows.size());
    if (has_gaps || place.step<PrimitiveStep>().kind != PrimitiveKind::triangle)
        return std::nullopt;
    return Planted{"middle-row-twice",
                   R"({"step":"primitive","name":")" + place.step<PrimitiveStep>().name.text() +
                       R"(","row_count":)" + std::to_string(rows.size() + 1) + "}"};
}

/// y = m x + b of an edge from corner to corner, with x and y exchanged in m.
Result invert_the_slope_of_a_line(const Place& place) {
    const std::string edge = place.step<EdgeStep>().edge.text();
    if (edge.size() != 2)
        return std::nullopt;
    const auto from = place.corner(edge[0]);
    const auto to = place.corner(edge[1]);
    if (from.empty() || to.empty() || from[0] == to[0] || from[1] == to[1])
        return std::nullopt;
    const Rational m = (to[1] - from[1]) / (to[0] - from[0]);
    const Rational b = from[1] - m * from[0];
    if (abs(m) == 1)
        return std::nullopt;
    return Planted{"dy-dx-inverted", R"({"step":"edge",)" + place.in() + R"("edge":")" + edge +
                                         R"(","y_form":)" + quoted({1 / m, b}) + "}"};
}

/// A sample on an edge, whose verdict is turned round.
Result decide_an_edge_otherwise(const Place& place) {
    const auto sample = place.step<SampleStep>();
    const auto weights = rationals(sample.weights);
    if (weights.empty() || sgn(*std::min_element(weights.begin(), weights.end())) != 0)
        return std::nullopt;
    return Planted{"edge-the-other-way",
                   fmt::format(R"({{"step":"sample",{}"x":{},"y":{},"inside":{}}})", place.in(),
                               sample.x, sample.y, sample.inside.is_false())};
}

std::vector<Rational> normal_of(const Place& place) {
    return rationals(place.step<FaceStep>().normal);
}

Result take_the_normal_for_the_view(const Place& place) {
    return rationals(place.step<FaceStep>().view) == normal_of(place)
               ? std::nullopt
               : Result({"normal-for-view", place.face_claim("view", quoted(normal_of(place)))});
}

Result exchange_x_and_y(const Place& place) {
    auto normal = normal_of(place);
    if (normal.size() != 3 || normal[0] == normal[1])
        return std::nullopt;
    std::swap(normal[0], normal[1]);
    return Planted{"coordinates-exchanged", place.face_claim("normal", quoted(normal))};
}

/// The cosine as its face tells it, in so many digits as a calculator shows.
std::optional<double> cosine_of(const Place& place) {
    const auto cosine = place.step<FaceStep>().cosine.nearest_double();
    return cosine && std::abs(*cosine) < 0.99 && std::abs(*cosine) > 0.01 ? cosine : std::nullopt;
}

Result take_the_angle(const Place& place) {
    const auto cosine = cosine_of(place);
    return cosine ? Result({"angle-for-cosine",
                            place.face_claim("cosine", fmt::format("{:.6f}", std::acos(*cosine)))})
                  : std::nullopt;
}

Result take_the_sine(const Place& place) {
    const auto cosine = cosine_of(place);
    if (!cosine || std::abs(*cosine * *cosine - 0.5) < 1e-3)
        return std::nullopt;
    return Planted{
        "complement-of-angle",
        place.face_claim("cosine", fmt::format("{:.6f}", std::sqrt(1 - *cosine * *cosine)))};
}

/// Where d is above 0 to the end, this is what comes of exchanged steps, too.
Result forget_dx(const Place& place) {
    return decide_by(place, "diagonal-of-one-axis",
                     [](std::size_t count, const Rational& dx, const Rational& dy) {
                         const Rational start = 2 * dy - dx;
                         auto all = decided(count, start, 2 * dy, 2 * dy);
                         return all == decided(count, start, 2 * (dy - dx), 2 * dy)
                                    ? std::vector<Rational>{}
                                    : all;
                     });
}

Result forget_to_double(const Place& place) {
    return decide_by(place, "factor-2-dropped",
                     [](std::size_t count, const Rational& dx, const Rational& dy) {
                         return decided(count, dy - dx, dy, dy - dx);
                     });
}

Result exchange_dx_and_dy(const Place& place) {
    return decide_by(place, "dx-and-dy-exchanged",
                     [](std::size_t count, const Rational& dx, const Rational& dy) {
                         return decided(count, 2 * dx - dy, 2 * dx, 2 * (dx - dy));
                     });
}

Result keep_a_sign(const Place& place) {
    return decide_by(place, "octant-ignored",
                     [](std::size_t count, const Rational& dx, const Rational& dy) {
                         return decided(count, -2 * dy - dx, -2 * dy, -2 * (dy + dx));
                     });
}

/// A way to make a mistake, and the kind of step that it is made in.
struct Planter {
    StepKind kind;
    Result (*plant)(const Place& place);
};
constexpr std::array planters{
    Planter{StepKind::scanline, invert_slope},
    Planter{StepKind::scanline, exchange_start_and_step},
    Planter{StepKind::scanline, take_the_row_above},
    Planter{StepKind::scanline, forget_the_start},
    Planter{StepKind::scanline, lose_the_minus},
    Planter{StepKind::scanline, cut_off},
    Planter{StepKind::edge, take_another_corner},
    Planter{StepKind::edge, take_dy_of_another_edge},
    Planter{StepKind::edge, forget_m_x_in_b},
    Planter{StepKind::face, exchange_y_and_z},
    Planter{StepKind::face, turn_the_view_round},
    Planter{StepKind::face, forget_the_lengths},
    Planter{StepKind::vertex, forget_to_divide},
    Planter{StepKind::vertex, forget_to_move},
    Planter{StepKind::depth, take_z_for_its_inverse},
    Planter{StepKind::scanline, round_the_slope},
    Planter{StepKind::scanline, invert_slope_from_the_other_end},
    Planter{StepKind::vertex, divide_only_z},
    Planter{StepKind::scanline, round_to_nearest},
    Planter{StepKind::scanline, take_only_pixels_between},
    Planter{StepKind::scanline, leave_out_the_right_end},
    Planter{StepKind::scanline, take_the_pixel_for_the_end},
    Planter{StepKind::scanline, take_no_slope},
    Planter{StepKind::scanline, divide_whole_numbers},
    Planter{StepKind::scanline, leave_out_the_last_pixel},
    Planter{StepKind::primitive, count_the_middle_row_twice},
    Planter{StepKind::edge, invert_the_slope_of_a_line},
    Planter{StepKind::sample, decide_an_edge_otherwise},
    Planter{StepKind::face, take_the_normal_for_the_view},
    Planter{StepKind::face, exchange_x_and_y},
    Planter{StepKind::face, take_the_angle},
    Planter{StepKind::face, take_the_sine},
};

constexpr std::array planters_of_lines{
    Planter{StepKind::decide, decide_ties_otherwise},
    Planter{StepKind::decide, exchange_the_steps},
    Planter{StepKind::decide, begin_with_the_other_axis},
    Planter{StepKind::decide, shift_the_list},
    Planter{StepKind::decide, forget_dx},
    Planter{StepKind::decide, forget_to_double},
    Planter{StepKind::decide, exchange_dx_and_dy},
    Planter{StepKind::decide, keep_a_sign},
};

/// A mistake in some step of the trace that it can be made in.
Result planted(const Trace& trace, const Planter& planter, Random& random) {
    std::vector<Result> all;
    std::size_t primitive = 0;
    for (std::size_t n = 1; n <= trace.size() && all.size() < 20; ++n) {
        if (trace.kind_of(n) == StepKind::primitive)
            primitive = n;
        if (trace.kind_of(n) != planter.kind)
            continue;
        const bool is_part =
            primitive != 0 && trace.step(primitive).as<PrimitiveStep>().part.is_true();
        if (!is_part)
            if (Result one = planter.plant({trace, n, primitive}))
                all.push_back(std::move(one));
    }
    return all.empty()
               ? std::nullopt
               : all[static_cast<std::size_t>(random.whole(0, static_cast<int>(all.size()) - 1))];
}

/// How often each slip was planted, named, and named first.
struct Tally {
    std::size_t planted = 0;
    std::size_t named = 0;
    std::size_t first = 0;
};

TEST(Slips, APlantedOneIsNamed) {
    const std::size_t wanted = random_cases(1000U);
    Random random(20221122);
    std::map<std::string, Tally> tallies;
    Tally all;
    std::size_t count = 0;
    for (std::uint64_t seed = 1; count < wanted; ++seed) {
        const std::string scene = RandomScene(seed).text();
        // Faces are tested where something is culled.
        MethodOverrides method{{"scalar", "exact"}, {"keep", "model"}, {"keep", "view"}};
        if (seed % 4 == 0)
            method.emplace_back("cull", "back");
        const auto read = read_scene({"scene.json", scene}, method);
        // Of a polygon's row, more than one step may be claimed.
        if (!read || read.value().scene.has(PrimitiveKind::polygon))
            continue;
        const Trace trace = trace_of(read.value().scene);
        Result mistake;
        for (std::size_t i = 0; i < planters.size() && !mistake; ++i)
            mistake = planted(trace, planters[(seed + i) % planters.size()], random);
        if (!mistake)
            continue;
        ++count;
        const Checked checked =
            check_claims(scene, R"({"claims":[)" + mistake->claim + "]}", method);
        ASSERT_EQ(checked.wrong, 1U) << mistake->claim << "\n" << scene;
        std::vector<std::string> names;
        for (const CheckedField& field : checked.claims[0].fields)
            for (const std::string& name : slip_names(field))
                names.push_back(name);
        const bool is_named = std::find(names.begin(), names.end(), mistake->slip) != names.end();
        for (Tally* tally : {&all, &tallies[mistake->slip]}) {
            ++tally->planted;
            tally->named += is_named ? 1 : 0;
            tally->first += is_named && names.front() == mistake->slip ? 1 : 0;
        }
    }
    // Some give a number that another slip gives as well, or chance.
    EXPECT_GE(all.named * 100, all.planted * (are_all_cases ? 97 : 92));
    EXPECT_GE(all.first * 100, all.planted * (are_all_cases ? 94 : 88));
    for (const auto& [slip, tally] : tallies) {
        EXPECT_GE(tally.planted, random_cases(2U)) << slip;
        EXPECT_GE(tally.named, tally.planted / 4) << slip << " of " << tally.planted;
    }
    const std::size_t kinds = 28; // of 2,000; fewer of a tenth
    EXPECT_GE(tallies.size(), wanted == 1000 ? kinds : kinds / 2);
}

TEST(Slips, APlantedOneOfALineIsNamed) {
    const std::size_t wanted = all_cases(400U);
    Random random(20261127);
    std::map<std::string, Tally> tallies;
    std::map<std::string, std::string> instead; ///< a claim that another slip is named for
    for (std::size_t count = 0; count < wanted;) {
        const std::string scene = fmt::format(
            R"({{"canvas":{{"width":31,"height":31}},"vertices":{{"A":[{},{}],"B":[{},{}]}},"lines":["AB"],)"
            R"("method":{{"scalar":"exact"}}}})",
            random.whole(-15, 15), random.whole(-15, 15), random.whole(-15, 15),
            random.whole(-15, 15));
        const Trace trace = trace_of(scene_in(scene));
        for (const Planter& planter : planters_of_lines) {
            const Result mistake = planted(trace, planter, random);
            if (!mistake)
                continue;
            ++count;
            const Checked checked = check_claims(scene, R"({"claims":[)" + mistake->claim + "]}");
            ASSERT_EQ(checked.wrong, 1U) << mistake->claim << "\n" << scene;
            const auto names = slip_names(checked.claims[0].fields[0]);
            Tally& tally = tallies[mistake->slip];
            ++tally.planted;
            const bool is_first = !names.empty() && names.front() == mistake->slip;
            tally.first += is_first ? 1 : 0;
            if (!is_first)
                instead[mistake->slip] = mistake->claim + (names.empty() ? "" : names.front());
        }
    }
    EXPECT_EQ(tallies.size(), planters_of_lines.size());
    for (const auto& [slip, tally] : tallies)
        EXPECT_GE(tally.first, tally.planted * 9 / 10)
            << slip << " " << tally.planted << " " << instead[slip];
}

/// The first steps of a drawing that another drawing does not have, as claims.
std::vector<std::string> claims_of_other_steps(const Trace& with, const Trace& right,
                                               std::size_t most) {
    const auto known = steps_of(right);
    const std::set<std::string> of_right(known.begin(), known.end());
    std::vector<std::string> claims;
    std::string primitive;
    for (std::size_t n = 1; n <= with.size() && claims.size() < most; ++n) {
        const StepKind kind = with.kind_of(n).value();
        if (kind == StepKind::primitive)
            primitive = with.step(n).as<PrimitiveStep>().name.text();
        const std::string step(with.step(n).json());
        const bool is_of_primitive = kind == StepKind::scanline || kind == StepKind::edge ||
                                     kind == StepKind::depth || kind == StepKind::decide ||
                                     kind == StepKind::along;
        if (of_right.contains(step) ||
            !(is_of_primitive || kind == StepKind::vertex || kind == StepKind::face ||
              kind == StepKind::light ||
              (kind == StepKind::pixel && step.find("color") != std::string::npos)))
            continue;
        claims.push_back(is_of_primitive ? R"({"in":")" + primitive + "\"," + step.substr(1)
                                         : step);
    }
    return claims;
}

// Who works out a few lines as a program with a mistake does is told its name.
TEST(Slips, AMistakeOfProgramsIsNamed) {
    std::map<std::string_view, Tally> tallies;
    Tally all;
    for (std::uint64_t seed = 1; seed <= all_cases(60U); ++seed) {
        const std::string scene = RandomScene(seed).text();
        const MethodOverrides method{{"scalar", "exact"}};
        const auto read = read_scene({"scene.json", scene}, method);
        if (!read || read.value().scene.primitives.size() > 4)
            continue;
        const Trace right = trace_of(read.value().scene);
        const Truth truth({"scene.json", scene}, method);
        for (const Mistake& mistake : mistakes()) {
            if (right.size() > 500 || !mistake.concerns(read.value().scene))
                continue;
            const auto with =
                read_scene({"scene.json", scene},
                           {{"scalar", "exact"}, {"mistake", std::string(mistake.name)}});
            if (!with)
                continue;
            std::string claims;
            for (const std::string& claim :
                 claims_of_other_steps(trace_of(with.value().scene), right, 8))
                claims += (claims.empty() ? "" : ",") + claim;
            if (claims.empty())
                continue;
            std::optional<Checked> checked;
            try {
                checked = check(truth, claims_in(R"({"claims":[)" + claims + "]}"));
            } catch (const Problem&) {
                continue; // about a step that is not one alone
            }
            if (checked->wrong == 0)
                continue;
            const bool is_named = std::find(checked->slips.begin(), checked->slips.end(),
                                            mistake.name) != checked->slips.end();
            for (Tally* const tally : {&all, &tallies[mistake.name]}) {
                ++tally->planted;
                tally->named += is_named ? 1 : 0;
            }
        }
    }
    EXPECT_GT(all.named, 0U);
    if (!are_all_cases)
        return;
    EXPECT_GT(tallies.size(), 60U);
    EXPECT_GE(all.named * 20, all.planted * 17) << all.named << " of " << all.planted;
    for (const auto& [mistake, tally] : tallies)
        EXPECT_GE(tally.named, tally.planted / 4) << mistake << " of " << tally.planted;
}

/// A number that a row's left end or an edge does not have: another digit, ten times as much, another number.
std::string number_by_chance(const Rational& right, Random& random) {
    const int way = random.whole(0, 2);
    std::string text = right.get_str();
    if (way == 0) {
        std::size_t at = 0;
        do
            at = static_cast<std::size_t>(random.whole(0, static_cast<int>(text.size()) - 1));
        while (text[at] < '0' || '9' < text[at]);
        text[at] = static_cast<char>('0' + random.whole(1, 9));
        return text;
    }
    if (way == 1)
        return Rational(random.whole(0, 1) == 0 ? Rational(right * 10) : Rational(right / 10))
            .get_str();
    const Rational other =
        Rational(random.whole(-20, 20)) / (random.whole(0, 1) == 0 ? 1 : random.whole(2, 9));
    return other.get_str();
}

TEST(Slips, ChanceIsRarelyTakenForOne) {
    const std::size_t wanted = all_cases(1000U);
    Random random(20261126);
    std::size_t wrong = 0;
    std::size_t named = 0;
    while (wrong < wanted) {
        const auto place = [&] {
            return fmt::format("[{},{}]", random.whole(-7, 7), random.whole(-6, 6));
        };
        const std::string scene = fmt::format(
            R"({{"canvas":{{"width":17,"height":14}},"vertices":{{"A":{},"B":{},"C":{}}},"triangles":["ABC"],)"
            R"("method":{{"scalar":"exact"}}}})",
            place(), place(), place());
        const Truth truth({"scene.json", scene}, {});
        const Trace& trace = truth.exact();
        for (std::size_t n = 1; n <= trace.size(); ++n) {
            std::string claim;
            if (trace.kind_of(n) == StepKind::scanline) {
                const auto row = trace.step(n).as<ScanlineStep>();
                claim =
                    fmt::format("y={}: {}, ?", row.y, number_by_chance(*row.left.exact(), random));
            } else if (trace.kind_of(n) == StepKind::edge &&
                       trace.step(n).as<EdgeStep>().dx_dy.has_number()) {
                const auto edge = trace.step(n).as<EdgeStep>();
                claim = fmt::format("edge {}: {}", edge.edge.text(),
                                    number_by_chance(*edge.dx_dy.exact(), random));
            }
            if (claim.empty() || claim.ends_with("/0") || claim.find("/0,") != std::string::npos)
                continue;
            const Checked checked = check(truth, claims_in(claim + "\n"));
            wrong += checked.wrong;
            for (const CheckedField& field : checked.claims[0].fields)
                named += field.slips.empty() ? 0 : 1;
        }
    }
    const std::size_t most = are_all_cases ? wrong * 3 / 100 : wrong;
    EXPECT_LE(named, most); // in scenes of small whole numbers, where much is near
}

// -1/4 -> 0 is rounded toward 0, or to the nearest; whoever has 7/2 -> 3 and 19/8 -> 2 besides does not round 7/2 to the
// nearest, which is 4.
TEST(Slips, OneThatRightNumbersSpeakAgainstComesLater) {
    const std::string scene = example_text("t0-fill/first-triangle.json");
    const std::string wrong = "y=2: -1/4, 25/8 -> 0..3\n";
    const auto place_of_nearest = [&](const std::string& claims) {
        const Checked checked = check_claims(scene, claims);
        EXPECT_EQ(checked.slips.front(), "truncate-for-floor");
        EXPECT_EQ(checked.slips, slip_names(checked.claims[0].fields[2]));
        return std::find(checked.slips.begin(), checked.slips.end(), "nearest-for-floor") -
               checked.slips.begin();
    };
    const auto alone = place_of_nearest(wrong);
    EXPECT_EQ(alone, 1);
    EXPECT_GT(place_of_nearest(wrong + "y=1: -1, 7/2 -> -1..3\n"), alone);
}

TEST(Slips, TheTableHasEachNameOnce) {
    std::set<std::string_view> names;
    for (const Slip& slip : slips()) {
        EXPECT_TRUE(names.insert(slip.name).second) << slip.name;
        EXPECT_EQ(find_slip(slip.name), &slip);
        for (const Language language : {Language::english, Language::portuguese})
            EXPECT_FALSE(slip.done.in(language).empty() || slip.instead_of.in(language).empty())
                << slip.name;
        EXPECT_FALSE(slip.symptom.empty()) << slip.name;
    }
    EXPECT_EQ(find_slip("no-such-slip"), nullptr);
}

TEST(Slips, NoneGivesTheRightResult) {
    const Formula formulas[] = {
        {Lerp{.d1 = 2, .i1 = 5, .d2 = -4, .i2 = -3, .i = 2, .other = {{5, -3}}}},
        {Slope{{2, 5}, {-4, -3}, Vec<Rational, 2>{5, -3}}},
        {FaceNormal{{{-1, 1, 3}, {1, 1, 3}, {1, -1, 3}}}},
        {FaceDot{{0, 0, -4}, {Rational(-1, 3), Rational(-1, 3), -3}}},
        {DividedByW{{-1, 1, 2, 3}}},
        {BresenhamDecisions{.major = 8, .minor = 6, .steps = 8}},
        {LinePixels{{.major = 8, .minor = 6, .steps = 8}, {1, 2}, {1, 0}, {1, -1}}},
        {LineForm{{2, 5}, {-4, -3}}},
        {LineForm{{2, 5}, {-4, -3}, true}},
        {InclusiveCount{-1, 3}},
        {MixedColor{
            {Color(0, 0, 0), Color(255, 0, 0)}, {Rational(1, 2), Rational(1, 2)}, false, {0, 1}}},
        {InTriangle{{{{{0, 0}, {6, 0}, {0, 6}}}, {3, 3}}, true}},
    };
    for (const Formula& formula : formulas)
        for (const Slip& slip : slips())
            for (const SlipResult& redone : slip.redo(formula))
                EXPECT_NE(redone.values, value_of(formula)) << slip.name;
}

} // namespace
} // namespace rastertrace
