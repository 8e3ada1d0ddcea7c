// SPDX-License-Identifier: MIT
#pragma once

// A vector of zeros that takes memory only where it is written: a large canvas costs what is drawn
// on it.
//
//     BlankVector<Color> colors(16384 * 4096);  // no_color; 256 MB are reserved, none is used yet

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace rastertrace {

/// As many elements as it is made with. Its memory is std::calloc's: large blocks are pages that the
/// system fills with zeros when they are first written. (A std::vector with an allocator of its own
/// walks over all elements when it is destroyed, unless the compiler sees that nothing is done.)
template <typename T> class BlankVector {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>,
                  "zeros have to be a value");

public:
    BlankVector() = default;
    /// @throws std::bad_alloc if there is not so much memory.
    explicit BlankVector(std::size_t size) : elements_(zeros(size)), size_(size) {}
    BlankVector(std::size_t size, const T& value) : BlankVector(size) {
        std::fill(begin(), end(), value);
    }
    template <typename Iterator>
    BlankVector(Iterator first, Iterator last)
        : BlankVector(static_cast<std::size_t>(std::distance(first, last))) {
        std::copy(first, last, begin());
    }
    BlankVector(const BlankVector& other) : BlankVector(other.begin(), other.end()) {}
    BlankVector(BlankVector&& other) noexcept
        : elements_(std::move(other.elements_)), size_(std::exchange(other.size_, 0)) {}
    BlankVector& operator=(BlankVector other) noexcept {
        std::swap(elements_, other.elements_);
        std::swap(size_, other.size_);
        return *this;
    }
    ~BlankVector() = default;

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    T* data() { return elements_.get(); }
    const T* data() const { return elements_.get(); }
    T* begin() { return data(); }
    const T* begin() const { return data(); }
    T* end() { return data() + size_; }
    const T* end() const { return data() + size_; }
    T& operator[](std::size_t index) { return data()[index]; }
    const T& operator[](std::size_t index) const { return data()[index]; }

    friend bool operator==(const BlankVector& a, const BlankVector& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end());
    }

private:
    struct Free {
        void operator()(T* elements) const { std::free(elements); }
    };
    using Elements = std::unique_ptr<T[], Free>;

    static Elements zeros(std::size_t size) {
        if (size == 0)
            return nullptr;
        if (size > std::numeric_limits<std::size_t>::max() / sizeof(T))
            throw std::bad_array_new_length();
        for (;;) { // as operator new
            if (void* const memory = std::calloc(size, sizeof(T)))
                return Elements(static_cast<T*>(memory));
            const std::new_handler handler = std::get_new_handler();
            if (handler == nullptr)
                throw std::bad_alloc();
            handler();
        }
    }

    Elements elements_;
    std::size_t size_ = 0;
};

} // namespace rastertrace
