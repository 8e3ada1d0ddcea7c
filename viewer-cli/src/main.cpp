// SPDX-License-Identifier: MIT
#include "command_line.h"

#include <csignal>

int main(int count, char** arguments) {
    // A reader that has seen enough, as in `| head`, ends us quietly.
    std::signal(SIGPIPE, SIG_DFL);
    return rastertrace::run_command_line(count, arguments);
}
