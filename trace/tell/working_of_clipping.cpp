// SPDX-License-Identifier: MIT
// The working of a vertex that clipping made: where an edge meets a plane of the view.

#include "meeting_point.h"
#include "sheet.h"

#include <rastertrace/core/draw/list/geometry.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/clip.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

using Place = std::array<Rational, 4>;
using Plane = ClipPlane<Rational>;

constexpr std::array<std::string_view, 4> letters{"x", "y", "z", "w"};

Vec<Rational, 4> vector_of(const Place& p) {
    return {p[0], p[1], p[2], p[3]};
}

/// A vertex in clip space.
struct ClipCorner {
    std::string name;
    Place at;
};

/// What clipping has told just before the current step: the planes that cut, and the corners that there are, the
/// primitive's own and those that clipping has made.
struct Cut {
    std::vector<std::string> planes = {};
    std::vector<ClipCorner> corners = {};
};

Cut cut_before(const Sheet& sheet) {
    const Trace& trace = sheet.trace();
    Cut cut;
    const auto add_corner = [&](std::size_t n) {
        const auto vertex = trace.step(n).as<VertexStep>();
        const auto at = numbers_in<4>(vertex.at.texts());
        if (vertex.space == Space::clip && at)
            cut.corners.push_back({vertex.name.text(), *at});
    };
    std::string whole;
    for (std::size_t n = sheet.at.step() - 1; n > 0; --n) {
        const auto kind = trace.kind_of(n);
        if (kind == StepKind::vertex) {
            add_corner(n);
        } else if (kind == StepKind::clip) {
            const auto step = trace.step(n).as<ClipStep>();
            whole = step.name.text();
            cut.planes.push_back(step.plane.text());
        } else {
            break;
        }
    }
    const std::vector<ClipCorner> made = std::exchange(cut.corners, {});
    // The parts of an outline's other sides may stand between.
    const auto primitives = sheet.at.primitives();
    const auto found = std::find_if(primitives.rbegin(), primitives.rend(), [&](std::size_t n) {
        return trace.step(n).as<PrimitiveStep>().name == whole;
    });
    if (found != primitives.rend())
        for (const std::string& name : primitive_in(trace.step(*found)).vertices)
            for (const std::size_t n : sheet.at.places_of(name))
                add_corner(n);
    cut.corners.insert(cut.corners.end(), made.begin(), made.end());
    return cut;
}

/// The planes at the sides of the view are |x| = guard w, and |y| = guard w: so many times as far from the middle as the
/// edge of the canvas.
Rational guard_at(const Sheet& sheet, std::size_t axis) {
    const Canvas& canvas = sheet.trace().canvas;
    const Rational extent = axis == 0 ? canvas.width : canvas.height;
    for (const std::size_t n : sheet.at.matrices())
        if (const auto step = sheet.trace().step(n).as<MatrixStep>(); step.name == "viewport") {
            const auto viewport = matrix_named(sheet, "viewport");
            const bool fits = step.factors.texts().size() > 1;
            return fits || !viewport || sgn(viewport->rows[axis][axis]) == 0
                       ? Rational(guard_band)
                       : Rational(guard_band * extent / (2 * abs(viewport->rows[axis][axis])));
        }
    return guard_band * extent;
}

/// A plane of the view. The distance of a near or a far one stands in the matrix of a frustum; of other perspectives
/// the trace does not tell it, and it is w of the vertex.
Plane plane_named(const Sheet& sheet, const std::string& name, const Matrix<Rational>& projection,
                  const Place& vertex) {
    const Rational zero;
    const bool is_near = name == "near";
    const std::string& type = sheet.trace().projection;
    if (type.starts_with("clip-space") && (is_near || name == "far"))
        return {"", {zero, zero, is_near ? 1 : -1, is_near && type != "clip-space" ? 0 : 1}, zero};
    if (is_near || name == "far") {
        const Rational& a = projection.rows[2][2];
        const Rational& b = projection.rows[2][3];
        const Rational side = is_near ? 1 : -1;
        if (sgn(projection.rows[3][2]) == 0)
            return {"", {zero, zero, side, zero}, 1};
        const bool is_told = sheet.trace().projection == "frustum" && a != side;
        return {
            "", {zero, zero, zero, side}, -side * (is_told ? Rational(b / (a - side)) : vertex[3])};
    }
    const Rational side = name == "left" || name == "bottom" ? 1 : -1;
    return name == "left" || name == "right"
               ? Plane{"", {side, zero, zero, guard_at(sheet, 0)}, zero}
               : Plane{"", {zero, side, zero, guard_at(sheet, 1)}, zero};
}

/// d of a plane, with letters, or with the numbers of a vertex: w - 1, x + 4096 w; 2 - 1, -1 + 4096 (2)
std::string distance_from(const Plane& plane, const Place* at = nullptr) {
    const auto& f = plane.factors;
    const std::array factors{f.x, f.y, f.z, f.w};
    std::string sum;
    const auto add = [&sum](const std::string& term) {
        sum += sum.empty() ? term : " " + plus(term);
    };
    for (std::size_t i = 0; i < 4; ++i) {
        const bool is_one = factors[i] == 1;
        if (sgn(factors[i]) != 0 && at != nullptr)
            add(is_one ? text((*at)[i]) : product(factors[i], (*at)[i]));
        else if (sgn(factors[i]) != 0)
            add(is_one             ? std::string(letters[i])
                : factors[i] == -1 ? fmt::format("-{}", letters[i])
                                   : fmt::format("{} {}", text(factors[i]), letters[i]));
    }
    if (sgn(plane.constant) != 0)
        add(text(plane.constant));
    return sum;
}

/// An edge from p, inside of a plane, to q, outside, and its end that the plane made.
struct Meeting {
    std::string plane_name;
    Plane plane;
    ClipCorner p;
    ClipCorner q;
    ClipCorner met;
    Rational d1; ///< of p
    Rational d2; ///< of q
    Rational t;  ///< d1/(d1 - d2)
};

/// Nothing if the edge does not meet the plane where the trace has the vertex.
std::optional<Meeting> meeting_at(const Sheet& sheet, const std::string& plane_name,
                                  const Plane& plane, const ClipCorner& p, const ClipCorner& q,
                                  const ClipCorner& met) {
    const Rational d1 = plane.value_at(vector_of(p.at));
    const Rational d2 = plane.value_at(vector_of(q.at));
    if (sgn(d1) <= 0 || sgn(d2) >= 0)
        return std::nullopt;
    const Rational t = d1 / (d1 - d2);
    for (std::size_t i = 0; i < 4; ++i)
        if (!sheet.agrees(p.at[i] + t * (q.at[i] - p.at[i]), met.at[i]))
            return std::nullopt;
    return Meeting{plane_name, plane, p, q, met, d1, d2, t};
}

void put_meeting(Sheet& sheet, const Meeting& meeting) {
    const auto& [plane_name, plane, p, q, met, d1, d2, t] = meeting;
    sheet.put(said("{} plane: d = {}, inside where d >= 0", in_language_of_steps(plane_name),
                   distance_from(plane)));
    sheet.put(said("{}: d1 = {} = {}, {}: d2 = {} = {}", p.name, distance_from(plane, &p.at),
                   text(d1), q.name, distance_from(plane, &q.at), text(d2)));
    const std::string sum = fmt::format("({} {})", text(d1), minus(text(d2)));
    sheet.put(fmt::format("t = d1/(d1 - d2) = {} = {}", quotient(text(d1), sum), text(t)));
    sheet.put(fmt::format("{0} = {1} + t ({2} - {1}):", met.name, p.name, q.name));
    for (std::size_t i = 0; i < 4; ++i)
        sheet.put(fmt::format("{} = {} + {} ({} {}) = {}", letters[i], text(p.at[i]), text(t),
                              text(q.at[i]), minus(text(p.at[i])), text(met.at[i])));
}

/// How the vertex of the current step came about; nothing if clipping did not make it.
std::optional<Meeting> meeting_of(const Sheet& sheet) {
    const auto vertex = sheet.step.as<VertexStep>();
    if (vertex.space != Space::clip || sheet.at.primitive() == 0)
        return std::nullopt;
    const auto at = numbers_in<4>(vertex.at.texts());
    const std::string& type = sheet.trace().projection;
    const bool is_typed_in_clip_space = type.starts_with("clip-space");
    const auto projection = is_typed_in_clip_space ? std::optional(identity<Rational>())
                                                   : matrix_named(sheet, "projection");
    const auto [planes, corners] = cut_before(sheet);
    if (!at || !projection || planes.empty())
        return std::nullopt;
    const ClipCorner met{vertex.name.text(), *at};
    // Any edge through the vertex meets a plane there whose distance is taken from it: such a one comes last, and only
    // if there are no two of them.
    const auto is_at_side = [](const std::string& name) { return name != "near" && name != "far"; };
    const bool are_both = std::count_if(planes.begin(), planes.end(), std::not_fn(is_at_side)) > 1;
    for (const bool side : {true, false})
        for (const std::string& name : planes) {
            if (is_at_side(name) != side ||
                (!side && are_both && type != "frustum" && !is_typed_in_clip_space))
                continue;
            const Plane plane = plane_named(sheet, name, *projection, *at);
            for (const ClipCorner& p : corners)
                for (const ClipCorner& q : corners)
                    if (auto meeting = meeting_at(sheet, name, plane, p, q, met))
                        return meeting;
        }
    return std::nullopt;
}

} // namespace

void write_meeting_point(Sheet& sheet) {
    if (const auto meeting = meeting_of(sheet))
        put_meeting(sheet, *meeting);
}

std::optional<MeetingPoint> meeting_point_of(const StepContext& step) {
    const auto meeting = meeting_of(Sheet(step));
    if (!meeting)
        return std::nullopt;
    return MeetingPoint{meeting->plane_name, meeting->p.name, meeting->q.name, meeting->t};
}

} // namespace rastertrace
