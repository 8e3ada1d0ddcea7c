// SPDX-License-Identifier: MIT
#pragma once

// A drawing that has all shapes, and texts that its format must not obey.

#include <rastertrace/figures/drawing.h>

#include <string>
#include <vector>

namespace rastertrace {

/// Texts with what SVG, TeX and terminals take for commands, and characters of many scripts.
inline std::vector<std::string> hostile_texts() {
    return {
        "\\ { } $ & # ^ _ ~ % ^^M ^^5c \\end{tikzpicture} \\input{x}",
        "-- --- << >> ?` !` '' `` ,, \" a\"b | ; : = / [ ] ( ) @ * + ?!",
        "]]> <!-- --> <script>alert('&amp;')</script> </text> &#0;",
        "a\nb\tc\x1b[0m \x01 \x7f \xff\xfe \xc3",
        "ÀÁÂÃÄÅÆÇÈÉÊËÌÍÎÏÑÒÓÔÕÖØÙÚÛÜÝßàáâãäåæçèéêëìíîïñòóôõöøùúûüýÿŒœŸı",
        "ĐđÐðÞþ αΩ א ع 日本 \U0001F600 e\u0301 \u200B \u202E \uFEFF",
        "½¼¾«»ªº°¹²³±µ·×÷¡¿§–—‘’“”„•…′πΔ−→←↑↓≤≥≠≈√∞\u00A0.",
        "  blanks   inside and behind  ",
    };
}

inline Drawing hostile_drawing() {
    Drawing drawing{.width = 400,
                    .height = 300,
                    .title = "Title\n\\end{document} ^^M <&> \xff",
                    .description = "First line\r\nsecond line \\bye"};
    for (const Role role : {Role::face_1, Role::empty, Role::inside})
        drawing.shapes.push_back(Areas{
            .role = role, .rectangles = {{{5, 5}, 30, 20}, {{-1e6, 40}, 2e6, 3}, {{9, 9}, 0, 0}}});
    drawing.shapes.push_back(
        Pixels{.corner = {60, 10},
               .side = 10,
               .columns = 2,
               .colors = {Color(1, 2, 3), Color(1, 2, 3), no_color, Color(200, 100, 0, 80)}});
    for (const Role role : {Role::true_edge, Role::curve_8, Role::window})
        drawing.shapes.push_back(
            Lines{.role = role,
                  .paths = {{{0, 0}, {400, 300}}, {{-1e6, -1e6}, {1e6, 9e5}, {3, 3}}, {{7, 7}}, {}},
                  .are_closed = role == Role::curve_8});
    drawing.shapes.push_back(
        Polygons{.role = Role::outside,
                 .paths = {{{-1e6, -1e6}, {1e6, -1e6}, {1e6, 1e6}}, {{10, 10}, {20, 10}}, {}}});
    drawing.shapes.push_back(
        Dots{.role = Role::vertex, .radius = 3, .centers = {{50, 50}, {1e6, 1e6}}});
    drawing.shapes.push_back(Dots{.role = Role::sample, .radius = 1e6, .centers = {{9, 9}}});
    drawing.shapes.push_back(Dots{.role = Role::sample, .radius = 0, .centers = {{9, 9}}});
    double y = 80;
    for (const std::string& text : hostile_texts())
        for (const bool is_fixed : {false, true}) {
            drawing.shapes.push_back(Label{.at = {10, y},
                                           .text = text,
                                           .size = is_fixed ? 7.3 : 10,
                                           .is_bold = y > 150,
                                           .is_fixed_width = is_fixed,
                                           .has_rim = is_fixed});
            y += 12;
        }
    drawing.shapes.push_back(Label{.at = {390, 200}, .text = "turned", .is_turned = true});
    drawing.shapes.push_back(
        Label{.at = {390, 290}, .text = "end", .size = 1e6, .anchor = Anchor::end});
    drawing.shapes.push_back(Label{.at = {1e6, 290}, .text = "far"});
    drawing.shapes.push_back(Label{.at = {200, 290}, .text = "", .anchor = Anchor::middle});
    return drawing;
}

} // namespace rastertrace
