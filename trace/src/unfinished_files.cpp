// SPDX-License-Identifier: MIT
#include <rastertrace/trace/unfinished_files.h>

#include "unfinished_list.h"

#include <unistd.h>

#include <atomic>

namespace rastertrace {

namespace {

/// A place for a file. Places are never freed, only used again, so that a handler can follow the
/// list at any moment.
struct Place {
    enum class State { free, being_changed, taken };

    std::atomic<State> state = State::being_changed;
    int folder = -1;
    char name[64] = {};
    Place* next = nullptr;
};

static_assert(std::atomic<Place::State>::is_always_lock_free &&
                  std::atomic<Place*>::is_always_lock_free,
              "a signal handler may use them");

std::atomic<Place*> first_place = nullptr;

/// A place that is the caller's alone: a free one, or a new one.
Place& take_place() {
    for (Place* place = first_place; place != nullptr; place = place->next) {
        auto expected = Place::State::free;
        if (place->state.compare_exchange_strong(expected, Place::State::being_changed))
            return *place;
    }
    Place* const place = new Place;
    place->next = first_place;
    while (!first_place.compare_exchange_weak(place->next, place)) {
    }
    return *place;
}

} // namespace

void note_unfinished(int folder, const std::string& name) {
    Place& place = take_place();
    place.folder = folder;
    place.name[name.copy(place.name, sizeof place.name - 1)] = '\0';
    place.state = Place::State::taken;
}

void forget_unfinished(int folder, const std::string& name) noexcept {
    for (Place* place = first_place; place != nullptr; place = place->next)
        if (place->state == Place::State::taken && place->folder == folder && place->name == name)
            place->state = Place::State::free;
}

void remove_unfinished_files() noexcept {
    for (Place* place = first_place; place != nullptr; place = place->next)
        if (place->state == Place::State::taken)
            ::unlinkat(place->folder, place->name, 0);
}

SignalsHeldBack::SignalsHeldBack() noexcept {
    sigset_t all;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before_);
}

SignalsHeldBack::~SignalsHeldBack() {
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

} // namespace rastertrace
