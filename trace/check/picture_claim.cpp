// SPDX-License-Identifier: MIT
#include "picture_claim.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <string>

namespace rastertrace {

namespace {

/// A part of a canvas: columns from x0 to x1 and rows from the top, both included.
struct Part {
    int x0, x1, row0, row1;
    int width() const { return std::max(0, x1 - x0 + 1); }
    int height() const { return std::max(0, row1 - row0 + 1); }
};

/// The smallest part with all that is drawn.
Part drawn_part(const Frame& frame) {
    const Canvas& canvas = frame.image.canvas();
    Part part{canvas.right() + 1, canvas.left() - 1, canvas.height, -1};
    for (int row = 0; row < canvas.height; ++row)
        for (int x = canvas.left(); x <= canvas.right(); ++x)
            if (frame.drawn_by[canvas.offset_of({x, canvas.y_of(row)})] != 0)
                part = {std::min(part.x0, x), std::max(part.x1, x), std::min(part.row0, row), row};
    return part;
}

/// The part that a picture of this size shows: all of the canvas, or what is drawn.
Part part_shown(const Claim& claim, const Claims& claims, const Frame& frame) {
    const Canvas& canvas = frame.image.canvas();
    const Part whole{canvas.left(), canvas.right(), 0, canvas.height - 1};
    const Part drawn = drawn_part(frame);
    const auto fits = [&claim](const Part& part) {
        return claim.picture.size() == static_cast<std::size_t>(part.height()) &&
               std::all_of(claim.picture.begin(), claim.picture.end(), [&](const auto& row) {
                   return row.size() == static_cast<std::size_t>(part.width());
               });
    };
    if (fits(whole))
        return whole;
    if (fits(drawn))
        return drawn;
    std::size_t longest = 0;
    for (const std::string& row : claim.picture)
        longest = std::max(longest, row.size());
    throw problem_at(
        claims.source, claim.offset,
        fmt::format("expected a picture of {} columns and {} rows, or of {} and {} with "
                    "only what is drawn, found {} and {}",
                    whole.width(), whole.height(), drawn.width(), drawn.height(), longest,
                    claim.picture.size()),
        "`.` is an empty pixel; every row has the same length");
}

/// What the trace tells of a row, if one triangle has it: `left -1/4, right 25/8: -1..3`.
std::string row_text(const StepIndex& index, int y) {
    const auto& rows = index.find(StepKind::scanline, {{"y", std::to_string(y)}});
    if (rows.size() != 1)
        return {};
    const auto row = index.trace().step(rows.front()).as<ScanlineStep>();
    return fmt::format("  {}, {} -> {}..{}", row.left.text(), row.right.text(), row.from, row.to);
}

} // namespace

CheckedClaim check_picture(const Claim& claim, const Claims& claims, const StepIndex& decided) {
    const Frame& frame = decided.frame();
    const Canvas& canvas = frame.image.canvas();
    const Part part = part_shown(claim, claims, frame);
    CheckedClaim checked;
    std::size_t extra = 0;
    std::size_t missing = 0;
    bool is_open = true; // no pixel is claimed
    for (std::size_t i = 0; i < claim.picture.size(); ++i) {
        const int y = canvas.y_of(part.row0 + static_cast<int>(i));
        std::string row;
        bool is_right = true;
        for (std::size_t k = 0; k < claim.picture[i].size(); ++k) {
            const int x = part.x0 + static_cast<int>(k);
            is_open = is_open && claim.picture[i][k] == '?';
            if (claim.picture[i][k] == '?') {
                row += ' ';
                continue;
            }
            const bool is_drawn = frame.drawn_by[canvas.offset_of({x, y})] != 0;
            const bool is_claimed = claim.picture[i][k] != '.';
            row += is_drawn ? (is_claimed ? '#' : '?') : (is_claimed ? '!' : '.');
            extra += is_claimed && !is_drawn ? 1 : 0;
            missing += is_drawn && !is_claimed ? 1 : 0;
            is_right = is_right && is_drawn == is_claimed;
        }
        checked.picture.push_back(
            fmt::format("{:>4}  {}{}", y, row, is_right ? std::string() : row_text(decided, y)));
    }
    CheckedField field{.name = "picture"};
    if (extra + missing > 0) {
        field.verdict = checked.verdict = ClaimVerdict::wrong;
        field.expected = said("the picture");
        field.found = said("{} too many, {} missing", extra, missing);
    } else {
        field.verdict = is_open ? ClaimVerdict::open : ClaimVerdict::right;
        checked.picture.clear();
    }
    checked.fields.push_back(std::move(field));
    return checked;
}

} // namespace rastertrace
