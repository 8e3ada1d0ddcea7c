// SPDX-License-Identifier: MIT
#pragma once

// Writes steps as lines of JSON (step_json.h). They are put together in a buffer that goes to the output when it is full:
// memory does not grow with the number of steps.
//
//     StepWriter writer(output, TraceLayout::json);
//     Arena arena;
//     draw(scene, plan, StepTracer<StepWriter>(writer, arena, false));

#include "step_json.h"
#include "trace_options.h"

#include <rastertrace/trace/text/output.h>

#include <cstddef>
#include <cstring>
#include <string_view>
#include <vector>

namespace rastertrace {

class StepWriter {
public:
    StepWriter(Output& output, TraceLayout layout)
        : output_(output), buffer_(buffer_size),
          next_separator_(layout == TraceLayout::json ? ",\n" : "\n") {}

    template <typename Step> void take(const Step& step) {
        ++counts_[static_cast<std::size_t>(Step::step_kind)];
        char* const begin = room(separator_.size() + room_for_step(step));
        std::memcpy(begin, separator_.data(), separator_.size());
        const char* const end = write_step(begin + separator_.size(), step, &texts_);
        used_ = static_cast<std::size_t>(end - buffer_.data());
        separator_ = next_separator_;
    }

    /// Writes text as it is: for what stands before the first step and behind the last one.
    void put_text(std::string_view text) {
        std::memcpy(room(text.size()), text.data(), text.size());
        used_ += text.size();
    }

    /// Hands everything written so far to the output.
    void flush() {
        output_.write({buffer_.data(), used_});
        used_ = 0;
    }

    /// How many steps have been written.
    const KindCounts& counts() const { return counts_; }

private:
    /// What the buffer holds before it is handed on.
    static constexpr std::size_t buffer_size = 256 * 1024;

    /// A place in the buffer with room for `size` bytes.
    char* room(std::size_t size) {
        if (buffer_.size() - used_ < size) {
            flush();
            if (buffer_.size() < size)
                buffer_.resize(size);
        }
        return buffer_.data() + used_;
    }

    Output& output_;
    std::vector<char> buffer_;
    std::size_t used_ = 0;
    std::string_view separator_ = "\n"; ///< before the next line
    std::string_view next_separator_;
    KindCounts counts_{};
    DoubleTexts texts_;
};

} // namespace rastertrace
