// SPDX-License-Identifier: MIT
#include <rastertrace/figures/theme.h>

#include <rastertrace/trace/text/named_value.h>

#include <array>
#include <cassert>

namespace rastertrace {

namespace {

/// 0xRRGGBB, and how much of it covers what is below, 0 to 255.
constexpr Color rgb(std::uint32_t hex, std::uint8_t alpha = 255) {
    return {static_cast<std::uint8_t>(hex >> 16), static_cast<std::uint8_t>(hex >> 8),
            static_cast<std::uint8_t>(hex), alpha};
}

constexpr std::array<double, 2> short_dashes{4, 3};
constexpr std::array<double, 2> close_dots{1.5, 2.5};
constexpr std::array<double, 2> long_dashes{7, 3};
constexpr std::array<double, 4> dash_dot{9, 3, 2, 3};
constexpr std::array<double, 2> longest_dashes{12, 3};
constexpr std::array<double, 6> dash_dot_dot{6, 2, 1, 2, 1, 2};
constexpr std::array<double, 2> far_dots{2, 5};
constexpr std::array<double, 4> two_dashes{10, 2, 2, 2};

struct Row {
    Role role;
    std::string_view name;
    Color light;
    Color dark;
    double width = 1;
    std::span<const double> dashes = {};
};

// Faces are the colors of Okabe and Ito (Color Universal Design, 2008), mixed with the paper so that what is written on
// them can be read, then moved apart until every kind of color vision tells each from the others and from the paper.
constexpr std::array all{
    Row{Role::paper, "paper", rgb(0xffffff), rgb(0x15181d)},
    Row{Role::plotted, "plotted", rgb(0xa8cdea), rgb(0x2f5f8a)},
    Row{Role::current, "current", rgb(0xffb454), rgb(0xb8690a)},
    Row{Role::current_border, "current-border", rgb(0xb8500a), rgb(0xffb454), 2.4},
    Row{Role::face_1, "face-1", rgb(0x69abd0), rgb(0x005a88)},
    Row{Role::face_2, "face-2", rgb(0xefb960), rgb(0x724600)},
    Row{Role::face_3, "face-3", rgb(0x9ad3af), rgb(0x177a53)},
    Row{Role::face_4, "face-4", rgb(0xeab2d0), rgb(0x68395e)},
    Row{Role::face_5, "face-5", rgb(0xf3e68d), rgb(0x7b6e02)},
    Row{Role::face_6, "face-6", rgb(0xea9972), rgb(0x8d452d)},
    Row{Role::face_7, "face-7", rgb(0xa6e6fd), rgb(0x5a6c85)},
    Row{Role::face_8, "face-8", rgb(0xa2a5a2), rgb(0x636367)},
    Row{Role::empty, "empty", rgb(0xffffff, 0), rgb(0x15181d, 0)},
    Row{Role::ink, "ink", rgb(0x000000), rgb(0xf4f4f4)},
    Row{Role::grid, "grid", rgb(0xb9bec5), rgb(0x434a54), 0.6},
    Row{Role::border, "border", rgb(0x5a616b), rgb(0x98a1ad), 1},
    Row{Role::axis, "axis", rgb(0x5a616b), rgb(0x98a1ad), 1.2},
    Row{Role::true_edge, "true-edge", rgb(0x111111), rgb(0xf4f4f4), 1.8},
    Row{Role::other_edge, "other-edge", rgb(0x444a52), rgb(0xb9c0c9), 1, short_dashes},
    Row{Role::pale_edge, "pale-edge", rgb(0x9aa2ac), rgb(0x5d6672), 0.9},
    Row{Role::image_edge, "image-edge", rgb(0x3f7f3f), rgb(0x86cf86), 0.9},
    Row{Role::vertex, "vertex", rgb(0x111111), rgb(0xf4f4f4)},
    Row{Role::sample, "sample", rgb(0x5a616b), rgb(0xaab3bf)},
    Row{Role::row, "row", rgb(0xa32020), rgb(0xff8a7a), 1.4, long_dashes},
    Row{Role::row_end, "row-end", rgb(0xa32020), rgb(0xff8a7a), 1.4},
    Row{Role::rounding, "rounding", rgb(0xa32020), rgb(0xff8a7a), 1.6},
    Row{Role::rejected, "rejected", rgb(0xa32020), rgb(0xff8a7a), 1.6},
    Row{Role::same, "same", rgb(0xdfe3e8), rgb(0x3a414b)},
    Row{Role::only_here, "only-here", rgb(0xf2a07e), rgb(0x8e3f1c)},
    Row{Role::only_there, "only-there", rgb(0x7fb8e6), rgb(0x1f5f95)},
    Row{Role::differs, "differs", rgb(0xe3c1ea), rgb(0x713a80)},
    Row{Role::inside, "inside", rgb(0x1f7fbf, 70), rgb(0x4aa8e8, 80)},
    Row{Role::outside, "outside", rgb(0xd06018, 40), rgb(0xe08040, 45)},
    Row{Role::bar, "bar", rgb(0x2f7fb8), rgb(0x5fb0e6)},
    Row{Role::bar_below, "bar-below", rgb(0xd0742a), rgb(0xeda060)},
    Row{Role::eye, "eye", rgb(0x111111), rgb(0xf4f4f4), 1.4},
    Row{Role::view_plane, "view-plane", rgb(0x3f7f3f), rgb(0x86cf86), 1.2},
    Row{Role::window, "window", rgb(0x3f7f3f, 34), rgb(0x86cf86, 34)},
    Row{Role::normal, "normal", rgb(0xa32020), rgb(0xff8a7a), 1.4},
    Row{Role::culled_normal, "culled-normal", rgb(0xa32020), rgb(0xff8a7a), 1.2, short_dashes},
    Row{Role::ray, "ray", rgb(0x8a6d1f), rgb(0xc8ab5a), 0.7},
    Row{Role::sight, "sight", rgb(0x1f5fa8), rgb(0x82b7f0), 1.6},
    Row{Role::light_ray, "light-ray", rgb(0xa86400), rgb(0xffc04a), 1.8},
    Row{Role::text, "text", rgb(0x111111), rgb(0xececec)},
    Row{Role::strong_text, "strong-text", rgb(0x111111), rgb(0xffffff)},
    Row{Role::cell_text, "cell-text", rgb(0x111111), rgb(0xf4f4f4)},
    Row{Role::quiet_text, "quiet-text", rgb(0x5a616b), rgb(0xa2abb7)},
    Row{Role::curve_1, "curve-1", rgb(0x000000), rgb(0xffffff), 1.3},
    Row{Role::curve_2, "curve-2", rgb(0xb3261e), rgb(0xff8a80), 1.3, long_dashes},
    Row{Role::curve_3, "curve-3", rgb(0x1f5fa8), rgb(0x82b7f0), 1.3, close_dots},
    Row{Role::curve_4, "curve-4", rgb(0x2e7d32), rgb(0x81c784), 1.3, dash_dot},
    Row{Role::curve_5, "curve-5", rgb(0x8a4b00), rgb(0xf0b060), 1.3, short_dashes},
    Row{Role::curve_6, "curve-6", rgb(0x6a1b9a), rgb(0xce93d8), 1.3, longest_dashes},
    Row{Role::curve_7, "curve-7", rgb(0x00707a), rgb(0x6fd3dc), 1.3, far_dots},
    Row{Role::curve_8, "curve-8", rgb(0x9c1f5c), rgb(0xf48fb1), 1.3, dash_dot_dot},
    Row{Role::curve_9, "curve-9", rgb(0x444444), rgb(0xbbbbbb), 1.3, close_dots},
    Row{Role::curve_10, "curve-10", rgb(0x5d6b00), rgb(0xd4dc70), 1.3, two_dashes},
    Row{Role::curve_11, "curve-11", rgb(0x003f8f), rgb(0x90a8ff), 1.3, short_dashes},
    Row{Role::curve_12, "curve-12", rgb(0x7a5c00), rgb(0xe0c060), 1.3, long_dashes},
    Row{Role::leader, "leader", rgb(0x5a616b), rgb(0x98a1ad), 0.6},
    Row{Role::shelf, "shelf", rgb(0xeeeeee), rgb(0x262b32)},
};

constexpr bool is_in_order_of_roles() {
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].role != static_cast<Role>(i))
            return false;
    return static_cast<std::size_t>(Role::shelf) + 1 == all.size();
}
static_assert(is_in_order_of_roles());

const Row& row_of_role(Role role) {
    return all[static_cast<std::size_t>(role)];
}

constexpr std::array<std::string_view, 3> names_of_themes{"auto", "light", "dark"};

} // namespace

std::vector<std::string_view> theme_names() {
    return {names_of_themes.begin(), names_of_themes.end()};
}

std::optional<Theme> theme_named(std::string_view name) {
    return value_named<Theme>(names_of_themes, name);
}

Paint paint_of(Role role, Theme theme) {
    const Row& row = row_of_role(role);
    return {.color = theme == Theme::dark ? row.dark : row.light,
            .width = row.width,
            .dashes = row.dashes};
}

std::string_view name_of(Role role) {
    return row_of_role(role).name;
}

std::span<const Role> roles() {
    static const auto list = [] {
        std::array<Role, all.size()> result{};
        std::transform(all.begin(), all.end(), result.begin(),
                       [](const Row& row) { return row.role; });
        return result;
    }();
    return list;
}

} // namespace rastertrace
