// SPDX-License-Identifier: MIT
#pragma once

// Memory that is given back all at once, for what the values of steps refer to: names and lists.
//
//     Arena arena;
//     const std::string_view name = arena.copy("\"ABC\"");

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace rastertrace {

class Arena {
public:
    /// Room for so many values, which nobody destroys.
    template <typename Value> std::span<Value> array(std::size_t count) {
        static_assert(std::is_trivially_destructible_v<Value>);
        auto* const memory = static_cast<Value*>(allocate(count * sizeof(Value), alignof(Value)));
        std::uninitialized_default_construct_n(memory, count);
        return {memory, count};
    }

    /// A copy of a text.
    std::string_view copy(std::string_view text) {
        const std::span<char> to = array<char>(text.size());
        std::memcpy(to.data(), text.data(), text.size());
        return {to.data(), to.size()};
    }

    /// Gives back all that has been taken; the memory stays, for what is taken next.
    void clear() { blocks_in_use_ = used_ = 0; }

    /// The memory that it holds.
    std::size_t bytes() const { return bytes_; }

private:
    struct Block {
        std::unique_ptr<std::byte[]> memory; // NOLINT: as long as it has to be
        std::size_t size;
    };
    static constexpr std::size_t usual_size = std::size_t{1} << 16U;

    void* allocate(std::size_t size, std::size_t alignment) {
        used_ = (used_ + alignment - 1) & ~(alignment - 1);
        while (blocks_in_use_ == 0 || used_ + size > blocks_[blocks_in_use_ - 1].size) {
            used_ = 0;
            if (++blocks_in_use_ > blocks_.size()) {
                const std::size_t room = std::max(size, usual_size);
                blocks_.push_back({std::unique_ptr<std::byte[]>(new std::byte[room]), room});
                bytes_ += room;
            }
        }
        return blocks_[blocks_in_use_ - 1].memory.get() + std::exchange(used_, used_ + size);
    }

    std::vector<Block> blocks_;
    std::size_t blocks_in_use_ = 0;
    std::size_t used_ = 0; ///< of the last of these
    std::size_t bytes_ = 0;
};

/// Values one behind the other, in an arena. They stay where they are.
template <typename Value> class ArenaList {
public:
    std::size_t size() const { return size_; }
    const Value& operator[](std::size_t i) const { return chunks_[i / in_chunk][i % in_chunk]; }
    const Value& back() const { return (*this)[size_ - 1]; }

    void add(const Value& value, Arena& arena) {
        if (size_ % in_chunk == 0)
            chunks_.push_back(arena.array<Value>(in_chunk).data());
        chunks_.back()[size_++ % in_chunk] = value;
    }

private:
    static constexpr std::size_t in_chunk = std::max<std::size_t>(4096 / sizeof(Value), 16);

    std::vector<Value*> chunks_;
    std::size_t size_ = 0;
};

} // namespace rastertrace
