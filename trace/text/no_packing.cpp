// SPDX-License-Identifier: MIT
// For pages, which read no files and write none: nothing is packed.

#include "packed.h"

namespace rastertrace {

struct Unpacker::Library {};

Packing packing_of(std::string_view) {
    return Packing::none;
}

std::string packed_block(std::string_view) {
    return {};
}

std::optional<std::string> unpacked_block(std::string_view, std::size_t) {
    return std::nullopt;
}

std::uint32_t checksum_of(std::string_view) {
    return 0;
}

Unpacker::Unpacker(Packing, std::string) {}
Unpacker::Unpacker(Unpacker&&) noexcept = default;
Unpacker& Unpacker::operator=(Unpacker&&) noexcept = default;
Unpacker::~Unpacker() = default;

void Unpacker::take(std::string) {}

bool Unpacker::unpack_into(std::string&) {
    return false;
}

bool Unpacker::is_whole() const {
    return true;
}

} // namespace rastertrace
