// SPDX-License-Identifier: MIT
#pragma once

// A trace that is gone through in both directions.
//
//     Playback playback(std::move(trace));
//     playback.go_to(31);
//     playback.sentence_of(30);

#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/tell/view.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace rastertrace {

class Playback {
public:
    /// Faces that have `lettered` keep their letters.
    explicit Playback(Trace trace, FaceGroups lettered = {});
    Playback(const Playback&) = delete;
    Playback& operator=(const Playback&) = delete;

    const Trace& trace() const { return trace_; }

    /// True if depth tests are remembered: there is a depth buffer.
    bool has_depths() const { return parts_.depths; }

    void go_to(std::size_t n) { replay_.go_to(n); }

    /// The picture after the current step.
    const Replay& replay() const { return replay_; }
    std::size_t step() const { return replay_.step(); }

    /// What a step near the current one says, see describe_step; valid until another step is asked for. Far from it this
    /// takes as long as going there.
    const std::string& sentence_of(std::size_t n) const;

    /// The faces that have letters.
    const FaceGroups& faces() const;

private:
    Trace trace_;
    FrameParts parts_;
    Replay replay_;
    mutable Replay around_;                                ///< that tells of the steps around
    mutable std::map<std::size_t, std::string> sentences_; ///< of some steps, by number

    FaceGroups lettered_;
    mutable std::optional<FaceGroups> faces_; ///< once someone has asked
};

} // namespace rastertrace
