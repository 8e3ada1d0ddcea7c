// SPDX-License-Identifier: MIT
#include "report_adaptive.h"

#include "job_builder.h"
#include "placed_triangles.h"

#include <rastertrace/core/draw/list/screen_list.h>
#include <rastertrace/core/draw/paint/piece_in.h>
#include <rastertrace/core/draw/plan/stages.h>

#include <deque>
#include <map>
#include <utility>
#include <variant>

namespace rastertrace {

AdaptiveTriangles::AdaptiveTriangles(const Scene& of, const Plan& with) : scene(of), plan(with) {
    std::map<std::size_t, std::deque<Piece<Interval>>> decided; // of each primitive
    for_each_placed_triangle<Interval>(scene, plan, [&decided](const Piece<Interval>& piece) {
        decided[piece.primitive].push_back(piece);
    });
    Scene exact = scene;
    exact.method.scalar = ScalarKind::exact;
    std::visit(
        [&]<typename AList>(const AList& list) {
            if constexpr (draws<Rational, AList>)
                for_each_piece(exact, list, [&](const auto& piece) {
                    if (piece.kind != PrimitiveKind::triangle)
                        return;
                    Placed& one = placed.emplace_back();
                    one.exact = piece_in<Rational>(piece, {});
                    auto& parts = decided[piece.primitive];
                    if (parts.empty())
                        return;
                    one.doubles = in_doubles(parts.front());
                    one.intervals = std::move(parts.front());
                    parts.pop_front();
                });
        },
        screen_list_for(exact));
}

std::vector<std::size_t> AdaptiveTriangles::primitives() const {
    std::vector<std::size_t> numbers;
    for (const Placed& one : placed)
        numbers.push_back(one.exact.primitive);
    return numbers;
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
