// SPDX-License-Identifier: MIT
#pragma once

// The step that a claim is about, and what its fields say.

#include "check.h"
#include "claim_comparison.h"
#include "step_index.h"

#include <rastertrace/trace/tell/formulas_of.h>

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

/// The traces that claims are held against, each with its index.
class TruthIndex {
public:
    /// A trace in exact numbers, drawn again with many digits of sines and roots; nullptr if it has none.
    using DrawManyDigits = std::function<const Trace*(const Trace&)>;

    /// The trace of a scene that is drawn with a mistake; nullptr if it cannot be, or no hand works so many steps out.
    using DrawMistake = std::function<const Trace*(const Mistake&)>;

    /// No `exact`: the decided one is. `draw_faces` gives the trace that has every face tested, or nullptr.
    TruthIndex(const Trace& decided, const Trace* exact, std::function<const Trace*()> draw_faces,
               DrawManyDigits draw_many_digits, DrawMistake draw_mistake)
        : decided_(decided), draw_faces_(std::move(draw_faces)),
          draw_many_digits_(std::move(draw_many_digits)), draw_mistake_(std::move(draw_mistake)) {
        if (exact != nullptr)
            exact_.emplace(*exact);
    }

    const StepIndex& decided() const { return decided_; }
    const StepIndex& exact() const { return exact_ ? *exact_ : decided_; }

    /// The one that has the tests of all faces, toward the eye: the exact one, if it has any.
    const StepIndex& faces() const;

    /// The same steps with many digits of sines and roots; nullptr if there are none.
    const StepIndex* with_many_digits(const StepIndex& index) const;

    /// The scene drawn with a mistake; nullptr if it cannot be.
    const TruthIndex* drawn_with(const Mistake& mistake) const;

private:
    StepIndex decided_;
    std::optional<StepIndex> exact_;
    std::function<const Trace*()> draw_faces_;
    DrawManyDigits draw_many_digits_;
    DrawMistake draw_mistake_;
    mutable std::optional<StepIndex> faces_;
    mutable std::map<const StepIndex*, std::optional<StepIndex>> with_many_digits_;
    mutable std::map<const Mistake*, std::unique_ptr<TruthIndex>> with_mistakes_;
};

/// What a claim is about: a step, in the exact trace and in that of the scene's own method and scalar; or a
/// pixel of the final picture, which may have no step.
struct Subject {
    StepKind kind;
    const Claim* claim = nullptr;
    const StepIndex* exact = nullptr;
    const StepIndex* decided = nullptr;
    StepIndex::Keys keys = {};
    std::vector<const ClaimedField*> fields = {}; ///< those that are compared
    std::size_t step = 0;                         ///< of `exact`; 0: there is none
    std::size_t decided_step = 0;                 ///< of `decided`
    std::string absence = {};                     ///< why there is no such step
    bool is_off_canvas = false;                   ///< of a pixel
    bool is_left_out = false; ///< it may be one of those that the trace leaves out
    bool culls = true;        ///< of a face: the scene tests faces by itself

    /// True if step n tells what the claim is about. The place of a vertex may stand in its primitive alone.
    bool is_told_in(const StepIndex& index, std::size_t n) const {
        return n != 0 && index.trace().kind_of(n) == kind;
    }
};

/// Finds it. Throws a Problem that points at a name which the scene does not have, or at a claim that several
/// steps could be meant by.
Subject subject_of(const Claim& claim, const Claims& claims, const TruthIndex& truth);

/// The name that an edge has in the trace, of one that may be named from either end.
std::string edge_in(const StepIndex& index, const std::string& name);

/// True if a name is that of a face, and of no line that Bresenham's decisions are told of. Where there are no such
/// lines, a name that nothing has is taken for that of a face.
bool names_face(const std::string& name, const TruthIndex& truth);

/// The `decide` steps of the line that begins at a step, in order.
std::vector<std::size_t> decisions_from(const StepIndex& index, std::size_t first);

/// What is told of a field, as the trace writes it; of a list, or a list of lists, each element. Fields of
/// check.h are worked out. nullopt if nothing is.
using ToldValues = std::optional<std::vector<std::string>>;

/// In one step.
ToldValues told_in(const StepIndex& index, std::size_t step, const ClaimedField& field);

/// By exact arithmetic.
ToldValues told_exactly(const Subject& subject, const ClaimedField& field);

/// A list as textbooks write it in another form, with the name of the form; "" if only the order is another.
struct OtherForm {
    std::string name;
    std::vector<std::string> values;
};

/// Of a circle: d that begins with 3 - 2 r or 5/4 - r, which decides the same; the pixels of the octant where d is told,
/// from the center or on the canvas; and all pixels in the order in which they are claimed.
std::vector<OtherForm> other_forms(const Subject& subject, const ClaimedField& field);

/// The same subject where sines and roots have many digits; nothing if the scene has none, or no such step there.
std::optional<Subject> with_many_digits(const Subject& subject, const TruthIndex& truth);

/// A cosine or an intensity by its formula, with many digits; nothing of any other field.
ToldValues cosine_with_many_digits(const Subject& subject, const ClaimedField& field);

/// By the scene's own method and scalar.
ToldValues told_as_decided(const Subject& subject, const ClaimedField& field);

/// Which pixel a claim is about.
Pixel pixel_of(const Subject& subject);

/// What kind of numbers the exact trace tells.
NumbersHeld numbers_held(const Subject& subject);

/// The formulas that a field can be worked out by, see tell/formulas_of.h.
std::vector<Formula> formulas_of(const Subject& subject, const Numbers& numbers,
                                 std::string_view field);

/// Where the number stands that a field is about, see tell/numbers.h; a pixel's by where it lies.
std::string name_of_number(const Subject& subject, const ClaimedField& field);

/// The step that shows how a field is worked out; 0 for none.
std::size_t step_of(const Subject& subject, std::string_view field);

/// The field of that name; nullptr if the kind has none.
const StepField* field_of(StepKind kind, std::string_view name);

/// True if a field tells what was decided, and not a number that is worked out.
bool is_decision(StepKind kind, std::string_view field);

} // namespace rastertrace
