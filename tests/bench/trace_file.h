// SPDX-License-Identifier: MIT
#pragma once

// A trace in a file, for benchmarks of what reads one: a head of 38,080 triangles with depths.
//
//     count_lines(head_trace_path());

#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/output.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace rastertrace {

/// A file in the system's folder for such, which is removed in the end.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::string& name)
        : path_(std::filesystem::temp_directory_path() / name) {}
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() { std::filesystem::remove(path_); }

    std::string path() const { return path_.string(); }

private:
    std::filesystem::path path_;
};

/// The path of the head's trace, which is written when it is first asked for.
inline const std::string& head_trace_path() {
    static const TemporaryFile file("rastertrace-bench.json");
    static const std::string path = [] {
        const std::string json = R"({
  "canvas": {"width": 1024, "height": 1024},
  "meshes": [{"obj": ")" + std::filesystem::path(RASTERTRACE_HEAD).filename().string() +
                                 R"("}],
  "camera": {"position": [0, 0, 6], "look_at": [0, 0, 0], "up": [0, 1, 0]},
  "projection": {"type": "frustum", "fov_y": 32, "near": 1, "far": 10},
  "method": {"depth": "inverse-z"}})";
        const auto scene = read_scene({RASTERTRACE_HEAD ".json", json});
        if (!scene)
            std::abort();
        FileOutput output(file.path());
        write_trace(scene.value().scene, scene.value().plan, {}, output);
        output.commit();
        return file.path();
    }();
    return path;
}

/// Reads a file in blocks and counts its lines: the least that a reader of lines can do.
inline std::ptrdiff_t count_lines(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string block(1 << 16, '\0');
    std::ptrdiff_t lines = 0;
    while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0)
        lines += std::count(block.begin(), block.begin() + file.gcount(), '\n');
    return lines;
}

} // namespace rastertrace
