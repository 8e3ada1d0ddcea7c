// SPDX-License-Identifier: MIT
#include "diff_reach.h"

#include <rastertrace/trace/record/traced_steps.h>

#include <algorithm>

namespace rastertrace {

namespace {

bool has_name(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

} // namespace

OwnerOfPixels owner_in(const Trace& trace, std::size_t n) {
    if (n == 0)
        return {};
    const auto primitive = trace.step(n).as<PrimitiveStep>();
    return {.name = primitive.name.text(),
            .face = name_of_whole(primitive),
            .vertices = primitive.vertices.texts()};
}

DiffReach::DiffReach(const FirstDifference& first, const Trace& a, const Trace& b)
    : first_(first), faces_{owner_in(a, first.section.a).face, owner_in(b, first.section.b).face} {}

bool DiffReach::has(Pixel pixel, const OwnerOfPixels& owner) const {
    return (first_.a && reaches(*first_.a, pixel, owner)) ||
           (first_.b && reaches(*first_.b, pixel, owner));
}

bool DiffReach::reaches(const KeyedStep& keyed, Pixel pixel, const OwnerOfPixels& owner) const {
    const bool is_of_face = has_name(faces_, owner.face);
    if (!keyed.kind)
        return is_of_face;
    const StepView step = keyed.view();
    switch (*keyed.kind) {
    case StepKind::matrix:
    case StepKind::order:
    case StepKind::triangulate:
        return true;
    case StepKind::vertex:
        return has_name(owner.vertices, name_in(step).text());
    case StepKind::crossings:
    case StepKind::scanline:
        return is_of_face && y_in(step) == pixel.y;
    case StepKind::sample:
    case StepKind::depth:
    case StepKind::pixel:
        return is_of_face && x_in(step) == pixel.x && y_in(step) == pixel.y;
    default:
        return is_of_face;
    }
}

} // namespace rastertrace
