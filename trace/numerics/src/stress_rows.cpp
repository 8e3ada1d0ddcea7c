// SPDX-License-Identifier: MIT
#include "stress_rows.h"

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/output.h>

#include <fmt/core.h>

#include <algorithm>
#include <cassert>

namespace rastertrace {

namespace {

/// The words of a list that is separated by blanks.
bool names(std::string_view list, std::string_view word) {
    while (!list.empty()) {
        const std::size_t end = std::min(list.find(' '), list.size());
        if (list.substr(0, end) == word)
            return true;
        list.remove_prefix(std::min(end + 1, list.size()));
    }
    return false;
}

} // namespace

Documented documented_of(const DocumentedOfScalars& documented, std::string_view scalar) {
    for (const DocumentedOf& one : documented)
        if (one.scalars == "all" || names(one.scalars, scalar))
            return one.documented;
    return right();
}

const std::vector<std::string_view>& scalar_names() {
    return find_method_key("scalar")->values;
}

Result<Scene> scene_in(std::string_view json, const MethodOverrides& method) {
    auto planned = read_scene({"scene", std::string(json)}, method);
    if (!planned)
        return planned.problem();
    return std::move(planned.value().scene);
}

Scene readable_scene(std::string_view json, const MethodOverrides& method) {
    auto scene = scene_in(json, method);
    assert(scene && "the catalogue's own scenes can be read");
    return std::move(scene.value());
}

MethodOverrides with_scalar_named(MethodOverrides method, std::string_view scalar) {
    method.emplace_back("scalar", scalar);
    return method;
}

Result<Trace> trace_in(std::string_view json, const MethodOverrides& method,
                       const std::vector<StepKind>& only) {
    const auto scene = scene_in(json, method);
    if (!scene)
        return scene.problem();
    Source trace{.name = "trace", .text = {}};
    StringOutput output(trace.text);
    TraceOptions options;
    if (!only.empty())
        options.filter.only = only;
    write_trace(scene.value(), options, output);
    return read_trace(std::move(trace));
}

std::uint64_t count_of(const Trace& trace, StepKind kind) {
    std::uint64_t count = 0;
    for (std::size_t n = 1; n <= trace.size(); ++n)
        count += trace.kind_of(n) == kind ? 1 : 0;
    return count;
}

Colors drawn_picture(const Scene& scene) {
    return draw(scene, plan_for(scene)).colors();
}

Colors moved_picture(const Colors& picture, const Canvas& canvas, Index right, Index down) {
    Colors moved(picture.size(), no_color);
    const auto width = static_cast<Index>(canvas.width);
    for (Index row = 0; row < canvas.height; ++row)
        for (Index column = 0; column < width; ++column) {
            const Index from_row = row - down;
            const Index from_column = column - right;
            if (0 <= from_row && from_row < canvas.height && 0 <= from_column &&
                from_column < width)
                moved[static_cast<std::size_t>(row * width + column)] =
                    picture[static_cast<std::size_t>(from_row * width + from_column)];
        }
    return moved;
}

std::uint64_t differing(const Colors& a, const Colors& b) {
    assert(a.size() == b.size());
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        count += a[i] == b[i] ? 0 : 1;
    return count;
}

std::uint64_t drawn_in(const Colors& picture) {
    return picture.size() -
           static_cast<std::uint64_t>(std::count(picture.begin(), picture.end(), no_color));
}

std::uint64_t common_pixels(const CoveredPixels& a, const CoveredPixels& b) {
    std::uint64_t common = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        common += a[i] && b[i] ? 1 : 0;
    return common;
}

void StressRows::add(std::string_view scalar, std::string_view method, Measured measured,
                     const Documented& documented) {
    rows_.push_back({std::string(scalar), std::string(method), std::move(measured), documented});
}

void StressRows::expect_same(std::string_view scalar, std::string_view method, std::uint64_t found,
                             std::uint64_t expected, std::string_view unit) {
    add(scalar, method,
        {.wrong = found == expected ? 0u : 1u,
         .note = found == expected ? counted(found, unit)
                                   : fmt::format("{}, not {}", counted(found, unit), expected)},
        right());
}

void StressRows::add_pictures(std::string_view json, std::string_view label,
                              const MethodOverrides& method, std::optional<std::uint64_t> pixels,
                              const DocumentedOfScalars& documented, ReferenceOf reference_of) {
    // The exact picture, of the vertices as typed and as `fixed` has them.
    const Scene typed = readable_scene(json, with_scalar_named(method, "exact"));
    const Colors reference = reference_of(typed);
    const Colors on_grid = reference_of(snapped_to_grid(typed));
    if (pixels)
        expect_same("reference", label, drawn_in(reference), *pixels, "pixel");

    for (const std::string_view scalar : scalar_names()) {
        const Documented expected = documented_of(documented, scalar);
        const auto scene = scene_in(json, with_scalar_named(method, scalar));
        if (!scene) {
            add(scalar, label, {.is_refused = true, .note = scene.problem().message}, expected);
            continue;
        }
        const bool is_fixed = scene.value().method.scalar == ScalarKind::fixed;
        const Image picture = draw(scene.value(), plan_for(scene.value()));
        Measured measured{.wrong = differing(picture.colors(), is_fixed ? on_grid : reference),
                          .unit = "pixel",
                          .note = counted(picture.drawn(), "pixel")};
        if (is_fixed)
            if (const auto moved = differing(on_grid, reference))
                measured.note += fmt::format("; the grid of 1/256 moves {}", moved);
        add(scalar, label, std::move(measured), expected);
    }
}

void StressRows::add_refusals(std::string_view json, std::string_view label,
                              std::string_view message, const MethodOverrides& method) {
    for (const std::string_view scalar : scalar_names()) {
        const auto scene = scene_in(json, with_scalar_named(method, scalar));
        add(scalar, label,
            scene ? Measured{.wrong = 1, .unit = "scene", .note = "it is drawn"}
                  : Measured{.is_refused = true, .note = scene.problem().message},
            refused(message));
    }
}

} // namespace rastertrace
