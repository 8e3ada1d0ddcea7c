// SPDX-License-Identifier: MIT
#pragma once

// The texts of doubles that were written not long ago. In a mesh, the numbers of a vertex come again with each
// triangle around it, and those of an edge with the other triangle beside it.
//
//     DoubleTexts texts;
//     end = texts.append(out, 0.1);  // as format_number writes it

#include <rastertrace/core/raster/blank_vector.h>
#include <rastertrace/trace/text/format_number.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace rastertrace {

class DoubleTexts {
public:
    /// Writes `value` as format_number does, with as much room.
    char* append(char* out, double value) {
        if (char* const end = format_dyadic(out, value))
            return end;
        if (value < 0)
            *out++ = '-';
        const double magnitude = std::abs(value);
        Entry& entry = entries_[place_of(magnitude)];
        if (entry.value != magnitude) {
            std::array<char, room_for(0.0)> text{};
            const char* const end = format_number(text.data(), magnitude);
            std::memcpy(entry.text.data(), text.data(), entry.text.size());
            entry.length = static_cast<std::uint8_t>(end - text.data());
            entry.value = magnitude;
        }
        std::memcpy(out, entry.text.data(), entry.text.size());
        return out + entry.length;
    }

private:
    /// Room for a positive double: 17 digits, a point, and e-324.
    static constexpr std::size_t longest = 23;

    struct Entry {
        double value = 0; ///< 0 of a blank entry; 0 itself is dyadic
        std::array<char, longest> text{};
        std::uint8_t length = 0;
    };

    /// Half a megabyte, enough for the vertices of some thousand triangles.
    static constexpr int bits_of_place = 14;

    static std::size_t place_of(double value) {
        // Fibonacci hashing: Knuth, The Art of Computer Programming, volume 3, section 6.4.
        return static_cast<std::size_t>(
            (std::bit_cast<std::uint64_t>(value) * 0x9E3779B97F4A7C15) >> (64 - bits_of_place));
    }

    BlankVector<Entry> entries_ = BlankVector<Entry>(std::size_t{1} << bits_of_place);
};

} // namespace rastertrace
