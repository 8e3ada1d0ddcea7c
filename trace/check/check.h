// SPDX-License-Identifier: MIT
#pragma once

// Claims held against a scene, or against a trace: which are right, and of the wrong ones the right
// value, how it is worked out, and the likely slip. What is said of it is in the language of steps.
//
//     Truth truth(std::move(scene_source), {});
//     const Checked checked = check(truth, claims);
//     checked.claims[2].fields[0].expected;  // "-1/4"
//
// A claim is a step with fields left out. Its key fields (step_kind.h) find the step, `in` names the
// step's primitive; the others are compared. Fields that are no fields of the trace, but follow from it:
//
//     pixel   plotted              the final picture has the pixel
//             inside               a primitive has it, seen or hidden
//             z, inverse_z         of what is seen there
//             color                that is seen there
//             share                of the way from one color of a line to the other
//             visible              it is the named primitive that is seen there
//     primitive  row_count, pixel_count  how many it has, seen or hidden
//             pixels               x and y of each, in the order in which they are drawn
//             visible              it is seen in a pixel
//     primitive, edge  y_form, x_form  m and b of y = m x + b, and of x = m y + b, on a line
//     scanline  pixel_count, pixels  how many pixels it has; the x of each
//     face    centroid, plane      of the corners in the world; A, B, C, D of A x + B y + C z + D = 0
//             angle                between normal and view, in degrees
//     decide  d                    a list: all of a line, in order

#include "claims.h"

#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

class TruthIndex;

/// What claims are held against. Of a scene: values against exact arithmetic, decisions against the scene's
/// own method and scalar, both drawn when someone asks. Of a trace: what it tells.
class Truth {
public:
    explicit Truth(Trace trace);

    /// Throws a Problem if the scene cannot be drawn.
    Truth(Source scene, MethodOverrides overrides, InputLimits limits = {},
          FrameChoice frames = {});
    Truth(Truth&&) noexcept;
    ~Truth();

    /// Decided by the scene's own method and scalar.
    const Trace& decided() const;

    /// The same scene in exact numbers; the trace itself if there is no scene.
    const Trace& exact() const;

    /// The same with every face tested, whether the scene culls or not; nullptr if there is no scene.
    const Trace* with_faces() const;

    /// The same scene by each other tie of its naive and DDA lines, with the name of the tie; none if the scene names one.
    const std::vector<std::pair<std::string, Truth>>& with_other_ties() const;

    /// What can be drawn, but is probably not what the scene's author meant.
    const std::vector<Problem>& remarks() const;

    /// For check(): its steps by their keys, found once for all files of claims.
    const TruthIndex& index() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// What has been found about a claim, or about one of its fields.
enum class ClaimVerdict {
    right,
    wrong,
    follows, ///< wrong only because it goes on from a wrong number, which was claimed elsewhere
    open,    ///< `?`: not worked out yet
    not_understood, ///< of a claim: it cannot be read, or held against the scene
};

/// A mistake that gives the number which was claimed.
struct LikelySlip {
    std::string name;    ///< of slips.h
    std::string meaning; ///< in words
    double evidence =
        0; ///< how much likelier the number is with it than by chance: a natural logarithm
    std::size_t place = 0; ///< of a list, the number that it gives; 0: all that are wrong
};

/// A number of a list, or a pixel of one, that is not the right one.
struct CheckedNumber {
    std::size_t place; ///< from 1
    ClaimVerdict
        verdict; ///< wrong; or follows: the one before it is wrong, and what was added to that is right
    std::string expected; ///< "none" behind the end of the right list
    std::string found;
};

/// What has been found about one field of a claim.
struct CheckedField {
    std::string name; ///< of the field
    ClaimVerdict verdict = ClaimVerdict::right;
    std::string expected = {}; ///< as it would be written: "-1/4", "2, 5"
    std::string found = {};
    std::size_t place =
        0; ///< of a list, the first that is wrong, from 1; then `expected` and `found` are that one

    /// Of a list that is marked number by number: those that are not right, how many are, and of how many that are not
    /// open; and whether numbers are missing behind the last, and no dots say so.
    std::vector<CheckedNumber> numbers = {};
    std::size_t right_numbers = 0;
    std::size_t claimed_numbers = 0;
    bool ends_early = false;

    std::string remark =
        {}; ///< "rounded to 2 digits", or what the scalar decides otherwise; may be empty

    /// Of a wrong one: the rule that it comes of, and its formula in letters; empty if there is none.
    std::string_view rule = {};
    std::string_view formula = {};

    /// Of a wrong one: most likely first, which is the one that explains most of the wrong fields.
    std::vector<LikelySlip> slips = {};

    /// Where the number stands that it goes on from: its line, which may be the field's own, and its field.
    std::size_t follows_from = 0;
    std::string follows_from_field = {};
    bool follows_from_rounded = false; ///< that number is right, but rounded
};

struct CheckedClaim {
    std::size_t claim = 0; ///< which one of the claims
    ClaimVerdict verdict = ClaimVerdict::right;
    std::vector<CheckedField> fields = {}; ///< those that were compared, in the claim's order
    std::size_t step = 0;                  ///< of the exact trace that it is about; 0 for none

    /// Of a wrong one: what is to be known besides (there is no such row; contradicts line 3), then how the
    /// right values are worked out.
    std::vector<std::string> remarks = {};
    std::vector<std::string> working = {};

    /// Of a picture that differs: `#` right, `!` extra, `?` missing, `.` empty, blank left open, each row with what the
    /// trace tells of it behind it.
    std::vector<std::string> picture = {};

    std::optional<Problem> problem = {}; ///< why it is not understood
};

struct Checked {
    std::size_t right = 0;
    std::size_t wrong = 0;
    std::size_t follow = 0;
    std::size_t open = 0;
    std::size_t not_understood = 0;
    std::size_t end_early =
        0; ///< of the open ones: lists of which all numbers are right, but some missing
    std::vector<CheckedClaim> claims;    ///< one for each, in their order
    std::vector<std::string> slips = {}; ///< behind the wrong numbers, the most likely first
    std::string remark = {};             ///< all of it is right with `ties: start`; may be empty

    /// True if a claim is wrong, is not understood, or ends early.
    bool has_faults() const { return wrong + follow + not_understood + end_early > 0; }

    /// Of the claims that are not understood; nothing if all are.
    std::optional<Problem> problem() const;
};

/// Checks every claim. One about a name that the scene does not have, or that does not say which of several steps is
/// meant, is not understood, as one that cannot be read. Throws a Problem if none is understood.
Checked check(const Truth& truth, const Claims& claims);

/// `, number 3` of a list, `, row 1, column 3` of a matrix; empty of 0.
std::string place_in_list(std::size_t place, std::string_view field);

/// "first pixel: expected -1, found 0", in the words that the claims are written in. `expected` and `found` are the
/// field's, or those of the number at a place of its list, or what is shown of them.
std::string difference_text(const Claims& claims, const CheckedField& field,
                            std::string_view expected, std::string_view found, std::size_t place);

} // namespace rastertrace
