// SPDX-License-Identifier: MIT
// What a step is about, in the picture in space.

#include "space_sheet.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/meeting_point.h>
#include <rastertrace/trace/tell/shown_steps.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/tell/told_samples.h>
#include <rastertrace/trace/tell/view.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <optional>

namespace rastertrace {

namespace {

constexpr double strong_dot = 3.2;

const SpatialPrimitive* primitive_at(std::size_t step, const SpatialScene& space) {
    const auto found = std::lower_bound(
        space.primitives.begin(), space.primitives.end(), step,
        [](const SpatialPrimitive& primitive, std::size_t n) { return primitive.step < n; });
    return found != space.primitives.end() && found->step == step ? &*found : nullptr;
}

void add_primitive(const SpatialPrimitive& primitive, SpaceSheet& sheet) {
    const auto corners = sheet.space().places_of(primitive.corners);
    if (primitive.is_closed && primitive.is_filled)
        sheet.polygon(corners, Role::inside, Role::true_edge);
    else if (primitive.is_closed)
        sheet.outline(corners, Role::true_edge);
    else if (corners.size() == 2)
        sheet.line(corners[0], corners[1], Role::true_edge);
    else
        sheet.dot(corners[0], Role::vertex, strong_dot);
}

/// The last `model` matrix so far.
glm::dmat4 model_at(const Replay& replay) {
    glm::dmat4 model(1);
    for (const std::size_t n : replay.matrices())
        if (const auto step = replay.trace().step(n).as<MatrixStep>(); step.name == "model")
            model = matrix_in(step).value_or(model);
    return model;
}

/// A place by its three coordinates: along x, then z, then y.
void add_coordinates(const glm::dmat4& basis, const Position& at, SpaceSheet& sheet) {
    const auto place = [&](double x, double y, double z) {
        return Position(basis * glm::dvec4(x, y, z, 1));
    };
    if (!sheet.all().grown(0.02).has(place(0, 0, 0)))
        return;                 // far away from all the rest
    if (basis != glm::dmat4(1)) // those of the world are there
        sheet.axes(basis, Role::axis);
    sheet.line(place(0, 0, 0), place(at.x, 0, 0), Role::other_edge);
    sheet.line(place(at.x, 0, 0), place(at.x, 0, at.z), Role::other_edge);
    sheet.line(place(at.x, 0, at.z), place(at.x, at.y, at.z), Role::other_edge);
}

/// The plane of a meeting point: parallel to the view plane, or through the eye and along a side of the canvas.
Position normal_of(const std::string& plane, const Position& met, const ToldCamera& camera) {
    const glm::dmat4 basis = camera.to_world();
    if (plane == "near" || plane == "far")
        return Position(basis[2]);
    const Position sight = camera.eye() ? met - *camera.eye() : Position(basis[2]);
    return glm::cross(sight, Position(basis[plane == "left" || plane == "right" ? 1 : 0]));
}

/// A plane that cuts a primitive, and where it meets the edges: `met` is the step of a vertex that it made.
void add_cut(Replay& at_vertex, const std::string& plane, SpaceSheet& sheet) {
    const SpatialScene& space = sheet.space();
    const Trace& trace = sheet.trace();
    bool is_drawn = false;
    for (std::size_t n = at_vertex.step() + 1; n <= trace.size(); ++n) {
        const auto kind = trace.kind_of(n);
        if (kind == StepKind::clip)
            continue;
        if (kind != StepKind::vertex)
            break;
        const auto vertex = trace.step(n).as<VertexStep>();
        const auto found = space.vertices.find(vertex.name.text());
        if (!(vertex.space == Space::clip) || found == space.vertices.end())
            continue;
        at_vertex.go_to(n);
        const auto meeting = meeting_point_of(at_vertex);
        if (!meeting || meeting->plane != plane)
            continue;
        if (!is_drawn) {
            const Position normal = normal_of(plane, found->second, *space.camera);
            const auto polygon = sheet.all().grown(0.05).section(found->second, normal);
            if (!polygon.empty()) {
                sheet.polygon(polygon, Role::outside, Role::leader);
                if (plane != "near" || !space.camera->near_z())
                    sheet.words(polygon.front(), found->second,
                                said("{} plane", std::string(in_language_of_steps(plane))),
                                Role::normal);
            }
            is_drawn = true;
        }
        sheet.dot(found->second, Role::rejected, strong_dot);
        sheet.words(found->second, sheet.vertices().middle(),
                    fmt::format("t = {}", short_number(meeting->t.get_str())), Role::normal, 10,
                    true);
    }
}

/// The vertices of a primitive, of those inside a plane and of those outside.
void add_clip(const Replay& replay, SpaceSheet& sheet) {
    const SpatialScene& space = sheet.space();
    const ClipStep step = sheet.trace().step(replay.step()).as<ClipStep>();
    if (!space.camera)
        return;
    for (const SpatialPrimitive& primitive : space.primitives)
        if (primitive.name == step.name.text() && !primitive.is_part) {
            const auto corners = space.places_of(primitive.corners);
            sheet.outline(corners, Role::other_edge);
            const auto inside = step.inside.values();
            for (std::size_t i = 0; i < corners.size() && corners.size() == inside.size(); ++i)
                sheet.words(corners[i], space.middle_of(primitive),
                            inside[i].is_true() ? said("inside") : said("outside"),
                            Role::quiet_text);
        } else if (primitive.is_part &&
                   name_of_whole(sheet.trace().step(primitive.step).as<PrimitiveStep>()) ==
                       step.name.text()) {
            add_primitive(primitive, sheet);
        }
    Replay at(sheet.trace());
    at.go_to(replay.step());
    add_cut(at, step.plane.text(), sheet);
}

void add_vertex(const Replay& replay, SpaceSheet& sheet) {
    const SpatialScene& space = sheet.space();
    const auto step = sheet.trace().step(replay.step()).as<VertexStep>();
    const std::string name = step.name.text();
    const auto found = space.vertices.find(name);
    if (found == space.vertices.end())
        return;
    const Position at = found->second;
    const Position middle = sheet.vertices().middle();
    const auto own = position_in(step.at);
    Position mark = at; // where its numbers stand
    if (step.space == Space::object && own) {
        add_coordinates(model_at(replay), *own, sheet);
    } else if (step.space == Space::world && own) {
        add_coordinates(glm::dmat4(1), *own, sheet);
    } else if (step.space == Space::camera && own && space.camera) {
        add_coordinates(space.camera->to_world(), *own, sheet);
    } else if (const auto image = space.images.find(name);
               space.camera && image != space.images.end()) {
        const Position eye = sheet.sight_at(image->second).first;
        const Position seen = space.camera->at(image->second, sheet.plane_z());
        sheet.line(eye, glm::length(seen - eye) > glm::length(at - eye) ? seen : at, Role::sight);
        sheet.dot(seen, Role::rejected, strong_dot);
        mark = step.space == Space::clip ? at : seen;
    }
    sheet.dot(at, Role::vertex, strong_dot);
    sheet.words(mark, middle, tuple_of(step.at), Role::normal, 10, true);
}

void add_matrix(const Replay& replay, SpaceSheet& sheet) {
    const auto step = sheet.trace().step(replay.step()).as<MatrixStep>();
    const auto& camera = sheet.space().camera;
    if (step.name == "model")
        if (const auto model = matrix_in(step))
            sheet.axes(*model, Role::normal);
    if (!camera)
        return;
    if (step.name == "view")
        sheet.axes(camera->to_world(), Role::normal);
    const auto window = sheet.window_at(sheet.plane_z());
    const auto end = sheet.window_at(sheet.sides_z());
    if (step.name == "projection") {
        for (std::size_t i = 0; i < window.size(); ++i)
            sheet.line(camera->eye().value_or(window[i]), end[i], Role::sight);
        sheet.outline(window, Role::sight);
        sheet.outline(end, Role::sight);
    }
    if (step.name == "viewport") {
        sheet.outline(window, Role::sight);
        const Canvas& canvas = sheet.trace().canvas;
        const Position middle = (window[0] + window[2]) / 2.0;
        sheet.words(window[0], middle, fmt::format("({}, {})", canvas.left(), canvas.top()),
                    Role::normal, 10, true);
        sheet.words(window[2], middle, fmt::format("({}, {})", canvas.right(), canvas.bottom()),
                    Role::normal, 10, true);
    }
}

/// The normal of a face, and what it is compared with.
void add_face(const Replay& replay, SpaceSheet& sheet) {
    const SpatialScene& space = sheet.space();
    for (const FaceTest& face : space.faces) {
        if (face.step != replay.step())
            continue;
        const SpatialPrimitive& primitive = space.primitives[face.primitive];
        const Position middle = space.middle_of(primitive);
        if (glm::length(face.normal) > 0) {
            const auto plane = sheet.vertices().grown(0.1).section(middle, face.normal);
            if (!plane.empty())
                sheet.polygon(plane, Role::outside, Role::leader);
        }
        add_primitive(primitive, sheet);
        const Position tip = sheet.tip_of(face, face.normal);
        sheet.arrow(middle, tip, face.is_culled ? Role::culled_normal : Role::normal);
        sheet.words(tip, middle, "N", Role::normal, 10, true);
        if (!face.other)
            continue;
        const Role role = face.is_light ? Role::light_ray : Role::sight;
        const Position other = sheet.tip_of(face, *face.other);
        if (!face.is_light)
            sheet.line(middle, middle + *face.other, Role::ray);
        sheet.arrow(middle, other, role);
        sheet.words(other, middle, face.is_light ? "L" : "V", role, 10, true);
        if (face.cosine)
            sheet.angle(middle, face.normal, *face.other, *face.cosine);
    }
}

/// In which order the painter draws.
void add_order(const Replay& replay, SpaceSheet& sheet) {
    const SpatialScene& space = sheet.space();
    const auto names = sheet.trace().step(replay.step()).as<OrderStep>().names.texts();
    for (std::size_t i = 0; i < names.size(); ++i)
        for (const SpatialPrimitive& primitive : space.primitives)
            if (primitive.name == names[i]) {
                const Position middle = space.middle_of(primitive);
                sheet.dot(middle, Role::vertex, 1.5);
                sheet.words(middle, middle, fmt::format("{}.", i + 1), Role::normal, 10, true);
                break;
            }
}

/// Where a line of sight meets a convex polygon: in so many parts of the way.
std::optional<double> hit(const Position& from, const Position& way,
                          const std::vector<Position>& corners) {
    const Position normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double along = glm::dot(normal, way);
    if (along == 0)
        return std::nullopt;
    const double share = glm::dot(normal, corners[0] - from) / along;
    const Position met = from + share * way;
    const double slack = -1e-9 * glm::dot(normal, normal);
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (glm::dot(normal, glm::cross(corners[(i + 1) % corners.size()] - corners[i],
                                        met - corners[i])) < slack)
            return std::nullopt;
    return share;
}

/// The line of sight of a pixel, and the faces that it meets, the nearest first.
void add_sight(Pixel pixel, const Replay& replay, SpaceSheet& sheet) {
    const SpatialScene& space = sheet.space();
    if (!space.camera)
        return;
    const SpatialPrimitive* const own = primitive_at(replay.primitive(), space);
    const auto samples = told_samples(sheet.trace());
    const auto& offset = own != nullptr && !own->is_filled ? samples.lines : samples.triangles;
    const Place screen{pixel.x + offset.x().get_d(), pixel.y + offset.y().get_d()};
    sheet.polygon(sheet.pixel_at(pixel, sheet.plane_z()), Role::current, Role::current_border);
    const auto [from, to] = sheet.sight_at(screen);
    struct Met {
        double share;
        const SpatialPrimitive* primitive;
    };
    std::vector<Met> met;
    for (const SpatialPrimitive& primitive : space.primitives)
        if (primitive.is_filled && !primitive.is_culled && !primitive.is_part &&
            primitive.corners.size() > 2)
            if (const auto share = hit(from, to - from, space.places_of(primitive.corners));
                share && *share > 0)
                met.push_back({*share, &primitive});
    std::stable_sort(met.begin(), met.end(),
                     [](const Met& a, const Met& b) { return a.share < b.share; });
    sheet.line(from, to, Role::sight);
    for (std::size_t i = 0; i < met.size(); ++i) {
        const Position at = from + met[i].share * (to - from);
        sheet.dot(at, i == 0 ? Role::rejected : Role::sample, i == 0 ? strong_dot : 2.2);
        sheet.words(at, sheet.vertices().middle(),
                    fmt::format("{}. {}", i + 1, printable(met[i].primitive->name)), Role::normal,
                    10, i == 0);
    }
}

/// A row on the view plane, and the lines of sight of its ends, up to the face.
void add_row(const Replay& replay, Index y, const TracedNumber& left_end,
             const TracedNumber& right_end, SpaceSheet& sheet) {
    const SpatialScene& space = sheet.space();
    const auto left = left_end.nearest_double();
    const auto right = right_end.nearest_double();
    const SpatialPrimitive* const own = primitive_at(replay.primitive(), space);
    if (!space.camera || !left || !right || own == nullptr || own->corners.size() < 3)
        return;
    const double sample =
        static_cast<double>(y) + told_samples(sheet.trace()).triangles.y().get_d();
    const auto corners = space.places_of(own->corners);
    const Position normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    std::vector<Position> on_face;
    for (const double x : {*left, *right}) {
        const auto [from, to] = sheet.sight_at({x, sample});
        const double along = glm::dot(normal, to - from);
        const double share = along == 0 ? 1 : glm::dot(normal, corners[0] - from) / along;
        on_face.push_back(from + share * (to - from));
        sheet.line(from, on_face.back(), Role::ray);
    }
    sheet.line(space.camera->at({*left, sample}, sheet.plane_z()),
               space.camera->at({*right, sample}, sheet.plane_z()), Role::sight);
    sheet.line(on_face[0], on_face[1], Role::sight);
}

} // namespace

void add_step_in_space(const Replay& replay, SpaceSheet& sheet) {
    const auto kind = sheet.trace().kind_of(replay.step());
    const StepSubject subject = subject_of(replay, replay.step());
    const SpatialPrimitive* const own = primitive_at(subject.primitive, sheet.space());
    const auto add_own = [&] {
        if (own != nullptr)
            add_primitive(*own, sheet);
    };
    const StepView step = sheet.trace().step(replay.step());
    if (!kind)
        return; // of a foreign rasterizer
    switch (*kind) {
    case StepKind::matrix:
        return add_matrix(replay, sheet);
    case StepKind::vertex:
        return add_vertex(replay, sheet);
    case StepKind::clip:
        return add_clip(replay, sheet);
    case StepKind::face:
    case StepKind::light:
        return add_face(replay, sheet);
    case StepKind::order:
        return add_order(replay, sheet);
    case StepKind::triangulate:
        for (const SpatialPrimitive& primitive : sheet.space().primitives)
            if (primitive.face == step.as<TriangulateStep>().name.text())
                add_primitive(primitive, sheet);
        return;
    case StepKind::edge:
        add_own();
        if (own != nullptr && subject.edge) {
            const auto corners = sheet.space().places_of(own->corners);
            sheet.line(corners[(*subject.edge)[0]], corners[(*subject.edge)[1]],
                       Role::current_border);
        }
        return;
    case StepKind::crossings:
        add_own();
        if (const auto row = step.as<CrossingsStep>(); row.x.values().size() > 1)
            add_row(replay, row.y, row.x.values().front(), row.x.values().back(), sheet);
        return;
    case StepKind::scanline: {
        const auto row = step.as<ScanlineStep>();
        add_own();
        return add_row(replay, row.y, row.left, row.right, sheet);
    }
    default:
        add_own();
        if (const auto pixel = pixel_of(sheet.trace(), replay.step()))
            add_sight(*pixel, replay, sheet);
    }
}

} // namespace rastertrace
