// SPDX-License-Identifier: MIT
#pragma once

// The sink with which algorithms tell a listener: a step over a Scalar becomes one over Quantity, if the
// listener takes such.

#include <rastertrace/core/draw/tell/listener.h>
#include <rastertrace/core/numbers/quantity.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace rastertrace {

template <typename Scalar> std::optional<Quantity> quantity(const std::optional<Scalar>& number) {
    return number ? std::optional<Quantity>(*number) : std::nullopt;
}
template <typename Scalar> Vec<Quantity, 2> quantities(const Vec<Scalar, 2>& at) {
    return {at.x, at.y};
}
template <typename Scalar> Vec<Quantity, 3> quantities(const Vec<Scalar, 3>& at) {
    return {at.x, at.y, at.z};
}
template <typename Scalar> Matrix<Quantity> quantities(const Matrix<Scalar>& matrix) {
    Matrix<Quantity> result;
    for (std::size_t row = 0; row < 4; ++row)
        std::copy(matrix.rows[row].begin(), matrix.rows[row].end(), result.rows[row].begin());
    return result;
}

/// Steps without numbers are told as they are.
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
    listener(MatrixSetUp<Quantity>{.name = step.name,
                                   .object = step.object,
                                   .matrix = quantities(step.matrix),
                                   .factors = factors,
                                   .camera = camera});
}

template <typename Scalar> void tell(const VertexPlaced<Scalar>& step, const Listener& listener) {
    std::array<Quantity, 4> at;
    std::array<Quantity, 4> snapped;
    std::copy(step.at.begin(), step.at.end(), at.begin());
    std::copy(step.snapped.begin(), step.snapped.end(), snapped.begin());
    listener(VertexPlaced<Quantity>{.name = step.name,
                                    .space = step.space,
                                    .at = std::span(at).first(step.at.size()),
                                    .snapped = std::span(snapped).first(step.snapped.size())});
}

template <typename Scalar>
void tell(const PrimitivesOrdered<Scalar>& step, const Listener& listener) {
    const std::vector<Quantity> distances(step.distances.begin(), step.distances.end());
    listener(PrimitivesOrdered<Quantity>{
        .names = step.names, .distances = distances, .indices = step.indices});
}

template <typename Scalar> void tell(const FaceTested<Scalar>& step, const Listener& listener) {
    listener(FaceTested<Quantity>{.normal = quantities<Scalar>(step.normal),
                                  .view = quantities<Scalar>(step.view),
                                  .dot = step.dot,
                                  .cosine = step.cosine,
                                  .is_by_light = step.is_by_light,
                                  .is_culled = step.is_culled,
                                  .is_culled_opposite = step.is_culled_opposite});
}

template <typename Scalar> void tell(const FaceLit<Scalar>& step, const Listener& listener) {
    listener(FaceLit<Quantity>{.normal = quantities<Scalar>(step.normal),
                               .light = quantities<Scalar>(step.light),
                               .dot = step.dot,
                               .intensity = step.intensity,
                               .color = step.color});
}

template <typename Scalar> void tell(const PrimitiveBegan<Scalar>& step, const Listener& listener) {
    std::array<Vec<Quantity, 2>, 3> positions;
    std::transform(step.positions.begin(), step.positions.end(), positions.begin(),
                   [](const auto& at) { return quantities<Scalar>(at); });
    std::array<Quantity, 3> depths;
    std::copy(step.depths.begin(), step.depths.end(), depths.begin());
    listener(
        PrimitiveBegan<Quantity>{.kind = step.kind,
                                 .name = step.name,
                                 .vertices = step.vertices,
                                 .positions = std::span(positions).first(step.positions.size()),
                                 .color = step.color,
                                 .colors = step.colors,
                                 .octant = step.octant,
                                 .is_part = step.is_part,
                                 .depths = std::span(depths).first(step.depths.size()),
                                 .is_painted = step.is_painted});
}

template <typename Scalar> void tell(const EdgeSetUp<Scalar>& step, const Listener& listener) {
    listener(EdgeSetUp<Quantity>{
        .edge = step.edge, .is_horizontal = step.is_horizontal, .dx_dy = step.dx_dy});
}

template <typename Scalar>
void tell(const EdgeFunctionSetUp<Scalar>& step, const Listener& listener) {
    listener(EdgeFunctionSetUp<Quantity>{
        .edge = step.edge, .a = step.a, .b = step.b, .is_top_left = step.is_top_left});
}

template <typename Scalar>
void tell(const ScanlineSpanned<Scalar>& step, const Listener& listener) {
    listener(ScanlineSpanned<Quantity>{.y = step.y,
                                       .left = step.left,
                                       .right = step.right,
                                       .from = step.from,
                                       .to = step.to,
                                       .left_edge = step.left_edge,
                                       .right_edge = step.right_edge,
                                       .left_depth = quantity(step.left_depth),
                                       .right_depth = quantity(step.right_depth)});
}

template <typename Scalar> void tell(const LineSampled<Scalar>& step, const Listener& listener) {
    listener(LineSampled<Quantity>{
        .is_x_major = step.is_x_major, .at = step.at, .value = step.value, .pixel = step.pixel});
}

template <typename Scalar> void tell(const SampleTested<Scalar>& step, const Listener& listener) {
    listener(SampleTested<Quantity>{.pixel = step.pixel,
                                    .weights = {step.weights[0], step.weights[1], step.weights[2]},
                                    .is_inside = step.is_inside});
}

template <typename Scalar> void tell(const DepthTested<Scalar>& step, const Listener& listener) {
    listener(DepthTested<Quantity>{.pixel = step.pixel,
                                   .depth = step.depth,
                                   .stored = quantity(step.stored),
                                   .passes = step.passes,
                                   .reason = step.reason,
                                   .other = step.other});
}

/// A sink for every step, of every Scalar.
class ListenerSink {
public:
    explicit ListenerSink(const Listener& listener) : listener_(listener) {}

    template <typename Step> bool takes() const { return listener_.takes<Step>(); }

    bool reads_corners() const { return listener_.reads_corners(); }

    template <typename Step> void operator()(const Step& step) const {
        if (listener_.takes<Step>())
            tell(step, listener_);
    }

private:
    const Listener& listener_;
};

} // namespace rastertrace
