// SPDX-License-Identifier: MIT
#include <rastertrace/figures/heat_map.h>

#include <rastertrace/trace/record/frame.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/named_value.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

namespace rastertrace {

namespace {

constexpr std::array<std::string_view, 3> words_of_heat{"overdraw", "tests", "depth-fights"};

/// matplotlib's viridis (Smith and van der Walt 2015) from its light end on, without the darkest eighth, which is not seen
/// on dark paper.
constexpr std::array viridis{Color{0xfd, 0xe7, 0x25}, Color{0xad, 0xdc, 0x30},
                             Color{0x5e, 0xc9, 0x62}, Color{0x28, 0xae, 0x80},
                             Color{0x21, 0x91, 0x8c}, Color{0x2c, 0x72, 0x8e},
                             Color{0x3b, 0x52, 0x8b}, Color{0x47, 0x2d, 0x7b}};

/// The color at a share of the way from the first to the last.
Color viridis_at(double share) {
    const double place = share * static_cast<double>(viridis.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), viridis.size() - 2);
    const double further = place - static_cast<double>(below);
    const auto between = [further](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::lround(a + further * (b - a)));
    };
    const Color a = viridis[below];
    const Color b = viridis[below + 1];
    return {between(a.red(), b.red()), between(a.green(), b.green()), between(a.blue(), b.blue())};
}

/// The gray that is as light as a color: the inverse of an sRGB level's luminance (IEC 61966-2-1).
Color gray_of(Color color) {
    const double light = luminance(color);
    const double level =
        light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
    const auto whole = static_cast<std::uint8_t>(std::lround(255 * level));
    return {whole, whole, whole};
}

/// The number of two depths: see equal_depths.
std::uint32_t digits_in_common(double a, double b) {
    if (a == b)
        return equal_depths;
    constexpr std::array powers{1e-1, 1e-2,  1e-3,  1e-4,  1e-5,  1e-6,  1e-7, 1e-8,
                                1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15};
    const double difference = std::abs(a - b) / std::max(std::abs(a), std::abs(b));
    return static_cast<std::uint32_t>(std::count_if(
        powers.begin(), powers.end(), [difference](double power) { return difference <= power; }));
}

/// What is known of a pixel's two nearest depths after one more test. The buffer has the nearest of those before: one that
/// passes makes that the second, any other may be nearer than the second.
std::uint32_t level_after(std::uint32_t level, const DepthStep& test) {
    constexpr std::uint32_t one_depth = 1;
    const bool is_nearest = stores_depth(test);
    if (level < one_depth)
        return is_nearest ? one_depth : level;
    const auto depth = test.depth.nearest_double();
    const auto stored = test.stored.nearest_double();
    const std::uint32_t now =
        depth && stored ? one_depth + 1 + digits_in_common(*depth, *stored) : one_depth;
    return is_nearest ? now : std::max(level, now);
}

} // namespace

std::vector<std::string_view> heat_names() {
    return {words_of_heat.begin(), words_of_heat.end()};
}

std::string_view name_of(Heat heat) {
    return words_of_heat[static_cast<std::size_t>(heat)];
}

std::optional<Heat> heat_named(std::string_view name) {
    return value_named<Heat>(words_of_heat, name);
}

StepKind steps_for(Heat heat) {
    return heat == Heat::overdraw ? StepKind::pixel : StepKind::depth;
}

void HeatMap::add(const StepView& step, std::optional<StepKind> kind) {
    if (kind != steps_for(heat_))
        return;
    const auto count = [this](const auto& counted) {
        if (!canvas_.contains(counted.x, counted.y))
            return;
        ++steps_;
        std::uint32_t& level =
            levels_[canvas_.offset_of({static_cast<int>(counted.x), static_cast<int>(counted.y)})];
        if constexpr (std::is_same_v<std::decay_t<decltype(counted)>, DepthStep>)
            level = is_of_two() ? level_after(level, counted) : level + 1;
        else
            ++level;
    };
    if (kind == StepKind::pixel)
        count(step.as<PixelStep>());
    else
        count(step.as<DepthStep>());
}

void HeatMap::add(const HeatMap& other) {
    steps_ += other.steps_;
    for (std::size_t i = 0; i < levels_.size(); ++i)
        levels_[i] =
            is_of_two() ? std::max(levels_[i], other.levels_[i]) : levels_[i] + other.levels_[i];
}

std::uint32_t HeatMap::most() const {
    if (is_of_two())
        return equal_depths;
    if (!most_)
        most_ = std::max(least(), *std::max_element(levels_.begin(), levels_.end()));
    return *most_;
}

std::string HeatMap::text_of(std::uint32_t number) const {
    return is_of_two() && number == equal_depths ? "=" : std::to_string(number);
}

Color HeatMap::color_of(std::uint32_t number, bool in_grays) const {
    const double range = most() - least();
    const Color color = viridis_at(range > 0 ? (number - least()) / range : 0);
    return in_grays ? gray_of(color) : color;
}

} // namespace rastertrace
