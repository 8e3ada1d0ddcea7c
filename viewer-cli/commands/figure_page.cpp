// SPDX-License-Identifier: MIT
#include "commands/figure_page.h"

#include "app/command_words.h"
#include "app/environment.h"
#include "app/installed_files.h"
#include "app/load.h"

#include <rastertrace/figures/figure.h>
#include <rastertrace/figures/page.h>
#include <rastertrace/figures/svg.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/tell/selector.h>
#include <rastertrace/trace/text/canvas_json.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/wasm/module.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

using Json = nlohmann::ordered_json;

/// What a scene in the plane may say; of what it draws, the number is limited.
constexpr std::array<std::string_view, 4> moved_lists{"points", "lines", "triangles", "outlines"};
constexpr std::array<std::string_view, 8> others{"$schema",  "title",  "canvas", "background",
                                                 "vertices", "colors", "method", "convention"};

bool is_plane_vertex(const Json& vertex) {
    return vertex.is_array() && vertex.size() == 2 &&
           std::all_of(vertex.begin(), vertex.end(),
                       [](const Json& number) { return number.is_number() || number.is_string(); });
}

bool can_be_moved(const Json& scene) {
    std::size_t primitives = 0;
    for (const auto& [key, value] : scene.items()) {
        if (std::find(moved_lists.begin(), moved_lists.end(), key) != moved_lists.end())
            primitives += value.size();
        else if (std::find(others.begin(), others.end(), key) == others.end())
            return false;
    }
    const auto vertices = scene.find("vertices");
    return primitives <= most_primitives_to_move && vertices != scene.end() &&
           vertices->is_object() &&
           std::all_of(vertices->begin(), vertices->end(), is_plane_vertex);
}

bool names_files(const Json& scene) {
    const auto meshes = scene.find("meshes");
    return meshes != scene.end() && meshes->is_array() &&
           std::any_of(meshes->begin(), meshes->end(),
                       [](const Json& mesh) { return mesh.is_object() && mesh.contains("obj"); });
}

/// The scene with the method that it was drawn by; its text is "" if the page cannot draw it: it is not JSON, names files,
/// or numbers vary. A small one in the plane can be moved, and has the canvas that it was drawn on: it has at most
/// most_primitives_to_move primitives, and a canvas no larger than those with answers about each pixel.
PageScene scene_of_page(const Source& source, const MethodOverrides& method, const Canvas& canvas) {
    Json scene = Json::parse(source.text, nullptr, false);
    if (!scene.is_object() || scene.contains("vary") || names_files(scene))
        return {};
    const bool is_movable =
        can_be_moved(scene) && std::max(canvas.width, canvas.height) <= largest_side_with_why_not;
    if (is_movable)
        scene["canvas"] = {
            {"width", canvas.width}, {"height", canvas.height}, {"origin", name_of(canvas.origin)}};
    for (const auto& [key, value] : method) {
        const MethodKey* const row = find_method_key(key);
        Json& place = key == "convention" ? scene : scene["method"];
        place[key] =
            row != nullptr && row->is_number() ? Json::parse(value, nullptr, false) : Json(value);
    }
    return {.text = scene.dump(),
            .is_movable = is_movable,
            .can_be_turned = scene.contains("projection") || scene.contains("camera")};
}

/// What a command that is typed beside the input calls it, with the options that it was drawn with; "" for a pipe.
std::string input_of_page(const FigureCommand& command, const InputFrames& input,
                          std::size_t frame) {
    if (command.trace == "-")
        return {};
    std::string text = shell_word(std::filesystem::path(command.trace).filename().string());
    for (const auto& [key, value] : command.scenes.method)
        text += fmt::format(" --{} {}", key, value);
    if (input.is_sequence())
        text += fmt::format(" --frame {}", frame);
    return text;
}

/// The module that lets pages draw: the file that RASTERTRACE_MODULE names, that of this program, or the installed one.
std::string module_for_pages() {
    std::filesystem::path file = environment_variable("RASTERTRACE_MODULE");
    if (file.empty() && !wasm_module().empty())
        return std::string(wasm_module());
    if (file.empty())
        file = installed_module();
    if (file.empty())
        return {};
    const std::string text = value_or_throw(read_named_file(file.string(), {})).text;
    if (text.find("var rastertrace = ") == std::string::npos ||
        text.find("</script") != std::string::npos)
        throw problem_of(file.string(), "expected the module for pages, found another file",
                         "it is share/rastertrace/rastertrace.js of an installation");
    return text;
}

/// What is shown of the first frame where there is no JavaScript; "" of a large canvas.
std::string picture_without_script(const Trace& trace, const FigureCommand& command) {
    if (std::max(trace.canvas.width, trace.canvas.height) > largest_side_with_why_not)
        return {};
    const std::vector<FigureFrame> last{{.steps = {0, trace.size()}}};
    FigureMaker maker(trace, last, {.view = command.figure.view});
    return value_or_throw(svg_of(maker.figure(0), command.style.theme));
}

/// What the page says of its first frame.
void set_options(const FigureCommand& command, const InputFrames& input, const Trace& trace,
                 PageOptions& options) {
    options.title = command.figure.title.value_or(trace.title);
    if (command.which == FigureCommand::Which::step) {
        const Selector selector =
            value_or_throw(parse_selector({"--step", command.selector}, trace));
        options.step = value_or_throw(matching_step(selector, trace, "say which"));
    }
    options.picture = picture_without_script(trace, command);
    if (const Source* const scene = input.given_scene())
        options.scene = scene_of_page(*scene, command.scenes.method, trace.canvas);
}

/// The traces of all frames. Those that have no room on the page are refused before any is written down.
std::vector<Trace> traces_of_page(InputFrames& input) {
    std::vector<Trace> traces;
    std::size_t steps = 0;
    for (std::size_t frame = input.first(); frame <= input.last(); ++frame) {
        const Trace& trace = traces.emplace_back(input.trace(frame));
        if (const auto problem = too_large_for_page(trace))
            throw *problem;
        steps += trace.size();
        if (steps > most_page_steps)
            throw problem_of("",
                             fmt::format("expected at most {} steps for a page, found more in the "
                                         "first {} frames",
                                         most_page_steps, traces.size()),
                             "--frame N makes a page of one frame");
    }
    return traces;
}

} // namespace

ExitStatus write_page(const FigureCommand& command) {
    InputFrames input(command.trace, command.scenes);
    ExitStatus status = exit_fine;
    PageOptions options{.theme = command.style.theme, .view = command.figure.view};
    options.module = module_for_pages();
    std::vector<PageFrame> frames;
    bool is_needed = false; // the scene, to be drawn by the page
    const std::vector<Trace> traces = traces_of_page(input);
    for (std::size_t frame = input.first(); frame <= input.last(); ++frame) {
        const Trace& trace = traces[frame - input.first()];
        status = std::max(status, report_damage(trace));
        if (frames.empty())
            set_options(command, input, trace, options);
        is_needed = is_needed || options.scene.is_movable || options.scene.can_be_turned;
        const bool can_draw = !options.module.empty() && !options.scene.text.empty();
        const PageDetail detail{.why_not_asked = can_draw ? few_why_not_asked : most_why_not_asked};
        is_needed = is_needed || (can_draw && !has_answers(trace, detail) &&
                                  trace.size() <= most_steps_with_working);
        frames.push_back(
            {.label = input.is_sequence() ? input.label(frame) : std::string(),
             .data = page_data(trace, detail, steps_in_space(trace, command.figure.eye).get()),
             .file = input_of_page(command, input, frame)});
    }
    if (!is_needed)
        options.scene = {};
    const std::string page = page_of(frames, options);
    if (command.output == "-")
        print(page);
    else
        write_file(command.output, page);
    return status;
}

} // namespace rastertrace
