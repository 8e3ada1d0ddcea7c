// SPDX-License-Identifier: MIT
#include "rule.h"

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/conventions.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>

namespace rastertrace {

namespace {

using Settings = MethodOverrides;

/// Every choice out of one list with every choice out of another.
std::vector<Settings> combined(const std::vector<Settings>& a, const std::vector<Settings>& b) {
    std::vector<Settings> all;
    for (const Settings& first : a)
        for (const Settings& second : b) {
            all.push_back(first);
            all.back().insert(all.back().end(), second.begin(), second.end());
        }
    return all;
}

/// A choice for each value of a key.
std::vector<Settings> each(std::string_view key, std::initializer_list<std::string_view> values) {
    std::vector<Settings> all;
    for (const std::string_view value : values)
        all.push_back({{std::string(key), std::string(value)}});
    return all;
}

std::vector<Settings> joined_lists(std::initializer_list<std::vector<Settings>> lists) {
    std::vector<Settings> all;
    for (const auto& list : lists)
        all.insert(all.end(), list.begin(), list.end());
    return all;
}

/// Where samples lie, and where vertices go before.
std::vector<Settings> placements() {
    return combined(each("sample", {"integer", "center"}),
                    each("snap", {"none", "floor", "truncate", "nearest"}));
}

std::vector<Settings> nearest(std::initializer_list<std::string_view> ties) {
    return combined(each("rounding", {"nearest"}), each("ties", ties));
}

/// What decides which pixels a triangle covers. In exact numbers, two-halves draws as scanline, and one lerp as the other.
std::vector<Settings> coverages() {
    const auto by_rows = combined(
        combined(each("fill", {"scanline"}),
                 joined_lists({each("rounding", {"floor", "truncate", "inside", "half-open"}),
                               nearest({"up", "start", "away", "even"})})),
        each("rows", {"closed", "half-open"}));
    const auto by_samples = joined_lists(
        {each("fill", {"barycentric"}),
         combined(each("fill", {"top-left"}), each("horizontal_edge", {"top", "bottom"}))});
    const auto by_lines = combined(each("fill", {"fan"}), each("fan_passes", {"1", "2", "3"}));
    return joined_lists({combined(joined_lists({by_rows, by_samples}), placements()), by_lines});
}

/// What decides which pixels a line has. In exact numbers, dda draws as naive.
std::vector<Settings> lines() {
    const auto rounded = combined(each("line", {"naive"}),
                                  joined_lists({each("rounding", {"floor", "truncate", "inside"}),
                                                nearest({"start", "step", "up", "away", "even"})}));
    const auto on_grid = combined(each("line", {"bresenham"}), each("ties", {"start", "step"}));
    const auto ends = combined(each("from", {"first", "low"}), each("ends", {"both", "first"}));
    return joined_lists({combined(combined(joined_lists({rounded, on_grid}), ends), placements()),
                         combined(each("line", {"diamond-exit"}), placements())});
}

/// A named convention, whatever a scene says itself, but for its scalar: rules are compared in exact numbers.
Settings settings_of(const ConventionRow& row) {
    Settings settings{{"convention", std::string(row.name)}};
    for (const auto& [name, value] : row.method)
        if (name != "scalar")
            settings.emplace_back(name, value);
    return settings;
}

std::optional<PlannedScene> read_by(Settings settings, const Source& scene,
                                    std::string_view scalar = "exact") {
    settings.emplace_back("scalar", scalar);
    auto read = read_scene(scene, settings);
    return read ? std::optional(std::move(read.value())) : std::nullopt;
}

/// The settings of a rule, with those of its mistakes that are settings.
Settings all_settings(const Rule& rule) {
    Settings settings = rule.settings;
    for (const Mistake* const mistake : rule.mistakes)
        if (mistake->put_in == nullptr)
            for (auto& setting : settings_of(*mistake))
                settings.push_back(std::move(setting));
    return settings;
}

} // namespace

std::string name_of(const Rule& rule) {
    std::vector<std::string> words;
    for (const auto& [name, value] : rule.settings)
        words.push_back(fmt::format("{}={}", name, value));
    for (const Mistake* const mistake : rule.mistakes)
        words.emplace_back(mistake->name);
    return words.empty() ? "as the scene asks" : joined(words, ", ");
}

std::optional<Rule> rule_named(std::string_view name) {
    Rule rule;
    for (std::string word : split_at(std::string(name), ',')) {
        word.erase(0, word.find_first_not_of(' '));
        const auto convention = std::ranges::find(convention_rows(), word, &ConventionRow::name);
        if (const Mistake* const mistake = find_mistake(word)) {
            rule.mistakes.push_back(mistake);
        } else if (convention != convention_rows().end()) {
            rule.settings = settings_of(*convention);
        } else {
            const auto settings = parse_method({"", word});
            if (!settings)
                return std::nullopt;
            rule.settings.insert(rule.settings.end(), settings.value().begin(),
                                 settings.value().end());
        }
    }
    return rule;
}

std::optional<Image> drawn_by(const Rule& rule, const Source& scene, DrawnIn numbers) {
    auto read =
        read_by(all_settings(rule), scene, numbers == DrawnIn::doubles ? "double" : "exact");
    if (!read)
        return std::nullopt;
    read->scene.method.mistakes = rule.mistakes;
    if (!modelled_mistakes(read->scene).empty() && !has_model(read->scene))
        return std::nullopt;
    return draw(read->scene, read->plan);
}

std::optional<Trace> traced_by(const Rule& rule, const Source& scene) {
    constexpr std::size_t most_steps = 1'000'000;
    Settings settings = rule.settings;
    std::vector<std::string_view> names;
    for (const Mistake* const mistake : rule.mistakes)
        names.push_back(mistake->name);
    if (!names.empty())
        settings.emplace_back("mistake", joined(names, ","));
    const auto read = read_by(settings, scene);
    if (!read)
        return std::nullopt;
    return drawn_trace(read->scene, read->plan, scene.name, most_steps);
}

std::vector<Rule> rules_for(const Source& scene, bool any_convention) {
    std::vector<Rule> rules{Rule{}};
    const auto read = read_by({}, scene);
    if (!read)
        return rules;
    const Scene& asked = read->scene;
    const auto add = [&rules](const std::vector<Settings>& all) {
        for (const Settings& settings : all)
            rules.push_back({settings, {}});
    };
    const auto add_mistakes = [&rules](const Settings& settings, const Scene& of_scene) {
        for (const Mistake& mistake : mistakes())
            if (mistake.concerns(of_scene))
                rules.push_back({settings, {&mistake}});
    };
    for (const ConventionRow& row : convention_rows())
        rules.push_back({settings_of(row), {}});
    if (asked.has(PrimitiveKind::triangle))
        add(coverages());
    if (asked.has(PrimitiveKind::line) || asked.has(PrimitiveKind::outline))
        add(lines());
    for (const MethodKey& key : method_keys())
        if (key.name != "convention" && key.name != "scalar" && key.name != "mistake" &&
            key.in_force(asked))
            for (const std::string_view value : key.values)
                rules.push_back({{{std::string(key.name), std::string(value)}}, {}});
    add_mistakes({}, asked);
    for (const ConventionRow& row : convention_rows())
        if (const auto by_row = any_convention ? read_by(settings_of(row), scene) : std::nullopt)
            add_mistakes(settings_of(row), by_row->scene);
    return rules;
}

} // namespace rastertrace
