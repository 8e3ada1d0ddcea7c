// SPDX-License-Identifier: MIT
#include "compared_steps.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace rastertrace {

namespace {

bool has(const std::vector<std::string>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// True if a trace tells the steps of a kind.
bool tells(const Trace& trace, std::string_view kind) {
    return !trace.left_out.only || has(*trace.left_out.only, kind);
}

std::optional<Region> region_of(const Trace& trace) {
    if (!trace.left_out.region)
        return std::nullopt;
    const auto& corners = *trace.left_out.region;
    const auto number = [&corners](std::size_t i) { return static_cast<int>(corners[i]); };
    return Region{number(0), number(1), number(2), number(3)};
}

/// True if two stretches of whole numbers meet, each given by its ends in any order.
bool meet(Index from, Index to, Index low, Index high) {
    return std::min(from, to) <= high && low <= std::max(from, to);
}

/// False for a step about pixels that a region leaves out.
bool is_told(const KeyedStep& step, const std::optional<Region>& region) {
    if (!region || !step.kind)
        return true;
    const StepView view = step.view();
    switch (*step.kind) {
    case StepKind::scanline: {
        const auto row = view.as<ScanlineStep>();
        return region->has_row(row.y) && region->meets(row.from, row.to);
    }
    case StepKind::crossings:
        return region->has_row(view.as<CrossingsStep>().y);
    case StepKind::along: {
        const auto [x, y, value, other] = view.as<AlongStep>();
        return region->has_row(y.value_or(other)) &&
               region->meets(x.value_or(other), x.value_or(other));
    }
    case StepKind::reject: {
        const auto [x, to_x, y, to_y, why] = view.as<RejectStep>();
        return (!y || meet(*y, to_y.value_or(*y), region->y0, region->y1)) &&
               (!x || meet(*x, to_x.value_or(*x), region->x0, region->x1));
    }
    case StepKind::decide:
    case StepKind::sample:
    case StepKind::depth:
    case StepKind::pixel: {
        const Index x = *x_in(view);
        return region->has_row(*y_in(view)) && region->meets(x, x);
    }
    default:
        return true;
    }
}

/// A kind of step; of a vertex, with its space: other programs tell it in fewer of them.
std::string kind_with_space(const StepView& step) {
    const std::string kind(step.kind_name());
    return step.kind() == StepKind::vertex ? kind + " in " + step.as<VertexStep>().space.text()
                                           : kind;
}

/// The kinds of step that a trace has.
std::set<std::string, std::less<>> kinds_in(const Trace& trace) {
    std::set<std::string, std::less<>> kinds;
    for (std::size_t n = 1; n <= trace.size(); ++n)
        kinds.insert(kind_with_space(trace.step(n)));
    return kinds;
}

bool is_told(const std::string& primitive, const Trace& trace) {
    const std::string& only = trace.left_out.primitive;
    return only.empty() || primitive == only || primitive.starts_with(only + "/");
}

} // namespace

ComparedSteps::ComparedSteps(const Trace& a, const Trace& b, const DiffOptions& options)
    : a_(a), b_(b), options_(options) {
    if (!options.compares_common)
        return;
    common_ = kinds_in(a);
    auto in_b = kinds_in(b);
    // A picture without a pixel is a picture, too.
    if (common_->contains("pixel") || in_b.contains("pixel")) {
        common_->insert("pixel");
        in_b.insert("pixel");
    }
    std::erase_if(*common_, [&in_b](const std::string& kind) { return !in_b.contains(kind); });
}

bool ComparedSteps::has_kind(std::string_view with_space) const {
    const std::string_view kind = with_space.starts_with("vertex in ") ? "vertex" : with_space;
    return (!common_ || common_->contains(with_space)) &&
           (options_.only.empty() || rastertrace::has(options_.only, kind)) &&
           !options_.ignores(kind) && tells(a_, kind) && tells(b_, kind);
}

bool ComparedSteps::has_primitives() const {
    return tells(a_, "primitive") && tells(b_, "primitive") &&
           (!common_ || common_->contains("primitive"));
}

bool ComparedSteps::has(const KeyedStep& step) const {
    return has_kind(common_ ? kind_with_space(step.view()) : step.kind_name) &&
           is_told(step, region_of(a_)) && is_told(step, region_of(b_));
}

bool ComparedSteps::has_primitive(const std::string& name) const {
    return is_told(name, a_) && is_told(name, b_);
}

bool ComparedSteps::tells_all_primitives() const {
    return a_.left_out.primitive.empty() && b_.left_out.primitive.empty();
}

bool ComparedSteps::has_pictures() const {
    return has_kind("pixel") && a_.left_out.primitive == b_.left_out.primitive;
}

std::optional<Region> ComparedSteps::region() const {
    const auto a = region_of(a_);
    const auto b = region_of(b_);
    if (!a || !b)
        return a ? a : b;
    return Region{std::max(a->x0, b->x0), std::max(a->y0, b->y0), std::min(a->x1, b->x1),
                  std::min(a->y1, b->y1)};
}

std::vector<std::string> ComparedSteps::remarks() const {
    std::vector<std::string> remarks;
    if (a_.left_out.only || b_.left_out.only) {
        std::vector<std::string_view> kinds;
        for (const std::string_view kind : step_kind_names())
            if (tells(a_, kind) && tells(b_, kind))
                kinds.push_back(kind);
        remarks.push_back(
            said("compared: only steps of {}, which both traces tell", joined(kinds, ", ")));
    }
    if (common_) {
        std::vector<std::string> kinds;
        std::copy_if(common_->begin(), common_->end(), std::back_inserter(kinds),
                     [this](const std::string& kind) { return has_kind(kind); });
        remarks.push_back(
            said("compared: only the fields that both traces have, of {}", joined(kinds, ", ")));
    }
    if (const auto part = region())
        remarks.push_back(said("compared: only what is about the pixels from ({}, {}) to ({}, {})",
                               part->x0, part->y0, part->x1, part->y1));
    for (const std::string& name :
         std::set<std::string>{a_.left_out.primitive, b_.left_out.primitive})
        if (!name.empty())
            remarks.push_back(said("compared: only the steps of primitive {}", printable(name)));
    return remarks;
}

} // namespace rastertrace
