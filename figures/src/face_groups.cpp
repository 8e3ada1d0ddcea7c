// SPDX-License-Identifier: MIT
#include <rastertrace/figures/face_groups.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace rastertrace {

namespace {

/// The mesh of a face: "torus" of "torus.f12", and of "torus.f12.1", a triangle of a face.
std::string mesh_of(const StepView& primitive) {
    std::string name = face_of(primitive);
    const auto is_face = [&name](std::size_t dot) {
        return dot + 1 < name.size() && name[dot + 1] == 'f' &&
               name.find_first_not_of("0123456789.", dot + 2) == std::string::npos;
    };
    for (std::size_t dot = name.find('.'); dot != std::string::npos; dot = name.find('.', dot + 1))
        if (is_face(dot))
            return name.substr(0, dot);
    return name;
}

std::string color_of(const StepView& primitive) {
    return primitive.text("color");
}

/// What faces are put together by.
struct Grouping {
    std::string_view heading; ///< said before the letters; nothing for faces
    std::string (*group_of)(const StepView& primitive);
};
constexpr std::array<Grouping, 3> groupings{
    {{"", face_of}, {"meshes: ", mesh_of}, {"colors: ", color_of}}};

/// Puts primitives in the scene's order: that in which they are drawn, unless the painter has sorted them.
void sort_as_listed(std::vector<std::size_t>& primitives, const Trace& trace, std::size_t order) {
    std::sort(primitives.begin(), primitives.end());
    if (order == 0)
        return;
    const StepView step = trace.step(order);
    const auto sorted = step.texts("names");
    const auto listed = step.texts("listed");
    std::unordered_map<std::string, double> place_of;
    for (std::size_t i = 0; i < std::min(sorted.size(), listed.size()); ++i)
        place_of.emplace(sorted[i], nearest_double_in(listed[i]).value_or(0));
    // Only triangles are sorted; what is not in the list comes behind it.
    const auto place = [&](std::size_t primitive) {
        const auto found = place_of.find(face_of(trace.step(primitive)));
        return found == place_of.end() ? std::numeric_limits<double>::infinity() : found->second;
    };
    std::stable_sort(primitives.begin(), primitives.end(),
                     [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
}

/// The groups, in the order of the primitives.
std::vector<std::string> groups_of(const std::vector<std::size_t>& primitives,
                                   const Grouping& grouping, const Trace& trace) {
    std::vector<std::string> groups;
    std::set<std::string> known;
    for (const std::size_t step : primitives)
        if (auto group = grouping.group_of(trace.step(step)); known.insert(group).second)
            groups.push_back(std::move(group));
    return groups;
}

} // namespace

std::string face_of(const StepView& primitive) {
    const std::string name = primitive.text("name");
    return primitive.text("part") == "true" ? name.substr(0, name.rfind('/')) : name;
}

std::vector<std::size_t> visible_primitives(const Replay& replay) {
    std::set<std::size_t> seen;
    for (const std::size_t step : replay.frame().drawn_by)
        if (step != 0)
            seen.insert(replay.primitive_of(step));
    seen.erase(0);
    return {seen.begin(), seen.end()};
}

FaceGroups face_groups(const Trace& trace, std::vector<std::size_t> primitives, std::size_t order,
                       std::size_t most) {
    sort_as_listed(primitives, trace, order);
    FaceGroups result;
    result.faces = primitives.size();
    const Grouping* grouping = nullptr;
    for (const Grouping& one : groupings) {
        result.names = groups_of(primitives, one, trace);
        grouping = &one;
        // One mesh says no more than that something is drawn; one face has a name.
        if (result.names.size() <= most && (result.names.size() > 1 || &one == groupings.data()))
            break;
    }
    result.heading = grouping->heading;
    std::unordered_map<std::string, std::size_t> places;
    for (const std::string& name : result.names)
        places.emplace(name, places.size());
    for (const std::size_t primitive : primitives)
        result.group_of.emplace(primitive, places.at(grouping->group_of(trace.step(primitive))));
    return result;
}

} // namespace rastertrace
