// SPDX-License-Identifier: MIT
#pragma once

// The faces that can be seen in a frame; where there are too many to be told apart, those of a mesh or of a color
// together.
//
//     const FaceGroups groups = face_groups(trace, visible_primitives(replay), replay.order(), 35);
//     groups.names[groups.group_of.at(primitive)];  // "ABC"

#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

namespace rastertrace {

struct FaceGroups {
    std::string heading; ///< "meshes: " or "colors: " if that is what they are, else ""
    std::vector<std::string>
        names;             ///< in the scene's order; more than asked for if no grouping has fewer
    std::size_t faces = 0; ///< how many they are
    /// The group, from 0, of each of these faces, by the step of its primitive.
    std::unordered_map<std::size_t, std::size_t> group_of;
    std::string (*name_of)(const PrimitiveStep& primitive) =
        nullptr; ///< the name of a primitive's group
};

/// Primitives, by their steps, in at most `most` groups if there is a way. `order` is the step that tells how the
/// painter has sorted them; 0 if there is none.
FaceGroups face_groups(const Trace& trace, std::vector<std::size_t> primitives, std::size_t order,
                       std::size_t most);

/// Those of all primitives of a trace that are painted.
FaceGroups painted_face_groups(const Trace& trace, std::size_t most);

/// The groups for all frames of a trace, where each keeps its place: those of the faces that can be seen at the end, and
/// behind them those of others that plot a pixel. What finds no place among `most` is in no group. `before` are those
/// of another trace of the same scene, which keep their places if the groups are of the same kind.
FaceGroups face_groups_of_all_frames(const Replay& at_end, std::size_t most,
                                     const FaceGroups& before);

/// The primitives of which pixels can be seen in the frame that a replay has reached, by their steps.
std::vector<std::size_t> visible_primitives(const Replay& replay);

} // namespace rastertrace
