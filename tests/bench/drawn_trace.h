// SPDX-License-Identifier: MIT
#pragma once

// The trace of a scene, for what reads traces.

#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/output.h>

#include <cstdlib>
#include <string>
#include <utility>

namespace rastertrace {

/// The trace of a scene, drawn; the program ends if it is none.
inline Trace drawn_trace(const Source& source) {
    const auto scene = read_scene(source);
    if (!scene)
        std::abort();
    std::string text;
    StringOutput output(text);
    write_trace(scene.value().scene, scene.value().plan, {}, output);
    auto trace = read_trace({"trace", std::move(text)});
    if (!trace)
        std::abort();
    return std::move(trace.value());
}

} // namespace rastertrace
