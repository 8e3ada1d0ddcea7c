// SPDX-License-Identifier: MIT
// `rastertrace diff`, `check` and `stats` with a picture that another program has drawn.

#include "program.h"

#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

using Rows = std::vector<std::string>;

class DiffPictureTest : public ProgramTest {
protected:
    /// The picture of a scene, as rows.
    Rows rows_of(const std::string& arguments) const {
        Rows rows = split_at(run("show " + arguments + " --bare").out, '\n');
        rows.pop_back();
        return rows;
    }

    void write_rows(const std::string& name, const Rows& rows) const {
        write(name, joined(rows, "\n") + "\n");
    }

    /// A PPM file whose levels are `drawn` where a row has no `.`, else white.
    void write_ppm(const std::string& name, const Rows& rows,
                   const std::array<int, 3>& drawn) const {
        std::string text = fmt::format("P3\n{} {}\n255\n", rows.front().size(), rows.size());
        for (const std::string& row : rows)
            for (const char c : row)
                text += c == '.' ? "255 255 255\n"
                                 : fmt::format("{} {} {}\n", drawn[0], drawn[1], drawn[2]);
        write(name, text);
    }

    const std::string triangle = "$examples/t0-fill/first-triangle.json";
};

TEST_F(DiffPictureTest, TheSameInEveryFormat) {
    const Rows rows = rows_of(triangle);
    write_rows("rows.txt", rows);
    write_ppm("colors.ppm", rows, {0, 0, 0});
    for (const char* const file : {"rows.txt", "colors.ppm"}) {
        EXPECT_THAT(diff(triangle + " " + file), Prints(HasSubstr("the same\n")));
        EXPECT_EQ(diff(std::string(file) + " " + triangle).status, 0);
    }
    EXPECT_THAT(diff(triangle + " colors.ppm").out, HasSubstr("b: what is #ffffff is not drawn\n"));
}

TEST_F(DiffPictureTest, EachPixelThatDiffersIsCountedAndTheFirstExplained) {
    Rows rows = rows_of(triangle);
    rows[5][7] = '.'; // (-1, 2)
    rows[0][0] = '#'; // (-8, 7)
    write_rows("mine.txt", rows);
    EXPECT_THAT(diff(triangle + " mine.txt"),
                Ends(1, AllOf(HasSubstr("the pictures: 1 pixel only in a, 1 pixel only in b\n"),
                              HasSubstr(" 2  .......!####.....\n"), HasSubstr(" 7  ?......"),
                              HasSubstr("pixel (-8, 7): not drawn: ABC does not cover it\n"))));
    // The other way round a is the picture.
    EXPECT_THAT(diff("mine.txt " + triangle).out, HasSubstr(" 2  .......?####.....\n"));
    // As a claim, and by itself.
    EXPECT_THAT(run("check " + triangle + " mine.txt").out,
                HasSubstr("picture: 1 too many, 1 missing"));
    EXPECT_THAT(run("stats mine.txt").out, HasSubstr("pixels      49 of 238 on the canvas"));
}

TEST_F(DiffPictureTest, ColorsMayBeNear) {
    const Rows rows = rows_of(triangle);
    write_ppm("near.ppm", rows, {3, 0, 2});
    EXPECT_THAT(diff(triangle + " near.ppm"),
                Ends(1, HasSubstr("the pictures: 49 pixels in another color\n")));
    EXPECT_EQ(diff("--tolerance pixel.color=2 " + triangle + " near.ppm").status, 1);
    EXPECT_EQ(diff("--tolerance pixel.color=3 " + triangle + " near.ppm").status, 0);
    EXPECT_EQ(diff("--ignore pixel.color " + triangle + " near.ppm").status, 0);
}

TEST_F(DiffPictureTest, AnotherPlaceDirectionOrSampleIsTold) {
    const Rows rows = rows_of(triangle);
    Rows moved = rows;
    for (std::string& row : moved)
        row = row.substr(2) + "..";
    write_rows("moved.txt", moved);
    EXPECT_THAT(diff(triangle + " moved.txt").out,
                HasSubstr("b is a, moved 2 pixels to the left: then nothing differs\n"));
    Rows turned(rows.rbegin(), rows.rend());
    turned.erase(turned.begin());
    turned.push_back(std::string(rows.front().size(), '.'));
    write_rows("turned.txt", turned);
    EXPECT_THAT(diff(triangle + " turned.txt").out,
                HasSubstr("moved 1 pixel down and turned upside down: then nothing differs\n"));
    Rows mirrored = rows;
    for (std::string& row : mirrored)
        std::ranges::reverse(row);
    write_rows("mirrored.txt", mirrored);
    EXPECT_THAT(diff("mirrored.txt " + triangle).out,
                HasSubstr("a is b, mirrored left to right: then nothing differs\n"));

    const std::string scene = R"({"canvas":{"width":12,"height":12,"origin":"top-left"},)"
                              R"("vertices":{"A":[1,1],"B":[10,3],"C":[4,11]},"triangles":["ABC"],)"
                              R"("method":{"fill":"barycentric","sample":"center"}})";
    write("centers.json", scene);
    write_rows("corners.txt", rows_of("centers.json --sample integer"));
    EXPECT_THAT(diff("centers.json corners.txt").out,
                HasSubstr("with --sample integer: then no pixels differ\n"));
}

// Of a picture that is drawn all over nothing says what its background is, but who asks.
TEST_F(DiffPictureTest, APictureThatIsDrawnAllOverIsNotTakenForEmpty) {
    write("full.json",
          R"({"canvas":{"width":3,"height":2,"origin":"top-left"},)"
          R"("vertices":{"A":[-9,-9],"B":[20,-9],"C":[-9,20]},)"
          R"("triangles":[{"vertices":"ABC","color":"#ff0000"}],"method":{"fill":"top-left"}})");
    write_ppm("full.ppm", {"###", "###"}, {255, 0, 0});
    EXPECT_EQ(diff("full.json full.ppm").status, 0) << diff("full.json full.ppm").out;
    write_ppm("hole.ppm", {"#.#", "###"}, {255, 0, 0});
    EXPECT_THAT(diff("full.json hole.ppm"),
                Ends(1, HasSubstr("the pictures: 1 pixel in another color\n")));
    EXPECT_THAT(diff("--background '#ffffff' full.json hole.ppm").out,
                HasSubstr("the pictures: 1 pixel only in a\n"));
}

// What a move takes off the canvas is not there: it differs. On two pixels a move would explain anything.
TEST_F(DiffPictureTest, AMoveIsToldOnlyIfEveryPixelWasCompared) {
    write("box.json", R"({"canvas":{"width":6,"height":2,"origin":"top-left"},)"
                      R"("vertices":{"A":[0,0],"B":[4,0],"C":[4,2],"D":[0,2]},)"
                      R"("triangles":["ABC","ACD"],"method":{"fill":"top-left"}})");
    EXPECT_EQ(rows_of("box.json"), Rows({"####..", "####.."}));
    write_rows("wide.txt", {"#####.", "#####."});
    EXPECT_THAT(diff("box.json wide.txt").out, Not(HasSubstr("moved")));
    write_rows("moved.txt", {".####.", ".####."});
    EXPECT_THAT(diff("box.json moved.txt").out,
                HasSubstr("b is a, moved 1 pixel to the right: then nothing differs\n"));
    write_rows("cut.txt", {"..####", "..####"});
    EXPECT_THAT(diff("box.json cut.txt --ignore header").out,
                HasSubstr("b is a, moved 2 pixels to the right: then nothing differs\n"));

    write("two.json", R"({"canvas":{"width":2,"height":1,"origin":"top-left"},)"
                      R"("vertices":{"A":[0,0]},"points":["A"]})");
    write_rows("other.txt", {".#"});
    EXPECT_THAT(diff("two.json other.txt").out, Not(HasSubstr("b is a")));
}

// A move that leaves nothing to compare explains nothing.
TEST_F(DiffPictureTest, ALostPixelIsNotTakenForAMove) {
    const Rows rows = rows_of(triangle);
    write_rows("empty.txt", Rows(rows.size(), std::string(rows.front().size(), '.')));
    EXPECT_THAT(diff(triangle + " empty.txt").out, Not(HasSubstr("moved")));
}

TEST_F(DiffPictureTest, WhoDrewThePixelsIsToldOfTheScene) {
    const std::string scene = "$examples/t0-hidden/two-cubes.json";
    Rows rows = rows_of(scene);
    for (std::string& row : rows)
        if (const std::size_t at = row.find_first_not_of('.'); at != std::string::npos)
            row[at] = '.';
    write_rows("mine.txt", rows);
    EXPECT_THAT(diff(scene + " mine.txt"),
                Ends(1, AllOf(HasSubstr("who drew them, a\n"), HasSubstr("A "), HasSubstr("B "))));
}

TEST_F(DiffPictureTest, BadPicturesAreRefused) {
    write("small.txt", "...\n.#.\n");
    EXPECT_THAT(diff(triangle + " small.txt"),
                Refused(HasSubstr("small.txt: expected a picture of 17x14 pixels")));
    write("cut.ppm", "P6\n17 14\n255\nabc");
    EXPECT_EQ(diff(triangle + " cut.ppm").status, 2);
    write("bomb.ppm", "P6\n99999 99999\n255\n");
    const Outcome bomb = diff(triangle + " bomb.ppm");
    EXPECT_EQ(bomb.status, 2);
    EXPECT_THAT(bomb.err, HasSubstr("expected a width from 1 to 16384"));
    EXPECT_LT(bomb.peak_memory, 1'000'000'000); // its pixels would be 30 GB
    write("uneven.txt", "..#\n.#\n");
    EXPECT_THAT(diff(triangle + " uneven.txt").err, HasSubstr("uneven.txt:2"));
}

} // namespace
} // namespace rastertrace
