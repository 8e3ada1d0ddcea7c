// SPDX-License-Identifier: MIT
#pragma once

// The stress catalogue: stiff and extreme cases, each with what must hold and what is documented to
// fail, put through every scalar and every method in question. A stiff case is ordinary input in
// which two scales meet inside one primitive; an extreme one lies at or past the edge of what can be
// represented or is defined.
//
//     for (const StressCase& one : stress_cases())
//         for (const StressRow& row : rows_of(one))
//             if (!is_as_documented(row)) ...
//
// What a row is compared with is exact: a reference that is written apart from the fills
// (reference.h), or a number that exact arithmetic gives. What IEEE arithmetic does wrong is
// documented by its count and must be wrong by just that.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// How a result stands to the exact one.
enum class Verdict {
    right,  ///< the same
    within, ///< every decision the same, numbers off by rounding, no more than the stated bound
    wrong,
    refused, ///< no result: a message says why
};

std::string_view name_of(Verdict verdict);

/// What was found.
struct Measured {
    std::uint64_t wrong = 0;     ///< pixels, rows, values that are not the exact ones
    std::string unit = {};       ///< of `wrong`, in the singular; empty: the note says it all
    double worst = 0;            ///< the largest error
    std::string worst_unit = {}; ///< of `worst`; empty: no size of the error is measured
    bool is_refused = false;     ///< then `note` is the message
    std::string note = {};       ///< what else there is to say
};

/// What is documented to be found.
struct Documented {
    Verdict verdict = Verdict::right;
    std::uint64_t wrong = 0; ///< Verdict::wrong: exactly so many
    std::string worst = {};  ///< Verdict::wrong: the largest error, to the digits written; "" if
                             ///< it is not documented
    double bound = 0;        ///< Verdict::within: the largest error is at most this
    std::string note = {};   ///< the note holds this, whatever the verdict
};

/// One scalar and one method, and how they did.
struct StressRow {
    std::string
        scalar; ///< a value of the method's key `scalar`, or the C++ type of a textbook's loop
    std::string method;
    Measured measured;
    Documented documented;
};

Verdict verdict_of(const StressRow& row);
bool is_as_documented(const StressRow& row);

/// How wrong a wrong row is: "590 rows wrong, at most 0.024 px".
std::string described_error(const StressRow& row);
/// What was found, in words: "590 rows wrong, at most 0.024 px; of 3001, first at y=3".
std::string described(const StressRow& row);
/// What is documented, in words.
std::string described(const Documented& documented, const Measured& measured);

struct StressOptions {
    bool quick = false; ///< every case, but the longest trace with one scalar only
};

/// A scene to draw, as a file would have it.
struct StressScene {
    std::string name; ///< "" if the case has only one
    std::string json;
};

/// One entry of the catalogue, whose rows and scenes are in its table (stress/cases.json).
struct StressCase {
    std::string id;    ///< L1, S4, ...
    std::string title; ///< at most 40 characters
    std::string input;
    std::string why;       ///< it is stiff or extreme
    std::string holds;     ///< what must hold, and what is documented not to
    std::size_t place = 0; ///< in the table

    /// None: the case is a computation.
    std::vector<StressScene> scenes() const;
};

/// The families of the catalogue by the first letter of their cases' ids: "lines", ...
std::string_view family_of(const StressCase& one);

/// All cases, in the order of the catalogue.
std::span<const StressCase> stress_cases();

/// The case with this id, in any case of letters; nullptr if there is none.
const StressCase* find_stress_case(std::string_view id);

/// Runs a case.
std::vector<StressRow> rows_of(const StressCase& one, const StressOptions& options = {});

} // namespace rastertrace
