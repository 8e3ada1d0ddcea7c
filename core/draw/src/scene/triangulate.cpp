// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/scene/triangulate.h>
#include <rastertrace/core/numbers/adaptive.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>
#include <span>
#include <tuple>
#include <utility>

namespace rastertrace {

namespace {

// A face's numbers, written over one denominator, are whole. `Whole` holds one of them, `Product` a sum of
// products of two. Nearly all meshes do with std::int64_t for both. Others need Int128 for the products, or
// mpz_class for both.

/// Coordinates in std::int64_t have at most this many bits: then a product of three fits in two times
/// Int128 (height_of).
constexpr int most_bits_of_grid = 59;

/// Twice the area in each of the three planes: the sum of (y1 - y2)(z1 + z2) over all edges, and so on
/// (M. E. Newell, in Sutherland, Sproull and Schumacker, A Characterization of Ten Hidden-Surface
/// Algorithms, 1974).
template <typename Product, typename Whole>
std::array<Product, 3> newells_normal(std::span<const std::array<Whole, 3>> corners) {
    std::array<Product, 3> normal{};
    const auto* from = &corners.back();
    for (const auto& to : corners) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t y = (axis + 1) % 3;
            const std::size_t z = (axis + 2) % 3;
            const Whole difference = (*from)[y] - to[y];
            const Whole sum = (*from)[z] + to[z];
            normal[axis] += Product(difference) * sum;
        }
        from = &to;
    }
    return normal;
}

/// The axis of the normal's largest component; of equal ones z, then y.
template <typename Number> std::size_t largest_axis(const std::array<Number, 3>& normal) {
    const auto size = [&normal](std::size_t axis) -> Number {
        return normal[axis] < 0 ? Number(-normal[axis]) : normal[axis];
    };
    std::size_t largest = 2;
    for (const std::size_t axis : {std::size_t{1}, std::size_t{0}})
        if (size(axis) > size(largest))
            largest = axis;
    return largest;
}

/// normal . (to - from), for each kind of normal.
Int128 height_of(const std::array<std::int64_t, 3>& to, const std::array<std::int64_t, 3>& from,
                 const std::array<std::int64_t, 3>& normal) {
    return Int128{normal[0]} * (to[0] - from[0]) + Int128{normal[1]} * (to[1] - from[1]) +
           Int128{normal[2]} * (to[2] - from[2]);
}

/// As a double that is 0 only if the product is.
double height_of(const std::array<std::int64_t, 3>& to, const std::array<std::int64_t, 3>& from,
                 const std::array<Int128, 3>& normal) {
    // The product has up to 192 bits: the upper half of the normal is multiplied by itself.
    Int128 upper = 0;
    Int128 lower = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Int128 way = to[axis] - from[axis];
        upper += static_cast<std::int64_t>(normal[axis] >> 64) * way;
        lower += static_cast<Int128>(static_cast<std::uint64_t>(normal[axis])) * way;
    }
    // What then remains of the lower half is at most half a unit of the upper one: they cannot cancel.
    const auto rest = static_cast<std::int64_t>(lower);
    upper += (lower - rest) >> 64;
    return static_cast<double>(upper) * 0x1p64 + static_cast<double>(rest);
}
mpz_class height_of(const std::array<mpz_class, 3>& to, const std::array<mpz_class, 3>& from,
                    const std::array<mpz_class, 3>& normal) {
    return normal[0] * (to[0] - from[0]) + normal[1] * (to[1] - from[1]) +
           normal[2] * (to[2] - from[2]);
}

/// span / (|normal| denominator).
template <typename Height, typename Product>
double length_along(const std::array<Product, 3>& normal, const Height& span,
                    std::int64_t denominator) {
    const Vec<double, 3> n{static_cast<double>(normal[0]), static_cast<double>(normal[1]),
                           static_cast<double>(normal[2])};
    return static_cast<double>(span) / (std::sqrt(dot(n, n)) * static_cast<double>(denominator));
}

/// The same of numbers that may be no doubles: each is one below 1 times a power of two.
double length_along(const std::array<mpz_class, 3>& normal, const mpz_class& span,
                    const mpz_class& denominator) {
    std::array<double, 3> components{};
    std::array<long, 3> powers{};
    for (std::size_t i = 0; i < 3; ++i)
        components[i] = mpz_get_d_2exp(&powers[i], normal[i].get_mpz_t());
    const long power = *std::max_element(powers.begin(), powers.end());
    double square = 0;
    for (std::size_t i = 0; i < 3; ++i)
        square += std::pow(std::scalbln(components[i], powers[i] - power), 2);
    long of_span = 0;
    long of_denominator = 0;
    const double quotient = mpz_get_d_2exp(&of_span, span.get_mpz_t()) /
                            mpz_get_d_2exp(&of_denominator, denominator.get_mpz_t());
    return std::scalbln(quotient / std::sqrt(square), of_span - of_denominator - power);
}

/// How far the corners lie apart along the normal.
template <typename Whole, typename Product>
void measure_plane(std::span<const std::array<Whole, 3>> corners,
                   const std::array<Product, 3>& normal, const Whole& denominator,
                   Triangulation& result) {
    using Height = decltype(height_of(corners[0], corners[0], normal));
    Height lowest = 0;
    Height highest = 0;
    for (const auto& corner : corners.subspan(1)) {
        const Height height = height_of(corner, corners[0], normal);
        if (height < lowest)
            lowest = height;
        if (height > highest)
            highest = height;
    }
    result.is_planar = lowest == highest;
    if (!result.is_planar)
        result.off_plane = length_along(normal, Height(highest - lowest), denominator) / 2;
}

/// A double that a whole number is near to.
Adaptive near_to(const mpz_class& number) {
    const double cut_off = number.get_d(); // by less than a unit in its last place
    return number == cut_off ? Adaptive(cut_off)
                             : Adaptive(cut_off, std::abs(cut_off) * 2 * Adaptive::half_ulp);
}

/// A face as seen along its normal, from where it is counter-clockwise. Corners at the place of the one before
/// are left out.
template <typename Whole> struct Polygon {
    std::span<const std::array<Whole, 3>> corners; ///< of the face
    std::size_t horizontal;                        ///< the coordinate that is x here
    std::size_t vertical;                          ///< and y
    std::vector<std::size_t> places;               ///< in the face: of the corners that it has
    std::vector<std::array<Adaptive, 2>> near;     ///< their x and y; none of std::int64_t

    std::size_t size() const { return places.size(); }
    std::size_t after(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
    std::size_t before(std::size_t i) const { return i == 0 ? size() - 1 : i - 1; }
    const Whole& x(std::size_t i) const { return corners[places[i]][horizontal]; }
    const Whole& y(std::size_t i) const { return corners[places[i]][vertical]; }

    /// True if the edge from here goes to the right, or straight up.
    bool goes_right(std::size_t i) const {
        const std::size_t to = after(i);
        return x(i) != x(to) ? x(i) < x(to) : y(i) < y(to);
    }

    /// Which way three corners turn: 1 to the left, -1 to the right, 0 straight on or back.
    int turn(std::size_t a, std::size_t b, std::size_t c) const { return turn(a, b, c, c); }

    /// The same for a third place that has its x from one corner and its y from another.
    int turn(std::size_t a, std::size_t b, std::size_t column, std::size_t row) const {
        if constexpr (std::same_as<Whole, std::int64_t>) {
            const Int128 cross =
                Int128{x(b) - x(a)} * (y(row) - y(a)) - Int128{y(b) - y(a)} * (x(column) - x(a));
            return cross < 0 ? -1 : cross > 0 ? 1 : 0;
        } else {
            // Doubles decide most of them.
            const auto order = order_of((near[b][0] - near[a][0]) * (near[row][1] - near[a][1]),
                                        (near[b][1] - near[a][1]) * (near[column][0] - near[a][0]));
            if (order)
                return *order < 0 ? -1 : *order > 0 ? 1 : 0;
            return sgn(Whole((x(b) - x(a)) * (y(row) - y(a)) - (y(b) - y(a)) * (x(column) - x(a))));
        }
    }
};

/// Drops an axis.
template <typename Whole>
void see_along(std::size_t axis, bool from_behind, std::span<const std::array<Whole, 3>> corners,
               Polygon<Whole>& polygon) {
    const std::size_t x = (axis + (from_behind ? 2 : 1)) % 3;
    const std::size_t y = (axis + (from_behind ? 1 : 2)) % 3;
    polygon.corners = corners;
    polygon.horizontal = x;
    polygon.vertical = y;

    // Of neighbors at one place, the first stays.
    const auto is_at = [&](std::size_t i, std::size_t k) {
        return corners[i][x] == corners[k][x] && corners[i][y] == corners[k][y];
    };
    std::vector<std::size_t>& places = polygon.places;
    places.resize(corners.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (i == 0 || !is_at(i, i - 1))
            places[count++] = i;
    while (count > 1 && is_at(0, places[count - 1]))
        --count;
    places.resize(count);

    if constexpr (!std::same_as<Whole, std::int64_t>)
        for (const std::size_t place : places)
            polygon.near.push_back({near_to(corners[place][x]), near_to(corners[place][y])});
}

/// True if it never turns right, and goes once to the right and once to the left (P. Schorn and F. Fisher,
/// Testing the Convexity of a Polygon, Graphics Gems IV, 1994).
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

/// The places of a point among all, from the left and from below: whether two boxes overlap is asked many
/// times, and does not hang on the numbers.
struct Rank {
    std::uint32_t x = 0;
    std::uint32_t y = 0;
};

template <typename Whole> std::vector<Rank> ranks_of(const Polygon<Whole>& polygon) {
    std::vector<Rank> ranks(polygon.size());
    std::vector<std::size_t> sorted(polygon.size());
    const auto rank = [&](std::size_t coordinate, std::uint32_t Rank::*rank_of) {
        const auto is_less = [&](std::size_t a, std::size_t b) {
            return polygon.corners[polygon.places[a]][coordinate] <
                   polygon.corners[polygon.places[b]][coordinate];
        };
        std::iota(sorted.begin(), sorted.end(), std::size_t{0});
        std::sort(sorted.begin(), sorted.end(), is_less);
        for (std::size_t i = 1; i < sorted.size(); ++i)
            ranks[sorted[i]].*rank_of =
                ranks[sorted[i - 1]].*rank_of + (is_less(sorted[i - 1], sorted[i]) ? 1 : 0);
    };
    rank(polygon.horizontal, &Rank::x);
    rank(polygon.vertical, &Rank::y);
    return ranks;
}

/// A rectangle around some points, borders included.
struct RankBox {
    Rank low;
    Rank high;

    explicit RankBox(std::initializer_list<Rank> points) : low(*points.begin()), high(low) {
        for (const Rank& point : points) {
            low = {std::min(low.x, point.x), std::min(low.y, point.y)};
            high = {std::max(high.x, point.x), std::max(high.y, point.y)};
        }
    }
    bool overlaps(const RankBox& other) const {
        return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y &&
               other.low.y <= high.y;
    }
    void include(const RankBox& other) { *this = RankBox{low, high, other.low, other.high}; }
};

/// Boxes, found by where they are: a binary tree, whose halves lie beside one another as far as the boxes do
/// (J. Goldsmith and J. Salmon, Automatic Creation of Object Hierarchies for Ray Tracing, 1987).
class BoxTree {
public:
    /// Box i of these is called names[i].
    BoxTree(const std::vector<RankBox>& boxes, std::vector<std::size_t> names)
        : names_(std::move(names)),
          leaf_of_(names_.empty() ? 0 : 1 + *std::max_element(names_.begin(), names_.end())) {
        if (boxes.empty())
            return;
        std::vector<std::size_t> order(boxes.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        nodes_.reserve(2 * boxes.size());
        build(boxes, order, no_node);
    }

    void remove(std::size_t name) {
        for (std::size_t node = leaf_of_[name]; node != no_node; node = nodes_[node].parent)
            --nodes_[node].count;
    }

    /// True if `is_wanted` is true of a box, by its name. Boxes are passed over that lie in one of which `may_have` is
    /// false.
    template <typename MayHave, typename IsWanted>
    bool any(MayHave&& may_have, IsWanted&& is_wanted) const {
        return !nodes_.empty() && any(0, may_have, is_wanted);
    }

private:
    static constexpr std::size_t no_node = std::numeric_limits<std::size_t>::max();

    struct Node {
        RankBox box;
        std::size_t parent;
        std::size_t count;            ///< of boxes that have not been removed
        std::size_t second = no_node; ///< half; the first one follows its parent
        std::size_t name = 0;         ///< of a leaf
    };

    std::size_t build(const std::vector<RankBox>& boxes, std::span<std::size_t> order,
                      std::size_t parent) {
        const std::size_t place = nodes_.size();
        RankBox all = boxes[order.front()];
        for (const std::size_t i : order)
            all.include(boxes[i]);
        nodes_.push_back({.box = all, .parent = parent, .count = order.size()});
        if (order.size() == 1) {
            nodes_[place].name = names_[order.front()];
            leaf_of_[nodes_[place].name] = place;
            return place;
        }
        const bool is_wide = all.high.x - all.low.x > all.high.y - all.low.y;
        const auto middle_of = [&](std::size_t i) {
            const RankBox& box = boxes[i];
            return is_wide ? std::uint64_t{box.low.x} + box.high.x
                           : std::uint64_t{box.low.y} + box.high.y;
        };
        const std::size_t half = order.size() / 2;
        std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(half),
                         order.end(),
                         [&](std::size_t a, std::size_t b) { return middle_of(a) < middle_of(b); });
        build(boxes, order.first(half), place);
        const std::size_t second = build(boxes, order.subspan(half), place);
        nodes_[place].second = second;
        return place;
    }

    template <typename MayHave, typename IsWanted>
    bool any(std::size_t place, MayHave& may_have, IsWanted& is_wanted) const {
        const Node& node = nodes_[place];
        if (node.count == 0 || !may_have(node.box))
            return false;
        if (node.second == no_node)
            return is_wanted(node.name);
        return any(place + 1, may_have, is_wanted) || any(node.second, may_have, is_wanted);
    }

    std::vector<std::size_t> names_;
    std::vector<std::size_t> leaf_of_; ///< by name
    std::vector<Node> nodes_;
};

/// True if two edges whose boxes overlap have a point in common: neither has both of its ends on one side
/// of the other.
template <typename Whole>
bool edges_meet(const Polygon<Whole>& polygon, std::size_t i, std::size_t j) {
    const std::size_t to_i = polygon.after(i);
    const std::size_t to_j = polygon.after(j);
    return polygon.turn(i, to_i, j) * polygon.turn(i, to_i, to_j) <= 0 &&
           polygon.turn(j, to_j, i) * polygon.turn(j, to_j, to_i) <= 0;
}

template <typename Whole>
bool are_neighbors(const Polygon<Whole>& polygon, std::size_t i, std::size_t j) {
    return polygon.after(i) == j || polygon.after(j) == i;
}

/// True if no edges meet that are no neighbors; neighbors may have only their corner in common. A line goes from the
/// left to the right, and those that it crosses are kept from the lowest to the highest: two edges that meet lie side
/// by side before they do (M. I. Shamos and D. Hoey, Geometric Intersection Problems, 1976).
template <typename Whole>
bool has_no_meeting(const Polygon<Whole>& polygon, const std::vector<Rank>& ranks) {
    const auto is_before = [&ranks](std::size_t a, std::size_t b) {
        return std::pair(ranks[a].x, ranks[a].y) < std::pair(ranks[b].x, ranks[b].y);
    };
    const auto left_end = [&](std::size_t edge) {
        return is_before(edge, polygon.after(edge)) ? edge : polygon.after(edge);
    };
    const auto right_end = [&](std::size_t edge) {
        return is_before(edge, polygon.after(edge)) ? polygon.after(edge) : edge;
    };
    /// Where b lies, as seen from a, which begins no later: 1 above it.
    const auto side_of = [&](std::size_t a, std::size_t b) {
        const int begin = polygon.turn(left_end(a), right_end(a), left_end(b));
        return begin != 0 ? begin : polygon.turn(left_end(a), right_end(a), right_end(b));
    };
    const auto is_below = [&](std::size_t a, std::size_t b) {
        if (a == b)
            return false;
        const int side = is_before(left_end(b), left_end(a)) ? -side_of(b, a) : side_of(a, b);
        return side != 0 ? side > 0 : a < b;
    };

    // At one corner, edges begin before others end.
    std::vector<std::pair<std::size_t, bool>> events;
    for (std::size_t edge = 0; edge < polygon.size(); ++edge)
        for (const bool ends : {false, true})
            events.emplace_back(edge, ends);
    const auto place_of = [&](const std::pair<std::size_t, bool>& event) {
        return event.second ? right_end(event.first) : left_end(event.first);
    };
    std::sort(events.begin(), events.end(), [&](const auto& a, const auto& b) {
        const Rank& one = ranks[place_of(a)];
        const Rank& other = ranks[place_of(b)];
        return std::tuple(one.x, one.y, a.second, a.first) <
               std::tuple(other.x, other.y, b.second, b.first);
    });

    const auto meet = [&](std::size_t i, std::size_t j) {
        return !are_neighbors(polygon, i, j) &&
               RankBox{ranks[i], ranks[polygon.after(i)]}.overlaps(
                   RankBox{ranks[j], ranks[polygon.after(j)]}) &&
               edges_meet(polygon, i, j);
    };
    std::set<std::size_t, decltype(is_below)> crossed(is_below);
    std::vector<decltype(crossed.begin())> place_in_crossed(polygon.size());
    for (const auto& [edge, ends] : events) {
        if (!ends) {
            const auto [here, is_new] = crossed.insert(edge);
            if (!is_new)
                return false;
            place_in_crossed[edge] = here;
            if ((here != crossed.begin() && meet(*std::prev(here), edge)) ||
                (std::next(here) != crossed.end() && meet(edge, *std::next(here))))
                return false;
            continue;
        }
        const auto above = crossed.erase(place_in_crossed[edge]);
        if (above != crossed.begin() && above != crossed.end() && meet(*std::prev(above), *above))
            return false;
    }
    return true;
}

/// The first edge that meets another one which begins later, and the first of those. None: the polygon is
/// simple.
template <typename Whole>
std::optional<std::array<std::size_t, 2>> first_meeting(const Polygon<Whole>& polygon,
                                                        const std::vector<Rank>& ranks) {
    std::optional<std::array<std::size_t, 2>> first;
    const auto note = [&first](std::size_t i, std::size_t j) {
        const std::array<std::size_t, 2> found{std::min(i, j), std::max(i, j)};
        first = std::min(first.value_or(found), found);
    };

    // Neighbors share a corner. They have more in common only if the second one turns back.
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const std::size_t before = polygon.before(i);
        if (polygon.goes_right(before) != polygon.goes_right(i) &&
            polygon.turn(before, i, polygon.after(i)) == 0)
            note(before, i);
    }

    if (!first && has_no_meeting(polygon, ranks))
        return std::nullopt;

    // Each of the others is compared with those that begin later.
    std::vector<RankBox> boxes;
    std::vector<std::size_t> names(polygon.size());
    std::iota(names.begin(), names.end(), std::size_t{0});
    for (const std::size_t i : names)
        boxes.push_back(RankBox{ranks[i], ranks[polygon.after(i)]});
    BoxTree later(boxes, names);
    for (std::size_t i = 0; i < polygon.size() && (!first || i <= first->front()); ++i) {
        later.remove(i);
        later.any([&](const RankBox& box) { return box.overlaps(boxes[i]); },
                  [&](std::size_t j) {
                      if (!are_neighbors(polygon, i, j) && edges_meet(polygon, i, j))
                          note(i, j);
                      return false;
                  });
    }
    return first;
}

/// What is left of a polygon while its ears are cut.
template <typename Whole> class EarCutter {
public:
    EarCutter(const Polygon<Whole>& polygon, std::vector<Rank> ranks)
        : polygon_(polygon), ranks_(std::move(ranks)), columns_(polygon.size()),
          rows_(polygon.size()), before_(polygon.size()), after_(polygon.size()),
          is_reflex_(polygon.size()) {
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            before_[i] = polygon.before(i);
            after_[i] = polygon.after(i);
            columns_[ranks_[i].x] = i;
            rows_[ranks_[i].y] = i;
        }
    }

    /// The corners stand in a line, the first one in front. The one in front leaves the line; if it is an
    /// ear, it is cut, and its two neighbors go to the end of the line: so cuts are spread all around.
    /// No other corner becomes an ear by that, or ceases to be one.
    std::vector<std::array<std::size_t, 3>> cut() {
        const std::size_t count = polygon_.size();
        std::vector<std::size_t> line(count);
        std::iota(line.begin(), line.end(), std::size_t{0});
        std::vector<std::size_t> place_in_line = line;
        std::vector<std::size_t> reflex;
        std::vector<RankBox> places;
        for (std::size_t i = 0; i < count; ++i)
            if (!turns_left(i)) {
                reflex.push_back(i);
                places.push_back(RankBox{ranks_[i]});
                is_reflex_[i] = true;
            }
        reflex_ = BoxTree(places, std::move(reflex));

        std::vector<std::array<std::size_t, 3>> ears;
        ears.reserve(count - 2);
        std::size_t last = 0;
        for (std::size_t i = 0; ears.size() + 3 < count; ++i) {
            assert(i < line.size() && "a simple polygon has two ears (Meisters)");
            const std::size_t corner = line[i];
            if (place_in_line[corner] != i || !is_ear(corner))
                continue;
            ears.push_back({before_[corner], corner, after_[corner]});
            after_[before_[corner]] = after_[corner];
            before_[after_[corner]] = before_[corner];
            for (const std::size_t neighbor : {before_[corner], after_[corner]}) {
                place_in_line[neighbor] = line.size();
                line.push_back(neighbor);
                if (is_reflex_[neighbor] && turns_left(neighbor)) {
                    is_reflex_[neighbor] = false;
                    reflex_.remove(neighbor);
                }
            }
            last = after_[corner];
        }

        // The last three, from the first of them on.
        const std::size_t first = std::min({last, after_[last], before_[last]});
        ears.push_back({first, after_[first], before_[first]});
        return ears;
    }

private:
    bool turns_left(std::size_t corner) const {
        return polygon_.turn(before_[corner], corner, after_[corner]) > 0;
    }

    /// True if the polygon turns left there, and no other corner lies in the triangle of this one and its
    /// neighbors, or on the edge that cutting it leaves. Only those that do not turn left need to be asked.
    bool is_ear(std::size_t corner) const {
        const std::size_t a = before_[corner];
        const std::size_t c = after_[corner];
        if (!turns_left(corner))
            return false;
        const RankBox box{ranks_[a], ranks_[corner], ranks_[c]};
        return !reflex_.any(
            [&](const RankBox& other) {
                return other.overlaps(box) && reaches_left_of(a, corner, other) &&
                       reaches_left_of(corner, c, other) && reaches_left_of(c, a, other);
            },
            [&](std::size_t other) {
                return other != a && other != c && polygon_.turn(a, corner, other) >= 0 &&
                       polygon_.turn(corner, c, other) >= 0 && polygon_.turn(c, a, other) >= 0;
            });
    }

    /// True if a part of a box lies to the left of the line from a to b, or on it.
    bool reaches_left_of(std::size_t a, std::size_t b, const RankBox& box) const {
        const Rank farthest{ranks_[a].y < ranks_[b].y ? box.low.x : box.high.x,
                            ranks_[a].x < ranks_[b].x ? box.high.y : box.low.y};
        return polygon_.turn(a, b, columns_[farthest.x], rows_[farthest.y]) >= 0;
    }

    const Polygon<Whole>& polygon_;
    std::vector<Rank> ranks_;
    std::vector<std::size_t> columns_; ///< a corner for each place from the left
    std::vector<std::size_t> rows_;    ///< and from below
    std::vector<std::size_t> before_;
    std::vector<std::size_t> after_;
    std::vector<bool> is_reflex_; ///< of each corner: it does not turn left
    BoxTree reflex_{{}, {}};      ///< those corners
};

mpz_class whole(Int128 number) {
    return exact(Fraction128(number)).get_num();
}
const mpz_class& whole(const mpz_class& number) {
    return number;
}

/// A vector over the square of a denominator.
template <typename Number>
Vec<Rational, 3> divided(const std::array<Number, 3>& vector, const mpz_class& denominator) {
    const mpz_class square = denominator * denominator;
    const auto quotient = [&](std::size_t i) {
        Rational number(whole(vector[i]), square);
        number.canonicalize();
        return number;
    };
    return {quotient(0), quotient(1), quotient(2)};
}

/// Newell's normal; its largest component is dropped; convex? then the fan; simple? then ears.
template <typename Product, typename Whole>
Triangulation cut_face(std::span<const std::array<Whole, 3>> corners, const Whole& denominator,
                       Polygon<Whole>& polygon) {
    Triangulation result;
    const auto normal = newells_normal<Product>(corners);
    const std::size_t axis = largest_axis(normal);
    if (normal[axis] == 0) {
        result.form = FaceForm::no_area;
        return result;
    }
    measure_plane(corners, normal, denominator, result);

    see_along(axis, normal[axis] < 0, corners, polygon);
    if (is_convex(polygon))
        return result;

    std::vector<Rank> ranks = ranks_of(polygon);
    if (const auto meeting = first_meeting(polygon, ranks)) {
        result.form = FaceForm::crossed;
        result.meeting = {polygon.places[meeting->front()], polygon.places[meeting->back()]};
        return result;
    }

    result.form = FaceForm::concave;
    result.ears = {.normal = divided(normal, denominator),
                   .dropped = axis,
                   .triangles = EarCutter(polygon, std::move(ranks)).cut()};
    for (auto& triangle : result.ears->triangles)
        for (std::size_t& corner : triangle)
            corner = polygon.places[corner];
    return result;
}

/// The coordinates of a vertex.
std::array<const Number*, 3> coordinates_of(const SceneVertex& vertex) {
    return {&vertex.x, &vertex.y, &vertex.z};
}

/// Three numbers over the denominator of a face.
using WidePoint3 = std::array<mpz_class, 3>;
struct WideCorners {
    std::vector<WidePoint3> corners;
    mpz_class denominator = 1;
};

mpz_class power_of_ten_of_any_size(int exponent) {
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(exponent));
    return power;
}

/// The corners of a face over the least denominator that all of its fractions have, and a power of ten for
/// its decimals. No corners if that has too many bits.
WideCorners over_one_denominator(std::span<const SceneVertex> vertices,
                                 std::span<const std::size_t> face) {
    int places = 0; // behind the point
    mpz_class of_fractions = 1;
    for (const std::size_t vertex : face)
        for (const Number* const number : coordinates_of(vertices[vertex]))
            if (const auto decimal = number->as_decimal())
                places = std::max(places, -decimal->exponent);
            else if (of_fractions = lcm(of_fractions, number->exact().get_den());
                     mpz_sizeinbase(of_fractions.get_mpz_t(), 2) > most_bits_of_face)
                return {};

    WideCorners result{.corners = std::vector<WidePoint3>(face.size()),
                       .denominator = of_fractions * power_of_ten_of_any_size(places)};
    for (std::size_t k = 0; k < face.size(); ++k)
        for (std::size_t i = 0; i < 3; ++i) {
            const Number& number = *coordinates_of(vertices[face[k]])[i];
            mpz_class& whole = result.corners[k][i];
            if (const auto decimal = number.as_decimal())
                whole = of_fractions * decimal->digits *
                        power_of_ten_of_any_size(places + decimal->exponent);
            else
                whole = mpq_class(number.exact() * result.denominator).get_num();
        }
    return result;
}

} // namespace

/// The current face. Memory is kept for the next one.
struct FaceCutter::Workspace {
    std::vector<GridPoint3> corners = {};
    Polygon<std::int64_t> polygon = {};
};

FaceCutter::FaceCutter(std::span<const SceneVertex> vertices, std::size_t first)
    : vertices_(vertices), first_(first) {}
FaceCutter::~FaceCutter() = default;

Triangulation FaceCutter::cut(std::span<const std::size_t> face) {
    if (!workspace_) {
        workspace_ = std::make_unique<Workspace>();
        put_on_grid();
    }
    if (take_from_grid(face)) {
        const std::span<const GridPoint3> all = workspace_->corners;
        Polygon<std::int64_t>& polygon = workspace_->polygon;
        if (bits_of_sums(face.size()) <= 62)
            return cut_face<std::int64_t>(all, denominator_, polygon);
        if (bits_of_sums(face.size()) <= 126)
            return cut_face<Int128>(all, denominator_, polygon);
    }

    const auto [corners, denominator] = over_one_denominator(vertices_, face);
    if (corners.empty())
        return {.form = FaceForm::too_fine};
    Polygon<mpz_class> polygon{};
    return cut_face<mpz_class>(std::span<const WidePoint3>(corners), denominator, polygon);
}

/// Writes the mesh over one power of ten, if all of it is decimals that fit on 64 bits with room for sums of
/// products.
void FaceCutter::put_on_grid() {
    const auto vertices = vertices_.subspan(first_);
    int exponent = 0;
    for (const SceneVertex& vertex : vertices)
        for (const Number* const number : coordinates_of(vertex)) {
            const auto decimal = number->as_decimal();
            if (!decimal)
                return;
            exponent = std::min(exponent, decimal->exponent);
        }
    constexpr int most_places = static_cast<int>(powers_of_ten.size()) - 1;
    if (exponent < -most_places)
        return;

    grid_.reserve(vertices.size());
    std::uint64_t all_bits = 0;
    for (const SceneVertex& vertex : vertices) {
        GridPoint3& point = grid_.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [digits, own_exponent] = *coordinates_of(vertex)[i]->as_decimal();
            const int places = own_exponent - exponent;
            if (places > most_places ||
                __builtin_mul_overflow(digits, power_of_ten(places), &point[i]))
                return grid_.clear();
            all_bits |= static_cast<std::uint64_t>(point[i] < 0 ? ~point[i] : point[i]);
        }
    }
    denominator_ = power_of_ten(-exponent);
    bits_ = static_cast<int>(std::bit_width(all_bits));
    if (bits_ > most_bits_of_grid)
        grid_.clear();
}

bool FaceCutter::take_from_grid(std::span<const std::size_t> face) {
    std::vector<GridPoint3>& corners = workspace_->corners;
    corners.resize(face.size());
    for (std::size_t i = 0; i < face.size(); ++i) {
        const std::size_t place = face[i] - first_; // beyond the end for what lies before `first_`
        if (place >= grid_.size())
            return false;
        corners[i] = grid_[place];
    }
    return true;
}

int FaceCutter::bits_of_sums(std::size_t corners) const {
    return 2 * (bits_ + 1) + static_cast<int>(std::bit_width(corners));
}

} // namespace rastertrace
