// SPDX-License-Identifier: MIT
#pragma once

// One name for vectors of every scalar: GLM's for float and double, a small struct of the same
// shape for exact numbers (glm::vec keeps its components in unions, which a heap-backed number
// cannot join).
//
//     Vec<double, 2> a{2.0, 5.0};
//     a.x + a.y

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <concepts>
#include <cstddef>

namespace rastertrace {

template <typename Scalar, std::size_t size> struct ExactVec;

template <typename Scalar> struct ExactVec<Scalar, 2> {
    Scalar x{};
    Scalar y{};
};

template <typename Scalar, std::size_t size> struct VecOf { using type = ExactVec<Scalar, size>; };

template <std::floating_point Scalar, std::size_t size> struct VecOf<Scalar, size> {
    using type = glm::vec<static_cast<glm::length_t>(size), Scalar>;
};

/// A vector with components x, y.
template <typename Scalar, std::size_t size> using Vec = typename VecOf<Scalar, size>::type;

} // namespace rastertrace
