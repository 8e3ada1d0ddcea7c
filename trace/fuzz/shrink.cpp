// SPDX-License-Identifier: MIT
#include "shrink.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// How many bits a fraction needs; 0 for a whole number.
int bits_of_fraction(std::int64_t value) {
    constexpr int bits_of_unit = std::bit_width(static_cast<std::uint64_t>(fuzz_unit)) - 1;
    return value == 0
               ? 0
               : std::max(0, bits_of_unit - std::countr_zero(static_cast<std::uint64_t>(value)));
}

/// A number with fewer bits behind the point is simpler; then a smaller one, then one that is not negative.
bool is_simpler(std::int64_t a, std::int64_t b) {
    const auto rank = [](std::int64_t value) {
        return std::tuple(bits_of_fraction(value), std::abs(value), value < 0);
    };
    return rank(a) < rank(b);
}

/// Simpler numbers to try instead of one, the simplest first.
std::vector<std::int64_t> simpler_numbers(std::int64_t value) {
    std::vector<std::int64_t> numbers{0};
    for (std::int64_t step = fuzz_unit; step > 0; step /= 2) {
        const std::int64_t down = value - ((value % step) + step) % step;
        numbers.insert(numbers.end(), {down, down + step, value / 2 / step * step});
    }
    // Large ones shrink by parts of themselves, then by one.
    for (std::int64_t part = 2; part <= std::abs(value) / fuzz_unit; part *= 2)
        numbers.push_back((value - value / part) / fuzz_unit * fuzz_unit);
    const std::int64_t toward_zero = value > 0 ? -fuzz_unit : fuzz_unit;
    numbers.insert(numbers.end(), {value + toward_zero, -value});
    std::erase_if(numbers, [value](std::int64_t one) { return !is_simpler(one, value); });
    std::ranges::sort(numbers, is_simpler);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
}

class Shrinking {
public:
    Shrinking(FuzzScene scene, const std::function<bool(const FuzzScene&)>& fails,
              std::size_t most_tries)
        : scene_(std::move(scene)), fails_(fails), most_tries_(most_tries) {}

    Shrunk run() && {
        for (bool goes_on = true; goes_on;) {
            // In this order: what makes all that follows faster comes first.
            const bool has_fewer = drop_primitives();
            const bool is_smaller = crop();
            const bool has_joined = join_vertices();
            const bool is_nearer = shift();
            const bool is_simple = simplify_numbers();
            goes_on = has_fewer || is_smaller || has_joined || is_nearer || is_simple;
        }
        return {std::move(scene_), tries_};
    }

private:
    /// Takes a scene if it still fails.
    bool takes(FuzzScene other) {
        if (tries_ >= most_tries_)
            return false;
        ++tries_;
        if (!fails_(other))
            return false;
        scene_ = std::move(other);
        return true;
    }

    /// Drops halves of the primitives, then quarters, ..., then one after the other (Zeller, Hildebrandt, Simplifying and
    /// isolating failure-inducing input, 2002).
    bool drop_primitives() {
        bool has_dropped = false;
        for (std::size_t size = scene_.primitives.size() / 2; size > 0; size /= 2)
            for (std::size_t end = scene_.primitives.size(); end >= size && end > 0;) {
                FuzzScene other = scene_;
                const auto last = other.primitives.begin() + static_cast<std::ptrdiff_t>(end);
                other.primitives.erase(last - static_cast<std::ptrdiff_t>(size), last);
                if (!other.primitives.empty() && takes(std::move(other)))
                    has_dropped = true;
                end -= std::min(end, size);
                end = std::min(end, scene_.primitives.size());
            }
        return has_dropped;
    }

    bool crop() {
        bool is_smaller = false;
        for (int FuzzScene::*const side : {&FuzzScene::width, &FuzzScene::height})
            for (int size = 1; size < scene_.*side;) {
                FuzzScene other = scene_;
                other.*side = size;
                if (takes(std::move(other)))
                    is_smaller = true;
                else
                    size = size < scene_.*side / 2 ? size * 2 : size + 1;
            }
        return is_smaller;
    }

    /// Moves everything by whole pixels to where coordinates are smallest.
    bool shift() {
        bool is_nearer = false;
        for (std::size_t axis = 0; axis < 2 && scene_.kind != FuzzKind::clip; ++axis) {
            const auto on_axis = [axis](const FuzzVertex& vertex) { return vertex[axis]; };
            const std::int64_t least =
                on_axis(std::ranges::min(fuzz_vertices(scene_), {}, on_axis));
            const std::int64_t by = least / fuzz_unit * fuzz_unit;
            if (by <= 0)
                continue;
            FuzzScene other = scene_;
            for (FuzzPrimitive& primitive : other.primitives)
                for (FuzzVertex& vertex : primitive.vertices)
                    vertex[axis] -= by;
            is_nearer = takes(std::move(other)) || is_nearer;
        }
        return is_nearer;
    }

    std::set<FuzzVertex> vertices() const {
        const std::vector<FuzzVertex> all = fuzz_vertices(scene_);
        return {all.begin(), all.end()};
    }

    FuzzScene with(const FuzzVertex& from, const FuzzVertex& to) const {
        FuzzScene other = scene_;
        for (FuzzPrimitive& primitive : other.primitives)
            std::ranges::replace(primitive.vertices, from, to);
        return other;
    }

    /// Puts one vertex in the place of another.
    bool join_vertices() {
        bool has_joined = false;
        for (const FuzzVertex& from : vertices())
            for (const FuzzVertex& to : vertices())
                if (from != to && vertices().contains(from) && takes(with(from, to)))
                    has_joined = true;
        return has_joined;
    }

    bool simplify_numbers() {
        bool is_simpler = false;
        for (const FuzzVertex& vertex : vertices()) {
            FuzzVertex at = vertex;
            for (std::size_t axis = 0; axis < at.size(); ++axis) {
                const std::int64_t simplest = axis == 3 ? fuzz_unit : 0; // a w is simple at 1
                for (const std::int64_t number : simpler_numbers(at[axis] - simplest)) {
                    FuzzVertex other = at;
                    other[axis] = number + simplest;
                    if (!takes(with(at, other)))
                        continue;
                    at = other;
                    is_simpler = true;
                    break;
                }
            }
        }
        return is_simpler;
    }

    FuzzScene scene_;
    const std::function<bool(const FuzzScene&)>& fails_;
    std::size_t most_tries_;
    std::size_t tries_ = 0;
};

} // namespace

Shrunk shrunk(FuzzScene scene, const std::function<bool(const FuzzScene&)>& fails,
              std::size_t most_tries) {
    return Shrinking(std::move(scene), fails, most_tries).run();
}

} // namespace rastertrace
