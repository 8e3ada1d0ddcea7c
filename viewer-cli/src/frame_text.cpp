// SPDX-License-Identifier: MIT
#include "frame_text.h"

#include <rastertrace/trace/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

/// The longest title line, and the width that plain output is laid out for.
constexpr std::size_t page_columns = 79;

/// Lines around the grid: title, caption, two blank ones, the coordinates, and the prompt below.
constexpr std::size_t lines_around_grid = 6;

/// Columns and rows of the canvas, counted from its left and top.
struct Window {
    int first_column = 0;
    int columns = 0;
    int first_row = 0;
    int rows = 0;
};

std::size_t length_of(int number) {
    return fmt::formatted_size("{}", number);
}

/// Where in `all` places to begin to show `shown` of them, so that `center` is in the middle.
int window_start(int all, int shown, int center) {
    return std::clamp(center - shown / 2, 0, all - shown);
}

/// What fits, around the pixel that is looked at.
Window visible_part(const Canvas& canvas, TextSize size, std::size_t margin, std::size_t cell,
                    std::optional<Pixel> center) {
    const auto fitting = [](std::size_t room, std::size_t taken, std::size_t each, int all) {
        const std::size_t count = room > taken ? (room - taken) / each : 0;
        return static_cast<int>(std::clamp<std::size_t>(count, 1, static_cast<std::size_t>(all)));
    };
    Window window;
    window.columns = fitting(size.columns, margin, cell, canvas.width);
    window.rows = fitting(size.lines, lines_around_grid, 1, canvas.height);
    const Pixel middle{canvas.left() + canvas.width / 2, canvas.y_of(canvas.height / 2)};
    const Pixel pixel = center.value_or(middle);
    window.first_column = window_start(canvas.width, window.columns, pixel.x - canvas.left());
    window.first_row =
        window_start(canvas.height, window.rows, static_cast<int>(canvas.row_of(pixel.y)));
    return window;
}

/// The x along the top, each above its column; where they would touch, only every 2nd, 5th, 10th,
/// ...
std::string column_labels(const Canvas& canvas, const Window& window, std::size_t margin,
                          std::size_t cell) {
    const int first_x = canvas.left() + window.first_column;
    const int last_x = first_x + window.columns - 1;
    // A label and a gap before it; the sign of a negative one is gap enough.
    const int largest = std::max(std::abs(first_x), std::abs(last_x));
    const std::size_t needed = length_of(largest) + 1;
    int every = 1;
    for (const int factor : {2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000})
        if (static_cast<std::size_t>(every) * cell < needed)
            every = factor;

    std::string line(margin, ' ');
    for (int x = first_x; x <= last_x; ++x) {
        line.append(cell, ' ');
        if (x % every != 0)
            continue;
        const std::string label = std::to_string(x);
        if (label.size() <= line.size())
            line.replace(line.size() - label.size(), label.size(), label);
    }
    return line.substr(0, line.find_last_not_of(' ') + 1);
}

/// The letters of the current primitive's vertices that lie on a pixel: those with one-letter
/// names.
std::map<std::size_t, std::string> vertex_letters(const Replay& replay) {
    std::map<std::size_t, std::string> letters;
    if (replay.primitive() == 0)
        return letters;
    const StepView step = replay.trace().step(replay.primitive());
    const auto names = step.texts("vertices");
    const auto places = step.text_rows("at");
    const auto whole = [](const std::string& text) -> std::optional<int> {
        int value = 0;
        const char* const end = text.data() + text.size();
        const auto read = std::from_chars(text.data(), end, value);
        if (read.ec != std::errc{} || read.ptr != end)
            return std::nullopt;
        return value;
    };
    const Canvas& canvas = replay.trace().canvas;
    for (std::size_t i = 0; i < names.size() && i < places.size(); ++i) {
        if (places[i].size() < 2 || characters_in(names[i]) != 1 || columns_in(names[i]) != 1 ||
            printable(names[i]) != names[i])
            continue;
        const auto x = whole(places[i][0]);
        const auto y = whole(places[i][1]);
        if (x && y && canvas.contains(*x, *y))
            letters.emplace(canvas.offset_of({*x, *y}), names[i]);
    }
    return letters;
}

/// The pixel that was drawn last, if any.
std::optional<Pixel> newest_pixel(const Frame& frame) {
    const Canvas& canvas = frame.image.canvas();
    const auto newest = std::max_element(frame.drawn_by.begin(), frame.drawn_by.end());
    if (*newest == 0)
        return std::nullopt;
    const auto offset = static_cast<int>(newest - frame.drawn_by.begin());
    return Pixel{canvas.left() + offset % canvas.width, canvas.y_of(offset / canvas.width)};
}

/// The row that a step is about, if it is about one.
std::optional<Index> row_of_step(const Trace& trace, std::size_t n) {
    return n == 0 ? std::nullopt : trace.step(n).whole("y");
}

/// The title, and on the right which steps the frame shows.
std::string title_line(const Trace& trace, const FrameText& about, std::size_t columns) {
    const std::string steps =
        about.first_step == about.last_step
            ? fmt::format("step {} of {}", about.last_step, trace.size())
            : fmt::format("steps {} to {} of {}", about.first_step, about.last_step, trace.size());
    const std::size_t width = std::clamp(columns, steps.size() + 5, page_columns);
    const std::size_t room = width - steps.size() - 2;
    const std::string title = shortened(printable(trace.title), room);
    return fmt::format("{}{:>{}}", title, steps, width - columns_in(title));
}

} // namespace

std::string frame_text(const Replay& replay, const FrameText& about, TextSize size) {
    const Canvas& canvas = replay.trace().canvas;
    const Frame& frame = replay.frame();

    // How wide: a mark and the longest y in front of each row, then one or two characters a pixel.
    const std::size_t label_width =
        std::max<std::size_t>({3, 1 + length_of(canvas.top()), 1 + length_of(canvas.bottom())});
    const std::size_t margin = label_width + 2;
    const std::size_t page = std::min(size.columns, page_columns + 1);
    const std::size_t cell = margin + 2 * static_cast<std::size_t>(canvas.width) <= page ? 2 : 1;

    // Which row is meant, and which part of the canvas is looked at.
    const std::optional<Pixel> newest = newest_pixel(frame);
    const std::optional<Index> current_row = row_of_step(replay.trace(), about.first_step);
    const auto letters = vertex_letters(replay);
    const Window window = visible_part(canvas, size, margin, cell, newest);

    std::string text =
        fmt::format("{}\n{}\n", title_line(replay.trace(), about, size.columns), about.caption);
    if (window.columns < canvas.width || window.rows < canvas.height)
        text += fmt::format(
            "(x {} to {}, y {} to {} of a canvas of {} x {})\n",
            canvas.left() + window.first_column,
            canvas.left() + window.first_column + window.columns - 1, canvas.y_of(window.first_row),
            canvas.y_of(window.first_row + window.rows - 1), canvas.width, canvas.height);
    text += "\n" + column_labels(canvas, window, margin, cell) + "\n";

    for (int row = window.first_row; row < window.first_row + window.rows; ++row) {
        const int y = canvas.y_of(row);
        std::string line = fmt::format("{:>{}}  ", y, label_width);
        if (current_row == y)
            line[0] = '>';
        for (int column = 0; column < window.columns; ++column) {
            const std::size_t offset =
                canvas.offset_of({canvas.left() + window.first_column + column, y});
            const auto letter = letters.find(offset);
            const std::size_t drawn_by = frame.drawn_by[offset];
            line.append(cell - 1, ' ');
            if (drawn_by != 0 && drawn_by >= about.first_step)
                line += '@';
            else if (letter != letters.end())
                line += letter->second;
            else
                line += drawn_by != 0 ? '#' : '.';
        }
        text += line + "\n";
    }
    return text;
}

std::string bare_frame_text(const Frame& frame) {
    const Canvas& canvas = frame.image.canvas();
    std::string text;
    text.reserve(frame.drawn_by.size() + static_cast<std::size_t>(canvas.height));
    for (int row = 0; row < canvas.height; ++row) {
        for (int x = canvas.left(); x <= canvas.right(); ++x)
            text += frame.drawn_by[canvas.offset_of({x, canvas.y_of(row)})] != 0 ? '#' : '.';
        text += '\n';
    }
    return text;
}

} // namespace rastertrace
