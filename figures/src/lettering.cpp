// SPDX-License-Identifier: MIT
#include "lettering.h"

#include "font.h"

#include <rastertrace/trace/text/text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

/// A label's size is so many dots.
constexpr double dots_in_size = 10;

/// The room that a letter has, in dots: five columns and a gap. width_of() promises no more.
constexpr double dots_in_advance = 6.1;

/// Where dots are, and how large. Where a dot has a pixel or more, all of it is in whole pixels: strokes are
/// equally wide then, with sharp borders, and only the gaps between them differ by a pixel.
class DotGrid {
public:
    /// `pitch` is from dot to dot, in pixels.
    DotGrid(double pitch, bool is_bold)
        : pitch_(pitch), is_whole_(std::floor(dots_in_advance * pitch) > glyph_columns),
          stroke_(is_whole_ ? std::max(1.0, std::floor(pitch + nearly_a_pixel)) : pitch),
          is_bold_(is_bold) {}

    /// The left border of a dot's box; columns count from the left one of a glyph. Both halves of a letter are
    /// alike.
    double left_of(int column) const {
        constexpr int middle = glyph_columns / 2;
        const double half = half_width(std::abs(column - middle));
        return half_width(middle) + (column < middle ? -half : half);
    }

    /// The upper border; the line that letters stand on is at 0.
    double top_of(int row) const {
        const int below = row - glyph_rows_above_line;
        return below >= 0 ? rounded(below * pitch_) : -rounded((-below - 1) * pitch_) - stroke_;
    }

    double stroke() const { return stroke_; }

    /// How much wider bold strokes are.
    double boldness() const {
        if (!is_bold_)
            return 0;
        return is_whole_ ? std::max(1.0, std::ceil(pitch_ / 2 - 0.5)) : pitch_ / 2;
    }

    /// True if bold strokes would close a gap of one dot.
    bool boldness_closes_gaps() const { return is_bold_ && is_whole_ && pitch_ < 1.5; }

    /// From a letter of fixed width to the next.
    double advance() const {
        return is_whole_ ? std::floor(dots_in_advance * pitch_) : dots_in_advance * pitch_;
    }

    /// Between letters.
    double gap() const {
        const double widest = left_of(glyph_columns - 1) + stroke_;
        return std::min(rounded(pitch_), advance() - widest);
    }

    double blank() const {
        constexpr int columns = 4;
        return rounded(columns * pitch_);
    }

    /// To where a text may begin.
    double rounded(double pixels) const { return is_whole_ ? std::floor(pixels + 0.5) : pixels; }

private:
    /// From the middle column to the one that is so many columns away. A gap is left beside the widest letters.
    double half_width(int columns) const {
        const double half = rounded(columns * pitch_);
        return is_whole_ ? std::min(half, std::floor((advance() - stroke_ - 1) / 2)) : half;
    }

    static constexpr double nearly_a_pixel = 0.1;

    double pitch_;
    bool is_whole_;
    double stroke_;
    bool is_bold_;
};

/// A letter and where it begins.
struct Letter {
    Glyph glyph;
    double x;
};

/// The columns that have dots.
struct Ink {
    int first;
    int last;
};

std::optional<Ink> ink_of(const Glyph& glyph) {
    unsigned columns = 0;
    for (const std::uint8_t row : glyph.rows)
        columns |= row;
    if (columns == 0)
        return std::nullopt;
    Ink ink{0, glyph_columns - 1};
    while ((columns >> ink.first & 1) == 0)
        ++ink.first;
    while ((columns >> ink.last & 1) == 0)
        --ink.last;
    return ink;
}

/// Letters beside one another from x = 0 on, and the width of all.
struct Line {
    std::vector<Letter> letters;
    double width = 0;
};

Line set_line(const Label& label, const DotGrid& grid) {
    Line line;
    const std::string text = printable(label.text);
    for (std::string_view rest = text; !rest.empty();) {
        const CodePoint character = first_code_point(rest);
        rest.remove_prefix(character.length);
        const Glyph glyph = glyph_of(character.value);
        const auto ink = ink_of(glyph);
        // Digits are all as wide as one another, so that numbers are.
        const bool is_digit = U'0' <= character.value && character.value <= U'9';
        if (label.is_fixed_width || is_digit) {
            line.letters.push_back({glyph, line.width});
            line.width += grid.advance();
            if (!label.is_fixed_width)
                line.width += grid.boldness();
        } else if (ink) {
            line.letters.push_back({glyph, line.width - grid.left_of(ink->first)});
            line.width += grid.left_of(ink->last) - grid.left_of(ink->first) + grid.stroke() +
                          grid.boldness() + grid.gap();
        } else {
            line.width += label.is_fixed_width ? grid.advance() : grid.blank();
        }
    }
    if (!line.letters.empty())
        line.width -= grid.gap(); // the gap behind the last letter
    return line;
}

/// Puts boxes of letters where the text stands on the sheet.
class Setter {
public:
    Setter(const Label& label, double scale, int rim, const DotGrid& grid, PixelCoverage& coverage)
        : label_(label), rim_(rim), grid_(grid),
          coverage_(coverage), origin_{grid.rounded(label.at.x * scale),
                                       grid.rounded(label.at.y * scale)} {}

    /// Lets the text begin so far before its place.
    void shift(double pixels) {
        pixels = grid_.rounded(pixels);
        if (label_.is_turned)
            origin_.y += pixels;
        else
            origin_.x -= pixels;
    }

    void add(const Letter& letter) {
        for (int row = 0; row < glyph_rows; ++row)
            for (int column = 0; column < glyph_columns; ++column)
                if (letter.glyph.has(column, row)) {
                    add_row(letter, column, row);
                    add_column(letter, column, row);
                    add_slants(letter, column, row);
                }
    }

private:
    /// The box of a dot, measured from the text's beginning.
    CoveredBox box_of(const Letter& letter, int column, int row) const {
        const double left = letter.x + grid_.left_of(column);
        const double top = grid_.top_of(row);
        const bool stays_slim = grid_.boldness_closes_gaps() &&
                                !letter.glyph.has(column + 1, row) &&
                                letter.glyph.has(column + 2, row);
        const double width = grid_.stroke() + (stays_slim ? 0 : grid_.boldness());
        return {left - rim_, top - rim_, left + width + rim_, top + grid_.stroke() + rim_};
    }

    /// The dots beside one another that begin with this one.
    void add_row(const Letter& letter, int column, int row) {
        if (letter.glyph.has(column - 1, row))
            return;
        CoveredBox box = box_of(letter, column, row);
        while (letter.glyph.has(column + 1, row))
            ++column;
        box.right = box_of(letter, column, row).right;
        add(box);
    }

    /// Those below one another.
    void add_column(const Letter& letter, int column, int row) {
        if (letter.glyph.has(column, row - 1) || !letter.glyph.has(column, row + 1))
            return;
        CoveredBox box = box_of(letter, column, row);
        while (letter.glyph.has(column, row + 1)) {
            const CoveredBox next = box_of(letter, column, ++row);
            box.right = std::min(box.right, next.right);
            box.bottom = next.bottom;
        }
        add(box);
    }

    /// Strokes to the dots at the lower right and the lower left, where nothing else leads there.
    void add_slants(const Letter& letter, int column, int row) {
        const Glyph& glyph = letter.glyph;
        const CoveredBox dot = box_of(letter, column, row);
        if (glyph.has(column, row + 1))
            return;
        for (const int side : {-1, 1}) {
            if (!glyph.has(column + side, row + 1) || glyph.has(column + side, row))
                continue;
            const CoveredBox next = box_of(letter, column + side, row + 1);
            // Single pixels that meet at their corners are read well, and are sharper.
            const bool meet = next.top <= dot.bottom &&
                              (side > 0 ? next.left <= dot.right : dot.left <= next.right);
            if (meet && grid_.stroke() <= 1)
                continue;
            // As wide as the strokes across and down: what they are narrower than from corner to corner is cut
            // off, half on each side.
            constexpr double share_cut_off = 0.293; // 1 - sqrt(1/2)
            const double cut = share_cut_off * grid_.stroke();
            if (side > 0)
                add({{{dot.right, dot.top + cut},
                      {next.right - cut, next.top},
                      {next.left, next.bottom - cut},
                      {dot.left + cut, dot.bottom}}});
            else
                add({{{dot.left, dot.top + cut},
                      {dot.right - cut, dot.bottom},
                      {next.right, next.bottom - cut},
                      {next.left + cut, next.top}}});
        }
    }

    /// From where the text begins to the sheet.
    Place to_sheet(Place place) const {
        return label_.is_turned ? Place{origin_.x + place.y, origin_.y - place.x}
                                : Place{origin_.x + place.x, origin_.y + place.y};
    }

    void add(const CoveredBox& box) {
        const Place a = to_sheet({box.left, box.top});
        const Place b = to_sheet({box.right, box.bottom});
        coverage_.add(CoveredBox{a.x, std::min(a.y, b.y), b.x, std::max(a.y, b.y)});
    }

    void add(std::array<Place, 4> places) {
        for (Place& place : places)
            place = to_sheet(place);
        coverage_.add_positive(places);
    }

    const Label& label_;
    int rim_;
    const DotGrid& grid_;
    PixelCoverage& coverage_;
    Place origin_; ///< where the text begins, in pixels
};

} // namespace

void add_lettering(const Label& label, double scale, int rim, PixelCoverage& coverage) {
    const double pitch = label.size * scale / dots_in_size;
    if (pitch <= 0)
        return;
    const DotGrid grid(pitch, label.is_bold);
    const Line line = set_line(label, grid);
    Setter setter(label, scale, rim, grid, coverage);
    if (label.anchor == Anchor::middle)
        setter.shift(line.width / 2);
    if (label.anchor == Anchor::end)
        setter.shift(line.width);
    for (const Letter& letter : line.letters)
        setter.add(letter);
}

} // namespace rastertrace
