// SPDX-License-Identifier: MIT
#pragma once

// One name for vectors of every scalar: GLM's for float and double, a small struct of the same
// shape for exact numbers (glm::vec keeps its components in unions, which a heap-backed number
// cannot join).
//
//     Vec<double, 3> a{2.0, 5.0, 1.0};
//     dot(a, cross(a, b));

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <concepts>
#include <cstddef>
#include <type_traits>

namespace rastertrace {

template <typename Scalar, std::size_t size> struct ExactVec;

template <typename Scalar> struct ExactVec<Scalar, 2> {
    Scalar x{};
    Scalar y{};
};

template <typename Scalar> struct ExactVec<Scalar, 3> {
    Scalar x{};
    Scalar y{};
    Scalar z{};

    friend ExactVec operator+(const ExactVec& a, const ExactVec& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend ExactVec operator-(const ExactVec& a, const ExactVec& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend Scalar dot(const ExactVec& a, const ExactVec& b) {
        return a.x * b.x + a.y * b.y + a.z * b.z;
    }
    friend ExactVec cross(const ExactVec& a, const ExactVec& b) {
        return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
    }
};

template <typename Scalar> struct ExactVec<Scalar, 4> {
    Scalar x{};
    Scalar y{};
    Scalar z{};
    Scalar w{};
};

/// A vector with components x, y and so on, up to four of them. `+`, `-`, `dot` and `cross` of
/// three-component vectors are the same for every scalar; for float and double they are GLM's.
template <typename Scalar, std::size_t size>
using Vec =
    std::conditional_t<std::floating_point<Scalar>,
                       glm::vec<static_cast<glm::length_t>(size), Scalar>, ExactVec<Scalar, size>>;

} // namespace rastertrace
