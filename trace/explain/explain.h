// SPDX-License-Identifier: MIT
#pragma once

// Why something is as it is: the steps of a trace that are about it, and, of a pixel that a primitive has not
// drawn, the rule that kept it out, with its numbers.
//
//     const auto answer = explain(trace, {.about = Topic::pixel, .pixel = {4, 2}});
//     answer.value().why_not[0].sentence;  // "AC ends row y=2 at x = 25/8 -> floor -> 3; ..."
//
// All numbers are those of the trace, or worked out from them exactly. What a trace lacks is said.

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// What a question is about.
enum class Topic : std::uint8_t {
    pixel,    ///< who drew it, and why the others did not
    scanline, ///< the ends of a row
    face,     ///< a triangle: turned away, lit, clipped, drawn
    vertex,   ///< its places from space to space
    edge,     ///< how it is set up, and the rows that it ends
    pair,     ///< two triangles: who has the pixels along their shared edge
    step,     ///< one step, see selector.h
};

/// pixel, scanline, ...: as the options are named.
std::string_view name_of(Topic topic);

/// The names of what can be asked about: faces, vertices, edges; of Topic::pair, the triangles. None of other topics.
std::vector<std::string> names_to_ask(const Trace& trace, Topic topic);

struct Question {
    Topic about = Topic::pixel;
    Pixel pixel = {};   ///< of Topic::pixel; of Topic::scanline its y
    std::string text{}; ///< the name of a face, vertex or edge; `ABC,ACD` of a pair; a selector
};

/// The question in words: `pixel (4, 2)`.
std::string to_text(const Question& question);

/// A step that is about what was asked.
struct Try {
    std::size_t number = 0;             ///< in the whole trace
    std::string step{};                 ///< as the trace has it
    std::string primitive{};            ///< of a row: whose it is
    std::string sentence{};             ///< see describe.h
    std::string before{};               ///< what the pixel showed, `ABC #000000`; "" of other steps
    std::string after{};                ///< the same once the step was done
    std::vector<std::string> working{}; ///< see working.h
};

/// What kept a primitive from a pixel.
struct WhyNot {
    std::string primitive{};
    std::string
        reason{}; ///< outside, elsewhere, hidden, culled, clipped, skipped, unpainted, rejected, unknown
    std::string sentence{};           ///< the rule and its numbers
    std::optional<double> distance{}; ///< how far outside the pixel's sample lies, in pixels
    std::vector<std::string> working{};
};

/// True if the first primitive was nearer to drawing the pixel than the second: hidden ones come first, then the
/// others by their distance.
bool was_nearer_to_drawing(const WhyNot& one, const WhyNot& other);

/// Where more primitives than this have not drawn a pixel, people are told of the nearest, and how many there are.
inline constexpr std::size_t most_why_not_told = 12;

/// A pixel along the edge that two triangles share.
struct PixelAlongEdge {
    Pixel pixel{};
    std::vector<std::string>
        owners{};        ///< who has plotted it, or would have if nothing had stood before it
    bool is_told = true; ///< false: steps are missing that could say that one more has it
    std::vector<std::string> why{}; ///< of each of the two triangles, how it came to have it or not
};

struct Explanation {
    std::string question{};
    std::string answer{};                 ///< one line
    std::vector<Try> tries{};             ///< in the order of the trace
    std::vector<WhyNot> why_not{};        ///< of a pixel: each primitive that has not drawn it
    std::vector<PixelAlongEdge> pixels{}; ///< of a pair, from one end of their edge to the other
    std::vector<std::string> lacks{};     ///< what cannot be told, because steps were left out
};

/// Answers a question from a trace, or from an excerpt that has the steps that matter to it. What is not there (a
/// pixel off the canvas, a name that nothing has) is a problem.
Result<Explanation> explain(const Trace& trace, const Question& question);

/// A decision that two traces of one scene took differently.
struct Difference {
    std::optional<Try> one; ///< nothing: this trace has no such step
    std::optional<Try> other;
};

/// The question that asks another trace of the same scene about the same: a step is found there by its primitive and
/// its key fields. `nullopt` if there is no such step.
std::optional<Question> question_for(const Trace& other, const Trace& trace,
                                     const Question& question);

/// The first decision about what was asked that differs; `nullopt` if none does. A step that only one of the
/// traces has is one if it changes something: a test that is passed does not.
std::optional<Difference> first_difference(const Trace& one, const Trace& other,
                                           const Question& question);

} // namespace rastertrace
