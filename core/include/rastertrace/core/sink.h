// SPDX-License-Identifier: MIT
#pragma once

// A sink is anything that can be called with a step. It is how an algorithm tells what it decided;
// no sink can change what is drawn or what another sink would see.
//
//     draw<double>(scene, plan, NullSink{});  // just the picture

#include <concepts>
#include <type_traits>

namespace rastertrace {

/// A sink that takes every one of these steps.
template <typename Sink, typename... Steps>
concept SinkFor = (std::invocable<Sink&, const Steps&> && ...);

/// Takes every step and keeps none. With it, the compiled code is that of the plain rasterizer.
struct NullSink {
    template <typename Step> [[gnu::always_inline]] void operator()(const Step&) const {}
};

/// False for a NullSink: what is worked out only to be reported need not be.
template <typename Sink>
inline constexpr bool keeps_steps = !std::same_as<std::remove_cvref_t<Sink>, NullSink>;

} // namespace rastertrace
