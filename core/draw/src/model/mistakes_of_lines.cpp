// SPDX-License-Identifier: MIT
// Mistakes in lines.

#include "model/mistake_tables.h"

#include <cmath>

namespace rastertrace {

namespace {

bool has_line(const Scene& scene) {
    return scene.has(PrimitiveKind::line) || scene.has(PrimitiveKind::outline);
}
bool walks(const Scene& scene) {
    return has_line(scene) && scene.method.line == LineMethod::bresenham;
}
bool goes_in_steps(const Scene& scene) {
    return has_line(scene) && scene.method.line != LineMethod::diamond_exit;
}
bool samples_lines(const Scene& scene) {
    return has_line(scene) && traits_of(scene.method.line).rule == LineRule::rounding;
}
bool mixes_on_lines(const Scene& scene) {
    return has_line(scene) && scene.mixes_colors();
}

/// Bresenham's line with a change made to what is right.
template <typename Change> void change_line(ModelRules& rules, Change change) {
    rules.line = [right = rules.line, change](const Vec<Rational, 2>& from,
                                              const Vec<Rational, 2>& to) {
        ModelLine line = right(from, to);
        change(line);
        return line;
    };
}

/// The lengths along both axes of Bresenham's line: 2 (minor - major) is what a diagonal step adds.
Index minor_of(const ModelLine& line) {
    return line.d_straight / 2;
}

GridPoint turned(GridPoint step) {
    return {-step.x, -step.y};
}

/// The color whose channels are `level(from, to)` of those at the ends of a line.
template <typename Level> Color mixed(const GridLine& line, Level level) {
    const Color a = line.from_color, b = line.to_color;
    return {level(a.red(), b.red()), level(a.green(), b.green()), level(a.blue(), b.blue()),
            a.alpha()};
}

constexpr std::string_view right_start = "d = 2 dy - dx (steep: dx and dy exchanged)";
constexpr std::string_view right_d =
    "d = 2 dy - dx; d += 2 dy, or 2 (dy - dx) (steep: dx and dy exchanged)";

constexpr Mistake lines_table[] = {
    {"falling-octants", "d = -2 |dy| - |dx| at the start of lines with y2 < y1",
     "d = 2 |dy| - |dx|, whatever the signs", "decide", "falling lines end too high",
     "stackoverflow 10060046", walks,
     [](ModelRules& rules) {
         change_line(rules, [](ModelLine& line) {
             if (line.diagonal.y < 0)
                 line.d = -2 * minor_of(line) - line.steps;
         });
     }},
    {"factor-2-dropped", "d = 2 dy - dx; d += dy, or dy - dx", right_d, "decide",
     "the line steps too late", "encukou/bresenham#1", walks,
     [](ModelRules& rules) {
         change_line(rules, [](ModelLine& line) {
             line.d_straight /= 2;
             line.d_diagonal /= 2;
         });
     }},
    {"step-not-kept", "plot(x + 1, y + 1), and y stays", "y = y + 1, then plot(x + 1, y)", "decide",
     "lines end on the row that they begin on", "Bug with the Bresenham's?", walks,
     [](ModelRules& rules) {
         change_line(rules, [](ModelLine& line) { line.kept = line.straight; });
     }},
    {"inverse-octant-map", "octants 3 and 7 mapped back by the map that leads to them",
     "by its inverse", "decide", "no line to the south east", "bracket-lib#135", walks,
     [](ModelRules& rules) {
         change_line(rules, [](ModelLine& line) {
             if (!line.is_x_major && line.diagonal.x * line.diagonal.y < 0) {
                 line.straight = turned(line.straight);
                 line.diagonal = line.kept = turned(line.diagonal);
             }
         });
     }},
    {"octant-ignored", "x from x0 to x1; y + 1 if d > 0, with dx and dy as they are",
     "steps along the longer axis, with the signs of dx and dy", "decide",
     "lines that fall stay flat, steep ones run diagonally, those to the left are points",
     "T2, error 5", walks,
     [](ModelRules& rules) {
         change_line(rules, [](ModelLine& line) {
             const GridPoint end = nearest_pixel(line.to, SampleOffset<Rational>());
             const Index dx = end.x - line.start.x, dy = end.y - line.start.y;
             line.steps = std::max<Index>(dx, 0);
             line.straight = {1, 0};
             line.diagonal = line.kept = {1, 1};
             line.d = 2 * dy - dx;
             line.d_straight = 2 * dy;
             line.d_diagonal = 2 * (dy - dx);
         });
     }},
    {"octants-missing", "no case for y1 < y0", "all eight octants", "decide",
     "lines in some directions are missing", "OneLife#350", walks,
     [](ModelRules& rules) {
         change_line(rules, [](ModelLine& line) {
             if (line.diagonal.y < 0 && !(line.steps > 0 && minor_of(line) == 0 && line.is_x_major))
                 line.steps = 0;
         });
     }},
    {"tie-the-other-way", "d < 0 goes straight on", "d <= 0 goes straight on", "decide",
     "lines of even slopes step a pixel early", "T2, error 3", walks, nullptr, "ties=step"},
    {"start-of-other-axis", "d = 2 dx - dy", right_start, "decide",
     "the line steps too early at its start", "T2", walks,
     [](ModelRules& rules) {
         change_line(rules, [](ModelLine& line) { line.d = 2 * line.steps - minor_of(line); });
     }},
    {"d-from-zero", "d = 0", right_start, "decide", "the line steps half a step too late", "T2",
     walks, [](ModelRules& rules) { change_line(rules, [](ModelLine& line) { line.d = 0; }); }},
    {"steps-exchanged", "d += 2 (dy - dx) after a straight step, 2 dy after a diagonal one",
     right_d, "decide", "the line bends away", "T2", walks,
     [](ModelRules& rules) {
         change_line(rules, [](ModelLine& line) { std::swap(line.d_straight, line.d_diagonal); });
     }},
    {"diagonal-of-one-axis", "d += 2 dy after a diagonal step, too", right_d, "decide",
     "after its first step the line is diagonal", "T2", walks,
     [](ModelRules& rules) {
         change_line(rules, [](ModelLine& line) { line.d_diagonal = line.d_straight; });
     }},
    {"dx-and-dy-exchanged", "steps along the shorter axis", "steps along the longer axis", "decide",
     "lines are too short, or have gaps", "T2, error 6", walks,
     [](ModelRules& rules) {
         change_line(rules, [](ModelLine& line) {
             const Index minor = minor_of(line);
             line.is_x_major = !line.is_x_major;
             line.straight =
                 line.is_x_major ? GridPoint{line.diagonal.x, 0} : GridPoint{0, line.diagonal.y};
             line.d = 2 * line.steps - minor;
             line.d_straight = 2 * line.steps;
             line.d_diagonal = 2 * (line.steps - minor);
             line.steps = minor;
         });
     }},
    {"last-pixel-left-out", "x < x1", "x <= x1", "pixel", "the last pixel is missing",
     "lib-spectrum#4", has_line, nullptr, "ends=first"},
    {"only-to-the-right", "while x < x1, whichever way the line runs", "while x has not come to x1",
     "pixel", "lines to the left have one pixel", "T2, error 6", goes_in_steps,
     [](ModelRules& rules) {
         change_line(rules, [](ModelLine& line) {
             if (line.to.x < line.from.x) {
                 line.steps = 0;
                 line.last = line.first;
             }
         });
     }},
    {"y-of-the-start", "y = m x0 + b", "y = m x + b", "along", "lines are level", "T2, error 1",
     samples_lines,
     [](ModelRules& rules) {
         rules.across = [](const ModelLine& line, Index) {
             return line.is_x_major ? line.from.y : line.from.x;
         };
     }},
    {"slope-in-integers", "m = int(dy/dx)", "m = dy/dx", "along",
     "flat lines are level, others diagonal", "T2, error 2", samples_lines,
     [](ModelRules& rules) {
         change_line(rules, [](ModelLine& line) { line.slope = cut(line.slope); });
     }},
    {"always-along-x", "a step for each x, however steep", "a step for each y where |dy| > |dx|",
     "along", "steep lines have gaps", "T2, error 5", samples_lines,
     [](ModelRules& rules) {
         change_line(rules, [](ModelLine& line) {
             const Rational dx = line.to.x - line.from.x;
             line.is_x_major = true;
             line.first = nearest_index(line.from.x, Ties::up);
             line.last = nearest_index(line.to.x, Ties::up);
             line.steps = std::abs(line.last - line.first);
             line.slope = dx == 0 ? Rational(0) : Rational((line.to.y - line.from.y) / dx);
         });
     }},
    {"truncate-for-nearest", "int(y)", "round(y)", "along", "lines half a pixel too low", "T2",
     samples_lines, nullptr, "rounding=truncate"},
    {"sum-of-slopes-in-float", "y += m, in float", "y = y0 + m (x - x0)", "along",
     "long lines drift off", "stress L4", samples_lines,
     [](ModelRules& rules) {
         rules.across = [right = rules.across](const ModelLine& line, Index at) {
             auto y = static_cast<float>(right(line, line.first).get_d());
             const auto m = static_cast<float>(line.slope.get_d());
             for (Index i = line.first; i < at; ++i)
                 y += m;
             for (Index i = line.first; i > at; --i)
                 y -= m;
             return Rational(y);
         };
     }},
    {"from-the-other-end", "drawn from the end on the left", "drawn from its first end", "decide",
     "AB and BA are the same line", "T4, error 12", has_line, nullptr, "from=low"},
    {"x-from-unrounded-end", "y = y0 + m i at step i, from the end as it is", "", "along",
     "lines between ends that are not whole differ by a pixel here and there", "textbooks' DDA",
     samples_lines,
     [](ModelRules& rules) {
         rules.across = [](const ModelLine& line, Index at) {
             const Rational steps = std::abs(at - line.first);
             const bool goes_back = line.last < line.first;
             const Rational& start = line.is_x_major ? line.from.y : line.from.x;
             return Rational(start + (goes_back ? Rational(-line.slope) : line.slope) * steps);
         };
     }},
    {"share-turned-round", "share = whole distance / distance to the end",
     "distance to the end / whole distance", "pixel", "colors of a line overflow", "T4, error 10",
     mixes_on_lines,
     [](ModelRules& rules) {
         rules.color_of_step = [right = rules.color_of_step](const GridLine& line, GridPoint pixel,
                                                             Index step, Index steps) {
             if (step == 0 || step == steps)
                 return right(line, pixel, step, steps);
             const Rational share(steps, steps - step);
             const auto level = [&share](std::uint8_t from, std::uint8_t to) {
                 return static_cast<std::uint8_t>(
                     truncate_index(Rational(share * from + (1 - share) * to)));
             };
             return mixed(line, level);
         };
     }},
    {"color-summed-and-cut", "c += (c2 - c1)/n, then int(c)", "c = c1 + (c2 - c1) i/n, rounded",
     "pixel", "the last color is 254 for 255", "T2, error 8", mixes_on_lines,
     [](ModelRules& rules) {
         rules.color_of_step = [](const GridLine& line, GridPoint, Index step, Index steps) {
             const auto level = [step, steps](std::uint8_t from, std::uint8_t to) {
                 double channel = from;
                 for (Index i = 0; i < step; ++i)
                     channel += (static_cast<double>(to) - from) / static_cast<double>(steps);
                 return static_cast<std::uint8_t>(std::clamp(std::trunc(channel), 0.0, 255.0));
             };
             return mixed(line, level);
         };
     }},
    {"color-by-distance", "the color by the distance from the end", "the color by the steps",
     "pixel", "colors a little beside, most on diagonal lines", "T4, error 11", mixes_on_lines,
     nullptr, "color_lerp=distance"},
};

} // namespace

std::span<const Mistake> mistakes_of_lines() {
    return lines_table;
}

} // namespace rastertrace
