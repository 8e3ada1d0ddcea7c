// SPDX-License-Identifier: MIT
// The fill with a sink that keeps nothing. Compiled twice and compared by compare.sh: as it is, and
// with -DWITHOUT_EMISSIONS, which turns every call of a sink into nothing before it is compiled.
// The name of a parameter (`Sink&& sink)`) or an argument is not followed by `(`, and stays.

#include <gmpxx.h>

#include <rastertrace/core/barycentric.h>
#include <rastertrace/core/edge.h>
#include <rastertrace/core/image.h>
#include <rastertrace/core/rounding.h>
#include <rastertrace/core/scalar.h>
#include <rastertrace/core/sink.h>
#include <rastertrace/core/steps.h>
#include <rastertrace/core/triangle.h>

#include <algorithm>
#include <array>
#include <tuple>

#ifdef WITHOUT_EMISSIONS
#define sink(...) static_cast<void>(0)
#endif
#include <rastertrace/core/fill_scanline.h>
#include <rastertrace/core/fill_top_left.h>

namespace rastertrace {

void scanline_with_doubles(const Triangle<double>& triangle, const Paint<double>& paint,
                           const ScanlineRules& rules, Image& image) {
    fill_scanline(triangle, paint, rules, image, NullSink{});
}

void scanline_with_fractions(const Triangle<Fraction64>& triangle, const Paint<Fraction64>& paint,
                             const ScanlineRules& rules, Image& image) {
    fill_scanline(triangle, paint, rules, image, NullSink{});
}

void top_left_with_doubles(const Triangle<double>& triangle, const Paint<double>& paint,
                           const SampleGrid<double>& grid, Image& image) {
    fill_top_left(triangle, paint, grid, image, NullSink{});
}

void top_left_with_fractions(const Triangle<Fraction64>& triangle, const Paint<Fraction64>& paint,
                             const SampleGrid<Fraction64>& grid, Image& image) {
    fill_top_left(triangle, paint, grid, image, NullSink{});
}

} // namespace rastertrace
