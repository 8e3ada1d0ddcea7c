// SPDX-License-Identifier: MIT
#pragma once

// A sink is anything that can be called with a step. An algorithm reports its decisions to one. The
// sink of a fill or a line is a painter (flat_painter.h), which paints the pixels and passes every
// step on to its own sink. A sink cannot change what is drawn, or what another sink receives.
//
//     fill_scanline(triangle, rules, canvas, FlatPainter(image, color));  // no sink
//     fill_scanline(triangle, rules, canvas, FlatPainter(image, color, sink));

#include <concepts>
#include <type_traits>

namespace rastertrace {

/// A sink that takes every one of these steps.
template <typename Sink, typename... Steps>
concept SinkFor = (std::invocable<Sink&, const Steps&> && ...);

/// Takes every step and keeps none. A fill whose painter passes its steps to a NullSink compiles to
/// the code of the plain rasterizer.
struct NullSink {
    template <typename Step> [[gnu::always_inline]] void operator()(const Step&) const {}
};

/// False for a NullSink: values that are only reported need not be computed.
template <typename Sink>
inline constexpr bool keeps_steps = !std::derived_from<std::remove_cvref_t<Sink>, NullSink>;

/// False if the sink ignores steps of this type: their values need not be computed. A sink without
/// a member takes<Step>() takes all steps.
template <typename Step, typename Sink> bool takes(const Sink& sink) {
    if constexpr (!keeps_steps<Sink>)
        return false;
    else if constexpr (requires { sink.template takes<Step>(); })
        return sink.template takes<Step>();
    else
        return true;
}

} // namespace rastertrace
