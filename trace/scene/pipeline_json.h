// SPDX-License-Identifier: MIT
#pragma once

// The part of a scene file that says how vertices come to the screen: models, the camera, the
// projection, the viewport; and the light. What is wrong is thrown as a Problem.

#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/draw/scene/transforms.h>
#include <rastertrace/trace/text/json_document.h>
#include <rastertrace/trace/text/json_reader.h>

#include <vector>

namespace rastertrace {

std::vector<ModelStep> read_model(const JsonReader& json, const JsonValue& value);
Camera read_camera(const JsonReader& json, const JsonValue& value);
Projection read_projection(const JsonReader& json, const JsonValue& value);
Light read_light(const JsonReader& json, const JsonValue& value);
Viewport read_viewport(const JsonReader& json, const JsonValue& value);

} // namespace rastertrace
