// SPDX-License-Identifier: MIT
#include "frames/frame_text.h"

#include "frames/off_canvas.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/digest.h>
#include <rastertrace/trace/tell/shown_steps.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/tell/told_samples.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// The longest title line, and the width that plain output is laid out for.
constexpr std::size_t page_columns = 79;

/// Lines around the grid beside title, caption and legend: a blank one, the coordinates, and the prompt below.
constexpr std::size_t lines_around_grid = 3;

/// What a cell takes, with the gap beside it.
struct CellSize {
    std::size_t columns;
    std::size_t lines;
};

using Window = FrameWindow;

std::size_t length_of(int number) {
    return std::to_string(number).size();
}

/// Where in `all` places to begin to show `shown` of them, so that `center` is in the middle.
int window_start(int all, int shown, int center) {
    return std::clamp(center - shown / 2, 0, all - shown);
}

/// How many cells of `each` columns or lines there is room for, 1 to `all`.
int fitting(std::size_t room, std::size_t taken, std::size_t each, int all) {
    const std::size_t count = room > taken ? (room - taken) / each : 0;
    return static_cast<int>(std::clamp<std::size_t>(count, 1, static_cast<std::size_t>(all)));
}

/// Columns in front of the cells: a mark and the longest y, and two blanks.
std::size_t margin_of(const Canvas& canvas) {
    return 2 +
           std::max<std::size_t>({3, 1 + length_of(canvas.top()), 1 + length_of(canvas.bottom())});
}

/// What fits, around the pixel that is looked at. `taken` are the lines around the grid.
Window window_around(const Canvas& canvas, TextSize size, std::size_t margin, CellSize cell,
                     std::size_t taken, std::optional<Pixel> center) {
    Window window;
    window.columns = fitting(size.columns, margin, cell.columns, canvas.width);
    window.rows = fitting(size.lines, taken, cell.lines, canvas.height);
    const Pixel middle{canvas.left() + canvas.width / 2, canvas.y_of(canvas.height / 2)};
    const Pixel pixel = center.value_or(middle);
    window.first_column = window_start(canvas.width, window.columns, pixel.x - canvas.left());
    window.first_row =
        window_start(canvas.height, window.rows, static_cast<int>(canvas.row_of(pixel.y)));
    return window;
}

/// The same where a character has two pixels, one above the other.
Window window_of_half_blocks(const Canvas& canvas, TextSize size, std::size_t margin,
                             std::size_t taken, std::optional<Pixel> center) {
    const Canvas half{canvas.width, (canvas.height + 1) / 2, Origin::top_left};
    if (center)
        center = Pixel{center->x - canvas.left(), static_cast<int>(canvas.row_of(center->y)) / 2};
    Window window = window_around(half, size, margin, {1, 1}, taken, center);
    window.first_row *= 2;
    window.block_height = 2;
    return window;
}

/// A part of the canvas that was asked for.
Window window_of(const Canvas& canvas, const Region& region) {
    const auto top = static_cast<int>(std::min(canvas.row_of(region.y0), canvas.row_of(region.y1)));
    const auto bottom =
        static_cast<int>(std::max(canvas.row_of(region.y0), canvas.row_of(region.y1)));
    return {.first_column = region.x0 - canvas.left(),
            .columns = region.x1 - region.x0 + 1,
            .first_row = top,
            .rows = bottom - top + 1};
}

/// All of the canvas, in blocks twice as high as wide, as characters are.
Window overview_of(const Canvas& canvas, TextSize size, std::size_t margin, std::size_t taken) {
    const bool is_page = size.columns == TextSize().columns;
    const int columns = fitting(is_page ? page_columns : size.columns, margin, 1, canvas.width);
    const int lines = fitting(size.lines, taken, 1, canvas.height);
    const auto blocks = [](int pixels, int each) { return (pixels + each - 1) / each; };
    Window window;
    while (blocks(canvas.width, window.block_width) > columns ||
           blocks(canvas.height, window.block_height) > lines) {
        ++window.block_width;
        window.block_height = 2 * window.block_width;
    }
    window.columns = blocks(canvas.width, window.block_width);
    window.rows = blocks(canvas.height, window.block_height);
    return window;
}

/// The x along the top, each above its column; where they would touch, only every 2nd, 5th, 10th,
/// ...
std::string column_labels(const Canvas& canvas, const Window& window, std::size_t margin,
                          std::size_t cell) {
    const int first_x = canvas.left() + window.first_column;
    const int last_x = first_x + (window.columns - 1) * window.block_width;
    // A label and a gap before it; the sign of a negative one is gap enough.
    const int largest = std::max(std::abs(first_x), std::abs(last_x));
    const std::size_t needed = length_of(largest) + 1;
    int every = 1;
    for (const int factor : {2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000})
        if (static_cast<std::size_t>(every) * cell < needed)
            every = factor;

    std::string line(margin, ' ');
    for (int column = 0; column < window.columns; ++column) {
        line.append(cell, ' ');
        const int x = first_x + column * window.block_width;
        if ((window.block_width == 1 ? x : column) % every != 0)
            continue;
        const std::string label = std::to_string(x);
        if (label.size() <= line.size())
            line.replace(line.size() - label.size(), label.size(), label);
    }
    return line.substr(0, line.find_last_not_of(' ') + 1);
}

/// A vertex of the primitive, at the nearest pixel of the canvas.
struct VertexMark {
    Pixel pixel;
    std::string name;
};

/// Those of the primitive of a step, or the one vertex that the step is about.
std::vector<VertexMark> vertex_marks(const Replay& replay, std::size_t step,
                                     const StepSubject& subject) {
    std::vector<VertexMark> marks;
    const Trace& trace = replay.trace();
    const std::size_t primitive = subject.primitive;
    if (step != 0 && trace.kind_of(step) == StepKind::vertex && subject.pixels)
        marks.push_back({{subject.pixels->x0, subject.pixels->y0},
                         printable(name_in(trace.step(step)).text())});
    if (primitive == 0)
        return marks;
    const auto current = trace.step(primitive).as<PrimitiveStep>();
    const auto names = current.vertices.texts();
    const auto positions = current.at.values();
    for (std::size_t i = 0; i < names.size() && i < positions.size(); ++i) {
        const auto pixel = pixel_at(trace, positions[i]);
        if (!pixel)
            continue;
        // One that another primitive hides does not shine through; at a corner of both, it is that one's too.
        const std::size_t drawn_by = replay.frame().drawn_by[trace.canvas.offset_of(*pixel)];
        const auto has_it_too = [&](std::size_t other) {
            if (other == 0)
                return false;
            const auto corners = trace.step(other).as<PrimitiveStep>().vertices.texts();
            return std::find(corners.begin(), corners.end(), names[i]) != corners.end();
        };
        if (drawn_by == 0 || drawn_by >= primitive || has_it_too(replay.primitive_of(drawn_by)))
            marks.push_back({*pixel, printable(names[i])});
    }
    return marks;
}

/// The mark of a vertex in `plotted`: its letter, a small one where its pixel is not drawn.
std::string letter_of(const std::string& name, bool is_drawn) {
    if (columns_in(name) != 1)
        return is_drawn ? "*" : "'";
    if (is_drawn)
        return name;
    const bool is_capital = name.size() == 1 && 'A' <= name[0] && name[0] <= 'Z';
    return is_capital ? std::string(1, static_cast<char>(name[0] - 'A' + 'a')) : "'";
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

/// Words in lines of at most so many columns.
std::string legend_lines(const std::vector<std::string>& words, std::size_t columns) {
    std::string text, line;
    for (const std::string& word : words) {
        if (!line.empty() && columns_in(line) + 2 + columns_in(word) > columns) {
            text += line + "\n";
            line.clear();
        }
        line += (line.empty() ? "" : "  ") + word;
    }
    return line.empty() ? text : text + line + "\n";
}

/// A sentence in one line, if the terminal has one as long, else in lines.
std::vector<std::string> caption_lines(const std::string& caption, std::size_t columns) {
    return columns_in(caption) <= columns ? std::vector{caption} : wrapped(caption, columns);
}

/// How many lines of a terminal some lines take: what is longer than a line goes on in the next.
std::size_t lines_on_terminal(std::string_view text, std::size_t columns) {
    std::size_t lines = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines +=
            std::max<std::size_t>(1, (columns_in(text.substr(0, end)) + columns - 1) / columns);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

/// Which part of the canvas is shown, or in which blocks; nothing if it is all of it.
std::string part_text(const Canvas& canvas, const FrameText& about, const Window& window) {
    if (about.is_overview)
        return said("(1 cell = {}x{} pixels, the most frequent of those drawn)\n",
                    window.block_width, window.block_height);
    if (window.columns == canvas.width && window.rows * window.block_height >= canvas.height)
        return {};
    return said(
        "(x {} to {}, y {} to {} of a canvas of {} x {})\n", canvas.left() + window.first_column,
        canvas.left() + window.first_column + window.columns - 1, canvas.y_of(window.first_row),
        canvas.y_of(std::min(window.first_row + window.rows * window.block_height, canvas.height) -
                    1),
        canvas.width, canvas.height);
}

/// The title, and on the right which steps the frame shows.
std::string title_line(const Trace& trace, const FrameText& about, std::size_t columns) {
    const std::string steps = steps_text(trace, {about.first_step, about.last_step});
    const std::size_t width = std::clamp(columns, steps.size() + 5, page_columns);
    const std::string title = title_of(trace, width - steps.size() - 2);
    return fmt::format("{}{:>{}}", title, steps, width - columns_in(title));
}

bool has(const Region& region, Pixel pixel) {
    return region.has_row(pixel.y) && region.meets(pixel.x, pixel.x);
}

/// What stands in a cell of the frame, and how it is marked.
struct MarkedCell {
    std::string text;
    Style style = {};
    bool is_new = false;    ///< between brackets
    bool is_cursor = false; ///< between parentheses
};

/// The cells of a frame with their marks.
class MarkedCells {
public:
    MarkedCells(const Replay& replay, const FrameText& about, std::size_t room)
        : replay_(replay), about_(about), cells_(about.view, replay, room, about.faces),
          not_drawn_(pixels_not_drawn(replay.trace(), {about.first_step, about.last_step})),
          subject_(subject_of(replay, about.first_step)) {
        const Trace& trace = replay.trace();
        if (about.first_step == 0)
            subject_.primitive = replay.primitive(); // of the whole picture
        if (subject_.edge) {
            const auto at = trace.step(subject_.primitive).as<PrimitiveStep>().at.values();
            for (const std::size_t end : *subject_.edge)
                if (const auto pixel = pixel_at(trace, at[end]))
                    ends_of_edge_.insert(trace.canvas.offset_of(*pixel));
        }
        if (about.view == View::plotted)
            for (const VertexMark& mark : vertex_marks(replay, about.first_step, subject_)) {
                const std::size_t offset = replay.trace().canvas.offset_of(mark.pixel);
                const bool is_marked = vertices_.emplace(offset, mark.name).second;
                const bool is_shown =
                    !about.is_overview && (!about.region || has(*about.region, mark.pixel));
                if (is_marked && is_shown && columns_in(mark.name) != 1)
                    long_names_.push_back(mark);
            }
    }

    std::size_t width() const { return cells_.width(); }
    const StepSubject& subject() const { return subject_; }

    std::vector<std::string> legend() const {
        auto legend = cells_.legend();
        if (!not_drawn_.empty())
            legend.push_back(said("x tested, not drawn"));
        if (about_.coming)
            legend.push_back(said("+ to come"));
        for (const VertexMark& mark : long_names_)
            legend.push_back(fmt::format(
                "{} {} ({}, {})",
                letter_of(mark.name,
                          replay_.frame().drawn_by[replay_.trace().canvas.offset_of(mark.pixel)] !=
                              0),
                mark.name, mark.pixel.x, mark.pixel.y));
        return legend;
    }

    /// The cell of a block of pixels: the most frequent one that is drawn, else an empty one.
    MarkedCell at(const Window& window, int row, int column) const {
        const Canvas& canvas = replay_.trace().canvas;
        const int left = canvas.left() + window.first_column + column * window.block_width;
        const int top = window.first_row + row * window.block_height;
        if (window.block_width == 1 && window.block_height == 1)
            return with_cursor(at({left, canvas.y_of(top)}), {left, canvas.y_of(top)});
        const int right = std::min(left + window.block_width - 1, canvas.right());
        const int end_row = std::min(top + window.block_height, canvas.height);
        std::map<std::string, int> counts;
        MarkedCell most{"."};
        for (int y = top; y < end_row; ++y) {
            const auto* const drawn_by =
                &replay_.frame().drawn_by[canvas.offset_of({left, canvas.y_of(y)})];
            for (int x = left; x <= right; ++x) {
                if (drawn_by[x - left] == 0)
                    continue;
                const MarkedCell cell = at({x, canvas.y_of(y)});
                const int count = ++counts[cell.text];
                if (count > counts[most.text])
                    most = cell;
            }
        }
        most.is_new = false;
        return most;
    }

    /// The cell of a single pixel, in a row of the canvas, which need not have it.
    MarkedCell in_row(const Window& window, int row, int column) const {
        const Canvas& canvas = replay_.trace().canvas;
        if (row >= canvas.height)
            return {"."};
        const Pixel pixel{canvas.left() + window.first_column + column, canvas.y_of(row)};
        return with_cursor(at(pixel), pixel);
    }

private:
    MarkedCell with_cursor(MarkedCell cell, Pixel pixel) const {
        cell.is_cursor = about_.cursor == pixel;
        cell.style.is_cursor = cell.is_cursor;
        return cell;
    }

    /// The cell of a pixel.
    MarkedCell at(Pixel pixel) const {
        const std::size_t offset = replay_.trace().canvas.offset_of(pixel);
        const std::size_t drawn_by = replay_.frame().drawn_by[offset];
        const bool is_new = about_.first_step != 0 && drawn_by >= about_.first_step;
        const bool is_marked =
            is_new || (!subject_.is_row && subject_.has(pixel)) || ends_of_edge_.count(offset) != 0;
        if (not_drawn_.count(offset) != 0)
            return {"x"};
        if (is_new && about_.view == View::plotted)
            return {"@", {.is_reversed = true}};
        if (const auto vertex = vertices_.find(offset); vertex != vertices_.end())
            return {
                letter_of(vertex->second, drawn_by != 0), {.is_reversed = is_marked}, is_marked};
        if (about_.coming && drawn_by == 0 && has(*about_.coming, pixel))
            return {"+"};
        Cell cell = cells_.at(pixel);
        return {
            std::move(cell.text), {.background = cell.color, .is_reversed = is_marked}, is_marked};
    }

    const Replay& replay_;
    const FrameText& about_;
    FrameCells cells_;
    std::set<std::size_t> not_drawn_;             ///< offsets of pixels
    StepSubject subject_;                         ///< of the first step
    std::set<std::size_t> ends_of_edge_;          ///< that it is about, the same
    std::map<std::size_t, std::string> vertices_; ///< names by offset, in `plotted`
    std::vector<VertexMark> long_names_;          ///< those that do not fit a cell
};

/// A character for a pixel and the one below it, each in the color that the view shows, or none.
std::string half_block(const MarkedCell& upper, const MarkedCell& lower, ColorDepth colors) {
    const auto color = [](const MarkedCell& cell) -> std::optional<Color> {
        constexpr Color cursor{255, 255, 0};
        constexpr Color marked{255, 0, 255};
        constexpr Color drawn{200, 200, 200};
        return cell.is_cursor                         ? std::optional(cursor)
               : cell.style.is_reversed               ? std::optional(marked)
               : cell.style.background                ? cell.style.background
               : cell.text == "." || cell.text == "+" ? std::nullopt
                                                      : std::optional(drawn);
    };
    const auto above = color(upper);
    const auto below = color(lower);
    if (!above)
        return below ? styled("▄", {.foreground = below}, colors) : "·";
    return styled("▀", {.background = below, .foreground = above}, colors);
}

/// The brackets that stand in front of a cell, in the gap that has one character.
char bracket_between(const MarkedCell& before, const MarkedCell& after) {
    if (after.is_cursor)
        return '(';
    if (before.is_cursor)
        return ')';
    if (before.is_new != after.is_new)
        return after.is_new ? '[' : ']';
    return ' ';
}

/// A line of a cell that takes several lines and columns. A sign fills it, `.` and words stand in its middle.
std::string line_of_cell(const MarkedCell& cell, std::size_t line, std::size_t width,
                         std::size_t lines) {
    const std::size_t columns = columns_in(cell.text);
    const bool is_middle = line == lines / 2;
    if (lines > 1 && columns == 1 && cell.text != ".")
        return std::string(width, cell.text.front());
    if (lines > 1 && (!is_middle || columns > width))
        return std::string(width, ' ');
    const std::size_t behind = lines > 1 ? (width - columns) / 2 : 0;
    return std::string(width - behind - columns, ' ') + cell.text + std::string(behind, ' ');
}

/// A line of a row of cells. Where there are gaps and no colors, new ones stand between brackets and the cursor's
/// between parentheses; without gaps it is `+`.
std::string line_of_cells(const std::vector<MarkedCell>& cells, std::size_t width, bool has_gaps,
                          std::size_t line, std::size_t lines, ColorDepth colors) {
    std::string text;
    const bool has_brackets = colors == ColorDepth::none;
    MarkedCell before;
    for (const MarkedCell& cell : cells) {
        if (has_gaps)
            text += has_brackets ? bracket_between(before, cell) : ' ';
        if (lines == 1 && !cell.style.is_cursor)
            text.append(width - columns_in(cell.text), ' ');
        std::string written = lines == 1 && !cell.style.is_cursor
                                  ? cell.text
                                  : line_of_cell(cell, line, width, lines);
        if (cell.is_cursor && has_brackets && !has_gaps)
            written.assign(width, '+');
        text += styled(written, cell.style, colors);
        before = cell;
    }
    const char last = bracket_between(before, {});
    return has_gaps && has_brackets && last != ' ' ? text + last : text;
}

} // namespace

std::optional<Pixel> pixel_looked_at(const Replay& replay, std::size_t n) {
    if (const auto pixels = subject_of(replay, n).pixels)
        return Pixel{(pixels->x0 + pixels->x1) / 2, (pixels->y0 + pixels->y1) / 2};
    return newest_pixel(replay.frame());
}

std::string title_of(const Trace& trace, std::size_t columns) {
    const std::string mistake = trace.method.word_of("mistake");
    const std::string marked = mistake.empty() ? "" : said(", with {}", mistake);
    return shortened(printable(trace.title), columns - std::min(columns, marked.size())) + marked;
}

std::vector<std::string> frame_heading(const Trace& trace, const FrameText& about,
                                       std::size_t columns) {
    std::vector<std::string> lines{title_line(trace, about, columns)};
    for (std::string& line : caption_lines(about.caption, columns))
        lines.push_back(std::move(line));
    return lines;
}

std::size_t grid_columns(const Canvas& canvas, const FrameText& about) {
    const auto columns = static_cast<std::size_t>(canvas.width);
    return margin_of(canvas) + (about.has_half_blocks ? columns : 2 * about.scale * columns + 1);
}

LaidOutFrame laid_out_frame(const Replay& replay, const FrameText& about, TextSize size) {
    const Canvas& canvas = replay.trace().canvas;

    // How wide: a mark and the longest y in front of each row, then the cells, with gaps if they fit.
    const std::size_t margin = margin_of(canvas);
    const std::size_t label_width = margin - 2;
    const std::size_t page = size.columns == TextSize().columns ? page_columns + 1 : size.columns;
    const auto columns = static_cast<std::size_t>(
        about.region ? about.region->x1 - about.region->x0 + 1 : canvas.width);
    const std::size_t room = page > margin ? (page - margin) / columns : 0;
    const MarkedCells cells(replay, about, about.is_overview || room == 0 ? 0 : room - 1);
    const bool is_large = about.scale > 1 && !about.is_overview;
    const bool has_gaps = is_large || (!about.is_overview && cells.width() < room);
    const std::size_t scale = is_large ? about.scale : 1;
    const std::size_t width = is_large ? std::max(cells.width(), 2 * scale - 1) : cells.width();
    const bool has_half_blocks = about.has_half_blocks && !about.is_overview && !about.region;
    const CellSize cell{has_half_blocks ? 1 : width + (has_gaps ? 1 : 0), scale};

    std::string legend = legend_lines(cells.legend(), std::min(page, page_columns));
    if (!legend.empty())
        legend.insert(0, "\n");

    std::string text;
    if (about.has_heading) {
        for (const std::string& line : frame_heading(replay.trace(), about, size.columns))
            text += line + "\n";
        for (const std::string& line : about.working)
            text += fmt::format("    {}\n", line);
    }
    // Which rows are meant, and which part of the canvas is looked at.
    const StepSubject& subject = cells.subject();
    const Index own_row =
        about.first_step == 0
            ? canvas.y_of(canvas.height)
            : y_in(replay.trace().step(about.first_step)).value_or(canvas.y_of(canvas.height));
    const auto is_meant = [&](Index y) {
        return subject.pixels ? subject.pixels->has_row(y) : y == own_row;
    };
    const bool is_around_step = !about.is_overview && !about.region;
    const auto center = about.center     ? about.center
                        : is_around_step ? pixel_looked_at(replay, about.first_step)
                                         : std::optional<Pixel>();
    const auto window_below = [&](std::size_t lines) {
        return about.is_overview ? overview_of(canvas, size, margin, lines)
               : about.region    ? window_of(canvas, *about.region)
               : has_half_blocks ? window_of_half_blocks(canvas, size, margin, lines, center)
                                 : window_around(canvas, size, margin, cell, lines, center);
    };
    // The line that tells the part takes a row itself. Where not even one row fits, the legend has to go.
    const auto window_beside = [&](const std::string& legend_lines) {
        const std::size_t taken = lines_around_grid + lines_on_terminal(text, page) +
                                  lines_on_terminal(legend_lines, page) +
                                  lines_on_terminal(about.below, page);
        const auto lines_of_part = [&](const Window& window) {
            return lines_on_terminal(part_text(canvas, about, window), page);
        };
        Window window = window_below(taken);
        if (const std::size_t lines = lines_of_part(window); lines > 0)
            window = window_below(taken + lines);
        const std::size_t rows = static_cast<std::size_t>(window.rows) * cell.lines;
        return std::pair(window, taken + lines_of_part(window) + rows <= size.lines);
    };
    if (!window_beside(legend).second && !about.region)
        legend.clear();
    const Window window = window_beside(legend).first;
    text += part_text(canvas, about, window);
    text += "\n" + column_labels(canvas, window, margin, cell.columns) + "\n";
    const FrameGrid grid{.window = window,
                         .first_line =
                             static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')),
                         .first_column = margin,
                         .cell_columns = cell.columns,
                         .cell_lines = cell.lines};

    // Where cells cannot show vertices, their names stand behind their rows.
    std::map<Index, std::string> names_in_row;
    if (about.view != View::plotted)
        for (const VertexMark& mark : vertex_marks(replay, about.first_step, subject)) {
            const int column = mark.pixel.x - canvas.left() - window.first_column;
            if (0 <= column && column < window.columns * window.block_width)
                names_in_row[canvas.row_of(mark.pixel.y)] +=
                    fmt::format("  {} x={}", mark.name, mark.pixel.x);
        }

    for (int row = 0; row < window.rows; ++row) {
        const int first = window.first_row + row * window.block_height;
        std::string line = fmt::format("{:>{}}  ", canvas.y_of(first), label_width);
        const auto has = [&](Index other) {
            return first <= other && other < first + window.block_height;
        };
        for (int y = first; y < std::min(first + window.block_height, canvas.height); ++y)
            if (is_meant(canvas.y_of(y)))
                line[0] = '>';
        std::vector<MarkedCell> in_row;
        for (int column = 0; column < window.columns; ++column)
            if (has_half_blocks)
                line += half_block(cells.in_row(window, first, column),
                                   cells.in_row(window, first + 1, column), about.colors);
            else
                in_row.push_back(cells.at(window, row, column));
        line += line_of_cells(in_row, width, has_gaps, 0, scale, about.colors);
        // Without a heading, as in the player, something may stand beside the grid.
        std::size_t taken = margin + in_row.size() * cell.columns;
        for (const auto& [named, names] : names_in_row) {
            if (!has(named))
                continue;
            taken += columns_in(names);
            if (about.has_heading || taken <= size.columns)
                line += names;
        }
        text += line + "\n";
        for (std::size_t more = 1; more < scale; ++more)
            text += std::string(margin, ' ') +
                    line_of_cells(in_row, width, has_gaps, more, scale, about.colors) + "\n";
    }
    return {text + legend, grid};
}

std::string frame_text(const Replay& replay, const FrameText& about, TextSize size) {
    return laid_out_frame(replay, about, size).text;
}

std::optional<Pixel> FrameGrid::pixel_at(std::size_t line, std::size_t column,
                                         const Canvas& canvas) const {
    if (line < first_line || column < first_column)
        return std::nullopt;
    const auto row = static_cast<int>((line - first_line) / cell_lines);
    const auto in_row = static_cast<int>((column - first_column) / cell_columns);
    if (row >= window.rows || in_row >= window.columns)
        return std::nullopt;
    const int x = canvas.left() + window.first_column + in_row * window.block_width;
    const int y =
        canvas.y_of(std::min(window.first_row + row * window.block_height, canvas.height - 1));
    return Pixel{std::min(x, canvas.right()), y};
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

std::string bare_frame_text(const Replay& replay, View view, const std::optional<Region>& region,
                            const FaceGroups* faces) {
    if (view == View::plotted && !region)
        return bare_frame_text(replay.frame());
    const Canvas& canvas = replay.trace().canvas;
    const Window window = region ? window_of(canvas, *region)
                                 : Window{.columns = canvas.width, .rows = canvas.height};
    const FrameCells cells(view, replay, std::string::npos, faces);
    std::string text;
    for (int row = window.first_row; row < window.first_row + window.rows; ++row) {
        for (int column = 0; column < window.columns; ++column) {
            if (cells.width() > 1 && column > 0)
                text += ' ';
            const Pixel pixel{canvas.left() + window.first_column + column, canvas.y_of(row)};
            text += fmt::format("{:>{}}", cells.at(pixel).text, cells.width());
        }
        text += '\n';
    }
    return text;
}

std::string text_below(const Trace& trace) {
    const std::string off_canvas = off_canvas_text(trace);
    return (off_canvas.empty() ? "" : "\n" + off_canvas) +
           (trace.stages.empty() ? "" : fmt::format("\nstages: {}\n", joined(trace.stages, ", ")));
}

std::string summary_text(const Replay& replay, FrameText about, TextSize size) {
    const Trace& trace = replay.trace();
    std::string text = title_of(trace, size.columns - 1) + "\n";
    for (const std::string& line : digest_of(trace))
        text += line + "\n";
    about.has_heading = false;
    about.first_step = about.last_step = 0; // no step is told, and none marked
    LaidOutFrame frame = laid_out_frame(replay, about, size);
    const FrameWindow& window = frame.grid.window;
    if (!about.region &&
        (window.columns < trace.canvas.width || window.rows < trace.canvas.height)) {
        about.is_overview = true;
        frame = laid_out_frame(replay, about, size);
    }
    return text + frame.text;
}

} // namespace rastertrace
