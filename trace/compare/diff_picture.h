// SPDX-License-Identifier: MIT
#pragma once

// The pictures of two traces, with the primitive that has drawn each pixel, and how they differ.
//
//     OwnedPicture picture(canvas);
//     picture.see(seen_in(trace, n));
//     difference_between(a, b, owners, {});

#include "diff.h"
#include "diff_reach.h"

#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/trace_options.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

/// What a step has to do with a picture.
struct SeenStep {
    enum class What : std::uint8_t { other, pixel, primitive };
    What what = What::other;
    Index x = 0;
    Index y = 0;
    std::optional<Color> color = {}; ///< of a primitive, or of a pixel that has its own
};

/// The same of step n.
SeenStep seen_in(const Trace& trace, std::size_t n);

/// A picture, and which primitive drew each pixel: 1 is the first, 0 stands for none.
class OwnedPicture {
public:
    explicit OwnedPicture(const Canvas& canvas) : image_(canvas), owners_(image_.colors().size()) {}

    /// Goes on by a step; a part of the primitive before may count as that.
    void see(const SeenStep& step, bool is_part_of_last = false) {
        if (step.what == SeenStep::What::pixel) {
            plot(step);
        } else if (step.what == SeenStep::What::primitive) {
            primitive_ += is_part_of_last ? 0 : 1;
            color_ = step.color.value_or(Color{});
        }
    }

    const Canvas& canvas() const { return image_.canvas(); }

    /// Who drew a pixel, which may lie anywhere; 0 for nobody.
    std::uint32_t owner(Pixel pixel) const {
        return canvas().contains(pixel.x, pixel.y) ? owners_[canvas().offset_of(pixel)] : 0;
    }
    /// Draws a pixel of the canvas that nobody owns.
    void put(Pixel pixel, Color color) { image_.at(pixel) = color; }

    bool is_drawn(Pixel pixel) const { return color(pixel) != no_color; }
    Color color(Pixel pixel) const {
        return canvas().contains(pixel.x, pixel.y) ? image_.at(pixel) : no_color;
    }

private:
    void plot(const SeenStep& step) {
        if (!canvas().contains(step.x, step.y))
            return;
        const Pixel pixel{static_cast<int>(step.x), static_cast<int>(step.y)};
        const std::size_t offset = canvas().offset_of(pixel);
        image_.at(pixel) = step.color.value_or(color_);
        owners_[offset] = primitive_;
    }

    Image image_;
    BlankVector<std::uint32_t> owners_;
    std::uint32_t primitive_ = 0;
    Color color_;
};

/// True if no level of a channel is farther apart.
bool are_near(Color a, Color b, int tolerance);

/// Who draws in a, and who in b.
struct PictureOwners {
    using LookUp = std::function<OwnerOfPixels(std::uint32_t)>;
    std::function<std::uint32_t(std::uint32_t)>
        b_of_a; ///< the primitive of b that is one of a; 0: none is
    LookUp in_a;
    LookUp in_b;
};

/// What of two pictures is compared.
struct PictureScope {
    std::optional<Region> region{}; ///< nothing: all of it
    bool has_owners = true;         ///< that a pixel is of different primitives is a difference
    bool has_colors = true;         ///< else only what is drawn, in whatever color
    int color_tolerance = 0;        ///< so far apart may levels of a channel be
    bool tells_owners =
        false; ///< letters for the primitives of one picture, which the other does not have
    std::optional<DiffReach> reach{}; ///< of the first difference
};

/// How the pictures differ, and what of it comes of the first difference.
std::pair<PictureDifference, Consequences> difference_between(const OwnedPicture& a,
                                                              const OwnedPicture& b,
                                                              const PictureOwners& owners,
                                                              const PictureScope& scope);

} // namespace rastertrace
