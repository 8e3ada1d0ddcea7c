// SPDX-License-Identifier: MIT
#pragma once

// A scene as the file that describes it, so that a test that fails on a random scene can say which one.
// docs/scene-format.md tells the format.
//
//     EXPECT_EQ(...) << scene_text(scene);  // save it as scene.json: rastertrace show scene.json

#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/pipeline_names.h>
#include <rastertrace/trace/text/stage_name.h>
#include <rastertrace/trace/text/text.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace rastertrace {

/// A number that is read back the same: whole, or a fraction in quotes.
inline std::string json_of(const Number& number) {
    const Rational exact = number.exact();
    return exact.get_den() == 1 ? exact.get_str() : '"' + exact.get_str() + '"';
}
inline std::string json_of(std::span<const Number> numbers) {
    std::string text;
    for (const Number& number : numbers)
        text += (text.empty() ? "[" : ",") + json_of(number);
    return text + "]";
}

/// `{"scale":[2,2,2]}`
inline std::string json_of(const ModelStep& step) {
    if (const auto* scale = std::get_if<Scale>(&step))
        return R"({"scale":)" + json_of(scale->by) + "}";
    if (const auto* translate = std::get_if<Translate>(&step))
        return R"({"translate":)" + json_of(translate->by) + "}";
    if (const auto* rotate = std::get_if<Rotate>(&step))
        return R"({"rotate":{"axis":)" + json_of(rotate->axis) + R"(,"degrees":)" +
               json_of(rotate->degrees) + "}}";
    const auto& shear = std::get<Shear>(step);
    return R"({"shear":{"xy":)" + json_of(shear.xy) + R"(,"xz":)" + json_of(shear.xz) +
           R"(,"yx":)" + json_of(shear.yx) + R"(,"yz":)" + json_of(shear.yz) + R"(,"zx":)" +
           json_of(shear.zx) + R"(,"zy":)" + json_of(shear.zy) + "}}";
}

/// Without the `far` of a pinhole or a view plane, for which a file has no key.
inline std::string json_of(const Projection& projection) {
    std::string text = R"({"type":")" + std::string(name_of(projection.type)) + '"';
    const auto put = [&text](std::string_view key, const Number& number) {
        text += ",\"" + std::string(key) + "\":" + json_of(number);
    };
    const bool is_frustum = projection.type == ProjectionType::frustum;
    if (is_frustum && projection.fov_y) {
        put("fov_y", *projection.fov_y);
    } else if (is_frustum || projection.type == ProjectionType::orthographic) {
        put("left", projection.left);
        put("right", projection.right);
        put("bottom", projection.bottom);
        put("top", projection.top);
    } else {
        put("distance", projection.distance);
    }
    if (projection.near)
        put("near", *projection.near);
    if (is_frustum || projection.type == ProjectionType::orthographic) {
        if (projection.far)
            put("far", *projection.far);
        else if (is_frustum)
            text += R"(,"far":"infinity")";
    }
    return text + "}";
}

/// A scene without meshes, its primitives listed as a file lists them: by kind. Vertices are called V0,
/// V1, ...; names of primitives have to differ.
inline std::string scene_text(const Scene& scene) {
    constexpr std::array origins{"center", "bottom-left", "top-left"};
    std::string text = R"({"canvas":{"width":)" + std::to_string(scene.canvas.width) +
                       R"(,"height":)" + std::to_string(scene.canvas.height) + R"(,"origin":")" +
                       origins[static_cast<std::size_t>(scene.canvas.origin)] + "\"}";
    const auto quoted = [](std::string_view name) { return json_quoted(name); };
    const auto vertex_name = [](std::size_t i) { return "\"V" + std::to_string(i) + '"'; };

    // Vertices, and their colors.
    std::string places, colors;
    for (std::size_t i = 0; i < scene.vertices.size(); ++i) {
        const SceneVertex& vertex = scene.vertices[i];
        places += (i == 0 ? "" : ",") + vertex_name(i) + ":" +
                  (scene.projection.type == ProjectionType::clip_space
                       ? json_of(std::array{vertex.x, vertex.y, vertex.z, vertex.w})
                       : json_of(std::array{vertex.x, vertex.y, vertex.z}));
        if (vertex.color)
            colors +=
                (colors.empty() ? "" : ",") + vertex_name(i) + ":" + quoted(to_text(*vertex.color));
    }
    text += ",\n\"vertices\":{" + places + "}";
    if (!colors.empty())
        text += ",\n\"colors\":{" + colors + "}";

    // Primitives by kind.
    for (const PrimitiveKind kind : all_primitives) {
        std::string list;
        for (const ScenePrimitive& primitive : scene.primitives) {
            if (primitive.kind != kind)
                continue;
            std::string corners;
            for (const std::size_t corner : primitive.corners())
                corners += (corners.empty() ? "" : ",") + vertex_name(corner);
            list += (list.empty() ? "" : ",") + (R"({"vertices":[)" + corners) + "]";
            if (!primitive.name.empty())
                list += R"(,"name":)" + quoted(primitive.name);
            list += R"(,"color":)" + quoted(to_text(primitive.color)) + "}";
        }
        if (!list.empty())
            text += ",\n\"" + std::string(traits_of(kind).list) + "\":[" + list + "]";
    }

    // From object space to the screen.
    std::string model;
    for (const SceneObject& object : scene.objects)
        for (const ModelStep& step : object.model.steps())
            model += (model.empty() ? "" : ",") + json_of(step);
    if (!model.empty())
        text += ",\n\"model\":[" + model + "]";
    if (scene.camera)
        text += ",\n\"camera\":{\"position\":" + json_of(scene.camera->position) +
                ",\"look_at\":" + json_of(scene.camera->look_at) +
                ",\"up\":" + json_of(scene.camera->up) + "}";
    if (scene.projection.type != ProjectionType::none)
        text += ",\n\"projection\":" + json_of(scene.projection);
    if (scene.viewport.type == ViewportType::pixels)
        text += ",\n\"viewport\":{\"pixels\":\"" +
                std::string(pixel_range_names()[static_cast<std::size_t>(scene.viewport.pixels)]) +
                "\",\"y\":\"" + (scene.viewport.is_y_down ? "down" : "up") + "\"}";
    else if (scene.viewport.type == ViewportType::pixels_per_unit)
        text +=
            ",\n\"viewport\":{\"pixels_per_unit\":" + json_of(scene.viewport.pixels_per_unit) + "}";
    if (scene.light)
        text += std::string(",\n\"light\":{\"") +
                (scene.light->kind == Light::Kind::direction ? "direction" : "position") +
                "\":" + json_of(scene.light->at) + "}";

    // How it is drawn.
    std::string method;
    for (const MethodKey& key : method_keys())
        if (const std::string value(key.get(scene.method)); !value.empty())
            method += (method.empty() ? "" : ",") + quoted(key.name) + ":" +
                      (key.is_number() ? value : quoted(value));
    text += ",\n\"method\":{" + method + "}";
    std::string keep;
    for (std::size_t i = 0; i < stage_count; ++i)
        if (const auto stage = static_cast<Stage>(i); scene.keep.has(stage))
            keep += (keep.empty() ? "" : ",") + quoted(name_of(stage));
    if (!keep.empty())
        text += ",\n\"keep\":[" + keep + "]";
    return text + "}\n";
}

} // namespace rastertrace
