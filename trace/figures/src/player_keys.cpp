// SPDX-License-Identifier: MIT
#include <rastertrace/figures/player_keys.h>

#include <algorithm>
#include <array>

namespace rastertrace {

namespace {

using enum PlayerAction;

// clang-format off
const std::array table = std::to_array<PlayerKey>({
    {next, "next", {"Right", "l"}, "the next step", true},
    {previous, "previous", {"Left", "h"}, "the previous step", true},
    {next_row, "next-row", {"Down", "j"}, "the next row that begins: a scanline, an along, decide or ray step", true},
    {previous_row, "previous-row", {"Up", "k"}, "the previous row", true},
    {next_of_kind, "next-of-kind", {"]"}, "the next step of the same kind", true},
    {previous_of_kind, "previous-of-kind", {"["}, "the previous step of the same kind", true},
    {next_of_primitive, "next-of-primitive", {")"}, "the next step about the same primitive", true},
    {previous_of_primitive, "previous-of-primitive", {"("}, "the previous step about the same primitive", true},
    {next_primitive, "next-primitive", {"}", "PageDown"}, "the next primitive that begins", true},
    {previous_primitive, "previous-primitive", {"{", "PageUp"}, "the previous primitive", true},
    {next_at_cursor, "next-at-cursor", {"."}, "the next step that touches the cursor's pixel", true},
    {previous_at_cursor, "previous-at-cursor", {","}, "the previous step that touches it", true},
    {first, "first", {"g", "Home"}, "before the first step", true},
    {last, "last", {"G", "End"}, "the last step; after a number, as in 14G, the step of that number, as 14 Enter", true},
    {play, "play", {"Space", "p"}, "play, pause", true},
    {faster, "faster", {"+", "="}, "play twice as fast", true},
    {slower, "slower", {"-"}, "play half as fast", true},
    {search, "search", {"/"}, "search for steps, as in scanline y=2, depth fail, pixel in=ABC, or for words of their sentences", false},
    {next_match, "next-match", {"n"}, "the next step that was searched for", false},
    {previous_match, "previous-match", {"N"}, "the previous step that was searched for", false},
    {breakpoint, "breakpoint", {"b"}, "a breakpoint: playing stops at such steps", false},
    {no_breakpoints, "no-breakpoints", {"B"}, "no breakpoints", false},
    {cursor_left, "cursor-left", {"Shift+Left", "H"}, "the cursor to the left", true},
    {cursor_down, "cursor-down", {"Shift+Down", "J"}, "the cursor down", true},
    {cursor_up, "cursor-up", {"Shift+Up", "K"}, "the cursor up", true},
    {cursor_right, "cursor-right", {"Shift+Right", "L"}, "the cursor to the right", true},
    {cursor_to_step, "cursor-to-step", {"c"}, "the cursor to the step's pixel; no cursor, if it is there", true},
    {next_view, "next-view", {"v"}, "the next view: plotted, faces, shade, ...", true},
    {previous_view, "previous-view", {"V"}, "the previous view", true},
    {overview, "overview", {"o"}, "all of the canvas, many pixels to a cell, or a part of it", false},
    {larger_cells, "larger-cells", {"z"}, "larger cells, for a projector", true},
    {smaller_cells, "smaller-cells", {"Z"}, "smaller cells", true},
    {working, "working", {"w"}, "how the numbers come of one another, or only the sentence", true},
    {working_down, "working-down", {"Ctrl+d"}, "the working further down, where it has no room", false},
    {working_up, "working-up", {"Ctrl+u"}, "the same, back up", false},
    {next_frame, "next-frame", {"f"}, "the next frame of a scene whose numbers vary", true},
    {previous_frame, "previous-frame", {"F"}, "the previous frame", true},
    {read_again, "read-again", {"r"}, "read the file again", false},
    {redraw, "redraw", {"Ctrl+l"}, "draw the screen again", false},
    {help, "help", {"?", "F1"}, "these keys; again for the next page", true},
    {quit, "quit", {"q"}, "leave; in the help, close it", false},
});
// clang-format on

/// Keys that are called otherwise in another language; `Shift`, `Home` and `Enter` are on its keyboards, too.
constexpr std::array words_of_keys{Words{"Right"}, Words{"Left"}, Words{"Up"}, Words{"Down"},
                                   Words{"Space"}};

} // namespace

std::span<const PlayerKey> player_keys() {
    return table;
}

const PlayerKey& key_of(PlayerAction action) {
    return *std::find_if(table.begin(), table.end(),
                         [action](const PlayerKey& row) { return row.action == action; });
}

std::optional<PlayerAction> player_action_of(std::string_view key) {
    for (const PlayerKey& row : table)
        if (std::find(row.keys.begin(), row.keys.end(), key) != row.keys.end())
            return row.action;
    return std::nullopt;
}

std::string told_key(std::string_view key) {
    const std::size_t end =
        key.size() > 1 ? key.rfind('+') + 1 : 0; // of `Shift+`; 0 = npos + 1 without it
    for (const Words& word : words_of_keys)
        if (key.substr(end) == word.in(Language::english))
            return std::string(key.substr(0, end)) + std::string(word.in(language_of_steps()));
    return std::string(key);
}

} // namespace rastertrace
