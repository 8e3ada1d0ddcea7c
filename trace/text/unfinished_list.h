// SPDX-License-Identifier: MIT
#pragma once

// The files and folders that exist under a temporary name, in a list that a signal handler may go through.

#include <csignal>
#include <string>

namespace rastertrace {

/// Puts a file on the list. Its folder stays open until it is taken off again; its name has at most
/// 63 bytes. To be called before the file is made, since memory for the list may be missing.
void note_unfinished(int folder, const std::string& name);

/// Takes a file off the list: it has its final name, or is not there.
void forget_unfinished(int folder, const std::string& name) noexcept;

/// Removes what is on the list and takes it off; "": nothing.
void remove_unfinished(int folder, const std::string& name);

/// Holds all signals of this thread back while it lives, so that what happens to a file and what the
/// list says of it change together.
class SignalsHeldBack {
public:
    SignalsHeldBack() noexcept;
    SignalsHeldBack(const SignalsHeldBack&) = delete;
    SignalsHeldBack& operator=(const SignalsHeldBack&) = delete;
    ~SignalsHeldBack();

private:
    sigset_t before_;
};

} // namespace rastertrace
