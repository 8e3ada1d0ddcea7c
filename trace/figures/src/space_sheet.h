// SPDX-License-Identifier: MIT
#pragma once

// The sheet of a picture in space: where a place of the world is on it, what is drawn there, and where words have room.

#include "label_places.h"
#include "space.h"

#include <rastertrace/figures/space_eye.h>
#include <rastertrace/trace/record/replay.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

/// More normals than that are a hedgehog.
inline constexpr std::size_t most_normals_in_space = 30;

/// A box in the world, its sides along the axes.
class Bounds {
public:
    void include(const Position& position);
    bool has(const Position& position) const;
    Position middle() const { return (least_ + most_) / 2.0; }
    double diagonal() const;

    /// With a margin on all sides, a part of the diagonal.
    Bounds grown(double part) const;

    /// What the box has of a plane: a polygon, or nothing.
    std::vector<Position> section(const Position& point, const Position& normal) const;

private:
    bool is_empty_ = true;
    Position least_{};
    Position most_{};
};

class SpaceSheet {
public:
    /// The space must outlive the sheet.
    SpaceSheet(const SpatialScene& space, const Trace& trace, const SpaceEye& eye, double width,
               double height);

    const SpatialScene& space() const { return space_; }
    const Trace& trace() const { return trace_; }

    /// Of the vertices.
    const Bounds& vertices() const { return vertices_; }
    /// Of the vertices, the eye and the view plane.
    const Bounds& all() const { return all_; }
    double size() const { return vertices_.diagonal(); }

    /// z in camera space of the plane that the picture is shown on. There must be a camera.
    double plane_z() const { return plane_z_; }
    /// The same of the sides of what is in view: where they go on for ever, they end soon.
    double sides_z() const { return sides_z_; }
    bool shows_far_plane() const { return shows_far_plane_; }

    /// Where a line of sight begins: in the eye, or on the plane if all are parallel; and where it ends.
    std::pair<Position, Position> sight_at(Place screen) const;

    /// The corners of pixels at z of camera space, in a circle from the upper left: of the whole canvas, or of one.
    std::vector<Position> window_at(double z) const;
    std::vector<Position> pixel_at(Pixel pixel, double z) const;

    /// From the middle of a face, as long as all normals.
    Position tip_of(const FaceTest& face, const Position& direction) const;

    /// How far from the scene's middle a light is drawn, and toward where.
    std::optional<std::pair<Position, Position>> light() const;

    Place at(const Position& position) const;

    void line(const Position& from, const Position& to, Role role);
    void polygon(const std::vector<Position>& corners, Role fill, Role border);
    void outline(const std::vector<Position>& corners, Role role);
    void arrow(const Position& from, const Position& to, Role role);
    void dot(const Position& at, Role role, double radius);

    /// Words beside a place, away from `inside`, where they have room; else none.
    void words(const Position& mark, const Position& inside, std::string_view text, Role role,
               double size = 10, bool is_bold = false);

    /// x, y, z from an origin, each as long as the sheet's axes.
    void axes(const glm::dmat4& basis, Role role);

    /// An arc from one direction to another around a place, with the angle between them.
    void angle(const Position& around, const Position& from, const Position& to, double cosine);

    std::vector<Shape> shapes;

private:
    Place flat(const Position& position) const;
    Path path_of(const std::vector<Position>& corners) const;
    void add_outline(Path path, Role role);

    const SpatialScene& space_;
    const Trace& trace_;
    double middle_ = 0; ///< of a pixel, from its integer point
    Position right_{};
    Position up_{};
    Bounds vertices_;
    Bounds all_;
    double plane_z_ = 0;
    double end_z_ = 0;
    double sides_z_ = 0;
    bool shows_far_plane_ = false;
    Place origin_; ///< of the sheet, of what is at (0, 0) when it is flat
    double scale_ = 1;
    Obstacles obstacles_;
};

/// What a picture in space has of everything, with pale or with strong edges.
enum class SpaceWeight : std::uint8_t { pale, strong };
void add_space(SpaceWeight weight, SpaceSheet& sheet);

/// What the current step of a replay is about.
void add_step_in_space(const Replay& replay, SpaceSheet& sheet);

} // namespace rastertrace
