// SPDX-License-Identifier: MIT
#include "exercise.h"

#include "slips.h"

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/byte_order_mark.h>
#include <rastertrace/trace/text/json_document.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>

namespace rastertrace {

namespace {

constexpr std::string_view exercise_line_begin = "# exercise ";

/// What may stand behind an ID in a sheet: a spreadsheet adds empty cells.
constexpr std::string_view padding = " \r\t,;";

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

/// The values of the vertices' coordinates, of each axis, ascending.
using Axes = std::array<std::vector<Rational>, 3>;

/// A scene drawn in exact numbers.
struct DrawnExercise {
    Source source;
    Scene scene;
    Trace trace;
};

Result<DrawnExercise> drawn_exactly(Source source) {
    constexpr std::size_t most_steps = 20'000;
    auto read = read_scene(source, {{"scalar", "exact"}});
    if (!read)
        return read.problem();
    auto& [scene, plan, remarks] = read.value();
    Trace trace = drawn_trace(scene, plan, source.name, most_steps);
    return DrawnExercise{std::move(source), std::move(scene), std::move(trace)};
}

/// A scene whose numbers can be drawn anew.
class Redrawing {
public:
    explicit Redrawing(const Source& scene) : source_(scene) {
        auto asked = drawn_exactly(scene);
        if (!asked)
            throw asked.problem();
        const Scene& typed = asked.value().scene;
        canvas_ = typed.canvas;
        has_lines_ =
            std::any_of(all_primitives.begin(), all_primitives.end(), [&typed](PrimitiveKind kind) {
                return typed.has(kind) && traits_of(kind).thickness == Thickness::line;
            });
        is_projected_ = typed.projection.type != ProjectionType::none || typed.camera ||
                        !typed.objects.empty() || typed.viewport.type != ViewportType::none;
        facts_ = exercise_facts(asked.value().trace);
        find_places();
        find_slips(slip_answers_in(asked.value().trace));
    }

    Source made(std::string_view id) const {
        Search search{RandomNumbers(id), typed_};
        auto found = first_to_tell_apart([&] { return next_alike(search); },
                                         [this](const DrawnExercise& alike) {
                                             const Answers all = slip_answers_in(alike.trace);
                                             Answers of_classes;
                                             for (const std::size_t slip : slips_)
                                                 of_classes.push_back(all[slip]);
                                             return of_classes;
                                         });
        if (!found)
            fail("expected a scene in which each slip can give an answer of its own, found none in "
                 "which they do",
                 "larger triangles and longer lines tell more apart");
        return std::move(found->source);
    }

private:
    /// Where a search for scenes stands: random numbers, the last scene, how many may yet be tried.
    struct Search {
        RandomNumbers random;
        Axes axes;
        int tries = 4'000;
    };

    /// Where a coordinate of a vertex stands in the scene's text.
    struct Place {
        std::size_t begin;
        std::size_t end;
        std::size_t axis;
        Rational value;
    };

    [[noreturn]] void fail(std::string message, std::string hint = {}) const {
        throw problem_of(source_.name, std::move(message), std::move(hint));
    }

    void find_places() {
        const auto document = parse_json(source_);
        const auto vertices =
            document ? document.value().root().find("vertices") : std::optional<JsonValue>();
        if (!vertices || vertices->members().empty())
            fail("expected a scene with vertices of its own, found none");
        if (const auto meshes = document.value().root().find("meshes"))
            for (const JsonValue& mesh : meshes->elements())
                if (mesh.find("obj"))
                    fail("expected a scene of one file, found a mesh in another one");
        for (const auto& [name, at] : vertices->members()) {
            std::size_t axis = 0;
            for (const JsonValue& coordinate : at.elements()) {
                const auto number = parse_number(coordinate.text);
                if (const auto* const found = std::get_if<Number>(&number); found && axis < 3)
                    places_.push_back({coordinate.begin, coordinate.end(), axis, found->exact()});
                ++axis;
            }
        }
        for (const Place& place : places_)
            typed_[place.axis].push_back(place.value);
        for (auto& values : typed_) {
            std::sort(values.begin(), values.end());
            values.erase(std::unique(values.begin(), values.end()), values.end());
        }
    }

    /// Those that can be made in the scene; of slips that give the same answers in all of some scenes, the first.
    void find_slips(Answers answers) {
        constexpr int enough = 6;
        Classes classes(answers.size());
        classes.split(answers);
        Search search{RandomNumbers("slips"), typed_};
        int count = 0;
        for (; count < enough; ++count) {
            const auto alike = next_alike(search);
            if (!alike)
                break;
            const Answers others = slip_answers_in(alike->trace);
            classes.split(others);
            for (std::size_t i = 0; i < answers.size(); ++i)
                answers[i] = answers[i] ? answers[i] : others[i];
        }
        if (count == 0)
            fail("expected a scene whose facts other numbers can have, too",
                 "a larger canvas has more of them");
        for (const auto& members : classes.members())
            if (answers[members.front()])
                slips_.push_back(members.front());
        if (slips_.empty())
            fail("expected a scene with numbers to work out, found only pixels");
    }

    /// The next scene with the facts of this one: after as many changes as there are values, each of which keeps the
    /// facts. `nullopt` when there are no tries left.
    std::optional<DrawnExercise> next_alike(Search& search) const {
        const std::size_t most_changes = typed_[0].size() + typed_[1].size() + typed_[2].size();
        std::optional<DrawnExercise> last;
        for (std::size_t changes = 0; search.tries > 0 && changes < most_changes;) {
            --search.tries;
            Axes changed = search.axes;
            if (!change(changed, search.random))
                continue;
            auto tried = drawn_exactly(with(changed));
            if (!tried)
                continue;
            // A larger scene has fewer tries.
            search.tries -= static_cast<int>(tried.value().trace.size() / 1000);
            if (exercise_facts(tried.value().trace) != facts_)
                continue;
            search.axes = std::move(changed);
            last = std::move(tried.value());
            if (++changes == most_changes && last->source.text == source_.text)
                changes = 0;
        }
        return last && last->source.text != source_.text ? std::move(last) : std::nullopt;
    }

    /// Changes one value of an axis between its neighbors, or all of them by the same. False if there is no other place.
    bool change(Axes& axes, RandomNumbers& random) const {
        const auto axis = static_cast<std::size_t>(random.below(3));
        auto& values = axes[axis];
        if (values.empty())
            return false;
        const auto [low, high] = range_of(axis);
        std::vector<Rational> units; // of each value
        for (const Rational& typed : typed_[axis])
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
        const Rational before = std::exchange(values[i], random.between(first, last) * unit);
        return values[i] != before;
    }

    /// The least and the largest value that a coordinate may have.
    std::pair<Rational, Rational> range_of(std::size_t axis) const {
        if (is_projected_ || axis == 2)
            return {typed_[axis].front(), typed_[axis].back()};
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
            const auto& typed = typed_[place->axis];
            const auto i =
                std::lower_bound(typed.begin(), typed.end(), place->value) - typed.begin();
            const std::string value = axes[place->axis][static_cast<std::size_t>(i)].get_str();
            scene.text.replace(place->begin, place->end - place->begin,
                               value.find('/') == std::string::npos ? value : json_quoted(value));
        }
        return scene;
    }

    Source source_;
    Canvas canvas_;
    bool is_projected_ = false;
    bool has_lines_ = false;    ///< their ends stay on the grid that they are on
    std::vector<Place> places_; ///< in the order of the text
    Axes typed_;
    ExerciseFacts facts_;
    std::vector<std::size_t>
        slips_; ///< that must give answers of their own, by their places in slips()
};

} // namespace

ExerciseMaker exercises_like(const Source& scene) {
    const auto like = std::make_shared<const Redrawing>(scene);
    return [like](std::string_view id) { return like->made(id); };
}

Result<std::string> exercise_id(std::string_view typed) {
    constexpr std::size_t most = 100;
    const std::size_t colon = typed.find(':');
    const std::string_view version = colon == std::string_view::npos ? "1" : typed.substr(0, colon);
    const std::string_view seed = typed.substr(colon + 1); // or all, without a colon
    const bool has_control = std::any_of(seed.begin(), seed.end(),
                                         [](char c) { return (c >= 0 && c < 0x20) || c == 0x7F; });
    if (version != "1" || seed.empty() || seed.size() > most || has_control ||
        padding.find(seed.back()) != std::string_view::npos)
        return problem_of(
            "", fmt::format("expected an ID of 1 to {} letters, none of them a control character "
                            "and the last one no blank, comma or semicolon, perhaps with version 1 "
                            "before it, as 1:anna; found \"{}\"",
                            most, shortened(printable(typed), most)));
    return fmt::format("1:{}", seed);
}

std::string exercise_line(std::string_view id) {
    return fmt::format("{}{}\n", exercise_line_begin, id);
}

Result<std::string> exercise_of_sheet(const Source& sheet) {
    for (const std::string& line : split_at(sheet.view().substr(size_of_mark(sheet.view())), '\n'))
        if (line.starts_with(exercise_line_begin)) {
            const std::string_view typed =
                std::string_view(line).substr(exercise_line_begin.size());
            auto id = exercise_id(typed.substr(0, typed.find_last_not_of(padding) + 1));
            return id ? id : Result<std::string>(problem_of(sheet.name, id.problem().message));
        }
    return std::string();
}

} // namespace rastertrace
