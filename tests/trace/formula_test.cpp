// SPDX-License-Identifier: MIT
// What a formula writes out is worked out again by a reader of arithmetic: it comes to what judges a claim.

#include <rastertrace/trace/tell/formula.h>
#include <rastertrace/trace/tell/step_text.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {
namespace {

/// Reads `(-4 - 2)/(-3 - 5) (2 - 5) + 2`: a space between two factors multiplies.
class Arithmetic {
public:
    explicit Arithmetic(std::string_view rest) : rest_(rest) {}

    Rational sum() {
        Rational value = product();
        while (true)
            if (take(" + "))
                value += product();
            else if (take(" - "))
                value -= product();
            else
                return value;
    }

    bool at_end() const { return rest_.empty(); }

private:
    Rational product() {
        Rational value = factor();
        while (true)
            if (take("/"))
                value /= factor();
            else if (rest_.starts_with(" (") && take(" "))
                value *= factor();
            else
                return value;
    }

    Rational factor() {
        if (take("(")) {
            Rational value = sum();
            if (!take(")"))
                throw std::string("expected )");
            return value;
        }
        std::size_t end = rest_.starts_with('-') ? 1 : 0;
        end = rest_.find_first_not_of("0123456789.", end);
        if (end < rest_.size() && rest_[end] == 'e')
            end = rest_.find_first_not_of("0123456789", end + 2); // behind the exponent's sign
        end = std::min(end, rest_.size());
        const auto value = number_in(rest_.substr(0, end));
        if (!value)
            throw "expected a number, found " + std::string(rest_);
        rest_.remove_prefix(end);
        return *value;
    }

    bool take(std::string_view token) {
        if (!rest_.starts_with(token))
            return false;
        rest_.remove_prefix(token.size());
        return true;
    }

    std::string_view rest_;
};

Rational worked_out(std::string_view text) {
    Arithmetic arithmetic(text);
    const Rational value = arithmetic.sum();
    RC_ASSERT(arithmetic.at_end());
    return value;
}

std::vector<std::string> split_around(const std::string& text, std::string_view separator) {
    std::vector<std::string> parts;
    std::size_t begin = 0;
    for (std::size_t end = 0; end != std::string::npos; begin = end + separator.size()) {
        end = text.find(separator, begin);
        parts.push_back(text.substr(begin, end == std::string::npos ? end : end - begin));
    }
    return parts;
}

/// Every side of `a = b = c`; of one with a long fraction, seven digits are written.
void expect_sides(const std::string& text, const Rational& value) {
    constexpr int largest_coordinate = 40;
    for (const std::string& side : split_around(text, " = ")) {
        const bool is_exact = side.find('.') == std::string::npos;
        const Rational room =
            is_exact ? Rational(0) : Rational((abs(value) + 2 * largest_coordinate) / 1'000'000);
        RC_ASSERT((abs(worked_out(side) - value) <= room));
    }
}

Rational coordinate() {
    return {*rc::gen::inRange(-40, 40), *rc::gen::element(1, 1, 2, 3)};
}
Vec<Rational, 3> corner() {
    Rational x = coordinate(), y = coordinate(), z = coordinate();
    for (Rational* const one : {&x, &y, &z})
        one->canonicalize();
    return {x, y, z};
}

RC_GTEST_PROP(Formula, WritesOutWhatALerpComesTo, ()) {
    const auto from = corner();
    const auto to = corner();
    const Lerp lerp{.d1 = from.x, .i1 = from.y, .d2 = to.x, .i2 = to.y, .i = from.z};
    RC_PRE(lerp.i1 != lerp.i2);
    expect_sides(lerp.written_out(lerp.value()), lerp.value());
}

RC_GTEST_PROP(Formula, WritesOutWhatAFaceComesTo, ()) {
    const FaceNormal face{{corner(), corner(), corner()}};
    const auto normal = face.value();
    const std::string cross = face.written_out();
    const auto parts = split_around(cross.substr(1, cross.size() - 2), ", ");
    RC_ASSERT(parts.size() == 3u);
    RC_ASSERT(worked_out(parts[0]) == normal.x);
    RC_ASSERT(worked_out(parts[1]) == normal.y);
    RC_ASSERT(worked_out(parts[2]) == normal.z);
    // At a right angle to its sides, by another way.
    const auto& a = face.corners[0];
    const auto& b = face.corners[1];
    const auto& c = face.corners[2];
    RC_ASSERT(FaceDot({normal, b - a}).value() == 0);
    const FaceDot product{normal, corner()};
    expect_sides(product.written_out(), product.value());
    // A point of the plane: each corner.
    std::string plane = FacePlane{normal, a}.written_out();
    const auto put_in = [&plane](const std::string& name, const Rational& x) {
        plane.replace(plane.find(" " + name + " "), 3, " (" + text(x) + ") ");
    };
    put_in("x", c.x);
    put_in("y", c.y);
    put_in("z", c.z);
    expect_sides(plane, 0);
}

RC_GTEST_PROP(Formula, WritesOutWhatAMatrixMakesOfAPoint, ()) {
    const auto row = corner();
    const auto point = corner();
    const MatrixTimes product{{{row.x, row.y, row.z, Rational(3)}},
                              {point.x, point.y, point.z, Rational(1)}};
    RC_ASSERT(worked_out(product.written_out(0)) == product.value(0));
    RC_ASSERT(value_of({product}) == Values{product.value(0)});
}

RC_GTEST_PROP(Formula, WritesOutTheWeightsOfASample, ()) {
    const auto place = [] {
        const auto at = corner();
        return Vec<Rational, 2>{at.x, at.y};
    };
    const Weights triangle{{place(), place(), place()}, place()};
    const auto& [a, b, c] = triangle.corners;
    const Rational area = doubled_area(a, b, c);
    RC_PRE(area != 0);
    const auto weights = *triangle.value();
    // By the areas of the parts, and by what weights are for: they mix the corners to the sample.
    RC_ASSERT((weights[0] == doubled_area(triangle.sample, b, c) / area));
    RC_ASSERT((weights[0] * a.x + weights[1] * b.x + weights[2] * c.x == triangle.sample.x));
    RC_ASSERT((weights[0] * a.y + weights[1] * b.y + weights[2] * c.y == triangle.sample.y));
    const auto parts = split_around(triangle.written_out(), " = ");
    RC_ASSERT((parts.size() == 2u));
    RC_ASSERT((parts[1] == text(Vec<Rational, 3>{weights[1] * area, weights[2] * area, area})));

    const auto depths = corner();
    const MixedDepth mixed{{weights.begin(), weights.end()}, {depths.x, depths.y, depths.z}};
    // Long fractions are written as seven digits, of which a sum of large terms loses some.
    Rational terms = abs(mixed.depth());
    for (std::size_t i = 0; i < 3; ++i)
        terms += abs(mixed.weights[i] * mixed.depths[i]);
    for (const std::string& side : split_around(mixed.written_out(mixed.depth()), " = "))
        RC_ASSERT((abs(worked_out(side) - mixed.depth()) <= terms / 1'000'000));
}

RC_GTEST_PROP(Formula, WritesOutBresenhamsDecisions, ()) {
    const int major = *rc::gen::inRange(1, 40);
    const BresenhamDecisions line{.major = major,
                                  .minor = *rc::gen::inRange(0, major + 1),
                                  .steps = static_cast<std::size_t>(major),
                                  .steps_at_ties = *rc::gen::arbitrary<bool>()};
    Rational minor_steps = 0;
    Rational step = 0;
    for (const Rational& d : value_of({line})) {
        // d is what the midpoint lies below the line, times 2 major.
        RC_ASSERT((d == 2 * line.minor * (step + 1) - 2 * line.major * minor_steps - line.major));
        const auto parts = split_around(line.written_out(d), " = ");
        RC_ASSERT((worked_out(parts[0]) == line.next(d)));
        RC_ASSERT((worked_out(parts[1]) == line.next(d)));
        step += 1;
        if (d > 0 || (d == 0 && line.steps_at_ties))
            minor_steps += 1;
    }
}

RC_GTEST_PROP(Formula, WritesOutACosine, ()) {
    const FaceCosine face{corner(), corner()};
    const auto cosine = face.value();
    const Rational squares = dot(face.normal, face.normal) * dot(face.view, face.view);
    RC_ASSERT((cosine.has_value() == (squares != 0)));
    if (!cosine)
        return;
    const Rational product = dot(face.normal, face.view);
    RC_ASSERT((abs(*cosine * *cosine - product * product / squares) < Rational(1, 1'000'000'000)));
    RC_ASSERT((*cosine * product >= 0));
    const auto parts = split_around(face.written_out("view"), " = ");
    RC_ASSERT((parts[0] == text(product) + " / (|normal| |view|)"));
    RC_ASSERT((abs(*number_in(parts[1]) - *cosine) < Rational(1, 100'000)));
}

} // namespace
} // namespace rastertrace
