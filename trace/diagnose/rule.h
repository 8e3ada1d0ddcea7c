// SPDX-License-Identifier: MIT
#pragma once

// A rule by which a picture may have been drawn: a convention, with or without mistakes.
//
//     const Rule rule{.settings = {{"rounding", "half-open"}}, .mistakes = {find_mistake("height-plus-one")}};
//     const auto drawn = drawn_by(rule, scene);

#include <rastertrace/core/draw/model/mistakes.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/problem.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

struct Rule {
    MethodOverrides settings = {}; ///< in the place of what a scene says
    std::vector<const Mistake*> mistakes = {};

    friend bool operator==(const Rule&, const Rule&) = default;
};

/// Its settings and its mistakes: `rounding=half-open, height-plus-one`; `as the scene asks` if there is none.
std::string name_of(const Rule& rule);

/// The rule of that name: mistakes, conventions, settings, joined by commas as above. `nullopt` if there is none.
std::optional<Rule> rule_named(std::string_view name);

/// In fractions, or, where no mistake is put in, in doubles: faster, and now and then another pixel.
enum class DrawnIn { fractions, doubles };

/// A scene drawn by a rule. `nullopt` if it cannot be drawn so.
std::optional<Image> drawn_by(const Rule& rule, const Source& scene,
                              DrawnIn numbers = DrawnIn::fractions);

/// The trace of a scene drawn by a rule, in fractions. `nullopt` if it cannot be drawn so.
std::optional<Trace> traced_by(const Rule& rule, const Source& scene);

/// The rules that a scene may have been drawn by: all values of each setting that its picture may depend on, alone and
/// in the combinations that decide which pixels are covered; the named conventions; the known mistakes. The first one
/// is what the scene asks for. With `any_convention`, mistakes are also made with each convention.
std::vector<Rule> rules_for(const Source& scene, bool any_convention);

} // namespace rastertrace
