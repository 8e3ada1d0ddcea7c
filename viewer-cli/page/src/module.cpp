// SPDX-License-Identifier: MIT
// What the module can be asked for: each function takes a scene as a text, and gives a text. module.js makes
// functions of JavaScript of them.

#include "grays.h"

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/core/draw/model/mistakes.h>
#include <rastertrace/figures/page.h>
#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/check/claims.h>
#include <rastertrace/trace/explain/explain_pixels.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/working.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/problem.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace rastertrace;

/// The last answer, which the page reads before it asks again.
std::string answer;
bool is_message = false;

/// Keeps what `ask` answers, or the message that tells why it does not.
template <typename Ask> const char* answer_to(Ask&& ask) {
    is_message = true;
    try {
        answer = ask();
        is_message = false;
    } catch (const Problem& problem) {
        answer = to_text(problem);
    } catch (const std::bad_alloc&) {
        answer = "expected a scene that has room in the memory of a page, found a larger one\n"
                 "hint: draw it with the program";
    } catch (const std::exception& exception) {
        answer = exception.what();
    }
    return answer.c_str();
}

/// Asks of a scene.
template <typename Ask>
const char* answer_of(const char* scene, Ask&& ask, const MethodOverrides& overrides = {}) {
    return answer_to([&] {
        const auto read = read_scene({.name = "scene", .text = scene}, overrides);
        if (!read)
            throw read.problem();
        return ask(read.value());
    });
}

std::string text_of_trace(const PlannedScene& planned) {
    std::string text;
    StringOutput output(text);
    write_trace(planned.scene, planned.plan, {}, output);
    return text;
}

/// The scene that was drawn last, so that several questions about it draw it once.
struct Drawn {
    explicit Drawn(const PlannedScene& planned)
        : trace(drawn_trace(planned.scene, planned.plan, "trace", any_number)), explainer(trace),
          replay(trace, {.writes = false, .depths = true}) {}

    Trace trace;
    PixelExplainer explainer;
    Replay replay;
};
std::string drawn_scene;
std::unique_ptr<Drawn> last_drawn;

/// Asks of a scene that was drawn.
template <typename Ask> const char* answer_of_drawn(const char* scene, Ask&& ask) {
    if (last_drawn && drawn_scene == scene)
        return answer_to([&] { return ask(*last_drawn); });
    return answer_of(scene, [&](const PlannedScene& planned) {
        last_drawn.reset();
        last_drawn = std::make_unique<Drawn>(planned);
        drawn_scene = scene;
        return ask(*last_drawn);
    });
}

/// ["a", "b"]
std::string json_of(const std::vector<std::string>& texts) {
    std::vector<std::string> quoted;
    for (const std::string& text : texts)
        quoted.push_back(json_quoted(text));
    return fmt::format("[{}]", joined(quoted, ","));
}

/// [1,2]
template <typename Number> std::string numbers_of(const std::vector<Number>& numbers) {
    std::string text = "[";
    for (const Number number : numbers)
        text += (text.size() > 1 ? "," : "") + std::to_string(number);
    return text + "]";
}

/// Who has drawn each pixel, and the depth that is stored there.
struct LastFrame {
    explicit LastFrame(const Canvas& canvas)
        : canvas(canvas), owners(canvas.area(), -1), depths(owners.size()) {}

    void operator()(const PrimitiveBegan<>& step) { names.emplace_back(step.name); }
    void operator()(const PixelPlotted<>& step) {
        owners[canvas.offset_of(step.pixel())] = static_cast<int>(names.size()) - 1;
    }
    void operator()(const DepthTested<>& step) {
        const double depth = step.depth.to_double();
        if (!std::isfinite(depth))
            return;
        grays.include(depth);
        if (!step.is_by_stored())
            return;
        if (step.stored && step.stored->to_double() != depth)
            grays.say_larger_is_nearer((depth > step.stored->to_double()) == step.pass);
        if (step.pass)
            depths[canvas.offset_of(step.pixel())] = depth;
    }

    /// Of each pixel the level of its depth's gray; 0: nothing is stored. Empty if there are no depths.
    std::vector<int> levels() const {
        std::vector<int> levels;
        const auto is_stored = [](const std::optional<double>& depth) { return depth.has_value(); };
        if (std::any_of(depths.begin(), depths.end(), is_stored))
            for (const std::optional<double>& depth : depths)
                levels.push_back(depth ? grays.level_of(depth) : 0);
        return levels;
    }

    Canvas canvas;
    std::vector<std::string> names; ///< of the primitives
    std::vector<int> owners;        ///< a place in names; -1: nobody
    std::vector<std::optional<double>> depths;
    DepthGrays grays;
};

/// The last frame alone: {"names": of the primitives, "owners": of each pixel a place in names or -1, "colors": those that
/// there are, "pixels": of each pixel a place in colors, "depths": of each pixel the level of a gray, 0 if none is stored}.
std::string frame_of(const PlannedScene& planned) {
    LastFrame frame(planned.scene.canvas);
    const Image image = draw(planned.scene, planned.plan, frame);
    std::map<std::string, std::size_t> places;
    std::vector<std::string> colors;
    std::vector<std::size_t> pixels;
    std::optional<Color> last; // neighbors are alike
    for (int row = 0; row < image.canvas().height; ++row)
        for (int x = image.canvas().left(); x <= image.canvas().right(); ++x) {
            const Color color = image.at({x, image.canvas().y_of(row)});
            if (last == color) {
                pixels.push_back(pixels.back());
                continue;
            }
            last = color;
            const auto [place, is_new] = places.emplace(to_text(color), places.size());
            if (is_new)
                colors.push_back(place->first);
            pixels.push_back(place->second);
        }
    return fmt::format(R"({{"names":{},"owners":{},"colors":{},"pixels":{},"depths":{}}})",
                       json_of(frame.names), numbers_of(frame.owners), json_of(colors),
                       numbers_of(pixels), numbers_of(frame.levels()));
}

/// What was found about a claim.
std::string json_of(const Claims& claims, const CheckedClaim& checked) {
    const Claim& claim = claims.claims[checked.claim];
    constexpr std::array<std::string_view, 5> verdicts{"right", "wrong", "follows", "open",
                                                       "not understood"};
    if (checked.problem)
        return fmt::format(
            R"({{"line":{},"claim":{},"verdict":"{}","fields":[],"slips":[],"remarks":{},"working":[]}})",
            claim.line, json_quoted(claim.text), verdicts.back(),
            json_of(std::vector{to_text(*checked.problem)}));
    std::vector<std::string> fields, slips;
    for (const CheckedField& field : checked.fields) {
        if (field.verdict == ClaimVerdict::right || field.verdict == ClaimVerdict::open)
            continue;
        fields.push_back(difference_text(claims, field, field.expected, field.found, field.place));
        for (const LikelySlip& slip : field.slips)
            slips.push_back(slip.meaning);
    }
    return fmt::format(
        R"({{"line":{},"claim":{},"verdict":"{}","fields":{},"slips":{},"remarks":{},"working":{}}})",
        claim.line, json_quoted(claim.text), verdicts[static_cast<std::size_t>(checked.verdict)],
        json_of(fields), json_of(slips), json_of(checked.remarks), json_of(checked.working));
}

} // namespace

extern "C" {

/// True if the last answer is a message that tells why there is no other.
bool rastertrace_is_message() {
    return is_message;
}

/// Sets the language of sentences by its code; one that there is not changes nothing.
void rastertrace_tell_steps_in(const char* code) {
    const auto language = language_with_code(code);
    if (!language || *language == language_of_steps())
        return;
    tell_steps_in(*language);
    last_drawn.reset(); // its answers are in the other one
}

/// What is wrong with a scene: {"message":, "hint":, "line":, "column":}, line 0 where it has no place; "" if nothing is.
const char* rastertrace_problem(const char* scene) {
    return answer_to([&] {
        const auto read = read_scene({.name = "scene", .text = scene});
        return read ? std::string()
                    : fmt::format(R"({{"message":{},"hint":{},"line":{},"column":{}}})",
                                  json_quoted(read.problem().message),
                                  json_quoted(read.problem().hint), read.problem().line,
                                  read.problem().column);
    });
}

/// The trace of a scene, as `rastertrace trace scene.json -o -` writes it.
const char* rastertrace_trace(const char* scene) {
    return answer_of(scene, text_of_trace);
}

/// What a page shows of a scene: figures/page.h.
const char* rastertrace_page_data(const char* scene) {
    return answer_of_drawn(scene, [](const Drawn& drawn) {
        return page_data(drawn.trace, detail_at_rest, steps_in_space(drawn.trace, {}).get());
    });
}

/// The same while a vertex is moved.
const char* rastertrace_page_data_in_motion(const char* scene) {
    return answer_of_drawn(
        scene, [](const Drawn& drawn) { return page_data(drawn.trace, detail_in_motion); });
}

/// The last frame of a scene, without steps, for a picture in motion: in doubles, whatever its own numbers are.
const char* rastertrace_frame(const char* scene) {
    return answer_of(scene, frame_of, {{"scalar", "double"}});
}

/// A step, counted from 1: {"sentence":, "working": [lines]}.
const char* rastertrace_step(const char* scene, int n) {
    return answer_of_drawn(scene, [n](Drawn& drawn) {
        if (n < 1 || static_cast<std::size_t>(n) > drawn.trace.size())
            throw problem_of(
                "", fmt::format("expected a step of 1 to {}, found {}", drawn.trace.size(), n));
        drawn.replay.go_to(static_cast<std::size_t>(n));
        return fmt::format(R"({{"sentence":{},"working":{}}})",
                           json_quoted(describe_step(drawn.replay)),
                           json_of(working_of(drawn.replay)));
    });
}

/// Why a pixel is as it is: page_answer of page.h.
const char* rastertrace_explain_pixel(const char* scene, int x, int y) {
    return answer_of_drawn(scene, [&](Drawn& drawn) {
        if (!drawn.trace.canvas.contains(x, y))
            throw problem_of("", fmt::format("expected a pixel of the canvas, found {},{}", x, y));
        return page_answer(drawn.explainer, {x, y});
    });
}

/// Claims about a scene, as `rastertrace check` takes them: [{"line":, "claim":, "verdict":, "fields":, ...}, ...].
const char* rastertrace_check(const char* scene, const char* claims_text) {
    return answer_of(scene, [&](const PlannedScene&) {
        const auto claims = read_claims({.name = "claims", .text = claims_text});
        if (!claims)
            throw claims.problem();
        const Truth truth({.name = "scene", .text = scene}, {});
        std::vector<std::string> told;
        for (const CheckedClaim& checked : check(truth, claims.value()).claims)
            told.push_back(json_of(claims.value(), checked));
        return fmt::format("[{}]", joined(told, ",\n"));
    });
}

/// The known mistakes that may change the scene: [{"name":, "says":, "should":, "symptom":}, ...].
const char* rastertrace_mistakes(const char* scene) {
    return answer_of(scene, [](const PlannedScene& planned) {
        std::vector<std::string> told;
        for (const Mistake& mistake : mistakes())
            if (mistake.concerns(planned.scene))
                told.push_back(fmt::format(R"({{"name":{},"says":{},"should":{},"symptom":{}}})",
                                           json_quoted(mistake.name), json_quoted(mistake.says),
                                           json_quoted(mistake.should),
                                           json_quoted(mistake.symptom)));
        return fmt::format("[{}]", joined(told, ",\n"));
    });
}
}
