// SPDX-License-Identifier: MIT
#pragma once

// A listener to the steps of a drawing: any callable that takes some kind of step, its numbers as
// Quantity.
//
//     int plotted = 0;
//     draw(scene, plan, [&](const PixelPlotted&) { ++plotted; });
//
// It is asked once which kinds it takes; no others are put together. A callable that takes
// PrimitiveBegan for its names alone has a member reads_corners() that returns false.

#include <rastertrace/core/numbers/quantity.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>

#include <memory>
#include <tuple>

namespace rastertrace {

/// A step as a listener gets it: its numbers as Quantity.
template <typename Step> struct AsTold { using type = Step; };
template <template <typename> typename Step, typename Scalar> struct AsTold<Step<Scalar>> {
    using type = Step<Quantity>;
};

/// Refers to a callable, and lives no longer than it.
class Listener {
public:
    /// Takes no step.
    Listener() = default;

    /// `callable` takes steps by `callable(step)`. If it has a member `takes<Step>()`, that is
    /// asked first: a kind of which it is false is never handed over.
    template <typename Callable>
    requires(std::is_class_v<std::remove_cvref_t<Callable>> &&
             !std::same_as<std::remove_cvref_t<Callable>, Listener>)
        Listener(Callable&& callable) // NOLINT: what is called with steps is a listener
        : callable_(const_cast<void*>(static_cast<const void*>(std::addressof(callable)))) {
        std::apply(
            [&callable]<typename... Steps>(Way<Steps>&... ways) {
                static_assert((std::invocable<Callable&, const Steps&> || ...),
                              "it can be called with no kind of step (steps.h), over Quantity");
                (find_way(callable, ways), ...);
            },
            ways_);
        if constexpr (requires { callable.reads_corners(); })
            reads_corners_ = callable.reads_corners();
    }

    /// True if there is no kind of step that it takes.
    bool takes_nothing() const {
        return std::apply([](const auto... ways) { return ((ways == nullptr) && ...); }, ways_);
    }

    /// True if it takes such steps, over whatever Scalar.
    template <typename Step> bool takes() const {
        return std::get<Way<typename AsTold<Step>::type>>(ways_) != nullptr;
    }

    /// True if it takes a step that fires while a primitive is drawn, but for PrimitiveSkipped.
    bool takes_pixels() const {
        return takes<EdgeSetUp<Quantity>>() || takes<EdgeFunctionSetUp<Quantity>>() ||
               takes<SideBegan>() || takes<HalfBegan>() || takes<RayBegan>() ||
               takes<RowCrossed<Quantity>>() || takes<ScanlineSpanned<Quantity>>() ||
               takes<LineSampled<Quantity>>() || takes<LineDecided>() ||
               takes<SampleTested<Quantity>>() || takes<DepthTested<Quantity>>() ||
               takes<PixelPlotted>() || takes<PixelsRejected>() || takes<RowsRejected>();
    }

    /// True if it takes PrimitiveBegan, and may read its positions and depths. For one that does
    /// not, filtered doubles need no exact ones.
    bool reads_corners() const { return reads_corners_ && takes<PrimitiveBegan<Quantity>>(); }

    /// Hands a step over Quantity, or one without numbers, to the callable if it takes such.
    template <typename Step> void operator()(const Step& step) const {
        if (const auto way = std::get<Way<Step>>(ways_))
            way(callable_, step);
    }

private:
    /// How a kind of step comes to the callable.
    template <typename Step> using Way = void (*)(void* callable, const Step& step);
    using Ways =
        std::tuple<Way<MatrixSetUp<Quantity>>, Way<VertexPlaced<Quantity>>,
                   Way<PrimitivesOrdered<Quantity>>, Way<FaceTested<Quantity>>,
                   Way<FaceLit<Quantity>>, Way<PrimitiveClipped>, Way<PrimitiveBegan<Quantity>>,
                   Way<EdgeSetUp<Quantity>>, Way<EdgeFunctionSetUp<Quantity>>, Way<SideBegan>,
                   Way<HalfBegan>, Way<RayBegan>, Way<RowCrossed<Quantity>>,
                   Way<ScanlineSpanned<Quantity>>, Way<LineSampled<Quantity>>, Way<LineDecided>,
                   Way<SampleTested<Quantity>>, Way<DepthTested<Quantity>>, Way<PixelPlotted>,
                   Way<PixelsRejected>, Way<RowsRejected>, Way<BoundExceeded>,
                   Way<PrimitiveSkipped>, Way<FaceTriangulated<Quantity>>>;

    template <typename Callable, typename Step>
    static void find_way(Callable& callable, Way<Step>& way) {
        if constexpr (std::invocable<Callable&, const Step&>)
            if (rastertrace::takes<Step>(callable))
                way = [](void* called, const Step& step) {
                    (*static_cast<Callable*>(called))(step);
                };
    }

    void* callable_ = nullptr;
    Ways ways_{};
    bool reads_corners_ = true;
};

} // namespace rastertrace
