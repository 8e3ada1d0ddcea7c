// SPDX-License-Identifier: MIT
#pragma once

// The keys and words of a scene file: docs/scene-format.md says more about each. The reader allows these and no
// others; docs/scene.schema.json has each.
//
//     json.allow_keys(root, scene_keys);

#include <rastertrace/core/draw/scene/transforms.h>
#include <rastertrace/trace/text/json_key.h>

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace rastertrace {

inline constexpr auto scene_keys = std::to_array<std::string_view>(
    {schema_key,   "title",    "canvas",   "background", "vertices", "colors",
     "triangles",  "polygons", "outlines", "lines",      "circles",  "points",
     "meshes",     "model",    "camera",   "projection", "viewport", "light",
     "convention", "method",   "keep",     "vary"});

/// Of a primitive that is written as an object. What its vertices are depends on the list that it is in.
inline constexpr std::string_view primitive_vertices = "vertices";
inline constexpr auto primitive_keys =
    std::to_array<std::string_view>({primitive_vertices, "name", "color"});

/// Of a primitive with a radius.
inline constexpr auto keys_around_vertex =
    std::to_array<std::string_view>({"center", "radius", "name", "color"});

inline constexpr auto mesh_keys =
    std::to_array<std::string_view>({"obj", "vertices", "faces", "name", "color", "draw", "model"});
inline constexpr auto draw_words =
    std::to_array<std::string_view>({"triangles", "polygons", "outlines", "hidden-lines"});

/// A step of a model has one of them.
inline constexpr auto model_keys =
    std::to_array<std::string_view>({"scale", "translate", "rotate", "shear"});
inline constexpr std::size_t most_model_steps = 256;

inline constexpr auto rotate_keys = std::to_array<std::string_view>({"axis", "degrees"});
/// An axis that is written as a word: the i-th has its 1 in coordinate i.
inline constexpr auto axis_words = std::to_array<std::string_view>({"x", "y", "z"});

inline constexpr auto shear_keys =
    std::to_array<std::string_view>({"xy", "xz", "yx", "yz", "zx", "zy"});

/// In place of a camera or a viewport: one that fits.
inline constexpr std::string_view fit_word = "fit";
inline constexpr auto camera_words = std::to_array<std::string_view>({fit_word});
inline constexpr auto viewport_words = std::to_array<std::string_view>({fit_word});

inline constexpr auto camera_keys = std::to_array<std::string_view>({"position", "look_at", "up"});

inline constexpr std::string_view projection_type = "type";

inline constexpr auto no_projection_keys = std::to_array<std::string_view>({projection_type});
inline constexpr auto clip_space_keys = std::to_array<std::string_view>({projection_type, "z"});
inline constexpr auto z_range_words =
    std::to_array<std::string_view>({"minus-one-to-one", "zero-to-one"});
inline constexpr auto orthographic_keys = std::to_array<std::string_view>(
    {projection_type, "left", "right", "bottom", "top", "near", "far"});
inline constexpr auto view_plane_keys =
    std::to_array<std::string_view>({projection_type, "distance", "near"});
inline constexpr auto frustum_keys = std::to_array<std::string_view>(
    {projection_type, "fov_y", "left", "right", "bottom", "top", "near", "far"});
/// A far plane that is none.
inline constexpr std::string_view infinity_word = "infinity";
inline constexpr auto far_words = std::to_array<std::string_view>({infinity_word});

/// Those of a projection.
constexpr std::span<const std::string_view> keys_of(ProjectionType type) {
    switch (type) {
    case ProjectionType::orthographic:
        return orthographic_keys;
    case ProjectionType::pinhole:
    case ProjectionType::view_plane:
        return view_plane_keys;
    case ProjectionType::frustum:
        return frustum_keys;
    case ProjectionType::clip_space:
        return clip_space_keys;
    case ProjectionType::none:
        break;
    }
    return no_projection_keys;
}

/// A viewport has `pixels`, and may say more ...
inline constexpr auto pixels_keys = std::to_array<std::string_view>({"pixels", "depth_range", "y"});
inline constexpr auto viewport_y_words = std::to_array<std::string_view>({"up", "down"});

/// ... or this alone.
inline constexpr auto viewport_keys = std::to_array<std::string_view>({"pixels_per_unit"});

/// A light has one of them.
inline constexpr auto light_keys = std::to_array<std::string_view>({"direction", "position"});

/// Of the values that a number takes, unless they are a list.
inline constexpr auto range_keys = std::to_array<std::string_view>({"from", "to", "steps"});

} // namespace rastertrace
