// SPDX-License-Identifier: MIT
#include "player/terminal_session.h"

#include "app/environment.h"
#include "app/load.h"

#include <rastertrace/trace/text/problem.h>

#include <fmt/core.h>

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <string_view>

namespace rastertrace {

namespace {

// Another screen without a cursor, lines that are cut instead of wrapped, clicks of the mouse in decimal coordinates.
constexpr std::string_view take_over = "\x1b[?1049h\x1b[?25l\x1b[?7l\x1b[?1000h\x1b[?1006h\x1b[2J";
constexpr std::string_view give_back = "\x1b[?1006l\x1b[?1000l\x1b[?7h\x1b[?25h\x1b[?1049l";

/// What handlers of signals need; they must not take memory. There is one session.
struct Shared {
    int input = -1;
    termios before{};
    termios during{};
    volatile std::sig_atomic_t is_taken = 0;
    volatile std::sig_atomic_t needs_redraw = 0;
};
Shared shared;

constexpr std::array ending_signals{SIGINT,  SIGTERM, SIGHUP,  SIGQUIT,  SIGXCPU, SIGABRT,
                                    SIGSEGV, SIGBUS,  SIGFPE,  SIGILL,   SIGUSR1, SIGUSR2,
                                    SIGALRM, SIGSYS,  SIGPIPE, SIGVTALRM};
constexpr std::array own_signals{SIGTSTP, SIGCONT, SIGWINCH};
std::array<struct sigaction, ending_signals.size()> ends_before;
std::array<struct sigaction, own_signals.size()> others_before;

/// Handlers have a stack of their own: the usual one may have come to its end.
alignas(16) std::array<char, 1 << 16> handler_stack;

/// Safe to call in a handler. What the terminal does not take cannot be helped.
void write_to_terminal(std::string_view text) {
    while (!text.empty()) {
        const ssize_t count = ::write(STDOUT_FILENO, text.data(), text.size());
        if (count < 0 && errno != EINTR)
            return;
        text.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
    }
}

/// Sets the terminal's modes also where the program is in the background, which would stop it.
void set_modes(const termios& modes) {
    sigset_t stop{};
    sigset_t before{};
    ::sigemptyset(&stop);
    ::sigaddset(&stop, SIGTTOU);
    ::sigprocmask(SIG_BLOCK, &stop, &before);
    ::tcsetattr(shared.input, TCSANOW, &modes);
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
}

void take_terminal() {
    shared.is_taken = 1;
    set_modes(shared.during);
    write_to_terminal(take_over);
}

/// The terminal is given back; then the signal does what it would have done.
extern "C" void end_session_by_signal(int signal) {
    ::tcflush(STDOUT_FILENO, TCOFLUSH); // nobody may be reading
    give_back_terminal();
    if (signal == SIGBUS) {
        go_on_alone();
        // The bytes of a file are looked at in their place, see mapped_file.h.
        constexpr std::string_view text = "rastertrace: what was played cannot be read any more: "
                                          "its file was probably cut short\n";
        [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
        ::_exit(3);
    }
    for (std::size_t i = 0; i < ending_signals.size(); ++i)
        if (ending_signals[i] == signal)
            ::sigaction(signal, &ends_before[i], nullptr);
    ::raise(signal);
}

extern "C" void stop_session(int) {
    const int error = errno;
    give_back_terminal();
    struct sigaction usual {};
    usual.sa_handler = SIG_DFL;
    struct sigaction own {};
    ::sigaction(SIGTSTP, &usual, &own);
    sigset_t stop{};
    ::sigemptyset(&stop);
    ::sigaddset(&stop, SIGTSTP);
    ::raise(SIGTSTP);
    ::sigprocmask(SIG_UNBLOCK, &stop, nullptr); // stops here, until somebody goes on
    ::sigaction(SIGTSTP, &own, nullptr);
    errno = error;
}

/// Goes on after any stop; in the background the terminal is somebody else's.
extern "C" void continue_session(int) {
    const int error = errno;
    if (::tcgetpgrp(shared.input) == ::getpgrp())
        take_terminal();
    shared.needs_redraw = 1;
    errno = error;
}

extern "C" void note_size(int) {
    shared.needs_redraw = 1;
}

/// Both are only let through where the session waits, so that nothing is lost between looking and waiting.
sigset_t waited_for() {
    sigset_t signals{};
    ::sigemptyset(&signals);
    ::sigaddset(&signals, SIGWINCH);
    ::sigaddset(&signals, SIGTSTP);
    return signals;
}

/// What is ignored from the start, as by nohup, stays so.
void handle(int signal, void (*handler)(int), struct sigaction& before) {
    ::sigaction(signal, nullptr, &before);
    if (before.sa_handler == SIG_IGN)
        return;
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_ONSTACK;
    ::sigaction(signal, &action, nullptr);
}

} // namespace

void go_on_alone() noexcept {
    static std::atomic_flag is_ending;
    if (is_ending.test_and_set())
        while (true)
            ::pause();
}

void give_back_terminal() noexcept {
    if (shared.is_taken == 0)
        return;
    shared.is_taken = 0;
    write_to_terminal(give_back);
    set_modes(shared.before);
}

bool TerminalSession::is_possible() {
    const std::string_view kind = environment_variable("TERM");
    if (::isatty(STDOUT_FILENO) == 0 || kind.empty() || kind == "dumb")
        return false;
    return ::isatty(STDIN_FILENO) != 0 ||
           Descriptor(::open("/dev/tty", O_RDONLY | O_CLOEXEC)).is_open();
}

TerminalSession::TerminalSession()
    : own_input_(::isatty(STDIN_FILENO) != 0 ? -1 : ::open("/dev/tty", O_RDONLY | O_CLOEXEC)),
      input_(own_input_.is_open() ? own_input_.number() : STDIN_FILENO) {
    if (::tcgetattr(input_, &shared.before) != 0)
        throw problem_of("", "expected a terminal, found none");
    shared.input = input_;
    shared.during = shared.before;
    shared.during.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | IEXTEN);
    shared.during.c_iflag &= ~static_cast<tcflag_t>(IXON | ICRNL);
    shared.during.c_cc[VMIN] = 1;
    shared.during.c_cc[VTIME] = 0;
    stack_t stack{};
    stack.ss_sp = handler_stack.data();
    stack.ss_size = handler_stack.size();
    ::sigaltstack(&stack, nullptr);
    for (std::size_t i = 0; i < ending_signals.size(); ++i)
        handle(ending_signals[i], end_session_by_signal, ends_before[i]);
    const sigset_t signals = waited_for();
    ::sigprocmask(SIG_BLOCK, &signals, nullptr);
    handle(SIGTSTP, stop_session, others_before[0]);
    handle(SIGCONT, continue_session, others_before[1]);
    handle(SIGWINCH, note_size, others_before[2]);
    take_terminal();
}

TerminalSession::~TerminalSession() {
    give_back_terminal();
    for (std::size_t i = 0; i < own_signals.size(); ++i)
        ::sigaction(own_signals[i], &others_before[i], nullptr);
    const sigset_t signals = waited_for();
    ::sigprocmask(SIG_UNBLOCK, &signals, nullptr);
    for (std::size_t i = 0; i < ending_signals.size(); ++i)
        ::sigaction(ending_signals[i], &ends_before[i], nullptr);
}

TextSize TerminalSession::size() const {
    const TextSize size = output_size();
    constexpr TextSize unknown;
    return size.columns == unknown.columns || size.lines == unknown.lines ? TextSize{80, 24} : size;
}

void TerminalSession::wait(int milliseconds) {
    if (shared.needs_redraw != 0)
        return;
    pollfd source{input_, POLLIN, 0};
    const timespec limit{milliseconds / 1000, milliseconds % 1000 * 1'000'000L};
    sigset_t signals{};
    ::sigprocmask(SIG_BLOCK, nullptr, &signals);
    ::sigdelset(&signals, SIGWINCH);
    ::sigdelset(&signals, SIGTSTP);
    if (::ppoll(&source, 1, milliseconds < 0 ? nullptr : &limit, &signals) > 0)
        read_keys();
}

void TerminalSession::read_keys() {
    std::array<char, 4096> bytes;
    const ssize_t count = ::read(input_, bytes.data(), bytes.size());
    if (count > 0)
        keys_.take({bytes.data(), static_cast<std::size_t>(count)});
    else if (count == 0 || (errno != EINTR && errno != EAGAIN))
        is_open_ = false;
}

std::optional<KeyPress> TerminalSession::key() {
    if (auto key = keys_.next())
        return key;
    if (!keys_.has_part())
        return std::nullopt;
    constexpr int moment = 50; // the bytes of one key come together
    pollfd source{input_, POLLIN, 0};
    if (::poll(&source, 1, moment) > 0) {
        read_keys();
        return keys_.next();
    }
    return keys_.next_of_rest();
}

bool TerminalSession::needs_redraw() {
    if (shared.needs_redraw == 0)
        return false;
    shared.needs_redraw = 0;
    shown_.clear();
    return true;
}

void TerminalSession::show(const std::vector<std::string>& lines) {
    std::string text;
    if (shown_.empty())
        text = "\x1b[2J";
    shown_.resize(std::max(shown_.size(), lines.size()));
    for (std::size_t i = 0; i < shown_.size(); ++i) {
        const std::string line = i < lines.size() ? lines[i] : std::string();
        if (line != shown_[i])
            text += fmt::format("\x1b[{};1H\x1b[K{}", i + 1, line);
        shown_[i] = line;
    }
    write_to_terminal(text);
}

} // namespace rastertrace
