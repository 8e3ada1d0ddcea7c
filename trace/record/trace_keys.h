// SPDX-License-Identifier: MIT
#pragma once

// The keys of a trace's header and of its end record; those of its steps are in step_kind.h. A reader takes other
// keys too: a foreign rasterizer may add its own. `validate` holds headers against these tables; docs/trace.schema.json
// says what each key means.
//
//     for (const HeaderKey& key : header_keys) ...

#include <array>
#include <string_view>

namespace rastertrace {

struct HeaderKey {
    std::string_view name;
    std::string_view form; ///< what its value is (header_check.cpp)
    bool is_required = false;
};

inline constexpr std::array header_keys{
    HeaderKey{"rastertrace", "version", true},
    HeaderKey{"title", "string"},
    HeaderKey{"canvas", "canvas", true},
    HeaderKey{"background", "color"},
    HeaderKey{"method", "method"},
    HeaderKey{"numbers", "string"},
    HeaderKey{"projection", "string"},
    HeaderKey{"viewport", "string"},
    HeaderKey{"matrices", "string"},
    HeaderKey{"stages", "stages"},
    HeaderKey{"only", "strings"},
    HeaderKey{"region", "region"},
    HeaderKey{"primitive", "string"},
};

inline constexpr std::array stage_keys{
    HeaderKey{"stage", "string", true},
    HeaderKey{"plane", "string"},
    HeaderKey{"kept", "boolean", true},
    HeaderKey{"why", "string"},
};

inline constexpr std::array end_keys{
    HeaderKey{"steps", "count"},
    HeaderKey{"count", "counts"},
    HeaderKey{"pixels", "count"},
    HeaderKey{"frame", "string"},
};

} // namespace rastertrace
