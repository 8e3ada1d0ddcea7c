// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/model/mistakes.h>

#include "model/mistake_tables.h"

#include <algorithm>
#include <utility>

namespace rastertrace {

std::optional<TypedBox> typed_box(const Scene& scene) {
    if (scene.has_transforms() || scene.vertices.empty())
        return std::nullopt;
    const auto range_of = [&scene](auto coordinate) {
        std::vector<Rational> all;
        for (const SceneVertex& vertex : scene.vertices)
            all.push_back((vertex.*coordinate).exact());
        const auto [least, largest] = std::minmax_element(all.begin(), all.end());
        return std::pair{*least, *largest};
    };
    const auto [left, right] = range_of(&SceneVertex::x);
    const auto [low, high] = range_of(&SceneVertex::y);
    return TypedBox{right - left, high - low, std::max<Rational>(abs(left), abs(right))};
}

std::span<const Mistake> mistakes() {
    static const std::vector<Mistake> all = [] {
        std::vector<Mistake> rows;
        for (const auto& part :
             {mistakes_of_rows(), mistakes_of_samples(), mistakes_of_lines(), mistakes_of_space()})
            rows.insert(rows.end(), part.begin(), part.end());
        return rows;
    }();
    return all;
}

const Mistake* find_mistake(std::string_view name) {
    for (const Mistake& mistake : mistakes())
        if (mistake.name == name)
            return &mistake;
    return nullptr;
}

std::vector<const Mistake*> modelled_mistakes(const Scene& scene) {
    std::vector<const Mistake*> made;
    for (const Mistake* const mistake : scene.method.mistakes)
        if (mistake->put_in != nullptr && mistake->concerns(scene))
            made.push_back(mistake);
    return made;
}

} // namespace rastertrace
