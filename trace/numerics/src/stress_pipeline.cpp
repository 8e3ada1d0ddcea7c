// SPDX-License-Identifier: MIT
// P: from space to the screen. The camera at the origin, looking along -z, near 1, far 17, 64x64, row
// 0 at clip y = -1, unless said.

#include "stress_rows.h"

#include <rastertrace/core/raster/shading.h>
#include <rastertrace/core/transform/matrix.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <random>

namespace rastertrace {

namespace {

/// A triangle in the view of P1 to P3. The frustum is one pixel wider than the canvas on each side
/// but half of it, so that `fit` puts x/w at 32 x/w + 31.5: at the integer samples of pixels, what
/// lies at their centers where the whole canvas is 64 wide.
std::string in_view(std::string_view a, std::string_view b, std::string_view c) {
    return fmt::format(R"({{
  "canvas": {{"width": 64, "height": 64, "origin": "top-left"}},
  "vertices": {{"A": [{}], "B": [{}], "C": [{}]}},
  "triangles": ["ABC"],
  "model": [{{"scale": [1, -1, 1]}}],
  "projection": {{"type": "frustum", "left": "-63/64", "right": "63/64", "bottom": "-63/64",
                 "top": "63/64", "near": 1, "far": 17}},
  "viewport": "fit",
  "method": {{"fill": "top-left", "sample": "integer", "depth": "none"}}
}})",
                       a, b, c);
}

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

Colors picture_of(const CoveredPixels& covered, Color color) {
    Colors picture;
    for (const bool is_covered : covered)
        picture.push_back(is_covered ? color : no_color);
    return picture;
}

Colors by_clipping(const Scene& scene) {
    return picture_of(covered_in_space(scene), scene.primitives[0].color);
}

/// The textbook's division of every vertex, in front of the eye or not.
Measured without_clipping(const Scene& scene) {
    std::vector<ExactPoint> polygon;
    for (const SpacePoint& point : space_points(scene))
        polygon.push_back(divided(point));
    const CoveredPixels wrong_one = covered_by_polygon(polygon, scene.canvas);
    const CoveredPixels right_one = covered_in_space(scene);
    Measured measured{.unit = "pixel"};
    for (std::size_t i = 0; i < wrong_one.size(); ++i)
        measured.wrong += wrong_one[i] == right_one[i] ? 0 : 1;
    measured.note =
        fmt::format("{} pixels, {} in common", std::count(wrong_one.begin(), wrong_one.end(), true),
                    common_pixels(wrong_one, right_one));
    return measured;
}

const std::string p1_touching = in_view("-1, -1, -2", "1, -1, -2", "0, 0.5, -1");
const std::string p1_on = in_view("-0.5, -0.5, -1", "0.5, -0.5, -1", "0, 0.5, -1");
const std::string p1_before = in_view("-0.5, -0.5, -0.5", "0.5, -0.5, -0.5", "0, 0.5, -0.5");
const std::string p2 = in_view("0, 1, -2", "-1, -1, -2", "1, -1, 2");
const std::string p3 = in_view("0, 1, -2", "-1, -1, -2", "1, -1, 0");

/// A face seen from an eye that looks at a place, back faces culled.
std::string seen_face(std::string_view a, std::string_view b, std::string_view c,
                      std::string_view eye, std::string_view look_at) {
    return fmt::format(R"({{
  "canvas": {{"width": 32, "height": 32}},
  "vertices": {{"A": [{}], "B": [{}], "C": [{}]}},
  "triangles": ["ABC"],
  "camera": {{"position": [{}], "look_at": [{}]}},
  "projection": {{"type": "frustum", "left": -1, "right": 1, "bottom": -1, "top": 1,
                 "near": 0.01, "far": "infinity"}},
  "method": {{"cull": "back", "depth": "none"}}
}})",
                       a, b, c, eye, look_at);
}

const std::string p4 = seen_face("0, 0, 0", "1, 0, 0", "0, 0, -1", "5, 0, -3", "0, 0, -3");
const std::string p5 =
    seen_face("0, 0, 0", "0.1, 0.2, 0.3", "0.7, -0.4, 0.5", "5.2, -2.2, 4.4", "0, 0, 0");
const std::string p6 = seen_face("0, 0, 0", "102334155, 165580141, 0", "165580141, 267914296, 0",
                                 "0, 0, 1", "0, 0, 0");
const std::string p7_coincident = seen_face("0, 0, 0", "1, 0, 0", "1, 0, 0", "0, 0, 3", "0, 0, 0");
const std::string p7_eye_on_vertex =
    seen_face("0, 0, 0", "1, 0, 0", "0, 1, 0", "0, 0, 0", "0, 0, -1");
const std::string p7_eye_in_plane =
    seen_face("0, 0, 0", "1, 0, 0", "0, 1, 0", "3, 4, 0", "0, 0, 0");

/// What a trace says of the only face of a scene.
struct FaceSeen {
    std::string dot;  ///< "" if the face was not tested
    std::string skip; ///< why it was not drawn, "" if it was
};
FaceSeen face_seen(std::string_view json, std::string_view scalar) {
    FaceSeen face;
    const auto trace = trace_in(json, with_scalar_named({}, scalar));
    for (std::size_t n = 1; trace && n <= trace.value().size(); ++n) {
        const StepView step = trace.value().step(n);
        if (trace.value().kind_of(n) == StepKind::face)
            face.dot = step.as<FaceStep>().dot.text();
        if (trace.value().kind_of(n) == StepKind::skip)
            face.skip = step.as<SkipStep>().why.text();
    }
    return face;
}

/// Rows for a face that must have this normal . view, and not be drawn.
void add_hidden_face(StressRows& rows, std::string_view json, std::string_view label,
                     std::string_view dot, const DocumentedOfScalars& documented = {}) {
    rows.add_for_all(label, documented, [&](std::string_view scalar) -> Measured {
        const FaceSeen face = face_seen(json, scalar);
        const bool is_right = face.dot == dot && !face.skip.empty();
        std::string said = face.skip.empty() ? "drawn" : face.skip;
        if (!face.dot.empty())
            said = fmt::format("normal.view = {}, {}", face.dot,
                               face.skip == "culled" ? "culled" : "not culled");
        return {.wrong = is_right ? 0u : 1u, .unit = "face", .note = said};
    });
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

/// P5's eye, 3B + 7C: as typed, or added up in Scalar.
template <typename Scalar> Point3<Scalar> p5_eye(bool is_typed) {
    if (is_typed)
        return tenths<Scalar>(52, -22, 44);
    const auto b = tenths<Scalar>(1, 2, 3);
    const auto c = tenths<Scalar>(7, -4, 5);
    const Scalar three = scalar_from<Scalar>(3);
    const Scalar seven = scalar_from<Scalar>(7);
    return {Scalar(three * b.x + seven * c.x), Scalar(three * b.y + seven * c.y),
            Scalar(three * b.z + seven * c.z)};
}

/// P5 from A: in Scalar, and exactly for inputs that were rounded to Scalar.
template <typename Scalar> Scalar p5_from_a(bool is_typed) {
    const auto a = tenths<Scalar>(0, 0, 0);
    return facing<Scalar>(a, tenths<Scalar>(1, 2, 3), tenths<Scalar>(7, -4, 5),
                          p5_eye<Scalar>(is_typed), a);
}
template <typename Scalar> Rational p5_of_rounded_inputs(bool is_typed) {
    const auto widened = [](const Point3<Scalar>& p) {
        return Point3<Rational>{Rational(p.x), Rational(p.y), Rational(p.z)};
    };
    const auto a = widened(tenths<Scalar>(0, 0, 0));
    return facing<Rational>(a, widened(tenths<Scalar>(1, 2, 3)), widened(tenths<Scalar>(7, -4, 5)),
                            widened(p5_eye<Scalar>(is_typed)), a);
}

Measured edge_on(const Rational& found, std::string_view unit) {
    return {.wrong = found == 0 ? 0u : 1u,
            .unit = std::string(unit),
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

/// P9: a scene whose set-up is singular.
std::string set_up(std::string_view canvas, std::string_view camera, std::string_view projection) {
    return fmt::format(R"({{
  "canvas": {{"width": {}, "height": 16}},
  "vertices": {{"A": [0, 0, -2], "B": [1, 0, -2], "C": [0, 1, -2]}},
  "triangles": ["ABC"],
  "camera": {{{}}},
  "projection": {{"type": "frustum", {}}}
}})",
                       canvas, camera, projection);
}
constexpr std::string_view plain_camera = R"("position": [0, 0, 1], "look_at": [0, 0, 0])";
constexpr std::string_view plain_frustum = R"("fov_y": 90, "near": 1, "far": 9)";

constexpr std::string_view p10 = R"({
  "canvas": {"width": 64, "height": 64, "origin": "top-left"},
  "vertices": {"A": [1, 0, 0], "B": [0, 0, 0], "C": [-1, 0, 0]},
  "points": ["A", "B", "C"],
  "projection": {"type": "orthographic", "left": -1, "right": 1, "bottom": -1, "top": 1},
  "viewport": "fit"
})";

/// P10: (x + 1) 63/2, a half up: columns 63, 32 and 0 of row 32.
Colors canonical_points(const Scene& scene) {
    Colors picture(64 * 64, no_color);
    for (const SceneVertex& vertex : scene.vertices) {
        const auto column = [](const Rational& x) {
            return floor_index(Rational((x + 1) * 63 / 2 + Rational(1, 2)));
        };
        picture[static_cast<std::size_t>(column(-vertex.y.exact()) * 64 +
                                         column(vertex.x.exact()))] = Color{};
    }
    return picture;
}

constexpr std::string_view p11 = R"({
  "canvas": {"width": 512, "height": 512, "origin": "top-left"},
  "vertices": {"A": [512, 0], "B": [512, 512], "C": [0, 512]},
  "points": ["A", "B", "C"]
})";

/// P12: for how many of 1..1000 scaling by 0.1, then by 3.3, is not scaling by their product.
template <typename Scalar> Measured scales_joined() {
    const Scalar tenth = nearest_scalar<Scalar>(Rational(1, 10));
    const Scalar more = nearest_scalar<Scalar>(Rational(33, 10));
    const Scalar one = scalar_from<Scalar>(1);
    const auto first = diagonal<Scalar>(tenth, tenth, tenth, one);
    const auto second = diagonal<Scalar>(more, more, more, one);
    const auto joined = second * first;
    Measured measured{.unit = "number", .note = "of 1000"};
    for (int x = 1; x <= 1000; ++x) {
        const Scalar zero = scalar_from<Scalar>(0);
        const Vec<Scalar, 4> v{scalar_from<Scalar>(x), zero, zero, one};
        measured.wrong +=
            Vec<Scalar, 4>(joined * v).x == Vec<Scalar, 4>(second * (first * v)).x ? 0 : 1;
    }
    return measured;
}

std::string p12(std::string_view model) {
    return fmt::format(R"({{
  "canvas": {{"width": 64, "height": 64}},
  "vertices": {{"A": [10, 20, 0], "B": [-90, -70, 0], "C": [80, -35, 0]}},
  "triangles": ["ABC"],
  "model": [{}],
  "method": {{"fill": "top-left"}}
}})",
                       model);
}
const std::string p12_two = p12(R"({"scale": [0.1, 0.1, 0.1]}, {"scale": [3.3, 3.3, 3.3]})");

/// P1 attacks clippers by vertices on the plane.
void p1_near_plane(StressRows& rows) {
    rows.add_pictures(p1_touching, "a vertex on it", {}, 512, {}, by_clipping);
    rows.add_pictures(p1_on, "all on it", {}, 512, {}, by_clipping);
    rows.add_pictures(p1_before, "all before it", {}, 0, {}, by_clipping);
}

/// P2 attacks the division by a negative w.
void p2_behind_eye(StressRows& rows) {
    rows.add_pictures(p2, "clipped, then divided", {}, 320, {}, by_clipping);
    rows.add("exact", "textbook: divided, not clipped", without_clipping(readable_scene(p2)),
             wrong(576, "", "256 pixels, 0 in common"));
}

/// P3 attacks the division by w = 0.
void p3_beside_eye(StressRows& rows) {
    rows.add_pictures(p3, "clipped, then divided", {}, 768, {}, by_clipping);
}

/// P4 attacks facing tests with >=.
void p4_edge_on(StressRows& rows) {
    add_hidden_face(rows, p4, "cull: back", "0");
    const auto dot = facing<double>({0, 0, 0}, {1, 0, 0}, {0, 0, -1}, {5, 0, -3}, {0, 0, 0});
    rows.add("double", "textbook: visible if >= 0", {.wrong = dot >= 0 ? 1u : 0u, .unit = "face"},
             wrong(1));
}

/// P5 attacks facing tests on inputs that are rounded: edge-on as typed is not edge-on as held.
void p5_edge_on_decimals(StressRows& rows) {
    const auto seen = [&rows](std::string_view scalar, std::string_view label,
                              const Rational& found, const Documented& documented) {
        rows.add(scalar, label, edge_on(found, "face"), documented);
    };
    constexpr std::string_view added = "textbook: from A, eye added up";
    seen("float", added, exact_value(p5_from_a<float>(false)), right());
    seen("double", added, exact_value(p5_from_a<double>(false)), wrong(1, "1.1e-16", "-1"));
    seen("exact", added, p5_from_a<Rational>(false), right());
    seen("exact", "from A, eye added up in float", p5_of_rounded_inputs<float>(false),
         wrong(1, "1.05e-7", "+1"));
    seen("exact", "from A, eye added up in double", p5_of_rounded_inputs<double>(false),
         wrong(1, "1.7e-16", "-1"));
    constexpr std::string_view typed = "textbook: from A, eye typed";
    seen("float", typed, exact_value(p5_from_a<float>(true)), wrong(1, "1.19e-7", "-1"));
    seen("double", typed, exact_value(p5_from_a<double>(true)), wrong(1, "1.11e-16", "+1"));
    seen("exact", typed, p5_from_a<Rational>(true), right());
    seen("exact", "from A, all rounded to float", p5_of_rounded_inputs<float>(true),
         wrong(1, "3.77e-8", "-3"));
    seen("exact", "from A, all rounded to double", p5_of_rounded_inputs<double>(true),
         wrong(1, "2.5e-17", "+2"));
    // Ours takes the view from the middle of the face.
    add_hidden_face(rows, p5, "cull: back", "0",
                    {{"float", wrong(1, "", "-1.7881393e-07, culled")},
                     {"double fixed", wrong(1, "", "2.220446049250313e-16, not culled")}});
}

/// P6 attacks normals, which are differences of large products.
void p6_nearly_edge_on(StressRows& rows) {
    add_hidden_face(rows, p6, "cull: back", "-1",
                    {{"float double fixed", wrong(1, "", "zero area")}});
}

/// P7 attacks facing tests that normalize.
void p7_no_normal(StressRows& rows) {
    add_hidden_face(rows, p7_coincident, "B = C", "");
    add_hidden_face(rows, p7_eye_on_vertex, "the eye on a vertex", "0");
    add_hidden_face(rows, p7_eye_in_plane, "the eye in the plane", "0");
}

/// P8 attacks facing tests that take the view from one vertex, by taking it from another.
void p8_each_vertex(StressRows& rows) {
    rows.add_for_all("normal . (eye - V)", {{"float", wrong(837)}, {"double fixed", wrong(842)}},
                     [](std::string_view scalar) {
                         return with_coordinates_of(
                             readable_scene(p5, with_scalar_named({}, scalar)),
                             []<typename Scalar>() { return faces_of_many_minds<Scalar>(); });
                     });
}

/// P9 attacks matrices by views that have none.
void p9_no_view(StressRows& rows) {
    rows.add_refusals(set_up("16", R"("position": [0, 5, 0], "look_at": [0, 0, 0])", plain_frustum),
                      "up parallel to the view", "expected an up that is not parallel to the view");
    rows.add_refusals(set_up("16", R"("position": [1, 2, 3], "look_at": [1, 2, 3])", plain_frustum),
                      "eye = look_at", "position = look_at");
    rows.add_refusals(set_up("16", plain_camera, R"("fov_y": 90, "near": 1, "far": 1)"),
                      "near = far", "expected far above near");
    rows.add_refusals(set_up("16", plain_camera, R"("fov_y": 90, "near": 0, "far": 1)"), "near = 0",
                      "expected a distance above 0");
    rows.add_refusals(set_up("16", plain_camera, R"("fov_y": 0, "near": 1, "far": 9)"), "fov = 0",
                      "expected a field of view between 0 and 180");
    rows.add_refusals(set_up("16", plain_camera, R"("fov_y": 180, "near": 1, "far": 9)"),
                      "fov = 180", "expected a field of view between 0 and 180");
    rows.add_refusals(set_up("0", plain_camera, plain_frustum), "canvas 0",
                      "expected a whole number of pixels from 1");
}

/// P10 attacks viewports that are a pixel too wide.
void p10_last_column(StressRows& rows) {
    rows.add_pictures(p10, "viewport: fit", {}, 3, {}, canonical_points);
}

/// P11 attacks tests against the canvas that let its width pass.
void p11_put_pixel(StressRows& rows) {
    rows.add_pictures(p11, "points", {}, 0);
    for (const std::string_view scalar : scalar_names()) {
        const auto trace = trace_in(p11, with_scalar_named({}, scalar));
        rows.expect_same(scalar, "points, rejected",
                         trace ? count_of(trace.value(), StepKind::reject) : 0, 3, "step");
    }
}

/// P12 attacks the joining of matrices, which is exact only before rounding.
void p12_joined_scales(StressRows& rows) {
    rows.add("float", "textbook: joined, or one by one", scales_joined<float>(), wrong(445));
    rows.add("double", "textbook: joined, or one by one", scales_joined<double>(), wrong(367));
    rows.add("exact", "textbook: joined, or one by one", scales_joined<Rational>(), right());
    rows.add_for_all("one model of two scales, or of one", {}, [](std::string_view scalar) {
        const auto picture = [scalar](const std::string& json) {
            return drawn_picture(readable_scene(json, with_scalar_named({}, scalar)));
        };
        return Measured{
            .wrong = differing(picture(p12_two), picture(p12(R"({"scale": [0.33, 0.33, 0.33]})"))),
            .unit = "pixel"};
    });
}

constexpr auto pipeline_catalogue = std::to_array<StressCase>({
    {.id = "P1",
     .title = "on the near plane",
     .input = "(-1,-1,-2)(1,-1,-2)(0,1/2,-1); (-1/2,-1/2)(1/2,-1/2)(0,1/2) at z = -1; at z = -1/2",
     .why = "a vertex on the plane, all on it, all before it: t = 0/0 in the clipper, slivers",
     .holds = "512, 512 and 0 pixels",
     .scenes =
         [] {
             return Scenes{{"a vertex on it", p1_touching},
                           {"all on it", p1_on},
                           {"all before it", p1_before}};
         },
     .run = p1_near_plane},
    {.id = "P2",
     .title = "behind the eye",
     .input = "(0,1,-2)(-1,-1,-2)(1,-1,2)",
     .why = "w = 2, 2, -2: divided by w, the third vertex stands mirrored before the eye",
     .holds = "320 pixels. Divided without clipping: 256, none of them in common.",
     .scenes = [] { return only(p2); },
     .run = p2_behind_eye},
    {.id = "P3",
     .title = "beside the eye",
     .input = "(0,1,-2)(-1,-1,-2)(1,-1,0)",
     .why = "w = 0: no place on the screen",
     .holds = "768 pixels",
     .scenes = [] { return only(p3); },
     .run = p3_beside_eye},
    {.id = "P4",
     .title = "edge-on",
     .input = "(0,0,0)(1,0,0)(0,0,-1), eye (5,0,-3)",
     .why = "normal . view = 0 exactly",
     .holds = "culled: a front has normal . view > 0. A test with >= draws it.",
     .scenes = [] { return only(p4); },
     .run = p4_edge_on},
    {.id = "P5",
     .title = "edge-on in decimals",
     .input = "A = 0, B(.1,.2,.3), C(.7,-.4,.5), eye = 3B + 7C = (5.2,-2.2,4.4)",
     .why = "none of the decimals is a float or double: what was typed is edge-on, what is held "
            "is not",
     .holds = "0 as typed: culled. With the eye added up, exactly for the inputs as rounded: "
              "+1.05e-7 (float), -1.7e-16 (double); computed: 0 (float), -1.1e-16 (double). "
              "Rounded, the face is turned either way: say which input is meant.",
     .scenes = [] { return only(p5); },
     .run = p5_edge_on_decimals},
    {.id = "P6",
     .title = "nearly edge-on",
     .input = "(0,0,0)(F40,F41,0)(F41,F42,0), eye (0,0,1)",
     .why = "the normal is the difference of two products of 2.7e16",
     .holds = "normal . view = -1: a back face. In float and double the normal is 0, and the face "
              "has no area.",
     .scenes = [] { return only(p6); },
     .run = p6_nearly_edge_on},
    {.id = "P7",
     .title = "no normal, no view",
     .input = "B = C; the eye on a vertex; the eye in the plane",
     .why = "a vector of length 0 has no cosine: 0/0",
     .holds = "not drawn, and nothing is normalized to decide it. A textbook's N.E/|N.E| is 0/0.",
     .scenes =
         [] {
             return Scenes{{"B = C", p7_coincident},
                           {"the eye on a vertex", p7_eye_on_vertex},
                           {"the eye in the plane", p7_eye_in_plane}};
         },
     .run = p7_no_normal},
    {.id = "P8",
     .title = "seen from A, B or C",
     .input = "1,000 random faces on a grid of 1/10",
     .why = "normal . (eye - V) does not depend on the vertex V, but its rounding does",
     .holds = "the same for all three, exactly; rounded, seldom",
     .run = p8_each_vertex},
    {.id = "P9",
     .title = "a view that is none",
     .input =
         "up parallel to the view; eye = look_at; near = far; near = 0; fov 0 or 180; canvas 0",
     .why = "a matrix of NaN or of infinities",
     .holds = "each is refused by its name",
     .run = p9_no_view},
    {.id = "P10",
     .title = "the last column",
     .input = "canonical x = 1, 0, -1 on 64 pixels",
     .why = "(w-1)/2 or w/2: the one ends at pixel 63, the other at 64, outside",
     .holds = "by T4's (w-1)/2: pixel 63, center 31.5. By w/2 the last column is lost.",
     .scenes = [] { return only(p10); },
     .run = p10_last_column},
    {.id = "P11",
     .title = "PutPixel at the edge",
     .input = "(512,0), (512,512), (0,512) on a canvas of 512",
     .why = "the text's test is x > width: 512 passes",
     .holds = "rejected, and the trace says so. The text's PutPixel writes (512,y) to the next "
              "row, and (512,512) behind the buffer.",
     .scenes = [] { return only(p11); },
     .run = p11_put_pixel},
    {.id = "P12",
     .title = "two scales, or their product",
     .input = "0.1, then 3.3, of 1..1000",
     .why = "matrix products are not associative when they are rounded",
     .holds =
         "equal in exact arithmetic. Rounded: 445 differ in float, 367 in double. Ours joins a "
         "model's steps exactly and rounds once.",
     .scenes = [] { return only(p12_two); },
     .run = p12_joined_scales},
});

} // namespace

std::span<const StressCase> pipeline_cases() {
    return pipeline_catalogue;
}

} // namespace rastertrace
