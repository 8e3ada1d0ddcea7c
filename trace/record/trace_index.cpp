// SPDX-License-Identifier: MIT
#include "trace_index.h"

#include "replay_bytes.h"
#include "scanned_lines.h"
#include "traced_steps.h"

#include <rastertrace/trace/text/in_threads.h>
#include <rastertrace/trace/text/input_file.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/packed.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <sys/stat.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>

namespace rastertrace {

namespace {

/// "rtindex" and the version of the format.
constexpr std::uint64_t index_magic = 0x0178'6564'6e69'7472;

/// Parts begin at multiples of it.
constexpr std::size_t alignment = 8;

/// So many blocks of the trace are scanned before they are taken in order.
constexpr std::size_t blocks_at_once = 64;

template <typename Item> std::string_view bytes_of(const std::vector<Item>& items) {
    static_assert(std::is_trivially_copyable_v<Item>);
    return {reinterpret_cast<const char*>(items.data()), items.size() * sizeof(Item)};
}

template <typename Item> std::string_view bytes_of(const Item& item) {
    static_assert(std::is_trivially_copyable_v<Item>);
    return {reinterpret_cast<const char*>(&item), sizeof(Item)};
}

/// True if a file was written before another one, as far as the system knows.
bool is_older(const struct stat& one, const struct stat& other) {
    return std::tie(one.st_mtim.tv_sec, one.st_mtim.tv_nsec) <
           std::tie(other.st_mtim.tv_sec, other.st_mtim.tv_nsec);
}

} // namespace

std::shared_ptr<const TraceIndex> TraceIndex::open(const std::string& path, const Source& trace) {
    const auto refuse = [&](const std::string& found) {
        throw problem_of(path, "expected the index of " + trace.name + ", found " + found);
    };
    const auto input = InputFile::open(path, InputFile::Kind::regular_file);
    if (!input)
        throw input.problem();
    struct stat of_index {};
    struct stat of_trace {};
    if (::fstat(input.value().descriptor(), &of_index) != 0 ||
        ::stat(trace.name.c_str(), &of_trace) != 0 || is_older(of_index, of_trace))
        refuse("an older one");

    const auto index = std::make_shared<TraceIndex>();
    index->file_ = MappedFile::of(input.value().descriptor(), path);
    const std::string_view bytes = index->file_->text();
    Head& head = index->head_;
    if (bytes.size() < sizeof(Head))
        refuse("something else");
    std::memcpy(&head, bytes.data() + bytes.size() - sizeof(Head), sizeof(Head));
    if (head.magic != index_magic ||
        head.checksum != checksum_of(bytes_of(head).substr(0, offsetof(Head, checksum))))
        refuse("something else");
    const std::string_view text = trace.view();
    if (head.trace_size != text.size() || head.begin_of_steps > head.end_of_steps ||
        head.end_of_steps > text.size() ||
        head.header_checksum != checksum_of(text.substr(0, head.begin_of_steps)) ||
        head.end_checksum != checksum_of(text.substr(head.end_of_steps)))
        refuse("that of another trace");
    std::copy(head.counts.begin(), head.counts.end(), index->counts_.known.begin());
    try {
        index->checked(Part::blocks);
    } catch (const StaleIndex&) {
        refuse("a damaged one");
    }
    return index;
}

std::string_view TraceIndex::bytes_at(const Place& place) const {
    const std::string_view bytes = file_->text();
    if (place.offset > bytes.size() || place.size > bytes.size() - place.offset)
        throw StaleIndex();
    return bytes.substr(place.offset, place.size);
}

std::string_view TraceIndex::checked(Part part) const {
    const auto i = static_cast<std::size_t>(part);
    const std::string_view bytes = bytes_at(head_.places[i]);
    if (!is_checked_[i] && checksum_of(bytes) != head_.places[i].checksum)
        throw StaleIndex();
    is_checked_[i] = true;
    return bytes;
}

std::size_t TraceIndex::primitive_of(std::size_t step) const {
    const auto all = primitives();
    const auto next = std::upper_bound(all.begin(), all.end(), step);
    return next == all.begin() ? 0 : *(next - 1);
}

std::vector<std::size_t> TraceIndex::vertex_steps(std::string_view name) const {
    const auto all = section<Vertex>(Part::vertices);
    const std::uint32_t wanted = checksum_of(name);
    std::vector<std::size_t> steps;
    for (auto vertex = std::lower_bound(
             all.begin(), all.end(), wanted,
             [](const Vertex&one, std::uint32_t value) { return one.name < value; });
         vertex != all.end() && vertex->name == wanted; ++vertex)
        steps.push_back(vertex->step);
    return steps;
}

std::optional<ReplayState> TraceIndex::keyframe(std::size_t n, std::size_t behind,
                                                const Canvas& canvas) const {
    const auto all = section<Keyframe>(Part::keyframes);
    const auto next =
        std::upper_bound(all.begin(), all.end(), n, [](std::size_t step, const Keyframe& keyframe) {
            return step < keyframe.step;
        });
    if (next == all.begin() || (next - 1)->step <= behind + head_.far)
        return std::nullopt;
    const Keyframe& found = *(next - 1);
    const std::string_view packed = bytes_at(found.place);
    if (checksum_of(packed) != found.place.checksum)
        throw StaleIndex();
    const auto bytes = unpacked_block(packed, found.size);
    if (!bytes)
        throw StaleIndex();
    return replay_from_bytes(*bytes, canvas, primitives());
}

/// Goes through the lines of a trace and writes its index.
class IndexWriter {
public:
    IndexWriter(const Trace& trace, const std::string& path, const IndexGrain& grain)
        : trace_(trace), grain_(grain), state_(trace.canvas, {.writes = true, .depths = true}),
          path_(path), output_(path) {}

    void write(const PixelUnits& units) {
        head_.magic = index_magic;
        head_.far = grain_.keyframe / 4;
        read_lines();
        head_.knows_units = units.are_known && !trace_.is_partial ? 1 : 0;
        head_.others = units.others;
        std::sort(vertices_.begin(), vertices_.end(), [](const Vertex& one, const Vertex& other) {
            return std::tie(one.name, one.step) < std::tie(other.name, other.step);
        });
        put(Part::blocks, bytes_of(blocks_));
        put(Part::primitives, bytes_of(primitives_));
        put(Part::loose, bytes_of(loose_));
        put(Part::vertices, bytes_of(vertices_));
        put(Part::units, bytes_of(units.units));
        put(Part::keyframes, bytes_of(keyframes_));
        head_.checksum =
            checksum_of(bytes_of(head_).substr(0, offsetof(TraceIndex::Head, checksum)));
        output_.write(bytes_of(head_));
        output_.commit();
    }

private:
    using Part = TraceIndex::Part;
    using Vertex = TraceIndex::Vertex;

    std::string_view text() const { return trace_.text(); }

    [[noreturn]] void refuse(const std::string& found) const {
        throw problem_of(path_, "expected a trace as rastertrace writes it, found " + found);
    }

    void read_lines() {
        if (trace_.size() == 0 || !trace_.damage.empty())
            refuse(trace_.size() == 0 ? "one without steps" : "damage");
        if (trace_.size() > std::numeric_limits<std::uint32_t>::max())
            refuse("more than 4,294,967,295 steps");
        std::size_t offset = trace_.offset_of(1);
        head_.trace_size = text().size();
        head_.begin_of_steps = offset;
        head_.header_checksum = checksum_of(text().substr(0, offset));
        const LineScan scan{.canvas = trace_.canvas,
                            .is_document = layout_of(text().substr(0, text().find('\n'))) ==
                                           LineLayout::document};
        while (state_.step() < trace_.size()) {
            const std::size_t before = offset;
            for (const ScannedLines& block :
                 scan_parts(text(), offset, offset + blocks_at_once * grain_.block, grain_.block,
                            usual_jobs(), scan)) {
                if (block.measured.kinds.empty())
                    break;
                take(block);
                offset = block.measured.end;
                if (!block.is_whole)
                    break;
            }
            if (offset == before)
                refuse("a line that is written otherwise");
        }
        head_.steps = trace_.size();
        head_.end_of_steps = offset;
        head_.end_checksum = checksum_of(text().substr(offset));
    }

    void take(const ScannedLines& lines) {
        const std::size_t before = state_.step();
        const auto& [begin, end, kinds, sizes] = lines.measured;
        blocks_.push_back({.offset = begin,
                           .first = static_cast<std::uint32_t>(before + 1),
                           .checksum = checksum_of(text().substr(begin, end - begin))});
        std::size_t offset = begin;
        for (std::size_t i = 0; i < kinds.size(); offset += sizes[i++]) {
            const auto step = static_cast<std::uint32_t>(before + i + 1);
            const auto kind = static_cast<StepKind>(kinds[i]);
            ++head_.counts[kinds[i]];
            if (kind == StepKind::primitive)
                primitives_.push_back(step);
            else if (kind == StepKind::vertex)
                vertices_.push_back(
                    {.name = checksum_of(name_of_vertex(offset, sizes[i])), .step = step});
            else if (is_loose(kind, !primitives_.empty()))
                loose_.push_back(step);
        }
        lines.play(state_);
        keep_frame(end);
    }

    std::string name_of_vertex(std::size_t offset, std::size_t size) const {
        const std::string_view line = text().substr(offset, size);
        return StepView(line.substr(0, line.rfind('}') + 1)).as<VertexStep>().name.text();
    }

    /// Keeps what the replay is at, if the last keyframe is far enough behind.
    void keep_frame(std::size_t offset) {
        constexpr std::size_t percent = 100;
        const std::size_t before = keyframes_.empty() ? 0 : keyframes_.back().step;
        if (state_.step() - before < grain_.keyframe ||
            offset * grain_.share_of_frames < (bytes_of_frames_ + last_frame_) * percent)
            return;
        const std::string bytes = replay_bytes(state_);
        const std::string packed = packed_block(bytes);
        last_frame_ = grain_.share_of_frames == 0 ? 0 : packed.size();
        bytes_of_frames_ += last_frame_;
        keyframes_.push_back(
            {.place = write_aligned(packed), .step = state_.step(), .size = bytes.size()});
    }

    TraceIndex::Place write_aligned(std::string_view bytes) {
        const TraceIndex::Place place{
            .offset = written_, .size = bytes.size(), .checksum = checksum_of(bytes)};
        output_.write(bytes);
        output_.write(std::string((alignment - bytes.size() % alignment) % alignment, '\0'));
        written_ += (bytes.size() + alignment - 1) / alignment * alignment;
        return place;
    }

    void put(Part part, std::string_view bytes) {
        head_.places[static_cast<std::size_t>(part)] = write_aligned(bytes);
    }

    const Trace& trace_;
    IndexGrain grain_;
    ReplayState state_;
    std::string path_;
    FileOutput output_;
    std::uint64_t written_ = 0;
    TraceIndex::Head head_;
    std::vector<IndexedBlock> blocks_;
    std::vector<std::uint32_t> primitives_;
    std::vector<std::uint32_t> loose_;
    std::vector<Vertex> vertices_;
    std::vector<TraceIndex::Keyframe> keyframes_;
    std::size_t bytes_of_frames_ = 0;
    std::size_t last_frame_ = 0;
};

void write_index(const Trace& trace, const PixelUnits& units, const std::string& path,
                 const IndexGrain& grain) {
    IndexWriter(trace, path, grain).write(units);
}

} // namespace rastertrace
