// SPDX-License-Identifier: MIT
#include "step_stream.h"

#include "frame.h"
#include "trace_lines.h"
#include "unknown_names.h"

#include <rastertrace/trace/text/first_line.h>
#include <rastertrace/trace/text/input_check.h>
#include <rastertrace/trace/text/input_file.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <fmt/core.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

/// So many bytes of steps are looked at at once: more each time.
constexpr std::size_t least_block = 1 << 20;
constexpr std::size_t largest_block = 8 * least_block;

template <typename T> T value_of(Result<T> result) {
    if (!result)
        throw result.problem();
    return std::move(result.value());
}

} // namespace

/// The file comes in blocks of whole lines. Each block is read as a trace of its own, with the header in front, so
/// that every line is checked as in a trace that is read whole.
struct StepStream::State {
    InputFile file;
    LineLayout layout = LineLayout::other;
    std::string header_line;
    std::string text; ///< what has been read and is in no block yet, from the beginning of a line
    bool has_all = false;       ///< the file has come to its end
    bool may_grow = false;      ///< the end of the file is not the end: more may be added
    std::size_t text_begin = 0; ///< of `text` in the file
    std::size_t block_begin = 0;
    std::size_t lines_before = 1; ///< lines of the file in front of `text`
    std::size_t lines_before_block = 1;

    Trace header;
    Trace block;
    std::size_t place = 0;  ///< of the current step in the block
    std::size_t before = 0; ///< steps in front of the block
    bool is_behind = false; ///< the last step has been passed
    BlockSums sums;
    std::size_t jobs = 0;
    std::size_t block_size = least_block;
    std::optional<EndRecord> end;
    std::optional<Problem> fault; ///< what stands behind the current block
    std::vector<Problem> damage;
    std::vector<Problem> passed_over; ///< in the header and the end record
    NotFiniteSteps not_finite;

    bool tells_all = false;         ///< useless steps are damage, and the picture is drawn
    bool has_useless_steps = false; ///< nobody knows what they should have been

    explicit State(InputFile opened) : file(std::move(opened)) {}

    /// False if there is no more, or not yet.
    bool read_more() {
        if (has_all)
            return false;
        const bool has_read = file.read_into(text);
        has_all = !has_read && !may_grow;
        return has_read;
    }

    /// A problem of what stands in `text`, with the line that it has in the file.
    Problem moved(Problem problem) const { return moved(std::move(problem), lines_before); }

    /// The same for a problem of lines that so many others stand in front of.
    static Problem moved(Problem problem, std::size_t before) {
        if (problem.line > 1)
            problem.line += before - 1;
        return problem;
    }

    /// The steps of some lines, as a trace of its own; what is wrong with them is damage of the whole.
    Trace trace_of(std::string_view lines, bool is_cut_off) {
        const bool is_document = layout == LineLayout::document;
        const std::string_view behind = is_cut_off    ? ""
                                        : is_document ? "],\"end\":{}}"
                                                      : "{\"end\":{}}";
        Source source{file.name(), {}, {}};
        source.text.reserve(header_line.size() + 1 + lines.size() + behind.size());
        source.text.append(header_line).append("\n").append(lines).append(behind);
        const bool goes_on = tells_all && damage.size() < most_useless_steps;
        auto read = read_block(std::move(source), goes_on, jobs, sums);
        if (!read)
            throw moved(read.problem());
        for (Problem& problem : read.value().damage)
            damage.push_back(moved(std::move(problem)));
        NotFiniteSteps& more = read.value().not_finite;
        if (not_finite.count == 0 && more.first)
            not_finite.first = moved(*std::move(more.first));
        not_finite.count += more.count;
        return std::move(read.value());
    }

    /// True for the line behind the last step.
    bool is_end(std::string_view line) const {
        if (line.starts_with("{\"step\""))
            return false;
        line = without_blanks(line);
        return layout == LineLayout::document ? line.starts_with(']') : is_end_line(line);
    }

    /// The whole lines in front of the line behind the last step, or all of `text` if it has none such.
    struct WholeLines {
        std::size_t size = 0; ///< bytes
        std::size_t count = 0;
        bool is_last = false; ///< the line behind the last step follows
    };
    WholeLines whole_lines() const {
        WholeLines lines;
        while (lines.size < text.size()) {
            const std::size_t newline = text.find('\n', lines.size);
            if (newline == std::string::npos && !has_all)
                break;
            const std::size_t line_end = std::min(newline, text.size());
            if (is_end(std::string_view(text).substr(lines.size, line_end - lines.size))) {
                lines.is_last = true;
                break;
            }
            lines.size = std::min(line_end + 1, text.size());
            lines.count += newline == std::string::npos ? 0 : 1;
        }
        return lines;
    }

    /// Goes to the next block that has a step.
    bool next_block() {
        if (is_behind)
            return false;
        before += std::exchange(block, {}).size();
        place = 0;
        while (text.size() < block_size && read_more()) {
        }
        block_size = std::min(2 * block_size, largest_block);
        WholeLines whole = whole_lines();
        while (whole.size == 0 && !whole.is_last && !has_all) { // a line longer than a block
            if (text.size() > longest_line)
                throw moved(line_too_long({file.name(), header_line + "\n" + text, {}},
                                          header_line.size() + 1));
            if (!read_more() && may_grow)
                return false; // not a whole line yet
            whole = whole_lines();
        }
        const std::string_view lines = std::string_view(text).substr(0, whole.size);
        const bool is_cut_off = !whole.is_last && has_all;
        if (fault)
            throw *fault;
        const bool had_stray_pixel = sums.has_stray_pixel;
        try {
            block = trace_of(lines, is_cut_off);
        } catch (const Problem& problem) {
            sums.has_stray_pixel =
                had_stray_pixel; // the steps in front of the fault are read again
            return next_block_before(problem, lines);
        }
        block_begin = text_begin;
        text_begin += whole.size;
        if (is_cut_off && !block.end && !damage.empty())
            damage.back().message = truncation_after(before + block.size());
        look_for_useless_steps();
        lines_before_block = lines_before;
        lines_before += whole.count;
        text.erase(0, whole.size);
        is_behind = whole.is_last || has_all;
        if (whole.is_last)
            read_end();
        return block.size() > 0 || next_block();
    }

    /// The steps in front of the line that is no step; the next block is the fault.
    bool next_block_before(const Problem& problem, std::string_view lines) {
        const std::size_t whole = problem.line > lines_before ? problem.line - lines_before - 1 : 0;
        std::size_t length = 0;
        for (std::size_t line = 0; line < whole && length < lines.size(); ++line)
            length = lines.find('\n', length) + 1;
        if (length == 0)
            throw problem;
        fault = problem;
        block = trace_of(lines.substr(0, length), false);
        block_begin = text_begin;
        lines_before_block = lines_before;
        look_for_useless_steps();
        if (block.size() == 0)
            throw problem;
        return true;
    }

    void look_for_useless_steps() {
        for (std::size_t n = 1; n <= block.size() && !has_useless_steps; ++n)
            has_useless_steps = !block.kind_of(n) && !is_foreign(block.step(n));
    }

    /// What is left is the end record, and nothing behind it.
    void read_end() {
        while (text.size() < 2 * largest_block && read_more()) {
        }
        Source source{file.name(), header_line + "\n" + text, {}};
        const Trace rest = value_of(read_end_of(std::move(source)));
        end = rest.end;
        // Those of the header have been told already.
        for (std::size_t i = header.passed_over.size(); i < rest.passed_over.size(); ++i)
            passed_over.push_back(moved(rest.passed_over[i]));
        if (!end) {
            for (Problem problem : rest.damage) {
                if (problem.message == truncation_after(0))
                    problem.message = truncation_after(before + block.size());
                damage.push_back(moved(std::move(problem)));
            }
            return;
        }
        // Held against no steps, it has told where it disagrees.
        compare_with_end(rest.damage.empty() ? problem_of(file.name(), "")
                                             : moved(rest.damage.front()));
    }

    Result<Trace> read_end_of(Source source) const {
        auto read = read_trace(std::move(source));
        return read ? std::move(read) : Result<Trace>(moved(read.problem()));
    }

    /// Says what does not agree with the end record; a problem points at it.
    void compare_with_end(const Problem& at) {
        const auto disagree = [&](std::uint64_t told, std::string_view what, std::uint64_t found) {
            damage.push_back(at);
            damage.back().message =
                disagreement(fmt::format("{}", told), what, fmt::format("{}", found));
        };
        if (end->steps && *end->steps != before + block.size())
            disagree(*end->steps, "steps", before + block.size());
        if (has_useless_steps)
            return;
        for (const auto& [name, told] : end->count) {
            if (const std::uint64_t found = sums.counts.of(name); found != told)
                disagree(told, name + " steps", found);
        }
        if (sums.state && !sums.has_stray_pixel)
            if (auto message = disagreement_of_picture(header, *end, sums.state->frame().image)) {
                damage.push_back(at);
                damage.back().message = *std::move(message);
            }
    }
};

void StepStream::tell_all() {
    state_->tells_all = true;
    state_->sums.state.emplace(state_->header.canvas);
}

std::vector<Problem> StepStream::faults_in_step() const {
    std::vector<Problem> faults = state_->block.faults_in_step(state_->place);
    for (Problem& fault : faults)
        fault = State::moved(std::move(fault), state_->lines_before_block);
    return faults;
}

const std::vector<Problem>& StepStream::passed_over() const {
    return state_->passed_over;
}

const NotFiniteSteps& StepStream::not_finite() const {
    return state_->not_finite;
}

StepStream::StepStream(StepStream&&) noexcept = default;
StepStream& StepStream::operator=(StepStream&&) noexcept = default;
StepStream::~StepStream() = default;

const Trace& StepStream::header() const {
    return state_->header;
}

std::string StepStream::header_json() const {
    return state_->header_line + (state_->layout == LineLayout::document ? "]}" : "");
}

const std::optional<FileId>& StepStream::file() const {
    return state_->file.id();
}

bool StepStream::next() {
    if (state_->place < state_->block.size()) {
        ++state_->place;
        return true;
    }
    if (!state_->next_block())
        return false;
    state_->place = 1;
    return true;
}

StepView StepStream::step() const {
    return state_->block.step(state_->place);
}

std::optional<StepKind> StepStream::kind() const {
    return state_->block.kind_of(state_->place);
}

bool StepStream::is_plain() const {
    return state_->block.is_plain(state_->place);
}

std::size_t StepStream::number() const {
    return state_->before + state_->place;
}

const std::optional<EndRecord>& StepStream::end() const {
    return state_->end;
}

const std::vector<Problem>& StepStream::damage() const {
    return state_->damage;
}

std::size_t StepStream::offset() const {
    const std::size_t lines = state_->header_line.size() + 1;
    return state_->block_begin + state_->block.offset_of(state_->place) - lines;
}

int StepStream::descriptor() const {
    return state_->file.descriptor();
}

bool StepStream::is_behind_end() const {
    return state_->is_behind && state_->place == state_->block.size();
}

void StepStream::let_grow(bool may_grow) {
    state_->may_grow = may_grow;
}

std::variant<StepStream, Source> StepStream::open(FirstLine first, std::size_t jobs) {
    if (first.layout == LineLayout::other)
        return std::move(first.source);
    StepStream stream(std::move(first.file), first.layout, first.source.text);
    stream.state_->jobs = jobs;
    return stream;
}

StepStream::StepStream(InputFile file, LineLayout layout, const std::string& first)
    : state_(std::make_unique<State>(std::move(file))) {
    State* const state = state_.get();
    state->layout = layout;
    const std::size_t newline = first.find('\n');
    state->header_line = without_blanks(first.substr(0, newline));
    state->text = first.substr(newline + 1);
    state->text_begin = newline + 1;
    state->header = state->trace_of("", false);
    state->damage.clear();
    state->passed_over = state->header.passed_over;
}

std::variant<StepStream, Source> open_steps(const std::string& path, const InputLimits& limits) {
    return StepStream::open(open_first_line(path, InputCheck::Kind::scene_or_trace, limits),
                            limits.jobs);
}

std::variant<StepStream, Source> open_steps_or_claims(const std::string& path,
                                                      const InputLimits& limits) {
    return StepStream::open(open_first_line(path, InputCheck::Kind::scene_trace_or_claims, limits),
                            limits.jobs);
}

} // namespace rastertrace
