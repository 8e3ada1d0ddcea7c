// SPDX-License-Identifier: MIT
#pragma once

// Scenes that exercises are like, of each kind of work.

#include <array>
#include <string_view>

namespace rastertrace {

struct ExerciseScene {
    std::string_view name; ///< "scanline"
    std::string_view text; ///< in JSON
};

inline constexpr std::array exercise_scenes{
    ExerciseScene{"scanline",
                  R"({"title": "The rows of a triangle",
 "canvas": {"width": 17, "height": 14},
 "vertices": {"A": [2, 5], "B": [-4, -3], "C": [5, -3]},
 "triangles": ["ABC"],
 "method": {"scalar": "exact"}}
)"},
    ExerciseScene{"bresenham",
                  R"({"title": "Two lines by Bresenham",
 "canvas": {"width": 17, "height": 15, "origin": "bottom-left"},
 "vertices": {"A": [1, 2], "B": [10, 6], "C": [12, 12], "D": [15, 4]},
 "lines": ["AB", "CD"],
 "method": {"line": "bresenham"}}
)"},
    ExerciseScene{"top-left",
                  R"({"title": "An edge that two triangles share",
 "canvas": {"width": 10, "height": 9, "origin": "top-left"},
 "vertices": {"A": [1, 1], "B": [8, 2], "C": [7, 7], "D": [2, 6]},
 "triangles": ["ABC", "ACD"],
 "method": {"scalar": "exact", "fill": "top-left"}}
)"},
    ExerciseScene{"depth",
                  R"({"title": "A side that leads away",
 "canvas": {"width": 10, "height": 10},
 "vertices": {"A": [-3, 2, 3], "D": [-3, -3, 3], "E": [0, 2, 5]},
 "triangles": ["ADE"],
 "method": {"scalar": "exact", "depth": "inverse-z"},
 "keep": ["depth"]}
)"},
    ExerciseScene{"pipeline",
                  R"({"title": "Three points seen by a camera",
 "canvas": {"width": 512, "height": 512, "origin": "top-left"},
 "vertices": {"P": [1, 1, 1], "Q": [2, "1/2", 0], "R": [-1, 2, -1]},
 "points": ["P", "Q", "R"],
 "camera": {"position": [0, 0, 4], "look_at": [0, 0, 0], "up": [0, 1, 0]},
 "projection": {"type": "view-plane", "distance": 1},
 "method": {"scalar": "exact", "depth": "none"}}
)"},
    ExerciseScene{"light",
                  R"({"title": "Two faces in the light",
 "canvas": {"width": 16, "height": 12},
 "vertices": {"A": [-6, -4, 0], "B": [5, -3, 1], "C": [0, 4, 3], "D": [6, 2, -2]},
 "triangles": [{"vertices": "ABC", "color": "#ffffff"}, {"vertices": "BDC", "color": "#ffffff"}],
 "light": {"direction": [1, 2, 3]},
 "method": {"scalar": "exact", "fill": "top-left", "cull": "back", "shade": "lambert"}}
)"},
    ExerciseScene{"clip",
                  R"({"title": "One vertex in front, one beside, one behind",
 "canvas": {"width": 33, "height": 17, "origin": "top-left"},
 "vertices": {"A": [0, 2, -4], "B": [-1, -2, 2], "C": [1, 0, 0]},
 "triangles": ["ABC"],
 "projection": {"type": "view-plane", "distance": 1, "near": 1},
 "method": {"scalar": "exact", "fill": "top-left"}}
)"},
};

} // namespace rastertrace
