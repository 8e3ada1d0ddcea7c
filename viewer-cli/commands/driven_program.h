// SPDX-License-Identifier: MIT
#pragma once

// A rasterizer of somebody else, run on a scene; what it answers, a trace or a picture, held against our drawing.
//
//     const DrivenProgram mine({"./mine", "{scene}"}, {}, std::chrono::seconds(10));
//     if (const auto finding = mine.difference(scene, mine.reference(scene).value())) ...

#include "app/run_program.h"
#include "app/shared_options.h"

#include <rastertrace/trace/compare/diff.h>
#include <rastertrace/trace/fuzz/fuzz_scene.h>
#include <rastertrace/trace/text/problem.h>

#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// How a program has failed.
struct DrivenFinding {
    enum class Kind : std::uint8_t {
        differs, ///< it decides otherwise
        ties, ///< only where two depths are equal, which numbers that round may decide either way
        crashes,  ///< it ends with a signal, or a status that is not 0
        hangs,    ///< it takes more than its time
        no_answer ///< what it answers is no trace and no picture
    };
    Kind kind = Kind::differs;
    std::string text{};  ///< of the difference, or of what it printed on standard error
    std::string first{}; ///< the first decision that differs, in one line; or how it ended
};

/// "decides otherwise", "hangs", ...
std::string_view words_of(DrivenFinding::Kind kind);

class DrivenProgram {
public:
    /// `words` are the program and its arguments. `{scene}` or `{triangles}` stands for a file with the scene;
    /// `{out}` for the file that it answers in, else it answers on standard output. Throws a
    /// Problem.
    DrivenProgram(std::vector<std::string> words, const ComparisonOptions& comparison,
                  std::chrono::seconds time);

    /// What is wrong with its answer to a scene; nothing if it agrees with the reference. Throws a Problem if the program
    /// cannot be run. May be called by several threads.
    std::optional<DrivenFinding> difference(const FuzzScene& scene,
                                            const std::string& reference) const;

    /// The text of a scene, as the program reads it, and the ending of its file.
    std::string scene_text(const FuzzScene& scene) const;
    std::string_view ending() const;

    /// Our trace of a scene, one step a line; a Problem if we do not draw it.
    Result<std::string> reference(const FuzzScene& scene) const;

    /// The words, with a file in the place of the scene.
    std::vector<std::string> words_for(const std::string& scene, const std::string& out) const;

    /// What is never compared: what a program calls its primitives; of a text without names of vertices, these, and what
    /// is named by vertices; colors, if its pictures have one for all primitives.
    std::string ignored() const;

    /// What was compared of the answers that agreed, line by line: of that which told the most.
    std::string remarks() const;
    bool answers_in_file() const { return has_out_; }

private:
    /// What it has written on standard output or in its {out}, or why that cannot be read.
    struct Answer {
        FinishedRun run{};
        Result<Source> bytes = Source{};
    };
    Answer run(const FuzzScene& scene) const;
    std::optional<DrivenFinding> compared(const std::string& reference, Source answer,
                                          FuzzKind kind) const;

    /// Learns from its picture of two small primitives which color is not drawn, that of most pixels, and if it takes
    /// colors from the scene.
    void learn_colors(FuzzKind kind) const;

    std::vector<std::string> words_;
    DiffOptions options_;
    std::chrono::seconds time_;
    std::string placeholder_; ///< of the scene
    bool has_out_ = false;

    mutable std::once_flag has_learnt_colors_;
    mutable std::optional<Color> background_;
    mutable bool takes_colors_ = true;
    mutable std::mutex mutex_;
    mutable std::string remark_;
};

} // namespace rastertrace
