// SPDX-License-Identifier: MIT
#include <rastertrace/numerics/plot_svg.h>

#include <rastertrace/trace/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace rastertrace {

namespace {

// The parts of a plot, in pixels.
constexpr double left = 58; ///< of the area of marks: left of it are the numbers of the y axis
constexpr double top = 34;
constexpr double right = plot_size.width - 14;
constexpr double bottom = plot_size.height - 92; ///< below it are numbers, label and caption
constexpr double shelf_slot = 13;                ///< on the shelf every curve has a column
constexpr double mark_radius = 4;
constexpr double ring_radius = 7;
constexpr double label_size = 9.5;
constexpr double label_advance = 0.58 * label_size; ///< of a character, wide enough for most fonts
constexpr std::size_t caption_width = 78;           ///< in characters

/// How a curve looks.
struct Style {
    std::string_view color;
    std::string_view dashes;
    int shape;
    bool is_filled;
};
constexpr std::array<Style, 12> styles{{{"#000000", "none", 0, true},
                                        {"#b3261e", "7 3", 1, true},
                                        {"#1f5fa8", "2 2", 2, true},
                                        {"#2e7d32", "9 3 2 3", 3, true},
                                        {"#8a4b00", "4 2", 0, false},
                                        {"#6a1b9a", "12 3", 1, false},
                                        {"#00707a", "1 3", 2, false},
                                        {"#9c1f5c", "6 2 1 2 1 2", 3, false},
                                        {"#444444", "3 5", 4, true},
                                        {"#5d6b00", "10 2 2 2", 5, true},
                                        {"#003f8f", "5 5", 6, false},
                                        {"#7a5c00", "2 4", 4, false}}};
const Style& style_of(std::size_t curve) {
    return styles[curve % styles.size()];
}

/// The outline of a mark: circle, square, diamond, triangle, triangle upside down, plus, cross.
std::string mark_svg(const Style& style, double x, double y) {
    const double r = mark_radius;
    const std::string fill(style.is_filled ? style.color : "#ffffff");
    const std::string paint =
        fmt::format(R"(fill="{}" stroke="{}" stroke-width="1.4")", fill, style.color);
    const auto path = [&](std::string_view data) {
        return fmt::format(R"(<path d="{}" {}/>)", data, paint);
    };
    switch (style.shape) {
    case 0:
        return fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" {}/>)", x, y, r - 0.4,
                           paint);
    case 1:
        return fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" {}/>)",
                           x - r + 0.7, y - r + 0.7, 2 * r - 1.4, 2 * r - 1.4, paint);
    case 2:
        return path(fmt::format("M{:.1f} {:.1f}l{:.1f} {:.1f}l{:.1f} {:.1f}l{:.1f} {:.1f}Z", x,
                                y - r - 0.8, r + 0.8, r + 0.8, -r - 0.8, r + 0.8, -r - 0.8,
                                -r - 0.8));
    case 3:
        return path(fmt::format("M{:.1f} {:.1f}l{:.1f} {:.1f}h{:.1f}Z", x, y - r - 0.5, r + 0.5,
                                2 * r, -2 * r - 1));
    case 4:
        return path(fmt::format("M{:.1f} {:.1f}l{:.1f} {:.1f}h{:.1f}Z", x, y + r + 0.5, r + 0.5,
                                -2 * r, -2 * r - 1));
    case 5:
        return path(fmt::format("M{:.1f} {:.1f}h{:.1f}M{:.1f} {:.1f}v{:.1f}", x - r, y, 2 * r, x,
                                y - r, 2 * r));
    default:
        return path(fmt::format("M{:.1f} {:.1f}l{:.1f} {:.1f}M{:.1f} {:.1f}l{:.1f} {:.1f}", x - r,
                                y - r, 2 * r, 2 * r, x - r, y + r, 2 * r, -2 * r));
    }
}

/// A logarithmic axis: from values to pixels.
struct LogAxis {
    double low = 0.1;
    double high = 1;
    double from = 0; ///< the pixel of `low`
    double to = 1;

    double at(double value) const {
        const double share = std::log10(value / low) / std::log10(high / low);
        return from + share * (to - from);
    }

    /// Values worth a line: powers of ten, and where there are few of these 2 and 5 of each too.
    std::vector<double> ticks() const {
        const auto first = static_cast<int>(std::floor(std::log10(low)));
        const auto last = static_cast<int>(std::ceil(std::log10(high)));
        constexpr int most = 9;
        const int stride = std::max(1, (last - first + most - 1) / most);
        std::vector<double> result;
        for (int power = first; power <= last; ++power)
            for (const double digit : {1.0, 2.0, 5.0}) {
                if ((digit != 1 && last - first > 3) || power % stride != 0)
                    continue;
                const double value = digit * std::pow(10, power);
                if (low <= value && value <= high)
                    result.push_back(value);
            }
        return result;
    }
};

/// "0.02", "500", "10^-7" with a raised exponent.
std::string tick_text(double value) {
    if (value >= 0.009 && value < 99'999)
        return fmt::format("{:g}", value);
    const auto power = static_cast<int>(std::floor(std::log10(value) + 1e-9));
    const double digit = std::round(value / std::pow(10, power));
    return fmt::format(R"({}10<tspan dy="-4" font-size="8">{}</tspan>)",
                       digit == 1 ? "" : fmt::format("{:g}x", digit), power);
}

/// A rectangle that is taken.
struct Box {
    double x0, y0, x1, y1;
    bool meets(const Box& other) const {
        return x0 < other.x1 && other.x0 < x1 && y0 < other.y1 && other.y0 < y1;
    }
};

class PlotWriter {
public:
    explicit PlotWriter(const Plot& plot) : plot_(plot) { find_axes(); }

    std::string written() {
        write_frame();
        for (std::size_t i = 0; i < plot_.curves.size(); ++i)
            write_line(i);
        for (std::size_t i = 0; i < plot_.curves.size(); ++i)
            write_marks(i);
        for (std::size_t i = 0; i < plot_.curves.size(); ++i)
            write_labels(i);
        write_caption();
        return std::move(svg_);
    }

private:
    template <typename... Arguments>
    void put(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        svg_ += fmt::format(format, std::forward<Arguments>(arguments)...);
        svg_ += '\n';
    }

    void find_axes() {
        double largest_x = 0;
        double smallest_x = 0;
        double largest_y = 0;
        double smallest_y = 0;
        const auto widen = [](double value, double& smallest, double& largest) {
            smallest = smallest == 0 ? value : std::min(smallest, value);
            largest = std::max(largest, value);
        };
        for (const PlotCurve& curve : plot_.curves)
            for (const PlotMark& mark : curve.marks) {
                if (mark.x > 0)
                    widen(mark.x, smallest_x, largest_x);
                if (mark.y > 0)
                    widen(mark.y, smallest_y, largest_y);
            }
        has_errors_ = largest_x > 0;
        shelf_right_ = left + shelf_slot * (static_cast<double>(plot_.curves.size()) + 1);
        // A little room around the marks.
        x_ = {.low = has_errors_ ? smallest_x / 2 : 0.1,
              .high = has_errors_ ? largest_x * 3 : 1,
              .from = shelf_right_ + 14,
              .to = right};
        y_ = {.low = largest_y > 0 ? smallest_y / 1.5 : 0.1,
              .high = largest_y > 0 ? largest_y * 1.5 : 1,
              .from = bottom,
              .to = top};
    }

    double x_of(std::size_t curve, const PlotMark& mark) const {
        return mark.x > 0 ? x_.at(mark.x) : left + shelf_slot * (static_cast<double>(curve) + 1);
    }
    double y_of(const PlotMark& mark) const { return y_.at(mark.y); }

    void write_frame() {
        put(R"(<text x="{}" y="18" font-size="12" font-weight="bold">{}</text>)", left,
            escaped(plot_.title));
        put(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="#eeeeee"/>)", left,
            top, shelf_right_ - left, bottom - top);
        for (const double value : y_.ticks()) {
            const double y = y_.at(value);
            put(R"(<path d="M{:.1f} {:.1f}H{:.1f}" stroke="#cccccc" stroke-width="0.7"/>)", left, y,
                right);
            put(R"(<text x="{:.1f}" y="{:.1f}" font-size="10" text-anchor="end">{}</text>)",
                left - 5, y + 3.5, tick_text(value));
        }
        if (has_errors_)
            for (const double value : x_.ticks()) {
                const double x = x_.at(value);
                put(R"(<path d="M{:.1f} {:.1f}V{:.1f}" stroke="#cccccc" stroke-width="0.7"/>)", x,
                    top, bottom);
                put(R"(<text x="{:.1f}" y="{:.1f}" font-size="10" text-anchor="middle">{}</text>)",
                    x, bottom + 15, tick_text(value));
            }
        else
            put(R"(<text x="{:.1f}" y="{:.1f}" font-size="11" text-anchor="middle">{}</text>)",
                (shelf_right_ + right) / 2, (top + bottom) / 2, "no method has an error here");
        put(R"(<text x="{:.1f}" y="{:.1f}" font-size="12" font-weight="bold" text-anchor="middle">0</text>)",
            (left + shelf_right_) / 2, bottom + 15);
        put(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="none" stroke="#000000"/>)",
            left, top, right - left, bottom - top);
        put(R"(<path d="M{:.1f} {:.1f}V{:.1f}" stroke="#000000"/>)", shelf_right_, top, bottom);
        put(R"(<text x="{:.1f}" y="{:.1f}" font-size="11" text-anchor="middle">{}</text>)",
            (left + right) / 2, bottom + 32, escaped(plot_.x_label));
        put(R"svg(<text transform="translate(14 {:.1f}) rotate(-90)" font-size="11" text-anchor="middle">{}</text>)svg",
            (top + bottom) / 2, escaped(plot_.y_label));
    }

    void write_line(std::size_t curve) {
        const auto& marks = plot_.curves[curve].marks;
        if (marks.size() < 2)
            return;
        std::string data;
        for (const PlotMark& mark : marks)
            data += fmt::format("{}{:.1f} {:.1f}", data.empty() ? "M" : "L", x_of(curve, mark),
                                y_of(mark));
        const Style& style = style_of(curve);
        put(R"(<path d="{}" fill="none" stroke="{}" stroke-width="1.2" stroke-dasharray="{}"/>)",
            data, style.color, style.dashes);
    }

    void write_marks(std::size_t curve) {
        for (const PlotMark& mark : plot_.curves[curve].marks) {
            const double x = x_of(curve, mark);
            const double y = y_of(mark);
            const double r = mark.is_on_front ? ring_radius : mark_radius;
            taken_.push_back({x - r, y - r, x + r, y + r});
            if (mark.is_on_front)
                put(R"(<circle class="front" cx="{:.1f}" cy="{:.1f}" r="{:.1f}" fill="none" stroke="#000000" stroke-width="1"/>)",
                    x, y, ring_radius);
            put("{}", mark_svg(style_of(curve), x, y));
        }
    }

    /// Beside each mark, where there is room; a label that would lie on something is left out.
    void write_labels(std::size_t curve) {
        for (const PlotMark& mark : plot_.curves[curve].marks) {
            const double x = x_of(curve, mark);
            const double y = y_of(mark);
            const double width = label_advance * static_cast<double>(columns_in(mark.label)) + 1;
            const double height = label_size;
            const double away = mark.is_on_front ? ring_radius + 1 : mark_radius + 2;
            struct Place {
                double x0, y0; ///< the upper left corner of the label
            };
            const std::array<Place, 8> places{{{x + away, y - height / 2},
                                               {x - width / 2, y - away - height},
                                               {x - width / 2, y + away},
                                               {x - away - width, y - height / 2},
                                               {x + away - 2, y - away - height + 3},
                                               {x + away - 2, y + away - 3},
                                               {x - away - width + 2, y - away - height + 3},
                                               {x - away - width + 2, y + away - 3}}};
            // Rather within its part of the plot than across the edge of the shelf.
            const auto is_free = [&](const Box& box, bool may_cross) {
                return box.x0 > left && box.x1 < right && box.y0 > top && box.y1 < bottom &&
                       (may_cross || box.x1 < shelf_right_ || shelf_right_ < box.x0) &&
                       std::none_of(taken_.begin(), taken_.end(),
                                    [&box](const Box& other) { return box.meets(other); });
            };
            std::optional<Box> found;
            for (const bool may_cross : {false, true})
                for (const Place& place : places) {
                    const Box box{place.x0, place.y0, place.x0 + width, place.y0 + height};
                    if (!found && is_free(box, may_cross))
                        found = box;
                }
            if (!found)
                continue;
            taken_.push_back(*found);
            // A white rim lifts it off the lines that it lies on.
            put(R"(<text x="{:.1f}" y="{:.1f}" font-size="{}" fill="{}" stroke="#ffffff" stroke-width="2.5" paint-order="stroke">{}</text>)",
                found->x0, found->y1 - 2, label_size, style_of(curve).color, escaped(mark.label));
        }
    }

    void write_caption() {
        double y = bottom + 49;
        for (const std::string& line : wrapped(plot_.caption, caption_width)) {
            put(R"(<text x="{:.1f}" y="{:.1f}" font-size="10" font-style="italic">{}</text>)",
                left - 40, y, escaped(line));
            y += 12.5;
        }
    }

    const Plot& plot_;
    LogAxis x_;
    LogAxis y_;
    double shelf_right_ = left;
    bool has_errors_ = false;
    std::vector<Box> taken_;
    std::string svg_;
};

} // namespace

std::string plot_svg(const Plot& plot) {
    return PlotWriter(plot).written();
}

std::string legend_svg(const std::vector<PlotCurve>& curves) {
    std::string svg;
    double y = top + 8;
    for (std::size_t i = 0; i < curves.size(); ++i, y += 20) {
        const Style& style = style_of(i);
        svg += fmt::format(
            R"(<path d="M8 {0:.1f}H48" stroke="{1}" stroke-width="1.2" stroke-dasharray="{2}"/>)",
            y, style.color, style.dashes);
        svg += mark_svg(style, 28, y);
        svg += text_svg(56, y + 4, 11, curves[i].name);
    }
    svg += fmt::format(R"(<circle cx="28" cy="{:.1f}" r="{:.1f}" fill="none" stroke="#000000"/>)",
                       y, ring_radius);
    svg += text_svg(56, y + 4, 11, "on the Pareto front");
    svg +=
        fmt::format(R"(<rect x="20" y="{:.1f}" width="16" height="12" fill="#eeeeee"/>)", y + 14);
    svg += text_svg(56, y + 24, 11, "the 0 shelf: no error at all");
    return svg;
}

std::string moved_svg(double x, double y, std::string_view group) {
    return fmt::format("<g transform=\"translate({:.1f} {:.1f})\">\n{}\n</g>\n", x, y, group);
}

std::string text_svg(double x, double y, double size, std::string_view text) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\">{}</text>\n", x, y, size,
                       escaped(text));
}

std::string svg_document(const SvgSize& size, std::string_view title, std::string_view body) {
    return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" "
                       "height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
                       "font-family=\"DejaVu Sans, Verdana, sans-serif\">\n"
                       "<title>{2}</title>\n"
                       "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#ffffff\"/>\n{3}</svg>\n",
                       size.width, size.height, escaped(title), body);
}

} // namespace rastertrace
