// SPDX-License-Identifier: MIT
#pragma once

// The decisions of a trace, taken again from its numbers, in the scalar that its header names. docs/trace-format.md,
// "Doing it again", says which numbers decide what, and in which order they are added and multiplied. Nothing here is
// shared with what draws: what both of them get wrong would not be found.

#include "redo.h"
#include "redo_exact.h"
#include "redo_numbers.h"

#include <rastertrace/core/draw/scene/method.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/raster/line.h>
#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/trace/record/told_samples.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/primitive_name.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <deque>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace rastertrace {

/// What a header says of the rules. What hangs on a rule that it does not say is not decided again.
struct RulesTold : ToldMethod {
    explicit RulesTold(const Trace& header);

    bool says(std::string_view key) const { return keys.contains(key); }

    ToldSamples samples;
    bool has_view_plane = false;
};

namespace redo_steps {

/// Reads a trace step by step and decides again. Real is the scene's scalar, Depth that of its depths.
/// `knows_all` is false where the trace does not tell the scalar: its numbers may be rounded.
template <typename Real, typename Depth, bool knows_all> class Redo {
public:
    explicit Redo(const Trace& trace, StepsToRedo steps = StepsToRedo::all)
        : steps_(steps), rules_(trace), method_(rules_.triangles), trace_(trace),
          canvas_(trace.canvas) {}

    Redone run() {
        for (number_ = 1; number_ <= trace_.size(); ++number_)
            try {
                if (const auto kind = trace_.kind_of(number_)) {
                    is_asked_ = steps_ == StepsToRedo::all || is_asked(trace_.step(number_), *kind);
                    redo(trace_.step(number_), *kind);
                }
            } catch (const NotTold&) {
            }
        return std::move(redone_);
    }

private:
    /// True if a step is one of those to redo, where primitives are told in doubles or in fractions.
    bool is_asked(const StepView& step, StepKind kind) {
        switch (kind) {
        case StepKind::triangulate:
        case StepKind::matrix:
        case StepKind::vertex:
        case StepKind::order:
        case StepKind::face:
        case StepKind::light:
            return steps_ == StepsToRedo::in_fractions;
        case StepKind::primitive:
            is_in_fractions_ =
                step.as<PrimitiveStep>().at.json().find('"') != std::string_view::npos;
            break;
        default:
            break;
        }
        return is_in_fractions_ == (steps_ == StepsToRedo::in_fractions);
    }

    template <typename Value>
    static const Value& told_at(const std::vector<Value>& list, std::size_t i) {
        return i < list.size() ? list[i] : throw NotTold();
    }

    using At = std::array<Real, 2>;
    struct Ends {
        std::size_t from;
        std::size_t to;
    };

    /// What was told against what comes of the numbers. `what` names the field; `of`, which of several values.
    template <typename A, typename B>
    void expect(const A& redone, const B& told, const char* what, std::string_view of = {}) {
        if (!is_asked_)
            return;
        ++redone_.count[what];
        if (redone == told)
            return;
        const WrongDecision wrong{number_, what + std::string(of), in_words(redone),
                                  in_words(told)};
        if (redone_.wrong++ == 0)
            redone_.first = wrong;
        if (redone_.wrong_steps.size() < most_wrong_steps) {
            std::string& values = redone_.wrong_steps[number_];
            values += (values.empty() ? "" : ", ") + wrong.value() + " = " + wrong.redone;
        }
    }

    void redo(const StepView& step, StepKind kind) {
        switch (kind) {
        case StepKind::triangulate:
            return redo_triangulation(step.as<TriangulateStep>());
        case StepKind::vertex:
            return redo_vertex(step.as<VertexStep>());
        case StepKind::order:
            return redo_order(step.as<OrderStep>());
        case StepKind::face:
            return redo_face(step.as<FaceStep>());
        case StepKind::light:
            return redo_light(step.as<LightStep>());
        case StepKind::primitive:
            return begin(step.as<PrimitiveStep>());
        case StepKind::edge:
            return redo_edge(step.as<EdgeStep>());
        case StepKind::half:
            return walks_.clear();
        case StepKind::crossings:
            return redo_crossings(step.as<CrossingsStep>());
        case StepKind::scanline:
            return redo_scanline(step.as<ScanlineStep>());
        case StepKind::along:
            return redo_along(step.as<AlongStep>());
        case StepKind::decide:
            return redo_decision(step.as<DecideStep>());
        case StepKind::sample:
            return redo_sample(step.as<SampleStep>());
        case StepKind::depth:
            return redo_depth(step.as<DepthStep>());
        case StepKind::pixel:
            return redo_pixel(step.as<PixelStep>());
        case StepKind::skip:
            if (step.as<SkipStep>().why == SkipReason::zero_area)
                redo_zero_area();
            return;
        default:
            return;
        }
    }

    /// The corners stand in a line, as docs/scene-format.md tells it.
    void redo_triangulation(const TriangulateStep& step) {
        using Corner = std::array<Rational, 3>;
        std::vector<Corner> corners;
        for (const auto& at : step.at.values()) {
            const auto place = numbers_of<Rational>(at);
            corners.push_back({told_at(place, 0), told_at(place, 1), told_at(place, 2)});
        }
        Corner normal{};
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Corner& p = corners[i];
            const Corner& q = corners[(i + 1) % corners.size()];
            normal[0] += (p[1] - q[1]) * (p[2] + q[2]);
            normal[1] += (p[2] - q[2]) * (p[0] + q[0]);
            normal[2] += (p[0] - q[0]) * (p[1] + q[1]);
        }
        const auto told = numbers_of<Rational>(step.normal);
        expect(std::vector<Rational>(normal.begin(), normal.end()), told, "triangulate: normal");
        std::size_t dropped = 2;
        for (const std::size_t axis : {std::size_t{1}, std::size_t{0}})
            if (abs(normal[axis]) > abs(normal[dropped]))
                dropped = axis;
        expect(std::string(1, "xyz"[dropped]), step.drops.text(), "triangulate: drops");

        const auto area = [&](std::size_t a, std::size_t b, std::size_t c) -> Rational {
            const std::size_t x = (dropped + 1) % 3;
            const std::size_t y = (dropped + 2) % 3;
            const Rational twice =
                (corners[b][x] - corners[a][x]) * (corners[c][y] - corners[a][y]) -
                (corners[b][y] - corners[a][y]) * (corners[c][x] - corners[a][x]);
            return sgn(normal[dropped]) * twice;
        };
        std::vector<std::size_t> left(corners.size());
        std::iota(left.begin(), left.end(), std::size_t{0});
        std::deque<std::size_t> line(left.begin(), left.end());
        std::vector<std::array<std::size_t, 3>> ears;
        while (left.size() > 3 && !line.empty()) {
            const std::size_t corner = line.front();
            line.pop_front();
            const auto at = static_cast<std::size_t>(std::find(left.begin(), left.end(), corner) -
                                                     left.begin());
            const std::size_t before = left[(at + left.size() - 1) % left.size()];
            const std::size_t after = left[(at + 1) % left.size()];
            const bool is_ear = area(before, corner, after) > 0 &&
                                std::none_of(left.begin(), left.end(), [&](std::size_t other) {
                                    return other != before && other != corner && other != after &&
                                           area(before, corner, other) >= 0 &&
                                           area(corner, after, other) >= 0 &&
                                           area(after, before, other) >= 0;
                                });
            if (!is_ear)
                continue;
            ears.push_back({before, corner, after});
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
            for (const std::size_t neighbor : {before, after}) {
                std::erase(line, neighbor);
                line.push_back(neighbor);
            }
        }
        ears.push_back({told_at(left, 0), told_at(left, 1), told_at(left, 2)});

        // The primitives of these names have to have these corners.
        const auto vertices = step.vertices.texts();
        const auto names = step.ears.texts();
        expect(ears.size(), names.size(), "triangulate: ears");
        for (std::size_t i = 0; i < ears.size() && i < names.size(); ++i)
            corners_of_ears_[names[i]] = {told_at(vertices, ears[i][0]),
                                          told_at(vertices, ears[i][1]),
                                          told_at(vertices, ears[i][2])};
    }

    void redo_decision(const DecideStep& step) {
        const auto in_words = [](bool is_straight) {
            return std::string(is_straight ? "straight on" : "diagonally");
        };
        const bool is_straight = step.move.text().size() == 1;
        const Rational d = exactly(step.d);
        const bool is_circle = kind_ == "circle";
        const bool steps_at_0 = is_circle || line_rules(rules_.others).ties == Ties::step;
        expect(in_words(steps_at_0 ? d < 0 : d <= 0), in_words(is_straight), "decide: move");
        if (!is_circle || !radius_)
            return;
        const At& center = told_at(at_, 0);
        const Rational x = step.x - nearest_of(exactly(offset_.in_columns(center[0])), Ties::up);
        const Rational y = step.y - nearest_of(exactly(offset_.in_rows(center[1])), Ties::up);
        const Rational r = *radius_;
        expect(Rational((x + 1) * (x + 1) + y * y - y - r * r), d, "decide: d");
    }

    void redo_vertex(const VertexStep& step) {
        const auto at = step.at.values();
        if (step.space == Space::clip)
            w_[step.name.text()] = number_of<Depth>(told_at(at, 3));
        if (!step.snapped || !rules_.says("snap"))
            return;
        const auto snapped = step.snapped.values();
        for (std::size_t i = 0; i < 2; ++i) {
            const Rational x = exactly(number_of<Real>(told_at(at, i)));
            const Index index = method_.snap == Snap::nearest
                                    ? nearest_of(x, method_.ties.value_or(Ties::up))
                                : method_.snap == Snap::floor || x > 0 ? floor_of(x)
                                                                       : ceil_of(x);
            expect(whole<Real>(index), number_of<Real>(told_at(snapped, i)), "vertex: snapped");
        }
    }

    void redo_order(const OrderStep& step) {
        const auto distances = numbers_of<Real>(step.distances);
        expect(true, std::is_sorted(distances.rbegin(), distances.rend()), "order: names",
               ", farthest first");
    }

    template <typename Number>
    static Number dot(const std::vector<Number>& a, const std::vector<Number>& b) {
        if (a.size() != 3 || b.size() != 3)
            throw NotTold();
        return Number(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
    }

    /// The product of the normal and `other`, as the face is worked out: `fixed` does that in doubles,
    /// unless nothing moves the vertices.
    void redo_product(const auto& step, const TracedList<TracedNumber>& other) {
        const auto again = [&]<typename Number>(Number) {
            expect(dot(numbers_of<Number>(step.normal), numbers_of<Number>(other)),
                   number_of<Number>(step.dot), "dot");
        };
        if (step.dot.json().starts_with('"'))
            again(Rational());
        else if (knows_all && steps_ == StepsToRedo::all)
            again(std::conditional_t<std::same_as<Depth, Rational>, double, Depth>());
    }

    void redo_face(const FaceStep& step) {
        tests_faces_ = true;
        redo_product(step, step.view);
        if (!rules_.says("cull"))
            return;
        const int sign = sgn(exactly(step.dot));
        const Cull cull = method_.cull;
        const bool is_culled = cull == Cull::both || (cull == Cull::front ? sign >= 0 : sign <= 0);
        expect(is_culled, step.culled.is_true(), "face: culled");
    }

    void redo_light(const LightStep& step) {
        redo_product(step, step.light);
        if (sgn(exactly(step.dot)) <= 0)
            expect(std::string("0"), step.intensity.text(), "light: intensity");
    }

    template <typename Number> static Number magnitude(const Number& number) {
        return number < Number(0) ? Number(-number) : number;
    }

    /// A number of the header.
    static Real in_real(const Rational& exact) { return nearest_scalar<Real>(exact); }

    void begin(const PrimitiveStep& step) {
        kind_ = step.kind.text();
        const SampleOffset<Rational>& offset = rules_.samples.of(step.kind);
        offset_ = {in_real(offset.x()), in_real(offset.y())};
        names_ = step.vertices.texts();
        if (const auto ear = corners_of_ears_.find(step.name.text()); ear != corners_of_ears_.end())
            expect(ear->second, names_, "triangulate: corners");
        at_.clear();
        for (const auto& at : step.at.values()) {
            const auto place = numbers_of<Real>(at);
            at_.push_back({told_at(place, 0), told_at(place, 1)});
        }
        depths_ = numbers_of<Depth>(step.depths);
        radius_ = step.radius;
        color_ = step.color.color().value_or(Color());
        colors_.clear();
        for (const TracedColor& color : step.colors.values())
            colors_.push_back(color.color().value_or(Color()));
        ways_.clear();
        edges_.clear();
        functions_.clear();
        walks_.clear();
        spans_.clear();
        row_.reset();
        side_ = {0, kind_ == "point" ? 0U : 1U};
        if (kind_ == "triangle" && at_.size() == 3 && depths_.size() == 3) {
            FaceOnScreen& face = faces_[step.name.text()];
            for (std::size_t i = 0; i < 3; ++i) {
                face.corners[i] = {depth_number(at_[i][0]), depth_number(at_[i][1])};
                face.depths[i] = depths_[i];
            }
        }
        along_before_.reset();
        weights_.clear();
    }

    /// How a primitive leads along an edge: from its first vertex to its second, or the other way. A polygon may do both.
    struct Way {
        Ends ends;
        bool leads_on = false;
        bool leads_back = false;
    };

    /// The edges of the current primitive by their names.
    const std::map<std::string, Way>& ways() {
        if (!ways_.empty())
            return ways_;
        const std::vector<std::string_view> views(names_.begin(), names_.end());
        const std::string separator(name_separator(views));
        const std::size_t count = names_.size();
        const auto way = [&](std::size_t from, std::size_t to) -> Way& {
            return ways_.try_emplace(names_[from] + separator + names_[to], Way{{from, to}})
                .first->second;
        };
        for (std::size_t from = 0; count > 1 && from < count; ++from) {
            const std::size_t to = (from + 1) % count;
            way(from, to).leads_on = true;
            way(to, from).leads_back = true;
        }
        return ways_;
    }

    Ends ends_of(const std::string& name) {
        const auto way = ways().find(name);
        if (way == ways_.end() ||
            std::max(way->second.ends.from, way->second.ends.to) >= at_.size())
            throw NotTold();
        return way->second.ends;
    }

    /// a (x - x1) + b (y - y1).
    struct Function {
        At from;
        Real a;
        Real b;
        bool is_top_left;
        bool admits(const Real& x, const Real& y) const {
            const Real value = a * (x - from[0]) + b * (y - from[1]);
            return is_top_left ? !(value < Real(0)) : Real(0) < value;
        }
    };

    void redo_edge(const EdgeStep& step) {
        const std::string name = step.edge.text();
        const Ends ends = ends_of(name);
        const At& p = at_[ends.from];
        const At& q = at_[ends.to];
        if (step.octant) {
            side_ = ends;
            along_before_.reset();
            return;
        }
        if (step.a) {
            const Function f{p, number_of<Real>(step.a), number_of<Real>(step.b),
                             step.top_left.is_true()};
            if (knows_all) {
                const bool is_turned = f.a != Real(p[1] - q[1]) || f.b != Real(q[0] - p[0]);
                expect(Real(is_turned ? q[1] - p[1] : p[1] - q[1]), f.a, "edge: a");
                expect(Real(is_turned ? p[0] - q[0] : q[0] - p[0]), f.b, "edge: b");
            }
            functions_[name] = f;
            if (!rules_.says("fill"))
                return;
            const int down = canvas_of_samples(method_, canvas_).down();
            const bool is_top = f.a == Real(0) && Real(0) < Real(f.b * Real(down));
            expect(Real(0) < f.a || is_top, f.is_top_left, "edge: top_left");
            return;
        }
        if (!step.dx_dy.has_number()) {
            expect(p[1] == q[1], true, "edge: horizontal");
            edges_[name] = std::nullopt;
            return;
        }
        const auto slope = number_of<Real>(step.dx_dy);
        if (knows_all)
            expect(Real((q[0] - p[0]) / (q[1] - p[1])), slope, "edge: dx_dy");
        edges_[name] = slope;
    }

    /// x of an edge on row y.
    Real x_of(const std::string& edge, Index y) {
        const Ends ends = ends_of(edge);
        const auto slope = edges_.find(edge);
        if (slope == edges_.end())
            throw NotTold();
        if (!slope->second)
            return at_[ends.from][0];
        const auto before = walks_.find(edge);
        // A polygon may lead along an edge more than once.
        if (before != walks_.end() && before->second.first == y)
            return before->second.second;
        Real x = at_[ends.from][0] + *slope->second * (offset_.y_of(y) - at_[ends.from][1]);
        if (method_.lerp == LerpForm::incremental && before != walks_.end())
            x = y > before->second.first ? Real(before->second.second + *slope->second)
                                         : Real(before->second.second - *slope->second);
        walks_[edge] = {y, x};
        return x;
    }

    struct Row {
        Index y;
        Index from;
        Index to;
        Real left;
        Real right;
        std::optional<Depth> left_depth;
        std::optional<Depth> right_depth;
    };

    /// A span of a polygon in a row.
    struct Span {
        std::string left_edge;
        std::string right_edge;
        Real left;
        Real right;
    };

    void redo_crossings(const CrossingsStep& step) {
        spans_.clear();
        const auto edges = step.edges.texts();
        const auto x = numbers_of<Real>(step.x);
        const auto told = numbers_of<Rational>(step.winding);
        std::size_t left = edges.size(); // of a span that is open
        Rational winding = 0;
        for (std::size_t i = 0; i < edges.size(); ++i) {
            const auto way = ways().find(edges[i]);
            if (way == ways_.end())
                throw NotTold();
            const Rational down = winding + 1;
            const Rational up = winding - 1;
            winding = told_at(told, i);
            const bool is_down =
                way->second.leads_on && (winding == down || !way->second.leads_back);
            expect(is_down ? down : up, winding, "crossings: winding");
            if (knows_all)
                expect(x_of(edges[i], step.y), told_at(x, i), "crossings: x");
            if (i > 0)
                expect(!(told_at(x, i) < x[i - 1]), true, "crossings: x", " in order");
            if (abs(winding) > Rational(most_corners))
                throw NotTold(); // no polygon runs around so often
            const bool is_in =
                is_inside(static_cast<int>(nearest_double(winding)), method_.fill_rule);
            if (left == edges.size() && is_in)
                left = i;
            if (left != edges.size() && !is_in) {
                spans_.push_back({edges[left], edges[i], told_at(x, left), told_at(x, i)});
                left = edges.size();
            }
        }
        expect(winding, Rational(0), "crossings: winding", " behind the last edge");
    }

    /// The ends of a row become its first and its last pixel.
    void expect_rounded(const Row& row) {
        if (!rules_.says("rounding"))
            return;
        const SpanRounding rule = span_rounding(method_);
        const auto pixel_at = [&](const Real& end, bool is_last) {
            return pixel_of(exactly(offset_.in_columns(end)), rule, is_last);
        };
        expect(pixel_at(row.left, false), row.from, "scanline: from");
        expect(pixel_at(row.right, true), row.to, "scanline: to");
    }

    /// A span of a polygon is one of those between its row's crossings.
    void redo_span(const Row& row, const std::string& left_edge, const std::string& right_edge) {
        expect_rounded(row);
        if (spans_.empty() || !rules_.says("fill_rule"))
            return;
        const auto found = std::find_if(spans_.begin(), spans_.end(), [&](const Span& span) {
            return span.left_edge == left_edge && span.right_edge == right_edge;
        });
        expect(found != spans_.end(), true, "scanline: is inside");
        if (found == spans_.end())
            return;
        expect(found->left, row.left, "scanline: left");
        expect(found->right, row.right, "scanline: right");
    }

    void redo_scanline(const ScanlineStep& step) {
        Row row{step.y, step.from, step.to, number_of<Real>(step.left), number_of<Real>(step.right),
                {},     {}};
        const std::string left_edge = step.left_edge.text();
        const std::string right_edge = step.right_edge.text();
        row_ = row;
        if (kind_ == "polygon")
            return redo_span(row, left_edge, right_edge);
        if (!rules_.says("fill"))
            return;
        if (method_.fill == Fill::top_left) {
            redo_top_left(row, left_edge, right_edge);
        } else {
            expect_rounded(row);
            if (knows_all) {
                expect(x_of(left_edge, row.y), row.left, "scanline: left");
                expect(x_of(right_edge, row.y), row.right, "scanline: right");
            }
            if (step.left_depth) {
                row.left_depth = number_of<Depth>(step.left_depth);
                row.right_depth = number_of<Depth>(step.right_depth);
                if (knows_all) {
                    expect(depth_on(left_edge, row.y), *row.left_depth, "scanline: left_depth");
                    expect(depth_on(right_edge, row.y), *row.right_depth, "scanline: right_depth");
                }
            }
        }
        row_ = row;
    }

    const Function& function_of(const std::string& edge) const {
        const auto found = functions_.find(edge);
        return found == functions_.end() ? throw NotTold() : found->second;
    }

    /// The samples between two edges are those that both admit.
    void redo_top_left(const Row& row, const std::string& left_edge,
                       const std::string& right_edge) {
        const Function& left = function_of(left_edge);
        const Function& right = function_of(right_edge);
        const Real y = whole<Real>(row.y) + offset_.y();
        for (int column = canvas_.left(); column <= canvas_.right(); ++column) {
            const Real x = Real(column) + offset_.x();
            expect(left.admits(x, y), row.from <= column, "scanline: left admits",
                   fmt::format(" x = {}", column));
            expect(right.admits(x, y), column <= row.to, "scanline: right admits",
                   fmt::format(" x = {}", column));
        }
        if (std::floating_point<Real>)
            return;
        expect(ceil_of(exactly(row.left) - exactly(offset_.x())), row.from, "scanline: from");
        expect(ceil_of(exactly(row.right) - exactly(offset_.x())) - 1, row.to, "scanline: to");
    }

    static Depth depth_number(const Real& x) {
        if constexpr (std::same_as<Real, Depth>)
            return x;
        else
            return nearest_double(x);
    }

    SampleOffset<Depth> depth_offset() const {
        return {depth_number(offset_.x()), depth_number(offset_.y())};
    }

    Depth depth_on(const std::string& edge, Index y) {
        const auto [from, to] = ends_of(edge);
        const Depth y1 = depth_number(at_[from][1]);
        const Depth height = depth_number(at_[to][1]) - y1;
        if (height == Depth(0))
            return told_at(depths_, from);
        const Depth rise = told_at(depths_, to) - told_at(depths_, from);
        return Depth(told_at(depths_, from) + rise * (depth_offset().y_of(y) - y1) / height);
    }

    static Depth finite_or_zero(const Depth& slope) {
        if constexpr (std::floating_point<Depth>)
            return std::isfinite(slope) ? slope : Depth(0);
        else
            return slope;
    }

    /// The depth of the primitive in a pixel, as its fill finds it.
    Depth depth_at(Index column, Index y) const {
        const Depth x = whole<Depth>(column);
        if (kind_ != "triangle")
            return point_of_line(column, y).depth;
        if (row_ && row_->left_depth) {
            const bool is_rounded = method_.depth_at == DepthAt::rounded_ends;
            const auto end_at = [&](Index pixel, const Real& end) {
                return is_rounded ? whole<Depth>(pixel)
                                  : depth_offset().in_columns(depth_number(end));
            };
            const Depth left = end_at(row_->from, row_->left);
            const Depth right = end_at(row_->to, row_->right);
            const Depth width = right - left;
            if (!(Depth(0) < width))
                return *row_->left_depth;
            const Depth slope =
                finite_or_zero(Depth((*row_->right_depth - *row_->left_depth) / width));
            return Depth(*row_->left_depth + slope * (std::clamp(x, left, right) - left));
        }
        const Depth ab = told_at(depths_, 1) - told_at(depths_, 0);
        const Depth ac = told_at(depths_, 2) - told_at(depths_, 0);
        need_corners();
        if (weights_.size() == 3)
            return Depth(depths_[0] + depth_number(weights_[1]) * ab +
                         depth_number(weights_[2]) * ac);
        std::array<std::array<Depth, 2>, 3> p;
        for (std::size_t i = 0; i < 3; ++i)
            p[i] = {depth_number(at_[i][0]), depth_number(at_[i][1])};
        const Depth abx = p[1][0] - p[0][0];
        const Depth aby = p[1][1] - p[0][1];
        const Depth acx = p[2][0] - p[0][0];
        const Depth acy = p[2][1] - p[0][1];
        const Depth area2 = abx * acy - acx * aby;
        if (area2 == Depth(0))
            return depths_[0];
        const Depth along_x = finite_or_zero(Depth((ab * acy - ac * aby) / area2));
        const Depth along_y = finite_or_zero(Depth((ac * abx - ab * acx) / area2));
        const Depth x0 = p[0][0] - depth_number(offset_.x());
        const Depth y0 = p[0][1] - depth_number(offset_.y());
        const Depth on_row = depths_[0] + along_y * (whole<Depth>(y) - y0);
        return Depth(on_row + along_x * (x - x0));
    }

    bool larger_passes() const {
        if (method_.depth_compare != DepthCompare::automatic)
            return method_.depth_compare == DepthCompare::greater;
        return method_.depth == rastertrace::Depth::inverse_z ||
               (method_.depth == rastertrace::Depth::ndc_z && rules_.has_view_plane);
    }

    void redo_depth(const DepthStep& step) {
        const Index x = step.x;
        const Index y = step.y;
        const bool passes = step.pass.is_true();
        if (knows_all)
            expect(depth_at(x, y), number_of<Depth>(step.depth), "depth: depth");
        if (!rules_.says("depth"))
            return;
        const bool is_face = kind_ == "triangle";
        const auto is_nearer = [this](const TracedNumber& a, const TracedNumber& b) {
            const auto one = number_of<Depth>(a);
            const auto other = number_of<Depth>(b);
            return larger_passes() ? other < one : one < other;
        };
        const auto face = face_depths_.find({x, y});
        const auto thin = thin_depths_.find({x, y});
        const bool has_face = face != face_depths_.end();
        const bool has_thin = thin != thin_depths_.end();
        const bool is_thin_nearer =
            has_thin && !(has_face && is_nearer(face->second, thin->second.depth));
        const bool lets_pass = step.side_of || step.beside;
        const bool is_by_thin = has_thin && (is_thin_nearer || (!is_face && !passes)) && !lets_pass;
        if (step.behind) {
            expect(false, passes, "depth: behind");
            if (knows_all)
                redo_behind(step.behind.text(), x, y);
        } else if (!step.stored.has_number()) {
            expect(true, passes, "depth: pass");
        } else if (lets_pass) {
            expect(is_nearer(step.stored, step.depth), passes, "depth: passes a nearer one");
        } else {
            const bool is_thinner =
                is_by_thin ? thickness() < thin->second.thickness : has_face && !is_face;
            expect(is_thinner ? !is_nearer(step.stored, step.depth)
                              : is_nearer(step.depth, step.stored),
                   passes, "depth: pass");
            if (knows_all && (has_thin || has_face)) {
                const TracedNumber& stored = is_by_thin ? thin->second.depth : face->second;
                if (is_fraction(stored) == is_fraction(step.stored))
                    expect(stored, step.stored, "depth: stored");
            }
        }
        if (is_face && (passes || (has_face && is_nearer(step.depth, face->second))))
            face_depths_[{x, y}] = step.depth;
        else if (!is_face && passes)
            thin_depths_[{x, y}] = {step.depth, thickness()};
    }

    /// A point 1, a line 2, a face 3.
    int thickness() const { return kind_ == "point" ? 1 : kind_ == "triangle" ? 3 : 2; }

    /// A line's own point at a step of its major axis, and its depth.
    struct LinePoint {
        std::array<Depth, 2> at;
        Depth depth;
    };
    LinePoint point_of_line(Index column, Index y) const {
        const auto place = [this](std::size_t i) {
            const At& at = told_at(at_, i);
            return std::array<Depth, 2>{depth_number(at[0]), depth_number(at[1])};
        };
        const auto from = place(side_.from);
        const auto to = place(side_.to);
        const Depth first = told_at(depths_, side_.from);
        const Depth last = told_at(depths_, side_.to);
        const std::size_t along =
            magnitude(Depth(to[0] - from[0])) < magnitude(Depth(to[1] - from[1])) ? 1 : 0;
        const Depth run = to[along] - from[along];
        if (run == Depth(0))
            return {from, larger_passes() == (first < last) ? last : first};
        const SampleOffset<Depth> offset = depth_offset();
        const Depth sample = along == 0 ? offset.x_of(column) : offset.y_of(y);
        const Depth way = sample - from[along];
        const Depth part = std::clamp(Depth(way / run), Depth(0), Depth(1));
        LinePoint point;
        for (std::size_t i = 0; i < 2; ++i)
            point.at[i] = from[i] + (to[i] - from[i]) * part;
        point.depth = first + (last - first) * part;
        return point;
    }

    /// A face that is told to hide a line's point covers it and is nearer there, in exact numbers.
    void redo_behind(const std::string& face, Index x, Index y) {
        const auto known = faces_.find(face);
        if constexpr (std::same_as<Depth, Rational>) {
            if (known == faces_.end())
                return; // clipping has cut it
            const LinePoint point = point_of_line(x, y);
            const auto& [corners, depths] = known->second;
            Rational area = 0;
            Rational of_face = 0;
            bool has_positive = false;
            bool has_negative = false;
            for (std::size_t i = 0; i < 3; ++i) {
                const auto& q = corners[(i + 1) % 3];
                const auto& r = corners[(i + 2) % 3];
                const Rational weight = (q[0] - point.at[0]) * (r[1] - point.at[1]) -
                                        (r[0] - point.at[0]) * (q[1] - point.at[1]);
                has_positive = has_positive || weight > 0;
                has_negative = has_negative || weight < 0;
                area += weight;
                of_face += weight * depths[i];
            }
            expect(has_positive && has_negative, false, "depth: behind covers");
            expect(area != 0, true, "depth: behind covers");
            const Rational deep = of_face / area;
            expect(larger_passes() ? point.depth < deep : deep < point.depth, true,
                   "depth: behind is nearer");
        }
    }

    void redo_along(const AlongStep& step) {
        const bool is_x_major = step.x.has_value();
        const std::size_t along = is_x_major ? 0 : 1;
        const std::size_t across = 1 - along;
        At from = told_at(at_, side_.from);
        At to = told_at(at_, side_.to);
        if (rules_.others.from == LineStart::low && to[along] < from[along])
            std::swap(from, to);

        if (!is_x_major && !step.y)
            throw NotTold();
        const Index at = is_x_major ? *step.x : *step.y;
        const auto value = number_of<Real>(step.value);
        if (rules_.others.line == LineMethod::diamond_exit)
            return redo_in_diamond(from, to, is_x_major, at, value, step.pixel);
        if (knows_all) {
            const Real run = to[along] - from[along];
            const Real sample = is_x_major ? offset_.x_of(at) : offset_.y_of(at);
            const Real m = run == Real(0) ? Real(0) : Real((to[across] - from[across]) / run);
            Real redone = rules_.others.line == LineMethod::naive
                              ? Real(m * sample + (from[across] - m * from[along]))
                              : Real(from[across] + m * (sample - from[along]));
            if (rules_.others.line == LineMethod::dda && along_before_)
                redone = at > along_before_->first ? Real(along_before_->second + m)
                                                   : Real(along_before_->second - m);
            expect(redone, value, "along: value");
        }
        along_before_ = {at, value};
        if (!rules_.says("rounding"))
            return;
        SpanRounding rule = line_rounding(rules_.others);
        const bool falls = to[across] < from[across];
        if (rule.rounding == Rounding::nearest && rule.ties == Ties::start && falls)
            rule.ties = Ties::up;
        else if (rule.rounding == Rounding::nearest && rule.ties == Ties::step && falls)
            rule.ties = Ties::start;
        const Real in_pixels = is_x_major ? offset_.in_rows(value) : offset_.in_columns(value);
        expect(pixel_of(exactly(in_pixels), rule, false), step.pixel, "along: pixel");
    }

    /// The pixel of a line in a column, or row, whose diamond it goes through. Ties are those of a line with y up.
    void redo_in_diamond(const At& from, const At& to, bool is_x_major, Index at, const Real& value,
                         Index pixel) {
        const std::size_t along = is_x_major ? 0 : 1;
        const std::size_t across = 1 - along;
        const Real run = to[along] - from[along];
        const Real rise = to[across] - from[across];
        const Real m = run == Real(0) ? Real(0) : Real(rise / run);
        if (knows_all)
            expect(
                Real(from[across] + m * (whole<Real>(at) +
                                         (is_x_major ? offset_.x() : offset_.y()) - from[along])),
                value, "along: value");
        if (!rules_.says("line"))
            return;
        const bool turns = is_x_major && canvas_.down() > 0;
        const bool rises = is_x_major && (turns ? m < Real(0) : Real(0) < m);
        const Rational among_samples =
            exactly(Real(value - (is_x_major ? offset_.y() : offset_.x())));
        const Index nearest = nearest_of(turns ? Rational(-among_samples) : among_samples,
                                         rises ? Ties::up : Ties::start);
        expect(turns ? -nearest : nearest, pixel, "along: pixel");
    }

    void need_corners() const {
        if (at_.size() != 3)
            throw NotTold();
    }

    Real area2() const {
        need_corners();
        const Real abx = at_[1][0] - at_[0][0];
        const Real aby = at_[1][1] - at_[0][1];
        const Real acx = at_[2][0] - at_[0][0];
        const Real acy = at_[2][1] - at_[0][1];
        return Real(abx * acy - acx * aby);
    }

    /// The weights of the corners in a pixel's sample.
    std::vector<Real> weights_in(Index column, Index row) const {
        need_corners();
        const Real abx = at_[1][0] - at_[0][0];
        const Real aby = at_[1][1] - at_[0][1];
        const Real acx = at_[2][0] - at_[0][0];
        const Real acy = at_[2][1] - at_[0][1];
        const Real all = area2();
        const Real pax = at_[0][0] - (whole<Real>(column) + offset_.x());
        const Real pay = at_[0][1] - (whole<Real>(row) + offset_.y());
        const Real b = acx * pay - pax * acy;
        const Real c = pax * aby - abx * pay;
        const Real a = all - b - c;
        return {Real(a / all), Real(b / all), Real(c / all)};
    }

    void redo_sample(const SampleStep& step) {
        weights_ = numbers_of<Real>(step.weights);
        if (knows_all)
            expect(weights_in(step.x, step.y), weights_, "sample: weights");
        if (!rules_.says("fill"))
            return;
        const bool has_negative = std::any_of(weights_.begin(), weights_.end(),
                                              [](const Real& weight) { return weight < Real(0); });
        expect(!has_negative, step.inside.is_true(), "sample: inside");
    }

    void redo_zero_area() {
        const bool is_told = rules_.says("scalar") && rules_.says("fill");
        if (at_.size() != 3 || tests_faces_ || !is_told) // faces have a normal
            return;
        if (method_.fill == Fill::barycentric)
            expect(area2(), Real(0), "skip: why");
        if (method_.fill == Fill::top_left) {
            // The edge function of the upper and the lower corner in the middle one.
            std::array<At, 3> p{at_[0], at_[1], at_[2]};
            std::sort(p.begin(), p.end(), [this](const At& a, const At& b) {
                if (a[1] != b[1])
                    return (canvas_.down() > 0) == (a[1] < b[1]);
                return a[0] < b[0];
            });
            const Function f{p[0], p[0][1] - p[2][1], p[2][0] - p[0][0], true};
            const bool is_on_it =
                f.admits(p[1][0], p[1][1]) &&
                Function{f.from, Real(-f.a), Real(-f.b), true}.admits(p[1][0], p[1][1]);
            expect(is_on_it, true, "skip: why");
        }
    }

    void redo_pixel(const PixelStep& step) {
        if (row_) {
            expect(row_->y == step.y && row_->from <= step.x && step.x <= row_->to, true,
                   "pixel: in its row");
        }
        if (kind_ != "triangle" || method_.fill == Fill::fan || at_.size() != 3)
            return;
        const Color told = step.color.color().value_or(color_);
        if (!colors_.empty() && colors_.size() != 3)
            throw NotTold();
        // Colors are mixed in the sample; of a fill that has rows, the header does not tell where that is.
        if (colors_.empty() || !rules_.says("scalar") || !rules_.says("sample"))
            return;
        if (colors_[0] == colors_[1] && colors_[0] == colors_[2]) {
            expect(colors_[0], told, "pixel: color");
        } else if (knows_all || !is_in_perspective()) {
            if (area2() == Real(0))
                expect(color_, told, "pixel: color");
            else
                expect(color_at(step.x, step.y), told, "pixel: color");
        }
    }

    bool is_in_perspective() const {
        return std::find(trace_.stages.begin(), trace_.stages.end(), "perspective") !=
               trace_.stages.end();
    }

    Color color_at(Index x, Index y) const {
        const std::vector<Real> weights = weights_in(x, y);
        if (is_in_perspective()) {
            std::array<Depth, 3> inverse_w;
            for (std::size_t i = 0; i < 3; ++i) {
                const auto known = w_.find(told_at(names_, i));
                inverse_w[i] = Depth(Depth(1) / (known == w_.end() ? Depth(1) : known->second));
            }
            if (inverse_w[0] != inverse_w[1] || inverse_w[0] != inverse_w[2]) {
                std::vector<Depth> in_space;
                for (std::size_t i = 0; i < 3; ++i)
                    in_space.push_back(Depth(depth_number(weights[i]) * inverse_w[i]));
                const Depth sum = in_space[0] + in_space[1] + in_space[2];
                if (Depth(0) < sum)
                    for (Depth& share : in_space)
                        share = Depth(share / sum);
                else
                    for (std::size_t i = 0; i < 3; ++i)
                        in_space[i] = depth_number(weights[i]);
                return mixed(in_space);
            }
        }
        return mixed(weights);
    }

    template <typename Weight> Color mixed(const std::vector<Weight>& weights) const {
        const auto mix = [&](std::uint8_t (Color::*channel)() const) {
            const int a = (colors_[0].*channel)();
            const int b = (colors_[1].*channel)();
            const int c = (colors_[2].*channel)();
            if (a == b && a == c)
                return static_cast<std::uint8_t>(a);
            const Weight level = Weight(Weight(0) + weights[0] * Weight(a)) +
                                 weights[1] * Weight(b) + weights[2] * Weight(c);
            const Index rounded = method_.color_rounding == ColorRounding::truncate
                                      ? floor_of(exactly(level))
                                      : nearest_of(exactly(level), Ties::up);
            return static_cast<std::uint8_t>(std::clamp<Index>(rounded, 0, 255));
        };
        return {mix(&Color::red), mix(&Color::green), mix(&Color::blue),
                std::max<std::uint8_t>(mix(&Color::alpha), 1)};
    }

    static bool is_fraction(const TracedNumber& told) { return told.json().starts_with('"'); }

    StepsToRedo steps_;
    bool is_asked_ = true;         ///< the step is one of those
    bool is_in_fractions_ = false; ///< the primitive is told in fractions
    RulesTold rules_;
    const Method& method_; ///< what holds for triangles
    const Trace& trace_;
    SampleOffset<Real> offset_; ///< of the samples of the current primitive
    Canvas canvas_;
    Redone redone_;
    std::size_t number_ = 0; ///< of the step
    bool tests_faces_ = false;
    std::map<std::string, std::vector<std::string>> corners_of_ears_; ///< by their names
    std::string kind_;
    std::vector<std::string> names_;
    std::map<std::string, Way> ways_; ///< once one was asked for
    std::vector<At> at_;
    std::vector<Depth> depths_;
    std::optional<Index> radius_; ///< of a circle
    std::vector<Span> spans_;     ///< of a polygon, in the row of the crossings before
    Color color_;
    std::vector<Color> colors_;
    std::map<std::string, std::optional<Real>> edges_; ///< dx/dy; none of a horizontal one
    std::map<std::string, Function> functions_;        ///< by the edge's name
    std::map<std::string, std::pair<Index, Real>>
        walks_; ///< where an edge was last, and at which row
    std::optional<Row> row_;
    Ends side_{};
    std::optional<std::pair<Index, Real>> along_before_;
    std::vector<Real> weights_;
    struct Thin {
        TracedNumber depth;
        int thickness;
    };
    std::map<std::pair<Index, Index>, TracedNumber> face_depths_; ///< the nearest face's
    std::map<std::pair<Index, Index>, Thin> thin_depths_;         ///< the nearest point's or line's
    struct FaceOnScreen {
        std::array<std::array<Depth, 2>, 3> corners;
        std::array<Depth, 3> depths;
    };
    std::map<std::string, FaceOnScreen> faces_; ///< by name
    std::map<std::string, Depth> w_;
};

} // namespace redo_steps

} // namespace rastertrace
