// SPDX-License-Identifier: MIT
#include "tell_apart.h"

#include <rastertrace/trace/fuzz/shrink.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/in_threads.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace rastertrace {

namespace {

constexpr std::array kinds{FuzzKind::plane, FuzzKind::lines, FuzzKind::depth, FuzzKind::clip};

Source source_of(const FuzzScene& scene) {
    return {"scene.json", scene_json(scene)};
}

/// The random scene of a seed: each kind in turn.
FuzzScene scene_of_seed(std::uint64_t seed, const MethodOverrides& method, int largest_canvas) {
    return random_scene(seed, {.kinds = {kinds[seed % kinds.size()]},
                               .method = method,
                               .largest_canvas = largest_canvas});
}

/// Of pixels far away, and of numbers that overflow, a few scenes are larger.
int canvas_of(std::uint64_t seed) {
    return seed % 8 == 0 ? 64 : 16;
}

/// True if both rules draw a scene, and not alike.
bool are_apart(const Rule& a, const Rule& b, const FuzzScene& scene) {
    const auto by_a = drawn_by(a, source_of(scene));
    const auto by_b = by_a ? drawn_by(b, source_of(scene)) : std::nullopt;
    return by_b && !std::ranges::equal(by_a->colors(), by_b->colors());
}

} // namespace

bool are_told_apart(const Rule& a, const Rule& b, const MethodOverrides& method,
                    std::uint64_t seeds) {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed)
        if (are_apart(a, b, scene_of_seed(seed, method, canvas_of(seed))))
            return true;
    return false;
}

std::optional<Source> scene_apart(const Rule& a, const Rule& b, const MethodOverrides& method,
                                  std::uint64_t seeds) {
    constexpr std::size_t most_tries = 400;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const FuzzScene scene = scene_of_seed(seed, method, canvas_of(seed));
        if (!are_apart(a, b, scene))
            continue;
        const auto fails = [&](const FuzzScene& one) { return are_apart(a, b, one); };
        const FuzzScene small = shrunk(scene, fails, most_tries).scene;
        const std::size_t most = small.kind == FuzzKind::lines ? 2 : 3;
        if (small.primitives.size() <= most)
            return source_of(small);
    }
    return std::nullopt;
}

namespace {

/// The methods that known rules are about.
std::vector<MethodOverrides> probed_methods() {
    return {{},
            {{"fill", "top-left"}},
            {{"rounding", "half-open"}, {"rows", "half-open"}},
            {{"line", "naive"}},
            {{"fill", "barycentric"}, {"depth", "linear-z"}}};
}

/// A number for each mistake, and one for the scene's own rules: the same number where the same is drawn.
std::vector<std::size_t> classes_of(const FuzzScene& scene) {
    const Source source = source_of(scene);
    const auto read = read_scene(source);
    std::map<std::vector<std::uint32_t>, std::size_t> pictures;
    const auto class_of = [&](const Rule& rule) {
        std::vector<std::uint32_t> picture;
        if (const auto image = drawn_by(rule, source))
            for (const Color& color : image->colors())
                picture.push_back(std::uint32_t{color.red()} << 16 |
                                  std::uint32_t{color.green()} << 8 | color.blue() |
                                  std::uint32_t{color.alpha()} << 24);
        return pictures.try_emplace(std::move(picture), pictures.size()).first->second;
    };
    const std::size_t as_asked = class_of({});
    std::vector<std::size_t> classes;
    for (const Mistake& mistake : mistakes())
        classes.push_back(read && mistake.concerns(read.value().scene) ? class_of({{}, {&mistake}})
                                                                       : as_asked);
    classes.push_back(as_asked);
    return classes;
}

/// How many classes there are when both partitions are laid over each other, and which.
std::size_t refine(std::vector<std::size_t>& classes, const std::vector<std::size_t>& by) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> numbers;
    for (std::size_t i = 0; i < classes.size(); ++i)
        classes[i] = numbers.try_emplace({classes[i], by[i]}, numbers.size()).first->second;
    return numbers.size();
}

} // namespace

std::vector<Source> probe_scenes(std::size_t jobs) {
    // Many scenes, and which rules each tells apart. Every eighth is larger.
    constexpr std::size_t candidates = 48;
    constexpr std::size_t in_eight = 8;
    const auto methods = probed_methods();
    std::vector<FuzzScene> scenes;
    for (std::size_t i = 0; i < candidates; ++i)
        scenes.push_back(scene_of_seed(i + 1, methods[i / kinds.size() % methods.size()],
                                       i % in_eight == 0 ? 64 : 32));
    std::vector<std::vector<std::size_t>> partitions(candidates);
    in_threads(candidates, jobs,
               [&](std::size_t i, std::size_t) { partitions[i] = classes_of(scenes[i]); });

    // The one that tells the most apart, then the one that tells the most of the rest apart, and so on.
    constexpr std::size_t most_small = 12;
    constexpr std::size_t most_large = 4;
    std::vector<Source> chosen;
    std::size_t small = 0;
    std::size_t large = 0;
    std::vector<std::size_t> classes(mistakes().size() + 1, 0);
    for (std::size_t count = 1;;) {
        std::size_t best = candidates;
        std::size_t most = count;
        for (std::size_t i = 0; i < candidates; ++i) {
            const bool is_large = i % in_eight == 0;
            if ((is_large ? large : small) == (is_large ? most_large : most_small))
                continue;
            auto refined = classes;
            if (const std::size_t with = refine(refined, partitions[i]); with > most) {
                most = with;
                best = i;
            }
        }
        if (best == candidates)
            return chosen;
        count = refine(classes, partitions[best]);
        ++(best % in_eight == 0 ? large : small);
        chosen.push_back(source_of(scenes[best]));
    }
}

} // namespace rastertrace
