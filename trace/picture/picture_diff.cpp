// SPDX-License-Identifier: MIT
#include "picture_diff.h"

#include "picture_trace.h"

#include <rastertrace/trace/compare/diff_picture.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// A trace's picture, and the step that begins each primitive.
struct DrawnTrace {
    const Trace& trace;
    OwnedPicture picture;
    std::vector<std::size_t> primitives{};

    explicit DrawnTrace(const Trace& of) : trace(of), picture(of.canvas) {
        for (const std::size_t n : of.steps_of({StepKind::primitive, StepKind::pixel})) {
            picture.see(seen_in(of, n));
            if (of.kind_of(n) == StepKind::primitive)
                primitives.push_back(n);
        }
    }

    OwnerOfPixels owner(std::uint32_t number) const {
        return owner_in(trace, number == 0 ? 0 : primitives[number - 1]);
    }
};

/// A picture that is moved by whole pixels, turned over, or both.
struct Placement {
    int right = 0;
    int down = 0;
    bool is_upside_down = false;
    bool is_mirrored = false;

    /// `moved 1 pixel to the left and turned upside down`
    std::string text() const {
        std::vector<std::string> parts;
        const auto add_move = [&parts](int by, const Words& forward, const Words& backward) {
            if (by != 0)
                parts.push_back(said("moved {} {}",
                                     said_count(static_cast<unsigned>(std::abs(by)), "pixel"),
                                     (by > 0 ? forward : backward).in(language_of_steps())));
        };
        add_move(right, "to the right", "to the left");
        add_move(down, "down", "up");
        if (is_upside_down)
            parts.push_back(said("turned upside down"));
        if (is_mirrored)
            parts.push_back(said("mirrored left to right"));
        return joined(parts, said(" and "));
    }
};

class PictureHeldAgainst {
public:
    PictureHeldAgainst(const OwnedPicture& drawn, const Picture& picture,
                       const PictureDiffOptions& options)
        : drawn_(drawn), picture_(picture), options_(options),
          background_(
              background_beside(picture, options.background,
                                [this](int x, int row) { return drawn_at(x, row) != no_color; })),
          has_colors_(options.compares_colors && picture.has_colors) {}

    /// The picture on the canvas of the trace. What has the color of the background counts as drawn where the trace
    /// has drawn in that color.
    OwnedPicture on_canvas() const {
        OwnedPicture owned(drawn_.canvas());
        for (int row = 0; row < picture_.height; ++row)
            for (int x = 0; x < picture_.width; ++x)
                if (const Color color = seen_at(x, row, drawn_at(x, row)); color != no_color)
                    owned.put(pixel_at(x, row), color);
        return owned;
    }

    /// How another placement of the picture explains what differs; "" if none explains most of it. Half of a side is too
    /// far to move, and two pixels are too few to turn over: that would explain anything.
    std::string placement_remark(std::uint64_t differing) const {
        constexpr int farthest = 2;
        constexpr int enough = 1 << 18; // of a large picture not every row is looked at
        const int pixels = picture_.width * picture_.height;
        const int step = std::max(1, pixels / enough);
        Placement best;
        std::uint64_t fewest = place({}, step).differing;
        const int most_right = std::min(farthest, (picture_.width - 1) / 2);
        const int most_down = std::min(farthest, (picture_.height - 1) / 2);
        for (int turned = 0; turned < (pixels > 2 ? 4 : 1); ++turned)
            for (int down = -most_down; down <= most_down; ++down)
                for (int right = -most_right; right <= most_right; ++right) {
                    const Placement placement{right, down, (turned & 1) != 0, (turned & 2) != 0};
                    const Placed placed = place(placement, step);
                    if (placed.differing < fewest && placed.common * 2 > placed.drawn) {
                        fewest = placed.differing;
                        best = placement;
                    }
                }
        fewest = place(best).differing;
        constexpr std::uint64_t explains = 4;
        if (fewest * explains > differing)
            return "";
        return said("{} {}: then {}", options_.is_picture_first ? said("a is b,") : said("b is a,"),
                    best.text(),
                    fewest == 0 ? said("nothing differs") : counted_differences(fewest, "pixel"));
    }

    bool has_colors() const { return has_colors_; }

    /// What is not drawn; `no_color` if only what is transparent is.
    Color background() const { return background_; }

private:
    Pixel pixel_at(int x, int row) const {
        const Canvas& canvas = drawn_.canvas();
        return {canvas.left() + x, canvas.top() + canvas.down() * row};
    }

    /// The trace's color, `no_color` beside its canvas.
    Color drawn_at(int x, int row) const { return drawn_.color(pixel_at(x, row)); }

    /// The picture's pixel, `no_color` where it is not drawn; `drawn` is what the trace has there.
    Color seen_at(int x, int row, Color drawn) const {
        const Color color = picture_.at(x, row);
        if (color.alpha() == 0 || color == no_color)
            return no_color;
        if (color != background_)
            return color;
        return has_colors_ && drawn != no_color && are_near(color, drawn, options_.color_tolerance)
                   ? drawn
                   : no_color;
    }

    struct Placed {
        std::uint64_t differing = 0;
        std::uint64_t common = 0; ///< drawn by both
        std::uint64_t drawn = 0;  ///< by the trace
    };

    /// How many pixels are which if the picture is placed so: also of those that are moved off the canvas.
    Placed place(const Placement& placement, int step = 1) const {
        Placed placed;
        const int beside = std::abs(placement.right);
        const int beyond = step == 1 ? std::abs(placement.down) : 0;
        for (int row = -beyond; row < picture_.height + beyond; row += step)
            for (int x = -beside; x < picture_.width + beside; ++x) {
                const Color drawn = drawn_at(x, row);
                int from_x = x + placement.right;
                int from_row = row + placement.down;
                if (placement.is_mirrored)
                    from_x = picture_.width - 1 - from_x;
                if (placement.is_upside_down)
                    from_row = picture_.height - 1 - from_row;
                const bool is_inside = from_x >= 0 && from_x < picture_.width && from_row >= 0 &&
                                       from_row < picture_.height;
                const Color seen = is_inside ? seen_at(from_x, from_row, drawn) : no_color;
                const bool is_in_both = drawn != no_color && seen != no_color;
                const bool is_alike =
                    is_in_both ? !has_colors_ || are_near(drawn, seen, options_.color_tolerance)
                               : drawn == seen;
                placed.differing += is_alike ? 0 : 1;
                placed.common += is_in_both ? 1 : 0;
                placed.drawn += drawn != no_color ? 1 : 0;
            }
        return placed;
    }

    const OwnedPicture& drawn_;
    const Picture& picture_;
    const PictureDiffOptions& options_;
    Color background_;
    bool has_colors_;
};

} // namespace

PictureDiffOptions picture_options(const DiffOptions& options) {
    PictureDiffOptions of_pictures;
    of_pictures.compares_colors = !options.ignores("pixel.color") && !options.ignores("color");
    for (const DiffTolerance& tolerance : options.tolerances)
        if ((tolerance.kind.empty() || tolerance.kind == "pixel") &&
            (tolerance.field.empty() || tolerance.field == "color"))
            of_pictures.color_tolerance =
                static_cast<int>(std::clamp(tolerance.amount.nearest_double(), 0.0, 255.0));
    return of_pictures;
}

TraceDiff diff_with_picture(const Trace& trace, const Picture& picture,
                            const PictureDiffOptions& options) {
    const DrawnTrace drawn(trace);
    const Canvas& canvas = drawn.picture.canvas();
    if (canvas.width != picture.width || canvas.height != picture.height)
        throw problem_of(options.name,
                         fmt::format("expected a picture of {}x{} pixels, as the canvas of {} has, "
                                     "found one of {}x{}",
                                     canvas.width, canvas.height, trace.source().name,
                                     picture.width, picture.height));
    PictureDiffOptions how = options;
    if (!how.background)
        how.background = trace.background;
    const PictureHeldAgainst held(drawn.picture, picture, how);
    const OwnedPicture shown = held.on_canvas();
    const bool is_first = options.is_picture_first;
    const auto of_trace = [&drawn](std::uint32_t number) { return drawn.owner(number); };
    const auto of_picture = [](std::uint32_t) { return OwnerOfPixels{}; };
    const PictureOwners owners{.b_of_a = {},
                               .in_a = is_first ? PictureOwners::LookUp(of_picture) : of_trace,
                               .in_b = is_first ? PictureOwners::LookUp(of_trace) : of_picture};
    const PictureScope scope{.has_owners = false,
                             .has_colors = held.has_colors(),
                             .color_tolerance = options.color_tolerance,
                             .tells_owners = true};
    TraceDiff found{.name_a = is_first ? options.name : trace.source().name,
                    .name_b = is_first ? trace.source().name : options.name};
    found.picture = difference_between(is_first ? shown : drawn.picture,
                                       is_first ? drawn.picture : shown, owners, scope)
                        .first;
    const std::uint64_t differing = count_pixels(found);
    found.is_same = differing == 0;
    if (!held.has_colors())
        found.remarks.push_back(said("compared: what is drawn, without colors"));
    if (const Color background = held.background(); background != no_color)
        found.remarks.push_back(
            said("{}: what is {} is not drawn", is_first ? 'a' : 'b', to_text(background)));
    if (!found.is_same)
        if (std::string remark = held.placement_remark(differing); !remark.empty())
            found.remarks.push_back(std::move(remark));
    return found;
}

} // namespace rastertrace
