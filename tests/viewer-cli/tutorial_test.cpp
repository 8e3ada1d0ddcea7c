// SPDX-License-Identifier: MIT
// The tutorial's exercises: what a student gets is all open, what stands in the answers is all right, and both ask the
// same. That pages show what commands print is another test's (docs-are-up-to-date).

#include "program.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cctype>
#include <map>
#include <set>

namespace rastertrace {
namespace {

using testing::HasSubstr;

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
        const Outcome outcome = shell("$rastertrace check '" + file.string() + "' --json");
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
    EXPECT_EQ(chapters().size(), 8U);
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

} // namespace
} // namespace rastertrace
