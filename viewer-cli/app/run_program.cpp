// SPDX-License-Identifier: MIT
#include "app/run_program.h"

#include "app/environment.h"

#include <rastertrace/trace/text/descriptor.h>
#include <rastertrace/trace/text/problem.h>
#include <rastertrace/trace/text/process_files.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/unfinished_list.h>

#include <fmt/core.h>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

extern char** environ;

namespace rastertrace {

namespace {

[[noreturn]] void fail(int error) {
    throw problem_of_system("", "a program could not be run", error);
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

/// Pointers to strings, as the system takes them: nullptr at the end.
std::vector<char*> pointers_to(std::vector<std::string>& strings) {
    std::vector<char*> pointers;
    for (std::string& string : strings)
        pointers.push_back(string.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// A run that is ended and waited for, whatever happens.
class Child {
public:
    Child(ProgramRun& program, const Pipe& out, const Pipe& err)
        : leads_group_(program.has_own_group) {
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
        const int own_group = leads_group_ ? POSIX_SPAWN_SETPGROUP : 0;
        ::posix_spawnattr_setflags(
            &attributes,
            static_cast<short>(POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | own_group));
        const int error = ::posix_spawnp(&process_, program.path.c_str(), &actions, &attributes,
                                         pointers_to(program.words).data(),
                                         pointers_to(program.environment).data());
        ::posix_spawnattr_destroy(&attributes);
        ::posix_spawn_file_actions_destroy(&actions);
        if (error != 0)
            throw problem_of_system(program.words.front(), "the program could not be run", error);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        if (process_ == 0)
            return;
        // So that it leaves nothing behind; if that takes long, at once.
        signal(SIGTERM);
        signal(SIGCONT);
        constexpr std::chrono::milliseconds moment{10};
        constexpr int moments = 200;
        for (int i = 0; i < moments && !has_ended(); ++i)
            std::this_thread::sleep_for(moment);
        signal(SIGKILL);
        wait();
    }

    bool has_ended() const {
        siginfo_t ended{};
        ::waitid(P_PID, static_cast<::id_t>(process_), &ended, WEXITED | WNOHANG | WNOWAIT);
        return ended.si_pid != 0;
    }

    /// Can be read once it has ended; closed where the system has no such thing.
    Descriptor ending() const {
        return Descriptor(static_cast<int>(::syscall(SYS_pidfd_open, process_, 0)));
    }

    /// The exit status, as a shell tells it.
    int wait() {
        siginfo_t ended{};
        while (::waitid(P_PID, static_cast<::id_t>(process_), &ended, WEXITED | WNOWAIT) < 0 &&
               errno == EINTR) {
        }
        // Its number is its own until then: so is that of its group, in which others may live on.
        if (leads_group_)
            signal(SIGKILL);
        int status = 0;
        ::waitpid(process_, &status, 0);
        process_ = 0;
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }

private:
    void signal(int number) const { ::kill(leads_group_ ? -process_ : process_, number); }

    ::pid_t process_ = 0;
    bool leads_group_;
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

/// Tells a run where to write its files, and that it is one.
constexpr const char* folder_variable = "RASTERTRACE_FILES_TO";
constexpr const char* pages_variable = "RASTERTRACE_PAGES"; // one a line

/// This program's environment, but for what its output depends on.
std::vector<std::string> environment(const std::string& folder,
                                     const std::vector<std::string>& pages) {
    const std::vector<std::string> fixed{"COLUMNS=",
                                         "LINES=",
                                         "NO_COLOR=",
                                         "TERM=",
                                         "COLORTERM=",
                                         "RASTERTRACE_LANGUAGE=",
                                         fmt::format("{}=", folder_variable),
                                         fmt::format("{}=", pages_variable)};
    std::vector<std::string> variables{"COLUMNS=80", "NO_COLOR=1", "TERM=dumb",
                                       fmt::format("{}={}", folder_variable, folder),
                                       fmt::format("{}={}", pages_variable, joined(pages, "\n"))};
    for (std::string& variable : own_environment())
        if (std::none_of(fixed.begin(), fixed.end(), [&variable](const std::string& name) {
                return variable.starts_with(name);
            }))
            variables.push_back(std::move(variable));
    return variables;
}

} // namespace

EndingHeldBack::EndingHeldBack() {
    sigset_t signals;
    ::sigemptyset(&signals);
    for (const int signal : asked_endings) {
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

std::vector<std::string> own_environment() {
    std::vector<std::string> variables;
    for (char** variable = environ; *variable != nullptr; ++variable)
        variables.emplace_back(*variable);
    return variables;
}

FinishedRun run_program(ProgramRun program) {
    const auto end = std::chrono::steady_clock::now() + program.time;
    const EndingHeldBack ending;
    Pipe out = make_pipe();
    Pipe err = make_pipe();
    Child child(program, out, err);
    // The child has its own; that they are closed is how the end of its output is seen.
    out.writer.close();
    err.writer.close();

    FinishedRun run;
    Descriptor ended = child.ending();
    const bool tells_its_end = ended.is_open();
    while (out.reader.is_open() || err.reader.is_open() || !child.has_ended()) {
        // What is closed has a negative number, which poll passes over.
        std::array<pollfd, 4> waiting{{{.fd = out.reader.number(), .events = POLLIN, .revents = 0},
                                       {.fd = err.reader.number(), .events = POLLIN, .revents = 0},
                                       {.fd = ending.descriptor(), .events = POLLIN, .revents = 0},
                                       {.fd = ended.number(), .events = POLLIN, .revents = 0}}};
        const auto left =
            std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
        if (left.count() <= 0) {
            run.is_too_long = true;
            return run;
        }
        constexpr std::int64_t moment = 10; // to ask again
        const int time =
            static_cast<int>(tells_its_end ? left.count() : std::min(left.count(), moment));
        if (::poll(waiting.data(), waiting.size(), time) < 0 && errno != EINTR)
            fail(errno);
        // A key that ends this program ends the run as well, which is no mistake of its own.
        if (waiting[2].revents != 0)
            throw problem_of_system("", "what runs was ended by a signal", EINTR);
        if (waiting[3].revents != 0)
            ended.close();
        if (waiting[0].revents != 0)
            read_some(out.reader, run.out);
        if (waiting[1].revents != 0)
            read_some(err.reader, run.err);
        if (run.out.size() + run.err.size() > program.most_output) {
            run.is_too_large = true;
            return run;
        }
    }
    run.exit_status = child.wait();
    return run;
}

FinishedRun run_self(const std::vector<std::string>& arguments, const std::string& folder,
                     const std::vector<std::string>& pages) {
    ProgramRun program{.path = "/proc/self/exe",
                       .words = {"rastertrace"},
                       .environment = environment(folder, pages),
                       .most_output = most_output,
                       .time = time_of_run};
    program.words.insert(program.words.end(), arguments.begin(), arguments.end());
    return run_program(std::move(program));
}

void take_folder_of_run() {
    if (std::getenv(folder_variable) == nullptr)
        return;
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    run_for_page(std::string(environment_variable(folder_variable)),
                 split_at(environment_variable(pages_variable), '\n'));
}

TemporaryFolder::TemporaryFolder(const std::string& name) {
    std::error_code error;
    const std::filesystem::path temporary = std::filesystem::temp_directory_path(error);
    std::string pattern = (temporary / (name + "-XXXXXX")).string();
    if (error)
        throw problem_of_system("TMPDIR", "no folder for temporary files", error.value());
    parent_ = Descriptor(::open(temporary.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    if (!parent_.is_open() || ::mkdtemp(pattern.data()) == nullptr)
        throw problem_of_system(pattern, "the folder could not be made", errno);
    path_ = pattern;
    note_unfinished(parent_.number(), path_.filename().string());
}

TemporaryFolder::~TemporaryFolder() {
    remove_unfinished(parent_.number(), path_.filename().string());
}

} // namespace rastertrace
