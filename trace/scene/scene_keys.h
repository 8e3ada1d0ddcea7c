// SPDX-License-Identifier: MIT
#pragma once

// The keys and words of a scene file: docs/scene-format.md says more about each. The reader allows these and no
// others, and the schema of scenes (schema_scene.cpp) is written from them.
//
//     json.allow_keys(root, scene_keys);

#include <rastertrace/core/draw/scene/transforms.h>
#include <rastertrace/trace/text/json_key.h>

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace rastertrace {

inline constexpr std::array scene_keys{
    schema_key,
    JsonKey{"title", "text", "Shown above every frame"},
    JsonKey{"canvas", "canvas", "The grid of pixels; without it, one that the primitives fit on"},
    JsonKey{"background", "color", "How views show the pixels that nothing draws; it draws none"},
    JsonKey{"vertices", "vertices", "Name of a vertex to its place"},
    JsonKey{"colors", "colors", "Name of a vertex to its color; pixels between vertices are mixed"},
    JsonKey{"triangles", "triangles", "Triangles, which are filled"},
    JsonKey{"polygons", "polygons", "Polygons of any shape, which are filled"},
    JsonKey{"outlines", "outlines", "Triangles of which the three sides are drawn"},
    JsonKey{"lines", "lines", "Lines"},
    JsonKey{"circles", "circles", "Circles around vertices"},
    JsonKey{"points", "points", "Points: the pixel nearest to each"},
    JsonKey{"meshes", "meshes", "Solids from OBJ files, or written out"},
    JsonKey{"model", "model", "Moves the scene's own vertices: steps, in the order of the list"},
    JsonKey{"camera", "camera", "Where the scene is seen from; without it, the world is its space"},
    JsonKey{
        "projection", "projection",
        "How camera space comes to the view plane; without it, x and y are places on the screen"},
    JsonKey{"viewport", "viewport", "How the view plane comes to the canvas"},
    JsonKey{"light", "light", "The light, for \"shade\": \"lambert\" and \"cull\": \"light\""},
    JsonKey{"convention", "convention", "Whose rules it is drawn by; its own keys win"},
    JsonKey{"method", "method", "Which algorithm draws, with which conventions"},
    JsonKey{"keep", "stages", "Stages that run although the scene does not need them"},
    JsonKey{"vary", "vary", "Numbers that have another value in each frame of a sequence"},
};

/// Of a primitive that is written as an object. What its vertices are depends on the list that it is in.
inline constexpr JsonKey primitive_vertices{"vertices", "", "Its vertices, by name", true};
inline constexpr std::array primitive_keys{
    primitive_vertices,
    JsonKey{"name", "text", "How steps and messages call it; without it, by its vertices"},
    JsonKey{"color", "color", "Its color; without it, black"},
};

/// Of a primitive with a radius.
inline constexpr std::array keys_around_vertex{
    JsonKey{"center", "text", "The vertex in its middle, by name", true},
    JsonKey{"radius", "radius", "How far it is from there, in whole pixels", true},
    JsonKey{"name", "text", "How steps and messages call it; without it, by its center"},
    JsonKey{"color", "color", "Its color; without it, black"},
};

inline constexpr std::array mesh_keys{
    JsonKey{"obj", "text", "A Wavefront OBJ file, by its path from the scene's folder"},
    JsonKey{"vertices", "vertices", "Or the mesh itself: name of a vertex to its place"},
    JsonKey{"faces", "faces", "And its faces, three vertices or more each"},
    JsonKey{"name", "text", "Vertices are called NAME.VERTEX, faces NAME.FACE"},
    JsonKey{"color", "color", "Of all faces; without it, black"},
    JsonKey{"draw", "draw", "Faces as triangles, polygons or outlines, or their hidden lines"},
    JsonKey{"model", "model", "Moves the mesh's vertices: steps, in the order of the list"},
};
inline constexpr std::array draw_words{
    JsonWord{"triangles", "faces are filled; one of more than three vertices is cut"},
    JsonWord{"polygons", "faces are filled, and none is cut"},
    JsonWord{"outlines", "the sides of faces are drawn"},
    JsonWord{"hidden-lines", "the sides of faces are drawn where no face hides them"},
};

/// A step of a model has one of them.
inline constexpr std::array model_keys{
    JsonKey{"scale", "numbers3", "Multiplies x, y and z"},
    JsonKey{"translate", "numbers3", "Adds to x, y and z"},
    JsonKey{"rotate", "rotate", "Turns around an axis through the origin"},
    JsonKey{"shear", "shear", "Adds a multiple of one coordinate to another"},
};
inline constexpr std::size_t most_model_steps = 256;

inline constexpr std::array rotate_keys{
    JsonKey{"axis", "axis", "The axis to turn around", true},
    JsonKey{"degrees", "number", "The angle; a right angle is 90", true},
};
/// An axis that is written as a word: the i-th has its 1 in coordinate i.
inline constexpr std::array axis_words{
    JsonWord{"x", "the axis [1, 0, 0]"},
    JsonWord{"y", "the axis [0, 1, 0]"},
    JsonWord{"z", "the axis [0, 0, 1]"},
};

inline constexpr std::array shear_keys{
    JsonKey{"xy", "number", "x grows by this times y"},
    JsonKey{"xz", "number", "x grows by this times z"},
    JsonKey{"yx", "number", "y grows by this times x"},
    JsonKey{"yz", "number", "y grows by this times z"},
    JsonKey{"zx", "number", "z grows by this times x"},
    JsonKey{"zy", "number", "z grows by this times y"},
};

/// In place of a camera or a viewport: one that fits.
inline constexpr std::string_view fit_word = "fit";
inline constexpr std::array camera_words{
    JsonWord{fit_word, "as near as all that there is stays in view"},
};
inline constexpr std::array viewport_words{
    JsonWord{fit_word, "all that is in view, to the centers of the outermost pixels"},
};

inline constexpr std::array camera_keys{
    JsonKey{"position", "numbers3", "Where the camera is", true},
    JsonKey{"look_at", "numbers3",
            "The place in the middle of the picture; without it, the origin"},
    JsonKey{"up", "numbers3", "A direction that points up in the picture; without it, [0, 1, 0]"},
};

inline constexpr JsonKey projection_type{"type", "projection-type", "Which projection it is", true};

inline constexpr std::array no_projection_keys{projection_type};
inline constexpr std::array clip_space_keys{
    projection_type,
    JsonKey{"z", "z-range", "Which z is in view: -w to w, or 0 to w"},
};
inline constexpr std::array z_range_words{
    JsonWord{"minus-one-to-one", "from -w to w, as in OpenGL"},
    JsonWord{"zero-to-one", "from 0 to w, as in Direct3D and Vulkan"},
};
inline constexpr std::array orthographic_keys{
    projection_type,
    JsonKey{"left", "number", "The smallest x in view", true},
    JsonKey{"right", "number", "The largest x in view", true},
    JsonKey{"bottom", "number", "The smallest y in view", true},
    JsonKey{"top", "number", "The largest y in view", true},
    JsonKey{"near", "number", "The distance that the view begins at; together with far"},
    JsonKey{"far", "number", "The distance that the view ends at"},
};
inline constexpr std::array view_plane_keys{
    projection_type,
    JsonKey{"distance", "positive", "From the eye to the view plane", true},
    JsonKey{"near", "positive", "What is nearer is clipped; without it, 1/1000 of the distance"},
};
inline constexpr std::array frustum_keys{
    projection_type,
    JsonKey{"fov_y", "positive", "The angle between bottom and top, in degrees, below 180"},
    JsonKey{"left", "number", "In place of fov_y: the smallest x in view, at near"},
    JsonKey{"right", "number", "In place of fov_y: the largest x in view, at near"},
    JsonKey{"bottom", "number", "In place of fov_y: the smallest y in view, at near"},
    JsonKey{"top", "number", "In place of fov_y: the largest y in view, at near"},
    JsonKey{"near", "positive", "The distance that the view begins at", true},
    JsonKey{"far", "far", "The distance that the view ends at, or \"infinity\"", true},
};
/// A far plane that is none.
inline constexpr std::string_view infinity_word = "infinity";
inline constexpr std::array far_words{JsonWord{infinity_word, "the view does not end"}};

/// Those of a projection.
constexpr std::span<const JsonKey> keys_of(ProjectionType type) {
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
inline constexpr std::array pixels_keys{
    JsonKey{
        "pixels", "pixel-range",
        "Where -1 and 1 are: the centers of the first and the last pixel, or edges of the canvas",
        true},
    JsonKey{"depth_range", "numbers2", "The depths that z = -1 and z = 1 become: [near, far]"},
    JsonKey{"y", "viewport-y", "Where y = 1 is in the picture: up, at the top, if not given"},
};
inline constexpr std::array viewport_y_words{
    JsonWord{"up", "y = 1 is at the top of the picture"},
    JsonWord{"down", "y = 1 is at the bottom of the picture"},
};

/// ... or this alone.
inline constexpr std::array viewport_keys{
    JsonKey{"pixels_per_unit", "positive", "How many pixels a unit of the view plane has", true},
};

/// A light has one of them.
inline constexpr std::array light_keys{
    JsonKey{"direction", "numbers3", "From the scene to a light that is far away"},
    JsonKey{"position", "numbers3", "The place of the light in the world"},
};

/// Of the values that a number takes, unless they are a list.
inline constexpr std::array range_keys{
    JsonKey{"from", "number", "The value in the first frame", true},
    JsonKey{"to", "number", "The value in the last frame", true},
    JsonKey{"steps", "frames", "How many frames there are", true},
};

} // namespace rastertrace
