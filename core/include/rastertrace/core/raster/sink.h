// SPDX-License-Identifier: MIT
#pragma once

// A sink is anything that can be called with a step. It is how an algorithm tells what it decided. The
// sink of a fill or a line is a painter (flat_painter.h, row_painter.h), which paints what it is told and
// tells it on; no sink behind that can change what is drawn or what another sink would see.
//
//     fill_scanline(triangle, rules, canvas, FlatPainter(image, color));        // tells nobody
//     fill_scanline(triangle, rules, canvas, FlatPainter(image, color, sink));

#include <concepts>
#include <type_traits>

namespace rastertrace {

/// A sink that takes every one of these steps.
template <typename Sink, typename... Steps>
concept SinkFor = (std::invocable<Sink&, const Steps&> && ...);

/// Takes every step and keeps none. With a painter that tells it, the compiled code of a fill is that of
/// the plain rasterizer.
struct NullSink {
    template <typename Step> [[gnu::always_inline]] void operator()(const Step&) const {}
};

/// False for a NullSink: what is worked out only to be reported need not be.
template <typename Sink>
inline constexpr bool keeps_steps = !std::derived_from<std::remove_cvref_t<Sink>, NullSink>;

/// False if the sink would not look at such a step: what is worked out only for it need not be. A
/// sink that says nothing about it, by takes<Step>(), takes all.
template <typename Step, typename Sink> bool takes(const Sink& sink) {
    if constexpr (!keeps_steps<Sink>)
        return false;
    else if constexpr (requires { sink.template takes<Step>(); })
        return sink.template takes<Step>();
    else
        return true;
}

} // namespace rastertrace
