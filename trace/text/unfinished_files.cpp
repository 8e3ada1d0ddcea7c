// SPDX-License-Identifier: MIT
#include "unfinished_files.h"

#include "unfinished_list.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cstring>

namespace rastertrace {

namespace {

/// A place for a file. Places are never freed, only used again, so that a handler can follow the
/// list at any moment.
struct ListPlace {
    enum class State { free, being_changed, taken };

    std::atomic<State> state = State::being_changed;
    int folder = -1;
    char name[64] = {};
    ListPlace* next = nullptr;
};

static_assert(std::atomic<ListPlace::State>::is_always_lock_free &&
                  std::atomic<ListPlace*>::is_always_lock_free,
              "a signal handler may use them");

std::atomic<ListPlace*> first_place = nullptr;

/// A place that is the caller's alone: a free one, or a new one.
ListPlace& take_place() {
    for (ListPlace* place = first_place; place != nullptr; place = place->next) {
        auto expected = ListPlace::State::free;
        if (place->state.compare_exchange_strong(expected, ListPlace::State::being_changed))
            return *place;
    }
    ListPlace* const place = new ListPlace;
    place->next = first_place;
    while (!first_place.compare_exchange_weak(place->next, place)) {
    }
    return *place;
}

/// Removes a file, or a folder with all that is in it, whatever its mode. The library's own functions take memory.
void remove_tree(int folder, const char* name) noexcept {
    if (::unlinkat(folder, name, 0) == 0)
        return;
    ::fchmodat(folder, name, 0700, 0);
    const int inner = ::openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    alignas(dirent64) char entries[2048];
    auto* const first = reinterpret_cast<dirent64*>(entries);
    for (long size = 0; (size = ::getdents64(inner, first, sizeof entries)) > 0;)
        for (long at = 0; at < size;) {
            const auto* const entry = reinterpret_cast<const dirent64*>(entries + at);
            at += entry->d_reclen;
            if (std::strcmp(entry->d_name, ".") != 0 && std::strcmp(entry->d_name, "..") != 0)
                remove_tree(inner, entry->d_name);
        }
    ::close(inner);
    ::unlinkat(folder, name, AT_REMOVEDIR);
}

} // namespace

void note_unfinished(int folder, const std::string& name) {
    ListPlace& place = take_place();
    place.folder = folder;
    place.name[name.copy(place.name, sizeof place.name - 1)] = '\0';
    place.state = ListPlace::State::taken;
}

void forget_unfinished(int folder, const std::string& name) noexcept {
    for (ListPlace* place = first_place; place != nullptr; place = place->next)
        if (place->state == ListPlace::State::taken && place->folder == folder &&
            place->name == name)
            place->state = ListPlace::State::free;
}

void remove_unfinished_files() noexcept {
    for (ListPlace* place = first_place; place != nullptr; place = place->next)
        if (place->state == ListPlace::State::taken)
            remove_tree(place->folder, place->name);
}

void remove_unfinished(int folder, const std::string& name) {
    if (name.empty())
        return;
    const SignalsHeldBack held;
    remove_tree(folder, name.c_str());
    forget_unfinished(folder, name);
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
