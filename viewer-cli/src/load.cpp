// SPDX-License-Identifier: MIT
#include "load.h"

#include <rastertrace/trace/output.h>
#include <rastertrace/trace/scene_file.h>

#include <fmt/format.h>

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace rastertrace {

namespace {

template <typename T> T value_or_throw(Result<T> result) {
    if (!result)
        throw result.problem();
    return std::move(result.value());
}

} // namespace

Source load_scene_source(const std::string& path) {
    Source source = value_or_throw(read_source(path));
    if (is_trace(source))
        throw problem_of(source.name, "expected a scene, found a trace",
                         "a trace is what this command makes; `show` and `stats` read it");
    return source;
}

PlannedScene load_scene(const std::string& path, const MethodOverrides& method) {
    return value_or_throw(read_scene(load_scene_source(path), method));
}

Trace load_trace(const std::string& path, const MethodOverrides& method) {
    Source source = value_or_throw(read_source(path));
    if (is_trace(source)) {
        if (!method.empty())
            throw problem_of(source.name,
                             fmt::format("expected a scene to draw with --{} {}, found a trace, "
                                         "which is drawn already",
                                         method.front().first, method.front().second));
        return value_or_throw(read_trace(std::move(source)));
    }
    const auto [scene, plan] = value_or_throw(read_scene(source, method));
    Source drawn{.name = source.name, .text = {}};
    StringOutput output(drawn.text);
    write_trace(scene, plan, {}, output);
    return value_or_throw(read_trace(std::move(drawn)));
}

ExitStatus report_damage(const Trace& trace) {
    for (const Problem& problem : trace.damage)
        fmt::print(stderr, "rastertrace: {}\n", to_text(problem));
    return trace.damage.empty() ? exit_fine : exit_bad_input;
}

void print(std::string_view text) {
    DescriptorOutput(STDOUT_FILENO, "standard output").write(text);
}

} // namespace rastertrace
