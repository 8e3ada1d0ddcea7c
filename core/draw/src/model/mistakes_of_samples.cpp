// SPDX-License-Identifier: MIT
// Mistakes in triangles that are filled by samples, and in where vertices go before.

#include "model/mistake_tables.h"

namespace rastertrace {

namespace {

bool has_owners(const Scene& scene) {
    return has_triangles(scene) && scene.method.fill == Fill::top_left;
}

bool has_large_samples(const Scene& scene) {
    return fills_by_samples(scene) && has_large_products(scene);
}

/// How much of the square around a sample lies in a triangle: the square cut at its three edges.
Rational covered_part(const ModelTriangle& triangle, GridPoint pixel) {
    const Rational half(1, 2);
    std::vector<Vec<Rational, 2>> polygon;
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
        polygon.push_back({pixel.x + half * x, pixel.y + half * y});
    const auto side = [](const Vec<Rational, 2>& a, const Vec<Rational, 2>& b,
                         const Vec<Rational, 2>& p) {
        return Rational((b.x - a.x) * (p.y - a.y) - (p.x - a.x) * (b.y - a.y));
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& a = triangle[i].at;
        const auto& b = triangle[(i + 1) % 3].at;
        const int inside = sgn(side(a, b, triangle[(i + 2) % 3].at));
        std::vector<Rational> sides;
        for (const auto& p : polygon)
            sides.push_back(side(a, b, p) * inside);
        const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
        if (*most <= 0)
            return 0;
        if (*least >= 0)
            continue;
        std::vector<Vec<Rational, 2>> left;
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const std::size_t next = (k + 1) % polygon.size();
            const auto &p = polygon[k], &q = polygon[next];
            if (sides[k] >= 0)
                left.push_back(p);
            if (sgn(sides[k]) * sgn(sides[next]) < 0) {
                const Rational way = sides[k] / (sides[k] - sides[next]);
                left.push_back({p.x + way * (q.x - p.x), p.y + way * (q.y - p.y)});
            }
        }
        polygon = std::move(left);
    }
    Rational twice = 0;
    for (std::size_t k = 2; k < polygon.size(); ++k)
        twice += abs(side(polygon[0], polygon[k - 1], polygon[k]));
    return twice / 2;
}

/// Fills by the part of a pixel that a triangle covers.
template <typename Enough> void fill_by_part(ModelRules& rules, Enough enough) {
    rules.scene.method.fill = Fill::top_left;
    rules.box = [](const ModelTriangle& triangle) {
        const auto& [a, b, c] = triangle;
        return BoundingBox{floor_index(std::min({a.at.x, b.at.x, c.at.x})),
                           ceil_index(std::max({a.at.x, b.at.x, c.at.x})),
                           floor_index(std::min({a.at.y, b.at.y, c.at.y})),
                           ceil_index(std::max({a.at.y, b.at.y, c.at.y}))};
    };
    rules.covers = [enough](const ModelTriangle& triangle, GridPoint pixel, const ModelWeights&) {
        return enough(covered_part(triangle, pixel));
    };
}

constexpr std::string_view as_it_is = "the vertex as it is";
constexpr std::string_view top_left = "E > 0, or E = 0 on a top or left edge";

constexpr Mistake samples_table[] = {
    {"tie-refused-by-both", "E > 0, with E the edge function at the sample", top_left, "sample",
     "holes along edges that two triangles share", "DRTK#9", fills_by_samples,
     [](ModelRules& rules) {
         rules.admits = [](const Rational& weight, const auto&, const auto&, const auto&) {
             return weight > 0;
         };
     }},
    {"tie-taken-by-both", "E >= 0, with E the edge function at the sample", top_left, "sample",
     "shared edges are drawn twice: visible where colors are mixed with what is there",
     "Avocado#18", has_owners, nullptr, "fill=barycentric,sample=center"},
    {"bottom-right-for-top-left", "E = 0 on a bottom or right edge", top_left, "sample",
     "everything lies one pixel to the lower right where edges meet samples",
     "SerenityOS/serenity#13738", has_owners,
     [](ModelRules& rules) {
         rules.admits = [right = rules.admits](const Rational& weight, const auto& from,
                                               const auto& to, const auto& opposite) {
             return weight == 0 ? !right(weight, from, to, opposite) : weight > 0;
         };
     }},
    {"every-horizontal-edge-is-top", "E = 0 on a horizontal or left edge", top_left, "sample",
     "rows that two triangles share are drawn twice", "SerenityOS/serenity#13738", has_owners,
     [](ModelRules& rules) {
         rules.admits = [right = rules.admits](const Rational& weight, const auto& from,
                                               const auto& to, const auto& opposite) {
             return right(weight, from, to, opposite) || (weight == 0 && from.at.y == to.at.y);
         };
     }},
    {"no-horizontal-edge-is-top", "E = 0 on a left edge", top_left, "sample",
     "rows that two triangles share are missing", "SerenityOS/serenity#13738", has_owners,
     [](ModelRules& rules) {
         rules.admits = [right = rules.admits](const Rational& weight, const auto& from,
                                               const auto& to, const auto& opposite) {
             return right(weight, from, to, opposite) && (weight != 0 || from.at.y != to.at.y);
         };
     }},
    {"tolerance-in-inside-test", "weight >= -0.001", top_left, "sample",
     "slivers beside every edge", "UCR CS130, a solution", has_triangles,
     [](ModelRules& rules) {
         // Where two weights are -t, the third is 1 + 2 t: a corner of the triangle of all points with at least -t.
         static const Rational t(1, 1000);
         rules.scene.method.fill = Fill::barycentric;
         rules.box = [right = rules.box](const ModelTriangle& triangle) {
             ModelTriangle widened = triangle;
             for (std::size_t i = 0; i < 3; ++i) {
                 const auto& a = triangle[i].at;
                 const auto& b = triangle[(i + 1) % 3].at;
                 const auto& c = triangle[(i + 2) % 3].at;
                 widened[i].at.x += t * (2 * a.x - b.x - c.x);
                 widened[i].at.y += t * (2 * a.y - b.y - c.y);
             }
             return right(widened);
         };
         rules.admits = [](const Rational& weight, const auto&, const auto&, const auto&) {
             return weight >= -t;
         };
     }},
    {"corner-for-center", "the sample of a pixel is (x, y)", "(x + 1/2, y + 1/2)", "sample",
     "pixels missing at the left, everything half a pixel off", "ppsspp#9681", fills_by_samples,
     nullptr, "sample=integer"},
    {"sample-at-7-12", "the sample of a pixel is (x + 7/12, y + 7/12)", "(x + 1/2, y + 1/2)",
     "sample", "edges one pixel to the lower right here and there", "dolphin#306", has_triangles,
     [](ModelRules& rules) { rules.sample = Rational(7, 12); }},
    {"vertices-in-the-middle", "vertex = floor(vertex) + 1/2", as_it_is, "vertex",
     "half a pixel off, but not constantly", "datashader#806", has_triangles,
     [](ModelRules& rules) {
         rules.placed = [](const Vec<Rational, 2>& at) {
             return Vec<Rational, 2>{floor_index(at.x) + Rational(1, 2),
                                     floor_index(at.y) + Rational(1, 2)};
         };
     }},
    {"vertices-rounded", "vertex = round(vertex)", as_it_is, "vertex",
     "edges jump while things move", "T3", has_triangles, nullptr, "snap=nearest"},
    {"vertices-cut-off", "vertex = int(vertex)", as_it_is, "vertex",
     "everything up to a pixel too near to 0", "T0, error 14", has_triangles, nullptr,
     "snap=truncate"},
    {"vertices-floored", "vertex = floor(vertex)", as_it_is, "vertex",
     "everything up to a pixel beside", "T0", has_triangles, nullptr, "snap=floor"},
    {"one-winding-only", "E >= 0 for all three, whatever the winding",
     "E turned for triangles of the other winding", "sample",
     "triangles of one winding are missing", "T3, error 5", fills_by_samples,
     [](ModelRules& rules) {
         rules.covers = [right = rules.covers](const ModelTriangle& triangle, GridPoint pixel,
                                               const ModelWeights& weights) {
             const auto& [a, b, c] = triangle;
             const Rational area2 =
                 (b.at.x - a.at.x) * (c.at.y - a.at.y) - (c.at.x - a.at.x) * (b.at.y - a.at.y);
             return area2 < 0 && right(triangle, pixel, weights);
         };
     }},
    {"third-edge-not-tested",
     "in[i+1 % 3], which is in[i+1]: the edge from C is that from C to nowhere", "in[(i + 1) % 3]",
     "sample", "triangles have no third side", "UCR CS130, a solution", fills_by_samples,
     [](ModelRules& rules) {
         rules.covers = [right = rules.covers](const ModelTriangle& triangle, GridPoint pixel,
                                               ModelWeights weights) {
             weights[1] = 1; // opposite to the edge from C to A
             return right(triangle, pixel, weights);
         };
     }},
    {"box-end-left-out", "x < right, y < bottom of the box", "x <= right, y <= bottom", "sample",
     "the last column and row of a triangle are missing", "loops that end with <", fills_by_samples,
     [](ModelRules& rules) {
         rules.box = [right = rules.box](const ModelTriangle& triangle) {
             BoundingBox box = right(triangle);
             --box.last_x;
             --box.last_row;
             return box;
         };
     }},
    {"product-in-16-bits-of-samples", "E = int16(a (x - x1)) + int16(b (y - y1))",
     "E = a (x - x1) + b (y - y1)", "sample", "wild stripes in large triangles",
     "Adafruit-GFX-Library#218", has_large_samples,
     [](ModelRules& rules) {
         rules.covers = [right = rules.covers](const ModelTriangle& triangle, GridPoint pixel,
                                               ModelWeights weights) {
             const auto held = [](const Rational& product) {
                 const Index whole = truncate_index(product);
                 return Rational(product - whole + wrapped(whole, 16));
             };
             for (std::size_t i = 0; i < 3; ++i) {
                 const auto& from = triangle[(i + 1) % 3].at;
                 const auto& to = triangle[(i + 2) % 3].at;
                 const auto& third = triangle[i].at;
                 const auto value = [&](const Rational& x, const Rational& y) {
                     return Rational(held((from.y - to.y) * (x - from.x)) +
                                     held((to.x - from.x) * (y - from.y)));
                 };
                 const Rational inside =
                     (from.y - to.y) * (third.x - from.x) + (to.x - from.x) * (third.y - from.y);
                 weights[i] = value(pixel.x, pixel.y) * sgn(inside);
             }
             return right(triangle, pixel, weights);
         };
     }},
    {"any-part-of-the-pixel", "a pixel is drawn if the triangle has any part of it", "", "sample",
     "triangles are one pixel fatter", "conservative rasterization", has_triangles,
     [](ModelRules& rules) { fill_by_part(rules, [](const Rational& part) { return part > 0; }); }},
    {"half-of-the-pixel", "a pixel is drawn if the triangle has half of it or more", "", "sample",
     "corners are rounder, thin triangles have gaps", "area coverage", has_triangles,
     [](ModelRules& rules) {
         fill_by_part(rules, [](const Rational& part) { return part >= Rational(1, 2); });
     }},
};

} // namespace

std::span<const Mistake> mistakes_of_samples() {
    return samples_table;
}

} // namespace rastertrace
