// SPDX-License-Identifier: MIT
#pragma once

// What two traces do differently. Steps are compared, not lines: a primitive is found in the other trace by its name
// and vertices, or else by one of the two (primitive_pairs.h), and each of its steps by the key fields of its kind
// (step_kind.h).
// Numbers are compared by value, as they are written: "25/8" is 3.125.
//
//     const TraceDiff found = diff(one, other, {});  // throws a Problem
//     if (!found.is_same)
//         puts(diff_text(found).c_str());

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/problem.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// How far apart two numbers may be.
struct DiffTolerance {
    std::string kind{};  ///< of steps; "": of any kind
    std::string field{}; ///< "": any number of such a step
    Number amount{};
    bool is_ulps = false; ///< else it is in the unit of the field
};

/// Reads `scanline.left=1e-9`, `scanline=4ulp`, or `4ulp` for all numbers. Ulps are those of a double, or of a float
/// where the scalar of a trace is float, at the larger of the two. Throws a Problem.
DiffTolerance parse_tolerance(const std::string& text);

struct DiffOptions {
    std::vector<DiffTolerance> tolerances{}; ///< the last one that is about a number counts
    std::vector<std::string>
        ignored{}; ///< `header`, `end`, a kind of step, or one of its fields: pixel.color
    std::vector<std::string> only{}; ///< these kinds alone; none: all
    std::map<std::string, std::vector<std::string>>
        keys{};                 ///< of kinds of one's own: the fields that a step is found by
    bool compares_order = true; ///< a step that stands among others than in the other trace differs
    bool compares_common = false; ///< only kinds and fields that both traces tell

    bool ignores(std::string_view name) const {
        return std::find(ignored.begin(), ignored.end(), name) != ignored.end();
    }
};

/// Reads `tile=tx,ty`: the fields that a step of a kind of one's own is found by. Throws a Problem.
void add_step_key(DiffOptions& options, const std::string& text);

/// A step of one of the two traces.
struct DiffStep {
    std::size_t number = 0; ///< from 1
    std::size_t line = 0;   ///< of its file; 0 if that has not one step a line, or was a scene
    std::string json{};
    std::string sentence{}; ///< see describe.h
};

/// A field of a step, or a key of the header, that is not alike.
struct FieldDifference {
    std::string name{};
    std::string a{}; ///< JSON; "" where there is none
    std::string b{};
    std::optional<double> distance{}; ///< between two numbers
};

/// A step that is not alike, or that only one of the traces has.
struct StepDifference {
    std::string kind{};
    std::string primitive{}; ///< "" in front of the first
    std::optional<DiffStep> a{};
    std::optional<DiffStep> b{};
    std::vector<FieldDifference>
        fields{};          ///< none of a step that only one has, or that only has moved
    bool is_moved = false; ///< it stands among others than in the other trace
};

/// A field, over all steps of a kind that are in both.
struct FieldSummary {
    std::string name{};
    std::size_t count = 0;           ///< of steps in which it differs
    std::optional<double> largest{}; ///< distance between two numbers
};

/// What differs in the steps of a kind.
struct KindDifference {
    std::string kind{};
    std::size_t changed = 0;
    std::size_t only_a = 0;
    std::size_t only_b = 0;
    std::size_t moved = 0;
    std::vector<FieldSummary> fields{};
};

/// A pixel of the final pictures.
struct PixelOwner {
    std::string primitive{};
    Color color{};
};
struct PixelDifference {
    Pixel pixel{};
    std::optional<PixelOwner> a{}; ///< nothing: it was not drawn
    std::optional<PixelOwner> b{};
};

/// The letters that stand for primitives in a picture, in this order; more than there are have `#`.
inline constexpr std::string_view primitive_letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";

/// How the final pictures differ.
struct PictureDifference {
    std::uint64_t only_a = 0; ///< pixels that only a has drawn
    std::uint64_t only_b = 0;
    std::uint64_t colors = 0; ///< drawn by both, in different colors
    std::uint64_t owners = 0; ///< drawn by both in one color, by different primitives
    std::vector<PixelDifference>
        pixels{}; ///< the first of them, from the top; at most `most_pixels_told`

    /// A part of the pictures that has as many of them as a page can show: x and y of its top left pixel, and rows of
    /// `#` drawn alike, `!` drawn by a only, `?` by b only, `~` by both otherwise, `.` by none.
    int left = 0;
    int top = 0;
    int down = -1;       ///< from row to row, in y
    bool is_cut = false; ///< the pictures are larger
    std::vector<std::string> rows{};

    /// The same part with a letter for each primitive, if different ones have drawn some pixel.
    std::vector<std::string> faces_a{};
    std::vector<std::string> faces_b{};
    std::vector<std::string> names{}; ///< of the letters, see primitive_letters
};

inline constexpr std::size_t most_pixels_told = 1000;

/// The pixels of the final pictures that differ because of the first difference.
struct Consequences {
    std::uint64_t count = 0;
    std::vector<Pixel> only_a{}; ///< at most `most_pixels_told` of each
    std::vector<Pixel> only_b{};
    std::vector<Pixel> colors{}; ///< drawn by both, in different colors
    std::vector<Pixel> owners{}; ///< drawn by both in one color, by different primitives
};

struct TraceDiff {
    std::string name_a{};
    std::string name_b{};
    bool is_same = false;       ///< nothing differs but what was ignored or is within a tolerance
    bool is_same_bytes = false; ///< not even that
    std::vector<FieldDifference> header{}; ///< `method.scalar`, `canvas.width`, ...
    std::vector<FieldDifference> end{};    ///< `end.frame`, where no step says why
    std::optional<StepDifference> first{}; ///< of the steps
    std::vector<DiffStep> before_a{};      ///< the steps around it
    std::vector<DiffStep> before_b{};
    std::vector<DiffStep> after_a{};
    std::vector<DiffStep> after_b{};
    Consequences led_to{};
    std::vector<KindDifference> kinds{}; ///< in the order of step_kind.h
    std::optional<PictureDifference>
        picture{};                      ///< nothing: steps of pixels are missing, or ignored
    std::vector<std::string> remarks{}; ///< what was not compared, and why
    std::vector<Problem> damage{};      ///< a trace that breaks off is compared as far as it goes
    std::string explanation{};          ///< of the first pixel that differs, where it is asked for
};

/// Compares two traces. Throws a Problem if an option names what neither trace has, or leaves nothing to compare.
TraceDiff diff(const Trace& a, const Trace& b, const DiffOptions& options);

/// How many steps differ, or have moved; and how many pixels of the final pictures differ.
std::uint64_t count_steps(const TraceDiff& found);
std::uint64_t count_pixels(const TraceDiff& found);

/// "1 step differs", "8 steps differ": in the language of steps, as diff_text.
std::string counted_differences(std::uint64_t count, const Words& what);

/// The whole of it as text, for people. Safe to print.
std::string diff_text(const TraceDiff& found);

/// How its table of kinds begins, and the line above its pictures.
std::string heading_of_kinds();
std::string heading_of_pictures();

} // namespace rastertrace
