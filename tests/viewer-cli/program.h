// SPDX-License-Identifier: MIT
#pragma once

// Runs the program as a user does, from a shell, in a folder of its own.
//
//     TEST_F(ProgramTest, ...) {
//         write("scene.json", ...);
//         EXPECT_THAT(run("plan scene.json"), Prints(...));
//     }

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

extern char** environ;

namespace rastertrace {

namespace fs = std::filesystem;

using testing::_;
using testing::AllOf;
using testing::AnyOf;
using testing::Contains;
using testing::ContainsRegex;
using testing::Each;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;

/// How a command ended, and what it printed.
struct Outcome {
    int status = -1; ///< as the shell tells it: 128 + signal if it was killed
    std::string out;
    std::string err;
    long peak_memory = 0; ///< of the largest program that ran, in bytes
};

inline std::ostream& operator<<(std::ostream& to, const Outcome& outcome) {
    return to << "status " << outcome.status << ", out:\n"
              << outcome.out << "err:\n"
              << outcome.err;
}

/// What a command prints, in full or by a matcher.
using Text = testing::Matcher<const std::string&>;

/// Of an outcome: how it ends, and what it prints. Refused is what becomes of bad input.
inline testing::Matcher<const Outcome&> Ends(int status, const Text& out = _, const Text& err = _) {
    return AllOf(testing::Field("status", &Outcome::status, status),
                 testing::Field("out", &Outcome::out, out),
                 testing::Field("err", &Outcome::err, err));
}
inline testing::Matcher<const Outcome&> Prints(const Text& out) {
    return Ends(0, out);
}
inline testing::Matcher<const Outcome&> Refused(const Text& err) {
    return Ends(2, _, err);
}

class ProgramTest : public testing::Test {
protected:
    ProgramTest() {
        std::string pattern = (fs::temp_directory_path() / "rastertrace-XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
    }
    ~ProgramTest() override { fs::remove_all(folder_); }

    /// Runs a shell command in the test's own folder; $rastertrace is the program, $examples the
    /// folder of examples.
    Outcome shell(const std::string& command) const {
        const std::string script = "cd '" + folder_.string() + "' || exit 99; rastertrace='" +
                                   std::string(RASTERTRACE_PROGRAM) + "'; examples='" +
                                   std::string(RASTERTRACE_EXAMPLES) + "'; unset COLUMNS LINES; " +
                                   command;
        const std::string out = (folder_ / ".out").string();
        const std::string err = (folder_ / ".err").string();
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions, 1, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                         0600);
        posix_spawn_file_actions_addopen(&actions, 2, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                         0600);
        std::vector<std::string> words{"/bin/sh", "-c", script};
        std::vector<char*> arguments;
        for (std::string& word : words)
            arguments.push_back(word.data());
        arguments.push_back(nullptr);
        pid_t child = 0;
        EXPECT_EQ(::posix_spawn(&child, "/bin/sh", &actions, nullptr, arguments.data(), environ),
                  0);
        posix_spawn_file_actions_destroy(&actions);
        int status = 0;
        struct rusage usage {};
        ::wait4(child, &status, 0, &usage);
        return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), content(".out"),
                content(".err"), 1024 * usage.ru_maxrss};
    }
    /// Runs the program with these arguments, and what a shell does behind them.
    Outcome run(const std::string& arguments) const { return shell("$rastertrace " + arguments); }
    Outcome diff(const std::string& arguments) const { return run("diff " + arguments); }

    /// The message of a command that is refused, and that it printed nothing.
    std::string refusal(const std::string& arguments) const {
        const Outcome told = run(arguments);
        EXPECT_EQ(told.status, 2) << arguments;
        EXPECT_EQ(told.out, "") << arguments;
        return told.err;
    }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }
    std::string content(const std::string& name) const {
        std::ostringstream text;
        text << std::ifstream(folder_ / name).rdbuf();
        return text.str();
    }
    std::size_t visible_files() const {
        return static_cast<std::size_t>(std::count_if(
            fs::directory_iterator(folder_), fs::directory_iterator(),
            [](const auto& entry) { return entry.path().filename().string().front() != '.'; }));
    }

    fs::path folder_;
};

} // namespace rastertrace
