// SPDX-License-Identifier: MIT
// What figures show, read back from their shapes. Numbers are those of the texts (docs/sources.md).
#include "depth_plot.h"
#include "drawings.h"
#include "error_bars.h"
#include "label_places.h"
#include "lattice.h"
#include "visibility.h"
#include "words.h"

#include <rastertrace/figures/figure.h>
#include <rastertrace/figures/theme.h>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

const std::string first_triangle = R"({"title": "First triangle",
    "canvas": {"width": 17, "height": 14},
    "vertices": {"A": [2, 5], "B": [-4, -3], "C": [5, -3]},
    "triangles": ["ABC"], "method": {"scalar": "exact"}})";

bool has(const Rectangle& rectangle, Place place) {
    return rectangle.corner.x < place.x && place.x < rectangle.corner.x + rectangle.width &&
           rectangle.corner.y < place.y && place.y < rectangle.corner.y + rectangle.height;
}

/// Where things are on a sheet, as a reader finds out: from the numbers at the axes.
class Axes {
public:
    explicit Axes(const Drawing& drawing) {
        for (const Label& label : shapes_of<Label>(drawing, Role::quiet_text)) {
            // Numbers of columns are centered below theirs, those of rows end at the left of theirs.
            if (label.anchor == Anchor::middle)
                columns_[std::stoi(label.text)] = label.at.x;
            else if (label.text.find("step") == std::string::npos)
                rows_[std::stoi(label.text)] = label.at.y - 0.35 * label.size;
        }
    }
    Place of(double x, double y) const { return {along(columns_, x), along(rows_, y)}; }
    double cell() const { return of(1, 0).x - of(0, 0).x; }

private:
    static double along(const std::map<int, double>& numbers, double value) {
        const auto [first, from] = *numbers.begin();
        const auto [last, to] = *numbers.rbegin();
        return from + (value - first) / (last - first) * (to - from);
    }
    std::map<int, double> columns_;
    std::map<int, double> rows_;
};

/// The rows from y = 7 to -6 of the first triangle's canvas: the letter of the role that a pixel has, `2` if it is
/// covered twice.
std::string picture_of(const Drawing& drawing, const std::map<Role, char>& letters) {
    const Axes axes(drawing);
    std::string picture;
    for (int y = 7; y >= -6; --y) {
        for (int x = -8; x <= 8; ++x) {
            char found = '.';
            for (const auto& [role, letter] : letters)
                for (const Areas& areas : shapes_of<Areas>(drawing, role))
                    for (const Rectangle& rectangle : areas.rectangles)
                        if (has(rectangle, axes.of(x, y)))
                            found = found == '.' ? letter : '2';
            picture += found;
        }
        picture += '\n';
    }
    return picture;
}

TEST(Figures, ARowHasItsPixelsAndThoseBefore) {
    const Drawing figure = figure_at(trace_of_scene(first_triangle), "scanline y=2");
    EXPECT_EQ(picture_of(figure, {{Role::plotted, '#'}, {Role::current, '@'}}), R"(.................
.................
..........#......
.........##......
........###......
.......@@@@@.....
.................
.................
.................
.................
.................
.................
.................
.................
)");
}

TEST(Figures, TheEndsOfARowAreWhereTheEdgesMeetIt) {
    const Drawing figure = figure_at(trace_of_scene(first_triangle), "scanline y=2");
    const Axes axes(figure);
    const auto dots = shapes_of<Dots>(figure, Role::row_end);
    ASSERT_EQ(dots.size(), 2U);
    // x = -1/4 and 25/8, on the line of y = 2.
    EXPECT_NEAR(dots[0].centers[0].x, axes.of(-0.25, 2).x, 1e-9);
    EXPECT_NEAR(dots[1].centers[0].x, axes.of(3.125, 2).x, 1e-9);
    EXPECT_NEAR(dots[1].centers[0].y, axes.of(0, 2).y, 1e-9);
    EXPECT_THAT(texts_of(figure, Role::row_end), testing::ElementsAre("-1/4", "25/8"));
    // An arrow from each to its pixel: -1 and 3.
    const auto arrows = shapes_of<Polygons>(figure, Role::rounding);
    ASSERT_EQ(arrows.size(), 2U);
    EXPECT_NEAR(arrows[0].paths[0][0].x, axes.of(-1, 2).x, 1e-9);
    EXPECT_NEAR(arrows[1].paths[0][0].x, axes.of(3, 2).x, 1e-9);
}

TEST(Figures, AnExactEndHasNoArrow) {
    // x = 2 at both ends of y = 5, and -1 at the left end of y = 1.
    const Trace trace = trace_of_scene(first_triangle);
    EXPECT_EQ(shapes_of<Polygons>(figure_at(trace, "scanline y=5"), Role::rounding).size(), 0U);
    EXPECT_EQ(shapes_of<Polygons>(figure_at(trace, "scanline y=1"), Role::rounding).size(), 1U);
}

TEST(Figures, AQuestionTellsNothingOfItsStep) {
    const Trace trace = trace_of_scene(first_triangle);
    const std::size_t n = step_of(trace, "scanline y=2");
    const Drawing figure = figure_of(trace, {.steps = {n, n}, .is_question = true});
    EXPECT_EQ(picture_of(figure, {{Role::plotted, '#'}, {Role::current, '@'}}), R"(.................
.................
..........#......
.........##......
........###......
.................
.................
.................
.................
.................
.................
.................
.................
.................
)");
    EXPECT_THAT(texts_of(figure, Role::row_end), testing::IsEmpty());
    EXPECT_THAT(texts_of(figure, Role::text), testing::IsEmpty());
    EXPECT_EQ(shapes_of<Lines>(figure, Role::row).size(), 1U) << "the row that is asked about";
}

std::string first_triangle_by(const std::string& fill) {
    std::string scene = first_triangle;
    return scene.insert(scene.rfind("}}"), R"(,"fill":")" + fill + '"');
}

constexpr const char* rectangle_by_rows =
    R"({"canvas":{"width":9,"height":6,"origin":"bottom-left"},
        "vertices":{"A":[1,1],"B":[7,1],"C":[7,4],"D":[1,4]},"polygons":["ABCD"],
        "method":{"scalar":"exact"}})";

/// What a step is about: pixels or rows, who tells the ends of its row, its primitive, an edge of that.
std::string subject_text(const Trace& trace, std::size_t n) {
    Replay replay(trace);
    replay.go_to(n);
    const StepSubject subject = subject_of(replay, n);
    std::string text;
    if (subject.pixels)
        text = fmt::format("{} {}..{} {}..{} ", subject.is_row ? "row" : "at", subject.pixels->x0,
                           subject.pixels->x1, subject.pixels->y0, subject.pixels->y1);
    if (subject.row != 0)
        text += "by " + trace.step(subject.row).kind_name() + " ";
    if (subject.primitive != 0)
        text += "of " + name_in(trace.step(subject.primitive)).text();
    if (subject.edge)
        text += fmt::format(" {}-{}", (*subject.edge)[0], (*subject.edge)[1]);
    return text;
}

TEST(Figures, EachKindOfStepIsAboutWhatItsSentenceSays) {
    struct Case {
        std::string scene, step, about;
    };
    const std::string line = R"({"canvas":{"width":8,"height":4,"origin":"bottom-left"},
        "vertices":{"A":[0,0],"B":[5,2]},"lines":["AB"],"method":{"line":")";
    const std::vector<Case> cases{
        {rectangle_by_rows, "primitive", "of ABCD"},
        {rectangle_by_rows, "edge CB", "of ABCD 2-1"},
        {rectangle_by_rows, "crossings y=2", "row 0..8 2..2 by crossings of ABCD"},
        {rectangle_by_rows, "scanline y=2", "row 1..7 2..2 by scanline of ABCD"},
        {rectangle_by_rows, "pixel 3,2", "at 3..3 2..2 by scanline of ABCD"},
        {first_triangle_by("two-halves"), "half upper", "row -8..8 -3..5 of ABC"},
        {first_triangle_by("fan"), "ray 2,5", "at 2..2 5..5 of ABC"},
        {first_triangle_by("barycentric"), "sample -4,5", "at -4..-4 5..5 of ABC"},
        {line + "bresenham\"}}", "decide x=1", "at 1..1 0..0 of AB"},
        {line + "dda\"}}", "along x=3", "at 3..3 1..1 of AB"}};
    for (const auto& [scene, step, about] : cases) {
        const Trace trace = trace_of_scene(scene);
        EXPECT_EQ(subject_text(trace, step_of(trace, step)), about) << step;
    }
    const Trace trace = readable_trace(R"({"rastertrace":1,
"canvas":{"width":8,"height":4,"origin":"top-left"},"steps":[
{"step":"primitive","kind":"triangle","name":"ABC","vertices":["A","B","C"]},
{"step":"scanline","y":1,"left":0,"right":2,"from":0,"to":2},
{"step":"reject","x":-3,"to_x":1,"y":1,"why":"off-canvas"},
{"step":"reject","y":2,"to_y":9,"why":"off-canvas"},
{"step":"reject","x":5,"y":2,"to_x":9,"to_y":9,"why":"off-canvas"},
{"step":"face","name":"ABC","normal":[0,0,1],"dot":1,"culled":false},
{"step":"matrix","name":"view","rows":[]},
{"step":"clip","name":"DEF","plane":"near","inside":[true,false,true],"out":4},
{"step":"vertex","name":"V","space":"camera","at":[2,3]},
{"step":"vertex","name":"V","space":"screen","at":[2,3]},
{"step":"primitive","kind":"triangle","name":"DEF/1","part":true,"vertices":["D","E","V"]},
{"step":"skip","name":"GHI","why":"culled"}
],"end":{"steps":12}})");
    const std::vector<std::string> about{"of ABC",
                                         "row 0..2 1..1 by scanline of ABC",
                                         "at 0..1 1..1 by scanline of ABC",
                                         "row 0..7 2..3 of ABC",
                                         "of ABC",
                                         "of ABC",
                                         "",
                                         "of DEF/1",
                                         "",
                                         "at 2..2 3..3 ",
                                         "of DEF/1",
                                         ""};
    for (std::size_t n = 1; n <= trace.size(); ++n)
        EXPECT_EQ(subject_text(trace, n), about[n - 1]) << n;
}

TEST(Figures, AStepMarksItsRowsItsEdgeOrItsPixel) {
    const Trace rectangle = trace_of_scene(rectangle_by_rows);
    const Drawing crossings = figure_at(rectangle, "crossings y=2");
    const auto rows = shapes_of<Lines>(crossings, Role::row);
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_NEAR(rows[0].paths[0][0].y, Axes(crossings).of(0, 2).y, 1e-9);
    EXPECT_THAT(texts_of(crossings, Role::row_end), testing::ElementsAre("1", "7"));

    const Drawing edge = figure_at(rectangle, "edge CB");
    const auto marked = shapes_of<Lines>(edge, Role::current_border);
    ASSERT_EQ(marked.size(), 1U);
    const Place from = Axes(edge).of(7, 4);
    const Place to = Axes(edge).of(7, 1);
    EXPECT_NEAR(marked[0].paths[0][0].x, from.x, 1e-9);
    EXPECT_NEAR(marked[0].paths[0][0].y, from.y, 1e-9);
    EXPECT_NEAR(marked[0].paths[0][1].y, to.y, 1e-9);

    // The second half begins, and nothing of the row before it is marked.
    const Drawing half = figure_at(trace_of_scene(first_triangle_by("two-halves")), "half upper");
    const auto ends = shapes_of<Lines>(half, Role::row);
    ASSERT_EQ(ends.size(), 2U);
    EXPECT_NEAR(ends[0].paths[0][0].y, Axes(half).of(0, -3).y, 1e-9);
    EXPECT_NEAR(ends[1].paths[0][0].y, Axes(half).of(0, 5).y, 1e-9);

    const Trace line = trace_of_scene(R"({"canvas":{"width":8,"height":4,"origin":"bottom-left"},
        "vertices":{"A":[0,0],"B":[5,2]},"lines":["AB"]})");
    const std::size_t n = step_of(line, "decide x=1");
    const Drawing decision = figure_of(line, {.steps = {n, n}});
    const auto border = shapes_of<Lines>(decision, Role::current_border);
    ASSERT_EQ(border.size(), 1U);
    ASSERT_EQ(border[0].paths.size(), 4U);
    const Place middle = Axes(decision).of(1, 0);
    EXPECT_LT(border[0].paths[0][0].x, middle.x);
    EXPECT_GT(border[0].paths[0][1].x, middle.x);
}

TEST(Figures, EdgesRunThroughTheVertices) {
    const Drawing figure = whole_figure(trace_of_scene(first_triangle));
    const Axes axes(figure);
    std::vector<Place> ends;
    for (const Lines& lines : shapes_of<Lines>(figure, Role::true_edge))
        for (const Path& path : lines.paths)
            ends.push_back(path.front());
    ASSERT_EQ(ends.size(), 3U);
    const std::array<Place, 3> corners{axes.of(2, 5), axes.of(-4, -3), axes.of(5, -3)};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(ends[i].x, corners[i].x, 1e-9);
        EXPECT_NEAR(ends[i].y, corners[i].y, 1e-9);
    }
    EXPECT_THAT(texts_of(figure, Role::strong_text),
                testing::IsSupersetOf({"A(2, 5)", "B(-4, -3)", "C(5, -3)"}));
}

TEST(Figures, PixelsAreNumberedInTheOrderOfDrawing) {
    const Drawing figure =
        whole_figure(trace_of_scene(first_triangle), {.with = {FigurePart::order}});
    std::map<std::pair<int, int>, std::string> numbers; // by row from the top, and column
    const Axes axes(figure);
    for (const Label& label : shapes_of<Label>(figure, Role::cell_text))
        numbers[{static_cast<int>(std::lround((label.at.y - axes.of(0, 7).y) / axes.cell() - 0.1)),
                 static_cast<int>(std::lround((label.at.x - axes.of(0, 0).x) / axes.cell()))}] =
            label.text;
    ASSERT_EQ(numbers.size(), 49U);
    int expected = 1;
    for (const auto& [place, number] : numbers)
        EXPECT_EQ(number, std::to_string(expected++));
}

TEST(Figures, TwoRoundingsDifferInEightPixels) {
    // Down against the nearest: y=3 0..2 and 1..3, y=2 -1..3 and 0..3, y=1 -1..3 and -1..4, y=0 -2..3 and -2..4, ...
    const Trace down = trace_of_scene(first_triangle);
    Scene nearest = scene_in(first_triangle);
    nearest.method.rounding = Rounding::nearest;
    const Trace other = trace_of(nearest);
    const Drawing figure = whole_figure(down, {.against = &other, .against_name = "nearest"});
    EXPECT_EQ(picture_of(figure, {{Role::same, '#'},
                                  {Role::only_here, '!'},
                                  {Role::only_there, '?'},
                                  {Role::differs, '~'}}),
              R"(.................
.................
..........#......
.........##......
........!##?.....
.......!####.....
.......#####?....
......######?....
.....!#######....
....!########?...
....##########...
.................
.................
.................
)");
    EXPECT_THAT(texts_of(figure, Role::cell_text),
                testing::UnorderedElementsAre("!", "!", "!", "!", "?", "?", "?", "?"));
}

TEST(Figures, AFaceKeepsItsColorWhateverHidesIt) {
    const Trace trace = trace_of_scene(R"({"canvas": {"width": 9, "height": 9},
        "vertices": {"A": [-4, -4, 3], "B": [4, -4, 3], "C": [-4, 4, 3],
                     "D": [-4, -4, 2], "E": [4, -4, 2], "F": [-4, 4, 2]},
        "triangles": ["ABC", "DEF"],
        "method": {"scalar": "exact", "depth": "linear-z"}})");
    const Drawing first = figure_at(trace, "primitive name=ABC");
    EXPECT_EQ(shapes_of<Areas>(first, Role::face_1).front().rectangles.size(), 9U);
    // DEF is nearer and covers all of it.
    const Drawing last = whole_figure(trace);
    EXPECT_THAT(shapes_of<Areas>(last, Role::face_1), testing::SizeIs(0));
    EXPECT_EQ(shapes_of<Areas>(last, Role::face_2).front().rectangles.size(), 9U);
}

TEST(Figures, WeightsOfASampleAreWritten) {
    Scene scene = scene_in(first_triangle);
    scene.method.fill = Fill::barycentric;
    const Drawing figure = whole_figure(trace_of(scene), {.with = {FigurePart::weights}});
    const Axes axes(figure);
    const Place origin = axes.of(0, 0);
    std::vector<std::string> weights;
    for (const Label& label : shapes_of<Label>(figure, Role::cell_text))
        if (std::abs(label.at.x - origin.x) < 1 &&
            std::abs(label.at.y - origin.y) < axes.cell() / 2)
            weights.push_back(label.text);
    // Of (0, 0): 27/72, 31/72, 14/72.
    EXPECT_THAT(weights, testing::ElementsAre("3/8", "31/72", "7/36"));
}

TEST(Figures, TheLegendOfHalfPlanesHasTheLayersOfThePicture) {
    const Trace trace = trace_of_scene(first_triangle);
    const Drawing figure = whole_figure(trace, {.with = {FigurePart::half_planes}});
    // At how many of the three edges a place is inside, by the polygons that have it: of the legend by its swatches.
    const auto layers_at = [&figure](Place place) {
        std::string layers;
        for (const Shape& shape : figure.shapes) {
            const auto* const areas = std::get_if<Areas>(&shape);
            if (areas != nullptr && (areas->role == Role::inside || areas->role == Role::outside) &&
                has(areas->rectangles.front(), place))
                layers += areas->role == Role::inside ? '+' : '-';
        }
        return layers;
    };
    std::map<std::string, std::string> legend;
    for (const Label& label : shapes_of<Label>(figure, Role::text))
        if (const auto layers = layers_at({label.at.x - 8, label.at.y - 3}); !layers.empty())
            legend[layers] = label.text;
    EXPECT_THAT(legend, testing::ElementsAre(testing::Pair("+++", "AB, BC, CA \u2265 0"),
                                             testing::Pair("++-", "one of them < 0"),
                                             testing::Pair("+--", "two of them < 0")));
    // No layer covers a name of an edge.
    const auto is_layer = [](const Shape& shape) {
        const auto* const polygons = std::get_if<Polygons>(&shape);
        return polygons != nullptr;
    };
    const auto is_name = [](const Shape& shape) {
        const auto* const label = std::get_if<Label>(&shape);
        return label != nullptr && label->role == Role::text;
    };
    EXPECT_GT(std::find_if(figure.shapes.begin(), figure.shapes.end(), is_name),
              std::find_if(figure.shapes.rbegin(), figure.shapes.rend(), is_layer).base() - 1);
    // A frame without a triangle has no legend of them.
    const Drawing none = FigureMaker(trace, {{.steps = {0, 0}}, {.steps = {0, 0}}},
                                     {.with = {FigurePart::half_planes}})
                             .figure(0);
    EXPECT_THAT(shapes_of<Areas>(none, Role::inside), testing::IsEmpty());
}

TEST(Figures, ASampleIsInTheMiddleOfItsPixel) {
    for (const bool begins_at_integers : {false, true})
        for (const Origin origin : {Origin::center, Origin::bottom_left, Origin::top_left}) {
            const Lattice lattice{.canvas = {.width = 5, .height = 4, .origin = origin},
                                  .region = {.x0 = 0, .y0 = 0, .x1 = 2, .y1 = 1},
                                  .begins_at_integers = begins_at_integers,
                                  .cell = 10,
                                  .corner = {3, 4}};
            const double sample = begins_at_integers ? 0.5 : 0.0;
            const Place middle = lattice.middle_of({1, 1});
            const Place place = lattice.place_of(1 + sample, 1 + sample);
            EXPECT_EQ(middle, place);
            EXPECT_EQ(middle.x, 3 + 15);
            EXPECT_EQ(middle.y, origin == Origin::top_left ? 4 + 15 : 4 + 5);
        }
}

TEST(Figures, BarsAreBresenhamsD) {
    const Trace trace =
        trace_of_scene(R"({"canvas": {"width": 8, "height": 4, "origin": "bottom-left"},
        "vertices": {"A": [0, 0], "B": [5, 2]}, "lines": ["AB"]})");
    Replay replay(trace);
    replay.go_to(trace.size());
    const auto decisions = decisions_of(replay);
    ASSERT_TRUE(decisions);
    EXPECT_FALSE(decisions->is_steep);
    std::vector<std::string> ds;
    for (const Decision& decision : decisions->all)
        ds.push_back(decision.text);
    EXPECT_THAT(ds, testing::ElementsAre("-1", "3", "-3", "1", "-5"));

    const Drawing figure = figure_at(trace, "last", {.with = {FigurePart::errors}});
    std::vector<double> heights;
    for (const Role role : {Role::bar, Role::bar_below})
        for (const Areas& areas : shapes_of<Areas>(figure, role))
            for (const Rectangle& rectangle : areas.rectangles)
                heights.push_back(rectangle.height);
    ASSERT_EQ(heights.size(), 5U);
    // 3, 1 upward, then 1, 3, 5 downward, in one scale.
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(heights[i] / heights[1], (std::array<double, 5>{3, 1, 1, 3, 5}[i]), 1e-9);
}

TEST(Figures, ASteepLineHasItsBarsBesideItsRows) {
    const Trace trace = trace_of_scene(R"({"canvas": {"width": 17, "height": 14},
        "vertices": {"A": [2, 5], "C": [5, -3]}, "lines": ["AC"]})");
    Replay replay(trace);
    replay.go_to(trace.size());
    const auto decisions = decisions_of(replay);
    ASSERT_TRUE(decisions);
    EXPECT_TRUE(decisions->is_steep);
    EXPECT_EQ(decisions->all.front().text, "-2");
    EXPECT_EQ(decisions->all.back().text, "-8");
}

TEST(Figures, TextsHaveTheSignsOfAPrinter) {
    for (const auto& [typed, set] : std::initializer_list<std::pair<const char*, const char*>>{
             {"left AB: x = 2 - 3/4 (4 - 5) = -1/4 -> floor -> -1",
              "left AB: x = 2 − 3/4 (4 − 5) = −1/4 → floor → −1"},
             {"B(-4, -3)", "B(−4, −3)"},
             {"-3", "−3"},
             {"z = -d D / (A x' + d C)", "z = −d D / (A x' + d C)"},
             {"half-open, small.E-small.G, 2-3, top-left",
              "half-open, small.E-small.G, 2-3, top-left"},
             {"a - -b <= 0", "a − −b ≤ 0"},
             {"--region", "--region"},
             {"-", "-"},
             {"", ""}})
        EXPECT_EQ(typeset(typed), set);
}

/// The length of what is seen of the edge AB, and of what is not, in pixels. DEF covers all of it but x = 0 to 4.
std::pair<double, double> seen_and_hidden(const std::string& depth, const std::string& z_of_cover,
                                          const std::string& kind_of_cover = "triangles") {
    const Trace trace = trace_of_scene(
        fmt::format(R"({{"canvas": {{"width": 12, "height": 12, "origin": "top-left"}},
        "vertices": {{"A": [0, 5, 9], "B": [10, 5, 9], "C": [5, 10, 9],
                      "D": [4, 0, {0}], "E": [4, 11, {0}], "F": [60, 5, {0}]}},
        "triangles": ["ABC"{2}"DEF"], "method": {{"scalar": "exact", "depth": "{1}"}}}})",
                    z_of_cover, depth,
                    kind_of_cover == "triangles" ? ", " : "], \"" + kind_of_cover + "\": ["));
    Replay replay(trace, {.depths = true});
    replay.go_to(trace.size());
    const FaceGroups groups;
    const Lattice lattice{
        .canvas = trace.canvas, .region = {0, 0, 11, 11}, .cell = 10, .corner = {}};
    const Visibility visibility({.replay = replay,
                                 .frame = {.steps = {0, trace.size()}},
                                 .lattice = lattice,
                                 .parts = {},
                                 .view = View::plotted,
                                 .groups = groups,
                                 .against = nullptr});
    const Path side{lattice.place_of(0, 5), lattice.place_of(10, 5)};
    const auto length = [&](bool seen) {
        double sum = 0;
        for (const Path& part : visibility.parts_of(replay.primitives().front(), side, seen))
            sum += part.back().x - part.front().x;
        return sum / lattice.cell;
    };
    return {length(true), length(false)};
}

TEST(Figures, EdgesAreSeenWhereNothingNearerIs) {
    for (const char* const depth : {"linear-z", "inverse-z", "painter"}) {
        const auto [seen, hidden] = seen_and_hidden(depth, "2");
        EXPECT_NEAR(seen, 4, 1e-5) << depth;
        EXPECT_NEAR(hidden, 6, 1e-5) << depth;
    }
    for (const auto& [depth, z] : {std::pair("linear-z", "20"), std::pair("inverse-z", "20"),
                                   std::pair("linear-z", "9"), std::pair("none", "2")})
        EXPECT_EQ(seen_and_hidden(depth, z), std::pair(10.0, 0.0)) << depth << " " << z;
    EXPECT_EQ(seen_and_hidden("linear-z", "2", "outlines"), std::pair(10.0, 0.0));
}

/// What is plotted at the end of a trace, or at the row that it steps through at this height.
std::vector<Plot> plots_of(const Trace& trace, std::optional<Index> y = {}) {
    ShownSteps steps{0, trace.size()};
    for (const std::size_t n : trace.steps_of({StepKind::scanline}))
        if (trace.step(n).as<ScanlineStep>().y == y)
            steps = {n, n};
    Replay replay(trace, {.depths = true});
    replay.go_to(steps.last);
    const FaceGroups groups;
    return depth_plots({.replay = replay,
                        .frame = {.steps = steps},
                        .lattice = {},
                        .parts = {},
                        .view = View::plotted,
                        .groups = groups,
                        .against = nullptr,
                        .subject = subject_of(replay, steps.first)});
}

TEST(Figures, APlotIsAlongOneSide) {
    // The left side is bent at B, whose row is that of BC: along it depths change most.
    const auto plots = plots_of(trace_of_scene(R"({"canvas": {"width": 10, "height": 10},
        "vertices": {"A": [0, 4, 2], "B": [-4, 0, 9], "C": [0, -4, 2]}, "triangles": ["ABC"],
        "keep": ["depth"], "method": {"scalar": "exact", "depth": "linear-z"}})"));
    ASSERT_EQ(plots.size(), 2U);
    EXPECT_EQ(plots[0].x.label, "y along the side BC");
    for (const PlotMark& mark : plots[0].curves[2].marks)
        EXPECT_NEAR(mark.y, 2 + (4 + mark.x) * 7 / 4, 1e-12); // from (-4, 2) to (0, 9)
}

TEST(Figures, WithoutAPerspectiveDepthsAreStraightInTruth) {
    for (const std::string depth : {"linear-z", "inverse-z"}) {
        const auto plots = plots_of(trace_of_scene(R"({"canvas": {"width": 10, "height": 10},
            "vertices": {"A": [-3, 2, -2], "D": [-3, -3, -2], "E": [0, 2, -8]},
            "triangles": ["ADE"], "keep": ["depth"],
            "projection": {"type": "orthographic", "left": -5, "right": 5, "bottom": -5, "top": 5,
                           "near": 1, "far": 9},
            "method": {"scalar": "exact", "depth": ")" +
                                                   depth + R"("}})"));
        ASSERT_EQ(plots.size(), 2U) << depth;
        const auto& truth = plots[0].curves[0].marks;
        ASSERT_GT(truth.size(), 2U);
        EXPECT_EQ(plots[0].curves[0].name, "true");
        const PlotMark& first = truth.front();
        const PlotMark& last = truth.back();
        EXPECT_GT(std::abs(last.y - first.y), 1) << depth;
        for (const PlotMark& mark : truth)
            EXPECT_NEAR(mark.y,
                        first.y + (mark.x - first.x) / (last.x - first.x) * (last.y - first.y),
                        1e-9)
                << depth;
    }
}

// In the row y = 2, floor(left) and floor(right) are not where the face ends: the straight line leads through these,
// and of 1/z it is the true one. Sampled at the center, the row lies at y = 5/2.
TEST(Figures, StraightBetweenTheEndsOfARowIsTheTruthOfItsReciprocals) {
    for (const auto& [sample, left, left_depth] : {std::tuple("integer", -29.0 / 6, 7.0 / 9),
                                                   std::tuple("center", -377.0 / 72, 22.0 / 27)}) {
        const Trace trace = trace_of_scene(R"({"canvas": {"width": 17, "height": 14},
            "vertices": {"A": ["-29/4", 5, 1], "B": ["31/4", 5, 10], "C": [0, -4, 3]},
            "triangles": ["ABC"], "keep": ["depth"],
            "method": {"scalar": "exact", "depth": "inverse-z", "sample": ")" +
                                           std::string(sample) + R"("}})");
        const auto plots = plots_of(trace, 2);
        ASSERT_EQ(plots.size(), 2U);
        const auto& truth = plots[1].curves[0].marks;
        const auto& straight = plots[1].curves[1].marks;
        ASSERT_EQ(straight.size(), 2U);
        EXPECT_NEAR(straight[0].x, left, 1e-12);
        EXPECT_NEAR(straight[0].y, left_depth, 1e-12);
        const double slope = (straight[1].y - straight[0].y) / (straight[1].x - straight[0].x);
        for (const PlotMark& mark : truth)
            EXPECT_NEAR(mark.y, straight[0].y + slope * (mark.x - straight[0].x), 1e-12) << sample;
        // What is drawn lies on it, too, but for the first pixel, whose sample lies outside.
        const auto& drawn = plots[1].curves[2].marks;
        for (std::size_t i = 1; i < drawn.size(); ++i)
            EXPECT_NEAR(drawn[i].y, straight[0].y + slope * (drawn[i].x - straight[0].x), 1e-12)
                << sample;
    }
}

TEST(Figures, DepthsInARowAreAsDrawnAndTrue) {
    // An edge from z = 3 at y = -3 to z = 4 at y = 2 (docs/sources.md): true 3, 60/19, 10/3, 60/17, 15/4, 4.
    for (const std::string depth : {"linear-z", "inverse-z"}) {
        const Trace trace = trace_of_scene(R"({"canvas": {"width": 10, "height": 10},
            "vertices": {"A": [-3, 2, 3], "D": [-3, -3, 3], "E": [0, 2, 4]},
            "triangles": ["ADE"], "keep": ["depth"],
            "method": {"scalar": "exact", "depth": ")" +
                                           depth + R"("}})");
        const std::vector<Plot> plots = plots_of(trace);
        ASSERT_EQ(plots.size(), 2U);
        EXPECT_EQ(plots[0].curves[0].name, "true in a perspective"); // the scene does not say
        const PlotCurve& truth = plots[0].curves[0];
        const PlotCurve& drawn = plots[0].curves[2];
        const std::array<double, 6> true_z{3, 60.0 / 19, 10.0 / 3, 60.0 / 17, 15.0 / 4, 4};
        ASSERT_EQ(drawn.marks.size(), 6U);
        for (std::size_t i = 0; i < 6; ++i) {
            EXPECT_EQ(drawn.marks[i].x, -3 + static_cast<double>(i));
            const double linear = 3 + static_cast<double>(i) / 5;
            EXPECT_NEAR(drawn.marks[i].y, depth == "linear-z" ? linear : true_z[i], 1e-12);
            const auto at =
                std::find_if(truth.marks.begin(), truth.marks.end(), [&](const PlotMark& mark) {
                    return std::abs(mark.x - drawn.marks[i].x) < 1e-9;
                });
            ASSERT_NE(at, truth.marks.end());
            EXPECT_NEAR(at->y, true_z[i], 1e-12);
        }
    }
}

TEST(Figures, WordsThatDoNotFitOnTheSheetAreAtTheOtherSideOfTheirPoint) {
    // B and E lie on the upper right corner of the pixels: their words are as wide as an eighth of these.
    const Drawing corner = whole_figure(trace_of_scene(R"({
        "canvas": {"width": 64, "height": 64, "origin": "top-left"},
        "vertices": {"A": [0, 0, 1], "B": [64, 0, 9], "C": [0, 64, 1],
                     "D": [0, 0, 4], "E": [64, 0, 4], "F": [0, 64, 4]},
        "triangles": ["ABC", "DEF"],
        "method": {"scalar": "exact", "fill": "top-left", "depth": "inverse-z"}})"));
    EXPECT_THAT(texts_of(corner, Role::strong_text),
                testing::IsSupersetOf({"A, D(0, 0)", "B, E(64, 0)", "C, F(0, 64)"}));

    for (const Rectangle& box : boxes_of(corner, Role::strong_text))
        EXPECT_TRUE((Rectangle{{}, corner.width, corner.height}).has(box))
            << box.left() << " to " << box.right() << " of " << corner.width;
}

TEST(Figures, WordsThatFitNowhereOnTheSheetAreLeftOut) {
    // The names of two vertices alone are wider than the sheet.
    const std::string many(40, 'W');
    const Drawing figure = whole_figure(
        trace_of_scene(R"({"canvas": {"width": 9, "height": 9}, "vertices": {")" + many +
                       R"(": [0, 0], "B": [4, 0], "C": [0, 4]}, "triangles": [[")" + many +
                       R"(", "B", "C"]], "method": {"scalar": "exact"}})"));
    EXPECT_THAT(texts_of(figure, Role::strong_text), testing::IsSupersetOf({"B(4, 0)", "C(0, 4)"}));
    EXPECT_THAT(texts_of(figure, Role::strong_text),
                testing::Each(testing::Not(testing::HasSubstr(many))));
    EXPECT_EQ(shapes_of<Dots>(figure, Role::vertex).front().centers.size(), 3U);
}

TEST(Figures, AFaceThatIsCutHasOneColorAndNoDiagonal) {
    const auto quads = [](const std::string& faces) {
        return trace_of_scene(R"({"canvas": {"width": 20, "height": 9},
            "meshes": [{"vertices": {"A": [-8, -3, 0], "B": [-2, -3, 0], "C": [-2, 3, 0], "D": [-8, 3, 0],
                                     "E": [2, -3, 0], "F": [8, -3, 0], "G": [8, 3, 0], "H": [2, 3, 0]},
                        "faces": )" +
                              faces + R"(}], "method": {"scalar": "exact"}})");
    };
    const auto sides_in = [](const Drawing& figure) {
        std::size_t sides = 0;
        for (const Lines& lines : shapes_of<Lines>(figure, Role::true_edge))
            sides += lines.paths.size();
        return sides;
    };
    const Drawing two = whole_figure(quads(R"(["ABCD", "EFGH"])"));
    EXPECT_EQ(sides_in(two), 8U);
    EXPECT_TRUE(shapes_of<Areas>(two, Role::face_3).empty());
    EXPECT_THAT(texts_of(two, Role::text), testing::ElementsAre("ABCD", "EFGH"));
    // Triangles of their own stay what they are.
    const Drawing four = whole_figure(quads(R"(["ABC", "ACD", "EFG", "EGH"])"));
    EXPECT_EQ(sides_in(four), 12U);
    EXPECT_FALSE(shapes_of<Areas>(four, Role::face_4).empty());
}

TEST(Figures, PixelsCanTellWhoseTheyAreAndTheirLevels) {
    const Trace trace =
        trace_of_scene(R"({"canvas": {"width": 9, "height": 9, "origin": "bottom-left"},
        "vertices": {"A": [1, 1], "B": [5, 1], "C": [7, 7]},
        "points": [{"vertices": "A", "color": "#808080"}, {"vertices": "B", "color": "#0a1420"},
                   {"vertices": "C", "name": "last", "color": "#ffffff"}]})");
    EXPECT_THAT(texts_of(whole_figure(trace, {.with = {FigurePart::owners}}), Role::cell_text),
                testing::UnorderedElementsAre("A", "B", "last"));
    EXPECT_THAT(texts_of(whole_figure(trace, {.with = {FigurePart::levels}}), Role::cell_text),
                testing::UnorderedElementsAre("128", "10", "20", "32", "255"));
}

TEST(Figures, ANoteHasAnArrowToItsPlaceAndCoversNoWords) {
    const Drawing figure = whole_figure(trace_of_scene(first_triangle),
                                        {.notes = {{2, 5, "the top"}, {-4, -3, "the left end"}}});
    const Axes axes(figure);
    const auto tips = shapes_of<Polygons>(figure, Role::rounding);
    ASSERT_EQ(tips.size(), 2U);
    EXPECT_NEAR(tips[0].paths[0][0].x, axes.of(2, 5).x, 1e-6);
    EXPECT_NEAR(tips[1].paths[0][0].y, axes.of(-4, -3).y, 1);
    for (const Rectangle& note : boxes_of(figure, Role::rounding))
        for (const Rectangle& name : boxes_of(figure, Role::strong_text))
            EXPECT_FALSE(note.meets(name));
}

TEST(Figures, CaptionsHaveSixDigitsAtMost) {
    EXPECT_EQ(
        with_six_digits("normal (-0.051426169613, 25/8, 1234567) . 0.12067135165399998, 1e-12."),
        "normal (-0.0514262, 25/8, 1234567) . 0.120671, 1e-12.");
    EXPECT_EQ(with_six_digits("0.5 and 3.25; -> 2 .. 4, v1.2.3456789"),
              "0.5 and 3.25; -> 2 .. 4, v1.2.3456789");
}

TEST(Figures, PartsThatASceneCannotHaveAreRefused) {
    const Trace trace = trace_of_scene(first_triangle);
    for (const FigurePart part : {FigurePart::space, FigurePart::errors, FigurePart::plot})
        EXPECT_THROW(whole_figure(trace, {.with = {part}}), Problem);
}

TEST(Figures, EveryPartHasARowInItsOrder) {
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < figure_part_count; ++i) {
        EXPECT_EQ(figure_parts()[i].part, static_cast<FigurePart>(i));
        EXPECT_TRUE(names.insert(figure_parts()[i].name).second);
        EXPECT_EQ(figure_part_named(figure_parts()[i].name), figure_parts()[i].part);
    }
    EXPECT_EQ(figure_part_named("no such part"), std::nullopt);
}

TEST(Figures, NamesAreThoseOfTheirValues) {
    EXPECT_EQ(theme_named("auto"), Theme::automatic);
    EXPECT_EQ(theme_named("dark"), Theme::dark);
    EXPECT_EQ(view_named("plotted"), View::plotted);
    EXPECT_EQ(view_named("coverage"), View::coverage);
    for (const std::string_view none : {"", "sce", "Print", "no such name"}) {
        EXPECT_EQ(theme_named(none), std::nullopt);
        EXPECT_EQ(view_named(none), std::nullopt);
    }
}

} // namespace
} // namespace rastertrace
