// SPDX-License-Identifier: MIT
#include <rastertrace/figures/svg.h>

#include "pixel_runs.h"

#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace rastertrace {

namespace {

/// "#rrggbb".
std::string hex(Color color) {
    return to_text(Color{color.red(), color.green(), color.blue()});
}

/// A color and how much of it covers what is below, for `fill` or `stroke`.
std::string paint_css(std::string_view property, Color color) {
    constexpr double opaque = 255;
    const std::string opacity = color.alpha() == 255 ? ""
                                                     : fmt::format(";{}-opacity:{}", property,
                                                                   decimal(color.alpha() / opaque));
    return fmt::format("{}:{}{}", property, hex(color), opacity);
}

std::string path_data(const Path& path, bool is_closed) {
    std::string data;
    for (const Place& place : path)
        data +=
            fmt::format("{}{} {}", data.empty() ? "M" : "L", decimal(place.x), decimal(place.y));
    return data + (is_closed ? "Z" : "");
}

std::string path_data(const Rectangle& rectangle) {
    const std::string width = decimal(rectangle.width);
    return fmt::format("M{} {}h{}v{}h-{}z", decimal(rectangle.corner.x),
                       decimal(rectangle.corner.y), width, decimal(rectangle.height), width);
}

/// True if a text has blanks that SVG leaves out unless it is told not to: at an end, or beside another one.
bool would_lose_blanks(std::string_view text) {
    return text.starts_with(' ') || text.ends_with(' ') ||
           text.find("  ") != std::string_view::npos;
}

/// Writes shapes, and remembers what they take.
class ShapeWriter {
public:
    std::string written(const Shape& shape) {
        return std::visit([this](const auto& one) { return written(one); }, shape);
    }

    const std::set<Role>& roles_used() const { return roles_used_; }
    std::size_t shapes() const { return shapes_; }

private:
    /// The attributes that all shapes have.
    std::string attributes(std::string_view kind, Role role,
                           const std::optional<Color>& fill = {}) {
        roles_used_.insert(role);
        return fmt::format(R"(class="{} {}"{})", kind, name_of(role),
                           fill ? fmt::format(R"( style="{}")", paint_css("fill", *fill)) : "");
    }

    /// A path, unless nothing is in it.
    std::string path_element(std::string_view kind, Role role, const std::string& data,
                             const std::optional<Color>& fill = {}) {
        return data.empty()
                   ? ""
                   : fmt::format("<path {} d=\"{}\"/>\n", attributes(kind, role, fill), data);
    }

    std::string written(const Areas& areas) {
        shapes_ += areas.rectangles.size();
        std::string data;
        for (const Rectangle& rectangle : areas.rectangles)
            data += path_data(rectangle);
        return path_element("area", areas.role, data, areas.color);
    }

    std::string written(const Lines& lines) {
        std::string data;
        shapes_ += lines.paths.size();
        for (const Path& path : lines.paths)
            data += path_data(path, lines.are_closed);
        return path_element("line", lines.role, data);
    }

    std::string written(const Polygons& polygons) {
        std::string data;
        shapes_ += polygons.paths.size();
        for (const Path& path : polygons.paths)
            data += path_data(path, true);
        return path_element("shape", polygons.role, data);
    }

    std::string written(const Dots& dots) {
        std::string data;
        const std::string radius = decimal(dots.radius);
        const std::string across = decimal(2 * dots.radius);
        shapes_ += dots.centers.size();
        for (const Place& center : dots.centers)
            data += fmt::format("M{0} {1}a{2} {2} 0 1 0 {3} 0a{2} {2} 0 1 0 -{3} 0z",
                                decimal(center.x - dots.radius), decimal(center.y), radius, across);
        return path_element("shape", dots.role, data);
    }

    std::string written(const Pixels& pixels) {
        std::string svg;
        for (const PixelRuns& runs : runs_of(pixels)) {
            shapes_ += runs.rectangles.size();
            svg += fmt::format("<path class=\"area\" style=\"{}\" d=\"",
                               paint_css("fill", runs.color));
            for (const Rectangle& rectangle : runs.rectangles)
                svg += path_data(rectangle);
            svg += "\"/>\n";
        }
        return svg;
    }

    std::string written(const Label& label) {
        ++shapes_;
        std::string more;
        if (label.is_turned)
            more += fmt::format(R"svg( transform="translate({} {}) rotate(-90)")svg",
                                decimal(label.at.x), decimal(label.at.y));
        else
            more += fmt::format(R"( x="{}" y="{}")", decimal(label.at.x), decimal(label.at.y));
        more += fmt::format(R"( font-size="{}")", decimal(label.size));
        if (label.anchor != Anchor::start)
            more += fmt::format(R"( text-anchor="{}")",
                                label.anchor == Anchor::middle ? "middle" : "end");
        if (label.is_bold)
            more += R"( font-weight="bold")";
        std::string kind = "label";
        if (label.is_fixed_width)
            kind += " fixed";
        if (would_lose_blanks(label.text))
            more += R"( xml:space="preserve")";
        if (label.has_rim)
            kind += " rim";
        return fmt::format("<text {}{}>{}</text>\n", attributes(kind, label.role, label.color),
                           more, escaped(shown_text(label)));
    }

    std::set<Role> roles_used_;
    std::size_t shapes_ = 0;
};

/// The class of a figure, other than that of any other one: pages may hold several, whose rules must not meet. FNV-1a.
std::string scope_of(std::string_view body, Theme theme) {
    std::uint32_t hash = 0x811C9DC5U ^ static_cast<std::uint32_t>(theme);
    for (const char c : body)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x01000193U;
    return fmt::format("r{:08x}", hash);
}

/// The width and dashes of a role's lines.
std::string line_css(const Paint& paint) {
    std::string css = "stroke-width:" + decimal(paint.width);
    for (std::size_t i = 0; i < paint.dashes.size(); ++i)
        css += (i == 0 ? ";stroke-dasharray:" : " ") + decimal(paint.dashes[i]);
    return css;
}

/// The rules for the kinds of shape.
std::string rules_of_kinds(std::string_view paper, std::string_view scope) {
    return fmt::format(".{1} .line{{fill:none;stroke-linejoin:round}}\n"
                       ".{1} .area,.{1} .shape,.{1} .label{{stroke:none}}\n"
                       ".{1} .area{{shape-rendering:crispEdges}}\n"
                       ".{1} .sheet{{fill:{0}}}\n"
                       ".{1} .rim{{stroke:{0};stroke-width:3;stroke-linejoin:round;"
                       "stroke-dasharray:none;paint-order:stroke}}\n"
                       ".{1} .label{{font-family:\"DejaVu Sans\",Verdana,sans-serif}}\n"
                       ".{1} .fixed{{font-family:\"DejaVu Sans Mono\",Menlo,Consolas,monospace}}\n",
                       paper, scope);
}

/// The rules for the roles that are used, and for the kinds of shape.
std::string rules(const std::set<Role>& used, Theme theme, std::string_view scope) {
    std::string css;
    for (const Role role : used) {
        const Paint paint = paint_of(role, theme);
        css += fmt::format(".{} .{}{{{};{};{}}}\n", scope, name_of(role),
                           paint_css("fill", paint.color), paint_css("stroke", paint.color),
                           line_css(paint));
    }
    return css + rules_of_kinds(hex(paint_of(Role::paper, theme).color), scope);
}

std::string style_sheet(const std::set<Role>& used, Theme theme, std::string_view scope) {
    std::string css = rules(used, theme, scope);
    if (theme == Theme::automatic)
        css += fmt::format("@media (prefers-color-scheme:dark){{\n{}}}\n",
                           rules(used, Theme::dark, scope));
    return css;
}

std::string document(const Drawing& sheet, double scale, std::string_view scope,
                     const std::string& css, const std::string& body) {
    const std::string width = decimal(sheet.width);
    const std::string height = decimal(sheet.height);
    const std::string description =
        sheet.description.empty() ? ""
                                  : fmt::format("<desc>{}</desc>\n", escaped(sheet.description));
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"{6}\" role=\"img\" width=\"{7}\" "
        "height=\"{8}\" viewBox=\"0 0 {0} {1}\">\n<title>{2}</title>\n{3}"
        "<style>\n{4}</style>\n"
        "<rect class=\"sheet\" width=\"{0}\" height=\"{1}\"/>\n{5}</svg>\n",
        width, height, escaped(sheet.title), description, css, body, scope,
        decimal(scale * sheet.width), decimal(scale * sheet.height));
}

/// The shapes of a drawing, each written.
std::vector<std::string> written_shapes(const Drawing& drawing, ShapeWriter& writer) {
    std::vector<std::string> shapes;
    for (const Shape& shape : drawing.shapes)
        shapes.push_back(writer.written(shape));
    return shapes;
}

std::string joined_from(const std::vector<std::string>& shapes, std::size_t first) {
    std::string body;
    for (std::size_t i = first; i < shapes.size(); ++i)
        body += shapes[i];
    return body;
}

/// How many shapes all of the frames begin with.
std::size_t common_shapes(const std::vector<std::vector<std::string>>& frames) {
    std::size_t count = frames.front().size();
    for (const auto& frame : frames) {
        const auto [end, unused] = std::mismatch(
            frames.front().begin(), frames.front().begin() + static_cast<std::ptrdiff_t>(count),
            frame.begin(), frame.end());
        count = static_cast<std::size_t>(end - frames.front().begin());
    }
    return count;
}

std::optional<Problem> too_many(std::size_t shapes) {
    if (shapes <= most_svg_shapes)
        return std::nullopt;
    return problem_of(
        "", fmt::format("expected at most {} shapes in an SVG, found {}", most_svg_shapes, shapes),
        "a .png holds any picture; --region takes a part of it");
}

} // namespace

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : printable(text)) {
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        case '\'':
            result += "&#39;";
            break;
        default:
            result += c;
        }
    }
    return result;
}

Result<std::string> svg_of(const Drawing& drawing, Theme theme, double scale) {
    ShapeWriter writer;
    const std::string body = joined_from(written_shapes(drawing, writer), 0);
    if (auto problem = too_many(writer.shapes()))
        return *std::move(problem);
    const std::string scope = scope_of(body, theme);
    return document(drawing, scale, scope, style_sheet(writer.roles_used(), theme, scope), body);
}

Result<std::string> animated_svg_of(std::span<const Drawing> frames, double seconds, Theme theme,
                                    double scale) {
    if (frames.size() == 1)
        return svg_of(frames.front(), theme, scale);
    ShapeWriter writer;
    std::vector<std::vector<std::string>> written;
    for (const Drawing& frame : frames)
        written.push_back(written_shapes(frame, writer));
    if (auto problem = too_many(writer.shapes()))
        return *std::move(problem);

    // What all begin with is written once. Each frame is shown for its share of the time, from its turn on; a
    // negative delay starts an animation in its middle.
    const std::size_t common = common_shapes(written);
    std::string body(joined_from(
        {written.front().begin(), written.front().begin() + static_cast<std::ptrdiff_t>(common)},
        0));
    const auto count = static_cast<double>(frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i)
        body += fmt::format("<g class=\"frame{}\" style=\"animation-delay:{}s\">\n{}</g>\n",
                            i + 1 == frames.size() ? " last" : "",
                            decimal(-static_cast<double>(frames.size() - i) * seconds),
                            joined_from(written[i], common));
    const std::string scope = scope_of(body, theme);
    std::string css = style_sheet(writer.roles_used(), theme, scope);
    css += fmt::format(
        ".{2} .frame{{visibility:hidden}}\n.{2} .last{{visibility:visible}}\n"
        "@keyframes turn-{2}{{0%{{visibility:visible}}{0:.4f}%{{visibility:hidden}}}}\n"
        "@media (prefers-reduced-motion:no-preference){{.{2} .frame{{animation:turn-{2} {1}s "
        "step-end infinite}}}}\n",
        100 / count, decimal(count * seconds), scope);
    return document(frames.back(), scale, scope, css, body);
}

std::string svg_elements(std::span<const Shape> shapes) {
    ShapeWriter writer;
    std::string text;
    for (const Shape& shape : shapes)
        text += writer.written(shape);
    return text;
}

std::string rules_of_roles(std::string_view scope) {
    const std::string common = line_css({});
    std::string css = fmt::format(
        ".{} [class*=\" \"]{{fill:currentColor;stroke:currentColor;{}}}\n", scope, common);
    for (const Role role : roles()) {
        const std::string line = line_css(paint_of(role, Theme::light));
        if (line != common)
            css += fmt::format(".{} .{}{{{}}}\n", scope, name_of(role), line);
    }
    return css + rules_of_kinds("var(--paper)", scope);
}

} // namespace rastertrace
