// SPDX-License-Identifier: MIT
#pragma once

// The numbers of a scene that vary from frame to frame: its "vary", and those of a command line.
//
//     const Variations variations(json, document.root(), {{"/canvas/width", "17,25"}});
//     variations.count();                // 2 frames
//     variations.label(2);               // "2 of 2: width 25"
//     variations.put_into(document, 2);  // which reads as if 25 were typed there

#include "scene_file.h"

#include <rastertrace/trace/text/json_document.h>
#include <rastertrace/trace/text/json_reader.h>
#include <rastertrace/trace/text/language.h>

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace rastertrace {

class Variations {
public:
    /// What is wrong with one is thrown as a Problem.
    Variations(const JsonReader& json, const JsonValue& root, const std::vector<Variation>& given);

    /// How many frames there are; 1 if nothing varies.
    std::size_t count() const { return varying_.empty() ? 1 : varying_.front().values.size(); }

    bool empty() const { return varying_.empty(); }

    /// `3 of 24: degrees 30`, for a frame from 1 to count().
    std::string label(std::size_t frame, Language language = Language::english) const;

    /// Puts the numbers of a frame into the document, or into another one of the same source.
    void put_into(JsonDocument& document, std::size_t frame) const;

private:
    struct Varying {
        std::string pointer;
        std::uint32_t node;            ///< of the number
        std::vector<mpq_class> values; ///< in order
    };
    std::vector<Varying> varying_;
};

} // namespace rastertrace
