// SPDX-License-Identifier: MIT
// The list of what a figure can show.

#include <rastertrace/figures/figure.h>

#include <algorithm>
#include <array>

namespace rastertrace {

namespace {

constexpr std::array parts{
    FigurePartRow{FigurePart::grid, "grid", "lines between the pixels",
                  "where pixels are large enough"},
    FigurePartRow{FigurePart::axes, "axes",
                  "the numbers of columns and rows, and where x and y are 0", "always"},
    FigurePartRow{FigurePart::edges, "edges",
                  "the true edges of primitives, over the pixels, as far as nothing nearer hides "
                  "them",
                  "of the step's primitive; at the end, of all if they are few; not under numbers"},
    FigurePartRow{FigurePart::hidden_edges, "hidden-edges",
                  "the edges, or their parts, that nearer faces hide, dashed", "never"},
    FigurePartRow{FigurePart::vertices, "vertices", "their vertices, with names", "with edges"},
    FigurePartRow{FigurePart::coordinates, "coordinates", "the coordinates of vertices",
                  "with vertices"},
    FigurePartRow{FigurePart::samples, "samples", "the place where each pixel is tested",
                  "for fills that test samples"},
    FigurePartRow{FigurePart::row, "row",
                  "the rows that the step is about, where the edges meet them, and arrows to the "
                  "pixels that ends are rounded to",
                  "for a step of a row"},
    FigurePartRow{FigurePart::pixels, "pixels", "the pixels drawn so far, colored by --view",
                  "always"},
    FigurePartRow{FigurePart::current, "current",
                  "which of them this step has drawn, or "
                  "is about",
                  "for a step"},
    FigurePartRow{FigurePart::rejected, "rejected",
                  "a cross where the step has tested a pixel and not drawn it", "for a step"},
    FigurePartRow{FigurePart::order, "order", "in each pixel, its number in the order of drawing",
                  "never"},
    FigurePartRow{FigurePart::depths, "depths", "in each pixel, what the depth buffer holds",
                  "in the view depth, where the numbers fit"},
    FigurePartRow{FigurePart::writes, "writes", "in each pixel, how often it was written",
                  "in the view writes"},
    FigurePartRow{FigurePart::weights, "weights", "in each pixel that was tested, its weights",
                  "never"},
    FigurePartRow{FigurePart::owners, "owners", "in each pixel, the face that it shows", "never"},
    FigurePartRow{FigurePart::levels, "levels",
                  "in each pixel, the levels of its color: one of a gray, else red, green, blue",
                  "never"},
    FigurePartRow{FigurePart::half_planes, "half-planes",
                  "for each edge of a triangle the side where its function is not negative",
                  "never"},
    FigurePartRow{FigurePart::errors, "errors",
                  "below or beside Bresenham's line, d at each of its decisions", "never"},
    FigurePartRow{FigurePart::space, "space",
                  "beside the pixels, the picture in space, as --view space has it", "never"},
    FigurePartRow{FigurePart::plot, "plot",
                  "below, depths along the row: as drawn, and the true curve", "never"},
    FigurePartRow{FigurePart::title, "title", "the title of the scene", "always"},
    FigurePartRow{FigurePart::step, "step", "beside the title, which step it is", "for a step"},
    FigurePartRow{FigurePart::legend, "legend", "what colors stand for",
                  "in the view faces, for --against and half-planes"},
    FigurePartRow{FigurePart::caption, "caption", "what the step says, or --caption TEXT",
                  "for a step"},
    FigurePartRow{FigurePart::working, "working", "below it, how its numbers come of one another",
                  "never"},
};
static_assert(parts.size() == figure_part_count);

struct NamedEye {
    std::string_view name;
    SpaceEye eye;
};
constexpr std::array<NamedEye, 4> eyes{
    {{"corner", {}}, {"front", {{0, 0, 1}}}, {"side", {{1, 0, 0}}}, {"top", {{0, 1, 0}}}}};

} // namespace

std::span<const FigurePartRow> figure_parts() {
    return parts;
}

std::optional<FigurePart> figure_part_named(std::string_view name) {
    const auto found = std::find_if(parts.begin(), parts.end(),
                                    [name](const FigurePartRow& row) { return row.name == name; });
    return found == parts.end() ? std::nullopt : std::optional(found->part);
}

std::vector<std::string_view> space_eye_names() {
    std::vector<std::string_view> names;
    for (const NamedEye& eye : eyes)
        names.push_back(eye.name);
    return names;
}

std::optional<SpaceEye> space_eye_named(std::string_view name) {
    const auto found = std::find_if(eyes.begin(), eyes.end(),
                                    [name](const NamedEye& eye) { return eye.name == name; });
    return found == eyes.end() ? std::nullopt : std::optional(found->eye);
}

} // namespace rastertrace
