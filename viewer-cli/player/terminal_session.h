// SPDX-License-Identifier: MIT
#pragma once

// A terminal taken over by the program: no echo, keys as they are pressed, the mouse, a screen of its own. It is given
// back as it was on every way out: the end of the session, a signal, a crash, and while the program is stopped.
//
//     TerminalSession terminal;
//     terminal.show({"first line", "second line"});
//     terminal.wait(100);
//     while (auto key = terminal.key()) ...

#include "frames/terminal_text.h"
#include "player/key_reader.h"

#include <rastertrace/trace/text/descriptor.h>

#include <optional>
#include <string>
#include <vector>

namespace rastertrace {

/// Gives the terminal back, if a session has it: for who ends the program without ending the session. May be called in a
/// handler of a signal.
void give_back_terminal() noexcept;

/// In a handler of a signal that several threads may get at once: returns in the first, and holds the others until the
/// program has ended.
void go_on_alone() noexcept;

class TerminalSession {
public:
    /// True if standard output is a terminal that can be taken over, and keys can be read from it.
    static bool is_possible();

    /// Takes the terminal over. There is one session at a time. Throws a Problem.
    TerminalSession();
    TerminalSession(const TerminalSession&) = delete;
    TerminalSession& operator=(const TerminalSession&) = delete;
    ~TerminalSession();

    TextSize size() const;

    /// Waits for a key or another size, so many milliseconds at most; for ever if that is negative.
    void wait(int milliseconds);

    /// The next key that was pressed. What may be the beginning of one is waited for a moment.
    std::optional<KeyPress> key();

    /// True once after the size has changed, or the screen has to be drawn anew for another reason.
    bool needs_redraw();

    /// False if nobody can press keys any more.
    bool is_open() const { return is_open_; }

    /// Shows these lines, from the top. Lines that have not changed are not written again.
    void show(const std::vector<std::string>& lines);

private:
    void read_keys();

    Descriptor own_input_; ///< if standard input is something else
    int input_;
    KeyReader keys_;
    std::vector<std::string> shown_;
    bool is_open_ = true;
};

} // namespace rastertrace
