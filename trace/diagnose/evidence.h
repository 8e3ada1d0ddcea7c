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
#include <vector>

namespace rastertrace {

/// What is known of the pixels of a picture, row by row from the top.
struct SeenCells {
    int width = 0;
    int height = 0;
    std::vector<Color> colors{}; ///< `no_color` where nothing is drawn
    bool has_colors = true;      ///< else it is only known where something is drawn
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

/// The cells of a picture. What has the color of most pixels that the scene does not draw is not drawn. Of a scene
/// whose colors are not mixed, a color between two of the scene's becomes the nearer one.
SeenCells cells_of(const Picture& picture, const Source& scene);

/// The cells of a trace's last frame.
SeenCells cells_of(const Trace& trace);

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
