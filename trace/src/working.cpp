// SPDX-License-Identifier: MIT
#include <rastertrace/trace/working.h>

#include "step_text.h"

#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/core/numbers/number.h>
#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/scene/stages.h>
#include <rastertrace/trace/scene_file.h>
#include <rastertrace/trace/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string_view>

namespace rastertrace {

namespace {

/// What a working is made of, and its lines so far.
struct Sheet {
    const Replay& replay;
    StepView step;
    PrimitiveText primitive;
    std::vector<std::string> lines = {};

    void put(std::string line) { lines.push_back(std::move(line)); }

    const Trace& trace() const { return replay.trace(); }
};

// Numbers.

template <std::size_t size>
std::optional<std::array<Rational, size>> numbers_in(const std::vector<std::string>& texts) {
    std::array<Rational, size> numbers;
    if (texts.size() < size)
        return std::nullopt;
    for (std::size_t i = 0; i < size; ++i) {
        const auto number = number_in(texts[i]);
        if (!number)
            return std::nullopt;
        numbers[i] = *number;
    }
    return numbers;
}

/// 2 (-3), (-2) (-3)
std::string product(const Rational& a, const Rational& b) {
    return sgn(a) < 0 ? fmt::format("({}) ({})", text(a), text(b))
                      : fmt::format("{} ({})", text(a), text(b));
}

/// True if a result is what the trace tells: as far as doubles go.
bool agrees(const Rational& worked_out, const Rational& told) {
    const double difference = std::abs(nearest_double(worked_out - told));
    return difference <= 1e-9 * std::max(1.0, std::abs(nearest_double(told)));
}

/// The square root of what a double can hold.
std::optional<Rational> root_of(const Rational& square) {
    return std::isnormal(nearest_double(square)) || sgn(square) == 0
               ? std::optional(square_root(square))
               : std::nullopt;
}

/// sqrt(83/9) = 3.036811
std::string length_of(const Vec3& v) {
    const Rational square = dot(v, v);
    const auto root = root_of(square);
    if (!root)
        return fmt::format("sqrt({})", text(square));
    return has_rational_root(square)
               ? text(*root)
               : fmt::format("sqrt({}) = {}", text(square), six_places(nearest_double(*root)));
}

// Corners.

/// Where they are in one of these spaces, the last that they have been in: as the `vertex` steps before
/// the first primitive tell.
std::optional<std::array<Vec3, 3>>
corners_in_space(const Sheet& sheet, std::initializer_list<std::string_view> spaces) {
    const auto& names = sheet.primitive.vertices;
    if (names.size() != 3)
        return std::nullopt;
    std::array<std::optional<Vec3>, 3> found;
    for (std::size_t n = 1; n <= sheet.trace().size(); ++n) {
        const auto kind = sheet.trace().kind_of(n);
        if (kind == StepKind::primitive)
            break;
        if (kind != StepKind::vertex)
            continue;
        const StepView vertex = sheet.trace().step(n);
        const std::string space = vertex.text("space");
        const auto corner = std::find(names.begin(), names.end(), vertex.text("name"));
        if (corner != names.end() && std::find(spaces.begin(), spaces.end(), space) != spaces.end())
            found[static_cast<std::size_t>(corner - names.begin())] = vec3_in(vertex.texts("at"));
    }
    if (!found[0] || !found[1] || !found[2])
        return std::nullopt;
    return std::array{*found[0], *found[1], *found[2]};
}

/// Without a model, objects stand in the world as they are.
std::optional<std::array<Vec3, 3>> world_corners_of(const Sheet& sheet) {
    return corners_in_space(sheet, {"object", "world"});
}

/// Without a camera, it stands at the origin of the world.
std::optional<std::array<Vec3, 3>> camera_corners_of(const Sheet& sheet) {
    return corners_in_space(sheet, {"object", "world", "camera"});
}

// Kinds of steps.

using Matrix4 = std::array<std::array<Rational, 4>, 4>;

/// The four rows from `first` on.
std::optional<Matrix4> matrix_of(const std::vector<std::vector<std::string>>& rows,
                                 std::size_t first = 0) {
    Matrix4 matrix;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto row = first + i < rows.size() ? numbers_in<4>(rows[first + i]) : std::nullopt;
        if (!row)
            return std::nullopt;
        matrix[i] = *row;
    }
    return matrix;
}

std::optional<Matrix4> matrix_in(const StepView& step) {
    return matrix_of(step.text_rows("rows"));
}

Matrix4 product(const Matrix4& a, const Matrix4& b) {
    Matrix4 result;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t k = 0; k < 4; ++k)
                result[i][j] += a[i][k] * b[k][j];
    return result;
}

/// The matrices that a `matrix` step tells its matrix to be the product of; none if it is not.
std::vector<Matrix4> factors_in(const StepView& step) {
    const auto rows = step.text_rows("factor_rows");
    std::vector<Matrix4> factors;
    std::optional<Matrix4> together;
    for (std::size_t first = 0; first < rows.size(); first += 4) {
        const auto factor = matrix_of(rows, first);
        if (!factor)
            return {};
        together = together ? product(*together, *factor) : *factor;
        factors.push_back(*factor);
    }
    const auto told = matrix_in(step);
    if (!together || !told)
        return {};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            if (!agrees((*together)[i][j], (*told)[i][j]))
                return {};
    return factors;
}

/// [1 0 0 4]
std::string row_text(const std::array<Rational, 4>& row) {
    return fmt::format("[{} {} {} {}]", text(row[0]), text(row[1]), text(row[2]), text(row[3]));
}

/// (y1 z2 - z1 y2, z1 x2 - x1 z2, x1 y2 - y1 x2)
std::string cross_written_out(const Vec3& a, const Vec3& b) {
    return fmt::format("({} - {}, {} - {}, {} - {})", product(a.y, b.z), product(a.z, b.y),
                       product(a.z, b.x), product(a.x, b.z), product(a.x, b.y), product(a.y, b.x));
}

/// The axes of a camera: d = p - l, up x d, d x (up x d), each divided by its length. They are the rows
/// of its rotation.
void put_camera(Sheet& sheet, const Matrix4& rotation) {
    const auto vectors = sheet.step.text_rows("camera");
    const auto p = vectors.size() == 3 ? vec3_in(vectors[0]) : std::nullopt;
    const auto l = vectors.size() == 3 ? vec3_in(vectors[1]) : std::nullopt;
    const auto up = vectors.size() == 3 ? vec3_in(vectors[2]) : std::nullopt;
    if (!p || !l || !up)
        return;
    const Vec3 d = *p - *l;
    const Vec3 right = cross(*up, d);
    const Vec3 upward = cross(d, right);
    const Vec3 z{rotation[2][0], rotation[2][1], rotation[2][2]};
    const bool looks_along_z = sgn(dot(z, d)) < 0; // as T0's pinhole does
    const auto is_along = [](const std::array<Rational, 4>& row, const Vec3& v) {
        const auto length = root_of(dot(v, v));
        return length && sgn(*length) != 0 && agrees(v.x / *length, row[0]) &&
               agrees(v.y / *length, row[1]) && agrees(v.z / *length, row[2]);
    };
    if (!is_along(rotation[0], right) || !is_along(rotation[1], upward) ||
        !is_along(rotation[2], looks_along_z ? *l - *p : d))
        return;
    const auto axis = [&rotation](std::size_t row) {
        return text(Vec3{rotation[row][0], rotation[row][1], rotation[row][2]});
    };
    sheet.put(fmt::format("d = p - l = {} - {} = {}, |d| = {}", text(*p), text(*l), text(d),
                          length_of(d)));
    sheet.put(fmt::format("up x d = {}", cross_written_out(*up, d)));
    sheet.put(fmt::format("= {}, |up x d| = {}", text(right), length_of(right)));
    sheet.put(fmt::format("d x (up x d) = {}", cross_written_out(d, right)));
    sheet.put(fmt::format("= {}, |d x (up x d)| = {}", text(upward), length_of(upward)));
    sheet.put(fmt::format("x = (up x d) / |up x d| = {}", axis(0)));
    sheet.put(fmt::format("y = d x (up x d) / |d x (up x d)| = {}", axis(1)));
    sheet.put(fmt::format("z = {} / |d| = {}", looks_along_z ? "-d" : "d", axis(2)));
}

/// What a matrix is a product of, and the camera that it comes of; then the matrices up to this one as
/// one: view x model, projection x view x model.
void matrix(Sheet& sheet) {
    const std::string name = sheet.step.text("name");
    const auto factors = factors_in(sheet.step);
    const auto factor_names = sheet.step.texts("factors");
    if (name == "view" && !factors.empty())
        put_camera(sheet, factors.front());
    for (std::size_t i = 0; factors.size() > 1 && i < std::min(factors.size(), factor_names.size());
         ++i) {
        const auto& rows = factors[i];
        sheet.put(fmt::format("{}:  {}  {}  {}  {}", factor_names[i], row_text(rows[0]),
                              row_text(rows[1]), row_text(rows[2]), row_text(rows[3])));
    }
    if (name == "viewport" || name == "model")
        return;
    std::optional<Matrix4> together;
    std::string names;
    std::string last_name;
    for (std::size_t n = 1; n <= sheet.replay.step(); ++n) {
        const StepView step = sheet.trace().step(n);
        const auto one =
            sheet.trace().kind_of(n) == StepKind::matrix ? matrix_in(step) : std::nullopt;
        if (!one || step.field("object") || last_name == step.text("name"))
            return; // several objects have several products
        last_name = step.text("name");
        together = together ? product(*one, *together) : *one;
        names = names.empty() ? step.text("name") : step.text("name") + " x " + names;
    }
    if (!together || names == name)
        return;
    sheet.put(fmt::format("{}:", names));
    for (const auto& row : *together)
        sheet.put(row_text(row));
}

/// The matrix that leads into a space.
std::string_view matrix_into(std::string_view space) {
    return space == "world"    ? "model"
           : space == "camera" ? "view"
           : space == "clip"   ? "projection"
           : space == "screen" ? "viewport"
                               : "";
}

/// A matrix times a vertex, or a division by w.
void vertex(Sheet& sheet) {
    if (sheet.replay.vertex_before() == 0)
        return;
    const StepView before = sheet.trace().step(sheet.replay.vertex_before());
    auto from = before.texts("at");
    const auto at = sheet.step.texts("at");
    if (before.text("name") != sheet.step.text("name") || from.size() < 3)
        return;
    constexpr std::array names{"x", "y", "z", "w"};
    if (sheet.step.text("space") == "canonical" && from.size() == 4 && at.size() == 3) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto clip = number_in(from[i]);
            const auto w = number_in(from[3]);
            const auto told = number_in(at[i]);
            if (clip && w && told && sgn(*w) != 0 && agrees(*clip / *w, *told))
                sheet.put(fmt::format("{} = {} = {}", names[i],
                                      quotient(in_sentence(from[i]), in_sentence(from[3])),
                                      in_sentence(at[i])));
        }
        return;
    }
    if (from.size() == 3)
        from.emplace_back("1");
    const auto vector = numbers_in<4>(from);
    const std::string_view wanted = matrix_into(sheet.step.text("space"));
    if (!vector || wanted.empty())
        return;
    for (std::size_t n = 1; n < sheet.replay.step(); ++n) {
        const StepView step = sheet.trace().step(n);
        if (sheet.trace().kind_of(n) != StepKind::matrix || step.text("name") != wanted)
            continue;
        const auto matrix = matrix_in(step);
        if (!matrix)
            continue;
        std::vector<std::string> lines;
        bool is_this = true;
        for (std::size_t i = 0; i < at.size() && i < 4; ++i) {
            const auto& row = (*matrix)[i];
            Rational sum;
            for (std::size_t k = 0; k < 4; ++k)
                sum += row[k] * (*vector)[k];
            const auto told = number_in(at[i]);
            is_this = is_this && told && agrees(sum, *told);
            lines.push_back(
                fmt::format("{} = {} + {} + {} + {} = {}", names[i], product(row[0], (*vector)[0]),
                            product(row[1], (*vector)[1]), product(row[2], (*vector)[2]),
                            product(row[3], (*vector)[3]), in_sentence(at[i])));
        }
        if (is_this) { // of several objects, the one that this vertex belongs to
            sheet.lines = std::move(lines);
            return;
        }
    }
}

void order(Sheet& sheet) {
    const auto names = sheet.step.texts("names");
    const auto distances = sheet.step.texts("distances");
    for (std::size_t i = 0; i < names.size() && i < distances.size(); ++i)
        sheet.put(fmt::format("{}. {} at {}", i + 1, names[i], in_sentence(distances[i])));
}

/// AB, or A1-B1.
std::string side_name(const PrimitiveText& primitive, std::size_t from, std::size_t to) {
    const std::vector<std::string_view> names(primitive.vertices.begin(), primitive.vertices.end());
    return fmt::format("{}{}{}", names[from], name_separator(names), names[to]);
}

/// Which way a triangle is turned: each vertex against the edge before it.
void primitive(Sheet& sheet) {
    const auto corners = corners_of(sheet.primitive);
    if (!corners)
        return;
    const auto& names = sheet.primitive.vertices;
    const bool is_y_up = sheet.trace().canvas.down() < 0;
    const Rational area = doubled_area((*corners)[0], (*corners)[1], (*corners)[2]);
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec2& a = (*corners)[i];
        const Vec2& b = (*corners)[(i + 1) % 3];
        const Vec2& p = (*corners)[(i + 2) % 3];
        const Rational value = doubled_area(a, b, p);
        const bool is_left = (sgn(value) > 0) == is_y_up;
        sheet.put(fmt::format(
            "{0} x {1} = {2} - {3} = {4}: {5} lies {6}", side_name(sheet.primitive, i, (i + 1) % 3),
            side_name(sheet.primitive, i, (i + 2) % 3), product(b.x - a.x, p.y - a.y),
            product(b.y - a.y, p.x - a.x), text(value), names[(i + 2) % 3],
            sgn(value) == 0 ? "on it"
            : is_left       ? "left of it"
                            : "right of it"));
    }
    const std::string_view turn = sgn(area) == 0               ? "no area"
                                  : (sgn(area) > 0) == is_y_up ? "counter-clockwise"
                                                               : "clockwise";
    sheet.put(fmt::format("area = |{}| / 2 = {}, {}", text(area), text(abs(area) / 2), turn));
}

/// normal . v, the lengths of both, and the angle between them.
void put_angle(Sheet& sheet, const Vec3& normal, const Vec3& v, std::string_view name) {
    const Rational value = dot(normal, v);
    const auto told = number_in(sheet.step, "dot");
    if (!told || !agrees(value, *told))
        return;
    sheet.put(fmt::format("normal . {} = {} + {} + {} = {}", name, product(normal.x, v.x),
                          product(normal.y, v.y), product(normal.z, v.z), text(value)));
    sheet.put(fmt::format("|normal| = {}, |{}| = {}", length_of(normal), name, length_of(v)));
    const auto lengths = root_of(dot(normal, normal) * dot(v, v));
    if (!lengths || sgn(*lengths) == 0)
        return;
    const double cosine = std::clamp(nearest_double(value / *lengths), -1.0, 1.0);
    sheet.put(fmt::format("cosine = {} / (|normal| |{}|) = {}, an angle of {:.2f} degrees",
                          text(value), name, six_places(cosine), degrees_of_cosine(cosine)));
}

/// The normal of a face from its corners in the world, and the plane that it lies in.
void put_normal(Sheet& sheet, const Vec3& normal) {
    const auto corners = world_corners_of(sheet);
    if (!corners)
        return;
    const auto& [a, b, c] = *corners;
    const auto& names = sheet.primitive.vertices;
    const Vec3 first = b - a;
    const Vec3 second = c - a;
    const Vec3 worked_out = cross(first, second);
    if (!agrees(worked_out.x, normal.x) || !agrees(worked_out.y, normal.y) ||
        !agrees(worked_out.z, normal.z))
        return;
    for (std::size_t i = 0; i < 3; ++i)
        sheet.put(fmt::format("{} = {}", names[i], text((*corners)[i])));
    sheet.put(fmt::format("{1} - {0} = {2}", names[0], names[1], text(first)));
    sheet.put(fmt::format("{1} - {0} = {2}", names[0], names[2], text(second)));
    sheet.put(fmt::format("normal = ({1} - {0}) x ({2} - {0})", names[0], names[1], names[2]));
    sheet.put(fmt::format("= {} = {}", cross_written_out(first, second), text(normal)));
    const Vec3 sum = a + b + c;
    sheet.put(fmt::format("centroid = ({} + {} + {}) / 3 = {}", names[0], names[1], names[2],
                          text(Vec3{sum.x / 3, sum.y / 3, sum.z / 3})));
    sheet.put(fmt::format("plane: {} x {} y {} z {} = 0", text(normal.x), plus(text(normal.y)),
                          plus(text(normal.z)), minus(text(dot(normal, a)))));
}

void face(Sheet& sheet) {
    const auto normal = vec3_in(sheet.step.texts("normal"));
    const auto view = vec3_in(sheet.step.texts("view"));
    if (!normal || !view)
        return;
    put_normal(sheet, *normal);
    put_angle(sheet, *normal, *view, sheet.step.text("by") == "light" ? "light" : "view");
}

void light(Sheet& sheet) {
    const auto normal = vec3_in(sheet.step.texts("normal"));
    const auto light = vec3_in(sheet.step.texts("light"));
    if (!normal || !light)
        return;
    put_normal(sheet, *normal);
    put_angle(sheet, *normal, *light, "light");
}

/// Both forms of the line, and on which side the third corner lies.
void edge(Sheet& sheet) {
    const std::string name = sheet.step.text("edge");
    const auto ends = ends_of_edge(sheet.primitive, name);
    const auto from = ends ? vec2_in(ends->from) : std::nullopt;
    const auto to = ends ? vec2_in(ends->to) : std::nullopt;
    if (!from || !to)
        return;
    const Rational dx = to->x - from->x;
    const Rational dy = to->y - from->y;
    sheet.put(fmt::format("dx = {} {} = {}, dy = {} {} = {}", text(to->x), minus(text(from->x)),
                          text(dx), text(to->y), minus(text(from->y)), text(dy)));
    if (sgn(dy) != 0) {
        const Rational slope = dx / dy;
        sheet.put(fmt::format("x = {} {} (y {})", text(from->x), plus(text(slope)),
                              minus(text(from->y))));
        sheet.put(fmt::format("  = {} y {}", text(slope), plus(text(from->x - slope * from->y))));
    }
    if (sgn(dx) != 0) {
        const Rational slope = dy / dx;
        sheet.put(fmt::format("y = {} x {}", text(slope), plus(text(from->y - slope * from->x))));
    }
    const auto corners = corners_of(sheet.primitive);
    const auto a = number_in(sheet.step, "a");
    const auto b = number_in(sheet.step, "b");
    if (!corners || !a || !b)
        return;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec2& p = (*corners)[i];
        const Rational value = *a * (p.x - from->x) + *b * (p.y - from->y);
        const bool is_end = (p.x == from->x && p.y == from->y) || (p.x == to->x && p.y == to->y);
        if (!is_end)
            sheet.put(fmt::format("E at {} = {} + {} = {}: {} 0, {}", sheet.primitive.vertices[i],
                                  product(*a, p.x - from->x), product(*b, p.y - from->y),
                                  text(value),
                                  sgn(value) < 0   ? "<"
                                  : sgn(value) > 0 ? ">"
                                                   : "=",
                                  sgn(value) < 0 ? "outside" : "inside"));
    }
}

/// Where an edge crosses a row.
void put_crossing(Sheet& sheet, const std::string& side) {
    const auto ends = ends_of_edge(sheet.primitive, sheet.step.text(side + "_edge"));
    const auto from = ends ? vec2_in(ends->from) : std::nullopt;
    const auto to = ends ? vec2_in(ends->to) : std::nullopt;
    const auto told = number_in(sheet.step, side);
    const auto row = number_in(sheet.step, "y");
    // A row that adds to the one before says so in its sentence.
    const bool adds = sheet.trace().method_value("lerp") == "incremental";
    if (adds || !from || !to || !told || !row || sgn(to->y - from->y) == 0)
        return;
    const Rational y = *row + sample_offset(sheet.trace());
    const Rational slope = (to->x - from->x) / (to->y - from->y);
    const Rational way = slope * (y - from->y);
    if (!agrees(from->x + way, *told))
        return;
    sheet.put(fmt::format("{} {}: x = {} {} ({} {}) = {} {} = {}", side,
                          sheet.step.text(side + "_edge"), text(from->x), plus(text(slope)),
                          text(y), minus(text(from->y)), text(from->x), plus(text(way)),
                          text(*told)));
}

/// What the edge function of an end of a row says of the sample of its pixel, where there are such functions.
void put_edge_function(Sheet& sheet, const std::string& side, std::string_view end) {
    const std::string name = sheet.step.text(side + "_edge");
    const auto x = number_in(sheet.step, end);
    const auto y = number_in(sheet.step, "y");
    const auto ends = ends_of_edge(sheet.primitive, name);
    const auto from = ends ? vec2_in(ends->from) : std::nullopt;
    for (const std::size_t n : sheet.replay.edges()) {
        const StepView edge = sheet.trace().step(n);
        const auto a = number_in(edge, "a");
        const auto b = number_in(edge, "b");
        if (edge.text("edge") != name || !a || !b || !from || !x || !y)
            continue;
        const Rational offset = sample_offset(sheet.trace());
        const Vec2 p{*x + offset, *y + offset};
        const Rational value = *a * (p.x - from->x) + *b * (p.y - from->y);
        const bool is_top_left = edge.text("top_left") == "true";
        const std::string_view where = sgn(value) > 0   ? "> 0, inside"
                                       : sgn(value) < 0 ? "< 0, outside"
                                       : is_top_left    ? "on a top or left edge, inside"
                                                        : "on the edge, outside";
        sheet.put(fmt::format("E of {} at {} = {} + {} = {}: {}", name, text(p),
                              product(*a, p.x - from->x), product(*b, p.y - from->y), text(value),
                              where));
    }
}

void scanline(Sheet& sheet) {
    const StepView& step = sheet.step;
    put_crossing(sheet, "left");
    put_crossing(sheet, "right");
    put_edge_function(sheet, "left", "from");
    put_edge_function(sheet, "right", "to");
    const auto left = number_in(step, "left");
    const auto right = number_in(step, "right");
    const std::string left_edge = step.text("left_edge");
    if (left && right && !left_edge.empty() && *left != *right)
        sheet.put(fmt::format("{} {} {}: {} is left, {} is right", text(*left),
                              *left < *right ? "<" : ">", text(*right), left_edge,
                              step.text("right_edge")));
    const auto left_depth = number_in(step, "left_depth");
    const auto right_depth = number_in(step, "right_depth");
    const auto from = step.whole("from").value_or(0);
    const auto to = step.whole("to").value_or(0);
    if (left_depth && right_depth && left && right && *left != *right)
        sheet.put(fmt::format(
            "depth = {} + ({} {}) / ({} {}) (x {}) = {} {} (x {})", text(*left_depth),
            text(*right_depth), minus(text(*left_depth)), text(*right), minus(text(*left)),
            minus(text(*left)), text(*left_depth),
            plus(text((*right_depth - *left_depth) / (*right - *left))), minus(text(*left))));
    if (from <= to)
        sheet.put(fmt::format("x = {} to {}: {} - {} + 1 = {}", from, to, to,
                              from < 0 ? fmt::format("({})", from) : std::to_string(from),
                              counted(static_cast<std::uint64_t>(to - from + 1), "pixel")));
}

/// Twice the areas that a point makes with the edges of a triangle, by one cross product (T3).
void sample(Sheet& sheet) {
    const auto p = sample_of(sheet.trace(), sheet.step);
    const auto corners = corners_of(sheet.primitive);
    const auto cross = corners && p ? cross_of_point(*corners, *p) : std::nullopt;
    if (!cross)
        return;
    const auto& names = sheet.primitive.vertices;
    const auto& [xs, ys, weights] = *cross;
    sheet.put(fmt::format("P = {}: {} = {}, {} = {}, P to {} = {}", text(*p),
                          side_name(sheet.primitive, 0, 1), text(Vec2{xs.x, ys.x}),
                          side_name(sheet.primitive, 0, 2), text(Vec2{xs.y, ys.y}), names[0],
                          text(Vec2{xs.z, ys.z})));
    sheet.put(fmt::format("{} x {} = {}", text(xs), text(ys), text(weights)));
    const Rational u = weights.x / weights.z;
    const Rational v = weights.y / weights.z;
    sheet.put(fmt::format("divided by {}: u = {} of {}, v = {} of {}, 1 - u - v = {} of {}",
                          text(weights.z), text(u), names[1], text(v), names[2], text(1 - u - v),
                          names[0]));
}

/// The matrix of this name, if there is one before the current step.
std::optional<Matrix4> matrix_named(const Sheet& sheet, std::string_view name) {
    for (std::size_t n = 1; n < sheet.replay.step(); ++n) {
        const auto kind = sheet.trace().kind_of(n);
        if (kind == StepKind::primitive)
            break;
        const StepView step = sheet.trace().step(n);
        if (kind == StepKind::matrix && step.text("name") == name)
            return matrix_in(step);
    }
    return std::nullopt;
}

/// z of a pixel from the plane of its face in the camera's space, A x + B y + C z + D = 0, and from where
/// it is seen on the view plane: z = -d D / (A x' + B y' + d C) (T0).
void put_plane_in_camera_space(Sheet& sheet, const Vec2& sample, const Rational& told) {
    const auto corners = camera_corners_of(sheet);
    const auto projection = matrix_named(sheet, "projection");
    const auto viewport = matrix_named(sheet, "viewport");
    if (!corners || !projection)
        return;
    const auto& rows = *projection;
    const Rational& w_of_z = rows[3][2]; // w = 1 z, -z or -z/d
    if (sgn(w_of_z) == 0 || sgn(rows[0][0]) == 0 || sgn(rows[1][1]) == 0)
        return; // nothing converges
    const auto canonical = [&](std::size_t i, const Rational& on_screen) {
        return viewport && sgn((*viewport)[i][i]) != 0
                   ? Rational((on_screen - (*viewport)[i][3]) / (*viewport)[i][i])
                   : on_screen;
    };
    // The view plane where canonical coordinates are lengths; if those of x and of y are not the same,
    // the one at the distance 1.
    const bool is_uniform =
        rows[0][0] == rows[1][1] && sgn(rows[0][2]) == 0 && sgn(rows[1][2]) == 0;
    const Rational d = (is_uniform ? rows[0][0] : Rational(1)) / w_of_z;
    const auto on_plane = [&](std::size_t i, const Rational& on_screen) {
        return Rational(d * (canonical(i, on_screen) * w_of_z - rows[i][2]) / rows[i][i]);
    };
    const Rational x = on_plane(0, sample.x);
    const Rational y = on_plane(1, sample.y);
    const auto& [a, b, c] = *corners;
    const Vec3 normal = cross(b - a, c - a);
    const Rational constant = -dot(normal, a);
    const Rational divisor = normal.x * x + normal.y * y + d * normal.z;
    if (sgn(divisor) == 0 || sgn(constant) == 0)
        return; // the plane leads through the eye
    const Rational z = -d * constant / divisor;
    if (!agrees(1 / abs(z), told))
        return;
    sheet.put(fmt::format("plane in camera space: {} x {} y {} z {} = 0", text(normal.x),
                          plus(text(normal.y)), plus(text(normal.z)), plus(text(constant))));
    sheet.put(fmt::format("seen at x' = {}, y' = {} on the view plane z = d = {}", text(x), text(y),
                          text(d)));
    sheet.put(fmt::format("z = -d D / (A x' + B y' + d C) = {} / ({} + {} + {}) = {}",
                          text(-d * constant), product(normal.x, x), product(normal.y, y),
                          product(d, normal.z), text(z)));
}

/// The depth of a pixel on the plane through the three corners, if that is what decided.
void depth(Sheet& sheet) {
    if (sheet.replay.primitive() == 0)
        return;
    const auto corners = corners_of(sheet.primitive);
    const auto depths = numbers_in<3>(sheet.trace().step(sheet.replay.primitive()).texts("depths"));
    const auto p = sample_of(sheet.trace(), sheet.step);
    const auto told = number_in(sheet.step, "depth");
    if (!corners || !depths || !p || !told)
        return;
    const auto cross = cross_of_point(*corners, *p);
    if (!cross)
        return;
    const auto& [a, b, c] = *corners;
    const Rational& area = cross->weights.z;
    const Rational u = cross->weights.x / area;
    const Rational v = cross->weights.y / area;
    const Rational w = 1 - u - v;
    const Rational value = w * (*depths)[0] + u * (*depths)[1] + v * (*depths)[2];
    if (!agrees(value, *told))
        return;
    const Rational dx = ((*depths)[1] - (*depths)[0]) * (c.y - a.y) / area -
                        ((*depths)[2] - (*depths)[0]) * (b.y - a.y) / area;
    const Rational dy = ((*depths)[2] - (*depths)[0]) * (b.x - a.x) / area -
                        ((*depths)[1] - (*depths)[0]) * (c.x - a.x) / area;
    sheet.put(fmt::format("plane through the corners: depth = {} x {} y {}", text(dx),
                          plus(text(dy)), plus(text((*depths)[0] - dx * a.x - dy * a.y))));
    sheet.put(fmt::format("depth = {} + {} + {} = {}", product(w, (*depths)[0]),
                          product(u, (*depths)[1]), product(v, (*depths)[2]), text(*told)));
    put_plane_in_camera_space(sheet, *p, *told);
}

/// Bresenham's increments, if the ends are pixels.
void decide(Sheet& sheet) {
    const auto ends = ends_of_line(sheet.primitive);
    const auto d = number_in(sheet.step, "d");
    const auto increment = d ? increment_of(sheet.primitive, *d) : std::nullopt;
    if (!ends || !increment)
        return;
    const Rational dx = abs(ends->to.x - ends->from.x);
    const Rational dy = abs(ends->to.y - ends->from.y);
    const std::string_view major = dx < dy ? "dy" : "dx";
    const std::string_view minor = dx < dy ? "dx" : "dy";
    const Rational longer = std::max(dx, dy);
    const Rational shorter = std::min(dx, dy);
    sheet.put(fmt::format("dx = {}, dy = {}: d begins at 2 {} - {} = {}", text(dx), text(dy), minor,
                          major, text(2 * shorter - longer)));
    sheet.put(fmt::format("straight on adds 2 {} = {}, diagonally 2 ({} - {}) = {}", minor,
                          text(2 * shorter), minor, major, text(2 * (shorter - longer))));
    sheet.put(fmt::format("next d = {} {} = {}", text(*d), plus(text(*increment)),
                          text(*d + *increment)));
}

void along(Sheet& sheet) {
    const auto ends = ends_of_line(sheet.primitive);
    const auto value = number_in(sheet.step, "value");
    const bool is_x_major = sheet.step.field("x").has_value();
    const auto at = number_in(sheet.step, is_x_major ? "x" : "y");
    if (!ends || !value || !at)
        return;
    const Rational dx = ends->to.x - ends->from.x;
    const Rational dy = ends->to.y - ends->from.y;
    const auto form = slope_form_of(*ends, is_x_major);
    if (!form || !agrees(form->m * *at + form->b, *value))
        return;
    const auto& [m, b] = *form;
    const std::string_view major = is_x_major ? "x" : "y";
    const std::string_view minor = is_x_major ? "y" : "x";
    sheet.put(fmt::format("m = d{} / d{} = {} = {}, b = {} - {} = {}", minor, major,
                          quotient(text(is_x_major ? dy : dx), text(is_x_major ? dx : dy)), text(m),
                          text(is_x_major ? ends->from.y : ends->from.x),
                          product(m, is_x_major ? ends->from.x : ends->from.y), text(b)));
    sheet.put(fmt::format("{} = m {} + b = {} {} = {}", minor, major, product(m, *at),
                          plus(text(b)), text(*value)));
}

void write_working(Sheet& sheet);

/// Why the pixel is drawn, once more, and where it lies in memory: four bytes a pixel, row by row from
/// the top left (T2).
void pixel(Sheet& sheet) {
    const Canvas& canvas = sheet.trace().canvas;
    const auto x = sheet.step.whole("x");
    const auto y = sheet.step.whole("y");
    if (!x || !y || !canvas.contains(*x, *y))
        return;
    const std::size_t reason = reason_of_pixel(sheet.replay);
    if (reason != 0) {
        // The row or the sample is of the same primitive, with the same edges.
        Sheet of_reason{sheet.replay, sheet.trace().step(reason), sheet.primitive};
        write_working(of_reason);
        sheet.put(fmt::format("because of step {}", reason));
        for (std::string& line : of_reason.lines)
            sheet.put(std::move(line));
    }
    const Index column = *x - canvas.left();
    const Index row = canvas.row_of(*y);
    sheet.put(fmt::format("column {}, row {} from the top left: byte 4 ({} ({}) + {}) = {}", column,
                          row, canvas.width, row, column, 4 * (canvas.width * row + column)));
}

/// A kind of step and what writes its working.
struct Row {
    StepKind kind;
    void (*write)(Sheet& sheet);
};
constexpr Row rows[] = {
    {StepKind::matrix, matrix},       {StepKind::vertex, vertex},     {StepKind::order, order},
    {StepKind::primitive, primitive}, {StepKind::face, face},         {StepKind::light, light},
    {StepKind::edge, edge},           {StepKind::scanline, scanline}, {StepKind::along, along},
    {StepKind::decide, decide},       {StepKind::sample, sample},     {StepKind::depth, depth},
    {StepKind::pixel, pixel},
};

/// The working of the sheet's step.
void write_working(Sheet& sheet) {
    const auto kind = sheet.step.kind();
    for (const Row& row : rows)
        if (kind == row.kind)
            row.write(sheet);
}

} // namespace

std::vector<std::string> working_of(const Replay& replay) {
    if (replay.step() == 0)
        return {};
    Sheet sheet{replay, replay.trace().step(replay.step()), primitive_of(replay)};
    write_working(sheet);
    for (std::string& line : sheet.lines)
        line = printable(line);
    return std::move(sheet.lines);
}

} // namespace rastertrace
