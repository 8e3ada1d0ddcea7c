// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/list/geometry.h>
#include <rastertrace/core/numbers/adaptive.h>

#include "tell/listener_sink.h"

#include <rastertrace/core/draw/scene/camera.h>
#include <rastertrace/core/draw/scene/model.h>
#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/core/raster/rounding.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace rastertrace {

/// True if a matrix of the scene has irrational entries, which are the nearest doubles instead.
bool has_rounded_matrix(const Scene& scene) {
    return (scene.camera && is_rounded(*scene.camera)) || is_rounded(scene.projection) ||
           std::any_of(scene.objects.begin(), scene.objects.end(), [](const SceneObject& object) {
               const auto& steps = object.model.steps();
               return std::any_of(steps.begin(), steps.end(),
                                  [](const ModelStep& step) { return is_rounded(step); });
           });
}

template <typename Scalar> Transforms<Scalar> transforms_of(const Scene& scene) {
    Transforms<Scalar> result;

    // A matrix that moves something, or that the scene keeps although it does not.
    const auto matrix_of = [&](Stage stage,
                               const Matrix<Rational>& exact) -> std::optional<Matrix<Scalar>> {
        if (exact != identity<Rational>())
            result.needed.add(stage);
        else if (!scene.keep.has(stage))
            return std::nullopt;
        return rounded<Scalar>(exact);
    };
    for (const SceneObject& object : scene.objects)
        result.models.push_back(matrix_of(Stage::model, object.model.matrix()));
    result.rest_model = matrix_of(Stage::model, identity<Rational>());
    result.view = matrix_of(
        Stage::view, scene.camera ? view_matrix(*scene.camera, view_axis_of(scene.projection.type))
                                  : identity<Rational>());
    if (scene.projection.type != ProjectionType::none)
        result.projection = rounded<Scalar>(projection_matrix(scene.projection, scene.canvas));
    if (scene.viewport.type != ViewportType::none)
        result.viewport = rounded<Scalar>(viewport_matrix(scene.viewport, scene.canvas));

    // A plane near the eye must not be rounded into it.
    const auto nearest = [](const Rational& exact) {
        const Scalar rounded_one = nearest_scalar<Scalar>(exact);
        if constexpr (std::floating_point<Scalar>)
            if (rounded_one == 0 && exact != 0)
                return std::copysign(std::numeric_limits<Scalar>::min(),
                                     static_cast<Scalar>(sgn(exact)));
        return rounded_one;
    };
    for (const ClipPlane<Rational>& plane :
         clip_planes(scene.projection, half_extent(scene.viewport, scene.canvas.width),
                     half_extent(scene.viewport, scene.canvas.height), guard_band))
        result.planes.push_back({plane.name,
                                 {nearest(plane.factors.x), nearest(plane.factors.y),
                                  nearest(plane.factors.z), nearest(plane.factors.w)},
                                 nearest(plane.constant)});
    result.snap = scene.method.snap;
    result.ties = scene.method.ties.value_or(Ties::up);
    return result;
}

/// `matrix` times `vector`, or `vector` itself if there is no matrix.
template <typename Scalar>
Vec<Scalar, 4> moved(const std::optional<Matrix<Scalar>>& matrix, const Vec<Scalar, 4>& vector) {
    return matrix ? *matrix * vector : vector;
}

/// The first spaces of a vertex, in homogeneous coordinates.
template <typename Scalar> struct VertexPositions {
    Vec<Scalar, 4> object;
    Vec<Scalar, 4> world;
    Vec<Scalar, 4> camera;
    Vec<Scalar, 4> clip;
};

template <typename Scalar>
VertexPositions<Scalar> positions_of(const SceneVertex& vertex,
                                     const std::optional<Matrix<Scalar>>& model,
                                     const Transforms<Scalar>& transforms) {
    VertexPositions<Scalar> positions;
    positions.object = {scalar_from<Scalar>(vertex.x), scalar_from<Scalar>(vertex.y),
                        scalar_from<Scalar>(vertex.z), scalar_from<Scalar>(1)};
    positions.world = moved(model, positions.object);
    positions.camera = moved(transforms.view, positions.world);
    positions.clip = moved(transforms.projection, positions.camera);
    return positions;
}

/// x/w, y/w and z/w, moved to the screen. w must not be 0.
template <typename Scalar>
ScreenPositions<Scalar> positions_on_screen(const Vec<Scalar, 4>& clip,
                                            const Transforms<Scalar>& transforms) {
    const Vec<Scalar, 4> canonical =
        transforms.divides ? Vec<Scalar, 4>{Scalar(clip.x / clip.w), Scalar(clip.y / clip.w),
                                            Scalar(clip.z / clip.w), scalar_from<Scalar>(1)}
                           : clip;
    const Vec<Scalar, 4> screen = moved(transforms.viewport, canonical);
    require_finite(screen.x);
    require_finite(screen.y);
    const auto snapped = [&transforms](const Scalar& x) {
        if constexpr (std::floating_point<Scalar>)
            if (!std::isfinite(x))
                return x; // find_unfit will say so
        switch (transforms.snap) {
        case Snap::floor:
            return scalar_from<Scalar>(floor_index(x));
        case Snap::truncate:
            return scalar_from<Scalar>(truncate_index(x));
        case Snap::nearest:
            return scalar_from<Scalar>(nearest_index(x, transforms.ties));
        case Snap::none:
            break;
        }
        return x;
    };
    return {.canonical = canonical,
            .screen = {screen.x, screen.y},
            .pixel = {snapped(screen.x), snapped(screen.y)}};
}

/// Which of the scene's vertices a primitive has.
std::vector<bool> used_vertices(const Scene& scene) {
    std::vector<bool> is_used(scene.vertices.size());
    for (const ScenePrimitive& primitive : scene.primitives)
        for (const std::size_t index : primitive.corners())
            is_used[index] = true;
    return is_used;
}

namespace {

/// Places as whole numbers over one denominator: fractions would be reduced in each of their sums.
struct WholePlaces {
    std::vector<std::array<mpz_class, 3>> above;
    mpz_class below = 1;
};

/// The vertices first .. end - 1 that are used, moved by a matrix.
WholePlaces whole_places(const Scene& scene, const std::vector<bool>& is_used, std::size_t first,
                         std::size_t end, const Matrix<Rational>& matrix) {
    WholePlaces places;
    std::vector<std::array<Rational, 3>> typed;
    mpz_class below_typed = 1;
    for (std::size_t i = first; i < end; ++i) {
        if (!is_used[i])
            continue;
        const SceneVertex& vertex = scene.vertices[i];
        typed.push_back({vertex.x.exact(), vertex.y.exact(), vertex.z.exact()});
        for (const Rational& coordinate : typed.back())
            below_typed = lcm(below_typed, coordinate.get_den());
    }
    mpz_class below_matrix = 1;
    for (const auto& row : matrix.rows)
        for (const Rational& entry : row)
            below_matrix = lcm(below_matrix, entry.get_den());
    const auto whole = [](const Rational& value, const mpz_class& below) {
        return mpz_class(value.get_num() * (below / value.get_den()));
    };

    std::array<std::array<mpz_class, 4>, 3> rows;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            rows[i][j] = whole(matrix.rows[i][j], below_matrix);
    places.below = below_matrix * below_typed;
    for (const auto& [x, y, z] : typed) {
        const mpz_class whole_x = whole(x, below_typed);
        const mpz_class whole_y = whole(y, below_typed);
        const mpz_class whole_z = whole(z, below_typed);
        auto& place = places.above.emplace_back();
        for (std::size_t i = 0; i < 3; ++i)
            place[i] = rows[i][0] * whole_x + rows[i][1] * whole_y + rows[i][2] * whole_z +
                       rows[i][3] * below_typed;
    }
    return places;
}

/// Calls `visit` with the places in the world, from `origin`, of each object that has any.
template <typename Visit>
void for_each_object(const Scene& scene, const Vec<Rational, 3>& origin, Visit&& visit) {
    const std::vector<bool> is_used = used_vertices(scene);
    const auto from_origin = translation<Rational>(Vec<Rational, 3>{} - origin);
    std::size_t first = 0;
    const auto visit_next = [&](std::size_t end, const Matrix<Rational>& model) {
        const WholePlaces places = whole_places(scene, is_used, first, end, from_origin * model);
        if (!places.above.empty())
            visit(places);
        first = end;
    };
    for (const SceneObject& object : scene.objects)
        visit_next(object.end_vertex, object.model.matrix());
    visit_next(scene.vertices.size(), identity<Rational>());
}

} // namespace

Box world_box(const Scene& scene) {
    std::optional<Box> box;
    for_each_object(scene, {}, [&box](const WholePlaces& places) {
        std::array<mpz_class, 3> low = places.above.front();
        std::array<mpz_class, 3> high = low;
        for (const auto& place : places.above)
            for (std::size_t i = 0; i < 3; ++i) {
                low[i] = std::min(low[i], place[i]);
                high[i] = std::max(high[i], place[i]);
            }
        for (const auto& corner : {low, high})
            include(box,
                    {quotient_of(corner[0], places.below), quotient_of(corner[1], places.below),
                     quotient_of(corner[2], places.below)});
    });
    return *box;
}

Rational farthest_square(const Scene& scene, const Vec<Rational, 3>& center) {
    Rational farthest = 0;
    for_each_object(scene, center, [&farthest](const WholePlaces& places) {
        mpz_class square = 0;
        for (const auto& [x, y, z] : places.above)
            square = std::max<mpz_class>(square, x * x + y * y + z * z);
        farthest = std::max(farthest, quotient_of(square, mpz_class(places.below * places.below)));
    });
    return farthest;
}

/// Calls `visit(index, model)` with each vertex that is used, and the matrix of its object.
template <typename Scalar, typename Visit>
void for_each_used_vertex(const Scene& scene, const Transforms<Scalar>& transforms,
                          const std::vector<bool>& is_used, Visit&& visit) {
    std::size_t object = 0;
    for (std::size_t i = 0; i < scene.vertices.size(); ++i) {
        while (object < scene.objects.size() && i >= scene.objects[object].end_vertex)
            ++object;
        if (is_used[i])
            visit(i, object < scene.objects.size() ? transforms.models[object]
                                                   : transforms.rest_model);
    }
}

/// The matrix of the object that a vertex belongs to.
template <typename Scalar>
const std::optional<Matrix<Scalar>>&
model_of(const Scene& scene, const Transforms<Scalar>& transforms, std::size_t index) {
    const auto object =
        std::upper_bound(scene.objects.begin(), scene.objects.end(), index,
                         [](std::size_t i, const SceneObject& one) { return i < one.end_vertex; });
    return object == scene.objects.end()
               ? transforms.rest_model
               : transforms.models[static_cast<std::size_t>(object - scene.objects.begin())];
}

/// How far a place in camera space lies in front of the eye. Without a camera and a projection, z as
/// typed is the distance.
template <typename Scalar>
Scalar distance_along_view(const Scene& scene, const Vec<Scalar, 4>& camera) {
    const bool looks_along_plus_z =
        scene.projection.type == ProjectionType::pinhole ||
        (scene.projection.type == ProjectionType::none && !scene.camera);
    return looks_along_plus_z ? camera.z : Scalar(-camera.z);
}

/// The eye in the world: the camera's place, or the origin without one. Where nothing converges, the
/// direction to it, against the view, which is the same for all faces.
template <typename Scalar> Vec<Scalar, 3> eye_of(const Scene& scene) {
    const Vec<Rational, 3> ahead{Rational(0), Rational(0), Rational(1)};
    const Vec<Rational, 3> eye =
        is_perspective(scene.projection.type)
            ? exact(scene.camera ? scene.camera->position : Numbers3{0, 0, 0})
        : scene.camera ? axes_of(*scene.camera).back
                       : ahead;
    return {nearest_scalar<Scalar>(eye.x), nearest_scalar<Scalar>(eye.y),
            nearest_scalar<Scalar>(eye.z)};
}

/// A vertex in clip space is in view if it lies outside of no plane.
template <typename Scalar>
bool is_in_view(const Vec<Scalar, 4>& clip, const Transforms<Scalar>& transforms) {
    return std::all_of(transforms.planes.begin(), transforms.planes.end(),
                       [&clip](const auto& plane) { return plane.has_inside(clip); });
}

/// A vertex in the world and in clip space.
template <typename Scalar>
VertexInSpace<Scalar> vertex_in_space(const Scene& scene, const Transforms<Scalar>& transforms,
                                      const std::optional<Matrix<Scalar>>& model,
                                      std::size_t index) {
    const VertexPositions<Scalar> positions =
        positions_of(scene.vertices[index], model, transforms);
    for (const Scalar* coordinate :
         {&positions.clip.x, &positions.clip.y, &positions.clip.z, &positions.clip.w})
        require_finite(*coordinate);
    return {.world = {positions.world.x, positions.world.y, positions.world.z},
            .in_clip_space = {.clip = positions.clip,
                              .distance = distance_along_view<Scalar>(scene, positions.camera),
                              .is_in_view = is_in_view(positions.clip, transforms)}};
}
template <typename Scalar>
VertexInSpace<Scalar> vertex_in_space(const Scene& scene, const Transforms<Scalar>& transforms,
                                      std::size_t index) {
    return vertex_in_space(scene, transforms, model_of(scene, transforms, index), index);
}

/// Takes a vertex to clip space.
template <typename Scalar>
void move_to_clip_space(const Scene& scene, const std::optional<Matrix<Scalar>>& model,
                        std::size_t index, Geometry<Scalar>& geometry) {
    auto [world, in_clip_space] = vertex_in_space(scene, geometry.list.transforms, model, index);
    geometry.vertices[index] = std::move(in_clip_space);
    if (!geometry.world.empty())
        geometry.world[index] = std::move(world);
}

/// Takes a vertex from there on to the screen, if it can be seen.
template <typename Scalar>
void move_to_screen(const ClipSpaceVertex<Scalar>& vertex, const Transforms<Scalar>& transforms,
                    ScreenVertex<Scalar>& on_screen) {
    if (vertex.is_in_view)
        on_screen.position = positions_on_screen(vertex.clip, transforms).pixel;
}

/// Takes a vertex to clip space, and on to the screen if it can be seen.
template <typename Scalar>
void move_vertex(const Scene& scene, std::size_t index, Geometry<Scalar>& geometry) {
    const auto& transforms = geometry.list.transforms;
    move_to_clip_space(scene, model_of(scene, transforms, index), index, geometry);
    move_to_screen(geometry.vertices[index], transforms, geometry.list.vertices[index]);
}

/// A geometry whose vertices have no place yet. What stays is allocated first, so that what goes leaves no
/// hole behind.
template <typename Scalar> Geometry<Scalar> empty_geometry(const Scene& scene) {
    Geometry<Scalar> result;
    result.list.transforms = transforms_of<Scalar>(scene);
    result.list.mixes_colors = scene.mixes_colors();
    result.list.depth = scene.depth();
    result.list.vertices.resize(scene.vertices.size());
    result.list.is_drawn.resize(scene.vertices.size());
    result.list.primitives.reserve(scene.primitives.size());
    result.vertices.resize(scene.vertices.size());
    result.is_used.resize(scene.vertices.size());
    if (scene.tests_faces()) {
        result.world.resize(scene.vertices.size());
        result.list.transforms.eye = eye_of<Scalar>(scene);
    }
    return result;
}

/// Throws Undecided if a number may be of either sign. Only Adaptive leaves that open.
template <typename Scalar> void require_decided(const Scalar& number) {
    if constexpr (std::same_as<Scalar, Adaptive>)
        static_cast<void>(number < Adaptive(0));
}

/// Takes every vertex that is used to clip space, and on to the screen if it can be seen.
template <typename Scalar> Geometry<Scalar> geometry_of(const Scene& scene) {
    Geometry<Scalar> result = empty_geometry<Scalar>(scene);
    result.is_used = used_vertices(scene);

    // To clip space. A plane that no vertex lies outside of cannot cut anything.
    Transforms<Scalar>& transforms = result.list.transforms;
    std::vector<std::size_t> outside(transforms.planes.size());
    for_each_used_vertex(scene, transforms, result.is_used, [&](std::size_t i, const auto& model) {
        move_to_clip_space(scene, model, i, result);
        const ClipSpaceVertex<Scalar>& vertex = result.vertices[i];
        if (!vertex.is_in_view)
            for (std::size_t plane = 0; plane < transforms.planes.size(); ++plane)
                if (!transforms.planes[plane].has_inside(vertex.clip))
                    ++outside[plane];
        if (vertex.clip.w != scalar_from<Scalar>(1))
            transforms.needed.add(Stage::divide);
    });
    // Behind the eye there is no 1/z: on that hangs whether the scene can be drawn (plan.cpp).
    if (scene.depth() == Depth::inverse_z && !is_perspective(scene.projection.type))
        for_each_used_vertex(scene, transforms, result.is_used, [&](std::size_t i, const auto&) {
            require_decided(result.vertices[i].distance);
        });
    transforms.divides = transforms.needed.has(Stage::divide) || scene.keep.has(Stage::divide);
    for (std::size_t plane = 0; plane < transforms.planes.size(); ++plane)
        result.list.outside.push_back({transforms.planes[plane].name, outside[plane]});
    if (!scene.keep.has(Stage::clip)) {
        std::vector<ClipPlane<Scalar>> crossed;
        for (std::size_t plane = 0; plane < transforms.planes.size(); ++plane)
            if (outside[plane] > 0)
                crossed.push_back(transforms.planes[plane]);
        transforms.planes = std::move(crossed);
    }

    // On to the screen, what can be seen.
    for (std::size_t i = 0; i < result.vertices.size(); ++i)
        move_to_screen(result.vertices[i], transforms, result.list.vertices[i]);

    const DistanceOf<Scalar> distance_of = [&result](std::size_t index) -> const Scalar& {
        return result.vertices[index].distance;
    };
    for (const DrawingOrder<Scalar>& order : drawing_orders<Scalar>)
        if (order.depth == scene.depth()) {
            if (!order.is_sorted(scene, distance_of))
                transforms.needed.add(Stage::order);
            if (transforms.needed.has(Stage::order) || scene.keep.has(Stage::order))
                result.list.order = order.sorted(scene, distance_of);
        }
    return result;
}

/// Tells a place of a vertex: the first `count` coordinates.
template <typename Scalar>
void tell_position(std::string_view name, Space space, const Vec<Scalar, 4>& at, std::size_t count,
                   const Listener& listener) {
    const ListenerSink sink(listener);
    const std::array<Scalar, 4> coordinates{at.x, at.y, at.z, at.w};
    sink(VertexPlaced<Scalar>{
        .name = name, .space = space, .at = std::span(coordinates).first(count), .snapped = {}});
}

/// Tells the spaces of a vertex from clip space on.
template <typename Scalar>
void tell_positions_on_screen(std::string_view name, const Vec<Scalar, 4>& clip,
                              const Transforms<Scalar>& transforms, const Listener& listener) {
    const ListenerSink sink(listener);
    const ScreenPositions<Scalar> positions = positions_on_screen(clip, transforms);
    if (transforms.projection && transforms.divides)
        tell_position<Scalar>(name, Space::canonical, positions.canonical, 3, listener);
    const std::array<Scalar, 2> screen{positions.screen.x, positions.screen.y};
    const std::array<Scalar, 2> pixel{positions.pixel.x, positions.pixel.y};
    sink(VertexPlaced<Scalar>{.name = name,
                              .space = Space::screen,
                              .at = screen,
                              .snapped = transforms.snap == Snap::none
                                             ? std::span<const Scalar>()
                                             : std::span<const Scalar>(pixel)});
}

/// Tells every vertex through its spaces; a space that the scene has no matrix for is passed over.
/// A vertex that cannot be seen stops at clip space.
template <typename Scalar>
void tell_vertices(const Scene& scene, const Transforms<Scalar>& transforms,
                   const Listener& listener) {
    if (!listener.takes<VertexPlaced<Scalar>>())
        return;
    for_each_used_vertex(
        scene, transforms, used_vertices(scene), [&](std::size_t i, const auto& model) {
            const std::string_view name = scene.vertices[i].name;
            const auto positions = positions_of(scene.vertices[i], model, transforms);
            if (model)
                tell_position<Scalar>(name, Space::object, positions.object, 3, listener);
            tell_position<Scalar>(name, Space::world, positions.world, 3, listener);
            if (transforms.view)
                tell_position<Scalar>(name, Space::camera, positions.camera, 3, listener);
            if (transforms.projection)
                tell_position<Scalar>(name, Space::clip, positions.clip, 4, listener);
            if (is_in_view(positions.clip, transforms))
                tell_positions_on_screen(name, positions.clip, transforms, listener);
        });
}

template <typename Scalar> bool is_finite(const Scalar& number) {
    if constexpr (std::floating_point<Scalar>)
        return std::isfinite(number);
    else
        return true;
}

/// Tells a matrix, what it is a product of, and the camera of a view.
template <typename Scalar>
void tell_matrix(std::string_view name, std::string_view object,
                 const std::optional<Matrix<Scalar>>& matrix,
                 const std::vector<MatrixFactor<Rational>>& exact_factors, const Camera* camera,
                 const Listener& listener) {
    if (!matrix)
        return;
    bool are_finite = true;
    std::vector<MatrixFactor<Scalar>> factors;
    for (const MatrixFactor<Rational>& factor : exact_factors) {
        factors.push_back({factor.name, rounded<Scalar>(factor.matrix)});
        for (const auto& row : factors.back().matrix.rows)
            are_finite = are_finite && std::all_of(row.begin(), row.end(), is_finite<Scalar>);
    }
    std::vector<Vec<Scalar, 3>> vectors;
    if (camera != nullptr)
        for (const Numbers3& numbers : {camera->position, camera->look_at, camera->up}) {
            const Vec<Rational, 3> v = exact(numbers);
            vectors.push_back({nearest_scalar<Scalar>(v.x), nearest_scalar<Scalar>(v.y),
                               nearest_scalar<Scalar>(v.z)});
            for (const Scalar& coordinate : {vectors.back().x, vectors.back().y, vectors.back().z})
                are_finite = are_finite && is_finite(coordinate);
        }
    if (!are_finite) {
        factors.clear();
        vectors.clear();
    }
    ListenerSink{listener}(MatrixSetUp<Scalar>{
        .name = name, .object = object, .matrix = *matrix, .factors = factors, .camera = vectors});
}

/// Tells the matrices of a scene.
template <typename Scalar>
void tell_matrices(const Scene& scene, const Transforms<Scalar>& transforms,
                   const Listener& listener) {
    if (!listener.takes<MatrixSetUp<Scalar>>())
        return;
    for (std::size_t i = 0; i < transforms.models.size(); ++i)
        tell_matrix<Scalar>("model", scene.objects[i].name, transforms.models[i],
                            factors_of(scene.objects[i].model.steps()), nullptr, listener);
    if (scene.objects.empty())
        tell_matrix<Scalar>("model", {}, transforms.rest_model, {}, nullptr, listener);
    tell_matrix<Scalar>("view", {}, transforms.view,
                        scene.camera
                            ? factors_of(*scene.camera, view_axis_of(scene.projection.type))
                            : std::vector<MatrixFactor<Rational>>(),
                        scene.camera ? &*scene.camera : nullptr, listener);
    tell_matrix<Scalar>("projection", {}, transforms.projection,
                        factors_of(scene.projection, scene.canvas), nullptr, listener);
    tell_matrix<Scalar>("viewport", {}, transforms.viewport,
                        factors_of(scene.viewport, scene.canvas), nullptr, listener);
}

/// Tells the matrices, then the vertices, then what the painter has sorted.
template <typename Scalar>
void tell_geometry(const Scene& scene, const ScreenList<Scalar>& list, const Listener& listener) {
    const ListenerSink sink(listener);
    const Transforms<Scalar>& transforms = list.transforms;
    tell_matrices(scene, transforms, listener);
    if (scene.has_transforms() || scene.keeps_transforms())
        tell_vertices(scene, transforms, listener);
    if (list.order) {
        std::vector<std::string_view> names;
        std::vector<std::size_t> indices;
        for (const std::size_t i : list.order->primitives)
            if (scene.primitives[i].kind == PrimitiveKind::triangle) {
                names.push_back(scene.primitives[i].name);
                indices.push_back(i);
            }
        sink(PrimitivesOrdered<Scalar>{
            .names = names, .distances = list.order->keys, .indices = indices});
    }
}

// For every kind of number that vertices are moved in.

template Geometry<float> geometry_of(const Scene&);
template VertexInSpace<float> vertex_in_space(const Scene&, const Transforms<float>&, std::size_t);
template ScreenPositions<float> positions_on_screen(const Vec<float, 4>&, const Transforms<float>&);
template void tell_position<float>(std::string_view, Space, const Vec<float, 4>&, std::size_t,
                                   const Listener&);
template void tell_positions_on_screen<float>(std::string_view, const Vec<float, 4>&,
                                              const Transforms<float>&, const Listener&);
template void tell_geometry(const Scene&, const ScreenList<float>&, const Listener&);

template Geometry<double> geometry_of(const Scene&);
template VertexInSpace<double> vertex_in_space(const Scene&, const Transforms<double>&,
                                               std::size_t);
template ScreenPositions<double> positions_on_screen(const Vec<double, 4>&,
                                                     const Transforms<double>&);
template void tell_position<double>(std::string_view, Space, const Vec<double, 4>&, std::size_t,
                                    const Listener&);
template void tell_positions_on_screen<double>(std::string_view, const Vec<double, 4>&,
                                               const Transforms<double>&, const Listener&);
template void tell_geometry(const Scene&, const ScreenList<double>&, const Listener&);

template Geometry<Adaptive> geometry_of(const Scene&);
template VertexInSpace<Adaptive> vertex_in_space(const Scene&, const Transforms<Adaptive>&,
                                                 std::size_t);
template ScreenPositions<Adaptive> positions_on_screen(const Vec<Adaptive, 4>&,
                                                       const Transforms<Adaptive>&);
template void tell_position<Adaptive>(std::string_view, Space, const Vec<Adaptive, 4>&, std::size_t,
                                      const Listener&);
template void tell_positions_on_screen<Adaptive>(std::string_view, const Vec<Adaptive, 4>&,
                                                 const Transforms<Adaptive>&, const Listener&);
template void tell_geometry(const Scene&, const ScreenList<Adaptive>&, const Listener&);

template Geometry<Rational> geometry_of(const Scene&);
template Geometry<Rational> empty_geometry(const Scene&);
template VertexInSpace<Rational> vertex_in_space(const Scene&, const Transforms<Rational>&,
                                                 std::size_t);
template void move_vertex(const Scene&, std::size_t, Geometry<Rational>&);
template ScreenPositions<Rational> positions_on_screen(const Vec<Rational, 4>&,
                                                       const Transforms<Rational>&);
template void tell_position<Rational>(std::string_view, Space, const Vec<Rational, 4>&, std::size_t,
                                      const Listener&);
template void tell_positions_on_screen<Rational>(std::string_view, const Vec<Rational, 4>&,
                                                 const Transforms<Rational>&, const Listener&);
template void tell_geometry(const Scene&, const ScreenList<Rational>&, const Listener&);

} // namespace rastertrace
