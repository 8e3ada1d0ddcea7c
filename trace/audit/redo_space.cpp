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

/// A matrix times a point; `sizes` are the sums of the summands' sizes.
std::vector<Rational> times(const std::vector<std::vector<Rational>>& matrix,
                            std::vector<Rational> point, std::vector<Rational>& sizes) {
    if (point.size() == 3)
        point.emplace_back(1);
    std::vector<Rational> result;
    sizes.clear();
    for (const auto& row : matrix) {
        Rational sum = 0;
        Rational size = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const Rational summand = told_at(row, i) * told_at(point, i);
            sum += summand;
            size += abs(summand);
        }
        result.push_back(sum);
        sizes.push_back(size);
    }
    return result;
}

/// True of a vertex that clipping makes: ABC:1.
bool is_made(const std::string& vertex) {
    return vertex.find(':') != std::string::npos;
}

/// Of matrices, the one that moves a point nearest to another: meshes without a name do not say whose a model is.
const std::vector<std::vector<Rational>>&
nearest_to(const std::vector<Rational>& place,
           const std::vector<std::vector<std::vector<Rational>>>& matrices,
           const std::vector<Rational>& point) {
    std::size_t best = 0;
    Rational least = -1;
    for (std::size_t i = 0; i < matrices.size() && matrices.size() > 1; ++i) {
        std::vector<Rational> sizes;
        const auto moved = times(matrices[i], point, sizes);
        Rational distance = 0;
        for (std::size_t k = 0; k < place.size() && k < moved.size(); ++k)
            distance += abs(moved[k] - place[k]);
        if (least < 0 || distance < least) {
            best = i;
            least = distance;
        }
    }
    return matrices[best];
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
    : trace_(trace), rules_(trace.method), findings_(findings),
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
    expect(Numbers{normal.x, normal.y, normal.z}, numbers_of<Rational>(step.normal),
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
    std::vector<Numbers> rows;
    for (const auto& row : step.rows.values())
        rows.push_back(numbers_of<Rational>(row));
    if (rows.size() != 4)
        throw NotTold();
    matrices_[step.name.text() + " " + step.object.text()].push_back(rows);

    // The product of its factors, column by column.
    std::vector<std::vector<Numbers>> factors;
    for (const auto& row : step.factor_rows.values()) {
        if (factors.empty() || factors.back().size() == 4)
            factors.emplace_back();
        factors.back().push_back(numbers_of<Rational>(row));
    }
    const auto told = step.rows.values();
    for (std::size_t column = 0; column < 4 && !factors.empty(); ++column) {
        Numbers point(4);
        point[column] = 1;
        Numbers sizes(4);
        for (std::size_t i = factors.size(); i-- > 0;)
            point = times(factors[i], point, sizes);
        for (std::size_t i = 0; i < 4; ++i)
            expect_rounded(point[i], told_at(told_at(told, i).values(), column),
                           std::max<Rational>(sizes[i], 1), "matrix: rows");
    }

    // A view moves the camera to the origin, and what it looks at to the axis.
    const auto camera = step.camera.values();
    if (camera.size() != 3)
        return;
    const auto position = numbers_of<Rational>(camera[0]);
    const auto look_at = numbers_of<Rational>(camera[1]);
    const auto up = numbers_of<Rational>(camera[2]);
    if (position.size() != 3 || look_at.size() != 3 || up.size() != 3)
        throw NotTold();
    eye_ = position;
    toward_camera_ = {position[0] - look_at[0], position[1] - look_at[1], position[2] - look_at[2]};
    Numbers sizes;
    Numbers of_look_at;
    const auto origin = times(rows, position, sizes);
    const auto on_axis = times(rows, look_at, of_look_at);
    Numbers direction = up;
    direction.emplace_back(0);
    Numbers of_up;
    const auto upward = times(rows, direction, of_up);
    const Rational slack(rules_.has_floats() ? 0x1p-12 : 0x1p-30);
    bool is_so = upward[1] > 0 && abs(upward[0]) <= slack * of_up[0];
    for (std::size_t i = 0; i < 3; ++i)
        is_so = is_so && abs(origin[i]) <= slack * sizes[i] &&
                (i == 2 || abs(on_axis[i]) <= slack * of_look_at[i]);
    expect(true, is_so && on_axis[2] != 0, "matrix: camera", " is what the matrix has");
}

/// A point in the next space; nothing if that is not told.
std::optional<SpaceAgain::Numbers> SpaceAgain::moved(const std::string& name, Space from,
                                                     const Numbers& at, Space to,
                                                     const Numbers& like, Numbers& sizes) const {
    Numbers point = at;
    const auto divide = [&] {
        if (point.size() != 4 || point[3] == 0)
            throw NotTold();
        for (std::size_t i = 0; i < 3; ++i)
            point[i] /= point[3];
        point.pop_back();
        sizes = point;
    };
    if (to == Space::canonical) {
        if (from != Space::clip)
            return std::nullopt;
        divide();
        return point;
    }
    if (point.size() == 4)
        divide();
    const std::string matrix = to == Space::world    ? "model "
                               : to == Space::camera ? "view "
                               : to == Space::clip   ? "projection "
                                                     : "viewport ";
    auto found = matrices_.find(matrix + object_of(name));
    if (found == matrices_.end())
        found = matrices_.find(matrix);
    if (found != matrices_.end())
        point = times(nearest_to(like, found->second, point), point, sizes);
    else if (matrices_.empty())
        return std::nullopt;
    else
        sizes = point;
    sizes.resize(4);
    if (to != Space::clip)
        point.resize(to == Space::screen ? 2 : 3);
    else if (point.size() == 3)
        point.emplace_back(1);
    return point;
}

void SpaceAgain::redo(const VertexStep& step) {
    const std::string name = step.name.text();
    const Space space = space_of(step.space);
    const Numbers at = numbers_of<Rational>(step.at);
    const auto last = at_.find(name);
    if (last == at_.end()) {
        // Without a model, a vertex begins in the world; one that clipping makes, where it is made.
        const auto models = matrices_.find("model " + object_of(name));
        const bool has_model = models != matrices_.end();
        const bool may_have_model = has_model && models->second.size() > 1;
        const bool begins = is_made(name)
                                ? space == Space::clip
                                : space == first_space_ || matrices_.empty() || may_have_model ||
                                      space == (has_model ? Space::object : Space::world);
        expect(true, begins, "vertex: name", ", told in the space before");
    } else {
        expect(true, last->second < space, "vertex: space", " behind the one before");
        Numbers sizes;
        if (const auto again =
                moved(name, last->second, places_[name][last->second], space, at, sizes))
            for (std::size_t i = 0; i < again->size(); ++i)
                expect_near((*again)[i], told_at(step.at.values(), i), abs(sizes[i]), "vertex: at");
    }
    at_[name] = space;
    places_[name][space] = at;
    if (space == Space::screen)
        on_screen_[name] = step.snapped ? step.snapped : step.at;
    redo_snap(step);
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
    const auto found = places_.find(vertex);
    if (found == places_.end())
        return std::nullopt;
    const auto at = [&](Space space, std::size_t i) -> std::optional<Rational> {
        const auto place = found->second.find(space);
        return place == found->second.end() ? std::nullopt
                                            : std::optional(told_at(place->second, i));
    };
    if (projection_ == ProjectionType::clip_space)
        return at(Space::clip, 3);
    auto z = at(Space::camera, 2);
    for (const Space space : {Space::world, Space::object})
        if (!z)
            z = at(space, 2);
    return z;
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
    for (std::size_t i = 0; i < corners.size() && i < names.size() && !on_screen_.empty(); ++i) {
        const auto known = on_screen_.find(names[i]);
        if (known == on_screen_.end()) {
            if (!is_made(names[i]))
                expect(true, false, "primitive: vertices", ", on the screen");
            continue;
        }
        const auto at = numbers_of<Rational>(known->second);
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
    std::vector<Vec<Rational, 3>> corners;
    for (const std::string& name : primitive_.vertices.texts()) {
        const auto found = places_.find(name);
        if (found == places_.end())
            throw NotTold();
        auto place = found->second.find(Space::world);
        if (place == found->second.end())
            place = found->second.find(Space::object);
        if (place == found->second.end() || place->second.size() < 3)
            throw NotTold();
        corners.push_back({place->second[0], place->second[1], place->second[2]});
    }
    return corners.size() < 3 ? throw NotTold() : corners;
}

void SpaceAgain::redo_normal(const TracedList<TracedNumber>& told, const char* what) {
    const auto at = corners();
    const auto normal = normal_of<Rational>(at);
    Rational farthest = 0;
    for (const auto& corner : at)
        farthest = std::max(farthest, largest_of({corner.x, corner.y, corner.z}));
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
    Numbers expected = eye_;
    Numbers sizes{1, 1, 1};
    if (projection_ && is_perspective(*projection_)) {
        const auto at = corners();
        const auto center = centroid_of<Rational>(at);
        expected = {eye_[0] - center.x, eye_[1] - center.y, eye_[2] - center.z};
        Rational farthest = largest_of(eye_);
        for (const auto& corner : at)
            farthest = std::max(farthest, largest_of({corner.x, corner.y, corner.z}));
        sizes.assign(3, 4 * farthest);
    } else {
        const bool is_back = told_at(view, 2).text().starts_with('-');
        expected = toward_camera_.empty() ? Numbers{0, 0, is_back ? -1 : 1} : toward_camera_;
        sizes.assign(3, largest_of(expected) + largest_of(eye_));
    }
    for (std::size_t i = 0; i < 3; ++i)
        expect_near(told_at(expected, i), told_at(view, i), sizes[i], "face: view");
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
