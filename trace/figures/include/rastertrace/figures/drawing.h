// SPDX-License-Identifier: MIT
#pragma once

// A drawing: shapes on a sheet, each with a role. A theme (theme.h) says what a role looks like; svg.h, tikz.h
// and bitmap.h write the drawing.
//
//     Drawing drawing{.width = 40, .height = 20, .title = "A line"};
//     drawing.shapes.push_back(Lines{.role = Role::edge, .paths = {{{0, 0}, {40, 20}}}});
//     const std::string svg = svg_of(drawing, Theme::automatic);
//
// One unit is a pixel of a screen (in a bitmap that is not scaled, exactly one). (0, 0) is the upper left
// corner of the sheet, x runs to the right and y down. Shapes cover those before them.

#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/tell/place.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rastertrace {

/// What a shape is there for. theme.cpp has a row for each: its name, its colors, its line.
enum class Role : std::uint8_t {
    paper,          ///< the sheet
    plotted,        ///< pixels that are drawn
    current,        ///< pixels that this step draws
    current_border, ///< around them
    face_1,         ///< pixels of the first face, of the second, ...: face_role()
    face_2,
    face_3,
    face_4,
    face_5,
    face_6,
    face_7,
    face_8,
    empty,      ///< pixels of a canvas that nothing has drawn
    ink,        ///< pixels that are drawn, where none has a color: black on light paper
    grid,       ///< between pixels
    border,     ///< of the canvas, of a panel
    axis,       ///< where x or y is 0
    true_edge,  ///< of the primitive that the step is about
    other_edge, ///< of another one
    pale_edge,  ///< in space, of what the step is not about
    image_edge, ///< on the view plane
    vertex,     ///< its dot
    sample,     ///< where a pixel is tested
    row,        ///< the line at the y that a row is about
    row_end,    ///< where an edge meets it
    rounding,   ///< from there to its pixel
    rejected,   ///< pixels that were tested and not drawn
    same,       ///< pixels that two traces have drawn alike
    only_here,  ///< pixels drawn by this trace alone
    only_there, ///< pixels drawn by the other one alone
    differs,    ///< pixels that both have drawn, differently
    inside,     ///< where a function is not negative
    outside,    ///< where it is
    bar,        ///< a value as a length
    bar_below,  ///< a negative one
    eye,
    view_plane,
    window, ///< what of it is in the picture
    normal,
    culled_normal, ///< of a face that is turned away
    ray,           ///< from the eye to a vertex
    sight,         ///< the one that the step is about
    light_ray,
    text,
    strong_text,
    cell_text,  ///< in a pixel
    quiet_text, ///< numbers of columns and rows, and what else is only looked up
    curve_1,    ///< of a plot: curve_role()
    curve_2,
    curve_3,
    curve_4,
    curve_5,
    curve_6,
    curve_7,
    curve_8,
    curve_9,
    curve_10,
    curve_11,
    curve_12,
    leader, ///< from a mark to its label
    shelf,  ///< the part of a plot for what its axis does not reach
};

/// The roles of the nth face and of the nth curve, from 0; after the last one comes the first again.
Role face_role(std::size_t n);
Role curve_role(std::size_t n);

/// A rectangle, its corner at the upper left.
struct Rectangle {
    Place corner;
    double width = 0;
    double height = 0;

    double left() const { return corner.x; }
    double top() const { return corner.y; }
    double right() const { return corner.x + width; }
    double bottom() const { return corner.y + height; }

    /// Borders included.
    bool has(Place place) const {
        return left() <= place.x && place.x <= right() && top() <= place.y && place.y <= bottom();
    }
    bool has(const Rectangle& other) const {
        return left() <= other.left() && other.right() <= right() && top() <= other.top() &&
               other.bottom() <= bottom();
    }

    /// True if they have more than a border in common.
    bool meets(const Rectangle& other) const {
        return left() < other.right() && other.left() < right() && top() < other.bottom() &&
               other.top() < bottom();
    }
};

/// Rectangles without a border.
struct Areas {
    Role role = Role::plotted;
    std::optional<Color> color = {}; ///< in the place of the role's
    std::vector<Rectangle> rectangles = {};
};

/// Lines, in the role's dashes.
struct Lines {
    Role role = Role::true_edge;
    std::vector<Path> paths = {};
    bool are_closed = false; ///< the last place is joined with the first
};

/// Polygons without a border.
struct Polygons {
    Role role = Role::inside;
    std::vector<Path> paths = {};
};

struct Dots {
    Role role = Role::vertex;
    double radius = 2;
    std::vector<Place> centers = {};
};

/// A grid of square pixels, each in a color of its own; `no_color` leaves the paper as it is.
struct Pixels {
    Place corner;
    double side = 1; ///< of a pixel
    std::size_t columns = 0;
    std::vector<Color> colors = {}; ///< row by row, the top one first
};

/// Which part of a text stands at its place.
enum class Anchor : std::uint8_t { start, middle, end };

/// A line of text.
struct Label {
    Role role = Role::text;
    std::optional<Color> color = {}; ///< in the place of the role\'s
    Place at;                        ///< on the line that the letters stand on
    std::string text;
    double size = 10; ///< of the letters, in units, from the top of an A to the bottom of a g
    Anchor anchor = Anchor::start;
    bool is_bold = false;
    bool is_fixed_width = false; ///< as on a terminal; otherwise it is typeset
    bool names_points = false;   ///< its capitals, and x, y, z, w, d, t, are names of the scene
    bool has_formulas = false;   ///< an author's words, whose $...$ is mathematics in LaTeX
    bool is_turned = false;      ///< it runs upward
    bool has_rim = false;        ///< in the color of the paper, to be read over lines
};

using Shape = std::variant<Areas, Lines, Polygons, Dots, Pixels, Label>;

/// A sheet and what is on it.
struct Drawing {
    double width = 0;
    double height = 0;
    std::string title;            ///< for who cannot see it: what it is ...
    std::string description = {}; ///< ... and what is to be seen
    std::vector<Shape> shapes = {};
};

/// Puts a drawing on another one, its upper left corner at `corner`.
void place(Drawing&& part, Place corner, Drawing& sheet);

/// About how many bytes a drawing takes in memory.
std::size_t memory_of(const Drawing& drawing);

/// A number to be read by people, with at most two digits behind the point: "0.25", "3", "-0.5".
std::string decimal(double value);

/// A line to `to` with a head there.
void add_arrow(Place from, Place to, Role role, double head_length, std::vector<Shape>& shapes);

/// A text with the signs that a printer has in the place of those of a keyboard: "x = -1 -> 2" is "x = −1 → 2". Hyphens
/// in words stay.
std::string typeset(std::string_view text);

/// Words, or a formula of LaTeX with its dollars.
struct TextPart {
    std::string text;
    bool is_formula = false;
};

/// An author's words and formulas, $...$, in their order. As in Markdown, a formula has no blank behind its first dollar or
/// before its last one, and no digit behind that; its braces have partners. \$ is a dollar, which stands in words as $.
std::vector<TextPart> parts_with_formulas(std::string_view text);

/// The text that a label shows: typeset, unless its letters are of fixed width.
std::string shown_text(const Label& label);

/// How wide a line of text is when it is typeset, in units, in letters that need not be of fixed width. (Those of TeX are
/// narrower.)
double width_of(std::string_view typed, double size, bool is_bold = false);

/// How many letters of a text have room in a line, at least one; of fixed width, or as wide on the average.
std::size_t letters_in(double width, double size);

} // namespace rastertrace
