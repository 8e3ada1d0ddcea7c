// SPDX-License-Identifier: MIT
#pragma once

// What is known of what a renderer has drawn, and how much of it a rule gives.

#include "rule.h"

#include <rastertrace/trace/check/claims.h>
#include <rastertrace/trace/picture/picture.h>
#include <rastertrace/trace/record/trace.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace rastertrace {

/// What is known of the pixels of a picture, row by row from the top.
struct SeenCells {
    int width = 0;
    int height = 0;
    std::vector<Color> colors{}; ///< `no_color` where nothing is drawn
    bool has_colors = true;      ///< else it is only known where something is drawn
    Color hidden = no_color;     ///< one of the scene's that cannot be told from what is not drawn
    std::vector<std::pair<Color, Color>>
        stand_ins{}; ///< another color of the picture, and the scene's in whose place it is
    std::uint64_t between =
        0; ///< pixels of an anti-aliased picture whose color lay between two that are known
};

/// A scene, and what a renderer has drawn of it, or what somebody claims of it.
struct DrawnPair {
    Source scene;
    SeenCells seen = {};
    std::optional<Claims> claims = {}; ///< in the place of a picture

    /// How many pixels are seen, or things claimed.
    std::size_t size() const { return claims ? claims->claims.size() : seen.colors.size(); }
};

/// What is left of claims when only what every trace tells is held against it: pictures, pixels, rows, edges,
/// primitives, faces, lights, samples, lines and depths.
Claims comparable(Claims claims);

/// The cells of a picture. What has the background's color (picture_trace.h) is not drawn. Where the scene mixes no
/// colors, one of them that does not occur has the color that most of its pixels have, and any other color becomes the
/// nearest one.
SeenCells cells_of(const Picture& picture, const Source& scene);

/// The cells of a trace's last frame. A trace without colors has those that the scene gives its primitives, by name; if it
/// does not give each a single one, only what is drawn is known.
SeenCells cells_of(const Trace& trace, const Source& scene);

/// True if a pixel of a picture is not as it was seen.
bool differs(const SeenCells& seen, std::size_t cell, Color drawn);

/// A pair held against what a rule draws of its scene.
struct HeldAgainst {
    std::vector<bool> wrong;   ///< for each pixel, row by row from the top, or each claim
    std::uint64_t picture = 0; ///< a hash of the picture, or of which claims are wrong
};

/// `nullopt` if the scene cannot be drawn by the rule, or if its picture has another size.
std::optional<HeldAgainst> held_against(const DrawnPair& pair, const Rule& rule,
                                        DrawnIn numbers = DrawnIn::fractions);

} // namespace rastertrace
