// SPDX-License-Identifier: MIT
#include "app/page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rastertrace {
namespace {

using testing::ElementsAre;

/// The page with this output below each of its commands.
std::string renewed(const std::string& text, const std::string& printed) {
    const Source page{.name = "page.md", .text = text};
    const std::vector<PageCommand> commands = commands_on(page);
    std::vector<std::string> outputs;
    for (const PageCommand& command : commands)
        outputs.push_back(output_for(page, command, printed));
    return with_outputs(page, commands, outputs);
}

/// What is wrong with the page once its commands have printed this.
std::string problem_of_page(const std::string& text, const std::string& printed = "new\n") {
    try {
        renewed(text, printed);
    } catch (const Problem& problem) {
        return to_text(problem);
    }
    return "no problem";
}

/// The only command, whose line is `$ rastertrace ` and this.
PageCommand command(const std::string& line) {
    return commands_on({"page.md", "```\n$ rastertrace " + line + "\n```\n"}).at(0);
}
std::string problem_of_command(const std::string& line) {
    return problem_of_page("```\n$ rastertrace " + line + "\n```\n");
}

TEST(RenewedPage, OutputsAreReplaced) {
    EXPECT_EQ(renewed("# Title\n"
                      "\n"
                      "```console\n"
                      "$ rastertrace plan a.json\n"
                      "old\n"
                      "\n"
                      "older\n"
                      "```\n"
                      "Text\n",
                      "new\nnewer\n"),
              "# Title\n"
              "\n"
              "```console\n"
              "$ rastertrace plan a.json\n"
              "new\n"
              "newer\n"
              "```\n"
              "Text\n");
}

TEST(RenewedPage, AnOutputEndsAtTheNextPrompt) {
    EXPECT_EQ(renewed("```\n"
                      "$ cd folder\n"
                      "nothing of ours\n"
                      "$ rastertrace plan a.json\n"
                      "$ rastertrace plan b.json\n"
                      "old\n"
                      "$ ls\n"
                      "a.json\n"
                      "```\n",
                      "new\n"),
              "```\n"
              "$ cd folder\n"
              "nothing of ours\n"
              "$ rastertrace plan a.json\n"
              "new\n"
              "$ rastertrace plan b.json\n"
              "new\n"
              "$ ls\n"
              "a.json\n"
              "```\n");
}

TEST(RenewedPage, BlankLinesBehindAnOutputAreTheAuthors) {
    const std::string once = renewed("```\n"
                                     "$ rastertrace plan a.json\n"
                                     "old\n"
                                     "\n"
                                     "$ rastertrace plan b.json\n"
                                     "\n"
                                     "```\n",
                                     "\nnew\n\n\n");
    EXPECT_EQ(once, "```\n"
                    "$ rastertrace plan a.json\n"
                    "\n"
                    "new\n"
                    "\n"
                    "$ rastertrace plan b.json\n"
                    "\n"
                    "new\n"
                    "\n"
                    "```\n");
    EXPECT_EQ(renewed(once, "\nnew\n\n\n"), once);
    EXPECT_EQ(renewed(once, ""), "```\n"
                                 "$ rastertrace plan a.json\n"
                                 "\n"
                                 "$ rastertrace plan b.json\n"
                                 "\n"
                                 "```\n");
}

TEST(RenewedPage, AFenceHasThreeMarksOrMore) {
    const std::string ours = "$ rastertrace plan a.json\nold\n";
    const std::string renewed_ours = "$ rastertrace plan a.json\nnew\n";
    for (const auto& [before, after] : std::vector<std::pair<std::string, std::string>>{
             {"```\n", "```\n"},
             {"```console\n", "```\n"},
             {"`````\n", "``````  \n"},
             {"````\n$ ls\n```\n````json\n", "````\n"}})
        EXPECT_EQ(renewed(before + ours + after, "new\n"), before + renewed_ours + after);
    for (const std::string before : {"", "``\n", "```code``` in a line\n", "```\n```\n", "> ```\n"})
        EXPECT_EQ(renewed(before + ours, "new\n"), before + ours);
}

TEST(RenewedPage, ABlockInAListKeepsItsIndent) {
    EXPECT_EQ(renewed("1. Look:\n"
                      "   ```\n"
                      "   $ rastertrace plan a.json\n"
                      "old\n"
                      "   ```\n",
                      "new\n\n  newer\n"),
              "1. Look:\n"
              "   ```\n"
              "   $ rastertrace plan a.json\n"
              "   new\n"
              "\n"
              "     newer\n"
              "   ```\n");
}

TEST(RenewedPage, TheRestStaysAsItIsByteForByte) {
    const std::string text = "\xEF\xBB\xBF"
                             "caf\xC3\xA9 \xFF\r\n"
                             "```\n"
                             "$ rastertrace plan a.json\n"
                             "old\n"
                             "```";
    EXPECT_EQ(renewed(text, "A \xE2\x86\x92 B\nnew\n"), "\xEF\xBB\xBF"
                                                        "caf\xC3\xA9 \xFF\r\n"
                                                        "```\n"
                                                        "$ rastertrace plan a.json\n"
                                                        "A \xE2\x86\x92 B\n"
                                                        "new\n"
                                                        "```");
    for (const std::string other : {"", "no newline", "```\n$ ls\n", "\n\n\r\n"})
        EXPECT_EQ(renewed(other, "new\n"), other);
}

TEST(RenewedPage, WordsAreSplitAtBlanksAndQuotesAreTakenAway) {
    EXPECT_THAT(command("show  a.json\t--last").words, ElementsAre("show", "a.json", "--last"));
    EXPECT_THAT(command(R"('a b' "c d" g'h'"i" '' "")").words,
                ElementsAre("a b", "c d", "ghi", "", ""));
    EXPECT_THAT(command("plan \xC3\xA9.json a#b").words,
                ElementsAre("plan", "\xC3\xA9.json", "a#b"));
    EXPECT_THAT(command("").words, ElementsAre());
}

TEST(RenewedPage, ACommentMayStateTheExitStatus) {
    EXPECT_EQ(command("show bad.json # exit 2").exit_status, 2);
    EXPECT_THAT(command("show bad.json # exit 2").words, ElementsAre("show", "bad.json"));
    EXPECT_EQ(command("show bad.json #exit 255 ").exit_status, 255);
    for (const std::string comment : {"# exit", "# exit 256", "# exit two", "# we exit 2", "# |>$"})
        EXPECT_EQ(command("show a.json " + comment).exit_status, 0) << comment;
}

TEST(RenewedPage, WhatNeedsAShellIsRefused) {
    EXPECT_EQ(problem_of_command("trace a.json | head"),
              "page.md:2:28: expected a command that needs no shell, found |\n"
              "$ rastertrace trace a.json | head\n"
              "                           ^\n"
              "hint: quote it if it is part of a word");
    for (const char c : std::string("\\|&;<>()$`*?[]{}~!")) {
        EXPECT_THAT(problem_of_command(std::string("show a") + c),
                    testing::HasSubstr(std::string("page.md:2:21: expected a command that needs "
                                                   "no shell, found ") +
                                       c));
        EXPECT_THAT(command(std::string("show 'a") + c + "'").words,
                    ElementsAre("show", std::string("a") + c));
    }
    EXPECT_EQ(problem_of_command("show 'a"),
              "page.md:2:20: expected a closing ', found the end of the line\n"
              "$ rastertrace show 'a\n"
              "                   ^");
}

TEST(RenewedPage, APlayerIsBegunByTheReader) {
    const auto words_of = [](const std::string& line) {
        const auto commands =
            commands_on({.name = "page.md", .text = "```\n$ rastertrace " + line + "\n```\n"});
        return commands.size() == 1 ? commands.front().words : std::vector<std::string>();
    };
    EXPECT_THAT(words_of("play scene.json"), ElementsAre());
    EXPECT_THAT(words_of("play a b --step 3"), ElementsAre());
    EXPECT_THAT(words_of("play --keys"), ElementsAre("play", "--keys"));
    EXPECT_THAT(words_of("play x --print 80x24"), ElementsAre("play", "x", "--print", "80x24"));
}

TEST(RenewedPage, ABlockWithoutAnEndIsRefused) {
    EXPECT_EQ(problem_of_page("Look:\n"
                              "  ```console\n"
                              "  $ rastertrace plan a.json\n"
                              "Text\n"),
              "page.md:2:3: expected a line that closes this block, found the end of the page\n"
              "  ```console\n"
              "  ^");
}

TEST(RenewedPage, AnOutputEndsNeitherItsBlockNorItself) {
    EXPECT_EQ(problem_of_page("```\n$ rastertrace plan a.json\n```\n", "a\n  ```\n"),
              "page.md:1:1: expected a longer fence, found one that the output of line 2 has, too\n"
              "```\n"
              "^");
    EXPECT_EQ(renewed("````\n$ rastertrace plan a.json\n````\n", "```\n````json\n"),
              "````\n$ rastertrace plan a.json\n```\n````json\n````\n");
    EXPECT_EQ(problem_of_page("```\n$ rastertrace plan a.json\n```\n", "$ ls\n"),
              "page.md:2:1: expected output that is no command, found \"$ ls\"\n"
              "$ rastertrace plan a.json\n"
              "^\n"
              "hint: a line that begins with $ and a blank would end the output");
}

TEST(RenewedPage, ControlCharactersAreMadeVisible) {
    EXPECT_EQ(renewed("```\n$ rastertrace plan a.json\n```\n", "a\x1b[2J\xFF\n"),
              "```\n$ rastertrace plan a.json\na<U+001B>[2J<0xFF>\n```\n");
}

} // namespace
} // namespace rastertrace
