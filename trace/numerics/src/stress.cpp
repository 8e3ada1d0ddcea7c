// SPDX-License-Identifier: MIT
#include <rastertrace/numerics/stress.h>

#include "stress_rows.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <utility>

namespace rastertrace {

namespace {

/// How many digits a number has that count: 2 for 0.024, 4 for 1675, 2 for 4.4e-11; 2 if nothing is
/// written.
int significant_digits(std::string_view number) {
    if (number.empty())
        return 2;
    int digits = 0;
    for (const char c : number.substr(0, number.find('e')))
        if (std::isdigit(static_cast<unsigned char>(c)) != 0 && (c != '0' || digits > 0))
            ++digits;
    return std::max(digits, 1);
}

/// `value` written with as many digits as `like`, and read back.
bool reads_as(double value, std::string_view like) {
    return number_in<double>(fmt::format("{:.{}g}", value, significant_digits(like))) ==
           number_in<double>(like);
}

} // namespace

std::string_view name_of(Verdict verdict) {
    switch (verdict) {
    case Verdict::right:
        return "right";
    case Verdict::within:
        return "within";
    case Verdict::wrong:
        return "wrong";
    case Verdict::refused:
        break;
    }
    return "refused";
}

Verdict verdict_of(const StressRow& row) {
    const auto& [scalar, method, measured, documented] = row;
    if (measured.is_refused)
        return Verdict::refused;
    if (measured.wrong == 0 && measured.worst == 0)
        return Verdict::right;
    // A number that is not one, nan, is within nothing.
    return measured.wrong == 0 && measured.worst <= documented.bound ? Verdict::within
                                                                     : Verdict::wrong;
}

bool is_as_documented(const StressRow& row) {
    const auto& [scalar, method, measured, documented] = row;
    const Verdict verdict = verdict_of(row);
    // Better than its bound is as documented.
    const bool is_better = verdict == Verdict::right && documented.verdict == Verdict::within;
    if (verdict != documented.verdict && !is_better)
        return false;
    if (verdict == Verdict::wrong &&
        (measured.wrong != documented.wrong ||
         (!documented.worst.empty() && !reads_as(measured.worst, documented.worst))))
        return false;
    return measured.note.find(documented.note) != std::string::npos;
}

std::string described_error(const StressRow& row) {
    const Measured& measured = row.measured;
    std::string text;
    if (measured.wrong > 0 && !measured.unit.empty())
        text = counted(measured.wrong, measured.unit) + " wrong";
    if (!measured.worst_unit.empty())
        text += fmt::format("{}at most {:.{}g} {}", text.empty() ? "" : ", ", measured.worst,
                            significant_digits(row.documented.worst), measured.worst_unit);
    return text;
}

std::string described(const StressRow& row) {
    const Measured& measured = row.measured;
    std::string text;
    if (verdict_of(row) == Verdict::within)
        text = fmt::format("off by at most {:.2g} {}", measured.worst, measured.worst_unit);
    if (verdict_of(row) == Verdict::wrong)
        text = described_error(row);
    return text + (text.empty() || measured.note.empty() ? "" : "; ") + measured.note;
}

std::string described(const Documented& documented, const Measured& measured) {
    switch (documented.verdict) {
    case Verdict::right:
        return documented.note.empty() ? "right" : fmt::format("right: {}", documented.note);
    case Verdict::refused:
        return fmt::format("refused: ... {} ...", documented.note);
    case Verdict::within:
        return fmt::format("within {:.2g} {}", documented.bound, measured.worst_unit);
    case Verdict::wrong:
        break;
    }
    std::string text = counted(documented.wrong, measured.unit) + " wrong";
    if (!documented.worst.empty())
        text += fmt::format(", at most {} {}", documented.worst, measured.worst_unit);
    return text;
}

std::string_view family_of(const StressCase& one) {
    constexpr std::array<std::pair<char, std::string_view>, 6> families{{{'L', "lines"},
                                                                         {'S', "scanline fill"},
                                                                         {'C', "edge functions"},
                                                                         {'Z', "depth"},
                                                                         {'P', "pipeline"},
                                                                         {'X', "stages left out"}}};
    for (const auto& [letter, name] : families)
        if (one.id.front() == letter)
            return name;
    return {};
}

const StressCase* find_stress_case(std::string_view id) {
    std::string upper;
    std::transform(id.begin(), id.end(), std::back_inserter(upper),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    for (const StressCase& one : stress_cases())
        if (one.id == upper)
            return &one;
    return nullptr;
}

} // namespace rastertrace
