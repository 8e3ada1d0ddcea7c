// SPDX-License-Identifier: MIT
#include "run_self.h"

#include <rastertrace/trace/descriptor.h>
#include <rastertrace/trace/problem.h>

#include <fmt/core.h>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <string_view>
#include <utility>

extern char** environ;

namespace rastertrace {

namespace {

[[noreturn]] void fail(int error) {
    throw problem_of_system("", "rastertrace could not be run", error);
}

struct Pipe {
    Descriptor reader;
    Descriptor writer;
};

Pipe make_pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        fail(errno);
    return {Descriptor(ends[0]), Descriptor(ends[1])};
}

/// This program's environment, but for what its output depends on.
std::vector<std::string> environment() {
    constexpr std::array<std::string_view, 6> fixed{
        "COLUMNS=", "LINES=", "NO_COLOR=", "TERM=", "COLORTERM=", "RASTERTRACE_LANGUAGE="};
    std::vector<std::string> variables{"COLUMNS=80", "NO_COLOR=1", "TERM=dumb"};
    for (char** variable = environ; *variable != nullptr; ++variable)
        if (std::none_of(fixed.begin(), fixed.end(), [variable](std::string_view name) {
                return std::string_view(*variable).starts_with(name);
            }))
            variables.emplace_back(*variable);
    return variables;
}

/// Pointers to strings, as the system takes them: nullptr at the end.
std::vector<char*> pointers_to(std::vector<std::string>& strings) {
    std::vector<char*> pointers;
    for (std::string& string : strings)
        pointers.push_back(string.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// A run of this program that is ended and waited for, whatever happens.
class Child {
public:
    Child(std::vector<std::string> words, const Pipe& out, const Pipe& err) {
        std::vector<std::string> variables = environment();
        ::posix_spawn_file_actions_t actions;
        ::posix_spawn_file_actions_init(&actions);
        ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        ::posix_spawn_file_actions_adddup2(&actions, out.writer.number(), STDOUT_FILENO);
        ::posix_spawn_file_actions_adddup2(&actions, err.writer.number(), STDERR_FILENO);
        const int error = ::posix_spawn(&process_, "/proc/self/exe", &actions, nullptr,
                                        pointers_to(words).data(), pointers_to(variables).data());
        ::posix_spawn_file_actions_destroy(&actions);
        if (error != 0)
            fail(error);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        if (process_ == 0)
            return;
        ::kill(process_, SIGKILL);
        wait();
    }

    /// The exit status, as a shell tells it.
    int wait() {
        int status = 0;
        while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
        }
        process_ = 0;
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }

private:
    ::pid_t process_ = 0;
};

/// Adds what there is to read; closes the reader at the end of it.
void read_some(Descriptor& reader, std::string& text) {
    std::array<char, 1 << 16> buffer;
    const ssize_t count = ::read(reader.number(), buffer.data(), buffer.size());
    if (count > 0)
        text.append(buffer.data(), static_cast<std::size_t>(count));
    else if (count == 0)
        reader.close();
    else if (errno != EINTR)
        fail(errno);
}

} // namespace

FinishedRun run_self(const std::vector<std::string>& arguments) {
    std::vector<std::string> words{"rastertrace"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    Pipe out = make_pipe();
    Pipe err = make_pipe();
    Child child(std::move(words), out, err);
    // The child has its own; that they are closed is how the end of its output is seen.
    out.writer.close();
    err.writer.close();

    FinishedRun run;
    while (out.reader.is_open() || err.reader.is_open()) {
        // A reader that is closed has a negative number, which poll passes over.
        std::array<pollfd, 2> waiting{
            {{.fd = out.reader.number(), .events = POLLIN, .revents = 0},
             {.fd = err.reader.number(), .events = POLLIN, .revents = 0}}};
        if (::poll(waiting.data(), waiting.size(), -1) < 0 && errno != EINTR)
            fail(errno);
        if (waiting[0].revents != 0)
            read_some(out.reader, run.out);
        if (waiting[1].revents != 0)
            read_some(err.reader, run.err);
        if (run.out.size() + run.err.size() > most_output) {
            run.is_too_large = true;
            return run;
        }
    }
    run.exit_status = child.wait();
    return run;
}

} // namespace rastertrace
