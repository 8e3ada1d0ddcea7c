// SPDX-License-Identifier: MIT
#include "scene_file.h"

#include "face_cuts.h"
#include "obj_file.h"
#include "pipeline_json.h"
#include "refusal.h"
#include "scene_keys.h"
#include "triangles_text.h"
#include "variations.h"

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/core/draw/list/geometry.h>
#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/draw/model/mistakes.h>
#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/draw/scene/fit.h>
#include <rastertrace/core/raster/circle.h>
#include <rastertrace/core/raster/fill_edge_table.h>
#include <rastertrace/trace/text/byte_order_mark.h>
#include <rastertrace/trace/text/canvas_json.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/conventions.h>
#include <rastertrace/trace/text/json_document.h>
#include <rastertrace/trace/text/json_reader.h>
#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/method_file.h>
#include <rastertrace/trace/text/name_index.h>
#include <rastertrace/trace/text/primitive_name.h>
#include <rastertrace/trace/text/stage_name.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/trace_layout.h>
#include <rastertrace/trace/text/typed_digits.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <system_error>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {

namespace {

/// The file name without its folder.
std::string base_name(const std::string& path) {
    return path.substr(path.find_last_of('/') + 1);
}

/// Replaces what stands behind the first `length` characters of a name by a number.
void put_number(std::string& name, std::size_t length, std::size_t number) {
    std::array<char, std::numeric_limits<std::size_t>::digits10 + 1> digits;
    const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), number);
    name.resize(length);
    name.append(digits.data(), written.ptr);
}

/// Makes room for `more` elements, and for as many again as there are: many meshes move no element often.
template <typename Element> void make_room(std::vector<Element>& list, std::size_t more) {
    if (list.capacity() - list.size() < more)
        list.reserve(list.size() + std::max(more, list.size()));
}

/// What to do where a canvas is missing or too small.
constexpr const char* canvas_hint = R"(say "canvas": {"width": ..., "height": ...})";

/// What a vertex is called, for the index of names.
struct NameOfVertex {
    const std::vector<SceneVertex>& vertices;
    std::string_view operator()(std::uint32_t vertex) const { return vertices[vertex].name; }
};

/// Reads one scene; the first fault ends it.
class SceneReader {
public:
    /// `models` has those of the frame before, by object, and then those of this one.
    SceneReader(const Source& source, const MethodOverrides& overrides, const InputLimits& limits,
                std::vector<Model>& models)
        : source_(source), json_{source}, overrides_(overrides), limits_(limits), models_(models) {}

    /// Takes everything from the document, which may be forgotten then.
    void read(const JsonValue& root) {
        // The smallest scene has vertices and triangles; everything else has a default.
        json_.allow_keys(root, scene_keys);
        if (const auto title = root.find("title"))
            scene_.title = json_.string_in(*title, "a title in quotes");
        if (const auto background = root.find("background"))
            scene_.background = color_in(*background);
        if (const auto convention = root.find("convention"))
            read_choice(*find_method_key("convention"), *convention);
        if (const auto method = root.find("method"))
            read_method(*method);
        if (const auto keep = root.find("keep"))
            read_keep(*keep);
        apply_overrides();
        apply_convention();
        apply_mistakes();
        if (const auto vertices = root.find("vertices"))
            read_vertices(*vertices);
        read_objects(root.find("model"), root.find("meshes"));
        if (const auto colors = root.find("colors"))
            read_colors(*colors);
        // Drawn in this order: what is thin comes last and stays visible.
        for (const PrimitiveKind kind : all_primitives) {
            read_primitives(root.find(traits_of(kind).list), kind);
            take_faces(kind);
        }
        if (scene_.primitives.empty())
            json_.fail(
                root, "expected at least one primitive, found none",
                R"(the smallest scene: {"vertices": {"A": [2, 5], "B": [-4, -3], "C": [5, -3]}, )"
                R"("triangles": ["ABC"]})");
        read_view(root);
        for (Method* const method : {&scene_.method, &asked_})
            drop_what_means_nothing(*method);
        check_method(root);
        check_mistakes(root);
        read_canvas(root.find("canvas"), root);
    }

    const Scene& scene() const { return scene_; }

    /// True if the camera has to be fitted to what is there before anything can be planned.
    bool fits_camera() const { return place_of_fit_.has_value(); }

    void look_from(const FittedCamera& fitted) {
        scene_.camera = fitted.camera;
        Projection& projection = scene_.projection;
        if (projection.type == ProjectionType::frustum && !projection.near) {
            projection.near = fitted.near;
            projection.far = fitted.far;
        }
    }

    [[noreturn]] void refuse_fit(std::string message, std::string hint = {}) const {
        json_.fail(*place_of_fit_, std::move(message), std::move(hint));
    }

    PlannedScene planned() {
        // From here on, nobody looks through all vertices for a color.
        scene_.method.shade = scene_.shade();
        auto plan = plan_or_unfit(scene_);
        if (const auto* unfit = std::get_if<Unfit>(&plan))
            refuse(*unfit);
        std::vector<Problem> remarks = remarks_on_z();
        if (auto remark = remark_on_w())
            remarks.push_back(*std::move(remark));
        if (place_of_camera_)
            remarks.push_back(remark_on_camera());
        if (place_of_mistake_ && !mistakes_show(std::get<Plan>(plan)))
            remarks.push_back(
                problem_at(source_, *place_of_mistake_,
                           fmt::format("remark: {} no pixel of this scene",
                                       scene_.method.mistakes.size() > 1
                                           ? "the mistakes " + quoted_mistakes() + " change"
                                           : "the mistake " + quoted_mistakes() + " changes")));
        std::move(remarks_on_meshes_.begin(), remarks_on_meshes_.end(),
                  std::back_inserter(remarks));
        return {std::move(scene_), std::get<Plan>(std::move(plan)), std::move(remarks)};
    }

private:
    /// A z that only some vertices have, where nothing looks at it: 5,5 typed for 5.5.
    std::vector<Problem> remarks_on_z() const {
        const auto& [first_without_z, first_with_z, first_with_w] = first_of_count_;
        if (!first_with_z || !first_without_z || scene_.needs_pipeline())
            return {};
        return {problem_at(source_, *first_with_z,
                           "remark: expected [x, y] as of other vertices, found three numbers; "
                           "nothing in this scene uses z",
                           "a decimal comma? JSON has a point: 5.5")};
    }

    /// Vertices in clip space that all lie behind the eye.
    std::optional<Problem> remark_on_w() const {
        if (scene_.projection.type != ProjectionType::clip_space ||
            std::any_of(scene_.vertices.begin(), scene_.vertices.end(),
                        [](const SceneVertex& vertex) { return vertex.w.exact() > 0; }))
            return std::nullopt;
        return problem_at(source_, places_of_vertices_.front(),
                          "remark: expected a vertex with w above 0, found none: all of them lie "
                          "behind the eye, and nothing is drawn");
    }

    Problem remark_on_camera() const {
        return problem_at(
            source_, *place_of_camera_,
            "remark: expected a projection for the camera, found none: x and y in the "
            "camera's space are places on the screen, and what lies behind it is drawn",
            R"(say "projection": {"type": "pinhole", "distance": 1}, or )"
            R"({"type": "none"} if that is meant)");
    }

    void read_method(const JsonValue& method) {
        std::vector<std::string_view> known;
        for (const MethodKey& key : method_keys())
            if (key.name != "convention") // a key of the scene
                known.push_back(key.name);
        json_.allow_keys(method, known);
        for (const auto& [name, value] : method.members())
            read_choice(*find_method_key(name.text), value);
    }

    void read_choice(const MethodKey& key, const JsonValue& value) {
        key.set(scene_.method, choice_in(json_, key, value));
        said_.insert(key.name);
    }

    /// The stages that run although the scene does not need them.
    void read_keep(const JsonValue& keep) {
        const std::string expected = fmt::format("stages out of {}", joined(stage_names(), ", "));
        for (const JsonValue& name : json_.array_in(keep, R"(a list of stages, like ["depth"])")) {
            const auto stage =
                name.kind == JsonValue::Kind::string ? stage_named(name.text) : std::nullopt;
            if (!stage)
                json_.fail_expecting(name, expected, did_you_mean(name.text, stage_names(), "\""));
            scene_.keep.add(*stage);
        }
    }

    void apply_overrides() {
        for (const auto& [name, value] : overrides_) {
            if (const auto stage = stage_named(value); name == "keep" && stage) {
                scene_.keep.add(*stage);
                continue;
            }
            const MethodKey* key = find_method_key(name);
            if (key == nullptr || !key->set(scene_.method, value))
                throw problem_of("", fmt::format("--{}: no such choice: {}", name, value));
            said_.insert(key->name);
        }
    }

    /// What the scene's convention sets, and the scene does not say itself.
    void apply_convention() {
        if (const ConventionRow* const row = row_of(scene_.method.convention))
            for (const auto& [name, value] : row->method)
                if (!said_.contains(name))
                    find_method_key(name)->set(scene_.method, value);
    }

    void apply_mistakes() {
        asked_ = scene_.method;
        for (const Mistake* const mistake : std::exchange(asked_.mistakes, {}))
            put_in(*mistake, scene_.method);
    }

    /// What the convention has set for other fills, or for depths that the scene has not.
    void drop_what_means_nothing(Method& method) const {
        if (method.convention == Convention::none)
            return;
        const Method other;
        const auto drop = [&](std::string_view key, auto Method::*member, bool means_nothing) {
            if (means_nothing && !said_.contains(key))
                method.*member = other.*member;
        };
        const bool by_rows = traits_of(method.fill).rule == PixelRule::row_ends;
        drop("rows", &Method::rows, !by_rows);
        drop("rounding", &Method::rounding, !by_rows);
        drop("ties", &Method::ties,
             method.snap == Snap::nearest || (by_rows && method.rounding == Rounding::nearest));
        drop("depth", &Method::depth,
             scene_.projection.type == ProjectionType::none || place_of_flat_);
    }

    void read_vertices(const JsonValue& vertices, const std::string& prefix = {}) {
        if (vertices.kind != JsonValue::Kind::object)
            json_.fail_expecting(vertices, R"(vertices by name, like {"A": [2, 5]})");
        make_room(scene_.vertices, vertices.members().size());
        make_room(places_of_vertices_, vertices.members().size());
        for (const auto& [name, place] : vertices.members()) {
            if (name.text.empty())
                json_.fail_expecting(name, "a name of at least one letter");
            constexpr std::string_view expected = "[x, y], [x, y, z] or [x, y, z, w]";
            const JsonElements coordinates = json_.array_in(place, expected);
            const std::size_t count = coordinates.size();
            if (count < 2 || count > 4)
                json_.fail_expecting(place, std::string(expected));
            auto& first_alike = first_of_count_[count - 2];
            first_alike = first_alike.value_or(place.begin);
            const auto vertex = static_cast<std::uint32_t>(scene_.vertices.size());
            scene_.vertices.push_back({prefix + name.text, json_.number_in(coordinates[0]),
                                       json_.number_in(coordinates[1]), std::nullopt,
                                       count >= 3 ? json_.number_in(coordinates[2]) : Number(0),
                                       count == 4 ? json_.number_in(coordinates[3]) : Number(1)});
            if (!vertex_by_name_.insert(vertex, NameOfVertex{scene_.vertices}))
                json_.fail_expecting(name, "a name that no other vertex has",
                                     "vertices of a mesh with a name are called NAME.VERTEX");
            places_of_vertices_.push_back(name.begin);
            float& unit = units_.emplace_back();
            for (std::size_t axis = 0; axis < count; ++axis)
                unit = std::max(unit, unit_of_last_digit(coordinates[axis].text));
        }
    }

    /// The scene's own vertices share the scene's model; each mesh has its own.
    void read_objects(const std::optional<JsonValue>& model,
                      const std::optional<JsonValue>& meshes) {
        if (!model && !meshes)
            return;
        scene_.objects.push_back({"", scene_.vertices.size(), model_in(model)});
        if (!meshes)
            return;
        const JsonElements list =
            json_.array_in(*meshes, R"(a list of meshes, like [{"obj": "cube.obj"}])");
        for (const JsonValue& mesh : list)
            if (const auto obj = mesh.find("obj"))
                ++obj_files_[obj->text].uses;
        for (const JsonValue& mesh : list)
            read_mesh(mesh);
    }

    /// The model of the next object. If the frame before has it too, its matrix is known.
    Model model_in(const std::optional<JsonValue>& value) {
        std::vector<ModelStep> steps;
        if (value)
            steps = read_model(json_, *value);
        models_.resize(std::max(models_.size(), scene_.objects.size() + 1));
        Model& model = models_[scene_.objects.size()];
        if (model.steps() != steps)
            model = std::move(steps);
        return model;
    }

    void read_mesh(const JsonValue& mesh) {
        json_.allow_keys(mesh, mesh_keys);
        SceneObject object;
        object.model = model_in(mesh.find("model"));
        if (const auto name = mesh.find("name"))
            object.name = json_.string_in(*name, "a name in quotes");
        if (!object.name.empty() && !names_of_objects_.insert(object.name).second)
            json_.fail_expecting(*mesh.find("name"), "a name that no other mesh has");

        // What all faces have in common.
        ScenePrimitive face;
        if (const auto color = mesh.find("color"))
            face.color = color_in(*color);
        if (const auto draw = mesh.find("draw")) {
            const std::vector<std::string_view> known(draw_words.begin(), draw_words.end());
            if (std::find(known.begin(), known.end(), draw->text) == known.end())
                json_.fail_expecting(*draw, "triangles, polygons, outlines or hidden-lines",
                                     did_you_mean(draw->text, known, "\""));
            if (draw->text == "outlines")
                face.kind = PrimitiveKind::outline;
            if (draw->text == "polygons") {
                face.kind = PrimitiveKind::polygon;
                place_of_flat_ = place_of_flat_.value_or(draw->begin);
            }
            if (draw->text == "hidden-lines") {
                face.is_painted = false;
                place_of_hidden_lines_ = place_of_hidden_lines_.value_or(draw->begin);
            }
        }
        sides_.clear();

        const auto obj = mesh.find("obj");
        if (!obj) {
            read_faces(mesh, object.name.empty() ? std::string() : object.name + ".", face);
        } else {
            for (const std::string_view other : {"vertices", "faces"})
                if (const auto found = mesh.find(other))
                    json_.fail(*found, fmt::format("expected obj or {}, found both", other));
            read_obj_mesh(*obj, object, face, !mesh.find("color"));
        }
        object.end_vertex = scene_.vertices.size();
        scene_.objects.push_back(std::move(object));
    }

    /// Whatever is drawn of a face beside its triangles: the sides of one that only hides, each once in its
    /// mesh, whose names begin with `prefix`.
    void begin_face(std::span<const std::size_t> corners, const std::string& prefix,
                    const ScenePrimitive& like) {
        for (std::size_t i = 0; !like.is_painted && i < corners.size(); ++i) {
            const std::size_t from = corners[i];
            const std::size_t to = corners[(i + 1) % corners.size()];
            const auto [low, high] = std::minmax(from, to);
            if (from == to || !sides_.insert(std::uint64_t{low} << 32U | high).second)
                continue;
            ScenePrimitive& side = faces_.emplace_back();
            side.kind = PrimitiveKind::line;
            side.color = like.color;
            side.is_side = true;
            side.vertices = {from, to, 0};
            const auto name_of = [&](std::size_t vertex) {
                return std::string_view(scene_.vertices[vertex].name).substr(prefix.size());
            };
            side.name = prefix + joined_names(std::array{name_of(from), name_of(to)});
        }
    }

    /// Adds a face: as a polygon; or its triangles, a fan or ears, and its sides if they are drawn.
    /// `name_of_face()` calls the whole face, `name_of_part` the k-th of its triangles.
    template <typename NameOfFace, typename NameOfPart>
    void add_face(std::span<const std::size_t> corners, const std::string& prefix,
                  const ScenePrimitive& like, FaceCuts& cuts, const JsonValue& blamed,
                  NameOfFace&& name_of_face, NameOfPart&& name_of_part) {
        if (traits_of(like.kind).has_ring) {
            ScenePrimitive& face = faces_.emplace_back(like);
            set_ring(face, {corners.begin(), corners.end()}, blamed);
            face.name = name_of_face();
            return;
        }
        begin_face(corners, prefix, like);
        if (corners.size() > 3)
            scene_.face_names.push_back(name_of_face());
        const auto polygon =
            static_cast<std::uint32_t>(corners.size() > 3 ? scene_.face_names.size() : 0);
        const auto add = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t k) {
            ScenePrimitive& face = faces_.emplace_back(like);
            face.vertices = {corners[a], corners[b], corners[c]};
            face.polygon = polygon;
            name_of_part(face, k);
        };
        Triangulation cut;
        if (corners.size() > 3)
            cut = cuts.cut(corners, blamed.begin, name_of_face);
        if (cut.form == FaceForm::too_fine)
            json_.fail(
                blamed,
                fmt::format("expected a face whose fractions have a common denominator of at "
                            "most {} bits, found a longer one",
                            most_bits_of_face));
        if (!cut.ears) {
            for (std::size_t k = 2; k < corners.size(); ++k)
                add(0, k - 1, k, k - 1);
            return;
        }
        scene_.cut_faces.push_back({.name = name_of_face(),
                                    .corners = {corners.begin(), corners.end()},
                                    .normal = cut.ears->normal,
                                    .dropped = cut.ears->dropped,
                                    .first_ear = faces_.size(), // moved by take_faces
                                    .ears = cut.ears->triangles.size()});
        places_of_ears_.push_back(faces_.size());
        for (const auto& [a, b, c] : cut.ears->triangles)
            add(a, b, c, faces_.size() - places_of_ears_.back() + 1);
    }

    void keep_remarks(const FaceCuts& cuts) {
        for (Problem& remark : cuts.remarks(source_))
            remarks_on_meshes_.push_back(std::move(remark));
    }

    /// A mesh that is written out in the scene. Polygons become triangles.
    void read_faces(const JsonValue& mesh, const std::string& prefix, const ScenePrimitive& like) {
        const std::size_t first = scene_.vertices.size();
        read_vertices(json_.member(mesh, "vertices"), prefix);
        const auto name_of = [&](std::span<const std::size_t> corners) {
            std::vector<std::string_view> names;
            for (const std::size_t corner : corners)
                names.push_back(
                    std::string_view(scene_.vertices[corner].name).substr(prefix.size()));
            return prefix + joined_names(names);
        };
        FaceCuts cuts(scene_.vertices, units_, first);
        const JsonValue faces = json_.member(mesh, "faces");
        constexpr std::string_view expected = R"(three vertices or more, "ABCD" or ["P1", ...])";
        for (const JsonValue& value :
             json_.array_in(faces, R"(a list of faces, like ["ABC", "ABCD"])")) {
            const auto corners = corners_in(value, prefix, expected);
            if (corners.size() < 3)
                json_.fail_expecting(value, expected);
            add_face(
                corners, prefix, like, cuts, value, [&] { return name_of(corners); },
                [&](ScenePrimitive& part, std::size_t) { part.name = name_of(part.corners()); });
        }
        keep_remarks(cuts);
        if (faces.elements().empty())
            json_.fail(faces, "expected at least one face, found none");
    }

    /// A mesh from a file.
    void read_obj_mesh(const JsonValue& obj, SceneObject& object, const ScenePrimitive& like,
                       bool takes_colors) {
        const std::string path = json_.string_in(obj, "the path of an OBJ file");
        ObjMesh mesh = obj_mesh(obj, path);

        if (object.name.empty()) {
            // The file's name; a second mesh of the same file gets a number.
            const std::string base = base_name(path);
            const std::string stem = base.substr(0, base.find_last_of('.'));
            object.name = stem;
            std::size_t& number = next_numbers_.try_emplace(stem, 2).first->second;
            while (!names_of_objects_.insert(object.name).second)
                object.name = fmt::format("{}-{}", stem, number++);
        }
        const std::size_t first = scene_.vertices.size();
        make_room(scene_.vertices, mesh.vertices.size());
        const std::string prefix = object.name + ".";
        std::string name = prefix;
        const std::size_t of_object = name.size();
        auto& first_alike = first_of_count_[mesh.weights.empty() ? 1 : 2];
        first_alike = first_alike.value_or(obj.begin);
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            Numbers3& at = mesh.vertices[i];
            put_number(name, of_object, i + 1);
            scene_.vertices.push_back(
                {name, std::move(at[0]), std::move(at[1]), std::nullopt, std::move(at[2])});
            if (!mesh.weights.empty())
                scene_.vertices.back().w = std::move(mesh.weights[i]);
            if (takes_colors && !mesh.colors.empty())
                scene_.vertices.back().color = mesh.colors[i];
        }
        places_of_vertices_.resize(scene_.vertices.size(), obj.begin);
        units_.insert(units_.end(), mesh.units.begin(), mesh.units.end());
        first_of_obj_.emplace(object.name, std::pair(first, mesh.vertices.size()));
        make_room(faces_, mesh.triangles());
        name.replace(of_object, std::string::npos, "f");
        FaceCuts cuts(scene_.vertices, units_, first);
        std::vector<std::size_t> face;
        for (std::size_t i = 0; i < mesh.faces(); ++i) {
            const auto corners = mesh.face(i);
            put_number(name, of_object + 1, i + 1);
            const std::size_t of_face = name.size();
            face.resize(corners.size());
            std::transform(corners.begin(), corners.end(), face.begin(),
                           [first](std::uint32_t corner) { return first + corner; });
            add_face(
                face, prefix, like, cuts, obj, [&] { return name.substr(0, of_face); },
                [&](ScenePrimitive& part, std::size_t k) {
                    if (face.size() > 3) {
                        name.resize(of_face);
                        name += '.';
                        put_number(name, of_face + 1, k);
                    }
                    part.name = name;
                });
        }
        keep_remarks(cuts);
    }

    /// The mesh of an OBJ file, which a relative path finds beside the scene. Each file is read once, and
    /// kept as long as it is used again.
    ObjMesh obj_mesh(const JsonValue& obj, const std::string& path) {
        ObjFile& known = obj_files_[path];
        if (!known.mesh) {
            refuse_outside(obj, path);
            const auto file = read_named_file(beside_scene(path), limits_);
            if (!file &&
                (file.problem().cause == Problem::Cause::system || file.problem().line > 0))
                throw file.problem();
            if (!file)
                json_.fail(obj, fmt::format("{} ({})", file.problem().message, beside_scene(path)),
                           file.problem().hint.empty()
                               ? "a relative path starts from the scene's folder"
                               : file.problem().hint);
            auto read = read_obj(file.value());
            if (!read)
                throw read.problem();
            known.mesh = std::move(read.value());
            std::move(known.mesh->remarks.begin(), known.mesh->remarks.end(),
                      std::back_inserter(remarks_on_meshes_));
        }
        return --known.uses == 0 ? std::move(*known.mesh) : *known.mesh;
    }

    std::string beside_scene(const std::string& path) const {
        const std::size_t folder = source_.name.find_last_of('/');
        return path.starts_with('/') || folder == std::string::npos
                   ? path
                   : source_.name.substr(0, folder + 1) + path;
    }

    /// A path may not leave the scene's folder, by itself or through a link, unless that is allowed:
    /// a scene from somewhere else cannot look around.
    void refuse_outside(const JsonValue& obj, const std::string& path) const {
        if (limits_.allow_outside)
            return;
        namespace fs = std::filesystem;
        std::error_code error;
        const fs::path folder = fs::canonical(beside_scene("."), error);
        const fs::path absolute =
            error ? fs::path() : fs::absolute(beside_scene(path.c_str()), error);
        const fs::path file = error ? fs::path() : fs::weakly_canonical(absolute, error);
        if (error) {
            Problem problem = problem_of(
                beside_scene(path),
                fmt::format("expected a file that can be read, found: {}", error.message()));
            problem.cause = cause_of_open_error(error.value());
            throw problem;
        }
        const auto parts = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
        if (parts.first != folder.end())
            json_.fail_expecting(obj, "an OBJ file in the scene's folder or below",
                                 "--allow-outside lets it lie anywhere");
    }

    /// Moves the faces of meshes that are drawn as `kind` to the primitives, and tells those that were cut
    /// where their triangles are now.
    void take_faces(PrimitiveKind kind) {
        const auto count = std::count_if(faces_.begin(), faces_.end(),
                                         [kind](const auto& face) { return face.kind == kind; });
        if (scene_.primitives.empty() && static_cast<std::size_t>(count) == faces_.size()) {
            scene_.primitives = std::exchange(faces_, {});
            return;
        }
        scene_.primitives.reserve(scene_.primitives.size() + static_cast<std::size_t>(count));
        auto cut = places_of_ears_.begin();
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            const bool begins_cut = cut != places_of_ears_.end() && *cut == i;
            if (faces_[i].kind == kind) {
                if (begins_cut)
                    scene_.cut_faces[static_cast<std::size_t>(cut - places_of_ears_.begin())]
                        .first_ear = scene_.primitives.size();
                scene_.primitives.push_back(std::move(faces_[i]));
            }
            cut += begins_cut ? 1 : 0;
        }
    }

    /// "a", "b"
    std::string quoted_mistakes() const {
        std::vector<std::string> names;
        for (const Mistake* const mistake : scene_.method.mistakes)
            names.push_back(fmt::format("\"{}\"", mistake->name));
        return joined(names, ", ");
    }

    /// The model, which draws with a mistake, goes from pixel to pixel.
    void check_mistakes(const JsonValue& root) {
        if (scene_.method.mistakes.empty())
            return;
        const JsonValue blamed = root.find("method").value_or(root);
        if (!modelled_mistakes(scene_).empty() && !has_model(scene_))
            json_.fail(
                blamed,
                fmt::format("expected no coordinate beyond {} to draw with the mistake {}, found "
                            "a larger one",
                            farthest_of_model(scene_), quoted_mistakes()));
        place_of_mistake_ = blamed.begin;
    }

    /// True if a pixel is another one with the mistakes of the scene than without.
    bool mistakes_show(const Plan& plan) const {
        Scene right = scene_;
        right.method = asked_;
        right.method.scalar = scene_.method.scalar;
        const auto plan_of_right = plan_or_unfit(right);
        const auto* const found = std::get_if<Plan>(&plan_of_right);
        if (found == nullptr)
            return true;
        const Image with = draw(scene_, plan);
        const Image without = draw(right, *found);
        return !std::equal(with.colors().begin(), with.colors().end(), without.colors().begin());
    }

    /// Choices that do not go together, as soon as it is known what they are for.
    void check_method(const JsonValue& root) const {
        const Method& method = scene_.method;
        const bool has_lines =
            scene_.has(PrimitiveKind::line) || scene_.has(PrimitiveKind::outline);
        const JsonValue blamed = root.find("method").value_or(root);
        if (method.rounding == Rounding::half_open && has_lines &&
            traits_of(method.line).rule == LineRule::rounding)
            json_.fail(
                blamed,
                "expected a rounding that lines can have, found \"half-open\": a line has no "
                "right end",
                R"(say "line": "bresenham", which needs none, or another rounding)");
        if (scene_.viewport.depths && scene_.has_depth_buffer() && scene_.depth() != Depth::ndc_z)
            json_.fail(blamed,
                       "expected \"depth\": \"ndc-z\" beside depth_range, found another: only z "
                       "after the division has a range");
        const bool fills_rows = scene_.has(PrimitiveKind::polygon) ||
                                (scene_.has(PrimitiveKind::triangle) &&
                                 traits_of(method.fill).rule == PixelRule::row_ends);
        if (method.ends == EndPixels::first && traits_of(method.line).rule == LineRule::diamonds)
            json_.fail(blamed, "expected no \"ends\" beside \"line\": \"diamond-exit\", found "
                               "\"first\": a diamond that the line ends in is not left");
        check_rows(blamed);
        const bool rounds_spans = fills_rows && method.rounding == Rounding::nearest;
        if (method.ties == Ties::step && (rounds_spans || method.snap == Snap::nearest))
            json_.fail(blamed,
                       fmt::format("expected ties that {} can have, found \"step\": only a line "
                                   "goes somewhere",
                                   rounds_spans ? "the rows of triangles" : "a snapped vertex"),
                       "the others are start, up, away and even");
        if (place_of_hidden_lines_ && !scene_.has_depth_buffer()) {
            const FillTraits fill = traits_of(method.fill);
            const bool has_no_depths = fill.depths == DepthForm::none;
            const bool is_said = has_no_depths || method.depth.has_value();
            json_.fail(
                *place_of_hidden_lines_,
                fmt::format("expected a depth buffer for hidden lines, found {}",
                            has_no_depths  ? fmt::format(R"("fill": "{}")", fill.name)
                            : method.depth ? fmt::format(R"("depth": "{}")",
                                                         find_method_key("depth")->get(method))
                                           : "none"),
                is_said
                    ? R"(the fan has no depths, the painter no buffer; "depth": "linear-z" has one)"
                    : R"(say "projection": {...}, or "method": {"depth": "linear-z"})");
        }
        // The rows of one trace have one rule.
        if (scene_.has(PrimitiveKind::polygon) && scene_.has(PrimitiveKind::triangle) &&
            traits_of(method.fill).rule != PixelRule::row_ends)
            json_.fail(
                blamed,
                fmt::format(
                    R"(expected triangles that are filled by rows beside polygons, found "fill": "{}")",
                    traits_of(method.fill).name),
                R"("fill": "scanline" does that; or write the triangles as polygons)");
        if (place_of_flat_ && scene_.has_depth_buffer()) {
            const auto* const flat =
                std::find_if(all_primitives.begin(), all_primitives.end(), [this](auto one) {
                    return !traits_of(one).has_depth && scene_.has(one);
                });
            const std::string_view kind = name_of(*flat);
            json_.fail(*place_of_flat_,
                       fmt::format("expected no depth buffer beside a {}, found one", kind),
                       fmt::format(R"(a {} is drawn in the picture, and has no depth there; )"
                                   R"("method": {{"depth": "none"}} draws without a buffer)",
                                   kind));
        }
    }

    void check_rows(const JsonValue& blamed) const {
        const Method& method = scene_.method;
        if (method.rows && method.polygon_vertices == PolygonVertices::turning &&
            scene_.has(PrimitiveKind::polygon))
            json_.fail(blamed,
                       R"(expected no "rows" beside "polygon_vertices": "turning", found both)",
                       "vertices say which rows a polygon has");
        if (method.rows == RowRule::half_open && scene_.has(PrimitiveKind::triangle) &&
            traits_of(method.fill).rule != PixelRule::row_ends)
            json_.fail(blamed,
                       fmt::format(R"(expected a fill by rows beside "rows": "half-open", found )"
                                   R"("fill": "{}")",
                                   traits_of(method.fill).name),
                       R"("fill": "scanline" and "two-halves" go row by row)");
    }

    /// Vertices of four numbers are in clip space: what leads there has been done, and what needs the world
    /// cannot be.
    void begin_in_clip_space(const JsonValue& root) {
        constexpr std::string_view hint = "decimal commas? JSON has a point: 5.5";
        const auto& [first_without_z, first_with_z, first_with_w] = first_of_count_;
        Projection& projection = scene_.projection;
        if (first_with_w && projection.type != ProjectionType::clip_space) {
            if (const auto given = root.find("projection"))
                json_.fail(
                    *given,
                    R"(expected no projection beside vertices [x, y, z, w], found one: they )"
                    R"(are in clip space already)",
                    R"({"type": "clip-space"} says so)");
            if (first_with_z || first_without_z)
                json_.fail(*first_with_w,
                           "expected vertices that all have a w, or none; found both",
                           std::string(hint));
            projection.type = ProjectionType::clip_space;
        }
        const ConventionRow* const row = row_of(scene_.method.convention);
        const auto given = root.find("projection");
        if (projection.type == ProjectionType::clip_space && row != nullptr &&
            !(given && given->find("z")))
            projection.z_from_zero = row->view->z_from_zero;
        if (projection.type != ProjectionType::clip_space)
            return;
        const auto refuse = [this](std::size_t at, std::string_view what) {
            json_.fail(at, fmt::format("expected no {} beside vertices in clip space, found one: "
                                       "where they are in the world is not known",
                                       what));
        };
        for (const std::string_view key : {"camera", "light", "model"})
            if (const auto found = root.find(key))
                refuse(found->begin, key);
        if (scene_.method.cull != Cull::none)
            refuse(root.find("method").value_or(root).begin, "cull");
        for (const SceneObject& object : scene_.objects)
            if (!object.model.steps().empty())
                refuse(root.find("meshes")->begin, "model");
        for (std::size_t i = 0; i < scene_.vertices.size(); ++i) {
            const SceneVertex& v = scene_.vertices[i];
            if (v.w == Number(0) && v.x == Number(0) && v.y == Number(0) && v.z == Number(0))
                json_.fail(
                    places_of_vertices_[i],
                    "expected a vertex in clip space, found (0, 0, 0, 0), which is no place");
        }
    }

    void take_viewport_of_convention() {
        const ConventionRow* const row = row_of(scene_.method.convention);
        Projection& projection = scene_.projection;
        // The view plane of a pinhole has a size of its own.
        if (row == nullptr || projection.type == ProjectionType::none ||
            projection.type == ProjectionType::pinhole)
            return;
        const ConventionView& view = *row->view;
        scene_.viewport = {.type = ViewportType::pixels,
                           .pixels_per_unit = 1,
                           .pixels = view.pixels,
                           .is_y_down = view.is_y_down};
        const bool holds_z = scene_.method.depth.value_or(Depth::ndc_z) == Depth::ndc_z;
        if (view.has_unit_depths && has_canonical_z(projection) && holds_z)
            scene_.viewport.depths = {Number(0), Number(1)};
    }

    /// How vertices come to the screen.
    void read_view(const JsonValue& root) {
        const auto camera = root.find("camera");
        if (camera && camera->text == fit_word)
            place_of_fit_ = camera->begin;
        else if (camera)
            scene_.camera = read_camera(json_, *camera);
        if (const auto projection = root.find("projection")) {
            scene_.projection = read_projection(json_, *projection);
            if (place_of_fit_ && scene_.projection.type == ProjectionType::none)
                json_.fail(*projection,
                           R"(expected a projection that a camera can be fitted to, found "none")",
                           "without \"projection\", it is a frustum");
        } else if (place_of_fit_) {
            scene_.projection = {.type = ProjectionType::frustum, .fov_y = fitted_fov_y};
        } else if (camera) {
            place_of_camera_ = camera->begin;
        }
        begin_in_clip_space(root);
        if (const auto viewport = root.find("viewport"))
            scene_.viewport = read_viewport(json_, *viewport);
        else
            take_viewport_of_convention();
        if (scene_.viewport.depths)
            scene_.viewport.depths->lowest_z = scene_.projection.z_from_zero ? 0 : -1;
        if (scene_.viewport.depths && !has_canonical_z(scene_.projection))
            json_.fail(*root.find("viewport")->find("depth_range"),
                       "expected a frustum, an orthographic projection with near and far, or "
                       "vertices in clip space beside depth_range, "
                       "found another: z does not lie within -1..1");
        if (const auto light = root.find("light"))
            scene_.light = read_light(json_, *light);
        const bool needs_light =
            scene_.method.cull == Cull::light || scene_.method.shade == Shade::lambert;
        if (needs_light && !scene_.light)
            json_.fail(root,
                       fmt::format("expected a light for {}, found none",
                                   scene_.method.cull == Cull::light ? "\"cull\": \"light\""
                                                                     : "\"shade\": \"lambert\""),
                       R"(say "light": {"direction": [x, y, z]}, from the scene to the light)");
    }

    std::size_t vertex_named(std::string_view name, std::size_t offset,
                             const std::string& prefix = {}) const {
        const auto found =
            vertex_by_name_.find(prefix + std::string(name), NameOfVertex{scene_.vertices});
        if (found)
            return *found;
        if (const auto of_obj = vertex_of_obj(name))
            return *of_obj;
        std::vector<std::string_view> known;
        for (const std::uint32_t vertex : vertex_by_name_.numbers())
            known.push_back(scene_.vertices[vertex].name);
        std::sort(known.begin(), known.end());
        constexpr std::size_t most_listed = 12;
        const bool too_many = known.size() > most_listed;
        std::string hint = did_you_mean(name, known, "\"");
        if (hint.empty() && !known.empty() && !too_many)
            hint = fmt::format("the scene has the vertices {}", joined(known, ", "));
        json_.fail(offset,
                   fmt::format("expected the name of a vertex, found \"{}\"", shortened(name, 40)),
                   std::move(hint));
    }

    /// MESH.NUMBER, for a vertex of an OBJ file.
    std::optional<std::size_t> vertex_of_obj(std::string_view name) const {
        const std::size_t dot = name.find_last_of('.');
        if (dot == std::string_view::npos)
            return std::nullopt;
        const auto object = first_of_obj_.find(std::string(name.substr(0, dot)));
        const auto number = parse_number(name.substr(dot + 1));
        const auto* given = std::get_if<Number>(&number);
        const auto whole = given != nullptr ? given->numerator_over(1) : std::nullopt;
        if (object == first_of_obj_.end() || !whole || *whole < 1 ||
            static_cast<std::uint64_t>(*whole) > object->second.second)
            return std::nullopt;
        return object->second.first + static_cast<std::size_t>(*whole) - 1;
    }

    /// What a list of primitives of a kind looks like, and the vertices of one of them.
    struct Form {
        std::string_view list;
        std::string_view vertices;
    };
    static Form form_of(PrimitiveKind kind) {
        switch (kind) {
        case PrimitiveKind::point:
            return {R"(a list of points, like ["A"])", R"(one vertex, "A" or ["P1"])"};
        case PrimitiveKind::line:
            return {R"(a list of lines, like ["AB"])", R"(two vertices, "AB" or ["P1", "P2"])"};
        case PrimitiveKind::outline:
            return {R"(a list of outlines, like ["ABC"])",
                    R"(three vertices, "ABC" or ["P1", "P2", "P3"])"};
        case PrimitiveKind::polygon:
            return {R"(a list of polygons, like ["ABCDE"])",
                    R"(three vertices or more, "ABCDE" or ["P1", ...])"};
        case PrimitiveKind::circle:
            return {R"(a list of circles, like [{"center": "A", "radius": 5}])",
                    R"(a circle, like {"center": "A", "radius": 5})"};
        case PrimitiveKind::triangle:
            break;
        }
        return {R"(a list of triangles, like ["ABC"])",
                R"(three vertices, "ABC" or ["P1", "P2", "P3"])"};
    }

    /// The vertices that "ABC" or ["P1", "P2", "P3"] names, each behind `prefix`.
    std::vector<std::size_t> corners_in(const JsonValue& value, const std::string& prefix,
                                        std::string_view expected) const {
        std::vector<std::size_t> corners;
        if (value.kind == JsonValue::Kind::string) {
            // One-letter names. A place inside the quotes can be pointed at if nothing is escaped.
            const bool as_typed = value.end() - value.begin == value.text.size() + 2;
            std::string_view rest = value.text;
            while (!rest.empty()) {
                const std::size_t length = first_code_point(rest).length;
                const std::size_t inside = as_typed ? 1 + value.text.size() - rest.size() : 0;
                corners.push_back(
                    vertex_named(rest.substr(0, length), value.begin + inside, prefix));
                rest.remove_prefix(length);
            }
        } else {
            for (const JsonValue& name : json_.array_in(value, expected))
                corners.push_back(vertex_named(json_.string_in(name, "the name of a vertex"),
                                               name.begin, prefix));
        }
        return corners;
    }

    /// The vertices of a polygon.
    void set_ring(ScenePrimitive& polygon, std::vector<std::size_t> corners,
                  const JsonValue& blamed) const {
        if (corners.size() > most_corners)
            json_.fail(blamed, fmt::format("expected a polygon of at most {} vertices, found {}",
                                           most_corners, corners.size()));
        polygon.ring = std::move(corners);
    }

    /// The vertices of a primitive: as many as its kind has.
    void read_corners(const JsonValue& value, ScenePrimitive& primitive) const {
        const std::string_view expected = form_of(primitive.kind).vertices;
        if (traits_of(primitive.kind).has_ring) {
            auto ring = corners_in(value, {}, expected);
            if (ring.size() < 3)
                json_.fail_expecting(value, expected);
            set_ring(primitive, std::move(ring), value);
            return;
        }
        const std::size_t count = primitive.corners().size();
        if (value.kind == JsonValue::Kind::string && characters_in(value.text) != count)
            json_.fail_expecting(value, expected);
        const auto corners = corners_in(value, {}, expected);
        if (corners.size() != count)
            json_.fail_expecting(value, expected);
        std::copy(corners.begin(), corners.end(), primitive.vertices.begin());
    }

    Color color_in(const JsonValue& value) const {
        constexpr std::string_view expected = R"(a color, like "#ff8000" or "red")";
        const auto color = parse_color(json_.string_in(value, expected));
        if (!color) {
            std::string hint = did_you_mean(value.text, color_names(), "\"");
            if (value.text.starts_with('#'))
                hint = "8 bits a channel: #rrggbb or #rrggbbaa; 4 bits: #rgb";
            json_.fail_expecting(value, expected, std::move(hint));
        }
        if (color->alpha() == 0)
            json_.fail_expecting(value, "a color that can be seen (alpha above 00)");
        return *color;
    }

    void read_colors(const JsonValue& colors) {
        if (colors.kind != JsonValue::Kind::object)
            json_.fail_expecting(colors, R"(colors by vertex, like {"A": "red"})");
        for (const auto& [name, color] : colors.members())
            scene_.vertices[vertex_named(name.text, name.begin)].color = color_in(color);
    }

    void read_primitives(const std::optional<JsonValue>& list, PrimitiveKind kind) {
        if (!list)
            return;
        const JsonElements values = json_.array_in(*list, form_of(kind).list);
        make_room(scene_.primitives, values.size());
        for (const JsonValue& value : values) {
            ScenePrimitive primitive;
            primitive.kind = kind;
            if (traits_of(kind).has_radius) {
                read_around_vertex(value, primitive);
            } else if (value.kind == JsonValue::Kind::object) {
                json_.allow_keys(value, primitive_keys);
                const auto vertices = value.find("vertices");
                if (!vertices)
                    json_.fail(value, R"(expected the key "vertices", found none)");
                read_corners(*vertices, primitive);
                read_color_and_name(value, primitive);
            } else {
                read_corners(value, primitive);
            }
            add_named(std::move(primitive), value.begin);
        }
    }

    /// A center and a radius.
    void read_around_vertex(const JsonValue& value, ScenePrimitive& primitive) {
        if (value.kind != JsonValue::Kind::object)
            json_.fail_expecting(value, form_of(primitive.kind).vertices);
        json_.allow_keys(value, keys_around_vertex);
        const JsonValue center = json_.member(value, "center");
        primitive.vertices[0] =
            vertex_named(json_.string_in(center, "the name of a vertex"), center.begin);
        primitive.radius = radius_in(json_.member(value, "radius"));
        read_color_and_name(value, primitive);
    }

    /// What is decided with it is decided in whole numbers.
    std::int32_t radius_in(const JsonValue& value) const {
        const auto whole = value.kind == JsonValue::Kind::number
                               ? json_.number_in(value).numerator_over(1)
                               : std::nullopt;
        if (!whole || *whole < 0 || *whole > largest_radius)
            json_.fail_expecting(
                value, fmt::format("a whole number of pixels from 0 to {}", largest_radius));
        return static_cast<std::int32_t>(*whole);
    }

    /// What a primitive that is written as an object may have beside its vertices.
    void read_color_and_name(const JsonValue& value, ScenePrimitive& primitive) {
        if (const auto color = value.find("color"))
            primitive.color = color_in(*color);
        if (const auto name = value.find("name")) {
            primitive.name = json_.string_in(*name, "a name in quotes");
            if (!names_of_primitives_.insert(primitive.name).second)
                json_.fail_expecting(*name, "a name that no other primitive has");
        }
    }

    /// Adds a primitive, called by its vertices if it has no name. `place` is its offset in the source.
    void add_named(ScenePrimitive&& primitive, std::size_t place) {
        if (!traits_of(primitive.kind).has_depth)
            place_of_flat_ = place_of_flat_.value_or(place);
        if (primitive.name.empty()) {
            std::vector<std::string_view> names;
            for (const std::size_t vertex : primitive.corners())
                names.push_back(scene_.vertices[vertex].name);
            primitive.name = joined_names(names);
        }
        scene_.primitives.push_back(std::move(primitive));
    }

    void read_canvas(const std::optional<JsonValue>& canvas, const JsonValue& root) {
        CanvasJson given;
        if (canvas) {
            auto read = read_canvas_json(source_, *canvas);
            if (!read)
                throw read.problem();
            given = read.value();
        }
        scene_.canvas = {given.width, given.height, given.origin};
        const JsonValue& blamed = canvas ? *canvas : root;
        choose_viewport(given, blamed);
        const std::array<double, 2> farthest =
            given.has_width && given.has_height ? std::array{0.0, 0.0} : farthest_places();
        if (!given.has_width)
            scene_.canvas.width = fitted_size(blamed, "width", farthest[0]);
        if (!given.has_height)
            scene_.canvas.height = fitted_size(blamed, "height", farthest[1]);
        if (const auto fault = fault_of_size(scene_.canvas))
            json_.fail(blamed, *fault, canvas_hint);
    }

    /// The viewport that goes with the projection, where the scene does not say.
    void choose_viewport(const CanvasJson& given, const JsonValue& blamed) {
        Viewport& viewport = scene_.viewport;
        const bool is_projected = scene_.projection.type != ProjectionType::none;
        if ((is_projected || viewport.type == ViewportType::pixels) &&
            !(given.has_width && given.has_height))
            fail_without_canvas(blamed);
        if (viewport.type == ViewportType::none && is_projected) {
            // The pinhole of T0 shows a view plane of 1 x 1 on the whole canvas.
            viewport.type = scene_.projection.type == ProjectionType::pinhole
                                ? ViewportType::pixels_per_unit
                                : ViewportType::pixels;
            viewport.pixels_per_unit = std::min(given.width, given.height);
        }
        if (viewport.has_reversed_depths() &&
            scene_.method.depth_compare == DepthCompare::automatic)
            scene_.method.depth_compare = DepthCompare::greater;
        if (viewport.type == ViewportType::pixels_per_unit && given.origin != Origin::center)
            json_.fail(blamed,
                       "expected a canvas with its origin in the center, found another: "
                       "pixels_per_unit starts from the center",
                       R"(say "viewport": "fit", or leave "origin" out)");
    }

    [[noreturn]] void fail_without_canvas(const JsonValue& blamed) const {
        if (const auto& with_w = first_of_count_.back())
            json_.fail(*with_w,
                       "expected a canvas with a width and a height beside a vertex of four "
                       "numbers, in clip space, found none",
                       fmt::format("{}; or decimal commas? JSON has a point: 5.5", canvas_hint));
        json_.fail(blamed,
                   "expected a canvas with a width and a height, found none: the picture is "
                   "fitted to it",
                   canvas_hint);
    }

    /// How far vertices lie from x = 0 and from y = 0, on the side that the canvas has.
    std::array<double, 2> farthest_places() const {
        std::array<double, 2> farthest{0, 0};
        const auto reach = [this, &farthest](std::size_t i, double value) {
            const bool is_centered = scene_.canvas.origin == Origin::center;
            farthest[i] = std::max(farthest[i], is_centered ? std::abs(value) : value);
        };
        std::visit(
            [&](const auto& list) {
                for_each_piece(scene_, list, [&](const auto& piece) {
                    const auto radius = static_cast<double>(piece.radius);
                    for (const auto& at : piece.corners())
                        for (const double way : {-radius, radius}) {
                            reach(0, to_double(at.x) + way);
                            reach(1, to_double(at.y) + way);
                        }
                });
            },
            screen_list_for(scene_));
        return farthest;
    }

    /// The width or height that holds every vertex of a primitive, and a pixel more on each side.
    int fitted_size(const JsonValue& blamed, std::string_view side, double farthest) const {
        const double to_border = std::ceil(farthest) + 1;
        const double size =
            scene_.canvas.origin == Origin::center ? 2 * to_border + 1 : to_border + 1;
        if (!(size <= largest_canvas_side))
            json_.fail(blamed,
                       fmt::format("expected vertices that fit on {0} pixels, or a canvas with a "
                                   "{1}; found a vertex {2:.6g} pixels from the origin",
                                   largest_canvas_side, side, farthest),
                       canvas_hint);
        return static_cast<int>(size);
    }

    void refuse(const Unfit& unfit) const {
        const Refusal refusal = refusal_of(scene_, unfit);
        json_.fail(places_of_vertices_[unfit.to], refusal.message, refusal.hint);
    }

    const Source& source_;
    JsonReader json_;
    const MethodOverrides& overrides_;
    const InputLimits& limits_;
    std::vector<Model>& models_;
    Scene scene_;
    std::optional<std::size_t> place_of_fit_;    ///< offset of a camera that is to be fitted
    std::optional<std::size_t> place_of_flat_;   ///< offset of the first primitive without depth
    std::optional<std::size_t> place_of_camera_; ///< offset of a camera without a projection
    std::optional<std::size_t> place_of_mistake_;
    Method asked_;                                ///< without the mistake
    std::vector<std::size_t> places_of_vertices_; ///< offsets of their names in the source
    std::vector<float> units_;                    ///< of each vertex: see typed_digits.h
    std::array<std::optional<std::size_t>, 3>
        first_of_count_; ///< offsets of the first vertices of two, of three and of four numbers
    NameIndex vertex_by_name_; ///< but for those of OBJ files
    std::unordered_map<std::string, std::pair<std::size_t, std::size_t>>
        first_of_obj_; ///< by mesh: its first vertex, and how many it has
    std::unordered_set<std::string> names_of_objects_{""};      ///< the scene itself has none
    std::unordered_map<std::string, std::size_t> next_numbers_; ///< of unnamed meshes, by file name
    struct ObjFile {
        std::size_t uses = 0; ///< that are still to come
        std::optional<ObjMesh> mesh;
    };
    std::unordered_map<std::string, ObjFile> obj_files_; ///< by path
    std::optional<std::size_t>
        place_of_hidden_lines_; ///< offset of the first mesh that asks for them
    std::unordered_set<std::uint64_t>
        sides_;                         ///< of the mesh that is read, by the vertices at their ends
    std::vector<ScenePrimitive> faces_; ///< of meshes, until they are drawn in their turn
    std::vector<std::size_t> places_of_ears_; ///< in `faces_`: the first of each face that was cut
    std::vector<Problem> remarks_on_meshes_;
    std::set<std::string_view> said_; ///< keys of the method that the scene, or an option, gives
    std::unordered_set<std::string> names_of_primitives_; ///< those that the author gave
};

/// What a source says; that it is no JSON is thrown as a Problem.
JsonDocument parsed(const Source& source) {
    auto document = parse_json(source);
    if (!document)
        throw document.problem();
    return std::move(document.value());
}

} // namespace

struct SceneSequence::State {
    std::unique_ptr<const Source> converted; ///< of an OBJ file, or a text of `fuzz`
    const Source& source;
    MethodOverrides overrides;
    InputLimits limits;
    std::optional<JsonDocument> document; ///< until the first frame is read
    Variations variations;
    std::optional<FittedCamera> fitted = {}; ///< once it is known; one for all frames
    std::vector<Model> models = {};          ///< of the last frame that was read, by object

    /// Does something with a frame; a Problem says which one it was.
    template <typename Do> auto in_frame(std::size_t frame, Do&& act) const {
        try {
            return act();
        } catch (Problem& problem) {
            if (!variations.empty())
                problem.message += fmt::format(", in frame {}", variations.label(frame));
            throw;
        }
    }

    /// Reads a frame. Each has a document of its own, which is forgotten before anything is planned.
    SceneReader read(std::size_t frame) {
        JsonDocument read_document = document ? *std::move(document) : parsed(source);
        document.reset();
        variations.put_into(read_document, frame);
        SceneReader reader(source, overrides, limits, models);
        in_frame(frame, [&] { reader.read(read_document.root()); });
        return reader;
    }

    /// Calls `visit` with the scene of every frame; one of them has been read.
    template <typename Visit>
    void for_each_scene(const SceneReader& reader, std::size_t frame, Visit&& visit) {
        visit(reader.scene());
        for (std::size_t other = 1; other <= variations.count(); ++other)
            if (other != frame)
                visit(read(other).scene());
    }

    /// The camera that has in view what is there in any frame.
    FittedCamera fit(const SceneReader& reader, std::size_t frame) {
        std::optional<Box> box;
        std::optional<ViewVolume> volume;
        for_each_scene(reader, frame, [&](const Scene& scene) {
            const Box of_frame = world_box(scene);
            include(box, of_frame.low);
            include(box, of_frame.high);
            const ViewVolume one = view_volume(scene.projection, scene.viewport, scene.canvas);
            volume = volume ? intersection(*volume, one) : one;
        });
        const Vec<Rational, 3> center = center_of(*box);
        Rational square = 0;
        for_each_scene(reader, frame, [&](const Scene& scene) {
            square = std::max(square, farthest_square(scene, center));
        });

        const auto camera =
            fitted_camera(center, square, *volume, view_axis_of(reader.scene().projection.type));
        if (const auto* fault = std::get_if<FitFault>(&camera))
            refuse_fit(reader, *fault);
        const auto& result = std::get<FittedCamera>(camera);
        if (volume->is_perspective && volume->far && *volume->far < result.far.exact())
            reader.refuse_fit(
                fmt::format("expected a far from {:g} on for a camera that fits, found {:g}",
                            result.far.nearest_double(), nearest_double(*volume->far)),
                "nearer than that, the sides of the view would cut off something");
        return result;
    }

    [[noreturn]] static void refuse_fit(const SceneReader& reader, FitFault fault) {
        switch (fault) {
        case FitFault::one_place:
            reader.refuse_fit("expected vertices in more than one place for a camera that fits, "
                              "found all in one",
                              R"(say "camera": {"position": [x, y, z], "look_at": [x, y, z]})");
        case FitFault::size:
            reader.refuse_fit(fmt::format("expected vertices that are {:g} to {:g} apart for a "
                                          "camera that fits, and no farther from the origin; "
                                          "found others",
                                          smallest_fit, largest_fit));
        case FitFault::no_view:
            break;
        }
        reader.refuse_fit("expected frames that all show a place in common for a camera that fits, "
                          "found none");
    }
};

SceneSequence::SceneSequence(const Source& given, MethodOverrides overrides, InputLimits limits,
                             const std::vector<Variation>& vary) {
    std::unique_ptr<const Source> converted;
    if (is_foreign_scene(given)) {
        auto scene =
            begins_obj(first_statement(given)) ? scene_of_obj(given) : scene_of_triangles(given);
        if (!scene)
            throw scene.problem();
        converted = std::make_unique<const Source>(std::move(scene.value()));
    }
    const Source& source = converted ? *converted : given;
    JsonDocument document = parsed(source);
    Variations variations(JsonReader{source}, document.root(), vary);
    state_.reset(new State{std::move(converted), source, std::move(overrides), limits,
                           std::move(document), std::move(variations)});
}

SceneSequence::SceneSequence(SceneSequence&&) noexcept = default;
SceneSequence::~SceneSequence() = default;

std::size_t SceneSequence::count() const {
    return state_->variations.count();
}

std::string SceneSequence::label(std::size_t frame) const {
    return state_->variations.label(frame, language_of_steps());
}

PlannedScene SceneSequence::frame(std::size_t frame) {
    const Variations& variations = state_->variations;
    if (frame < 1 || frame > variations.count())
        throw problem_of(
            state_->source.name,
            fmt::format("expected a frame from 1 to {}, found frame {}", variations.count(), frame),
            variations.empty() ? R"("vary" in the scene, or --vary, makes more frames)" : "");
    SceneReader reader = state_->read(frame);
    if (reader.fits_camera()) {
        if (!state_->fitted)
            state_->fitted = state_->fit(reader, frame);
        reader.look_from(*state_->fitted);
    }
    return state_->in_frame(frame, [&reader] { return reader.planned(); });
}

bool is_scene(const Source& source) {
    std::string_view document = source.view();
    document.remove_prefix(std::min(document.find_first_not_of(blanks_and_mark), document.size()));
    if (!document.starts_with('{'))
        return is_foreign_scene(source);
    JsonScanner fields(document);
    while (fields.next_field())
        // A title may stand in any file.
        for (const std::string_view key : scene_keys)
            if (fields.key() == key && key != schema_key && key != "title")
                return true;
    return fields.failed();
}

MethodOverrides every_stage_kept() {
    MethodOverrides all;
    for (const std::string_view stage : stage_names())
        all.emplace_back("keep", stage);
    return all;
}

Result<PlannedScene> read_scene(const Source& source, const MethodOverrides& overrides,
                                const InputLimits& limits, const FrameChoice& choice) {
    try {
        return SceneSequence(source, overrides, limits, choice.vary)
            .frame(choice.frame.value_or(1));
    } catch (const Problem& problem) {
        return problem;
    }
}

} // namespace rastertrace
