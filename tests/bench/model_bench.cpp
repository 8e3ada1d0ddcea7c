// SPDX-License-Identifier: MIT
// A model of 100,000 triangles, from its OBJ file to a picture of 800 x 800 with a depth buffer of 1/z,
// next to what well-known teaching renderers do: a stream for each line of the file, barycentric
// coordinates for each pixel of the box of a triangle.

#include "trace_file.h"

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/output.h>

#include <benchmark/benchmark.h>
#include <fmt/core.h>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

constexpr int side = 800; // of the picture, in pixels

/// The torus of scripts/make-models.sh in triangles, each corner with a texture coordinate and a normal: 4.7 MB.
std::string torus(int rings, int sides) {
    std::string text = "vt 0.5 0.5\nvn 0 1 0\n";
    for (int ring = 0; ring < rings; ++ring)
        for (int side_of_ring = 0; side_of_ring < sides; ++side_of_ring) {
            const double around = 2 * std::numbers::pi * ring / rings;
            const double along = 2 * std::numbers::pi * side_of_ring / sides;
            const double distance = 1 + 0.4 * std::cos(along);
            fmt::format_to(std::back_inserter(text), "v {:.6f} {:.6f} {:.6f}\n",
                           distance * std::cos(around), 0.4 * std::sin(along),
                           distance * std::sin(around));
        }
    const auto vertex = [&](int ring, int side_of_ring) {
        return ring % rings * sides + side_of_ring % sides + 1;
    };
    const auto face = [&text](int a, int b, int c) {
        fmt::format_to(std::back_inserter(text), "f {}/1/1 {}/1/1 {}/1/1\n", a, b, c);
    };
    for (int r = 0; r < rings; ++r)
        for (int s = 0; s < sides; ++s) {
            face(vertex(r, s), vertex(r, s + 1), vertex(r + 1, s + 1));
            face(vertex(r, s), vertex(r + 1, s + 1), vertex(r + 1, s));
        }
    return text;
}

const std::string& model_path() {
    static const TemporaryFile file("rastertrace-bench-torus.obj");
    static const std::string path = [] {
        std::ofstream(file.path(), std::ios::binary) << torus(250, 200);
        return file.path();
    }();
    return path;
}

PlannedScene read_model() {
    const std::filesystem::path model = model_path();
    auto read = read_scene({(model.parent_path() / "torus.json").string(),
                            R"({"canvas": {"width": 800, "height": 800},
  "camera": {"position": [0, 2, 4]},
  "projection": {"type": "frustum", "fov_y": 60, "near": 1, "far": 20},
  "method": {"fill": "top-left", "depth": "inverse-z"},
  "meshes": [{"obj": ")" + model.filename().string() +
                                R"("}]})",
                            {}});
    if (!read)
        std::abort();
    return std::move(read.value());
}

/// `rastertrace trace --only skip`, less its start.
void ours(benchmark::State& state) {
    model_path();
    for (auto _ : state) {
        const PlannedScene model = read_model();
        std::string text;
        StringOutput output(text);
        write_trace(model.scene, model.plan, {.filter = {.only = std::vector{StepKind::skip}}},
                    output);
        benchmark::DoNotOptimize(text.data());
    }
}

/// The same without a listener.
void drawn(benchmark::State& state) {
    model_path();
    for (auto _ : state) {
        const PlannedScene model = read_model();
        const Image image = draw(model.scene, model.plan);
        benchmark::DoNotOptimize(image.colors().data());
    }
}

/// A model as a plain loader has it.
struct PlainModel {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec2> texture_coordinates;
    std::vector<glm::vec3> normals;
    std::vector<std::array<std::size_t, 3>> faces; ///< indices in `positions`
};

/// A stream for each line, and for each number.
PlainModel load(const std::string& path) {
    PlainModel model;
    std::ifstream file(path);
    std::string line;
    while (std::getline(file, line)) {
        std::istringstream words(line);
        std::string name;
        words >> name;
        if (name == "v") {
            glm::vec3& at = model.positions.emplace_back();
            words >> at.x >> at.y >> at.z;
        } else if (name == "vt") {
            glm::vec2& at = model.texture_coordinates.emplace_back();
            words >> at.x >> at.y;
        } else if (name == "vn") {
            glm::vec3& normal = model.normals.emplace_back();
            words >> normal.x >> normal.y >> normal.z;
        } else if (name == "f") {
            std::array<std::size_t, 3>& face = model.faces.emplace_back();
            for (std::size_t& corner : face) {
                std::size_t position = 0, texture_coordinate = 0, normal = 0;
                char slash = 0;
                words >> position >> slash >> texture_coordinate >> slash >> normal;
                corner = position - 1;
            }
        }
    }
    return model;
}

/// The textbook's loop, with the depth of each pixel by its weights.
void fill_box(const std::array<glm::vec3, 3>& corners, Color color, std::vector<Color>& colors,
              std::vector<float>& depths) {
    const auto& [a, b, c] = corners;
    const glm::vec2 low =
        glm::max(glm::floor(glm::vec2(glm::min(a, glm::min(b, c)))), glm::vec2(0));
    const glm::vec2 high =
        glm::min(glm::ceil(glm::vec2(glm::max(a, glm::max(b, c)))), glm::vec2(side - 1));
    for (int y = static_cast<int>(low.y); y <= static_cast<int>(high.y); ++y)
        for (int x = static_cast<int>(low.x); x <= static_cast<int>(high.x); ++x) {
            const glm::vec2 p(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
            const glm::vec3 cross = glm::cross(glm::vec3(b.x - a.x, c.x - a.x, a.x - p.x),
                                               glm::vec3(b.y - a.y, c.y - a.y, a.y - p.y));
            const glm::vec3 weights(1.0F - (cross.x + cross.y) / cross.z, cross.x / cross.z,
                                    cross.y / cross.z);
            if (!(weights.x >= 0 && weights.y >= 0 && weights.z >= 0))
                continue;
            const float depth = weights.x * a.z + weights.y * b.z + weights.z * c.z;
            const auto pixel = static_cast<std::size_t>(y * side + x);
            if (depth > depths[pixel]) {
                depths[pixel] = depth;
                colors[pixel] = color;
            }
        }
}

void plain(benchmark::State& state) {
    model_path();
    const glm::mat4 to_clip = glm::perspective(glm::radians(60.0F), 1.0F, 1.0F, 20.0F) *
                              glm::lookAt(glm::vec3(0, 2, 4), glm::vec3(0), glm::vec3(0, 1, 0));
    for (auto _ : state) {
        const PlainModel model = load(model_path());
        std::vector<Color> colors(std::size_t{side} * side);
        std::vector<float> depths(colors.size(), 0);
        for (const auto& face : model.faces) {
            std::array<glm::vec3, 3> corners{};
            for (std::size_t i = 0; i < 3; ++i) {
                const glm::vec4 clip = to_clip * glm::vec4(model.positions[face[i]], 1);
                corners[i] = {(clip.x / clip.w + 1) * side / 2, (1 - clip.y / clip.w) * side / 2,
                              1 / clip.w};
            }
            fill_box(corners, Color(255, 255, 255), colors, depths);
        }
        benchmark::DoNotOptimize(colors.data());
    }
}

BENCHMARK(plain)->Name("model/plain")->Unit(benchmark::kMillisecond);
BENCHMARK(ours)->Name("model/ours, nothing written")->Unit(benchmark::kMillisecond);
BENCHMARK(drawn)->Name("model/ours, no listener")->Unit(benchmark::kMillisecond);

} // namespace
} // namespace rastertrace
