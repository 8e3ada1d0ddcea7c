// SPDX-License-Identifier: MIT
#include "claim_subject.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace rastertrace {

const StepField* field_of(StepKind kind, std::string_view name) {
    const auto& fields = fields_of(kind);
    const auto found = std::find_if(fields.begin(), fields.end(),
                                    [&](const StepField& field) { return field.name == name; });
    return found == fields.end() ? nullptr : &*found;
}

const StepIndex& TruthIndex::faces() const {
    const auto& tested = exact().find(StepKind::face, {});
    const auto& by_light = exact().find(StepKind::face, {{"by", "light"}});
    if (!tested.empty() && by_light.empty())
        return exact();
    if (!faces_)
        if (const Trace* const drawn = draw_faces_())
            faces_.emplace(*drawn);
    return faces_ ? *faces_ : exact();
}

const StepIndex* TruthIndex::with_many_digits(const StepIndex& index) const {
    const auto [place, is_new] = with_many_digits_.try_emplace(&index);
    if (is_new)
        if (const Trace* const drawn = draw_many_digits_(index.trace()))
            place->second.emplace(*drawn);
    return place->second ? &*place->second : nullptr;
}

std::optional<Subject> with_many_digits(const Subject& subject, const TruthIndex& truth) {
    const StepIndex* const index = truth.with_many_digits(*subject.exact);
    if (index == nullptr || subject.step == 0)
        return std::nullopt;
    // The steps come in the same order, unless the roots decide it.
    const auto& steps = subject.exact->find(subject.kind, subject.keys);
    const auto& others = index->find(subject.kind, subject.keys);
    const auto at = static_cast<std::size_t>(std::find(steps.begin(), steps.end(), subject.step) -
                                             steps.begin());
    if (steps.size() != others.size() || at >= others.size())
        return std::nullopt;
    Subject other = subject;
    other.exact = other.decided = index;
    other.step = other.decided_step = others[at];
    return other;
}

namespace {

bool is_key(StepKind kind, std::string_view name) {
    const StepField* const field = field_of(kind, name);
    return name == "in" || (field != nullptr && field->role == FieldRole::key);
}

/// Names as a message lists them: the first few.
std::string listed(const std::vector<std::string>& names) {
    constexpr std::size_t most_named = 8;
    const std::size_t shown = std::min(names.size(), most_named);
    const std::string text = joined(
        std::vector<std::string>(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown)),
        ", ");
    return printable(shown < names.size() ? fmt::format("{}, ... ({} in all)", text, names.size())
                                          : text);
}

/// Finds the step of one claim.
class Finder {
public:
    Finder(const Claim& claim, const Claims& claims, const TruthIndex& truth)
        : claim_(claim), claims_(claims), truth_(truth), kind_(*step_kind_named(claim.step)),
          index_(kind_ == StepKind::face && !is_of_own_test() ? truth.faces() : truth.exact()) {}

    Subject find() {
        Subject subject{.kind = kind_, .exact = &index_, .decided = &truth_.decided()};
        for (const ClaimedField& field : claim_.fields)
            if (field.name == "k" && kind_ == StepKind::decide)
                index_in_line_ = number_in(field.values.front());
            else if (is_key(kind_, field.name))
                subject.keys.emplace_back(field.name, key_value(field));
            else
                subject.fields.push_back(&field);
        check_keys(subject.keys);
        check_trace();
        check_names(subject.keys);
        if (kind_ == StepKind::pixel)
            check_pixel(subject);
        subject.step = step_in(*subject.exact, subject.keys);
        subject.decided_step = step_in(*subject.decided, subject.keys);
        if (subject.step == 0 && kind_ != StepKind::pixel)
            subject.absence = absence(subject.keys);
        const Trace& trace = index_.trace();
        subject.is_left_out = subject.step == 0 && (trace.is_partial || !trace.damage.empty());
        subject.culls = &index_ == &truth_.exact();
        return subject;
    }

private:
    /// True of a verdict: it is the one of the scene's own test, by light too, and numbers beside it are those that
    /// decided.
    bool is_of_own_test() const {
        return claim_.find("culled") != nullptr && !truth_.exact().find(StepKind::face, {}).empty();
    }

    [[noreturn]] void fail(std::string_view field, std::string message,
                           std::string hint = {}) const {
        const ClaimedField* const at = claim_.find(field);
        throw problem_at(claims_.source, at == nullptr ? claim_.offset : at->offset,
                         std::move(message), std::move(hint));
    }

    /// The value of a key: one, which is known. An edge may be named from either end.
    std::string key_value(const ClaimedField& field) const {
        if (field.values.size() != 1 || field.is_list || field.values.front() == open_value)
            fail(field.name,
                 fmt::format("expected one value of {}, which says what the claim is about",
                             field.name));
        const std::string& value = field.values.front();
        return field.name == "edge" ? edge_in(index_, value) : value;
    }

    /// Without its keys, nobody knows what a claim is about. All decisions of a line have no place.
    void check_keys(const StepIndex::Keys& keys) const {
        for (const StepField& field : fields_of(kind_)) {
            const bool is_there = std::any_of(
                keys.begin(), keys.end(), [&](const auto& key) { return key.first == field.name; });
            if (field.role == FieldRole::key && field.is_required() && !is_there &&
                !is_whole_line() && !index_in_line_)
                fail("", fmt::format("expected the `{}` that this claim is about, found none",
                                     field.name));
        }
    }

    /// What a claim is about must be told by the trace.
    void check_trace() const {
        const Trace& trace = index_.trace();
        if (kind_ == StepKind::pixel && (trace.is_partial || trace.lacks(StepKind::pixel)))
            fail("", "expected a trace with all pixels, found one that steps were left out of");
        const bool has_other_places = kind_ == StepKind::pixel || kind_ == StepKind::vertex;
        if (has_other_places || !index_.find(kind_, {}).empty())
            return;
        const ClaimedField* const in = claim_.find("in");
        auto names = names_for("in");
        for (const std::string& edge : index_.values_of(StepKind::edge, "edge"))
            names.push_back(edge);
        if (kind_ == StepKind::decide && in != nullptr &&
            std::find(names.begin(), names.end(), in->values.front()) == names.end())
            fail("in",
                 fmt::format("expected the name of something in the scene ({}), found {}",
                             listed(names), json_quoted(in->values.front())),
                 did_you_mean(in->values.front(), {names.begin(), names.end()}));
        constexpr std::array<std::pair<StepKind, std::string_view>, 7> ways{
            {{StepKind::decide, "lines are drawn so by --line bresenham"},
             {StepKind::along, "lines are drawn so by --line naive and --line dda"},
             {StepKind::depth, "--depth inverse-z gives the scene a depth buffer"},
             {StepKind::sample, "--fill barycentric tests samples"},
             {StepKind::scanline, "--fill scanline fills row by row"},
             {StepKind::order, "--depth painter sorts the triangles"},
             {StepKind::light, "--shade lambert lights faces"}}};
        const auto way = std::find_if(ways.begin(), ways.end(),
                                      [this](const auto& one) { return one.first == kind_; });
        fail("",
             fmt::format("expected a claim about something that the trace tells, found one about "
                         "`{}`, of which it has no step",
                         name_of(kind_)),
             way == ways.end() ? std::string() : std::string(way->second));
    }

    /// The names that a key can have.
    std::vector<std::string> names_for(const std::string& field) const {
        std::vector<std::string> names;
        if (field == "in")
            names = index_.values_of(StepKind::primitive, "name");
        if (field == "edge" || field == "name")
            names = index_.values_of(kind_, field);
        if (field == "in")
            for (std::string& around : index_.values_of(kind_, "in"))
                names.push_back(std::move(around));
        if (kind_ == StepKind::vertex && names.empty())
            for (const std::size_t n : index_.find(StepKind::primitive, {}))
                for (std::string& corner :
                     index_.trace().step(n).as<PrimitiveStep>().vertices.texts())
                    names.push_back(std::move(corner));
        std::sort(names.begin(), names.end());
        names.erase(std::unique(names.begin(), names.end()), names.end());
        return names;
    }

    /// True if something has this name, found without a list of all.
    bool is_known(const std::string& field, const std::string& value) const {
        return !index_.find(kind_, {{field, value}}).empty() ||
               (field == "in" && !index_.find(StepKind::primitive, {{"in", value}}).empty());
    }

    void check_names(const StepIndex::Keys& keys) const {
        for (const auto& [field, value] : keys) {
            if ((field != "in" && field != "edge" && field != "name") || is_known(field, value))
                continue;
            const auto names = names_for(field);
            if (std::find(names.begin(), names.end(), value) != names.end())
                continue;
            const std::string_view what = kind_ == StepKind::vertex ? "a vertex"
                                          : field == "edge"         ? "an edge"
                                          : kind_ == StepKind::face ? "a face"
                                                                    : "a primitive";
            const std::vector<std::string_view> known(names.begin(), names.end());
            fail(field,
                 fmt::format("expected {} of the scene ({}), found \"{}\"", what, listed(names),
                             printable(value)),
                 did_you_mean(value, known));
        }
    }

    /// Off the canvas, no pixel is drawn, and nothing else is known.
    void check_pixel(Subject& subject) const {
        const ClaimedField* const x = claim_.find("x");
        const ClaimedField* const y = claim_.find("y");
        if (x == nullptr || y == nullptr || x->values.empty() || y->values.empty())
            fail("", "expected the x and the y of a pixel, found none");
        const Canvas& canvas = index_.trace().canvas;
        const auto column = number_in(x->values.front());
        const auto row = number_in(y->values.front());
        const Rational lowest(std::min(canvas.top(), canvas.bottom()));
        const Rational highest(std::max(canvas.top(), canvas.bottom()));
        if (column && row && canvas.left() <= *column && *column <= canvas.right() &&
            lowest <= *row && *row <= highest)
            return;
        subject.is_off_canvas = true;
        subject.absence = said("the canvas has x {} to {}, y {} to {}", canvas.left(),
                               canvas.right(), lowest.get_str(), highest.get_str());
        for (const ClaimedField* const field : subject.fields)
            if (field->name != "plotted")
                fail("x",
                     fmt::format("expected a pixel of the canvas (x {} to {}, y {} to {}), "
                                 "found ({}, {})",
                                 canvas.left(), canvas.right(), lowest.get_str(), highest.get_str(),
                                 printable(x->values.front()), printable(y->values.front())));
    }

    /// The step that has these keys; 0 if none has.
    std::size_t step_in(const StepIndex& index, const StepIndex::Keys& keys) const {
        const auto& steps = index.find(kind_, keys);
        if ((kind_ == StepKind::matrix || claim_.is_printed) && steps.size() > 1)
            if (const std::size_t nearest = step_that_says_most(index, steps); nearest != 0)
                return nearest;
        if (kind_ == StepKind::decide && (is_whole_line() || index_in_line_)) {
            const std::size_t first = first_of_line(index, steps);
            if (!index_in_line_ || first == 0)
                return first;
            const auto decisions = decisions_from(index, first);
            const bool is_there =
                sgn(*index_in_line_) >= 0 && *index_in_line_ < static_cast<long>(decisions.size());
            return is_there ? decisions[index_in_line_->get_num().get_ui()] : 0;
        }
        if (kind_ == StepKind::pixel)
            return steps.empty() ? 0 : steps.back(); // what is seen
        if (kind_ == StepKind::vertex && steps.empty())
            return place_on_screen(index);
        if (steps.size() <= 1 || say_the_same(index, steps))
            return steps.empty() ? 0 : steps.front();
        const std::size_t span = nearest_span(index, steps);
        if (span == 0)
            refuse_several(index, steps);
        return span;
    }

    /// Of the steps that a sentence could be, the first that has most of its values; 0 if none has any.
    std::size_t step_that_says_most(const StepIndex& index,
                                    const std::vector<std::size_t>& steps) const {
        const auto values_of = [&](std::size_t n) {
            return std::count_if(
                claim_.fields.begin(), claim_.fields.end(), [&](const auto& field) {
                    if (is_key(kind_, field.name))
                        return false;
                    const ToldValues told = told_in(index, n, field);
                    return told && compare(field, *told, NumbersHeld::doubles, false).is_right;
                });
        };
        std::size_t best = 0;
        std::ptrdiff_t most = 0;
        for (const std::size_t n : steps)
            if (const auto count = values_of(n); count > most) {
                most = count;
                best = n;
            }
        return best;
    }

    /// Of the spans of a polygon in one row, the one whose end is nearest to the first that is claimed; 0 if they are of
    /// several primitives, or no end is claimed.
    std::size_t nearest_span(const StepIndex& index, const std::vector<std::size_t>& steps) const {
        const auto claimed_end = [this](std::string_view name) -> std::optional<Rational> {
            const ClaimedField* const field = claim_.find(name);
            const auto typed = field == nullptr || field->values.empty()
                                   ? std::nullopt
                                   : typed_value(field->values.front());
            return typed ? std::optional(typed->value) : std::nullopt;
        };
        const std::size_t owner = index.primitive_of(steps.front());
        if (const ClaimedField* const count = claim_.find("pixel_count");
            kind_ == StepKind::scanline && count != nullptr && count->values.front() == "0")
            return steps.front(); // none has no pixels
        if (kind_ != StepKind::scanline ||
            std::any_of(steps.begin(), steps.end(),
                        [&](std::size_t n) { return index.primitive_of(n) != owner; }))
            return 0;
        for (const std::string_view end : {"left", "from", "right", "to"})
            if (const auto claimed = claimed_end(end)) {
                const auto distance = [&](std::size_t n) {
                    const auto row = index.trace().step(n).as<ScanlineStep>();
                    const Rational told = end == "left"    ? row.left.exact().value_or(0)
                                          : end == "right" ? row.right.exact().value_or(0)
                                          : end == "from"  ? Rational(row.from)
                                                           : Rational(row.to);
                    return Rational(abs(told - *claimed));
                };
                return *std::min_element(
                    steps.begin(), steps.end(),
                    [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
            }
        return 0;
    }

    /// True of a claim about all of a line's decisions.
    bool is_whole_line() const {
        const ClaimedField* const d = claim_.find("d");
        return d != nullptr && d->is_list;
    }

    /// The first step of the line that is named, rather than of a side of that name.
    std::size_t first_of_line(const StepIndex& index, const std::vector<std::size_t>& steps) const {
        if (claim_.find("in") == nullptr) {
            const bool is_only_line = std::all_of(steps.begin(), steps.end(), [&](std::size_t n) {
                return index.primitive_of(n) == index.primitive_of(steps.front());
            });
            if (!is_only_line)
                refuse_several(index, steps);
            return steps.empty() ? 0 : steps.front();
        }
        for (const std::size_t n : steps)
            if (const std::size_t owner = index.primitive_of(n);
                owner != 0 &&
                name_in(index.trace().step(owner)) == claim_.find("in")->values.front())
                return n;
        return steps.empty() ? 0 : steps.front();
    }

    /// A trace that does not tell its vertices has them in its primitives.
    std::size_t place_on_screen(const StepIndex& index) const {
        const ClaimedField* const space = claim_.find("space");
        if (space == nullptr || space->values.front() != "screen")
            return 0;
        for (const std::size_t n : index.find(StepKind::primitive, {})) {
            const auto names = index.trace().step(n).as<PrimitiveStep>().vertices.texts();
            if (std::find(names.begin(), names.end(), claim_.find("name")->values.front()) !=
                names.end())
                return n;
        }
        return 0;
    }

    /// True if it makes no difference which of the steps is meant.
    bool say_the_same(const StepIndex& index, const std::vector<std::size_t>& steps) const {
        return std::all_of(claim_.fields.begin(), claim_.fields.end(), [&](const auto& field) {
            return is_key(kind_, field.name) ||
                   std::all_of(steps.begin(), steps.end(), [&](std::size_t n) {
                       return told_in(index, n, field) == told_in(index, steps.front(), field);
                   });
        });
    }

    [[noreturn]] void refuse_several(const StepIndex& index,
                                     const std::vector<std::size_t>& steps) const {
        std::vector<std::string> owners;
        for (const std::size_t n : steps) {
            const std::size_t owner = index.primitive_of(n);
            const std::string name = owner == 0 ? "" : name_in(index.trace().step(owner)).text();
            if (std::find(owners.begin(), owners.end(), name) == owners.end())
                owners.push_back(name);
        }
        fail("",
             fmt::format("expected a claim about one step, found one about {} of kind `{}`",
                         steps.size(), name_of(kind_)),
             owners.size() > 1
                 ? fmt::format("say which is meant: {}; {} y=2: ..., or \"in\": \"{}\"",
                               listed(owners), printable(owners.front()), printable(owners.front()))
                 : std::string());
    }

    /// Why a step is not there, with what there is instead.
    std::string absence(const StepIndex::Keys& keys) const {
        const auto& clip =
            index_.find(StepKind::vertex,
                        {{"name", claim_.find("name") ? claim_.find("name")->values.front() : ""},
                         {"space", "clip"}});
        for (const auto& [field, value] : keys)
            if (field == "space" && value == "canonical" && !clip.empty())
                return said("it is clipped before the division: w = {}",
                            index_.trace().step(clip.front()).as<VertexStep>().at.texts().back());
        for (const auto& [field, value] : keys)
            if (field == "space") {
                std::vector<std::string> spaces;
                for (const std::size_t n :
                     index_.find(StepKind::vertex, {{"name", claim_.find("name")->values.front()}}))
                    spaces.push_back(index_.trace().step(n).as<VertexStep>().space.text());
                fail("space", fmt::format("expected a space that {} is in ({}), found {}",
                                          printable(claim_.find("name")->values.front()),
                                          listed(spaces), printable(value)));
            }
        if (kind_ == StepKind::scanline) {
            std::vector<Index> rows;
            StepIndex::Keys others = keys;
            std::erase_if(others, [](const auto& key) { return key.first == "y"; });
            for (const std::size_t n : index_.find(kind_, others))
                rows.push_back(index_.trace().step(n).as<ScanlineStep>().y);
            if (!rows.empty()) {
                const auto [low, high] = std::minmax_element(rows.begin(), rows.end());
                return said("there is no such row: rows are y={} to {}", *low, *high);
            }
        }
        return said("the trace has no such step `{}`", name_of(kind_));
    }

    const Claim& claim_;
    const Claims& claims_;
    const TruthIndex& truth_;
    StepKind kind_;
    const StepIndex& index_;
    std::optional<Rational> index_in_line_ = {}; ///< `k`, of one of a line's decisions
};

} // namespace

const TruthIndex* TruthIndex::drawn_with(const Mistake& mistake) const {
    const auto [place, is_new] = with_mistakes_.try_emplace(&mistake);
    if (const Trace* const trace = is_new ? draw_mistake_(mistake) : nullptr)
        place->second = std::make_unique<TruthIndex>(
            *trace, nullptr, [] { return nullptr; }, [](const Trace&) { return nullptr; },
            [](const Mistake&) { return nullptr; });
    return place->second.get();
}

Subject subject_of(const Claim& claim, const Claims& claims, const TruthIndex& truth) {
    Subject subject = Finder(claim, claims, truth).find();
    subject.claim = &claim;
    return subject;
}

std::string edge_in(const StepIndex& index, const std::string& name) {
    const std::string turned(name.rbegin(), name.rend());
    const bool is_turned = name.size() == 2 &&
                           index.find(StepKind::edge, {{"edge", name}}).empty() &&
                           !index.find(StepKind::edge, {{"edge", turned}}).empty();
    return is_turned ? turned : name;
}

bool names_face(const std::string& name, const TruthIndex& truth) {
    const StepIndex& told = truth.exact();
    if (!told.find(StepKind::decide, {{"in", name}}).empty())
        return false;
    const StepIndex& faces = truth.faces();
    if (!faces.find(StepKind::face, {{"name", name}}).empty())
        return true;
    return !faces.find(StepKind::face, {}).empty() && told.find(StepKind::decide, {}).empty() &&
           told.find(StepKind::primitive, {{"name", name}}).empty();
}

bool is_decision(StepKind kind, std::string_view field) {
    if (kind == StepKind::pixel)
        return field == "plotted" || field == "inside" || field == "color" || field == "visible";
    if (kind == StepKind::primitive || kind == StepKind::scanline)
        for (const std::string_view counted : {"row_count", "pixel_count", "pixels", "visible"})
            if (field == counted)
                return true;
    const StepField* const known = field_of(kind, field);
    return known != nullptr && known->role == FieldRole::decision;
}

} // namespace rastertrace
