// SPDX-License-Identifier: MIT
// Fills with a painter that tells nobody. Compiled twice and compared by compare.sh: as they are, and
// with -DWITHOUT_EMISSIONS, which turns every call of a sink into nothing before it is compiled, except
// that of the painter with a row to paint. The name of a parameter (`Sink&& sink)`) or an argument is
// not followed by `(`, and stays.

#include <gmpxx.h>

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/raster/barycentric.h>
#include <rastertrace/core/raster/edge.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>
#include <rastertrace/core/raster/triangle.h>

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>
#include <type_traits>

namespace rastertrace {

/// True of what a painter paints.
template <typename Step> constexpr bool is_painted = false;
template <typename Scalar> constexpr bool is_painted<ScanlineSpanned<Scalar>> = true;

} // namespace rastertrace

#ifdef WITHOUT_EMISSIONS
#define sink_(...) static_cast<void>(0)
#define sink(...)                                                                                  \
    if constexpr (is_painted<std::remove_cvref_t<decltype(__VA_ARGS__)>>)                          \
    (sink)(__VA_ARGS__)
#endif
#include <rastertrace/core/draw/paint/fill_top_left.h>
#include <rastertrace/core/raster/fill_scanline.h>
#include <rastertrace/core/raster/flat_painter.h>

namespace rastertrace {

void scanline_with_doubles(const Triangle<double>& triangle, const SampleOffset<double>& offset,
                           const ScanlineRules& rules, const FlatPainter<>& painter,
                           const Canvas& canvas) {
    fill_scanline(triangle, offset, rules, canvas, painter);
}

void scanline_with_fractions(const Triangle<Fraction64>& triangle,
                             const SampleOffset<Fraction64>& offset, const ScanlineRules& rules,
                             const FlatPainter<>& painter, const Canvas& canvas) {
    fill_scanline(triangle, offset, rules, canvas, painter);
}

void top_left_with_doubles(const Triangle<double>& triangle, const SampleGrid<double>& grid,
                           const FlatPainter<>& painter, const Canvas& canvas) {
    fill_top_left(triangle, grid, canvas, painter);
}

void top_left_with_fractions(const Triangle<Fraction64>& triangle,
                             const SampleGrid<Fraction64>& grid, const FlatPainter<>& painter,
                             const Canvas& canvas) {
    fill_top_left(triangle, grid, canvas, painter);
}

} // namespace rastertrace
