// SPDX-License-Identifier: MIT
#pragma once

// The faces of one mesh on their way to triangles, and what its author is told about them: once a mesh,
// with the first face that is meant.
//
//     FaceCuts cuts(scene.vertices, units, first_vertex);
//     const auto ears = cuts.cut(corners, place, [&] { return name; });
//     cuts.remarks(source);

#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/draw/scene/triangulate.h>
#include <rastertrace/trace/text/problem.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

/// Refers to the vertices, and to the coarsest unit of each: see typed_digits.h.
class FaceCuts {
public:
    FaceCuts(std::span<const SceneVertex> vertices, std::span<const float> units, std::size_t first)
        : vertices_(vertices), units_(units), cutter_(vertices, first) {}

    /// What is known about a face of more than three corners. `place` is what to point at in the scene;
    /// `name` calls the face, if it has to be told of.
    template <typename Name>
    Triangulation cut(std::span<const std::size_t> corners, std::size_t place, Name&& name) {
        Triangulation cut = cutter_.cut(corners);
        ++faces_;
        if (is_bent(cut, corners)) {
            note(bent_, place, name);
            farthest_off_ = std::max(farthest_off_, cut.off_plane);
        }
        if (cut.form == FaceForm::no_area)
            note(without_area_, place, name);
        if (cut.form == FaceForm::crossed && note(crossed_, place, name))
            where_crossed_ = {edge(corners, cut.meeting[0]), edge(corners, cut.meeting[1])};
        return cut;
    }

    /// What can be drawn, but is probably not what was meant.
    std::vector<Problem> remarks(const Source& source) const;

private:
    /// Faces of which there is something to tell, and the first of them.
    struct Noted {
        std::size_t count = 0;
        std::size_t place = 0;
        std::string name = {};
    };

    /// True if it is the first one.
    template <typename Name> static bool note(Noted& noted, std::size_t place, Name&& name) {
        if (noted.count++ != 0)
            return false;
        noted.place = place;
        noted.name = name();
        return true;
    }

    /// True of a face that is farther off its plane than rounding to the digits that were typed
    /// moves it: half a unit in each coordinate of a corner is less than a unit along the normal.
    bool is_bent(const Triangulation& cut, std::span<const std::size_t> corners) const;

    /// "from A to B", for the edge that begins at a corner.
    std::string edge(std::span<const std::size_t> corners, std::size_t from) const;

    std::span<const SceneVertex> vertices_;
    std::span<const float> units_;
    FaceCutter cutter_;
    std::size_t faces_ = 0;
    Noted bent_;
    double farthest_off_ = 0; ///< of those: from the plane
    Noted crossed_;
    std::pair<std::string, std::string> where_crossed_; ///< the first of those
    Noted without_area_;
};

} // namespace rastertrace
