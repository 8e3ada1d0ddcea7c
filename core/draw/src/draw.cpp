// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/draw.h>

#include "draw_scalar.h"

#include <rastertrace/core/draw/model/mistakes.h>
#include <rastertrace/core/draw/scene/triangulate.h>

#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

/// Tells how the faces of meshes that are not convex were cut.
void tell_cut_faces(const Scene& scene, const Listener& listener) {
    if (!listener.takes<FaceTriangulated<>>())
        return;
    for (const CutFace& face : scene.cut_faces) {
        std::vector<std::string_view> vertices;
        std::vector<Vec<Rational, 3>> places;
        for (const std::size_t corner : face.corners) {
            const SceneVertex& vertex = scene.vertices[corner];
            vertices.push_back(vertex.name);
            places.push_back({vertex.x.exact(), vertex.y.exact(), vertex.z.exact()});
        }
        std::vector<Vec<Quantity, 3>> at;
        for (const Vec<Rational, 3>& place : places)
            at.push_back({place.x, place.y, place.z});
        std::vector<std::string_view> ears;
        for (std::size_t i = 0; i < face.ears; ++i)
            ears.push_back(scene.primitives[face.first_ear + i].name);
        const char drops = axis_name(face.dropped);
        listener(FaceTriangulated<>{.name = face.name,
                                    .vertices = vertices,
                                    .at = at,
                                    .normal = {face.normal.x, face.normal.y, face.normal.z},
                                    .drops = {&drops, 1},
                                    .ears = ears});
    }
}

} // namespace

Image draw(const Scene& scene, const Plan& plan, const Listener& listener, Fallbacks* fallbacks) {
    tell_cut_faces(scene, listener);
    if (const auto mistakes = modelled_mistakes(scene); !mistakes.empty()) {
        ModelRules rules(scene);
        for (const Mistake* const mistake : mistakes)
            mistake->put_in(rules);
        return draw_by(rules, listener);
    }
    const auto draw_by_plan = with_scalar(plan, []<typename Scalar>() { return draw_in<Scalar>; });
    return draw_by_plan(scene, plan, listener, fallbacks);
}

} // namespace rastertrace
