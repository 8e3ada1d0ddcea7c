// SPDX-License-Identifier: MIT
#pragma once

// The options that many commands have: how a scene is drawn, how much is read, which frame.

#include "app/command.h"
#include "app/load.h"

#include <rastertrace/trace/compare/diff.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/method_names.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// What the argument of a command that needs a trace is.
inline const std::string trace_input =
    "A trace, or a scene, which is drawn first; - for standard input";

/// Tells steps in the language of --language, or of RASTERTRACE_LANGUAGE if that is not given; never
/// by the locale: a command prints the same on every machine.
void choose_language(const std::string& option);

/// Adds --view; `view` gets its value.
void add_view_to(OptionList& options, std::string& view);

/// --fan-passes for fan_passes.
std::string option_named(std::string_view key);

/// One option per key of the method: --scalar, --fill, ...
class MethodOptions {
public:
    void add_to(OptionList& options);
    MethodOverrides overrides() const;

private:
    std::string file_;
    std::map<std::string, std::string> values_;
    std::string keep_;
    bool full_ = false;
};

/// Whether a command holds the steps of a trace, and so has --max-steps.
enum class Holds { no_steps, steps };

/// How far the files that are read are trusted: --max-input, --allow-outside; how much of them is
/// held: --max-steps.
class InputOptions {
public:
    void add_to(OptionList& options, Holds holds);
    InputLimits limits() const;

private:
    std::string max_input_;
    std::string max_steps_;
    InputLimits limits_;
};

/// Which frame of a scene whose numbers vary: --vary, --frame.
class FrameOptions {
public:
    /// `without` is what happens without --frame.
    void add_to(OptionList& options, std::string_view without);
    FrameChoice choice() const;

private:
    std::vector<std::string> vary_;
    std::string frame_;
};

/// What of two traces is compared: --tolerance, --ignore, --only, --key, --any-order, --common.
class ComparisonOptions {
public:
    void add_to(OptionList& options);
    DiffOptions options() const;

    /// Of a picture: the color of what is not drawn.
    std::optional<Color> background() const;

    /// The options as words for a shell, but for --common and --any-order; `ignored` are left out besides.
    std::string words(const std::string& ignored) const;

private:
    std::string background_;
    DiffOptions options_;
    std::vector<std::string> tolerances_;
    std::vector<std::string> keys_;
    std::string ignored_;
    std::string only_;
    bool is_any_order_ = false;
};

/// All of them.
class DrawingOptions {
public:
    void add_to(OptionList& options, Holds holds,
                std::string_view without_frame = "1 if not given") {
        method_.add_to(options);
        input_.add_to(options, holds);
        frames_.add_to(options, without_frame);
    }

    /// Throws a Problem.
    SceneOptions scene_options() const {
        return {
            .method = method_.overrides(), .limits = input_.limits(), .frames = frames_.choice()};
    }

private:
    MethodOptions method_;
    InputOptions input_;
    FrameOptions frames_;
};

} // namespace rastertrace
