// SPDX-License-Identifier: MIT
#include "space_drawing.h"

#include <rastertrace/figures/page.h>
#include <rastertrace/figures/svg.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace rastertrace {

namespace {

constexpr std::size_t most_names = 24;   ///< of vertices that are told
constexpr std::size_t most_rays = 12;    ///< of sight that are drawn
constexpr std::size_t most_images = 100; ///< of primitives, on the view plane
constexpr std::size_t most_angles = 4;
constexpr std::size_t most_culled = 60; ///< sides of culled faces

/// The sides of primitives, each once, whichever way round.
using Sides = std::set<std::pair<std::string, std::string>>;

std::vector<std::pair<std::string, std::string>> sides_of(const SpatialPrimitive& primitive) {
    std::vector<std::pair<std::string, std::string>> sides;
    const std::size_t count = primitive.corners.size();
    for (std::size_t i = 0; i + (primitive.is_closed ? 0 : 1) < count && count > 1; ++i)
        sides.emplace_back(std::minmax(primitive.corners[i], primitive.corners[(i + 1) % count]));
    return sides;
}

/// Adds sides, but for those where a face was cut into triangles.
void add_sides(const std::vector<const SpatialPrimitive*>& primitives, Sides& sides) {
    std::map<std::string, std::map<std::pair<std::string, std::string>, int>> times; // in a face
    for (const SpatialPrimitive* primitive : primitives)
        for (const auto& side : sides_of(*primitive))
            ++times[primitive->face][side];
    for (const auto& [face, all] : times)
        for (const auto& [side, count] : all)
            if (face.empty() || count == 1)
                sides.insert(side);
}

void add_edges(SpaceWeight weight, SpaceSheet& sheet) {
    std::vector<const SpatialPrimitive*> of_seen;
    std::vector<const SpatialPrimitive*> of_culled;
    for (const SpatialPrimitive& primitive : sheet.space().primitives)
        if (!primitive.is_part)
            (primitive.is_culled ? of_culled : of_seen).push_back(&primitive);
    Sides seen;
    Sides culled;
    add_sides(of_seen, seen);
    add_sides(of_culled, culled);
    const auto& vertices = sheet.space().vertices;
    const Role role = weight == SpaceWeight::strong ? Role::true_edge : Role::pale_edge;
    for (const auto& [a, b] : culled)
        if (culled.size() <= most_culled && !seen.contains({a, b}))
            sheet.line(vertices.at(a), vertices.at(b), Role::other_edge);
    for (const auto& [a, b] : seen)
        sheet.line(vertices.at(a), vertices.at(b), role);
}

/// What is on the view plane: the images of primitives.
void add_images(SpaceSheet& sheet) {
    const SpatialScene& space = sheet.space();
    std::vector<const SpatialPrimitive*> shown;
    for (const SpatialPrimitive& primitive : space.primitives)
        if (!primitive.is_culled)
            shown.push_back(&primitive);
    if (shown.size() > most_images)
        return;
    Sides sides;
    add_sides(shown, sides);
    const auto image_of = [&](const std::string& name) {
        const auto found = space.images.find(name);
        return found == space.images.end() ? std::optional<Position>()
                                           : space.camera->at(found->second, sheet.plane_z());
    };
    for (const auto& [a, b] : sides)
        if (const auto from = image_of(a), to = image_of(b); from && to)
            sheet.line(*from, *to, Role::image_edge);
}

/// The eye, the plane that it looks through, and how far: from the plane on, the sides of what is in view.
void add_camera(SpaceSheet& sheet) {
    const ToldCamera& camera = *sheet.space().camera;
    const auto window = sheet.window_at(sheet.plane_z());
    const auto end = sheet.window_at(sheet.sides_z());
    for (std::size_t i = 0; i < window.size(); ++i)
        sheet.line(camera.eye().value_or(window[i]), end[i], Role::leader);
    if (sheet.shows_far_plane()) {
        sheet.outline(end, Role::leader);
        sheet.words(end[1], sheet.all().middle(), in_language_of_steps("far"), Role::quiet_text, 9);
    }
    sheet.polygon(window, Role::window, Role::view_plane);
    add_images(sheet);
    if (const auto eye = camera.eye()) {
        // d is the name of the distance to a plane of one's own; a frustum's is near.
        const Position foot = Position(camera.to_world() * glm::dvec4(0, 0, sheet.plane_z(), 1));
        sheet.line(*eye, foot, Role::ray);
        sheet.dot(*eye, Role::eye, 4);
        sheet.words(*eye, foot, said("eye"), Role::eye);
        if (!camera.near_z())
            sheet.words((*eye + foot) / 2.0, (*eye + foot) / 2.0,
                        fmt::format("d = {}", decimal(glm::length(foot - *eye))), Role::quiet_text,
                        9);
    }
    sheet.words(window[0], (window[0] + window[2]) / 2.0,
                camera.near_z() && camera.is_perspective()
                    ? std::string(in_language_of_steps("near"))
                    : said("view plane"),
                Role::view_plane, 9);
}

void add_rays(SpaceSheet& sheet) {
    const SpatialScene& space = sheet.space();
    if (!space.camera || space.images.size() > most_rays)
        return;
    for (const auto& [name, image] : space.images)
        if (const auto vertex = space.vertices.find(name); vertex != space.vertices.end())
            sheet.line(sheet.sight_at(image).first, vertex->second, Role::ray);
}

void add_normals(SpaceSheet& sheet) {
    const SpatialScene& space = sheet.space();
    if (space.faces.size() > most_normals_in_space)
        return;
    const bool has_angles = space.faces.size() <= most_angles;
    for (const FaceTest& face : space.faces) {
        const Position middle = space.middle_of(space.primitives[face.primitive]);
        sheet.arrow(middle, sheet.tip_of(face, face.normal),
                    face.is_culled ? Role::culled_normal : Role::normal);
        if (has_angles && face.other && face.cosine) {
            if (!face.is_light)
                sheet.line(middle, middle + *face.other, Role::other_edge);
            sheet.angle(middle, face.normal, *face.other, *face.cosine);
        }
    }
}

} // namespace

void add_space(SpaceWeight weight, SpaceSheet& sheet) {
    const SpatialScene& space = sheet.space();
    for (const auto& [from, to] : space.guides)
        sheet.line(from, to, Role::view_plane);
    if (!space.axis_names[0].empty() && sheet.all().grown(0.02).has({}))
        sheet.axes(glm::dmat4(1), Role::leader);
    if (weight == SpaceWeight::strong)
        add_rays(sheet);
    if (space.camera)
        add_camera(sheet);
    add_edges(weight, sheet);
    if (const auto light = sheet.light()) {
        sheet.arrow(light->first, light->second, Role::light_ray);
        sheet.words(light->first, light->second, said("light"), Role::light_ray);
    }
    if (weight == SpaceWeight::strong)
        add_normals(sheet);
    if (space.vertices.size() > most_names)
        return;
    const Position middle = sheet.vertices().middle();
    for (const auto& [name, position] : space.vertices)
        sheet.words(position, middle, printable(name), Role::strong_text, 10, true);
}

Drawing space_drawing(const SpatialScene& space, const Trace& trace, const SpaceEye& eye,
                      std::pair<double, double> size, const Replay* replay) {
    SpaceSheet sheet(space, trace, eye, size.first, size.second);
    add_space(replay != nullptr ? SpaceWeight::pale : SpaceWeight::strong, sheet);
    if (replay != nullptr)
        add_step_in_space(*replay, sheet);
    return {
        .width = size.first, .height = size.second, .title = {}, .shapes = std::move(sheet.shapes)};
}

namespace {

class StepsOfScene final : public StepsInSpace {
public:
    StepsOfScene(SpatialScene space, const Trace& trace, const SpaceEye& eye)
        : space_(std::move(space)), sheet_(space_, trace, eye, width, height) {
        add_space(SpaceWeight::pale, sheet_);
    }

    std::string of_all() const override { return svg_elements(sheet_.shapes); }

    std::string of_step(const Replay& replay) const override {
        SpaceSheet sheet = sheet_;
        sheet.shapes.clear();
        add_step_in_space(replay, sheet);
        return svg_elements(sheet.shapes);
    }

private:
    SpatialScene space_;
    SpaceSheet sheet_;
};

} // namespace

std::unique_ptr<const StepsInSpace> steps_in_space(const Trace& trace, const SpaceEye& eye) {
    auto space = space_of(trace);
    return space ? std::make_unique<const StepsOfScene>(*std::move(space), trace, eye) : nullptr;
}

} // namespace rastertrace
