// SPDX-License-Identifier: MIT
#include "pipeline_json.h"

#include "scene_keys.h"

#include <rastertrace/trace/text/pipeline_names.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>
#include <variant>

namespace rastertrace {

namespace {

/// The most bits of all numbers of a model, as fractions: its matrix has a multiple of them, and exact
/// arithmetic uses that for every vertex. Room for eight of the longest numbers, or for 256 rotations by
/// ordinary ones.
constexpr std::size_t most_model_bits = 32768;

/// x, y, z or the axis that a value names.
Numbers3 axis_in(const JsonReader& json, const JsonValue& value) {
    constexpr std::string_view expected = R"("x", "y", "z" or an axis [x, y, z])";
    for (std::size_t i = 0; i < axis_words.size(); ++i)
        if (value.kind == JsonValue::Kind::string && value.text == axis_words[i]) {
            Numbers3 axis{0, 0, 0};
            axis[i] = 1;
            return axis;
        }
    const Numbers3 axis = json.numbers3_in(value, expected);
    if (is_zero(exact(axis)))
        json.fail_expecting(value, "an axis other than [0, 0, 0]");
    return axis;
}

/// The place of the word that a value is, in a list of those that it can be.
std::size_t place_of_word(const JsonReader& json, const JsonValue& value,
                          std::span<const std::string_view> words) {
    const auto found = value.kind == JsonValue::Kind::string
                           ? std::find(words.begin(), words.end(), value.text)
                           : words.end();
    if (found == words.end()) {
        const std::vector<std::string_view> known(words.begin(), words.end());
        json.fail_expecting(value, "one of " + joined(known, ", "),
                            did_you_mean(value.text, known, "\""));
    }
    return static_cast<std::size_t>(found - words.begin());
}

/// The depths of the nearest and of the farthest z.
DepthRange<Number> depth_range_in(const JsonReader& json, const JsonValue& value) {
    if (value.elements().size() != 2)
        json.fail_expecting(value, "two depths, [near, far], like [0, 1]");
    std::vector<Number> depths;
    for (const JsonValue& element : value.elements())
        depths.push_back(json.number_in(element));
    if (depths[0].exact() == depths[1].exact())
        json.fail(value, "expected two depths that differ, found the same twice");
    return {depths[0], depths[1]};
}

Rotate read_rotate(const JsonReader& json, const JsonValue& value) {
    json.allow_keys(value, rotate_keys);
    return {axis_in(json, json.member(value, "axis")),
            json.number_in(json.member(value, "degrees"))};
}

Shear read_shear(const JsonReader& json, const JsonValue& value) {
    json.allow_keys(value, shear_keys);
    const auto factor = [&json, &value](std::string_view key) {
        const auto found = value.find(key);
        return !found ? Number(0) : json.number_in(*found);
    };
    return {factor("xy"), factor("xz"), factor("yx"), factor("yz"), factor("zx"), factor("zy")};
}

Number positive_in(const JsonReader& json, const JsonValue& value, std::string_view what) {
    const Number number = json.number_in(value);
    if (sgn(number.exact()) <= 0)
        json.fail_expecting(value, fmt::format("{} above 0", what));
    return number;
}

/// How many bits a number has as a fraction: those above and those below the bar.
std::size_t bits_of(const Number& number) {
    const mpq_class value = number.exact();
    return mpz_sizeinbase(value.get_num_mpz_t(), 2) + mpz_sizeinbase(value.get_den_mpz_t(), 2);
}

std::size_t bits_of(const Numbers3& numbers) {
    return bits_of(numbers[0]) + bits_of(numbers[1]) + bits_of(numbers[2]);
}

/// The bits of all numbers of a step.
std::size_t bits_of(const ModelStep& step) {
    struct Bits {
        std::size_t operator()(const Scale& scale) const { return bits_of(scale.by); }
        std::size_t operator()(const Translate& translate) const { return bits_of(translate.by); }
        std::size_t operator()(const Rotate& rotate) const {
            return bits_of(rotate.axis) + bits_of(rotate.degrees);
        }
        std::size_t operator()(const Shear& shear) const {
            return bits_of({shear.xy, shear.xz, shear.yx}) +
                   bits_of({shear.yz, shear.zx, shear.zy});
        }
    };
    return std::visit(Bits(), step);
}

/// Two numbers of an object of which the first must be the smaller.
void read_range(const JsonReader& json, const JsonValue& object, std::string_view low_key,
                std::string_view high_key, Number& low, Number& high) {
    const JsonValue low_value = json.member(object, low_key);
    const JsonValue high_value = json.member(object, high_key);
    low = json.number_in(low_value);
    high = json.number_in(high_value);
    if (low.exact() >= high.exact())
        json.fail(high_value, fmt::format("expected {} above {}, found {} and {}", high_key,
                                          low_key, high_value.text, low_value.text));
}

void read_bounds(const JsonReader& json, const JsonValue& value, Projection& projection) {
    read_range(json, value, "left", "right", projection.left, projection.right);
    read_range(json, value, "bottom", "top", projection.bottom, projection.top);
}

void read_orthographic(const JsonReader& json, const JsonValue& value, Projection& projection) {
    json.allow_keys(value, orthographic_keys);
    read_bounds(json, value, projection);
    if (value.find("near") || value.find("far")) {
        Number near;
        Number far;
        read_range(json, value, "near", "far", near, far);
        projection.near = near;
        projection.far = far;
    }
}

void read_view_plane(const JsonReader& json, const JsonValue& value, Projection& projection) {
    json.allow_keys(value, view_plane_keys);
    projection.distance = positive_in(json, json.member(value, "distance"), "a distance");
    if (const auto near = value.find("near"))
        projection.near = positive_in(json, *near, "a distance");
}

void read_frustum(const JsonReader& json, const JsonValue& value, Projection& projection) {
    json.allow_keys(value, frustum_keys);
    if (const auto fov_y = value.find("fov_y")) {
        for (const std::string_view bound : {"left", "right", "bottom", "top"})
            if (const auto found = value.find(bound))
                json.fail_expecting(*found, fmt::format("fov_y or {}, not both", bound));
        projection.fov_y = json.number_in(*fov_y);
        const mpq_class degrees = projection.fov_y->exact();
        if (degrees <= 0 || degrees >= 180)
            json.fail_expecting(*fov_y, "a field of view between 0 and 180 degrees");
        // Its cotangent must be a double.
        if (degrees < mpq_class(1e-300))
            json.fail_expecting(*fov_y, "a field of view from 1e-300 degrees on");
    } else {
        read_bounds(json, value, projection);
    }
    projection.near = positive_in(json, json.member(value, "near"), "a distance");
    const JsonValue far = json.member(value, "far");
    if (far.kind == JsonValue::Kind::string && far.text == infinity_word)
        return;
    Number low;
    Number high;
    read_range(json, value, "near", "far", low, high);
    projection.far = high;
}

} // namespace

std::vector<ModelStep> read_model(const JsonReader& json, const JsonValue& value) {
    std::vector<ModelStep> steps;
    std::size_t bits = 0;
    for (const JsonValue& item :
         json.array_in(value, R"(a list, like [{"scale": [2, 2, 2]}, {"translate": [0, 0, 4]}])")) {
        if (steps.size() == most_model_steps)
            json.fail(item, fmt::format("expected at most {} steps, found more", most_model_steps));
        json.allow_keys(item, model_keys);
        const JsonMembers members = item.members();
        if (members.size() != 1)
            json.fail(item,
                      fmt::format("expected one step of the model, found {} in one object",
                                  members.size()),
                      R"(each in its own braces: [{"scale": ...}, {"translate": ...}])");
        const auto [key, what] = members[0];
        const std::string& name = key.text;
        if (name == "scale")
            steps.push_back(Scale{json.numbers3_in(what, "[x, y, z] to multiply by")});
        else if (name == "translate")
            steps.push_back(Translate{json.numbers3_in(what, "[x, y, z] to move by")});
        else if (name == "rotate")
            steps.push_back(read_rotate(json, what));
        else
            steps.push_back(read_shear(json, what));
        bits += bits_of(steps.back());
        if (bits > most_model_bits)
            json.fail(item, fmt::format("expected a model whose numbers have at most {} bits as "
                                        "fractions, all together; found more",
                                        most_model_bits));
    }
    return steps;
}

Camera read_camera(const JsonReader& json, const JsonValue& value) {
    if (value.kind != JsonValue::Kind::object)
        json.fail_expecting(value, R"("fit" or a camera, like {"position": [0, 0, 4]})",
                            did_you_mean(value.text, {fit_word}, "\""));
    json.allow_keys(value, camera_keys);
    Camera camera;
    camera.position = json.numbers3_in(json.member(value, "position"), "a place [x, y, z]");
    camera.look_at = {0, 0, 0};
    if (const auto look_at = value.find("look_at"))
        camera.look_at = json.numbers3_in(*look_at, "a place [x, y, z]");
    if (const auto up = value.find("up"))
        camera.up = json.numbers3_in(*up, "a direction [x, y, z]");

    switch (fault_of(camera)) {
    case CameraFault::looks_at_itself:
        json.fail(value, "expected a camera that looks at another place than its own, found "
                         "position = look_at");
    case CameraFault::up_along_view:
        json.fail(value.find("up").value_or(value),
                  "expected an up that is not parallel to the view, found one that is",
                  R"(for a camera that looks straight down, say "up": [0, 0, -1])");
    case CameraFault::none:
        break;
    }
    return camera;
}

Projection read_projection(const JsonReader& json, const JsonValue& value) {
    if (value.kind != JsonValue::Kind::object)
        json.fail_expecting(value, R"(a projection, like {"type": "pinhole", "distance": 1})");
    const JsonValue type = json.member(value, "type");
    Projection projection;
    projection.type = static_cast<ProjectionType>(place_of_word(json, type, projection_names()));
    switch (projection.type) {
    case ProjectionType::orthographic:
        read_orthographic(json, value, projection);
        break;
    case ProjectionType::pinhole:
    case ProjectionType::view_plane:
        read_view_plane(json, value, projection);
        break;
    case ProjectionType::frustum:
        read_frustum(json, value, projection);
        break;
    case ProjectionType::clip_space:
        json.allow_keys(value, clip_space_keys);
        if (const auto z = value.find("z"))
            projection.z_from_zero = place_of_word(json, *z, z_range_words) == 1;
        break;
    case ProjectionType::none:
        json.allow_keys(value, no_projection_keys);
        break;
    }
    return projection;
}

Light read_light(const JsonReader& json, const JsonValue& value) {
    json.allow_keys(value, light_keys);
    const JsonMembers members = value.members();
    if (members.size() != 1)
        json.fail(value, fmt::format("expected a direction or a position, found {}",
                                     members.empty() ? "neither" : "both"));
    const auto [kind, at] = members[0];
    const bool is_position = kind.text == "position";
    Light light{.kind = is_position ? Light::Kind::position : Light::Kind::direction,
                .at = json.numbers3_in(at, "[x, y, z]")};
    if (!is_position && is_zero(exact(light.at)))
        json.fail(at, "expected a direction to the light that is not 0, found [0, 0, 0]");
    return light;
}

Viewport read_viewport(const JsonReader& json, const JsonValue& value) {
    if (value.kind == JsonValue::Kind::string && value.text == fit_word)
        return {.type = ViewportType::pixels};
    if (!value.find("pixels") && !value.find("pixels_per_unit"))
        json.fail_expecting(value, R"("fit", {"pixels": "edges"} or {"pixels_per_unit": 10})");
    if (const auto pixels = value.find("pixels")) {
        json.allow_keys(value, pixels_keys);
        Viewport viewport{.type = ViewportType::pixels};
        viewport.pixels =
            static_cast<PixelRange>(place_of_word(json, *pixels, pixel_range_names()));
        if (const auto y = value.find("y"))
            viewport.is_y_down = place_of_word(json, *y, viewport_y_words) == 1;
        if (const auto depths = value.find("depth_range"))
            viewport.depths = depth_range_in(json, *depths);
        return viewport;
    }
    json.allow_keys(value, viewport_keys);
    return {.type = ViewportType::pixels_per_unit,
            .pixels_per_unit =
                positive_in(json, json.member(value, "pixels_per_unit"), "a number of pixels")};
}

} // namespace rastertrace
