// SPDX-License-Identifier: MIT
#include "page_scene.h"

#include <rastertrace/figures/page.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/canvas_json.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace rastertrace {

namespace {

using Json = nlohmann::ordered_json;

/// What a scene in the plane may say; of what it draws, the number is limited.
constexpr std::array<std::string_view, 4> moved_lists{"points", "lines", "triangles", "outlines"};
constexpr std::array<std::string_view, 8> others{"$schema",  "title",  "canvas", "background",
                                                 "vertices", "colors", "method", "convention"};

bool is_plane_vertex(const Json& vertex) {
    return vertex.is_array() && vertex.size() == 2 &&
           std::all_of(vertex.begin(), vertex.end(),
                       [](const Json& number) { return number.is_number() || number.is_string(); });
}

bool can_be_moved(const Json& scene) {
    std::size_t primitives = 0;
    for (const auto& [key, value] : scene.items()) {
        if (std::find(moved_lists.begin(), moved_lists.end(), key) != moved_lists.end())
            primitives += value.size();
        else if (std::find(others.begin(), others.end(), key) == others.end())
            return false;
    }
    const auto vertices = scene.find("vertices");
    return primitives <= most_primitives_to_move && vertices != scene.end() &&
           vertices->is_object() &&
           std::all_of(vertices->begin(), vertices->end(), is_plane_vertex);
}

bool names_files(const Json& scene) {
    const auto meshes = scene.find("meshes");
    return meshes != scene.end() && meshes->is_array() &&
           std::any_of(meshes->begin(), meshes->end(),
                       [](const Json& mesh) { return mesh.is_object() && mesh.contains("obj"); });
}

} // namespace

PageScene scene_of_page(const Source& source, const MethodOverrides& method, const Canvas& canvas) {
    Json scene = Json::parse(source.text, nullptr, false);
    if (!scene.is_object() || scene.contains("vary") || names_files(scene))
        return {};
    const bool is_movable =
        can_be_moved(scene) && std::max(canvas.width, canvas.height) <= largest_side_with_why_not;
    if (is_movable)
        scene["canvas"] = {
            {"width", canvas.width}, {"height", canvas.height}, {"origin", name_of(canvas.origin)}};
    for (const auto& [key, value] : method) {
        const MethodKey* const row = find_method_key(key);
        Json& place = key == "convention" ? scene : scene["method"];
        place[key] =
            row != nullptr && row->is_number() ? Json::parse(value, nullptr, false) : Json(value);
    }
    return {.text = scene.dump(),
            .is_movable = is_movable,
            .can_be_turned = scene.contains("projection") || scene.contains("camera")};
}

} // namespace rastertrace
