// SPDX-License-Identifier: MIT
// The table of step kinds is what the writer writes, the describer says and the documentation tells.

#include "random_scene.h"
#include "traces.h"

#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/tell/describe.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <set>
#include <string>

namespace rastertrace {
namespace {

bool has_type(const nlohmann::ordered_json& value, FieldType type) {
    switch (type) {
    case FieldType::whole:
        return value.is_number_integer();
    case FieldType::quantity:
        return value.is_number() || value.is_string() || value.is_null();
    case FieldType::string:
        return value.is_string();
    case FieldType::boolean:
        return value.is_boolean();
    case FieldType::list:
        break;
    }
    return value.is_array();
}

/// A step has the fields of its row, in that order, and the required ones.
void expect_row(const StepView& step) {
    const auto known = fields_of(*step.kind());
    const auto json = nlohmann::ordered_json::parse(step.json());
    auto next = known.begin();
    for (const auto& [key, value] : json.items()) {
        if (key == "step")
            continue;
        next = std::find_if(next, known.end(),
                            [&key = key](const StepField& field) { return field.name == key; });
        ASSERT_NE(next, known.end()) << key << " in " << step.json();
        EXPECT_TRUE(has_type(value, next->type)) << key << " in " << step.json();
        ++next;
    }
    for (const StepField& field : known)
        EXPECT_TRUE(!field.is_required() || json.contains(field.name)) << field.name;
}

TEST(StepKinds, AreWrittenAndDescribedAsTheTableSays) {
    std::set<StepKind> met;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        const auto read = read_scene({"scene.json", RandomScene(seed).text()});
        if (!read)
            continue;
        const Trace trace = trace_of(read.value().scene);
        Replay replay(trace);
        for (std::size_t n = 1; n <= trace.size(); ++n) {
            const StepView step = trace.step(n);
            expect_row(step);
            replay.go_to(n);
            EXPECT_THAT(
                describe_step(replay),
                testing::Not(testing::AnyOf(testing::HasSubstr("{"), testing::HasSubstr("@"))));
            met.insert(*step.kind());
        }
    }
    EXPECT_EQ(met.size(), step_kinds);
}

TEST(StepKinds, EveryPlaceholderOfTheirSentencesIsKnown) {
    for (std::size_t i = 0; i < step_kinds; ++i) {
        const StepRow& row = row_of(static_cast<StepKind>(i));
        for (const Language language : {Language::english, Language::portuguese})
            EXPECT_EQ(unknown_placeholder(row.sentence.in(language), row), "") << name_of(row.kind);
    }
    const StepRow& face = row_of(StepKind::face);
    EXPECT_EQ(unknown_placeholder("{normal} {@cosine} {#name} {culled?no:yes}", face), "");
    EXPECT_EQ(unknown_placeholder("{normal} {@cosin} {view}", face), "@cosin");
    EXPECT_EQ(unknown_placeholder("{normal} {views}", face), "views");
    EXPECT_EQ(unknown_placeholder("{#nam}", face), "#nam");
    EXPECT_EQ(unknown_placeholder("{cull?no:yes}", face), "cull?no:yes");
    EXPECT_EQ(unknown_placeholder("{culled?no}", face), "culled?no");
}

TEST(StepKinds, HaveTheirRowsAndNames) {
    const auto names = step_kind_names();
    ASSERT_EQ(names.size(), step_kinds);
    for (std::size_t i = 0; i < step_kinds; ++i) {
        const auto kind = static_cast<StepKind>(i);
        EXPECT_EQ(row_of(kind).kind, kind) << names[i];
        EXPECT_EQ(step_kind_named(names[i]), kind) << names[i];
    }
}

/// The rows of a Markdown table under a heading that begin with `name`, and those that go on with it.
std::string rows_of(const std::string& name, std::istream& document, const std::string& heading) {
    std::string line;
    std::string rows;
    bool is_under = false;
    bool is_row = false;
    while (std::getline(document, line)) {
        if (line.starts_with("## "))
            is_under = line == "## " + heading;
        if (!is_under || !line.starts_with("|"))
            continue;
        const std::string first = line.substr(0, line.find('|', 1));
        if (first.find_first_not_of("| ") != std::string::npos)
            is_row = first.find('`' + name + '`') != std::string::npos;
        if (is_row)
            rows += line + '\n';
    }
    return rows;
}

TEST(StepKinds, AreDocumented) {
    const std::string path = RASTERTRACE_EXAMPLES "/../docs/trace-format.md";
    for (const std::string_view name : step_kind_names()) {
        const StepRow& row = row_of(*step_kind_named(name));
        std::ifstream document(path);
        ASSERT_TRUE(document);
        const std::string told = rows_of(std::string(name), document, "Steps");
        EXPECT_THAT(told, testing::HasSubstr(std::string(row.fires))) << name;
        for (const StepField& field : fields_of(row.kind))
            EXPECT_THAT(told, testing::HasSubstr('`' + std::string(field.name) + '`')) << name;
    }
}

} // namespace
} // namespace rastertrace
