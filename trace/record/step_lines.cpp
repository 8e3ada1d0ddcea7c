// SPDX-License-Identifier: MIT
#include "step_lines.h"

#include "field_type.h"
#include "step_decoder.h"

#include "trace_lines.h"

#include <rastertrace/trace/text/input_check.h>
#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/process_files.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace rastertrace {

namespace {

/// So much is read at once: as much as stays in a cache close to the processor.
constexpr std::size_t read_size = 1 << 17;

/// A field of a key: a whole number as such, anything else as what it says.
void add_key(std::string& key, std::string_view name, std::string_view json) {
    const auto number = whole_in(json);
    key += ' ';
    key += name;
    key += '=';
    key += number ? std::to_string(*number) : plain_text(json);
}

std::string key_of(const StepLine& line, const StepKeys& keys) {
    std::string key = line.kind_name;
    const StepView step(line.json);
    if (line.kind) {
        for (const StepField& field : fields_of(*line.kind))
            if (field.role == FieldRole::key)
                if (const auto json = step.field(field.name))
                    add_key(key, field.name, *json);
        return key;
    }
    // Of a kind that we do not know: what it was said to have, or what other kinds have.
    static const std::vector<std::string> usual{"name", "x", "y"};
    const auto own = keys.find(line.kind_name);
    for (const std::string& name : own == keys.end() ? usual : own->second)
        if (const auto json = step.field(name))
            add_key(key, name, *json);
    return key;
}

/// A step by its number. Throws a Problem if it is none.
StepLine step_line(const std::string& name, std::string json, std::size_t number,
                   const StepKeys& keys) {
    Source source{name, std::move(json), {}};
    StepLine line;
    line.kind = checked_kind(source, 0, source.text.size());
    line.json = std::move(source.text);
    line.kind_name = line.kind ? std::string(name_of(*line.kind)) : StepView(line.json).kind_name();
    line.key = key_of(line, keys);
    line.number = number;
    return line;
}

} // namespace

std::string_view step_of_line(std::string_view line) {
    line = without_blanks(line);
    if (line.ends_with(','))
        line.remove_suffix(1);
    return line;
}

StepLines::StepLines(const TraceText& text, LinePlace from, std::size_t end, StepKeys keys)
    : text_(text), place_(from), end_(end), keys_(std::move(keys)) {
    if (place_.offset == 0)
        place_.offset = text.begin();
}

bool StepLines::is_blank(std::string_view line) {
    constexpr std::size_t shortest_step = 10; // {"step":""}
    return line.size() < shortest_step && without_blanks(line).empty();
}

bool StepLines::ends_steps(std::string_view line) const {
    if (line.starts_with(front_of_step))
        return false;
    line = without_blanks(line);
    return text_.is_document() ? line.starts_with(']') : is_end_line(line);
}

Problem StepLines::too_long() const {
    Problem problem = line_too_long({text_.name(), buffer_, {}}, 0);
    problem.line = text_.has_lines() ? place_.lines + 2 : 0;
    return problem;
}

bool StepLines::read_more() {
    if (has_all_)
        return false;
    if (passed_ > 0) {
        buffer_.erase(0, passed_);
        passed_ = 0;
    }
    if (buffer_.size() > longest_line)
        throw too_long();
    const std::size_t kept = buffer_.size();
    const std::size_t begin = place_.offset + kept;
    const std::size_t size = std::min(read_size, end_ - std::min(end_, begin));
    buffer_.resize(kept + size);
    const std::size_t count = text_.read(begin, std::span(buffer_).subspan(kept));
    add_bytes_done({.read = count});
    buffer_.resize(kept + count);
    has_all_ = count == 0;
    return !has_all_;
}

std::string_view StepLines::unread_lines() {
    if (!ahead_.empty() || is_behind_)
        return {};
    for (;;) {
        const std::string_view unread = std::string_view(buffer_).substr(passed_);
        const std::size_t last = unread.rfind('\n');
        if (last != std::string_view::npos) {
            const std::size_t size = last + 1;
            return unread.substr(0, std::min(size, end_ - std::min(end_, place_.offset)));
        }
        if (!read_more())
            return {};
    }
}

void StepLines::pass_lines(LinePlace to) {
    passed_ += to.offset - place_.offset;
    place_ = to;
}

/// The next line that is not empty, with what ends it.
std::optional<std::string_view> StepLines::next_line() {
    while (place_.offset < end_) {
        std::string_view unread = std::string_view(buffer_).substr(passed_);
        std::size_t newline = unread.find('\n');
        while (newline == std::string_view::npos && read_more()) {
            unread = std::string_view(buffer_).substr(passed_);
            newline = unread.find('\n');
        }
        unread = std::string_view(buffer_).substr(passed_);
        if (unread.empty())
            break;
        const std::string_view line = unread.substr(0, std::min(newline, unread.size() - 1) + 1);
        if (!without_blanks(step_of_line(line.substr(0, newline))).empty())
            return line;
        pass_lines({place_.offset + line.size(), place_.steps, place_.lines + 1});
    }
    return std::nullopt;
}

const StepLine* StepLines::at(std::size_t i) {
    while (ahead_.size() <= i && !is_behind_) {
        const auto line = next_line();
        if (!line) {
            is_behind_ = true;
            is_cut_off_ = place_.offset < end_;
            break;
        }
        const std::string_view json = line->substr(0, line->find('\n'));
        if (ends_steps(json)) {
            is_behind_ = true;
            break;
        }
        const bool is_last = !line->ends_with('\n');
        try {
            ahead_.push_back(step_in(step_of_line(json)));
        } catch (const Problem&) {
            // The last line of a file may be one that was not written to its end.
            if (!is_last)
                throw;
            is_behind_ = is_cut_off_ = true;
            break;
        }
        pass_lines({place_.offset + line->size(), place_.steps + 1, place_.lines + 1});
    }
    return i < ahead_.size() ? &ahead_[i] : nullptr;
}

StepLine StepLines::step_in(std::string_view json) const {
    try {
        StepLine line = step_line(text_.name(), std::string(json), place_.steps + 1, keys_);
        line.place = place_;
        return line;
    } catch (Problem& problem) {
        problem.line = text_.has_lines() ? place_.lines + 2 : 0;
        throw;
    }
}

} // namespace rastertrace
