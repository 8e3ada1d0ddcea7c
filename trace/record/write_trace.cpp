// SPDX-License-Identifier: MIT
#include "write_trace.h"

#include "step_tracer.h"
#include "step_writer.h"

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/core/draw/list/geometry.h>
#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/trace/text/canvas_json.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/pipeline_names.h>
#include <rastertrace/trace/text/stage_name.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <numeric>

namespace rastertrace {

namespace {

/// What numbers a kind of scalar is drawn with, where the plan chooses among several.
std::string_view numbers_in_words(const Scene& scene, const Plan& plan) {
    if (scene.method.scalar == ScalarKind::single_precision ||
        scene.method.scalar == ScalarKind::double_precision)
        return "";
    switch (plan.number) {
    case NumberType::fraction64:
        return "fractions of 64 bits";
    case NumberType::rational:
        return "fractions of any size";
    case NumberType::interval:
        return "doubles within intervals, and fractions of any size";
    case NumberType::binary32:
    case NumberType::binary64:
        break;
    }
    return "";
}

} // namespace

std::string header_members(const Scene& scene, const Plan& plan, const StepFilter& filter) {
    std::string text = fmt::format(R"("rastertrace":{})", trace_version);
    if (!scene.title.empty())
        text += fmt::format(R"(,"title":{})", json_quoted(scene.title));
    text += fmt::format(R"(,"canvas":{{"width":{},"height":{},"origin":"{}"}})", scene.canvas.width,
                        scene.canvas.height, name_of(scene.canvas.origin));
    if (scene.background)
        text += fmt::format(R"(,"background":"{}")", to_text(*scene.background));

    text += R"(,"method":{)";
    std::string_view separator;
    for (const MethodKey& key : method_keys())
        if (key.in_force(scene)) {
            const std::string_view quote = key.is_number() ? "" : "\"";
            text += fmt::format(R"({}"{}":{}{}{})", separator, key.name, quote,
                                value_in_force(key, scene), quote);
            separator = ",";
        }
    text += '}';

    if (const std::string_view numbers = numbers_in_words(scene, plan); !numbers.empty())
        text += fmt::format(R"(,"numbers":"{}")", numbers);
    if (scene.has_transforms())
        text += fmt::format(R"(,"projection":"{}","viewport":"{}")", name_of(scene.projection),
                            name_of(scene.viewport));
    if (decides_exactly(scene.method) && has_rounded_matrix(scene))
        text += R"(,"matrices":"irrational entries are the nearest doubles")";

    text += R"(,"stages":[)";
    separator = "";
    for (const StageDecision& decision : plan.stages.decisions) {
        text += fmt::format(R"({}{{"stage":"{}")", separator, name_of(decision.stage));
        if (!decision.plane.empty())
            text += fmt::format(R"(,"plane":"{}")", decision.plane);
        text +=
            fmt::format(R"(,"kept":{},"why":{}}})", decision.is_kept, json_quoted(decision.why));
        separator = ",";
    }
    text += ']';

    if (filter.only) {
        text += R"(,"only":[)";
        separator = "";
        for (const StepKind kind : *filter.only) {
            text += fmt::format(R"({}"{}")", separator, name_of(kind));
            separator = ",";
        }
        text += ']';
    }
    if (filter.region)
        text += fmt::format(R"(,"region":[{},{},{},{}])", filter.region->x0, filter.region->y0,
                            filter.region->x1, filter.region->y1);
    if (filter.primitive)
        text += fmt::format(R"(,"primitive":{})", json_quoted(*filter.primitive));
    return text;
}

std::string end_record(const KindCounts& count, const Image& image) {
    std::string counts;
    std::uint64_t steps = 0;
    for (std::size_t i = 0; i < step_kinds; ++i) {
        steps += count[i];
        if (count[i] > 0)
            counts +=
                fmt::format(R"({}"{}":{})", counts.empty() ? "" : ",", step_names[i], count[i]);
    }
    return fmt::format(R"("end":{{"steps":{},"count":{{{}}},"pixels":{},"frame":"{}"}})", steps,
                       counts, image.drawn(), frame_name(image));
}

std::string frame_name(const Image& image) {
    // FNV-1a's offset basis and prime for 64 bits.
    std::uint64_t hash = 0xCBF29CE484222325;
    constexpr std::uint64_t prime = 0x100000001B3;
    const auto mix = [&hash](std::uint8_t byte) { hash = (hash ^ byte) * prime; };
    for (const Color& color : image.colors()) {
        // A byte of 0 only multiplies, and four of them may do so at once.
        if (color == no_color) {
            hash *= prime * prime * prime * prime;
            continue;
        }
        mix(color.red());
        mix(color.green());
        mix(color.blue());
        mix(color.alpha());
    }
    return fmt::format("{:016x}", hash);
}

std::uint64_t write_trace(const Scene& scene, const TraceOptions& options, Output& output) {
    return write_trace(scene, plan_for(scene), options, output);
}

std::uint64_t write_trace(const Scene& scene, const Plan& plan, const TraceOptions& options,
                          Output& output) {
    const bool is_document = options.layout == TraceLayout::json;
    StepWriter writer(output, options.layout);
    Arena arena;
    StepTracer<StepWriter> tracer(writer, arena, false, options.filter);

    writer.put_text(fmt::format("{{{}{}", header_members(scene, plan, options.filter),
                                is_document ? R"(,"steps":[)" : "}"));

    const Image image = draw(scene, plan, tracer);

    const std::string end = end_record(writer.counts(), image);
    writer.put_text(fmt::format("\n{}{}}}\n", is_document ? "],\n" : "{", end));
    writer.flush();
    return std::accumulate(writer.counts().begin(), writer.counts().end(), std::uint64_t{0});
}

} // namespace rastertrace
