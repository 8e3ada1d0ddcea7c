// SPDX-License-Identifier: MIT
// The schemas of docs/, and what `$schema` does in a file. tests/schema holds the schemas against the readers.

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/check/claims.h>
#include <rastertrace/trace/check/schema.h>
#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/method_names.h>

#include "random_choice.h"
#include "random_scene.h"
#include "traces.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <variant>

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

TEST(Schema, ThoseOfTheDocsAreWhatTheProgramWrites) {
    for (const SchemaKind kind : schema_kinds) {
        const std::string name = std::string(name_of(kind));
        std::ostringstream text;
        text << std::ifstream(std::string(RASTERTRACE_EXAMPLES) + "/../docs/" + name +
                              ".schema.json")
                    .rdbuf();
        // Not EXPECT_EQ, which would print both.
        EXPECT_TRUE(text.str() == schema_of(kind)) << "to renew it: rastertrace validate --schema "
                                                   << name << " > docs/" << name << ".schema.json";
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

TEST(Schema, HasEveryStepAndEveryChoiceOfTheMethod) {
    const Json steps = Json::parse(schema_of(SchemaKind::trace))["definitions"];
    for (const std::string_view name : step_kind_names())
        for (const StepField& field : fields_of(*step_kind_named(name)))
            EXPECT_TRUE(steps["step-" + std::string(name)]["properties"].contains(field.name))
                << name << " " << field.name;
    const Json scene = Json::parse(schema_of(SchemaKind::scene))["definitions"];
    for (const MethodKey& key : method_keys()) {
        const Json& choice = key.name == "convention"
                                 ? scene["convention"]
                                 : scene["method"]["properties"][std::string(key.name)];
        EXPECT_NE(choice.dump().find("\"" + std::string(key.values.back()) + "\""),
                  std::string::npos)
            << key.name;
    }
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
