// SPDX-License-Identifier: MIT
#pragma once

// The sink between algorithms and a listener: a step over a Scalar becomes a step over Quantity, if
// the listener takes its kind.

#include <rastertrace/core/draw/tell/listener.h>

#include <algorithm>
#include <vector>

namespace rastertrace {

template <typename Scalar> Vec<Quantity, 2> quantities(const Vec<Scalar, 2>& at) {
    return {at.x, at.y};
}
template <typename Scalar> Vec<Quantity, 3> quantities(const Vec<Scalar, 3>& at) {
    return {at.x, at.y, at.z};
}
template <typename Scalar> Matrix<Quantity> quantities(const Matrix<Scalar>& matrix) {
    return mapped<Quantity>(matrix, [](const Scalar& entry) { return Quantity(entry); });
}

/// Hands a step to the listener: field by field if it has numbers, else as it is.
template <typename Step> void tell(const Step& step, const Listener& listener) {
    listener(step);
}

template <typename Scalar> void tell(const MatrixSetUp<Scalar>& step, const Listener& listener) {
    std::vector<MatrixFactor<Quantity>> factors;
    for (const MatrixFactor<Scalar>& factor : step.factors)
        factors.push_back({factor.name, quantities(factor.matrix)});
    std::vector<Vec<Quantity, 3>> camera;
    for (const Vec<Scalar, 3>& vector : step.camera)
        camera.push_back(quantities<Scalar>(vector));
    listener(
        MatrixSetUp<Quantity>{step.name, step.object, quantities(step.matrix), factors, camera});
}

template <typename Scalar> void tell(const VertexPlaced<Scalar>& step, const Listener& listener) {
    std::array<Quantity, 4> at;
    std::array<Quantity, 4> snapped;
    std::copy(step.at.begin(), step.at.end(), at.begin());
    std::copy(step.snapped.begin(), step.snapped.end(), snapped.begin());
    listener(VertexPlaced<Quantity>{step.name, step.space, std::span(at).first(step.at.size()),
                                    std::span(snapped).first(step.snapped.size())});
}

template <typename Scalar>
void tell(const PrimitivesOrdered<Scalar>& step, const Listener& listener) {
    const std::vector<Quantity> distances(step.distances.begin(), step.distances.end());
    listener(PrimitivesOrdered<Quantity>{step.names, distances, step.indices});
}

template <typename Scalar> void tell(const FaceTested<Scalar>& step, const Listener& listener) {
    const auto& [normal, view, dot, cosine, is_by_light, is_culled, is_culled_opposite] = step;
    listener(FaceTested<Quantity>{quantities<Scalar>(normal), quantities<Scalar>(view), dot, cosine,
                                  is_by_light, is_culled, is_culled_opposite});
}

template <typename Scalar> void tell(const FaceLit<Scalar>& step, const Listener& listener) {
    const auto& [normal, light, dot, intensity, color] = step;
    listener(FaceLit<Quantity>{quantities<Scalar>(normal), quantities<Scalar>(light), dot,
                               intensity, color});
}

template <typename Scalar> void tell(const PrimitiveBegan<Scalar>& step, const Listener& listener) {
    std::vector<Vec<Quantity, 2>> positions;
    positions.reserve(step.positions.size());
    for (const Vec<Scalar, 2>& at : step.positions)
        positions.push_back(quantities<Scalar>(at));
    const std::vector<Quantity> depths(step.depths.begin(), step.depths.end());
    std::vector<std::array<Quantity, 4>> levels;
    for (const auto& [red, green, blue, alpha] : step.levels)
        levels.push_back({red, green, blue, alpha});
    listener(PrimitiveBegan<Quantity>{step.kind, step.name, step.vertices, positions, step.color,
                                      step.colors, step.octant, step.is_part, depths,
                                      step.is_painted, step.radius, step.face, levels});
}

template <typename Scalar> void tell(const EdgeSetUp<Scalar>& step, const Listener& listener) {
    listener(EdgeSetUp<Quantity>{step.edge, step.is_horizontal, step.dx_dy});
}

template <typename Scalar> void tell(const RowCrossed<Scalar>& step, const Listener& listener) {
    const std::vector<Quantity> x(step.x.begin(), step.x.end());
    listener(RowCrossed<Quantity>{step.y, step.edges, x, step.winding});
}

template <typename Scalar>
void tell(const EdgeFunctionSetUp<Scalar>& step, const Listener& listener) {
    listener(EdgeFunctionSetUp<Quantity>{step.edge, step.a, step.b, step.is_top_left});
}

template <typename Scalar>
void tell(const ScanlineSpanned<Scalar>& step, const Listener& listener) {
    const auto& [y, left, right, from, to, left_edge, right_edge, left_depth, right_depth] = step;
    listener(ScanlineSpanned<Quantity>{y, left, right, from, to, left_edge, right_edge, left_depth,
                                       right_depth});
}

template <typename Scalar> void tell(const LineSampled<Scalar>& step, const Listener& listener) {
    listener(LineSampled<Quantity>{step.is_x_major, step.at, step.value, step.pixel});
}

template <typename Scalar> void tell(const SampleTested<Scalar>& step, const Listener& listener) {
    const auto& [a, b, c] = step.weights;
    listener(SampleTested<Quantity>{step.pixel, {a, b, c}, step.is_inside});
}

template <typename Scalar> void tell(const DepthTested<Scalar>& step, const Listener& listener) {
    const auto& [pixel, depth, stored, passes, reason, other] = step;
    listener(DepthTested<Quantity>{pixel, depth, stored, passes, reason, other});
}

/// A sink for every step, of every Scalar.
class ListenerSink {
public:
    explicit ListenerSink(const Listener& listener) : listener_(listener) {}

    template <typename Step> bool takes() const { return listener_.takes<Step>(); }

    template <typename Step> void operator()(const Step& step) const {
        if (listener_.takes<Step>())
            tell(step, listener_);
    }

private:
    const Listener& listener_;
};

/// A sink for what draws a piece if the listener takes no pixels (Listener::takes_pixels): tells that the piece is
/// skipped, and leaves the drawing as fast as with a NullSink.
class SkipSink : public NullSink {
public:
    explicit SkipSink(const Listener& listener) : listener_(&listener) {}

    /// True if the listener takes the step.
    bool is_heard() const { return listener_->takes<PrimitiveSkipped>(); }

    using NullSink::operator();
    void operator()(const PrimitiveSkipped& step) const { (*listener_)(step); }

private:
    const Listener* listener_;
};

} // namespace rastertrace
