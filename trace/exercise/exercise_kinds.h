// SPDX-License-Identifier: MIT
#pragma once

// Scenes that exercises of a kind are like, for who has none of his own.

#include <array>
#include <string_view>

namespace rastertrace {

struct ExerciseKind {
    std::string_view name;  ///< "scanline"
    std::string_view about; ///< what is worked out
    std::string_view scene; ///< in JSON
};

inline constexpr std::array exercise_kinds{
    ExerciseKind{"scanline", "the rows of a triangle, from its edges",
                 R"({"title": "The rows of a triangle",
 "canvas": {"width": 17, "height": 14},
 "vertices": {"A": [2, 5], "B": [-4, -3], "C": [5, -3]},
 "triangles": ["ABC"],
 "method": {"scalar": "exact"}}
)"},
    ExerciseKind{"bresenham", "d, step by step, of two lines",
                 R"({"title": "Two lines by Bresenham",
 "canvas": {"width": 17, "height": 15, "origin": "bottom-left"},
 "vertices": {"A": [1, 2], "B": [10, 6], "C": [12, 12], "D": [15, 4]},
 "lines": ["AB", "CD"],
 "method": {"line": "bresenham"}}
)"},
    ExerciseKind{"top-left", "the edge functions of two triangles that share an edge",
                 R"({"title": "An edge that two triangles share",
 "canvas": {"width": 10, "height": 9, "origin": "top-left"},
 "vertices": {"A": [1, 1], "B": [8, 2], "C": [7, 7], "D": [2, 6]},
 "triangles": ["ABC", "ACD"],
 "method": {"scalar": "exact", "fill": "top-left"}}
)"},
    ExerciseKind{"depth", "1/z along edges and rows",
                 R"({"title": "A side that leads away",
 "canvas": {"width": 10, "height": 10},
 "vertices": {"A": [-3, 2, 3], "D": [-3, -3, 3], "E": [0, 2, 5]},
 "triangles": ["ADE"],
 "method": {"scalar": "exact", "depth": "inverse-z"},
 "keep": ["depth"]}
)"},
    ExerciseKind{"pipeline", "three points on their way to the screen",
                 R"({"title": "Three points seen by a camera",
 "canvas": {"width": 512, "height": 512, "origin": "top-left"},
 "vertices": {"P": [1, 1, 1], "Q": [2, "1/2", 0], "R": [-1, 2, -1]},
 "points": ["P", "Q", "R"],
 "camera": {"position": [0, 0, 4], "look_at": [0, 0, 0], "up": [0, 1, 0]},
 "projection": {"type": "view-plane", "distance": 1},
 "method": {"scalar": "exact", "depth": "none"}}
)"},
    ExerciseKind{"light", "normals, what is culled, and the light on a face",
                 R"({"title": "Two faces in the light",
 "canvas": {"width": 16, "height": 12},
 "vertices": {"A": [-6, -4, 0], "B": [5, -3, 1], "C": [0, 4, 3], "D": [6, 2, -2]},
 "triangles": [{"vertices": "ABC", "color": "#ffffff"}, {"vertices": "BDC", "color": "#ffffff"}],
 "light": {"direction": [1, 2, 3]},
 "method": {"scalar": "exact", "fill": "top-left", "cull": "back", "shade": "lambert"}}
)"},
    ExerciseKind{"clip", "where the near plane cuts a triangle",
                 R"({"title": "One vertex in front, one beside, one behind",
 "canvas": {"width": 33, "height": 17, "origin": "top-left"},
 "vertices": {"A": [0, 2, -4], "B": [-1, -2, 2], "C": [1, 0, 0]},
 "triangles": ["ABC"],
 "projection": {"type": "view-plane", "distance": 1, "near": 1},
 "method": {"scalar": "exact", "fill": "top-left"}}
)"},
};

} // namespace rastertrace
