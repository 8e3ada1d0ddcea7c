// SPDX-License-Identifier: MIT
// The report of error against run time. Expected counts are those of numerics.md, part B, worked out
// there in exact rationals and in single operations of IEEE arithmetic.

#include "../effort.h"
#include "../picture.h"

#include <rastertrace/numerics/knobs.h>
#include <rastertrace/numerics/report.h>
#include <rastertrace/trace/scene/scene_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

/// As quick as can be: times are not what is tested.
ReportOptions only(ReportJob job) {
    return {
        .jobs = {job}, .timing = {.runs = 1, .shortest_run = 0, .most_time = 0}, .progress = {}};
}

JobReport report_of_job(const Scene& scene, ReportJob job) {
    return report_of(scene, only(job)).jobs.front();
}

const Curve& curve_of(const JobReport& job, std::string_view method) {
    for (const Curve& curve : job.curves)
        if (curve.method == method)
            return curve;
    throw std::runtime_error("no such curve: " + std::string(method));
}
const Setting& setting_of(const JobReport& job, std::string_view method, std::string_view name) {
    for (const Setting& setting : curve_of(job, method).settings)
        if (setting.name == name)
            return setting;
    throw std::runtime_error("no such setting: " + std::string(name));
}
std::uint64_t wrong(const JobReport& job, std::string_view method, std::string_view name) {
    for (const ErrorValue& error : setting_of(job, method, name).errors)
        if (error.count)
            return *error.count;
    throw std::runtime_error("it counts nothing");
}
std::vector<std::uint64_t> wrongs(const JobReport& job, std::string_view method) {
    std::vector<std::uint64_t> counts;
    for (const Setting& setting : curve_of(job, method).settings)
        counts.push_back(wrong(job, method, setting.name));
    return counts;
}
double error(const JobReport& job, std::string_view method, std::string_view name,
             std::size_t measure) {
    return setting_of(job, method, name).errors.at(measure).value.value();
}

/// Case S4: x is a whole number in every third row.
Scene s4() {
    Scene scene;
    scene.title = "S4";
    scene.canvas = {.width = 1001, .height = 3001, .origin = Origin::top_left};
    scene.vertices = {{"A", 0, 0}, {"B", 1000, 3000}};
    scene.primitives = {
        {.kind = PrimitiveKind::line, .name = "AB", .vertices = {0, 1}, .color = {}}};
    return scene;
}

TEST(EdgeReport, CountsTheWrongRowsOfS4) {
    const JobReport job = report_of_job(s4(), ReportJob::edge);
    EXPECT_EQ(job.units, 3001U);
    EXPECT_EQ(wrong(job, "x += a, float", "never"), 590U);
    EXPECT_EQ(wrong(job, "x += a, double", "never"), 409U);
    EXPECT_NEAR(error(job, "x += a, float", "never", 1), 0.024, 0.0005);
    EXPECT_NEAR(error(job, "x += a, double", "never", 1), 4.4e-11, 0.05e-11);
    EXPECT_THAT(wrongs(job, "x1 + a (y - y1)"), ElementsAre(0U, 0U, 0U));
    EXPECT_EQ(wrong(job, "(1 - t) x1 + t x2", "float"), 5U);
    EXPECT_EQ(wrong(job, "x += a, fixed point", "4 bits"), 2983U);
    EXPECT_EQ(wrong(job, "x += a, fixed point", "8 bits"), 2743U);
    EXPECT_EQ(wrong(job, "x += a, fixed point", "12 bits"), 1000U);
    EXPECT_EQ(wrong(job, "x += a, fixed point", "16 bits"), 1000U);
}

TEST(EdgeReport, WholeNumbersHaveNoErrorAtAll) {
    const JobReport job = report_of_job(s4(), ReportJob::edge);
    EXPECT_EQ(error(job, "pixel and rest, whole numbers", "64 bits", 0), 0);
    EXPECT_EQ(error(job, "pixel and rest, whole numbers", "64 bits", 1), 0);
    EXPECT_EQ(error(job, "x1 + a (y - y1)", "exact", 1), 0);
}

TEST(EdgeReport, BeginningAnewInEveryRowIsTheDirectForm) {
    const JobReport job = report_of_job(s4(), ReportJob::edge);
    for (const auto& [curve, scalar] :
         {std::pair{"x += a, float", "float"}, std::pair{"x += a, double", "double"}}) {
        EXPECT_EQ(wrong(job, curve, "every row"), wrong(job, "x1 + a (y - y1)", scalar));
        EXPECT_EQ(error(job, curve, "every row", 1), error(job, "x1 + a (y - y1)", scalar, 1));
    }
}

TEST(EdgeReport, TheLargestErrorGrowsWithTheIntervalAndShrinksWithTheBits) {
    const JobReport job = report_of_job(s4(), ReportJob::edge);
    for (const auto& [curve, growth] :
         {std::pair{"x += a, float", 1}, std::pair{"x += a, double", 1},
          std::pair{"x += a, fixed point", -1}}) {
        double before = growth > 0 ? 0 : 1e9;
        for (const Setting& setting : curve_of(job, curve).settings) {
            const double now = setting.errors[1].value.value();
            EXPECT_GE(growth * now, growth * before) << curve << " " << setting.name;
            before = now;
        }
    }
}

// The direct form subtracts, multiplies and adds in every row; setting the edge up takes two
// subtractions, a comparison and a division.
TEST(EdgeReport, CountsWhatIsDone) {
    const JobReport job = report_of_job(s4(), ReportJob::edge);
    const Work work = setting_of(job, "x1 + a (y - y1)", "double").work.value();
    EXPECT_EQ(work.multiplies, 3001U);
    EXPECT_EQ(work.adds, 2 * 3001U + 2);
    EXPECT_EQ(work.divides, 1U);
    EXPECT_EQ(work.comparisons, 1U);
    EXPECT_EQ(setting_of(job, "x += a, float", "every 64 rows").work.value().multiplies, 47U);
}

TEST(EdgeReport, ListsWhatDoesNotFit) {
    Scene scene = s4();
    scene.vertices = {{"A", 0, 0}, {"B", Number::decimal(1, 300), 1000}};
    const JobReport job = report_of_job(scene, ReportJob::edge);
    EXPECT_EQ(setting_of(job, "x1 + a (y - y1)", "float").failure,
              "an edge or its slope is beyond the largest float");
    EXPECT_EQ(setting_of(job, "x += a, float", "every 4 rows").failure,
              "an edge or its slope is beyond the largest float");
    EXPECT_EQ(setting_of(job, "x += a, fixed point", "8 bits").failure,
              "an edge, or its slope times its height, needs more than 64 bits");
    EXPECT_EQ(setting_of(job, "pixel and rest, whole numbers", "128 bits").failure,
              "an edge needs more than 128 bits");
    EXPECT_EQ(error(job, "x1 + a (y - y1)", "exact", 1), 0) << "rationals hold any edge";
}

TEST(EdgeReport, ASceneWithoutEdgesHasNothingToMeasure) {
    Scene scene = s4();
    scene.primitives = {{.kind = PrimitiveKind::point, .name = "A", .vertices = {0}, .color = {}}};
    const SceneReport report =
        report_of(scene, {.timing = only(ReportJob::edge).timing, .progress = {}});
    EXPECT_FALSE(report.has_measured());
    EXPECT_EQ(report.jobs[0].nothing, "the scene has no edge that passes a row of pixels");
    EXPECT_EQ(report.jobs[1].nothing, "the scene has no triangle to fill");
    EXPECT_EQ(report.jobs[2].nothing, "the scene has no depth");
    EXPECT_EQ(report.jobs[3].nothing, "the scene has no triangle with colored vertices");
}

// The diagonal of C13 is moved by the grid: 36 pixels, snapped to 1/256 only 28. That is what `fixed`
// costs; against exact arithmetic on the snapped triangle it has no error.
TEST(CoverageReport, FixedIsExactOnWhatItHasSnapped) {
    const Scene scene = triangle_scene({"0", "0", "8", "0", "0", "8193/1024"},
                                       {.width = 16, .height = 16, .origin = Origin::top_left},
                                       {.scalar = ScalarKind::exact, .fill = Fill::top_left});
    const JobReport job = report_of_job(scene, ReportJob::coverage);
    EXPECT_EQ(job.units, 36U);
    EXPECT_EQ(wrong(job, "top-left, fixed point", "8 bits"), 8U);
    EXPECT_EQ(wrong(job, "top-left, fixed point", "12 bits"), 0U);
    EXPECT_EQ(wrong(job, "top-left, scalars", "exact"), 0U);
    for (const Setting& setting : curve_of(job, "top-left, fixed point").settings)
        EXPECT_EQ(setting.wrong_when_snapped, 0U) << setting.name;
}

TEST(CoverageReport, FixedIsExactOnAnySnappedVertices) {
    std::mt19937_64 random(20220705);
    const auto coordinate = [&random] {
        return std::to_string(static_cast<int>(random() % 4000)) + "/" +
               std::to_string(1 + static_cast<int>(random() % 97));
    };
    for (int i = 0; i < 40; ++i) {
        const Scene scene = triangle_scene(
            {coordinate(), coordinate(), coordinate(), coordinate(), coordinate(), coordinate()},
            {.width = 40, .height = 40, .origin = Origin::bottom_left},
            {.scalar = ScalarKind::exact,
             .fill = i % 3 == 0   ? Fill::barycentric
                     : i % 3 == 1 ? Fill::two_halves
                                  : Fill::scanline});
        for (const Curve& curve : report_of_job(scene, ReportJob::coverage).curves)
            for (const Setting& setting : curve.settings)
                EXPECT_EQ(setting.wrong_when_snapped.value_or(0), 0U)
                    << i << " " << curve.method << " " << setting.name;
    }
}

TEST(CoverageReport, TheErrorShrinksWithTheBits) {
    const Scene scene = triangle_scene({"1/3", "1/7", "59.3", "22.9", "11.1", "61.7"},
                                       {.width = 64, .height = 64, .origin = Origin::top_left});
    const JobReport job = report_of_job(scene, ReportJob::coverage);
    for (const std::string fill : {"scanline", "top-left"}) {
        const auto counts = wrongs(job, fill + ", fixed point");
        EXPECT_GT(counts.front(), 0U);
        EXPECT_TRUE(std::is_sorted(counts.rbegin(), counts.rend()));
        EXPECT_EQ(counts.back(), 0U);
        for (const Setting& setting : curve_of(job, fill + ", fixed point").settings)
            EXPECT_EQ(setting.wrong_when_snapped, 0U) << fill << " " << setting.name;
    }
}

/// Case Z2: a steep triangle through a flat one. Linear z shows the wrong one in 735 of 2016 pixels.
Scene z2() {
    Scene scene;
    scene.title = "Z2";
    scene.canvas = {.width = 64, .height = 64, .origin = Origin::top_left};
    scene.vertices = {{"A", 0, 0, {}, 1}, {"B", 64, 0, {}, 9}, {"C", 0, 64, {}, 1},
                      {"D", 0, 0, {}, 4}, {"E", 64, 0, {}, 4}, {"F", 0, 64, {}, 4}};
    scene.primitives = {
        {.kind = PrimitiveKind::triangle, .name = "ABC", .vertices = {0, 1, 2}, .color = {}},
        {.kind = PrimitiveKind::triangle, .name = "DEF", .vertices = {3, 4, 5}, .color = {}}};
    scene.method.fill = Fill::top_left;
    scene.method.depth = Depth::inverse_z;
    return scene;
}

TEST(DepthReport, CountsTheWrongWinnersOfZ2) {
    const JobReport job = report_of_job(z2(), ReportJob::depth);
    EXPECT_EQ(setting_of(job, "linear-z", "exact").errors[0].of, 2016U);
    EXPECT_THAT(wrongs(job, "linear-z"), Each(735U));
    EXPECT_THAT(wrongs(job, "inverse-z"), Each(0U));
    EXPECT_EQ(error(job, "inverse-z", "exact", 1), 0);
    EXPECT_LT(error(job, "inverse-z", "double", 1), 1e-15);
    // Nearest vertex first: ABC covers DEF everywhere, and is 45 pixels too much.
    EXPECT_EQ(wrong(job, "painter", "nearest"), 2016U - 1971U);
    // Half a code of a buffer from the nearest vertex, 1, to infinity, 0, against 1/9 at the far end.
    EXPECT_LE(error(job, "inverse-z, stored", "16 bits", 1), 0.5 / 65535 * 9 * 1.01);
    EXPECT_GT(error(job, "inverse-z, stored", "16 bits", 1),
              error(job, "inverse-z, stored", "24 bits", 1));
    EXPECT_GT(error(job, "inverse-z, stored", "24 bits", 1),
              error(job, "inverse-z, stored", "32 bits", 1));
}

/// Squares of 16 x 32 pixels at these distances, parallel to the screen, drawn in this order. In clip
/// space as a frustum from `near` to `far` has them.
struct Squares {
    std::vector<Rational> distances;
    Rational near{1, 10};
    Rational far{1000};

    Scene scene(Projection projection, const Viewport& viewport = {}) const {
        Scene scene;
        scene.title = "squares";
        scene.canvas = {.width = 32, .height = 32, .origin = Origin::top_left};
        projection.near = Number::fraction(near);
        projection.far = Number::fraction(far);
        const bool is_clip = projection.type == ProjectionType::clip_space;
        scene.projection = projection;
        if (is_clip)
            scene.projection = {.type = projection.type};
        scene.viewport = viewport;
        scene.viewport.type = ViewportType::pixels;
        scene.viewport.pixels = PixelRange::edges;
        scene.method.fill = Fill::top_left;
        for (const Rational& z : distances) {
            const Rational size = is_perspective(projection.type) ? z : Rational(1);
            const Rational depth =
                is_clip ? Rational(((far + near) * z - 2 * far * near) / (far - near))
                : projection.type == ProjectionType::pinhole ? z
                                                             : Rational(-z);
            const std::size_t first = scene.vertices.size();
            for (const auto& [x, y] :
                 std::vector<std::pair<int, int>>{{-1, -1}, {0, -1}, {0, 1}, {-1, 1}})
                scene.vertices.push_back({std::to_string(scene.vertices.size()),
                                          Number::fraction(x * size),
                                          Number::fraction(y * size),
                                          {},
                                          Number::fraction(depth),
                                          is_clip ? Number::fraction(z) : Number(1)});
            for (const std::size_t second : {first + 1, first + 2})
                scene.primitives.push_back({.kind = PrimitiveKind::triangle,
                                            .name = std::to_string(scene.primitives.size()),
                                            .vertices = {first, second, second + 1},
                                            .color = {}});
        }
        return scene;
    }

    /// far (z - near)/(z (far - near)), from 0 at the near plane to 1 at the far one: in so many codes.
    Rational code(const Rational& z, const Rational& codes) const {
        const Rational depth = far * (z - near) / (z * (far - near)) * codes + Rational(1, 2);
        mpz_class whole;
        mpz_fdiv_q(whole.get_mpz_t(), depth.get_num_mpz_t(), depth.get_den_mpz_t());
        return Rational(whole);
    }
    /// How far 1/z is off, if it is read back from the code.
    double error(const Rational& z, const Rational& codes) const {
        const Rational read = (far - code(z, codes) / codes * (far - near)) / (far * near);
        return std::abs(Rational(read * z - 1).get_d());
    }
};

// The codes of issue 78: near 0.1, far 1000, 16 bits. z = 502 and z = 500 have one code, and what is drawn first
// stays in all pixels; 1/z at 500 is off by 3.4 %.
TEST(DepthReport, CodesOfWholeNumbersGoFromTheNearPlaneToTheFarOne) {
    const Squares squares{{502, 500}};
    const Rational codes = 65535;
    EXPECT_EQ(squares.code(502, codes), 65528);
    EXPECT_EQ(squares.code(500, codes), 65528);
    EXPECT_NEAR(squares.error(500, codes), 0.034, 0.0005);

    const Projection frustum{.type = ProjectionType::frustum,
                             .left = Number::decimal(-1, -1),
                             .right = Number::decimal(1, -1),
                             .bottom = Number::decimal(-1, -1),
                             .top = Number::decimal(1, -1)};
    const auto ranged = [](int near, int far) {
        return Viewport{.depths = DepthRange<Number>{near, far}};
    };
    for (const Scene& scene :
         {squares.scene(frustum), squares.scene(frustum, ranged(0, 1)),
          squares.scene(frustum, ranged(1, 0)), squares.scene({.type = ProjectionType::pinhole}),
          squares.scene({.type = ProjectionType::view_plane}),
          squares.scene({.type = ProjectionType::clip_space})}) {
        const JobReport job = report_of_job(scene, ReportJob::depth);
        for (const std::string kind : {"ndc-z", "inverse-z"}) {
            // The z of clip space says nothing of the eye's distance from its planes.
            if (kind == "inverse-z" && scene.projection.type == ProjectionType::clip_space)
                continue;
            const std::string curve = kind + ", stored";
            EXPECT_EQ(wrong(job, curve, "16 bits"), 512U) << kind;
            EXPECT_EQ(setting_of(job, curve, "16 bits").errors[0].of, 512U);
            EXPECT_NEAR(error(job, curve, "16 bits", 1),
                        std::max(squares.error(500, codes), squares.error(502, codes)), 1e-6)
                << kind;
            EXPECT_EQ(wrong(job, curve, "32 bits"), 0U) << kind;
        }
    }
}

TEST(DepthReport, CodesOfAParallelViewAreEvenlySpaced) {
    const Projection parallel{.type = ProjectionType::orthographic};
    for (const auto& [distances, wrong_ones] :
         {std::pair(std::vector{Rational(52, 5), Rational(101, 10)}, 512U), // code 10 for both
          std::pair(std::vector{Rational(53, 5), Rational(52, 5)}, 0U)}) {
        const Squares squares{distances, 0, 65535};
        const JobReport job = report_of_job(squares.scene(parallel), ReportJob::depth);
        EXPECT_EQ(wrong(job, "linear-z, stored", "16 bits"), wrong_ones);
        EXPECT_EQ(wrong(job, "ndc-z, stored", "16 bits"), wrong_ones);
    }
}

// Half a code before the far plane, a depth is stored as what the buffer is cleared to.
TEST(DepthReport, WhatHasTheLastCodeIsNotSeen) {
    const Squares squares{{995}};
    EXPECT_EQ(squares.code(995, 65535), 65535);
    const JobReport job =
        report_of_job(squares.scene({.type = ProjectionType::pinhole}), ReportJob::depth);
    EXPECT_EQ(wrong(job, "ndc-z, stored", "16 bits"), 512U);
    EXPECT_EQ(wrong(job, "ndc-z, stored", "24 bits"), 0U);
}

// One triangle is drawn right by any order and any depth. On others of its kind, the painter and the depths of another
// kind of view are wrong.
TEST(DepthReport, AdvisesWhatIsRightInScenesOfThisKind) {
    for (const auto& [type, not_right] : {std::pair(ProjectionType::pinhole, "linear-z"),
                                          std::pair(ProjectionType::orthographic, "inverse-z")}) {
        const JobReport job = report_of_job(Squares{{5}}.scene({.type = type}), ReportJob::depth);
        for (const std::string& advice : job.advice)
            EXPECT_THAT(advice,
                        testing::Not(testing::AnyOf(HasSubstr("painter"), HasSubstr(not_right))));
        for (const Curve& curve : job.curves)
            EXPECT_EQ(curve.is_apart,
                      curve.method == "painter" || curve.method.starts_with(not_right))
                << curve.method;
    }
}

/// Z2 in a perspective, from an eye at the origin, with colors.
Scene z2_in_perspective() {
    Scene scene = z2();
    scene.projection = {.type = ProjectionType::pinhole, .distance = 1};
    for (SceneVertex& vertex : scene.vertices) {
        vertex.x = Number::fraction(vertex.x.exact() * vertex.z.exact());
        vertex.y = Number::fraction(vertex.y.exact() * vertex.z.exact());
    }
    scene.vertices[0].color = Color(255, 0, 0);
    scene.vertices[1].color = Color(0, 255, 0);
    scene.vertices[2].color = Color(0, 0, 255);
    return scene;
}

TEST(ColorReport, DividingLessOftenIsLessExact) {
    const JobReport job = report_of_job(z2_in_perspective(), ReportJob::color);
    EXPECT_EQ(error(job, "in space, divided in each pixel", "exact", 0), 0);
    double before = 0;
    for (const Setting& setting : curve_of(job, "in space, double").settings) {
        EXPECT_GE(setting.errors[0].value.value(), before) << setting.name;
        before = setting.errors[0].value.value();
    }
    EXPECT_GT(before, 1);
    EXPECT_GT(error(job, "on the screen (affine)", "exact", 0), before);
}

/// A scene of examples/numerics.
Scene example(const std::string& name) {
    const std::string path = RASTERTRACE_EXAMPLES "/numerics/" + name + ".json";
    std::ifstream file(path);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    return read_scene({path, text}).value().scene;
}

// The extreme scene is clipped: colors that clipping makes are rounded as the method rounds.
TEST(ColorReport, WhatNeverErrsHasNoErrorOnAnyExample) {
    for (const std::string name : {"friendly", "extreme"})
        for (const Curve& curve : report_of_job(example(name), ReportJob::color).curves)
            for (const Setting& setting : curve.settings)
                if (setting.never_errs) {
                    EXPECT_EQ(setting.errors.at(1).count, 0U)
                        << name << ", " << name_of(curve, setting);
                }
}

/// The settings of `adaptive`, as far as fractions do not serve.
std::vector<Setting> adaptive_settings(const JobReport& job) {
    std::vector<Setting> settings;
    for (const Curve& curve : job.curves)
        for (const Setting& setting : curve.settings)
            if (setting.name.starts_with("adaptive"))
                settings.push_back(setting);
    return settings;
}

TEST(AdaptiveReport, HasNoErrorInPixelsAndWinnersOfTheExamples) {
    for (const std::string name : {"friendly", "stiff", "extreme"}) {
        const Scene scene = example(name);
        const JobReport coverage = report_of_job(scene, ReportJob::coverage);
        EXPECT_FALSE(adaptive_settings(coverage).empty());
        for (const Setting& setting : adaptive_settings(coverage)) {
            EXPECT_EQ(setting.failure, "") << name;
            EXPECT_EQ(setting.errors.at(0).value, 0) << name;
        }
        const JobReport depth = report_of_job(scene, ReportJob::depth);
        EXPECT_EQ(wrong(depth, "inverse-z", "adaptive"), 0U) << name;
        EXPECT_EQ(wrong(depth, "linear-z", "adaptive"), wrong(depth, "linear-z", "exact")) << name;
        // It holds doubles.
        EXPECT_LT(error(depth, "inverse-z", "adaptive", 1), 1e-9) << name;
    }
}

TEST(AdaptiveReport, MixesTheColorsOfExactNumbers) {
    const std::vector<std::string> names{"friendly", "stiff", "extreme"};
    for (std::size_t i = 0; i < std::max<std::size_t>(1, all_cases(names.size())); ++i) {
        const std::string& name = names[i];
        const JobReport job = report_of_job(example(name), ReportJob::color);
        for (const std::string curve :
             {"on the screen (affine)", "in space, divided in each pixel"}) {
            const Setting& exact = setting_of(job, curve, "exact");
            const Setting& adaptive = setting_of(job, curve, "adaptive");
            EXPECT_EQ(adaptive.failure, "") << name << ", " << curve;
            EXPECT_EQ(adaptive.errors.at(0).value, exact.errors.at(0).value) << name << curve;
            EXPECT_EQ(adaptive.errors.at(1).count, exact.errors.at(1).count) << name << curve;
        }
    }
}

// Two triangles lie in one plane, and others share their corners with samples.
TEST(AdaptiveReport, CountsWhatTookExactNumbers) {
    const Scene scene = example("extreme");
    const JobReport coverage = report_of_job(scene, ReportJob::coverage);
    const Setting& filled = setting_of(coverage, "top-left, scalars", "adaptive");
    EXPECT_GT(filled.work.value().exact_fallbacks, 0U);
    EXPECT_FALSE(filled.work.value().has_operations);
    EXPECT_THAT(filled.note, HasSubstr("left open, and filled in rationals"));
    const JobReport depth = report_of_job(scene, ReportJob::depth);
    const Setting& tested = setting_of(depth, "inverse-z", "adaptive");
    EXPECT_GT(tested.work.value().exact_fallbacks, 1000U) << "a plane that is cut twice";
}

// Each fragment is worked on once for each run, as by every other scalar: nothing is placed or drawn.
TEST(AdaptiveReport, IsTimedForTheUnitsOfTheOtherScalars) {
    const Scene scene = example("friendly");
    for (const ReportJob which : {ReportJob::coverage, ReportJob::depth, ReportJob::color}) {
        const JobReport job = report_of_job(scene, which);
        for (const Curve& curve : job.curves)
            for (const Setting& setting : curve.settings)
                if (setting.name == "adaptive") {
                    EXPECT_EQ(setting.units, curve.settings.back().units) << curve.method;
                    EXPECT_EQ(setting.work.value().pixels_tested,
                              curve.settings.back().work.value().pixels_tested)
                        << curve.method;
                }
    }
}

// In row 1 the edge CA is at x = 1: one piece takes exact numbers, and it is the only one.
TEST(AdaptiveReport, CountsTheOneTie) {
    const Scene scene = triangle_scene({"0.999999999999999999999999999999", "0", "5", "1",
                                        "1.000000000000000000000000000001", "2"},
                                       {.width = 12, .height = 12});
    const JobReport job = report_of_job(scene, ReportJob::coverage);
    EXPECT_EQ(setting_of(job, "scanline, scalars", "adaptive").work.value().exact_fallbacks, 1U);
    EXPECT_EQ(setting_of(job, "scanline, scalars", "exact").work.value().exact_fallbacks, 0U);
}

TEST(AdaptiveReport, FractionsServeWhereTheyFit) {
    const JobReport job = report_of_job(first_triangle(), ReportJob::coverage);
    EXPECT_EQ(wrong(job, "scanline, scalars", "adaptive"), 0U);
    EXPECT_TRUE(setting_of(job, "scanline, scalars", "adaptive").work.value().has_operations);
}

// Lines are drawn too, but they are not what is measured.
TEST(AdaptiveReport, OnlyTrianglesAreMeasured) {
    Scene scene = triangle_scene({"1e-30", "0", "5", "0", "0", "5"}, {.width = 12, .height = 12});
    scene.primitives.insert(
        scene.primitives.begin(),
        {.kind = PrimitiveKind::line, .name = "AB", .vertices = {0, 1}, .color = {}});
    const JobReport job = report_of_job(scene, ReportJob::coverage);
    EXPECT_EQ(wrong(job, "scanline, scalars", "adaptive"), 0U);
}

TEST(Report, IsTheSameTwiceButForTheTimes) {
    const Scene scene = z2_in_perspective();
    const ReportOptions options{.timing = only(ReportJob::edge).timing, .progress = {}};
    const SceneReport a = report_of(scene, options);
    const SceneReport b = report_of(scene, options);
    ASSERT_EQ(a.jobs.size(), 4U);
    for (std::size_t job = 0; job < a.jobs.size(); ++job) {
        EXPECT_EQ(a.jobs[job].units, b.jobs[job].units);
        ASSERT_EQ(a.jobs[job].curves.size(), b.jobs[job].curves.size());
        for (std::size_t curve = 0; curve < a.jobs[job].curves.size(); ++curve)
            for (std::size_t i = 0; i < a.jobs[job].curves[curve].settings.size(); ++i) {
                const Setting& one = a.jobs[job].curves[curve].settings[i];
                const Setting& other = b.jobs[job].curves[curve].settings[i];
                EXPECT_EQ(one.name, other.name);
                EXPECT_EQ(one.failure, other.failure);
                EXPECT_EQ(one.work, other.work);
                EXPECT_EQ(one.wrong_when_snapped, other.wrong_when_snapped);
                ASSERT_EQ(one.errors.size(), other.errors.size());
                for (std::size_t measure = 0; measure < one.errors.size(); ++measure) {
                    EXPECT_EQ(one.errors[measure].value, other.errors[measure].value);
                    EXPECT_EQ(one.errors[measure].count, other.errors[measure].count);
                }
            }
    }
    EXPECT_EQ(a.trace.steps, b.trace.steps);
    EXPECT_EQ(a.trace.bytes, b.trace.bytes);
}

TEST(Report, EveryScalarThatAMethodCanNameIsThere) {
    const JobReport job = report_of_job(first_triangle(), ReportJob::coverage);
    std::vector<std::string> names;
    for (const Setting& setting : curve_of(job, "scanline, scalars").settings)
        names.push_back(setting.name);
    EXPECT_THAT(names, testing::IsSupersetOf({"float", "double", "exact"}));
}

/// A setting with an error and a median time.
Setting hand_made(std::string name, double error_value, double time) {
    Setting setting;
    setting.name = std::move(name);
    setting.errors = {{error_value}};
    setting.timing = {.minimum = time, .median = time, .runs = 1};
    return setting;
}

JobReport hand_made_job() {
    JobReport job;
    job.unit = "row";
    job.measures = {{"e", "error", "px"}};
    job.curves = {{"one",
                   "knob",
                   {hand_made("exact", 0, 10), hand_made("slow and exact", 0, 20),
                    hand_made("good", 1e-6, 3), hand_made("worse", 1e-5, 5)}},
                  {"two", "knob", {hand_made("fast", 1e-3, 2), hand_made("as fast", 1e-2, 1.99)}}};
    job.curves[0].settings[1].never_errs = true;
    Setting failed;
    failed.name = "failed";
    failed.failure = "overflow";
    job.curves[1].settings.push_back(failed);
    mark_fronts(job);
    return job;
}

TEST(Pareto, NothingIsBothFasterAndNearer) {
    const JobReport job = hand_made_job();
    std::vector<std::string> front;
    for (const Curve& curve : job.curves)
        for (const Setting& setting : curve.settings)
            if (setting.on_front[0])
                front.push_back(setting.name);
    // "as fast" is faster by less than the clock can tell.
    EXPECT_THAT(front, ElementsAre("exact", "good", "fast"));
}

/// A job of one curve: what never errs in `exact_time`, and what is near and what is not, both in 1 ns or less.
JobReport job_with_price(double exact_time, double near_error, double unseen) {
    JobReport job;
    job.unit = "row";
    job.measures = {{"e", "error", "px", {}, unseen, "half a grain"}};
    job.curves = {{"one",
                   "knob",
                   {hand_made("exact", 0, exact_time), hand_made("near", near_error, 1),
                    hand_made("far", 0.5, 0.9)}}};
    job.curves[0].settings[0].never_errs = true;
    return job;
}

TEST(Advice, TakesTheFastestThatIsEnoughAndTellsThePriceOfExactness) {
    EXPECT_EQ(advice_for(job_with_price(207, 2e-12, 1e-3), 0),
              "Choose one: near: it is off by 2e-12 px, no more than half a grain (1 ns per row). "
              "What never errs, one: exact, takes 207 times as long (207 ns per row). The fastest, "
              "one: far, is off by 0.5 px (0.9 ns per row).");
}

TEST(Advice, AnErrorOfJustWhatIsUnseenIsEnough) {
    EXPECT_THAT(advice_for(job_with_price(207, 1e-3, 1e-3), 0),
                testing::StartsWith("Choose one: near: "));
    EXPECT_THAT(advice_for(job_with_price(207, 1.001e-3, 1e-3), 0),
                testing::StartsWith("Choose one: exact: "));
}

TEST(Advice, TakesWhatNeverErrsWhereThatIsCheap) {
    EXPECT_EQ(advice_for(job_with_price(price_of_safety, 2e-12, 1e-3), 0),
              "Choose one: exact: it never errs (2 ns per row). The fastest, one: far, is off by "
              "0.5 px (0.9 ns per row).");
    EXPECT_THAT(advice_for(job_with_price(price_of_safety + 0.1, 2e-12, 1e-3), 0),
                HasSubstr("Choose one: near: it is off by 2e-12 px, no more than half a grain (1 "
                          "ns per row). What never errs, one: exact, takes 2.1 times as long"));
}

TEST(Advice, TakesTheLeastErrorWhereNothingIsEnough) {
    JobReport job = job_with_price(207, 1e-2, 1e-3);
    job.curves[0].settings.erase(job.curves[0].settings.begin());
    EXPECT_EQ(advice_for(job, 0),
              "Choose one: near: it is off by 0.01 px, the least of all (1 ns per row). The "
              "fastest, one: far, is off by 0.5 px (0.9 ns per row).");
}

TEST(Advice, NoErrorHereNeedNotMeanNoneElsewhere) {
    JobReport job = job_with_price(30, 0, 0);
    job.curves[0].settings.pop_back();
    EXPECT_EQ(advice_for(job, 0),
              "Choose one: near: it has no error here, and nothing is faster (1 ns per row). What "
              "never errs, one: exact, takes 30 times as long (30 ns per row).");
    job.curves[0].settings[1].never_errs = true;
    EXPECT_EQ(advice_for(job, 0),
              "Choose one: near: it never errs, and nothing is faster (1 ns per row).");
}

TEST(Advice, OfTimesThatTheClockCannotTellApartTheOneThatNeverErrsIsTheFastest) {
    EXPECT_EQ(advice_for(job_with_price(0.9 * (1 + timing_noise / 2), 0, 0), 0),
              "Choose one: exact: it never errs, and nothing is faster (0.909 ns per row).");
}

TEST(Advice, FewWrongPixelsAreStillWrong) {
    JobReport job = job_with_price(10, 0, 0);
    job.measures[0].against = "rows";
    job.curves[0].settings[1].errors = {ErrorValue::ratio(1, 1000000)};
    EXPECT_EQ(advice_for(job, 0), "Choose one: exact: it never errs (10 ns per row). The "
                                  "fastest, one: far, is off by 0.5 px (0.9 ns per row).");
}

TEST(Advice, WhatDoesSomethingElseIsNeitherAdvisedNorOnAFront) {
    JobReport job = job_with_price(10, 0, 0);
    job.curves.push_back({"apart", "knob", {hand_made("fastest of all", 0, 0.1)}, true});
    mark_fronts(job);
    EXPECT_TRUE(job.curves[0].settings[1].on_front[0]);
    EXPECT_FALSE(job.curves[1].settings[0].on_front[0]);
    EXPECT_THAT(advice_for(job, 0), testing::Not(HasSubstr("apart")));
    job.curves[1].is_apart = false;
    EXPECT_THAT(advice_for(job, 0), testing::StartsWith("Choose apart: fastest of all"));
}

TEST(ColorReport, WhatIsCutOffIsApartFromWhatIsRounded) {
    for (const Curve& curve : report_of_job(z2_in_perspective(), ReportJob::color).curves)
        EXPECT_EQ(curve.is_apart, curve.method.find("cut off") != std::string::npos)
            << curve.method;
}

TEST(Advice, WithoutAnyMeasurementThereIsNone) {
    JobReport job = job_with_price(1, 0, 0);
    for (Setting& setting : job.curves[0].settings)
        setting.failure = "overflow";
    EXPECT_EQ(advice_for(job, 0), "Nothing could be measured.");
}

// Knobs at their ends, against the core's own walk.
TEST(Knobs, NeverBeginningAnewIsTheIncrementalWalkOfCore) {
    const Edge<float> edge = edge_between(Vertex<float>{{0.1F, 0.3F}}, Vertex<float>{{77.7F, 99}});
    ReseededWalk<float> reseeded(edge, 1, without_end);
    EdgeWalk<float> incremental(edge, LerpForm::incremental, 1);
    for (int y = 1; y < 99; ++y)
        EXPECT_EQ(reseeded.x_on_row(y), incremental.x_on_row(y)) << y;
}

TEST(Knobs, PixelAndRestWalkUpAndDown) {
    // x = -7/2 + (5/3)(y + 1/2), in halves.
    const WholeEdge<std::int64_t> edge{-7, -1, 3, 5, 2};
    QuotientWalk<std::int64_t> down(edge, 1, 0);
    std::vector<std::int64_t> pixels;
    for (int y = 0; y <= 2; ++y, down.step())
        pixels.push_back(down.pixel());
    EXPECT_THAT(pixels, ElementsAre(-3, -1, 0)); // -8/3, -1, 2/3
    QuotientWalk<std::int64_t> up(edge, -1, 2);
    pixels.clear();
    for (int y = 2; y >= 0; --y, up.step())
        pixels.push_back(up.pixel());
    EXPECT_THAT(pixels, ElementsAre(0, -1, -3));
}

TEST(Knobs, CodesOfDepthsRoundToTheNearest) {
    const DepthCodes<double> codes(-1, 0, 2); // -1, -2/3, -1/3, 0
    EXPECT_EQ(codes.code_of(-1), 0U);
    EXPECT_EQ(codes.code_of(-0.8), 1U);
    EXPECT_EQ(codes.code_of(0), 3U);
    EXPECT_EQ(codes.code_of(-5), 0U);
    EXPECT_EQ(codes.code_of(5), 3U);
    EXPECT_DOUBLE_EQ(codes.depth_of(2), -1.0 / 3);
}

TEST(Counted, CountsEachOperationOnce) {
    Work work;
    {
        const Counting counting(work);
        const Counted<double> a = 3.0;
        const Counted<double> b = a * a + a / 2 - 1;
        EXPECT_TRUE(a < b && !(b <= a));
        EXPECT_EQ(-b.value(), -9.5);
    }
    EXPECT_EQ(work.adds, 2U);
    EXPECT_EQ(work.multiplies, 1U);
    EXPECT_EQ(work.divides, 1U);
    EXPECT_EQ(work.comparisons, 2U);
    const Counted<double> after = Counted<double>(1.0) + 1;
    EXPECT_EQ(after.value(), 2);
    EXPECT_EQ(work.adds, 2U) << "nobody is counting any more";
}

} // namespace
} // namespace rastertrace
