// SPDX-License-Identifier: MIT
#include "exercise.h"

#include "facts.h"
#include "random_numbers.h"
#include "slip_answers.h"

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/trace/check/slips.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/scene/distinguish.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/json_document.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace rastertrace {

namespace {

/// A scene drawn in exact numbers.
struct Drawn {
    Scene scene;
    Trace trace;
};

Result<Drawn> drawn(const Source& source) {
    constexpr std::size_t most_steps = 20'000;
    auto read = read_scene(source, {{"scalar", "exact"}});
    if (!read)
        return read.problem();
    Trace trace = drawn_trace(read.value().scene, read.value().plan, source.name, most_steps);
    return Drawn{std::move(read.value().scene), std::move(trace)};
}

} // namespace

/// A scene whose numbers can be drawn anew.
class ExerciseMaker::Redrawing {
public:
    explicit Redrawing(const Source& scene) : source_(scene) {
        const auto asked = drawn(scene);
        if (!asked)
            throw asked.problem();
        const auto& [as_typed, trace] = asked.value();
        canvas_ = as_typed.canvas;
        has_lines_ = as_typed.has(PrimitiveKind::line) || as_typed.has(PrimitiveKind::outline) ||
                     as_typed.has(PrimitiveKind::circle);
        is_projected_ = as_typed.projection.type != ProjectionType::none || as_typed.camera ||
                        !as_typed.objects.empty() || as_typed.viewport.type != ViewportType::none;
        facts_ = facts_of(trace);
        find_places();

        // Slips that give the same answers in all of some scenes are the same.
        Classes classes(slips().size());
        Answers answers = slip_answers_in(trace);
        classes.split(answers);
        constexpr int enough = 6;
        SearchState state{RandomNumbers("slips"), typed_values()};
        int count = 0;
        for (; count < enough; ++count) {
            const auto alike = next_alike(state);
            if (!alike)
                break;
            const Answers others = slip_answers_in(alike->trace);
            classes.split(others);
            for (std::size_t i = 0; i < answers.size(); ++i)
                answers[i] = answers[i] ? answers[i] : others[i];
        }
        if (count == 0)
            throw problem_of(
                source_.name,
                fmt::format("expected a scene whose facts other numbers can have, too; "
                            "in {} tries, what changed most often is \"{}\"",
                            most_tries, most_frequent_change()));
        for (auto& members : classes.members())
            if (answers[members.front()]) // can be made
                slips_.push_back(std::move(members));
        if (slips_.empty())
            throw problem_of(source_.name,
                             "expected a scene with numbers to work out, found only pixels");
    }

    Exercise made(std::string_view id) {
        SearchState state{RandomNumbers(id), typed_values()};
        auto found = first_to_tell_apart([&] { return next_alike(state); },
                                         [this](const Alike& alike) {
                                             const Answers all = slip_answers_in(alike.trace);
                                             Answers of_classes;
                                             for (const auto& members : slips_)
                                                 of_classes.push_back(all[members.front()]);
                                             return of_classes;
                                         });
        if (!found)
            throw problem_of(
                source_.name,
                "expected a scene in which each slip can give an answer of its own, found "
                "none in which they do",
                "larger triangles and longer lines tell more apart");
        return {std::string(id), std::move(found->source), slip_names()};
    }

private:
    /// A scene as it stands while numbers are changed: the values of each axis, ascending.
    using Axes = std::array<std::vector<Rational>, 3>;

    static constexpr int most_tries = 4'000;

    /// Where a search for scenes stands: random numbers, the last scene, how many may yet be tried.
    struct SearchState {
        RandomNumbers random;
        Axes axes;
        int tries = most_tries;
    };

    /// Where a coordinate of a vertex stands in the scene's text.
    struct Place {
        std::size_t begin;
        std::size_t end;
        std::size_t axis;
        Rational value;
    };

    /// A scene with the facts of this one.
    struct Alike {
        Source source;
        Trace trace;
    };

    /// The next such scene: after as many changes as there are values, each of which keeps the facts. `nullopt` when
    /// there are no tries left.
    std::optional<Alike> next_alike(SearchState& state) {
        const std::size_t most_changes = values_[0].size() + values_[1].size() + values_[2].size();
        std::optional<Alike> last;
        for (std::size_t changes = 0; state.tries > 0 && changes < most_changes;) {
            --state.tries;
            Axes changed = state.axes;
            if (!change(changed, state.random))
                continue;
            Source one = with(changed);
            auto tried = drawn(one);
            if (tried) // a larger scene has fewer tries
                state.tries -= static_cast<int>(tried.value().trace.size() / 1000);
            if (!tried || has_other_facts(facts_of(tried.value().trace)))
                continue;
            state.axes = std::move(changed);
            last = {std::move(one), std::move(tried.value().trace)};
            if (++changes == most_changes && last->source.text == source_.text)
                changes = 0;
        }
        return last && last->source.text != source_.text ? std::move(last) : std::nullopt;
    }

    Axes typed_values() const {
        Axes axes;
        for (std::size_t axis = 0; axis < 3; ++axis)
            axes[axis].assign(values_[axis].begin(), values_[axis].end());
        return axes;
    }

    /// Changes one value of an axis between its neighbors, or all of them by the same. False if there is no other place.
    bool change(Axes& axes, RandomNumbers& random) const {
        const auto axis = static_cast<std::size_t>(random.below(3));
        auto& values = axes[axis];
        if (values.empty())
            return false;
        const auto [low, high] = range_of(axis);
        std::vector<Rational> units; // of each value
        for (const Rational& typed : values_[axis])
            units.push_back(unit_for(typed, high - low, values.size()));
        if (random.below(4) == 0) {
            const Rational unit = *std::max_element(units.begin(), units.end());
            const Index down = ceil_index(Rational((low - values.front()) / unit));
            const Index up = floor_index(Rational((high - values.back()) / unit));
            if (up < down)
                return false;
            const Rational by = random.between(down, up) * unit;
            for (Rational& value : values)
                value += by;
            return by != 0;
        }
        const auto i = static_cast<std::size_t>(random.below(values.size()));
        const Rational& unit = units[i];
        const Rational from = i == 0 ? low : Rational(values[i - 1] + unit);
        const Rational to = i + 1 == values.size() ? high : Rational(values[i + 1] - unit);
        const Index first = ceil_index(Rational(from / unit));
        const Index last = floor_index(Rational(to / unit));
        if (last < first)
            return false;
        const Rational before = values[i];
        values[i] = random.between(first, last) * unit;
        return values[i] != before;
    }

    void find_places() {
        const auto document = parse_json(source_);
        const auto vertices =
            document ? document.value().root().find("vertices") : std::optional<JsonValue>();
        if (!vertices || vertices->members().empty())
            throw problem_of(source_.name, "expected a scene with vertices of its own, found none");
        if (const auto meshes = document.value().root().find("meshes"))
            for (const JsonValue& mesh : meshes->elements())
                if (mesh.find("obj"))
                    throw problem_of(source_.name,
                                     "expected a scene of one file, found a mesh in another one");
        for (const auto& [name, at] : vertices->members()) {
            std::size_t axis = 0;
            for (const JsonValue& coordinate : at.elements()) {
                if (axis < 3)
                    if (const auto number = number_in_text(coordinate.text))
                        places_.push_back({coordinate.begin, coordinate.end(), axis, *number});
                ++axis;
            }
        }
        for (const Place& place : places_)
            values_[place.axis].insert(place.value);
    }

    static std::optional<Rational> number_in_text(const std::string& text) {
        const auto number = parse_number(text);
        const Number* const found = std::get_if<Number>(&number);
        return found ? std::optional(found->exact()) : std::nullopt;
    }

    /// The least and the largest value that a coordinate may have.
    std::pair<Rational, Rational> range_of(std::size_t axis) const {
        const auto& values = values_[axis];
        if (is_projected_ || axis == 2)
            return {*values.begin(), *values.rbegin()};
        if (axis == 0)
            return {canvas_.left(), canvas_.right()};
        return std::minmax({Rational(canvas_.top()), Rational(canvas_.bottom())});
    }

    /// The step between the values that a coordinate may have: 1 over the denominator that it has, at most 8; halved as
    /// long as there are few of them, but not where lines are.
    Rational unit_for(const Rational& value, const Rational& width, std::size_t count) const {
        constexpr long largest_denominator = 8;
        const bool is_fine = value.get_den() > largest_denominator;
        Rational unit(1, is_fine ? mpz_class(largest_denominator) : value.get_den());
        while (!has_lines_ && width / unit < 3 * static_cast<long>(count) &&
               unit.get_den() * 2 <= largest_denominator)
            unit /= 2;
        return unit;
    }

    /// The scene with other values in the place of its own.
    Source with(const Axes& axes) const {
        Source scene = source_;
        for (auto place = places_.rbegin(); place != places_.rend(); ++place) {
            const auto& typed = values_[place->axis];
            const auto i =
                static_cast<std::size_t>(std::distance(typed.begin(), typed.find(place->value)));
            const std::string value = axes[place->axis][i].get_str();
            scene.text.replace(place->begin, place->end - place->begin,
                               value.find('/') == std::string::npos ? value
                                                                    : fmt::format("\"{}\"", value));
        }
        return scene;
    }

    bool has_other_facts(const std::vector<std::string>& facts) {
        if (facts == facts_)
            return false;
        auto changed = only_in(facts_, facts);
        if (changed.empty())
            changed = only_in(facts, facts_);
        for (const std::string& fact : changed)
            ++changes_[fact];
        return true;
    }

    static std::vector<std::string> only_in(const std::vector<std::string>& some,
                                            const std::vector<std::string>& others) {
        std::vector<std::string> only;
        std::set_difference(some.begin(), some.end(), others.begin(), others.end(),
                            std::back_inserter(only));
        return only;
    }

    std::string most_frequent_change() const {
        const auto found =
            std::max_element(changes_.begin(), changes_.end(),
                             [](const auto& a, const auto& b) { return a.second < b.second; });
        return found == changes_.end() ? "that it can be drawn" : found->first;
    }

    std::vector<std::vector<std::string_view>> slip_names() const {
        std::vector<std::vector<std::string_view>> names;
        for (const auto& members : slips_) {
            auto& of_class = names.emplace_back();
            for (const std::size_t i : members)
                of_class.push_back(slips()[i].name);
        }
        std::sort(names.begin(), names.end());
        return names;
    }

    Source source_;
    Canvas canvas_;
    bool is_projected_ = false;
    bool has_lines_ = false;                   ///< their ends stay on the grid that they are on
    std::vector<Place> places_;                ///< in the order of the text
    std::array<std::set<Rational>, 3> values_; ///< of x, y and z
    std::vector<std::string> facts_;
    std::map<std::string, int> changes_; ///< how often a fact was another one
    std::vector<std::vector<std::size_t>>
        slips_; ///< that can be made, by their places in slips(): those alike
};

ExerciseMaker::ExerciseMaker(const Source& scene) : like_(std::make_unique<Redrawing>(scene)) {}
ExerciseMaker::ExerciseMaker(ExerciseMaker&&) noexcept = default;
ExerciseMaker::~ExerciseMaker() = default;

Exercise ExerciseMaker::exercise(std::string_view id) {
    return like_->made(id);
}

} // namespace rastertrace
