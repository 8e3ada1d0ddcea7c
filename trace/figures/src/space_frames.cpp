// SPDX-License-Identifier: MIT
#include <rastertrace/figures/space_frames.h>

#include "space_sheet.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/formula.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/named_value.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace rastertrace {

namespace {

constexpr std::array<std::string_view, 2> words_of_frames{"spaces", "ears"};
constexpr std::array all_spaces{Space::object, Space::world,     Space::camera,
                                Space::clip,   Space::canonical, Space::screen};

/// A frame: a picture of so much, and what stands below.
struct SpaceFrame {
    SpatialScene space;
    SpaceEye eye;
    std::string mark = {};                ///< a vertex
    std::vector<std::string> whole = {};  ///< the corners of a face
    std::vector<std::string> filled = {}; ///< of an ear
    std::vector<std::string> lines = {};  ///< of text
};

/// The frames on a sheet, in rows.
Drawing sheet_of(const Trace& trace, const std::vector<SpaceFrame>& frames, double letter_scale) {
    constexpr std::size_t columns = 3;
    const double width = 230 / letter_scale;
    const double height = 200 / letter_scale;
    constexpr double margin = 10;
    constexpr double line_height = 13;
    constexpr double size = line_height - 3;
    std::vector<std::vector<std::string>> lines_below;
    std::size_t most_lines = 0;
    for (const SpaceFrame& frame : frames) {
        auto& lines = lines_below.emplace_back();
        for (const std::string& line : frame.lines)
            for (std::string& part : wrapped(line, letters_in(width, size)))
                lines.push_back(std::move(part));
        most_lines = std::max(most_lines, lines.size());
    }
    const double pitch = height + line_height * (static_cast<double>(most_lines) + 1);
    Drawing sheet{.width =
                      2 * margin + width * static_cast<double>(std::min(columns, frames.size())),
                  .title = trace.title};
    sheet.shapes.push_back(Label{.role = Role::strong_text,
                                 .at = {margin, margin + 12},
                                 .text = printable(trace.title),
                                 .size = 13,
                                 .is_bold = true});
    double bottom = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const SpaceFrame& frame = frames[i];
        SpaceSheet space(frame.space, trace, frame.eye, width, height);
        add_space(SpaceWeight::strong, space);
        if (!frame.whole.empty())
            space.outline(frame.space.places_of(frame.whole), Role::other_edge);
        if (!frame.filled.empty())
            space.polygon(frame.space.places_of(frame.filled), Role::current, Role::current_border);
        if (!frame.mark.empty())
            space.dot(frame.space.vertices.at(frame.mark), Role::rejected, 4);
        const Place corner{margin + width * static_cast<double>(i % columns),
                           2 * margin + 16 + pitch * static_cast<double>(i / columns)};
        place({.width = width, .height = height, .title = {}, .shapes = std::move(space.shapes)},
              corner, sheet);
        double y = corner.y + height;
        for (const std::string& line : lines_below[i]) {
            sheet.shapes.push_back(Label{.at = {corner.x + width / 2, y += line_height},
                                         .text = line,
                                         .size = size,
                                         .anchor = Anchor::middle});
            sheet.description += (sheet.description.empty() ? "" : " ") + line;
        }
        bottom = std::max(bottom, y);
    }
    sheet.height = std::ceil(bottom + margin);
    return sheet;
}

/// The first step of a kind, or the one that was asked for if it is of that kind.
std::size_t step_of_kind(const Trace& trace, StepKind kind, std::optional<std::size_t> asked,
                         std::string_view sheet) {
    const std::size_t step = asked.value_or(trace.next_of({kind}, 1, trace.size()));
    if (0 < step && step <= trace.size() && trace.kind_of(step) == kind)
        return step;
    throw problem_of("", fmt::format("--sheet {}: expected a {} step, found {}", sheet,
                                     name_of(kind), asked ? "another" : "none"));
}

// --- A vertex in its spaces ----------------------------------------------------------------------

/// The twelve sides of a box whose front and back are given, in a circle each; nothing in front: an apex.
using Guides = std::vector<std::pair<Position, Position>>;
Guides sides_of(const std::vector<Position>& front, const std::vector<Position>& back) {
    Guides sides;
    for (std::size_t i = 0; i < back.size(); ++i) {
        sides.emplace_back(front[i % front.size()], back[i]);
        sides.emplace_back(back[i], back[(i + 1) % back.size()]);
        if (front.size() > 1)
            sides.emplace_back(front[i], front[(i + 1) % front.size()]);
    }
    return sides;
}

std::vector<Position> square(double half, double z) {
    return {{-half, half, z}, {half, half, z}, {half, -half, z}, {-half, -half, z}};
}

/// The vertices of a trace, in a space. That of clip space has w in the place of z.
std::map<std::string, Position> vertices_in(const Trace& trace, Space space, double forward) {
    std::map<std::string, Position> vertices;
    for (const std::size_t n : trace.steps_of({StepKind::vertex})) {
        const auto step = trace.step(n).as<VertexStep>();
        const auto numbers = step.at.values();
        if (!(step.space == space) || numbers.size() < 2)
            continue;
        std::array<double, 3> at{};
        for (std::size_t i = 0; i < 3 && i < numbers.size(); ++i)
            at[i] = numbers[space == Space::clip && i == 2 ? numbers.size() - 1 : i]
                        .nearest_double()
                        .value_or(0);
        if (space == Space::clip)
            at[2] *= forward;
        if (space == Space::screen)
            at[1] *= -trace.canvas.down();
        vertices[step.name.text()] = {at[0], at[1], at[2]};
    }
    return vertices;
}

/// What a space has of its own: what is in view, or the canvas.
void add_guides(Space space, const SpatialScene& world, const Trace& trace, SpatialScene& scene) {
    const ToldCamera& camera = *world.camera;
    if (space == Space::camera) {
        const SpaceSheet sheet(world, trace, {}, 1, 1);
        const auto in_camera = [&](const Position& at) {
            return Position(glm::inverse(camera.to_world()) * glm::dvec4(at, 1));
        };
        std::vector<Position> window;
        for (const Position& corner : sheet.window_at(sheet.plane_z()))
            window.push_back(in_camera(corner));
        scene.guides =
            sides_of(camera.eye() ? std::vector{in_camera(*camera.eye())} : window, window);
    } else if (space == Space::clip && camera.is_perspective()) {
        double most = 1;
        for (const auto& [name, at] : scene.vertices)
            most = std::max(most, std::abs(at.z));
        scene.guides = sides_of({{0, 0, 0}}, square(most, camera.forward() * most));
        scene.axis_names[2] = camera.forward() > 0 ? "w" : "-w";
    } else if (space == Space::canonical || space == Space::clip) {
        scene.guides = sides_of(square(1, -1), square(1, 1));
    } else if (space == Space::screen) {
        const Canvas& canvas = trace.canvas;
        const double up = -canvas.down();
        const Position first{canvas.left(), up * canvas.top(), 0};
        const Position last{canvas.right(), up * canvas.bottom(), 0};
        const std::vector<Position> frame{first, {last.x, first.y, 0}, last, {first.x, last.y, 0}};
        scene.guides = sides_of(frame, frame);
        scene.axis_names = {};
    }
}

std::vector<SpaceFrame> frames_of_spaces(const Trace& trace, std::size_t step,
                                         const SpaceEye& eye) {
    const std::string name = trace.step(step).as<VertexStep>().name.text();
    const auto world = space_of(trace);
    if (!world || !world->camera)
        throw problem_of("", "--sheet spaces: expected a scene with a projection, found none");
    const double forward = world->camera->forward();
    std::vector<SpaceFrame> frames;
    for (const Space space : all_spaces) {
        SpatialScene scene{.vertices = vertices_in(trace, space, forward),
                           .handedness = world->handedness};
        if (!scene.vertices.contains(name))
            continue;
        if (space == Space::world) {
            scene = *world;
        } else {
            for (const SpatialPrimitive& primitive : world->primitives)
                if (std::all_of(primitive.corners.begin(), primitive.corners.end(),
                                [&](const auto& one) { return scene.vertices.contains(one); }))
                    scene.primitives.push_back(primitive);
            // What is nearer is in front: a z that grows with the distance points away from there.
            if (space == Space::canonical)
                scene.handedness = world->camera->canonical_z_grows() ? -1 : 1;
            add_guides(space, *world, trace, scene);
        }
        scene.faces.clear();
        SpaceFrame frame{.space = std::move(scene), .eye = eye, .mark = name};
        if (space == Space::screen)
            frame.eye = *space_eye_named("front");
        std::string numbers;
        for (const std::size_t n : trace.steps_of({StepKind::vertex}))
            if (const auto vertex = trace.step(n).as<VertexStep>();
                numbers.empty() && vertex.space == space && vertex.name == name)
                numbers = tuple_of(vertex.at);
        frame.lines = {said("{}: {} {}", std::string(in_language_of_steps(word_of(space))),
                            printable(name), numbers)};
        frames.push_back(std::move(frame));
    }
    return frames;
}

// --- A face in ears ------------------------------------------------------------------------------

using Flat = std::array<Rational, 2>;

/// The corners of an ear, as its primitive names them.
std::vector<std::string> corners_named(const Trace& trace, const std::string& ear) {
    for (const std::size_t n : trace.steps_of({StepKind::primitive}))
        if (const auto primitive = trace.step(n).as<PrimitiveStep>(); primitive.name == ear)
            return primitive.vertices.texts();
    return {};
}

std::vector<SpaceFrame> frames_of_ears(const Trace& trace, std::size_t step) {
    const auto face = trace.step(step).as<TriangulateStep>();
    const auto ring_names = face.vertices.texts();
    const auto places = face.at.values();
    const std::size_t dropped = face.drops == "x" ? 0 : face.drops == "y" ? 1 : 2;
    SpatialScene scene{.vertices = {}, .axis_names = {}};
    std::map<std::string, Flat> flat;
    for (std::size_t i = 0; i < ring_names.size() && i < places.size(); ++i) {
        const auto numbers = places[i].values();
        const auto position = position_in(places[i]);
        if (!position)
            throw problem_of("", "--sheet ears: expected finite vertices, found others");
        scene.vertices[ring_names[i]] = *position;
        flat[ring_names[i]] = {numbers[(dropped + 1) % 3].exact().value_or(0),
                               numbers[(dropped + 2) % 3].exact().value_or(0)};
    }
    scene.primitives = {{.step = step, .name = face.name.text(), .corners = ring_names}};
    const auto normal = face.normal.values();
    const bool turns_left = normal.size() == 3 && sgn(normal[dropped].exact().value_or(1)) >= 0;
    SpaceEye eye{.direction = {0, 0, 0}, .is_named = false};
    eye.direction[dropped] = turns_left ? 1 : -1;

    const auto turn_at = [&](const std::vector<std::string>& ring, std::size_t i) {
        const Flat& a = flat.at(ring[(i + ring.size() - 1) % ring.size()]);
        const Flat& b = flat.at(ring[i]);
        const Flat& c = flat.at(ring[(i + 1) % ring.size()]);
        const int sign =
            sgn(Rational((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])));
        return turns_left ? sign : -sign;
    };
    std::vector<SpaceFrame> frames;
    std::vector<std::string> ring = ring_names;
    const auto ears = face.ears.texts();
    for (std::size_t i = 0; i < ears.size(); ++i) {
        const auto corners = corners_named(trace, ears[i]);
        if (corners.size() != 3)
            continue;
        scene.primitives.front().corners = ring;
        SpaceFrame frame{.space = scene, .eye = eye, .whole = ring_names, .filled = corners};
        std::string reflex;
        for (std::size_t k = 0; k < ring.size(); ++k)
            if (turn_at(ring, k) < 0)
                reflex += (reflex.empty() ? "" : ", ") + ring[k];
        const auto tip = std::find(ring.begin(), ring.end(), corners[1]);
        const std::string number = fmt::format("{}. {}: ", i + 1, printable(ears[i]));
        if (ring.size() > 3)
            frame.lines = {number + said("convex at {},", printable(corners[1])),
                           said("no other vertex in it"),
                           said("(reflex: {})", reflex.empty() ? said("none") : printable(reflex))};
        else
            frame.lines = {number + said("what is left")};
        frames.push_back(std::move(frame));
        if (tip != ring.end())
            ring.erase(tip);
    }
    return frames;
}

} // namespace

std::vector<std::string_view> space_frames_names() {
    return {words_of_frames.begin(), words_of_frames.end()};
}

std::optional<SpaceFrames> space_frames_named(std::string_view name) {
    return value_named<SpaceFrames>(words_of_frames, name);
}

Drawing space_frames(const Trace& trace, SpaceFrames frames, std::optional<std::size_t> step,
                     const SpaceEye& eye, double letter_scale) {
    const auto first = [&](StepKind kind) {
        return step_of_kind(trace, kind, step, words_of_frames[static_cast<std::size_t>(frames)]);
    };
    return sheet_of(trace,
                    frames == SpaceFrames::spaces
                        ? frames_of_spaces(trace, first(StepKind::vertex), eye)
                        : frames_of_ears(trace, first(StepKind::triangulate)),
                    letter_scale);
}

} // namespace rastertrace
