// SPDX-License-Identifier: MIT
// The workings of steps in space: matrices, vertices, faces, light, and the plane of a face.

#include "formula.h"
#include "sheet.h"

#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/core/numbers/number.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/transform/matrix.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

namespace rastertrace {

namespace {

/// Of a face with more corners, nobody reads the working of a normal.
constexpr std::size_t most_corners_shown = 24;

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

using Factors = std::vector<MatrixTimes::Factor>;

/// The factors of a step, if their product is its matrix.
Factors factors_that_agree(const Sheet& sheet, const MatrixStep& step) {
    constexpr std::size_t most_factors = 256; // as many rotations as a scene may have
    Factors factors = factors_in(step);
    const auto told = exact_matrix_in(step);
    if (factors.empty() || factors.size() > most_factors || !told)
        return {};
    Matrix<Rational> together = identity<Rational>();
    for (const auto& factor : factors)
        together = together * Matrix<Rational>{factor.rows};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            if (!sheet.agrees(together.rows[i][j], told->rows[i][j]))
                return {};
    return factors;
}

/// [1 0 0 4]
std::string row_text(const std::array<Rational, 4>& row) {
    return fmt::format("[{} {} {} {}]", text(row[0]), text(row[1]), text(row[2]), text(row[3]));
}

/// A product entry by entry, row times column, without the terms that are 0: 1 (0), 1 (-1), 0, 1 (1) = [0 -1 0 1]
void put_product(Sheet& sheet, const Matrix<Rational>& left, const Matrix<Rational>& right) {
    const Matrix<Rational> together = left * right;
    for (std::size_t i = 0; i < 4; ++i) {
        std::vector<std::string> entries;
        for (std::size_t j = 0; j < 4; ++j) {
            std::vector<std::string> terms;
            for (std::size_t k = 0; k < 4; ++k)
                if (sgn(left.rows[i][k]) != 0 && sgn(right.rows[k][j]) != 0)
                    terms.push_back(product(left.rows[i][k], right.rows[k][j]));
            entries.push_back(terms.empty() ? "0" : joined(terms, " + "));
        }
        sheet.put(fmt::format("{} = {}", joined(entries, ", "), row_text(together.rows[i])));
    }
}

/// The product of a step's factors, from the one that moves a point first on.
void put_factors(Sheet& sheet, const Factors& factors) {
    constexpr std::size_t most_shown = 8;
    if (factors.size() < 2 || factors.size() > most_shown)
        return;
    Matrix<Rational> product{factors.back().rows};
    std::string name = factors.back().name;
    for (std::size_t i = factors.size() - 1; i-- > 0;) {
        const Matrix<Rational> factor{factors[i].rows};
        name = factors[i].name + " x " + name;
        sheet.put(said("{}, row times column:", name));
        put_product(sheet, factor, product);
        product = factor * product;
    }
}

/// The matrices so far as one: view x model, projection x view x model.
struct Product {
    std::string names;
    Matrix<Rational> matrix;
    Matrix<Rational> last;   ///< the one that was multiplied last ...
    Matrix<Rational> before; ///< ... with these
};

/// None if there is but one matrix, or if several objects have models, and so several products.
std::optional<Product> product_so_far(const Sheet& sheet) {
    std::optional<Product> product;
    std::string last_name;
    std::size_t count = 0;
    for (const std::size_t n : sheet.at.matrices()) {
        const auto step = sheet.trace().step(n).as<MatrixStep>();
        const std::string name = step.name.text();
        const auto matrix = exact_matrix_in(step);
        if (!matrix || last_name == name)
            return std::nullopt;
        if (name == "viewport")
            break;
        last_name = name;
        const std::string matrix_name(in_language_of_steps(name));
        const std::string named =
            step.object ? said("{} of {}", matrix_name, step.object.text()) : matrix_name;
        product = product ? Product{named + " x " + product->names, *matrix * product->matrix,
                                    *matrix, product->matrix}
                          : Product{named, *matrix, {}, {}};
        ++count;
    }
    return count > 1 ? product : std::nullopt;
}

/// The axes of a camera: d = p - l, up x d, d x (up x d), each divided by its length. They are the rows
/// of its rotation.
void put_camera(Sheet& sheet, const MatrixStep& step, const Matrix<Rational>& rotation) {
    const auto vectors = text_rows(step.camera);
    const auto p = vectors.size() == 3 ? vec3_in(vectors[0]) : std::nullopt;
    const auto l = vectors.size() == 3 ? vec3_in(vectors[1]) : std::nullopt;
    const auto up = vectors.size() == 3 ? vec3_in(vectors[2]) : std::nullopt;
    if (!p || !l || !up)
        return;
    const Vec3 d = *p - *l;
    const Vec3 right = cross(*up, d);
    const Vec3 upward = cross(d, right);
    const Vec3 z{rotation.rows[2][0], rotation.rows[2][1], rotation.rows[2][2]};
    const bool looks_along_z = sgn(dot(z, d)) < 0; // as T0's pinhole does
    const auto is_along = [&sheet](const std::array<Rational, 4>& row, const Vec3& v) {
        const auto length = root_of(dot(v, v));
        return length && sgn(*length) != 0 && sheet.agrees(v.x / *length, row[0]) &&
               sheet.agrees(v.y / *length, row[1]) && sheet.agrees(v.z / *length, row[2]);
    };
    if (!is_along(rotation.rows[0], looks_along_z ? Vec3{} - right : right) ||
        !is_along(rotation.rows[1], upward) ||
        !is_along(rotation.rows[2], looks_along_z ? *l - *p : d))
        return;
    const auto axis = [&rotation](std::size_t row) {
        return text(Vec3{rotation.rows[row][0], rotation.rows[row][1], rotation.rows[row][2]});
    };
    sheet.put(fmt::format("d = p - l = {} - {} = {}, |d| = {}", text(*p), text(*l), text(d),
                          length_of(d)));
    sheet.put(fmt::format("up x d = {}", cross_written_out(*up, d)));
    sheet.put(fmt::format("= {}, |up x d| = {}", text(right), length_of(right)));
    sheet.put(fmt::format("d x (up x d) = {}", cross_written_out(d, right)));
    sheet.put(fmt::format("= {}, |d x (up x d)| = {}", text(upward), length_of(upward)));
    sheet.put(fmt::format("x = {}(up x d) / |up x d| = {}", looks_along_z ? "-" : "", axis(0)));
    sheet.put(fmt::format("y = d x (up x d) / |d x (up x d)| = {}", axis(1)));
    sheet.put(fmt::format("z = {} / |d| = {}", looks_along_z ? "-d" : "d", axis(2)));
}

/// normal . v, the lengths of both, and the angle between them.
void put_angle(Sheet& sheet, const FaceDot& product, std::string_view name) {
    sheet.put(fmt::format("normal . {} = {}", name, product.written_out()));
    sheet.put(fmt::format("|normal| = {}, |{}| = {}", length_of(product.normal), name,
                          length_of(product.view)));
    const FaceCosine angle{product.normal, product.view};
    const auto cosine = angle.value();
    if (!cosine)
        return;
    sheet.put(said("cosine = {}, an angle of {:.2f} degrees", angle.written_out(name),
                   degrees_of_cosine(std::clamp(nearest_double(*cosine), -1.0, 1.0))));
}

/// The normal of a face from its corners in the world, and the plane that it lies in.
void put_normal(Sheet& sheet, const Vec3& normal) {
    const auto face = sheet.form<FaceNormal>("normal");
    if (!face || face->corners.size() > most_corners_shown)
        return;
    const auto& corners = face->corners;
    const auto& names = sheet.primitive.vertices;
    const Vec3 worked_out = face->value();
    if (!sheet.agrees(worked_out.x, normal.x) || !sheet.agrees(worked_out.y, normal.y) ||
        !sheet.agrees(worked_out.z, normal.z))
        return;
    const Vec3& first = corners.front();
    for (std::size_t i = 0; i < corners.size(); ++i)
        sheet.put(fmt::format("{} = {}", names[i], text(corners[i])));
    for (std::size_t i = 1; i < corners.size(); ++i)
        sheet.put(fmt::format("{1} - {0} = {2}", names[0], names[i], text(corners[i] - first)));
    std::string products;
    for (std::size_t i = 2; i < corners.size(); ++i)
        products += fmt::format("{3}({1} - {0}) x ({2} - {0})", names[0], names[i - 1], names[i],
                                i == 2 ? "" : " + ");
    sheet.put("normal = " + products);
    sheet.put(fmt::format("= {} = {}", face->written_out(), text(normal)));
    sheet.put(said("centroid = ({}) / {} = {}", joined(names, " + "), corners.size(),
                   text(Centroid{corners}.value())));
    sheet.put(said("plane: {}", FacePlane{normal, first}.written_out()));
}

/// All matrices at once, from object space to clip space.
void put_whole_way(Sheet& sheet, const VertexStep& vertex) {
    const auto together = product_so_far(sheet);
    const auto& places = sheet.at.places_of(vertex.name.text());
    if (!together || places.empty() || vertex.space != Space::clip)
        return;
    // Where no matrix leads to a space, it is not told: the first one is where the vertex was typed.
    const auto at = vec3_in(sheet.trace().step(places.front()).as<VertexStep>().at.texts());
    const auto told = numbers_in<4>(vertex.at.texts());
    if (!at || !told)
        return;
    const auto clip = together->matrix * Vec<Rational, 4>{at->x, at->y, at->z, Rational(1)};
    if (sheet.agrees(clip.x, (*told)[0]) && sheet.agrees(clip.y, (*told)[1]) &&
        sheet.agrees(clip.z, (*told)[2]) && sheet.agrees(clip.w, (*told)[3]))
        sheet.put(said("at once: {} times {} = ({}, {}, {}, {})", together->names, text(*at),
                       text(clip.x), text(clip.y), text(clip.z), text(clip.w)));
}

/// The normal of a face, as its `face` or its `light` step tells it, and its angle to the eye or the light.
void put_face_toward(Sheet& sheet, const TracedNumber& dot, std::string_view name) {
    const auto product = sheet.form<FaceDot>("dot");
    if (!product)
        return;
    put_normal(sheet, product->normal);
    if (const auto told = dot.exact(); told && sheet.agrees(product->value(), *told))
        put_angle(sheet, *product, name);
}

/// (y1 - y2) (z1 + z2)
std::string newells_product(const Rational& y1, const Rational& y2, const Rational& z1,
                            const Rational& z2) {
    return fmt::format("({} {}) ({} {})", text(y1), minus(text(y2)), text(z1), plus(text(z2)));
}

} // namespace

std::optional<Matrix<Rational>> matrix_named(const Sheet& sheet, std::string_view name) {
    for (const std::size_t n : sheet.at.matrices())
        if (const auto step = sheet.trace().step(n).as<MatrixStep>(); step.name == name)
            return exact_matrix_in(step);
    return std::nullopt;
}

/// Newell's normal, edge by edge.
void write_triangulation(Sheet& sheet) {
    const auto step = sheet.step.as<TriangulateStep>();
    const auto rows = text_rows(step.at);
    const auto names = step.vertices.texts();
    const auto told = vec3_in(step.normal.texts());
    if (!told || rows.size() != names.size() || rows.size() > most_corners_shown)
        return;
    std::vector<Vec3> at;
    for (const auto& row : rows) {
        const auto corner = vec3_in(row);
        if (!corner)
            return;
        at.push_back(*corner);
    }
    std::vector<std::string> lines;
    Vec3 sum{};
    for (std::size_t i = 0; i < at.size(); ++i) {
        const std::size_t next = i + 1 == at.size() ? 0 : i + 1;
        const Vec3& p = at[i];
        const Vec3& q = at[next];
        const Vec3 part{(p.y - q.y) * (p.z + q.z), (p.z - q.z) * (p.x + q.x),
                        (p.x - q.x) * (p.y + q.y)};
        lines.push_back(said("{} to {}: ({}, {}, {}) = {}", names[i], names[next],
                             newells_product(p.y, q.y, p.z, q.z),
                             newells_product(p.z, q.z, p.x, q.x),
                             newells_product(p.x, q.x, p.y, q.y), text(part)));
        sum = sum + part;
    }
    if (sum.x != told->x || sum.y != told->y || sum.z != told->z)
        return;
    sheet.lines = std::move(lines);
    sheet.put(said("normal = the sum of these = {}, of length {}: twice the area", text(sum),
                   length_of(sum)));
    sheet.put(said("largest in {}: the face is seen without it", step.drops.text()));
}

/// What a matrix is a product of, and the camera that it comes of; then the matrices up to this one as
/// one: view x model, projection x view x model.
void write_matrix(Sheet& sheet) {
    const auto step = sheet.step.as<MatrixStep>();
    const Factors factors = factors_that_agree(sheet, step);
    if (step.name == "view" && !factors.empty())
        put_camera(sheet, step, Matrix<Rational>{factors.front().rows});
    for (std::size_t i = 0; factors.size() > 1 && i < factors.size(); ++i) {
        const auto& [name, rows] = factors[i];
        sheet.put(fmt::format("{}:  {}  {}  {}  {}", name, row_text(rows[0]), row_text(rows[1]),
                              row_text(rows[2]), row_text(rows[3])));
    }
    put_factors(sheet, factors);
    if (step.name == "viewport" || step.name == "model")
        return;
    const auto together = product_so_far(sheet);
    if (!together)
        return;
    sheet.put(said("{}, row times column:", together->names));
    put_product(sheet, together->last, together->before);
}

/// A matrix times a vertex, or a division by w.
void write_vertex(Sheet& sheet) {
    write_meeting_point(sheet);
    const auto vertex = sheet.step.as<VertexStep>();
    const auto told = vertex.at.values();
    constexpr std::array names{"x", "y", "z", "w"};
    const auto put = [&](std::size_t i, const std::string& worked_out) {
        sheet.put(fmt::format("{} = {} = {}", names[i], worked_out, in_sentence(told[i].text())));
    };
    if (const auto division = sheet.form<DividedByW>("at")) {
        const auto before = sheet.trace().step(sheet.at.vertex_before()).as<VertexStep>();
        const auto from = before.at.texts();
        if (before.name != vertex.name || from.size() != 4)
            return;
        for (std::size_t i = 0; i < std::min<std::size_t>(told.size(), 3); ++i) {
            const auto divided = division->value(i);
            const auto number = told[i].exact();
            if (divided && number && sheet.agrees(*divided, *number))
                put(i, quotient(in_sentence(from[i]), in_sentence(from[3])));
        }
    } else if (const auto product = sheet.form<MatrixTimes>("at")) {
        for (std::size_t i = 0; i < product->rows.size(); ++i)
            if (const auto number = told[i].exact();
                !number || !sheet.agrees(product->value(i), *number))
                return;
        for (std::size_t i = 0; i < product->rows.size(); ++i)
            put(i, product->written_out(i));
        put_whole_way(sheet, vertex);
    }
}

void write_face(Sheet& sheet) {
    const auto face = sheet.step.as<FaceStep>();
    put_face_toward(sheet, face.dot, face.by == "light" ? said("light") : said("view"));
}

void write_light(Sheet& sheet) {
    put_face_toward(sheet, sheet.step.as<LightStep>().dot, said("light"));
}

void write_plane_in_camera_space(Sheet& sheet, const Vec2& sample, const Rational& told) {
    const auto corners = sheet.numbers.corners_in(sheet.primitive.vertices, Space::camera);
    const auto projection = matrix_named(sheet, "projection");
    const auto viewport = matrix_named(sheet, "viewport");
    if (!corners || !projection)
        return;
    const auto& rows = projection->rows;
    const Rational& w_of_z = rows[3][2]; // w = 1 z, -z or -z/d
    if (sgn(w_of_z) == 0 || sgn(rows[0][0]) == 0 || sgn(rows[1][1]) == 0)
        return; // nothing converges
    const auto canonical = [&](std::size_t i, const Rational& on_screen) {
        return viewport && sgn(viewport->rows[i][i]) != 0
                   ? Rational((on_screen - viewport->rows[i][3]) / viewport->rows[i][i])
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
    const Vec3 normal = FaceNormal{*corners}.value();
    const FacePlane plane{normal, (*corners)[0]};
    const Rational constant = plane.constant();
    const Rational divisor = normal.x * x + normal.y * y + d * normal.z;
    if (sgn(divisor) == 0 || sgn(constant) == 0)
        return; // the plane leads through the eye
    const Rational z = -d * constant / divisor;
    if (!sheet.agrees(1 / abs(z), told))
        return;
    sheet.put(said("plane in camera space: {}", plane.written_out()));
    sheet.put(
        said("seen at x' = {}, y' = {} on the view plane z = d = {}", text(x), text(y), text(d)));
    sheet.put(fmt::format("z = -d D / (A x' + B y' + d C) = {} / ({} + {} + {}) = {}{}",
                          text(-d * constant), product(normal.x, x), product(normal.y, y),
                          product(d, normal.z), text(z),
                          sgn(z) < 0 ? said(", at a distance of {}", text(-z)) : ""));
}

} // namespace rastertrace
