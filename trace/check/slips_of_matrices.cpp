// SPDX-License-Identifier: MIT
// The mistakes that people make with matrices.

#include "slip_results.h"

#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/trace/tell/step_text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <string_view>

namespace rastertrace {

namespace {

std::vector<SlipResult> rows_for_columns(const Formula& formula) {
    SlipResults results(formula);
    if (const Values& rows = results.right(); as_form<TakenOver>(formula) && rows.size() == 16) {
        Values transposed;
        for (std::size_t i = 0; i < rows.size(); ++i)
            transposed.push_back(rows[i % 4 * 4 + i / 4]);
        results.add(std::move(transposed));
    }
    const auto* product = as_form<MatrixTimes>(formula);
    if (product == nullptr || product->rows.size() != 4)
        return results.take();
    MatrixTimes transposed = *product;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 4; ++k)
            transposed.rows[i][k] = product->rows[k][i];
    results.add_formula({transposed});
    return results.take();
}

using Factor = MatrixTimes::Factor;

/// The product of factors times the point of `times`, as many components of it.
Values product_of(const std::vector<Factor>& factors, const MatrixTimes& times) {
    MatrixTimes::Row point = times.point;
    for (auto factor = factors.rbegin(); factor != factors.rend(); ++factor) {
        MatrixTimes::Row moved;
        for (std::size_t i = 0; i < 4; ++i)
            moved[i] = std::inner_product(factor->rows[i].begin(), factor->rows[i].end(),
                                          point.begin(), Rational(0));
        point = moved;
    }
    return {point.begin(), point.begin() + static_cast<std::ptrdiff_t>(times.rows.size())};
}

/// What comes of other factors, one of which is changed at a time.
template <typename Change>
std::vector<SlipResult> with_other_factors(const Formula& formula, std::string_view name,
                                           const Change& change) {
    SlipResults results(formula);
    const auto* const times = as_form<MatrixTimes>(formula);
    for (std::size_t i = 0; times != nullptr && i < times->factors.size(); ++i) {
        std::vector<Factor> factors = times->factors;
        if (factors[i].name == name && change(factors[i].rows))
            results.add(product_of(factors, *times));
    }
    return results.take();
}

std::vector<SlipResult> turned_the_other_way(const Formula& formula) {
    return with_other_factors(formula, "rotate", [](std::array<MatrixTimes::Row, 4>& rows) {
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < i; ++k)
                std::swap(rows[i][k], rows[k][i]);
        return true;
    });
}

/// The rotation about the same axis by an angle of which `other` gives the sine and the cosine.
template <typename Other>
std::vector<SlipResult> turned_by(const Formula& formula, const Other& other) {
    return with_other_factors(formula, "rotate", [&](std::array<MatrixTimes::Row, 4>& rows) {
        const auto entry = [&rows](std::size_t i, std::size_t k) {
            return nearest_double(rows[i][k]);
        };
        const std::array axis{(entry(2, 1) - entry(1, 2)) / 2, (entry(0, 2) - entry(2, 0)) / 2,
                              (entry(1, 0) - entry(0, 1)) / 2};
        const double sine = std::hypot(axis[0], axis[1], axis[2]);
        if (sine == 0)
            return false;
        const auto [other_sine, other_cosine] =
            other(sine, (entry(0, 0) + entry(1, 1) + entry(2, 2) - 1) / 2);
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const double a = axis[i] / sine;
                const double b = axis[k] / sine;
                const double turn =
                    i == k ? 0 : axis[3 - i - k] / sine * ((k + 1) % 3 == i ? 1 : -1);
                rows[i][k] = Rational((i == k ? other_cosine : 0) + (1 - other_cosine) * a * b +
                                      other_sine * turn);
            }
        return true;
    });
}

/// The number of degrees as if it were one of radians.
std::vector<SlipResult> degrees_for_radians(const Formula& formula) {
    return turned_by(formula, [](double sine, double cosine) {
        const double degrees =
            std::round(std::atan2(sine, cosine) * 180 / std::numbers::pi * 1e6) / 1e6;
        return std::pair(std::sin(degrees), std::cos(degrees));
    });
}

/// Of a face, the sine for the cosine; of a rotation, each for the other, whichever way the angle goes.
std::vector<SlipResult> complement_of_angle(const Formula& formula) {
    SlipResults results(formula);
    if (as_form<FaceCosine>(formula) && !results.right().empty())
        if (const Rational& cosine = results.right().front(); abs(cosine) <= 1)
            results.add(square_root(1 - cosine * cosine));
    for (const int way : {1, -1})
        for (SlipResult& turned : turned_by(formula, [way](double sine, double cosine) {
                 return std::pair(way * cosine, way * sine);
             }))
            results.add(std::move(turned.values));
    return results.take();
}

std::vector<SlipResult> factors_exchanged(const Formula& formula) {
    SlipResults results(formula);
    const auto* const times = as_form<MatrixTimes>(formula);
    for (std::size_t i = 1; times != nullptr && i < times->factors.size(); ++i) {
        std::vector<Factor> factors = times->factors;
        std::swap(factors[i - 1], factors[i]);
        results.add(product_of(factors, *times),
                    said("{} before {}", factors[i].name, factors[i - 1].name));
    }
    // Of two, that is the same. A viewport's are in one order in all texts.
    if (times != nullptr && times->factors.size() > 2 && !times->is_viewport) {
        std::vector<Factor> factors(times->factors.rbegin(), times->factors.rend());
        results.add(product_of(factors, *times), said("all of them"));
    }
    return results.take();
}

/// W/2 for (W - 1)/2, in x and y, or in one of them.
std::vector<SlipResult> size_for_last_pixel(const Formula& formula) {
    const auto* const times = as_form<MatrixTimes>(formula);
    if (times == nullptr || !times->is_viewport)
        return {};
    SlipResults results(formula);
    const std::vector<std::size_t> both{0, 1}, x{0}, y{1};
    for (const auto& axes : {both, x, y})
        for (SlipResult& one :
             with_other_factors(formula, "scale", [&axes](std::array<MatrixTimes::Row, 4>& rows) {
                 return std::count_if(axes.begin(), axes.end(), [&rows](std::size_t i) {
                            const bool is_size = abs(rows[i][i]) > 1;
                            rows[i][i] += is_size ? Rational(sgn(rows[i][i])) / 2 : Rational(0);
                            return is_size;
                        }) > 0;
             }))
            results.add(std::move(one.values));
    return results.take();
}

constexpr Slip matrix_slips[] = {
    {"turned-the-other-way", as_mistake, as_mistake, as_mistake, 30, turned_the_other_way},
    {"degrees-for-radians", "the number of degrees taken for radians", "degrees",
     "the angle seems to be any", 30, degrees_for_radians},
    {"factors-exchanged", as_mistake, as_mistake, as_mistake, 30, factors_exchanged},
    {"size-for-last-pixel", as_mistake, as_mistake, as_mistake, 30, size_for_last_pixel},
    {"complement-of-angle", "the sine, as of 90 degrees less the angle", "the cosine of the angle",
     "bright where it should be dark, turned by 90 degrees less the angle", 5, complement_of_angle},
    {"rows-for-columns", "the columns of the matrix taken for rows", "its rows",
     "turned the other way, and moved nowhere", 20, rows_for_columns},
};

} // namespace

std::span<const Slip> slips_of_matrices() {
    return matrix_slips;
}

} // namespace rastertrace
