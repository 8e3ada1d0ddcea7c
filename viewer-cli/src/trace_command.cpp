// SPDX-License-Identifier: MIT
// `rastertrace trace`: draws a scene and writes its trace.

#include "commands.h"
#include "load.h"

#include <rastertrace/trace/output.h>
#include <rastertrace/trace/text.h>

#include <fmt/core.h>

#include <unistd.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

/// JSON Lines for a file that is named so, else one JSON document.
TraceLayout layout_of(const TraceCommand& command) {
    if (command.layout)
        return *command.layout;
    return command.output.ends_with(".jsonl") ? TraceLayout::jsonl : TraceLayout::json;
}

} // namespace

int run(const TraceCommand& command) {
    const auto [scene, plan, files, remarks] =
        load_scene(command.scene, command.method, command.input);
    if (const auto& name = command.filter.primitive) {
        std::vector<std::string_view> names;
        for (const ScenePrimitive& primitive : scene.primitives)
            names.push_back(primitive.name);
        if (std::find(names.begin(), names.end(), *name) == names.end())
            throw problem_of(command.scene,
                             fmt::format("expected a primitive of the scene, found {}", *name),
                             did_you_mean(*name, names));
    }
    const TraceOptions options{.layout = layout_of(command), .filter = command.filter};

    if (command.output.empty() || command.output == "-") {
        DescriptorOutput output(STDOUT_FILENO, "standard output");
        write_trace(scene, plan, options, output);
        return exit_fine;
    }
    FileOutput output(command.output, files);
    write_trace(scene, plan, options, output);
    output.commit();
    return exit_fine;
}

} // namespace rastertrace
