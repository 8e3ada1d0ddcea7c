// SPDX-License-Identifier: MIT
// `rastertrace plan` as a user calls it: the stages that are needed, and why.

#include "program.h"

#include <string>

namespace rastertrace {
namespace {

TEST_F(ProgramTest, PlanSaysWhichStagesAreNeededAndWhy) {
    EXPECT_EQ(run("plan $examples/t4-pipeline/camera-points.json").out,
              "Three points seen by T4's camera\n"
              "stage        plan      why; what it saves\n"
              "model        left out  no model moves anything; saves 4 steps\n"
              "view         kept      the camera moves the world\n"
              "clip near    kept      1 vertex lies outside it\n"
              "clip left    kept      1 vertex lies outside it\n"
              "clip right   kept      1 vertex lies outside it\n"
              "clip bottom  kept      1 vertex lies outside it\n"
              "clip top     kept      1 vertex lies outside it\n"
              "divide       kept      w is not 1 at every vertex\n"
              "order        left out  the method has no painter\n"
              "cull         left out  the method does not ask for it\n"
              "light        left out  the method does not ask for it\n"
              "canvas       left out  no triangle is filled\n"
              "depth        left out  the method has no depth buffer\n"
              "perspective  left out  no colors are mixed in a perspective\n"
              "colors       left out  no colors are mixed\n");
    const std::string triangle = "$examples/t0-fill/first-triangle.json";
    EXPECT_THAT(run("plan --full " + triangle).out,
                HasSubstr("model        kept      asked to be kept; no model moves anything\n"));
    EXPECT_THAT(
        run("plan --json --keep divide " + triangle).out,
        HasSubstr(R"({"stage":"divide","kept":true,"why":"asked to be kept; w is 1 at every )"
                  R"(vertex","saves":{"bytes":0,"steps":0,"pixels":0}})"));
    EXPECT_THAT(run("show " + triangle + " --rounding truncate --full").out,
                EndsWith("\nstages: model, view, divide, canvas\n"));
    EXPECT_THAT(run("plan --keep dept " + triangle),
                Refused("rastertrace: --keep: expected stages out of "
                        "model,view,clip,divide,order,cull,light,canvas,depth,perspective,colors, "
                        "found \"dept\"\nhint: did you mean depth?\n"));
    EXPECT_THAT(run("trace --primitive ABD " + triangle),
                Refused(HasSubstr("expected a primitive of the scene, found ABD\n"
                                  "hint: did you mean ABC?\n")));
}

} // namespace
} // namespace rastertrace
