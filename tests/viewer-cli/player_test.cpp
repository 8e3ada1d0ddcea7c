// SPDX-License-Identifier: MIT
// The player without a terminal: what keys do, and what the screen says.

#include "player/player.h"

#include "effort.h"
#include "languages.h"
#include "picture.h"
#include "player/player_screen.h"
#include "random_choice.h"
#include "random_scene.h"
#include "traces.h"

#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/working.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

using ::testing::HasSubstr;

Player player_of(const Scene& scene, const PlayerOptions& options = {}) {
    return Player({.open = [scene](std::size_t) { return trace_of(scene); }}, options);
}

Scene titled_triangle() {
    Scene scene = first_triangle();
    scene.title = "First triangle";
    return scene;
}

void press(Player& player, const std::vector<std::string>& keys) {
    for (const std::string& key : keys)
        player.press({key});
    while (player.work()) {
    }
}

void type(Player& player, const std::string& text) {
    for (const char c : text)
        player.press({c == ' ' ? "Space" : std::string(1, c)});
    press(player, {"Enter"});
}

/// As long as it plays, or a minute.
void play_on(Player& player) {
    for (int i = 0; i < 240 && player.is_playing(); ++i)
        player.pass(0.25);
}

std::size_t step_after(Player& player, const std::vector<std::string>& keys) {
    press(player, keys);
    return player.playback().step();
}

std::string message_after(Player& player, const std::vector<std::string>& keys) {
    press(player, keys);
    return player.message();
}

std::string screen_text(const Player& player, TextSize size = {80, 24}) {
    std::string text;
    for (const std::string& line : player_screen(player, size, {}).lines)
        text += line + "\n";
    return text;
}

StepView step_of(const Player& player) {
    return player.playback().trace().step(player.playback().step());
}

TEST(Player, GoesForwardAndBack) {
    Player player = player_of(first_triangle());
    EXPECT_EQ(player.playback().step(), 0U);
    EXPECT_EQ(step_after(player, {"Right"}), 1U);
    EXPECT_EQ(step_after(player, {"l", "l"}), 3U);
    EXPECT_EQ(step_after(player, {"h"}), 2U);
    EXPECT_EQ(step_after(player, {"1", "0", "Right"}), 12U);
    EXPECT_EQ(step_after(player, {"5", "Left"}), 7U);
    EXPECT_EQ(step_after(player, {"1", "4", "G"}), 14U);
    EXPECT_EQ(step_after(player, {"3", "1", "Enter"}), 31U);
    EXPECT_EQ(step_after(player, {"End"}), 62U);
    EXPECT_EQ(step_after(player, {"Right"}), 62U);
    EXPECT_EQ(player.message(), "this is the last step");
    EXPECT_EQ(step_after(player, {"g"}), 0U);
    EXPECT_EQ(step_after(player, {"Left"}), 0U);
    EXPECT_EQ(player.message(), "nothing is before the first step");
    EXPECT_EQ(step_after(player, {"9", "9", "G"}), 62U);
    EXPECT_EQ(player.message(), "expected a step up to 62, found 99");
}

TEST(Player, FindsRowsKindsAndPrimitives) {
    Player player = player_of(first_triangle());
    press(player, {"Down", "Down"});
    EXPECT_EQ(step_of(player).kind(), StepKind::scanline);
    EXPECT_EQ(y_in(step_of(player)), 4);
    press(player, {"Up"});
    EXPECT_EQ(y_in(step_of(player)), 5);
    press(player, {"3", "j"});
    EXPECT_EQ(y_in(step_of(player)), 2);
    const std::size_t row = player.playback().step();
    EXPECT_EQ(step_after(player, {"Right", "]"}), row + 2); // its second pixel
    EXPECT_EQ(step_after(player, {"["}), row + 1);
    press(player, {"{"});
    EXPECT_EQ(step_of(player).kind(), StepKind::primitive);
    EXPECT_EQ(message_after(player, {"{"}), "no primitive begins that way");
    EXPECT_EQ(step_of(player).kind(), StepKind::primitive);
}

TEST(Player, GoesToTheStepsOfTheSamePrimitive) {
    const Scene scene = scene_in(R"({"canvas":{"width":9,"height":9},
        "vertices":{"A":[0,3],"B":[-3,-2],"C":[3,-2],"D":[4,3]},"triangles":["ABC","ACD"]})");
    Player player = player_of(scene);
    press(player, {"}", "}"});
    EXPECT_EQ(name_in(step_of(player)).text(), "ACD");
    const std::size_t second = player.playback().step();
    EXPECT_EQ(step_after(player, {")"}), second + 1);
    EXPECT_EQ(step_after(player, {"("}), second);
    EXPECT_EQ(step_after(player, {"("}), second);
    EXPECT_EQ(player.message(), "no other step is about ACD that way");
}

TEST(Player, FindsTheStepsOfThePixelUnderTheCursor) {
    Player player =
        player_of(scene_in(R"({"canvas":{"width":9,"height":9},"method":{"depth":"linear-z"},
        "vertices":{"A":[0,3,5],"B":[-3,-2,5],"C":[3,-2,5],"D":[0,3,2],"E":[-3,-2,2],"F":[3,-2,2]},
        "triangles":["ABC","DEF"]})"));
    EXPECT_EQ(message_after(player, {"."}), "there is no cursor: c sets it, or a click");
    press(player, {"c"}); // the middle: nothing is drawn yet
    EXPECT_EQ(player.cursor(), (Pixel{0, 0}));
    std::vector<std::string> kinds;
    for (int i = 0; i < 5; ++i) {
        press(player, {"."});
        if (player.message().empty())
            kinds.push_back(step_of(player).kind_name() + " " +
                            std::to_string(*x_in(step_of(player))));
    }
    EXPECT_EQ(kinds, (std::vector<std::string>{"depth 0", "pixel 0", "depth 0", "pixel 0"}));
    press(player, {"2", ","});
    EXPECT_EQ(step_of(player).kind(), StepKind::pixel);
    press(player, {"L", "J"});
    EXPECT_EQ(player.cursor(), (Pixel{1, -1}));
    press(player, {"c"}); // from elsewhere to the step's pixel
    EXPECT_EQ(player.cursor(), (Pixel{0, 0}));
    press(player, {"c"});
    EXPECT_EQ(player.cursor(), std::nullopt);
}

TEST(Player, AsksWhoDrewThePixel) {
    Player player = player_of(first_triangle());
    press(player, {"1", "4", "G", "Right", "c"});
    ASSERT_NE(player.question(), nullptr);
    ASSERT_TRUE(player.question()->answer());
    const Trace trace = trace_of(first_triangle());
    EXPECT_EQ(player.question()->answer()->value().answer,
              explain(trace, {.about = Topic::pixel, .pixel = {-1, 2}}).value().answer);
    EXPECT_THAT(screen_text(player, {200, 50}),
                HasSubstr("pixel (-1, 2), in the end: drawn by ABC at step 15"));
    press(player, {"H"});
    EXPECT_THAT(screen_text(player, {200, 50}), HasSubstr("not ABC: AB begins row y=2"));
}

TEST(Player, SearchesForSteps) {
    Player player = player_of(first_triangle());
    press(player, {"/"});
    EXPECT_EQ(player.prompt(), "/");
    type(player, "scanline y=2");
    EXPECT_EQ(player.playback().step(), 14U);
    EXPECT_EQ(step_after(player, {"n"}), 14U);
    EXPECT_EQ(player.message(), "no other step that way is scanline y=2");
    type(player, "/scanline");
    EXPECT_EQ(y_in(step_of(player)), 1);
    press(player, {"N", "N"});
    EXPECT_EQ(y_in(step_of(player)), 3);
    type(player, "/scanline y=200");
    EXPECT_EQ(player.message(),
              "expected a step of the trace, found none with y=200; scanline has y: 5, "
              "4, 3, 2, 1, ...");
    type(player, "/scanlines");
    EXPECT_THAT(player.message(), HasSubstr("found scanlines; did you mean scanline?"));
    type(player, "/31");
    EXPECT_EQ(player.playback().step(), 31U);
    press(player, {"/", "x", "Backspace", "Backspace"});
    EXPECT_EQ(player.prompt(), std::nullopt);
}

TEST(Player, PlaysAndStopsAtBreakpoints) {
    Player player = player_of(first_triangle());
    press(player, {"b"});
    type(player, "scanline y=3");
    press(player, {"Space"});
    EXPECT_TRUE(player.is_playing());
    player.pass(0.5); // 4 steps a second
    EXPECT_EQ(player.playback().step(), 2U);
    play_on(player);
    EXPECT_FALSE(player.is_playing());
    EXPECT_EQ(y_in(step_of(player)), 3);
    EXPECT_EQ(player.message(), "breakpoint");
    press(player, {"B", "+", "Space"});
    EXPECT_EQ(player.steps_per_second(), 8);
    player.pass(100); // who was stopped so long has missed nothing
    EXPECT_LE(player.playback().step(), 14U);
    play_on(player);
    EXPECT_EQ(player.playback().step(), 62U);
    EXPECT_FALSE(player.is_playing());
    press(player, {"Space"});
    EXPECT_FALSE(player.is_playing()); // there is nothing to play
}

TEST(Player, ShowsEveryFrameOfASequence) {
    const Scene scene = first_triangle();
    std::vector<std::size_t> opened;
    Player player({.first_frame = 1,
                   .last_frame = 3,
                   .open =
                       [&](std::size_t frame) {
                           opened.push_back(frame);
                           return trace_of(scene);
                       },
                   .label = [](std::size_t frame) { return std::to_string(frame) + " of 3"; }},
                  {});
    EXPECT_EQ(step_after(player, {"1", "4", "G", "f"}), 14U);
    EXPECT_THAT(screen_text(player), HasSubstr("frame 2 of 3"));
    EXPECT_EQ(message_after(player, {"f", "f"}), "this is the last frame");
    EXPECT_EQ(message_after(player, {"F", "F", "F"}), "this is the first frame");
    EXPECT_EQ(opened, (std::vector<std::size_t>{1, 2, 3, 2, 1}));
}

TEST(Player, ChangesWhatIsLookedAt) {
    Player player = player_of(first_triangle());
    std::set<View> views;
    for (std::size_t i = 0; i < view_names().size(); ++i) {
        views.insert(player.view());
        screen_text(player);
        press(player, {"v"});
    }
    EXPECT_EQ(views.size(), view_names().size() - 1); // no depth: there is no buffer
    press(player, {"V", "V"});
    EXPECT_EQ(player.view(), View::coverage); // from the second one back
    press(player, {"z", "z"});
    EXPECT_EQ(player.scale(), 3U);
    press(player, {"Z", "Z", "Z", "Z", "Z"});
    EXPECT_EQ(player.scale(), 0U);
    press(player, {"o", "w"});
    EXPECT_TRUE(player.is_overview());
    EXPECT_FALSE(player.has_working());
    EXPECT_EQ(message_after(player, {"x"}), "x does nothing; ? lists the keys");
}

TEST(Player, BeginsWithTheViewAndTheStepThatWereAskedFor) {
    const Player player =
        player_of(first_triangle(), {.view = View::writes, .step = "scanline y=2"});
    EXPECT_EQ(player.view(), View::writes);
    EXPECT_EQ(player.playback().step(), 14U);
    EXPECT_EQ(player_of(first_triangle(), {.step = "last"}).playback().step(), 62U);
    EXPECT_THROW(player_of(first_triangle(), {.step = "63"}), Problem);
    EXPECT_THROW(player_of(first_triangle(), {.step = "scanline y=200"}), Problem);
    EXPECT_THROW(player_of(first_triangle(), {.step = "scan"}), Problem);
    // Of several, it is not for the player to choose: as for `show`.
    EXPECT_EQ(player_of(first_triangle(), {.step = "first"}).playback().step(), 1U);
    EXPECT_EQ(player_of(first_triangle(), {.step = "pixel x=3 y=2"}).playback().step(), 19U);
    EXPECT_THROW(player_of(first_triangle(), {.step = "scanline"}), Problem);
}

TEST(Player, DoesWhatANumberInFrontSays) {
    Player player = player_of(first_triangle());
    press(player, {"c", "5", "L", "2", "K"});
    EXPECT_EQ(player.cursor(), (Pixel{5, 2}));
    EXPECT_EQ(step_after(player, {"0", "]"}), 1U); // not at all makes no sense: once
    EXPECT_EQ(step_after(player, {"1", "2", "Backspace", "4", "G"}), 14U);
    EXPECT_EQ(message_after(player, {"9", "9", "j"}), "no row begins that way");
    EXPECT_EQ(y_in(step_of(player)), -3); // the last one
}

TEST(Player, LooksAtTheStepUntilTheCursorMoves) {
    Player player = player_of(first_triangle());
    press(player, {"3", "1", "G", "c"});
    EXPECT_FALSE(player.looks_at_cursor());
    press(player, {"L"});
    EXPECT_TRUE(player.looks_at_cursor());
    press(player, {"Right"});
    EXPECT_FALSE(player.looks_at_cursor());
}

TEST(Player, TurnsThePagesOfItsHelp) {
    Player player = player_of(first_triangle());
    press(player, {"?"});
    EXPECT_THAT(screen_text(player), HasSubstr("page 1 of"));
    press(player, {"Space"});
    EXPECT_THAT(screen_text(player), HasSubstr("page 2 of"));
    press(player, {"k"});
    EXPECT_THAT(screen_text(player), HasSubstr("page 1 of"));
    press(player, {"q"});
    EXPECT_EQ(player.help_page(), 0U);
    EXPECT_FALSE(player.wants_to_leave());
    press(player, {"?", "G"});
    EXPECT_EQ(player.help_page(), 0U);
    EXPECT_EQ(player.playback().step(), 62U);
}

TEST(Player, WritesNothingThatATerminalObeys) {
    Player player(
        {.open =
             [](std::size_t) {
                 return readable_trace(
                     "{\"rastertrace\":1,\"title\":\"\\u001b]0;x\",\"canvas\":{\"width\":3,"
                     "\"height\":3}}\n{\"step\":\"\\u001b[2J\",\"name\":\"\\u202e\"}\n{\"end\":{}}"
                     "\n");
             }},
        {});
    press(player, {"Right"});
    for (const char* const typed : {"x", "\x1b[2J", "primitive"}) {
        press(player, {"/"});
        for (const char c : std::string(typed))
            player.press({std::string(1, c)});
        press(player, {"Enter"});
        const std::string text = screen_text(player);
        EXPECT_EQ(text.find('\x1b'), std::string::npos) << text;
        EXPECT_EQ(text.find("\u202e"), std::string::npos) << text;
    }
}

TEST(Player, IsAtTheFrameOfItsStepAfterAnyMoves) {
    const Trace trace = trace_of(first_triangle());
    Player player = player_of(first_triangle());
    std::vector<std::string> keys;
    for (const PlayerKey& row : player_keys())
        if (row.action != PlayerAction::quit && row.action != PlayerAction::search &&
            row.action != PlayerAction::breakpoint)
            keys.insert(keys.end(), row.keys.begin(), row.keys.end());
    for (const char* const more : {"1", "2", "7", "Enter", "Escape", "Click", "", "PageUp"})
        keys.emplace_back(more);
    Random random(11);
    for (int move = 0; move < random_cases(10'000); ++move) {
        const auto key =
            static_cast<std::size_t>(random.whole(0, static_cast<int>(keys.size()) - 1));
        player.press({keys[key]});
        player.work();
        const Replay& replay = player.playback().replay();
        const Frame frame = frame_after(trace, replay.step());
        ASSERT_TRUE(replay.frame().image.colors() == frame.image.colors()) << keys[key];
        ASSERT_TRUE(replay.frame().drawn_by == frame.drawn_by) << keys[key];
    }
}

TEST(Player, HasAScreenOfEverySizeThatFits) {
    std::vector<Scene> scenes{first_triangle()};
    for (std::uint64_t seed = 0; seed < 30; ++seed)
        if (const auto scene = read_scene({"scene.json", RandomScene(seed).text()}))
            scenes.push_back(scene.value().scene);
    Random random(3);
    for (const Scene& scene : scenes) {
        Player player = player_of(scene);
        for (int i = 0; i < 40; ++i) {
            press(player,
                  {random.pick<std::string>({"j", "]", "l", "c", "v", "z", "Z", "o", "L", "}"})});
            const TextSize size{
                static_cast<std::size_t>(random.pick({1, 10, 24, 40, 80, 130, 300})),
                static_cast<std::size_t>(random.pick({1, 3, 7, 12, 24, 50, 100}))};
            const auto screen = player_screen(player, size, {});
            ASSERT_LE(screen.lines.size(), size.lines);
            for (const std::string& line : screen.lines)
                if (line.find('\x1b') == std::string::npos) {
                    ASSERT_LE(columns_in(line), std::max<std::size_t>(size.columns, 5)) << line;
                }
        }
    }
}

TEST(Player, ClicksOnThePixelThatTheScreenShowsThere) {
    Player player = player_of(first_triangle());
    for (const std::vector<std::string>& keys :
         {std::vector<std::string>{"2", "3", "G"}, {"z"}, {"z"}, {"Z", "Z"}}) {
        press(player, keys);
        const TextSize size{80, 24};
        const PlayerScreen screen = player_screen(player, size, {});
        int found = 0;
        for (std::size_t line = 0; line < size.lines; ++line)
            for (std::size_t column = 0; column < size.columns; ++column) {
                const auto pixel =
                    screen.places.grid.pixel_at(line, column, player.playback().trace().canvas);
                if (!pixel)
                    continue;
                ++found;
                player.press({"Click", column, line}, screen.places);
                ASSERT_EQ(player.cursor(), pixel);
                ASSERT_LT(line, screen.lines.size());
                // What stands in the row in front of its cells is its y.
                std::size_t label = line;
                while (screen.lines[label].substr(0, 4).find_first_not_of(" >") ==
                       std::string::npos)
                    ++label; // the first line of a large cell has it
                if (screen.places.grid.cell_lines == 1) {
                    ASSERT_EQ(std::stoi(screen.lines[label].substr(1, 3)), pixel->y);
                }
            }
        EXPECT_GT(found, 0);
    }
}

/// Two triangles, one behind the other.
Scene two_depths() {
    return scene_in(R"({"canvas":{"width":9,"height":9},"method":{"depth":"linear-z"},
        "vertices":{"A":[0,3,5],"B":[-3,-2,5],"C":[3,-2,5],"D":[0,3,6],"E":[-3,-2,6],"F":[3,-2,6]},
        "triangles":["ABC","DEF"]})");
}

TEST(Player, TellsBothDepthsOfATest) {
    Player player = player_of(two_depths());
    type(player, "/depth in=DEF"); // behind the nearer triangle
    EXPECT_THAT(screen_text(player, {100, 30}), HasSubstr("DEF  6"));
    EXPECT_THAT(screen_text(player, {100, 30}), HasSubstr("ABC  5  <- is kept"));
}

TEST(Player, SearchesForWordsOfSentences) {
    Player player = player_of(first_triangle());
    type(player, "/HORIZONTAL, it");
    EXPECT_EQ(step_of(player).as<EdgeStep>().edge, "BC");
    type(player, "/25/8");
    EXPECT_EQ(player.playback().step(), 14U);
    EXPECT_EQ(step_after(player, {"n"}), 14U);
    EXPECT_EQ(player.message(), "no other step that way says \"25/8\"");
    type(player, "/scanlin");
    EXPECT_EQ(player.playback().step(), 20U); // in a sentence
    type(player, "/scanlime");
    EXPECT_THAT(player.message(), HasSubstr("no other step that way says \"scanlime\"; expected"));
}

TEST(Player, ScrollsTheWorkingWhereItHasNoRoom) {
    Player player = player_of(titled_triangle(), {.step = "scanline y=2"});
    const TextSize small{60, 20};
    const std::string lines_of_all = screen_text(player, {200, 60});
    EXPECT_THAT(lines_of_all, HasSubstr("AB is left, AC is right"));
    EXPECT_THAT(screen_text(player, small), HasSubstr("lines of working: Ctrl+d"));
    std::string seen = screen_text(player, small);
    for (int i = 0; i < 20; ++i) {
        press(player, {"Ctrl+d"});
        seen += screen_text(player, small);
    }
    for (const char* const line :
         {"left AB: x = (x2", "right AC: x = (x2", "AB is left, AC is right"})
        EXPECT_THAT(seen, HasSubstr(line));
    press(player, {"9", "9", "Ctrl+u"});
    EXPECT_THAT(screen_text(player, small), HasSubstr("lines of working: Ctrl+d"));
    EXPECT_THAT(screen_text(player, {80, 24}), HasSubstr("left AB: x = (x2"));
}

TEST(Player, AnEmptyPictureHidesNoWorking) {
    Player player = player_of(scene_in(
        R"({"canvas":{"width":41,"height":21},"vertices":{"A":[0,1,-3],"B":[-1,-1,-3],"C":[1,-1,-3]},
            "triangles":["ABC"],"projection":{"type":"frustum","fov_y":90,"near":1,"far":9},
            "light":{"direction":[0,0,-1]},"method":{"shade":"lambert"},"keep":["model"]})"));
    const Trace& trace = player.playback().trace();
    std::size_t seen = 0;
    for (std::size_t n = 1; n <= trace.size() && trace.kind_of(n) != StepKind::edge; ++n) {
        press(player, {"l"});
        ASSERT_EQ(player.playback().step(), n);
        const auto working = working_of(player.playback().replay());
        if (working.empty() || trace.kind_of(n) == StepKind::primitive)
            continue;
        ++seen;
        constexpr std::size_t least_shown = 20; // characters of a line
        EXPECT_THAT(screen_text(player, {40, 12}),
                    HasSubstr(working.front().substr(0, least_shown)))
            << n;
        for (const std::string& line : working)
            EXPECT_THAT(screen_text(player, {80, 30}), HasSubstr(line.substr(0, least_shown))) << n;
    }
    EXPECT_GT(seen, 10U);
}

TEST(Player, GoesToAStepOfTheListThatIsClicked) {
    for (const TextSize size : {TextSize{80, 24}, TextSize{200, 60}}) {
        Player player = player_of(first_triangle(), {.step = "20"});
        const PlayerScreen screen = player_screen(player, size, {});
        const auto& list = screen.places.list;
        ASSERT_GT(list.count, 2U);
        for (std::size_t i = 0; i < list.count; ++i)
            EXPECT_THAT(screen.lines[list.first_line + i].substr(list.first_column),
                        HasSubstr(fmt::format(" {}  ", list.first_step + i)));
        player.press({"Click", list.first_column + 3, list.first_line + 1}, screen.places);
        EXPECT_EQ(player.playback().step(), list.first_step + 1);
    }
}

TEST(Player, ShowsTheFrameWithTheWorkingAndTheStepsBesideIt) {
    Player player = player_of(titled_triangle(), {.step = "scanline y=2"});
    EXPECT_EQ(screen_text(player, {100, 24}),
              R"(First triangle                                                    step 14 of 62
scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/4 -> floor -> -1   right AC: x = 2 - 3/8 (2 - 5) =
25/8 -> floor -> 3

     -8-7-6-5-4-3-2-1 0 1 2 3 4 5 6 7 8   left AB: x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = (-4 -
  7   . . . . . . . . . . . . . . . . .   2)/(-3 - 5) (2 - 5) + 2 = 3/4 (-3) + 2 = -1/4 -> floor ->
  6   . . . . . . . . . . . . . . . . .   -1
  5   . . . . . . . . . . A . . . . . .   right AC: x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = (5 -
  4   . . . . . . . . . # # . . . . . .   2)/(-3 - 5) (2 - 5) + 2 = (-3/8) (-3) + 2 = 25/8 -> floor
  3   . . . . . . . . # # # . . . . . .   -> 3
> 2   . . . . . . . + + + + + . . . . .   -1/4 < 25/8: AB is left, AC is right
  1   . . . . . . . . . . . . . . . . .   x = -1 to 3: 3 - (-1) + 1 = 5 pixels
  0   . . . . . . . . . . . . . . . . .
 -1   . . . . . . . . . . . . . . . . .     10  scanline y=3   left AB: x = 2 + 3/4 (3 - 5) = 1/2...
 -2   . . . . . . . . . . . . . . . . .     11  pixel (0, 3)   row y=3: 0 to 2
 -3   . . . . b . . . . . . . . c . . .     12  pixel (1, 3)   row y=3: 0 to 2
 -4   . . . . . . . . . . . . . . . . .     13  pixel (2, 3)   row y=3: 0 to 2
 -5   . . . . . . . . . . . . . . . . .   > 14  scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/...
 -6   . . . . . . . . . . . . . . . . .     15  pixel (-1, 2)   row y=2: -1 to 3
                                            16  pixel (0, 2)   row y=2: -1 to 3
+ to come                                   17  pixel (1, 2)   row y=2: -1 to 3
scalar exact, fill scanline, rounding floor, lerp direct
step 14 of 62 [=========>                              ] 22 %  plotted
? keys   q leave   Right next   Left back   Space play   / search   c cursor
)");
}

TEST(PlayerKeys, EachDoesOneThingAndIsInTheHelp) {
    std::set<std::string_view> seen;
    for (const PlayerKey& row : player_keys()) {
        EXPECT_EQ(key_of(row.action).name, row.name);
        ASSERT_FALSE(row.keys.empty());
        for (const std::string_view key : row.keys) {
            EXPECT_TRUE(seen.insert(key).second) << key;
            EXPECT_EQ(player_action_of(key), row.action);
        }
    }
    for (const Language language : {Language::english, Language::portuguese}) {
        const TellingIn telling(language);
        const std::vector<std::string> help = player_help(80);
        for (const PlayerKey& row : player_keys())
            EXPECT_THAT(joined(help, "\n"),
                        HasSubstr(std::string(row.does.in(language).substr(0, 30))));
        for (const std::string& line : help)
            EXPECT_LE(columns_in(line), 80U);
    }
}

TEST(PlayerKeys, AreCalledAsOnAKeyboardOfTheLanguage) {
    EXPECT_EQ(told_key("Shift+Right"), "Shift+Right");
    const TellingIn portuguese(Language::portuguese);
    EXPECT_EQ(told_key("Shift+Right"), "Shift+Direita");
    EXPECT_EQ(told_key("Space"), "Espaço");
    for (const char* const same : {"PageDown", "PageUp", "Home", "Ctrl+d", "+", "l"})
        EXPECT_EQ(told_key(same), same);
    EXPECT_EQ(player_help(79).front(), "Direita l         o próximo passo");
}

/// Words that only the player says, in English.
const std::set<std::string> english_words_of_player{
    "all",     "answer",  "background", "breakpoint", "breakpoints", "cells",  "clear",
    "dark",    "far",     "frame",      "keys",       "leave",       "light",  "many",
    "near",    "next",    "or",         "others",     "outside",     "pass",   "play",
    "playing", "reading", "right",      "tells",      "removed",     "search", "searching"};

class PlayerInPortuguese : public ::testing::Test {
protected:
    /// Looks at all that it says.
    static void hear(const Player& player) {
        const auto kinds = step_kind_names();
        std::set<std::string> words_of_trace(kinds.begin(), kinds.end());
        for (const auto& [key, value] : player.playback().trace().method.words)
            for (const std::string& word : split_at(key + " " + value, ' '))
                words_of_trace.insert(word);
        const auto look_at = [&words_of_trace](const std::string& line) {
            for (const std::string& word : split(line).words)
                EXPECT_TRUE(
                    words_of_trace.contains(word) ||
                    (!english_words.contains(word) && !english_words_of_player.contains(word)))
                    << word << " in: " << line;
        };
        look_at(player.message());
        for (const TextSize size : {TextSize{200, 60}, {80, 24}, {40, 20}, {20, 8}})
            for (const std::string& line : player_screen(player, size, {}).lines) {
                look_at(line);
                if (player.help_page() == 0) {
                    EXPECT_LE(columns_in(line), size.columns) << line;
                }
            }
    }

    /// The same after each of some keys.
    static void hear(Player& player, const std::vector<std::string>& keys) {
        for (const std::string& key : keys) {
            press(player, {key});
            hear(player);
        }
    }

private:
    TellingIn portuguese_{Language::portuguese};
};

TEST_F(PlayerInPortuguese, NothingIsEnglishWhateverIsPressed) {
    Player player = player_of(first_triangle());
    hear(player);
    // Where there is nothing to go to.
    hear(player, {"Left", "n", ".", "B", "(", "f", "x", "Space"});
    EXPECT_THAT(screen_text(player), HasSubstr("  rodando, 4 passos/s"));
    EXPECT_THAT(screen_text(player), HasSubstr("? teclas  q sai  Direita avança  Esquerda volta  "
                                               "Espaço roda  / busca  c cursor\n"));
    hear(player, {"Escape", "9", "9", "G", "Right", "g", "Left", "9", "9", "j", "{", "{", "]"});
    EXPECT_EQ(player.message(), "não há outro passo primitive nessa direção");
    hear(player, {"9", "9", ")", "1", "4", "G", "+", "-", "Ctrl+d", "Ctrl+u"});
    // A pixel, drawn and not drawn.
    hear(player, {"Right", "c", ".", "9", "9", ".", "H", ".", "End", "c", "c"});
    // Searching, and breakpoints.
    hear(player, {"/"});
    type(player, "scanline y=5");
    EXPECT_EQ(player.message(), "dos passos assim (1), nenhum está adiante; N vai ao anterior");
    hear(player, {"N", "n"});
    type(player, "/25/8");
    hear(player, {"n"});
    EXPECT_EQ(player.message(), "nenhum outro passo nessa direção diz \"25/8\"");
    hear(player, {"b"});
    EXPECT_EQ(player.prompt(), "parar em: ");
    type(player, "scanline y=3");
    hear(player, {"g", "b"});
    type(player, "scanline y=4");
    hear(player);
    press(player, {"Space"});
    play_on(player);
    EXPECT_EQ(player.message(), "ponto de parada");
    hear(player, {"B"});
    // The pages of the help, and views.
    hear(player, {"?", "Space", "Space", "Space", "Space", "Space", "Space", "q"});
    hear(player, {"1", "4", "G", "z", "z", "Z", "Z", "o"});
    for (std::size_t i = 0; i < view_names().size(); ++i)
        hear(player, {"v"});
}

TEST_F(PlayerInPortuguese, BothDepthsOfATest) {
    Player player = player_of(two_depths());
    type(player, "/depth in=DEF");
    EXPECT_THAT(screen_text(player, {100, 30}), HasSubstr("ABC  5  <- fica"));
    for (std::size_t i = 0; i < view_names().size(); ++i)
        hear(player, {"v"});
    hear(player, {"c"});
}

TEST_F(PlayerInPortuguese, SamplesAndFaces) {
    for (const auto& [name, kind] :
         {std::pair("t3-sweep-and-box/barycentric", "sample"), {"t0-hidden/cube-culled", "face"}}) {
        std::ifstream file(std::string(RASTERTRACE_EXAMPLES "/") + name + ".json");
        Scene scene = scene_in({std::istreambuf_iterator<char>(file), {}});
        scene.title.clear(); // it is English
        Player player = player_of(scene);
        type(player, std::string("/") + kind);
        for (int i = 0; i < 12; ++i)
            hear(player, {"]"});
        hear(player, {"End", "c", "v", "v"});
    }
}

TEST_F(PlayerInPortuguese, Frames) {
    Player frames({.first_frame = 1,
                   .last_frame = 2,
                   .open = [](std::size_t) { return trace_of(first_triangle()); },
                   .label = [](std::size_t frame) { return std::to_string(frame) + " de 2"; }},
                  {});
    hear(frames, {"F"});
    EXPECT_EQ(frames.message(), "este é o primeiro quadro");
    hear(frames, {"f", "f"});
    EXPECT_EQ(frames.message(), "este é o último quadro");
    EXPECT_THAT(screen_text(frames), HasSubstr("  quadro 2 de 2"));
}

TEST_F(PlayerInPortuguese, WhatGoesOnInALongTrace) {
    std::string text =
        "{\"rastertrace\":1,\"title\":\"T\",\"canvas\":{\"width\":3,\"height\":3}}\n";
    for (int i = 0; i < 60'000; ++i)
        text += "{\"step\":\"pixel\",\"x\":0,\"y\":0}\n";
    text += "{\"end\":{}}\n";
    Player player({.open = [text](std::size_t) { return readable_trace(text); }}, {});
    const auto press_only = [&player](const std::vector<std::string>& keys) {
        for (const std::string& key : keys)
            player.press({key}); // and nothing is gone through
        hear(player);
    };
    press_only({"c"});
    EXPECT_THAT(screen_text(player), HasSubstr("pixel (0, 0): vistos "));
    press_only({"g", "/", "q", "q", "Enter"});
    EXPECT_THAT(screen_text(player), HasSubstr("  busca, 0 %, uma tecla encerra"));
    press_only({"Escape"});
}

} // namespace
} // namespace rastertrace
