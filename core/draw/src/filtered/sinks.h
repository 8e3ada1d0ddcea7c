// SPDX-License-Identifier: MIT
#pragma once

// The sinks between `adaptive` and a listener: one that emits nothing and finds out whether doubles
// can express all steps, one for an undecided primitive, and one for a piece that is decided.

#include "tell/listener_sink.h"

#include <rastertrace/core/draw/filtered/exactly.h>
#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/numbers/adaptive.h>
#include <rastertrace/core/raster/steps.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <span>

namespace rastertrace {

inline bool is_finite(const Quantity& number) {
    return number.visit([]<typename Scalar>(const Scalar& value) {
        if constexpr (std::floating_point<Scalar>)
            return std::isfinite(value);
        else
            return true;
    });
}
inline bool is_finite(double number) {
    return std::isfinite(number);
}
template <typename Number> bool is_finite(const std::optional<Number>& number) {
    return !number || is_finite(*number);
}
inline bool is_finite(const Vec<Quantity, 3>& at) {
    return is_finite(at.x) && is_finite(at.y) && is_finite(at.z);
}
inline bool is_finite(std::span<const Quantity> numbers) {
    return std::all_of(numbers.begin(), numbers.end(),
                       [](const Quantity& number) { return is_finite(number); });
}

/// Takes the steps that a listener takes, and emits none. Throws Undecided at a step with a number
/// that has overflowed: it can only be emitted in exact numbers.
class Certifier {
public:
    explicit Certifier(const Listener& listener) : listener_(listener) {}

    template <typename Step> bool takes() const { return listener_.takes<Step>(); }

    template <typename Step> void operator()(const Step&) const {}
    void operator()(const VertexPlaced<Quantity>& step) const { require(step.at); }
    void operator()(const FaceTested<Quantity>& step) const {
        require(step.normal, step.view, step.dot, step.cosine);
    }
    void operator()(const FaceLit<Quantity>& step) const {
        require(step.normal, step.light, step.dot, step.intensity);
    }
    void operator()(const EdgeSetUp<Quantity>& step) const { require(step.dx_dy); }
    void operator()(const EdgeFunctionSetUp<Quantity>& step) const { require(step.a, step.b); }
    void operator()(const ScanlineSpanned<Quantity>& step) const {
        require(step.left, step.right, step.left_depth, step.right_depth);
    }
    void operator()(const RowCrossed<Quantity>& step) const { require(step.x); }
    void operator()(const LineSampled<Quantity>& step) const { require(step.value); }
    void operator()(const SampleTested<Quantity>& step) const {
        require(std::span<const Quantity>(step.weights));
    }

private:
    template <typename... Numbers> static void require(const Numbers&... numbers) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        if (!(is_finite(numbers) && ...))
            Adaptive::leave_open(infinity, infinity);
    }

    const Listener& listener_;
};

/// Emits all steps of a primitive that is undecided, and BoundExceeded after the first
/// PrimitiveBegan.
class TellingUndecided {
public:
    TellingUndecided(const Listener& listener, const Undecided& undecided)
        : listener_(listener), undecided_(undecided) {}

    template <typename Step> bool takes() const { return listener_.takes<Step>(); }
    template <typename Step>
    requires std::same_as<Step, PrimitiveBegan<Quantity>>
    bool takes() const { return listener_.takes<Step>() || listener_.takes<BoundExceeded>(); }

    template <typename Step> void operator()(const Step& step) { listener_(step); }
    void operator()(const PrimitiveBegan<Quantity>& step) {
        listener_(step);
        if (!is_told_)
            listener_(
                BoundExceeded{.difference = undecided_.difference, .error = undecided_.error});
        is_told_ = true;
    }

private:
    const Listener& listener_;
    Undecided undecided_;
    bool is_told_ = false;
};

/// The double nearest to dx/dy of an edge whose vertices are doubles. Returns nullopt if the
/// remainder of the division, dx - q dy, does not decide which double is the nearest.
inline std::optional<double> nearest_slope(const Vec<Adaptive, 2>& from,
                                           const Vec<Adaptive, 2>& to) {
    if (from.x.error() + from.y.error() + to.x.error() + to.y.error() != 0)
        return std::nullopt;
    const Adaptive dx = to.x - from.x;
    const Adaptive dy = to.y - from.y;
    const double quotient = dx.value() / dy.value();
    const double magnitude = std::abs(quotient);
    // Away from underflow and overflow.
    if (!(magnitude > 0x1p-400 && magnitude < 0x1p400 && std::abs(dy.value()) > 0x1p-100))
        return std::nullopt;
    const double rest = std::fma(-quotient, dy.value(), dx.value());
    const double off = (std::abs(rest) + dx.error() + magnitude * dy.error()) * Adaptive::widening;
    const double to_next = magnitude - std::nextafter(magnitude, 0.0);
    const double smallest_dy = (std::abs(dy.value()) - dy.error()) / Adaptive::widening;
    return off < to_next / 2 * smallest_dy ? std::optional(quotient) : std::nullopt;
}

/// Emits the steps of a piece that is decided, with each slope rounded to the nearest double.
class NearestSlopes {
public:
    NearestSlopes(const Listener& listener, const Piece<Adaptive>& piece, Exactness& exactness)
        : sink_(listener), piece_(piece), exactness_(exactness) {}

    template <typename Step> bool takes() const { return sink_.takes<Step>(); }
    bool reads_corners() const { return sink_.reads_corners(); }

    template <typename Step> void operator()(const Step& step) const { sink_(step); }
    void operator()(const EdgeSetUp<Adaptive>& step) const {
        EdgeSetUp<Adaptive> told = step;
        if (takes<EdgeSetUp<Adaptive>>() && step.dx_dy.error() != 0)
            told.dx_dy = Adaptive(slope_of(step.edge));
        sink_(told);
    }

private:
    double slope_of(EdgeName edge) const {
        if (const auto slope =
                nearest_slope(piece_.corners()[edge.from], piece_.corners()[edge.to]))
            return *slope;
        const auto exact = exactness_.pieces.piece(exactness_.drawn.back());
        const auto& from = exact.corners()[edge.from];
        const auto& to = exact.corners()[edge.to];
        return nearest_double(Rational((to.x - from.x) / (to.y - from.y)));
    }

    ListenerSink sink_;
    const Piece<Adaptive>& piece_;
    Exactness& exactness_;
};

} // namespace rastertrace
