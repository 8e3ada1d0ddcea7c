// SPDX-License-Identifier: MIT
#pragma once

// Bytes packed by gzip (RFC 1952) or by Zstandard (RFC 8878). A file is unpacked by what it begins with, and written packed
// by what its name ends with.
//
//     PackedOutput packed(file, packing_named("trace.jsonl.gz"));
//     packed.write(text);
//     packed.finish();
//
// What is written is a sequence of blocks that can be unpacked one without the other (members of gzip, frames of
// Zstandard), packed in threads; gzip, zstd and their libraries read it as one file.

#include "output.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace rastertrace {

enum class Packing : std::uint8_t { none, gzip, zstd };

/// What is needed of the beginning of a file, in bytes.
inline constexpr std::size_t longest_packing_mark = 4;

/// How a file is packed that begins with these bytes.
Packing packing_of(std::string_view beginning);

/// How a file of this name is to be packed: `.gz`, `.zst`, or not.
Packing packing_named(std::string_view path);

/// The name without that ending: of `a.jsonl.gz`, `a.jsonl`.
std::string_view without_packing(std::string_view path);

/// Bytes as one block of Zstandard; and what such a block holds, none if that is not so many bytes.
std::string packed_block(std::string_view bytes);
std::optional<std::string> unpacked_block(std::string_view packed, std::size_t size);

/// CRC-32 (ISO 3309).
std::uint32_t checksum_of(std::string_view bytes);

/// Unpacks a file piece by piece.
class Unpacker {
public:
    /// Messages call the file by its name.
    Unpacker(Packing packing, std::string name);
    Unpacker(Unpacker&&) noexcept;
    Unpacker& operator=(Unpacker&&) noexcept;
    ~Unpacker();

    /// Takes the next bytes of the file, once unpack_into has nothing more.
    void take(std::string packed);

    /// Adds the next bytes to a text, a megabyte at most; false if it needs more of the file. Throws a Problem if they
    /// are damaged, or far more than such a file can be meant to hold.
    bool unpack_into(std::string& text);

    /// False in the middle of a block: a file that ends here has been cut off.
    bool is_whole() const;

private:
    struct Library;
    struct Gzip;
    struct Zstd;

    std::unique_ptr<Library> library_;
    std::string name_;
    std::string packed_; ///< what has been taken, of which `used_` bytes are done
    std::size_t used_ = 0;
    std::size_t taken_ = 0; ///< in all
    std::size_t given_ = 0;
};

/// Writes packed what it is given to another output.
class PackedOutput final : public Output {
public:
    /// With Packing::none, all goes on as it is.
    PackedOutput(Output& to, Packing packing) : to_(to), packing_(packing) {}

    void write(std::string_view bytes) override;

    /// Writes what is left: to be called behind the last byte.
    void finish();

private:
    void pack_block();
    void write_first();

    Output& to_;
    Packing packing_;
    std::string block_;
    std::deque<std::future<std::string>> packed_; ///< in their order
};

} // namespace rastertrace
