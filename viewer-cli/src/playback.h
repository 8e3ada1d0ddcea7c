// SPDX-License-Identifier: MIT
#pragma once

// A trace that is gone through in both directions.
//
//     Playback playback(std::move(trace), bytes);
//     while (playback.read_on()) {}
//     playback.go_to(31);
//     playback.sentence_of(30);

#include <rastertrace/figures/view.h>
#include <rastertrace/trace/record/frame.h>
#include <rastertrace/trace/record/snapshots.h>

#include <cstddef>
#include <map>
#include <string>

namespace rastertrace {

class Playback {
public:
    /// `bytes`: what pictures may take, those that are shown and those that are kept for going back. Faces that have
    /// `lettered` keep their letters.
    Playback(Trace trace, std::size_t bytes, FaceGroups lettered = {});
    Playback(const Playback&) = delete;
    Playback& operator=(const Playback&) = delete;

    const Trace& trace() const { return trace_; }
    const Snapshots& snapshots() const { return snapshots_; }

    /// True if depth tests are remembered: there is a depth buffer.
    bool has_depths() const { return parts_.depths; }

    /// Goes through a piece of the trace more, for the pictures; false if there is nothing to do any more.
    bool read_on() { return snapshots_.read_on(steps_at_once); }

    void go_to(std::size_t n);

    /// The picture after the current step.
    const Replay& replay() const { return replay_; }
    std::size_t step() const { return replay_.step(); }

    /// What a step near the current one says, see describe_step; valid until another step is asked for. Far from it this
    /// takes as long as going there.
    const std::string& sentence_of(std::size_t n) const;

    /// The faces that have letters. As long as the trace is gone through, they may change.
    const FaceGroups& faces() const;

private:
    /// Some milliseconds.
    static constexpr std::size_t steps_at_once = 40'000;

    Trace trace_;
    FrameParts parts_;
    Replay replay_;

    // A second replay tells of the steps around. Coming to a step it goes first, and the other one takes its picture
    // over, so that the steps between two kept pictures are gone through once.
    mutable Replay around_;

    Snapshots snapshots_;
    mutable std::map<std::size_t, std::string> sentences_; ///< of some steps, by number

    FaceGroups lettered_;
    mutable FaceGroups faces_;
    mutable std::size_t steps_of_faces_ = 0; ///< they were found in so many
};

} // namespace rastertrace
