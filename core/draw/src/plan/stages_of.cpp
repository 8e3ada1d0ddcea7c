// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/plan/stages.h>

#include "plan/survey.h"

#include <rastertrace/core/draw/list/geometry.h>

#include <type_traits>

namespace rastertrace {

namespace {

/// What a face of the scene is called.
std::string word_for_face(const Scene& scene) {
    return scene.has(PrimitiveKind::polygon) ? "face" : "triangle";
}

/// True if a primitive's colors are not mixed by steps on the screen.
bool mixes_by_weights_or_in_space(const Scene& scene, PrimitiveKind kind) {
    const bool has_weights = kind == PrimitiveKind::triangle && scene.method.fill != Fill::fan;
    return has_weights || scene.color_lerp() == ColorLerp::space;
}

/// The stages of each primitive's pixels.
std::vector<PixelStages> pixel_stages(const Scene& scene,
                                      const std::vector<PrimitiveSurvey>& surveys) {
    const bool has_depth_buffer = scene.has_depth_buffer();
    const bool mixes_colors = scene.mixes_colors();
    const bool mixes_in_perspective = scene.mixes_in_perspective();
    const PixelBox canvas = box_of(scene.canvas);
    std::vector<PixelStages> result(surveys.size());
    for (std::size_t i = 0; i < surveys.size(); ++i) {
        const PrimitiveSurvey& survey = surveys[i];
        PixelStages& stages = result[i];
        stages.tests_canvas = scene.keep.has(Stage::canvas) || !canvas.contains(survey.box);
        stages.is_painted = scene.primitives[i].is_painted;
        stages.tests_depth = has_depth_buffer && (scene.keep.has(Stage::depth) ||
                                                  survey.may_be_hidden() || survey.has_parts());
        if (mixes_colors && (survey.colors_differ || scene.keep.has(Stage::colors)))
            stages.colors = mixes_in_perspective &&
                                    mixes_by_weights_or_in_space(scene, survey.kind) &&
                                    (survey.w_differs || scene.keep.has(Stage::perspective))
                                ? ColorStage::perspective
                                : ColorStage::affine;
    }
    return result;
}

/// What a list says of the stages of vertices. Vertices as typed go through none.
struct VertexStages {
    std::uint64_t vertices = 0; ///< that go through them
    StageSet needed = {};
    StageSet runs = {};
    bool projects = false;
    std::vector<VerticesOutside> outside = {};
};

VertexStages vertex_stages(const Scene& scene, const AnyScreenList& any) {
    return std::visit(
        [&scene]<typename AList>(const AList& list) -> VertexStages {
            if constexpr (std::is_same_v<AList, TypedVertices>) {
                return {};
            } else {
                const auto& transforms = list.transforms;
                const auto is_used = used_vertices(scene);
                VertexStages stages{.vertices = static_cast<std::uint64_t>(
                                        std::count(is_used.begin(), is_used.end(), true)),
                                    .needed = transforms.needed,
                                    .projects = transforms.projection.has_value(),
                                    .outside = list.outside};
                for (const auto& [stage, runs] :
                     {std::pair{Stage::model,
                                transforms.needed.has(Stage::model) || transforms.rest_model},
                      std::pair{Stage::view, transforms.view.has_value()},
                      std::pair{Stage::divide, transforms.divides},
                      std::pair{Stage::order, list.order.has_value()}})
                    if (runs)
                        stages.runs.add(stage);
                return stages;
            }
        },
        any);
}

/// Decides about the stages of vertices.
void decide_vertex_stages(const Scene& scene, const VertexStages& stages,
                          std::vector<StageDecision>& decisions) {
    const auto decide = [&](Stage stage, const std::string& why, std::uint64_t saved_steps) {
        decisions.push_back({stage, "", stages.runs.has(stage), why, {.steps = saved_steps}});
    };
    const bool is_typed_projected = scene.projection.type == ProjectionType::clip_space;
    const std::uint64_t steps_of_space = is_typed_projected ? 0 : stages.vertices;
    decide(Stage::model,
           is_typed_projected                ? "vertices are typed in clip space"
           : stages.needed.has(Stage::model) ? "a model moves its vertices"
                                             : "no model moves anything",
           steps_of_space);
    decide(Stage::view,
           is_typed_projected               ? "vertices are typed in clip space"
           : stages.needed.has(Stage::view) ? "the camera moves the world"
           : scene.camera                   ? "the camera looks from where the world begins"
                                            : "there is no camera",
           steps_of_space);
    for (const auto& [plane, outside] : stages.outside)
        decisions.push_back({Stage::clip, plane, outside > 0 || scene.keep.has(Stage::clip),
                             outside == 1  ? "1 vertex lies outside it"
                             : outside > 0 ? std::to_string(outside) + " vertices lie outside it"
                                           : "no vertex lies outside it"});
    if (stages.outside.empty())
        decide(Stage::clip, "nothing bounds the view", 0);
    decide(Stage::divide,
           stages.needed.has(Stage::divide) ? "w is not 1 at every vertex"
                                            : "w is 1 at every vertex",
           stages.projects ? stages.vertices : 0);
    const bool paints = scene.depth() == Depth::painter;
    decide(Stage::order,
           !paints ? "the method has no painter"
           : stages.needed.has(Stage::order)
               ? "the farthest " + word_for_face(scene) + "s do not come first"
               : "the farthest " + word_for_face(scene) + "s come first already",
           paints ? 1 : 0);
}

/// Decides about the stages of faces. They change the picture, so they run exactly if the method
/// asks for them.
void decide_face_stages(const Scene& scene, std::vector<StageDecision>& decisions) {
    const bool culls = scene.method.cull != Cull::none;
    const bool lights = scene.method.shade == Shade::lambert;
    const bool has_faces = scene.has_faces();
    const auto why = [has_faces](bool is_asked) {
        return !is_asked    ? "the method does not ask for it"
               : !has_faces ? "there is no triangle"
                            : "the method asks for it";
    };
    decisions.push_back({Stage::cull, "", culls && has_faces, why(culls)});
    decisions.push_back({Stage::light, "", lights && has_faces, why(lights)});
}

/// Why depths are tested, or not. What is only asked to be kept does not count.
std::string why_depth(const std::vector<PrimitiveSurvey>& surveys) {
    std::uint64_t all = 0, hidden = 0, with_parts = 0;
    bool are_triangles = true;
    for (const PrimitiveSurvey& one : surveys) {
        if (one.pieces == 0)
            continue;
        ++all;
        hidden += one.may_be_hidden() ? 1 : 0;
        with_parts += one.has_parts() && !one.may_be_hidden() ? 1 : 0;
        are_triangles = are_triangles && one.kind == PrimitiveKind::triangle;
    }
    const std::string of_all = " of " + counted(all, are_triangles ? "triangle" : "primitive");
    std::string why;
    if (hidden > 0)
        why = std::to_string(hidden) + of_all +
              " may share a pixel with another, or may be as far as the buffer starts";
    if (with_parts > 0)
        why += (why.empty() ? "" : "; ") + std::to_string(with_parts) + of_all +
               (with_parts == 1 ? " has" : " have") +
               (are_triangles ? " parts, made by clipping, that may share a pixel"
                              : " parts or sides that may share a pixel");
    if (!why.empty())
        return why;
    return are_triangles ? "no two triangles can share a pixel"
                         : "no two primitives can share a pixel";
}

/// How often a stage of pixels is needed.
struct StageCount {
    std::uint64_t needed = 0;       ///< triangles that need it
    std::uint64_t kept = 0;         ///< primitives that have it
    std::uint64_t saved_pixels = 0; ///< in the boxes of the others

    void add(bool is_needed, bool is_kept, std::uint64_t pixels) {
        needed += is_needed ? 1 : 0;
        kept += is_kept ? 1 : 0;
        saved_pixels += is_kept ? 0 : pixels;
    }
};
struct PixelStageCounts {
    std::uint64_t faces = 0;
    std::uint64_t lines = 0; ///< whose colors are mixed in space
    StageCount canvas, depth, perspective, colors;
    PixelBox tested; ///< the pixels whose depths are tested
};

PixelStageCounts counts_of(const Scene& scene, const std::vector<PrimitiveSurvey>& surveys,
                           const std::vector<PixelStages>& stages, const PixelBox& canvas) {
    PixelStageCounts counts;
    const bool mixes_lines = scene.mixes_lines_in_space();
    for (std::size_t i = 0; i < surveys.size(); ++i) {
        const PrimitiveSurvey& survey = surveys[i];
        if (survey.pieces == 0)
            continue;
        const PixelBox box = survey.box.intersected(canvas);
        const bool tests_depth = stages[i].tests_depth;
        const ColorStage colors = stages[i].colors;
        if (tests_depth && !box.is_empty())
            counts.tested = counts.tested.joined(box);
        counts.depth.add(false, tests_depth, is_filled(survey.kind) ? box.area() : 0);
        if (mixes_lines &&
            (survey.kind == PrimitiveKind::line || survey.kind == PrimitiveKind::outline)) {
            ++counts.lines;
            counts.perspective.add(survey.w_differs, colors == ColorStage::perspective, 0);
        }
        if (!is_filled(survey.kind))
            continue;
        ++counts.faces;
        counts.canvas.add(!canvas.contains(survey.box), stages[i].tests_canvas, box.area());
        counts.perspective.add(survey.w_differs, colors == ColorStage::perspective, box.area());
        counts.colors.add(survey.colors_differ, colors != ColorStage::flat, box.area());
    }
    return counts;
}

/// Decides about the stages of pixels, from what was decided for each primitive.
void decide_pixel_stages(const Scene& scene, const std::vector<PrimitiveSurvey>& surveys,
                         std::size_t depth_size, Stages& stages) {
    const PixelBox canvas = box_of(scene.canvas);
    const PixelStageCounts counts = counts_of(scene, surveys, stages.pixels, canvas);
    const bool has_depths = scene.has_depth_buffer();
    const PixelBox tested = has_depths && scene.keep.has(Stage::depth) ? canvas : counts.tested;
    stages.depth_region = {tested.left, tested.top, std::max(tested.right - tested.left + 1, 0),
                           std::max(tested.bottom - tested.top + 1, 0)};

    const auto decide = [&stages](Stage stage, const StageCount& count, const std::string& why,
                                  bool applies, std::uint64_t bytes = 0) {
        stages.decisions.push_back({stage,
                                    "",
                                    count.kept > 0,
                                    why,
                                    {.bytes = bytes, .pixels = applies ? count.saved_pixels : 0}});
    };
    const std::string face = word_for_face(scene);
    const auto of_all = [&](const StageCount& count) {
        return std::to_string(count.needed) + " of " + counted(counts.faces, face);
    };
    const bool fills = counts.faces > 0;
    const bool mixes = fills && scene.mixes_colors();
    const std::uint64_t mixed = counts.faces + counts.lines;
    const bool mixes_in_space = mixed > 0 && scene.mixes_in_perspective();
    const std::string one_mixed = counts.lines > 0 ? "primitive" : face;
    decide(Stage::canvas, counts.canvas,
           counts.canvas.needed > 0 ? of_all(counts.canvas) + " may reach beyond the canvas"
           : fills                  ? "every " + face + " lies on the canvas"
                                    : "no triangle is filled",
           true);
    decide(Stage::depth, counts.depth,
           has_depths ? why_depth(surveys) : "the method has no depth buffer", has_depths,
           has_depths ? (canvas.area() - tested.area()) * depth_size : 0);
    decide(Stage::perspective, counts.perspective,
           !mixes_in_space ? "no colors are mixed in a perspective"
           : counts.perspective.needed > 0
               ? "w differs in " + std::to_string(counts.perspective.needed) + " of " +
                     counted(mixed, one_mixed)
               : "w is the same all over each " + one_mixed,
           mixes_in_space);
    decide(Stage::colors, counts.colors,
           !mixes                     ? "no colors are mixed"
           : counts.colors.needed > 0 ? "the vertices differ in " + of_all(counts.colors)
                                      : "the vertices of each " + face + " agree",
           mixes);
}

} // namespace

Stages stages_of(const Scene& scene, const AnyScreenList& list, std::size_t depth_size) {
    const std::vector<PrimitiveSurvey> surveys = survey_of(scene, list);
    Stages stages;
    stages.pixels = pixel_stages(scene, surveys);
    decide_vertex_stages(scene, vertex_stages(scene, list), stages.decisions);
    decide_face_stages(scene, stages.decisions);
    decide_pixel_stages(scene, surveys, depth_size, stages);

    for (StageDecision& decision : stages.decisions) {
        if (decision.is_kept)
            decision.saved = {};
        if (decision.is_kept && scene.keep.has(decision.stage))
            decision.why = "asked to be kept; " + decision.why;
    }
    return stages;
}

} // namespace rastertrace
