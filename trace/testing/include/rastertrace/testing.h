// SPDX-License-Identifier: MIT
#pragma once

// Tests of a rasterizer: what its trace says, in GoogleTest's words. A test that fails says why it is not so.
//
//     using namespace rastertrace::matchers;
//     TEST(Fill, DrawsTheFirstTriangle) {
//         const TestedTrace trace = trace_in("mine.jsonl");
//         EXPECT_THAT(trace, PlotsPixel(3, 2));
//         EXPECT_THAT(trace, HasScanline(2, "-1/4", 3.125));
//     }
//
// docs/regression-tests.md begins at the beginning. A question that cannot be answered (a file that is missing, a
// name that nothing has) fails the test, also within Not().

#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/numbers/number.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/problem.h>

#include <gmock/gmock.h>

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace::matchers {

/// A trace that is tested, or the problem that kept it from being read. A problem fails every test of it.
struct TestedTrace {
    std::string name{}; ///< what messages call it
    std::string text{}; ///< the trace as it was written, in any layout
    Result<Trace> trace = problem_of("", "no trace"); ///< the same, read
};

/// The trace in a file, or that of the scene in it, which is drawn first: by its own method, except for what `method`
/// says, {{"fill", "top-left"}}. Damage is a problem too.
TestedTrace trace_in(const std::string& path, const MethodOverrides& method = {});

/// The trace of a scene, drawn by this library.
TestedTrace trace_of(const Scene& scene);

/// A trace, or a scene, that is held in memory.
TestedTrace trace_from(Source source, const MethodOverrides& method = {});

/// What messages say of a trace, for GoogleTest.
void PrintTo(const TestedTrace& tested, std::ostream* out);

/// What is asked of a trace: an argument of EXPECT_THAT and of GoogleMock's Not(), AllOf(), ...
using TraceMatcher = ::testing::Matcher<const TestedTrace&>;

/// The line of a test that asks. The compiler fills it in.
class Caller {
public:
    static Caller here(const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
        Caller caller;
        caller.file_ = file;
        caller.line_ = line;
        return caller;
    }
    const char* file() const { return file_; }
    int line() const { return line_; }

private:
    Caller() = default; // two numbers are a Pixel
    const char* file_ = "";
    int line_ = 0;
};

/// The primitive that is meant, where a scene has several: PlotsPixel(3, 2, In("ABC")). Its parts are meant too.
class In {
public:
    explicit In(std::string name) : name_(std::move(name)) {}
    const std::string& name() const { return name_; }

private:
    std::string name_;
};

/// A number that a trace is asked for, by value: "25/8", 3.125 and "3.125" are the same. A double, or a float, is the
/// shortest decimal that reads back to it: 0.1 is 1/10, as in a trace.
class Value {
public:
    Value(const char* text) : text_(text) {}            // NOLINT: numbers are written as numbers
    Value(std::string text) : text_(std::move(text)) {} // NOLINT
    Value(std::integral auto whole) : text_(std::to_string(whole)) {} // NOLINT
    Value(double number);                                             // NOLINT
    Value(float number);                                              // NOLINT

    /// As it was typed; about 1/3 as "1/3 +- 1e-9".
    std::string text() const;

    /// nullopt: what was typed is no number.
    std::optional<Number> number() const;

    /// True if a number of a trace is this one, or no farther from it than the tolerance.
    bool is(const std::string& told) const;

private:
    friend Value about(Value value, double tolerance);
    std::string text_;
    double tolerance_ = 0;
};

/// A number to within an absolute tolerance, for rasterizers whose numbers are floats: about("1/3", 1e-6).
Value about(Value value, double tolerance);

/// A pixel was plotted, whatever was drawn over it later. A test that fails says who has not drawn it, by which rule
/// and numbers.
TraceMatcher PlotsPixel(int x, int y, Caller caller = Caller::here());
TraceMatcher PlotsPixel(int x, int y, const In& primitive, Caller caller = Caller::here());

/// A row has these two ends, in x. A test that fails says which ones it has, and how they are worked out.
TraceMatcher HasScanline(int y, const Value& left, const Value& right,
                         Caller caller = Caller::here());
TraceMatcher HasScanline(int y, const Value& left, const Value& right, const In& primitive,
                         Caller caller = Caller::here());

/// A face was tested and culled. A test that fails says how normal . view comes out.
TraceMatcher CullsFace(const std::string& name, Caller caller = Caller::here());

/// A pixel of a primitive met the depth buffer, and something nearer was there. A test that fails tells both depths.
TraceMatcher FailsDepth(const std::string& primitive, int x, int y, Caller caller = Caller::here());

/// Every decision is the one that the numbers beside it give ("Doing it again" in docs/trace-format.md). A test that fails
/// tells the first that is not.
TraceMatcher DecidesByItsNumbers(Caller caller = Caller::here());

/// Rows of `#` and `.`, the top row first: a text, "..#\n.##\n", or a list of rows.
class Picture {
public:
    Picture(std::string_view text);                                // NOLINT: a text is a picture
    Picture(const char* text) : Picture(std::string_view(text)) {} // NOLINT
    Picture(const std::string& text) : Picture(std::string_view(text)) {} // NOLINT
    Picture(std::vector<std::string> rows) : rows_(std::move(rows)) {}    // NOLINT
    Picture(std::initializer_list<std::string_view> rows) : rows_(rows.begin(), rows.end()) {}
    const std::vector<std::string>& rows() const { return rows_; }

private:
    std::vector<std::string> rows_;
};

/// The final picture, of the whole canvas. A test that fails shows both pictures, and a third one that marks what
/// differs: `!` only expected, `?` only there.
TraceMatcher ShowsPicture(const Picture& picture, Caller caller = Caller::here());

/// The same for a part of the canvas, whose top left pixel is named.
TraceMatcher ShowsPicture(const Picture& picture, Pixel top_left, Caller caller = Caller::here());

/// What of a trace is held against a stored one.
struct GoldenRules {
    /// Kinds of step; none: all of the trace. Of some kinds, nothing else is stored and compared, nor the
    /// header: what a later version adds there changes no test.
    std::vector<std::string> kinds{};
    std::vector<std::string>
        tolerances{}; ///< `scanline.left=1e-9`, `depth=4ulp`; see `rastertrace diff`
    std::vector<std::string> ignored{}; ///< `header`, a kind, or a field: `pixel.color`
};

/// The trace is as in a file that was stored, its golden, except for what the rules allow. A test that fails tells what
/// differs, as `rastertrace diff` does, and the command that renews the golden: with RASTERTRACE_RENEW=1 in the
/// environment, the golden is written anew from the trace (in one step; a file that is no trace is left alone).
TraceMatcher MatchesTrace(const std::string& golden, GoldenRules rules = {},
                          Caller caller = Caller::here());

} // namespace rastertrace::matchers
