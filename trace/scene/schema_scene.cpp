// SPDX-License-Identifier: MIT
// The schema of scene files.

#include "schema_scene.h"

#include "scene_file.h"
#include "scene_keys.h"

#include <rastertrace/core/raster/circle.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/pipeline_names.h>
#include <rastertrace/trace/text/schema_parts.h>
#include <rastertrace/trace/text/stage_name.h>

#include <fmt/core.h>

#include <cstddef>
#include <string>
#include <vector>

namespace rastertrace {

namespace {

/// A list of so many numbers.
Json numbers(std::size_t least, std::size_t most) {
    Json schema = list_of("number", least);
    schema["maxItems"] = most;
    return schema;
}

/// An object that has exactly one of these keys.
Json one_key_of(std::span<const JsonKey> keys) {
    Json schema = object_with(keys);
    schema["minProperties"] = 1;
    schema["maxProperties"] = 1;
    return schema;
}

/// "ABC" or ["P1", "P2", "P3"], of so many names; `most` 0: or more.
Json corners(std::size_t least, std::size_t most) {
    Json letters{{"type", "string"}, {"minLength", least}};
    Json names = list_of("text", least);
    if (most > 0) {
        letters["maxLength"] = most;
        names["maxItems"] = most;
    }
    return {{"anyOf", Json::array({std::move(letters), std::move(names)})}};
}

/// The list of primitives of a kind, and one of them.
void define_primitives(Json& definitions, const PrimitiveTraits& traits) {
    const std::string list(traits.list);
    if (traits.has_radius) {
        const std::string one(traits.name);
        definitions[one] = object_with(keys_around_vertex);
        definitions[list] = list_of(one);
        return;
    }
    const std::string of_one = "vertices-of-" + list;
    definitions[of_one] = corners(traits.corners, traits.has_ring ? most_corners : traits.corners);
    Json written_out = object_with(primitive_keys);
    written_out["properties"][std::string(primitive_vertices.name)] =
        reference_to(of_one, primitive_vertices.meaning);
    definitions["one-of-" + list] = {
        {"anyOf", Json::array({reference_to(of_one), std::move(written_out)})}};
    definitions[list] = list_of("one-of-" + list);
}

/// A mesh is a file, or vertices and faces.
Json mesh() {
    Json schema = object_with(mesh_keys);
    schema["if"] = {{"required", {"obj"}}};
    schema["then"] = {{"properties", {{"vertices", false}, {"faces", false}}}};
    schema["else"] = {{"required", {"vertices", "faces"}}};
    return schema;
}

/// Which of the keys of a projection go together, beside those that must be there.
Json conditions_of(ProjectionType type) {
    if (type == ProjectionType::orthographic)
        return {{"dependencies", {{"near", {"far"}}, {"far", {"near"}}}}};
    if (type != ProjectionType::frustum)
        return Json::object();
    const Json bounds{"left", "right", "bottom", "top"};
    Json without_bounds = Json::object();
    for (const auto& bound : bounds)
        without_bounds[bound.get<std::string>()] = false;
    return {{"if", {{"required", {"fov_y"}}}},
            {"then", {{"properties", without_bounds}}},
            {"else", {{"required", bounds}}}};
}

/// The type says which keys there are.
Json projection() {
    const std::string type_key(projection_type.name);
    Json cases = Json::array();
    for (const std::string_view name : projection_names()) {
        const ProjectionType type = *projection_named(name);
        Json keys = object_with(keys_of(type));
        keys.update(conditions_of(type));
        const Json is_type{{"properties", {{type_key, {{"const", name}}}}},
                           {"required", {type_key}}};
        cases.push_back({{"if", is_type}, {"then", std::move(keys)}});
    }
    Json schema = open_object_with(no_projection_keys);
    schema["allOf"] = std::move(cases);
    return schema;
}

/// The values of a key of the method.
Json one_of_values(const MethodKey& key) {
    std::vector<JsonWord> words;
    for (std::size_t i = 0; i < key.values.size(); ++i)
        words.push_back({key.values[i], key.meanings[i]});
    Json schema = one_of(words);
    if (key.name == "mistake") // or several
        return {{"anyOf", Json::array({schema, {{"type", "string"}, {"pattern", ","}}})}};
    // A number may stand in quotes, or without.
    if (key.is_number())
        for (const JsonWord& word : words) {
            schema["enum"].push_back(std::stoi(std::string(word.name)));
            schema["enumDescriptions"].push_back(word.meaning);
        }
    return schema;
}

/// One line for people; with the default, where that hangs on nothing.
std::string meaning_of(const MethodKey& key) {
    const std::string value = key.get(Method{});
    return std::string(key.meaning) + (value.empty() ? "" : "; without it, " + value);
}

Json method() {
    Json schema{{"type", "object"}, {"properties", Json::object()}};
    for (const MethodKey& key : method_keys()) {
        if (key.name == "convention")
            continue; // a key of the scene
        Json value = one_of_values(key);
        value["description"] = meaning_of(key);
        schema["properties"][std::string(key.name)] = std::move(value);
    }
    schema["additionalProperties"] = false;
    return schema;
}

/// Pointers to numbers, and their values.
Json vary() {
    Json values = list_of("number", 1);
    values["maxItems"] = most_frames;
    return {{"type", "object"},
            {"propertyNames", {{"pattern", "^/"}}},
            {"additionalProperties", {{"anyOf", Json::array({object_with(range_keys), values})}}}};
}

/// A number above 0.
Json positive() {
    Json schema = number_schema();
    schema.erase("minimum");
    schema["exclusiveMinimum"] = 0;
    schema["allOf"] = Json::array({{{"pattern", "^[0-9.]*[1-9]"}}});
    return schema;
}

/// At least one list has a primitive.
Json has_primitives() {
    Json cases = Json::array();
    std::vector<std::string> lists;
    for (const PrimitiveKind kind : all_primitives)
        lists.emplace_back(traits_of(kind).list);
    lists.emplace_back("meshes");
    for (const std::string& list : lists)
        cases.push_back({{"required", {list}}, {"properties", {{list, {{"minItems", 1}}}}}});
    return cases;
}

} // namespace

std::string scene_schema() {
    Json schema =
        schema_titled("A scene of rastertrace", "What is drawn, on which canvas, by which method");
    schema.update(object_with(scene_keys));
    schema["anyOf"] = has_primitives();

    Json definitions;
    definitions["text"] = text_schema();
    definitions["number"] = number_schema();
    definitions["positive"] = positive();
    definitions["numbers2"] = numbers(2, 2);
    definitions["numbers3"] = numbers(3, 3);
    definitions["color"] = color_schema(visible_alpha);
    define_canvas(definitions);

    definitions["place"] = numbers(2, 4);
    definitions["place"]["title"] = "A vertex: [x, y], [x, y, z] or [x, y, z, w]";
    definitions["vertices"] = map_to("place");
    definitions["vertices"]["propertyNames"] = {{"minLength", 1}};
    definitions["colors"] = map_to("color");
    for (const PrimitiveKind kind : all_primitives)
        define_primitives(definitions, traits_of(kind));
    definitions["radius"] = {{"type", "integer"}, {"minimum", 0}, {"maximum", largest_radius}};

    definitions["meshes"] = list_of("mesh");
    definitions["mesh"] = mesh();
    definitions["faces"] = list_of("face", 1);
    definitions["face"] = corners(3, 0);
    definitions["draw"] = one_of(draw_words);

    definitions["model"] = list_of("model-step");
    definitions["model"]["maxItems"] = most_model_steps;
    definitions["model-step"] = one_key_of(model_keys);
    definitions["rotate"] = object_with(rotate_keys);
    definitions["axis"] = {{"anyOf", Json::array({one_of(axis_words), reference_to("numbers3")})}};
    definitions["shear"] = object_with(shear_keys);

    definitions["camera"] = {
        {"anyOf", Json::array({one_of(camera_words), object_with(camera_keys)})}};
    definitions["projection"] = projection();
    definitions["projection-type"] = one_of(projection_words());
    definitions["far"] = {{"anyOf", Json::array({one_of(far_words), reference_to("positive")})}};
    definitions["viewport"] = {
        {"anyOf", Json::array({one_of(viewport_words), object_with(pixels_keys),
                               object_with(viewport_keys)})}};
    definitions["z-range"] = one_of(z_range_words);
    definitions["convention"] = one_of_values(*find_method_key("convention"));
    definitions["pixel-range"] = one_of(pixel_range_words());
    definitions["viewport-y"] = one_of(viewport_y_words);
    definitions["light"] = one_key_of(light_keys);

    definitions["method"] = method();
    definitions["stages"] = list_of("stage");
    definitions["stage"] = one_of(stage_words());
    definitions["vary"] = vary();
    const Json whole{{"type", "integer"}, {"minimum", 1}, {"maximum", most_frames}};
    const Json in_quotes{{"type", "string"}, {"pattern", number_pattern()}};
    definitions["frames"] = {{"anyOf", Json::array({whole, in_quotes})}};
    schema["definitions"] = std::move(definitions);
    return schema_text(schema);
}

} // namespace rastertrace
