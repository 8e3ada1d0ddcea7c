// SPDX-License-Identifier: MIT
// `rastertrace review`: what waits beside goldens is accepted, left or seen.

#include "program.h"

#include <gmock/gmock.h>

#include <string>

namespace rastertrace {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class ReviewTest : public ProgramTest {
protected:
    ReviewTest() {
        shell("mkdir 'my goldens'; cd 'my goldens';"
              "$rastertrace trace $examples/t0-fill/first-triangle.json -o one.golden.jsonl;"
              "cp one.golden.jsonl two.golden.jsonl; cp one.golden.jsonl cut.golden.jsonl;"
              "$rastertrace trace $examples/t0-fill/first-triangle.json --rounding truncate -o "
              "one.golden.new.jsonl;"
              "cp one.golden.new.jsonl two.golden.new.jsonl; head -9 one.golden.new.jsonl > "
              "cut.golden.new.jsonl");
    }
    Outcome review(const std::string& answers) const {
        return shell("printf '" + answers + "' | $rastertrace review 'my goldens'");
    }
};

TEST_F(ReviewTest, EachIsAcceptedOrLeft) {
    const std::string before = content("my goldens/two.golden.jsonl");
    const std::string now = content("my goldens/one.golden.new.jsonl");
    const Outcome told = review("a\\nl\\ns\\na\\nl\\n");
    EXPECT_EQ(told.status, 1);
    EXPECT_THAT(told.out, AllOf(HasSubstr("1 of 3: my goldens/cut.golden.jsonl\n"),
                                HasSubstr("cannot be accepted: my goldens/cut.golden.new.jsonl"),
                                HasSubstr("the first difference, in ABC"),
                                HasSubstr("accepted 1, left 2\n")));
    EXPECT_EQ(content("my goldens/one.golden.jsonl"), now);
    EXPECT_EQ(content("my goldens/two.golden.jsonl"), before);
    EXPECT_FALSE(fs::exists(folder_ / "my goldens/one.golden.new.jsonl"));
    EXPECT_TRUE(fs::exists(folder_ / "my goldens/two.golden.new.jsonl"));
}

TEST_F(ReviewTest, WhatBreaksOffIsNeverAccepted) {
    const std::string before = content("my goldens/cut.golden.jsonl");
    review("a\\na\\na\\na\\na\\na\\na\\na\\n");
    EXPECT_EQ(content("my goldens/cut.golden.jsonl"), before);
}

TEST_F(ReviewTest, TheEndOfTheInputLeavesTheRest) {
    EXPECT_EQ(review("").status, 1);
    EXPECT_THAT(review("").out, HasSubstr("accepted 0, left 3\n"));
    shell("rm my*/*.new.jsonl");
    EXPECT_EQ(review("").status, 0);
    EXPECT_EQ(review("").out, "no golden has changed\n");
    EXPECT_EQ(shell("$rastertrace review nowhere").status, 3);
}

} // namespace
} // namespace rastertrace
