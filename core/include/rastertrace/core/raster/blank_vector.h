// SPDX-License-Identifier: MIT
#pragma once

// A vector of zeros that takes memory only where it is written: a large canvas costs what is drawn
// on it.
//
//     BlankVector<Color> colors(16384 * 4096);  // no_color; 256 MB are reserved, none is used yet

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace rastertrace {

/// Takes its memory from std::calloc: large blocks are pages that the system fills with zeros when
/// they are first written. Elements constructed without a value are left as they are.
template <typename T> struct BlankAllocator {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>,
                  "zeros have to be a value");
    using value_type = T;

    BlankAllocator() = default;
    template <typename Other>
    BlankAllocator(const BlankAllocator<Other>&) {} // NOLINT: as std::allocator

    T* allocate(std::size_t count) {
        if (count > std::numeric_limits<std::size_t>::max() / sizeof(T))
            throw std::bad_array_new_length();
        for (;;) { // as operator new
            if (void* const memory = std::calloc(count, sizeof(T)))
                return static_cast<T*>(memory);
            const std::new_handler handler = std::get_new_handler();
            if (handler == nullptr)
                throw std::bad_alloc();
            handler();
        }
    }
    void deallocate(T* memory, std::size_t) { std::free(memory); }

    template <typename Made> void construct(Made*) {}
    template <typename Made, typename... Values> void construct(Made* place, Values&&... values) {
        ::new (static_cast<void*>(place)) Made(std::forward<Values>(values)...);
    }

    friend bool operator==(const BlankAllocator&, const BlankAllocator&) { return true; }
};

template <typename T> using BlankVector = std::vector<T, BlankAllocator<T>>;

} // namespace rastertrace
