// SPDX-License-Identifier: MIT
#include "diagnosis.h"

#include "tell_apart.h"

#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/in_threads.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

namespace rastertrace {

namespace {

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
            pictures_.push_back(*drawn_by({}, pair.scene));
            asked_.push_back(*held_against(pair, {}));
            all_.push_back(all_.size());
        }
        constexpr std::size_t few = 6;
        few_ = all_;
        std::ranges::stable_sort(few_, std::ranges::greater{}, [this](std::size_t i) {
            return std::ranges::count(asked_[i].wrong, true);
        });
        few_.resize(std::min(few_.size(), few));
    }

    Diagnosis found() {
        Diagnosis diagnosis;
        for (const HeldAgainst& held : asked_)
            diagnosis.differing += static_cast<std::uint64_t>(std::ranges::count(held.wrong, true));
        for (const DrawnPair& pair : pairs_)
            diagnosis.between += pair.seen.between;
        if (diagnosis.is_as_asked()) {
            diagnosis.answer.emplace_back();
            return diagnosis;
        }
        for (std::size_t i = 0; i < pairs_.size(); ++i)
            for (std::size_t k = 0; k < pairs_[i].size(); ++k)
                diagnosis.drawn += pairs_[i].claims || pairs_[i].seen.colors[k] != no_color ||
                                   pictures_[i].colors()[k] != no_color;

        std::vector<Tried> tried = try_all(distinct(all_rules()));
        if (const std::uint64_t least = least_of(tried); least > 0) {
            const auto two = try_all(rules_of_two());
            if (!two.empty() && least_of(two) < least)
                tried.insert(tried.end(), two.begin(), two.end());
        }
        std::ranges::stable_sort(tried, {}, &Tried::order);
        const Tried best = tried.front();
        diagnosis.unexplained = best.unexplained;
        if (best.unexplained > 0 && (best.unexplained * 3 > diagnosis.differing ||
                                     best.unexplained * 20 > diagnosis.drawn)) {
            diagnosis.runner_up = best.rule;
            return diagnosis;
        }
        for (const Tried& one : tried)
            if (one.picture == best.picture && one.size() <= best.size())
                add_to_answer(one.rule, diagnosis.answer);
        const auto next = std::ranges::find_if(
            tried, [&](const Tried& one) { return one.is_drawn && one.picture != best.picture; });
        if (next != tried.end()) {
            diagnosis.runner_up = next->rule;
            diagnosis.runner_up_unexplained = next->unexplained;
        }
        if (const auto found = telling_cell(diagnosis)) {
            const auto& [pair, cell] = *found;
            diagnosis.pair = pair;
            diagnosis.pixel = pixel_of(pair, cell);
            if (diagnosis.runner_up)
                diagnosis.rows = telling_rows(diagnosis);
        }
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
        std::set<std::string> seen;
        for (Rule& rule : rules) {
            std::erase_if(rule.settings, [this](const auto& setting) {
                const MethodKey& key = *find_method_key(setting.first);
                return setting.first != "convention" &&
                       std::ranges::all_of(scenes_, [&](const Scene& scene) {
                           return value_in_force(key, scene) == setting.second;
                       });
            });
            if (seen.insert(name_of(rule)).second)
                kept.push_back(std::move(rule));
        }
        return kept;
    }

    static std::uint64_t least_of(const std::vector<Tried>& tried) {
        return std::ranges::min(tried, {}, &Tried::unexplained).unexplained;
    }

    /// All rules on the few pairs that differ the most; those that come near the best of them on all.
    std::vector<Tried> try_all(const std::vector<Rule>& rules) {
        std::vector<Tried> tried = try_on(rules, few_);
        for (const Tried& one : tried)
            if (one.is_drawn && one.rule.mistakes.size() == 1 && one.rule.settings.empty())
                singles_.push_back(one);
        if (few_.size() == pairs_.size() || tried.empty())
            return tried;
        const std::uint64_t least = least_of(tried);
        std::vector<Rule> near_rules;
        for (const Tried& one : tried)
            if (is_near(one, least))
                near_rules.push_back(one.rule);
        return try_on(near_rules, all_);
    }

    /// Settings are drawn in doubles first. Those that come near the best are drawn again in fractions.
    std::vector<Tried> try_on(const std::vector<Rule>& rules,
                              const std::vector<std::size_t>& pairs) const {
        std::vector<Tried> tried(rules.size());
        const auto in_doubles = [](const Rule& rule) {
            return std::ranges::all_of(rule.mistakes,
                                       [](const Mistake* one) { return !one->put_in; });
        };
        in_threads(rules.size(), options_.jobs, [&](std::size_t i, std::size_t) {
            tried[i] = try_one(rules[i], pairs,
                               in_doubles(rules[i]) ? DrawnIn::doubles : DrawnIn::fractions);
        });
        const std::uint64_t least = rules.empty() ? 0 : least_of(tried);
        in_threads(rules.size(), options_.jobs, [&](std::size_t i, std::size_t) {
            if (in_doubles(rules[i]) && is_near(tried[i], least))
                tried[i] = try_one(rules[i], pairs, DrawnIn::fractions);
        });
        return tried;
    }

    static bool is_near(const Tried& one, std::uint64_t least) {
        constexpr std::uint64_t near = 16;
        return one.is_drawn && one.unexplained <= 2 * least + near;
    }

    Tried try_one(const Rule& rule, const std::vector<std::size_t>& pairs, DrawnIn numbers) const {
        Tried tried{.rule = rule, .changes = rule.settings.size(), .is_drawn = true};
        for (const std::size_t i : pairs) {
            const auto held = held_against(pairs_[i], rule, numbers);
            if (!held)
                return {.rule = rule,
                        .changes = rule.settings.size(),
                        .unexplained = std::numeric_limits<std::uint64_t>::max()};
            for (std::size_t k = 0; k < held->wrong.size(); ++k) {
                tried.unexplained += held->wrong[k];
                tried.gain += !held->wrong[k] && asked_[i].wrong[k];
            }
            tried.picture = tried.picture * 31 + held->picture;
        }
        return tried;
    }

    /// Pairs of the mistakes that each draw the most pixels as seen which the scene's own rules do not, and of the few best
    /// ones with any other.
    std::vector<Rule> rules_of_two() const {
        constexpr std::size_t most_gaining = 14;
        constexpr std::size_t best_ones = 3;
        auto by_gain = singles_;
        std::ranges::stable_sort(by_gain, std::ranges::greater{}, &Tried::gain);
        by_gain.resize(std::min(by_gain.size(), most_gaining));
        auto by_order = singles_;
        std::ranges::stable_sort(by_order, {}, &Tried::order);
        by_order.resize(std::min(by_order.size(), best_ones));

        std::vector<Rule> rules;
        std::set<std::pair<std::string_view, std::string_view>> known;
        const auto add = [&](const Tried& one, const Tried& other) {
            const Mistake* const a = one.rule.mistakes.front();
            const Mistake* const b = other.rule.mistakes.front();
            if (a->name != b->name && known.insert(std::minmax(a->name, b->name)).second)
                rules.push_back({{}, {a, b}});
        };
        for (const Tried& one : by_gain)
            for (const Tried& other : by_gain)
                add(one, other);
        for (const Tried& one : by_order)
            for (const Tried& other : singles_)
                add(one, other);
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
            if (are_told_apart(one.rule, rule, method_of(scenes_.front()), seeds))
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

    /// A pixel that is as the answer has it, and neither as the scene asks nor, if possible, as the runner-up has it: of
    /// which pair, and which of its cells.
    std::optional<std::pair<std::size_t, std::size_t>>
    telling_cell(const Diagnosis& diagnosis) const {
        std::optional<std::pair<std::size_t, std::size_t>> found;
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            if (pairs_[i].claims)
                continue;
            const auto by_answer = held_against(pairs_[i], diagnosis.answer.front().rule);
            const auto by_next =
                diagnosis.runner_up ? held_against(pairs_[i], *diagnosis.runner_up) : std::nullopt;
            for (std::size_t cell = 0; cell < asked_[i].wrong.size(); ++cell) {
                if (!asked_[i].wrong[cell] || by_answer->wrong[cell])
                    continue;
                if (!by_next || by_next->wrong[cell])
                    return std::pair(i, cell);
                if (!found)
                    found.emplace(i, cell);
            }
        }
        return found;
    }

    Pixel pixel_of(std::size_t pair, std::size_t cell) const {
        const Canvas& canvas = scenes_[pair].canvas;
        const auto width = static_cast<std::size_t>(canvas.width);
        return {canvas.left() + static_cast<int>(cell % width),
                canvas.y_of(static_cast<int>(cell / width))};
    }

    /// The rows with pixels that are as the answer has them, and not as the runner-up does.
    std::vector<int> telling_rows(const Diagnosis& diagnosis) const {
        const DrawnPair& pair = pairs_[diagnosis.pair];
        const auto by_answer = held_against(pair, diagnosis.answer.front().rule);
        const auto by_next = held_against(pair, *diagnosis.runner_up);
        std::vector<int> rows;
        for (std::size_t cell = 0; cell < by_answer->wrong.size(); ++cell) {
            const int y = pixel_of(diagnosis.pair, cell).y;
            if (!by_answer->wrong[cell] && by_next->wrong[cell] &&
                (rows.empty() || rows.back() != y))
                rows.push_back(y);
        }
        return rows;
    }

    std::span<const DrawnPair> pairs_;
    const DiagnoseOptions& options_;
    std::vector<Scene> scenes_;
    std::vector<Image> pictures_;    ///< as the scenes ask
    std::vector<std::size_t> all_;   ///< the numbers of the pairs
    std::vector<std::size_t> few_;   ///< of those that differ the most
    std::vector<Tried> singles_;     ///< one mistake each, on these
    std::vector<HeldAgainst> asked_; ///< what is seen, held against these
};

} // namespace

Diagnosis diagnose(std::span<const DrawnPair> pairs, const DiagnoseOptions& options) {
    return Search(pairs, options).found();
}

} // namespace rastertrace
