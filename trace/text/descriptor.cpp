// SPDX-License-Identifier: MIT
#include "descriptor.h"

#include <poll.h>
#include <unistd.h>

namespace rastertrace {

bool Descriptor::close() {
    const int number = std::exchange(number_, -1);
    return number < 0 || ::close(number) == 0;
}

namespace {

/// A failure, such as an interruption, is left to the next attempt to read or write.
void wait_for(int descriptor, short events) {
    pollfd waiting{.fd = descriptor, .events = events, .revents = 0};
    ::poll(&waiting, 1, -1);
}

} // namespace

void wait_until_readable(int descriptor) {
    wait_for(descriptor, POLLIN);
}

void wait_until_writable(int descriptor) {
    wait_for(descriptor, POLLOUT);
}

} // namespace rastertrace
