// SPDX-License-Identifier: MIT
#include "list/faces.h"

#include <compare>

namespace rastertrace {

std::vector<bool> culled_sides_of(const Scene& scene,
                                  const std::function<bool(std::size_t index)>& is_drawn) {
    const auto& primitives = scene.primitives;
    if (scene.method.cull == Cull::none ||
        std::none_of(primitives.begin(), primitives.end(),
                     [](const ScenePrimitive& one) { return one.is_side; }))
        return {};

    // A face is drawn if one of its triangles is: one without area never is.
    const auto face_number = [&primitives](std::size_t i) {
        return primitives[i].polygon == 0 ? i : primitives.size() + primitives[i].polygon;
    };
    std::vector<std::size_t> filled;
    std::vector<std::size_t> faces;
    for (std::size_t i = 0; i < primitives.size(); ++i)
        if (is_filled(primitives[i].kind)) {
            filled.push_back(i);
            if (is_drawn(i))
                faces.push_back(face_number(i));
        }
    std::sort(faces.begin(), faces.end());

    // The sides of the drawn faces. A side that two triangles of one face share is a diagonal.
    struct SideOfFace {
        std::size_t low, high, face;
        auto operator<=>(const SideOfFace&) const = default;
    };
    std::vector<SideOfFace> sides;
    for (const std::size_t i : filled)
        if (const auto corners = primitives[i].corners();
            std::binary_search(faces.begin(), faces.end(), face_number(i)))
            for (std::size_t k = 0; k < corners.size(); ++k) {
                const std::size_t from = corners[k];
                const std::size_t to = corners[(k + 1) % corners.size()];
                sides.push_back({std::min(from, to), std::max(from, to), face_number(i)});
            }
    std::sort(sides.begin(), sides.end());
    const auto is_drawn_side = [&sides](std::size_t from, std::size_t to) {
        const SideOfFace first{std::min(from, to), std::max(from, to), 0};
        auto side = std::lower_bound(sides.begin(), sides.end(), first);
        while (side != sides.end() && side->low == first.low && side->high == first.high) {
            const auto next = std::upper_bound(side, sides.end(), *side);
            if (next - side == 1)
                return true;
            side = next;
        }
        return false;
    };
    std::vector<bool> result(primitives.size());
    for (std::size_t i = 0; i < primitives.size(); ++i)
        result[i] = primitives[i].is_side &&
                    !is_drawn_side(primitives[i].vertices[0], primitives[i].vertices[1]);
    return result;
}

} // namespace rastertrace
