// SPDX-License-Identifier: MIT
#include "packed.h"

#include "problem.h"

#include <fmt/core.h>

#define ZLIB_CONST // what is read is not written to
#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <thread>
#include <utility>

namespace rastertrace {

namespace {

/// What is packed as one: small enough to be found and unpacked quickly, large enough to pack well.
constexpr std::size_t block_size = 1 << 20;

/// A piece of what is unpacked.
constexpr std::size_t piece_size = 1 << 20;

/// The quickest level of both.
constexpr int level = 1;

/// A file that holds more than so much, and so many times what it takes, is a bomb. (A trace takes 5 to 20 %.)
constexpr std::size_t largest_without_question = 256'000'000;
constexpr std::size_t most_times = 500;

constexpr int gzip_window = MAX_WBITS + 16; ///< zlib's way to say: with gzip's header

std::string packed_by_gzip(const std::string& block) {
    z_stream stream{};
    if (deflateInit2(&stream, level, Z_DEFLATED, gzip_window, MAX_MEM_LEVEL, Z_DEFAULT_STRATEGY) !=
        Z_OK)
        throw std::bad_alloc();
    std::string packed(deflateBound(&stream, block.size()), '\0');
    stream.next_in = reinterpret_cast<const Bytef*>(block.data());
    stream.avail_in = static_cast<uInt>(block.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH); // the bound is enough
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

std::string packed_by_zstd(std::string_view block) {
    const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(),
                                                                       ZSTD_freeCCtx);
    if (context == nullptr)
        throw std::bad_alloc();
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, level);
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1); // gzip always has one
    std::string packed(ZSTD_compressBound(block.size()), '\0');
    const std::size_t size =
        ZSTD_compress2(context.get(), packed.data(), packed.size(), block.data(), block.size());
    if (ZSTD_isError(size) != 0)
        throw std::bad_alloc();
    packed.resize(size);
    return packed;
}

} // namespace

std::string packed_block(std::string_view bytes) {
    return packed_by_zstd(bytes);
}

std::optional<std::string> unpacked_block(std::string_view packed, std::size_t size) {
    std::string bytes(size, '\0');
    if (ZSTD_decompress(bytes.data(), size, packed.data(), packed.size()) != size)
        return std::nullopt;
    return bytes;
}

std::uint32_t checksum_of(std::string_view bytes) {
    return static_cast<std::uint32_t>(
        crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

Packing packing_of(std::string_view beginning) {
    return beginning.starts_with("\x1f\x8b\x08")       ? Packing::gzip
           : beginning.starts_with("\x28\xb5\x2f\xfd") ? Packing::zstd
                                                       : Packing::none;
}

Packing packing_named(std::string_view path) {
    return path.ends_with(".gz")    ? Packing::gzip
           : path.ends_with(".zst") ? Packing::zstd
                                    : Packing::none;
}

std::string_view without_packing(std::string_view path) {
    const bool is_packed = packing_named(path) != Packing::none;
    return is_packed ? path.substr(0, path.rfind('.')) : path;
}

/// One of the two libraries, in the middle of a file.
struct Unpacker::Library {
    Library() = default;
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
    virtual ~Library() = default;

    struct Progress {
        std::size_t taken = 0;
        std::size_t given = 0;
        std::string_view fault{}; ///< why the bytes are no such file
    };
    virtual Progress unpack(std::string_view packed, char* to, std::size_t room) = 0;

    bool is_whole = true;
};

struct Unpacker::Gzip final : Unpacker::Library {
    Gzip() {
        if (inflateInit2(&stream, gzip_window) != Z_OK)
            throw std::bad_alloc();
    }
    ~Gzip() override { inflateEnd(&stream); }

    Progress unpack(std::string_view packed, char* to, std::size_t room) override {
        constexpr std::size_t most = std::numeric_limits<uInt>::max();
        stream.next_in = reinterpret_cast<const Bytef*>(packed.data());
        stream.avail_in = static_cast<uInt>(std::min(packed.size(), most));
        stream.next_out = reinterpret_cast<Bytef*>(to);
        stream.avail_out = static_cast<uInt>(std::min(room, most));
        const std::size_t of_file = stream.avail_in;
        const std::size_t of_room = stream.avail_out;
        const int result = inflate(&stream, Z_NO_FLUSH);
        const Progress progress{of_file - stream.avail_in, of_room - stream.avail_out};
        is_whole = result == Z_STREAM_END;
        if (is_whole)
            inflateReset(&stream); // another block may follow
        if (result == Z_MEM_ERROR)
            throw std::bad_alloc();
        if (result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR)
            return {progress.taken, progress.given,
                    stream.msg != nullptr ? stream.msg : "no dictionary is known"};
        return progress;
    }

    z_stream stream{};
};

struct Unpacker::Zstd final : Unpacker::Library {
    Zstd() : stream(ZSTD_createDStream()) {
        if (stream == nullptr)
            throw std::bad_alloc();
    }
    ~Zstd() override { ZSTD_freeDStream(stream); }

    Progress unpack(std::string_view packed, char* to, std::size_t room) override {
        ZSTD_inBuffer in{packed.data(), packed.size(), 0};
        ZSTD_outBuffer out{to, room, 0};
        const std::size_t result = ZSTD_decompressStream(stream, &out, &in);
        if (ZSTD_isError(result) != 0)
            return {in.pos, out.pos, ZSTD_getErrorName(result)};
        is_whole = result == 0;
        return {in.pos, out.pos};
    }

    ZSTD_DStream* stream;
};

Unpacker::Unpacker(Packing packing, std::string name) : name_(std::move(name)) {
    if (packing == Packing::gzip)
        library_ = std::make_unique<Gzip>();
    else
        library_ = std::make_unique<Zstd>();
}

Unpacker::Unpacker(Unpacker&&) noexcept = default;
Unpacker& Unpacker::operator=(Unpacker&&) noexcept = default;
Unpacker::~Unpacker() = default;

void Unpacker::take(std::string packed) {
    packed_ = std::move(packed);
    used_ = 0;
}

bool Unpacker::unpack_into(std::string& text) {
    const std::size_t before = text.size();
    text.resize(before + piece_size);
    std::size_t given = 0;
    while (given < piece_size && used_ < packed_.size()) {
        const auto progress = library_->unpack(std::string_view(packed_).substr(used_),
                                               text.data() + before + given, piece_size - given);
        used_ += progress.taken;
        taken_ += progress.taken;
        given += progress.given;
        if (!progress.fault.empty())
            throw problem_of(name_,
                             fmt::format("expected packed bytes, found damage at byte {}: {}",
                                         taken_ + 1, progress.fault));
    }
    text.resize(before + given);
    given_ += given;
    if (given_ > largest_without_question && given_ / most_times > taken_)
        throw problem_of(name_,
                         fmt::format("expected a file that holds at most {} times what it takes, "
                                     "found one of {} bytes so far, from {}",
                                     most_times, given_, taken_));
    return given > 0;
}

bool Unpacker::is_whole() const {
    return library_->is_whole && used_ == packed_.size();
}

void PackedOutput::write(std::string_view bytes) {
    if (packing_ == Packing::none)
        return to_.write(bytes);
    while (!bytes.empty()) {
        const std::string_view part = bytes.substr(0, block_size - block_.size());
        block_ += part;
        bytes.remove_prefix(part.size());
        if (block_.size() == block_size)
            pack_block();
    }
}

void PackedOutput::pack_block() {
    static const std::size_t most_waiting = std::max(std::thread::hardware_concurrency(), 1U);
    while (packed_.size() >= most_waiting)
        write_first();
    packed_.push_back(
        std::async(std::launch::async, [block = std::exchange(block_, {}), packing = packing_] {
            return packing == Packing::gzip ? packed_by_gzip(block) : packed_by_zstd(block);
        }));
    block_.reserve(block_size);
}

void PackedOutput::write_first() {
    to_.write(packed_.front().get());
    packed_.pop_front();
}

void PackedOutput::finish() {
    if (!block_.empty())
        pack_block();
    while (!packed_.empty())
        write_first();
}

} // namespace rastertrace
