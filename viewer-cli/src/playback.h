// SPDX-License-Identifier: MIT
#pragma once

// A trace that is gone through in both directions while it is still being read.
//
//     Playback playback(std::move(growing), bytes);
//     while (playback.read_on()) {}
//     playback.go_to(31);
//     describe_step(playback.replay());

#include <rastertrace/figures/view.h>
#include <rastertrace/trace/frame.h>
#include <rastertrace/trace/growing_trace.h>
#include <rastertrace/trace/snapshots.h>

#include <cstddef>
#include <utility>

namespace rastertrace {

class Playback {
public:
    /// `bytes`: what pictures may take that are kept for going back.
    Playback(GrowingTrace trace, std::size_t bytes)
        : growing_(std::move(trace)), parts_(parts_for(View::writes, growing_.trace())),
          snapshots_(growing_.trace(), parts_, bytes), replay_(growing_.trace(), parts_) {}
    Playback(const Playback&) = delete;
    Playback& operator=(const Playback&) = delete;

    const Trace& trace() const { return growing_.trace(); }
    const GrowingTrace& growing() const { return growing_; }
    const Snapshots& snapshots() const { return snapshots_; }

    /// What its replays remember.
    FrameParts parts() const { return parts_; }

    /// True if depth tests are remembered: there is a depth buffer.
    bool has_depths() const { return parts_.depths; }

    /// Reads a piece of the trace more, or goes through it once, for the pictures; false if there is nothing to do now.
    bool read_on() {
        const bool has_read = growing_.read_on();
        return snapshots_.read_on(steps_at_once) || has_read;
    }

    /// Goes to a step, up to the last one that has been read.
    void go_to(std::size_t n) { snapshots_.go_to(replay_, n); }

    /// The picture after the current step.
    const Replay& replay() const { return replay_; }
    std::size_t step() const { return replay_.step(); }

private:
    static constexpr std::size_t steps_at_once = 40'000;

    GrowingTrace growing_;
    FrameParts parts_;
    Snapshots snapshots_;
    Replay replay_;
};

} // namespace rastertrace
