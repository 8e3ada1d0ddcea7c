// SPDX-License-Identifier: MIT
#pragma once

// A polygon in the plane: is it convex, which of its edges meet, and how is it cut into ears (G. H.
// Meisters, Polygons Have Ears, 1975; J. O'Rourke, Computational Geometry in C, chapter 1)?
// Coordinates are whole numbers, and every decision is the sign of one.
//
//     Polygon<std::int64_t> polygon(corners, axis, false);
//     polygon.rank_corners();
//     if (!first_meeting(polygon))
//         for (const auto& [a, b, c] : cut_ears(polygon))  // indices of corners of the polygon

#include <rastertrace/core/numbers/interval.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace rastertrace {

/// What holds a sum of products of two coordinates: Int128 for std::int64_t, or else mpz_class for
/// mpz_class.
template <typename Whole>
using ProductOf = std::conditional_t<std::is_same_v<Whole, std::int64_t>, Int128, Whole>;

/// A face seen along an axis, counter-clockwise. Of successive corners at the same position, it has
/// the first.
template <typename Whole> struct Polygon {
    struct Corner {
        std::array<Whole, 2> at; ///< x and y: positions compare by x first, then by y
        std::size_t index_in_face;
    };
    std::vector<Corner> corners;
    std::vector<std::array<Interval, 2>> filtered = {}; ///< x and y, if `has_filter`
    std::vector<std::size_t> in_order = {};             ///< corners by position; see `rank_corners`
    std::vector<std::size_t> rank = {};                 ///< of each corner in that order

    /// Doubles decide most turns of numbers of any size.
    static constexpr bool has_filter = !std::is_same_v<Whole, std::int64_t>;

    /// Drops the coordinate `axis`; x is axis 0. `from_behind` if the face is clockwise as seen from
    /// the axis's tip.
    Polygon(std::span<const std::array<Whole, 3>> face, std::size_t axis, bool from_behind) {
        const std::size_t x = (axis + (from_behind ? 2 : 1)) % 3;
        const std::size_t y = 3 - axis - x;
        corners.reserve(face.size());
        for (std::size_t i = 0; i < face.size(); ++i)
            if (i == 0 || face[i][x] != face[i - 1][x] || face[i][y] != face[i - 1][y])
                corners.push_back({{face[i][x], face[i][y]}, i});
        while (corners.size() > 1 && corners.back().at == corners.front().at)
            corners.pop_back();
        if constexpr (has_filter)
            for (const auto& [at, index] : corners)
                filtered.push_back({Conversion<Interval>::of(Rational(at[0])),
                                    Conversion<Interval>::of(Rational(at[1]))});
    }

    void rank_corners() {
        in_order.resize(size());
        rank.resize(size());
        std::iota(in_order.begin(), in_order.end(), std::size_t{0});
        std::sort(in_order.begin(), in_order.end(),
                  [&](std::size_t a, std::size_t b) { return is_before(a, b); });
        for (std::size_t k = 0; k < size(); ++k)
            rank[in_order[k]] = k;
    }

    std::size_t size() const { return corners.size(); }
    std::size_t after(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
    std::size_t before(std::size_t i) const { return i == 0 ? size() - 1 : i - 1; }
    const std::array<Whole, 2>& at(std::size_t i) const { return corners[i].at; }

    /// True if a lies to the left of b, or straight below it.
    bool is_before(std::size_t a, std::size_t b) const {
        return at(a)[0] != at(b)[0] ? at(a)[0] < at(b)[0] : at(a)[1] < at(b)[1];
    }

    /// True if the edge from here goes to the right, or straight up.
    bool goes_right(std::size_t i) const { return is_before(i, after(i)); }

    /// A coordinate as the nearest double, limited so that a sum of two is finite. Rounding is
    /// monotonic: of two numbers the one that is less as a double is less.
    double near(std::size_t i, std::size_t axis) const {
        if constexpr (has_filter)
            return filtered[i][axis].is_number()
                       ? std::clamp(filtered[i][axis].middle(), -1e300, 1e300)
                       : sgn(at(i)[axis]) * 1e300;
        else
            return static_cast<double>(at(i)[axis]);
    }

    /// Which way one turns from the direction a to b into the direction c to d: 1 to the left, -1
    /// to the right, 0 straight on or back.
    int turn(std::size_t a, std::size_t b, std::size_t c, std::size_t d) const {
        if constexpr (has_filter) {
            const Interval cross =
                (filtered[b][0] - filtered[a][0]) * (filtered[d][1] - filtered[c][1]) -
                (filtered[b][1] - filtered[a][1]) * (filtered[d][0] - filtered[c][0]);
            if (surely_differ(cross, Interval(0)))
                return cross.low() > 0 ? 1 : -1;
        }
        using Product = ProductOf<Whole>;
        const Product cross = Product(at(b)[0] - at(a)[0]) * (at(d)[1] - at(c)[1]) -
                              Product(at(b)[1] - at(a)[1]) * (at(d)[0] - at(c)[0]);
        return cross > 0 ? 1 : cross < 0 ? -1 : 0;
    }

    /// On which side of the line from a to b a corner lies: 1 left, -1 right, 0 on it.
    int turn(std::size_t a, std::size_t b, std::size_t c) const {
        return c == a || c == b ? 0 : turn(a, b, a, c);
    }
};

/// True if it never turns right, and goes once to the right and once to the left (P. Schorn and F.
/// Fisher, Testing the Convexity of a Polygon, Graphics Gems IV, 1994).
template <typename Whole> bool is_convex(const Polygon<Whole>& polygon) {
    int changes = 0;
    std::size_t before = polygon.size() - 1;
    bool went_right = polygon.goes_right(before);
    for (std::size_t i = 0; i < polygon.size(); before = i++) {
        if (polygon.turn(before, i, polygon.after(i)) < 0)
            return false;
        const bool goes_right = polygon.goes_right(i);
        changes += goes_right != went_right ? 1 : 0;
        went_right = goes_right;
    }
    return changes == 2;
}

/// True if two edges, by the corners at which they begin, have a point in common: neither has both
/// of its ends on one side of the other; on one line, they overlap. Neighbors share their corner:
/// they meet only if the second one turns back.
template <typename Whole>
bool edges_meet(const Polygon<Whole>& polygon, std::size_t i, std::size_t j) {
    const std::size_t to_i = polygon.after(i);
    const std::size_t to_j = polygon.after(j);
    const int begin = polygon.turn(i, to_i, j);
    const int end = polygon.turn(i, to_i, to_j);
    const bool are_in_line = begin == 0 && end == 0;
    if (to_i == j || to_j == i)
        return are_in_line && polygon.goes_right(i) != polygon.goes_right(j);
    if (are_in_line) {
        const auto& [first, last] = std::minmax(polygon.at(i), polygon.at(to_i));
        return std::max(polygon.at(j), polygon.at(to_j)) >= first &&
               std::min(polygon.at(j), polygon.at(to_j)) <= last;
    }
    return begin * end <= 0 && polygon.turn(j, to_j, i) * polygon.turn(j, to_j, to_i) <= 0;
}

/// The bounding box of some corners.
struct CornerBox {
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    std::array<double, 2> low{infinity, infinity};
    std::array<double, 2> high{-infinity, -infinity};

    template <typename Whole>
    void include(const Polygon<Whole>& polygon, std::span<const std::size_t> corners) {
        for (const std::size_t corner : corners)
            for (const std::size_t axis : {0U, 1U}) {
                low[axis] = std::min(low[axis], polygon.near(corner, axis));
                high[axis] = std::max(high[axis], polygon.near(corner, axis));
            }
    }
    bool overlaps(const CornerBox& other) const {
        return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] &&
               other.low[1] <= high[1];
    }
};

/// From one corner of a polygon to another one, or to itself.
using CornerSegment = std::array<std::size_t, 2>;

/// Segments between corners of a polygon, found by where they are: a binary tree whose halves lie
/// beside one another as far as the segments do (J. Goldsmith and J. Salmon, Automatic Creation of
/// Object Hierarchies for Ray Tracing, 1987). A node has the bounding box and the convex hull of
/// its segments: hulls tell slanted chains apart that are close together, boxes do not.
template <typename Whole> class HullTree {
public:
    /// No two segments begin at the same corner.
    HullTree(const Polygon<Whole>& polygon, std::vector<CornerSegment> segments)
        : polygon_(polygon), leaf_of_(polygon.size(), no_node) {
        nodes_.reserve(2 * segments.size());
        if (!segments.empty())
            build(segments, no_node);
    }

    /// Removes the segment that begins at a corner, if there is one. Boxes and hulls stay as they
    /// are.
    void remove(std::size_t corner) {
        for (std::size_t node = std::exchange(leaf_of_[corner], no_node); node != no_node;
             node = nodes_[node].parent)
            --nodes_[node].count;
    }

    /// True if `is_wanted` is true of the corner at which a segment begins. It is not asked of all
    /// segments that lie apart from a shape: a triangle, counter-clockwise, or an edge, by their
    /// corners.
    template <typename IsWanted>
    bool any(std::span<const std::size_t> shape, IsWanted&& is_wanted) const {
        CornerBox box;
        box.include(polygon_, shape);
        return !nodes_.empty() && any(0, shape, box, is_wanted);
    }

private:
    static constexpr std::size_t no_node = std::numeric_limits<std::size_t>::max();
    using Corners = std::span<const std::size_t>;

    struct Node {
        CornerBox box = {};
        std::size_t parent;
        std::size_t count;            ///< of segments that have not been removed
        std::size_t second = no_node; ///< half; the first one follows its parent
        std::size_t corner = 0;       ///< of a leaf: where its segment begins
        /// Where the lower half of the hull begins in `hulls_`, then the upper half, and where that
        /// ends.
        std::array<std::size_t, 3> hull = {};
    };

    void build(std::span<CornerSegment> segments, std::size_t parent) {
        const std::size_t place = nodes_.size();
        Node& node = nodes_.emplace_back(Node{.parent = parent, .count = segments.size()});
        for (const CornerSegment& segment : segments)
            node.box.include(polygon_, segment);
        if (segments.size() == 1) {
            node.corner = segments[0][0];
            leaf_of_[node.corner] = place;
            const auto ends = std::span(segments[0]);
            for (const std::size_t half : {0U, 1U})
                add_half_of_hull(node, half, ends.first(1), ends.last(1));
            return;
        }
        const auto& [low, high] = node.box;
        const std::size_t axis = high[0] - low[0] > high[1] - low[1] ? 0 : 1;
        const auto middle = segments.begin() + static_cast<std::ptrdiff_t>(segments.size() / 2);
        std::nth_element(segments.begin(), middle, segments.end(),
                         [&](const CornerSegment& a, const CornerSegment& b) {
                             return polygon_.near(a[0], axis) + polygon_.near(a[1], axis) <
                                    polygon_.near(b[0], axis) + polygon_.near(b[1], axis);
                         });
        build({segments.begin(), middle}, place);
        node.second = nodes_.size();
        build({middle, segments.end()}, place);
        for (const std::size_t half : {0U, 1U})
            add_half_of_hull(node, half, half_of_hull(nodes_[place + 1], half),
                             half_of_hull(nodes_[node.second], half));
    }

    /// The corners of the lower (0) or upper (1) half of a hull, from the left to the right.
    Corners half_of_hull(const Node& node, std::size_t half) const {
        return Corners(hulls_).subspan(node.hull[half], node.hull[half + 1] - node.hull[half]);
    }

    /// Makes a half of a hull of the same half of two others (A. M. Andrew, Another Efficient
    /// Algorithm for Convex Hulls in Two Dimensions, 1979).
    void add_half_of_hull(Node& node, std::size_t half, Corners one, Corners other) {
        merged_.clear();
        std::set_union(
            one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(merged_),
            [&](std::size_t a, std::size_t b) { return polygon_.rank[a] < polygon_.rank[b]; });
        const int inward = half == 0 ? 1 : -1;
        node.hull[half] = hulls_.size();
        for (const std::size_t corner : merged_) {
            while (hulls_.size() >= node.hull[half] + 2 &&
                   polygon_.turn(hulls_.end()[-2], hulls_.back(), corner) != inward)
                hulls_.pop_back();
            hulls_.push_back(corner);
        }
        node.hull[half + 1] = hulls_.size();
    }

    template <typename IsWanted>
    bool any(std::size_t place, Corners shape, const CornerBox& box, IsWanted& is_wanted) const {
        const Node& node = nodes_[place];
        if (node.count == 0 || !node.box.overlaps(box))
            return false;
        if (node.second == no_node)
            return is_wanted(node.corner);
        std::size_t from = shape.back();
        for (const std::size_t to : shape)
            if (is_right_of(node, std::exchange(from, to), to))
                return false;
        return any(place + 1, shape, box, is_wanted) || any(node.second, shape, box, is_wanted);
    }

    /// True if all of a hull lies to the right of a line. The corner that lies farthest to the left
    /// is where the edges of one half begin to turn away from the line: those before turn to the
    /// left.
    bool is_right_of(const Node& node, std::size_t from, std::size_t to) const {
        const bool goes_left = polygon_.rank[to] < polygon_.rank[from];
        const Corners half = half_of_hull(node, goes_left ? 0 : 1);
        const auto is_right = [&](std::size_t corner) {
            return polygon_.turn(from, to, corner) < 0;
        };
        return is_right(half.front()) && is_right(half.back()) &&
               is_right(*std::partition_point(
                   half.begin(), half.end() - 1, [&](const std::size_t& corner) {
                       return polygon_.turn(from, to, corner, *(&corner + 1)) > 0;
                   }));
    }

    const Polygon<Whole>& polygon_;
    std::vector<std::size_t> leaf_of_; ///< by the corner at which its segment begins
    std::vector<Node> nodes_;
    std::vector<std::size_t> hulls_;
    std::vector<std::size_t> merged_;
};

/// True if no two edges meet. A line sweeps from the left to the right, and the edges that it
/// crosses are kept from the lowest to the highest: two edges that meet are next to each other
/// before they do (M. I. Shamos and D. Hoey, Geometric Intersection Problems, 1976).
template <typename Whole> bool is_simple(const Polygon<Whole>& polygon) {
    const auto ends = [&](std::size_t edge) { // the left one first
        const std::size_t to = polygon.after(edge);
        return polygon.rank[edge] < polygon.rank[to] ? std::pair(edge, to) : std::pair(to, edge);
    };
    // On which side of edge a the edge b begins, or else ends: 1 above it. It begins no earlier.
    const auto side_of = [&](std::size_t a, std::size_t b) {
        const auto [from, to] = ends(a);
        const int begin = polygon.turn(from, to, ends(b).first);
        return begin != 0 ? begin : polygon.turn(from, to, ends(b).second);
    };
    const auto is_below = [&](std::size_t a, std::size_t b) {
        const bool begins_later = polygon.rank[ends(b).first] < polygon.rank[ends(a).first];
        const int side = a == b ? 0 : begins_later ? -side_of(b, a) : side_of(a, b);
        return side != 0 ? side > 0 : a < b;
    };
    std::set<std::size_t, decltype(is_below)> crossed(is_below);
    std::vector<decltype(crossed.begin())> place_in_crossed(polygon.size());
    const auto meets_next_below = [&](auto edge) {
        return edge != crossed.begin() && edge != crossed.end() &&
               edges_meet(polygon, *std::prev(edge), *edge);
    };

    const auto is_same = [&](std::size_t a, std::size_t b) {
        return polygon.at(a) == polygon.at(b);
    };
    const auto& corners = polygon.in_order;
    if (std::adjacent_find(corners.begin(), corners.end(), is_same) != corners.end())
        return false;
    for (const std::size_t corner : corners) {
        const std::array edges{polygon.before(corner), corner};
        for (const std::size_t edge : edges)
            if (ends(edge).first == corner) {
                const auto here = crossed.insert(edge).first;
                place_in_crossed[edge] = here;
                if (meets_next_below(here) || meets_next_below(std::next(here)))
                    return false;
            }
        for (const std::size_t edge : edges)
            if (ends(edge).second == corner &&
                meets_next_below(crossed.erase(place_in_crossed[edge])))
                return false;
    }
    return true;
}

/// Two edges that meet, by the corners at which they begin: the first edge that meets another one
/// which begins later, and the first of those. `nullopt` if the polygon is simple.
template <typename Whole>
std::optional<std::array<std::size_t, 2>> first_meeting(const Polygon<Whole>& polygon) {
    if (is_simple(polygon))
        return std::nullopt;
    std::vector<CornerSegment> edges;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        edges.push_back({i, polygon.after(i)});
    HullTree<Whole> later(polygon, edges);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        later.remove(i);
        std::size_t first = polygon.size();
        later.any(edges[i], [&](std::size_t j) {
            if (j < first && edges_meet(polygon, i, j))
                first = j;
            return false;
        });
        if (first < polygon.size())
            return std::array{i, first};
    }
    return std::nullopt;
}

/// Cuts a simple polygon into ears: the corner before each, the ear and the corner after it, in the
/// order in which they are cut. The last triangle is what is left. The corners wait in a queue. If
/// the first one is an ear, it is cut, and its two neighbors move to the end of the queue: so cuts
/// are spread all around. No other corner becomes an ear by that, or ceases to be one.
template <typename Whole>
std::vector<std::array<std::size_t, 3>> cut_ears(const Polygon<Whole>& polygon) {
    std::vector<std::size_t> before(polygon.size());
    std::vector<std::size_t> after(polygon.size());
    const auto turn_at = [&](std::size_t i) { return polygon.turn(before[i], i, after[i]); };
    std::vector<CornerSegment> reflex_corners;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        before[i] = polygon.before(i);
        after[i] = polygon.after(i);
        if (turn_at(i) <= 0)
            reflex_corners.push_back({i, i});
    }
    HullTree<Whole> reflex(polygon, std::move(reflex_corners));

    // At an ear, the polygon turns left, and no other corner lies in the triangle of the ear and
    // its neighbors, borders included. If any does, a reflex corner does.
    const auto is_ear = [&](std::size_t b) {
        const std::size_t a = before[b];
        const std::size_t c = after[b];
        return turn_at(b) > 0 && !reflex.any(std::array{a, b, c}, [&](std::size_t i) {
            return i != a && i != c && polygon.turn(a, b, i) >= 0 && polygon.turn(b, c, i) >= 0 &&
                   polygon.turn(c, a, i) >= 0;
        });
    };

    std::vector<std::size_t> queue(polygon.size());
    std::iota(queue.begin(), queue.end(), std::size_t{0});
    std::vector<std::size_t> place_in_queue = queue;
    std::vector<std::array<std::size_t, 3>> ears;
    std::size_t last = 0;
    for (std::size_t i = 0; ears.size() + 3 < polygon.size(); ++i) {
        assert(i < queue.size() && "a simple polygon has two ears (Meisters)");
        const std::size_t ear = queue[i];
        if (place_in_queue[ear] != i || !is_ear(ear))
            continue;
        ears.push_back({before[ear], ear, after[ear]});
        last = after[ear];
        after[before[ear]] = last;
        before[last] = before[ear];
        for (const std::size_t neighbor : {before[ear], last}) {
            place_in_queue[neighbor] = queue.size();
            queue.push_back(neighbor);
            if (turn_at(neighbor) > 0)
                reflex.remove(neighbor);
        }
    }

    // The last three, from the first of them on.
    const std::size_t first = std::min({last, after[last], before[last]});
    ears.push_back({first, after[first], before[first]});
    return ears;
}

} // namespace rastertrace
