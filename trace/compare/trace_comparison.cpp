// SPDX-License-Identifier: MIT
#include "trace_comparison.h"

#include <rastertrace/trace/record/trace_lines.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

namespace rastertrace {

namespace {

/// How far ahead a step is looked for before it counts as one that the other trace does not have here.
constexpr std::size_t farthest_look = 16384;

/// So many bytes are taken at most by steps that have not been found in the other trace, but may be farther on.
constexpr std::size_t most_waiting = 24'000'000;

/// What comes of a line that has been read, with the place where it stands.
struct SeenLine {
    std::string_view line{};
    SeenStep step{};
    LinePlace place{};
};

/// Goes through whole lines as far as `use` wants and the steps go; returns the place behind them.
template <typename Use>
LinePlace go_through(const StepLines& lines, std::string_view text, const Use& use) {
    return lines.go_through(text, [&use](std::string_view line, LinePlace place) {
        return use(SeenLine{line, seen_in(line), place});
    });
}

/// Where lines stand in a text from an offset on: that of the first one. At most `most` bytes are read, which are taken
/// from it.
std::optional<std::size_t> find_lines(const std::string& lines, const TraceText& text,
                                      std::size_t from, std::size_t& most) {
    constexpr std::size_t block_size = 1 << 20;
    const std::string wanted = "\n" + lines;
    std::string block;
    while (most > 0) {
        const std::size_t kept = block.size();
        block.resize(kept + std::min(block_size, most));
        const std::size_t count = text.read(from + kept, std::span(block).subspan(kept));
        block.resize(kept + count);
        most -= count;
        if (const std::size_t found = block.find(wanted); found != std::string::npos)
            return from + found + 1;
        if (count == 0)
            return std::nullopt;
        const std::size_t gone = block.size() - std::min(block.size(), wanted.size());
        block.erase(0, gone);
        from += gone;
    }
    return std::nullopt;
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

/// The primitives that are left of a trace, which is drawn meanwhile.
std::vector<PrimitivePlace> primitives_from_here(DiffSide& side) {
    std::vector<PrimitivePlace> primitives;
    const auto begin = [&](const std::string_view step, LinePlace place) {
        if (!primitives.empty())
            primitives.back().end = place;
        primitives.push_back(primitive_place(std::string(step), place));
    };
    const auto add_content = [&primitives](std::string_view step) {
        if (!primitives.empty())
            primitives.back().content =
                primitives.back().content * 31 + std::hash<std::string_view>()(step);
    };
    while (const StepLine* const ahead = side.lines.front()) {
        if (ahead->kind == StepKind::primitive)
            begin(ahead->json, ahead->place);
        else
            add_content(ahead->json);
        side.pass(*ahead);
        for (bool goes_on = true; goes_on;) {
            const LinePlace behind =
                go_through(side.lines, side.lines.unread_lines(), [&](const SeenLine& seen) {
                    if (seen.step.what == SeenStep::What::primitive)
                        begin(step_of_line(seen.line), seen.place);
                    else
                        add_content(step_of_line(seen.line));
                    side.see(seen.step, seen.line, seen.place);
                    return true;
                });
            goes_on = behind.offset > side.lines.place().offset;
            side.lines.pass_lines(behind);
        }
    }
    if (!primitives.empty())
        primitives.back().end = side.lines.place();
    return primitives;
}

} // namespace

void DiffSide::see(const SeenStep& step, std::string_view line, LinePlace place) {
    if (picture)
        picture->see(step);
    tells_colors = tells_colors || step.color.has_value();
    if (step.what != SeenStep::What::primitive)
        return;
    primitives.push_back(place);
    begin = place;
    json = step_of_line(line);
}

void DiffSide::pass(const StepLine& line) {
    see(seen_in(line.json), line.json, line.place);
    lines.pass();
}

OwnerOfPixels DiffSide::primitive(std::uint32_t number) const {
    if (number == 0)
        return {};
    const auto owner_at = [this](std::size_t i) {
        const bool is_last = i + 1 == primitives.size();
        StepLines line(text, primitives[i], is_last ? nowhere : primitives[i + 1].offset);
        const StepLine* const step = line.front();
        return step == nullptr ? OwnerOfPixels{} : owner_in(step->json);
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

TraceComparison::TraceComparison(const TraceText& a, const TraceText& b, const DiffOptions& options,
                                 Renames names)
    : options_(options), names_(std::move(names)), had_names_(!names_.is_empty()),
      renames_front_(had_names_), compared_(a, b, options),
      has_primitives_(compared_.has_primitives()),
      fields_(options, (a.header().method_value("scalar") == "float" ? 1 : 0) +
                           (b.header().method_value("scalar") == "float" ? 1 : 0)),
      a_(a, true, {.keys = options.keys}), b_(b, false, reading_of_b()),
      tally_(options.compares_order), bytes_to_search_(a.size() + b.size()),
      remarks_(compared_.remarks()) {}

/// In front of the first primitive of b its names are those of a, as far as they are known.
StepReading TraceComparison::reading_of_b() const {
    StepReading reading{.keys = options_.keys};
    if (renames_front_)
        reading.rewrite = [this](std::string_view step) {
            return renames_front_ && !begins_primitive(step) ? names_.in_step(step, {})
                                                             : std::string(step);
        };
    return reading;
}

void TraceComparison::run() {
    if (!compare_in_order())
        compare_pairs();
    if (is_cut_off())
        remarks_.emplace_back("what follows the place where a trace breaks off was not compared");
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
        renames_front_ = false;
        if (had_names_ || a == nullptr || b == nullptr || !begin_same_primitive(a->json, b->json)) {
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
        if (!renames_front_ && !renames_section_)
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
        if (is_compared_ && compared_.has(*step))
            return step;
        side.pass(*step);
    }
    return nullptr;
}

/// The i-th step ahead, if it is of this primitive.
const StepLine* TraceComparison::ahead(DiffSide& side, std::size_t i) const {
    const StepLine* const step = side.lines.at(i);
    return step == nullptr || begins_section(*step) ? nullptr : step;
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
        if (of_a != nullptr && compared_.has(*of_a))
            places_a.emplace(of_a->key, i);
        if (of_b != nullptr && compared_.has(*of_b))
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
    const auto end = find_lines(next, side.text, last_seen->place.offset, bytes_to_search_);
    if (!end)
        return false;
    while (const StepLine* const step = ahead(side, 0)) {
        if (step->place.offset >= *end)
            break;
        const StepLine one = *step;
        side.pass(one);
        if (compared_.has(one) && !finds_elsewhere(side, one))
            tell_alone(side.is_a, gap_, one);
    }
    return true;
}

/// Takes steps out of one trace, as far as this primitive goes, and looks for them among those of the other that wait.
void TraceComparison::put_aside(DiffSide& side, std::size_t steps) {
    WaitingSteps& own = side.is_a ? waiting_a_ : waiting_b_;
    for (; steps > 0 && ahead(side, 0) != nullptr; --steps) {
        StepLine step = *ahead(side, 0);
        side.pass(step);
        if (compared_.has(step) && !finds_elsewhere(side, step))
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

/// A step that the other trace does not have.
void TraceComparison::tell_alone(bool is_in_a, std::size_t gap, const StepLine& step) {
    if (is_in_a)
        tally_.add_only_a(gap, step);
    else
        tally_.add_only_b(gap, step);
}

/// What waits has no equal. If a trace breaks off, what waits in the last gap might have had one behind that.
void TraceComparison::give_up_waiting(bool breaks_off) {
    const auto is_told = [&](const WaitingSteps::Step& one) {
        return !breaks_off || one.gap != gap_;
    };
    waiting_a_.take_all([&](const WaitingSteps::Step& one) {
        if (is_told(one))
            tell_alone(true, one.gap, one.line);
    });
    waiting_b_.take_all([&](const WaitingSteps::Step& one) {
        if (is_told(one))
            tell_alone(false, one.gap, one.line);
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
    const LinePlace behind = go_through(a.lines, text, [&](const SeenLine& seen) {
        const bool is_primitive = seen.step.what == SeenStep::What::primitive && has_primitives_;
        if (is_primitive && waits)
            return false;
        a.see(seen.step, seen.line, seen.place);
        b.see(seen.step, seen.line, in_b(seen.place));
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

// Where the primitives are not the same in the same order, those that are the same are looked for.

void TraceComparison::compare_pairs() {
    const std::vector<PrimitivePlace> of_a = primitives_from_here(a_);
    const std::vector<PrimitivePlace> of_b = primitives_from_here(b_);
    const std::vector<std::size_t> in_b = pair_primitives(of_a, of_b);
    const std::vector<bool> stays = in_common_order(in_b);
    std::vector<std::size_t> in_a(of_b.size(), nowhere);
    for (std::size_t i = 0; i < in_b.size(); ++i) {
        const bool is_there = in_b[i] != nowhere;
        if (is_there)
            in_a[in_b[i]] = i;
        partner_.push_back(is_there ? common_primitives_ + static_cast<std::uint32_t>(in_b[i]) + 1
                                    : 0);
    }
    const bool is_one_order = std::find(stays.begin(), stays.end(), false) == stays.end() &&
                              std::find(in_a.begin(), in_a.end(), nowhere) == in_a.end();
    if (!is_one_order && compared_.tells_all_primitives())
        remarks_.emplace_back("the primitives are not the same in the same order: from there on "
                              "the traces were read twice");
    if (!options_.compares_names)
        find_names(of_a, of_b, in_b);

    // Both lists together: what only one has, what has moved, and what is in the same order in both.
    const auto is_broken = [&](std::size_t in_list_a, std::size_t in_list_b) {
        return (in_list_a + 1 == of_a.size() && a_.lines.is_cut_off()) ||
               (in_list_b + 1 == of_b.size() && b_.lines.is_cut_off());
    };
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < of_a.size() || j < of_b.size()) {
        ++gap_;
        if (i < of_a.size() && in_b[i] == nowhere) {
            if (!b_.lines.is_cut_off())
                add_primitive(a_.text, of_a[i], true);
            ++i;
        } else if (j < of_b.size() && in_a[j] == nowhere) {
            if (!a_.lines.is_cut_off())
                add_primitive(b_.text, of_b[j], false);
            ++j;
        } else if (i < of_a.size() && !stays[i]) {
            compare_primitives(of_a[i], of_b[in_b[i]], true, is_broken(i, in_b[i]));
            ++i;
        } else if (j < of_b.size() && !stays[in_a[j]]) {
            ++j; // it has moved: it is compared where a has it
        } else {
            compare_primitives(of_a[i], of_b[j], false, is_broken(i, j));
            ++i;
            ++j;
        }
    }
}

/// Finds what is named otherwise in b.
void TraceComparison::find_names(const std::vector<PrimitivePlace>& of_a,
                                 const std::vector<PrimitivePlace>& of_b,
                                 const std::vector<std::size_t>& in_b) {
    std::size_t renamed = 0;
    for (std::size_t i = 0; i < of_a.size(); ++i) {
        if (in_b[i] == nowhere || !is_renamed(of_a[i], of_b[in_b[i]]))
            continue;
        names_.add(primitive_step(a_.text, of_a[i]), primitive_step(b_.text, of_b[in_b[i]]));
        ++renamed;
    }
    if (renamed == 0)
        return;
    remarks_.push_back(renamed == 1 ? "1 primitive is renamed"
                                    : fmt::format("{} primitives are renamed", renamed));
    const auto has_front = [](const DiffSide& side) {
        return !side.primitives.empty() && side.primitives.front().steps > 0;
    };
    needs_names_in_front_ = !had_names_ && (has_front(a_) || has_front(b_));
}

/// The step that begins a primitive.
std::string TraceComparison::primitive_step(const TraceText& text,
                                            const PrimitivePlace& primitive) const {
    StepLines lines(text, primitive.begin, primitive.end.offset);
    const StepLine* const step = lines.front();
    return step == nullptr ? "" : step->json;
}

/// A primitive that only one trace has, with all its steps.
void TraceComparison::add_primitive(const TraceText& text, const PrimitivePlace& primitive,
                                    bool is_in_a) {
    if (!compared_.has_primitive(primitive.name))
        return;
    StepLines lines(text, primitive.begin, primitive.end.offset);
    DiffSection section;
    if (const StepLine* const first = lines.front())
        (is_in_a ? section.json_a : section.json_b) = first->json;
    (is_in_a ? section.begin_a : section.begin_b) = primitive.begin;
    tally_.begin_section(std::move(section));
    while (const StepLine* const step = lines.front()) {
        if (compared_.has(*step) && is_in_a)
            tally_.add_only_a(gap_, *step);
        else if (compared_.has(*step))
            tally_.add_only_b(gap_, *step);
        lines.pass();
    }
}

/// A primitive that both traces have, perhaps at another place.
void TraceComparison::compare_primitives(const PrimitivePlace& of_a, const PrimitivePlace& of_b,
                                         bool has_moved, bool breaks_off) {
    Renames names;
    renames_section_ = !options_.compares_names && !names_.is_empty();
    StepReading reading_b{.keys = options_.keys};
    if (renames_section_) {
        names.add(primitive_step(a_.text, of_a), primitive_step(b_.text, of_b));
        reading_b.rewrite = [&](std::string_view step) { return names.in_step(step, names_); };
    }
    DiffSide a(a_.text, true, of_a, {.keys = options_.keys});
    DiffSide b(b_.text, false, of_b, std::move(reading_b));
    const StepLine* const step_a = a.lines.front();
    const StepLine* const step_b = b.lines.front();
    if (step_a == nullptr || step_b == nullptr)
        return;
    a_.json = step_a->json;
    b_.json = step_b->json;
    a_.begin = of_a.begin;
    b_.begin = of_b.begin;
    if (has_moved && compared_.has(*step_a)) {
        begin_section();
        tally_.add_moved(gap_, *step_a, *step_b);
    }
    a.breaks_off = b.breaks_off = breaks_off;
    begin_primitive(a, b);
    compare_section(a, b);
}

} // namespace rastertrace
