// SPDX-License-Identifier: MIT
#include "scene_panel.h"

#include "label_places.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace rastertrace {

namespace {

using Row = std::array<double, 4>;
using Rows = std::array<Row, 4>;

std::optional<Position> position_in(const TracedList<TracedNumber>& list) {
    const auto numbers = list.values();
    if (numbers.size() < 3)
        return std::nullopt;
    Position position{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto number = numbers[i].nearest_double();
        if (!number || !std::isfinite(*number))
            return std::nullopt;
        position[i] = *number;
    }
    return position;
}

std::optional<Rows> rows_in(const MatrixStep& matrix) {
    const auto lists = matrix.rows.values();
    Rows rows{};
    if (lists.size() != 4)
        return std::nullopt;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto numbers = lists[i].values();
        for (std::size_t j = 0; j < 4; ++j) {
            const auto number = numbers.size() == 4 ? numbers[j].nearest_double() : std::nullopt;
            if (!number)
                return std::nullopt;
            rows[i][j] = *number;
        }
    }
    return rows;
}

Position sum(const Position& a, const Position& b, double share = 1) {
    return {a[0] + share * b[0], a[1] + share * b[1], a[2] + share * b[2]};
}

double length_of(const Position& vector) {
    return std::sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
}

/// From camera space to the world: the view is a rotation R and a translation t, so x = R^T (c - t).
Position from_camera(const Rows& view, const Position& camera) {
    Position world{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t row = 0; row < 3; ++row)
            world[i] += view[row][i] * (camera[row] - view[row][3]);
    return world;
}

/// The eye, and the canvas on the plane where a point of the scene is on the screen as it is in camera space.
std::optional<Viewer> viewer_of(const Canvas& canvas, const std::optional<Rows>& view,
                                const std::optional<Rows>& projection,
                                const std::optional<Rows>& viewport) {
    if (!projection || !viewport)
        return std::nullopt;
    // x' = m00 x / (m32 z + m33): on the plane, the divisor is m00. Without m32 nothing gets smaller far away.
    const double m32 = (*projection)[3][2];
    if (m32 == 0 || (*viewport)[0][0] == 0 || (*viewport)[1][1] == 0)
        return std::nullopt;
    const double z = ((*projection)[0][0] - (*projection)[3][3]) / m32;
    const double eye_z = -(*projection)[3][3] / m32; // where the divisor is 0
    const auto to_world = [&](const Position& camera) {
        return view ? from_camera(*view, camera) : camera;
    };
    const double left = canvas.left() - 0.5;
    const double top = canvas.top() - 0.5 * canvas.down();
    const double right = left + canvas.width;
    const double bottom = top + canvas.down() * canvas.height;
    const auto on_plane = [&](double x, double y) {
        return to_world({(x - (*viewport)[0][3]) / (*viewport)[0][0],
                         (y - (*viewport)[1][3]) / (*viewport)[1][1], z});
    };
    return Viewer{.eye = to_world({0, 0, eye_z}),
                  .view_plane = {on_plane(left, top), on_plane(right, top), on_plane(right, bottom),
                                 on_plane(left, bottom)}};
}

/// Each side once, whichever way round.
class Sides {
public:
    void add(const std::vector<std::string>& corners, bool is_closed) {
        const std::size_t count = is_closed ? corners.size() : corners.size() - 1;
        for (std::size_t i = 0; i < count; ++i)
            sides_.insert(std::minmax(corners[i], corners[(i + 1) % corners.size()]));
    }
    bool has(const std::pair<std::string, std::string>& side) const {
        return sides_.contains(side);
    }
    const auto& all() const { return sides_; }

private:
    std::set<std::pair<std::string, std::string>> sides_;
};

/// A place to look from, and what of the picture is where on the sheet.
class SideView {
public:
    /// From the front right, and a little from above, whatever is up in the scene: y, as in all of the texts.
    Place flat(const Position& p) const {
        // The sine and cosine of 35 degrees around y, and of 20 degrees of height, by four digits.
        constexpr double sin_turn = 0.5736;
        constexpr double cos_turn = 0.8192;
        constexpr double sin_height = 0.3420;
        constexpr double cos_height = 0.9397;
        const double x = cos_turn * p[0] + sin_turn * p[2];
        const double away = -sin_turn * p[0] + cos_turn * p[2];
        return {x, -(cos_height * p[1] + sin_height * away)};
    }

    void include(const Position& p) {
        const Place place = flat(p);
        if (is_first_) {
            least_ = most_ = place;
            is_first_ = false;
        }
        least_ = {std::min(least_.x, place.x), std::min(least_.y, place.y)};
        most_ = {std::max(most_.x, place.x), std::max(most_.y, place.y)};
    }

    /// Once all is included: fits it into a rectangle.
    void fit(const Rectangle& room) {
        const double width = std::max(most_.x - least_.x, 1e-300);
        const double height = std::max(most_.y - least_.y, 1e-300);
        scale_ = std::min(room.width / width, room.height / height);
        origin_ = {room.corner.x + (room.width - scale_ * width) / 2,
                   room.corner.y + (room.height - scale_ * height) / 2};
    }

    Place at(const Position& p) const {
        const Place place = flat(p);
        return {origin_.x + scale_ * (place.x - least_.x),
                origin_.y + scale_ * (place.y - least_.y)};
    }

private:
    bool is_first_ = true;
    Place least_;
    Place most_;
    Place origin_;
    double scale_ = 1;
};

/// How long normals are drawn: a part of the whole.
double length_of_normals(const SpatialScene& space) {
    Position least{};
    Position most{};
    bool is_first = true;
    for (const auto& [name, at] : space.vertices) {
        for (std::size_t i = 0; i < 3; ++i) {
            least[i] = is_first ? at[i] : std::min(least[i], at[i]);
            most[i] = is_first ? at[i] : std::max(most[i], at[i]);
        }
        is_first = false;
    }
    constexpr double part = 0.25;
    return part * length_of(sum(most, least, -1));
}

/// A label, which other words keep away from.
void add_words(Label label, Obstacles& obstacles, std::vector<Shape>& shapes) {
    const double width = width_of(label.text, label.size, label.is_bold);
    const double left = label.at.x - (label.anchor == Anchor::end      ? width
                                      : label.anchor == Anchor::middle ? width / 2
                                                                       : 0);
    const double top = label.at.y - 0.85 * label.size;
    obstacles.words.push_back({{left, top}, width, label.size});
    shapes.push_back(std::move(label));
}

/// The names of vertices, each away from the middle of all and from other words; those without room are left out.
void add_names(const SpatialScene& space, const SideView& side, double size, Obstacles& obstacles,
               std::vector<Shape>& shapes) {
    Place sum;
    for (const auto& [name, at] : space.vertices) {
        const Place place = side.at(at);
        sum = {sum.x + place.x, sum.y + place.y};
    }
    const auto count = static_cast<double>(space.vertices.size());
    const Place middle{sum.x / count, sum.y / count};
    for (const auto& [name, at] : space.vertices) {
        const Place place = side.at(at);
        const std::string words = printable(name);
        const auto box = words_beside({place, middle, words, size}, obstacles);
        if (!box)
            continue;
        obstacles.words.push_back(*box);
        shapes.push_back(strong_label_in(*box, {place, middle, words, size}));
    }
}

/// More normals than this are a hedgehog, and of more than a few nobody reads the angles.
constexpr std::size_t most_normals = 30;
constexpr std::size_t most_angles = 4;

/// The normals; and of a few faces the line of sight, and the angle between both, whose words become obstacles.
template <typename TipOf>
void add_normals(const SpatialScene& space, const SideView& side, const TipOf& tip_of,
                 Obstacles& obstacles, std::vector<Shape>& shapes) {
    constexpr double head = 6;
    constexpr double text_size = 9;
    const bool has_angles = space.faces.size() <= most_angles;
    for (const FaceTest& face : space.faces) {
        const Place tip = side.at(tip_of(face));
        if (has_angles && face.view)
            shapes.push_back(
                Lines{.role = Role::axis,
                      .paths = {{side.at(face.middle), side.at(sum(face.middle, *face.view))}}});
        add_arrow(side.at(face.middle), tip, Role::normal, head, shapes);
        if (!has_angles || !face.cosine)
            continue;
        constexpr double degrees = 180 / std::numbers::pi;
        const std::string angle =
            fmt::format("{:.1f}\u00b0", std::acos(std::clamp(*face.cosine, -1.0, 1.0)) * degrees);
        // At the right of the tip; or where that is cut off, at its left, above or below the arrow.
        constexpr double away = 4;
        const bool is_below = side.at(face.middle).y < tip.y;
        const Place at_left{tip.x, tip.y + (is_below ? away + text_size : -2 * away)};
        const bool fits =
            tip.x + away + width_of(angle, text_size, true) <= obstacles.sheet.right();
        add_words({.role = Role::normal,
                   .at = fits ? Place{tip.x + away, tip.y - 3} : at_left,
                   .text = angle,
                   .size = text_size,
                   .anchor = fits ? Anchor::start : Anchor::end,
                   .is_bold = true,
                   .has_rim = true},
                  obstacles, shapes);
    }
}

} // namespace

std::optional<SpatialScene> space_of(const Trace& trace) {
    SpatialScene space;
    std::optional<Rows> view, projection, viewport;
    struct Face {
        std::string name;
        FaceTest test;
    };
    std::vector<Face> faces;
    std::set<std::string> culled;
    std::map<std::string, std::vector<std::string>> corners_of;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const auto kind = trace.kind_of(n);
        const StepView step = trace.step(n);
        if (kind == StepKind::matrix) {
            const auto matrix = step.as<MatrixStep>();
            if (matrix.name == "view")
                view = rows_in(matrix);
            else if (matrix.name == "projection")
                projection = rows_in(matrix);
            else if (matrix.name == "viewport")
                viewport = rows_in(matrix);
        } else if (kind == StepKind::vertex) {
            // Object space comes first, then the world, if anything moves there.
            const auto vertex = step.as<VertexStep>();
            if (vertex.space == Space::object || vertex.space == Space::world)
                if (const auto position = position_in(vertex.at))
                    space.vertices[vertex.name.text()] = *position;
        } else if (kind == StepKind::primitive) {
            const auto primitive = step.as<PrimitiveStep>();
            corners_of[primitive.name.text()] = primitive.vertices.texts();
        } else if (kind == StepKind::face) {
            const auto face = step.as<FaceStep>();
            if (const auto normal = position_in(face.normal))
                faces.push_back({face.name.text(),
                                 {.middle = {},
                                  .normal = *normal,
                                  .view = position_in(face.view),
                                  .cosine = face.cosine.nearest_double()}});
            if (face.culled.is_true())
                culled.insert(face.name.text());
        }
    }
    if (space.vertices.empty())
        return std::nullopt;

    // What is cut has vertices that are nowhere in space: the whole primitive has been told before.
    std::erase_if(corners_of, [&space](const auto& primitive) {
        return primitive.second.size() < 2 ||
               std::any_of(primitive.second.begin(), primitive.second.end(),
                           [&](const auto& name) { return !space.vertices.contains(name); });
    });
    Sides seen, hidden;
    for (const auto& [name, corners] : corners_of)
        (culled.contains(name) ? hidden : seen).add(corners, corners.size() > 2);
    for (Face& face : faces) {
        const auto found = corners_of.find(face.name);
        if (found == corners_of.end())
            continue;
        for (const std::string& corner : found->second)
            face.test.middle = sum(face.test.middle, space.vertices.at(corner),
                                   1.0 / static_cast<double>(found->second.size()));
        space.faces.push_back(face.test);
    }
    space.seen.assign(seen.all().begin(), seen.all().end());
    for (const auto& side : hidden.all())
        if (!seen.has(side))
            space.culled.push_back(side);
    space.viewer = viewer_of(trace.canvas, view, projection, viewport);
    return space;
}

Drawing scene_drawing(const SpatialScene& space, double width, double height) {
    constexpr double text_size = 10;
    constexpr std::size_t most_names = 24;
    double margin = 18; // for names
    if (space.vertices.size() <= most_names)
        for (const auto& [name, at] : space.vertices)
            margin = std::max(margin, width_of(printable(name), text_size) + 6);
    margin = std::min(margin, width / 4);
    Drawing drawing{.width = width, .height = height, .title = "The scene in space"};
    std::vector<Shape>& shapes = drawing.shapes;

    SideView side;
    for (const auto& [name, at] : space.vertices)
        side.include(at);
    if (space.viewer) {
        side.include(space.viewer->eye);
        for (const Position& corner : space.viewer->view_plane)
            side.include(corner);
    }
    const bool has_normals = space.faces.size() <= most_normals;
    const double normal_length = length_of_normals(space);
    const auto tip_of = [normal_length](const FaceTest& face) {
        const double length = length_of(face.normal);
        return sum(face.middle, face.normal, length > 0 ? normal_length / length : 0);
    };
    if (has_normals)
        for (const FaceTest& face : space.faces)
            side.include(tip_of(face));
    side.fit({{margin, margin}, width - 2 * margin, height - 2 * margin});

    const Rectangle sheet{{}, width, height};
    Obstacles obstacles{.sheet = sheet, .frame = sheet};
    const auto lines_of = [&](const auto& sides, Role role) {
        Lines lines{.role = role};
        for (const auto& [a, b] : sides)
            lines.paths.push_back({side.at(space.vertices.at(a)), side.at(space.vertices.at(b))});
        obstacles.sides.insert(obstacles.sides.end(), lines.paths.begin(), lines.paths.end());
        shapes.push_back(std::move(lines));
    };
    lines_of(space.culled, Role::other_edge);
    lines_of(space.seen, Role::true_edge);

    // The view plane, the lines of sight through its corners, and the eye where they meet.
    if (space.viewer) {
        const Place eye = side.at(space.viewer->eye);
        Path plane;
        Lines sight{.role = Role::other_edge};
        for (const Position& corner : space.viewer->view_plane) {
            plane.push_back(side.at(corner));
            sight.paths.push_back({eye, plane.back()});
        }
        shapes.push_back(std::move(sight));
        shapes.push_back(Polygons{.role = Role::inside, .paths = {plane}});
        shapes.push_back(Lines{.role = Role::view_plane, .paths = {plane}, .are_closed = true});
        constexpr double radius = 4;
        shapes.push_back(Dots{.role = Role::eye, .radius = radius, .centers = {eye}});
        obstacles.words.push_back(box_around(eye, radius));
        add_words({.role = Role::eye,
                   .at = {eye.x, eye.y + text_size + radius},
                   .text = "eye",
                   .size = text_size,
                   .anchor = Anchor::middle,
                   .has_rim = true},
                  obstacles, shapes);
    }
    if (has_normals)
        add_normals(space, side, tip_of, obstacles, shapes);
    if (space.vertices.size() <= most_names)
        add_names(space, side, text_size, obstacles, shapes);
    return drawing;
}

} // namespace rastertrace
