// SPDX-License-Identifier: MIT
#include "t_junctions.h"

#include <rastertrace/core/numbers/rational.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace rastertrace {

namespace {

/// How much a vertex on an edge may be off, as a part of the edge's length.
constexpr double largest_deviation = 1.0 / 8;

// Edges, seen along an axis.

/// x or y, and the other one.
const mpq_class& along(const ScreenPoint& point, bool is_x) {
    return is_x ? point.x : point.y;
}
const mpq_class& across(const ScreenPoint& point, bool is_x) {
    return is_x ? point.y : point.x;
}

/// An edge as a function: where it lies across an axis, for each place along the axis.
struct Run {
    bool along_x = true;
    mpq_class low; ///< along, from here
    mpq_class high;
    mpq_class low_across; ///< at `low`
    mpq_class slope;
    bool is_upward = false; ///< from the edge's first end to its second, `along` grows
    bool is_above = false;  ///< the triangle lies where `across` is larger

    mpq_class across_at(const mpq_class& place) const { return low_across + slope * (place - low); }

    /// How far a point lies from the edge, across.
    mpq_class distance_of(const ScreenPoint& point) const {
        return abs(across(point, along_x) - across_at(along(point, along_x)));
    }

    /// What "on" or "near" may be at most.
    mpq_class reach(double most) const {
        return std::min<mpq_class>(most, (high - low) * largest_deviation);
    }

    /// Strictly between the ends, and not next to one.
    bool is_between_ends(const ScreenPoint& point) const {
        const mpq_class& place = along(point, along_x);
        return place - low >= on_edge_reach && high - place >= on_edge_reach;
    }

    bool has_near(const ScreenPoint& point) const {
        return is_between_ends(point) && distance_of(point) <= reach(near_edge_reach);
    }
};

/// Which way a point lies from the line from one to another: above 0 to the left, where y points up.
int side_of(const ScreenPoint& from, const ScreenPoint& to, const ScreenPoint& point) {
    return cmp((to.x - from.x) * (point.y - from.y), (point.x - from.x) * (to.y - from.y));
}

/// An edge of a triangle, seen along an axis; `nullopt` if it runs straight across.
std::optional<Run> run_of(const ScreenTriangle& triangle, std::size_t from, std::size_t to,
                          bool along_x) {
    const ScreenPoint* low = &triangle.at[from];
    const ScreenPoint* high = &triangle.at[to];
    const int direction = cmp(along(*high, along_x), along(*low, along_x));
    if (direction == 0)
        return std::nullopt;
    if (direction < 0)
        std::swap(low, high);
    Run run;
    run.along_x = along_x;
    run.low = along(*low, along_x);
    run.high = along(*high, along_x);
    run.low_across = across(*low, along_x);
    run.slope = (across(*high, along_x) - run.low_across) / (run.high - run.low);
    run.is_upward = direction > 0;
    // To the left of an edge that goes right lies what is above it; of one that goes up, smaller x.
    run.is_above = (side_of(*low, *high, triangle.at[3 - from - to]) > 0) == along_x;
    return run;
}

/// The same along the axis along which it runs more; it must have a length.
Run run_of(const ScreenTriangle& triangle, std::size_t from, std::size_t to) {
    const ScreenPoint& a = triangle.at[from];
    const ScreenPoint& b = triangle.at[to];
    return *run_of(triangle, from, to, abs(b.x - a.x) >= abs(b.y - a.y));
}

/// An edge that one triangle has, and no other.
struct OpenEdge {
    TriangleCorner from;
    TriangleCorner to;
};

/// An edge, gone from one end to the other.
struct Way {
    std::size_t edge = 0;
    TriangleCorner start;
    TriangleCorner end;
};

/// A vertex on an edge.
struct Meeting {
    std::size_t edge = 0;
    TriangleCorner vertex;
};

// Which vertices lie near a line.

/// One end of an open edge, as seen along an axis; rounded.
struct EdgeEnd {
    double along = 0;
    double across = 0;
    std::size_t edge = 0;
    TriangleCorner end;
};

/// Ends of edges, halved again and again at the median of the axis in which they lie farther apart.
class EndTree {
public:
    explicit EndTree(std::vector<EdgeEnd> ends) : ends_(std::move(ends)) {
        std::size_t nodes = 1;
        for (std::size_t size = ends_.size(); size > most_in_leaf; size -= size / 2)
            nodes = 2 * nodes + 1;
        boxes_.resize(nodes);
        build(0, 0, ends_.size());
    }

    /// Visits all ends that lie within `on_edge_reach` of an edge, and hardly any others.
    template <typename Visit> void visit_close_to(const Run& run, Visit&& visit) const {
        const Line line(run);
        visit_in(0, 0, ends_.size(), line, visit);
    }

private:
    static constexpr std::size_t most_in_leaf = 8;

    struct Box {
        double low_along = std::numeric_limits<double>::infinity();
        double high_along = -std::numeric_limits<double>::infinity();
        double low_across = std::numeric_limits<double>::infinity();
        double high_across = -std::numeric_limits<double>::infinity();
    };

    /// An edge in doubles without what is next to its ends, and how far across from it one has to
    /// look.
    struct Line {
        explicit Line(const Run& run)
            : low(run.low.get_d()), low_across(run.low_across.get_d()), slope(run.slope.get_d()) {
            // The slope is at most 1, so all numbers are at most of this size; 2^-40 of it is far
            // more than what rounding loses.
            const double high = run.high.get_d();
            const double size = std::abs(low) + std::abs(high) + std::abs(low_across);
            const double slack = std::ldexp(size, -40);
            first = low + on_edge_reach - slack;
            last = high - on_edge_reach + slack;
            margin = 2 * on_edge_reach + slack;
        }

        /// False only if the box is surely farther away. A number that is none, of coordinates that
        /// no double holds, makes no comparison true.
        bool may_touch(const Box& box) const {
            const double from = std::max(box.low_along, first);
            const double to = std::min(box.high_along, last);
            if (from > to)
                return false;
            const double at_from = low_across + slope * (from - low);
            const double at_to = low_across + slope * (to - low);
            const bool is_below =
                at_from + margin < box.low_across && at_to + margin < box.low_across;
            const bool is_above =
                at_from - margin > box.high_across && at_to - margin > box.high_across;
            return !is_below && !is_above;
        }

        double low;
        double low_across;
        double slope;
        double first = 0;
        double last = 0;
        double margin = 0;
    };

    void build(std::size_t node, std::size_t first, std::size_t last) {
        Box box;
        for (std::size_t i = first; i < last; ++i) {
            box.low_along = std::min(box.low_along, ends_[i].along);
            box.high_along = std::max(box.high_along, ends_[i].along);
            box.low_across = std::min(box.low_across, ends_[i].across);
            box.high_across = std::max(box.high_across, ends_[i].across);
        }
        boxes_[node] = box;
        if (last - first <= most_in_leaf)
            return;
        const std::size_t middle = first + (last - first) / 2;
        const auto at = [this](std::size_t i) {
            return ends_.begin() + static_cast<std::ptrdiff_t>(i);
        };
        const bool is_longer_along =
            box.high_along - box.low_along >= box.high_across - box.low_across;
        std::nth_element(at(first), at(middle), at(last),
                         [is_longer_along](const EdgeEnd& a, const EdgeEnd& b) {
                             return is_longer_along ? a.along < b.along : a.across < b.across;
                         });
        build(2 * node + 1, first, middle);
        build(2 * node + 2, middle, last);
    }

    template <typename Visit>
    void visit_in(std::size_t node, std::size_t first, std::size_t last, const Line& line,
                  Visit& visit) const {
        if (first == last || !line.may_touch(boxes_[node]))
            return;
        if (last - first <= most_in_leaf) {
            for (std::size_t i = first; i < last; ++i) {
                const EdgeEnd& end = ends_[i];
                if (line.may_touch({end.along, end.along, end.across, end.across}))
                    visit(end);
            }
            return;
        }
        const std::size_t middle = first + (last - first) / 2;
        visit_in(2 * node + 1, first, middle, line, visit);
        visit_in(2 * node + 2, middle, last, line, visit);
    }

    std::vector<EdgeEnd> ends_;
    std::vector<Box> boxes_; ///< those of node n are in nodes 2n + 1 and 2n + 2
};

// The search.

class JunctionFinder {
public:
    explicit JunctionFinder(std::span<const ScreenTriangle> triangles) : triangles_(triangles) {
        find_open_edges();
    }

    std::vector<TJunction> find() {
        follow_from_vertices();
        look_beside_edges();
        return junctions();
    }

private:
    // Points and edges.

    const ScreenPoint& point(const TriangleCorner& corner) const {
        return triangles_[corner.triangle].at[corner.corner];
    }
    std::uint32_t number(const TriangleCorner& corner) const {
        return triangles_[corner.triangle].corners[corner.corner];
    }

    std::optional<Run> run_of(std::size_t edge, bool along_x) const {
        const auto& [from, to] = edges_[edge];
        return rastertrace::run_of(triangles_[from.triangle], from.corner, to.corner, along_x);
    }
    Run run_of(std::size_t edge) const {
        const auto& [from, to] = edges_[edge];
        return rastertrace::run_of(triangles_[from.triangle], from.corner, to.corner);
    }

    Way way_from(const TriangleCorner& start, std::size_t edge) const {
        const OpenEdge& open = edges_[edge];
        return number(open.from) == number(start) ? Way{edge, open.from, open.to}
                                                  : Way{edge, open.to, open.from};
    }

    void find_open_edges() {
        constexpr std::array<std::pair<std::size_t, std::size_t>, 3> sides{
            {{0, 1}, {1, 2}, {2, 0}}};
        const auto ends_of = [this](std::size_t triangle, std::size_t from, std::size_t to) {
            const auto& corners = triangles_[triangle].corners;
            const auto [low, high] = std::minmax(corners[from], corners[to]);
            return std::uint64_t{low} << 32 | high;
        };
        std::unordered_map<std::uint64_t, std::uint32_t> uses;
        std::uint32_t largest = 0;
        for (std::size_t i = 0; i < triangles_.size(); ++i)
            for (const auto& [from, to] : sides) {
                ++uses[ends_of(i, from, to)];
                largest = std::max(largest, triangles_[i].corners[from]);
            }
        edges_at_.resize(std::size_t{largest} + 1);
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            if (!triangles_[i].is_drawn)
                continue;
            for (const auto& [from, to] : sides) {
                if (uses[ends_of(i, from, to)] > 1)
                    continue;
                for (const std::size_t end : {from, to})
                    edges_at_[triangles_[i].corners[end]].push_back(edges_.size());
                edges_.push_back({{i, from}, {i, to}});
            }
        }
    }

    // Near: rows of edges that part at one vertex and meet at another.

    void follow_from_vertices() {
        for (std::size_t vertex = 0; vertex < edges_at_.size(); ++vertex) {
            if (edges_at_[vertex].size() < 2)
                continue;
            // By direction, so that neighbors are next to each other.
            std::vector<std::pair<double, Way>> ways;
            for (const std::size_t edge : edges_at_[vertex]) {
                const auto& [from, to] = edges_[edge];
                const Way way = number(from) == vertex ? Way{edge, from, to} : Way{edge, to, from};
                const auto [x, y] = direction_of(way);
                ways.emplace_back(std::atan2(y, x), way);
            }
            std::stable_sort(ways.begin(), ways.end(),
                             [](const auto& a, const auto& b) { return a.first < b.first; });

            const std::size_t neighbors = std::min(most_edges_at_vertex, ways.size() / 2);
            for (std::size_t i = 0; i < ways.size(); ++i)
                for (std::size_t k = 1; k <= neighbors; ++k)
                    follow(ways[i].second, ways[(i + k) % ways.size()].second);
        }
    }

    /// From where it starts to where it ends, in doubles.
    std::pair<double, double> direction_of(const Way& way) const {
        const ScreenPoint& from = point(way.start);
        const ScreenPoint& to = point(way.end);
        return {mpq_class(to.x - from.x).get_d(), mpq_class(to.y - from.y).get_d()};
    }

    /// Follows two rows of edges that part at a vertex, on the one's left and the other's right.
    void follow(Way one, Way other) {
        if (!may_be_near(one, other) || !are_beside(one, other))
            return;
        std::vector<Meeting> meetings;
        std::vector<std::pair<std::size_t, std::size_t>> beside;
        while (beside.size() < edges_.size()) {
            beside.emplace_back(one.edge, other.edge);
            if (number(one.end) == number(other.end)) {
                for (const Meeting& meeting : meetings)
                    add(meeting);
                for (const auto& [a, b] : beside) {
                    add_beside(a, b);
                    add_beside(b, a);
                }
                return;
            }
            // Whichever ends beside the other goes on.
            std::optional<Way> next;
            if (run_of(one.edge).has_near(point(other.end))) {
                meetings.push_back({one.edge, other.end});
                if (!(next = next_beside(other, one)))
                    return;
                other = *next;
            } else if (run_of(other.edge).has_near(point(one.end))) {
                meetings.push_back({other.edge, one.end});
                if (!(next = next_beside(one, other)))
                    return;
                one = *next;
            } else {
                return;
            }
        }
    }

    /// False only if both ends of two edges from one vertex are surely too far from the other edge.
    /// In doubles, where they are small enough to be as good as exact.
    bool may_be_near(const Way& one, const Way& other) const {
        const auto [x, y] = direction_of(one);
        const auto [other_x, other_y] = direction_of(other);
        const double length = std::max(std::abs(x), std::abs(y));
        const double other_length = std::max(std::abs(other_x), std::abs(other_y));
        constexpr double small_enough = 0x1p40;
        if (!(length < small_enough && other_length < small_enough))
            return true;
        // Twice the area, over the length: the distance across of the other edge's end.
        return std::abs(x * other_y - y * other_x) <= std::max(length, other_length);
    }

    /// Two sides of a sliver lie beside each other too, but that is one triangle.
    bool are_of_one_triangle(std::size_t edge, std::size_t other) const {
        return edges_[edge].from.triangle == edges_[other].from.triangle;
    }

    /// Do two edges run the same way along the first one, with their triangles on different sides?
    bool are_beside(const Way& one, const Way& other) const {
        if (are_of_one_triangle(one.edge, other.edge))
            return false;
        const Run run = run_of(one.edge);
        const auto other_run = run_of(other.edge, run.along_x);
        return other_run && goes_upward(one, run) == goes_upward(other, *other_run) &&
               run.is_above != other_run->is_above;
    }
    bool goes_upward(const Way& way, const Run& run) const {
        return cmp(along(point(way.end), run.along_x), along(point(way.start), run.along_x)) > 0;
    }

    /// The edge that goes on from the end of `way`, beside an edge that goes farther.
    std::optional<Way> next_beside(const Way& way, const Way& farther) const {
        const auto& edges = edges_at_[number(way.end)];
        const std::size_t count = std::min(edges.size(), 2 * most_edges_at_vertex);
        for (std::size_t i = 0; i < count; ++i) {
            if (edges[i] == way.edge)
                continue;
            const Way next = way_from(way.end, edges[i]);
            if (are_beside(farther, next) && (number(next.end) == number(farther.end) ||
                                              run_of(farther.edge).has_near(point(next.end)) ||
                                              run_of(next.edge).has_near(point(farther.end))))
                return next;
        }
        return std::nullopt;
    }

    // On: edges that run beside each other within `on_edge_reach`.

    void look_beside_edges() {
        for (const bool along_x : {true, false})
            for (const bool is_above : {true, false})
                look_beside_edges(along_x, is_above);
    }

    /// Compares the edges that run along an axis and have their triangle on one side of them with
    /// the ends of those that have it on the other.
    void look_beside_edges(bool along_x, bool is_above) {
        std::vector<std::size_t> edges;
        std::vector<EdgeEnd> ends;
        for (std::size_t edge = 0; edge < edges_.size(); ++edge) {
            const auto run = run_of(edge, along_x);
            // What runs beside an edge that is at most as steep as 1 is not much steeper.
            if (!run || abs(run->slope) > 2)
                continue;
            if (run->is_above == is_above && abs(run->slope) <= 1 &&
                run_of(edge).along_x == along_x)
                edges.push_back(edge);
            if (run->is_above != is_above)
                for (const TriangleCorner& end : {edges_[edge].from, edges_[edge].to})
                    ends.push_back({along(point(end), along_x).get_d(),
                                    across(point(end), along_x).get_d(), edge, end});
        }
        if (edges.empty() || ends.empty())
            return;
        const EndTree tree(std::move(ends));
        for (const std::size_t edge : edges) {
            const Run run = *run_of(edge, along_x);
            tree.visit_close_to(run, [&](const EdgeEnd& end) { compare(edge, run, end); });
        }
    }

    /// Adds the end of an edge to a T-junction if it lies on another edge, and its edge runs on
    /// beside that one.
    void compare(std::size_t edge, const Run& run, const EdgeEnd& end) {
        if (is_told_often(number(end.end), edge))
            return;
        const ScreenPoint& vertex = point(end.end);
        if (are_of_one_triangle(edge, end.edge) || !run.is_between_ends(vertex))
            return;
        const Run beside = *run_of(end.edge, run.along_x);
        const mpq_class reach = std::min(run.reach(on_edge_reach), beside.reach(on_edge_reach));
        if (run.distance_of(vertex) > reach)
            return;
        // Where the two no longer run beside each other: at the end of the one or the other.
        const ScreenPoint& far_end = point(way_from(end.end, end.edge).end);
        const mpq_class& place = along(far_end, run.along_x);
        const mpq_class last = std::clamp(place, run.low, run.high);
        if (abs(run.across_at(last) - beside.across_at(last)) > reach)
            return;
        add({edge, end.end});
        add_beside(edge, end.edge);
    }

    // What was found.

    struct Found {
        std::map<std::uint32_t, TriangleCorner> vertices; ///< by number
        std::map<std::size_t, EdgeBeside> beside;         ///< by edge
    };

    /// Is a vertex told of at as many edges as it may be, and not at this one?
    bool is_told_often(std::uint32_t corner, std::size_t edge) const {
        const auto told = edges_told_.find(corner);
        if (told == edges_told_.end() || told->second < most_edges_at_vertex)
            return false;
        const auto found = found_.find(edge);
        return found == found_.end() || !found->second.vertices.contains(corner);
    }

    void add(const Meeting& meeting) {
        const std::uint32_t corner = number(meeting.vertex);
        if (found_[meeting.edge].vertices.emplace(corner, meeting.vertex).second)
            ++edges_told_[corner];
    }

    void add_beside(std::size_t edge, std::size_t beside) {
        const Run run = run_of(edge);
        const auto other = run_of(beside, run.along_x);
        if (!other)
            return;
        const mpq_class& low = std::max(run.low, other->low);
        const mpq_class& high = std::min(run.high, other->high);
        if (low < high)
            found_[edge].beside.emplace(
                beside, EdgeBeside{edges_[beside].from, edges_[beside].to, low, high});
    }

    std::vector<TJunction> junctions() {
        // The triangles at the vertices that were found.
        std::unordered_map<std::uint32_t, std::vector<std::size_t>> around;
        for (const auto& [corner, count] : edges_told_)
            around[corner] = {};
        for (std::size_t i = 0; i < triangles_.size() && !around.empty(); ++i)
            for (const std::uint32_t corner : triangles_[i].corners)
                if (const auto at = around.find(corner);
                    at != around.end() && triangles_[i].is_drawn)
                    at->second.push_back(i);

        std::vector<TJunction> result;
        for (const auto& [edge, found] : found_) {
            if (found.vertices.empty())
                continue;
            const Run run = run_of(edge);
            TJunction junction{edges_[edge].from, edges_[edge].to, {}, {}, {}};
            for (const auto& [corner, vertex] : found.vertices) {
                junction.vertices.push_back({vertex, run.distance_of(point(vertex))});
                const auto& triangles = around[corner];
                junction.around.insert(junction.around.end(), triangles.begin(), triangles.end());
            }
            for (const auto& [other, beside] : found.beside)
                junction.beside.push_back(beside);
            std::sort(junction.around.begin(), junction.around.end());
            junction.around.erase(std::unique(junction.around.begin(), junction.around.end()),
                                  junction.around.end());
            put_in_order(junction, run);
            result.push_back(std::move(junction));
        }
        return result;
    }

    /// From `from` to `to`.
    void put_in_order(TJunction& junction, const Run& run) const {
        std::sort(junction.vertices.begin(), junction.vertices.end(),
                  [&](const JunctionVertex& a, const JunctionVertex& b) {
                      return along(point(a.vertex), run.along_x) <
                             along(point(b.vertex), run.along_x);
                  });
        std::sort(junction.beside.begin(), junction.beside.end(),
                  [](const EdgeBeside& a, const EdgeBeside& b) {
                      return std::tie(a.low, a.high) < std::tie(b.low, b.high);
                  });
        if (!run.is_upward) {
            std::reverse(junction.vertices.begin(), junction.vertices.end());
            std::reverse(junction.beside.begin(), junction.beside.end());
        }
    }

    std::span<const ScreenTriangle> triangles_;
    std::vector<OpenEdge> edges_;
    std::vector<std::vector<std::size_t>> edges_at_;            ///< by number of the vertex
    std::map<std::size_t, Found> found_;                        ///< by edge
    std::unordered_map<std::uint32_t, std::size_t> edges_told_; ///< by number of the vertex
};

// Pixels.

/// Strictly inside a triangle, and farther than rounding reaches from two of its edges: those other
/// than the one between `from` and `to`.
bool is_inside_at_edge(const ScreenTriangle& triangle, const TriangleCorner& from,
                       const TriangleCorner& to, const ScreenPoint& point) {
    const auto area2 = [](const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) {
        return mpq_class((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
    };
    const auto& at = triangle.at;
    const int winding = sgn(area2(at[0], at[1], at[2]));
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3;
        const bool is_edge = i + next == from.corner + to.corner;
        if (winding * area2(at[i], at[next], point) <= (is_edge ? mpq_class(0) : triangle.error))
            return false;
    }
    return true;
}

/// Where edges lie beside a T-junction's edge without a break: from `low` to `high`.
using Stretch = std::pair<mpq_class, mpq_class>;

std::vector<Stretch> stretches_of(const TJunction& junction) {
    std::vector<Stretch> parts;
    for (const EdgeBeside& beside : junction.beside)
        parts.emplace_back(beside.low, beside.high);
    std::sort(parts.begin(), parts.end());
    std::vector<Stretch> whole;
    for (const Stretch& part : parts)
        if (!whole.empty() && part.first <= whole.back().second)
            whole.back().second = std::max(whole.back().second, part.second);
        else
            whole.push_back(part);
    return whole;
}

/// The whole numbers from `low` to `high`, as far as they lie from `first` to `last`.
std::pair<Index, Index> whole_numbers(const mpq_class& low, const mpq_class& high, Index first,
                                      Index last) {
    return {std::max(ceil_index(low), first), std::min(floor_index(high), last)};
}

/// The pixels that both of two triangles cover, found from the one that covers fewer.
void add_common(std::span<const std::uint32_t> one, std::span<const std::uint32_t> other,
                std::vector<std::uint32_t>& common) {
    if (one.size() > other.size())
        std::swap(one, other);
    for (const std::uint32_t offset : one)
        if (std::binary_search(other.begin(), other.end(), offset))
            common.push_back(offset);
}

void put_in_order(std::vector<std::uint32_t>& offsets) {
    std::sort(offsets.begin(), offsets.end());
    offsets.erase(std::unique(offsets.begin(), offsets.end()), offsets.end());
}

} // namespace

JunctionPixels pixels_at(const TJunction& junction, std::span<const ScreenTriangle> triangles,
                         const CoveredBy& covered_by, const Canvas& canvas,
                         const mpq_class& sample_offset) {
    JunctionPixels pixels;
    const std::size_t owner = junction.from.triangle;
    for (const EdgeBeside& beside : junction.beside)
        add_common(covered_by(owner), covered_by(beside.from.triangle), pixels.twice);
    put_in_order(pixels.twice);

    const auto is_covered_by = [&covered_by](std::size_t triangle, std::uint32_t offset) {
        const auto covered = covered_by(triangle);
        return std::binary_search(covered.begin(), covered.end(), offset);
    };
    const auto is_covered_by_any = [&](std::uint32_t offset) {
        return std::any_of(junction.beside.begin(), junction.beside.end(),
                           [&](const EdgeBeside& beside) {
                               return is_covered_by(beside.from.triangle, offset);
                           }) ||
               std::any_of(junction.around.begin(), junction.around.end(),
                           [&](std::size_t triangle) { return is_covered_by(triangle, offset); });
    };

    const Run run = run_of(triangles[owner], junction.from.corner, junction.to.corner);
    // A sample beside an end of it all may belong to a triangle that only touches that end.
    const std::vector<Stretch> stretches = stretches_of(junction);
    const auto is_between_ends = [&stretches](const mpq_class& place) {
        return std::any_of(stretches.begin(), stretches.end(), [&place](const Stretch& stretch) {
            return stretch.first < place && place < stretch.second;
        });
    };
    const auto [low_y, high_y] = std::minmax<Index>({canvas.top(), canvas.bottom()});
    const Index first_along = run.along_x ? canvas.left() : low_y;
    const Index last_along = run.along_x ? canvas.right() : high_y;
    const Index first_across = run.along_x ? low_y : canvas.left();
    const Index last_across = run.along_x ? high_y : canvas.right();
    for (const EdgeBeside& beside : junction.beside) {
        const ScreenTriangle& other = triangles[beside.from.triangle];
        const Run other_run = *run_of(other, beside.from.corner, beside.to.corner, run.along_x);
        const auto [first, last] = whole_numbers(
            beside.low - sample_offset, beside.high - sample_offset, first_along, last_along);
        for (Index i = first; i <= last; ++i) {
            const mpq_class place = i + sample_offset;
            const mpq_class on_edge = run.across_at(place);
            const mpq_class on_other = other_run.across_at(place);
            const auto [from, to] =
                whole_numbers(on_edge - sample_offset - 1, on_edge - sample_offset + 1,
                              first_across, last_across);
            for (Index k = from; k <= to; ++k) {
                const auto [x, y] = run.along_x ? std::pair{i, k} : std::pair{k, i};
                const auto offset = static_cast<std::uint32_t>(
                    canvas.offset_of({static_cast<int>(x), static_cast<int>(y)}));
                if (is_covered_by(owner, offset) || is_covered_by(beside.from.triangle, offset))
                    continue;
                const mpq_class level = k + sample_offset;
                const ScreenPoint sample =
                    run.along_x ? ScreenPoint{place, level} : ScreenPoint{level, place};
                const bool is_in_gap = run.is_above ? on_other <= level && level <= on_edge
                                                    : on_edge <= level && level <= on_other;
                const bool is_missed =
                    (is_in_gap && is_between_ends(place)) ||
                    is_inside_at_edge(triangles[owner], junction.from, junction.to, sample) ||
                    is_inside_at_edge(other, beside.from, beside.to, sample);
                if (is_missed && !is_covered_by_any(offset))
                    pixels.never.push_back(offset);
            }
        }
    }
    put_in_order(pixels.never);
    return pixels;
}

std::vector<TJunction> t_junctions_of(std::span<const ScreenTriangle> triangles) {
    return triangles.empty() ? std::vector<TJunction>() : JunctionFinder(triangles).find();
}

} // namespace rastertrace
