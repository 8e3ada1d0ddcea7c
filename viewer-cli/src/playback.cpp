// SPDX-License-Identifier: MIT
#include "playback.h"

#include <rastertrace/trace/tell/describe.h>

#include <algorithm>
#include <utility>

namespace rastertrace {

namespace {

/// Sentences of so many steps before the current one are worked out on the way.
constexpr std::size_t steps_before = 64;

/// Two replays, and that of the pictures.
constexpr std::size_t frames_at_hand = 3;

/// Sentences are kept of at most so many steps.
constexpr std::size_t most_sentences = 2000;

} // namespace

Playback::Playback(Trace trace, std::size_t bytes, FaceGroups lettered)
    : trace_(std::move(trace)), parts_(parts_for(View::writes, trace_)), replay_(trace_, parts_),
      around_(trace_, parts_),
      snapshots_(trace_, parts_,
                 bytes - std::min(bytes / 2, frames_at_hand * replay_.frame().bytes())),
      lettered_(std::move(lettered)) {}

void Playback::go_to(std::size_t n) {
    if (replay_.step() <= n && n - replay_.step() <= steps_before)
        return replay_.go_to(n);
    const std::size_t first = n - std::min(n, steps_before);
    snapshots_.go_to(around_, first);
    for (std::size_t before = first; before < n; ++before)
        sentence_of(before);
    replay_.go_to_place_of(around_);
    replay_.go_to(n);
}

const FaceGroups& Playback::faces() const {
    const Replay& farthest = snapshots_.farthest();
    const bool is_at_end = farthest.step() == trace().size();
    const bool has_doubled = farthest.step() >= 2 * steps_of_faces_;
    if (steps_of_faces_ != farthest.step() && (is_at_end || has_doubled)) {
        faces_ = lettered_faces(farthest, lettered_);
        steps_of_faces_ = farthest.step();
    }
    return faces_;
}

const std::string& Playback::sentence_of(std::size_t n) const {
    if (sentences_.size() > most_sentences)
        sentences_.clear();
    const auto [place, is_new] = sentences_.try_emplace(n);
    if (is_new) {
        snapshots_.go_to(around_, n);
        place->second = describe_step(around_);
    }
    return place->second;
}

} // namespace rastertrace
