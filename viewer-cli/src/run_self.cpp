// SPDX-License-Identifier: MIT
#include "run_self.h"

#include "environment.h"

#include <rastertrace/trace/text/descriptor.h>
#include <rastertrace/trace/text/problem.h>

#include <fmt/core.h>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <thread>
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

/// Tell a run its FileRules, and that it is one.
constexpr const char* files_below = "RASTERTRACE_FILES_BELOW";
constexpr const char* files_to = "RASTERTRACE_FILES_TO";

/// This program's environment, but for what its output depends on; and rules for files.
std::vector<std::string> environment(const FileRules& rules) {
    const std::vector<std::string> fixed{"COLUMNS=",
                                         "LINES=",
                                         "NO_COLOR=",
                                         "TERM=",
                                         "COLORTERM=",
                                         "RASTERTRACE_LANGUAGE=",
                                         fmt::format("{}=", files_below),
                                         fmt::format("{}=", files_to)};
    std::vector<std::string> variables{"COLUMNS=80", "NO_COLOR=1", "TERM=dumb",
                                       fmt::format("{}={}", files_below, rules.below),
                                       fmt::format("{}={}", files_to, rules.outputs)};
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
    Child(std::vector<std::string> words, const FileRules& rules, const Pipe& out,
          const Pipe& err) {
        std::vector<std::string> variables = environment(rules);
        ::posix_spawn_file_actions_t actions;
        ::posix_spawn_file_actions_init(&actions);
        ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        ::posix_spawn_file_actions_adddup2(&actions, out.writer.number(), STDOUT_FILENO);
        ::posix_spawn_file_actions_adddup2(&actions, err.writer.number(), STDERR_FILENO);
        // No signal is held back there, and SIGTERM ends it, whoever has started this program.
        ::posix_spawnattr_t attributes;
        ::posix_spawnattr_init(&attributes);
        sigset_t signals;
        ::sigemptyset(&signals);
        ::posix_spawnattr_setsigmask(&attributes, &signals);
        ::sigaddset(&signals, SIGTERM);
        ::posix_spawnattr_setsigdefault(&attributes, &signals);
        ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
        const int error = ::posix_spawn(&process_, "/proc/self/exe", &actions, &attributes,
                                        pointers_to(words).data(), pointers_to(variables).data());
        ::posix_spawnattr_destroy(&attributes);
        ::posix_spawn_file_actions_destroy(&actions);
        if (error != 0)
            fail(error);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        if (process_ == 0)
            return;
        // So that it leaves nothing behind; if that takes long, at once.
        ::kill(process_, SIGTERM);
        ::kill(process_, SIGCONT);
        constexpr std::chrono::milliseconds moment{10};
        constexpr int moments = 200;
        for (int i = 0; i < moments; ++i) {
            if (::waitpid(process_, nullptr, WNOHANG) == process_)
                return;
            std::this_thread::sleep_for(moment);
        }
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

constexpr std::array ending_signals{SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU};

} // namespace

EndingHeldBack::EndingHeldBack() {
    sigset_t signals;
    ::sigemptyset(&signals);
    for (const int signal : ending_signals) {
        struct sigaction action {};
        // What is ignored, as by nohup, ends nothing.
        if (::sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN)
            ::sigaddset(&signals, signal);
    }
    waiting_ = Descriptor(::signalfd(-1, &signals, SFD_CLOEXEC));
    if (!waiting_.is_open())
        fail(errno);
    ::pthread_sigmask(SIG_BLOCK, &signals, &before_);
}

EndingHeldBack::~EndingHeldBack() {
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

FinishedRun run_self(const std::vector<std::string>& arguments, const RunLimits& limits) {
    const auto end = std::chrono::steady_clock::now() + limits.time;
    const EndingHeldBack ending;
    std::vector<std::string> words{"rastertrace"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    Pipe out = make_pipe();
    Pipe err = make_pipe();
    Child child(std::move(words), limits.files, out, err);
    // The child has its own; that they are closed is how the end of its output is seen.
    out.writer.close();
    err.writer.close();

    FinishedRun run;
    while (out.reader.is_open() || err.reader.is_open()) {
        // A reader that is closed has a negative number, which poll passes over.
        std::array<pollfd, 3> waiting{
            {{.fd = out.reader.number(), .events = POLLIN, .revents = 0},
             {.fd = err.reader.number(), .events = POLLIN, .revents = 0},
             {.fd = ending.descriptor(), .events = POLLIN, .revents = 0}}};
        const auto left =
            std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
        const int time = static_cast<int>(std::max<std::int64_t>(left.count(), 0));
        const int ready = ::poll(waiting.data(), waiting.size(), time);
        if (ready < 0 && errno != EINTR)
            fail(errno);
        if (ready == 0) {
            run.is_too_long = true;
            return run;
        }
        // A key that ends this program ends the run as well, which is no mistake of its own.
        if (waiting[2].revents != 0)
            throw problem_of("", "expected time to end what runs, found a signal");
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

void take_limits_of_run() {
    if (std::getenv(files_below) == nullptr)
        return;
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    set_file_rules({.below = std::string(environment_variable(files_below)),
                    .outputs = std::string(environment_variable(files_to))});
}

} // namespace rastertrace
