// SPDX-License-Identifier: MIT
#pragma once

// Scenes from text, and their traces.
//
//     const Trace trace = trace_of(scene_in(R"({"vertices":{"A":[1,2]},"points":["A"]})"));

#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/output.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

/// The scenes of the examples by their paths, in one order on every machine.
inline std::vector<std::string> example_files() {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(RASTERTRACE_EXAMPLES))
        if (entry.path().extension() == ".json")
            files.push_back(entry.path().string());
    std::sort(files.begin(), files.end());
    return files;
}

/// The scene that a file of this text describes.
inline Scene scene_in(const std::string& text) {
    auto read = read_scene({"folder/scene.json", text});
    if (!read) {
        ADD_FAILURE() << to_text(read.problem());
        return {};
    }
    return std::move(read.value().scene);
}

/// What a file of this text is refused with; "" if it is a scene.
inline std::string refusal_of_scene(const std::string& text) {
    const auto read = read_scene({"scene.json", text});
    return read ? "" : read.problem().message;
}

inline std::string trace_text(const Scene& scene, const TraceOptions& options = {}) {
    std::string text;
    StringOutput output(text);
    write_trace(scene, options, output);
    return text;
}
inline std::string trace_text(const PlannedScene& scene, const TraceOptions& options) {
    std::string text;
    StringOutput output(text);
    write_trace(scene.scene, scene.plan, options, output);
    return text;
}

/// JSON Lines: a step can be changed, put in or taken out without its neighbors.
inline const TraceOptions in_lines{.layout = TraceLayout::jsonl, .filter = {}};

/// A trace that can be read, with or without damage.
inline Trace readable_trace(const std::string& text) {
    auto trace = read_trace({"trace.json", text});
    if (!trace) {
        ADD_FAILURE() << to_text(trace.problem());
        return {};
    }
    return std::move(trace.value());
}

/// A trace without damage.
inline Trace sound_trace(const std::string& text) {
    Trace trace = readable_trace(text);
    for (const Problem& problem : trace.damage)
        ADD_FAILURE() << to_text(problem);
    return trace;
}

inline Trace trace_of(const Scene& scene) {
    return sound_trace(trace_text(scene));
}

/// The steps of a trace as they stand there.
inline std::vector<std::string> steps_of(const Trace& trace) {
    std::vector<std::string> steps;
    for (std::size_t n = 1; n <= trace.size(); ++n)
        steps.emplace_back(trace.step(n).json());
    return steps;
}

/// What is wrong with a trace, in messages.
inline std::vector<std::string> damage_of(const Trace& trace) {
    std::vector<std::string> damage;
    for (const Problem& problem : trace.damage)
        damage.push_back(to_text(problem));
    return damage;
}

} // namespace rastertrace
