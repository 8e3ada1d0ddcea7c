// SPDX-License-Identifier: MIT
// What somebody does first: the commands of README.md, as they stand, and demo.sh.

#include "program.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

class ReadmeTest : public ProgramTest {
protected:
    /// A folder that has of the project only the examples.
    ReadmeTest() {
        fs::copy(RASTERTRACE_EXAMPLES, folder_ / "examples", fs::copy_options::recursive);
        fs::create_directories(folder_ / "docs/figures"); // for the picture that README.md has
    }

    /// A file of the project, line by line.
    static std::vector<std::string> lines_of(const std::string& name) {
        std::ifstream file(source / name);
        std::vector<std::string> lines;
        for (std::string line; std::getline(file, line);)
            lines.push_back(line);
        return lines;
    }

    inline static const fs::path source = fs::path(RASTERTRACE_EXAMPLES).parent_path();
};

/// A command of the program and the exit status that a page tells; -1: none is told.
struct Told {
    std::string command;
    int status;
};

/// Those of a line: behind `$ `, or between backticks.
std::vector<Told> commands_in(const std::string& line) {
    static const std::regex prompt(R"(^\$ (rastertrace .*?)(?: # exit (\d))?$)");
    static const std::regex code("`(rastertrace [^`]+)`");
    std::smatch found;
    if (std::regex_match(line, found, prompt))
        return {{found[1], found[2].matched ? std::stoi(found[2]) : 0}};
    std::vector<Told> commands;
    for (std::sregex_iterator one(line.begin(), line.end(), code), end; one != end; ++one)
        commands.push_back({(*one)[1], -1});
    return commands;
}

TEST_F(ReadmeTest, EveryCommandOfTheReadmeRunsAsItStands) {
    std::size_t count = 0;
    for (const std::string& line : lines_of("README.md"))
        for (const auto& [command, status] : commands_in(line)) {
            const Outcome told = shell("PATH=$(dirname \"$rastertrace\"):$PATH; " + command);
            // In a table stands no status; 1 says that something differs.
            const int expected = status >= 0 ? status : told.status == 1 ? 1 : 0;
            EXPECT_EQ(told.status, expected) << command << "\n" << told.err;
            ++count;
        }
    EXPECT_GE(count, 10U);
    const auto lines = lines_of("README.md");
    EXPECT_THAT(lines, Contains("export PATH=$PWD/build/release/viewer-cli:$PATH"));
    EXPECT_LE(lines.size(), 100U) << "two screens";
}

TEST_F(ReadmeTest, TheDemoFitsOnAScreenAndEndsWithWhatToDoNext) {
    // The program is built already, and nothing is missing.
    const fs::path program_folder = folder_ / "build/release/viewer-cli";
    fs::create_directories(program_folder);
    fs::create_directory(folder_ / "scripts");
    for (const std::string name : {"rastertrace", "rastertrace_first_picture"})
        fs::create_symlink(fs::path(RASTERTRACE_PROGRAM).parent_path() / name,
                           program_folder / name);
    fs::create_symlink("/bin/true", folder_ / "scripts/install-packages.sh");
    fs::create_symlink("/bin/true", folder_ / "cmake");
    fs::copy_file(source / "demo.sh", folder_ / "demo.sh");
    const Outcome told = shell("PATH=$PWD:$PATH ./demo.sh");
    EXPECT_EQ(told.status, 0) << told.err;
    EXPECT_LE(std::count(told.out.begin(), told.out.end(), '\n'), 40);
    EXPECT_THAT(told.out,
                StartsWith(shell("$rastertrace show examples/t0-fill/first-triangle.json").out))
        << "what is linked first tells the same";
    EXPECT_THAT(told.out, HasSubstr("  y=2    AB x = -1/4 -> -1    AC x = 25/8 -> 3   5 pixels\n"));
    EXPECT_THAT(told.out, HasSubstr(" -3   . . . . B # # # # # # # # C . . .\n"));
    const std::string program = "build/release/viewer-cli/rastertrace";
    const std::string next = program + " play examples/t0-fill/first-triangle.json";
    EXPECT_THAT(told.out, EndsWith("\n\nThe program is " + (folder_ / program).string() +
                                   ". To go through this step by step, and back:\n    " + next +
                                   "\nThe tutorial begins in docs/tutorial/README.md.\n"));
    EXPECT_EQ(shell(next + " --print 80x24").status, 0);
    EXPECT_TRUE(fs::exists(source / "docs/tutorial/README.md"));
}

} // namespace
} // namespace rastertrace
