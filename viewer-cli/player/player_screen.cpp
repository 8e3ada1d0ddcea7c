// SPDX-License-Identifier: MIT
#include "player/player_screen.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/tell/working.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace rastertrace {

namespace {

using TextLines = std::vector<std::string>;

/// Panels stand beside the picture where so many columns are left for them, or on a terminal as wide as that, which
/// then cuts the picture.
constexpr std::size_t least_side = 36;
constexpr std::size_t most_side = 76;
constexpr std::size_t wide = 120;
constexpr std::size_t side_of_wide = 56;

/// Lines above and below the pixels of a picture: blank, coordinates, a legend.
constexpr std::size_t around_grid = 4;

/// A frame with fewer columns or lines cannot be read.
constexpr std::size_t least_columns = 24;
constexpr std::size_t least_lines = 9;

TextLines lines_in(std::string_view text) {
    TextLines lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

void append(TextLines& lines, TextLines more) {
    lines.insert(lines.end(), std::make_move_iterator(more.begin()),
                 std::make_move_iterator(more.end()));
}

/// Steps, a line each, of which one can be clicked.
struct StepList {
    TextLines lines;
    std::size_t first_step = 0;
};

/// The steps around the current one, a line each.
StepList steps_around(const Player& player, std::size_t columns, std::size_t count,
                      ColorDepth colors) {
    const Trace& trace = player.playback().trace();
    const std::size_t here = player.playback().step();
    const std::size_t last = trace.size();
    const std::size_t before = std::min(here, count / 2);
    const std::size_t first = std::min(here - before, last + 1 - std::min(last + 1, count));
    const std::size_t digits = std::to_string(trace.size()).size();
    StepList list{.lines = {}, .first_step = first};
    for (std::size_t n = first; n < first + count && n <= last; ++n) {
        const bool is_here = n == here;
        const std::string& sentence = player.playback().sentence_of(n);
        list.lines.push_back(styled(shortened(fmt::format("{} {:>{}}  {}", is_here ? '>' : ' ',
                                                          trace.number_of(n), digits, sentence),
                                              columns),
                                    {.is_strong = is_here, .is_quiet = !is_here}, colors));
    }
    return list;
}

/// The two numbers of a depth test, one below the other, with whose they are.
TextLines compared_depths(const Replay& replay) {
    const Trace& trace = replay.trace();
    const std::size_t n = replay.step();
    if (n == 0 || trace.kind_of(n) != StepKind::depth)
        return {};
    const auto test = trace.step(n).as<DepthStep>();
    const auto name_of_primitive = [&](std::size_t primitive) {
        return primitive == 0 ? std::string() : printable(name_in(trace.step(primitive)).text());
    };
    const std::size_t stored_by = replay.stored_before();
    const std::array<std::string, 2> names{
        name_of_primitive(replay.primitive()),
        stored_by == 0 ? said("clear") : name_of_primitive(replay.primitive_of(stored_by))};
    const std::array<std::string, 2> numbers{short_number(test.depth.text()),
                                             short_number(test.stored.text())};
    const std::size_t width = std::max(columns_in(names[0]), columns_in(names[1]));
    const std::size_t of_numbers = std::max(numbers[0].size(), numbers[1].size());
    const bool is_stored = stores_depth(test);
    TextLines lines;
    for (std::size_t i = 0; i < 2; ++i)
        lines.push_back(fmt::format("{}  {:>{}}{}", padded(names[i], width), numbers[i], of_numbers,
                                    (i == 0) == is_stored ? said("  <- is kept") : ""));
    return lines;
}

/// How the numbers of the step come of one another.
TextLines lines_of_working(const Player& player, std::size_t columns) {
    TextLines lines;
    for (const std::string& line : compared_depths(player.playback().replay()))
        lines.push_back(shortened(line, columns));
    for (const std::string& line : working_of(player.playback().replay()))
        append(lines, wrapped(line, columns));
    return lines;
}

/// The same, a part of it where there is no room for all. `last` becomes the farthest that it can be scrolled to.
TextLines working_panel(const Player& player, std::size_t columns, std::size_t count,
                        std::size_t& last) {
    last = 0;
    if (!player.has_working() || count == 0)
        return {};
    TextLines lines = lines_of_working(player, columns);
    if (lines.size() <= count)
        return lines;
    last = lines.size() - std::min(lines.size(), count - 1) + 1;
    if (count == 1)
        return {shortened(said("... {} lines of working: Ctrl+d", lines.size()), columns)};
    const std::size_t room = count - 1; // the last line tells the part
    const std::size_t from =
        player.working_from() - std::min<std::size_t>(player.working_from(), 1);
    const std::size_t first = std::min(from, lines.size() - room); // the first key only makes room
    const std::string part = said("... lines {} to {} of {}: Ctrl+d, Ctrl+u",
                                  std::min(first + 1, lines.size()), first + room, lines.size());
    TextLines shown(lines.begin() + static_cast<std::ptrdiff_t>(first),
                    lines.begin() + static_cast<std::ptrdiff_t>(first + room));
    shown.push_back(shortened(part, columns));
    return shown;
}

/// The choices of the trace's header: `fill scanline, rounding floor, ...`.
std::string conventions(const Trace& trace, std::size_t columns) {
    std::vector<std::string> words;
    for (const auto& [key, value] : trace.method.words)
        words.push_back(printable(key + " " + value));
    return shortened(joined(words, ", "), columns);
}

/// What has become of the pixel under the cursor.
TextLines pixel_panel(const Player& player, std::size_t columns, std::size_t count) {
    const PixelQuestion* const question = player.question();
    if (question == nullptr || count == 0)
        return {};
    const std::string name =
        fmt::format("pixel ({}, {})", question->pixel().x, question->pixel().y);
    if (!question->answer())
        return {said("{}: looked at {:.0f} % of the steps", name, 100 * question->share())};
    if (!*question->answer())
        return {shortened(question->answer()->problem().message, columns)};
    const Explanation& answer = question->answer()->value();
    const bool is_at_end = player.playback().step() == player.playback().trace().size();
    TextLines lines =
        wrapped(fmt::format("{}{}: {}", name, is_at_end ? "" : said(", in the end"), answer.answer),
                columns);
    for (const std::string& lack : answer.lacks)
        append(lines, wrapped(lack, columns));
    for (const Try& one : answer.tries)
        lines.push_back(
            shortened(fmt::format("{} {}  {}", one.number == player.playback().step() ? '>' : ' ',
                                  one.number, one.sentence),
                      columns));
    for (const WhyNot& why : answer.why_not)
        append(lines,
               wrapped(said("  not {}: {}", printable(why.primitive), why.sentence), columns));
    if (lines.size() > count) {
        lines.resize(count);
        if (count > 1) // the answer is more than where to find the rest
            lines.back() = shortened(said("  ... (`explain --pixel` tells all)"), columns);
    }
    return lines;
}

/// `[=====>      ]`, with so many columns between the brackets.
std::string bar(double share, std::size_t columns) {
    const auto done = static_cast<std::size_t>(std::lround(share * static_cast<double>(columns)));
    std::string text(columns, ' ');
    std::fill_n(text.begin(), std::min(done, columns), '=');
    if (done > 0 && done < columns)
        text[done] = '>';
    return "[" + text + "]";
}

/// How far one has come, the view, and what goes on.
std::string progress(const Player& player, std::size_t columns) {
    const Playback& playback = player.playback();
    const std::size_t last = playback.trace().size();
    const double share =
        last == 0 ? 1 : static_cast<double>(playback.step()) / static_cast<double>(last);
    std::string right =
        fmt::format("{:.0f} %  {}", std::floor(100 * share), name_of(player.view()));
    if (player.is_playing())
        right += said("  playing, {:g} steps a second", player.steps_per_second());
    if (const auto searched = player.searched())
        right += said("  searching, {:.0f} %, any key ends it", std::floor(100 * *searched));
    if (!player.frame_label().empty())
        right += said("  frame {}", printable(player.frame_label()));
    const std::string left = said("step {} of {} ", playback.step(), last);
    constexpr std::size_t most_bar = 40;
    constexpr std::size_t least_bar = 6;
    const std::size_t taken = left.size() + columns_in(right) + 3;
    const std::size_t room = columns > taken ? std::min(columns - taken, most_bar) : 0;
    return shortened(left + (room >= least_bar ? bar(share, room) + " " : "") + right, columns);
}

/// What is typed, with its end if it is long.
std::string prompt_line(const std::string& prompt, std::size_t columns) {
    const std::string text = printable(prompt) + "_";
    std::string_view end = text;
    while (columns_in(end) > columns)
        end.remove_prefix(first_characters(end, 1).size());
    return std::string(end);
}

/// What is typed, or else what is to be said, what is wrong with the trace, and the keys to begin with.
TextLines last_lines(const Player& player, TextSize size) {
    const std::size_t most_lines = std::min<std::size_t>(3, size.lines / 6 + 1);
    if (const auto prompt = player.prompt())
        return {prompt_line(*prompt, size.columns)};
    TextLines lines;
    const auto& damage = player.playback().trace().damage;
    if (!player.message().empty())
        lines = wrapped(printable(player.message()), size.columns);
    else if (!damage.empty())
        lines = wrapped(
            fmt::format("line {}: {}", damage.front().line, printable(damage.front().message)),
            size.columns);
    lines.resize(std::min(lines.size(), most_lines));
    if (player.message().empty() && lines.size() < most_lines)
        lines.push_back(
            said("? keys   q leave   Right next   Left back   Space play   / search   c cursor"));
    for (std::string& line : lines)
        line = shortened(line, size.columns);
    return lines;
}

/// The pixel that a line goes to next, past its depth test: what a decision decides. Of a circle, the first of its eight.
std::optional<Region> decided_pixel(const Trace& trace, std::size_t n) {
    std::size_t next = n + 1;
    if (next <= trace.size() && trace.kind_of(next) == StepKind::depth)
        ++next;
    if (next > trace.size() || trace.kind_of(next) != StepKind::pixel)
        return std::nullopt;
    const auto pixel = trace.step(next).as<PixelStep>();
    const auto x = static_cast<int>(pixel.x);
    const auto y = static_cast<int>(pixel.y);
    return Region{.x0 = x, .y0 = y, .x1 = x, .y1 = y};
}

/// The pixels of a row that has been found, or that a decision leads to; nothing at any other step.
std::optional<Region> pixels_to_come(const Replay& replay) {
    const Trace& trace = replay.trace();
    const auto kind = replay.step() == 0 ? std::nullopt : trace.kind_of(replay.step());
    if (kind == StepKind::decide || kind == StepKind::along)
        return decided_pixel(trace, replay.step());
    if (kind != StepKind::scanline)
        return std::nullopt;
    const auto row = trace.step(replay.step()).as<ScanlineStep>();
    return row.from > row.to ? std::nullopt
                             : std::optional(Region{.x0 = static_cast<int>(row.from),
                                                    .y0 = static_cast<int>(row.y),
                                                    .x1 = static_cast<int>(row.to),
                                                    .y1 = static_cast<int>(row.y)});
}

/// The frame as `show` prints it; heading and working stand elsewhere.
FrameText frame_options(const Player& player, const ScreenAbility& ability) {
    const Replay& replay = player.playback().replay();
    const bool has_half_blocks =
        player.scale() == 0 && ability.has_unicode && ability.colors >= ColorDepth::palette256;
    return {.caption = describe_step(replay),
            .first_step = replay.step(),
            .last_step = replay.step(),
            .view = player.view(),
            .colors = ability.colors,
            .is_overview = player.is_overview(),
            .has_heading = false,
            .center = player.looks_at_cursor() ? player.cursor() : std::nullopt,
            .cursor = player.cursor(),
            // In a ramp, + is a color.
            .coming = player.view() == View::plotted || player.view() == View::faces
                          ? pixels_to_come(replay)
                          : std::nullopt,
            .scale = std::max<std::size_t>(player.scale().value_or(1), 1),
            .has_half_blocks = has_half_blocks,
            .faces = player.view() == View::faces ? &player.playback().faces() : nullptr};
}

PlayerScreen help_screen(const Player& player, TextSize size) {
    const TextLines all = player_help(size.columns);
    const std::size_t room = std::max<std::size_t>(size.lines, 2) - 1;
    const std::size_t pages = (all.size() + room - 1) / room;
    const std::size_t page = (player.help_page() - 1) % pages; // behind the last is the first
    PlayerScreen screen;
    const std::size_t first = page * room;
    screen.lines.assign(all.begin() + static_cast<std::ptrdiff_t>(first),
                        all.begin() +
                            static_cast<std::ptrdiff_t>(std::min(first + room, all.size())));
    screen.lines.push_back(
        shortened(said("page {} of {}   Space goes on   q closes", page + 1, pages), size.columns));
    return screen;
}

/// A line, and from a column on another one beside it.
std::string beside(const std::string& left, const std::string& right, std::size_t column) {
    if (right.empty())
        return left;
    // Who knows how many columns a line with colors takes? The terminal.
    return left.find('\x1b') == std::string::npos
               ? padded(left, column) + right
               : fmt::format("{}\x1b[{}G{}", left, column + 1, right);
}

} // namespace

std::vector<std::string> player_help(std::size_t columns) {
    std::size_t width = 0;
    std::vector<std::pair<std::string, std::string_view>> rows;
    for (const PlayerKey& row : player_keys()) {
        TextLines keys;
        for (const std::string_view key : row.keys)
            keys.push_back(told_key(key));
        rows.emplace_back(joined(keys, " "), row.does.in(language_of_steps()));
        width = std::max(width, columns_in(rows.back().first));
    }
    TextLines lines;
    for (const auto& [keys, does] : rows) {
        const std::size_t room = std::max<std::size_t>(columns, width + 12) - width - 2;
        std::string front = padded(keys, width) + "  ";
        for (const std::string& line : wrapped(does, room)) {
            lines.push_back(shortened(front + line, columns));
            front.assign(width + 2, ' ');
        }
    }
    append(lines, {"", said("A number in front of a key that goes somewhere: so many times."),
                   said("A click sets the cursor, or goes to a step of the list."),
                   said("The wheel goes on and back.")});
    return lines;
}

namespace {

/// The step and its sentence, where nothing else has room.
PlayerScreen small_screen(const Player& player, TextSize size) {
    const Playback& playback = player.playback();
    TextLines lines{said("{} of {}", playback.step(), playback.trace().size())};
    const std::string sentence = describe_step(player.playback().replay());
    const std::size_t room = std::max<std::size_t>(size.lines, 3) - 2;
    const TextLines in_words = wrapped(sentence, std::max<std::size_t>(size.columns, 1));
    append(lines, in_words.size() <= room ? in_words : TextLines{sentence});
    for (std::string& line : lines)
        line = shortened(line, size.columns);
    lines.resize(std::min(lines.size(), std::max<std::size_t>(size.lines, 2) - 1));
    append(lines, last_lines(player, size));
    lines.resize(std::min(lines.size(), size.lines));
    return {std::move(lines), {}};
}

/// What a whole picture takes; in most views names of vertices stand behind their rows.
std::size_t columns_of_picture(const Canvas& canvas, const FrameText& about) {
    constexpr std::size_t for_names = 12;
    return grid_columns(canvas, about) + 2 + (about.view == View::plotted ? 0 : for_names);
}

/// Columns beside the picture for panels; 0: they stand below it.
std::size_t side_columns(const Canvas& canvas, const FrameText& about, std::size_t columns) {
    const std::size_t taken = columns_of_picture(canvas, about);
    const std::size_t left = columns - std::min(columns, taken);
    if (left >= least_side && !about.is_overview)
        return std::min(left, most_side);
    return columns >= wide ? side_of_wide : 0;
}

/// How large cells can be so that all of the picture fits beside the panels of a wide terminal.
std::size_t fitting_scale(const Canvas& canvas, FrameText about, std::size_t columns,
                          std::size_t lines) {
    about.scale = largest_scale;
    while (about.scale > 1 &&
           (columns_of_picture(canvas, about) + 2 + side_of_wide > columns ||
            static_cast<std::size_t>(canvas.height) * about.scale + around_grid > lines))
        --about.scale;
    return about.scale;
}

/// The panels, each as long as `lines` allows: the working gives way to the steps, these to the pixel. Of the list of
/// steps it tells where it stands among them.
TextLines panels_of(const Player& player, std::size_t columns, std::size_t lines, ColorDepth colors,
                    ScreenPlaces& places) {
    constexpr std::size_t few_steps = 3;
    const TextLines pixel = pixel_panel(player, columns, std::min(lines, lines / 3 + 2));
    std::size_t left = lines - pixel.size();
    const std::size_t gaps = lines >= 10 ? 1 : 0; // a blank line between two panels
    left -= std::min(left, gaps * (pixel.empty() ? 1 : 2));
    // The steps give way to a working that is scrolled.
    const std::size_t for_steps = player.working_from() > 0 ? 1 : few_steps;
    const TextLines working = working_panel(
        player, columns, left > for_steps ? left - for_steps : std::min<std::size_t>(left, 1),
        places.last_working);
    left -= working.size();
    const StepList steps = steps_around(player, columns, left, colors);
    TextLines panels;
    for (const TextLines* panel : {&working, &steps.lines, &pixel}) {
        if (!panels.empty() && !panel->empty() && gaps > 0)
            panels.emplace_back();
        if (panel == &steps.lines)
            places.list = {.first_line = panels.size(),
                           .first_column = 0,
                           .first_step = steps.first_step,
                           .count = steps.lines.size()};
        append(panels, *panel);
    }
    return panels;
}

/// True if nothing has been drawn, and the step draws nothing: the picture gives way to the working.
bool shows_nothing(const Player& player) {
    const Replay& replay = player.playback().replay();
    constexpr StepKindSet outside{StepKind::triangulate, StepKind::matrix, StepKind::vertex,
                                  StepKind::order,       StepKind::face,   StepKind::light,
                                  StepKind::clip,        StepKind::skip,   StepKind::undecided};
    const auto kind = replay.step() == 0 ? std::nullopt : replay.trace().kind_of(replay.step());
    return player.has_working() && kind && outside.has(*kind) && replay.frame().image.drawn() == 0;
}

/// Panels below the picture have so many lines at least, of all that are there.
std::size_t least_below(std::size_t lines) {
    constexpr std::size_t few_lines = 5;
    return lines >= 20 ? few_lines : lines >= 10 ? 3 : lines >= 6 ? 1 : 0;
}

} // namespace

PlayerScreen player_screen(const Player& player, TextSize size, const ScreenAbility& ability) {
    if (player.help_page() > 0)
        return help_screen(player, size);
    if (size.columns < least_columns || size.lines < least_lines)
        return small_screen(player, size);

    const Trace& trace = player.playback().trace();
    FrameText about = frame_options(player, ability);
    if (grid_columns(trace.canvas, about) <= size.columns &&
        static_cast<std::size_t>(trace.canvas.height) + least_lines <= size.lines)
        about.is_overview = false; // all of it fits as it is
    TextLines lines = frame_heading(trace, about, size.columns);
    if (const std::size_t most_lines = size.lines / 3; lines.size() > most_lines) {
        lines.resize(most_lines);
        lines.back() = shortened(lines.back() + " ...", size.columns);
    }
    for (std::size_t i = 1; i < lines.size(); ++i) // the sentence, below the title
        lines[i] = styled(lines[i], {.is_strong = true}, ability.colors);
    TextLines bottom;
    constexpr std::size_t lines_for_conventions = 16;
    if (size.lines >= lines_for_conventions)
        bottom.push_back(
            styled(conventions(trace, size.columns), {.is_quiet = true}, ability.colors));
    bottom.push_back(progress(player, size.columns));
    append(bottom, last_lines(player, size));

    const std::size_t body = size.lines - lines.size() - bottom.size();
    if (!player.scale() && !about.is_overview)
        about.scale = fitting_scale(trace.canvas, about, size.columns, body);
    const std::size_t side = side_columns(trace.canvas, about, size.columns);
    const std::size_t frame_columns =
        side > 0 ? std::min(size.columns - side - 2, columns_of_picture(trace.canvas, about))
                 : size.columns;
    std::size_t most_lines = side > 0 ? body : body - least_below(body);
    if (side == 0 && shows_nothing(player)) {
        constexpr std::size_t for_steps = 5; // and blank lines
        constexpr std::size_t least_picture = around_grid + 3;
        const std::size_t below = lines_of_working(player, size.columns).size() + for_steps;
        const std::size_t room = body - std::min(body, below);
        most_lines = room >= least_picture ? std::min(most_lines, room) : 0;
    }
    // A frame leaves a line for the prompt of a shell, which is not there.
    LaidOutFrame frame;
    if (most_lines > 0)
        frame = laid_out_frame(player.playback().replay(), about, {frame_columns, most_lines + 1});
    TextLines grid = lines_in(frame.text);
    ScreenPlaces places{.scale = about.scale};
    const TextLines panels = panels_of(
        player, side > 0 ? side : size.columns,
        side > 0 ? body - 1 : body - std::min(grid.size(), most_lines), ability.colors, places);
    const std::size_t frame_lines = side > 0 ? body : body - panels.size();
    frame.grid.first_line += lines.size();
    places.grid = frame.grid;
    places.list.first_line += lines.size() + (side > 0 ? 1 : frame_lines);
    places.list.first_column = side > 0 ? frame_columns + 2 : 0;
    grid.resize(frame_lines);
    for (std::string& line : grid)
        if (line.find('\x1b') == std::string::npos) // cells with colors fit
            line = shortened(line, frame_columns);
    if (side > 0)
        for (std::size_t i = 0; i < panels.size(); ++i)
            grid[i + 1] = beside(grid[i + 1], panels[i], frame_columns + 2);
    append(lines, std::move(grid));
    if (side == 0)
        append(lines, panels);
    append(lines, std::move(bottom));
    return {std::move(lines), places};
}

} // namespace rastertrace
