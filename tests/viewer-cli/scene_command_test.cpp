// SPDX-License-Identifier: MIT
// `rastertrace scene`, as a user calls it, and other commands with scenes in other forms.

#include "program.h"

#include <gtest/gtest.h>

#include <string>

namespace rastertrace {
namespace {

class SceneCommandTest : public ProgramTest {
protected:
    SceneCommandTest() {
        write("course.txt",
              "png 9 7 a.png\nxyzw -1 -1 0 1\nxyzw 1 -1 0 1\nxyzw 0 1 0 1\ntri 1 2 3\n");
        write("shapes.svg",
              "<svg width=\"9\" height=\"7\"><polygon points=\"1 1 8 2 4 6\"/></svg>\n");
        write("model.obj", "v -1 -1 0 1\nv 1 -1 0 2\nv 0 1 0\nf 1 2 3\n");
    }
};

/// What it prints is drawn as the file is.
TEST_F(SceneCommandTest, PrintsASceneThatIsDrawnAlike) {
    for (const std::string file : {"course.txt", "shapes.svg", "model.obj"}) {
        const Outcome alike =
            shell("$rastertrace trace " + file + " > one; $rastertrace scene " + file +
                  " > scene.json; $rastertrace trace scene.json > other; cmp one other; "
                  "$rastertrace scene - < " +
                  file + " | cmp - scene.json");
        EXPECT_EQ(alike.out + alike.err, "") << file;
        EXPECT_EQ(alike.status, 0) << file;
    }
}

TEST_F(SceneCommandTest, RefusesWhatIsNoScene) {
    write("text", "once upon a time\n");
    EXPECT_EQ(shell("$rastertrace scene text").status, 2);
    const Outcome faulty = shell("sed -i s/8/x/ shapes.svg; $rastertrace show shapes.svg");
    EXPECT_EQ(faulty.status, 2);
    EXPECT_EQ(faulty.err.substr(0, faulty.err.find('\n')),
              "rastertrace: shapes.svg:1:48: expected a number, found \"x\"");
}

} // namespace
} // namespace rastertrace
