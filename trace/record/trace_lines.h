// SPDX-License-Identifier: MIT
#pragma once

// The two layouts that have one step a line, and what is said of a trace that ends too soon.

#include "frame.h"
#include "step_kind.h"
#include "trace.h"
#include "traced_steps.h"

#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rastertrace {

/// The kind of the step that a part of a source holds, if we know it. Throws a Problem if it is no step that can be
/// understood.
std::optional<StepKind> checked_kind(const Source& source, std::size_t begin, std::size_t size);

/// Counts a step, if it has a quantity that is not finite.
void note_not_finite(NotFiniteSteps& noted, const Source& source, std::size_t begin,
                     std::string_view json, StepKind kind);

/// That so many steps are whole, and then the file ends.
std::string truncation_after(std::size_t steps);

/// That there are not as many as the end record says: `expected 62 steps as the end record says, found 61`.
std::string disagreement(std::string_view told, std::string_view what, std::string_view found);

/// The picture that the steps of a trace draw, given one after the other.
class PictureOfSteps {
public:
    explicit PictureOfSteps(const Canvas& canvas) : image_(canvas), canvas_(canvas) {}

    void add(const PrimitiveStep& step) { color_ = color_of_primitive(step); }
    void add(const PixelStep& step) {
        const auto plotted = plotted_by(step, canvas_, color_);
        if (plotted)
            image_.at(plotted->pixel) = plotted->color;
        has_stray_pixel_ = has_stray_pixel_ || !plotted;
    }
    template <typename Step> void add(const Step& /*other*/) {}

    /// The same for a step that has not been decoded.
    void add(const StepView& step, StepKind kind) {
        if (kind == StepKind::primitive)
            add(step.as<PrimitiveStep>());
        if (kind == StepKind::pixel)
            add(step.as<PixelStep>());
    }

    const Image& image() const { return image_; }
    bool has_stray_pixel() const { return has_stray_pixel_; } ///< one that the canvas has not

private:
    Image image_;
    Canvas canvas_;
    Color color_; ///< of the current primitive
    bool has_stray_pixel_ = false;
};

/// Reads a part of a trace, with the header in front of it: who asks holds the whole against the end record.
Result<Trace> read_block(Source source, bool to_tell);

/// True if an end record says something about the picture.
bool tells_picture(const EndRecord& end);

/// What the picture that comes of all steps has otherwise than the end record says.
std::optional<std::string> disagreement_of_picture(const Trace& header, const EndRecord& end,
                                                   const Image& image);

} // namespace rastertrace
