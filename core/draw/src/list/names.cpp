// SPDX-License-Identifier: MIT
#include "list/names.h"

#include <rastertrace/core/numbers/adaptive.h>

#include <algorithm>
#include <string_view>

namespace rastertrace {

PieceNames::PieceNames(const Scene& scene, const TypedVertices&, const ScreenPrimitive& one)
    : piece(scene.primitives[one.primitive].name) {
    const auto indices = scene.primitives[one.primitive].corners();
    std::transform(indices.begin(), indices.end(), corners.begin(),
                   [&](std::size_t index) { return std::string_view(scene.vertices[index].name); });
}
template <typename Scalar>
PieceNames::PieceNames(const Scene& scene, const ScreenList<Scalar>& list,
                       const ScreenPrimitive& one)
    : piece(scene.primitives[one.primitive].name) {
    const std::string& name = scene.primitives[one.primitive].name;
    std::size_t i = 0;
    for (const std::size_t index : corners_of(scene, list, one)) {
        if (index >= scene.vertices.size())
            made_[i] = name_of_made(name, list.made[index - scene.vertices.size()].ordinal);
        corners[i] = index < scene.vertices.size() ? scene.vertices[index].name : made_[i];
        ++i;
    }
    if (one.state == ScreenPrimitive::State::part)
        piece = made_[3] = name + "/" + std::to_string(list.parts[one.index].ordinal);
}

template PieceNames::PieceNames(const Scene&, const ScreenList<float>&, const ScreenPrimitive&);
template PieceNames::PieceNames(const Scene&, const ScreenList<double>&, const ScreenPrimitive&);
template PieceNames::PieceNames(const Scene&, const ScreenList<Adaptive>&, const ScreenPrimitive&);
template PieceNames::PieceNames(const Scene&, const ScreenList<Rational>&, const ScreenPrimitive&);

} // namespace rastertrace
