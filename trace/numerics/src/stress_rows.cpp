// SPDX-License-Identifier: MIT
#include "stress_rows.h"

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cassert>

namespace rastertrace {

// Written by embed.cmake.
std::string cases_json();
std::string scenes_json();

namespace {

/// One of the two files, parsed.
struct Table {
    explicit Table(std::string text)
        : source{"stress", std::move(text)}, document(parse_json(source).value()) {}
    Source source;
    JsonDocument document;
};

const Table& cases_table() {
    static const Table table(cases_json());
    return table;
}

const Table& scenes_table() {
    static const Table table(scenes_json());
    return table;
}

JsonValue member(const JsonValue& object, std::string_view key) {
    return object.find(key).value();
}

JsonValue entry_of(const StressCase& one) {
    return cases_table().document.root().elements()[one.place];
}

const std::vector<std::string_view>& scalar_names() {
    return find_method_key("scalar")->values;
}

bool is_scalar(std::string_view name) {
    const auto& names = scalar_names();
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// The largest relative error of one correctly rounded operation: 2^-24 for float, 2^-53 for double, which is
/// what `fixed` divides in.
double rounding_unit(std::string_view scalar) {
    return scalar == "float" ? 0x1p-24 : 0x1p-53;
}

/// {"wrong": 590, "worst": "0.024"}, {"within": 1e-9}, {"right": "the note"} or {"refused": "the message"}.
Documented documented_in(const JsonValue& json, std::string_view scalar) {
    Documented documented;
    for (const auto& [key, value] : json.members()) {
        if (key.text == "wrong") {
            documented.verdict = Verdict::wrong;
            documented.wrong = number_in<std::uint64_t>(value.text);
        } else if (key.text == "within" || key.text == "within_units") {
            documented.verdict = Verdict::within;
            documented.bound =
                number_in<double>(value.text) * (key.text == "within" ? 1 : rounding_unit(scalar));
        } else if (key.text == "worst") {
            documented.worst = value.text;
        } else if (key.text == "refused") {
            documented.verdict = Verdict::refused;
            documented.note = value.text;
        } else if (key.text == "right" || key.text == "note") {
            documented.note = value.text;
        }
    }
    return documented;
}

/// Z7: 4096 layers, the first of them red.
std::string layers() {
    std::string list;
    for (int i = 0; i < 4096; ++i)
        list += fmt::format(R"({}{{"vertices": "ABC", "name": "layer {}", "color": "{}"}})",
                            i == 0 ? "" : ",\n    ", i + 1, i == 0 ? "red" : "blue");
    return "[\n    " + list + "]";
}

void replace_all(std::string& text, std::string_view part, std::string_view by) {
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + by.size()))
        text.replace(at, part.size(), by);
}

Result<Scene> scene_in(std::string_view json, const MethodOverrides& method) {
    auto planned = read_scene({"scene", std::string(json)}, method);
    if (!planned)
        return planned.problem();
    return std::move(planned.value().scene);
}

/// What a scene's picture must be.
Colors exact_picture(const TableRow& row, const Scene& scene) {
    if (row.has("reference"))
        return clipped_picture(scene);
    const auto pixels = row.json.find("picture");
    if (!pixels)
        return reference_picture(scene);
    Colors picture(scene.canvas.area(), no_color);
    for (const JsonValue& pixel : pixels->elements()) {
        const JsonElements told = pixel.elements();
        const auto place =
            number_in<std::size_t>(told[1].text) * static_cast<std::size_t>(scene.canvas.width) +
            number_in<std::size_t>(told[0].text);
        picture[place] = *parse_color(told[2].text);
    }
    return picture;
}

/// Draws a scene with every scalar and compares each pixel with the exact picture. For `fixed` that
/// is the picture of the vertices snapped to 1/256 pixel.
void add_pictures(const TableRow& row, std::vector<StressRow>& rows) {
    const std::string json = scene_text(row.text("scene"));
    const std::string label = row.text("method");
    Colors reference;
    Colors on_grid;
    if (const auto typed =
            scene_in(json, row.method("exact", row.has("against") ? "against" : "by"))) {
        reference = exact_picture(row, typed.value());
        on_grid = exact_picture(row, snapped_to_grid(typed.value()));
    }
    if (row.has("pixels"))
        rows.push_back(
            {"reference",
             label,
             expected_count(drawn_in(reference), row.number<std::uint64_t>("pixels"), "pixel"),
             {}});

    for (const std::string_view scalar : scalar_names()) {
        const auto measured = [&]() -> Measured {
            const auto scene = scene_in(json, row.method(scalar));
            if (!scene)
                return {.is_refused = true, .note = scene.problem().message};
            if (reference.empty())
                return {.wrong = 1, .unit = "scene", .note = "it is drawn"};
            const bool is_fixed = scene.value().method.scalar == ScalarKind::fixed;
            const Image picture = draw(scene.value(), plan_for(scene.value()));
            std::string note = counted(picture.drawn(), "pixel");
            if (const auto moved = differing(on_grid, reference); is_fixed && moved > 0)
                note += fmt::format("; the grid of 1/256 moves {}", moved);
            return {.wrong = differing(picture.colors(), is_fixed ? on_grid : reference),
                    .unit = "pixel",
                    .note = note};
        }();
        rows.push_back({std::string(scalar), label, measured, documented_of(row, scalar)});
    }
}

Measured measure_of(const TableRow& row, std::string_view scalar) {
    const std::string name = row.text("measure");
    for (auto* const family : {line_measures, scanline_measures, edge_function_measures,
                               depth_measures, pipeline_measures, stage_measures})
        for (const NamedMeasure& one : family())
            if (one.name == name)
                return one.measure(row, scalar);
    return {.is_refused = true, .note = fmt::format("there is no measure \"{}\"", name)};
}

} // namespace

std::string TableRow::text(std::string_view key) const {
    const auto value = json.find(key);
    return value ? value->text : "";
}

MethodOverrides TableRow::method(std::string_view scalar, std::string_view key) const {
    MethodOverrides method;
    if (const auto keys = json.find(key))
        for (const auto& [name, value] : keys->members())
            method.emplace_back(name.text, value.text);
    if (is_scalar(scalar))
        method.emplace_back("scalar", scalar);
    return method;
}

Scene TableRow::scene(std::string_view scalar, std::string_view key,
                      std::string_view method_key) const {
    return readable_scene(scene_text(text(key)), method(scalar, method_key));
}

Trace TableRow::trace(std::string_view scalar) const {
    return trace_of(scene(scalar));
}

Documented documented_of(const TableRow& row, std::string_view scalar) {
    const auto verdict = row.json.find("verdict");
    if (!verdict)
        return {};
    for (const auto& [scalars, documented] : verdict->members()) {
        if (documented.kind != JsonValue::Kind::object)
            return documented_in(*verdict, scalar);
        const auto named = split_at(scalars.text, ' ');
        if (scalars.text == "all" || std::find(named.begin(), named.end(), scalar) != named.end())
            return documented_in(documented, scalar);
    }
    return {};
}

std::string scene_text(std::string_view name) {
    const Table& table = scenes_table();
    const auto as_typed = [&table](const JsonValue& value) {
        return std::string(table.source.view().substr(value.begin, value.end() - value.begin));
    };
    const JsonValue scene = member(table.document.root(), name);
    if (scene.kind == JsonValue::Kind::object)
        return as_typed(scene);
    std::string text;
    int place = 0;
    for (const JsonValue& part : scene.elements()) {
        if (place == 0)
            text = scene_text(part.text);
        else if (part.text == "layers")
            replace_all(text, R"("$1")", layers());
        else
            // A string is text of any kind, also what is no JSON.
            replace_all(text, fmt::format(R"("${}")", place),
                        part.kind == JsonValue::Kind::string ? part.text : as_typed(part));
        ++place;
    }
    return text;
}

Scene readable_scene(std::string_view json, const MethodOverrides& method) {
    auto scene = scene_in(json, method);
    assert(scene && "the catalogue's own scenes can be read");
    return std::move(scene.value());
}

Trace trace_of(const Scene& scene) {
    return drawn_trace(scene, plan_for(scene), "trace", any_number);
}

Measured expected_count(std::uint64_t found, std::uint64_t expected, std::string_view unit) {
    const std::string count = counted(found, unit);
    if (found == expected)
        return {.note = count};
    return {.wrong = 1, .note = fmt::format("{}, not {}", count, expected)};
}

Measured counted_as(const TableRow& row, std::uint64_t found) {
    const std::string unit = row.text("unit");
    if (row.has("expected"))
        return expected_count(found, row.number<std::uint64_t>("expected"), unit);
    return {.wrong = found, .unit = unit};
}

std::uint64_t count_of(const Trace& trace, StepKind kind) {
    return trace.steps_of({kind}).size();
}

Colors drawn_picture(const Scene& scene) {
    return draw(scene, plan_for(scene)).colors();
}

Colors drawn_alone(const Scene& scene, std::size_t primitive) {
    Scene alone = scene;
    alone.primitives = {scene.primitives[primitive]};
    return drawn_picture(alone);
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

std::uint64_t count_in(const CoveredPixels& covered) {
    return static_cast<std::uint64_t>(std::count(covered.begin(), covered.end(), true));
}

std::uint64_t common_pixels(const CoveredPixels& a, const CoveredPixels& b) {
    std::uint64_t common = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        common += a[i] && b[i] ? 1 : 0;
    return common;
}

std::vector<StressScene> StressCase::scenes() const {
    std::vector<StressScene> scenes;
    if (const auto named = entry_of(*this).find("scenes"))
        for (const auto& [name, scene] : named->members())
            scenes.push_back({name.text, scene_text(scene.text)});
    return scenes;
}

std::span<const StressCase> stress_cases() {
    static const std::vector<StressCase> cases = [] {
        std::vector<StressCase> all;
        for (const JsonValue& entry : cases_table().document.root().elements()) {
            const auto text = [&entry](std::string_view key) { return member(entry, key).text; };
            all.push_back({.id = text("id"),
                           .title = text("title"),
                           .input = text("input"),
                           .why = text("why"),
                           .holds = text("holds"),
                           .place = all.size()});
        }
        return all;
    }();
    return cases;
}

std::vector<StressRow> rows_of(const StressCase& one, const StressOptions& options) {
    std::vector<StressRow> rows;
    const auto add = [&](const TableRow& row, std::string_view scalar) {
        if (options.quick && row.has("slow") && scalar != scalar_names().front())
            return;
        rows.push_back({std::string(scalar), row.text("method"), measure_of(row, scalar),
                        documented_of(row, scalar)});
    };
    for (const JsonValue& entry : member(entry_of(one), "rows").elements()) {
        const TableRow row{entry};
        const auto in_turn = entry.find("each");
        if (row.has("scalar"))
            add(row, row.text("scalar"));
        else if (!in_turn && !row.has("measure"))
            add_pictures(row, rows);
        else
            for (const std::string_view scalar : scalar_names()) {
                if (!in_turn)
                    add(row, scalar);
                else
                    for (const JsonValue& other : in_turn->elements())
                        add({other}, scalar);
            }
    }
    return rows;
}

} // namespace rastertrace
