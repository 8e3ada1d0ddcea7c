// SPDX-License-Identifier: MIT
#include "evidence.h"

#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/picture/picture_trace.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/traced_steps.h>
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
    if (checked.not_understood > 0)
        return std::nullopt;
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
    if (color == no_color && drawn == seen.hidden)
        return false;
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

namespace {

/// A color of the picture, and the scene's that it stands for; `no_color` is not drawn.
struct PaletteColor {
    Color seen;
    Color meant;
};

int distance(Color a, Color b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
           std::abs(a.blue() - b.blue());
}

/// True if each primitive has one color.
bool is_flat(const Scene& scene) {
    return !scene.mixes_colors() && scene.shade() != Shade::lambert;
}

/// Takes what has the color of the background for not drawn, and puts the colors of a scene that mixes none in the place of
/// those that stand for them in its picture.
void take_scene_colors(SeenCells& cells, Color background, const Image& asked, const Scene& scene) {
    constexpr std::size_t most_known = 64;
    std::vector<Color> known;
    for (const Color& color : asked.colors())
        if (is_flat(scene) && color != no_color && known.size() < most_known &&
            std::ranges::find(known, color) == known.end())
            known.push_back(color);
    const auto is_drawn = [background](Color color) {
        return color != background && color.alpha() != 0;
    };

    std::vector<PaletteColor> palette;
    for (const Color& meant : known) {
        std::vector<Color> others;
        for (std::size_t i = 0; i < cells.colors.size(); ++i)
            if (const Color seen = cells.colors[i]; asked.colors()[i] == meant && is_drawn(seen) &&
                                                    std::ranges::find(known, seen) == known.end())
                others.push_back(seen);
        const bool occurs =
            is_drawn(meant) && std::ranges::find(cells.colors, meant) != cells.colors.end();
        const Color seen = occurs || others.empty() ? meant : most_frequent(others);
        if (seen != meant) {
            cells.stand_ins.emplace_back(seen, meant);
            if (std::ranges::find(palette, seen, &PaletteColor::seen) != palette.end())
                cells.has_colors = false; // it stands for two
        } else if (meant == background) {
            cells.hidden = meant;
        }
        palette.push_back({seen, meant});
    }
    if (!palette.empty() && background != no_color)
        palette.push_back({background, no_color});

    for (Color& color : cells.colors) {
        if (!is_drawn(color)) {
            color = no_color;
        } else if (!palette.empty()) {
            const auto nearest = std::ranges::min_element(
                palette, {}, [&](const PaletteColor& one) { return distance(one.seen, color); });
            cells.between += nearest->seen != color;
            color = nearest->meant;
        }
    }
}

/// True if a trace says the color of anything that it draws.
bool tells_colors(const Trace& trace) {
    for (const std::size_t n : trace.steps_of({StepKind::primitive, StepKind::pixel}))
        if (trace.kind_of(n) == StepKind::pixel ? trace.step(n).as<PixelStep>().color.color()
                                                : trace.step(n).as<PrimitiveStep>().color.color())
            return true;
    return false;
}

} // namespace

SeenCells cells_of(const Picture& picture, const Source& scene) {
    SeenCells cells{picture.width,
                    picture.height,
                    {picture.pixels.begin(), picture.pixels.end()},
                    picture.has_colors};
    const auto read = read_scene(scene);
    const auto asked = drawn_by({}, scene);
    if (!picture.has_colors || !read || !asked || asked->colors().size() != cells.colors.size())
        return cells;
    const auto is_drawn = [&](int x, int row) {
        return asked->colors()[static_cast<std::size_t>(row * picture.width + x)] != no_color;
    };
    const Scene& of = read.value().scene;
    take_scene_colors(cells, background_beside(picture, of.background, is_drawn), *asked, of);
    return cells;
}

SeenCells cells_of(const Trace& trace, const Source& scene) {
    Replay replay(trace);
    replay.go_to(trace.size());
    const Frame& frame = replay.frame();
    SeenCells cells{trace.canvas.width,
                    trace.canvas.height,
                    {frame.image.colors().begin(), frame.image.colors().end()}};
    const auto read = read_scene(scene);
    const auto asked = drawn_by({}, scene);
    if (!read || !asked || asked->colors().size() != cells.colors.size())
        return cells;
    const Scene& of = read.value().scene;
    if (tells_colors(trace)) {
        take_scene_colors(cells, no_color, *asked, of);
        return cells;
    }
    cells.has_colors = is_flat(of);
    for (std::size_t i = 0; cells.has_colors && i < cells.colors.size(); ++i) {
        const std::size_t step = replay.primitive_of(frame.drawn_by[i]);
        const auto name = step == 0 ? "" : name_of_whole(trace.step(step).as<PrimitiveStep>());
        const auto owner = std::ranges::find(of.primitives, name, &ScenePrimitive::name);
        cells.has_colors = frame.drawn_by[i] == 0 || owner != of.primitives.end();
        if (cells.has_colors && frame.drawn_by[i] != 0)
            cells.colors[i] = owner->color;
    }
    return cells;
}

} // namespace rastertrace
