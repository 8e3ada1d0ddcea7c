// SPDX-License-Identifier: MIT
#pragma once

// What is told in front of the primitives, and of their faces, done again: matrices, vertices from space to space, faces,
// light, the painter's order, the cuts of faces and of clipping.
//
//     SpaceAgain space(trace, findings);
//     space.redo(n);  // the steps one after the other

#include "redo_findings.h"

#include <rastertrace/core/draw/scene/transforms.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/transform/projection.h>
#include <rastertrace/trace/tell/formulas_of.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

class SpaceAgain {
public:
    SpaceAgain(const Trace& trace, Findings& findings);

    /// Step n, if it is one of these.
    void redo(std::size_t n);

    /// Behind the last one: what should have come.
    void finish();

private:
    void redo(const TriangulateStep& step);
    void redo(const MatrixStep& step);
    void redo(const VertexStep& step);
    void redo(const OrderStep& step);
    void redo(const PrimitiveStep& step);
    void redo(const FaceStep& step);
    void redo(const LightStep& step);
    void redo(const ClipStep& step);

    void redo_snap(const VertexStep& step);
    void redo_name(const TracedText& name, const char* what);
    void redo_normal(const TracedList<TracedNumber>& told, const char* what);
    void redo_product(const TracedList<TracedNumber>& normal, const TracedList<TracedNumber>& other,
                      const TracedNumber& told, const char* what);
    void redo_place(const VertexStep& step);
    std::vector<Vec<Rational, 3>> corners() const;
    std::optional<Rational> distance_of(const std::string& vertex) const;
    void expect_near(const Rational& redone, const TracedNumber& told, const Rational& size,
                     const std::string& what);

    void expect_rounded(const Rational& redone, const TracedNumber& told, const Rational& size,
                        const std::string& what);

    template <typename A, typename B>
    void expect(const A& redone, const B& told, const std::string& what, std::string_view of = {}) {
        findings_.expect(n_, redone, told, what, of);
    }

    const Trace& trace_;
    Numbers numbers_;
    const ToldMethod& rules_;
    Findings& findings_;
    std::optional<ProjectionType> projection_;
    std::size_t n_ = 0;                 ///< the step
    Space first_space_ = Space::object; ///< in which most vertices begin
    Vec3 eye_{0, 0, 0};
    std::optional<Vec3> toward_camera_; ///< from what it looks at; none without one
    bool has_screen_ = false;           ///< a vertex has been told there
    struct Ear {
        std::string face;
        std::vector<std::string> corners;
        std::size_t step = 0; ///< that tells it
    };
    std::map<std::string, Ear> ears_;
    std::size_t order_step_ = 0;
    std::vector<std::string> order_;
    std::vector<TracedNumber> distances_;
    std::size_t drawn_ = 0; ///< primitives that are no parts, since `order`
    PrimitiveStep primitive_;
    std::optional<std::string> undecided_; ///< the primitive that has to come next
};

} // namespace rastertrace
