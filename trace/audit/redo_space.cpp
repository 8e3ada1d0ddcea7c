// SPDX-License-Identifier: MIT
#include "redo_space.h"

#include "redo_drawn.h"

#include <rastertrace/core/draw/scene/triangulate.h>
#include <rastertrace/core/raster/facing.h>
#include <rastertrace/core/raster/painter.h>
#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/core/raster/shading.h>
#include <rastertrace/trace/text/pipeline_names.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <variant>

namespace rastertrace {

namespace {

constexpr std::array spaces{Space::object, Space::world,     Space::camera,
                            Space::clip,   Space::canonical, Space::screen};

Space space_of(const TracedWord<Space>& told) {
    for (const Space space : spaces)
        if (told == space)
            return space;
    throw NotTold();
}

template <typename Number>
Number product(const std::vector<Number>& a, const std::vector<Number>& b) {
    if (a.size() != 3 || b.size() != 3)
        throw NotTold();
    return Number(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

Rational largest_of(const std::vector<Rational>& numbers) {
    Rational largest = 0;
    for (const Rational& number : numbers)
        largest = std::max<Rational>(largest, abs(number));
    return largest;
}

Rational largest_of(const Vec3& v) {
    return largest_of(std::vector{v.x, v.y, v.z});
}

/// What a matrix's products are at most, before they are added.
Matrix<Rational> sizes_of(const Matrix<Rational>& matrix) {
    return mapped<Rational>(matrix, [](const Rational& entry) { return Rational(abs(entry)); });
}

Vec<Rational, 4> as_point(const Vec3& v, int w) {
    return {v.x, v.y, v.z, w};
}

/// True of a vertex that clipping makes: ABC:1.
bool is_made(const std::string& vertex) {
    return vertex.find(':') != std::string::npos;
}

/// The mesh that a vertex belongs to; "" for the scene's own.
std::string object_of(const std::string& vertex) {
    const std::size_t point = vertex.rfind('.');
    return point == std::string::npos ? "" : vertex.substr(0, point);
}

Vec<double, 3> in_doubles(const TracedList<TracedNumber>& list) {
    const auto numbers = numbers_of<double>(list);
    return {told_at(numbers, 0), told_at(numbers, 1), told_at(numbers, 2)};
}

} // namespace

SpaceAgain::SpaceAgain(const Trace& trace, Findings& findings)
    : trace_(trace), numbers_(StepContext(trace)), rules_(trace.method), findings_(findings),
      projection_(projection_named(trace.projection.substr(0, trace.projection.find(',')))) {
    // A vertex without a model begins in the world.
    std::map<std::string, std::string> firsts;
    std::map<std::string, std::size_t> counts;
    for (const std::size_t n : trace.steps_of({StepKind::vertex})) {
        const auto step = trace.step(n).as<VertexStep>();
        const std::string name = step.name.text();
        if (!is_made(name) && firsts.try_emplace(name, step.space.text()).second)
            ++counts[step.space.text()];
    }
    std::size_t most = 0;
    for (const Space space : spaces)
        if (const std::size_t count = counts[std::string(word_of(space))]; count > most) {
            most = count;
            first_space_ = space;
        }
}

void SpaceAgain::redo(std::size_t n) {
    const auto kind = trace_.kind_of(n);
    if (!kind)
        return;
    n_ = n;
    const StepView step = trace_.step(n);
    try {
        switch (*kind) {
        case StepKind::triangulate:
            return redo(step.as<TriangulateStep>());
        case StepKind::matrix:
            return redo(step.as<MatrixStep>());
        case StepKind::vertex:
            return redo(step.as<VertexStep>());
        case StepKind::order:
            return redo(step.as<OrderStep>());
        case StepKind::primitive:
            return redo(step.as<PrimitiveStep>());
        case StepKind::face:
            return redo(step.as<FaceStep>());
        case StepKind::light:
            return redo(step.as<LightStep>());
        case StepKind::clip:
            return redo(step.as<ClipStep>());
        case StepKind::undecided:
            undecided_ = step.as<UndecidedStep>().name.text();
            return;
        default:
            return;
        }
    } catch (const NotTold&) {
    }
}

/// A number that is worked out in an order that is not told: exact ones have to be the same.
void SpaceAgain::expect_near(const Rational& redone, const TracedNumber& told, const Rational& size,
                             const std::string& what) {
    const bool is_exact =
        rules_.triangles.scalar == ScalarKind::exact && told.json().starts_with('"');
    expect_rounded(redone, told, is_exact ? Rational(0) : size, what);
}

/// A number whose largest summand has a size, and may be rounded as that is.
void SpaceAgain::expect_rounded(const Rational& redone, const TracedNumber& told,
                                const Rational& size, const std::string& what) {
    findings_.count(what);
    constexpr double of_floats = 0x1p-16;
    const bool is_double = rules_.says("scalar") && !rules_.has_floats();
    const Rational off = size * Rational(is_double ? largest_rounding : of_floats);
    if (!told.exact() || abs(redone - exactly(told)) > off)
        findings_.add({n_, what, size == 0 ? in_words(redone) : in_words(nearest_double(redone)),
                       told.text()});
}

/// The face is cut as docs/scene-format.md tells it.
void SpaceAgain::redo(const TriangulateStep& step) {
    std::vector<SceneVertex> vertices;
    std::vector<std::size_t> face;
    for (const auto& at : step.at.values()) {
        std::array<Number, 3> place;
        for (std::size_t i = 0; i < 3; ++i)
            place[i] = Number::fraction(exactly(told_at(at.values(), i)));
        face.push_back(vertices.size());
        vertices.push_back({.name = {}, .x = place[0], .y = place[1], .color = {}, .z = place[2]});
    }
    const auto cut = face.size() < 3 ? Triangulation() : FaceCutter(vertices).cut(face);
    expect(true, cut.ears.has_value(), "triangulate: at", ", a concave face");
    if (!cut.ears)
        return;
    const auto& [normal, dropped, triangles] = *cut.ears;
    expect(Values{normal.x, normal.y, normal.z}, numbers_of<Rational>(step.normal),
           "triangulate: normal");
    expect(std::string(1, axis_name(dropped)), step.drops.text(), "triangulate: drops");
    const auto names = step.ears.texts();
    const auto corners = step.vertices.texts();
    expect(triangles.size(), names.size(), "triangulate: ears");
    for (std::size_t i = 0; i < triangles.size() && i < names.size(); ++i) {
        Ear& ear = ears_[names[i]];
        ear.face = step.name.text();
        ear.step = n_;
        for (const std::size_t corner : triangles[i])
            ear.corners.push_back(told_at(corners, corner));
    }
}

void SpaceAgain::redo(const MatrixStep& step) {
    const auto told_matrix = exact_matrix_in(step);
    if (!told_matrix)
        throw NotTold();
    const Matrix<Rational>& matrix = *told_matrix;
    const auto factors = factors_in(step);
    Matrix<Rational> product = identity<Rational>();
    Matrix<Rational> sizes = product;
    for (const auto& factor : factors) {
        product = product * Matrix<Rational>{factor.rows};
        sizes = sizes * sizes_of({factor.rows});
    }
    const auto told = step.rows.values();
    for (std::size_t i = 0; i < 4 && !factors.empty(); ++i)
        for (std::size_t k = 0; k < 4; ++k)
            expect_rounded(product.rows[i][k], told_at(told_at(told, i).values(), k),
                           std::max<Rational>(sizes.rows[i][k], 1), "matrix: rows");

    // A view moves the camera to the origin, and what it looks at to the axis.
    const auto camera = step.camera.values();
    if (camera.size() != 3)
        return;
    const auto vector_of = [](const TracedList<TracedNumber>& list) {
        const auto numbers = numbers_of<Rational>(list);
        return numbers.size() == 3 ? Vec3{numbers[0], numbers[1], numbers[2]} : throw NotTold();
    };
    const Vec3 position = vector_of(camera[0]);
    const Vec3 look_at = vector_of(camera[1]);
    eye_ = position;
    toward_camera_ = position - look_at;
    const Rational slack(rules_.has_floats() ? 0x1p-12 : 0x1p-30);
    bool is_so = true;
    const auto moves_to_axis = [&](const Vec<Rational, 4>& point, bool to_origin) {
        const auto at = matrix * point;
        const auto size = sizes_of(matrix) *
                          Vec<Rational, 4>{abs(point.x), abs(point.y), abs(point.z), abs(point.w)};
        is_so = is_so && abs(at.x) <= slack * size.x &&
                (point.w == 0 || abs(at.y) <= slack * size.y) &&
                (!to_origin || abs(at.z) <= slack * size.z);
        return at;
    };
    moves_to_axis(as_point(position, 1), true);
    const bool is_before = moves_to_axis(as_point(look_at, 1), false).z != 0;
    const bool is_upright = moves_to_axis(as_point(vector_of(camera[2]), 0), false).y > 0;
    expect(true, is_so && is_before && is_upright, "matrix: camera", " is what the matrix has");
}

void SpaceAgain::redo(const VertexStep& step) {
    const std::string name = step.name.text();
    const Space space = space_of(step.space);
    const auto& places = numbers_.steps().places_of(name);
    const auto here = std::lower_bound(places.begin(), places.end(), n_);
    if (here == places.begin()) {
        // Without a model, a vertex begins in the world; one that clipping makes, where it is made.
        const auto matrices = numbers_.steps().at(n_).matrices();
        const auto models = std::count_if(matrices.begin(), matrices.end(), [&](std::size_t n) {
            const auto matrix = trace_.step(n).as<MatrixStep>();
            return matrix.name == "model" && matrix.object.text() == object_of(name);
        });
        const bool begins = is_made(name)
                                ? space == Space::clip
                                : space == first_space_ || matrices.empty() || models > 1 ||
                                      space == (models > 0 ? Space::object : Space::world);
        expect(true, begins, "vertex: name", ", told in the space before");
    } else {
        const Space last = space_of(trace_.step(*std::prev(here)).as<VertexStep>().space);
        expect(true, last < space, "vertex: space", " behind the one before");
        if (space == Space::canonical ? last == Space::clip
                                      : !numbers_.steps().at(n_).matrices().empty())
            redo_place(step);
    }
    has_screen_ = has_screen_ || space == Space::screen;
    redo_snap(step);
}

/// A point in the next space.
void SpaceAgain::redo_place(const VertexStep& step) {
    const auto formulas = formulas_of(numbers_, n_, "at");
    if (formulas.empty())
        return;
    const Values again = value_of(formulas.front());
    const auto told = step.at.values();
    for (std::size_t i = 0; i < std::min(again.size(), told.size()); ++i) {
        Rational size;
        if (const auto* const product = std::get_if<MatrixTimes>(&formulas.front().of))
            for (std::size_t k = 0; k < 4; ++k)
                size += abs(product->rows[i][k] * product->point[k]);
        else
            size = abs(again[i]);
        expect_near(again[i], told[i], size, "vertex: at");
    }
}

void SpaceAgain::redo_snap(const VertexStep& step) {
    if (!step.snapped || !rules_.says("snap"))
        return;
    const Method& method = rules_.triangles;
    for (std::size_t i = 0; i < 2; ++i) {
        const TracedNumber told = told_at(step.at.values(), i);
        const Rational x = rules_.has_floats() ? Rational(number_of<float>(told)) : exactly(told);
        const Index index = method.snap == Snap::nearest
                                ? nearest_index(x, method.ties.value_or(Ties::up))
                            : method.snap == Snap::floor ? floor_index(x)
                                                         : truncate_index(x);
        const auto snapped = told_at(step.snapped.values(), i);
        const Rational whole(static_cast<long>(index));
        if (rules_.has_floats())
            expect(nearest_float(whole), number_of<float>(snapped), "vertex: snapped");
        else
            expect(whole, exactly(snapped), "vertex: snapped");
    }
}

void SpaceAgain::redo(const OrderStep& step) {
    order_step_ = n_;
    order_ = step.names.texts();
    distances_ = step.distances.values();
    drawn_ = 0;
    const auto distances = numbers_of<Rational>(step.distances);
    expect(true, std::is_sorted(distances.rbegin(), distances.rend()), "order: distances",
           ", farthest first");
}

/// How far a vertex lies from the eye, as the painter sorts by it.
std::optional<Rational> SpaceAgain::distance_of(const std::string& vertex) const {
    if (projection_ != ProjectionType::clip_space) {
        const auto at = numbers_.place_in(vertex, Space::camera);
        return at ? std::optional(at->z) : std::nullopt;
    }
    for (const std::size_t n : numbers_.steps().places_of(vertex))
        if (const auto step = trace_.step(n).as<VertexStep>(); step.space == Space::clip)
            return exactly(told_at(step.at.values(), 3));
    return std::nullopt;
}

void SpaceAgain::redo(const PrimitiveStep& step) {
    primitive_ = step;
    const std::string name = step.name.text();
    const auto names = step.vertices.texts();
    if (undecided_) {
        expect(true, name == *undecided_ || name_of_whole(step) == *undecided_, "undecided: name",
               " of the next primitive");
        undecided_.reset();
    }
    if (const auto ear = ears_.find(name); ear != ears_.end()) {
        expect(ear->second.corners, names, "triangulate: ears", ", their corners");
        expect(ear->second.face, step.face.text(), "triangulate: name");
        ears_.erase(ear);
    }
    if (!step.part.is_true() && drawn_ < order_.size()) {
        const std::size_t place = drawn_++;
        const std::size_t n = std::exchange(n_, order_step_);
        expect(name, order_[place], "order: names", ", of the primitives");
        std::vector<Rational> distances;
        for (const std::string& vertex : names)
            if (const auto distance = distance_of(vertex))
                distances.push_back(*distance);
        if (distances.size() == names.size() && !names.empty() && place < distances_.size()) {
            Rational key = painter_key<Rational>(rules_.triangles.painter_key, distances);
            const auto told = distances_[place].exact();
            if (told && (*told < 0) != (key < 0)) // which way it looks is not told
                for (Rational& distance : distances)
                    distance = -distance;
            key = painter_key<Rational>(rules_.triangles.painter_key, distances);
            expect_near(key, distances_[place], largest_of(distances), "order: distances");
        }
        n_ = n;
    }

    const auto corners = step.at.values();
    for (const PrimitiveKind kind : all_primitives)
        if (const std::size_t count = traits_of(kind).corners;
            step.kind == kind && corners.size() == names.size())
            expect(true,
                   traits_of(kind).has_ring ? corners.size() >= count : corners.size() == count,
                   "primitive: kind", ", by its corners");
    for (std::size_t i = 0; i < corners.size() && i < names.size() && has_screen_; ++i) {
        std::optional<VertexStep> known;
        for (const std::size_t n : numbers_.steps().places_of(names[i]))
            if (auto vertex = trace_.step(n).as<VertexStep>();
                n < n_ && vertex.space == Space::screen)
                known = vertex;
        if (!known) {
            if (!is_made(names[i]))
                expect(true, false, "primitive: vertices", ", on the screen");
            continue;
        }
        const auto at = numbers_of<Rational>(known->snapped ? known->snapped : known->at);
        const bool is_on_grid = rules_.triangles.scalar == ScalarKind::fixed;
        for (std::size_t k = 0; k < 2; ++k) {
            const TracedNumber told = told_at(corners[i].values(), k);
            if (is_on_grid)
                expect(true, abs(told_at(at, k) - exactly(told)) <= Rational(1, 512),
                       "primitive: at", ", on the grid");
            else
                expect_near(told_at(at, k), told, abs(told_at(at, k)) + trace_.canvas.width,
                            "primitive: at");
        }
    }
}

void SpaceAgain::finish() {
    for (const auto& [name, ear] : ears_)
        findings_.add({ear.step, "triangulate: ears", "no such primitive", name});
}

void SpaceAgain::redo_name(const TracedText& name, const char* what) {
    if (primitive_.name)
        expect(primitive_.name.text(), name.text(), what);
}

/// The corners of the current primitive in the world.
std::vector<Vec<Rational, 3>> SpaceAgain::corners() const {
    auto corners = numbers_.corners_in(primitive_.vertices.texts(), Space::world);
    return corners ? std::move(*corners) : throw NotTold();
}

void SpaceAgain::redo_normal(const TracedList<TracedNumber>& told, const char* what) {
    const auto at = corners();
    const auto normal = normal_of<Rational>(at);
    Rational farthest = 0;
    for (const auto& corner : at)
        farthest = std::max(farthest, largest_of(corner));
    const Rational size = 8 * farthest * farthest;
    expect_near(normal.x, told_at(told.values(), 0), size, what);
    expect_near(normal.y, told_at(told.values(), 1), size, what);
    expect_near(normal.z, told_at(told.values(), 2), size, what);
}

/// `fixed` works faces out in doubles, unless nothing moves the vertices; `adaptive` rounds each number by itself.
void SpaceAgain::redo_product(const TracedList<TracedNumber>& normal,
                              const TracedList<TracedNumber>& other, const TracedNumber& told,
                              const char* what) {
    if (!told)
        throw NotTold();
    const auto again = [&]<typename Number>(Number) {
        expect(product(numbers_of<Number>(normal), numbers_of<Number>(other)),
               number_of<Number>(told), what);
    };
    const bool is_double = rules_.says("scalar") && rules_.triangles.scalar != ScalarKind::adaptive;
    if (told.json().starts_with('"'))
        return again(Rational());
    if (rules_.has_floats())
        return again(float());
    if (is_double)
        return again(double());
    const auto a = numbers_of<Rational>(normal);
    const auto b = numbers_of<Rational>(other);
    expect_near(product(a, b), told, 3 * largest_of(a) * largest_of(b), what);
}

void SpaceAgain::redo(const FaceStep& step) {
    redo_name(step.name, "face: name");
    redo_product(step.normal, step.view, step.dot, "face: dot");
    const Rational dot = exactly(step.dot);
    if (rules_.says("cull")) {
        const Cull cull = rules_.triangles.cull;
        expect(is_culled(cull, dot), step.culled.is_true(), "face: culled");
        if (step.opposite.is_there())
            expect(is_culled(cull, Rational(-dot)), step.opposite.is_true(), "face: opposite");
        expect(std::string(cull == Cull::light ? "light" : ""), step.by.text(), "face: by");
    }
    if (const auto cosine = cosine_between(in_doubles(step.normal), in_doubles(step.view));
        cosine && step.cosine)
        expect_rounded(Rational(*cosine), step.cosine, 1, "face: cosine");
    redo_normal(step.normal, "face: normal");

    if (step.by || projection_ == ProjectionType::clip_space)
        return; // the light is not told
    const auto view = step.view.values();
    Vec3 expected = eye_;
    Rational size;
    if (projection_ && is_perspective(*projection_)) {
        const auto at = corners();
        expected = eye_ - centroid_of<Rational>(at);
        Rational farthest = largest_of(eye_);
        for (const auto& corner : at)
            farthest = std::max(farthest, largest_of(corner));
        size = 4 * farthest;
    } else {
        const bool is_back = told_at(view, 2).text().starts_with('-');
        expected = toward_camera_.value_or(Vec3{0, 0, is_back ? -1 : 1});
        size = largest_of(expected) + largest_of(eye_);
    }
    const std::array components{expected.x, expected.y, expected.z};
    for (std::size_t i = 0; i < 3; ++i)
        expect_near(components[i], told_at(view, i), size, "face: view");
}

void SpaceAgain::redo(const LightStep& step) {
    redo_name(step.name, "light: name");
    redo_product(step.normal, step.light, step.dot, "light: dot");
    const auto cosine = cosine_between(in_doubles(step.normal), in_doubles(step.light));
    if (cosine)
        expect_rounded(Rational(exactly(step.dot) > 0 ? *cosine : 0.0), step.intensity, 1,
                       "light: intensity");
    if (step.color && primitive_.color)
        expect(true, step.color.color() == primitive_.color.color(), "light: color",
               " is the primitive's");
    redo_normal(step.normal, "light: normal");
}

/// Those inside are left, and at most one for each side that crosses the plane.
void SpaceAgain::redo(const ClipStep& step) {
    expect(true, step.name == primitive_.name.text() || step.name == name_of_whole(primitive_),
           "clip: name", " of the primitive");
    const auto inside = step.inside.values();
    Index those_inside = 0;
    Index crossings = 0;
    for (std::size_t i = 0; i < inside.size(); ++i) {
        const bool is_in = inside[i].is_true();
        those_inside += is_in ? 1 : 0;
        crossings += is_in != inside[(i + 1) % inside.size()].is_true() ? 1 : 0;
    }
    const Index most = those_inside + (inside.size() == 2 ? crossings / 2 : crossings);
    expect(true, those_inside < static_cast<Index>(inside.size()), "clip: inside", ", not all");
    if (step.out)
        expect(true, *step.out <= most, "clip: out", ", as many as can be left");
}

} // namespace rastertrace
