// SPDX-License-Identifier: MIT
// What the program says of itself: help, pages of the manual, completions of shells. All are made of one table.

#include "program.h"

#include <rastertrace/trace/text/text.h>

#include <regex>
#include <set>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

class HelpTest : public ProgramTest {
protected:
    std::vector<std::string> completions(const std::string& words) const {
        const Outcome told = run("help -- " + words);
        EXPECT_EQ(told.status, 0) << words;
        EXPECT_EQ(told.err, "") << words;
        std::vector<std::string> lines = split_at(told.out, '\n');
        lines.pop_back();
        return lines;
    }
};

/// What a pattern finds in a text, each once.
std::set<std::string> found_in(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::set<std::string> found;
    for (std::sregex_iterator one(text.begin(), text.end(), regex), end; one != end; ++one)
        found.insert((*one)[1]);
    return found;
}

TEST_F(HelpTest, HelpHas80Columns) {
    for (const std::string& command : completions("''"))
        for (const std::string& call :
             {command + " -h", command + " --help", std::string("--help"), "help " + command}) {
            const Outcome help = run(call);
            EXPECT_EQ(help.status, 0) << call;
            EXPECT_EQ(help.err, "") << call;
            for (const std::string& line : split_at(help.out, '\n'))
                EXPECT_LE(columns_in(line), 80U) << call << "\n" << line;
        }
}

TEST_F(HelpTest, EveryOptionIsInTheManualAndIsCompleted) {
    std::size_t options = 0;
    for (const std::string& command : completions("''")) {
        const std::string whole = run("help " + command).out;
        const auto names = found_in(whole, "\n  (?:-[a-zA-Z], )?(--[a-z0-9-]+)");
        const std::string manual = run("help --man " + command).out;
        const auto completed = completions(command + " -");
        EXPECT_THAT(names, Contains("--help")) << command;
        for (const std::string& name : names) {
            EXPECT_THAT(completed, Contains(name)) << command;
            const std::string in_roff = std::regex_replace(name, std::regex("-"), "\\-");
            EXPECT_TRUE(name == "--help" || manual.find(in_roff) != std::string::npos)
                << command << " " << name;
        }
        for (const std::string& one : completed)
            EXPECT_TRUE(one.size() == 2 || names.contains(one)) << command << " " << one;
        options += names.size();
        EXPECT_THAT(whole, StartsWith(run(command + " --help").out));
    }
    EXPECT_GT(options, 300U);
}

TEST_F(HelpTest, TheShortHelpLeavesOutWhatManyCommandsHave) {
    EXPECT_THAT(run("show -h").out,
                AllOf(HasSubstr("  --every STEP "), Not(HasSubstr("--rounding")),
                      HasSubstr("More with --help: Method, instead of what the scene says (")));
    EXPECT_THAT(run("show --help").out, HasSubstr("  --rounding NAME "));
}

// A line that begins with a point is a command of roff, and each is one that the pages of manuals have.
TEST_F(HelpTest, PagesOfTheManualAreRoff) {
    for (const std::string& command : completions("''")) {
        const std::string page = run("help --man " + command).out;
        EXPECT_THAT(page, StartsWith(".TH ")) << command;
        for (const std::string& macro : found_in(page, "\n(\\.[^\n ]*)"))
            EXPECT_THAT((std::set<std::string>{".SH", ".SS", ".TP", ".PP", ".nf", ".fi", ".nh"}),
                        Contains(macro))
                << command;
        for (const std::string section : {"NAME", "SYNOPSIS", "OPTIONS", "EXAMPLES", "EXIT STATUS"})
            EXPECT_THAT(page, HasSubstr("\n.SH " + section + "\n")) << command;
    }
    EXPECT_THAT(run("help --man").out, HasSubstr("\\fBrastertrace\\-show\\fR(1)"));
}

TEST_F(HelpTest, WordsAreCompleted) {
    const std::string triangle = " $examples/t0-fill/first-triangle.json ";
    EXPECT_THAT(completions("sh"), ElementsAre("show", "sheet"));
    EXPECT_THAT(completions("examples/"), ElementsAre(":files"));
    EXPECT_THAT(completions("show ''"), ElementsAre(":files"));
    EXPECT_THAT(completions("figure x -o ''"), ElementsAre(":files"));
    EXPECT_THAT(completions("show x --v"), ElementsAre("--view", "--vary"));
    EXPECT_THAT(completions("show x --view s"), ElementsAre("shade"));
    EXPECT_THAT(completions("figure x --with grid,hidden"), ElementsAre("grid,hidden-edges"));
    EXPECT_THAT(completions("show x --every sc"), ElementsAre("scanline"));
    EXPECT_THAT(completions("show x --step l"), Contains("last"));
    EXPECT_THAT(completions("explain x --against fill=top-left,rounding=h"),
                ElementsAre("fill=top-left,rounding=half-open"));
    EXPECT_THAT(completions("trace x --mistake height-plus"), ElementsAre("height-plus-one"));
    EXPECT_THAT(completions("explain" + triangle + "--vertex ''"), ElementsAre("A", "B", "C"));
    EXPECT_THAT(completions("trace" + triangle + "--primitive ''"), ElementsAre("ABC"));
    EXPECT_THAT(completions("explain nothing.json --vertex ''"), IsEmpty());
    EXPECT_THAT(completions("explain" + triangle + "--edge A"), ElementsAre("AB", "AC"));
    const std::string quads = " $examples/t0-hidden/cube-culled.json ";
    EXPECT_THAT(completions("explain" + quads + "--face AB"), ElementsAre("ABC"));
    EXPECT_THAT(completions("explain" + quads + "--pair ABC,A"),
                ElementsAre("ABC,ACD", "ABC,ADE", "ABC,AEF", "ABC,AFB"));
    EXPECT_THAT(completions("figure x --with grid,g"), IsEmpty());
    EXPECT_THAT(completions("show x --fill=two"), ElementsAre("--fill=two-halves"));
    EXPECT_THAT(completions("show x --fill = two"), ElementsAre("two-halves"));
    EXPECT_THAT(completions("show x --rounding ="), Contains("half-open"));
    EXPECT_THAT(completions("explain x --against fill=top-left,rounding = h"),
                ElementsAre("half-open"));
    EXPECT_THAT(completions(triangle + "--fram"), ElementsAre("--frame"));
    EXPECT_THAT(completions("--v"), ElementsAre("--version"));
    EXPECT_THAT(completions("help figu"), ElementsAre("figure"));
    EXPECT_THAT(completions("nothing --x"), IsEmpty());
}

TEST_F(HelpTest, BashCompletesWords) {
    const auto by_bash = [this](const std::string& words) {
        return shell(
                   "export PATH=$(dirname $rastertrace):$PATH; bash -c 'eval \"$(rastertrace help "
                   "--completion bash)\"; COMP_WORDS=(" +
                   words +
                   "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _rastertrace; echo "
                   "\"${COMPREPLY[*]}\"' 2>/dev/null")
            .out;
    };
    EXPECT_EQ(by_bash("rastertrace sh"), "show sheet\n");
    EXPECT_EQ(by_bash("rastertrace show x --view sh"), "shade\n");
    EXPECT_EQ(run("help --completion csh").err,
              "rastertrace: --completion: expected one of bash, zsh, fish, found \"csh\"\n"
              "hint: did you mean zsh?\n");
}

TEST_F(HelpTest, EveryCommandHasAnExampleThatWorks) {
    EXPECT_THAT(run("--version").out, StartsWith("rastertrace "));
    for (const std::string command :
         {"trace", "show", "figure", "stats", "plan", "stress", "report", "renew"}) {
        const std::string help = run(command + " --help").out;
        const std::size_t example = help.find("Example:\n  rastertrace ");
        ASSERT_NE(example, std::string::npos) << command;
        std::string line = help.substr(example + 23);
        for (std::size_t end = line.find("\\\n"); end != std::string::npos; end = line.find("\\\n"))
            line.erase(end, 2);
        line = line.substr(0, line.find('\n'));
        EXPECT_EQ(shell("[ -e docs ] || cp -r $examples $examples/../docs .; $rastertrace " + line)
                      .status,
                  0)
            << line;
    }
}

} // namespace
} // namespace rastertrace
