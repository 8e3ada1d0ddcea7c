// SPDX-License-Identifier: MIT
#include "step_stream.h"

#include "frame.h"
#include "line_blocks.h"
#include "trace_lines.h"
#include "unknown_names.h"

#include <rastertrace/trace/text/first_line.h>
#include <rastertrace/trace/text/input_check.h>
#include <rastertrace/trace/text/input_file.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <fmt/core.h>

#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

template <typename T> T value_of(Result<T> result) {
    if (!result)
        throw result.problem();
    return std::move(result.value());
}

} // namespace

/// The file comes in blocks of whole lines. Each block is read as a trace of its own, with the header in front, so
/// that every line is checked as in a trace that is read whole.
struct StepStream::State {
    LineBlocks lines;
    std::size_t block_begin = 0;  ///< of the current block's lines in the file
    std::size_t lines_before = 1; ///< lines of the file in front of what is in no block yet
    std::size_t lines_before_block = 1;

    Trace header;
    Trace block;
    std::size_t place = 0;  ///< of the current step in the block
    std::size_t before = 0; ///< steps in front of the block
    bool is_behind = false; ///< the last step has been passed
    BlockSums sums;
    std::optional<EndRecord> end;
    std::optional<Problem> fault; ///< what stands behind the current block
    std::vector<Problem> damage;
    std::vector<Problem> passed_over; ///< in the header and the end record
    NotFiniteSteps not_finite;

    bool tells_all = false;         ///< useless steps are damage, and the picture is drawn
    bool has_useless_steps = false; ///< nobody knows what they should have been

    /// What has been read of a file, its first line at least.
    State(InputFile file, LineLayout layout, std::string_view first)
        : lines(std::move(file), layout,
                std::string(without_blanks(first.substr(0, first.find('\n')))),
                first.substr(first.find('\n') + 1), first.find('\n') + 1) {}

    const std::string& name() const { return lines.file().name(); }

    /// A problem of what is in no block yet, with the line that it has in the file.
    Problem moved(Problem problem) const { return moved(std::move(problem), lines_before); }

    /// The same for a problem of lines that so many others stand in front of.
    static Problem moved(Problem problem, std::size_t before) {
        if (problem.line > 1)
            problem.line += before - 1;
        return problem;
    }

    /// The steps of a block, as a trace of its own; what is wrong with them is damage of the whole. Throws a Problem; then
    /// the block is as it was.
    Trace trace_of(LineBlock& from) {
        const bool is_document = lines.layout() == LineLayout::document;
        const std::size_t size = from.text.size();
        if (!from.is_cut_off)
            from.text += is_document ? "],\"end\":{}}" : "{\"end\":{}}";
        Source source{name(), std::move(from.text), {}};
        const bool goes_on = tells_all && damage.size() < most_useless_steps;
        auto read = read_block(source, goes_on, sums);
        if (!read) {
            from.text = std::move(source.text);
            from.text.resize(size);
            throw moved(read.problem());
        }
        for (Problem& problem : read.value().damage)
            damage.push_back(moved(std::move(problem)));
        NotFiniteSteps& more = read.value().not_finite;
        if (not_finite.count == 0 && more.first)
            not_finite.first = moved(*std::move(more.first));
        not_finite.count += more.count;
        return std::move(read.value());
    }

    /// Goes to the next block that has a step.
    bool next_block() {
        if (is_behind)
            return false;
        before += std::exchange(block, {}).size();
        place = 0;
        if (fault)
            throw *fault;
        auto from = next_lines();
        if (!from)
            return false; // not a whole line yet
        const bool had_stray_pixel = sums.has_stray_pixel;
        try {
            block = trace_of(*from);
        } catch (const Problem& problem) {
            sums.has_stray_pixel =
                had_stray_pixel; // the steps in front of the fault are read again
            return next_block_before(problem, *std::move(from));
        }
        block_begin = from->begin;
        if (from->is_cut_off && !block.end && !damage.empty())
            damage.back().message = truncation_after(before + block.size());
        look_for_useless_steps();
        lines_before_block = lines_before;
        lines_before += from->newlines;
        is_behind = from->is_last || from->is_cut_off;
        if (from->is_last)
            read_end();
        return block.size() > 0 || next_block();
    }

    std::optional<LineBlock> next_lines() {
        try {
            return lines.next();
        } catch (Problem& problem) {
            throw moved(std::move(problem));
        }
    }

    /// The steps in front of the line that is no step; the next block is the fault.
    bool next_block_before(const Problem& problem, LineBlock from) {
        const std::size_t whole = problem.line > lines_before ? problem.line - lines_before - 1 : 0;
        const std::size_t front = lines.header_line().size() + 1;
        std::size_t size = front;
        for (std::size_t line = 0; line < whole && size < from.text.size(); ++line)
            size = from.text.find('\n', size) + 1;
        if (size == front)
            throw problem;
        from.text.resize(size);
        from.is_cut_off = false;
        fault = problem;
        block = trace_of(from);
        block_begin = from.begin;
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
        const Trace rest = value_of(read_end_of({name(), lines.rest(), {}}));
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
        compare_with_end(rest.damage.empty() ? problem_of(name(), "") : moved(rest.damage.front()));
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
    const std::size_t front = state_->lines.header_line().size() + 1;
    return state_->block_begin + state_->block.offset_of(state_->place) - front;
}

int StepStream::descriptor() const {
    return state_->lines.file().descriptor();
}

bool StepStream::is_behind_end() const {
    return state_->is_behind && state_->place == state_->block.size();
}

void StepStream::let_grow(bool may_grow) {
    state_->lines.let_grow(may_grow);
}

std::variant<StepStream, Source> StepStream::open(FirstLine first) {
    if (first.layout == LineLayout::other)
        return std::move(first.source);
    return StepStream(std::move(first.file), first.layout, first.source.text);
}

StepStream::StepStream(InputFile file, LineLayout layout, const std::string& first)
    : state_(std::make_unique<State>(std::move(file), layout, first)) {
    State* const state = state_.get();
    LineBlock none{.text = state->lines.header_line() + "\n"};
    state->header = state->trace_of(none);
    state->damage.clear();
    state->passed_over = state->header.passed_over;
}

std::variant<StepStream, Source> open_steps(const std::string& path, const InputLimits& limits) {
    return StepStream::open(open_first_line(path, InputCheck::Kind::scene_or_trace, limits));
}

std::variant<StepStream, Source> open_steps_or_claims(const std::string& path,
                                                      const InputLimits& limits) {
    return StepStream::open(open_first_line(path, InputCheck::Kind::scene_trace_or_claims, limits));
}

} // namespace rastertrace
