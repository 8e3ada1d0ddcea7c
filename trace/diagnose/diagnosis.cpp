// SPDX-License-Identifier: MIT
#include "diagnosis.h"

#include "in_threads.h"
#include "tell_apart.h"

#include <rastertrace/trace/picture/picture_trace.h>
#include <rastertrace/trace/record/frame.h>
#include <rastertrace/trace/scene/scene_file.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace rastertrace {

namespace {

/// True if a pixel of a picture is not as it was seen.
bool differs(const SeenCells& seen, std::size_t cell, Color drawn) {
    const Color color = seen.colors[cell];
    return seen.has_colors ? color != drawn : (color == no_color) != (drawn == no_color);
}

/// A rule, and how it does on all pairs.
struct Tried {
    Rule rule{};
    std::size_t changes = 0; ///< settings that are not those in force
    std::uint64_t unexplained = 0;
    std::uint64_t gain = 0;    ///< pixels that it draws as seen, and the scenes' own rules do not
    std::uint64_t picture = 0; ///< a hash of all pictures
    bool is_drawn = false;

    /// How far it is from what the scene asks for.
    std::size_t size() const { return changes + rule.mistakes.size(); }

    /// Better ones come first: what explains more, with fewer mistakes, with fewer changes.
    auto order() const { return std::tuple(!is_drawn, unexplained, rule.mistakes.size(), changes); }
};

class Search {
public:
    Search(std::span<const DrawnPair> pairs, const DiagnoseOptions& options)
        : pairs_(pairs), options_(options) {
        for (const DrawnPair& pair : pairs) {
            auto read = read_scene(pair.scene, {{"scalar", "exact"}});
            if (!read)
                throw read.problem();
            scenes_.push_back(std::move(read.value().scene));
            asked_.push_back(*drawn_by({}, pair.scene));
        }
    }

    Diagnosis found() {
        Diagnosis diagnosis;
        const Tried as_asked = try_one({}, DrawnIn::fractions);
        diagnosis.differing = as_asked.unexplained;
        if (diagnosis.is_as_asked()) {
            diagnosis.answer.emplace_back();
            return diagnosis;
        }
        for (std::size_t i = 0; i < pairs_.size(); ++i)
            for (std::size_t cell = 0; cell < pairs_[i].seen.colors.size(); ++cell)
                diagnosis.drawn +=
                    pairs_[i].seen.colors[cell] != no_color || asked_[i].colors()[cell] != no_color;

        std::vector<Tried> tried = try_all(distinct(all_rules()));
        if (const std::uint64_t least = least_of(tried); least > 0) {
            const auto two = try_all(rules_of_two(tried));
            if (!two.empty() && least_of(two) < least)
                tried.insert(tried.end(), two.begin(), two.end());
        }
        std::ranges::stable_sort(tried, {}, &Tried::order);
        const Tried best = tried.front();
        diagnosis.unexplained = best.unexplained;
        if (best.unexplained > 0 &&
            (best.unexplained * 3 > diagnosis.differing || best.unexplained * 20 > diagnosis.drawn))
            return diagnosis;
        for (const Tried& one : tried)
            if (one.picture == best.picture && one.size() < best.size() + 2)
                add_to_answer(one.rule, diagnosis.answer);
        const auto next = std::ranges::find_if(
            tried, [&](const Tried& one) { return one.is_drawn && one.picture != best.picture; });
        if (next != tried.end()) {
            diagnosis.runner_up = next->rule;
            diagnosis.runner_up_unexplained = next->unexplained;
        }
        find_pixel(diagnosis);
        return diagnosis;
    }

private:
    std::vector<Rule> all_rules() const {
        std::vector<Rule> all;
        for (const DrawnPair& pair : pairs_)
            for (Rule& rule : rules_for(pair.scene, options_.any_convention))
                all.push_back(std::move(rule));
        return all;
    }

    /// Each once; without the settings that are in force in all scenes anyway.
    std::vector<Rule> distinct(std::vector<Rule> rules) const {
        std::vector<Rule> kept;
        std::map<std::string, bool> seen;
        for (Rule& rule : rules) {
            std::erase_if(rule.settings, [this](const auto& setting) {
                const MethodKey& key = *find_method_key(setting.first);
                return setting.first != "convention" &&
                       std::ranges::all_of(scenes_, [&](const Scene& scene) {
                           return value_in_force(key, scene) == setting.second;
                       });
            });
            if (seen.try_emplace(name_of(rule), true).second)
                kept.push_back(std::move(rule));
        }
        return kept;
    }

    static std::uint64_t least_of(const std::vector<Tried>& tried) {
        return std::ranges::min(tried, {}, &Tried::unexplained).unexplained;
    }

    /// Settings are drawn in doubles first. Those that come near the best are drawn again in fractions.
    std::vector<Tried> try_all(const std::vector<Rule>& rules) const {
        constexpr std::uint64_t near = 16;
        std::vector<Tried> tried(rules.size());
        const auto in_doubles = [](const Rule& rule) {
            return std::ranges::all_of(rule.mistakes,
                                       [](const Mistake* one) { return !one->put_in; });
        };
        in_threads(rules.size(), options_.jobs, [&](std::size_t i) {
            tried[i] =
                try_one(rules[i], in_doubles(rules[i]) ? DrawnIn::doubles : DrawnIn::fractions);
        });
        const std::uint64_t least = rules.empty() ? 0 : least_of(tried);
        in_threads(rules.size(), options_.jobs, [&](std::size_t i) {
            if (in_doubles(rules[i]) && tried[i].unexplained <= 2 * least + near)
                tried[i] = try_one(rules[i], DrawnIn::fractions);
        });
        return tried;
    }

    Tried try_one(const Rule& rule, DrawnIn numbers) const {
        Tried tried{.rule = rule, .changes = rule.settings.size(), .is_drawn = true};
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            const DrawnPair& pair = pairs_[i];
            const auto image = drawn_by(rule, pair.scene, numbers);
            if (!image || image->colors().size() != pair.seen.colors.size()) {
                tried.is_drawn = false;
                break;
            }
            for (std::size_t cell = 0; cell < pair.seen.colors.size(); ++cell) {
                const Color color = image->colors()[cell];
                const bool is_wrong = differs(pair.seen, cell, color);
                tried.unexplained += is_wrong;
                tried.gain += !is_wrong && differs(pair.seen, cell, asked_[i].colors()[cell]);
                // FNV-1a, a word at a time.
                const std::uint64_t word = std::uint64_t{color.red()} << 24 |
                                           std::uint64_t{color.green()} << 16 |
                                           std::uint64_t{color.blue()} << 8 | color.alpha();
                tried.picture = (tried.picture ^ word) * 0x100000001B3;
            }
        }
        if (!tried.is_drawn)
            tried.unexplained = std::numeric_limits<std::uint64_t>::max();
        return tried;
    }

    /// Pairs of the mistakes that each explain the most of what differs: pixels that they draw as seen, and the scene's
    /// own rules do not.
    std::vector<Rule> rules_of_two(const std::vector<Tried>& tried) const {
        constexpr std::size_t most = 14;
        std::vector<std::pair<std::uint64_t, const Mistake*>> gains;
        for (const Tried& one : tried)
            if (one.is_drawn && one.rule.mistakes.size() == 1 && one.rule.settings.empty() &&
                one.gain > 0)
                gains.emplace_back(one.gain, one.rule.mistakes.front());
        std::ranges::stable_sort(gains, std::ranges::greater{},
                                 [](const auto& one) { return one.first; });
        gains.resize(std::min(gains.size(), most));
        std::vector<Rule> rules;
        for (std::size_t i = 0; i < gains.size(); ++i)
            for (std::size_t k = i + 1; k < gains.size(); ++k)
                rules.push_back({{}, {gains[i].second, gains[k].second}});
        return rules;
    }

    /// Adds a rule, unless one that is part of it, or that always draws the same, is there.
    void add_to_answer(const Rule& rule, std::vector<AnsweredRule>& answer) const {
        constexpr std::uint64_t seeds = 24;
        const auto has = [](const auto& all, const auto& item) {
            return std::ranges::find(all, item) != all.end();
        };
        const auto is_part = [&](const Rule& one) {
            return std::ranges::all_of(
                       one.settings,
                       [&](const auto& setting) { return has(rule.settings, setting); }) &&
                   std::ranges::all_of(one.mistakes, [&](const Mistake* mistake) {
                       return has(rule.mistakes, mistake);
                   });
        };
        for (AnsweredRule& one : answer) {
            if (is_part(one.rule))
                return;
            if (scene_apart(one.rule, rule, method_of(scenes_.front()), seeds))
                continue;
            if (rule.mistakes.size() == 1 && rule.settings.empty())
                one.same.push_back(rule.mistakes.front());
            return;
        }
        answer.push_back({rule, {}});
    }

    /// What a scene says of its method, for scenes like it.
    static MethodOverrides method_of(const Scene& scene) {
        MethodOverrides method;
        for (const MethodKey& key : method_keys())
            if (const std::string said = key.get(scene.method);
                !said.empty() && key.in_force(scene) && key.name != "mistake")
                method.emplace_back(key.name, said);
        return method;
    }

    /// A pixel that is as the answer has it, and neither as the scene asks nor, if possible, as the runner-up has it.
    void find_pixel(Diagnosis& diagnosis) const {
        for (const bool tells_apart : {true, false})
            for (std::size_t i = 0; i < pairs_.size() && !diagnosis.pixel; ++i) {
                const SeenCells& seen = pairs_[i].seen;
                const auto by_answer = drawn_by(diagnosis.answer.front().rule, pairs_[i].scene);
                const auto by_next = diagnosis.runner_up
                                         ? drawn_by(*diagnosis.runner_up, pairs_[i].scene)
                                         : std::nullopt;
                for (std::size_t cell = 0; cell < seen.colors.size(); ++cell)
                    if (differs(seen, cell, asked_[i].colors()[cell]) &&
                        !differs(seen, cell, by_answer->colors()[cell]) &&
                        (!tells_apart || !by_next ||
                         differs(seen, cell, by_next->colors()[cell]))) {
                        const Canvas& canvas = scenes_[i].canvas;
                        const auto width = static_cast<std::size_t>(canvas.width);
                        diagnosis.pair = i;
                        diagnosis.pixel = Pixel{canvas.left() + static_cast<int>(cell % width),
                                                canvas.y_of(static_cast<int>(cell / width))};
                        break;
                    }
            }
    }

    std::span<const DrawnPair> pairs_;
    const DiagnoseOptions& options_;
    std::vector<Scene> scenes_;
    std::vector<Image> asked_;
};

} // namespace

SeenCells cells_of(const Picture& picture, const Source& scene) {
    SeenCells cells{picture.width,
                    picture.height,
                    {picture.pixels.begin(), picture.pixels.end()},
                    picture.has_colors};
    const auto asked = drawn_by({}, scene);
    if (!picture.has_colors || !asked || asked->colors().size() != cells.colors.size())
        return cells;

    // What is not drawn.
    std::vector<Color> not_drawn;
    std::vector<Color> known{no_color};
    for (std::size_t i = 0; i < cells.colors.size(); ++i) {
        const Color color = asked->colors()[i];
        if (color == no_color)
            not_drawn.push_back(cells.colors[i]);
        else if (std::ranges::find(known, color) == known.end() && known.size() < 64)
            known.push_back(color);
    }
    const Color background = most_frequent(not_drawn);
    for (Color& color : cells.colors)
        if (color == background || color.alpha() == 0)
            color = no_color;

    // Colors between those of a scene that mixes none.
    const auto read = read_scene(scene);
    const bool is_flat =
        read && !read.value().scene.mixes_colors() && read.value().scene.shade() != Shade::lambert;
    const auto distance = [&](Color a, Color b) {
        const Color p = a == no_color ? background : a;
        const Color q = b == no_color ? background : b;
        return std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) +
               std::abs(p.blue() - q.blue());
    };
    for (Color& color : cells.colors)
        if (is_flat && std::ranges::find(known, color) == known.end()) {
            ++cells.between;
            color = *std::ranges::min_element(known, {},
                                              [&](Color one) { return distance(one, color); });
        }
    return cells;
}

SeenCells cells_of(const Trace& trace) {
    Replay replay(trace);
    replay.go_to(trace.size());
    const Image& image = replay.frame().image;
    return {
        trace.canvas.width, trace.canvas.height, {image.colors().begin(), image.colors().end()}};
}

Diagnosis diagnose(std::span<const DrawnPair> pairs, const DiagnoseOptions& options) {
    return Search(pairs, options).found();
}

} // namespace rastertrace
