// SPDX-License-Identifier: MIT
#pragma once

// A trace as a page to click through: one HTML file that asks for nothing else. Its sentences are those of the
// program, its arithmetic is done here: the page fills in, compares whole numbers and paints.
//
//     const std::string html = page_of({{.label = "", .data = page_data(trace)}}, {.title = trace.title});
//
// page_data() is also what the program compiled for browsers answers a changed scene with, so that a page shows that
// in place of what it was made with.

#include <rastertrace/figures/space_eye.h>
#include <rastertrace/figures/theme.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/tell/view.h>
#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

class PixelExplainer;

/// The most steps of a page, those of all its frames together, and the most pixels of its canvas.
inline constexpr std::size_t most_page_steps = 200'000;
inline constexpr std::size_t most_page_pixels = std::size_t{1024} * 1024;

/// A trace of more steps has no workings on its page.
inline constexpr std::size_t most_steps_with_working = 50'000;

/// Why pixels are not drawn is on the page of a canvas of at most this width and height, and of at most so many pixels
/// times primitives. Beyond the lower number, a page that can draw asks for it instead.
inline constexpr int largest_side_with_why_not = 128;
inline constexpr std::size_t most_why_not_asked = 300'000;
inline constexpr std::size_t few_why_not_asked = 10'000;

/// The picture in space shows the line of sight of a pixel in traces of at most so many steps.
inline constexpr std::size_t most_steps_with_sight = 5'000;

/// A scene with more primitives than this has no vertices that can be moved.
inline constexpr std::size_t most_primitives_to_move = 10;

/// Why a trace cannot be a page; nullopt if it can.
std::optional<Problem> too_large_for_page(const Trace& trace);

/// How much is written into a page; beyond, it does without, or asks.
struct PageDetail {
    std::size_t steps_with_working = most_steps_with_working; ///< a longer trace has none
    std::size_t why_not_asked = most_why_not_asked;           ///< pixels times primitives
};

/// In the browser: after a vertex was moved, and while it is moved. Pixels are asked about one by one.
inline constexpr PageDetail detail_at_rest{.steps_with_working = 3'000, .why_not_asked = 0};
inline constexpr PageDetail detail_in_motion{.steps_with_working = 500, .why_not_asked = 0};

/// The picture in space on a page.
class StepsInSpace {
public:
    virtual ~StepsInSpace() = default;

    double width = 480;
    double height = 360;

    /// The elements of an SVG that all steps have, and those that the current step of a replay adds.
    virtual std::string of_all() const = 0;
    virtual std::string of_step(const Replay& replay) const = 0;
};

/// That of a trace; nullptr if its scene is not one in space. The trace must outlive it.
std::unique_ptr<const StepsInSpace> steps_in_space(const Trace& trace, const SpaceEye& eye);

/// What a page needs of a trace, as a JSON object: page_data.cpp says what is in it. The same trace makes the same
/// bytes. Without `in_space`, the page has no picture in space.
std::string page_data(const Trace& trace, const PageDetail& detail = {},
                      const StepsInSpace* in_space = nullptr);

/// True if it has the answers about all pixels: why others have not drawn them.
bool has_answers(const Trace& trace, const PageDetail& detail);

/// Why a pixel of the canvas is as it is, for a page that asks: {"answer": a sentence, "count": how many primitives have
/// not drawn it, "whyNot": [{"primitive":, "reason":, "sentence":}, ...] of the nearest, "lacks": [sentences]}.
std::string page_answer(PixelExplainer& explainer, Pixel pixel);

/// A frame of a page: of a scene whose numbers vary, or the only one.
struct PageFrame {
    std::string label = {}; ///< "3 of 24: degrees 30"
    std::string data;       ///< of page_data()
    std::string file = {};  ///< what the commands on the page call the input; "" for none
};

/// What a page that has the module can draw.
struct PageScene {
    std::string text = {}; ///< "": the page has only what it was made with
    /// Its vertices can be moved. Without the module, who tries it is told why they stay.
    bool is_movable = false;
    bool can_be_turned = false; ///< it is in space
};

struct PageOptions {
    std::string title = {};
    Theme theme = Theme::automatic;
    std::optional<View> view = {}; ///< the one that the page begins with; none: the trace's default
    std::optional<std::size_t> step = {}; ///< the step that it begins at; none: the last
    std::string picture = {};             ///< an SVG, which is shown where there is no JavaScript
    std::string module = {}; ///< the program compiled for browsers, as a script; "" for none
    PageScene scene = {};
};

/// The player as an element of any page, <raster-trace>: a module of JavaScript (trace/figures/page/element.js).
std::string page_element();

/// The whole file.
std::string page_of(std::span<const PageFrame> frames, const PageOptions& options);

} // namespace rastertrace
