// SPDX-License-Identifier: MIT
#include "player/playback.h"

#include <rastertrace/trace/tell/describe.h>

#include <utility>

namespace rastertrace {

namespace {

/// Sentences are kept of at most so many steps.
constexpr std::size_t most_sentences = 2000;

} // namespace

Playback::Playback(Trace trace, FaceGroups lettered)
    : trace_(std::move(trace)), parts_(parts_for(View::writes, trace_)), replay_(trace_, parts_),
      around_(replay_), lettered_(std::move(lettered)) {}

const FaceGroups& Playback::faces() const {
    if (!faces_) {
        Replay at_end(trace_);
        at_end.go_to(trace_.size());
        faces_ = lettered_faces(at_end, lettered_);
    }
    return *faces_;
}

const std::string& Playback::sentence_of(std::size_t n) const {
    if (sentences_.size() > most_sentences)
        sentences_.clear();
    const auto [place, is_new] = sentences_.try_emplace(n);
    if (is_new) {
        around_.go_to(n);
        place->second = describe_step(around_);
    }
    return place->second;
}

} // namespace rastertrace
