// SPDX-License-Identifier: MIT
// What a trace tells of the fields of a claim, and what of them is worked out.

#include "claim_subject.h"

#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/json_scanner.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>
#include <variant>

namespace rastertrace {

std::vector<std::size_t> decisions_from(const StepIndex& index, std::size_t first) {
    std::vector<std::size_t> decisions;
    for (std::size_t n = first; n <= index.trace().size(); ++n) {
        const auto kind = index.trace().kind_of(n);
        if (kind == StepKind::edge || kind == StepKind::primitive || kind == StepKind::ray)
            break;
        if (kind == StepKind::decide)
            decisions.push_back(n);
    }
    return decisions;
}

namespace {

/// d before each step of a whole line, of which the canvas may have a part: of that part, if as many are claimed.
std::vector<std::string> told_decisions(const StepIndex& index, std::size_t first,
                                        std::size_t claimed) {
    std::vector<std::string> on_canvas;
    for (const std::size_t n : decisions_from(index, first))
        on_canvas.push_back(index.trace().step(n).as<DecideStep>().d.text());
    const auto formulas = formulas_of(index.right(), first, "d");
    if (on_canvas.size() == claimed || formulas.empty())
        return on_canvas;
    std::vector<std::string> all;
    for (const Rational& d : value_of(formulas.front()))
        all.push_back(d.get_str());
    return all.empty() ? on_canvas : all;
}

/// The angle between a face's normal and its view in degrees, to nine digits behind the point.
ToldValues told_angle(const StepIndex& index, std::size_t face) {
    for (const Formula& formula : formulas_of(index.right(), face, "cosine"))
        if (const Values cosine = value_of(formula); cosine.size() == 1) {
            constexpr double digits = 1e9;
            const double degrees =
                std::acos(std::clamp(nearest_double(cosine.front()), -1.0, 1.0)) * 180 /
                std::numbers::pi;
            return std::vector{
                Rational(Rational(std::round(degrees * digits)) / Rational(digits)).get_str()};
        }
    return std::nullopt;
}

/// z, or 1/z, by a depth test.
ToldValues told_z(const StepIndex& index, std::size_t test, bool is_inverse) {
    const auto depth = index.trace().step(test).as<DepthStep>().depth.exact();
    const bool holds_inverse = index.trace().method.triangles.depth == Depth::inverse_z;
    if (!depth || (is_inverse != holds_inverse && sgn(*depth) == 0))
        return std::nullopt;
    return std::vector{(is_inverse == holds_inverse ? *depth : Rational(1 / *depth)).get_str()};
}

/// The length of a face's normal, in many digits.
ToldValues told_length(const StepIndex& index, std::size_t face) {
    Rational square;
    const Values normal = index.right().of(face, "normal");
    for (const Rational& component : normal)
        square += component * component;
    return normal.empty() ? ToldValues()
                          : std::vector{square_root(square, RootDigits::many).get_str()};
}

/// What the edge table has of an edge: its least and its largest y, and x at the least.
ToldValues told_of_edge(const StepIndex& index, std::size_t edge, std::string_view field) {
    for (const Formula& formula : formulas_of(index.right(), edge, "dx_dy"))
        if (const auto* const slope = std::get_if<Slope>(&formula.of)) {
            const auto& [low, high] = slope->from.y < slope->to.y
                                          ? std::pair(slope->from, slope->to)
                                          : std::pair(slope->to, slope->from);
            return std::vector{(field == "y_min"   ? low.y
                                : field == "y_max" ? high.y
                                                   : low.x)
                                   .get_str()};
        }
    return std::nullopt;
}

/// The pixel before a step of a line, or the one behind it; of a line by its equation, its pixel or its point.
ToldValues told_place(const StepIndex& index, std::size_t n, std::string_view field) {
    const StepView view = index.trace().step(n);
    if (view.kind() == StepKind::decide) {
        const auto step = view.as<DecideStep>();
        const std::string move = field == "place" ? step.move.text() : "";
        const auto way = [&move](char forth, char back) {
            return move.find(forth) != std::string::npos  ? 1
                   : move.find(back) != std::string::npos ? -1
                                                          : 0;
        };
        return std::vector{std::to_string(step.x + way('E', 'W')),
                           std::to_string(step.y + way('N', 'S'))};
    }
    const auto step = view.as<AlongStep>();
    const std::string other = field == "xy" ? step.value.text() : std::to_string(step.pixel);
    return step.x ? std::vector{std::to_string(*step.x), other}
                  : std::vector{other, std::to_string(*step.y)};
}

bool is_seen(const StepIndex& index, std::size_t n) {
    const StepView step = index.trace().step(n);
    const Pixel pixel{static_cast<int>(x_in(step).value_or(0)),
                      static_cast<int>(y_in(step).value_or(0))};
    return index.trace().canvas.contains(pixel.x, pixel.y) &&
           index.frame().drawn_by[index.trace().canvas.offset_of(pixel)] == n;
}

/// What follows from the pixels of a primitive.
ToldValues told_of_pixels(const StepIndex& index, std::size_t primitive, std::string_view field) {
    if (field == "visible") {
        const auto& drawn =
            index.find(StepKind::pixel, {{"in", name_in(index.trace().step(primitive)).text()}});
        const bool is_visible = std::any_of(drawn.begin(), drawn.end(),
                                            [&](std::size_t n) { return is_seen(index, n); });
        return std::vector<std::string>{is_visible ? "true" : "false"};
    }
    std::vector<std::string> listed;
    std::set<Index> rows;
    for (const std::size_t n : pixels_of(index.steps(), primitive)) {
        const StepView step = index.trace().step(n);
        rows.insert(y_in(step).value_or(0));
        for (const auto coordinate : {x_in(step), y_in(step)})
            listed.push_back(std::to_string(coordinate.value_or(0)));
    }
    return field == "pixels" ? listed
                             : std::vector{std::to_string(
                                   field == "row_count" ? rows.size() : listed.size() / 2)};
}

/// The pixels of a row, or how many they are.
std::vector<std::string> told_of_row(const ScanlineStep& row, std::string_view field) {
    if (field == "pixel_count")
        return {std::to_string(std::max<Index>(row.to - row.from + 1, 0))};
    std::vector<std::string> pixels;
    for (Index x = row.from; x <= row.to; ++x)
        pixels.push_back(std::to_string(x));
    return pixels;
}

} // namespace

ToldValues told_in(const StepIndex& index, std::size_t step, const ClaimedField& field) {
    if (step == 0)
        return std::nullopt;
    const StepView view = index.trace().step(step);
    if (view.kind() == StepKind::decide && field.name == "d" && field.is_list)
        return told_decisions(index, step, field.values.size());
    if (view.kind() == StepKind::depth && (field.name == "z" || field.name == "inverse_z"))
        return told_z(index, step, field.name == "inverse_z");
    if (view.kind() == StepKind::face && field.name == "angle")
        return told_angle(index, step);
    if (view.kind() == StepKind::face && field.name == "length")
        return told_length(index, step);
    if (field.name == "y_min" || field.name == "y_max" || field.name == "x_start")
        return told_of_edge(index, step, field.name);
    if (field.name == "xy" || field.name.starts_with("place"))
        return told_place(index, step, field.name);
    const bool is_of_pixels =
        field.name == "pixels" || field.name == "pixel_count" || field.name == "visible";
    if (view.kind() == StepKind::primitive && (is_of_pixels || field.name == "row_count"))
        return told_of_pixels(index, step, field.name);
    if (view.kind() == StepKind::scanline && is_of_pixels)
        return told_of_row(view.as<ScanlineStep>(), field.name);
    const auto json = view.field(field.name);
    if (json == "null" && field.name == "dx_dy")
        return std::vector{std::string(no_slope)};
    if (json && json->starts_with("[[")) {
        std::vector<std::string> values;
        for (const auto& row : text_rows(TracedList<TracedList<TracedValue>>(*json)))
            values.insert(values.end(), row.begin(), row.end());
        return values;
    }
    if (json)
        return json->starts_with('[') ? TracedList<TracedValue>(*json).texts()
                                      : std::vector{plain_text(*json)};
    const auto formulas = formulas_of(index.right(), step, field.name);
    if (formulas.empty())
        return std::nullopt;
    std::vector<std::string> values;
    for (const Rational& value : value_of(formulas.front()))
        values.push_back(value.get_str());
    if (values.empty()) // y = m x + b of a line that is vertical
        values.emplace_back(no_slope);
    return values;
}

namespace {

/// x and y of the pixels of a circle's octant, less those of a point; the last lies beyond the diagonal, or on it.
std::vector<std::string> octant(const StepIndex& index, const std::vector<std::size_t>& decisions,
                                const Vec2& less) {
    std::vector<std::string> values;
    const auto add = [&](const ToldValues& place) {
        values.push_back(Rational(number_in(place->at(0)).value_or(0) - less.x).get_str());
        values.push_back(Rational(number_in(place->at(1)).value_or(0) - less.y).get_str());
    };
    for (const std::size_t n : decisions)
        add(told_place(index, n, "place_before"));
    if (!decisions.empty())
        add(told_place(index, decisions.back(), "place"));
    return values;
}

/// The pixels of a list in the order in which they are claimed; those that are not are in the places of wrong ones.
std::vector<std::string> in_claimed_order(const std::vector<std::string>& told,
                                          const std::vector<std::string>& claimed) {
    std::multiset<std::pair<std::string, std::string>> left;
    for (std::size_t i = 0; i + 1 < told.size(); i += 2)
        left.emplace(told[i], told[i + 1]);
    std::vector<std::string> values(told.size());
    std::vector<bool> is_put(told.size());
    for (std::size_t i = 0; i + 1 < std::min(told.size(), claimed.size()); i += 2)
        if (const auto found = left.find({normal_form(claimed[i]), normal_form(claimed[i + 1])});
            found != left.end()) {
            std::tie(values[i], values[i + 1]) = *found;
            is_put[i] = true;
            left.erase(found);
        }
    for (std::size_t i = 0; i + 1 < told.size(); i += 2)
        if (!is_put[i])
            std::tie(values[i], values[i + 1]) = left.extract(left.begin()).value();
    return values;
}

const std::string& value_of_key(const Subject& subject, std::string_view field) {
    return std::find_if(subject.keys.begin(), subject.keys.end(),
                        [&](const auto& key) { return key.first == field; })
        ->second;
}

} // namespace

Pixel pixel_of(const Subject& subject) {
    const auto coordinate = [&](std::string_view axis) {
        return static_cast<int>(
            number_in(value_of_key(subject, axis)).value_or(0).get_num().get_si());
    };
    return {coordinate("x"), coordinate("y")};
}

std::vector<OtherForm> other_forms(const Subject& subject, const ClaimedField& field) {
    const StepIndex& index = *subject.exact;
    const bool are_pixels = subject.kind == StepKind::primitive && field.name == "pixels";
    const bool is_d = subject.kind == StepKind::decide && field.name == "d" && field.is_list;
    const std::size_t primitive = subject.step == 0 || (!are_pixels && !is_d) ? 0
                                  : are_pixels                                ? subject.step
                                               : index.primitive_of(subject.step);
    if (primitive == 0 ||
        index.trace().step(primitive).as<PrimitiveStep>().kind != PrimitiveKind::circle)
        return {};
    const auto decisions =
        index.find(StepKind::decide, {{"in", name_in(index.trace().step(primitive)).text()}});
    std::vector<OtherForm> forms;
    if (is_d) {
        for (const auto& [name, factor, more] :
             {std::tuple("d = 3 - 2 r", Rational(2), Rational(1)),
              std::tuple("d = 5/4 - r", Rational(1), Rational(1, 4))}) {
            OtherForm& form = forms.emplace_back(OtherForm{said("in the form {}", name), {}});
            for (const std::size_t n : decisions)
                if (const auto d = index.trace().step(n).as<DecideStep>().d.exact())
                    form.values.push_back(Rational(factor * *d + more).get_str());
        }
        return forms;
    }
    const PrimitiveText circle = primitive_of(index.steps().at(primitive));
    const auto center = center_of(circle, index.trace());
    for (const Vec2& less : {Vec2{0, 0}, center.value_or(Vec2{0, 0})}) {
        auto values = octant(index, decisions, less);
        if (values.size() < 4)
            return {};
        auto inside = values; // up to the diagonal
        inside.resize(values.size() - 2);
        forms.push_back({said("of one octant"), std::move(inside)});
        forms.push_back({said("of one octant"), std::move(values)});
    }
    if (const ToldValues told = told_in(index, primitive, field))
        forms.push_back({"", in_claimed_order(*told, field.values)});
    return forms;
}

namespace {

/// The depth test that the buffer has its last depth from, in a pixel; 0 for none.
std::size_t stored_by(const StepIndex& index, const Subject& subject) {
    std::size_t stored = 0;
    for (const std::size_t n : index.find(StepKind::depth, {{"x", value_of_key(subject, "x")},
                                                            {"y", value_of_key(subject, "y")},
                                                            {"pass", "true"}}))
        if (stores_depth(index.trace().step(n).as<DepthStep>()))
            stored = n;
    return stored;
}

/// True if a primitive, the one that is named or any, has the pixel, seen or hidden.
bool is_inside_any(const StepIndex& index, const Subject& subject) {
    StepIndex::Keys tested = subject.keys;
    tested.emplace_back("inside", "true");
    return !index.find(StepKind::pixel, subject.keys).empty() ||
           !index.find(StepKind::depth, subject.keys).empty() ||
           !index.find(StepKind::sample, tested).empty();
}

/// How far a pixel of a line has come from one of its colors to the other.
ToldValues told_share(const StepIndex& index, std::size_t pixel) {
    if (pixel == 0)
        return std::nullopt;
    const StepContext at = index.steps().at(pixel);
    const auto line = color_on_line(at, primitive_of(at));
    return line ? ToldValues({line->share().get_str()}) : std::nullopt;
}

/// What is told of a pixel of the final picture.
ToldValues told_of_pixel(const StepIndex& index, std::size_t step, const Subject& subject,
                         std::string_view field) {
    if (subject.is_off_canvas)
        return std::vector<std::string>{"false"};
    const std::size_t drawn_by =
        index.frame().drawn_by[index.trace().canvas.offset_of(pixel_of(subject))];
    // Of a primitive that is named, it is asked whether that one has plotted it.
    const bool names_primitive = std::any_of(subject.keys.begin(), subject.keys.end(),
                                             [](const auto& key) { return key.first == "in"; });
    const bool is_plotted = names_primitive ? step != 0 : drawn_by != 0;
    if (field == "plotted")
        return std::vector<std::string>{is_plotted ? "true" : "false"};
    if (field == "inside")
        return std::vector<std::string>{is_inside_any(index, subject) ? "true" : "false"};
    if (field == "visible" && !is_inside_any(index, subject))
        return std::vector<std::string>{"outside"};
    if (field == "visible")
        return std::vector<std::string>{step != 0 && drawn_by == step ? "true" : "false"};
    if (field == "share")
        return told_share(index, drawn_by);
    if (field == "color")
        return std::vector{drawn_by == 0 ? "none"
                                         : to_text(index.frame().image.at(pixel_of(subject)))};
    if (field == "z" || field == "inverse_z")
        return told_in(index, stored_by(index, subject),
                       {.name = std::string(field), .values = {}});
    return told_in(index, step, {.name = std::string(field), .values = {}});
}

/// The only row that a pixel could be in; 0 if there are several, or none.
std::size_t row_of_pixel(const StepIndex& index, const Subject& subject) {
    StepIndex::Keys keys = subject.keys;
    std::erase_if(keys, [](const auto& key) { return key.first == "x"; });
    const auto& rows = index.find(StepKind::scanline, keys);
    return rows.size() == 1 ? rows.front() : 0;
}

/// Where a vertex is on the screen, of a trace that tells it in its primitives only.
ToldValues told_in_primitive(const StepIndex& index, std::size_t step, const std::string& vertex) {
    const auto primitive = index.trace().step(step).as<PrimitiveStep>();
    const auto names = primitive.vertices.texts();
    const auto places = primitive.at.values();
    const auto at =
        static_cast<std::size_t>(std::find(names.begin(), names.end(), vertex) - names.begin());
    return at < places.size() ? ToldValues(places[at].texts()) : std::nullopt;
}

/// A vertex that is clipped before it is divided by w, as if it was; nothing if w is 0.
ToldValues told_behind_eye(const StepIndex& index, const Subject& subject) {
    const auto& clip =
        index.find(StepKind::vertex, {{"name", value_of_key(subject, "name")}, {"space", "clip"}});
    if (clip.empty() || value_of_key(subject, "space") != "canonical")
        return std::nullopt;
    const Values point = index.right().of(clip.front(), "at");
    if (point.size() != 4 || sgn(point[3]) == 0)
        return std::nullopt;
    std::vector<std::string> divided;
    for (std::size_t i = 0; i < 3; ++i)
        divided.push_back(Rational(point[i] / point[3]).get_str());
    return divided;
}

ToldValues told(const StepIndex& index, std::size_t step, const Subject& subject,
                const ClaimedField& field) {
    if (subject.kind == StepKind::vertex && step == 0 && field.name == "at")
        return told_behind_eye(index, subject);
    if (subject.kind == StepKind::pixel)
        return told_of_pixel(index, step, subject, field.name);
    if (subject.kind == StepKind::scanline && step == 0 && field.name == "pixel_count")
        return std::vector<std::string>{"0"}; // there is no such row
    if (subject.kind == StepKind::vertex && step != 0 && !subject.is_told_in(index, step))
        return told_in_primitive(index, step, value_of_key(subject, "name"));
    return told_in(index, step, field);
}

} // namespace

ToldValues told_exactly(const Subject& subject, const ClaimedField& field) {
    // What is culled, the scene's method says, and not the trace that has faces tested for their numbers.
    if (subject.kind == StepKind::face && field.name == "culled" && !subject.culls)
        return told_as_decided(subject, field);
    return told(*subject.exact, subject.step, subject, field);
}

ToldValues cosine_with_many_digits(const Subject& subject, const ClaimedField& field) {
    if (field.name != "cosine" && field.name != "intensity")
        return std::nullopt;
    for (const Formula& formula : formulas_of(subject, subject.exact->right(), field.name))
        if (const auto* const face = std::get_if<FaceCosine>(&formula.of))
            if (const auto cosine = face->value(RootDigits::many))
                return std::vector{
                    (face->is_intensity ? std::max(*cosine, Rational(0)) : *cosine).get_str()};
    return std::nullopt;
}

ToldValues told_as_decided(const Subject& subject, const ClaimedField& field) {
    // Where nothing is culled, no face is tested: all are drawn.
    if (subject.kind == StepKind::face && field.name == "culled" && subject.decided_step == 0)
        return std::vector<std::string>{"false"};
    return told(*subject.decided, subject.decided_step, subject, field);
}

NumbersHeld numbers_held(const Subject& subject) {
    const ToldMethod& method = subject.exact->trace().method;
    const ScalarKind scalar = method.triangles.scalar;
    return scalar == ScalarKind::exact || scalar == ScalarKind::fixed ? NumbersHeld::fractions
           : method.has_floats()                                      ? NumbersHeld::floats
                                                                      : NumbersHeld::doubles;
}

std::string name_of_number(const Subject& subject, const ClaimedField& field) {
    const bool is_of_step = subject.kind != StepKind::pixel &&
                            !(subject.kind == StepKind::decide && field.is_list) &&
                            subject.is_told_in(*subject.exact, subject.step);
    if (is_of_step)
        return name_of_number(subject.exact->trace(), subject.step, field.name);
    std::string name =
        fmt::format("{}{} of {}", field.is_list ? "all " : "", field.name, name_of(subject.kind));
    for (const auto& [key, value] : subject.keys)
        name += fmt::format(" {}={}", key, normal_form(value));
    return name;
}

std::size_t step_of(const Subject& subject, std::string_view field) {
    if (subject.kind != StepKind::pixel)
        return subject.step;
    if (field == "z" || field == "inverse_z")
        return stored_by(*subject.exact, subject);
    if (field == "inside" || field == "plotted")
        if (const auto& samples = subject.exact->find(StepKind::sample, subject.keys);
            samples.size() == 1)
            return samples.front();
    if (field == "color" || field == "share")
        return subject.exact->frame()
            .drawn_by[subject.exact->trace().canvas.offset_of(pixel_of(subject))];
    const std::size_t row = row_of_pixel(*subject.exact, subject);
    return (field == "plotted" || field == "inside") && row != 0 ? row : subject.step;
}

std::vector<Formula> formulas_of(const Subject& subject, const Numbers& numbers,
                                 std::string_view field) {
    if (subject.kind == StepKind::pixel && (field == "plotted" || field == "inside")) {
        if (const std::size_t sample = step_of(subject, field);
            sample != 0 && numbers.trace().kind_of(sample) == StepKind::sample)
            return formulas_of(numbers, sample, "inside");
        const std::size_t row = row_of_pixel(*subject.exact, subject);
        return row == 0 ? std::vector<Formula>{}
                        : std::vector{in_row(numbers, row, Rational(pixel_of(subject).x))};
    }
    if (field == "share")
        if (const ToldValues share = told_share(*subject.exact, step_of(subject, field)))
            return {{TakenOver{{number_in(share->front()).value_or(0)}}}};
    if (subject.kind == StepKind::matrix && field == "rows" && subject.step != 0)
        if (const auto matrix =
                exact_matrix_in(numbers.trace().step(subject.step).as<MatrixStep>())) {
            Values entries;
            for (const auto& row : matrix->rows)
                entries.insert(entries.end(), std::begin(row), std::end(row));
            return {{TakenOver{entries}}};
        }
    return formulas_of(numbers, step_of(subject, field), field);
}

} // namespace rastertrace
