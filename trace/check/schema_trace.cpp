// SPDX-License-Identifier: MIT
// The schema of traces: of a document, and of each line of JSON Lines.

#include "schema_trace.h"

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/trace/record/field_type.h>
#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/record/trace_keys.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/schema_parts.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <string>
#include <utility>

namespace rastertrace {

namespace {

/// The definition of what a field holds.
std::string_view form_of(FieldType type) {
    switch (type) {
    case FieldType::whole:
        return "whole";
    case FieldType::quantity:
        return "quantity";
    case FieldType::string:
        return "string";
    case FieldType::boolean:
        return "boolean";
    case FieldType::list:
        break;
    }
    return "list";
}

std::string_view meaning_of_role(FieldRole role) {
    switch (role) {
    case FieldRole::key:
        return "Says which of the steps of its kind it is";
    case FieldRole::reason:
        return "A reason of the decision, which can be taken again from it";
    case FieldRole::decision:
        return "What was decided";
    case FieldRole::told:
        break;
    }
    return "Told for who wants to know";
}

Json schema_of_field(const StepField& field) {
    const bool is_list = field.type == FieldType::list;
    const std::string_view value = field.is_color ? "color" : form_of(field.element);
    const std::string form = is_list ? fmt::format("list-of-{}", value) : std::string(value);
    if (!field.may_be_null())
        return reference_to(form, meaning_of_role(field.role));
    const Json null{{"type", "null"}};
    return {{"description", fmt::format("{}; null if there is none", meaning_of_role(field.role))},
            {"anyOf", Json::array({reference_to(form), null})}};
}

/// A step of a known kind.
Json schema_of_step(const StepRow& row) {
    Json schema{{"description", fmt::format("Fires when {}", row.fires)},
                {"properties", Json::object()}};
    Json required = Json::array();
    for (const StepField& field : fields_of(row.kind)) {
        schema["properties"][std::string(field.name)] = schema_of_field(field);
        if (field.is_required())
            required.push_back(field.name);
    }
    if (!required.empty())
        schema["required"] = std::move(required);
    return schema;
}

/// Any step: one of a known kind has the fields of its row.
Json step() {
    Json kinds = one_of(step_kind_words(step_kind_names()));
    kinds["description"] = "The kinds that rastertrace writes; others are kept";
    Json cases = Json::array();
    for (const std::string_view name : step_kind_names()) {
        const Json is_kind{{"properties", {{"step", {{"const", name}}}}}, {"required", {"step"}}};
        cases.push_back({{"if", is_kind}, {"then", reference_to(fmt::format("step-{}", name))}});
    }
    return {{"type", "object"},
            {"properties",
             {{"step", {{"type", "string"}, {"anyOf", Json::array({kinds, true})}}},
              {std::string(key_of_code),
               {{"description", "The place in the program that drew it, raster.cpp:120"}}}}},
            {"required", {"step"}},
            {"allOf", std::move(cases)}};
}

/// Lists of values, or of such lists.
Json nested_list(std::string_view form) {
    const Json list{{"type", "array"}, {"items", reference_to(fmt::format("list-of-{}", form))}};
    return {{"anyOf", Json::array({list_of(form), list})}};
}

/// What the method may say; a foreign rasterizer may have another one.
Json method() {
    const Json word{{"type", {"string", "number"}}};
    Json schema{{"type", "object"}, {"properties", Json::object()}};
    for (const MethodKey& key : method_keys()) {
        Json value = word;
        value["description"] = fmt::format("{}: {}", key.meaning, key.listed());
        schema["properties"][std::string(key.name)] = std::move(value);
    }
    schema["additionalProperties"] = word;
    return schema;
}

Json whole(Index least) {
    return {{"type", "integer"}, {"minimum", least}, {"maximum", farthest_index + 1}};
}

/// A JSON number, or an exact one of any size; of a foreign rasterizer also what is not finite.
Json quantity() {
    Json number = number_schema();
    number.erase("maxLength");
    const Json not_finite{{"description", "Of a foreign rasterizer"},
                          {"enum", {"NaN", "inf", "-inf"}}};
    return {{"anyOf", Json::array({std::move(number), not_finite})}};
}

void define_header(Json& definitions) {
    const Json version{{"type", "integer"}, {"minimum", 1}, {"maximum", trace_version}};
    definitions["version"] = version;
    define_canvas(definitions);
    definitions["canvas"]["required"] = {"width", "height"};
    definitions["color"] = color_schema(any_alpha);
    definitions["method"] = method();
    definitions["stages"] = {{"type", "array"}, {"items", open_object_with(stage_keys)}};
    definitions["strings"] = list_of("string");
    definitions["region"] = list_of("whole", 4);
    definitions["region"]["maxItems"] = 4;
}

void define_steps(Json& definitions) {
    definitions["step"] = step();
    for (const std::string_view name : step_kind_names())
        definitions[fmt::format("step-{}", name)] = schema_of_step(row_of(*step_kind_named(name)));
    // What lies next to the farthest index is one, too: an empty span ends there.
    definitions["whole"] = whole(-farthest_index - 1);
    definitions["quantity"] = quantity();
    definitions["string"] = {{"type", "string"}};
    definitions["boolean"] = {{"type", "boolean"}};
    for (const std::string_view form : {"quantity", "string", "boolean", "color"})
        definitions[fmt::format("list-of-{}", form)] = nested_list(form);
}

/// The layouts: all in one document, or in three kinds of lines.
void define_layouts(Json& definitions) {
    Json document = open_object_with(header_keys);
    document["properties"]["steps"] = {{"description", "What was decided, in order"},
                                       {"type", "array"},
                                       {"items", reference_to("step")}};
    document["properties"]["end"] = reference_to("end", "Makes the trace complete");
    document["required"].insert(document["required"].end(), {"steps", "end"});
    definitions["document"] = std::move(document);

    definitions["header-line"] = open_object_with(header_keys);
    Json end_line{{"type", "object"}, {"properties", {{"end", reference_to("end")}}}};
    end_line["required"] = {"end"};
    definitions["end-line"] = std::move(end_line);
    definitions["end"] = open_object_with(end_keys);
    definitions["count"] = whole(0);
    definitions["counts"] = map_to("count");
}

/// `then` for an object with a key, `otherwise` for one without.
Json by_key(std::string_view key, Json then, Json otherwise) {
    return {{"if", {{"required", Json::array({key})}}},
            {"then", std::move(then)},
            {"else", std::move(otherwise)}};
}

} // namespace

std::vector<JsonWord> step_kind_words(std::span<const std::string_view> names) {
    std::vector<JsonWord> words;
    for (const std::string_view name : names)
        words.push_back({name, row_of(*step_kind_named(name)).fires});
    return words;
}

std::string trace_schema() {
    Json schema = schema_titled(
        "A trace of rastertrace",
        "What a rasterizer decided, step by step: a whole document, or one line of JSON Lines");
    schema["type"] = "object";
    const Json with_header = by_key("steps", reference_to("document"), reference_to("header-line"));
    const Json other_line = by_key("step", reference_to("step"), reference_to("end-line"));
    schema.update(by_key("rastertrace", with_header, other_line));

    Json definitions;
    define_layouts(definitions);
    define_header(definitions);
    define_steps(definitions);
    schema["definitions"] = std::move(definitions);
    return schema_text(schema);
}

} // namespace rastertrace
