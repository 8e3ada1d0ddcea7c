// SPDX-License-Identifier: MIT
// Mistakes on the way from object space to the screen, in faces, depths, colors and the canvas.

#include "model/mistake_tables.h"

namespace rastertrace {

namespace {

using Vec4 = Vec<Rational, 4>;

bool any_scene(const Scene&) {
    return true;
}
bool is_projected(const Scene& scene) {
    return scene.projection.type != ProjectionType::none;
}
bool has_perspective(const Scene& scene) {
    return is_perspective(scene.projection.type);
}
bool has_camera(const Scene& scene) {
    return scene.camera.has_value();
}
bool has_models(const Scene& scene) {
    return std::any_of(scene.objects.begin(), scene.objects.end(),
                       [](const SceneObject& object) { return !object.model.steps().empty(); });
}
bool fits_last_pixel(const Scene& scene) {
    return scene.viewport.type == ViewportType::pixels &&
           scene.viewport.pixels == PixelRange::centers;
}
bool has_viewport(const Scene& scene) {
    return scene.viewport.type == ViewportType::pixels;
}
bool culls_faces(const Scene& scene) {
    return scene.has_faces() && scene.method.cull != Cull::none;
}
bool is_lit(const Scene& scene) {
    return scene.has_faces() && scene.method.shade == Shade::lambert;
}
bool has_buffer(const Scene& scene) {
    return scene.has_depth_buffer();
}
bool has_inverse_depths(const Scene& scene) {
    return scene.has_depth_buffer() && scene.depth() == Depth::inverse_z;
}
bool is_painted(const Scene& scene) {
    return scene.depth() == Depth::painter;
}
bool mixes_colors(const Scene& scene) {
    return has_triangles(scene) && scene.mixes_colors();
}

/// A matrix of other factors.
void set(ModelMatrix& matrix, MatrixFactors<Rational> factors) {
    matrix = {std::move(factors), {}};
    matrix.product = product_of(matrix.factors);
}

/// Its factors in the other order.
void reverse(ModelMatrix& matrix) {
    set(matrix, {matrix.factors.rbegin(), matrix.factors.rend()});
}

/// v/w, far away where w is 0.
Vec<Rational, 3> divided_anyway(const Vec4& clip) {
    const Rational w = clip.w == 0 ? Rational(1, 1024) : clip.w;
    return {clip.x / w, clip.y / w, clip.z / w};
}

constexpr Mistake space_table[] = {
    // From object space to the screen.
    {"factors-exchanged", "the matrices in the other order",
     "the last step first: its matrix stands left", "matrix", "turned about another point",
     "T4, error 3", has_models,
     [](ModelRules& rules) {
         for (ModelMatrix& model : rules.models)
             reverse(model);
     }},
    {"turned-the-other-way", "sin for -sin", "(cos, -sin), (sin, cos)", "matrix",
     "turned the other way", "the sign of an angle", has_models,
     [](ModelRules& rules) {
         for (ModelMatrix& model : rules.models) {
             // The inverse of a rotation is its transpose.
             MatrixFactors<Rational> factors = model.factors;
             for (auto& [name, matrix] : factors)
                 for (std::size_t row = 0; name == "rotate" && row < 3; ++row)
                     for (std::size_t column = 0; column < row; ++column)
                         std::swap(matrix.rows[row][column], matrix.rows[column][row]);
             set(model, std::move(factors));
         }
     }},
    {"moved-after-turning", "V = T R: the camera's position after its rotation", "V = R T",
     "matrix", "the scene lies elsewhere unless the camera looks along z", "T4, error 2",
     has_camera, [](ModelRules& rules) { reverse(rules.view); }},
    {"camera-turned-round", "z = (look_at - position)/|...|", "z = (position - look_at)/|...|",
     "matrix", "the scene is behind the camera, upside down if nothing is clipped", "T4, error 1",
     has_camera,
     [](ModelRules& rules) {
         rules.view = {{}, diagonal<Rational>(-1, 1, -1, 1) * rules.view.product};
         rules.planes.clear();
         rules.divided = divided_anyway;
     }},
    {"projection-order", "M_t M_p", "M_p M_t", "matrix", "all depths are the same", "T4, error 3",
     [](const Scene& scene) { return scene.projection.type == ProjectionType::view_plane; },
     [](ModelRules& rules) { reverse(rules.projection); }},
    {"no-near-clip", "x/w, whatever w is", "clipped at the near plane, then divided", "clip",
     "what is behind the eye appears upside down in front of it",
     "GameDev.net, The Near Plane on a Software Rasterizer, 2005", has_perspective,
     [](ModelRules& rules) {
         rules.planes.clear();
         rules.divided = divided_anyway;
     }},
    {"dropped-at-near-plane", "a triangle with a vertex before the near plane is dropped",
     "it is cut", "clip", "triangles vanish when they come close", "bullet3#1006, EmberGL#1",
     is_projected,
     [](ModelRules& rules) {
         rules.drops = [&rules](const ModelRules::Corners& corners) {
             return std::any_of(corners.begin(), corners.end(), [&](const auto& corner) {
                 return std::any_of(rules.planes.begin(), rules.planes.end(),
                                    [&corner](const auto& plane) {
                                        return (plane.name == "near" || plane.name == "w") &&
                                               !plane.has_inside(corner.position);
                                    });
             });
         };
     }},
    {"off-screen-after-divide", "x/w < -1 at all vertices: dropped", "x < -w at all vertices",
     "clip", "the ground disappears near the camera", "tgx#47", has_perspective,
     [](ModelRules& rules) {
         rules.drops = [](const ModelRules::Corners& corners) {
             const auto all = [&corners](Rational Vec<Rational, 3>::*axis, int side) {
                 return std::all_of(corners.begin(), corners.end(), [&](const auto& corner) {
                     return divided_anyway(corner.position).*axis * side > 1;
                 });
             };
             using V = Vec<Rational, 3>;
             return all(&V::x, 1) || all(&V::x, -1) || all(&V::y, 1) || all(&V::y, -1);
         };
     }},
    {"not-divided", "x, y", "x/w, y/w", "vertex", "no perspective", "T4", has_perspective,
     [](ModelRules& rules) {
         rules.divided = [](const Vec4& clip) { return Vec<Rational, 3>{clip.x, clip.y, clip.z}; };
     }},
    {"size-for-last-pixel", "(x + 1) W/2", "(x + 1) (W - 1)/2", "vertex",
     "the last column and row are missing", "T4, error 4", fits_last_pixel,
     [](ModelRules& rules) {
         const Canvas& canvas = rules.scene.canvas;
         rules.placed = [right = rules.placed,
                         x = Rational(canvas.width, std::max(canvas.width - 1, 1)),
                         y = Rational(canvas.height, std::max(canvas.height - 1, 1))](
                            const Vec<Rational, 2>& at) {
             return right({at.x * x, at.y * y});
         };
     }},
    {"last-pixel-for-size", "(x + 1) (W - 1)/2", "(x + 1) W/2", "vertex",
     "the picture is a pixel too small", "T4, error 4",
     [](const Scene& scene) { return has_viewport(scene) && !fits_last_pixel(scene); },
     [](ModelRules& rules) {
         const Canvas& canvas = rules.scene.canvas;
         rules.placed =
             [right = rules.placed, x = Rational(canvas.width - 1, canvas.width),
              y = Rational(canvas.height - 1, canvas.height)](const Vec<Rational, 2>& at) {
                 return right({at.x * x, at.y * y});
             };
     }},
    {"half-size-in-integers", "int(W - 1)/2: 255 for 255.5", "(W - 1)/2", "vertex",
     "half a pixel off", "T4, error 5", fits_last_pixel,
     [](ModelRules& rules) {
         rules.viewport.factors.clear();
         for (const std::size_t row : {0U, 1U})
             for (Rational& entry : rules.viewport.product.rows[row])
                 entry = cut(entry);
     }},
    {"turned-after-moving", "y = -(y + 1) (H - 1)/2", "y = (1 - y) (H - 1)/2", "vertex",
     "nothing is on the screen", "T4, error 4", has_viewport,
     [](ModelRules& rules) {
         rules.viewport.factors.clear();
         Rational& shift = rules.viewport.product.rows[1][3];
         shift = -abs(shift);
     }},
    {"y-the-other-way", "y flipped twice, or never", "y flipped once", "vertex",
     "the picture is upside down", "T4", any_scene,
     [](ModelRules& rules) {
         const Canvas& canvas = rules.scene.canvas;
         rules.placed = [right = rules.placed,
                         sum = canvas.top() + canvas.bottom()](const Vec<Rational, 2>& at) {
             return right({at.x, sum - at.y});
         };
     }},

    // Faces.
    {"view-turned-round", "from the eye to the face", "from the face to the eye", "face",
     "inside out", "T0, error 22", culls_faces, nullptr, "cull=front"},
    {"culled-by-light", "normal . light <= 0: dropped", "normal . view <= 0: dropped", "face",
     "half of what is seen is missing", "tinyrenderer#64",
     [](const Scene& scene) { return culls_faces(scene) && scene.light.has_value(); }, nullptr,
     "cull=light"},
    {"no-culling", "every face is drawn", "normal . view <= 0: dropped", "face",
     "far faces over near ones", "T0, figure fail1", culls_faces, nullptr, "cull=none"},
    {"z-of-the-normal", "normal.z > 0", "normal . view > 0", "face",
     "faces near the silhouette are culled wrongly", "T1, N_7 > 0", culls_faces,
     [](ModelRules& rules) {
         rules.facing = [](const auto& normal, const auto&) { return normal.z; };
     }},
    {"cosine-of-dot-only", "normal . light", "normal . light / (|normal| |light|)", "light",
     "cosines beyond 1: large faces are white", "T3, error 7", is_lit,
     [](ModelRules& rules) {
         rules.intensity = [](const auto& normal, const auto& light) {
             return std::clamp(Rational(dot(normal, light)).get_d(), 0.0, 1.0);
         };
     }},
    {"cosine-by-its-own-size", "N . L / |N . L|", "N . L / (|N| |L|)", "light",
     "faces are bright or black, nothing between", "T1", is_lit,
     [](ModelRules& rules) {
         rules.intensity = [](const auto& normal, const auto& light) {
             return dot(normal, light) > 0 ? 1.0 : 0.0;
         };
     }},
    {"light-from-behind", "|normal . light|", "normal . light, 0 if it is negative", "light",
     "faces turned from the light are lit", "T3, error 7", is_lit,
     [](ModelRules& rules) {
         rules.intensity = [right = rules.intensity](const auto& normal, const auto& light) {
             return std::max(right(normal, light), right({-normal.x, -normal.y, -normal.z}, light));
         };
     }},

    // Depths.
    {"nearest-painted-first", "nearest first", "farthest first", "order", "far triangles on top",
     "T0, error 9", is_painted, [](ModelRules& rules) { rules.paints_farthest_first = false; }},
    {"painter-for-buffer", "sorted by the mean of z", "a depth buffer", "order",
     "far triangles on top where they overlap", "cetz#1040, olcPixelGameEngine#69", has_buffer,
     nullptr, "depth=painter"},
    {"no-depth-test", "what is drawn last stays", "what is nearest stays", "depth",
     "far triangles on top", "T0", has_buffer, nullptr, "depth=none"},
    {"buffer-begun-at-tiny", "the buffer starts at the smallest positive float",
     "at the farthest depth", "depth", "faces have holes, or nothing is drawn", "tinyrenderer#95",
     has_buffer,
     [](ModelRules& rules) {
         mpz_class power;
         mpz_ui_pow_ui(power.get_mpz_t(), 2, 126);
         rules.cleared = Rational(1, power);
     }},
    {"equal-depth-passes", "nearer or as near", "nearer", "depth",
     "dots at edges, and flicker on equal planes", "tinyrenderer#85", has_buffer,
     [](ModelRules& rules) {
         rules.passes = [right = rules.passes](const Rational& depth,
                                               const std::optional<Rational>& stored) {
             return right(depth, stored) || depth == stored;
         };
     }},
    {"farther-passes", "the farther one passes", "the nearer one", "depth", "seen from behind",
     "GAMES101, assignment 3", has_buffer,
     [](ModelRules& rules) {
         rules.cleared = std::nullopt;
         rules.passes = [right = rules.passes](const Rational& depth,
                                               const std::optional<Rational>& stored) {
             return !stored || (depth != *stored && !right(depth, stored));
         };
     }},
    {"z-for-inverse-z", "z in a straight line", "1/z in a straight line", "depth",
     "what is in the middle lies too far away", "T0, error 10", has_inverse_depths, nullptr,
     "depth=linear-z"},
    {"z-tested-as-inverse-z", "buffer < z, from 0", "buffer < 1/z, from 0", "depth",
     "far triangles on top", "T0, error 10", has_inverse_depths,
     [](ModelRules& rules) {
         rules.depth_of = [](const Rational& distance, const Vec4&) { return distance; };
     }},
    {"depth-in-8-bits", "int(255 z)", "z", "depth",
     "stripes where surfaces are near to one another", "a depth image", has_buffer,
     [](ModelRules& rules) {
         rules.passes = [right = rules.passes](const Rational& depth,
                                               const std::optional<Rational>& stored) {
             const auto in_bits = [](const Rational& z) {
                 return Rational(floor_index(Rational(z * 255)));
             };
             return right(in_bits(depth), stored ? std::optional(in_bits(*stored)) : std::nullopt);
         };
     }},
    {"depth-at-rounded-ends", "the depths of the edges at the row's first and last pixel",
     "where the edges meet the row", "depth", "depths a little beside along edges", "T0, error 11",
     [](const Scene& scene) { return has_buffer(scene) && fills_by_rows(scene); }, nullptr,
     "depth_at=rounded-ends"},

    // Colors.
    {"affine-for-perspective", "weights on the screen",
     "each weight over its w, then over their sum", "pixel",
     "colors bend along the diagonal of a square", "euc#5, SoftwareRenderer#1",
     [](const Scene& scene) { return scene.mixes_in_perspective(); }, nullptr, "shade=affine"},
    {"perspective-for-affine", "each weight over its w", "weights on the screen", "pixel",
     "colors are drawn to the near side", "xemu#667",
     [](const Scene& scene) { return has_triangles(scene) && scene.shade() == Shade::affine; },
     nullptr, "shade=interpolate"},
    {"weights-permuted", "the weight of A for B, of B for C, of C for A", "each its own", "pixel",
     "colors look as if they were not sorted", "tinyrenderer#40", mixes_colors,
     [](ModelRules& rules) {
         rules.shares = [right = rules.shares](const ModelTriangle& triangle,
                                               const ModelWeights& weights) {
             const ModelWeights shares = right(triangle, weights);
             return ModelWeights{shares[2], shares[0], shares[1]};
         };
     }},
    {"byte-cast", "int(level)", "round(level)", "pixel", "127 in the middle of 0 to 255", "T2",
     mixes_colors, nullptr, "color_rounding=truncate"},
    {"level-overflows", "byte(level): 256 is 0", "level held in 0 to 255", "pixel",
     "wrong colors along edges", "T4, error 10", mixes_colors,
     [](ModelRules& rules) {
         rules.level = [](const Rational& channel) {
             return static_cast<std::uint8_t>(nearest_index(channel, Ties::up));
         };
     }},

    // The canvas.
    {"canvas-one-too-wide", "x > W or y > H: off the canvas", "x >= W or y >= H", "pixel",
     "what leaves the right side comes back in the next row", "T4, error 9", any_scene,
     [](ModelRules& rules) {
         rules.beside_canvas = [&canvas = rules.scene.canvas](GridPoint p) {
             const GridPoint next{canvas.left(), p.y + canvas.down()};
             return p.x == canvas.right() + 1 && canvas.contains(next.x, next.y)
                        ? std::optional(next)
                        : std::nullopt;
         };
     }},
    {"no-bounds-test", "buffer[W y + x], wherever x is", "only if 0 <= x < W and 0 <= y < H",
     "pixel", "what leaves one side comes back at the other", "T2, error 9", any_scene,
     [](ModelRules& rules) {
         rules.beside_canvas = [&canvas = rules.scene.canvas](GridPoint p) {
             const Index index = canvas.row_of(p.y) * canvas.width + (p.x - canvas.left());
             return index < 0 || index >= Index{canvas.width} * canvas.height
                        ? std::nullopt
                        : std::optional(GridPoint{canvas.left() + index % canvas.width,
                                                  canvas.y_of(index / canvas.width)});
         };
     }},
};

} // namespace

std::span<const Mistake> mistakes_of_space() {
    return space_table;
}

} // namespace rastertrace
