// SPDX-License-Identifier: MIT
#pragma once

// The sink between algorithms and a listener: a step over a Scalar becomes a step over Quantity, if
// the listener takes its kind.

#include <rastertrace/core/draw/tell/listener.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

namespace rastertrace {

/// Converts steps over a Scalar to steps over Quantity. Their lists are valid as long as this object.
class Retelling {
public:
    template <typename Told, typename Field> Told as(const Field& field) {
        if constexpr (std::same_as<Told, Field>)
            return field;
        else if constexpr (std::same_as<Told, Quantity>)
            return Quantity(field);
        else
            return make(std::type_identity<Told>(), field);
    }

    template <typename Told, typename Step> Told step(const Step& step) {
        Told told;
        for_each_pair_of_fields(told, step, [this]<typename Field>(Field& to, const auto& from) {
            to = this->template as<Field>(from);
        });
        return told;
    }

private:
    template <typename Told, typename Field>
    Told make(std::type_identity<Told> /*told*/, const Field& vector) requires requires {
        vector.x;
    }
    {
        if constexpr (requires { vector.z; })
            return {as<Quantity>(vector.x), as<Quantity>(vector.y), as<Quantity>(vector.z)};
        else
            return {as<Quantity>(vector.x), as<Quantity>(vector.y)};
    }
    template <typename Value, std::size_t size, typename Field>
    std::array<Value, size> make(std::type_identity<std::array<Value, size>> /*told*/,
                                 const std::array<Field, size>& values) {
        std::array<Value, size> told;
        std::transform(values.begin(), values.end(), told.begin(),
                       [this](const Field& value) { return as<Value>(value); });
        return told;
    }
    template <typename Value, typename Field>
    std::span<const Value> make(std::type_identity<std::span<const Value>> /*told*/,
                                std::span<const Field> values) {
        const std::shared_ptr<Value> room(new Value[values.size()], std::default_delete<Value[]>());
        std::transform(values.begin(), values.end(), room.get(),
                       [this](const Field& value) { return as<Value>(value); });
        lists_.push_back(room);
        return {room.get(), values.size()};
    }
    template <typename Value, typename Field>
    std::optional<Value> make(std::type_identity<std::optional<Value>> /*told*/,
                              const std::optional<Field>& field) {
        return field ? std::optional(as<Value>(*field)) : std::nullopt;
    }
    template <typename Value, typename Field>
    OrNull<Value> make(std::type_identity<OrNull<Value>> /*told*/, const OrNull<Field>& field) {
        return field ? OrNull<Value>(as<Value>(*field)) : OrNull<Value>();
    }

    std::vector<std::shared_ptr<const void>> lists_;
};

/// A sink for every step, of every Scalar.
class ListenerSink {
public:
    explicit ListenerSink(const Listener& listener) : listener_(listener) {}

    const Listener& listener() const { return listener_; }

    template <typename Step> bool takes() const { return listener_.takes<Step>(); }

    template <typename Step> void operator()(const Step& step) const {
        using Told = typename AsTold<Step>::type;
        if (!listener_.takes<Step>())
            return;
        if constexpr (std::same_as<Step, Told>)
            listener_(step);
        else
            listener_(Retelling().step<Told>(step));
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
    bool is_heard() const { return listener_->takes<PrimitiveSkipped<>>(); }

    using NullSink::operator();
    void operator()(const PrimitiveSkipped<>& step) const { (*listener_)(step); }

private:
    const Listener* listener_;
};

} // namespace rastertrace
