// SPDX-License-Identifier: MIT
#include "replay_bytes.h"

#include "trace_index.h"

#include <algorithm>
#include <bit>
#include <initializer_list>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

constexpr std::size_t planes = sizeof(std::uint32_t);

/// Adds numbers: the lowest bytes of all, then the next ones.
void add_planes(const std::vector<std::uint32_t>& numbers, std::string& bytes) {
    for (std::size_t plane = 0; plane < planes; ++plane)
        for (const std::uint32_t number : numbers)
            bytes += static_cast<char>(number >> 8 * plane & 0xff);
}

/// Takes what add_planes has added from the front of some bytes.
class PlaneReader {
public:
    explicit PlaneReader(std::string_view bytes) : bytes_(bytes) {}

    std::vector<std::uint32_t> take(std::size_t count) {
        if (count > bytes_.size() / planes)
            throw StaleIndex();
        std::vector<std::uint32_t> numbers(count);
        for (std::size_t plane = 0; plane < planes; ++plane)
            for (std::size_t i = 0; i < count; ++i)
                numbers[i] |= std::uint32_t{static_cast<std::uint8_t>(bytes_[plane * count + i])}
                              << 8 * plane;
        bytes_.remove_prefix(count * planes);
        return numbers;
    }

private:
    std::string_view bytes_;
};

std::uint32_t in_32_bits(std::size_t number) {
    return static_cast<std::uint32_t>(number);
}

std::uint32_t bits_of(Color color) {
    return std::bit_cast<std::uint32_t>(color);
}

Color color_of(std::uint32_t bits) {
    return std::bit_cast<Color>(bits);
}

} // namespace

/// Knows what a replay is made of.
struct ReplayBytes {
    /// The numbers of a place: `visit` is called with each.
    template <typename Place, typename Visit> static void visit(Place& place, const Visit& visit) {
        for (auto* const number :
             {&place.step, &place.primitive, &place.scanline, &place.scanline_before,
              &place.drew_over, &place.stored_before, &place.order, &place.ray, &place.vertex,
              &place.vertex_before, &place.primitives, &place.matrices})
            visit(*number);
    }

    /// The pixels of the tiles that are not blank, by their offsets.
    template <typename Use>
    static void for_each_pixel(const ReplayState& state,
                               const std::vector<std::uint8_t>& has_changed, const Use& use) {
        const std::size_t pixels = state.frame_.drawn_by.size();
        for (std::size_t i = 0; i < pixels; ++i)
            if (has_changed[i / ReplayState::tile_size] != 0)
                use(i);
            else
                i += ReplayState::tile_size - 1;
    }

    static std::string bytes(const ReplayState& state) {
        std::vector<std::uint32_t> place;
        visit(state.place_, [&](std::size_t number) { place.push_back(in_32_bits(number)); });
        place.push_back(bits_of(state.place_.color));
        place.push_back(in_32_bits(state.place_.edges.size()));
        std::vector<std::uint32_t> lists;
        for (const std::size_t edge : state.place_.edges)
            lists.push_back(in_32_bits(edge));
        for (const std::size_t matrix : state.matrices())
            lists.push_back(in_32_bits(matrix));

        // Neighbors have mostly been drawn one after the other, each behind its depth test.
        std::vector<std::uint32_t> colors, drawn_by, writes, stored_by;
        std::uint32_t before = 0;
        for_each_pixel(state, state.has_changed_, [&](std::size_t i) {
            const std::uint32_t step = in_32_bits(state.frame_.drawn_by[i]);
            colors.push_back(bits_of(state.frame_.image.colors()[i]));
            drawn_by.push_back(step - std::exchange(before, step));
            writes.push_back(state.frame_.writes[i]);
            stored_by.push_back(step - in_32_bits(state.frame_.stored_by[i]));
        });
        std::string bytes;
        const std::vector<std::uint32_t> tiles(state.has_changed_.begin(),
                                               state.has_changed_.end());
        using Numbers = const std::vector<std::uint32_t>*;
        for (const Numbers numbers : std::initializer_list<Numbers>{&place, &lists, &tiles, &colors,
                                                                    &drawn_by, &writes, &stored_by})
            add_planes(*numbers, bytes);
        return bytes;
    }

    static ReplayState state(std::string_view bytes, const Canvas& canvas,
                             std::span<const std::uint32_t> primitives) {
        ReplayState state(canvas, {.writes = true, .depths = true});
        PlaneReader reader(bytes);
        std::size_t numbers = 0;
        visit(state.place_, [&](std::size_t) { ++numbers; });
        const auto place = reader.take(numbers + 2);
        std::size_t next = 0;
        visit(state.place_, [&](std::size_t& number) { number = place[next++]; });
        state.place_.color = color_of(place[next++]);
        const std::size_t edges = place[next];
        const auto lists = reader.take(edges + state.place_.matrices);
        const auto behind_edges = lists.begin() + static_cast<std::ptrdiff_t>(edges);
        state.place_.edges.assign(lists.begin(), behind_edges);
        state.matrices_.assign(behind_edges, lists.end());
        if (state.place_.primitives > primitives.size())
            throw StaleIndex();
        const auto so_far = primitives.first(state.place_.primitives);
        state.primitives_.assign(so_far.begin(), so_far.end());

        const auto tiles = reader.take(state.has_changed_.size());
        std::copy(tiles.begin(), tiles.end(), state.has_changed_.begin());
        std::size_t pixels = 0;
        for_each_pixel(state, state.has_changed_, [&](std::size_t) { ++pixels; });
        const auto colors = reader.take(pixels);
        const auto drawn_by = reader.take(pixels);
        const auto writes = reader.take(pixels);
        const auto stored_by = reader.take(pixels);
        Color* const image = state.frame_.image.row(canvas.top()).colors;
        std::uint32_t step = 0;
        std::size_t at = 0;
        for_each_pixel(state, state.has_changed_, [&](std::size_t i) {
            step += drawn_by[at];
            image[i] = color_of(colors[at]);
            state.frame_.drawn_by[i] = step;
            state.frame_.writes[i] = writes[at];
            state.frame_.stored_by[i] = step - stored_by[at];
            ++at;
        });
        return state;
    }
};

std::string replay_bytes(const ReplayState& state) {
    return ReplayBytes::bytes(state);
}

ReplayState replay_from_bytes(std::string_view bytes, const Canvas& canvas,
                              std::span<const std::uint32_t> primitives) {
    return ReplayBytes::state(bytes, canvas, primitives);
}

} // namespace rastertrace
