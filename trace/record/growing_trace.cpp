// SPDX-License-Identifier: MIT
#include "growing_trace.h"

#include "step_places.h"
#include "step_stream.h"

#include <rastertrace/trace/text/first_line.h>
#include <rastertrace/trace/text/input_file.h>
#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/mapped_file.h>
#include <rastertrace/trace/text/nameless_file.h>
#include <rastertrace/trace/text/output.h>

#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <limits>
#include <utility>

namespace rastertrace {

namespace {

/// So many steps are read at once, at most.
constexpr std::size_t steps_in_piece = 20'000;

/// Pictures that are kept have 32 bits for a step, see snapshots.h.
constexpr std::size_t most_steps = std::numeric_limits<std::uint32_t>::max();

struct stat status_of(int descriptor, const std::string& name) {
    struct stat status {};
    if (::fstat(descriptor, &status) != 0)
        throw problem_of_system(name, "could not be read", errno);
    return status;
}

} // namespace

struct GrowingTrace::State {
    Trace trace;
    std::optional<StepStream> steps; ///< none: the trace has been given whole
    bool is_whole = false;
    std::string name;
    std::string path; ///< of the file that steps stay in; "": of none
    int descriptor = -1;
    struct stat status {}; ///< when it was opened

    std::optional<InputFile> pipe; ///< until its end
    std::string from_pipe;
    Descriptor spool;

    /// Takes what the pipe has now.
    void spool_more() {
        pollfd ready{pipe->descriptor(), POLLIN, 0};
        if (::poll(&ready, 1, 0) <= 0)
            return;
        if (!pipe->read_into(from_pipe)) {
            pipe.reset();
            steps->let_grow(false);
            return;
        }
        write_to_spool();
    }

    bool read_on();

    void write_to_spool() {
        DescriptorOutput(spool.number(), "a temporary file for " + name).write(from_pipe);
        from_pipe.clear();
    }
};

GrowingTrace::GrowingTrace(std::unique_ptr<State> state) : state_(std::move(state)) {}
GrowingTrace::GrowingTrace(GrowingTrace&&) noexcept = default;
GrowingTrace& GrowingTrace::operator=(GrowingTrace&&) noexcept = default;
GrowingTrace::~GrowingTrace() = default;

GrowingTrace::GrowingTrace(Trace trace) : state_(std::make_unique<State>()) {
    state_->trace = std::move(trace);
    state_->is_whole = true;
}

const Trace& GrowingTrace::trace() const {
    return state_->trace;
}

void GrowingTrace::name_untitled(const std::string& title) {
    if (state_->trace.title.empty())
        state_->trace.title = title;
}

void GrowingTrace::let_numbers_give(std::map<std::size_t, std::string> values_of_steps) {
    state_->trace.numbers_give =
        std::make_shared<const std::map<std::size_t, std::string>>(std::move(values_of_steps));
}

bool GrowingTrace::is_whole() const {
    return state_->is_whole;
}

int GrowingTrace::pipe() const {
    return state_->pipe ? state_->pipe->descriptor() : -1;
}

void GrowingTrace::wait_for_pipe() const {
    if (state_->pipe)
        wait_until_readable(state_->pipe->descriptor());
}

double GrowingTrace::share() const {
    if (state_->is_whole)
        return 1;
    const Trace& trace = state_->trace;
    const auto size = status_of(state_->descriptor, state_->name).st_size;
    if (state_->pipe || trace.size() == 0 || size == 0)
        return 0;
    return static_cast<double>(trace.offset_of(trace.size())) / static_cast<double>(size);
}

bool GrowingTrace::read_on() {
    if (state_->is_whole)
        return false;
    try {
        return state_->read_on();
    } catch (const Problem& problem) {
        // What stands in front of it can be used.
        state_->trace.damage.push_back(problem);
        state_->is_whole = true;
        state_->pipe.reset();
        return true;
    }
}

bool GrowingTrace::State::read_on() {
    if (pipe)
        spool_more();
    const std::size_t before = trace.size();
    while (trace.size() < before + steps_in_piece && steps->next()) {
        const auto length = static_cast<std::uint32_t>(steps->step().json().size());
        trace.steps_->add({.offset = steps->offset(),
                           .length = length,
                           .kind = steps->kind(),
                           .is_plain = steps->is_plain()});
        trace.text_of_file_ = trace.source_.mapped->first(steps->offset() + length);
    }
    if (trace.size() > most_steps)
        throw problem_of(name, "expected a trace of at most 4,294,967,295 steps, found more");
    trace.damage = steps->damage();
    trace.not_finite = steps->not_finite();
    const bool is_at_end = trace.size() < before + steps_in_piece;
    if (is_at_end && (!pipe || steps->is_behind_end())) {
        trace.end = steps->end();
        is_whole = true;
        pipe.reset();
    }
    return trace.size() > before || is_whole;
}

std::optional<std::string> GrowingTrace::change() const {
    if (state_->path.empty())
        return std::nullopt;
    const auto changed = [this](const Words& what) {
        return state_->path + std::string(what.in(language_of_steps()));
    };
    const struct stat& before = state_->status;
    const struct stat now = status_of(state_->descriptor, state_->name);
    struct stat at_path {};
    if (::stat(state_->path.c_str(), &at_path) == 0 &&
        (at_path.st_ino != before.st_ino || at_path.st_dev != before.st_dev))
        return changed({" is another file now", " agora é outro arquivo"});
    // Of a file that was cut nothing may be read, so its last step is only measured.
    const Trace& trace = state_->trace;
    const StepView last = trace.size() == 0 ? StepView("") : trace.step(trace.size());
    const std::size_t needed =
        trace.size() == 0 ? 0 : trace.offset_of(trace.size()) + last.json().size();
    if (now.st_size < before.st_size || static_cast<std::size_t>(now.st_size) < needed)
        return changed({" was cut short", " foi encurtado"});
    const bool is_written = now.st_mtim.tv_sec != before.st_mtim.tv_sec ||
                            now.st_mtim.tv_nsec != before.st_mtim.tv_nsec;
    if (is_written)
        return changed({" was changed", " foi alterado"});
    return std::nullopt;
}

std::variant<GrowingTrace, Source> GrowingTrace::open(const std::string& path,
                                                      const InputLimits& limits) {
    auto [input, source, layout] =
        open_first_line(path, InputCheck::Kind::scene_trace_or_claims, limits);
    if (layout == LineLayout::other)
        return std::move(source);

    auto state = std::make_unique<GrowingTrace::State>();
    state->name = source.name;
    if (source.file && path != "-") {
        state->path = path;
        state->steps = StepStream(std::move(input), layout, source.text);
        state->descriptor = state->steps->descriptor();
    } else {
        NamelessFile file = nameless_file(source.name);
        state->pipe = std::move(input);
        state->spool = std::move(file.to_write);
        state->from_pipe = source.text;
        state->write_to_spool();
        ::lseek(file.to_read.number(), static_cast<off_t>(source.text.size()), SEEK_SET);
        state->steps =
            StepStream(InputFile(source.name, std::move(file.to_read)), layout, source.text);
        state->steps->let_grow(true);
        state->descriptor = state->steps->descriptor();
    }
    state->status = status_of(state->descriptor, state->name);
    state->trace = state->steps->header().without_steps();
    state->trace.passed_over = state->steps->passed_over();
    state->trace.source_.mapped = MappedFile::of(state->descriptor, state->name, true);
    state->trace.steps_->set_file(state->trace.source_.mapped);
    return GrowingTrace(std::move(state));
}

} // namespace rastertrace
