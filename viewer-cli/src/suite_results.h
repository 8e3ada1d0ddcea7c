// SPDX-License-Identifier: MIT
#pragma once

// What came of the cases of a suite, in each of its formats. Nothing in it depends on the machine, on the time, or on how
// many cases ran at once.
//
//     print(suite_text(merged(shards)));

#include <rastertrace/trace/text/json_document.h>
#include <rastertrace/trace/text/problem.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// What came of one case.
struct SuiteResult {
    enum class Outcome : std::uint8_t {
        passed,
        failed,
        left_out ///< the file turned out to be no scene, trace or claims
    };
    std::string name{}; ///< its file, as a path from the folder, safe to print
    Outcome outcome = Outcome::passed;
    std::string message{}; ///< why it failed, in a line
    std::string text{};    ///< and all that there is to be said of it
};

/// A part of a suite: of all its cases by name, every `count`th one, from this number on.
struct Shard {
    std::size_t number = 1;
    std::size_t count = 1;
};

/// "1/2"; nothing of any other text, or where no such shard can be.
std::optional<Shard> shard_named(std::string_view text);

struct SuiteResults {
    Shard shard{};
    std::vector<SuiteResult> cases{}; ///< by name

    std::size_t count(SuiteResult::Outcome outcome) const;
};

/// Puts the shards of a suite together, in any order. Throws a Problem if one is missing, or is there twice.
SuiteResults merged(std::vector<SuiteResults> shards);

/// Reads what suite_json has written. Throws a Problem.
SuiteResults read_suite_results(const Source& source);

/// A result as an object in one line, and one read again. Throws a Problem.
std::string result_json(const SuiteResult& result);
SuiteResult read_result(const Source& source, const JsonValue& value);

/// The cases that failed, and how many passed.
std::string suite_text(const SuiteResults& results);
std::string suite_json(const SuiteResults& results);
std::string suite_markdown(const SuiteResults& results);
std::string suite_junit(const SuiteResults& results);

/// The formats, in the order of the help.
struct SuiteFormat {
    std::string_view name;
    std::string (*write)(const SuiteResults& results);
};
inline constexpr std::array suite_formats{
    SuiteFormat{"text", suite_text}, SuiteFormat{"json", suite_json},
    SuiteFormat{"markdown", suite_markdown}, SuiteFormat{"junit", suite_junit}};

} // namespace rastertrace
