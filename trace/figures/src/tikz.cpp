// SPDX-License-Identifier: MIT
#include <rastertrace/figures/tikz.h>

#include "clip.h"
#include "pixel_runs.h"

#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>

namespace rastertrace {

namespace {

constexpr double opaque = 255;

/// TeX has no lengths of 5.8 meters and more, and TikZ no numbers of 16,384 and more.
constexpr double most_mm = 5000;
constexpr double most_units = 16000;

/// Names of ours begin so, that they are not those of TikZ or of the document.
constexpr std::string_view prefix = "rt-";

/// A number with at most `digits` digits behind the point.
std::string number(double value, int digits) {
    std::string text = fmt::format("{:.{}f}", value, digits);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.'))
        text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string millimeters(double value) {
    return number(value, 4) + "mm";
}

/// In units.
std::string text_of(Place place) {
    return fmt::format("({},{})", number(place.x, 3), number(place.y, 3));
}

std::string html_color(Color color) {
    return fmt::format("{:02X}{:02X}{:02X}", color.red(), color.green(), color.blue());
}

/// The document's letters that come nearest to so many points where its text has 10; none smaller than \scriptsize, which
/// can be read. What TeX has no name for is scaled.
struct TexSize {
    double at_most; ///< points
    std::string_view command;
};
constexpr std::array tex_sizes{TexSize{7.5, "\\scriptsize"}, TexSize{8.5, "\\footnotesize"},
                               TexSize{9.5, "\\small"},      TexSize{11, "\\normalsize"},
                               TexSize{13.2, "\\large"},     TexSize{15.8, "\\Large"},
                               TexSize{18.9, "\\LARGE"},     TexSize{22.8, "\\huge"}};
constexpr TexSize largest_tex_size{24.88, "\\Huge"};

/// A comment of one line.
std::string comment(std::string_view text) {
    return text.empty() ? "" : fmt::format("% {}\n", printable(text));
}

/// An author's words, whose formulas stay as they are.
std::string with_formulas(std::string_view text) {
    // The words are typeset as they stand in the line, with a sign in the place of each formula.
    constexpr char sign = '\1';
    std::string words;
    std::vector<std::string> formulas;
    for (TextPart& part : parts_with_formulas(text)) {
        words += part.is_formula ? std::string(1, sign) : part.text;
        if (part.is_formula)
            formulas.push_back(std::move(part.text));
    }
    std::string tex;
    const auto pieces = split_at(typeset(words), sign);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        tex += tex_escaped(pieces[i]);
        if (i == formulas.size())
            break;
        constexpr std::string_view no_break = "\u00a0";
        for (std::string_view rest = formulas[i]; !rest.empty();) {
            const bool is_blank = rest.starts_with(no_break);
            tex += is_blank ? ' ' : rest.front();
            rest.remove_prefix(is_blank ? no_break.size() : 1);
        }
    }
    return tex;
}

/// Writes shapes, and remembers what they take.
class TikzWriter {
public:
    TikzWriter(const Drawing& sheet, Theme theme, double mm_per_unit)
        : theme_(theme), mm_per_unit_(mm_per_unit), clip_{{-widest_line, -widest_line},
                                                          sheet.width + 2 * widest_line,
                                                          sheet.height + 2 * widest_line},
          largest_radius_(2 * (sheet.width + sheet.height)) {}

    /// The commands of a shape.
    std::string written(const Shape& shape) {
        body_.clear();
        std::visit([this](const auto& one) { write(one); }, shape);
        return std::move(body_);
    }

    std::size_t places() const { return places_; }

    /// Colors and lines of the roles that have been used.
    std::string definitions() const {
        std::string tex;
        for (const Role role : roles_used_) {
            const Paint paint = paint_of(role, theme_);
            tex += fmt::format("\\definecolor{{{}{}}}{{HTML}}{{{}}}\n", prefix, name_of(role),
                               html_color(paint.color));
        }
        for (const Role role : lines_used_) {
            const Paint paint = paint_of(role, theme_);
            std::string dashes;
            for (std::size_t i = 0; i < paint.dashes.size(); ++i)
                dashes += fmt::format("{}{} {}", i == 0 ? "" : " ", i % 2 == 0 ? "on" : "off",
                                      in_mm(paint.dashes[i]));
            tex += fmt::format(
                "\\tikzset{{{0}line {1}/.style={{draw={0}{1},line width={2}{3}}}}}\n", prefix,
                name_of(role), in_mm(paint.width), dashes.empty() ? "" : ",dash pattern=" + dashes);
        }
        for (const std::string& color : colors_used_)
            tex += fmt::format("\\definecolor{{{}{}}}{{HTML}}{{{}}}\n", prefix, color, color);
        return tex;
    }

private:
    /// Units around the sheet in which lines go on that leave it.
    static constexpr double widest_line = 20;

    /// TeX keeps a path in memory until it ends, and takes longer for each part of a long one.
    static constexpr std::size_t characters_per_path = 2000;
    static constexpr std::size_t places_per_line = 1000;

    std::string in_mm(double units) const { return millimeters(units * mm_per_unit_); }

    /// The name of the color that a shape has.
    std::string color_name(Role role, const std::optional<Color>& color) {
        if (!color) {
            roles_used_.insert(role);
            return fmt::format("{}{}", prefix, name_of(role));
        }
        return fmt::format("{}{}", prefix, *colors_used_.insert(html_color(*color)).first);
    }

    std::string fill_options(Role role, const std::optional<Color>& color = {}) {
        const Color painted = color.value_or(paint_of(role, theme_).color);
        return color_name(role, color) +
               (painted.alpha() == 255 ? "" : ",fill opacity=" + decimal(painted.alpha() / opaque));
    }

    /// As few commands as hold all parts.
    void write_in_paths(const std::string& command, std::span<const std::string> parts) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            body_ += (length == 0 ? command : "\n  ") + parts[i];
            length += parts[i].size();
            if (i + 1 == parts.size() || length > characters_per_path) {
                body_ += ";\n";
                length = 0;
            }
        }
    }

    void write_rectangles(const std::string& options, const std::vector<Rectangle>& rectangles) {
        places_ += 2 * rectangles.size();
        if (is_too_much())
            return;
        std::vector<std::string> written;
        for (const Rectangle& rectangle : rectangles)
            if (const auto part = clipped(rectangle, clip_))
                written.push_back(fmt::format("{} rectangle {}", text_of(part->corner),
                                              text_of({part->right(), part->bottom()})));
        write_in_paths(fmt::format("\\fill[{}] ", options), written);
    }

    /// A line in parts that TikZ has memory for, each from the end of the one before.
    static std::vector<Path> parts_of(const Path& path) {
        std::vector<Path> parts;
        for (std::size_t begin = 0; begin + 1 < path.size(); begin += places_per_line - 1) {
            const std::size_t end = std::min(begin + places_per_line, path.size());
            parts.emplace_back(path.begin() + static_cast<std::ptrdiff_t>(begin),
                               path.begin() + static_cast<std::ptrdiff_t>(end));
        }
        return parts;
    }

    static std::string joined_places(const Path& path) {
        std::string tex;
        for (std::size_t i = 0; i < path.size(); ++i)
            tex += (i == 0 ? "" : i % 8 == 0 ? "\n  -- " : " -- ") + text_of(path[i]);
        return tex;
    }

    void write(const Areas& areas) {
        write_rectangles(fill_options(areas.role, areas.color), areas.rectangles);
    }

    void write(const Pixels& pixels) {
        for (const PixelRuns& runs : runs_of(pixels))
            write_rectangles(fill_options(Role::plotted, runs.color), runs.rectangles);
    }

    void write(const Lines& lines) {
        std::vector<std::string> written;
        for (Path path : lines.paths) {
            if (is_too_much())
                return;
            const bool is_whole = path.size() <= places_per_line &&
                                  std::all_of(path.begin(), path.end(),
                                              [this](Place place) { return clip_.has(place); });
            if (is_whole && path.size() > 1) {
                places_ += path.size();
                written.push_back(joined_places(path) + (lines.are_closed ? " -- cycle" : ""));
                continue;
            }
            if (lines.are_closed && !path.empty())
                path.push_back(path.front());
            for (const Path& piece : clipped_pieces(path, clip_)) {
                places_ += piece.size();
                for (const Path& part : parts_of(piece))
                    written.push_back(joined_places(part));
            }
        }
        if (written.empty())
            return;
        roles_used_.insert(lines.role);
        lines_used_.insert(lines.role);
        std::string options = fmt::format("{}line {}", prefix, name_of(lines.role));
        const Color painted = paint_of(lines.role, theme_).color;
        if (painted.alpha() != 255)
            options += ",draw opacity=" + decimal(painted.alpha() / opaque);
        write_in_paths(fmt::format("\\draw[{}] ", options), written);
    }

    void write(const Polygons& polygons) {
        std::string written;
        for (const Path& path : polygons.paths) {
            const Path part = clipped(path, clip_);
            places_ += part.size();
            if (part.size() > 2 && !is_too_much())
                written += (written.empty() ? "" : "\n  ") + joined_places(part) + " -- cycle";
        }
        if (!written.empty()) // one path: what two of the polygons cover is not twice as dark
            body_ += fmt::format("\\fill[{}] {};\n", fill_options(polygons.role), written);
    }

    void write(const Dots& dots) {
        // A dot that is larger than the sheet is drawn as large as that: TeX has no larger lengths.
        const double radius = std::min(dots.radius, largest_radius_);
        places_ += 4 * dots.centers.size();
        if (radius <= 0 || is_too_much())
            return;
        std::vector<std::string> written;
        for (const Place& center : dots.centers)
            if (clip_.has(center))
                written.push_back(
                    fmt::format("{} circle[radius={}]", text_of(center), in_mm(radius)));
        write_in_paths(fmt::format("\\fill[{}] ", fill_options(dots.role)), written);
    }

    void write(const Label& label) {
        places_ += 20;
        if (!clip_.has(label.at) || label.size <= 0 || label.text.empty() || is_too_much())
            return;
        const double points = points_of(label.size);
        const auto named =
            std::find_if(tex_sizes.begin(), tex_sizes.end(),
                         [points](const TexSize& one) { return points <= one.at_most; });
        const TexSize& size = named == tex_sizes.end() ? largest_tex_size : *named;
        std::string options = fmt::format("rt-label,text={}", color_name(label.role, label.color));
        if (named == tex_sizes.end())
            options += fmt::format(",scale={}", number(points / largest_tex_size.at_most, 4));
        if (label.is_turned)
            options += ",rotate=90";
        constexpr double rim_units = 1.5;
        if (label.has_rim)
            options += fmt::format(",fill={},inner sep={}", color_name(Role::paper, std::nullopt),
                                   in_mm(rim_units));
        options += fmt::format(",anchor=base{}", label.anchor == Anchor::start ? " west"
                                                 : label.anchor == Anchor::end ? " east"
                                                                               : "");
        std::string fonts = fmt::format("{} ", size.command);
        if (label.is_fixed_width)
            fonts += "\\ttfamily ";
        if (label.is_bold)
            fonts += "\\bfseries ";
        body_ +=
            fmt::format("\\node[{}] at {} {{{}{}}};\n", options, text_of(label.at), fonts,
                        label.has_formulas
                            ? with_formulas(label.text)
                            : tex_escaped(shown_text(label),
                                          label.is_fixed_width            ? TexFont::fixed_width
                                          : label.names_points            ? TexFont::with_names
                                          : label.role == Role::cell_text ? TexFont::in_cell
                                                                          : TexFont::proportional));
    }

    double points_of(double size) const {
        constexpr double points_per_mm = 72.27 / 25.4;
        constexpr double largest = 5000;
        return std::min(size * mm_per_unit_ * points_per_mm, largest);
    }

    bool is_too_much() const { return places_ > most_tikz_places; }

    Theme theme_;
    double mm_per_unit_;
    Rectangle clip_; ///< the sheet and what of a line may be around it
    double largest_radius_;
    std::string body_;
    std::size_t places_ = 0; ///< see most_tikz_places
    std::set<Role> roles_used_{Role::paper};
    std::set<Role> lines_used_;
    std::set<std::string> colors_used_;
};

} // namespace

Result<std::string> tikz_of(const Drawing& drawing, Theme theme, double width_mm) {
    return tikz_of(std::span(&drawing, 1), theme, width_mm);
}

Result<std::string> tikz_of(std::span<const Drawing> frames, Theme theme, double width_mm) {
    const Drawing& drawing = frames.back();
    const double mm_per_unit = width_mm / drawing.width;
    const double height_mm = drawing.height * mm_per_unit;
    if (!(drawing.width > 0 && drawing.height > 0 && width_mm > 0 && width_mm <= most_mm &&
          height_mm <= most_mm))
        return problem_of("", fmt::format("expected a picture of at most {} x {} mm for TeX, found "
                                          "{} x {} mm",
                                          most_mm, most_mm, decimal(width_mm), decimal(height_mm)));
    if (std::max(drawing.width, drawing.height) > most_units)
        return problem_of("",
                          fmt::format("expected a sheet of at most {0} x {0} units for TeX, found "
                                      "{1} x {2}",
                                      most_units, decimal(drawing.width), decimal(drawing.height)),
                          "a .png holds any picture; --region takes a part of it");
    TikzWriter writer(drawing, theme, mm_per_unit);
    std::string body;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (frames.size() > 1)
            body += fmt::format("\\only<{}>{{%\n", i + 1);
        for (const Shape& shape : frames[i].shapes)
            body += writer.written(shape);
        if (frames.size() > 1)
            body += "}%\n";
    }
    if (writer.places() > most_tikz_places)
        return problem_of("",
                          fmt::format("expected a picture that fits into TeX's memory, found more "
                                      "than {} places (a rectangle counts as two, a dot as four, "
                                      "a label as twenty)",
                                      most_tikz_places),
                          "a .png holds any picture; --region takes a part of it");

    const std::string sheet = "(0,0) rectangle " + text_of({drawing.width, drawing.height});
    return comment(drawing.title) + comment(drawing.description) +
           fmt::format(
               "% To be put into a document that has \\usepackage{{tikz}}: \\input{{FILE}}\n"
               "\\begingroup\n"
               "% Packages for languages let some signs be commands. Here they are signs.\n"
               "\\catcode33 12\\catcode34 12\\catcode39 12\\catcode45 12\\catcode58 12"
               "\\catcode59 12\\catcode60 12\n"
               "\\catcode61 12\\catcode62 12\\catcode63 12\\catcode94 7\\catcode96 12"
               "\\catcode124 12\n"
               "\\begin{{tikzpicture}}[x={0},y=-{0},line join=round]\n"
               "{1}"
               "\\tikzset{{rt-label/.style={{inner sep=0pt,outer sep=0pt,"
               "font=\\normalfont}}}}\n"
               "\\ifcsname rastertracestyle\\endcsname\\csname rastertracestyle\\endcsname\\fi\n"
               "\\clip {2};\n\\fill[rt-paper] {2};\n"
               "{3}\\end{{tikzpicture}}%\n\\endgroup\n",
               number(mm_per_unit, 6) + "mm", writer.definitions(), sheet, body);
}

} // namespace rastertrace
