// SPDX-License-Identifier: MIT
// The tutorial's exercises: what a student gets is all open, what stands in the answers is all right, and both ask the
// same; and a table of a page that no command prints. That pages show what commands print is another test's
// (docs-are-up-to-date).

#include "program.h"

#include <nlohmann/json.hpp>

#include <cctype>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

const fs::path examples = fs::path(RASTERTRACE_EXAMPLES);
const fs::path exercises = examples / "tutorial";
const fs::path pages = examples / "../docs/tutorial";

/// The files of claims in a folder by name. Exercises begin with their number.
std::set<std::string> claims_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".claims")
            names.insert(entry.path().filename().string());
    return names;
}

bool is_exercise(const std::string& name) {
    return std::isdigit(static_cast<unsigned char>(name.front())) != 0;
}

std::set<std::string> chapters() {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(exercises / "answers"))
        names.insert(entry.path().filename().string());
    return names;
}

std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// The texts of all pages in a folder.
std::map<std::string, std::string> pages_in(const fs::path& folder) {
    std::map<std::string, std::string> texts;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".md")
            texts[entry.path().filename().string()] = text_of(entry.path());
    return texts;
}

class TutorialTest : public ProgramTest {
protected:
    nlohmann::json checked(const fs::path& file) const {
        const Outcome outcome = run("check '" + file.string() + "' --json");
        EXPECT_EQ(outcome.status, 0) << file << outcome.err;
        return outcome.status == 0 ? nlohmann::json::parse(outcome.out) : nlohmann::json();
    }
};

/// What a claim is about: all before its values.
std::vector<std::string> subjects_in(const nlohmann::json& report) {
    std::vector<std::string> subjects;
    for (const auto& claim : report["claims"]) {
        const std::string text = claim["claim"];
        subjects.push_back(text.substr(0, text.find(':')));
    }
    return subjects;
}

TEST_F(TutorialTest, EachExerciseIsOpenAndItsAnswerRight) {
    EXPECT_EQ(chapters().size(), 9U);
    for (const std::string& chapter : chapters()) {
        const auto answers = claims_in(exercises / "answers" / chapter);
        std::set<std::string> asked;
        for (const std::string& name : claims_in(exercises / chapter))
            if (is_exercise(name))
                asked.insert(name);
        EXPECT_EQ(asked, answers) << chapter;
        EXPECT_GE(asked.size(), 5U) << chapter;
        for (const std::string& name : asked) {
            const auto exercise = checked(exercises / chapter / name);
            const auto answer = checked(exercises / "answers" / chapter / name);
            if (exercise.is_null() || answer.is_null())
                continue;
            EXPECT_GT(exercise["open"], 0) << chapter << name;
            EXPECT_EQ(exercise["right"], 0) << chapter << name << ": a number is given away";
            EXPECT_EQ(answer["open"], 0) << chapter << name;
            EXPECT_EQ(answer["right"], exercise["open"]) << chapter << name;
            EXPECT_EQ(subjects_in(answer), subjects_in(exercise)) << chapter << name;
        }
    }
}

TEST_F(TutorialTest, EveryExerciseAnswerAndMistakeIsOnAPage) {
    const auto texts = pages_in(pages);
    const auto answers = pages_in(pages / "answers");
    const auto names = [](const std::map<std::string, std::string>& on, const std::string& file) {
        return std::any_of(on.begin(), on.end(), [&file](const auto& page) {
            return page.second.find(file) != std::string::npos;
        });
    };
    for (const std::string& chapter : chapters()) {
        for (const std::string& name : claims_in(exercises / chapter))
            EXPECT_TRUE(names(texts, "examples/tutorial/" + chapter + "/" + name) ||
                        names(answers, "examples/tutorial/" + chapter + "/" + name))
                << name;
        for (const std::string& name : claims_in(exercises / "answers" / chapter)) {
            EXPECT_TRUE(names(answers, "examples/tutorial/answers/" + chapter + "/" + name))
                << name;
            EXPECT_FALSE(names(texts, "examples/tutorial/answers/" + chapter + "/" + name)) << name;
        }
    }
}

TEST_F(TutorialTest, ChaptersHaveTheSamePartsAndLinkTheirAnswers) {
    for (const auto& [name, text] : pages_in(pages)) {
        if (!is_exercise(name))
            continue;
        for (const char* const heading : {"\n## The idea\n", "\n## The trace\n",
                                          "\n## Classic mistakes, and what they look like\n",
                                          "\n## What to remember\n", "\n## Exercises\n"})
            EXPECT_THAT(text, HasSubstr(heading)) << name;
        EXPECT_THAT(text, HasSubstr("(answers/" + name + ")"));
        EXPECT_TRUE(fs::exists(pages / "answers" / name)) << name;
        EXPECT_THAT(text_of(pages / "answers" / name), HasSubstr("(../" + name)) << name;
        EXPECT_THAT(text_of(pages / "README.md"), HasSubstr("(" + name + ")"));
    }
}

/// The cells of a row of a table, without the blanks and backquotes around them.
std::vector<std::string> cells_of(const std::string& row) {
    std::vector<std::string> cells;
    std::istringstream rest(row.substr(1));
    for (std::string cell; std::getline(rest, cell, '|');) {
        const std::size_t first = cell.find_first_not_of(" `");
        cells.push_back(first == std::string::npos
                            ? ""
                            : cell.substr(first, cell.find_last_not_of(" `") + 1 - first));
    }
    return cells;
}

/// True if a decimal is a number, rounded to the digits that it has.
bool is_rounded(const std::string& decimal, double number) {
    const std::size_t point = decimal.find('.');
    const auto places =
        point == std::string::npos ? 0 : static_cast<int>(decimal.size() - point - 1);
    return std::abs(std::stod(decimal) - number) <= 0.5000001 * std::pow(10.0, -places);
}

TEST_F(TutorialTest, TheTableOfSumsHasTheNumbersOfTheStressCatalogue) {
    const std::string page = text_of(pages / "7-numbers-that-go-wrong.md");
    std::istringstream lines(page.substr(page.find("| case | numbers | added: wrong |")));
    std::string row;
    std::getline(lines, row); // the head
    std::getline(lines, row); // and the line under it
    nlohmann::json measured;
    std::size_t checked_rows = 0;
    while (std::getline(lines, row) && row.starts_with('|')) {
        const std::vector<std::string> cells = cells_of(row);
        ASSERT_EQ(cells.size(), 6u) << row;
        if (!cells[0].empty()) {
            const std::string id = cells[0].substr(0, cells[0].find(':'));
            measured =
                nlohmann::json::parse(run("stress --json --case " + id).out)["cases"][0]["rows"];
        }
        // What adds comes first of each scalar, then what multiplies.
        std::vector<nlohmann::json> of_scalar;
        for (const auto& one : measured)
            if (one["scalar"] == cells[1] && one.contains("worst"))
                of_scalar.push_back(one);
        ASSERT_GE(of_scalar.size(), 2u) << row;
        for (const std::size_t i : {0u, 1u}) {
            EXPECT_EQ(cells[2 + 2 * i], of_scalar[i]["wrong"].dump()) << row;
            EXPECT_TRUE(is_rounded(cells[3 + 2 * i], of_scalar[i]["worst"]))
                << row << of_scalar[i]["worst"];
        }
        ++checked_rows;
    }
    EXPECT_EQ(checked_rows, 6u);
}

} // namespace
} // namespace rastertrace
