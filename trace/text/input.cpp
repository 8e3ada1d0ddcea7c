// SPDX-License-Identifier: MIT
#include "input.h"

#include "input_check.h"
#include "input_file.h"
#include "mapped_file.h"
#include "nameless_file.h"
#include "output.h"
#include "text.h"
#include "trace_layout.h"

#include <unistd.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

/// What the first line of a text tells.
LineLayout layout_by_first_line(std::string_view text) {
    return layout_of(without_blanks(text.substr(0, text.find('\n'))));
}

/// From so many bytes on, a trace with a step a line is looked at where it is.
constexpr std::size_t smallest_mapped = 1'000'000;

/// Where the first line begins that is too long for a trace.
std::optional<std::size_t> too_long_line_in(std::string_view text) {
    for (std::size_t begin = 0; text.size() - begin > longest_line;) {
        const std::size_t newline = text.rfind('\n', begin + longest_line);
        if (newline == std::string_view::npos || newline < begin)
            return begin;
        begin = newline + 1;
    }
    return std::nullopt;
}

/// A trace with a step a line, from its first byte on, whose lines are not too long; null for what is read instead: any
/// other file, and a small one, which nobody has to look at where it is.
std::shared_ptr<const MappedFile> mapped_trace(const InputFile& file) {
    if (!file.id() || ::lseek(file.descriptor(), 0, SEEK_CUR) != 0)
        return nullptr;
    auto mapped = MappedFile::of(file.descriptor(), file.name());
    const std::string_view text = mapped->text();
    // A file that is no text may have no end of a line for as long as it goes on.
    const std::string_view beginning = text.substr(0, longest_line);
    if (text.size() < smallest_mapped || layout_by_first_line(beginning) == LineLayout::other ||
        too_long_line_in(text)) // who reads it says so
        return nullptr;
    return mapped;
}

/// A trace from a pipe, of which a text has been read: written to a file without a name, up to a line that is too long,
/// and mapped.
std::shared_ptr<const MappedFile> kept_trace(InputFile& file, std::string text) {
    const NamelessFile kept = nameless_file(file.name());
    DescriptorOutput output(kept.to_write.number(), "a temporary file for " + file.name());
    std::size_t line = 0; // bytes behind the last newline
    do {
        output.write(text);
        const std::size_t newline = text.rfind('\n');
        line = newline == std::string::npos ? line + text.size() : text.size() - newline - 1;
        text.clear();
    } while (line <= longest_line && file.read_into(text));
    return MappedFile::of(kept.to_read.number(), file.name());
}

Result<Source> read_path(const std::string& path, InputFile::Kind kind, InputCheck fault_of) {
    auto file = InputFile::open(path, kind);
    if (!file)
        return file.problem();
    Source source{
        .name = file.value().name(), .text = {}, .file = file.value().id(), .is_read = true};
    try {
        std::size_t block = 0;
        if (kind == InputFile::Kind::any) // what another file names is no trace
            source.mapped = mapped_trace(file.value());
        // A text that need not grow is neither copied nor moved. What the system tells may be far from true.
        constexpr std::size_t most_trusted = 64U << 20U;
        if (!source.mapped)
            source.text.reserve(std::min(file.value().told_size(), most_trusted));
        while (!source.mapped && file.value().read_into(source.text)) {
            if (auto fault = fault_of(source, block))
                return *std::move(fault);
            const std::size_t before = std::exchange(block, source.text.size());
            if (before < smallest_mapped && block >= smallest_mapped &&
                kind == InputFile::Kind::any &&
                layout_by_first_line(source.text) != LineLayout::other) {
                source.mapped = kept_trace(file.value(), std::exchange(source.text, {}));
                if (const auto begin = too_long_line_in(source.view()))
                    return line_too_long(source, *begin);
            }
        }
    } catch (const Problem& problem) {
        return problem;
    }
    return source;
}

} // namespace

Result<Source> read_source(const std::string& path) {
    return read_source(path, InputLimits{});
}

Result<Source> read_source(const std::string& path, const InputLimits& limits) {
    return read_path(path, InputFile::Kind::any, {InputCheck::Kind::scene_or_trace, limits});
}

Result<Source> read_source_or_claims(const std::string& path, const InputLimits& limits) {
    return read_path(path, InputFile::Kind::any, {InputCheck::Kind::scene_trace_or_claims, limits});
}

Result<Source> read_bytes(const std::string& path, const InputLimits& limits) {
    return read_path(path, InputFile::Kind::regular_file, {InputCheck::Kind::bytes, limits});
}

Result<Source> read_named_file(const std::string& path, const InputLimits& limits) {
    if (path.find('\0') != std::string::npos)
        return problem_of(path, "expected the name of a file, found one with a zero byte");
    return read_path(path, InputFile::Kind::regular_file, {InputCheck::Kind::other, limits});
}

} // namespace rastertrace
