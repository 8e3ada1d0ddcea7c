// SPDX-License-Identifier: MIT
#include "facts.h"

#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <string_view>

namespace rastertrace {

namespace {

/// Facts as they are counted, of one primitive after the other.
class Counts {
public:
    void add(const Trace& trace, std::size_t n) {
        const StepView step = trace.step(n);
        const auto kind = trace.kind_of(n);
        if (!kind)
            return;
        switch (*kind) {
        case StepKind::primitive: {
            const auto primitive = step.as<PrimitiveStep>();
            name_ = primitive.name.text();
            if (primitive.part.is_true())
                name_ = name_.substr(0, name_.find('/'));
            count(primitive.part.is_true() ? "parts" : "times drawn");
            if (primitive.octant)
                add_octant(*primitive.octant);
            break;
        }
        case StepKind::edge: {
            const auto edge = step.as<EdgeStep>();
            if (edge.octant)
                add_octant(*edge.octant);
            else if (edge.dx_dy.text() == "null")
                count("horizontal edges");
            break;
        }
        case StepKind::face:
            count(step.as<FaceStep>().culled.is_true() ? "culled faces" : "faces that are seen");
            break;
        case StepKind::skip:
            count("times skipped");
            break;
        case StepKind::scanline: {
            const auto row = step.as<ScanlineStep>();
            count("rows");
            for (const std::string& end : {row.left.text(), row.right.text()})
                add_tie(is_whole(end));
            break;
        }
        case StepKind::sample: {
            const auto weights = step.as<SampleStep>().weights.texts();
            add_tie(std::find(weights.begin(), weights.end(), "0") != weights.end() &&
                    std::none_of(weights.begin(), weights.end(), [](const std::string& weight) {
                        return weight.starts_with('-');
                    }));
            break;
        }
        case StepKind::decide:
            add_tie(step.as<DecideStep>().d.text() == "0");
            count("decisions");
            counts_[name_ + (step.as<DecideStep>().move.text().size() > 1
                                 ? ": diagonal steps, more than none"
                                 : ": straight steps, more than none")] = 1;
            break;
        case StepKind::along: {
            const auto value = number_in(step.as<AlongStep>().value.text());
            add_tie(value && value->get_den() == 2);
            count("pixels along it");
            break;
        }
        case StepKind::clip:
            count("cuts");
            break;
        case StepKind::depth:
            if (!step.as<DepthStep>().pass.is_true())
                counts_[name_ + ": hidden pixels, more than none"] = 1;
            break;
        default:
            break;
        }
    }

    std::vector<std::string> facts() const {
        std::vector<std::string> told;
        for (const auto& [what, count] : counts_)
            told.push_back(fmt::format("{}: {}", what, count));
        return told;
    }

private:
    static bool is_whole(const std::string& number) {
        const auto value = number_in(number);
        return value && value->get_den() == 1;
    }
    void count(std::string_view what) { ++counts_[fmt::format("{}: {}", name_, what)]; }
    void add_tie(bool is_tie) {
        if (is_tie)
            count("ties");
    }
    void add_octant(Index octant) { count(fmt::format("lines in octant {}", octant)); }

    std::string name_; ///< of the primitive
    std::map<std::string, int> counts_;
};

} // namespace

std::vector<std::string> facts_of(const Trace& trace) {
    Counts counts;
    for (std::size_t n = 1; n <= trace.size(); ++n)
        counts.add(trace, n);
    return counts.facts();
}

} // namespace rastertrace
