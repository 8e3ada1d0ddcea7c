// SPDX-License-Identifier: MIT
// What belongs to the process: its signals, its standard descriptors, and what happens when there is
// no memory left.

#include "app/command_line.h"
#include "app/exit_status.h"
#include "app/load.h"
#include "app/progress.h"
#include "app/run_program.h"
#include "player/terminal_session.h"

#include <rastertrace/trace/text/unfinished_files.h>

#include <gmp.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <new>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

/// Ends the program at once. Unwinding is no way out: GMP calls its allocation functions from C and
/// assembly, which no exception can pass, and messages need memory themselves.
[[noreturn]] void end_without_memory() {
    rastertrace::remove_unfinished_files();
    rastertrace::give_back_terminal();
    rastertrace::print_error("rastertrace: out of memory\n");
    ::_exit(rastertrace::exit_system);
}

void* allocate(std::size_t size) {
    void* const memory = std::malloc(size);
    if (memory == nullptr)
        end_without_memory();
    return memory;
}

void* reallocate(void* old, std::size_t, std::size_t size) {
    void* const memory = std::realloc(old, size);
    if (memory == nullptr)
        end_without_memory();
    return memory;
}

void release(void* memory, std::size_t) {
    std::free(memory);
}

/// Runs before all constructors of static objects, which allocate too.
[[gnu::constructor(101)]] void prepare_for_lack_of_memory() {
    std::set_new_handler(end_without_memory);
    ::mp_set_memory_functions(allocate, reallocate, release);
}

/// Leaves memory that one stage has freed to the next. glibc would give back blocks of more than 128 kB at once, and the
/// system takes a microsecond for each page of new ones. Blocks of more than 32 MB still go back.
void keep_freed_memory() {
#ifdef __GLIBC__
    ::mallopt(M_MMAP_THRESHOLD, 32 << 20);
    ::mallopt(M_TRIM_THRESHOLD, 64 << 20);
#endif
}

/// The signal does what it would have done, once nothing is left behind.
extern "C" void end_by_signal(int signal) {
    rastertrace::remove_unfinished_files();
    if (signal != SIGPIPE)
        rastertrace::tell_interrupted_work();
    ::raise(signal);
}

/// Somebody has cut a trace short whose file is looked at where it is (mapped_file.h).
extern "C" void end_without_file(int /*signal*/) {
    rastertrace::go_on_alone();
    rastertrace::remove_unfinished_files();
    rastertrace::give_back_terminal();
    rastertrace::print_error("rastertrace: a trace was cut short while it was read\n");
    ::_exit(rastertrace::exit_system);
}

void prepare_for_signals() {
    // A reader that has seen enough, as in `| head`, ends us quietly.
    std::signal(SIGPIPE, SIG_DFL);
    // A file that may grow no more is a failed write, with a message.
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGBUS, end_without_file);

    struct sigaction action {};
    action.sa_handler = end_by_signal;
    // So that the signal raised again has its usual effect.
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    const auto handle = [&action](int signal) {
        struct sigaction before {};
        // What is ignored from the start, as by nohup, stays so; and a sanitizer tells faults itself.
        if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_DFL)
            ::sigaction(signal, &action, nullptr);
    };
    for (const int signal : rastertrace::asked_endings)
        handle(signal);
    for (const int fault : {SIGSEGV, SIGILL, SIGFPE, SIGTRAP, SIGSYS})
        handle(fault);
}

/// A file that is opened must not get the number of a standard descriptor that was closed: messages
/// would go into it. What is put there instead refuses to be read or written, as before.
void fill_closed_descriptors() {
    for (int number = STDIN_FILENO; number <= STDERR_FILENO; ++number)
        if (::fcntl(number, F_GETFD) < 0 && errno == EBADF)
            ::open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

} // namespace

int main(int count, char** arguments) {
    keep_freed_memory();
    prepare_for_signals();
    fill_closed_descriptors();
    rastertrace::take_folder_of_run();
    return rastertrace::run_command_line(count, arguments);
}
