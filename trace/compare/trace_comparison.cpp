// SPDX-License-Identifier: MIT
#include "trace_comparison.h"

#include <rastertrace/trace/record/trace_lines.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <unordered_map>

namespace rastertrace {

namespace {

/// How far ahead a step is looked for before it counts as one that the other trace does not have here.
constexpr std::size_t farthest_look = 16384;

/// So many bytes are taken at most by steps that have not been found in the other trace, but may be farther on.
constexpr std::size_t most_waiting = 24'000'000;

/// The primitives that a trace tells in parts.
std::set<std::string> cut_in(const TraceText& text) {
    std::set<std::string> cut;
    const auto& stages = text.header().stages;
    const bool may_clip = text.header_json().find("\"stages\"") == std::string::npos ||
                          std::find(stages.begin(), stages.end(), "clip") != stages.end();
    if (may_clip)
        StepLines(text).pass_all_lines([&cut](std::string_view line, LinePlace) {
            if (seen_in(line).what != SeenStep::What::primitive)
                return;
            const auto step = StepView(step_of_line(line)).as<PrimitiveStep>();
            if (step.part.is_true())
                cut.insert(name_of_whole(step));
        });
    return cut;
}

/// Finds the primitives that one side tells in parts, and the other draws whole.
void find_wholes(DiffSide& side, const std::set<std::string>& cut, const DiffSide& other,
                 const std::set<std::string>& cut_in_other) {
    std::string name;
    StepLines(other.text).pass_all_lines([&](std::string_view line, LinePlace) {
        const SeenStep seen = seen_in(line);
        const StepView step(step_of_line(line));
        if (seen.what == SeenStep::What::primitive)
            name = name_in(step).text();
        if (!cut.contains(name) || cut_in_other.contains(name))
            return;
        // Clipped there, too, and not drawn, it has lost its parts.
        if (step.kind() == StepKind::clip)
            side.whole_in_other.erase(name);
        else if (seen.what != SeenStep::What::other)
            side.whole_in_other.insert(name);
    });
}

/// True if what follows the last step of a side is not known.
bool breaks_off(const DiffSide& side) {
    return side.breaks_off || side.lines.is_cut_off();
}

/// The bytes that two texts have in common at their front.
std::size_t common_front(std::string_view a, std::string_view b) {
    const std::size_t size = std::min(a.size(), b.size());
    if (size == 0 || std::memcmp(a.data(), b.data(), size) == 0)
        return size;
    const auto end = a.begin() + static_cast<std::ptrdiff_t>(size);
    return static_cast<std::size_t>(std::mismatch(a.begin(), end, b.begin()).first - a.begin());
}

} // namespace

bool DiffSide::tells_part(std::string_view line) const {
    if (whole_in_other.empty())
        return false;
    const StepView step(step_of_line(line));
    if (step.kind() == StepKind::vertex) {
        const std::string name = name_in(step).text();
        const std::size_t colon = name.rfind(':');
        return colon != std::string::npos && whole_in_other.contains(name.substr(0, colon));
    }
    return step.kind() == StepKind::primitive && step.as<PrimitiveStep>().part.is_true() &&
           whole_in_other.contains(name_of_whole(step.as<PrimitiveStep>()));
}

void DiffSide::see(const SeenStep& step, std::string_view line, LinePlace place) {
    const bool is_primitive = step.what == SeenStep::What::primitive;
    const bool is_part = is_primitive && tells_part(line);
    if (picture)
        picture->see(step, is_part);
    tells_colors = tells_colors || step.color.has_value();
    if (!is_primitive || is_part)
        return;
    primitives.push_back(place);
    begin = place;
    json = step_of_line(line);
}

void DiffSide::pass(const StepLine& line) {
    see(seen_in(line.json), line.json, line.place);
    lines.pass();
}

std::string DiffSide::step_at(LinePlace place, std::size_t end) const {
    StepLines from(text, place, end);
    const StepLine* const step = from.front();
    return step == nullptr ? "" : step->json;
}

OwnerOfPixels DiffSide::primitive(std::uint32_t number) const {
    if (number == 0)
        return {};
    const auto owner_at = [this](std::size_t i) {
        const bool is_last = i + 1 == primitives.size();
        return owner_in(step_at(primitives[i], is_last ? nowhere : primitives[i + 1].offset));
    };
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

TraceComparison::TraceComparison(const TraceText& a, const TraceText& b, const DiffOptions& options)
    : options_(options), compared_(a, b, options), has_primitives_(compared_.has_primitives()),
      fields_(options, (a.header().method_value("scalar") == "float" ? 1 : 0) +
                           (b.header().method_value("scalar") == "float" ? 1 : 0)),
      a_(a, true, options.keys), b_(b, false, options.keys), tally_(options.compares_order),
      bytes_to_search_(a.size() + b.size()), remarks_(compared_.remarks()) {
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
        remarks_.push_back(said({"what follows the place where a trace breaks off was not compared",
                                 "o que vem depois do ponto em que um rastro se interrompe não foi "
                                 "comparado"}));
}

std::vector<Problem> TraceComparison::damage() const {
    std::vector<Problem> damage;
    for (const DiffSide* const side : {&a_, &b_}) {
        if (!side->lines.is_cut_off())
            continue;
        const LinePlace end = side->lines.place();
        damage.push_back(problem_of(side->text.name(), truncation_after(end.steps)));
        if (side->text.has_lines()) {
            damage.back().line = end.lines + 2;
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
        scope.reach.emplace(*first);
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
        if (is_cut_off())
            return true;
        const StepLine* const a = a_.lines.front();
        const StepLine* const b = b_.lines.front();
        if (a == nullptr && b == nullptr)
            return true;
        if (a == nullptr || b == nullptr || !begin_same_primitive(a->json, b->json)) {
            common_primitives_ = static_cast<std::uint32_t>(a_.primitives.size());
            return false;
        }
        begin_primitive(a_, b_);
    }
}

/// Goes past the steps that begin a primitive in both traces, and compares them.
void TraceComparison::begin_primitive(DiffSide& a, DiffSide& b) {
    const StepLine of_a = *a.lines.front();
    const StepLine of_b = *b.lines.front();
    a.pass(of_a);
    b.pass(of_b);
    begin_section();
    compare(of_a, of_b);
}

void TraceComparison::begin_section() {
    tally_.begin_section(
        {.json_a = a_.json, .json_b = b_.json, .begin_a = a_.begin, .begin_b = b_.begin});
    is_compared_ = compared_.has_primitive(name_in(StepView(a_.json)).text());
}

void TraceComparison::compare(const StepLine& a, const StepLine& b) {
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
        pass_equal_lines(a, b);
        const StepLine* const of_a = next_compared(a);
        const StepLine* const of_b = next_compared(b);
        if (of_a == nullptr && of_b == nullptr)
            break;
        if ((of_a == nullptr && breaks_off(a)) || (of_b == nullptr && breaks_off(b))) {
            give_up_waiting(true);
            break;
        }
        if (of_a == nullptr || of_b == nullptr) {
            begin_gap(a, b);
            put_aside(of_a != nullptr ? a : b, 1);
        } else if (of_a->key == of_b->key) {
            compare(*of_a, *of_b);
            a.pass(*of_a);
            b.pass(*of_b);
        } else {
            realign(a, b);
        }
        if (waiting_a_.bytes() + waiting_b_.bytes() > most_waiting)
            give_up_waiting();
    }
    give_up_waiting();
}

/// The next step of this primitive that is compared; those before are passed.
const StepLine* TraceComparison::next_compared(DiffSide& side) {
    while (const StepLine* const step = ahead(side, 0)) {
        if (is_compared_ && has(side, *step))
            return step;
        side.pass(*step);
    }
    return nullptr;
}

/// The i-th step ahead, if it is of this primitive.
const StepLine* TraceComparison::ahead(DiffSide& side, std::size_t i) const {
    const StepLine* const step = side.lines.at(i);
    return step == nullptr || begins_section(side, *step) ? nullptr : step;
}

/// The next steps are not alike.
void TraceComparison::begin_gap(const DiffSide& a, const DiffSide& b) {
    ++gap_;
    const auto here = [](const DiffSide& side) {
        const StepLine* const step = side.lines.ahead();
        return step == nullptr ? side.lines.place() : step->place;
    };
    if (!first_gap_)
        first_gap_ = DiffGap{gap_, here(a), here(b)};
}

/// Puts as few steps aside as it takes to have the same step next in both traces.
void TraceComparison::realign(DiffSide& a, DiffSide& b) {
    begin_gap(a, b);
    std::unordered_map<std::string_view, std::size_t> places_a;
    std::unordered_map<std::string_view, std::size_t> places_b;
    for (std::size_t i = 0; i < farthest_look; ++i) {
        const StepLine* const of_a = ahead(a, i);
        const StepLine* const of_b = ahead(b, i);
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

/// Passes the steps that one side has in front of what comes next in the other, if that stands there byte for byte.
bool TraceComparison::pass_gap(DiffSide& side, DiffSide& other) {
    constexpr std::size_t lines_alike = 16;
    const StepLine* const first = ahead(other, 0);
    const StepLine* const behind = ahead(other, lines_alike);
    const StepLine* const last_seen = ahead(side, farthest_look - 1);
    if (first == nullptr || behind == nullptr || last_seen == nullptr)
        return false;
    std::string next(behind->place.offset - first->place.offset, '\0');
    next.resize(other.text.read(first->place.offset, next));
    const auto end = side.text.find("\n" + next, last_seen->place.offset, bytes_to_search_);
    if (!end)
        return false;
    while (const StepLine* const step = ahead(side, 0)) {
        if (step->place.offset > *end)
            break;
        const StepLine one = *step;
        side.pass(one);
        if (has(side, one) && !finds_elsewhere(side, one))
            tally_.add_alone(gap_, side.is_a, one);
    }
    return true;
}

/// Takes steps out of one trace, as far as this primitive goes, and looks for them among those of the other that wait.
void TraceComparison::put_aside(DiffSide& side, std::size_t steps) {
    WaitingSteps& own = side.is_a ? waiting_a_ : waiting_b_;
    for (; steps > 0 && ahead(side, 0) != nullptr; --steps) {
        StepLine step = *ahead(side, 0);
        side.pass(step);
        if (has(side, step) && !finds_elsewhere(side, step))
            own.add(std::move(step), gap_);
    }
}

/// True if a step of one side waits in the other trace: it stands elsewhere there.
bool TraceComparison::finds_elsewhere(const DiffSide& side, const StepLine& step) {
    WaitingSteps::Step other;
    if (!(side.is_a ? waiting_b_ : waiting_a_).take(step.key, other))
        return false;
    const StepLine& a = side.is_a ? step : other.line;
    const StepLine& b = side.is_a ? other.line : step;
    tally_.add_moved(other.gap, a, b);
    auto fields = fields_.differing(a, b);
    if (!fields.empty())
        tally_.add_changed(other.gap, a, b, std::move(fields));
    return true;
}

/// What waits has no equal. If a trace breaks off, what waits in the last gap might have had one behind that.
void TraceComparison::give_up_waiting(bool breaks_off) {
    for (WaitingSteps* const waiting : {&waiting_a_, &waiting_b_})
        waiting->take_all([&](const WaitingSteps::Step& one) {
            if (!breaks_off || one.gap != gap_)
                tally_.add_alone(one.gap, waiting == &waiting_a_, one.line);
        });
}

/// Passes lines that are the same in both texts, without a look at what they say, but for the pictures.
void TraceComparison::pass_equal_lines(DiffSide& a, DiffSide& b) {
    for (;;) {
        const std::string_view in_a = a.lines.unread_lines();
        const std::size_t same = common_front(in_a, b.lines.unread_lines());
        const std::size_t passed = pass_lines(a, b, in_a.substr(0, same));
        if (passed == 0 || passed < same)
            return;
    }
}

/// Passes whole lines that are the same in both, to the next primitive if steps wait to be found. Returns how many
/// bytes they have.
std::size_t TraceComparison::pass_lines(DiffSide& a, DiffSide& b, std::string_view text) {
    const bool waits = !waiting_a_.is_empty() || !waiting_b_.is_empty();
    const LinePlace from_a = a.lines.place();
    const LinePlace from_b = b.lines.place();
    const auto in_b = [&](LinePlace in_a) {
        return LinePlace{in_a.offset - from_a.offset + from_b.offset,
                         in_a.steps - from_a.steps + from_b.steps,
                         in_a.lines - from_a.lines + from_b.lines};
    };
    const LinePlace behind = a.lines.go_through(text, [&](std::string_view line, LinePlace place) {
        const SeenStep step = seen_in(line);
        const bool is_primitive = step.what == SeenStep::What::primitive && has_primitives_;
        if (is_primitive && waits)
            return false;
        a.see(step, line, place);
        b.see(step, line, in_b(place));
        if (is_primitive)
            begin_section();
        return true;
    });
    const std::size_t bytes = behind.offset - from_a.offset;
    if (bytes > 0)
        ++gap_;
    b.lines.pass_lines(in_b(behind));
    a.lines.pass_lines(behind);
    return bytes;
}

} // namespace rastertrace
