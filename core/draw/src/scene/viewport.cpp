// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/scene/viewport.h>

#include <rastertrace/core/draw/scene/model.h>
#include <rastertrace/core/transform/model.h>
#include <rastertrace/core/transform/viewport.h>

#include <algorithm>

namespace rastertrace {

std::vector<MatrixFactor<Rational>> factors_of(const Viewport& viewport, const Canvas& canvas) {
    switch (viewport.type) {
    case ViewportType::fit:
        return fit_to<Rational>({.left = canvas.left(),
                                 .lowest_y = std::min(canvas.top(), canvas.bottom()),
                                 .width = canvas.width,
                                 .height = canvas.height,
                                 .is_y_down = canvas.down() > 0});
    case ViewportType::pixels_per_unit: {
        const Rational scale = viewport.pixels_per_unit.exact();
        return {{"scale", scaling<Rational>({scale, scale, 1})}};
    }
    case ViewportType::none:
        break;
    }
    return {};
}

Matrix<Rational> viewport_matrix(const Viewport& viewport, const Canvas& canvas) {
    return product_of(factors_of(viewport, canvas));
}

Rational half_extent(const Viewport& viewport, int extent) {
    switch (viewport.type) {
    case ViewportType::fit:
        return 1;
    case ViewportType::pixels_per_unit:
        return Rational(extent) / (2 * abs(viewport.pixels_per_unit.exact()));
    case ViewportType::none:
        break;
    }
    return extent;
}

} // namespace rastertrace
