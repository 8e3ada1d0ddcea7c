// SPDX-License-Identifier: MIT
#include "redo_drawn.h"

#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/draw/screen_drawing.h>
#include <rastertrace/trace/record/step_tracer.h>
#include <rastertrace/trace/record/steps.h>
#include <rastertrace/trace/text/pipeline_names.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace rastertrace {

namespace {

/// The steps of a primitive's drawing. Each hangs on those of the rows before its own: they are only looked at if these
/// are right, so that one wrong number is not told again and again.
constexpr std::array<StepKindSet, 4> stages_of_drawing{
    StepKindSet{StepKind::primitive, StepKind::edge, StepKind::half, StepKind::skip},
    {StepKind::ray, StepKind::crossings, StepKind::scanline, StepKind::along, StepKind::decide,
     StepKind::sample},
    {StepKind::depth},
    {StepKind::pixel, StepKind::reject}};

/// A number in the scalar that a piece is drawn with.
template <typename Scalar> Scalar coordinate_of(const TracedNumber& told) {
    if constexpr (is_fraction<Scalar>) {
        const auto numerator = nearest_numerator(exactly(told), fixed_grid);
        return numerator ? Scalar(*numerator, fixed_grid) : throw NotTold();
    } else {
        return number_of<Scalar>(told);
    }
}

/// The method of a scene whose header says this, with two values for triangles and for all else.
Method method_of(const ToldMethod& rules) {
    Method method = rules.triangles;
    const auto join = [&](auto Method::*choice) {
        if (rules.others.*choice != rules.triangles.*choice)
            method.*choice = std::nullopt;
    };
    join(&Method::rounding);
    join(&Method::ties);
    const Sample of_triangles = sample_of_others(rules.triangles);
    method.sample = of_triangles;
    if (sample_of_others(rules.others) != of_triangles &&
        traits_of(method.fill).sample == of_triangles)
        method.sample = std::nullopt;
    method.mistakes.clear(); // what they do is wrong
    return method;
}

/// A value as a message tells it: a list as (1, 2).
std::string value_text(std::string_view json) {
    return json.starts_with('[') ? "(" + joined(TracedList<TracedValue>(json).texts(), ", ") + ")"
                                 : TracedValue(json).text();
}

/// What a step is found by among those of its kind.
std::string key_of(const StepView& step, StepKind kind) {
    std::string key;
    for (const StepField& field : fields_of(kind))
        if (field.role == FieldRole::key)
            if (const auto value = step.field(field.name))
                key.append(field.name).append(*value);
    return key;
}

} // namespace

DrawnAgain::DrawnAgain(const Trace& trace, Findings& findings)
    : trace_(trace), rules_(trace.method), findings_(findings) {
    scene_.canvas = trace.canvas;
    scene_.method = method_of(rules_);
    const std::string projection = trace.projection.substr(0, trace.projection.find(','));
    scene_.projection.type = projection_named(projection).value_or(ProjectionType::none);
    find_depths();
    const bool has_any_fractions = trace.numbers == "fractions of any size";
    if (!rules_.says("scalar")) { // what goes from pixel to pixel
        draw_ = drawing_in<Rational>();
        return;
    }
    switch (rules_.triangles.scalar) {
    case ScalarKind::single_precision:
        draw_ = drawing_in<float>();
        break;
    case ScalarKind::double_precision:
        draw_ = drawing_in<double>();
        break;
    case ScalarKind::fixed:
        draw_ = has_any_fractions ? drawing_in<Rational>() : drawing_in<Fraction64>();
        break;
    case ScalarKind::adaptive:
        draw_ = drawing_in<double>();
        draw_in_fractions_ = drawing_in<Rational>();
        break;
    case ScalarKind::exact:
        draw_ = drawing_in<Rational>();
        break;
    }
}

/// Finds which pixels have a depth, the depth that nothing has drawn, and which one passes.
void DrawnAgain::find_depths() {
    if (!rules_.says("depth"))
        return;
    double left = 0, right = -1, low = 0, high = -1;
    std::optional<DepthStep> first;
    std::array<bool, 2> are_told{}; ///< in numbers, and in fractions
    for (const std::size_t n : trace_.steps_of({StepKind::primitive, StepKind::depth})) {
        if (trace_.kind_of(n) == StepKind::depth) {
            if (!first)
                first = trace_.step(n).as<DepthStep>();
            continue;
        }
        const auto step = trace_.step(n).as<PrimitiveStep>();
        if (!step.depths)
            continue;
        are_told[step.depths.json().find('"') == std::string_view::npos ? 0 : 1] = true;
        for (const auto& at : step.at.values()) {
            const auto place = at.values();
            if (place.size() != 2 || !place[0].exact() || !place[1].exact())
                continue;
            const double x = place[0].nearest_double().value_or(0);
            const double y = place[1].nearest_double().value_or(0);
            const bool is_first = right < left;
            left = is_first ? x : std::min(left, x);
            right = is_first ? x : std::max(right, x);
            low = is_first ? y : std::min(low, y);
            high = is_first ? y : std::max(high, y);
        }
    }
    if (right < left || !first)
        return;
    mixes_numbers_ = are_told[0] && are_told[1];
    constexpr Index around = 3; // as far as rounding, and a face next to a line, may reach
    const Canvas& canvas = scene_.canvas;
    const auto [top, bottom] =
        std::minmax({canvas.row_of(floor_index(low)), canvas.row_of(ceil_index(high))});
    const auto column = [&](Index x) {
        return static_cast<int>(std::clamp<Index>(x, canvas.left(), canvas.right()));
    };
    const auto row = [&](Index at) {
        return static_cast<int>(std::clamp<Index>(at, 0, canvas.height - 1));
    };
    const int first_column = column(floor_index(left) - around);
    const int first_row = row(top - around);
    const DepthRegion region{first_column, first_row,
                             column(ceil_index(right) + around) - first_column + 1,
                             row(bottom + around) - first_row + 1};
    if (region.area() > most_depths_redone)
        return;
    region_ = region;
    if (first->stored.exact())
        cleared_ = first->stored;

    const Method& method = rules_.triangles;
    const bool is_view_plane = scene_.projection.type == ProjectionType::view_plane;
    if (method.depth_compare != DepthCompare::automatic)
        larger_passes_ = method.depth_compare == DepthCompare::greater;
    else if (method.depth == Depth::ndc_z && !is_view_plane) // `depth_range` may turn it round
        larger_passes_ =
            cleared_ && first->depth.exact() && *cleared_->exact() < *first->depth.exact();
    else
        larger_passes_ = method.depth == Depth::inverse_z || method.depth == Depth::ndc_z;
}

template <typename Scalar> DrawnAgain::Draw DrawnAgain::drawing_in() {
    using D = DepthOf<Scalar>;
    DepthRule<D> rule{.larger_passes = larger_passes_};
    if (cleared_)
        rule.cleared = number_of<D>(*cleared_);
    const auto drawing = std::make_shared<ScreenDrawing<Scalar>>(
        scene_, is_fraction<Scalar> ? fixed_grid : 1, region_, rule);
    const auto inverse = [is_fixed = rules_.triangles.scalar == ScalarKind::fixed](
                             const TracedNumber& w) { // `fixed` moves vertices in doubles
        return is_fixed ? D(1 / number_of<double>(w)) : D(D(1) / number_of<D>(w));
    };
    return [drawing, inverse, rounding = scene_.method.color_rounding](const ToldPiece& told,
                                                                       const Listener& listener) {
        const auto corners = told.step.at.values();
        const std::string name = told.step.name.text();
        Piece<Scalar> piece{
            .kind = told.kind, .color = told.step.color.color().value_or(Color()), .colors = {}};
        piece.primitive = told.primitive;
        piece.is_part = told.step.part.is_true();
        piece.radius = told.step.radius.value_or(0);
        piece.colors.fill(piece.color);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const auto at = corners[i].values();
            const Vec<Scalar, 2> position{coordinate_of<Scalar>(told_at(at, 0)),
                                          coordinate_of<Scalar>(told_at(at, 1))};
            if (traits_of(told.kind).has_ring) {
                piece.ring.push_back(position);
                piece.ring_vertices.push_back(told.vertices[i]);
                continue;
            }
            ++piece.count;
            piece.positions[i] = position;
            piece.vertices[i] = told.vertices[i];
            if (told.stages.tests_depth)
                piece.depths[i] = number_of<D>(told_at(told.step.depths.values(), i));
            if (!told.colors.empty())
                piece.colors[i] = told.colors[i];
            if (!told.w.empty())
                piece.inverse_w[i] = inverse(told.w[i]);
        }
        for (const auto& levels : told.step.levels.values()) {
            const std::vector<D> channels = numbers_of<D>(levels);
            for (std::size_t i = 0; auto& channel : piece.levels.emplace_back().of)
                channel = told_at(channels, i++);
        }
        for (std::size_t i = 0; i < std::min<std::size_t>(piece.count, piece.levels.size()); ++i)
            piece.colors[i] = piece.levels[i].rounded(rounding);
        return drawing->draw({.piece = std::move(piece),
                              .name = name,
                              .corners = {told.names.begin(), told.names.end()},
                              .stages = told.stages},
                             listener);
    };
}

void DrawnAgain::see(const VertexStep& step) {
    const auto at = step.at.values();
    if (step.space == Space::clip && at.size() == 4)
        w_[step.name.text()] = at[3];
}

bool DrawnAgain::tells_rules(PrimitiveKind kind) const {
    const Method& method = scene_.method;
    const bool is_line = kind == PrimitiveKind::line || kind == PrimitiveKind::outline;
    const bool is_triangle = kind == PrimitiveKind::triangle;
    const bool is_rounded = is_triangle ? traits_of(method.fill).rule == PixelRule::row_ends
                            : is_line   ? traits_of(method.line).rule == LineRule::rounding
                                        : kind == PrimitiveKind::polygon;
    const bool is_on_grid = is_triangle ? traits_of(method.fill).rule == PixelRule::lines
                            : is_line   ? traits_of(method.line).rule == LineRule::grid
                                        : kind != PrimitiveKind::polygon;
    return (is_on_grid || rules_.says("scalar")) && (!is_triangle || rules_.says("fill")) &&
           (!is_line || rules_.says("line")) &&
           (kind != PrimitiveKind::polygon || rules_.says("fill_rule")) &&
           (!is_rounded || rules_.says("rounding"));
}

bool DrawnAgain::tests_faces() const {
    return scene_.method.cull != Cull::none || scene_.method.shade == Shade::lambert;
}

/// The primitive that begins with step n, which the scene gets if it is no part of the one before.
ToldPiece DrawnAgain::piece_at(std::size_t n) {
    const auto step = trace_.step(n).as<PrimitiveStep>();
    const auto* const kind = std::find_if(all_primitives.begin(), all_primitives.end(),
                                          [&](PrimitiveKind one) { return step.kind == one; });
    if (kind == all_primitives.end())
        throw NotTold();
    ToldPiece piece{.step = step, .kind = *kind, .names = step.vertices.texts()};
    for (const std::string& name : piece.names)
        piece.vertices.push_back(vertices_.try_emplace(name, vertices_.size()).first->second);
    for (const TracedColor& color : step.colors.values())
        piece.colors.push_back(color.color() ? *color.color() : throw NotTold());

    auto& primitives = scene_.primitives;
    if (!step.part.is_true() || primitives.empty()) {
        ScenePrimitive whole{
            .kind = *kind, .is_painted = !step.painted.is_false(), .name = step.name.text()};
        std::copy_n(piece.vertices.begin(), std::min<std::size_t>(3, piece.vertices.size()),
                    whole.vertices.begin());
        whole.ring = piece.vertices;
        if (const std::string face = step.face.text(); !face.empty()) {
            if (scene_.face_names.empty() || scene_.face_names.back() != face)
                scene_.face_names.push_back(face);
            whole.polygon = static_cast<std::uint32_t>(scene_.face_names.size());
        }
        primitives.push_back(whole);
    }
    piece.primitive = primitives.size() - 1;

    // Of a part of an outline, only the side counts that it is the rest of.
    const auto& whole = primitives.back();
    if (step.part.is_true() && whole.kind == PrimitiveKind::outline && piece.vertices.size() == 2) {
        const auto place_of = [&](std::size_t vertex) {
            const auto corners = whole.corners();
            return static_cast<std::size_t>(std::find(corners.begin(), corners.end(), vertex) -
                                            corners.begin());
        };
        if (place_of(piece.vertices[0]) == 3 && place_of(piece.vertices[1]) < 3)
            piece.vertices[0] = whole.vertices[(place_of(piece.vertices[1]) + 2) % 3];
        if (place_of(piece.vertices[0]) == 3 && step.depths)
            throw NotTold();
    }
    return piece;
}

bool DrawnAgain::redo(std::size_t first, std::size_t last) {
    try {
        ToldPiece piece = piece_at(first);
        const auto corners = piece.step.at.values().size();
        const std::size_t fewest = traits_of(piece.kind).corners;
        if (!tells_rules(piece.kind) || piece.vertices.size() != corners ||
            (traits_of(piece.kind).has_ring ? corners < fewest : corners != fewest) ||
            (!piece.colors.empty() && piece.colors.size() != corners))
            return false;
        piece.stages.is_painted = !piece.step.painted.is_false();
        piece.stages.tests_depth = piece.step.depths && region_.area() > 0 &&
                                   trace_.next_of({StepKind::depth}, first, last) <= last;
        if (piece.step.levels || std::any_of(piece.colors.begin(), piece.colors.end(),
                                             [&](Color one) { return one != piece.colors[0]; })) {
            const auto& ran = trace_.stages;
            const bool in_perspective =
                std::find(ran.begin(), ran.end(), "perspective") != ran.end();
            piece.stages.colors = in_perspective ? ColorStage::perspective : ColorStage::affine;
            for (const std::string& name : piece.names)
                if (in_perspective && w_.contains(name))
                    piece.w.push_back(w_[name]);
            if (in_perspective && piece.w.size() != corners)
                return false; // clipping has made a vertex: nobody tells its w
        }
        color_ = piece.step.color.json();
        is_thin_open_ = is_open_ = mixes_numbers_ && piece.kind != PrimitiveKind::triangle;
        const auto face = trace_.next_of({StepKind::face}, first, last);
        const auto skip = trace_.next_of({StepKind::skip}, first, last);
        const auto why =
            skip <= last ? trace_.step(skip).as<SkipStep>().why : TracedWord<SkipReason>();
        // Before it is drawn: the sides of culled faces have no face of their own, faces without area no normal.
        const bool is_culled = face <= last ? trace_.step(face).as<FaceStep>().culled.is_true()
                                            : why == SkipReason::culled && !is_filled(piece.kind);
        const bool has_no_normal =
            face > last && why == SkipReason::zero_area && is_filled(piece.kind) && tests_faces();
        if (is_culled || has_no_normal) {
            Steps skipped;
            skipped.take(SkipStep{
                .name = piece.step.name,
                .why = TracedWord<SkipReason>(is_culled ? R"("culled")" : R"("zero area")")});
            compare(skipped, first, last);
            return true;
        }
        Steps again;
        if (!draw(piece, again))
            return false;
        compare(again, first, last);
        return true;
    } catch (const NotTold&) {
        return false;
    }
}

/// Draws a piece; false if it cannot be drawn.
bool DrawnAgain::draw(const ToldPiece& piece, Steps& steps) {
    const bool is_in_fractions =
        draw_in_fractions_ && piece.step.at.json().find('"') != std::string::npos;
    StepTracer<Steps> tracer(steps, steps.arena(), true);
    if (!(is_in_fractions ? draw_in_fractions_ : draw_)(piece, tracer))
        return false;
    // What is drawn in other numbers has to know its depths.
    if (mixes_numbers_ && piece.stages.tests_depth)
        (is_in_fractions ? draw_ : draw_in_fractions_)(piece, Listener());
    return true;
}

/// Holds the steps of a primitive against those of its drawing.
void DrawnAgain::compare(const Steps& again, std::size_t first, std::size_t last) {
    std::array<std::vector<StepView>, step_kinds> drawn;
    for (std::size_t n = 1; n <= again.size(); ++n)
        drawn[static_cast<std::size_t>(*again.kind(n))].push_back(again.at(n));

    bool is_right = true;
    for (const StepKindSet& kinds : stages_of_drawing) {
        std::map<StepKind, std::vector<std::size_t>> told;
        for (const std::size_t n : trace_.steps_of(kinds, first, last))
            told[*trace_.kind_of(n)].push_back(n);
        for (const auto& [kind, steps] : told)
            is_right = compare_kind(drawn[static_cast<std::size_t>(kind)], steps, kind) && is_right;
        if (!is_right) {
            depths_differ_ = depths_differ_ || region_.area() > 0;
            return;
        }
        if ((depths_differ_ || is_open_) && kinds.has(StepKind::depth))
            return;
    }
}

bool DrawnAgain::compare_kind(const std::vector<StepView>& drawn,
                              const std::vector<std::size_t>& told, StepKind kind) {
    // What a foreign rasterizer tells and we do not.
    if (drawn.empty() && kind != StepKind::pixel && kind != StepKind::skip)
        return true;
    std::map<std::string, std::vector<std::size_t>> places; // by key, if they are asked for
    std::vector<bool> is_used(drawn.size());
    std::vector<std::size_t> left;
    bool is_right = true;
    std::size_t next = 0;
    for (const std::size_t n : told) {
        const StepView step = trace_.step(n);
        std::size_t place = next;
        if (next >= drawn.size() || is_used[next] ||
            (step.json() != drawn[next].json() &&
             key_of(step, kind) != key_of(drawn[next], kind))) {
            if (places.empty())
                for (std::size_t i = 0; i < drawn.size(); ++i)
                    places[key_of(drawn[i], kind)].push_back(i);
            const auto& same = places[key_of(step, kind)];
            const auto found =
                std::find_if(same.begin(), same.end(), [&](std::size_t i) { return !is_used[i]; });
            if (found == same.end()) {
                left.push_back(n);
                continue;
            }
            place = *found;
        }
        is_used[place] = true;
        next = place + 1;
        is_right = compare_steps(drawn[place], n, kind) && is_right;
        if (!is_right && adds_up(kind))
            return false;
    }
    if (left.empty())
        return is_right;
    const auto unused = std::find(is_used.begin(), is_used.end(), false);
    const bool is_one = left.size() == 1 && std::count(is_used.begin(), is_used.end(), false) == 1;
    for (const std::size_t n : left)
        if (is_one)
            compare_steps(drawn[static_cast<std::size_t>(unused - is_used.begin())], n, kind);
        else
            findings_.add(
                {n, fmt::format("{}: {}", name_of(kind), fields_of(kind)[0].name), "no such step",
                 value_text(trace_.step(n).field(fields_of(kind)[0].name).value_or("null"))});
    return false;
}

/// True if each number of such a step is the one before and something more.
bool DrawnAgain::adds_up(StepKind kind) const {
    const Method& method = scene_.method;
    return kind == StepKind::decide ||
           (kind == StepKind::along && traits_of(method.line).adds_up) ||
           (kind == StepKind::scanline && method.lerp == LerpForm::incremental);
}

/// Holds step n against the one of the drawing, field by field. Decisions are looked at if their reasons are right.
bool DrawnAgain::compare_steps(const StepView& again, std::size_t n, StepKind kind) {
    const StepView step = trace_.step(n);
    bool is_tested = kind != StepKind::depth || (!depths_differ_ && !is_thin_open_);
    if (kind == StepKind::depth && mixes_numbers_) { // equal but for rounding?
        const auto told = step.as<DepthStep>();
        const auto a = told.depth.exact();
        const auto b = told.stored.exact();
        const bool is_tie = a && b && abs(*a - *b) <= abs(*a) * Rational(largest_rounding);
        is_tested = is_tested && !is_tie;
        is_open_ = is_open_ || is_tie;
    }
    bool are_reasons_right = true;
    bool is_right = true;
    for (const StepField& field : fields_of(kind)) {
        if (kind == StepKind::primitive && field.name != "octant" && field.name != "colors")
            continue; // what it is drawn from; colors are rounded levels
        if (!is_tested && field.role != FieldRole::key && field.name != "depth")
            continue;
        if (field.role == FieldRole::decision && !are_reasons_right)
            continue;
        auto told = step.field(field.name);
        auto drawn = again.field(field.name);
        if (kind == StepKind::pixel && field.is_color) { // without one, a pixel has the primitive's
            told = told.value_or(color_);
            drawn = drawn.value_or(color_);
        }
        if (!told)
            continue;
        const bool names_face = kind == StepKind::depth && field.type == FieldType::string;
        if (!drawn && !names_face)
            continue;
        const std::string what = fmt::format("{}: {}", name_of(kind), field.name);
        findings_.count(what);
        if (drawn && are_alike(*drawn, *told, field))
            continue;
        is_right = false;
        are_reasons_right = are_reasons_right && field.role == FieldRole::decision;
        findings_.add({n, what, drawn ? value_text(*drawn) : "no face", value_text(*told)});
    }
    return is_right;
}

/// True if two values are alike in the scalar of the trace.
bool DrawnAgain::are_alike(std::string_view again, std::string_view told,
                           const StepField& field) const {
    if (again == told)
        return true;
    if (field.type == FieldType::list && again.starts_with('[') && told.starts_with('[')) {
        const auto a = elements_of(again);
        const auto b = elements_of(told);
        StepField element = field;
        element.type = field.element;
        return a.size() == b.size() &&
               std::equal(a.begin(), a.end(), b.begin(),
                          [&](auto one, auto other) { return are_alike(one, other, element); });
    }
    if (field.is_color)
        return TracedColor(again).color() == TracedColor(told).color();
    if (field.type != FieldType::quantity && field.type != FieldType::whole)
        return TracedValue(again).text() == TracedValue(told).text();
    const auto a = TracedNumber(again).exact();
    const auto b = TracedNumber(told).exact();
    if (!a || !b)
        return false;
    // Another primitive's depth was told in other numbers, and is rounded.
    if (mixes_numbers_ && field.name == "stored")
        return abs(*a - *b) <= abs(*a) * Rational(largest_rounding);
    if (again.starts_with('"') || told.starts_with('"'))
        return *a == *b;
    return rules_.has_floats() ? nearest_float(*a) == nearest_float(*b)
                               : nearest_double(*a) == nearest_double(*b);
}

} // namespace rastertrace
