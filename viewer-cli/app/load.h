// SPDX-License-Identifier: MIT
#pragma once

// Inputs of commands: a scene, or a trace, or a scene where a trace is wanted, which is drawn
// first. A picture is the trace of its pixels.

#include "app/exit_status.h"

#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/check/claims.h>
#include <rastertrace/trace/picture/picture.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/trace_options.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

/// What was made, or the Problem that kept it from being made, thrown.
template <typename T> T value_or_throw(Result<T> result) {
    if (!result)
        throw result.problem();
    return std::move(result.value());
}

/// How the scenes that a command reads are drawn, and what of them is read.
struct SceneOptions {
    MethodOverrides method = {};
    InputLimits limits = {};
    FrameChoice frames = {};
    bool is_quiet = false;    ///< remarks on scenes are told nobody
    bool tells_steps = false; ///< the sentences of wrong steps of a trace are marked
};

/// What a command was given: a trace, or a scene, which has one frame or, if numbers vary, more.
///
///     InputFrames input("scene.json", {});
///     for (std::size_t n = input.first(); n <= input.last(); ++n)
///         use(input.trace(n));
class InputFrames {
public:
    /// Reads the file ("-" for standard input). Throws a Problem.
    InputFrames(const std::string& path, const SceneOptions& options);

    /// The same for a file that has been read.
    InputFrames(const std::string& path, Source source, const SceneOptions& options);
    InputFrames(const InputFrames&) = delete;
    InputFrames& operator=(const InputFrames&) = delete;

    std::size_t first() const { return first_; } ///< of the frames that were asked for, from 1
    std::size_t last() const { return last_; }

    /// True if more than one frame was asked for.
    bool is_sequence() const { return first_ < last_; }

    /// The trace that was given; nullptr if it was a scene.
    const Source* given_trace() const { return scenes_ ? nullptr : &source_; }

    /// The scene that was given, if it is one frame; nullptr else.
    const Source* given_scene() const {
        return scenes_ && scenes_->count() == 1 ? &source_ : nullptr;
    }

    /// `3 of 24: degrees 30`, for a frame of a sequence.
    std::string label(std::size_t frame) const { return scenes_->label(frame); }

    /// The scene of a frame, and its plan. Remarks on the first one go to standard error. Throws a
    /// Problem; that the input is a trace is one.
    PlannedScene scene(std::size_t frame);

    /// The trace that was given, or that of the frame, drawn; with a title to show. Throws a Problem.
    /// Damage that leaves a trace usable is left to the caller, see report_damage.
    Trace trace(std::size_t frame);

    /// That of the scene's frame, drawn by another method instead. Throws a Problem; that the input is a
    /// trace is one.
    Trace trace_by(std::size_t frame, const MethodOverrides& method) const;

private:
    std::string path_;
    SceneOptions options_;
    Source source_;
    std::optional<SceneSequence> scenes_; ///< none: it is a trace
    std::size_t first_ = 1;
    std::size_t last_ = 1;
};

/// True if an entry of a folder is a regular file. That a link leads to nothing is told on standard error.
bool is_file(const std::filesystem::directory_entry& entry);

/// Throws a Problem if a region does not lie on a canvas.
void check_region(const Region& region, const Canvas& canvas);

/// The picture in a regular file, if it is one (picture.h). Throws a Problem for one that is damaged.
std::optional<Picture> picture_in_file(const std::string& path, const InputLimits& limits);

/// Reads a file that is a scene, a trace or a picture, whose trace it returns. Throws a Problem.
Source load_input(const std::string& path, const InputLimits& limits);

/// The trace that was read, or that of the scene, drawn. Options are about scenes only. Throws a Problem.
Trace trace_to_compare(Source source, const std::string& path, const SceneOptions& options);

/// Throws a Problem if an option says how to draw what is drawn already.
void refuse_scene_options(const Source& trace, const SceneOptions& options);

/// The scene in a file: the frame that was chosen, or the first.
PlannedScene load_scene(const std::string& path, const SceneOptions& options = {});

/// The text of the scene in a file, not yet read. Throws a Problem; a trace is one.
Source load_scene_source(const std::string& path, const InputLimits& limits = {});

/// The title to show: the given one, or else the name of the file that has none, without its folder.
std::string shown_title(const std::string& title, const std::string& path);

/// The trace in a file, or that of the scene in it: of the frame that was chosen, or the first.
Trace load_trace(const std::string& path, const SceneOptions& options = {});

/// Reads a file that is a scene, a trace, or claims. Throws a Problem.
Source load_scene_trace_or_claims(const std::string& path, const InputLimits& limits);

/// What claims are held against, in a source that is a scene or a trace. Throws a Problem.
Truth truth_in(Source source, const SceneOptions& options);

/// The path of the scene or trace that claims name, which starts from their folder. Throws a Problem if they name none.
std::string path_of_scene(const Claims& claims);

/// The scene or trace at that path. Throws a Problem, at the place where claims name a file that cannot be used.
Source load_scene_of_claims(const Claims& claims, const InputLimits& limits);

/// Reads the Markdown page in a file, which is no pipe and no device. Throws a Problem.
Source load_page(const std::string& path);

/// Tells on standard error what is wrong with a trace that can be used all the same. Returns the
/// exit status that this means: bad input if there was something to tell.
ExitStatus report_damage(const Trace& trace);

/// Standard output. Throws a Problem if what is written would go into a file that has been read, as after `>>` it may.
DescriptorOutput standard_output();

/// Writes to it. Throws a Problem.
void print(std::string_view text);

/// Writes to standard error, if it takes it: that it does not changes nothing else.
void print_error(std::string_view text) noexcept;

/// "rastertrace: scene.json:3:5: expected ..." on standard error.
void print_error(const Problem& problem);

} // namespace rastertrace
