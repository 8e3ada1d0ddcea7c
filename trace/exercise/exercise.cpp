// SPDX-License-Identifier: MIT
#include "exercise.h"

#include "facts.h"

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/trace/check/derivation.h>
#include <rastertrace/trace/check/slips.h>
#include <rastertrace/trace/check/step_index.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/json_document.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace rastertrace {

namespace {

constexpr std::string_view exercise_line_begin = "# exercise ";

/// Random numbers that are the same everywhere: SplitMix64 (Steele, Lea and Flood 2014), from the FNV-1a hash of an ID.
class RandomNumbers {
public:
    explicit RandomNumbers(std::string_view id) {
        for (const char c : id)
            state_ = (state_ ^ static_cast<unsigned char>(c)) * 0x100000001B3;
    }

    /// From 0 to `count` - 1.
    std::uint64_t below(std::uint64_t count) {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EB;
        return (z ^ (z >> 31U)) % count;
    }

    /// Both included.
    Index between(Index first, Index last) {
        return first + static_cast<Index>(below(static_cast<std::uint64_t>(last - first) + 1));
    }

private:
    std::uint64_t state_ = 0xCBF29CE484222325;
};

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

/// Of each slip, in words that are the same where it makes the same of all numbers.
using Answers = std::map<std::string_view, std::string>;

/// What every slip makes of all that can be worked out in a trace; a slip that cannot be made has no answer.
Answers answers_in(const Trace& trace) {
    constexpr std::array worked_out{StepKind::vertex, StepKind::face,     StepKind::light,
                                    StepKind::edge,   StepKind::scanline, StepKind::decide,
                                    StepKind::along,  StepKind::depth};
    constexpr std::size_t most = 200;
    const StepIndex index(trace);
    const Numbers numbers(index);
    Answers answers;
    std::size_t count = 0;
    for (std::size_t n = 1; n <= trace.size() && count < most; ++n) {
        const auto kind = trace.kind_of(n);
        if (!kind || std::find(worked_out.begin(), worked_out.end(), *kind) == worked_out.end())
            continue;
        ++count;
        for (const StepField& field : fields_of(*kind)) {
            if (!trace.step(n).field(field.name)) // nobody is asked for it
                continue;
            const auto formulas = formulas_of(numbers, n, field.name);
            if (formulas.empty())
                continue;
            for (const Slip& slip : slips())
                for (const SlipResult& result : slip.redo(formulas.front())) {
                    std::string& answer = answers[slip.name];
                    answer += fmt::format("{}.{}=", n, field.name);
                    for (const Rational& value : result.values)
                        answer += value.get_str() + ",";
                }
        }
    }
    return answers;
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
        constexpr std::size_t enough = 6;
        std::vector<Answers> all{answers_in(trace)};
        RandomNumbers random("slips");
        Axes axes = typed_values();
        for (int tries = most_tries; tries > 0 && all.size() <= enough;)
            if (auto alike = next_alike(random, tries, axes))
                all.push_back(std::move(alike->second));
        if (all.size() == 1)
            throw problem_of(
                source_.name,
                fmt::format("expected a scene whose facts other numbers can have, too; "
                            "in {} tries, what changed most often is \"{}\"",
                            most_tries, most_frequent_change()));
        slips_ = slips_alike(all);
        if (slips_.empty())
            throw problem_of(source_.name,
                             "expected a scene with numbers to work out, found only pixels");
    }

    Exercise made(std::string_view id) {
        RandomNumbers random(id);
        Axes axes = typed_values();
        for (int tries = most_tries; tries > 0;)
            if (auto alike = next_alike(random, tries, axes); alike && tells_apart(alike->second))
                return {std::string(id), std::move(alike->first), slips_};
        throw problem_of(source_.name,
                         "expected a scene in which each slip can give an answer of its own, found "
                         "none in which they do",
                         "larger triangles and longer lines tell more apart");
    }

private:
    static constexpr int most_tries = 4'000;

    /// Where a coordinate of a vertex stands in the scene's text.
    struct Place {
        std::size_t begin;
        std::size_t end;
        std::size_t axis;
        Rational value;
    };

    /// A scene as it stands while numbers are changed: the values of each axis, ascending.
    using Axes = std::array<std::vector<Rational>, 3>;

    /// The next scene with the facts of this one, and what slips make of it: after as many changes as there are values,
    /// each of which keeps the facts. `nullopt` when there are no tries left.
    std::optional<std::pair<Source, Answers>> next_alike(RandomNumbers& random, int& tries,
                                                         Axes& axes) {
        std::size_t changes = values_[0].size() + values_[1].size() + values_[2].size();
        std::optional<Trace> last;
        Source scene;
        while (tries-- > 0 && changes > 0) {
            Axes changed = axes;
            if (!change(changed, random))
                continue;
            Source one = with(changed);
            auto tried = drawn(one);
            if (tried) // a larger scene has fewer tries
                tries -= static_cast<int>(tried.value().trace.size() / 1000);
            if (!tried || has_other_facts(facts_of(tried.value().trace)))
                continue;
            axes = std::move(changed);
            scene = std::move(one);
            last = std::move(tried.value().trace);
            --changes;
        }
        if (!last || scene.text == source_.text)
            return std::nullopt;
        return std::pair(std::move(scene), answers_in(*last));
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

    /// The slips that can be made, in groups of those that give the same answers in all scenes.
    static std::vector<std::vector<std::string_view>>
    slips_alike(const std::vector<Answers>& all_answers) {
        std::map<std::vector<std::string>, std::vector<std::string_view>> groups;
        for (const Slip& slip : slips()) {
            std::vector<std::string> all;
            bool is_made = false;
            for (const Answers& answers : all_answers) {
                const auto found = answers.find(slip.name);
                all.push_back(found == answers.end() ? "" : found->second);
                is_made = is_made || !all.back().empty();
            }
            if (is_made)
                groups[std::move(all)].push_back(slip.name);
        }
        std::vector<std::vector<std::string_view>> found;
        for (auto& [answers, names] : groups)
            found.push_back(std::move(names));
        std::sort(found.begin(), found.end());
        return found;
    }

    /// True if every group can be made, and each gives an answer of its own.
    bool tells_apart(const Answers& answers) const {
        std::set<std::string_view> known;
        return std::all_of(slips_.begin(), slips_.end(), [&](const auto& group) {
            const auto found = answers.find(group.front());
            return found != answers.end() && known.insert(found->second).second;
        });
    }

    Source source_;
    Canvas canvas_;
    bool is_projected_ = false;
    bool has_lines_ = false;                   ///< their ends stay on the grid that they are on
    std::vector<Place> places_;                ///< in the order of the text
    std::array<std::set<Rational>, 3> values_; ///< of x, y and z
    std::vector<std::string> facts_;
    std::map<std::string, int> changes_; ///< how often a fact was another one
    std::vector<std::vector<std::string_view>> slips_;
};

Result<std::string> exercise_id(std::string_view typed) {
    constexpr std::size_t most = 100;
    const auto refuse = [&](std::string message) { return problem_of("", std::move(message)); };
    if (typed.size() > most)
        return refuse(
            fmt::format("expected an ID of at most {} letters, found {}", most, typed.size()));
    std::string_view seed = typed;
    if (const std::size_t colon = typed.find(':'); colon != std::string_view::npos) {
        if (typed.substr(0, colon) != std::to_string(exercise_version))
            return refuse(fmt::format("expected an ID of version {}, found one of version \"{}\"",
                                      exercise_version, typed.substr(0, colon)));
        seed = typed.substr(colon + 1);
    }
    if (seed.empty())
        return refuse("expected an ID, found an empty one");
    const bool has_control = std::any_of(seed.begin(), seed.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    });
    if (has_control)
        return refuse(
            "expected an ID without control characters, such as the ends of lines, found some");
    return fmt::format("{}:{}", exercise_version, seed);
}

std::string exercise_line(std::string_view id) {
    return fmt::format("{}{}\n", exercise_line_begin, id);
}

Result<std::string> exercise_of_sheet(const Source& sheet) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    for (const std::string& whole : split_at(sheet.view(), '\n')) {
        std::string_view typed = whole;
        if (typed.starts_with(byte_order_mark))
            typed.remove_prefix(byte_order_mark.size());
        if (typed.starts_with(exercise_line_begin)) {
            typed.remove_prefix(exercise_line_begin.size());
            while (!typed.empty() && (typed.back() == '\r' || typed.back() == ' '))
                typed.remove_suffix(1);
            auto id = exercise_id(typed);
            if (!id)
                return problem_of(sheet.name, id.problem().message);
            return id;
        }
    }
    return problem_of(
        sheet.name, "expected a line that names the exercise, as `# exercise 1:anna`, found none");
}

ExerciseMaker::ExerciseMaker(const Source& scene) : like_(std::make_unique<Redrawing>(scene)) {}
ExerciseMaker::ExerciseMaker(ExerciseMaker&&) noexcept = default;
ExerciseMaker::~ExerciseMaker() = default;

Exercise ExerciseMaker::exercise(std::string_view id) {
    return like_->made(id);
}

} // namespace rastertrace
