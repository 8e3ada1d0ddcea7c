// SPDX-License-Identifier: MIT
#include "view.h"

#include "corners.h"
#include "describe.h"
#include "formula.h"
#include "step_text.h"
#include "told_samples.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/named_value.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace rastertrace {

namespace {

constexpr std::array<std::string_view, 6> words_of_views{"plotted", "faces",  "shade",
                                                         "depth",   "writes", "coverage"};

/// One for each face: no x, which marks what was tested and not drawn.
constexpr std::string_view face_letters = "abcdefghijklmnopqrstuvwyz0123456789";

/// From dark to light. Neither blank nor `.`, so that a black pixel is not an empty one.
constexpr std::string_view ramp = "-~:+=*o%8&";

constexpr std::string_view empty_cell = ".";

/// How many steps of the ramp a share of 0 to 1 is.
char ramp_at(double share) {
    const double step = std::floor(share * static_cast<double>(ramp.size()));
    return ramp[static_cast<std::size_t>(
        std::clamp(step, 0.0, static_cast<double>(ramp.size() - 1)))];
}

/// What an untouched cell of the buffer holds: what the first depth of all is compared with.
std::string cleared_depth(const Trace& trace) {
    for (const std::size_t n : trace.steps_of({StepKind::depth})) {
        const TracedNumber stored = trace.step(n).as<DepthStep>().stored;
        if (stored.json() == "null")
            break;
        return short_number(stored.text());
    }
    const Method& method = trace.method.triangles;
    return method.depth == Depth::linear_z && method.depth_compare != DepthCompare::greater
               ? "inf"
               : std::string(empty_cell);
}

/// How far `p` lies from the line through two points; positive on the left side with y up.
double distance_from_line(const Place& p, const Place& from, const Place& to) {
    return doubled_area(from, to, p) / std::hypot(to.x - from.x, to.y - from.y);
}

} // namespace

bool has_depth_buffer(const Trace& trace) {
    const auto depth = trace.method.triangles.depth;
    return !trace.method.word_of("depth").empty() && depth != Depth::none &&
           depth != Depth::painter;
}

std::vector<std::string_view> view_names() {
    return {words_of_views.begin(), words_of_views.end()};
}

std::string_view name_of(View view) {
    return words_of_views[static_cast<std::size_t>(view)];
}

std::optional<View> view_named(std::string_view name) {
    return value_named<View>(words_of_views, name);
}

std::string short_number(const std::string& text) {
    constexpr std::size_t longest = 6;
    constexpr double most_whole_digits = 1e6;
    const auto number = TracedNumber(text).nearest_double();
    if (text.size() <= longest || !number)
        return text;
    const bool is_large = 1000 <= std::abs(*number) && std::abs(*number) < most_whole_digits;
    return is_large ? fmt::format("{:.0f}", *number) : fmt::format("{:.3g}", *number);
}

FrameParts parts_for(View view, const Trace& trace) {
    return {.writes = view == View::writes,
            .depths = view == View::depth || has_depth_buffer(trace)};
}

bool larger_is_nearer(const Trace& trace) {
    for (const std::size_t n : trace.steps_of({StepKind::depth}))
        if (const auto larger = larger_depth_passes(trace, n))
            return *larger;
    return false;
}

View default_view(const Trace& trace) {
    std::set<std::string> faces;
    std::set<std::string> colors;
    for (const std::size_t n : trace.steps_of({StepKind::light, StepKind::primitive})) {
        if (trace.kind_of(n) == StepKind::light)
            return View::shade;
        const auto primitive = trace.step(n).as<PrimitiveStep>();
        if (primitive.colors)
            return View::shade;
        if (!is_filled(primitive.kind) || primitive.painted.is_false())
            continue;
        if (colors.size() < 2)
            colors.insert(primitive.color.text());
        if (faces.size() <= face_letters.size())
            faces.insert(name_of_face(primitive));
    }
    if (faces.size() < 2)
        return View::plotted;
    const bool is_one_mass = faces.size() > face_letters.size() && colors.size() < 2;
    return is_one_mass && has_depth_buffer(trace) ? View::depth : View::faces;
}

FaceGroups lettered_faces(const Replay& at_end, const FaceGroups& before) {
    return face_groups_of_all_frames(at_end, face_letters.size(), before);
}

FrameCells::FrameCells(View view, const Replay& replay, std::size_t room, const FaceGroups* faces)
    : replay_(replay) {
    const Frame& frame = replay.frame();
    switch (view) {
    case View::plotted:
        cell_ = [&frame](std::size_t offset, Pixel) {
            return Cell{frame.drawn_by[offset] != 0 ? "#" : std::string(empty_cell)};
        };
        break;
    case View::faces:
        set_up_faces(faces);
        break;
    case View::shade:
        set_up_shade();
        break;
    case View::depth:
        set_up_depths(room);
        break;
    case View::writes:
        legend_ = {said("1..9: so many writes"), said("+: more")};
        cell_ = [&frame](std::size_t offset, Pixel) {
            const std::uint32_t writes = frame.writes[offset];
            return Cell{writes == 0   ? std::string(empty_cell)
                        : writes <= 9 ? std::to_string(writes)
                                      : "+"};
        };
        break;
    case View::coverage:
        set_up_coverage();
        break;
    }
}

Cell FrameCells::at(Pixel pixel) const {
    return cell_(replay_.trace().canvas.offset_of(pixel), pixel);
}

/// A letter for each face; if too many can be seen at the end, for each mesh, or for each color.
void FrameCells::set_up_faces(const FaceGroups* faces) {
    const Frame& frame = replay_.frame();
    if (faces == nullptr) {
        Replay at_end(replay_.trace());
        at_end.go_to(replay_.trace().size());
        faces = &own_faces_.emplace(lettered_faces(at_end));
    }
    const bool has_letters = faces->names.size() <= face_letters.size();
    std::set<std::size_t> seen;
    bool has_others = false;
    for (const std::size_t primitive : visible_primitives(replay_)) {
        const auto group = faces->group_of.find(primitive);
        if (group == faces->group_of.end())
            has_others = true;
        else
            seen.insert(group->second);
    }
    if (has_letters) {
        for (const std::size_t i : seen)
            legend_.push_back(fmt::format("{} {}", face_letters[i], printable(faces->names[i])));
        if (has_others)
            legend_.push_back(said("# others"));
        if (!legend_.empty())
            legend_.front().insert(0, faces->heading);
    } else {
        legend_ = {
            said("{} faces, {} colors: too many for letters", faces->faces, faces->names.size())};
    }
    cell_ = [this, &frame, has_letters, faces](std::size_t offset, Pixel) {
        const std::size_t drawn_by = frame.drawn_by[offset];
        if (drawn_by == 0)
            return Cell{std::string(empty_cell)};
        const auto group = faces->group_of.find(replay_.primitive_of(drawn_by));
        const bool has_letter = has_letters && group != faces->group_of.end();
        return Cell{.text = std::string(1, has_letter ? face_letters[group->second] : '#'),
                    .color = frame.image.colors()[offset]};
    };
}

void FrameCells::set_up_shade() {
    const Frame& frame = replay_.frame();
    legend_ = {said("dark {} light", ramp)};
    // As bright as it looks: half the light of white is seen as three quarters.
    const auto shown = [](Color color) {
        return Cell{std::string(1, ramp_at(std::pow(luminance(color), 1 / 2.4))), color};
    };
    const std::optional<Color> background = replay_.trace().background;
    const Cell empty = background ? shown(*background) : Cell{std::string(empty_cell)};
    if (background)
        legend_.push_back(said("background {} {}", empty.text, to_text(*background)));
    cell_ = [&frame, shown, empty](std::size_t offset, Pixel) {
        return frame.drawn_by[offset] == 0 ? empty : shown(frame.image.colors()[offset]);
    };
}

void FrameCells::set_up_depths(std::size_t room) {
    const Frame& frame = replay_.frame();
    const Trace& trace = replay_.trace();
    std::vector<std::size_t> stored; // the cells that hold a depth
    for (std::size_t cell = 0; cell < frame.stored_by.size(); ++cell)
        if (frame.stored_by[cell] != 0)
            stored.push_back(cell);
    if (stored.empty()) {
        legend_ = {
            said("the buffer is clear: no depth was tested (a scene is, with --keep depth)")};
        width_ = 1;
        cell_ = [](std::size_t, Pixel) { return Cell{std::string(empty_cell)}; };
        return;
    }
    // One after the other, steps are found quicker.
    std::sort(stored.begin(), stored.end(), [&frame](std::size_t a, std::size_t b) {
        return frame.stored_by[a] < frame.stored_by[b];
    });

    const std::string clear = cleared_depth(trace);
    width_ = clear.size();
    const auto depth_in = [&frame, &trace](std::size_t cell) {
        return trace.step(frame.stored_by[cell]).as<DepthStep>().depth;
    };
    std::vector<double> values(frame.stored_by.size());
    double least = std::numeric_limits<double>::infinity();
    double largest = -least;
    bool all_finite = true;
    for (const std::size_t cell : stored) {
        const TracedNumber told = depth_in(cell);
        if (width_ <= room)
            width_ = std::max(width_, short_number(told.text()).size());
        values[cell] = told.nearest_double().value_or(std::numeric_limits<double>::quiet_NaN());
        if (std::isnan(values[cell])) {
            all_finite = false;
            continue;
        }
        least = std::min(least, values[cell]);
        largest = std::max(largest, values[cell]);
    }
    // The nearest is the brightest.
    const bool larger = larger_is_nearer(trace);
    const auto brightness = [larger, least, largest](double depth) {
        if (std::isnan(depth))
            return std::optional<double>();
        const double range = largest - least;
        const double share = range > 0 ? (depth - least) / range : 1;
        return std::optional(larger ? share : 1 - share);
    };
    const bool is_ramp = width_ > room;
    if (is_ramp) {
        width_ = 1;
        if (least <= largest)
            legend_.push_back(said("far {:.4g} {} {:.4g} near", larger ? least : largest, ramp,
                                   larger ? largest : least));
        if (!all_finite)
            legend_.push_back(said("? not finite"));
    }
    cell_ = [&frame, depth_in, brightness, values = std::move(values), is_ramp,
             clear](std::size_t offset, Pixel) {
        if (frame.stored_by[offset] == 0)
            return Cell{is_ramp ? std::string(empty_cell) : clear};
        const auto share = brightness(values[offset]);
        return Cell{.text = !is_ramp ? short_number(depth_in(offset).text())
                                     : std::string(1, share ? ramp_at(*share) : '?'),
                    .brightness = share};
    };
}

void FrameCells::set_up_coverage() {
    const Trace& trace = replay_.trace();
    Path corners;
    if (replay_.primitive() != 0)
        corners = corners_of(trace.step(replay_.primitive()).as<PrimitiveStep>());
    legend_ = {corners.size() == 3
                   ? said("0..9: tenths of a pixel from the sample to the nearest edge")
                   : said("coverage is that of a triangle")};
    const auto offset = told_samples(trace).triangles;
    cell_ = [corners, x = offset.x().get_d(), y = offset.y().get_d()](std::size_t, Pixel pixel) {
        const Place sample{pixel.x + x, pixel.y + y};
        if (corners.size() != 3)
            return Cell{"-"};
        const auto &a = corners[0], b = corners[1], c = corners[2];
        const double side = distance_from_line(c, a, b) < 0 ? -1 : 1;
        const double distance = std::min({side * distance_from_line(sample, a, b),
                                          side * distance_from_line(sample, b, c),
                                          side * distance_from_line(sample, c, a)});
        if (!(distance >= 0))
            return Cell{"-"};
        return Cell{std::string(
            1, static_cast<char>('0' + static_cast<int>(std::min(9.0, distance * 10))))};
    };
}

} // namespace rastertrace
