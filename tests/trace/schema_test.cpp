// SPDX-License-Identifier: MIT
// The schemas of docs/, and what `$schema` does in a file. tests/schema holds the schemas against the readers.

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/check/claim_fields.h>
#include <rastertrace/trace/check/claims.h>
#include <rastertrace/trace/check/claims_keys.h>
#include <rastertrace/trace/check/schema.h>
#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/scene/scene_keys.h>
#include <rastertrace/trace/text/canvas_json.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/pipeline_names.h>
#include <rastertrace/trace/text/stage_name.h>

#include "random_choice.h"
#include "random_scene.h"
#include "traces.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <regex>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {
namespace {

using Json = nlohmann::json;

/// Calls `visit` with every object in a JSON value.
template <typename Visit> void for_each_object(const Json& value, Visit&& visit) {
    if (value.is_object())
        visit(value);
    if (value.is_structured())
        for (const Json& inside : value)
            for_each_object(inside, visit);
}

TEST(Schema, ThoseOfTheDocsAreWhatTheProgramPrints) {
    for (const SchemaKind kind : schema_kinds) {
        const std::string name = std::string(name_of(kind));
        std::ostringstream text;
        text << std::ifstream(std::string(RASTERTRACE_EXAMPLES) + "/../docs/" + name +
                              ".schema.json")
                    .rdbuf();
        // Not EXPECT_EQ, which would print both.
        EXPECT_TRUE(text.str() == schema_of(kind)) << name;
    }
}

TEST(Schema, EveryReferenceLeadsToADefinitionAndEveryDefinitionIsUsed) {
    for (const SchemaKind kind : schema_kinds) {
        const Json schema = Json::parse(schema_of(kind));
        std::set<std::string> used;
        for_each_object(schema, [&used](const Json& object) {
            if (object.contains("$ref") && object["$ref"].is_string())
                used.insert(object["$ref"].get<std::string>());
        });
        std::set<std::string> defined;
        for (const auto& [name, definition] : schema["definitions"].items())
            defined.insert("#/definitions/" + name);
        EXPECT_EQ(used, defined) << name_of(kind);
    }
}

TEST(Schema, EveryKeyHasAMeaning) {
    const Json schema = Json::parse(schema_of(SchemaKind::scene));
    std::size_t keys = 0;
    for_each_object(schema, [&keys](const Json& object) {
        // Where all keys are listed, and not only a condition on some of them.
        if (!object.contains("properties") || !object.contains("additionalProperties"))
            return;
        for (const auto& [key, value] : object["properties"].items()) {
            EXPECT_FALSE(value.value("description", "").empty()) << key;
            ++keys;
        }
    });
    EXPECT_GT(keys, 80U);
}

TEST(Schema, EveryWordHasAMeaning) {
    for (const SchemaKind kind : {SchemaKind::scene, SchemaKind::trace})
        for_each_object(Json::parse(schema_of(kind)), [](const Json& object) {
            if (!object.contains("enum") || object["enum"].front() == "NaN")
                return;
            EXPECT_EQ(object["enum"].size(), object.value("enumDescriptions", Json()).size())
                << object;
            for (const Json& meaning : object.value("enumDescriptions", Json()))
                EXPECT_NE(meaning, "") << object;
        });
}

using Names = std::set<std::string>;

Names names_in(std::span<const std::string_view> names) {
    return {names.begin(), names.end()};
}

/// The keys that an object may have.
Names keys_of(const Json& definition) {
    Names keys;
    EXPECT_EQ(definition.value("additionalProperties", true), false) << definition;
    for (const auto& [key, value] : definition["properties"].items())
        keys.insert(key);
    return keys;
}

/// The words that a value may be.
Names words_of(const Json& definition) {
    Names words;
    for (const Json& word : definition["enum"])
        words.insert(word.is_string() ? word.get<std::string>() : word.dump());
    return words;
}

TEST(Schema, OfScenesHasTheKeysAndWordsThatAreRead) {
    const Json schema = Json::parse(schema_of(SchemaKind::scene));
    const Json& all = schema["definitions"];
    EXPECT_EQ(keys_of(schema), names_in(scene_keys));
    const std::vector<std::pair<Json, std::span<const std::string_view>>> keys{
        {all["canvas"], canvas_keys},
        {all["one-of-triangles"]["anyOf"][1], primitive_keys},
        {all["circle"], keys_around_vertex},
        {all["mesh"], mesh_keys},
        {all["model-step"], model_keys},
        {all["rotate"], rotate_keys},
        {all["shear"], shear_keys},
        {all["camera"]["anyOf"][1], camera_keys},
        {all["viewport"]["anyOf"][1], pixels_keys},
        {all["viewport"]["anyOf"][2], viewport_keys},
        {all["light"], light_keys},
        {all["vary"]["additionalProperties"]["anyOf"][0], range_keys}};
    for (const auto& [definition, known] : keys)
        EXPECT_EQ(keys_of(definition), names_in(known));
    for (const Json& one : all["projection"]["allOf"]) {
        const std::string type = one["if"]["properties"]["type"]["const"];
        EXPECT_EQ(keys_of(one["then"]), names_in(keys_of(*projection_named(type)))) << type;
    }
    const std::vector<std::pair<Json, std::span<const std::string_view>>> words{
        {all["origin"], origin_words()},           {all["draw"], draw_words},
        {all["axis"]["anyOf"][0], axis_words},     {all["z-range"], z_range_words},
        {all["pixel-range"], pixel_range_names()}, {all["viewport-y"], viewport_y_words}};
    for (const auto& [definition, known] : words)
        EXPECT_EQ(words_of(definition), names_in(known));
    EXPECT_EQ(words_of(all["projection-type"]), names_in(projection_names()));
    EXPECT_EQ(words_of(all["stage"]), names_in(stage_names()));
}

TEST(Schema, OfClaimsHasTheFieldsThatAreRead) {
    const Json schema = Json::parse(schema_of(SchemaKind::claims));
    EXPECT_EQ(keys_of(schema), names_in(claims_keys));
    EXPECT_EQ(words_of(schema["definitions"]["round"]), names_in(round_words));
    for (const std::string_view kind : claim_kinds()) {
        Names fields{"step"};
        for (const ClaimField& field : claim_fields_of(*step_kind_named(kind)))
            fields.emplace(field.name);
        EXPECT_EQ(keys_of(schema["definitions"]["claim-" + std::string(kind)]), fields) << kind;
    }
}

TEST(Schema, HasEveryStepAndEveryChoiceOfTheMethod) {
    const Json steps = Json::parse(schema_of(SchemaKind::trace))["definitions"];
    for (const std::string_view name : step_kind_names())
        for (const StepField& field : fields_of(*step_kind_named(name)))
            EXPECT_TRUE(steps["step-" + std::string(name)]["properties"].contains(field.name))
                << name << " " << field.name;
    const Json scene = Json::parse(schema_of(SchemaKind::scene))["definitions"];
    for (const MethodKey& key : method_keys()) {
        Json choice = key.name == "convention"
                          ? scene["convention"]
                          : scene["method"]["properties"][std::string(key.name)];
        if (choice.contains("anyOf")) // or several
            choice = choice["anyOf"][0];
        EXPECT_EQ(words_of(choice), names_in(key.values)) << key.name;
    }
    const Json header = Json::parse(schema_of(SchemaKind::trace))["definitions"]["method"];
    for (const MethodKey& key : method_keys())
        EXPECT_TRUE(header["properties"].contains(key.name)) << key.name;
}

TEST(Schema, ANumberInQuotesHasThePatternThatIsRead) {
    const Json number = Json::parse(schema_of(SchemaKind::scene))["definitions"]["number"];
    const std::regex pattern(number["pattern"].get<std::string>());
    Random random(29);
    int numbers = 0;
    for (int i = 0; i < 20'000; ++i) {
        std::string text;
        for (int length = random.whole(1, 7); length > 0; --length)
            text += random.pick<char>({'0', '1', '5', '-', '+', '.', '/', 'e', 'E', ' '});
        const auto read = parse_number(text);
        const auto* const fault = std::get_if<NumberFault>(&read);
        const bool has_form = fault == nullptr || *fault == NumberFault::too_large ||
                              *fault == NumberFault::too_small;
        EXPECT_EQ(std::regex_search(text, pattern), has_form) << text;
        numbers += has_form ? 1 : 0;
    }
    EXPECT_GT(numbers, 1000);
}

TEST(Schema, IsNamedInASceneAndInClaims) {
    const std::string rest =
        R"("vertices":{"A":[2,5],"B":[-4,-3],"C":[5,-3]},"triangles":["ABC"]})";
    EXPECT_TRUE(read_scene({"scene.json", R"({"$schema":"../docs/scene.schema.json",)" + rest}));
    const auto scene = read_scene({"scene.json", R"({"$schema":5,)" + rest});
    ASSERT_FALSE(scene);
    EXPECT_EQ(to_text(scene.problem()),
              "scene.json:1:12: expected the path of a schema in quotes, found 5\n"
              "{\"$schema\":5,\"vertices\":{\"A\":[2,5],\"B\":[-4,-3],\"C\":...\n"
              "           ^");
    EXPECT_TRUE(read_claims({"claims.json", R"({"$schema":"claims.schema.json","claims":[]})"}));
    EXPECT_FALSE(read_claims({"claims.json", R"({"$schema":null,"claims":[]})"}));
    // Elsewhere it is a key like any other that nobody knows.
    const auto inside = read_scene({"scene.json", R"({"canvas":{"$schema":"x"},)" + rest});
    ASSERT_FALSE(inside);
    EXPECT_EQ(inside.problem().message,
              "expected a key out of width, height, origin, found \"$schema\"");
}

/// Fails for each key of an object that a definition of the schema does not have.
void expect_known_keys(const Json& object, const Json& definition) {
    for (const auto& [key, value] : object.items())
        EXPECT_TRUE(definition["properties"].contains(key))
            << "\"" << key << "\": a new key needs a row";
}

// The schema allows unknown keys in a trace, as readers do; so a key that is written without a row in the tables would
// not be missed otherwise.
TEST(Schema, EveryKeyOfAHeaderAndAnEndThatIsWrittenHasItsRow) {
    const Json definitions = Json::parse(schema_of(SchemaKind::trace))["definitions"];
    const TraceOptions part{
        .layout = TraceLayout::json,
        .filter = {.only = std::vector{StepKind::pixel}, .region = Region{}, .primitive = "T"}};
    std::set<std::string> seen;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const auto read = read_scene({"scene.json", RandomScene(seed).text()});
        if (!read)
            continue;
        for (const TraceOptions& options : {TraceOptions{}, part}) {
            std::string text;
            StringOutput output(text);
            write_trace(read.value().scene, read.value().plan, options, output);
            const Json trace = Json::parse(text);
            expect_known_keys(trace, definitions["document"]);
            for (const Json& stage : trace["stages"])
                expect_known_keys(stage, definitions["stages"]["items"]);
            expect_known_keys(trace["end"], definitions["end"]);
            for (const auto& [key, value] : trace.items())
                seen.insert(key);
        }
    }
    for (const std::string key :
         {"numbers", "projection", "viewport", "only", "region", "primitive"})
        EXPECT_TRUE(seen.contains(key)) << key;
}

} // namespace
} // namespace rastertrace
