// SPDX-License-Identifier: MIT
// S: the scanline fill, its rows floor(left)..floor(right), and the edges that it walks along. Pixels
// are integer points.

#include "stress_rows.h"

#include <rastertrace/core/raster/edge.h>
#include <rastertrace/numerics/knobs.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/text/output.h>

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace rastertrace {

namespace {

const MethodOverrides direct{{"fill", "scanline"}, {"lerp", "direct"}};
const MethodOverrides incremental{{"fill", "scanline"}, {"lerp", "incremental"}};
const MethodOverrides two_halves{{"fill", "two-halves"}, {"lerp", "direct"}};
const MethodOverrides closed{{"fill", "barycentric"}, {"sample", "integer"}};
const MethodOverrides top_left{{"fill", "top-left"}, {"sample", "center"}};

/// The fills that go from row to row: the textbook's, with and without accumulating, and the one in
/// two halves.
void add_row_fills(StressRows& rows, std::string_view json, std::uint64_t pixels,
                   const DocumentedOfScalars& of_direct = {},
                   const DocumentedOfScalars& of_incremental = {},
                   const DocumentedOfScalars& of_halves = {}) {
    rows.add_pictures(json, "scanline", direct, pixels, of_direct);
    rows.add_pictures(json, "scanline, incremental", incremental, pixels, of_incremental);
    rows.add_pictures(json, "two-halves", two_halves, pixels, of_halves);
}

/// An edge from (from_x, 0) to (from_x + dx, dy), walked down row by row and floored, against
/// from_x + floor(y dx / dy), which whole numbers give.
struct WalkedEdge {
    Index from_x;
    Index dx;
    Index dy;

    std::string json() const {
        return fmt::format(R"({{
  "canvas": {{"width": 64, "height": 64, "origin": "top-left"}},
  "vertices": {{"A": [{0}, 0], "B": [{1}, {2}], "C": [{0}, {2}]}},
  "triangles": ["ABC"],
  "method": {{"fill": "scanline", "lerp": "incremental"}}
}})",
                           from_x, from_x + dx, dy);
    }

    Index exact_on_row(Index y) const { return from_x + y * dx / dy; }

    /// Counts the rows that `x_on_row(y)` gets wrong.
    template <typename XOnRow> Measured count(XOnRow&& x_on_row) const {
        Measured measured{.unit = "row", .worst_unit = "px"};
        std::optional<Index> first_wrong;
        for (Index y = 0; y <= dy; ++y) {
            const auto x = x_on_row(y);
            if (floor_index(x) != exact_on_row(y)) {
                ++measured.wrong;
                first_wrong = first_wrong.value_or(y);
            }
            // x - from_x and y dx are whole or short doubles: only the error itself is rounded.
            if constexpr (std::floating_point<std::remove_cvref_t<decltype(x)>>)
                measured.worst = std::max(
                    measured.worst,
                    std::abs(std::fma(static_cast<double>(x) - static_cast<double>(from_x),
                                      static_cast<double>(dy), -static_cast<double>(y * dx))) /
                        static_cast<double>(dy));
        }
        if (first_wrong)
            measured.note = fmt::format("of {}, first at y={}", dy + 1, *first_wrong);
        return measured;
    }

    /// With the core's own walk.
    Measured walk(std::string_view scalar, LerpForm form) const {
        const Scene scene = readable_scene(json(), with_scalar_named({}, scalar));
        return with_numbers_of(scene, [&]<typename Scalar>(const Plan& plan) {
            const Vertex<Scalar> from{place_of<Scalar>(scene, 0, plan), 0};
            const Vertex<Scalar> to{place_of<Scalar>(scene, 1, plan), 1};
            EdgeWalk<Scalar> walk(edge_between(from, to), form, 1);
            return count([&walk](Index y) { return walk.x_on_row(static_cast<int>(y)); });
        });
    }

    /// x = (1 - t) a + t b.
    template <typename Real> Measured mix() const {
        return count([this](Index y) {
            const Real t = static_cast<Real>(y) / static_cast<Real>(dy);
            return (1 - t) * static_cast<Real>(from_x) + t * static_cast<Real>(from_x + dx);
        });
    }

    /// The fixed-point walk that the report measures: the slope truncated, and added row after row.
    Measured fixed_point(int bits) const {
        const Int128 unit = Int128{1} << bits;
        FixedPointWalk<Int128> walk({from_x * unit, 0, (from_x + dx) * unit, dy * unit, unit}, 1, 0,
                                    bits);
        Measured measured{.unit = "row"};
        for (Index y = 0; y <= dy; ++y) {
            walk.step();
            measured.wrong += walk.pixel() == exact_on_row(y) ? 0 : 1;
        }
        return measured;
    }

    void add_to(StressRows& rows, const DocumentedOfScalars& accumulated,
                const DocumentedOfScalars& multiplied) const {
        rows.add_for_all("incremental, x += dx/dy", accumulated, [this](std::string_view scalar) {
            return walk(scalar, LerpForm::incremental);
        });
        rows.add_for_all(
            "direct, x1 + dx/dy (y - y1)", multiplied,
            [this](std::string_view scalar) { return walk(scalar, LerpForm::direct); });
    }

    /// How far off a product may be: the slope is rounded, then the product, then the sum.
    Documented within_of_products(double rounding_unit) const {
        return within(
            rounding_unit *
            (2 * static_cast<double>(std::abs(dx)) + static_cast<double>(std::abs(from_x + dx))) *
            (1 + 4 * rounding_unit));
    }
};

constexpr double float_unit = rounding_unit<float>();
constexpr double double_unit = rounding_unit<double>();

/// S6 on double: the same edge where double has only every second whole number, in the textbook's
/// loop (our indices end at 2^53 - 1).
template <typename AtRow> Measured absorbed_at_2_53(AtRow&& x_on_row) {
    constexpr Index from_x = Index{1} << 53;
    Measured measured{.unit = "row"};
    for (Index y = 0; y <= 2000; ++y)
        measured.wrong +=
            static_cast<Index>(std::floor(x_on_row(y))) == from_x + y * 2 / 2000 ? 0 : 1;
    return measured;
}

constexpr std::string_view s1 = R"({
  "canvas": {"width": 17, "height": 14},
  "vertices": {"A": [2, 5], "B": [-4, -3], "C": [5, -3]},
  "triangles": ["ABC"]
})";

constexpr std::string_view s3 = R"({
  "canvas": {"width": 8, "height": 12, "origin": "top-left"},
  "vertices": {"A": [0, 0], "B": [1, 10], "C": [5, 10]},
  "triangles": ["ABC"],
  "method": {"lerp": "incremental"}
})";

/// A triangle ABC on a canvas whose origin lies at the top or the bottom.
std::string triangle_in(int width, int height, std::string_view origin, std::string_view a,
                        std::string_view b, std::string_view c) {
    return fmt::format(R"({{
  "canvas": {{"width": {}, "height": {}, "origin": "{}-left"}},
  "vertices": {{"A": [{}], "B": [{}], "C": [{}]}},
  "triangles": ["ABC"]
}})",
                       width, height, origin, a, b, c);
}

const std::string s7 = triangle_in(64, 64, "top", "0, 0", "3000000, 1", "-3000000, 1");
const std::string s8 =
    triangle_in(8, 4, "bottom", R"("1/10", "1/5")", R"("53/10", "4/5")", R"(2, "9/10")");

/// S9's three triangles, without height, without extent, without area.
const std::string s9_flat = triangle_in(20, 20, "bottom", "0, 5", "10, 5", "4, 5");
const std::string s9_point = triangle_in(20, 20, "bottom", "5, 5", "5, 5", "5, 5");
const std::string s9_collinear = triangle_in(20, 20, "bottom", "0, 0", "8, 8", "16, 16");

/// S10's square: the two halves, and both.
std::string half_of_square(std::string_view triangles) {
    return fmt::format(R"({{
  "canvas": {{"width": 12, "height": 12, "origin": "top-left"}},
  "vertices": {{"A": [0, 0], "B": [8, 0], "C": [8, 8], "D": [0, 8]}},
  "triangles": [{}]
}})",
                       triangles);
}
const char* const upper_half = R"("ABC")";
const char* const lower_half = R"("ACD")";
const char* const both_halves = R"({"vertices": "ABC", "color": "red"}, "ACD")";

const std::string s11 = triangle_in(64, 64, "top", "0, -1e9", "1e9, 1e9", "-1e9, 1e9");

/// 2^-149 is the smallest float above 0.
constexpr std::string_view s12 = R"({
  "canvas": {"width": 8, "height": 6},
  "vertices": {"A": ["-1/713623846352979940529142984724747568191373312", 0],
               "B": [2, 0], "C": [0, 2]},
  "triangles": ["ABC"]
})";

constexpr std::string_view s13 = R"({
  "canvas": {"width": 8, "height": 8},
  "vertices": {"A": [-0.0, -0.0], "B": [3, -0.0], "C": [-0.0, 3]},
  "triangles": ["ABC"]
})";

std::string s14(std::string_view x) {
    return triangle_in(16, 8, "top", "0, 0", fmt::format("{}, 0", x), "0, 6");
}

/// How many pixels both halves of a square draw.
std::uint64_t drawn_twice(const MethodOverrides& method) {
    const auto one_half = readable_scene(half_of_square(upper_half), method);
    const auto other_half = readable_scene(half_of_square(lower_half), method);
    const auto a = covered_by(exact_corners(one_half, 0), one_half.method, one_half.canvas);
    const auto b = covered_by(exact_corners(other_half, 0), other_half.method, other_half.canvas);
    return common_pixels(a, b);
}

/// How many steps of a kind a scene's trace has, with every scalar; at most `most`.
void add_step_counts(StressRows& rows, std::string_view json, std::string_view label, StepKind kind,
                     std::uint64_t most) {
    rows.add_for_all(label, {}, [&](std::string_view scalar) -> Measured {
        const auto trace = trace_in(json, with_scalar_named({}, scalar));
        const std::uint64_t count = trace ? count_of(trace.value(), kind) : most + 1;
        return {.wrong = count > most ? count - most : 0,
                .unit = "step",
                .note = counted(count, "step")};
    });
}

/// How many pixels the trace of a scene names, plotted or rejected.
std::uint64_t pixels_named(const Trace& trace) {
    std::uint64_t pixels = 0;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        if (trace.kind_of(n) == StepKind::pixel)
            ++pixels;
        if (trace.kind_of(n) == StepKind::reject) {
            const auto reject = trace.step(n).as<RejectStep>();
            pixels += static_cast<std::uint64_t>(reject.to_x.value_or(*reject.x) - *reject.x + 1);
        }
    }
    return pixels;
}

/// S1 attacks the division by the height of an edge: the lower one is horizontal.
void s1_worked_example(StressRows& rows) {
    add_row_fills(rows, s1, 49);
    rows.add_pictures(s1, "barycentric", closed, 43);
}

/// S2 attacks the cast to int, which rounds toward 0, where floor is meant.
void s2_floor_of_negatives(StressRows& rows) {
    rows.add_pictures(s1, "half-open", {{"rounding", "half-open"}}, 41);
    rows.add_pictures(s1, "floor", {{"rounding", "floor"}}, 49);
    rows.add_pictures(s1, "truncate", {{"rounding", "truncate"}}, 45);
    rows.add_pictures(s1, "truncate, taken for floor", {{"rounding", "truncate"}}, 49,
                      {{"all", wrong(4)}}, [](const Scene& scene) {
                          Scene floored = scene;
                          floored.method.rounding = Rounding::floor;
                          return reference_picture(floored);
                      });
}

/// S3 attacks the sum of a slope that no binary number is.
void s3_tenth_ten_times(StressRows& rows) {
    add_row_fills(rows, s3, 35, {}, {{"double", wrong(1)}});
}

/// S4 attacks every rounding of x to the left, in rows where x is whole.
void s4_whole_every_third_row(StressRows& rows) {
    const WalkedEdge edge{0, 1000, 3000};
    edge.add_to(rows, {{"float", wrong(590, "0.024")}, {"double", wrong(409, "4.4e-11")}},
                {{"float", edge.within_of_products(float_unit)},
                 {"double", edge.within_of_products(double_unit)}});
    rows.add("float", "textbook: (1-t) a + t b", edge.mix<float>(), wrong(5));
    for (const auto& [bits, wrong_rows] :
         {std::pair{4, 2983}, std::pair{8, 2743}, std::pair{12, 1000}, std::pair{16, 1000},
          std::pair{20, 1000}, std::pair{24, 1000}, std::pair{28, 1000}, std::pair{32, 1000}})
        rows.add("whole numbers", fmt::format("textbook: slope truncated to .{}", bits),
                 edge.fixed_point(bits), wrong(static_cast<std::uint64_t>(wrong_rows)));
}

/// S5 attacks sums by their length.
void s5_many_rows(StressRows& rows) {
    const WalkedEdge edge{0, 100'000, 700'000};
    edge.add_to(rows, {{"float", wrong(670'337, "337")}, {"double", wrong(70'874, "8.2e-7")}},
                {{"float", edge.within_of_products(float_unit)},
                 {"double", edge.within_of_products(double_unit)}});
}

/// S6 attacks sums whose step is less than half the distance to the next number.
void s6_absorbed_step(StressRows& rows) {
    const WalkedEdge edge{16'777'216, 2, 2000};
    edge.add_to(rows, {{"float", wrong(1001, "2")}, {"double", wrong(2)}},
                {{"float", wrong(1000)}, {"double", edge.within_of_products(double_unit)}});
    const double start = 0x1p53;
    double x = start;
    rows.add("double", "textbook: x += 1/1000, from 2^53", absorbed_at_2_53([&](Index y) {
                 if (y > 0)
                     x += 0.001;
                 return x;
             }),
             wrong(1001));
    rows.add("double", "textbook: 2^53 + y/1000",
             absorbed_at_2_53([&](Index y) { return start + 0.001 * static_cast<double>(y); }),
             wrong(1000));
}

/// S7 attacks fills that visit, or tell, each pixel outside of the canvas.
void s7_wide_row(StressRows& rows) {
    add_row_fills(rows, s7, 65);
    for (const std::string_view scalar : scalar_names()) {
        const auto trace = trace_in(s7, with_scalar_named({}, scalar));
        rows.expect_same(scalar, "pixels plotted or rejected",
                         trace ? pixels_named(trace.value()) : 0, 6'000'002, "pixel");
    }
    add_step_counts(rows, s7, "steps that reject, at most 2", StepKind::reject, 2);
}

/// S8 attacks fills that round their vertices first.
void s8_between_rows(StressRows& rows) {
    add_row_fills(rows, s8, 0);
    rows.add_pictures(s8, "scanline, vertices rounded", {{"snap", "nearest"}}, 0,
                      {{"all", wrong(5)}}, [](const Scene& scene) {
                          Scene unsnapped = scene;
                          unsnapped.method.snap = Snap::none;
                          return reference_picture(unsnapped);
                      });
}

/// S9 attacks slopes of edges without height, and the choice of a left and a right edge.
void s9_no_area(StressRows& rows) {
    for (const auto& [json, pixels] :
         {std::pair{s9_flat, 11u}, std::pair{s9_point, 1u}, std::pair{s9_collinear, 17u}}) {
        add_row_fills(rows, json, pixels);
        rows.add_pictures(json, "top-left", top_left, 0);
        rows.add_pictures(json, "barycentric", closed, 0);
    }
}

/// S10 attacks rows that include both ends: neighbors draw their common edge twice.
void s10_shared_edge(StressRows& rows) {
    const MethodOverrides closed_centers{{"fill", "barycentric"}, {"sample", "center"}};
    rows.add_pictures(half_of_square(upper_half), "scanline, upper", direct, 45);
    rows.add_pictures(half_of_square(lower_half), "scanline, lower", direct, 45);
    rows.add_pictures(half_of_square(both_halves), "scanline, both", direct, 81);
    rows.add_pictures(half_of_square(upper_half), "top-left, upper", top_left, 36);
    rows.add_pictures(half_of_square(lower_half), "top-left, lower", top_left, 28);
    rows.add_pictures(half_of_square(both_halves), "top-left, both", top_left, 64);
    rows.add_pictures(half_of_square(both_halves), "barycentric, both", closed_centers, 64);
    const auto twice = [&rows](std::string_view label, const MethodOverrides& method,
                               const Documented& documented) {
        rows.add("reference", label, {.wrong = drawn_twice(method), .unit = "pixel"}, documented);
    };
    twice("scanline, drawn twice", direct, wrong(9));
    twice("barycentric, drawn twice", closed_centers, wrong(8));
    twice("top-left, drawn twice", top_left, right());
}

/// S11 attacks loops over the rows outside of the canvas.
void s11_many_rows_outside(StressRows& rows) {
    add_row_fills(rows, s11, 4096);
    rows.add_pictures(s11, "top-left", top_left, 4096);
    add_step_counts(rows, s11, "steps of rows, at most 64", StepKind::scanline, 64);
}

/// S12 attacks slopes that underflow.
void s12_least_float(StressRows& rows) {
    const DocumentedOfScalars lost{{"float", wrong(2)}};
    add_row_fills(rows, s12, 8, lost, lost, lost);
}

/// S13 attacks the sign of 0.
void s13_minus_zero(StressRows& rows) {
    add_row_fills(rows, s13, 10);
    rows.add_pictures(s13, "top-left", top_left, 3);
    rows.add_for_all("-0 in the trace", {}, [](std::string_view scalar) {
        std::string text;
        StringOutput output(text);
        write_trace(readable_scene(s13, with_scalar_named({}, scalar)), {}, output);
        Measured measured{.unit = "number"};
        for (const std::string_view minus_zero : {"-0,", "-0]", "-0}", "-0\"", "-0.0"})
            for (auto at = text.find(minus_zero); at != std::string::npos;
                 at = text.find(minus_zero, at + 1))
                ++measured.wrong;
        return measured;
    });
}

/// S14 attacks casts to int of numbers that it does not hold.
void s14_beyond_int(StressRows& rows) {
    rows.add_pictures(s14("3e9"), "scanline, x = 3e9", direct, 97);
    const auto too_large = refused("found vertex B at (1e+300, 0)");
    rows.add_pictures(s14("1e300"), "scanline, x = 1e300", direct, 97,
                      {{"float", refused("vertex B")}, {"fixed", too_large}});
    rows.add_refusals(s14("NaN"), "x = NaN", "NaN");
    rows.add_refusals(s14("1e400"), "x = 1e400", "1e400");
}

constexpr auto scanline_catalogue = std::to_array<StressCase>({
    {.id = "S1",
     .title = "the worked example",
     .input = "A(2,5) B(-4,-3) C(5,-3)",
     .why = "B-C is horizontal: the text's own LERP(-3,-3) divides by zero",
     .holds = "rows y=-3..5: [-4,5] [-4,4] [-3,4] [-2,3] [-1,3] [-1,3] [0,2] [1,2] [2,2]; 49 "
              "pixels. The closed triangle has 43, by Pick's theorem.",
     .scenes = [] { return only(s1); },
     .run = s1_worked_example},
    {.id = "S2",
     .title = "floor of negatives",
     .input = "A(2,5) B(-4,-3) C(5,-3), its ends cast to int",
     .why = "a cast goes to zero, not down",
     .holds = "floor: 49 pixels. Truncated, the left ends of rows y=-2,-1,0,2 are one to the "
              "right: 4 pixels lost, 45 left.",
     .scenes = [] { return only(s1); },
     .run = s2_floor_of_negatives},
    {.id = "S3",
     .title = "a tenth, ten times",
     .input = "(0,0)(1,10)(5,10)",
     .why = "1/10 is no sum of powers of two: ten of them make 0.9999999999999999",
     .holds = "the last row is [1,5]; double, accumulated, draws [0,5]. Float happens to be right.",
     .scenes = [] { return only(s3); },
     .run = s3_tenth_ten_times},
    {.id = "S4",
     .title = "x whole in every third row",
     .input = "edge (0,0)-(1000,3000), floored",
     .why = "where x is whole, the least error to the left is a wrong pixel",
     .holds = "floor(y/3) in 3001 rows. Multiplied: every row right. Accumulated: wrong in 590 "
              "(float) and 409 (double). Fixed point with a truncated slope is wrong in every "
              "row whose x is whole, with any number of bits.",
     .scenes =
         [] {
             return only(WalkedEdge{0, 1000, 3000}.json());
         },
     .run = s4_whole_every_third_row},
    {.id = "S5",
     .title = "700,001 rows",
     .input = "edge (0,0)-(100000,700000), floored",
     .why = "as S4, and longer",
     .holds = "floor(y/7). Multiplied: every row right. Accumulated: 670,337 rows wrong in float, "
              "70,874 in double.",
     .scenes =
         [] {
             return only(WalkedEdge{0, 100'000, 700'000}.json());
         },
     .run = s5_many_rows},
    {.id = "S6",
     .title = "a step that is absorbed",
     .input = "edge (16777216,0)-(16777218,2000), floored",
     .why = "1/1000 added to 2^24 is nothing: float's next number is 2 away",
     .holds = "16777216 + floor(y/1000). Float: accumulated, never moves; multiplied, jumps by "
              "2 once. At 2^53 double fails alike.",
     .run = s6_absorbed_step},
    {.id = "S7",
     .title = "3,000,000 px in one row",
     .input = "(0,0)(3000000,1)(-3000000,1)",
     .why = "dx/dy = 3e6: the row is a hundred thousand canvases wide",
     .holds = "rows [0,0] and [-3000000,3000000], 6,000,002 pixels; on 64x64: [0,0] and [0,63]. "
              "What the canvas does not have is two steps, not six million.",
     .scenes = [] { return only(s7); },
     .run = s7_wide_row},
    {.id = "S8",
     .title = "between two rows",
     .input = "(1/10,1/5)(53/10,4/5)(2,9/10)",
     .why = "no row of pixels meets it",
     .holds = "nothing is drawn; vertices rounded first (`snap: nearest`) draw 5 pixels",
     .scenes = [] { return only(s8); },
     .run = s8_between_rows},
    {.id = "S9",
     .title = "flat, a point, collinear",
     .input = "(0,5)(10,5)(4,5); (5,5) three times; (0,0)(8,8)(16,16)",
     .why = "0/0 in a slope; no middle row tells left from right",
     .holds = "scanline: 11, 1 and 17 pixels; top-left: none, it has no area",
     .scenes =
         [] {
             return std::vector<StressScene>{
                 {"flat", s9_flat}, {"point", s9_point}, {"collinear", s9_collinear}};
         },
     .run = s9_no_area},
    {.id = "S10",
     .title = "an edge that two triangles share",
     .input = "square (0,0)-(8,8), split on (0,0)-(8,8)",
     .why = "rows with both ends included, and closed triangles, share their edge's pixels",
     .holds = "scanline: 45 + 45 pixels, 9 of them twice, 81 in all. Top-left: 36 + 28, none "
              "twice, 64. Barycentric, closed, at centers: 8 twice.",
     .scenes = [] { return only(half_of_square(both_halves)); },
     .run = s10_shared_edge},
    {.id = "S11",
     .title = "two billion rows",
     .input = "(0,-1e9)(1e9,1e9)(-1e9,1e9) on 64x64",
     .why = "2,000,000,001 rows, of which the canvas has 64",
     .holds = "4,096 pixels, at most 64 steps of rows; no time is spent outside",
     .scenes = [] { return only(s11); },
     .run = s11_many_rows_outside},
    {.id = "S12",
     .title = "the smallest number left of 0",
     .input = "(-2^-149,0)(2,0)(0,2)",
     .why = "the least number of float: half of it, the edge's slope, is 0",
     .holds = "rows [-1,2] [-1,1] [0,0]: floor sees the least step to the left of 0. In float the "
              "edge is vertical, and two pixels are lost.",
     .scenes = [] { return only(s12); },
     .run = s12_least_float},
    {.id = "S13",
     .title = "minus zero",
     .input = "(-0.0,-0.0)(3,-0.0)(-0.0,3)",
     .why = "-0 equals 0, but prints otherwise and divides to the other infinity",
     .holds = "the picture of 0; the trace prints 0",
     .scenes = [] { return only(s13); },
     .run = s13_minus_zero},
    {.id = "S14",
     .title = "numbers that no int holds",
     .input = "x = 3e9; x = 1e300; x = NaN",
     .why = "casting them to int is undefined",
     .holds = "drawn as far as the canvas goes, or refused with the vertex named, before any cast",
     .scenes =
         [] {
             return Scenes{{"3e9", s14("3e9")}, {"1e300", s14("1e300")}};
         },
     .run = s14_beyond_int},
});

} // namespace

std::span<const StressCase> scanline_cases() {
    return scanline_catalogue;
}

} // namespace rastertrace
