// SPDX-License-Identifier: MIT
// The schema of claims in JSON.

#include "schema_claims.h"

#include "claim_fields.h"
#include "claims.h"
#include "claims_keys.h"
#include "schema_trace.h"

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/text/schema_parts.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// What a field that is left open says.
Json open() {
    return {{"enum", {nullptr, open_value}}};
}

/// A number in quotes, of at most as many characters as are read.
Json quoted_number() {
    return {{"type", "string"}, {"pattern", number_pattern()}, {"maxLength", longest_number}};
}

/// The definition of the values of a field.
std::string form_of(const ClaimField& field) {
    switch (field.type) {
    case FieldType::whole:
        return "whole";
    case FieldType::quantity:
        return "number";
    case FieldType::boolean:
        return "boolean";
    case FieldType::string:
    case FieldType::list: // its elements have types of their own
        break;
    }
    return field.name == "color" ? "color" : "name";
}

/// What a field of a claim may hold. Only what says which step is meant cannot be left open.
Json schema_of_field(const ClaimField& field) {
    const std::string form = form_of(field);
    if (field.is_key)
        return reference_to(form, "Says which step is meant");
    return reference_to(fmt::format("{}-{}", field.is_list ? "list-of" : "claimed", form),
                        fmt::format("Claimed: {}; null or \"?\" if it is left open",
                                    words_for_field(field.name, Language::english)));
}

/// Two fields of one name take what either does.
Json either(const Json& one, const Json& other) {
    return {{"anyOf", Json::array({one, other})}};
}

/// Claims about a kind of step: fields that say which one it is, and at least one that is claimed.
Json schema_of_claim(std::string_view kind) {
    const StepKind known = *step_kind_named(kind);
    Json schema{{"description", fmt::format("Claims about when {}", row_of(known).fires)},
                {"type", "object"},
                {"properties", {{"step", {{"const", kind}}}}}};
    Json& properties = schema["properties"];
    Json claimed = Json::array();
    for (const ClaimField& field : claim_fields_of(known)) {
        const std::string name(field.name);
        const Json value = schema_of_field(field);
        const bool is_known = properties.contains(name);
        properties[name] = is_known ? either(properties[name], value) : value;
        properties[name]["description"] = value["description"];
        if (!field.is_key && !is_known)
            claimed.push_back({{"required", Json::array({name})}});
    }
    schema["additionalProperties"] = false;
    schema["anyOf"] = std::move(claimed);
    return schema;
}

/// The kind of step says which fields there are; a picture is no step.
Json claim() {
    Json cases = Json::array();
    for (const std::string_view kind : claim_kinds()) {
        const Json is_kind{{"properties", {{"step", {{"const", kind}}}}}, {"required", {"step"}}};
        cases.push_back({{"if", is_kind}, {"then", reference_to(fmt::format("claim-{}", kind))}});
    }
    Json kinds = one_of(step_kind_words(claim_kinds()));
    kinds["description"] = "The kind of step that is claimed about";
    const Json about_step{{"properties", {{"step", std::move(kinds)}}},
                          {"required", {"step"}},
                          {"allOf", std::move(cases)}};
    // A claim with no key yet may become either; an editor offers what stands beside the condition.
    Json schema = open_object_with(picture_keys);
    schema.erase("required");
    schema["if"] = {{"required", {picture_keys.front().name}}};
    schema["then"] = object_with(picture_keys);
    schema["else"] = about_step;
    return schema;
}

/// Rows of marks.
Json picture() {
    const Json row{{"type", "string"}, {"pattern", fmt::format("^[{}]+$", picture_marks)}};
    return {{"type", "array"}, {"minItems", 1}, {"items", row}};
}

/// True if there is a field that holds a list of values of a form.
bool is_listed(std::string_view form) {
    for (const std::string_view kind : claim_kinds())
        for (const ClaimField& field : claim_fields_of(*step_kind_named(kind)))
            if (field.is_list && form_of(field) == form)
                return true;
    return false;
}

/// The values of a form: by themselves, in fields that may be left open, and in lists, or lists of lists, of which
/// each may be.
void define_values(Json& definitions, const std::string& form, Json value) {
    const std::string claimed = "claimed-" + form;
    const std::string values = "values-of-" + form;
    definitions[form] = std::move(value);
    definitions[claimed] = either(reference_to(form), open());
    if (!is_listed(form))
        return;
    definitions[values] = {{"type", "array"},
                           {"minItems", 1},
                           {"items", either(reference_to(claimed), reference_to(values))}};
    definitions["list-of-" + form] = either(reference_to(values), open());
}

} // namespace

std::string claims_schema() {
    Json schema = schema_titled("Claims about a scene of rastertrace",
                                "What somebody worked out by hand, for `rastertrace check`");
    schema.update(object_with(claims_keys));

    Json definitions;
    definitions["text"] = text_schema();
    definitions["round"] = one_of(round_words);
    definitions["claims"] = list_of("claim");
    definitions["claim"] = claim();
    definitions["picture"] = picture();
    for (const std::string_view kind : claim_kinds())
        definitions[fmt::format("claim-{}", kind)] = schema_of_claim(kind);

    // Values are read as text, so what is no string may be one, and the other way round.
    define_values(definitions, "whole", either({{"type", "integer"}}, quoted_number()));
    define_values(definitions, "number", number_schema());
    define_values(definitions, "boolean", {{"enum", {true, false, "true", "false"}}});
    define_values(definitions, "color", color_schema(any_alpha));
    define_values(definitions, "name",
                  {{"type", {"string", "number", "boolean"}}, {"minLength", 1}});
    schema["definitions"] = std::move(definitions);
    return schema_text(schema);
}

} // namespace rastertrace
