// SPDX-License-Identifier: MIT
#include "face_cuts.h"

#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>

namespace rastertrace {

namespace {

/// How much of a name is shown.
constexpr std::size_t shown_of_name = 60;

std::string faces(std::size_t count) {
    return fmt::format("{} face{}", count, count == 1 ? "" : "s");
}

constexpr const char* fan_hint = "it is drawn as the fan of triangles from its first corner";

} // namespace

bool FaceCuts::is_bent(const Triangulation& cut, std::span<const std::size_t> corners) const {
    float unit = 0;
    for (const std::size_t corner : corners)
        unit = std::max(unit, units_[corner]);
    return !cut.is_planar && cut.off_plane >= unit;
}

std::string FaceCuts::edge(std::span<const std::size_t> corners, std::size_t from) const {
    const std::size_t to = from + 1 == corners.size() ? 0 : from + 1;
    return fmt::format("from {} to {}", shortened(vertices_[corners[from]].name, shown_of_name),
                       shortened(vertices_[corners[to]].name, shown_of_name));
}

std::vector<Problem> FaceCuts::remarks(const Source& source) const {
    std::vector<Problem> remarks;
    if (bent_.count > 0)
        remarks.push_back(problem_at(
            source, bent_.place,
            fmt::format("remark: expected faces whose corners lie in one plane, found {} of {} "
                        "whose corners do not, by up to {:.3g}; the first is {}",
                        bent_.count, faces(faces_), farthest_off_,
                        shortened(bent_.name, shown_of_name)),
            "it is cut as it is seen along x, y or z, whichever its normal is nearest to"));
    if (crossed_.count > 0)
        remarks.push_back(problem_at(
            source, crossed_.place,
            fmt::format("remark: expected faces whose edges do not cross, found {} whose "
                        "edges do; in {} the edge {} meets the one {}",
                        faces(crossed_.count), shortened(crossed_.name, shown_of_name),
                        where_crossed_.first, where_crossed_.second),
            fan_hint));
    if (without_area_.count > 0)
        remarks.push_back(problem_at(
            source, without_area_.place,
            fmt::format("remark: expected faces with an area, found {} without; the first is {}",
                        faces(without_area_.count), shortened(without_area_.name, shown_of_name)),
            fan_hint));
    return remarks;
}

} // namespace rastertrace
