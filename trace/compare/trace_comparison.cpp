// SPDX-License-Identifier: MIT
#include "trace_comparison.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/record/visit_step.h>
#include <rastertrace/trace/tell/step_text.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <unordered_map>

namespace rastertrace {

namespace {

/// How far ahead a step is looked for before it counts as one that the other trace does not have here.
constexpr std::size_t farthest_look = 16384;

/// The primitives that a trace tells in parts.
std::set<std::string> cut_in(const Trace& trace) {
    std::set<std::string> cut;
    for (const std::size_t n : trace.steps_of({StepKind::primitive}))
        if (const auto step = trace.step(n).as<PrimitiveStep>(); step.part.is_true())
            cut.insert(name_of_whole(step));
    return cut;
}

/// "" for 0.
std::string name_of_primitive(const Trace& trace, std::size_t n) {
    return n == 0 ? "" : name_in(trace.step(n)).text();
}

/// Finds the primitives that one side tells in parts, and the other draws whole.
void find_wholes(DiffSide& side, const std::set<std::string>& cut, const DiffSide& other,
                 const std::set<std::string>& cut_in_other) {
    std::string name;
    const Trace& trace = other.trace;
    for (const std::size_t n :
         trace.steps_of({StepKind::primitive, StepKind::clip, StepKind::pixel})) {
        const auto kind = trace.kind_of(n);
        if (kind == StepKind::primitive)
            name = name_in(trace.step(n)).text();
        if (!cut.contains(name) || cut_in_other.contains(name))
            continue;
        // Clipped there, too, and not drawn, it has lost its parts.
        if (kind == StepKind::clip)
            side.whole_in_other.erase(name);
        else
            side.whole_in_other.insert(name);
    }
}

} // namespace

bool DiffSide::tells_part(std::size_t n) const {
    if (whole_in_other.empty())
        return false;
    const auto kind = trace.kind_of(n);
    const StepView step = trace.step(n);
    if (kind == StepKind::vertex) {
        const std::string name = name_in(step).text();
        const std::size_t colon = name.rfind(':');
        return colon != std::string::npos && whole_in_other.contains(name.substr(0, colon));
    }
    return kind == StepKind::primitive && step.as<PrimitiveStep>().part.is_true() &&
           whole_in_other.contains(name_of_whole(step.as<PrimitiveStep>()));
}

void DiffSide::pass() {
    const std::size_t n = steps.next();
    steps.pass();
    const SeenStep step = seen_in(trace, n);
    const bool is_primitive = step.what == SeenStep::What::primitive;
    const bool is_part = is_primitive && tells_part(n);
    if (picture)
        picture->see(step, is_part);
    tells_colors = tells_colors || step.color.has_value();
    if (!is_primitive || is_part)
        return;
    primitives.push_back(n);
    primitive_step = n;
}

OwnerOfPixels DiffSide::primitive(std::uint32_t number) const {
    if (number == 0)
        return {};
    const auto owner_at = [this](std::size_t i) { return owner_in(trace, primitives[i]); };
    OwnerOfPixels owner = owner_at(number - 1);
    // What is cut is told in front of its parts, with the vertices that it has in the scene.
    if (owner.face != owner.name)
        for (std::size_t i = number - 1; i > 0; --i) {
            const OwnerOfPixels before = owner_at(i - 1);
            if (before.face != owner.face)
                break;
            owner.vertices = before.vertices;
        }
    return owner;
}

TraceComparison::TraceComparison(const Trace& a, const Trace& b, const DiffOptions& options)
    : options_(options), compared_(a, b, options), has_primitives_(compared_.has_primitives()),
      fields_(options, int{a.method.has_floats()} + int{b.method.has_floats()}),
      a_(a, true, options.keys), b_(b, false, options.keys), tally_(options.compares_order),
      steps_to_search_(a.size() + b.size()), remarks_(compared_.remarks()) {
    if (!has_primitives_)
        return;
    const std::set<std::string> cut_in_a = cut_in(a);
    const std::set<std::string> cut_in_b = cut_in(b);
    if (cut_in_a == cut_in_b)
        return;
    find_wholes(a_, cut_in_a, b_, cut_in_b);
    find_wholes(b_, cut_in_b, a_, cut_in_a);
}

void TraceComparison::run() {
    if (!compare_in_order())
        compare_pairs();
    if (is_cut_off())
        remarks_.push_back(
            said("what follows the place where a trace breaks off was not compared"));
}

std::vector<Problem> TraceComparison::damage() const {
    std::vector<Problem> damage;
    for (const Trace* const trace : {&a_.trace, &b_.trace}) {
        if (!trace->cut_short)
            continue;
        damage.push_back(problem_of(trace->source().name, trace->cut_short->message));
        if (trace->source().is_read) {
            damage.back().line = trace->cut_short->line;
            damage.back().column = 1;
        }
    }
    return damage;
}

std::optional<std::pair<PictureDifference, Consequences>> TraceComparison::picture() const {
    if (!compared_.has_pictures() || is_cut_off())
        return std::nullopt;
    const PictureOwners owners{.b_of_a = [this](std::uint32_t of_a) { return b_of_a(of_a); },
                               .in_a = [this](std::uint32_t owner) { return a_.primitive(owner); },
                               .in_b = [this](std::uint32_t owner) { return b_.primitive(owner); }};
    // What a foreign rasterizer does not tell is no difference, if so asked.
    const bool tell_colors = !options_.compares_common || (a_.tells_colors && b_.tells_colors);
    PictureScope scope{.region = compared_.region(),
                       .has_owners = has_primitives_,
                       .has_colors = has_primitives_ && tell_colors};
    if (const auto& first = tally_.first())
        scope.reach.emplace(*first, a_.trace, b_.trace);
    return difference_between(*a_.picture, *b_.picture, owners, scope);
}

std::uint32_t TraceComparison::b_of_a(std::uint32_t of_a) const {
    if (of_a <= common_primitives_ || partner_.empty())
        return of_a;
    return partner_[of_a - common_primitives_ - 1];
}

// One primitive after the other, as long as both traces have the same ones.

/// False if the primitives come in another order from some place on.
bool TraceComparison::compare_in_order() {
    begin_section();
    for (;;) {
        compare_section(a_, b_);
        if ((a_.steps.is_behind() && a_.breaks_off) || (b_.steps.is_behind() && b_.breaks_off))
            return true;
        const bool has_a = !a_.steps.is_behind();
        const bool has_b = !b_.steps.is_behind();
        if (!has_a && !has_b)
            return true;
        if (!has_a || !has_b ||
            !begin_same_primitive(a_.trace.step(a_.steps.next()).as<PrimitiveStep>(),
                                  b_.trace.step(b_.steps.next()).as<PrimitiveStep>())) {
            common_primitives_ = static_cast<std::uint32_t>(a_.primitives.size());
            return false;
        }
        begin_primitive(a_, b_);
    }
}

/// Goes past the steps that begin a primitive in both traces, and compares them.
void TraceComparison::begin_primitive(DiffSide& a, DiffSide& b) {
    const KeyedStep of_a = *a.steps.front();
    const KeyedStep of_b = *b.steps.front();
    a.pass();
    b.pass();
    begin_section();
    compare(of_a, of_b);
}

void TraceComparison::begin_section() {
    tally_.begin_section({.a = a_.primitive_step, .b = b_.primitive_step});
    is_compared_ = compared_.has_primitive(name_of_primitive(a_.trace, a_.primitive_step));
}

void TraceComparison::compare(const KeyedStep& a, const KeyedStep& b) {
    ++gap_;
    if (!compared_.has(a) || !is_compared_)
        return;
    auto fields = fields_.differing(a, b);
    if (!fields.empty())
        tally_.add_changed(gap_, a, b, std::move(fields));
}

/// Compares the steps up to the next primitive.
void TraceComparison::compare_section(DiffSide& a, DiffSide& b) {
    for (;;) {
        pass_equal_steps(a, b);
        const KeyedStep* const of_a = next_compared(a);
        const KeyedStep* const of_b = next_compared(b);
        if (of_a == nullptr && of_b == nullptr)
            break;
        const auto is_broken = [](const KeyedStep* next, const DiffSide& side) {
            return next == nullptr && side.breaks_off && side.steps.is_behind();
        };
        if (is_broken(of_a, a) || is_broken(of_b, b)) {
            give_up_waiting(true);
            break;
        }
        if (of_a == nullptr || of_b == nullptr) {
            begin_gap(a, b);
            put_aside(of_a != nullptr ? a : b, 1);
        } else if (of_a->key == of_b->key) {
            compare(*of_a, *of_b);
            a.pass();
            b.pass();
        } else {
            realign(a, b);
        }
    }
    give_up_waiting();
}

/// The next step of this primitive that is compared; those before are passed.
const KeyedStep* TraceComparison::next_compared(DiffSide& side) {
    while (const KeyedStep* const step = ahead(side, 0)) {
        if (is_compared_ && has(side, *step))
            return step;
        side.pass();
    }
    return nullptr;
}

/// The i-th step ahead, if it is of this primitive.
const KeyedStep* TraceComparison::ahead(DiffSide& side, std::size_t i) const {
    const KeyedStep* const step = side.steps.at(i);
    return step == nullptr || begins_section(side, step->number) ? nullptr : step;
}

/// The next steps are not alike.
void TraceComparison::begin_gap(const DiffSide& a, const DiffSide& b) {
    ++gap_;
    if (!first_gap_)
        first_gap_ = DiffGap{gap_, a.steps.next(), b.steps.next()};
}

/// Puts as few steps aside as it takes to have the same step next in both traces.
void TraceComparison::realign(DiffSide& a, DiffSide& b) {
    begin_gap(a, b);
    std::unordered_map<std::string_view, std::size_t> places_a;
    std::unordered_map<std::string_view, std::size_t> places_b;
    for (std::size_t i = 0; i < farthest_look; ++i) {
        const KeyedStep* const of_a = ahead(a, i);
        const KeyedStep* const of_b = ahead(b, i);
        if (of_a != nullptr && has(a, *of_a))
            places_a.emplace(of_a->key, i);
        if (of_b != nullptr && has(b, *of_b))
            places_b.emplace(of_b->key, i);

        // The nearest place of each of the two in the other trace.
        const auto in_b = of_a == nullptr ? places_b.end() : places_b.find(of_a->key);
        const auto in_a = of_b == nullptr ? places_a.end() : places_a.find(of_b->key);
        const bool is_in_b = in_b != places_b.end();
        const bool is_in_a = in_a != places_a.end();
        if (!is_in_a && !is_in_b)
            continue;
        // Of two that are as near the smaller key: it does not matter which trace is named first.
        const bool takes_a = is_in_b && (!is_in_a || in_b->second < in_a->second ||
                                         (in_b->second == in_a->second && of_a->key < of_b->key));
        const std::size_t steps_a = takes_a ? i : in_a->second;
        const std::size_t steps_b = takes_a ? in_b->second : i;
        put_aside(a, steps_a);
        put_aside(b, steps_b);
        return;
    }
    if (pass_gap(a, b) || pass_gap(b, a))
        return;
    put_aside(a, farthest_look);
    put_aside(b, farthest_look);
}

/// Passes the steps that one side has in front of what comes next in the other, if that stands there just so.
bool TraceComparison::pass_gap(DiffSide& side, DiffSide& other) {
    constexpr std::size_t steps_alike = 16;
    if (ahead(other, steps_alike) == nullptr || ahead(side, farthest_look - 1) == nullptr)
        return false;
    const auto goes_on_at = [&](std::size_t n) {
        for (std::size_t i = 0; i < steps_alike; ++i)
            if (!are_same(side.trace.step(n + i), other.trace.step(other.steps.next() + i)))
                return false;
        return true;
    };
    std::size_t end = side.steps.next() + farthest_look;
    for (;; ++end) {
        if (end + steps_alike > side.trace.size() + 1 || steps_to_search_ == 0)
            return false;
        --steps_to_search_;
        if (goes_on_at(end))
            break;
    }
    while (side.steps.next() < end && ahead(side, 0) != nullptr) {
        const KeyedStep one = *ahead(side, 0);
        side.pass();
        if (has(side, one) && !finds_elsewhere(side, one))
            tally_.add_alone(gap_, side.is_a, one);
    }
    return true;
}

/// Takes steps out of one trace, as far as this primitive goes, and looks for them among those of the other that wait.
void TraceComparison::put_aside(DiffSide& side, std::size_t steps) {
    WaitingSteps& own = side.is_a ? waiting_a_ : waiting_b_;
    for (; steps > 0 && ahead(side, 0) != nullptr; --steps) {
        KeyedStep step = *ahead(side, 0);
        side.pass();
        if (has(side, step) && !finds_elsewhere(side, step))
            own.add(std::move(step), gap_);
    }
}

/// True if a step of one side waits in the other trace: it stands elsewhere there.
bool TraceComparison::finds_elsewhere(const DiffSide& side, const KeyedStep& step) {
    const auto other = (side.is_a ? waiting_b_ : waiting_a_).take(step.key);
    if (!other)
        return false;
    const KeyedStep& a = side.is_a ? step : other->step;
    const KeyedStep& b = side.is_a ? other->step : step;
    tally_.add_moved(other->gap, a, b);
    auto fields = fields_.differing(a, b);
    if (!fields.empty())
        tally_.add_changed(other->gap, a, b, std::move(fields));
    return true;
}

/// What waits has no equal. If a trace breaks off, what waits in the last gap might have had one behind that.
void TraceComparison::give_up_waiting(bool breaks_off) {
    for (WaitingSteps* const waiting : {&waiting_a_, &waiting_b_})
        waiting->take_all([&](const WaitingSteps::Step& one) {
            if (!breaks_off || one.gap != gap_)
                tally_.add_alone(one.gap, waiting == &waiting_a_, one.step);
        });
}

/// Passes steps that are the same in both traces, to the next primitive if steps wait to be found.
void TraceComparison::pass_equal_steps(DiffSide& a, DiffSide& b) {
    const bool waits = !waiting_a_.is_empty() || !waiting_b_.is_empty();
    bool has_passed = false;
    while (!a.steps.is_behind() && !b.steps.is_behind() &&
           are_same(a.trace.step(a.steps.next()), b.trace.step(b.steps.next()))) {
        const bool is_primitive =
            has_primitives_ && a.trace.kind_of(a.steps.next()) == StepKind::primitive;
        if (is_primitive && waits)
            break;
        a.pass();
        b.pass();
        has_passed = true;
        if (is_primitive)
            begin_section();
    }
    gap_ += has_passed ? 1 : 0;
}

} // namespace rastertrace
