// SPDX-License-Identifier: MIT
// What a page holds: the program's own sentences, answers and pixels, and nothing that a browser obeys.

#include "effort.h"
#include "page_parts.h"
#include "traces.h"

#include <rastertrace/figures/page.h>
#include <rastertrace/trace/explain/explain.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/working.h>
#include <rastertrace/trace/text/color_text.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {
namespace {

using Json = nlohmann::json;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

/// Reads the data of a page as the page does.
class PageReader {
public:
    explicit PageReader(const Trace& trace) : data_(Json::parse(page_data(trace))) {
        std::size_t place = 0;
        for (const Json& kind : data_["step_kinds"]) {
            fills_.push_back(place);
            place += data_["kinds"][kind.get<std::size_t>()].size() - 2;
        }
    }

    const Json& data() const { return data_; }
    std::size_t count() const { return fills_.size(); }
    std::string word(const Json& place) const {
        return data_["words"][place.get<std::size_t>()].get<std::string>();
    }
    std::string kind(std::size_t n) const { return kind_row(n)[0].get<std::string>(); }

    std::string sentence(std::size_t n) const {
        const Json& pieces = kind_row(n);
        std::string text = pieces[1].get<std::string>();
        for (std::size_t i = 2; i < pieces.size(); ++i)
            text += word(data_["fills"][fills_[n - 1] + i - 2]) + pieces[i].get<std::string>();
        const Json marks = data_.value("marks", Json::array());
        for (std::size_t i = 0; i < marks.size(); i += 2)
            if (marks[i] == n)
                text += word(marks[i + 1]);
        return text;
    }

    std::vector<std::string> working(std::size_t n) const {
        std::vector<std::string> lines;
        for (const Json& line : data_["working"][n - 1])
            lines.push_back(word(line));
        return lines;
    }

    /// The answers about all pixels, from the upper left one on; none if the canvas is too large.
    std::vector<Explanation> answers() const {
        std::vector<Explanation> answers;
        if (data_["answers"].is_null())
            return answers;
        const Json& list = data_["answers"]["pixels"];
        std::size_t place = 0;
        const auto sentence = [&] {
            const Json& pieces = data_["answers"]["patterns"][list[place++].get<std::size_t>()];
            std::string text = pieces[0].get<std::string>();
            for (std::size_t i = 1; i < pieces.size(); ++i)
                text += word(list[place++]) + pieces[i].get<std::string>();
            return text;
        };
        while (place < list.size()) {
            Explanation& one = answers.emplace_back();
            one.answer = sentence();
            one.pixels.resize(list[place++].get<std::size_t>()); // how many there are in all
            for (auto told = list[place++].get<std::size_t>(); told > 0; --told) {
                WhyNot& why = one.why_not.emplace_back();
                why.primitive = word(list[place++]);
                why.reason = word(list[place++]);
                why.sentence = sentence();
            }
            for (auto lines = list[place++].get<std::size_t>(); lines > 0; --lines)
                one.lacks.push_back(word(list[place++]));
        }
        return answers;
    }

private:
    const Json& kind_row(std::size_t n) const {
        return data_["kinds"][data_["step_kinds"][n - 1].get<std::size_t>()];
    }

    Json data_;
    std::vector<std::size_t> fills_; ///< where those of each step begin
};

struct Example {
    std::string file;
    Trace trace;
    PageReader page;
};

/// The traces of all examples that have a page; those of more steps take too long here.
const std::vector<Example>& examples() {
    static const std::vector<Example> all = [] {
        constexpr auto most_steps = random_cases<std::size_t>(8'000);
        std::vector<Example> list;
        for (const std::string& file : example_files()) {
            std::ifstream text(file);
            auto read = read_scene({file, {std::istreambuf_iterator<char>(text), {}}});
            if (!read)
                continue;
            Trace trace = trace_of(read.value().scene);
            if (too_large_for_page(trace) || trace.size() > most_steps)
                continue;
            PageReader page(trace);
            list.push_back({file, std::move(trace), std::move(page)});
        }
        return list;
    }();
    return all;
}

Trace hostile_trace(const std::string& title, const std::string& name) {
    return readable_trace(
        R"({"rastertrace":1,"title":)" + Json(title).dump() +
        R"(,"canvas":{"width":3,"height":3,"origin":"center"},"method":{},"steps":[
{"step":"primitive","kind":"triangle","name":)" +
        Json(name).dump() + R"(,"vertices":[)" + Json(name).dump() +
        R"(,"B","C"],"at":[[0,0],[1,0],[0,1]],"color":"#000000"},
{"step":"pixel","x":0,"y":0}
],"end":{"steps":2}})");
}

std::string page_of_trace(const Trace& trace) {
    const std::vector<PageFrame> frames{{.label = "", .data = page_data(trace)}};
    return page_of(frames, {.title = trace.title});
}

TEST(Page, MarksWrongStepsAsShowDoes) {
    Trace trace = hostile_trace("A", "A");
    EXPECT_FALSE(PageReader(trace).data().contains("marks"));
    using Texts = std::map<std::size_t, std::string>;
    trace.numbers_give = std::make_shared<const Texts>(Texts{{1, "to = -1"}, {2, "from = <b>"}});
    const PageReader page(trace);
    Replay replay(trace, {.depths = true});
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        replay.go_to(n);
        EXPECT_EQ(page.sentence(n), describe_step(replay));
    }
    EXPECT_THAT(page.sentence(1), EndsWith("   [!] its numbers give to = -1"));
    EXPECT_THAT(page.sentence(2), EndsWith("   [!] its numbers give from = <b>"));
}

TEST(Page, EverySentenceAndWorkingOfEveryExampleIsTheProgramsOwn) {
    ASSERT_GT(examples().size(), 30U);
    std::set<std::string> kinds;
    for (const Example& example : examples()) {
        const PageReader& page = example.page;
        ASSERT_EQ(page.count(), example.trace.size());
        Replay replay(example.trace, {.depths = true});
        for (std::size_t n = 1; n <= page.count(); ++n) {
            replay.go_to(n);
            ASSERT_EQ(page.sentence(n), describe_step(replay)) << example.file;
            ASSERT_EQ(page.working(n), working_of(replay)) << example.file;
            kinds.insert(page.kind(n));
        }
    }
    EXPECT_GE(kinds.size(), 16U);
}

TEST(Page, WhyPixelsAreNotDrawnIsWhatExplainSays) {
    constexpr std::size_t most_work = all_cases(400'000); // a pixel is asked of the whole trace
    std::set<std::string> reasons;
    std::size_t scenes = 0;
    for (const Example& example : examples()) {
        const PageReader& page = example.page;
        const auto answers = page.answers();
        const Canvas& canvas = example.trace.canvas;
        const auto width = static_cast<std::size_t>(canvas.width);
        if (answers.empty())
            continue;
        ASSERT_EQ(answers.size(), width * static_cast<std::size_t>(canvas.height));
        ++scenes;
        const std::size_t stride = 1 + answers.size() * page.count() / most_work;
        for (std::size_t i = 0; i < answers.size(); i += stride) {
            const Pixel pixel{canvas.left() + static_cast<int>(i % width),
                              canvas.y_of(static_cast<int>(i / width))};
            Explanation told =
                explain(example.trace, {.about = Topic::pixel, .pixel = pixel}).value();
            ASSERT_EQ(answers[i].answer, told.answer) << example.file << " " << told.question;
            ASSERT_EQ(answers[i].lacks, told.lacks);
            ASSERT_EQ(answers[i].pixels.size(), told.why_not.size());
            if (told.why_not.size() > most_why_not_told)
                std::stable_sort(told.why_not.begin(), told.why_not.end(), was_nearer_to_drawing);
            ASSERT_EQ(answers[i].why_not.size(), std::min(told.why_not.size(), most_why_not_told));
            for (std::size_t k = 0; k < answers[i].why_not.size(); ++k) {
                ASSERT_EQ(answers[i].why_not[k].primitive, told.why_not[k].primitive);
                ASSERT_EQ(answers[i].why_not[k].reason, told.why_not[k].reason);
                ASSERT_EQ(answers[i].why_not[k].sentence, told.why_not[k].sentence);
                reasons.insert(told.why_not[k].reason);
            }
        }
    }
    EXPECT_GT(scenes, 25U);
    for (const std::string reason : {"outside", "elsewhere", "hidden", "culled"})
        EXPECT_TRUE(reasons.contains(reason)) << reason;
}

TEST(Page, ThePixelsAndDepthsOfEveryExampleCanBePlayed) {
    for (const Example& example : examples()) {
        const PageReader& page = example.page;
        const Frame frame = [&] {
            Replay replay(example.trace, {.writes = true, .depths = true});
            replay.go_to(example.trace.size());
            return std::move(replay).frame();
        }();
        std::vector<std::size_t> drawn_by(frame.drawn_by.size()), stored_by(drawn_by.size());
        std::vector<std::string> colors(drawn_by.size());
        std::size_t pixels = 0, depths = 0;
        for (std::size_t n = 1; n <= page.count(); ++n) {
            const Json& at = page.data()["at"][n - 1];
            const bool is_pixel = page.kind(n) == "pixel";
            const bool is_depth = page.kind(n) == "depth";
            if (is_pixel && at != -1) {
                drawn_by[at.get<std::size_t>()] = n;
                colors[at.get<std::size_t>()] = page.word(page.data()["pixels"][pixels]);
            }
            if (is_depth && at != -1 &&
                page.data()["depths"][3 * depths].get<int>() >= 2) // it is stored
                stored_by[at.get<std::size_t>()] = n;
            pixels += is_pixel ? 1 : 0;
            depths += is_depth ? 1 : 0;
        }
        for (std::size_t i = 0; i < drawn_by.size(); ++i) {
            ASSERT_EQ(drawn_by[i], frame.drawn_by[i]) << example.file;
            ASSERT_EQ(stored_by[i], frame.stored_by[i]) << example.file;
            if (drawn_by[i] != 0) {
                ASSERT_EQ(colors[i], to_text(frame.image.colors()[i])) << example.file;
            }
        }
        EXPECT_EQ(page.data()["pixels"].size(), pixels);
        EXPECT_EQ(page.data()["depths"].size(), 3 * depths);
    }
}

TEST(Page, NothingInATraceEndsAnElementOfThePage) {
    const std::string hostile = "</script><img src=x onerror=alert(1)>{{data}}<!--";
    const auto count = [](const std::string& text, std::string_view what) {
        std::size_t times = 0;
        for (std::size_t at = text.find(what); at != std::string::npos;
             at = text.find(what, at + 1))
            ++times;
        return times;
    };
    const std::string tame = page_of_trace(hostile_trace("A", "A"));
    const Trace trace = hostile_trace(hostile, hostile);
    const std::vector<PageFrame> frames{
        {.label = hostile, .data = page_data(trace), .file = hostile}};
    const std::string page =
        page_of(frames, {.title = hostile, .module = "var a;", .scene = {.text = hostile}});
    EXPECT_EQ(count(page, "</script"), count(tame, "</script") + 1); // that of the module
    EXPECT_EQ(count(page, "<img"), count(tame, "<img"));             // that of a comment
    EXPECT_EQ(count(page, "<!--"), count(tame, "<!--"));
    EXPECT_EQ(count(page, "<script type=\"text/plain\">"), 1U);
    EXPECT_THAT(page,
                HasSubstr("<title>&lt;/script&gt;&lt;img src=x onerror=alert(1)&gt;{{data}}"));
}

TEST(Page, WhatCanBeMovedIsOnThePageAlsoWithoutTheModule) {
    // tests/page/check_page.cjs tries to move it.
    const std::vector<PageFrame> frames{{.data = page_data(hostile_trace("A", "A"))}};
    for (const std::string module : {"", "var a;"})
        EXPECT_THAT(
            page_of(frames, {.module = module, .scene = {.text = "{}", .is_movable = true}}),
            HasSubstr(R"("scene":"{}","movable":true)"));
    EXPECT_THAT(page_of(frames, {}), Not(HasSubstr(R"("scene":)")));
}

TEST(Page, WhatATerminalObeysIsShown) {
    const std::string name = "A\x1b]0;x\a\u202e";
    const PageReader page(hostile_trace(name, name));
    EXPECT_EQ(page.data()["title"], "A<U+001B>]0;x<U+0007><U+202E>");
    EXPECT_EQ(page.sentence(1), "triangle A<U+001B>]0;x<U+0007><U+202E>   "
                                "A<U+001B>]0;x<U+0007><U+202E> (0, 0)   B (1, 0)   C (0, 1)");
    const std::string html = page_of_trace(hostile_trace(name, name));
    EXPECT_TRUE(std::none_of(html.begin(), html.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20 && c != '\n';
    }));
}

TEST(Page, ATraceThatIsDamagedOrFromALaterProgramHasAPage) {
    const PageReader cut(readable_trace(
        R"({"rastertrace":1,"title":"Cut","canvas":{"width":3,"height":3,"origin":"center"},"method":{"mood":"calm"},"steps":[
{"step":"primitive","kind":"triangle","name":"A","vertices":["A","B","C"],"color":"#000000","later":[1]},
{"step":"blur","x":1,"y":1,"radius":2},
{"step":"pixel","x":0,"y":0},
{"step":"pixel","x":700,"y":0},
{"step":"pi)"));
    ASSERT_EQ(cut.count(), 4U);
    EXPECT_EQ(cut.sentence(2), R"({"step":"blur","x":1,"y":1,"radius":2})");
    EXPECT_EQ(cut.data()["at"], Json({-1, 2, 4, -1}));
    EXPECT_EQ(cut.sentence(4), "pixel (700, 0)   not on the canvas, not drawn");
    EXPECT_GE(cut.data()["notes"].size(), 1U);
    EXPECT_THAT(cut.word(cut.data()["notes"][0]), Not(HasSubstr("trace.json")));
    ASSERT_EQ(cut.answers().size(), 9U);
    EXPECT_THAT(cut.answers()[0].lacks, testing::SizeIs(1));
}

TEST(Page, TellsWhatAStepIsAboutIfItIsNoPixel) {
    const Trace trace = readable_trace(R"({"rastertrace":1,
"canvas":{"width":8,"height":4,"origin":"top-left"},"steps":[
{"step":"primitive","kind":"polygon","name":"ABC","vertices":["A","B","C"],"at":[[0,0],[4,3],[0,3]]},
{"step":"edge","edge":"BA"},
{"step":"crossings","y":2,"edges":[],"x":[],"winding":[]},
{"step":"reject","x":-3,"to_x":1,"y":1,"why":"off-canvas"},
{"step":"clip","name":"DEF","plane":"near"},
{"step":"primitive","kind":"triangle","name":"DEF/1","part":true,"vertices":[]}
],"end":{"steps":6}})");
    const std::string data = page_data(trace, {}, nullptr);
    // Step, columns, rows: of the row y = 2, and of what is left of the run.
    EXPECT_THAT(data, testing::HasSubstr("\"areas\":[3,0,7,2,2,4,0,1,1,1]"));
    EXPECT_THAT(data, testing::HasSubstr("\"about\":[5,6]"));
    EXPECT_THAT(data, testing::HasSubstr("\"edges\":[1,0]"));
}

TEST(Page, FarPlacesAreNumbersThatJsonHas) {
    const Trace trace = readable_trace(
        R"({"rastertrace":1,"canvas":{"width":3,"height":3,"origin":"center"},"method":{"fill":"scanline"},"steps":[
{"step":"primitive","kind":"triangle","name":"ABC","vertices":["A","B","C"],"at":[["1)" +
        std::string(400, '0') + R"(","0"],["0","1"],["-1","-1"]],"color":"#000000"},
{"step":"edge","edge":"AB","dx_dy":null},
{"step":"scanline","y":9007199254740991,"left":"-1","right":"1)" +
        std::string(400, '0') + R"(","from":-9007199254740991,"to":9007199254740991}
],"end":{"steps":3}})");
    const PageReader page(trace);
    EXPECT_EQ(page.data()["primitives"][5][0], 1e9);
    EXPECT_EQ(page.data()["rows"][0], -1);
    EXPECT_EQ(page.data()["edges"], Json({0, 1}));
}

TEST(Page, TheSameTraceMakesTheSameBytes) {
    const Trace& trace = examples().front().trace;
    EXPECT_EQ(page_of_trace(trace), page_of_trace(trace));
}

TEST(Page, WhatIsTooLargeIsRefusedWithWhatToDoInstead) {
    Trace trace = hostile_trace("A", "A");
    EXPECT_FALSE(too_large_for_page(trace));
    trace.canvas = {.width = 2048, .height = 1024};
    EXPECT_EQ(to_text(*too_large_for_page(trace)),
              "expected at most 1048576 pixels for a page, found 2048 x 1024\n"
              "hint: a .png or .svg shows it, or a page of the scene on a smaller canvas");
    trace.canvas = {.width = 129, .height = 1};
    EXPECT_TRUE(PageReader(trace).data()["answers"].is_null());
    trace.canvas = {.width = 128, .height = 1};
    EXPECT_FALSE(PageReader(trace).data()["answers"].is_null());
}

TEST(Page, ItsFilesAreAscii) {
    for (const std::string& text :
         {page_html(), element_html(), element_css(), element_js(), player_js()})
        EXPECT_TRUE(
            std::all_of(text.begin(), text.end(), [](char c) { return ' ' <= c || c == '\n'; }));
}

TEST(Page, AThemeThatIsChosenIsTheOnlyOne) {
    const std::vector<PageFrame> frames{{.label = "", .data = page_data(hostile_trace("A", "A"))}};
    const std::string dark = page_of(frames, {.theme = Theme::dark});
    EXPECT_THAT(dark, HasSubstr("<raster-trace whole-page theme=\"dark\">"));
    EXPECT_THAT(dark, HasSubstr("\nhtml{background:#15181d}\n"));
    EXPECT_THAT(page_of(frames, {}),
                HasSubstr("@media (prefers-color-scheme:dark){html{background:#15181d}}"));
    EXPECT_THAT(page_of(frames, {}), HasSubstr("<raster-trace whole-page>"));
}

} // namespace
} // namespace rastertrace
