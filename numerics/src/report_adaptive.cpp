// SPDX-License-Identifier: MIT
#include "report_adaptive.h"

#include "job_builder.h"

#include <rastertrace/core/draw/list/screen_list.h>
#include <rastertrace/core/draw/paint/piece_in.h>
#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/core/numbers/adaptive.h>

#include <map>
#include <utility>
#include <variant>

namespace rastertrace {

AdaptiveTriangles::AdaptiveTriangles(const Scene& of, const Plan& with)
    : scene(of), plan(with), exactness{ExactPieces(scene, plan),
                                       sample_offset<Rational>(sample_of(scene.method), 1)} {
    std::map<std::uint32_t, std::uint32_t> parts; // of each primitive, so far
    const auto add = [&](const PieceIndex& index, std::optional<Piece<Adaptive>> filtered) {
        placed.push_back({index, std::move(filtered), exactness.pieces.piece(index)});
    };
    const auto add_from = [&](const auto& list, const ScreenPrimitive& one) {
        add({one.primitive, parts[one.primitive]++},
            piece_in<Adaptive>(piece_of(scene, list, one), plan));
    };
    std::visit(
        [&]<typename AList>(const AList& list) {
            if constexpr (draws<Adaptive, AList>)
                for_each_primitive(scene, list, [&](const ScreenPrimitive& one) {
                    if (scene.primitives[one.primitive].kind != PrimitiveKind::triangle)
                        return;
                    if (one.state != ScreenPrimitive::State::undecided)
                        return add_from(list, one);
                    // Its face, or what is left of it, was found in rationals.
                    for (const ScreenPrimitive& exact : exactness.pieces.of(one.primitive)) {
                        if (exact.state == ScreenPrimitive::State::part)
                            add_from(exactness.pieces.list(), exact);
                        else
                            add({one.primitive, parts[one.primitive]++}, std::nullopt);
                    }
                });
        },
        *plan.list);
}

std::vector<std::size_t> AdaptiveTriangles::primitives() const {
    std::vector<std::size_t> numbers;
    for (const Placed& one : placed)
        numbers.push_back(one.index.primitive);
    return numbers;
}

void AdaptiveTriangles::begin() {
    exactness.drawn.clear();
    exactness.colors.reset();
    exactness.fallbacks = {};
}

Setting adaptive_setting(std::uint64_t pixels_tested, std::uint64_t exact_fallbacks,
                         std::string note) {
    Setting setting = named_setting("adaptive");
    setting.note = std::move(note);
    setting.work = Work{.pixels_tested = pixels_tested,
                        .exact_fallbacks = exact_fallbacks,
                        .has_operations = false};
    return setting;
}

} // namespace rastertrace
