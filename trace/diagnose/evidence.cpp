// SPDX-License-Identifier: MIT
#include "evidence.h"

#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/picture/picture_trace.h>
#include <rastertrace/trace/record/frame.h>
#include <rastertrace/trace/scene/scene_file.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

/// FNV-1a, a word at a time.
void add_to(std::uint64_t& hash, std::uint64_t word) {
    hash = (hash ^ word) * 0x100000001B3;
}

std::optional<HeldAgainst> claims_against(const DrawnPair& pair, const Rule& rule) {
    auto trace = traced_by(rule, pair.scene);
    if (!trace)
        return std::nullopt;
    Checked checked;
    try {
        checked = check(Truth(std::move(*trace)), *pair.claims);
    } catch (const Problem&) { // by this rule, there is nothing that a claim could be about
        return std::nullopt;
    }
    HeldAgainst held;
    for (const CheckedClaim& claim : checked.claims) {
        const bool is_wrong =
            claim.verdict == ClaimVerdict::wrong || claim.verdict == ClaimVerdict::follows;
        held.wrong.push_back(is_wrong);
        add_to(held.picture, is_wrong ? 2 : 1);
    }
    return held;
}

} // namespace

bool differs(const SeenCells& seen, std::size_t cell, Color drawn) {
    const Color color = seen.colors[cell];
    return seen.has_colors ? color != drawn : (color == no_color) != (drawn == no_color);
}

std::optional<HeldAgainst> held_against(const DrawnPair& pair, const Rule& rule, DrawnIn numbers) {
    if (pair.claims)
        return claims_against(pair, rule);
    const auto image = drawn_by(rule, pair.scene, numbers);
    if (!image || image->colors().size() != pair.seen.colors.size())
        return std::nullopt;
    HeldAgainst held;
    for (std::size_t cell = 0; cell < pair.seen.colors.size(); ++cell) {
        const Color color = image->colors()[cell];
        held.wrong.push_back(differs(pair.seen, cell, color));
        add_to(held.picture, std::uint64_t{color.red()} << 24 | std::uint64_t{color.green()} << 16 |
                                 std::uint64_t{color.blue()} << 8 | color.alpha());
    }
    return held;
}

Claims comparable(Claims claims) {
    constexpr std::array<std::string_view, 11> kinds{"picture",   "pixel",  "scanline", "edge",
                                                     "primitive", "face",   "light",    "sample",
                                                     "along",     "decide", "depth"};
    std::erase_if(claims.claims, [&kinds](const Claim& claim) {
        return std::ranges::find(kinds, claim.step) == kinds.end();
    });
    return claims;
}

SeenCells cells_of(const Picture& picture, const Source& scene) {
    SeenCells cells{picture.width,
                    picture.height,
                    {picture.pixels.begin(), picture.pixels.end()},
                    picture.has_colors};
    const auto asked = drawn_by({}, scene);
    if (!picture.has_colors || !asked || asked->colors().size() != cells.colors.size())
        return cells;

    // What is not drawn.
    std::vector<Color> not_drawn;
    std::vector<Color> known{no_color};
    for (std::size_t i = 0; i < cells.colors.size(); ++i) {
        const Color color = asked->colors()[i];
        if (color == no_color)
            not_drawn.push_back(cells.colors[i]);
        else if (std::ranges::find(known, color) == known.end() && known.size() < 64)
            known.push_back(color);
    }
    const Color background = most_frequent(not_drawn);
    for (Color& color : cells.colors)
        if (color == background || color.alpha() == 0)
            color = no_color;

    // Colors between those of a scene that mixes none.
    const auto read = read_scene(scene);
    const bool is_flat =
        read && !read.value().scene.mixes_colors() && read.value().scene.shade() != Shade::lambert;
    const auto distance = [&](Color a, Color b) {
        const Color p = a == no_color ? background : a;
        const Color q = b == no_color ? background : b;
        return std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) +
               std::abs(p.blue() - q.blue());
    };
    for (Color& color : cells.colors)
        if (is_flat && std::ranges::find(known, color) == known.end()) {
            ++cells.between;
            color = *std::ranges::min_element(known, {},
                                              [&](Color one) { return distance(one, color); });
        }
    return cells;
}

SeenCells cells_of(const Trace& trace) {
    Replay replay(trace);
    replay.go_to(trace.size());
    const Image& image = replay.frame().image;
    return {
        trace.canvas.width, trace.canvas.height, {image.colors().begin(), image.colors().end()}};
}

} // namespace rastertrace
