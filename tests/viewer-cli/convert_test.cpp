// SPDX-License-Identifier: MIT
// `rastertrace convert` and `trace --flat` as a user calls them. Rows are compared with the trace as another reader of
// JSON has it.

#include "effort.h"
#include "program.h"

#include <gmock/gmock.h>
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

using Json = nlohmann::json;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

/// The fields of a line of a CSV file, whose end is a carriage return.
std::vector<std::string> csv_fields(const std::string& line) {
    std::vector<std::string> fields{""};
    bool is_quoted = false;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const bool is_escape = is_quoted && line.compare(i, 2, "\"\"") == 0;
        if (line[i] == '"' && !is_escape) {
            is_quoted = !is_quoted;
        } else if (line[i] == ',' && !is_quoted) {
            fields.emplace_back();
        } else {
            fields.back() += line[i];
            i += is_escape ? 1 : 0;
        }
    }
    EXPECT_TRUE(!is_quoted && line.ends_with('\r')) << line;
    return fields;
}

/// True if no double is nearer to the fraction.
bool is_nearest(double value, const mpq_class& fraction) {
    const mpq_class distance = abs(mpq_class(value) - fraction);
    const double infinity = std::numeric_limits<double>::infinity();
    return distance <= abs(mpq_class(std::nextafter(value, infinity)) - fraction) &&
           distance <= abs(mpq_class(std::nextafter(value, -infinity)) - fraction);
}

/// True if a value, or each value of a list, is the number that the trace has there as the nearest double.
bool is_number_of(const Json& value, const Json& traced) {
    if (traced.is_array()) {
        if (!value.is_array() || value.size() != traced.size())
            return false;
        for (std::size_t i = 0; i < traced.size(); ++i)
            if (!is_number_of(value[i], traced[i]))
                return false;
        return true;
    }
    if (traced.is_string())
        return value.is_number() &&
               is_nearest(value.get<double>(), mpq_class(traced.get<std::string>()));
    return value == traced;
}

/// True if a value is a string, and so is what it holds, a number as no JSON number.
bool has_text(const Json& value) {
    if (value.is_array())
        return std::any_of(value.begin(), value.end(), has_text);
    return value.is_string() || value.is_null();
}

/// A program that is started counts the memory of the one that starts it: a suite of its own has little.
class ConvertMemoryTest : public ProgramTest {};

TEST_F(ConvertMemoryTest, DoesNotGrowWithTheTrace) {
    if (is_sanitized)
        GTEST_SKIP() << "the sanitizer needs memory of its own";
    write("scene.json", R"({"canvas":{"width":800,"height":800},"method":{"fill":"barycentric"},
                            "vertices":{"A":[-390,-390],"B":[390,-390],"C":[0,390]},
                            "triangles":["ABC"]})");
    shell("$rastertrace trace scene.json -o large.jsonl");
    ASSERT_GT(fs::file_size(folder_ / "large.jsonl"), 70'000'000u);
    for (const std::string words :
         {"convert large.jsonl --to flat", "convert large.jsonl --to jsonl",
          "convert large.jsonl --to csv", "trace scene.json --flat"})
        EXPECT_LT(shell("$rastertrace " + words + " -o out").peak_memory, 48'000'000) << words;
}

class ConvertTest : public ProgramTest {
protected:
    ConvertTest() {
        const auto lines = lines_of(shell("$rastertrace convert --columns").out);
        for (std::size_t i = 1; i < lines.size(); ++i) {
            const auto column = csv_fields(lines[i]);
            names_.push_back(column[0]);
            types_[column[0]] = column[1];
        }
    }

    bool is_of_type(const Json& value, const std::string& column) const {
        const auto type = types_.find(column);
        if (type == types_.end())
            return false;
        return type->second == "BIGINT"    ? value.is_number_integer()
               : type->second == "DOUBLE"  ? value.is_number()
               : type->second == "BOOLEAN" ? value.is_boolean()
                                           : value.is_string();
    }

    /// Compares a row with step n of a trace, whose primitive is `in`; no name of our own has an exact text.
    void expect_row(Json row, std::size_t n, const Json& in, const Json& step) const {
        for (const auto& [column, value] : row.items())
            EXPECT_TRUE(is_of_type(value, column)) << column << ": " << value;
        const auto take = [&row](const std::string& column) {
            const Json value = row.contains(column) ? row[column] : Json();
            row.erase(column);
            return value;
        };
        EXPECT_EQ(take("flat"), 1);
        EXPECT_EQ(take("n"), n);
        EXPECT_EQ(take("in"), in);
        for (const auto& [field, traced] : step.items()) {
            const std::string column = field + (traced.is_array() ? "_list" : "");
            Json value = take(column);
            if (traced.is_array())
                value = Json::parse(value.get<std::string>());
            if (!types_.contains(column + "_exact")) {
                EXPECT_EQ(value, traced) << field;
                continue;
            }
            EXPECT_TRUE(is_number_of(value, traced)) << field << ": " << value << " of " << traced;
            const Json exact = take(column + "_exact");
            EXPECT_EQ(exact, !has_text(traced)    ? Json()
                             : traced.is_string() ? traced
                                                  : Json(traced.dump()));
        }
        EXPECT_TRUE(row.empty()) << row;
    }

    /// The same for a record of a CSV file and a row of JSON Lines.
    void expect_record(const std::vector<std::string>& record, const Json& row) const {
        ASSERT_EQ(record.size(), names_.size());
        for (std::size_t i = 0; i < record.size(); ++i) {
            if (!row.contains(names_[i])) {
                EXPECT_EQ(record[i], "") << names_[i];
                continue;
            }
            const Json& value = row[names_[i]];
            EXPECT_EQ(value.is_string() ? Json(record[i]) : Json::parse(record[i]), value);
        }
    }

    std::vector<std::string> names_;
    std::map<std::string, std::string> types_; ///< in SQL, by column
};

TEST_F(ConvertTest, EveryStepOfEveryExampleHasItsRow) {
    std::size_t traces = 0;
    for (const auto& entry : fs::recursive_directory_iterator(RASTERTRACE_EXAMPLES)) {
        if (entry.path().extension() != ".json")
            continue;
        for (const std::string scalar : {"float", "double", "fixed", "adaptive", "exact"}) {
            SCOPED_TRACE(entry.path().string() + " " + scalar);
            const Outcome outcome = shell(
                "scene='" + entry.path().string() + "'; options='--frame 1 --scalar " + scalar +
                "'; $rastertrace trace $scene $options -o t.json 2>no-scene || exit 9; "
                "$rastertrace convert t.json --to jsonl -o t.jsonl && "
                "$rastertrace trace $scene $options --flat -o flat.jsonl && "
                "$rastertrace convert t.jsonl --to flat | cmp - flat.jsonl && "
                "$rastertrace convert - --to csv <t.jsonl >flat.csv");
            if (outcome.status == 9)
                continue; // no scene, or none that is drawn in such numbers
            ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
            ++traces;
            const auto steps = lines_of(content("t.jsonl"));
            const auto rows = lines_of(content("flat.jsonl"));
            const auto records = lines_of(content("flat.csv"));
            ASSERT_EQ(rows.size(), steps.size() - 2);
            ASSERT_EQ(records.size(), rows.size() + 1);
            EXPECT_EQ(csv_fields(records.front()), names_);
            // Of a long trace, only some steps are looked into.
            const std::size_t every = 1 + rows.size() / 5000;
            Json in;
            for (std::size_t n = 1; n <= rows.size() && !HasFailure(); ++n) {
                if (steps[n].starts_with(R"({"step":"primitive")"))
                    in = Json::parse(steps[n])["name"];
                EXPECT_THAT(rows[n - 1],
                            StartsWith("{\"flat\":1,\"n\":" + std::to_string(n) + "," +
                                       (in.is_null() ? "" : "\"in\":" + in.dump() + ",") +
                                       "\"step\":"));
                if (n % every != 0)
                    continue;
                const Json row = Json::parse(rows[n - 1]);
                expect_row(row, n, in, Json::parse(steps[n]));
                expect_record(csv_fields(records[n]), row);
            }
        }
    }
    EXPECT_GT(traces, 250u);
}

/// What a foreign rasterizer has put in, or written in its own way.
TEST_F(ConvertTest, WhatNobodyKnowsIsInOther) {
    write("foreign.jsonl",
          R"({"rastertrace":1,"canvas":{"width":9,"height":9}}
{"step":"primitive", "kind":"triangle","name":"=A\"é","code":"raster.cpp:1"}
{"step":"depth","x":1,"y":2,"depth":"NaN","stored":null,"pass":true,"z":[1, "a"]}
{"step":"pixel","x":1,"y":2,"depth":"1/3","inside":[true],"mine":"\u001b\""}
{"x":3,"y":"4","step":"shaded"}
{"end":{}}
)");
    const Outcome flat = shell("$rastertrace convert foreign.jsonl --to flat");
    EXPECT_EQ(flat.status, 0);
    EXPECT_THAT(flat.err, HasSubstr("NaN")) << "said as by stats";
    EXPECT_EQ(
        flat.out,
        R"({"flat":1,"n":1,"in":"=A\"é","step":"primitive","name":"=A\"é","kind":"triangle","code":"raster.cpp:1"}
{"flat":1,"n":2,"in":"=A\"é","step":"depth","x":1,"y":2,"depth_exact":"NaN","stored_exact":"null","pass":true,"other":"{\"z\":[1, \"a\"]}"}
{"flat":1,"n":3,"in":"=A\"é","step":"pixel","inside_list":"[true]","x":1,"y":2,"depth":0.3333333333333333,"depth_exact":"1/3","other":"{\"mine\":\"\\u001b\\\"\"}"}
{"flat":1,"n":4,"in":"=A\"é","step":"shaded","x":3,"other":"{\"y\":\"4\"}"}
)");
    // What a spreadsheet would run is text.
    const auto records = lines_of(shell("$rastertrace convert foreign.jsonl --to csv").out);
    EXPECT_EQ(csv_fields(records[1])[2], "'=A\"\u00e9");
    EXPECT_EQ(csv_fields(records[4]).back(), R"({"y":"4"})");
}

TEST_F(ConvertTest, ItDoesNotMatterHowTheTraceIsLaidOut) {
    EXPECT_EQ(shell("scene=$examples/t0-hidden/cube-culled.json; "
                    "$rastertrace trace $scene -o t.json; $rastertrace trace $scene -o t.jsonl; "
                    "tr '\\n' ' ' <t.json >one-line.json; $rastertrace trace $scene --flat >flat; "
                    "for from in $scene t.json t.jsonl one-line.json; do "
                    "$rastertrace convert $from --to jsonl | cmp - t.jsonl && "
                    "$rastertrace convert $from --to flat | cmp - flat || exit 1; done; "
                    "$rastertrace trace t.json --flat | cmp - flat && "
                    "$rastertrace trace $scene --only face,pixel >part.json && "
                    "$rastertrace trace part.json --flat >part && "
                    "$rastertrace trace $scene --only face,pixel --flat | cmp - part")
                  .status,
              0);
}

TEST_F(ConvertTest, APackedTraceIsTheSameAndIsPackedAgain) {
    EXPECT_EQ(
        shell("$rastertrace trace $examples/t0-hidden/cube-painter.json -o t.jsonl.zst && "
              "$rastertrace convert t.jsonl.zst --to flat -o flat.jsonl.gz && "
              "$rastertrace trace $examples/t0-hidden/cube-painter.json --flat -o same.jsonl.gz && "
              "$rastertrace convert t.jsonl.zst --to flat >flat.jsonl && "
              "cmp flat.jsonl.gz same.jsonl.gz && gzip -dc flat.jsonl.gz | cmp - flat.jsonl")
            .status,
        0);
}

TEST_F(ConvertTest, AFaultIsToldAsByOtherCommandsAndNoFileIsLeft) {
    shell("$rastertrace trace $examples/t0-fill/first-triangle.json -o whole.jsonl; "
          "head -n 20 whole.jsonl >cut.jsonl; "
          "sed '9s/\"y\":[0-9]*/\"y\":\"?\"/' whole.jsonl >damaged.jsonl; "
          "sed 's/\"steps\":62/\"steps\":63/' whole.jsonl >miscounted.jsonl; "
          "echo '{\"x\"' >broken.json; echo 'x=1' >claims.txt");
    for (const std::string name : {"none.jsonl", "cut.jsonl", "damaged.jsonl", "miscounted.jsonl",
                                   "broken.json", "claims.txt"}) {
        const std::string told = shell("$rastertrace stats " + name).err;
        EXPECT_THAT(told, StartsWith("rastertrace: " + name)) << name;
        for (const std::string form : {"flat", "csv", "jsonl"}) {
            const Outcome refused = shell("$rastertrace convert " + name + " --to " + form +
                                          " -o out; s=$?; "
                                          "test ! -e out && exit $s");
            EXPECT_EQ(refused.status, 2) << name;
            EXPECT_EQ(refused.err, told) << form;
        }
    }
    const auto refusal = [this](const std::string& words) {
        const Outcome outcome = shell("$rastertrace " + words);
        EXPECT_EQ(outcome.status, 2) << words;
        return outcome.err;
    };
    EXPECT_EQ(refusal("convert whole.jsonl --to cvs"),
              "rastertrace: --to: expected one of csv, jsonl, flat, found \"cvs\"\n"
              "hint: did you mean csv?\n");
    EXPECT_EQ(refusal("convert whole.jsonl"),
              "rastertrace: convert: expected --to csv, --to jsonl, --to flat, found none\n");
    EXPECT_THAT(refusal("convert"), StartsWith("rastertrace: convert: expected a trace"));
    EXPECT_THAT(refusal("convert x --columns"), HasSubstr("--columns: expected no trace"));
    EXPECT_THAT(refusal("convert whole.jsonl --to csv --fill fan"), HasSubstr("--fill fan"));
    EXPECT_THAT(refusal("trace whole.jsonl --flat --format json"), HasSubstr("--format"));
}

} // namespace
} // namespace rastertrace
