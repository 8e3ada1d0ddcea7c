// SPDX-License-Identifier: MIT
#include "conventions.h"

#include "pipeline_names.h"

#include <algorithm>
#include <array>

namespace rastertrace {

namespace {

constexpr ConventionView gl_view{.pixels = PixelRange::edges};
constexpr ConventionView d3d_view{.pixels = PixelRange::edges, .z_from_zero = true};
constexpr ConventionView vulkan_view{
    .pixels = PixelRange::edges, .is_y_down = true, .z_from_zero = true};
constexpr ConventionView canonical_depths{.pixels = PixelRange::edges, .has_unit_depths = false};
constexpr ConventionView cs418_view{
    .pixels = PixelRange::edges, .is_y_down = true, .has_unit_depths = false};

} // namespace

std::span<const ConventionRow> convention_rows() {
    static const std::array rows{
        ConventionRow{
            Convention::opengl,
            "opengl",
            "OpenGL, and WebGL",
            {{"fill", "top-left"},
             {"horizontal_edge", "bottom"},
             {"sample", "center"},
             {"line", "diamond-exit"},
             {"depth", "ndc-z"},
             {"scalar", "fixed"}},
            &gl_view,
            "OpenGL 4.6 core, sections 13.8.1 (viewport), 14.5.1 (lines), 14.6.1 (polygons)",
            "which triangle owns a sample on a shared edge is the driver's choice, but exactly one "
            "does; here, as in Mesa, bottom and left edges have their samples"},
        ConventionRow{
            Convention::direct3d,
            "direct3d",
            "Direct3D 10 to 12",
            {{"fill", "top-left"},
             {"sample", "center"},
             {"line", "diamond-exit"},
             {"depth", "ndc-z"},
             {"scalar", "fixed"}},
            &d3d_view,
            "Direct3D 11.3 functional specification, sections 3.3 (viewport), 3.4.2.1 (triangles), "
            "3.4.3 (lines)",
            "z is in view from 0 to w; of a line's ties only those of OpenGL are drawn here, "
            "Direct3D gives the lower sides of a diamond to it"},
        ConventionRow{
            Convention::vulkan,
            "vulkan",
            "Vulkan",
            {{"fill", "top-left"},
             {"sample", "center"},
             {"line", "diamond-exit"},
             {"depth", "ndc-z"},
             {"scalar", "fixed"}},
            &vulkan_view,
            "Vulkan 1.3, chapters 27.9 (viewport) and 28.11 (polygons), "
            "VK_EXT_line_rasterization: Bresenham lines",
            "y = 1 is at the bottom; z is in view from 0 to w; a driver may draw lines as "
            "rectangles instead"},
        ConventionRow{Convention::cgfs,
                      "cgfs",
                      "Computer Graphics from Scratch, G. Gambetta",
                      {{"fill", "scanline"},
                       {"rounding", "truncate"},
                       {"lerp", "incremental"},
                       {"line", "dda"},
                       {"depth", "inverse-z"},
                       {"depth_at", "rounded-ends"}},
                      &canonical_depths,
                      "Computer Graphics from Scratch, chapters 6 to 12, and their demos",
                      "rows have both ends; a pixel is a whole number, cut toward zero"},
        ConventionRow{Convention::tinyrenderer,
                      "tinyrenderer",
                      "tinyrenderer, D. Sokolov",
                      {{"fill", "barycentric"},
                       {"sample", "integer"},
                       {"snap", "truncate"},
                       {"line", "bresenham"},
                       {"from", "low"},
                       {"depth", "ndc-z"}},
                      &canonical_depths,
                      "tinyrenderer, lessons 1 to 3",
                      "vertices are cut to whole pixels; both triangles draw a shared edge"},
        ConventionRow{Convention::cs418,
                      "cs418",
                      "UIUC CS418, the rasterizer",
                      {{"fill", "scanline"},
                       {"rows", "half-open"},
                       {"rounding", "half-open"},
                       {"lerp", "incremental"},
                       {"color_rounding", "truncate"},
                       {"depth", "none"}},
                      &cs418_view,
                      "UIUC CS418, machine problem Rasterizer: DDA by rows",
                      "a pixel is a whole number: left and top ends belong to a triangle, right "
                      "and bottom ends do not; y points down; colors are cut off"},
        ConventionRow{
            Convention::scotty3d,
            "scotty3d",
            "CMU 15-462, Scotty3D, assignment 1",
            {{"fill", "top-left"},
             {"sample", "center"},
             {"line", "diamond-exit"},
             {"depth", "ndc-z"}},
            &gl_view,
            "Scotty3D, A1: lines by the diamond-exit rule, triangles once on shared edges",
            "which triangle owns a shared edge is open; top-left is taken here"},
    };
    return rows;
}

const ConventionRow* row_of(Convention convention) {
    const auto rows = convention_rows();
    const auto found = std::find_if(rows.begin(), rows.end(), [convention](const auto& row) {
        return row.convention == convention;
    });
    return found == rows.end() ? nullptr : &*found;
}

std::string name_of_view(const ConventionRow& row) {
    std::string text(pixel_range_names()[static_cast<std::size_t>(row.view->pixels)]);
    text += row.view->is_y_down ? ", y down" : ", y up";
    if (row.view->z_from_zero)
        text += ", z from 0";
    return text + (row.view->has_unit_depths ? ", depths 0 to 1" : ", depths z/w");
}

} // namespace rastertrace
