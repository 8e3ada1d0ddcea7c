// SPDX-License-Identifier: MIT
// `rastertrace exercise` as a teacher and a grader meet it.

#include "program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace rastertrace {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class ExerciseTest : public ProgramTest {};

TEST_F(ExerciseTest, TheGraderNeedsOnlyTheSeed) {
    ASSERT_EQ(shell("$rastertrace exercise --kind scanline --seed anna -o anna").status, 0);
    EXPECT_EQ(shell("$rastertrace exercise --kind scanline --seed anna").out,
              content("anna/scene.json"));
    EXPECT_THAT(content("anna/sheet.txt"), StartsWith("# exercise 1:anna\n"));
    EXPECT_THAT(content("anna/picture.svg"), StartsWith("<svg"));
    const Outcome marked = shell("$rastertrace exercise --kind scanline --seed 1:anna | "
                                 "$rastertrace check - anna/sheet.txt");
    EXPECT_EQ(marked.status, 0);
    EXPECT_THAT(marked.out, StartsWith("0 right, 0 wrong, "));
}

TEST_F(ExerciseTest, AClassHasAFolderForEachSeed) {
    const Outcome made =
        shell("$rastertrace exercise --kind bresenham --seed class --count 3 -o .");
    EXPECT_EQ(made.status, 0) << made.err;
    EXPECT_THAT(made.out, HasSubstr("written: ./class-3\n"));
    EXPECT_NE(content("class-1/scene.json"), content("class-2/scene.json"));
    EXPECT_EQ(shell("$rastertrace exercise --kind bresenham --seed class-2").out,
              content("class-2/scene.json"));
}

TEST_F(ExerciseTest, BadInputIsToldInPlainWords) {
    EXPECT_THAT(shell("$rastertrace exercise --seed anna").err, HasSubstr("[--like,--kind]"));
    EXPECT_THAT(shell("$rastertrace exercise --kind line --seed anna").err,
                HasSubstr("--kind: expected one out of scanline, bresenham, "));
    EXPECT_THAT(shell("$rastertrace exercise --kind scanline --seed 2:anna").err,
                HasSubstr("expected an ID of version 1, found one of version \"2\""));
    EXPECT_EQ(shell("$rastertrace exercise --kind scanline --seed anna --count 3").status, 2);
}

} // namespace
} // namespace rastertrace
