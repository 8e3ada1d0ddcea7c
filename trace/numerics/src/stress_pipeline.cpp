// SPDX-License-Identifier: MIT
// P: from space to the screen. The camera at the origin, looking along -z, near 1, far 17, 64x64, row
// 0 at clip y = -1, unless said.

#include "stress_rows.h"

#include <rastertrace/core/raster/shading.h>
#include <rastertrace/core/transform/matrix.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <fmt/core.h>

#include <array>
#include <random>

namespace rastertrace {

namespace {

// The view of P1 to P3: the frustum is one pixel wider than the canvas on each side
// but half of it, so that `fit` puts x/w at 32 x/w + 31.5: at the integer samples of pixels, what
// lies at their centers where the whole canvas is 64 wide.

/// A vertex of P1 to P3 as the reference sees it.
struct SpacePoint {
    Rational x;
    Rational y;
    Rational w; ///< -z
};

std::vector<SpacePoint> space_points(const Scene& scene) {
    std::vector<SpacePoint> points;
    for (const SceneVertex& vertex : scene.vertices)
        points.push_back({vertex.x.exact(), vertex.y.exact(), -vertex.z.exact()});
    return points;
}

ExactPoint divided(const SpacePoint& point) {
    return {point.x / point.w * 32 + 32, point.y / point.w * 32 + 32};
}

/// What lies at w >= 1, divided by w, with samples at the centers of 64x64 pixels.
CoveredPixels covered_in_space(const Scene& scene) {
    const auto points = space_points(scene);
    std::vector<ExactPoint> polygon;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const SpacePoint& p = points[i];
        const SpacePoint& q = points[(i + 1) % points.size()];
        if (p.w >= 1)
            polygon.push_back(divided(p));
        if ((p.w < 1 && q.w > 1) || (q.w < 1 && p.w > 1)) {
            const Rational t = (1 - p.w) / (q.w - p.w);
            polygon.push_back(divided({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), Rational(1)}));
        }
    }
    if (polygon.size() < 3)
        return CoveredPixels(64 * 64);
    return covered_by_polygon(polygon, scene.canvas);
}

/// P2: the textbook's division of every vertex, in front of the eye or not.
Measured not_clipped(const TableRow& row, std::string_view) {
    const Scene scene = row.scene({});
    std::vector<ExactPoint> polygon;
    for (const SpacePoint& point : space_points(scene))
        polygon.push_back(divided(point));
    const CoveredPixels mirrored = covered_by_polygon(polygon, scene.canvas);
    const CoveredPixels clipped = covered_in_space(scene);
    const std::uint64_t common = common_pixels(mirrored, clipped);
    return {.wrong = count_in(mirrored) + count_in(clipped) - 2 * common,
            .unit = "pixel",
            .note = fmt::format("{} pixels, {} in common", count_in(mirrored), common)};
}

/// A face that must have "dot" as normal . view, as the trace tells it ("": it is not tested), and not be drawn.
Measured hidden_face(const TableRow& row, std::string_view scalar) {
    std::string dot;
    std::string skip; // why it was not drawn
    const Trace trace = row.trace(scalar);
    for (const std::size_t n : trace.steps_of({StepKind::face}))
        dot = trace.step(n).as<FaceStep>().dot.text();
    for (const std::size_t n : trace.steps_of({StepKind::skip}))
        skip = trace.step(n).as<SkipStep>().why.text();
    std::string said = skip.empty() ? "drawn" : skip;
    if (!dot.empty())
        said = fmt::format("normal.view = {}, {}", dot, skip == "culled" ? "culled" : "not culled");
    return {
        .wrong = dot == row.text("dot") && !skip.empty() ? 0u : 1u, .unit = "face", .note = said};
}

/// normal . (eye - v) of a face, in the core's own operations.
template <typename Scalar> using Point3 = Vec<Scalar, 3>;
template <typename Scalar>
Scalar facing(const Point3<Scalar>& a, const Point3<Scalar>& b, const Point3<Scalar>& c,
              const Point3<Scalar>& eye, const Point3<Scalar>& v) {
    const Point3<Scalar> view = eye - v;
    return dot(normal_of<Scalar>(std::array{a, b, c}), view);
}

/// A point whose coordinates are so many tenths, rounded to Scalar.
template <typename Scalar> Point3<Scalar> tenths(int x, int y, int z) {
    const auto tenth = [](int n) { return nearest_scalar<Scalar>(Rational(n) / 10); };
    return {tenth(x), tenth(y), tenth(z)};
}

/// P4: visible if normal . view >= 0, as a textbook has it.
Measured seen_edge_on(const TableRow&, std::string_view) {
    const auto dot = facing<double>({0, 0, 0}, {1, 0, 0}, {0, 0, -1}, {5, 0, -3}, {0, 0, 0});
    return {.wrong = dot >= 0 ? 1u : 0u, .unit = "face"};
}

/// P5's face and its eye, 3B + 7C, as typed, or added up in Scalar.
template <typename Scalar> struct DecimalFace {
    explicit DecimalFace(bool adds_eye) {
        const Scalar three = scalar_from<Scalar>(3);
        const Scalar seven = scalar_from<Scalar>(7);
        if (adds_eye)
            eye = {Scalar(three * b.x + seven * c.x), Scalar(three * b.y + seven * c.y),
                   Scalar(three * b.z + seven * c.z)};
    }
    Point3<Scalar> a = tenths<Scalar>(0, 0, 0);
    Point3<Scalar> b = tenths<Scalar>(1, 2, 3);
    Point3<Scalar> c = tenths<Scalar>(7, -4, 5);
    Point3<Scalar> eye = tenths<Scalar>(52, -22, 44);
};

/// P5 from A, in the row's scalar; with "inputs", exactly for inputs that were rounded to that one.
Measured edge_on_in_decimals(const TableRow& row, std::string_view scalar) {
    const bool adds_eye = row.text("eye") == "added";
    const bool is_exact = row.has("inputs");
    const Rational found =
        with_type(is_exact ? row.text("inputs") : scalar, [&]<typename Scalar>() {
            const DecimalFace<Scalar> face(adds_eye);
            const auto held = [](const Point3<Scalar>& p) {
                return Point3<Rational>{exact_value(p.x), exact_value(p.y), exact_value(p.z)};
            };
            if (is_exact)
                return facing<Rational>(held(face.a), held(face.b), held(face.c), held(face.eye),
                                        held(face.a));
            return exact_value(facing<Scalar>(face.a, face.b, face.c, face.eye, face.a));
        });
    return {.wrong = found == 0 ? 0u : 1u,
            .unit = "face",
            .worst = nearest_double(abs(found)),
            .worst_unit = "from 0",
            .note = fmt::format("{}{:.3g}", sgn(found) > 0 ? "+" : "", nearest_double(found))};
}

/// P8: of 1,000 random faces on a grid of 1/10, those for which normal . (eye - V) is not the same
/// for V = A, B and C.
template <typename Scalar> Measured faces_of_many_minds() {
    std::mt19937_64 random(8);
    const auto point = [&random] {
        const auto tenth = [&random] { return static_cast<int>(random() % 199) - 99; };
        const int x = tenth();
        const int y = tenth();
        return tenths<Scalar>(x, y, tenth());
    };
    Measured measured{.unit = "face", .note = "of 1000"};
    for (int i = 0; i < 1000; ++i) {
        const auto a = point();
        const auto b = point();
        const auto c = point();
        const auto eye = point();
        const Scalar from_a = facing<Scalar>(a, b, c, eye, a);
        const Scalar from_b = facing<Scalar>(a, b, c, eye, b);
        const Scalar from_c = facing<Scalar>(a, b, c, eye, c);
        measured.wrong += from_a == from_b && from_a == from_c ? 0 : 1;
    }
    return measured;
}

/// The same in the numbers that faces are tested in.
Measured faces_from_each_vertex(const TableRow& row, std::string_view scalar) {
    return with_coordinates_of(row.scene(scalar),
                               []<typename Scalar>() { return faces_of_many_minds<Scalar>(); });
}

/// P12: for how many of 1..1000 scaling by 0.1, then by 3.3, is not scaling by their product.
Measured joined_scales(const TableRow&, std::string_view scalar) {
    return with_type(scalar, []<typename Scalar>() {
        const Scalar tenth = nearest_scalar<Scalar>(Rational(1, 10));
        const Scalar more = nearest_scalar<Scalar>(Rational(33, 10));
        const Scalar zero = scalar_from<Scalar>(0);
        const Scalar one = scalar_from<Scalar>(1);
        const auto first = diagonal<Scalar>(tenth, tenth, tenth, one);
        const auto second = diagonal<Scalar>(more, more, more, one);
        const auto joined = second * first;
        Measured measured{.unit = "number", .note = "of 1000"};
        for (int x = 1; x <= 1000; ++x) {
            const Vec<Scalar, 4> v{scalar_from<Scalar>(x), zero, zero, one};
            measured.wrong +=
                Vec<Scalar, 4>(joined * v).x == Vec<Scalar, 4>(second * (first * v)).x ? 0 : 1;
        }
        return measured;
    });
}

constexpr auto measures_of_pipelines = std::to_array<NamedMeasure>({
    {"not clipped", not_clipped},
    {"hidden face", hidden_face},
    {"seen edge-on", seen_edge_on},
    {"edge-on in decimals", edge_on_in_decimals},
    {"faces from each vertex", faces_from_each_vertex},
    {"joined scales", joined_scales},
});

} // namespace

Colors clipped_picture(const Scene& scene) {
    const auto covered = covered_in_space(scene);
    Colors picture(covered.size());
    for (std::size_t i = 0; i < covered.size(); ++i)
        picture[i] = covered[i] ? scene.primitives[0].color : no_color;
    return picture;
}

std::span<const NamedMeasure> pipeline_measures() {
    return measures_of_pipelines;
}

} // namespace rastertrace
