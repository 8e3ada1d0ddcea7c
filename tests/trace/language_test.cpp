// SPDX-License-Identifier: MIT
// Steps told, questions answered and claims checked in Portuguese: nothing is missing, and only words differ from
// English.

#include "claims_support.h"
#include "effort.h"
#include "languages.h"
#include "random_scene.h"
#include "traces.h"

#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/check/slips.h>
#include <rastertrace/trace/explain/explain.h>
#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/formula.h>
#include <rastertrace/trace/tell/working.h>
#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/text.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {
namespace {

/// The placeholders of a pattern in order, without numbers; of {inside?in:out} only what is asked.
std::vector<std::string> placeholders_of(std::string_view pattern) {
    std::vector<std::string> names;
    for (std::size_t open = pattern.find('{'); open != std::string_view::npos;
         open = pattern.find('{', open + 1)) {
        const std::string_view name = pattern.substr(open + 1, pattern.find('}', open) - open - 1);
        const bool is_place = name.find_first_not_of("0123456789") == std::string_view::npos;
        names.emplace_back(is_place ? "" : name.substr(0, name.find('?')));
    }
    return names;
}

const std::filesystem::path sources = std::filesystem::path(RASTERTRACE_EXAMPLES) / "..";

std::map<std::string, std::string> portuguese_catalogue() {
    std::ifstream file(sources / "trace/text/languages/pt.json");
    return nlohmann::json::parse(file);
}

/// A text that stands in a source, and what stands before it.
struct Literal {
    std::string before;
    std::string text;
};

/// All texts of a source; those with nothing between are one.
std::vector<Literal> literals_in(const std::string& source) {
    std::vector<Literal> found;
    std::string before; ///< of code, without blanks
    bool goes_on = false;
    for (std::size_t i = 0; i < source.size(); ++i) {
        if (source.compare(i, 2, "//") == 0) {
            i = std::min(source.find('\n', i), source.size());
        } else if (source.compare(i, 3, "R\"(") == 0) {
            i = source.find(")\"", i) + 1;
            goes_on = false;
        } else if (source[i] == '\'' && (before.empty() || std::isalnum(static_cast<unsigned char>(
                                                               before.back())) == 0)) {
            i += source[i + 1] == '\\' ? 3 : 2; // a letter
        } else if (source[i] == '"') {
            const std::size_t begin = i++;
            while (source[i] != '"')
                i += source[i] == '\\' ? 2 : 1;
            const auto text =
                nlohmann::json::parse(source.substr(begin, i + 1 - begin), nullptr, false);
            if (!goes_on)
                found.push_back({before, {}});
            if (text.is_string())
                found.back().text += text.get<std::string>();
            goes_on = true;
            before += '"';
        } else if (std::isspace(static_cast<unsigned char>(source[i])) == 0) {
            before = (before + source[i]).substr(before.size() < 20 ? 0 : 1);
            goes_on = false;
        }
    }
    return found;
}

TEST(Language, TheCatalogueHasWhatIsSaidAndNothingElse) {
    const auto catalogue = portuguese_catalogue();
    std::set<std::string> texts;
    std::size_t said = 0;
    for (const std::string_view layer : {"core", "trace", "viewer-cli"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(sources / layer)) {
            if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h")
                continue;
            std::ifstream file(entry.path());
            for (const Literal& one : literals_in({std::istreambuf_iterator<char>(file), {}})) {
                texts.insert(one.text);
                const bool is_told = one.before.ends_with("said(") || one.before.ends_with("told(");
                said += is_told ? 1 : 0;
                EXPECT_TRUE(!is_told || catalogue.contains(one.text))
                    << entry.path() << ": " << one.text;
            }
        }
    EXPECT_GT(said, 400U);
    for (const auto& [english, portuguese] : catalogue) {
        const std::string_view words(english);
        const bool is_of_traces =
            words.ends_with("##trace"); // words of enumerators, like between_rows
        EXPECT_TRUE(is_of_traces || texts.contains(english)) << english;
        EXPECT_THAT(placeholders_of(portuguese), testing::UnorderedElementsAreArray(placeholders_of(
                                                     words.substr(0, words.find("##")))))
            << english;
    }
}

TEST(Language, CodesNameThem) {
    EXPECT_THAT(language_codes(), testing::ElementsAre("en", "pt"));
    for (const std::string_view code : language_codes())
        EXPECT_EQ(code_of(*language_with_code(code)), code);
    EXPECT_EQ(language_with_code("pt_BR"), std::nullopt);
    EXPECT_EQ(language_of_steps(), Language::english);
}

/// What both languages call the same: signs of formulas, words of scenes (rules, factors of matrices), and words that
/// are Portuguese too.
const std::set<std::string> shared_words{
    "cos",   "diagonal",   "sin",       "away",     "buffer", "byte",     "ceil",
    "do",    "doubles",    "dx",        "dy",       "even",   "face",     "flip",
    "floor", "horizontal", "inside",    "nearest",  "no",     "normal",   "perspective",
    "pixel", "pixels",     "rotate",    "scale",    "shear",  "sRGB",     "sqrt",
    "start", "step",       "translate", "truncate", "up",     "viewport", "zero",
    "nx",    "ny",         "nz",        "vx",       "vy",     "vz"};

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

Scene example(const std::string& name) {
    std::ifstream file(RASTERTRACE_EXAMPLES "/" + name + ".json");
    return scene_in({std::istreambuf_iterator<char>(file), {}});
}

/// Some questions of each kind that a trace has an answer to.
std::vector<Question> questions_about(const Trace& trace) {
    const Canvas& canvas = trace.canvas;
    std::vector<Question> questions{{.about = Topic::step, .text = "1"}};
    for (int row = 0; row < canvas.height; row += 2) {
        const int y = canvas.y_of(row);
        questions.push_back({.about = Topic::scanline, .pixel = {0, y}});
        for (int x = canvas.left(); x <= canvas.right(); x += 3)
            questions.push_back({.pixel = {x, y}});
    }
    for (const Topic topic : {Topic::face, Topic::vertex, Topic::edge})
        for (const std::string& name : names_to_ask(trace, topic))
            questions.push_back({.about = topic, .text = name});
    if (const auto names = names_to_ask(trace, Topic::pair); names.size() >= 2)
        questions.push_back({.about = Topic::pair, .text = names[0] + "," + names[1]});
    return questions;
}

/// All that an answer says; nothing if there is none.
std::vector<std::string> told_of(const Trace& trace, const Question& question) {
    const auto answer = explain(trace, question);
    if (!answer)
        return {};
    const Explanation& told = answer.value();
    std::vector<std::string> texts{told.question, told.answer};
    const auto add = [&texts](const std::vector<std::string>& lines) {
        texts.insert(texts.end(), lines.begin(), lines.end());
    };
    add(told.lacks);
    for (const Try& one : told.tries) {
        texts.push_back(one.sentence);
        add(one.working);
    }
    for (const WhyNot& one : told.why_not) {
        texts.push_back(one.sentence);
        add(one.working);
    }
    for (const PixelAlongEdge& one : told.pixels)
        add(one.why);
    return texts;
}

void expect_in_portuguese(const Trace& trace) {
    for (const Question& question : questions_about(trace)) {
        const std::vector<std::string> english = told_of(trace, question);
        const TellingIn portuguese(Language::portuguese);
        const std::vector<std::string> told = told_of(trace, question);
        ASSERT_EQ(told.size(), english.size());
        for (std::size_t i = 0; i < told.size(); ++i) {
            const Split found = split(told[i]);
            EXPECT_EQ(found.digits, split(english[i]).digits) << told[i];
            for (const std::string& word : found.words)
                EXPECT_FALSE(english_words.contains(word)) << word << " in: " << told[i];
        }
    }
}

TEST(Language, NoEnglishWordIsLeftInAnswersInPortuguese) {
    for (const char* const name :
         {"circle/midpoint", "polygon/star", "t0-fill/first-triangle", "t0-hidden/cube-culled",
          "t0-hidden/two-depths", "t2-lines/naive", "t2-lines/outline", "t2-lines/points",
          "t3-sweep-and-box/barycentric", "t3-sweep-and-box/top-left", "t4-fan/fan"})
        expect_in_portuguese(trace_of(example(name)));

    const Scene scene = example("t0-fill/first-triangle");
    expect_in_portuguese(readable_trace(
        trace_text(scene, {.filter = {.only = {{StepKind::primitive, StepKind::pixel}}}})));
    expect_in_portuguese(
        readable_trace(trace_text(scene, {.filter = {.region = Region{-3, -3, 1, 1}}})));
    const std::string lines = trace_text(scene, in_lines);
    expect_in_portuguese(readable_trace(lines.substr(0, lines.find("\n", lines.size() / 2) + 1)));
}

TEST(Language, WhyAPixelIsNotDrawnInPortuguese) {
    const Trace trace = trace_of(example("t0-fill/first-triangle"));
    const Question question{.pixel = {4, 2}};
    EXPECT_EQ(explain(trace, question).value().why_not[0].sentence,
              "AC ends row y=2 at x = 25/8 -> floor -> 3; x = 4 lies beyond it by 7/8");
    const TellingIn portuguese(Language::portuguese);
    const Explanation told = explain(trace, question).value();
    EXPECT_EQ(told.answer, "não desenhado: ABC não o cobre");
    EXPECT_EQ(told.why_not[0].sentence,
              "AC termina a linha y=2 em x = 25/8 -> floor -> 3; x = 4 fica 7/8 além");
    EXPECT_EQ(told.why_not[0].reason, "outside");
    EXPECT_EQ(explain(trace, {.about = Topic::scanline, .pixel = {0, 2}}).value().answer,
              "1 primitiva com esta linha");
}

/// Nothing but words of both languages is the same.
void expect_other_words(const std::vector<std::string>& english,
                        const std::vector<std::string>& told) {
    ASSERT_EQ(told.size(), english.size());
    for (std::size_t i = 0; i < told.size(); ++i) {
        const Split here = split(english[i]);
        const Split there = split(told[i]);
        EXPECT_EQ(there.digits, here.digits) << told[i];
        for (const std::string& word : there.words)
            EXPECT_FALSE(here.words.contains(word) && !shared_words.contains(word))
                << word << " in: " << told[i];
    }
}

/// All that is said of claims, except for their workings: these are of working.h and explain.h.
std::vector<std::string> told_of(const Checked& checked) {
    std::vector<std::string> texts;
    for (const CheckedClaim& claim : checked.claims) {
        for (const auto* const lines : {&claim.remarks, &claim.picture})
            texts.insert(texts.end(), lines->begin(), lines->end());
        for (const CheckedField& field : claim.fields) {
            for (const std::string_view text :
                 {words_for_field(field.name), word_for_value(field.name, field.expected),
                  word_for_value(field.name, field.found), std::string_view(field.remark),
                  field.rule, field.formula})
                texts.emplace_back(text);
            for (const LikelySlip& slip : field.slips)
                texts.push_back(slip.meaning);
        }
    }
    return texts;
}

/// Claims, one of which has this remark, or this value, in English.
struct ClaimsWith {
    std::string told;
    std::string scene;
    std::string claims;
    MethodOverrides method = {};
};

TEST(Language, NoEnglishWordIsLeftInWhatIsFoundInPortuguese) {
    const std::string triangle = example_text("t0-fill/first-triangle.json");
    const std::string lines = example_text("t2-lines/worked-lines.json");
    const std::string cube = example_text("t0-hidden/cube-culled.json");
    const std::string in_thirds = R"({"canvas":{"width":17,"height":14},
        "vertices":{"A":[0,0],"B":[2,3],"C":[4,0]},"triangles":["ABC"],"method":{"scalar":"exact"}})";
    const std::string edge_on = R"({"canvas":{"width":17,"height":14},
        "vertices":{"A":[0,0,0],"B":[1,0,0],"C":[0,1,0]},"triangles":["ABC"],
        "model":[{"rotate":{"axis":"y","degrees":45}},{"rotate":{"axis":"y","degrees":45}}],
        "method":{"scalar":"exact","cull":"back"}})";
    const std::vector<ClaimsWith> cases{
        {"there is no such row: rows are y=-3 to 5", triangle, "y=6: 1, 2\n"},
        {"the trace has no such step `sample`",
         triangle,
         "weights (8,7): 1, 0, 0\n",
         {{"fill", "barycentric"}}},
        {"contradicts line 1", triangle, "A screen: 3, 5\nA screen: 2, 5\n"},
        {"rounded to 2 digits", triangle, "y=4: 1.25, 2.38\n"},
        {"cut off behind 2 digits, not rounded", in_thirds, "y=1: 0.66, ?\n"},
        {"ends early: the first 3 of 8", lines, "AB: 4 0 12\n"},
        {"8 of 9 right; 8 belong", lines, "AB: 4 0 12 8 4 0 12 8 4\n"},
        {"2 of 6 right, 3 follow; ends early: 8 belong", lines, "AB: 4 0 13 9 5 1\n"},
        {"2 of 3 right; ends early: 8 belong", lines, "AB: 4 1 12\n"},
        {"the scene culls nothing", cube, "ABC: culled\n", {{"cull", "none"}}},
        {"left and right are exchanged", example_text("tutorial/filling/whose-slip.json"),
         "y=1: 3, -1/3\n"},
        {"0 too many, 49 missing", triangle,
         "picture:\n..........\n..........\n..........\n..........\n..........\n..........\n"
         "..........\n..........\n..........\n"},
        {"the scene's `double` has 1, exact arithmetic 2",
         example_text("tutorial/numbers/thirds.json"),
         "y=6: -> 2..?\n",
         {{"scalar", "double"}, {"lerp", "incremental"}}},
        {"by the sines and roots as doubles; without rounding it is a tie", edge_on,
         "ABC: culled\n"},
        {"off", triangle, "(1,4): off\n"},
        {"outside", triangle, "(5,5): inside\n"},
        {"none", triangle, "edge BC: 1\n"},
        {"drawn", cube, "ABC: culled\nview ABC: 1/3, 1/3, 3\ndot ABC: -12\ncosine ABC: -1\n"}};
    for (const ClaimsWith& one : cases) {
        const auto english = told_of(check_claims(one.scene, one.claims, one.method));
        EXPECT_THAT(english, testing::Contains(testing::HasSubstr(one.told))) << one.claims;
        const TellingIn portuguese(Language::portuguese);
        expect_other_words(english, told_of(check_claims(one.scene, one.claims, one.method)));
    }
}

/// A formula of each kind, without numbers.
template <std::size_t... kinds>
std::vector<Formula> one_of_each(std::index_sequence<kinds...> /*all*/) {
    return {Formula{std::variant_alternative_t<kinds, decltype(Formula::of)>{}}...};
}

TEST(Language, NoEnglishWordIsLeftInRulesAndSlipsInPortuguese) {
    auto formulas =
        one_of_each(std::make_index_sequence<std::variant_size_v<decltype(Formula::of)>>());
    for (const Rounding rounding : {Rounding::floor, Rounding::nearest, Rounding::truncate,
                                    Rounding::inside, Rounding::half_open})
        formulas.push_back({RoundedEnd{.x = 0, .rule = {.rounding = rounding}}});
    for (const bool other : {false, true})
        for (const Formula& formula : {Formula{IsCulled{0, other}},
                                       {LineForm{{}, {}, other}},
                                       {DepthComparison{0, 0, other}}})
            formulas.push_back(formula);
    const auto told = [&formulas] {
        std::vector<std::string> texts;
        for (const Formula& formula : formulas) {
            texts.emplace_back(rule_of(formula).rule);
            texts.emplace_back(rule_of(formula).formula);
        }
        for (const Slip& slip : slips())
            texts.push_back(meaning_of(slip, "x"));
        return texts;
    };
    const auto english = told();
    const TellingIn portuguese(Language::portuguese);
    expect_other_words(english, told());
}

TEST(Language, AWrongRowInPortuguese) {
    const TellingIn portuguese(Language::portuguese);
    const Checked checked =
        check_claims(example_text("t0-fill/first-triangle.json"), "y=2: -1/4, 25/8 -> 0..3\n");
    const CheckedField& first = checked.claims[0].fields[2];
    EXPECT_EQ(words_for_field(first.name), "primeiro pixel");
    EXPECT_EQ(first.rule, "o extremo de uma linha é arredondado para baixo, até seu pixel");
    EXPECT_EQ(first.slips[0].name, "truncate-for-floor");
    EXPECT_EQ(first.slips[0].meaning, "arredondar em direção a 0, int(x), e não arredondar para "
                                      "baixo, floor(x)");
    EXPECT_EQ(checked.claims[0].working[0],
              "linha y=2   esquerda AB: x = 2 + 3/4 (2 - 5) = -1/4 -> floor -> -1   "
              "direita AC: x = 2 - 3/8 (2 - 5) = 25/8 -> floor -> 3");
}

} // namespace
} // namespace rastertrace
