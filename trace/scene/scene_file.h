// SPDX-License-Identifier: MIT
#pragma once

// Scene files: JSON to Scene. docs/scene-format.md describes them.
//
//     const auto read = read_scene({"first.json", text});
//     draw(read.value().scene, read.value().plan, listener);

#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// A number of the scene that has another value in each frame, as a command line says it.
struct Variation {
    std::string pointer; ///< to the number: a JSON Pointer (RFC 6901)
    std::string values;  ///< FROM:TO:STEPS, or the values with commas between
};

/// What of a sequence is asked for.
struct FrameChoice {
    std::vector<Variation> vary; ///< in the place of what the scene says of the same number
    std::optional<std::size_t> frame = {}; ///< from 1; none: all, or the first
};

/// The most frames of a sequence.
inline constexpr std::size_t most_frames = 100'000;

/// A scene, and how it is drawn.
struct PlannedScene {
    Scene scene;
    Plan plan;

    /// What can be drawn, but is probably not what its author meant.
    std::vector<Problem> remarks;
};

/// Reads a scene. `overrides` take the place of what its "method" says. The scene that comes back
/// can be drawn: every name is known, every number is finite, and no step can overflow. That is
/// found out by planning, so the plan comes with it. `limits` are for the files of its meshes. Of a
/// sequence of scenes, this is the frame that is chosen, or else the first.
Result<PlannedScene> read_scene(const Source& source, const MethodOverrides& overrides = {},
                                const InputLimits& limits = {}, const FrameChoice& choice = {});

/// Overrides that leave no stage out: so is drawn what another drawing is held against, which may leave out less.
MethodOverrides every_stage_kept();

/// True if a source may hold a scene: an object with a key that says what is drawn or how, or the beginning of an
/// object that is no JSON.
bool is_scene(const Source& source);

/// The scenes of a source whose "vary" makes a sequence of it: frame n is the scene that has the
/// numbers of frame n typed in their places. A scene where nothing varies is its only frame.
///
///     SceneSequence sequence(source, {}, {}, {});
///     for (std::size_t n = 1; n <= sequence.count(); ++n)
///         draw(sequence.frame(n).scene, ...);
class SceneSequence {
public:
    /// Finds out what varies; throws a Problem. The source must outlive the sequence.
    SceneSequence(const Source& source, MethodOverrides overrides, InputLimits limits,
                  const std::vector<Variation>& vary);
    SceneSequence(SceneSequence&&) noexcept;
    ~SceneSequence();

    /// How many frames it has.
    std::size_t count() const;

    /// What is said of a frame, in the language of steps: `3 of 24: degrees 30`.
    std::string label(std::size_t frame) const;

    /// Reads a frame, from 1 to count(), as read_scene does; throws a Problem.
    PlannedScene frame(std::size_t frame);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace rastertrace
