// SPDX-License-Identifier: MIT
#pragma once

// A trace read once, step by step, without keeping it: for those that are larger than the memory. Each step is
// checked as read_trace does.
//
//     auto opened = open_steps("trace.jsonl", {});  // throws a Problem
//     if (auto* stream = std::get_if<StepStream>(&opened))
//         while (stream->next())
//             use(stream->number(), stream->step());
//
// It takes the layouts of this program, one step a line, also from a pipe. What has another layout, or is a scene,
// is read whole.

#include "trace.h"

#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/problem.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rastertrace {

class GrowingTrace;
class InputFile;
struct FirstLine;
enum class LineLayout : std::uint8_t;

class StepStream {
public:
    StepStream(StepStream&&) noexcept;
    StepStream& operator=(StepStream&&) noexcept;
    ~StepStream();

    /// What stands in front of the steps: a trace without any.
    const Trace& header() const;

    /// Goes to the next step; false behind the last. Throws a Problem.
    bool next();

    /// The current step, valid until the next one is asked for.
    StepView step() const;
    std::optional<StepKind> kind() const;
    std::size_t number() const; ///< from 1
    bool is_plain() const;      ///< see Trace::is_plain

    /// Where the step begins in the file, in bytes.
    std::size_t offset() const;

    /// Behind the last step: what the end record says, if there is one.
    const std::optional<EndRecord>& end() const;

    /// Behind the last step: what is wrong though the steps can be used. The picture is held against the end record
    /// only after tell_all.
    const std::vector<Problem>& damage() const;

    /// Of the steps that have been read.
    const NotFiniteSteps& not_finite() const;

    /// Fields of the current step that have another type than step_kind.h says, though the step can be understood.
    std::vector<Problem> faults_in_step() const;

    /// Known keys of the header, and behind the last step also of the end record, that are not as the format says, and
    /// that nobody reads.
    const std::vector<Problem>& passed_over() const;

    /// Before the first step: for who wants to know all that is wrong. A step that cannot be used is damage, as in
    /// read_trace_to_tell, and the picture is drawn and held against the end record.
    void tell_all();

private:
    friend std::variant<StepStream, Source> open_steps(const std::string& path,
                                                       const InputLimits& limits);
    friend std::variant<StepStream, Source> open_steps_or_claims(const std::string& path,
                                                                 const InputLimits& limits);
    int descriptor() const;

    /// Whether more may be added to the file, as to that which keeps a pipe: then next() is false where it ends, and may
    /// be true later. Only what ends with a newline is a step then.
    void let_grow(bool may_grow);
    bool is_behind_end() const; ///< an end record, or the end of a file that does not grow
    struct State;
    static std::variant<StepStream, Source> open(FirstLine first);
    friend class GrowingTrace;
    StepStream(InputFile file, LineLayout layout, const std::string& first);

    std::unique_ptr<State> state_;
};

/// Opens a file ("-" for standard input): the steps of a trace, or, if it is none of one step a line, all that it
/// holds. Throws a Problem.
std::variant<StepStream, Source> open_steps(const std::string& path, const InputLimits& limits);

/// The same for a command that takes claims too, which need not be JSON.
std::variant<StepStream, Source> open_steps_or_claims(const std::string& path,
                                                      const InputLimits& limits);

} // namespace rastertrace
