// SPDX-License-Identifier: MIT
#include "diff_reach.h"

#include <algorithm>

namespace rastertrace {

namespace {

bool has_name(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

} // namespace

OwnerOfPixels owner_in(const std::string& primitive_json) {
    const StepView step(primitive_json);
    OwnerOfPixels owner{.name = step.text("name"), .vertices = step.texts("vertices")};
    owner.face =
        step.text("part") == "true" ? owner.name.substr(0, owner.name.rfind('/')) : owner.name;
    return owner;
}

DiffReach::DiffReach(const FirstDifference& first) : first_(first) {
    for (const std::string* const json : {&first.section.json_a, &first.section.json_b})
        faces_.push_back(owner_in(*json).face);
}

bool DiffReach::has(Pixel pixel, const OwnerOfPixels& owner) const {
    return (first_.a && reaches(*first_.a, pixel, owner)) ||
           (first_.b && reaches(*first_.b, pixel, owner));
}

bool DiffReach::reaches(const StepLine& line, Pixel pixel, const OwnerOfPixels& owner) const {
    const bool is_of_face = has_name(faces_, owner.face);
    if (!line.kind)
        return is_of_face;
    const StepView step(line.json);
    switch (*line.kind) {
    case StepKind::matrix:
    case StepKind::order:
    case StepKind::triangulate:
        return true;
    case StepKind::vertex:
        return has_name(owner.vertices, step.text("name"));
    case StepKind::scanline:
        return is_of_face && step.whole("y") == pixel.y;
    case StepKind::sample:
    case StepKind::depth:
    case StepKind::pixel:
        return is_of_face && step.whole("x") == pixel.x && step.whole("y") == pixel.y;
    default:
        return is_of_face;
    }
}

} // namespace rastertrace
