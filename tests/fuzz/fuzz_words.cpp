// SPDX-License-Identifier: MIT
// Any bytes as what a user types or a page holds: a selector of steps, numbers that vary, a method, a file of one, a Markdown page with
// commands. What is wrong is said safely; what can be read holds together. The first byte chooses the reader.

#include "check.h"

#include <page.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/tell/selector.h>
#include <rastertrace/trace/text/method_file.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace rastertrace::fuzz {

namespace {

const Source& scene() {
    static const Source source{"small.json", R"({"canvas":{"width":6,"height":5},
"vertices":{"A":[2,2],"B":[-2,-1],"C":[2,-2]},"triangles":["ABC"]})"};
    return source;
}

const Trace& trace() {
    static const Trace drawn = [] {
        const PlannedScene planned = std::move(read_scene(scene()).value());
        Source source{"small.jsonl", {}};
        StringOutput output(source.text);
        write_trace(planned.scene, planned.plan, {.layout = TraceLayout::jsonl}, output);
        return std::move(read_trace(source).value());
    }();
    return drawn;
}

void read_selector(Source text) {
    const auto selector = parse_selector(std::move(text), trace());
    const auto steps = selector ? matching_steps(selector.value(), trace())
                                : Result<std::vector<std::size_t>>(selector.problem());
    if (!steps)
        return check_message(steps.problem());
    check(!steps.value().empty(), "a selector that means no step is no problem");
    check(steps.value().back() <= trace().size(), "a step that is meant is behind the last");
}

void read_vary(const Source& text) {
    const std::size_t equals = text.text.find('=');
    if (equals == std::string::npos)
        return;
    const SceneSequence scenes(scene(), {}, {},
                               {{text.text.substr(0, equals), text.text.substr(equals + 1)}});
    check(!has_control(scenes.label(scenes.count()), ' '), "a label has a control character");
}

void read_method(const Source& text) {
    const auto method = parse_method(text);
    if (!method)
        return check_message(method.problem());
    for (const auto& [key, value] : method.value())
        if (Method scratch; !find_method_key(key)->set(scratch, value))
            check(false, "a method has a value that its key does not take");
}

void read_method_file(const Source& file) {
    for (const auto& [key, value] : method_in(file))
        if (Method scratch; !find_method_key(key)->set(scratch, value))
            check(false, "a file of a method has a value that its key does not take");
}

/// Outputs that are put in place of those that are there: the same commands are on the page.
void read_page(const Source& page) {
    const auto commands = commands_on(page);
    std::vector<std::string> outputs;
    for (const PageCommand& command : commands)
        outputs.push_back(output_for(page, command, "one\ntwo\n"));
    const Source renewed{page.name, with_outputs(page, commands, outputs)};
    const auto again = commands_on(renewed);
    check(again.size() == commands.size(), "a renewed page has other commands");
    for (std::size_t i = 0; i < commands.size(); ++i)
        check(again[i].text == commands[i].text, "a renewed page has another command");
}

} // namespace

} // namespace rastertrace::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace rastertrace;
    if (size == 0)
        return 0;
    const Source text = fuzz::source_of("fuzz", data + 1, size - 1);
    try {
        switch (data[0] % 5) {
        case 0:
            fuzz::read_selector(text);
            break;
        case 1:
            fuzz::read_vary(text);
            break;
        case 2:
            fuzz::read_method(text);
            break;
        case 3:
            fuzz::read_method_file(text);
            break;
        default:
            fuzz::read_page(text);
        }
    } catch (const Problem& problem) {
        fuzz::check_message(problem);
    }
    return 0;
}
