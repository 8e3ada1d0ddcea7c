// SPDX-License-Identifier: MIT
// The fill with a sink that keeps nothing. Compiled twice and compared by compare.sh: as it is, and
// with -DWITHOUT_EMISSIONS, which turns every call of a sink into nothing before it is compiled.
// The name of a parameter (`Sink&& sink)`) or an argument is not followed by `(`, and stays.

#include <gmpxx.h>

#include <rastertrace/core/canvas.h>
#include <rastertrace/core/edge.h>
#include <rastertrace/core/image.h>
#include <rastertrace/core/rounding.h>
#include <rastertrace/core/scalar.h>
#include <rastertrace/core/sink.h>
#include <rastertrace/core/steps.h>
#include <rastertrace/core/triangle.h>

#include <algorithm>
#include <array>

#ifdef WITHOUT_EMISSIONS
#define sink(...) static_cast<void>(0)
#endif
#include <rastertrace/core/fill_scanline.h>

namespace rastertrace {

void fill_with_doubles(const Triangle<double>& triangle, Color color, const ScanlineRules& rules,
                       Image& image) {
    fill_scanline(triangle, color, rules, image, NullSink{});
}

void fill_with_fractions(const Triangle<Fraction64>& triangle, Color color,
                         const ScanlineRules& rules, Image& image) {
    fill_scanline(triangle, color, rules, image, NullSink{});
}

} // namespace rastertrace
