// SPDX-License-Identifier: MIT
#include "space.h"

#include <rastertrace/trace/tell/view.h>

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace rastertrace {

namespace {

bool is_finite(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row]))
                return false;
    return true;
}

} // namespace

ToldCamera::ToldCamera(const glm::dmat4& view, const glm::dmat4& projection,
                       const glm::dmat4& viewport)
    : view_(view), projection_(projection), viewport_(viewport),
      from_clip_(glm::inverse(projection * view)) {}

std::optional<ToldCamera> ToldCamera::of(const glm::dmat4& view, const glm::dmat4& projection,
                                         const glm::dmat4& viewport) {
    const ToldCamera camera(view, projection, viewport);
    const bool has_scales = projection[0][0] != 0 && viewport[0][0] != 0 && viewport[1][1] != 0;
    if (!has_scales || !is_finite(camera.from_clip_) || !is_finite(glm::inverse(view)))
        return std::nullopt;
    return camera;
}

Position ToldCamera::at(Place screen, double z) const {
    const double w = projection_[2][3] * z + projection_[3][3];
    const double x = (screen.x - viewport_[3][0]) / viewport_[0][0];
    const double y = (screen.y - viewport_[3][1]) / viewport_[1][1];
    const glm::dvec4 clip{x * w, y * w, projection_[2][2] * z + projection_[3][2], w};
    const glm::dvec4 world = from_clip_ * clip;
    return Position(world) / world.w;
}

std::optional<Position> ToldCamera::from_clip(const glm::dvec4& clip) const {
    const glm::dvec4 world = from_clip_ * clip;
    if (world.w == 0)
        return std::nullopt;
    return Position(world) / world.w;
}

double ToldCamera::depth_of(const Position& position) const {
    return (view_ * glm::dvec4(position, 1)).z;
}

std::optional<Position> ToldCamera::eye() const {
    if (!is_perspective())
        return std::nullopt;
    return at({}, -projection_[3][3] / projection_[2][3]);
}

double ToldCamera::plane_z() const {
    // x' = m00 x / (m32 z + m33): there, the divisor is m00.
    return (projection_[0][0] - projection_[3][3]) / projection_[2][3];
}

bool ToldCamera::canonical_z_grows() const {
    const auto canonical = [this](double z) {
        return (projection_[2][2] * z + projection_[3][2]) /
               (projection_[2][3] * z + projection_[3][3]);
    };
    return canonical(2 * forward()) > canonical(forward());
}

double ToldCamera::forward() const {
    return is_perspective() && projection_[2][3] > 0 ? 1 : -1;
}

std::optional<double> ToldCamera::near_z() const {
    const double a = projection_[2][2];
    const double b = projection_[3][2];
    if (!is_perspective())
        return b == 0 && std::abs(a) == 1 ? std::nullopt : std::optional((-1 - b) / a);
    // z_clip = -w, in a frustum: a z + b = z, of one that looks along -z.
    return projection_[2][3] == -1 && a != 1 && b < 0 ? std::optional(b / (1 - a)) : std::nullopt;
}

std::optional<double> ToldCamera::far_z() const {
    const double a = projection_[2][2];
    const double b = projection_[3][2];
    if (!near_z() || a == -1)
        return std::nullopt; // infinitely far
    return is_perspective() ? -b / (a + 1) : (1 - b) / a;
}

glm::dmat4 ToldCamera::to_world() const {
    return glm::inverse(view_);
}

std::vector<Position> SpatialScene::places_of(const std::vector<std::string>& names) const {
    std::vector<Position> places;
    for (const std::string& name : names)
        places.push_back(vertices.at(name));
    return places;
}

Position SpatialScene::middle_of(const SpatialPrimitive& primitive) const {
    Position sum{};
    for (const Position& corner : places_of(primitive.corners))
        sum += corner;
    return sum / static_cast<double>(primitive.corners.size());
}

std::optional<Position> position_in(const TracedList<TracedNumber>& list) {
    const auto numbers = list.values();
    if (numbers.size() < 3)
        return std::nullopt;
    Position position{};
    for (int i = 0; i < 3; ++i) {
        const auto number = numbers[static_cast<std::size_t>(i)].nearest_double();
        if (!number)
            return std::nullopt;
        position[i] = *number;
    }
    return position;
}

std::string tuple_of(const TracedList<TracedNumber>& list) {
    std::string text;
    for (const TracedNumber& number : list.values())
        text += (text.empty() ? "(" : ", ") + short_number(number.text());
    return text + ")";
}

std::optional<glm::dmat4> matrix_in(const MatrixStep& step) {
    const auto rows = step.rows.values();
    if (rows.size() != 4)
        return std::nullopt;
    glm::dmat4 matrix{};
    for (int row = 0; row < 4; ++row) {
        const auto numbers = rows[static_cast<std::size_t>(row)].values();
        if (numbers.size() != 4)
            return std::nullopt;
        for (int column = 0; column < 4; ++column) {
            const auto number = numbers[static_cast<std::size_t>(column)].nearest_double();
            if (!number)
                return std::nullopt;
            matrix[column][row] = *number;
        }
    }
    return matrix;
}

namespace {

/// Collects a scene step by step.
class SpaceReader {
public:
    explicit SpaceReader(const Trace& trace) : trace_(trace) {}

    void read(std::size_t n) {
        const auto kind = trace_.kind_of(n);
        const StepView step = trace_.step(n);
        if (kind == StepKind::matrix)
            read(step.as<MatrixStep>());
        else if (kind == StepKind::vertex)
            read(step.as<VertexStep>());
        else if (kind == StepKind::primitive)
            read(n, step.as<PrimitiveStep>());
        else if (kind == StepKind::face)
            read(n, step.as<FaceStep>());
        else if (kind == StepKind::light)
            read(n, step.as<LightStep>());
    }

    std::optional<SpatialScene> scene() {
        for (const auto& [name, clip] : cut_)
            if (space_.camera && !space_.vertices.contains(name))
                if (const auto position = space_.camera->from_clip(clip))
                    space_.vertices[name] = *position;
        if (space_.vertices.empty())
            return std::nullopt;
        if (space_.camera)
            space_.handedness = -space_.camera->forward();
        std::map<std::string, std::size_t> by_name;
        for (SpatialPrimitive& primitive : primitives_) {
            const bool has_places = std::all_of(
                primitive.corners.begin(), primitive.corners.end(),
                [this](const auto& corner) { return space_.vertices.contains(corner); });
            if (!has_places || primitive.corners.empty())
                continue;
            primitive.is_culled = culled_.contains(primitive.name);
            by_name.emplace(primitive.name, space_.primitives.size());
            space_.primitives.push_back(std::move(primitive));
        }
        for (auto& [name, test] : faces_)
            if (const auto found = by_name.find(name); found != by_name.end()) {
                test.primitive = found->second;
                space_.faces.push_back(test);
            }
        return std::move(space_);
    }

private:
    void read(const MatrixStep& step) {
        const auto matrix = matrix_in(step);
        if (step.name == "view")
            view_ = matrix;
        else if (step.name == "projection")
            projection_ = matrix;
        else if (step.name == "viewport" && projection_ && matrix)
            space_.camera = ToldCamera::of(view_.value_or(glm::dmat4(1)), *projection_, *matrix);
    }

    void read(const VertexStep& step) {
        // Object space comes first, then the world, if anything moves there.
        if (step.space == Space::object || step.space == Space::world) {
            if (const auto position = position_in(step.at))
                space_.vertices[step.name.text()] = *position;
        } else if (step.space == Space::clip) {
            const auto at = step.at.values();
            const auto w = at.size() == 4 ? at[3].nearest_double() : std::nullopt;
            if (const auto position = position_in(step.at); position && w)
                cut_[step.name.text()] = glm::dvec4(*position, *w);
        } else if (step.space == Space::screen) {
            const auto at = step.at.values();
            const auto x = at.size() < 2 ? std::nullopt : at[0].nearest_double();
            const auto y = at.size() < 2 ? std::nullopt : at[1].nearest_double();
            if (x && y)
                space_.images[step.name.text()] = {*x, *y};
        }
    }

    void read(std::size_t n, const PrimitiveStep& step) {
        primitives_.push_back(
            {.step = n,
             .name = step.name.text(),
             .face = step.face.text(),
             .corners = step.vertices.texts(),
             .is_closed = !(step.kind == PrimitiveKind::line || step.kind == PrimitiveKind::point),
             .is_filled = is_filled(step.kind),
             .is_part = step.part.is_true()});
    }

    void read(std::size_t n, const FaceStep& step) {
        if (step.culled.is_true())
            culled_.insert(step.name.text());
        if (const auto normal = position_in(step.normal))
            faces_.emplace_back(step.name.text(), FaceTest{.step = n,
                                                           .primitive = 0,
                                                           .normal = *normal,
                                                           .other = position_in(step.view),
                                                           .is_light = step.by == "light",
                                                           .cosine = step.cosine.nearest_double(),
                                                           .is_culled = step.culled.is_true()});
    }

    void read(std::size_t n, const LightStep& step) {
        const auto normal = position_in(step.normal);
        const auto light = position_in(step.light);
        if (!normal || !light)
            return;
        const double lengths = glm::length(*normal) * glm::length(*light);
        const auto dot = step.dot.nearest_double();
        faces_.emplace_back(
            step.name.text(),
            FaceTest{.step = n,
                     .primitive = 0,
                     .normal = *normal,
                     .other = light,
                     .is_light = true,
                     .cosine = dot && lengths > 0 ? std::optional(*dot / lengths) : std::nullopt,
                     .is_culled = false});
    }

    const Trace& trace_;
    SpatialScene space_;
    std::optional<glm::dmat4> view_, projection_;
    std::map<std::string, glm::dvec4> cut_; ///< vertices in clip space
    std::vector<SpatialPrimitive> primitives_;
    std::vector<std::pair<std::string, FaceTest>> faces_;
    std::set<std::string> culled_;
};

} // namespace

std::optional<SpatialScene> space_of(const Trace& trace) {
    SpaceReader reader(trace);
    for (std::size_t n = 1; n <= trace.size(); ++n)
        reader.read(n);
    return reader.scene();
}

} // namespace rastertrace
