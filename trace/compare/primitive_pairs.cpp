// SPDX-License-Identifier: MIT
#include "primitive_pairs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace rastertrace {

namespace {

std::uint64_t mixed(std::uint64_t hash, std::uint64_t more) {
    // The last step of SplitMix64 (Steele, Lea, Flood, Fast splittable pseudorandom number generators, 2014).
    hash = (hash ^ more) + 0x9e3779b97f4a7c15U;
    hash = (hash ^ (hash >> 30U)) * 0xbf58476d1ce4e5b9U;
    hash = (hash ^ (hash >> 27U)) * 0x94d049bb133111ebU;
    return hash ^ (hash >> 31U);
}

/// The same for numbers that are near each other; what is no number counts as it is written.
std::uint64_t hash_of(const TracedNumber& number) {
    constexpr double scale = 1024;
    const auto value = number.nearest_double();
    if (!value || std::abs(*value) > 1e15)
        return std::hash<std::string_view>()(number.json());
    return static_cast<std::uint64_t>(std::llround(*value * scale));
}

/// One of the two lists, and where in the other one each of it is.
struct ListOfPair {
    const std::vector<PrimitivePlace>& primitives;
    std::vector<std::size_t> partner;

    explicit ListOfPair(const std::vector<PrimitivePlace>& list)
        : primitives(list), partner(list.size(), nowhere) {}

    /// Those that are left from one place to another.
    std::vector<std::size_t> left(std::size_t begin, std::size_t end) const {
        std::vector<std::size_t> left;
        for (std::size_t i = begin; i < end; ++i)
            if (partner[i] == nowhere)
                left.push_back(i);
        return left;
    }

    /// Those that are left, by their keys. A key of 0 is none.
    template <typename KeyOf>
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> by_key(const KeyOf& key_of) const {
        std::unordered_map<std::uint64_t, std::vector<std::size_t>> places;
        for (const std::size_t i : left(0, partner.size()))
            if (const std::uint64_t key = key_of(primitives[i]); key != 0)
                places[key].push_back(i);
        return places;
    }
};

class Pairing {
public:
    Pairing(const std::vector<PrimitivePlace>& a, const std::vector<PrimitivePlace>& b)
        : a_(a), b_(b) {}

    /// Pairs those of the same key in order; with `once`, where each list has a single one left.
    template <typename KeyOf> void pair_by(const KeyOf& key_of, bool once) {
        const auto left_b = b_.by_key(key_of);
        for (const auto& [key, of_a] : a_.by_key(key_of)) {
            const auto of_b = left_b.find(key);
            if (of_b == left_b.end() || (once && (of_a.size() > 1 || of_b->second.size() > 1)))
                continue;
            for (std::size_t n = 0; n < std::min(of_a.size(), of_b->second.size()); ++n)
                pair(of_a[n], of_b->second[n]);
        }
    }

    /// Pairs what is left between two pairs that stand in the same order in both lists.
    void pair_in_gaps() {
        const std::vector<bool> stays = in_common_order(a_.partner);
        std::size_t begin_a = 0;
        std::size_t begin_b = 0;
        const std::size_t size_a = a_.partner.size();
        for (std::size_t i = 0; i <= size_a; ++i) {
            if (i < size_a && !stays[i])
                continue;
            const std::size_t end_b = i < size_a ? a_.partner[i] : b_.partner.size();
            pair_most_alike(a_.left(begin_a, i), b_.left(begin_b, end_b));
            begin_a = i + 1;
            begin_b = end_b + 1;
        }
    }

    PrimitivePairs pairs() && { return {std::move(a_.partner), std::move(b_.partner)}; }

private:
    void pair(std::size_t i, std::size_t j) {
        a_.partner[i] = j;
        b_.partner[j] = i;
    }

    /// How much two primitives have in common; 0: nothing that says that they are one.
    static int likeness(const PrimitivePlace& a, const PrimitivePlace& b) {
        constexpr int of_corner = 4;
        constexpr int of_content = 2;
        int score = a.name == b.name ? 1 : 0;
        if (a.corners.size() == b.corners.size())
            for (std::size_t i = 0; i < a.corners.size(); ++i)
                score += a.corners[i] == b.corners[i] ? of_corner : 0;
        return score + (a.content == b.content && a.content != 0 ? of_content : 0);
    }

    /// An alignment of two short lists with the largest sum of likenesses (Needleman, Wunsch, 1970). Long lists, whose
    /// table would take too long, are left to their names.
    void pair_most_alike(const std::vector<std::size_t>& of_a,
                         const std::vector<std::size_t>& of_b) {
        constexpr std::size_t largest_table = 1'000'000;
        if (of_a.empty() || of_b.empty() || of_a.size() > largest_table / of_b.size())
            return;
        const std::size_t columns = of_b.size() + 1;
        std::vector<int> best((of_a.size() + 1) * columns, 0); // of what is left from (i, j) on
        const auto at = [&](std::size_t i, std::size_t j) -> int& { return best[i * columns + j]; };
        const auto paired = [&](std::size_t i, std::size_t j) {
            const int score = likeness(a_.primitives[of_a[i]], b_.primitives[of_b[j]]);
            return score == 0 ? -1 : score + at(i + 1, j + 1);
        };
        for (std::size_t i = of_a.size(); i-- > 0;)
            for (std::size_t j = of_b.size(); j-- > 0;)
                at(i, j) = std::max({paired(i, j), at(i + 1, j), at(i, j + 1)});
        for (std::size_t i = 0, j = 0; i < of_a.size() && j < of_b.size();)
            if (at(i, j) == paired(i, j))
                pair(of_a[i++], of_b[j++]);
            else if (at(i, j) == at(i + 1, j))
                ++i;
            else
                ++j;
    }

    ListOfPair a_;
    ListOfPair b_;
};

std::uint64_t hash_of_name(const PrimitivePlace& one) {
    return mixed(1, std::hash<std::string>()(one.name));
}
std::uint64_t hash_of_corners(const PrimitivePlace& one) {
    std::uint64_t hash = one.corners.size();
    for (const std::uint64_t corner : one.corners)
        hash = mixed(hash, corner);
    return hash;
}

/// Within 0.001, or that part of the larger one.
bool are_near_numbers(const TracedNumber& a, const TracedNumber& b) {
    constexpr double enough = 1e-3;
    const auto of_a = a.nearest_double();
    const auto of_b = b.nearest_double();
    if (!of_a || !of_b)
        return a.json() == b.json();
    return std::abs(*of_a - *of_b) <= enough * std::max({1.0, std::abs(*of_a), std::abs(*of_b)});
}

} // namespace

PrimitivePlace primitive_place(const PrimitiveStep& step, std::size_t begin) {
    PrimitivePlace place{.name = step.name.text(), .begin = begin};
    for (const TracedList<TracedNumber>& corner : step.at.values()) {
        std::uint64_t hash = mixed(std::hash<std::string_view>()(step.kind.json()),
                                   static_cast<std::uint64_t>(step.radius.value_or(0)));
        for (const TracedNumber& number : corner.values())
            hash = mixed(hash, hash_of(number));
        place.corners.push_back(hash);
    }
    return place;
}

bool begin_same_primitive(const PrimitiveStep& a, const PrimitiveStep& b) {
    if (a.kind.text() != b.kind.text() || a.name.text() != b.name.text() ||
        (a.vertices && b.vertices && a.vertices.texts() != b.vertices.texts()))
        return false;
    if (!a.at || !b.at)
        return true;
    const auto all_near = [](const auto& one, const auto& other, const auto& are_alike) {
        return std::equal(one.begin(), one.end(), other.begin(), other.end(), are_alike);
    };
    return all_near(a.at.values(), b.at.values(), [&](const auto& corner, const auto& other) {
        return all_near(corner.values(), other.values(), are_near_numbers);
    });
}

PrimitivePairs pair_primitives(const std::vector<PrimitivePlace>& a,
                               const std::vector<PrimitivePlace>& b) {
    Pairing pairing(a, b);
    pairing.pair_by(
        [](const PrimitivePlace& one) { return mixed(hash_of_name(one), hash_of_corners(one)); },
        false);
    pairing.pair_by(hash_of_corners, false);
    pairing.pair_by(hash_of_name, true);
    pairing.pair_in_gaps();
    pairing.pair_by(hash_of_name, false);
    return std::move(pairing).pairs();
}

std::vector<bool> in_common_order(const std::vector<std::size_t>& places) {
    // The last element of the best sequence of each length so far, and what comes before each element.
    std::vector<std::size_t> ends;
    std::vector<std::size_t> before(places.size(), nowhere);
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i] == nowhere)
            continue;
        const auto longer = std::lower_bound(
            ends.begin(), ends.end(), places[i],
            [&places](std::size_t end, std::size_t place) { return places[end] < place; });
        before[i] = longer == ends.begin() ? nowhere : *(longer - 1);
        if (longer == ends.end())
            ends.push_back(i);
        else
            *longer = i;
    }
    std::vector<bool> stays(places.size(), false);
    for (std::size_t i = ends.empty() ? nowhere : ends.back(); i != nowhere; i = before[i])
        stays[i] = true;
    return stays;
}

} // namespace rastertrace
