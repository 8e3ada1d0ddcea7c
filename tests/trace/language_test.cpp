// SPDX-License-Identifier: MIT
// Steps told in Portuguese: nothing is missing, and only words differ from English.

#include "effort.h"
#include "random_scene.h"
#include "traces.h"

#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/working.h>
#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/text.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {
namespace {

/// Tells steps in a language as long as it lives.
class TellingIn {
public:
    explicit TellingIn(Language language) { tell_steps_in(language); }
    ~TellingIn() { tell_steps_in(Language::english); }
    TellingIn(const TellingIn&) = delete;
    TellingIn& operator=(const TellingIn&) = delete;
};

/// The placeholders of a pattern in order; of {inside?in:out} only what is asked.
std::vector<std::string> placeholders_of(std::string_view pattern) {
    std::vector<std::string> names;
    for (std::size_t open = pattern.find('{'); open != std::string_view::npos;
         open = pattern.find('{', open + 1)) {
        const std::string_view name = pattern.substr(open + 1, pattern.find('}', open) - open - 1);
        names.emplace_back(name.substr(0, name.find('?')));
    }
    return names;
}

TEST(Language, TheTableOfStepsHasASentenceInEach) {
    for (const std::string_view name : step_kind_names()) {
        const Words& sentence = row_of(*step_kind_named(name)).sentence;
        for (const std::string_view code : language_codes()) {
            const std::string_view told = sentence.in(*language_with_code(code));
            EXPECT_FALSE(told.empty()) << name;
            EXPECT_EQ(placeholders_of(told), placeholders_of(sentence.in(Language::english)))
                << name << " in " << code;
        }
    }
}

TEST(Language, CodesNameThem) {
    EXPECT_THAT(language_codes(), testing::ElementsAre("en", "pt"));
    for (const std::string_view code : language_codes())
        EXPECT_EQ(code_of(*language_with_code(code)), code);
    EXPECT_EQ(language_with_code("pt_BR"), std::nullopt);
    EXPECT_EQ(language_of_steps(), Language::english);
}

/// The words of a text, and its digits. A word has two letters at least, the first of them small, and nothing but
/// letters: names of vertices are capitals, and names of faces and colors have digits or dots in them.
struct Split {
    std::set<std::string> words;
    std::string digits;
};
Split split(const std::string& text) {
    Split found;
    for (std::string word : split_at(text, ' ')) {
        for (const char byte : word)
            if (std::isdigit(static_cast<unsigned char>(byte)) != 0)
                found.digits += byte;
        while (!word.empty() &&
               std::string_view("(),:;|").find(word.back()) != std::string_view::npos)
            word.pop_back();
        word.erase(0, std::min(word.find_first_not_of('('), word.size()));
        const auto is_letter = [](char byte) {
            return std::isalpha(static_cast<unsigned char>(byte)) != 0;
        };
        if (word.size() >= 2 && std::all_of(word.begin(), word.end(), is_letter) &&
            std::islower(static_cast<unsigned char>(word.front())) != 0)
            found.words.insert(word);
    }
    return found;
}

/// What both languages call the same: signs of formulas, words of scenes (rules, factors of matrices), and words that
/// are Portuguese too.
const std::set<std::string> shared_words{
    "away",   "buffer",      "byte",  "ceil",      "do",         "doubles", "dx",       "dy",
    "even",   "face",        "flip",  "floor",     "horizontal", "inside",  "nearest",  "no",
    "normal", "perspective", "pixel", "pixels",    "rotate",     "scale",   "shear",    "sRGB",
    "sqrt",   "start",       "step",  "translate", "truncate",   "up",      "viewport", "zero"};

TEST(Language, NoEnglishWordIsLeftInPortugueseAndNoNumberDiffers) {
    std::set<StepKind> met;
    std::map<std::string, std::string> left; // and where
    for (std::uint64_t seed = 1; seed <= random_cases(400u); ++seed) {
        const auto read = read_scene({"scene.json", RandomScene(seed).text()});
        if (!read)
            continue;
        const Trace trace = trace_of(read.value().scene);
        std::set<std::string> names;
        for (std::size_t n = 1; n <= trace.size(); ++n)
            if (trace.kind_of(n) == StepKind::primitive || trace.kind_of(n) == StepKind::vertex ||
                trace.kind_of(n) == StepKind::matrix) {
                const StepView step = trace.step(n);
                const bool is_matrix = trace.kind_of(n) == StepKind::matrix;
                const TracedText object = is_matrix ? step.as<MatrixStep>().object : TracedText();
                for (const TracedText& name : {name_in(step), object})
                    for (const std::string& word : split(name.text()).words)
                        names.insert(word);
            }
        Replay replay(trace, {.depths = true});
        for (std::size_t n = 1; n <= trace.size(); ++n) {
            constexpr std::size_t one_in = 16; // of so many pixels one will do
            if (trace.kind_of(n) == StepKind::pixel && n % one_in != 0)
                continue;
            replay.go_to(n);
            std::vector<std::string> english = working_of(replay);
            english.push_back(describe_step(replay));
            const TellingIn portuguese(Language::portuguese);
            std::vector<std::string> told = working_of(replay);
            told.push_back(describe_step(replay));
            ASSERT_EQ(told.size(), english.size());
            for (std::size_t i = 0; i < told.size(); ++i) {
                const Split there = split(told[i]);
                const Split here = split(english[i]);
                EXPECT_EQ(there.digits, here.digits) << told[i];
                for (const std::string& word : there.words)
                    if (here.words.contains(word) && !names.contains(word) &&
                        !shared_words.contains(word))
                        left.emplace(word, told[i]);
            }
            met.insert(*trace.kind_of(n));
        }
    }
    EXPECT_EQ(met.size(), step_kinds);
    for (const auto& [word, where] : left)
        ADD_FAILURE() << word << " in: " << where;
}

TEST(Language, TheFirstTriangleInPortuguese) {
    const Trace trace = trace_of(scene_in(
        R"({"vertices":{"A":[2,5],"B":[-4,-3],"C":[5,-3]},"triangles":["ABC"],"method":{"scalar":"exact"}})"));
    Replay replay(trace);
    const TellingIn portuguese(Language::portuguese);
    const auto told = [&replay](std::size_t n) {
        replay.go_to(n);
        return describe_step(replay);
    };
    EXPECT_EQ(told(0), "nada desenhado ainda");
    EXPECT_EQ(told(1), "triângulo ABC   A (2, 5)   B (-4, -3)   C (5, -3)");
    EXPECT_EQ(told(3), "aresta BC: horizontal, não tem dx/dy");
    EXPECT_EQ(told(14), "linha y=2   esquerda AB: x = 2 + 3/4 (2 - 5) = -1/4 -> floor -> -1   "
                        "direita AC: x = 2 - 3/8 (2 - 5) = 25/8 -> floor -> 3");
    EXPECT_EQ(told(15), "pixel (-1, 2)   linha y=2: -1 a 3");
}

} // namespace
} // namespace rastertrace
