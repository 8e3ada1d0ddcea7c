// SPDX-License-Identifier: MIT
#include <rastertrace/core/raster/line.h>
#include <rastertrace/numerics/cliffs.h>

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/core/draw/list/geometry.h>
#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/draw/paint/piece_in.h>
#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/primitive_name.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace rastertrace {

namespace {

/// What there is to fall from, in the order of CliffKind.
struct KindWords {
    std::string_view name;
    std::string_view meaning;
};
constexpr std::array words_of_kinds{
    KindWords{"depth-ratio",
              "depths that differ a million times in one triangle: linear z and 24-bit buffers "
              "fall"},
    KindWords{"slope",
              "a slope of a million or a millionth: a step that suits one axis loses the other"},
    KindWords{"absorbed-step", "a step too small for the number it is added to"},
    KindWords{"growing-error", "a slope added up until its rounding reaches the next tie"},
    KindWords{"sliver", "a triangle of almost no area: rounded, its sign is anybody's guess"},
    KindWords{"sample-on-edge",
              "edges on samples, or within 2^-20 px of them: the tie rule or the rounding decides"},
    KindWords{"collapsed", "triangles that `fixed` leaves nothing of"},
    KindWords{"snapped", "vertices that `fixed` moves to its grid of 1/256"},
    KindWords{"edge-on", "faces seen from their edge: rounded, they may be turned either way"},
    KindWords{"near-plane", "vertices at the near plane, or before it: clipping makes new ones"},
    KindWords{"far-out", "coordinates beyond 2^23: float has no half pixels there"}};
static_assert(words_of_kinds.size() == static_cast<std::size_t>(CliffKind::far_out) + 1);

/// Bits of a significand.
constexpr int float_bits = 24;
constexpr int double_bits = 53;

/// Numbers that differ by this factor are of different scales.
constexpr double stiff_ratio = 1e6;

/// How near to an edge a sample is near, in pixels, and a cosine to 0.
constexpr double least_distance = 0x1p-20;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// "float", or "float and double", by how many bits something is lost.
std::string_view who_loses(bool double_too) {
    return double_too ? "float and double" : "float";
}

/// A line of the screen, and what it is called.
struct ScreenEdge {
    Vec<Rational, 2> from;
    Vec<Rational, 2> to;
    std::string where;
};

/// Where along one axis an edge is looked at, and where across it lies what it must not touch.
struct Marks {
    bool along_x;    ///< along x and across y, or along y and across x
    Rational along;  ///< of a mark, from an index
    Rational across; ///< the same
};

/// The marks that an edge touches, or nearly touches.
struct Touches {
    std::uint64_t exact = 0;
    std::uint64_t near = 0; ///< within the least distance
    Rational nearest = 1;
    std::optional<GridPoint> place; ///< of the nearest; none if there is none
};

std::string in_words(const Touches& touches, std::string_view what) {
    const std::string at = fmt::format("({}, {})", touches.place->x, touches.place->y);
    if (touches.exact == 0)
        return fmt::format("comes within 2^-20 px of {}, the nearest {:.2g} px away, at pixel {}",
                           counted(touches.near, what), nearest_double(touches.nearest), at);
    return fmt::format("passes exactly through {}, one at pixel {}", counted(touches.exact, what),
                       at) +
           (touches.near > 0 ? fmt::format("; {} more within 2^-20 px", touches.near) : "");
}

/// A filter in double: false only where start + slope i is farther than the least distance from every
/// whole number. Where its own error could be as large, it lets everything through.
class NearMarks {
public:
    NearMarks(const Rational& start, const Rational& slope, Index low, Index high)
        : start_(nearest_double(start)), slope_(nearest_double(slope)) {
        constexpr double sure = 0x1p28;
        const auto as_double = [](Index i) { return std::abs(static_cast<double>(i)); };
        is_sure_ = std::abs(start_) < sure &&
                   std::abs(slope_) *
                           std::max({as_double(high - low + 1), as_double(low), as_double(high)}) <
                       sure;
    }

    bool operator()(Index i) const {
        const double x = start_ + slope_ * static_cast<double>(i);
        return !is_sure_ || std::abs(x - std::nearbyint(x)) <= 2 * least_distance;
    }

private:
    double start_;
    double slope_;
    bool is_sure_;
};

Rational absolute(const Rational& x) {
    return abs(x);
}

class CliffFinder {
public:
    explicit CliffFinder(Scene scene) : scene_(std::move(scene)) {
        scene_.method.scalar = ScalarKind::exact;
        // With this stage kept, every vertex goes through its spaces, in rationals.
        scene_.keep.add(Stage::model);
        geometry_ = geometry_of<Rational>(scene_);
    }

    std::vector<CliffGroup> find() {
        look_at_vertices();
        const auto list = screen_list_of(scene_, geometry_);
        for_each_primitive(scene_, list, [&](const ScreenPrimitive& one) {
            look_at(piece_of(scene_, list, one), PieceNames(scene_, list, one));
        });
        look_at_depths();
        look_at_faces();

        std::vector<CliffGroup> groups;
        for (std::size_t i = 0; i < words_of_kinds.size(); ++i) {
            std::vector<Cliff>& found = found_[i];
            if (found.empty())
                continue;
            std::stable_sort(found.begin(), found.end(), [](const Cliff& a, const Cliff& b) {
                return a.nearness > b.nearness;
            });
            CliffGroup group{static_cast<CliffKind>(i), {}, more_[i]};
            if (found.size() > most_cliffs) {
                group.more += found.size() - most_cliffs;
                found.resize(most_cliffs);
            }
            group.worst = std::move(found);
            groups.push_back(std::move(group));
        }
        return groups;
    }

private:
    void add(CliffKind kind, std::string where, std::string how_near, double nearness) {
        auto& found = found_[static_cast<std::size_t>(kind)];
        found.push_back({std::move(where), std::move(how_near), nearness});
        // A mesh may have a million of them; only the worst are shown.
        constexpr std::size_t most_held = 64 * most_cliffs;
        if (found.size() >= most_held) {
            const auto middle = found.begin() + static_cast<std::ptrdiff_t>(most_cliffs);
            std::nth_element(
                found.begin(), middle, found.end(),
                [](const Cliff& a, const Cliff& b) { return a.nearness > b.nearness; });
            more_[static_cast<std::size_t>(kind)] += found.size() - most_cliffs;
            found.resize(most_cliffs);
        }
    }

    // Vertices in space.

    void look_at_vertices() {
        const auto nearest = near_of(scene_.projection);
        if (!is_perspective(scene_.projection.type) || !nearest)
            return;
        const Rational& near = *nearest;
        for (std::size_t i = 0; i < scene_.vertices.size(); ++i) {
            if (!geometry_.is_used[i])
                continue;
            const auto& vertex = geometry_.vertices[i];
            const std::string where = fmt::format("vertex {}", scene_.vertices[i].name);
            const double distance = nearest_double(vertex.distance);
            const Rational size = std::max(absolute(vertex.clip.x), absolute(vertex.clip.y));
            const Rational gap = absolute(vertex.distance - near);
            if (absolute(vertex.clip.w) <= size * Rational(least_distance))
                add(CliffKind::near_plane, where,
                    fmt::format("w = {:.3g}, with x or y = {:.3g}: as good as beside the eye",
                                nearest_double(vertex.clip.w), nearest_double(size)),
                    infinity);
            else if (vertex.distance < near)
                add(CliffKind::near_plane, where,
                    fmt::format("{} {:.6g}, cut off by the near plane at {:.6g}",
                                distance > 0 ? "at distance" : "behind the eye, at", distance,
                                nearest_double(near)),
                    nearest_double(near / gap));
            else if (gap == 0)
                add(CliffKind::near_plane, where, "on the near plane", infinity);
            else if (gap <= near * Rational(least_distance))
                add(CliffKind::near_plane, where,
                    fmt::format("{:.3g} beyond the near plane", nearest_double(gap)),
                    nearest_double(near / gap));
        }
    }

    void look_at_depths() {
        const bool has_depths =
            scene_.depth() != Depth::none || is_perspective(scene_.projection.type);
        if (!has_depths)
            return;
        const auto near = near_of(scene_.projection);
        for (const ScenePrimitive& primitive : scene_.primitives) {
            if (primitive.kind != PrimitiveKind::triangle)
                continue;
            std::array<Rational, 3> z;
            for (std::size_t i = 0; i < 3; ++i) {
                z[i] = geometry_.vertices[primitive.vertices[i]].distance;
                // What is nearer is cut off.
                if (is_perspective(scene_.projection.type) && near && z[i] < *near)
                    z[i] = *near;
            }
            const auto [least, largest] = std::minmax({z[0], z[1], z[2]});
            if (least <= 0)
                continue; // without a perspective, any distance will do
            const double ratio = nearest_double(largest / least);
            if (ratio >= stiff_ratio)
                add(CliffKind::depth_ratio, fmt::format("triangle {}", primitive.name),
                    fmt::format("depths from {:.6g} to {:.6g}: 1 to {:.3g}", nearest_double(least),
                                nearest_double(largest), ratio),
                    ratio);
        }
    }

    void look_at_faces() {
        if (!scene_.has_transforms() && !scene_.tests_faces())
            return;
        Scene tested = scene_;
        tested.method.cull = Cull::back;
        const auto geometry = geometry_of<Rational>(tested);
        // Where the world of clip space is is not known, but x, y and w are a view of it, from (0, 0, 0).
        const auto world_of = [&](std::size_t vertex) {
            const Vec<Rational, 4>& clip = geometry.vertices[vertex].clip;
            return tested.projection.type == ProjectionType::clip_space
                       ? Vec<Rational, 3>{clip.x, clip.y, clip.w}
                       : geometry.world[vertex];
        };
        for (const ScenePrimitive& primitive : tested.primitives) {
            if (primitive.kind != PrimitiveKind::triangle)
                continue;
            const auto [a, b, c] = primitive.vertices;
            const std::array world{world_of(a), world_of(b), world_of(c)};
            const auto face = face_of<Rational>(tested, geometry.list.transforms, primitive, world);
            if (!face.tested || !face.tested->cosine)
                continue;
            const double cosine = std::abs(*face.tested->cosine);
            if (cosine <= least_distance)
                add(CliffKind::edge_on, fmt::format("triangle {}", primitive.name),
                    face.tested->dot == 0
                        ? std::string("seen exactly from its edge: normal . view = 0")
                        : fmt::format("normal . view = {:.3g}, cosine {:.3g}",
                                      nearest_double(face.tested->dot), *face.tested->cosine),
                    1 / cosine);
        }
    }

    // Pieces on the screen.

    void look_at(const Piece<Rational>& piece, const PieceNames& names) {
        if (piece.is_skipped)
            return;
        const std::string owner = fmt::format("{} {}", name_of(piece.kind), names.piece);
        for (std::size_t i = 0; i < piece.count; ++i)
            if (piece.is_part || seen_vertices_.insert(piece.vertices[i]).second)
                look_at_place(piece, names, i, owner);

        const bool is_filled = piece.kind == PrimitiveKind::triangle;
        if (is_filled)
            look_at_area(piece, owner);
        const std::size_t edges = piece.count == 3 ? 3 : piece.count - 1;
        for (std::size_t i = 0; i < edges; ++i) {
            const std::size_t next = (i + 1) % piece.count;
            // An edge that two triangles share is one edge.
            const auto ends = std::minmax(piece.vertices[i], piece.vertices[next]);
            if (!piece.is_part && !seen_edges_.insert({is_filled, ends.first, ends.second}).second)
                continue;
            const std::array<std::string_view, 2> ends_named{names.corners[i], names.corners[next]};
            const ScreenEdge edge{
                piece.positions[i], piece.positions[next],
                piece.kind == PrimitiveKind::line
                    ? owner
                    : fmt::format("edge {} of {}", joined_names(ends_named), owner)};
            look_at_slope(edge, is_filled);
            look_at_marks(edge, is_filled);
        }
    }

    void look_at_place(const Piece<Rational>& piece, const PieceNames& names, std::size_t i,
                       const std::string& owner) {
        const auto& [x, y] = piece.positions[i];
        const std::string where = piece.is_part
                                      ? fmt::format("vertex {} of {}", names.corners[i], owner)
                                      : fmt::format("vertex {}", names.corners[i]);
        const double farthest = std::max(nearest_double(absolute(x)), nearest_double(absolute(y)));
        constexpr double float_pixels = 0x1p23;
        if (farthest > float_pixels)
            add(CliffKind::far_out, where,
                fmt::format("at ({:.6g}, {:.6g}): float's next number is {:.3g} px away",
                            nearest_double(x), nearest_double(y),
                            std::ldexp(1.0, std::ilogb(farthest) - float_bits + 1)),
                farthest);

        const auto moved = [](const Rational& coordinate) -> Rational {
            const Rational units = coordinate * fixed_grid;
            return absolute(units - Rational(static_cast<long>(
                                        floor_index(Rational(units + Rational(1, 2)))))) /
                   fixed_grid;
        };
        if (farthest > static_cast<double>(farthest_index) / static_cast<double>(fixed_grid))
            return; // `fixed` refuses it
        const double distance = nearest_double(std::max(moved(x), moved(y)));
        if (distance > 0)
            add(CliffKind::snapped, where,
                fmt::format("at ({:.9g}, {:.9g}) moves by {:.3g} px", nearest_double(x),
                            nearest_double(y), distance),
                distance);
    }

    void look_at_area(const Piece<Rational>& piece, const std::string& owner) {
        const auto& [a, b, c] = piece.positions;
        const Rational first = (b.x - a.x) * (c.y - a.y);
        const Rational second = (c.x - a.x) * (b.y - a.y);
        const Rational area2 = absolute(first - second);
        const Rational products = absolute(first) + absolute(second);
        const auto is_sliver = [&](int bits) {
            return area2 <= products * Rational(std::ldexp(1.0, 2 - bits));
        };
        if (area2 == 0)
            add(CliffKind::sliver, owner, "its area is 0", infinity);
        else if (is_sliver(float_bits))
            add(CliffKind::sliver, owner,
                fmt::format(
                    "twice its area is {:.3g}, the difference of products of {:.3g}: lost in {}",
                    nearest_double(area2), nearest_double(products / 2),
                    who_loses(is_sliver(double_bits))),
                nearest_double(products / area2));

        const auto snapped = [](const Rational& x) {
            return Rational(
                static_cast<long>(floor_index(Rational(x * fixed_grid + Rational(1, 2)))));
        };
        const Rational on_grid = (snapped(b.x) - snapped(a.x)) * (snapped(c.y) - snapped(a.y)) -
                                 (snapped(c.x) - snapped(a.x)) * (snapped(b.y) - snapped(a.y));
        if (area2 != 0 && on_grid == 0)
            add(CliffKind::collapsed, owner,
                fmt::format("twice its area is {:.3g} px^2, and 0 on the grid of 1/{}",
                            nearest_double(area2), fixed_grid),
                1 / nearest_double(area2));
    }

    void look_at_slope(const ScreenEdge& edge, bool is_filled) {
        const Rational dx = edge.to.x - edge.from.x;
        const Rational dy = edge.to.y - edge.from.y;
        if (dx == 0 || dy == 0)
            return;

        // A fill walks down the rows, a line along the axis in which it is longer.
        const bool along_x = !is_filled && absolute(dx) >= absolute(dy);
        const Rational slope = absolute(along_x ? Rational(dy / dx) : Rational(dx / dy));
        const std::string_view slope_name = along_x ? "dy/dx" : "dx/dy";
        const double steep = nearest_double(slope);
        if (steep >= stiff_ratio || steep <= 1 / stiff_ratio)
            add(CliffKind::slope, edge.where, fmt::format("{} = {:.3g}", slope_name, steep),
                std::max(steep, 1 / steep));

        const Rational across = along_x ? std::max(absolute(edge.from.y), absolute(edge.to.y))
                                        : std::max(absolute(edge.from.x), absolute(edge.to.x));
        const double steps = nearest_double(across / slope);
        if (steps >= std::ldexp(1.0, float_bits - 1))
            add(CliffKind::absorbed_step, edge.where,
                fmt::format("{} = {:.3g} is added to {:.6g}: absorbed in {}", slope_name, steep,
                            nearest_double(across),
                            who_loses(steps >= std::ldexp(1.0, double_bits - 1))),
                steps);

        // Added up, row after row or pixel after pixel, as far as the canvas goes.
        const Method& method = scene_.method;
        const bool is_added = is_filled ? method.lerp == LerpForm::incremental &&
                                              traits_of(method.fill).rule == PixelRule::row_ends
                                        : traits_of(method.line).adds_up;
        if (!is_added)
            return;
        const double n =
            std::min(nearest_double(absolute(along_x ? dx : dy)),
                     static_cast<double>(along_x ? scene_.canvas.width : scene_.canvas.height));
        const double error = n * n * steep * std::ldexp(1.0, -float_bits);
        if (error >= 1 / (2 * n))
            add(CliffKind::growing_error, edge.where,
                fmt::format("{:.0f} steps of {:.3g} may be off by {:.2g} px, and a tie lies within "
                            "{:.2g} px: {}",
                            n, steep, error, 1 / (2 * n),
                            who_loses(std::ldexp(error, float_bits - double_bits) >= 1 / (2 * n))),
                error * n);
    }

    /// The samples of a fill, the ends of its rows, the ties of a line.
    void look_at_marks(const ScreenEdge& edge, bool is_filled) {
        const Method& method = scene_.method;
        const Rational dx = absolute(edge.to.x - edge.from.x);
        const Rational dy = absolute(edge.to.y - edge.from.y);
        const auto tie_of = [](Rounding rounding) {
            return rounding == Rounding::nearest ? Rational(1, 2) : Rational(0);
        };
        const PixelRule rule = traits_of(method.fill).rule;
        const bool is_on_grid = traits_of(method.line).rule == LineRule::grid;
        if (is_filled && rule == PixelRule::lines)
            return;
        const bool along_x = dx >= dy;
        const Sample sample = is_filled ? sample_of(method) : sample_of_lines(method);
        const auto offset = sample_offset<Rational>(sample, 1);
        const Rational& moved = offset.x(); // the same in y
        if (is_filled && rule == PixelRule::row_ends) {
            const Rational tie = tie_of(span_rounding(method).rounding);
            look_along(edge, {false, moved, Rational(tie + moved)}, "row end");
        } else if (is_filled) {
            look_along(edge, {along_x, moved, moved}, "sample");
        } else {
            ScreenEdge line = edge;
            if (is_on_grid)
                for (auto* const end : {&line.from, &line.to}) {
                    const GridPoint pixel = nearest_pixel(*end, offset);
                    *end = {offset.x_of(pixel.x), offset.y_of(pixel.y)};
                }
            const Rational tie =
                is_on_grid ? Rational(1, 2) : tie_of(line_rounding(method).rounding);
            look_along(line, {along_x, moved, Rational(tie + moved)}, "tie");
        }
    }

    void look_along(const ScreenEdge& edge, const Marks& marks, std::string_view what) {
        const auto turned = [&marks](const Vec<Rational, 2>& p) {
            return marks.along_x ? p : Vec<Rational, 2>{p.y, p.x};
        };
        Vec<Rational, 2> from = turned(edge.from);
        Vec<Rational, 2> to = turned(edge.to);
        if (from.x == to.x) {
            look_at_row(edge.where, from.x);
            return;
        }
        if (to.x < from.x)
            std::swap(from, to);
        const Touches touches = touches_along(from, to, marks);
        if (touches.place)
            // Whatever is touched comes before what is only near.
            add(CliffKind::sample_on_edge, edge.where, in_words(touches, what),
                touches.exact > 0 ? 0x1p60 * static_cast<double>(touches.exact)
                                  : 1 / nearest_double(touches.nearest));
    }

    /// A fill's horizontal edge: it is a row, or is not.
    void look_at_row(const std::string& where, const Rational& y) {
        const Index row = nearest_index(y, Ties::up);
        const Rational distance = absolute(y - Rational(static_cast<long>(row)));
        if (scene_.canvas.row_of(row) >= 0 && scene_.canvas.row_of(row) < scene_.canvas.height &&
            distance <= Rational(least_distance))
            add(CliffKind::sample_on_edge, where,
                distance == 0
                    ? fmt::format("lies on row {}", row)
                    : fmt::format("lies {:.2g} px from row {}", nearest_double(distance), row),
                distance == 0 ? 0x1p60 : 1 / nearest_double(distance));
    }

    /// The marks of the canvas that an edge touches; x goes along it, y across.
    Touches touches_along(const Vec<Rational, 2>& from, const Vec<Rational, 2>& to,
                          const Marks& marks) const {
        const Canvas& canvas = scene_.canvas;
        const std::pair<Index, Index> columns{canvas.left(), canvas.right()};
        const std::pair<Index, Index> rows = std::minmax(canvas.top(), canvas.bottom());
        const auto& [low, high] = marks.along_x ? columns : rows;
        const auto& [low_across, high_across] = marks.along_x ? rows : columns;
        const Index first = std::max(low, ceil_index(Rational(from.x - marks.along)));
        const Index last = std::min(high, floor_index(Rational(to.x - marks.along)));

        const Rational slope = (to.y - from.y) / (to.x - from.x);
        const Rational start = from.y - slope * (from.x - marks.along) - marks.across;
        const NearMarks may_be_near(start, slope, low, high);
        Touches touches;
        for (Index i = first; i <= last; ++i) {
            if (!may_be_near(i))
                continue;
            const Rational across = start + slope * Rational(static_cast<long>(i));
            const Index index = nearest_index(across, Ties::up);
            if (index < low_across || index > high_across)
                continue;
            const Rational distance = absolute(across - Rational(static_cast<long>(index)));
            if (distance > Rational(least_distance))
                continue;
            (distance == 0 ? touches.exact : touches.near) += 1;
            if (!touches.place || distance < touches.nearest) {
                touches.nearest = distance;
                touches.place = marks.along_x ? GridPoint{i, index} : GridPoint{index, i};
            }
        }
        return touches;
    }

    Scene scene_;
    Geometry<Rational> geometry_;
    std::set<std::size_t> seen_vertices_; ///< places in the scene
    std::set<std::tuple<bool, std::size_t, std::size_t>>
        seen_edges_; ///< filled or not, and its ends
    std::array<std::vector<Cliff>, words_of_kinds.size()> found_;
    std::array<std::uint64_t, words_of_kinds.size()> more_{};
};

/// Of each primitive, by its name: a number from 1 on.
using NumberOfPrimitive = std::map<std::string, std::size_t, std::less<>>;

/// A picture, and the primitive that each pixel shows: the listener to its own drawing.
struct OwnedPicture {
    NumberOfPrimitive& numbers;
    Canvas canvas;
    std::vector<std::size_t> owners; ///< of the pixels; 0 is none
    std::size_t current = 0;
    Image image;

    OwnedPicture(const PlannedScene& planned, NumberOfPrimitive& numbers_of_names)
        : numbers(numbers_of_names), canvas(planned.scene.canvas), owners(canvas.area()),
          image(draw(planned.scene, planned.plan, *this)) {}

    void operator()(const PrimitiveBegan<>& began) {
        if (!began.part) // a part is of the primitive that began before it
            current =
                numbers.try_emplace(std::string(began.name), numbers.size() + 1).first->second;
    }
    void operator()(const PixelPlotted<>& plotted) {
        owners[canvas.offset_of(plotted.pixel())] = current;
    }

    /// The owner and the color of a pixel, which the canvas need not have.
    std::pair<std::size_t, Color> at(Pixel pixel) const {
        if (!canvas.contains(pixel.x, pixel.y))
            return {0, no_color};
        return {owners[canvas.offset_of(pixel)], image.at(pixel)};
    }
};

/// Counts the pixels that either picture draws, and those that differ. A canvas that is fitted to
/// rounded vertices may have a row or column that the other has not.
void compare(const OwnedPicture& picture, const OwnedPicture& exact, ComparedPicture& result) {
    const auto visit = [&](const Canvas& canvas, const auto& is_new) {
        for (int row = 0; row < canvas.height; ++row)
            for (int x = canvas.left(); x <= canvas.right(); ++x) {
                const Pixel pixel{x, canvas.y_of(row)};
                const auto found = picture.at(pixel);
                const auto right = exact.at(pixel);
                if (!is_new(pixel) || (found.first == 0 && right.first == 0))
                    continue;
                ++result.pixels;
                if (found == right)
                    continue;
                ++result.differing;
                result.first = result.first.value_or(pixel);
            }
    };
    visit(exact.canvas, [](Pixel) { return true; });
    visit(picture.canvas,
          [&exact](Pixel pixel) { return !exact.canvas.contains(pixel.x, pixel.y); });
}

} // namespace

std::string_view name_of(CliffKind kind) {
    return words_of_kinds[static_cast<std::size_t>(kind)].name;
}

std::string_view meaning_of(CliffKind kind) {
    return words_of_kinds[static_cast<std::size_t>(kind)].meaning;
}

std::vector<CliffGroup> cliffs_of(const Scene& scene) {
    return CliffFinder(scene).find();
}

std::vector<ComparedPicture> compared_pictures(const Source& source, const MethodOverrides& method,
                                               const InputLimits& limits,
                                               const FrameChoice& choice) {
    const auto read_with = [&](std::string_view scalar) {
        MethodOverrides with = method;
        with.emplace_back("scalar", scalar);
        return read_scene(source, with, limits, choice);
    };
    NumberOfPrimitive numbers;
    std::optional<OwnedPicture> exact;
    if (const auto scene = read_with("exact"))
        exact.emplace(scene.value(), numbers);

    std::vector<ComparedPicture> compared;
    for (const std::string_view scalar : find_method_key("scalar")->values) {
        ComparedPicture one{.scalar = std::string(scalar), .refusal = {}, .first = {}};
        const auto scene = read_with(scalar);
        if (!scene) {
            one.refusal = scene.problem().message;
        } else {
            const OwnedPicture picture(scene.value(), numbers);
            compare(picture, exact ? *exact : picture, one);
        }
        compared.push_back(std::move(one));
    }
    return compared;
}

} // namespace rastertrace
