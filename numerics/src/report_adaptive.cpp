// SPDX-License-Identifier: MIT
#include "report_adaptive.h"

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/numerics/drawing.h>
#include <rastertrace/numerics/timing.h>

#include <algorithm>
#include <concepts>
#include <utility>

namespace rastertrace {

namespace {

/// Keeps what is drawn. Every primitive begins once, in the scene's order; its parts are no others.
struct StepsSink {
    const std::vector<std::size_t>& numbers;
    AdaptiveSteps& steps;
    std::size_t begun = 0;

    template <typename Step> void operator()(const Step&) {}
    /// One that is cut begins with the numbers that it has before it is placed.
    template <typename Scalar> void operator()(const PrimitiveBegan<Scalar>& step) {
        begun += step.is_part ? 0 : 1;
    }
    template <typename Scalar> void operator()(const SampleTested<Scalar>&) {
        ++steps.samples_tested;
    }
    template <typename Scalar> void operator()(const DepthTested<Scalar>& step) {
        steps.tested.push_back({numbers[begun - 1], step.pixel, to_double(step.depth)});
    }
    void operator()(const PixelPlotted& step) {
        steps.plotted.push_back({numbers[begun - 1], step.pixel, step.color});
    }

    template <typename Step> bool takes() const {
        return std::same_as<Step, PrimitiveBegan<Quantity>> ||
               std::same_as<Step, SampleTested<Quantity>> ||
               std::same_as<Step, DepthTested<Quantity>> || std::same_as<Step, PixelPlotted>;
    }
};

} // namespace

std::shared_ptr<AdaptiveDrawing> adaptive_drawing(const Scene& scene) {
    const auto drawing = std::make_shared<AdaptiveDrawing>();
    drawing->scene = scene;
    drawing->scene.primitives.clear();
    for (std::size_t number = 0; number < scene.primitives.size(); ++number)
        if (scene.primitives[number].kind == PrimitiveKind::triangle) {
            drawing->scene.primitives.push_back(scene.primitives[number]);
            drawing->numbers.push_back(number);
        }
    drawing->plan = plan_for(drawing->scene);
    drawing->plan.number = NumberType::adaptive;
    return drawing;
}

std::uint64_t AdaptiveSteps::pixels_tested() const {
    return samples_tested > 0 ? samples_tested : plotted.size();
}

AdaptiveSteps steps_of(const AdaptiveDrawing& drawing) {
    AdaptiveSteps steps;
    draw(drawing.scene, drawing.plan, StepsSink{drawing.numbers, steps});
    return steps;
}

Setting adaptive_setting(const AdaptiveDrawing& drawing, std::uint64_t pixels_tested) {
    // Counted without a sink: what is only told may be left open, too.
    Fallbacks fallbacks;
    keep(drawn(drawing.scene, drawing.plan, &fallbacks));
    Setting setting;
    setting.name = "adaptive (draw)";
    setting.label = setting.name;
    setting.note = "timed as a whole drawing, with placing and clipping";
    setting.work =
        Work{.pixels_tested = pixels_tested,
             .exact_fallbacks = fallbacks.primitives + fallbacks.depths + fallbacks.colors,
             .has_operations = false};
    return setting;
}

std::function<void()> timed(std::shared_ptr<const AdaptiveDrawing> drawing) {
    return [drawing = std::move(drawing)] { keep(drawn(drawing->scene, drawing->plan)); };
}

} // namespace rastertrace
