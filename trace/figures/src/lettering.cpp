// SPDX-License-Identifier: MIT
#include "lettering.h"

#include "font.h"
#include "stroke.h"

#include <rastertrace/trace/text/text.h>

#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

void add_lettering(const Label& label, double scale, double rim, PixelCoverage& coverage) {
    const double size = label.size * scale;
    if (size <= 0)
        return;
    const Typeface face = label.is_fixed_width ? Typeface::fixed_width
                          : label.is_bold      ? Typeface::bold
                                               : Typeface::regular;
    // Letters beside one another from x = 0 on.
    std::vector<Path> contours;
    double width = 0;
    const std::string text = printable(shown_text(label));
    for (std::string_view rest = text; !rest.empty();) {
        const CodePoint character = first_code_point(rest);
        rest.remove_prefix(character.length);
        Outline letter = outline_of(character.value, face, size);
        for (Path& contour : letter.contours) {
            for (Place& place : contour)
                place.x += width;
            contours.push_back(std::move(contour));
        }
        width += letter.advance;
    }

    const double shift = label.anchor == Anchor::start    ? 0
                         : label.anchor == Anchor::middle ? width / 2
                                                          : width;
    const auto whole = [](double pixels) { return std::floor(pixels + 0.5); };
    for (Path& contour : contours) {
        for (Place& place : contour)
            place = label.is_turned ? Place{whole(label.at.x * scale) + place.y,
                                            label.at.y * scale - (place.x - shift)}
                                    : Place{label.at.x * scale + (place.x - shift),
                                            whole(label.at.y * scale) + place.y};
        if (rim > 0)
            add_stroke(contour, {.width = 2 * rim, .joins_ends = true}, coverage);
        coverage.add(contour);
    }
}

} // namespace rastertrace
