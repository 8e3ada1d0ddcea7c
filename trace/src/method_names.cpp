// SPDX-License-Identifier: MIT
#include <rastertrace/trace/method_names.h>

#include <array>
#include <cstddef>

namespace rastertrace {

namespace {

template <typename Enum> struct Word {
    Enum value;
    std::string_view word;
};
template <typename Enum> Word(Enum, std::string_view) -> Word<Enum>;

constexpr std::array scalars{Word{ScalarKind::double_precision, "double"},
                             Word{ScalarKind::exact, "exact"}};
constexpr std::array fills{Word{Fill::scanline, "scanline"}};
constexpr std::array roundings{Word{Rounding::floor, "floor"}, Word{Rounding::nearest, "nearest"},
                               Word{Rounding::truncate, "truncate"},
                               Word{Rounding::inside, "inside"}};
constexpr std::array tie_rules{Word{Ties::start, "start"}, Word{Ties::up, "up"},
                               Word{Ties::away, "away"}, Word{Ties::even, "even"}};
constexpr std::array lerps{Word{LerpForm::direct, "direct"},
                           Word{LerpForm::incremental, "incremental"}};

/// The key that chooses `member`, one of `words`.
template <auto member, const auto& words>
MethodKey key(
    std::string_view name, std::string_view meaning,
    bool (*in_force)(const Method&) = [](const Method&) { return true; }) {
    MethodKey result{.name = name,
                     .meaning = meaning,
                     .values = {},
                     .get =
                         [](const Method& method) {
                             for (const auto& word : words)
                                 if (word.value == method.*member)
                                     return word.word;
                             return std::string_view();
                         },
                     .set =
                         [](Method& method, std::string_view value) {
                             for (const auto& word : words)
                                 if (word.word == value) {
                                     method.*member = word.value;
                                     return true;
                                 }
                             return false;
                         },
                     .in_force = in_force};
    for (const auto& word : words)
        result.values.push_back(word.word);
    return result;
}

} // namespace

std::span<const MethodKey> method_keys() {
    static const std::array keys{
        key<&Method::scalar, scalars>("scalar", "the numbers to draw with"),
        key<&Method::fill, fills>("fill", "the algorithm that fills triangles"),
        key<&Method::rounding, roundings>("rounding", "how a span's ends become pixels"),
        key<&Method::ties, tie_rules>(
            "ties", "where rounding to nearest sends a half",
            [](const Method& method) { return method.rounding == Rounding::nearest; }),
        key<&Method::lerp, lerps>("lerp", "how x is found from row to row"),
    };
    return keys;
}

const MethodKey* find_method_key(std::string_view name) {
    for (const MethodKey& key : method_keys())
        if (key.name == name)
            return &key;
    return nullptr;
}

} // namespace rastertrace
