// SPDX-License-Identifier: MIT
#include "trace_text.h"

#include "trace_lines.h"

#include <rastertrace/trace/text/first_line.h>
#include <rastertrace/trace/text/input_file.h>
#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/nameless_file.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace rastertrace {

namespace {

template <typename T> T value_of(Result<T> result) {
    if (!result)
        throw result.problem();
    return std::move(result.value());
}

/// JSON without the blanks between its tokens.
std::string compact(std::string_view json) {
    std::string text;
    bool is_in_string = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (!is_in_string && (c == ' ' || c == '\t' || c == '\r' || c == '\n'))
            continue;
        text += c;
        if (is_in_string && c == '\\')
            text += json[++i];
        else if (c == '"')
            is_in_string = !is_in_string;
    }
    return text;
}

/// A document of any layout as JSON Lines.
std::string one_step_a_line(std::string_view document) {
    std::string header = "{";
    std::string steps;
    std::string end;
    JsonScanner fields(document);
    while (fields.next_field()) {
        if (fields.key() == "steps") {
            JsonScanner elements(fields.value());
            while (elements.next_element())
                steps += compact(elements.value()) + "\n";
        } else if (fields.key() == "end") {
            end = "{\"end\":" + compact(fields.value()) + "}\n";
        } else {
            header += header.size() > 1 ? "," : "";
            header += "\"" + std::string(fields.key()) + "\":" + compact(fields.value());
        }
    }
    return header + "}\n" + steps + end;
}

} // namespace

struct TraceText::State {
    std::string name;
    std::optional<FileId> file;
    Trace header;
    std::string header_json;
    LineLayout layout = LineLayout::lines;
    std::size_t begin = 0;
    bool has_lines = false;

    std::string text;               ///< in memory ...
    std::optional<InputFile> input; ///< ... or in a file ...
    NamelessFile temporary;         ///< ... or in one without a name
    int descriptor = -1;

    /// Reads the header from the first line.
    void read_header(const std::string& first_line) {
        const bool is_document = layout == LineLayout::document;
        header_json = first_line + (is_document ? "]}" : "");
        header =
            value_of(read_trace({name, header_json + (is_document ? "" : "\n{\"end\":{}}"), {}}));
        header.end.reset();
        header.damage.clear();
    }
};

TraceText::TraceText(std::unique_ptr<State> state) : state_(std::move(state)) {}
TraceText::TraceText(TraceText&&) noexcept = default;
TraceText& TraceText::operator=(TraceText&&) noexcept = default;
TraceText::~TraceText() = default;

TraceText::TraceText(Source source) : state_(std::make_unique<State>()) {
    state_->name = source.name;
    state_->file = source.file;
    const auto first_line_of = [](std::string_view text) {
        return std::string(without_blanks(text.substr(0, text.find('\n'))));
    };
    state_->layout = layout_of(first_line_of(source.view()));
    if (state_->layout == LineLayout::other) {
        const Trace checked = value_of(read_trace(source));
        const std::size_t brace = source.text.find('{');
        state_->text = one_step_a_line(std::string_view(source.text).substr(brace));
        state_->layout = LineLayout::lines;
    } else {
        state_->text = source.mapped ? std::string(source.view()) : std::move(source.text);
    }
    state_->read_header(first_line_of(state_->text));
    state_->begin = std::min(state_->text.find('\n'), state_->text.size() - 1) + 1;
}

const std::string& TraceText::name() const {
    return state_->name;
}

const std::optional<FileId>& TraceText::file() const {
    return state_->file;
}

const Trace& TraceText::header() const {
    return state_->header;
}

const std::string& TraceText::header_json() const {
    return state_->header_json;
}

bool TraceText::has_lines() const {
    return state_->has_lines;
}

bool TraceText::is_document() const {
    return state_->layout == LineLayout::document;
}

std::size_t TraceText::begin() const {
    return state_->begin;
}

std::size_t TraceText::size() const {
    if (state_->descriptor < 0)
        return state_->text.size();
    struct stat status {};
    if (::fstat(state_->descriptor, &status) != 0)
        throw problem_of_system(state_->name, "could not be read", errno);
    return static_cast<std::size_t>(status.st_size);
}

std::size_t TraceText::read(std::size_t offset, std::span<char> to) const {
    if (state_->descriptor < 0) {
        const std::string_view rest =
            std::string_view(state_->text).substr(std::min(offset, state_->text.size()), to.size());
        std::memcpy(to.data(), rest.data(), rest.size());
        return rest.size();
    }
    for (;;) {
        const ssize_t count =
            ::pread(state_->descriptor, to.data(), to.size(), static_cast<off_t>(offset));
        if (count >= 0)
            return static_cast<std::size_t>(count);
        if (errno != EINTR)
            throw problem_of_system(state_->name, "could not be read", errno);
    }
}

std::optional<std::size_t> TraceText::find(std::string_view wanted, std::size_t from,
                                           std::size_t& most) const {
    constexpr std::size_t block_size = 1 << 20;
    std::string block;
    while (most > 0) {
        const std::size_t kept = block.size();
        block.resize(kept + std::min(block_size, most));
        const std::size_t count = read(from + kept, std::span(block).subspan(kept));
        block.resize(kept + count);
        most -= count;
        if (const std::size_t found = block.find(wanted); found != std::string::npos)
            return from + found;
        if (count == 0)
            return std::nullopt;
        // It may begin in one block and end in the next.
        const std::size_t gone = block.size() - std::min(block.size(), wanted.size());
        block.erase(0, gone);
        from += gone;
    }
    return std::nullopt;
}

std::variant<TraceText, Source> open_trace_text(const std::string& path,
                                                const InputLimits& limits) {
    auto [input, source, layout] = open_first_line(path, InputCheck::Kind::scene_or_trace, limits);
    if (layout == LineLayout::other)
        return std::move(source);

    auto state = std::make_unique<TraceText::State>();
    state->name = source.name;
    state->file = source.file;
    state->layout = layout;
    state->has_lines = true;
    const std::size_t newline = source.text.find('\n');
    state->begin = newline + 1;
    state->read_header(std::string(without_blanks(source.text.substr(0, newline))));
    if (source.file && path != "-") {
        state->descriptor = input.descriptor();
        state->input = std::move(input);
        return TraceText(std::move(state));
    }
    state->temporary = nameless_file(source.name);
    state->descriptor = state->temporary.to_read.number();
    DescriptorOutput output(state->temporary.to_write.number(),
                            "a temporary file for " + source.name);
    do {
        output.write(source.text);
        source.text.clear();
    } while (input.read_into(source.text));
    return TraceText(std::move(state));
}

} // namespace rastertrace
