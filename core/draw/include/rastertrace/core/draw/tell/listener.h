// SPDX-License-Identifier: MIT
#pragma once

// A listener to the steps of a drawing: any callable that takes some kind of step, its numbers as
// Quantity.
//
//     int plotted = 0;
//     draw(scene, plan, [&](const PixelPlotted<>&) { ++plotted; });
//
// It is asked once which kinds it takes; no others are put together.

#include <rastertrace/core/numbers/quantity.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>

#include <memory>
#include <tuple>
#include <variant>

namespace rastertrace {

/// A step as a listener gets it: its numbers as Quantity.
template <typename Step> struct AsTold;
template <template <typename> typename Step, typename Scalar> struct AsTold<Step<Scalar>> {
    using type = Step<Quantity>;
};

/// True if a sink can be called with such a step, or one that may be changed ...
template <typename Sink, typename Step>
concept CallableWith = requires(Sink& sink, Step& step) {
    sink(step);
};

/// ... but over another scalar.
template <typename Sink, typename Step> inline constexpr bool takes_other_scalar = false;
template <typename Sink, template <typename> typename Step>
inline constexpr bool takes_other_scalar<Sink, Step<Quantity>> =
    CallableWith<Sink, const Step<double>> || CallableWith<Sink, const Step<float>> ||
    CallableWith<Sink, const Step<Rational>>;

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
        find_ways(callable, ways_);
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
        const auto is_one = []<typename Step>(Way<Step> way) {
            return StepKind::edge <= Step::step_kind && Step::step_kind <= StepKind::reject &&
                   way != nullptr;
        };
        return std::apply([&](const auto... ways) { return (is_one(ways) || ...); }, ways_);
    }

    /// Hands a step over Quantity, or one without numbers, to the callable if it takes such.
    template <typename Step> void operator()(const Step& step) const {
        if (const auto way = std::get<Way<Step>>(ways_))
            way(callable_, step);
    }

private:
    /// How a kind of step comes to the callable.
    template <typename Step> using Way = void (*)(void* callable, const Step& step);
    template <typename Variant> struct WaysOf;
    template <typename... Steps> struct WaysOf<std::variant<Steps...>> {
        using type = std::tuple<Way<Steps>...>;
    };
    using Ways = WaysOf<AnyStepOf<Quantity>>::type;

    template <typename Callable, typename... Steps>
    static void find_ways(Callable& callable, std::tuple<Way<Steps>...>& ways) {
        static_assert((CallableWith<Callable, const Steps> || ...),
                      "it can be called with no kind of step (steps.h), over Quantity");
        (find_way(callable, std::get<Way<Steps>>(ways)), ...);
    }

    template <typename Callable, typename Step>
    static void find_way(Callable& callable, Way<Step>& way) {
        if constexpr (CallableWith<Callable, const Step>) {
            if (rastertrace::takes<Step>(callable))
                way = [](void* called, const Step& step) {
                    (*static_cast<Callable*>(called))(step);
                };
        } else {
            // An overload that nobody would ever call is a mistake.
            static_assert(!CallableWith<Callable, Step>,
                          "a sink takes a step by a reference that is not const");
            static_assert(!takes_other_scalar<Callable, Step>,
                          "a sink takes a step over another scalar than Quantity");
        }
    }

    void* callable_ = nullptr;
    Ways ways_{};
};

} // namespace rastertrace
