// SPDX-License-Identifier: MIT
#include "face_groups.h"

#include <rastertrace/trace/text/language.h>

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
std::string mesh_of(const PrimitiveStep& primitive) {
    std::string name = name_of_whole(primitive);
    const auto is_face = [&name](std::size_t dot) {
        return dot + 1 < name.size() && name[dot + 1] == 'f' &&
               name.find_first_not_of("0123456789.", dot + 2) == std::string::npos;
    };
    for (std::size_t dot = name.find('.'); dot != std::string::npos; dot = name.find('.', dot + 1))
        if (is_face(dot))
            return name.substr(0, dot);
    return name;
}

std::string color_of(const PrimitiveStep& primitive) {
    return primitive.color.text();
}

/// What faces are put together by.
struct Grouping {
    Words heading; ///< said before the letters; nothing for faces
    std::string (*group_of)(const PrimitiveStep& primitive);
};
constexpr std::array<Grouping, 3> groupings{
    {{"", name_of_face}, {"meshes: ", mesh_of}, {"colors: ", color_of}}};

/// Puts primitives in the scene's order: that in which they are drawn, unless the painter has sorted them.
void sort_as_listed(std::vector<std::size_t>& primitives, const Trace& trace, std::size_t order) {
    std::sort(primitives.begin(), primitives.end());
    if (order == 0)
        return;
    const auto step = trace.step(order).as<OrderStep>();
    const auto sorted = step.names.texts();
    const auto listed = step.listed.values();
    std::unordered_map<std::string, double> place_of;
    for (std::size_t i = 0; i < std::min(sorted.size(), listed.size()); ++i)
        place_of.emplace(sorted[i], listed[i].nearest_double().value_or(0));
    // Only triangles are sorted; what is not in the list comes behind it.
    const auto place = [&](std::size_t primitive) {
        const auto found = place_of.find(name_of_whole(trace.step(primitive).as<PrimitiveStep>()));
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
        if (auto group = grouping.group_of(trace.step(step).as<PrimitiveStep>());
            known.insert(group).second)
            groups.push_back(std::move(group));
    return groups;
}

/// Puts primitives into groups: those that there are, and others as long as there are fewer than `most`.
void add_members(FaceGroups& groups, const std::vector<std::size_t>& primitives, const Trace& trace,
                 std::size_t most) {
    std::unordered_map<std::string, std::size_t> places;
    for (const std::string& name : groups.names)
        places.emplace(name, places.size());
    for (const std::size_t primitive : primitives) {
        std::string name = groups.name_of(trace.step(primitive).as<PrimitiveStep>());
        auto place = places.find(name);
        if (place == places.end() && groups.names.size() < most) {
            place = places.emplace(name, places.size()).first;
            groups.names.push_back(std::move(name));
        }
        if (place != places.end())
            groups.group_of.emplace(primitive, place->second);
    }
}

/// The primitives of which a step so far plots a pixel.
std::vector<std::size_t> plotting_primitives(const Replay& replay) {
    std::vector<std::size_t> plotting;
    std::size_t primitive = 0; // that has plotted none
    for (std::size_t n = 1; n <= replay.step(); ++n) {
        const auto kind = replay.trace().kind_of(n);
        if (kind == StepKind::primitive)
            primitive = n;
        else if (kind == StepKind::pixel && primitive != 0)
            plotting.push_back(std::exchange(primitive, 0));
    }
    return plotting;
}

} // namespace

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
    for (const Grouping& one : groupings) {
        result.names = groups_of(primitives, one, trace);
        result.heading = one.heading.in(language_of_steps());
        result.name_of = one.group_of;
        // One mesh says no more than that something is drawn; one face has a name.
        if (result.names.size() <= most && (result.names.size() > 1 || &one == groupings.data()))
            break;
    }
    add_members(result, primitives, trace, result.names.size());
    return result;
}

FaceGroups painted_face_groups(const Trace& trace, std::size_t most) {
    std::vector<std::size_t> painted;
    std::size_t order = 0;
    for (const std::size_t n : trace.steps_of({StepKind::order, StepKind::primitive}))
        if (trace.kind_of(n) == StepKind::order)
            order = n;
        else if (!trace.step(n).as<PrimitiveStep>().painted.is_false())
            painted.push_back(n);
    return face_groups(trace, std::move(painted), order, most);
}

FaceGroups face_groups_of_all_frames(const Replay& at_end, std::size_t most,
                                     const FaceGroups& before) {
    const Trace& trace = at_end.trace();
    auto visible = visible_primitives(at_end);
    FaceGroups result = face_groups(trace, visible, at_end.order(), most);
    if (result.name_of == before.name_of && result.names.size() <= most) {
        result.names = before.names;
        result.group_of.clear();
        sort_as_listed(visible, trace, at_end.order());
        add_members(result, visible, trace, most);
    }
    auto plotting = plotting_primitives(at_end);
    sort_as_listed(plotting, trace, at_end.order());
    add_members(result, plotting, trace, most);
    return result;
}

} // namespace rastertrace
