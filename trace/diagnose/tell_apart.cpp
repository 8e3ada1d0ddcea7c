// SPDX-License-Identifier: MIT
#include "tell_apart.h"

#include <rastertrace/trace/fuzz/shrink.h>
#include <rastertrace/trace/scene/distinguish.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/in_threads.h>

#include <algorithm>
#include <array>
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

/// What a rule draws of a scene, each color in four bytes.
std::optional<std::string> picture_by(const Rule& rule, const Source& scene) {
    const auto image = drawn_by(rule, scene);
    if (!image)
        return std::nullopt;
    std::string picture;
    for (const Color& color : image->colors())
        for (const auto part : {color.red(), color.green(), color.blue(), color.alpha()})
            picture += static_cast<char>(part);
    return picture;
}

/// Random scenes one after the other, held against two rules.
class SearchApart {
public:
    SearchApart(const Rule& a, const Rule& b, const MethodOverrides& method, std::uint64_t seeds)
        : a_(a), b_(b), method_(method), seeds_(seeds) {}

    /// The next one that both draw, and not alike.
    std::optional<FuzzScene> next() {
        return first_to_tell_apart(
            [this]() -> std::optional<FuzzScene> {
                if (seed_ == seeds_)
                    return std::nullopt;
                ++seed_;
                return scene_of_seed(seed_, method_, canvas_of(seed_));
            },
            [this](const FuzzScene& scene) { return pictures_of(scene); });
    }

    Answers pictures_of(const FuzzScene& scene) const {
        const Source source = source_of(scene);
        return {picture_by(a_, source), picture_by(b_, source)};
    }

private:
    const Rule& a_;
    const Rule& b_;
    const MethodOverrides& method_;
    std::uint64_t seeds_;
    std::uint64_t seed_ = 0;
};

} // namespace

bool are_told_apart(const Rule& a, const Rule& b, const MethodOverrides& method,
                    std::uint64_t seeds) {
    return SearchApart(a, b, method, seeds).next().has_value();
}

std::optional<Source> scene_apart(const Rule& a, const Rule& b, const MethodOverrides& method,
                                  std::uint64_t seeds) {
    constexpr std::size_t most_tries = 400;
    SearchApart search(a, b, method, seeds);
    while (const auto scene = search.next()) {
        const auto fails = [&](const FuzzScene& one) {
            return tells_all_apart(search.pictures_of(one));
        };
        const FuzzScene small = shrunk(*scene, fails, most_tries).scene;
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

/// The pictures of each mistake, and of the scene's own rules.
Answers pictures_of_mistakes(const FuzzScene& scene) {
    const Source source = source_of(scene);
    const auto read = read_scene(source);
    const auto as_asked = picture_by({}, source);
    Answers pictures{as_asked};
    for (const Mistake& mistake : mistakes())
        pictures.push_back(read && mistake.concerns(read.value().scene)
                               ? picture_by({{}, {&mistake}}, source)
                               : as_asked);
    return pictures;
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
    const Classes all_alike(mistakes().size() + 1);
    std::vector<Classes> classes_by(candidates, all_alike);
    in_threads(candidates, jobs, [&](std::size_t i, std::size_t) {
        classes_by[i].split(pictures_of_mistakes(scenes[i]));
    });

    // The one that tells the most apart, then the one that tells the most of the rest apart, and so on.
    constexpr std::size_t most_small = 12;
    constexpr std::size_t most_large = 4;
    std::vector<Source> chosen;
    std::size_t small = 0;
    std::size_t large = 0;
    Classes classes = all_alike;
    for (std::size_t count = 1;;) {
        std::size_t best = candidates;
        std::size_t most = count;
        for (std::size_t i = 0; i < candidates; ++i) {
            const bool is_large = i % in_eight == 0;
            if ((is_large ? large : small) == (is_large ? most_large : most_small))
                continue;
            Classes refined = classes;
            if (const std::size_t with = refined.split(classes_by[i]); with > most) {
                most = with;
                best = i;
            }
        }
        if (best == candidates)
            return chosen;
        count = classes.split(classes_by[best]);
        ++(best % in_eight == 0 ? large : small);
        chosen.push_back(source_of(scenes[best]));
    }
}

} // namespace rastertrace
