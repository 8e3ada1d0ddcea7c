// SPDX-License-Identifier: MIT
#include "space_sheet.h"

#include "clip.h"

#include <rastertrace/trace/tell/told_samples.h>

#include <fmt/core.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rastertrace {

void Bounds::include(const Position& position) {
    least_ = is_empty_ ? position : glm::min(least_, position);
    most_ = is_empty_ ? position : glm::max(most_, position);
    is_empty_ = false;
}

bool Bounds::has(const Position& position) const {
    for (int i = 0; i < 3; ++i)
        if (position[i] < least_[i] || most_[i] < position[i])
            return false;
    return true;
}

double Bounds::diagonal() const {
    const double length = glm::length(most_ - least_);
    return length > 0 ? length : 1; // of a single vertex
}

Bounds Bounds::grown(double part) const {
    Bounds larger = *this;
    larger.include(least_ - Position(part * diagonal()));
    larger.include(most_ + Position(part * diagonal()));
    return larger;
}

std::vector<Position> Bounds::section(const Position& point, const Position& normal) const {
    const auto corner = [this](int i) {
        return Position{(i & 1) != 0 ? most_.x : least_.x, (i & 2) != 0 ? most_.y : least_.y,
                        (i & 4) != 0 ? most_.z : least_.z};
    };
    std::vector<Position> met;
    for (int i = 0; i < 8; ++i)
        for (int bit = 1; bit < 8; bit *= 2) {
            if ((i & bit) != 0)
                continue;
            const double a = glm::dot(corner(i) - point, normal);
            const double b = glm::dot(corner(i | bit) - point, normal);
            if ((a <= 0) != (b <= 0))
                met.push_back(corner(i) + a / (a - b) * (corner(i | bit) - corner(i)));
        }
    if (met.size() < 3)
        return {};
    // Around their middle.
    Position middle{};
    for (const Position& one : met)
        middle += one / static_cast<double>(met.size());
    const Position u = glm::normalize(met.front() - middle);
    const Position v = glm::normalize(glm::cross(normal, u));
    const auto turn = [&](const Position& one) {
        return std::atan2(glm::dot(one - middle, v), glm::dot(one - middle, u));
    };
    std::sort(met.begin(), met.end(),
              [&](const Position& a, const Position& b) { return turn(a) < turn(b); });
    return met;
}

namespace {

constexpr double note_size = 10; ///< of letters

/// How far the faces of a scene are from being seen edge-on, as a sine; of a scene of many, 1: no place shows all.
double openness(const SpatialScene& space, const Position& toward) {
    constexpr std::size_t few = 8;
    double least = 1;
    if (space.primitives.size() > few)
        return least;
    for (const SpatialPrimitive& primitive : space.primitives) {
        if (!primitive.is_filled || primitive.corners.size() < 3)
            continue;
        const auto corner = [&](std::size_t i) { return space.vertices.at(primitive.corners[i]); };
        const Position normal = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
        if (const double length = glm::length(normal); length > 0)
            least = std::min(least, std::abs(glm::dot(normal, toward)) / length);
    }
    return least;
}

} // namespace

SpaceSheet::SpaceSheet(const SpatialScene& space, const Trace& trace, const SpaceEye& eye,
                       double width, double height)
    : space_(space), trace_(trace), middle_(pixels_begin_at_integers(trace) ? 0.5 : 0) {
    const auto& camera = space.camera;
    // z of the eye's direction is toward where the camera stands; one that looks along +z has a left-handed space.
    const double handedness = space.handedness;
    Position toward = glm::normalize(Position{eye.direction[0], eye.direction[1],
                                              eye.direction[2] * (eye.is_named ? handedness : 1)});
    constexpr double open_enough = 0.15;
    const Position other_side{-toward.x, toward.y, toward.z};
    if (eye.is_named && openness(space, toward) < open_enough &&
        openness(space, other_side) > open_enough)
        toward = other_side;
    constexpr double nearly_along_y = 0.999;
    const Position upward = std::abs(toward.y) > nearly_along_y
                                ? Position{0, 0, -handedness * (toward.y < 0 ? -1 : 1)}
                                : Position{0, 1, 0};
    right_ = handedness * glm::normalize(glm::cross(upward, toward));
    up_ = handedness * glm::cross(toward, right_);

    for (const auto& [name, position] : space.vertices)
        vertices_.include(position);
    all_ = vertices_;
    if (camera) {
        const double forward = camera->forward();
        double nearest = 0;
        double farthest = 0;
        bool is_first = true;
        for (const auto& [name, position] : space.vertices) {
            const double depth = forward * camera->depth_of(position);
            nearest = is_first ? depth : std::min(nearest, depth);
            farthest = is_first ? depth : std::max(farthest, depth);
            is_first = false;
        }
        const auto near = camera->near_z();
        const auto far = camera->far_z();
        plane_z_ = near                       ? *near
                   : camera->is_perspective() ? camera->plane_z()
                                              : forward * (nearest - 0.3 * size());
        farthest = std::max(farthest + 0.1 * size(), forward * plane_z_);
        // One that is far behind all the rest would make that small.
        shows_far_plane_ = far && forward * *far < farthest + size();
        end_z_ = shows_far_plane_ ? *far : forward * farthest;
        const auto stands = camera->eye();
        constexpr double beyond = 1.5; // as far from the eye as the plane
        sides_z_ = stands && !shows_far_plane_
                       ? (1 - beyond) * camera->depth_of(*stands) + beyond * plane_z_
                       : end_z_;
        if (camera->eye())
            all_.include(*camera->eye());
        for (const Position& corner : window_at(plane_z_))
            all_.include(corner);
    }

    std::vector<Position> shown;
    for (const auto& [name, position] : space.vertices)
        shown.push_back(position);
    if (camera) {
        for (const double z : {plane_z_, sides_z_})
            for (const Position& corner : window_at(z))
                shown.push_back(corner);
        if (camera->eye())
            shown.push_back(*camera->eye());
    }
    if (space.faces.size() <= most_normals_in_space)
        for (const FaceTest& face : space.faces)
            shown.push_back(tip_of(face, face.normal));
    for (const auto& [from, to] : space.guides)
        shown.insert(shown.end(), {from, to});
    if (const auto sun = light())
        shown.push_back(sun->first);
    Place least = flat(shown.front());
    Place most = least;
    for (const Position& position : shown) {
        const Place place = flat(position);
        least = {std::min(least.x, place.x), std::min(least.y, place.y)};
        most = {std::max(most.x, place.x), std::max(most.y, place.y)};
    }
    constexpr double margin = 24; // for words
    const double across = std::max(most.x - least.x, 1e-300);
    const double down = std::max(most.y - least.y, 1e-300);
    scale_ = std::min((width - 2 * margin) / across, (height - 2 * margin) / down);
    origin_ = {(width - scale_ * across) / 2 - scale_ * least.x,
               (height - scale_ * down) / 2 - scale_ * least.y};
    const Rectangle sheet{{}, width, height};
    obstacles_ = {.sheet = sheet, .frame = sheet};
}

std::pair<Position, Position> SpaceSheet::sight_at(Place screen) const {
    const ToldCamera& camera = *space_.camera;
    return {camera.eye() ? *camera.eye() : camera.at(screen, plane_z_), camera.at(screen, end_z_)};
}

std::vector<Position> SpaceSheet::window_at(double z) const {
    const Canvas& canvas = trace_.canvas;
    const double left = canvas.left() + middle_ - 0.5;
    const double top = canvas.top() + middle_ - 0.5 * canvas.down();
    const double right = left + canvas.width;
    const double bottom = top + canvas.down() * canvas.height;
    const ToldCamera& camera = *space_.camera;
    return {camera.at({left, top}, z), camera.at({right, top}, z), camera.at({right, bottom}, z),
            camera.at({left, bottom}, z)};
}

std::vector<Position> SpaceSheet::pixel_at(Pixel pixel, double z) const {
    const double left = pixel.x + middle_ - 0.5;
    const double low = pixel.y + middle_ - 0.5;
    const ToldCamera& camera = *space_.camera;
    return {camera.at({left, low}, z), camera.at({left + 1, low}, z),
            camera.at({left + 1, low + 1}, z), camera.at({left, low + 1}, z)};
}

Position SpaceSheet::tip_of(const FaceTest& face, const Position& direction) const {
    constexpr double part = 0.25; // of the whole scene
    const double length = glm::length(direction);
    return space_.middle_of(space_.primitives[face.primitive]) +
           (length > 0 ? part * size() / length : 0) * direction;
}

std::optional<std::pair<Position, Position>> SpaceSheet::light() const {
    for (const FaceTest& face : space_.faces)
        if (face.is_light && face.other && glm::length(*face.other) > 0) {
            const Position toward = glm::normalize(*face.other);
            return std::pair(vertices_.middle() + 0.85 * size() * toward,
                             vertices_.middle() + 0.6 * size() * toward);
        }
    return std::nullopt;
}

Place SpaceSheet::flat(const Position& position) const {
    return {glm::dot(right_, position), -glm::dot(up_, position)};
}

Place SpaceSheet::at(const Position& position) const {
    const Place place = flat(position);
    return {origin_.x + scale_ * place.x, origin_.y + scale_ * place.y};
}

void SpaceSheet::line(const Position& from, const Position& to, Role role) {
    Path path{at(from), at(to)};
    obstacles_.sides.push_back(path);
    shapes.push_back(Lines{.role = role, .paths = {std::move(path)}});
}

Path SpaceSheet::path_of(const std::vector<Position>& corners) const {
    Path path;
    for (const Position& corner : corners)
        path.push_back(at(corner));
    return path;
}

void SpaceSheet::add_outline(Path path, Role role) {
    for (std::size_t i = 0; i < path.size(); ++i)
        obstacles_.sides.push_back({path[i], path[(i + 1) % path.size()]});
    shapes.push_back(Lines{.role = role, .paths = {std::move(path)}, .are_closed = true});
}

void SpaceSheet::outline(const std::vector<Position>& corners, Role role) {
    add_outline(path_of(corners), role);
}

void SpaceSheet::polygon(const std::vector<Position>& corners, Role fill, Role border) {
    // A plane may go on beyond the sheet.
    Path path = clipped(path_of(corners), obstacles_.sheet);
    shapes.push_back(Polygons{.role = fill, .paths = {path}});
    add_outline(std::move(path), border);
}

void SpaceSheet::arrow(const Position& from, const Position& to, Role role) {
    constexpr double head = 6;
    add_arrow(at(from), at(to), role, head, shapes);
    obstacles_.sides.push_back({at(from), at(to)});
}

void SpaceSheet::dot(const Position& position, Role role, double radius) {
    shapes.push_back(Dots{.role = role, .radius = radius, .centers = {at(position)}});
    obstacles_.words.push_back(box_around(at(position), radius));
}

void SpaceSheet::words(const Position& mark, const Position& inside, std::string_view text,
                       Role role, double size, bool is_bold) {
    const WordsWish wish{at(mark), at(inside), text, size};
    const auto box = words_beside(wish, obstacles_);
    if (!box)
        return;
    obstacles_.words.push_back(*box);
    Label label = strong_label_in(*box, wish);
    label.role = role;
    label.is_bold = is_bold;
    shapes.push_back(std::move(label));
}

void SpaceSheet::axes(const glm::dmat4& basis, Role role) {
    constexpr double part = 0.22; // of the whole scene
    const Position origin(basis[3]);
    for (int i = 0; i < 3; ++i) {
        const Position axis(basis[i]);
        if (glm::length(axis) == 0)
            continue;
        const Position tip = origin + part * size() * glm::normalize(axis);
        arrow(origin, tip, role);
        words(tip, origin, space_.axis_names[static_cast<std::size_t>(i)], role);
    }
}

void SpaceSheet::angle(const Position& around, const Position& from, const Position& to,
                       double cosine) {
    const Position u = glm::normalize(from);
    const Position beside = glm::normalize(to) - glm::dot(glm::normalize(to), u) * u;
    const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double radius = 0.1 * size();
    Path arc;
    if (glm::length(beside) > 0) {
        const Position v = glm::normalize(beside);
        constexpr int pieces = 16;
        for (int i = 0; i <= pieces; ++i) {
            const double share = angle * i / pieces;
            arc.push_back(at(around + radius * (std::cos(share) * u + std::sin(share) * v)));
        }
        shapes.push_back(Lines{.role = Role::axis, .paths = {std::move(arc)}});
    }
    const Position between = glm::normalize(u + glm::normalize(to) + 1e-9 * up_);
    constexpr double degrees = 180 / std::numbers::pi;
    words(around + 1.3 * radius * between, around, fmt::format("{:.1f}\u00b0", angle * degrees),
          Role::normal, note_size, true);
}

} // namespace rastertrace
