// SPDX-License-Identifier: MIT
// Mistakes in triangles that are filled row by row.

#include "model/mistake_tables.h"

namespace rastertrace {

namespace {

Rational x_at(const ModelEdge& edge, const Rational& y) {
    return edge.from.at.x + edge.dx_dy * (y - edge.from.at.y);
}

bool has_large_rows(const Scene& scene) {
    return fills_rows(scene) && has_large_products(scene);
}
bool has_far_rows(const Scene& scene) {
    return fills_rows(scene) && has_far_x(scene);
}

constexpr std::string_view floor_of_x = "rounding down, floor(x)";
constexpr std::string_view floor_of_ends =
    "rounding down at both ends, floor(left) to floor(right)";
constexpr std::string_view right_slope = "dx/dy = (x2 - x1)/(y2 - y1)";
constexpr std::string_view right_x = "x = x1 + (x2 - x1)/(y2 - y1) (y - y1)";

constexpr Mistake rows_table[] = {
    {"dx-dy-inverted", "dx/dy = (y2 - y1)/(x2 - x1)", right_slope, "edge",
     "steep edges lie flat, flat ones are steep", "T0, error 1", fills_rows,
     [](ModelRules& rules) {
         rules.slope = [](const ModelEdge& edge) {
             const Rational dx = edge.to.at.x - edge.from.at.x;
             return dx == 0 ? Rational(0) : Rational((edge.to.at.y - edge.from.at.y) / dx);
         };
     }},
    {"slope-of-zero", "dx/dy = (x2 - x2)/(y2 - y1)", right_slope, "edge",
     "edges run straight down from their upper vertices", "T0, error 2", fills_rows,
     [](ModelRules& rules) { rules.slope = [](const ModelEdge&) { return Rational(0); }; }},
    {"step-before-first", "x = x1 + (x2 - x1)/(y2 - y1) (y + 1 - y1)", right_x, "scanline",
     "every row has the ends of the row below it", "T0, error 3", fills_rows,
     [](ModelRules& rules) {
         rules.x_on = [](const ModelEdge& edge, Index y) { return x_at(edge, y + 1); };
     }},
    {"start-and-step-exchanged", "x = (x2 - x1)/(y2 - y1) + x1 (y - y1)", right_x, "scanline",
     "rows fly apart", "T0, error 15", fills_rows,
     [](ModelRules& rules) {
         rules.x_on = [](const ModelEdge& edge, Index y) {
             return Rational(edge.dx_dy + edge.from.at.x * (y - edge.from.at.y));
         };
     }},
    {"middle-row-twice", "upper edge, then lower edge with the row of the middle vertex once more",
     "the row of the middle vertex once", "scanline",
     "below the middle vertex, one end lies a row too low", "T0, error 5", fills_by_rows,
     [](ModelRules& rules) {
         rules.x_on = [](const ModelEdge& edge, Index y) {
             const bool is_late = edge.role == ModelEdge::Role::lower && y - 1 >= edge.from.at.y;
             return x_at(edge, is_late ? y - 1 : y);
         };
     }},
    {"sides-exchanged", "from the right edge to the left one",
     "from the left edge to the right one", "scanline",
     "only rows whose ends are one pixel are drawn", "T0, error 6", fills_rows,
     [](ModelRules& rules) {
         rules.span = [right_way = rules.span](const Rational& left, const Rational& right) {
             return right_way(right, left);
         };
     }},
    {"not-sorted", "top, middle, bottom = the first, second, third vertex",
     "top, middle, bottom by their y", "scanline",
     "triangles are missing, or torn, as their vertices are named", "T0, error 7", fills_by_rows,
     [](ModelRules& rules) {
         rules.sorted_from_top = [](const ModelTriangle& triangle) { return triangle; };
     }},
    {"shorter-sides-joined", "the two shorter sides are joined against the longest",
     "the two sides of the smaller heights are joined against the tallest", "scanline",
     "flat triangles are torn at their middle vertex", "T0, error 8", fills_by_rows,
     [](ModelRules& rules) {
         rules.sorted_from_top = [by_height =
                                      rules.sorted_from_top](const ModelTriangle& triangle) {
             const auto& [a, b, c] = by_height(triangle);
             const auto length2 = [](const ModelVertex& p, const ModelVertex& q) {
                 const Rational dx = q.at.x - p.at.x, dy = q.at.y - p.at.y;
                 return Rational(dx * dx + dy * dy);
             };
             const Rational ab = length2(a, b), bc = length2(b, c), ac = length2(a, c);
             if (ab > bc && ab > ac)
                 return ModelTriangle{a, c, b};
             return bc > ac ? ModelTriangle{b, a, c} : ModelTriangle{a, b, c};
         };
     }},
    {"height-plus-one",
     "dx/dy = (x2 - x1)/(y2 - y1 + 1) on the two edges that meet in the middle vertex", right_slope,
     "edge", "gaps and overlaps along short edges, the more the flatter", "tinyrenderer#32",
     fills_by_rows,
     [](ModelRules& rules) {
         rules.slope = [right = rules.slope](const ModelEdge& edge) {
             if (edge.role == ModelEdge::Role::long_edge)
                 return right(edge);
             // Of vertices that were not sorted, -1 is a height too.
             const Rational height = edge.to.at.y - edge.from.at.y + 1;
             return height == 0 ? Rational(0) : Rational((edge.to.at.x - edge.from.at.x) / height);
         };
     }},
    {"pre-step-a-row-off",
     "first row floor(y1) + 1 with the x of row ceil(y1): these two differ where y1 is whole",
     "first row ceil(y1), and the x of that row", "scanline",
     "cracks where triangles join, if vertices have whole y",
     "GameDev.net, Triangle Rasterization Troubles, 2012", fills_by_rows,
     [](ModelRules& rules) {
         rules.rows = [](const Rational& top, const Rational& bottom) {
             return std::pair{floor_index(top) + 1, floor_index(bottom)};
         };
         rules.first_lower_row = [](const ModelTriangle& sorted) {
             return floor_index(sorted[1].at.y) + 1;
         };
         rules.x_on = [](const ModelEdge& edge, Index y) {
             return x_at(edge, floor_index(edge.from.at.y) == edge.from.at.y ? y - 1 : y);
         };
     }},
    {"y-snapped-alone", "x = x1 + (x2 - x1)/(y2 - y1) (y - nearest(y1))", right_x, "scanline",
     "seams in nearly every scene whose vertices are not whole", "GLideN64#1731", fills_rows,
     [](ModelRules& rules) {
         rules.x_on = [](const ModelEdge& edge, Index y) {
             return Rational(edge.from.at.x +
                             edge.dx_dy * (y - nearest_index(edge.from.at.y, Ties::up)));
         };
     }},
    {"right-end-included", "last = floor(right)", "last = ceil(right) - 1", "scanline",
     "one column too many where the right edge lies on whole x", "TIC-80#1059", is_half_open,
     [](ModelRules& rules) {
         rules.span = [](const Rational& left, const Rational& right) {
             return std::pair{ceil_index(left), floor_index(right)};
         };
     },
     "rounding=inside"},
    {"right-end-left-out", "x < last", "x <= last", "scanline", "one column too few at the right",
     "loops that end with <", fills_rows,
     [](ModelRules& rules) {
         rules.span = [right_way = rules.span](const Rational& left, const Rational& right) {
             const auto [from, to] = right_way(left, right);
             return std::pair{from, to - 1};
         };
     }},
    {"left-end-left-out", "x = first + 1", "x = first", "scanline",
     "one column too few at the left", "pixels missing at the left: ppsspp#9681", fills_rows,
     [](ModelRules& rules) {
         rules.span = [right_way = rules.span](const Rational& left, const Rational& right) {
             const auto [from, to] = right_way(left, right);
             return std::pair{from + 1, to};
         };
     }},
    {"bottom-row-left-out", "y < last row", "y <= last row", "scanline",
     "the lowest row is missing", "loops that end with <", fills_by_rows,
     [](ModelRules& rules) {
         rules.rows = [right = rules.rows](const Rational& top, const Rational& bottom) {
             const auto [first, last] = right(top, bottom);
             return std::pair{first, last - 1};
         };
     }},
    {"bottom-row-included", "y <= floor(y3)", "y < ceil(y3)", "scanline",
     "the row between two triangles is drawn by both", "TIC-80#776", fills_by_rows, nullptr,
     "rows=closed"},
    {"top-row-left-out", "first row floor(y1) + 1", "first row ceil(y1)", "scanline",
     "the highest row is missing where it has a whole y", "loops that begin one too late",
     fills_by_rows,
     [](ModelRules& rules) {
         rules.rows = [right = rules.rows](const Rational& top, const Rational& bottom) {
             return std::pair{floor_index(top) + 1, right(top, bottom).second};
         };
     }},
    {"sum-in-float", "x += dx/dy, in float", right_x, "scanline",
     "ends one pixel off where edges meet whole x", "stress S4", fills_rows,
     [](ModelRules& rules) {
         rules.x_on = [](const ModelEdge& edge, Index y) {
             const Index first = ceil_index(edge.from.at.y);
             auto x = static_cast<float>(x_at(edge, first).get_d());
             const auto step = static_cast<float>(edge.dx_dy.get_d());
             for (Index row = first; row < y; ++row)
                 x += step;
             return Rational(x);
         };
     }},
    {"product-in-16-bits", "x = x1 + int16((x2 - x1) (y - y1))/(y2 - y1)", right_x, "scanline",
     "large triangles run wild at their lower end", "Adafruit-GFX-Library#164, #218",
     has_large_rows,
     [](ModelRules& rules) {
         rules.x_on = [](const ModelEdge& edge, Index y) {
             const Rational height = edge.to.at.y - edge.from.at.y;
             const Rational product = (edge.to.at.x - edge.from.at.x) * (y - edge.from.at.y);
             const Index held = wrapped(truncate_index(product), 16);
             return height == 0 ? edge.from.at.x : Rational(edge.from.at.x + cut(held / height));
         };
         rules.span = [right_way = rules.span](const Rational& left, const Rational& right) {
             return right_way(std::min(left, right), std::max(left, right));
         };
     }},
    {"fixed-point-overflow", "x in 16.16: beyond 32767 it turns negative", right_x, "scanline",
     "triangles far off the canvas come back on its other side", "keeperfx#4668", has_far_rows,
     [](ModelRules& rules) {
         rules.x_on = [](const ModelEdge& edge, Index y) {
             const Index units = floor_index(Rational(x_at(edge, y) * 65536));
             return Rational(wrapped(units, 32), 65536);
         };
     }},
    {"integer-division", "dx/dy = int((x2 - x1)/(y2 - y1))", right_slope, "edge",
     "slopes below 1 are 0: edges run straight down", "C's / of ints", fills_rows,
     [](ModelRules& rules) {
         rules.slope = [right = rules.slope](const ModelEdge& edge) { return cut(right(edge)); };
     }},
    {"rounded-too-early", "x = round(x + dx/dy) on every row",
     "x += dx/dy, rounded for the pixel alone", "scanline", "edges drift from their ends",
     "T0, error 3", fills_rows,
     [](ModelRules& rules) {
         rules.x_on = [](const ModelEdge& edge, Index y) {
             const Index first = ceil_index(edge.from.at.y);
             const Index at_first = nearest_index(x_at(edge, first), Ties::up);
             return Rational(at_first + nearest_index(edge.dx_dy, Ties::up) * (y - first));
         };
     }},
    {"truncate-for-floor", "rounding toward 0, int(x)", floor_of_x, "scanline",
     "left of x = 0, rows begin and end one pixel too far right", "T0, figures", rounds_down,
     nullptr, "rounding=truncate"},
    {"nearest-for-floor", "rounding to the nearest, round(x)", floor_of_x, "scanline",
     "half of the ends lie one pixel too far right", "T0 against T2", rounds_down, nullptr,
     "rounding=nearest"},
    {"inside-for-floor", "only the pixels between the ends, ceil(left) to floor(right)",
     floor_of_ends, "scanline", "rows begin one pixel too late", "T3", rounds_down, nullptr,
     "rounding=inside"},
    {"half-open-for-floor", "leaving out the right end, ceil(left) to ceil(right) - 1",
     floor_of_ends, "scanline", "rows end one pixel too early", "TIC-80#1862", rounds_down, nullptr,
     "rounding=half-open"},
    {"half-open-left-out", "y <= floor(y3), x <= floor(right)", "y < ceil(y3), x < ceil(right)",
     "scanline", "shared edges are drawn by both triangles", "Avocado#18", is_half_open, nullptr,
     "rounding=inside,rows=closed"},
    {"lines-for-rows", "a line from each pixel of AB to C", "rows from edge to edge", "scanline",
     "holes, and pixels that are written again and again", "T4, error 13", has_triangles, nullptr,
     "fill=fan"},
    {"drop-out-control", "a row between two samples has the nearer one", "", "scanline",
     "thin triangles have no gaps", "TrueType", fills_rows,
     [](ModelRules& rules) {
         rules.span = [right_way = rules.span](const Rational& left, const Rational& right) {
             const auto span = right_way(left, right);
             const Index middle = nearest_index(Rational((left + right) / 2), Ties::start);
             return span.second < span.first && !(right < left) ? std::pair{middle, middle} : span;
         };
     }},
    {"outline-with-fill", "the fill, and a line along each side", "", "scanline",
     "edges lie on pixels beside the fill", "T2 with T0", has_triangles,
     [](ModelRules& rules) { rules.draws_outlines = true; }},
};

} // namespace

std::span<const Mistake> mistakes_of_rows() {
    return rows_table;
}

} // namespace rastertrace
