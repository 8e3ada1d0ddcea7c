// SPDX-License-Identifier: MIT
// Any bytes as claims: what is wrong with them is said safely, and claims that can be read can be held against a
// scene, each with one verdict. The input chooses the scene.

#include "check.h"

#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/check/claims.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace rastertrace::fuzz {

namespace {

/// T0's triangle; its cube; lines.
const std::array<Truth, 3>& truths() {
    static const std::array<Truth, 3> all{
        Truth({"triangle.json", R"({"canvas":{"width":17,"height":14},
"vertices":{"A":[2,5],"B":[-4,-3],"C":[5,-3]},"triangles":["ABC"]})"},
              {}),
        Truth({"cube.json", R"({"canvas":{"width":10,"height":10},
"vertices":{"A":[-1,1,3],"B":[1,1,3],"C":[1,-1,3],"D":[-1,-1,3],"E":[-1,1,5]},
"triangles":["ABC","ACD","ADE"],"projection":{"type":"pinhole","distance":1},
"method":{"scalar":"exact","cull":"back","snap":"floor","depth":"inverse-z"}})"},
              {}),
        Truth({"lines.json", R"({"canvas":{"width":17,"height":14},
"vertices":{"O":[0,0],"P":[5,2],"A":[2,5],"B":[-4,-3]},"lines":["OP","AB"]})"},
              {})};
    return all;
}

void check_verdicts(const Truth& truth, const Claims& claims) {
    const Checked checked = rastertrace::check(truth, claims);
    check(checked.claims.size() == claims.claims.size(), "a claim has no verdict");
    check(checked.right + checked.wrong + checked.follow + checked.open + checked.not_understood ==
              claims.claims.size(),
          "the verdicts do not add up");
    for (const CheckedClaim& claim : checked.claims) {
        const bool has_wrong_field =
            std::any_of(claim.fields.begin(), claim.fields.end(), [](const CheckedField& field) {
                return field.verdict == ClaimVerdict::wrong;
            });
        check(has_wrong_field == (claim.verdict == ClaimVerdict::wrong),
              "a claim is wrong without a wrong field, or right with one");
    }
}

} // namespace

} // namespace rastertrace::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace rastertrace;
    const auto claims = read_claims(fuzz::source_of("fuzz.claims", data, size));
    if (!claims) {
        fuzz::check_message(claims.problem());
        return 0;
    }
    const std::size_t choice = std::hash<std::string>()(claims.value().source.text);
    try {
        fuzz::check_verdicts(fuzz::truths()[choice % fuzz::truths().size()], claims.value());
    } catch (const Problem& problem) {
        fuzz::check_message(problem);
    }
    return 0;
}
