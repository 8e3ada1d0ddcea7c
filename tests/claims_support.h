// SPDX-License-Identifier: MIT
#pragma once

// Claims held against a scene, in a test.
//
//     const Checked checked = check_claims(scene_text, "y=2: 1/4, 25/8\n");

#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/check/claims.h>
#include <rastertrace/trace/text/problem.h>

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

/// The text of a file in examples/.
inline std::string example_text(const std::string& name) {
    std::ifstream file(std::string(RASTERTRACE_EXAMPLES) + "/" + name);
    EXPECT_TRUE(file) << name;
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Claims that can be read.
inline Claims claims_in(const std::string& text) {
    auto read = read_claims({"claims", text});
    if (!read) {
        ADD_FAILURE() << to_text(read.problem());
        return {};
    }
    return std::move(read.value());
}

inline Checked check_claims(const std::string& scene, const std::string& claims,
                            const MethodOverrides& method = {}) {
    return check(Truth({"scene.json", scene}, method), claims_in(claims));
}

/// What is wrong with claims that cannot be held against a scene.
inline std::string problem_of_claims(const std::string& scene, const std::string& claims) {
    try {
        check_claims(scene, claims);
    } catch (const Problem& problem) {
        return to_text(problem);
    }
    return "no problem";
}

/// The names of a field's likely slips, the likeliest first.
inline std::vector<std::string> slip_names(const CheckedField& field) {
    std::vector<std::string> names;
    for (const LikelySlip& slip : field.slips)
        names.push_back(slip.name);
    return names;
}

} // namespace rastertrace
