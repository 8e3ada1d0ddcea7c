// SPDX-License-Identifier: MIT
// What `explain` says of pixels, against the rules of the fills, stated once more in exact fractions: for every
// pixel of the examples, and for pixels of random scenes.

#include "effort.h"
#include "picture.h"
#include "random_scene.h"
#include "traces.h"

#include <rastertrace/trace/explain/explain.h>
#include <rastertrace/trace/explain/explain_pixels.h>
#include <rastertrace/trace/explain/steps_of_pixel.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/told_samples.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

using ::testing::IsEmpty;

Explanation about(const Trace& trace, Pixel pixel) {
    auto answer = explain(trace, {.about = Topic::pixel, .pixel = pixel});
    if (!answer) {
        ADD_FAILURE() << to_text(answer.problem());
        return {};
    }
    return std::move(answer.value());
}

std::vector<Pixel> pixels_of(const Canvas& canvas) {
    std::vector<Pixel> pixels;
    for (int row = 0; row < canvas.height; ++row)
        for (int x = canvas.left(); x <= canvas.right(); ++x)
            pixels.push_back({x, canvas.y_of(row)});
    return pixels;
}

Rational floor_of(const Rational& number) {
    mpz_class whole;
    mpz_fdiv_q(whole.get_mpz_t(), number.get_num_mpz_t(), number.get_den_mpz_t());
    return whole;
}

// The worked triangle of T0: AB is x = (3y - 7)/4, AC is x = (31 - 3y)/8, rows y = 5 to -3.
TEST(ExplainPixel, EveryPixelOfTheWorkedTriangle) {
    const Trace trace = trace_of(first_triangle());
    int drawn = 0;
    for (const auto& [x, y] : pixels_of(trace.canvas)) {
        const Explanation answer = about(trace, {x, y});
        const Rational left = Rational(3 * y - 7) / 4;
        const Rational right = Rational(31 - 3 * y) / 8;
        const std::string at = "x = " + std::to_string(x);
        const std::string row = "row y=" + std::to_string(y);
        std::string expected;
        if (y > 5)
            expected = row + " lies above its rows, y=5 to -3: its highest corner, A, is at y = 5";
        else if (y < -3)
            expected = row + " lies below its rows, y=5 to -3: its lowest corner, B, is at y = -3";
        else if (x < floor_of(left))
            expected = "AB begins " + row + " at x = " + left.get_str() + " -> floor -> " +
                       floor_of(left).get_str() + "; " + at + " lies before it by " +
                       Rational(left - x).get_str();
        else if (x > floor_of(right))
            expected = "AC ends " + row + " at x = " + right.get_str() + " -> floor -> " +
                       floor_of(right).get_str() + "; " + at + " lies beyond it by " +
                       Rational(x - right).get_str();
        if (expected.empty()) {
            ++drawn;
            ASSERT_EQ(answer.tries.size(), 1U);
            EXPECT_EQ(answer.tries[0].after, "ABC #000000");
            EXPECT_THAT(answer.why_not, IsEmpty());
        } else {
            EXPECT_THAT(answer.tries, IsEmpty());
            ASSERT_EQ(answer.why_not.size(), 1U);
            EXPECT_EQ(answer.why_not[0].sentence, expected);
        }
    }
    EXPECT_EQ(drawn, 49);
}

/// A triangle of a trace with exact numbers, and the rule that it is filled by.
struct FilledTriangle {
    std::vector<Vec<Rational, 2>> at;
    std::string fill;
    std::string rounding;
    SampleOffset<Rational> offset;
    bool is_y_up;

    /// Twice the area of two corners and a point, counted from the side of the third: above 0 inside.
    Rational inside_of(std::size_t i, const Vec<Rational, 2>& p) const {
        const auto area = [](const auto& a, const auto& b, const auto& c) {
            return Rational((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
        };
        const auto& a = at[i];
        const auto& b = at[(i + 1) % 3];
        const Rational own = area(a, b, at[(i + 2) % 3]);
        return sgn(own) < 0 ? Rational(-area(a, b, p)) : area(a, b, p);
    }

    bool has_area() const { return sgn(inside_of(0, at[2])) != 0; }

    /// An edge at the top of the picture, or at the left: the triangle lies below it, or right of it.
    bool is_top_left(std::size_t i) const {
        const auto& a = at[i];
        const auto& b = at[(i + 1) % 3];
        const auto& third = at[(i + 2) % 3];
        if (a.y == b.y)
            return is_y_up ? third.y < a.y : third.y > a.y;
        const Rational x = a.x + (b.x - a.x) * (third.y - a.y) / (b.y - a.y);
        return third.x > x;
    }

    bool covers(Pixel pixel) const {
        const Vec<Rational, 2> sample = offset.sample_of(pixel);
        if (fill == "scanline" || fill == "two-halves")
            return covers_by_row(pixel.x, sample.y);
        for (std::size_t i = 0; i < 3; ++i) {
            const int side = sgn(inside_of(i, sample));
            if (side < 0 || (side == 0 && fill == "top-left" && !is_top_left(i)))
                return false;
        }
        return true;
    }

    /// Where a row of samples meets the closed triangle, rounded.
    bool covers_by_row(int column, const Rational& y) const {
        std::vector<Rational> xs;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& a = at[i];
            const auto& b = at[(i + 1) % 3];
            if (std::min(a.y, b.y) > y || std::max(a.y, b.y) < y)
                continue;
            if (a.y == b.y)
                xs.insert(xs.end(), {offset.in_columns(a.x), offset.in_columns(b.x)});
            else
                xs.push_back(offset.in_columns(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y)));
        }
        if (xs.empty())
            return false;
        const auto [left, right] = std::minmax_element(xs.begin(), xs.end());
        const auto ceil_of = [](const Rational& x) { return Rational(-floor_of(-x)); };
        const auto cut = [&](const Rational& x) { return sgn(x) < 0 ? ceil_of(x) : floor_of(x); };
        const auto nearest = [](const Rational& x) { return floor_of(x + Rational(1, 2)); };
        Rational from = floor_of(*left), to = floor_of(*right);
        if (rounding == "truncate")
            from = cut(*left), to = cut(*right);
        else if (rounding == "nearest")
            from = nearest(*left), to = nearest(*right);
        else if (rounding == "inside")
            from = ceil_of(*left);
        else if (rounding == "half-open")
            from = ceil_of(*left), to = ceil_of(*right) - 1;
        return from <= column && column <= to;
    }
};

/// The triangle of a primitive, if the rule is stated here: not for lines of a fan, nor where corners are not told
/// exactly.
std::optional<FilledTriangle> filled_triangle(const Trace& trace, const PrimitiveStep& primitive) {
    const std::string rounding = trace.method.word_of("rounding");
    FilledTriangle triangle{.at = {},
                            .fill = trace.method.word_of("fill"),
                            .rounding = rounding.substr(0, rounding.find('+')),
                            .offset = told_samples(trace).triangles,
                            .is_y_up = trace.canvas.down() < 0};
    const bool has_ties = trace.method.word_of("ties") != "" && triangle.rounding == "nearest";
    if (trace.method.word_of("scalar") != "exact" || triangle.fill == "fan" || has_ties ||
        primitive.kind != PrimitiveKind::triangle)
        return std::nullopt;
    for (const auto& place : primitive.at.values()) {
        const auto at = place.values();
        triangle.at.push_back({*at[0].exact(), *at[1].exact()});
    }
    return triangle.at.size() == 3 && triangle.has_area() ? std::optional(triangle) : std::nullopt;
}

/// What each step of a trace is about, found once: for pixels that are asked about one by one.
class Facts {
public:
    explicit Facts(const Trace& trace) : trace_(trace), frame_(frame_after(trace, trace.size())) {
        for (std::size_t n = 1; n <= trace.size(); ++n) {
            const StepView step = trace.step(n);
            const auto kind = trace.kind_of(n);
            if (kind == StepKind::primitive) {
                const auto primitive = step.as<PrimitiveStep>();
                primitives_.push_back(
                    {n, primitive.name.text(), filled_triangle(trace, primitive)});
                primitives_.back().is_whole = !primitive.at;
                primitives_.back().is_painted = !primitive.painted.is_false();
            }
            if (kind == StepKind::skip && !primitives_.empty())
                primitives_.back().is_skipped = true;
            if (kind == StepKind::pixel || kind == StepKind::depth)
                tries_[{static_cast<int>(*x_in(step)), static_cast<int>(*y_in(step))}].push_back(n);
        }
    }

    /// Holds what is said of a pixel against the trace and the rules. Who asks many may ask an excerpt of it.
    void check(Pixel pixel, const Trace& asked) const { check(pixel, about(asked, pixel)); }
    void check(Pixel pixel, const Explanation& answer) const {
        static const std::vector<std::size_t> none;
        const auto found = tries_.find({pixel.x, pixel.y});
        const auto& tries = found == tries_.end() ? none : found->second;
        std::vector<std::size_t> told;
        for (const Try& one : answer.tries)
            told.push_back(one.number);
        ASSERT_EQ(told, tries) << answer.question;

        const bool is_drawn = frame_.drawn_by[trace_.canvas.offset_of(pixel)] != 0;
        ASSERT_EQ(answer.answer.starts_with("drawn"), is_drawn)
            << answer.question << ": " << answer.answer;
        ASSERT_EQ(!answer.tries.empty() && answer.tries.back().after != "empty" &&
                      !answer.tries.back().after.starts_with("background"),
                  is_drawn);

        std::multimap<std::string, const WhyNot*> why_not;
        for (const WhyNot& why : answer.why_not)
            why_not.emplace(why.primitive, &why);
        for (std::size_t i = 0; i < primitives_.size(); ++i)
            check_primitive(i, pixel, tries, why_not);
        ASSERT_TRUE(why_not.empty()) << why_not.begin()->second->sentence;
    }

    /// Pixels that steps are about, at most so many.
    std::vector<Pixel> first_tried(std::size_t most) const {
        std::vector<Pixel> pixels;
        for (const auto& [pixel, steps] : tries_)
            if (pixels.size() < most && trace_.canvas.contains(pixel.first, pixel.second))
                pixels.push_back({pixel.first, pixel.second});
        return pixels;
    }

private:
    struct Primitive {
        std::size_t step;
        std::string name;
        std::optional<FilledTriangle> triangle;
        bool is_whole = false;
        bool is_painted = true;
        bool is_skipped = false;
    };

    /// It has drawn the pixel, or there is one reason why not, which is then taken away.
    void check_primitive(std::size_t i, Pixel pixel, const std::vector<std::size_t>& tries,
                         std::multimap<std::string, const WhyNot*>& why_not) const {
        const Primitive& primitive = primitives_[i];
        const std::size_t end =
            i + 1 < primitives_.size() ? primitives_[i + 1].step : trace_.size() + 1;
        bool has_drawn = false, is_hidden = false;
        for (const std::size_t n : tries)
            if (primitive.step < n && n < end) {
                has_drawn = has_drawn || trace_.kind_of(n) == StepKind::pixel;
                is_hidden = is_hidden || (trace_.kind_of(n) == StepKind::depth &&
                                          trace_.step(n).as<DepthStep>().pass.is_false());
            }
        const auto found = why_not.find(primitive.name);
        if (primitive.is_whole && !primitive.is_skipped) {
            if (found != why_not.end())
                why_not.erase(found);
            return; // its parts answer for it
        }
        ASSERT_EQ(found == why_not.end(), has_drawn) << primitive.name;
        const bool covers = primitive.triangle && !primitive.is_skipped
                                ? primitive.triangle->covers(pixel)
                                : has_drawn || is_hidden;
        if (primitive.triangle && primitive.is_painted) {
            ASSERT_EQ(covers, has_drawn || is_hidden)
                << primitive.name << " at " << pixel.x << ", " << pixel.y;
        }
        if (found == why_not.end())
            return;
        const WhyNot& why = *found->second;
        EXPECT_FALSE(why.sentence.empty());
        EXPECT_NE(why.reason, "unknown") << why.sentence;
        if (primitive.is_painted && !primitive.is_skipped) {
            EXPECT_EQ(why.reason == "hidden", is_hidden) << why.sentence;
            if (primitive.triangle) {
                EXPECT_EQ(why.reason == "outside", !covers) << why.sentence;
            }
        }
        why_not.erase(found);
    }

    const Trace& trace_;
    Frame frame_;
    std::vector<Primitive> primitives_;
    std::map<std::pair<int, int>, std::vector<std::size_t>> tries_;
};

/// The trace without what is about pixels of triangles in other rows: it can be asked about all of a row quickly.
Trace excerpt_of_row(const Trace& trace, int y) {
    Trace excerpt = trace.without_steps();
    bool is_triangle = false;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const StepView step = trace.step(n);
        const auto kind = trace.kind_of(n);
        if (kind == StepKind::primitive)
            is_triangle = step.as<PrimitiveStep>().kind == PrimitiveKind::triangle;
        const bool is_of_pixel = kind == StepKind::pixel || kind == StepKind::depth ||
                                 kind == StepKind::sample || kind == StepKind::reject;
        if (!is_triangle || !is_of_pixel || y_in(step) == y)
            excerpt.add_to_excerpt(n);
    }
    return excerpt;
}

/// Who asks about many pixels is told the same as who asks about one.
void expect_the_same(const Explanation& of_many, const Explanation& of_one) {
    EXPECT_EQ(of_many.answer, of_one.answer);
    EXPECT_EQ(of_many.lacks, of_one.lacks);
    ASSERT_EQ(of_many.why_not.size(), of_one.why_not.size());
    for (std::size_t i = 0; i < of_one.why_not.size(); ++i) {
        EXPECT_EQ(of_many.why_not[i].primitive, of_one.why_not[i].primitive);
        EXPECT_EQ(of_many.why_not[i].reason, of_one.why_not[i].reason);
        EXPECT_EQ(of_many.why_not[i].sentence, of_one.why_not[i].sentence);
        EXPECT_EQ(of_many.why_not[i].distance, of_one.why_not[i].distance);
    }
}

/// Asks about the pixels of a trace; where there are too many, or too many steps, about every so many and the first
/// that were drawn. Returns whether it asked about all.
bool ask_about_pixels(const Trace& trace) {
    constexpr std::size_t most_steps_taken = 150'000;
    constexpr std::size_t most_pixels = 10'000;
    const Canvas& canvas = trace.canvas;
    const Facts facts(trace);
    PixelExplainer explainer(trace);
    const std::size_t pixels =
        static_cast<std::size_t>(canvas.width) * static_cast<std::size_t>(canvas.height);
    const Trace middle = excerpt_of_row(trace, canvas.y_of(canvas.height / 2));
    const std::size_t stride =
        1 + std::max(pixels * middle.size() / most_steps_taken, pixels / most_pixels);
    std::optional<Trace> excerpt;
    int row_of_excerpt = 0;
    for (std::size_t i = 0; i < pixels && !testing::Test::HasFailure(); i += stride) {
        const auto width = static_cast<std::size_t>(canvas.width);
        const int row = static_cast<int>(i / width);
        const Pixel pixel{canvas.left() + static_cast<int>(i % width), canvas.y_of(row)};
        if (!excerpt || row != row_of_excerpt)
            excerpt = excerpt_of_row(trace, pixel.y);
        row_of_excerpt = row;
        const Explanation answer = about(*excerpt, pixel);
        facts.check(pixel, answer);
        expect_the_same(explainer.explain(pixel), answer);
    }
    for (const Pixel& pixel : facts.first_tried(stride == 1 ? 0 : 100))
        facts.check(pixel, trace);
    return stride == 1;
}

TEST(ExplainPixel, EveryPixelOfEveryExample) {
    const std::vector<std::string> files = example_files();
    int too_long = 0;
    ASSERT_GT(files.size(), 30U);
    constexpr std::size_t group = 10; // of which the sanitizers look at one
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (i % group >= all_cases(group))
            continue;
        const std::string& file = files[i];
        std::ifstream text(file);
        auto scene = read_scene({file, {std::istreambuf_iterator<char>(text), {}}});
        ASSERT_TRUE(scene) << to_text(scene.problem());
        const Trace trace = trace_of(scene.value().scene);
        SCOPED_TRACE(file);
        if (!ask_about_pixels(trace))
            ++too_long;
        ASSERT_FALSE(testing::Test::HasFailure());
    }
    // Those of 512 x 512 pixels, of a thousand triangles, and one of lines that are tested for depth.
    EXPECT_LE(too_long, 19);
}

TEST(ExplainPixel, PixelsOfRandomScenes) {
    Random random(18);
    for (int i = 0; i < random_cases(2000); ++i) {
        const std::string text = RandomScene(static_cast<std::uint64_t>(i)).text();
        auto scene = read_scene({"scene.json", text});
        if (!scene)
            continue;
        const Trace trace = trace_of(scene.value().scene);
        const Facts facts(trace);
        PixelExplainer explainer(trace);
        for (int k = 0; k < 6; ++k) {
            const Pixel pixel{random.whole(trace.canvas.left(), trace.canvas.right()),
                              trace.canvas.y_of(random.whole(0, trace.canvas.height - 1))};
            const Explanation answer = about(trace, pixel);
            facts.check(pixel, answer);
            expect_the_same(explainer.explain(pixel), answer);
            ASSERT_FALSE(testing::Test::HasFailure()) << text;
        }
    }
}

} // namespace
} // namespace rastertrace
