// SPDX-License-Identifier: MIT
#pragma once

// A trace that was read back: its header, its steps, its end record.
//
//     const Result<Trace> trace = read_trace(std::move(source));
//     trace.value().size();                  // how many steps
//     trace.value().step(1).kind_name();     // "primitive"
//
// Steps and fields of unknown names are kept as text.

#include "step_kind.h"

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/problem.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace rastertrace {

class Steps;
struct Plan;
struct Scene;

/// No limit.
inline constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

/// One step: a view, valid as long as its trace.
class StepView {
public:
    /// A step of a kind that we know, with its struct (traced_steps.h); and its text, if that is not as this program writes
    /// it. Of another kind, the text alone.
    StepView(std::optional<StepKind> kind, const void* value, std::string_view text)
        : kind_(kind), value_(value), text_(text) {}

    /// A `pixel` step without a color.
    explicit StepView(const Pixel& pixel) : kind_(StepKind::pixel), pixel_(pixel) {}

    /// Its object, as it stands in a trace.
    std::string json() const;

    /// The value of "step": primitive, pixel, ..., or a name that we do not know.
    std::string kind_name() const;
    std::optional<StepKind> kind() const { return kind_; }

    /// The step as its kind has it; Step is that of its kind. A reference, but to a pixel, of which a row may be held.
    template <typename Step>
    std::conditional_t<Step::step_kind == StepKind::pixel, Step, const Step&> as() const {
        assert(kind_ == Step::step_kind);
        if constexpr (Step::step_kind == StepKind::pixel)
            if (value_ == nullptr)
                return Step{.x = pixel_.x, .y = pixel_.y};
        return *static_cast<const Step*>(value_);
    }

    /// The JSON of a field, or nothing if the step has no such field.
    std::optional<std::string> field(std::string_view name) const;

    /// The name and the JSON of each field.
    std::vector<std::pair<std::string, std::string>> fields() const;

    /// Its text, if that is not as this program writes it; else "".
    std::string_view own_text() const { return text_; }

private:
    std::optional<StepKind> kind_;
    const void* value_ = nullptr; ///< of a `pixel` step without a color: null
    std::string_view text_;
    Pixel pixel_{};
};

/// What the end record says; whatever it leaves out is not there.
struct EndRecord {
    std::optional<std::uint64_t> steps;
    std::map<std::string, std::uint64_t> count; ///< of steps, by kind
    std::optional<std::uint64_t> pixels;        ///< different pixels plotted
    std::string frame;                          ///< name of the final picture, see frame_name
};

/// Which steps were left out, as the header says: `only`, `region`, `primitive`.
struct LeftOut {
    std::optional<std::vector<std::string>> only; ///< the kinds that were written
    std::optional<std::array<Index, 4>> region;   ///< x0, y0, x1, y1: those about these pixels
    std::string primitive;                        ///< the one whose steps were written
    bool has_places_missing = false;              ///< by `region` or `primitive`
};

/// Steps of a foreign rasterizer with a quantity that is not finite: "NaN", "inf" or "-inf". Nothing is worked out from
/// such a number.
struct NotFiniteSteps {
    std::uint64_t count = 0;
    std::optional<Problem> first; ///< where the first of them is, and what it has

    /// What is said of them, if there are any.
    std::optional<Problem> remark() const;
};

class Trace {
public:
    Trace();

    Index version = 0; ///< of the format
    std::string title;
    Canvas canvas;
    std::optional<Color> background; ///< of pixels that nothing draws
    ToldMethod method;
    std::vector<std::string> stages; ///< those that ran, as in the header; see stages.h
    std::string numbers;             ///< those that were drawn with, where the plan chose them
    std::string projection;  ///< how camera space came to the view plane; "" without transforms
    bool is_partial = false; ///< the header says that steps were left out: only, region, primitive
    LeftOut left_out;
    std::optional<EndRecord> end;
    std::string header_json; ///< as it stands in front of the steps, an object of its own

    /// Where the trace breaks off, if it does; among its damage too.
    std::optional<Problem> cut_short;

    /// What is wrong with the trace though its whole steps can be used: cut short, pixels off the
    /// canvas, counts that do not agree. Empty for a sound trace.
    std::vector<Problem> damage;

    NotFiniteSteps not_finite;

    /// Of steps that do not tell what their numbers give: what these give, by the step's number in the whole trace. For
    /// who has done them again (audit/redo.h).
    std::shared_ptr<const std::map<std::size_t, std::string>> numbers_give;

    /// Known keys of the header and the end record that are not as the format says, and that nobody reads.
    std::vector<Problem> passed_over;

    /// The same for the fields of step n: those that have another type than step_kind.h says, though the step can be
    /// understood without them.
    std::vector<Problem> faults_in_step(std::size_t n) const;

    /// A problem at a field of step n, which was read; at its beginning, if it has no such field.
    Problem problem_at_field(std::size_t n, std::string_view field, std::string message) const;

    /// How many steps there are.
    std::size_t size() const;

    /// Step n, from 1 to size().
    StepView step(std::size_t n) const;

    /// What it was read from; of a trace that was drawn, the name of its scene.
    const Source& source() const;

    /// The line of the file that step n is in, from 1; 0 if it was read from no file, or has not one step a line.
    std::size_t line_of(std::size_t n) const;

    /// The kind of step n, if we know it.
    std::optional<StepKind> kind_of(std::size_t n) const;

    /// The first step from n to `last` that is of one of these kinds; last + 1, if there is none.
    std::size_t next_of(StepKindSet kinds, std::size_t n, std::size_t last) const;

    /// The numbers of the steps of these kinds, from `first` to `last`.
    ///
    ///     for (const std::size_t n : trace.steps_of({StepKind::primitive}))
    std::vector<std::size_t> steps_of(StepKindSet kinds, std::size_t first = 1,
                                      std::size_t last = any_number) const;

    /// True if step n is a line as this program writes it: then nothing is wrong with it.
    bool is_plain(std::size_t n) const;

    /// The number of step n in the trace that this is an excerpt of; n, if it is none.
    std::size_t number_of(std::size_t n) const {
        return !is_excerpt_ || n == 0 ? n : numbers_[n - 1];
    }

    /// The header and the end of this trace, without a step: the beginning of an excerpt, which has the same steps in memory.
    Trace without_steps() const;

    /// Adds a step to an excerpt: step `number` of the whole trace.
    void add_to_excerpt(std::size_t number) { numbers_.push_back(number); }

    /// True if steps of this kind were left out.
    bool lacks(StepKind kind) const;

private:
    friend class TraceReader;
    friend Trace drawn_trace(const Scene& scene, const Plan& plan, const std::string& name,
                             std::size_t most_steps);

    std::string_view text_of(std::size_t n) const;

    std::shared_ptr<Steps> steps_;
    bool has_lines_ = false; ///< one step a line
    bool is_excerpt_ = false;
    std::vector<std::size_t> numbers_; ///< of an excerpt: those of its steps in the whole trace
};

/// Reads a trace in either layout, found by its content. A problem comes back only if nothing can
/// be shown: no header, a newer version, a line that is no step, or more steps than are wanted.
Result<Trace> read_trace(Source source, std::size_t most_steps = any_number);

/// The most steps of a trace that are told to be of no use before the reading ends.
inline constexpr std::size_t most_useless_steps = 100;

/// The same for who wants to know all that is wrong: a step that cannot be used is damage, has no kind, and the rest is
/// read.
Result<Trace> read_trace_to_tell(Source source, std::size_t most_steps = any_number);

/// Draws a scene and holds its steps; pixels of a row that are plotted one after the other are held as one. Throws a
/// Problem that names `--max-steps` if there are more steps to hold than `most_steps`.
Trace drawn_trace(const Scene& scene, const Plan& plan, const std::string& name,
                  std::size_t most_steps);

} // namespace rastertrace
