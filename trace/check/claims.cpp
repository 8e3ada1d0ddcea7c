// SPDX-License-Identifier: MIT
// Claims files: which layout a file has, and the one in JSON.

#include "claims.h"

#include "claim_fields.h"
#include "claims_keys.h"
#include "claims_table.h"

#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/text/byte_order_mark.h>
#include <rastertrace/trace/text/json_document.h>
#include <rastertrace/trace/text/json_reader.h>
#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/trace_layout.h>
#include <rastertrace/trace/text/zero_byte.h>

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace rastertrace {

namespace {

/// What begins behind the blanks, or 0.
char first_character(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks_and_mark);
    return first == std::string_view::npos ? '\0' : text[first];
}

} // namespace

std::string in_one_line(std::string_view text) {
    std::string line;
    for (const std::string& part : split_at(text, '\n')) {
        const std::size_t first = std::min(part.find_first_not_of(blanks_and_mark), part.size());
        const std::size_t end = part.find_last_not_of(blanks_and_mark) + 1;
        if (first < end)
            line += (line.empty() ? "" : " ") + part.substr(first, end - first);
    }
    return line;
}

namespace {

/// Reads claims in JSON. What is wrong is thrown as a Problem.
class JsonClaimsReader {
public:
    explicit JsonClaimsReader(Claims& claims) : claims_(claims), json_{claims.source} {}

    void read() {
        const JsonDocument document = document_of(claims_.source);
        const JsonValue root = document.root();
        refuse_other_files(root);
        json_.allow_keys(root, claims_keys);
        if (const auto scene = root.find("scene")) {
            claims_.scene = json_.string_in(*scene, "the name of a scene file");
            claims_.scene_offset = scene->begin;
        }
        if (const auto round = root.find("round"))
            claims_.only_rounds = only_rounds(*round);
        for (const JsonValue& claim :
             json_.array_in(json_.member(root, "claims"), "a list of claims"))
            read_claim(claim);
    }

private:
    static JsonDocument document_of(const Source& source) {
        auto document = parse_json(source);
        if (!document)
            throw document.problem();
        return std::move(document.value());
    }

    /// A scene and a trace are JSON too.
    void refuse_other_files(const JsonValue& root) const {
        if (root.kind == JsonValue::Kind::object && root.find("claims"))
            return;
        const std::string_view found = is_trace(claims_.source)                       ? "a trace"
                                       : root.find("vertices") || root.find("canvas") ? "a scene"
                                                                                      : "none";
        json_.fail(root, fmt::format("expected claims, found {}", found),
                   found == "none" ? R"(claims are a table, or {"claims": [...]})"
                                   : "claims come behind the scene: check SCENE CLAIMS");
    }

    bool only_rounds(const JsonValue& round) const {
        const std::vector<std::string_view> known(round_words.begin(), round_words.end());
        if (std::find(known.begin(), known.end(), round.text) == known.end())
            json_.fail_expecting(round, R"("nearest" or "truncate")",
                                 did_you_mean(round.text, known, "\""));
        return round.text == "nearest";
    }

    /// The number of the line that a claim begins in; claims are read in their order.
    std::size_t line_of(std::size_t offset) {
        const auto at = claims_.source.text.begin();
        line_ +=
            static_cast<std::size_t>(std::count(at + static_cast<std::ptrdiff_t>(counted_to_),
                                                at + static_cast<std::ptrdiff_t>(offset), '\n'));
        counted_to_ = offset;
        return line_;
    }

    void read_claim(const JsonValue& value) {
        if (value.kind != JsonValue::Kind::object)
            json_.fail_expecting(value, R"(a claim, like {"step": "scanline", "y": 2, "left": 1})");
        Claim claim{.line = line_of(value.begin),
                    .offset = value.begin,
                    .text = in_one_line(std::string_view(claims_.source.text)
                                            .substr(value.begin, value.end() - value.begin)),
                    .step = {},
                    .fields = {},
                    .picture = {}};
        if (const auto picture = value.find("picture")) {
            json_.allow_keys(value, picture_keys);
            claim.step = "picture";
            read_picture(*picture, claim);
        } else {
            read_step(value, claim);
        }
        claims_.claims.push_back(std::move(claim));
    }

    void read_picture(const JsonValue& picture, Claim& claim) const {
        for (const JsonValue& row : json_.array_in(picture, "the rows of a picture")) {
            claim.picture.push_back(json_.string_in(row, "a row of a picture"));
            if (const auto fault = fault_in_last_row(claim.picture))
                json_.fail(row, *fault);
        }
        if (claim.picture.empty())
            json_.fail_expecting(picture, "the rows of a picture");
    }

    void read_step(const JsonValue& value, Claim& claim) const {
        const JsonValue step = json_.member(value, "step");
        const auto known = claim_kinds();
        if (std::find(known.begin(), known.end(), step.text) == known.end())
            json_.fail_expecting(step, fmt::format("a kind of step ({})", joined(known, ", ")),
                                 did_you_mean(step.text, known, "\""));
        claim.step = step.text;
        const auto fields = claim_fields_of(*step_kind_named(step.text));
        bool has_claimed = false;
        for (const auto& [key, member] : value.members()) {
            if (key.text == "step")
                continue;
            const ClaimField& field = field_for(key, member, claim.step, fields);
            has_claimed = has_claimed || !field.is_key;
            claim.fields.push_back({.name = key.text,
                                    .values = values_in(member, field),
                                    .is_list = field.is_list,
                                    .offset = member.begin});
        }
        if (!has_claimed)
            json_.fail(value, fmt::format("expected what is claimed of the {}, found only which "
                                          "one it is",
                                          claim.step));
    }

    /// The field of a name; of two with that name, the list takes lists.
    const ClaimField& field_for(const JsonValue& key, const JsonValue& value,
                                const std::string& step,
                                const std::vector<ClaimField>& fields) const {
        const ClaimField* found = nullptr;
        std::vector<std::string_view> known;
        for (const ClaimField& field : fields) {
            if (field.name == key.text &&
                (!found || field.is_list == (value.kind == JsonValue::Kind::array)))
                found = &field;
            known.push_back(field.name);
        }
        if (!found)
            json_.fail_expecting(key, fmt::format("a field of {} ({})", step, joined(known, ", ")),
                                 did_you_mean(key.text, known, "\""));
        return *found;
    }

    static bool is_open(const JsonValue& value) {
        return value.kind == JsonValue::Kind::null || value.text == open_value;
    }

    std::vector<std::string> values_in(const JsonValue& value, const ClaimField& field) const {
        const bool is_array = value.kind == JsonValue::Kind::array;
        if (is_array != field.is_list && !is_open(value))
            json_.fail_expecting(
                value,
                fmt::format("{} for {}", field.is_list ? "a list" : "one value", field.name));
        std::vector<std::string> values;
        if (is_array)
            add_elements(value, field, values);
        else
            add_value(value, field, values);
        return values;
    }

    /// The elements of a list, or of the lists in it.
    void add_elements(const JsonValue& list, const ClaimField& field,
                      std::vector<std::string>& values) const {
        for (const JsonValue& element : list.elements())
            if (element.kind == JsonValue::Kind::array)
                add_elements(element, field, values);
            else
                add_value(element, field, values);
        if (list.elements().empty())
            json_.fail_expecting(list, fmt::format("values for {}", field.name));
    }

    void add_value(const JsonValue& value, const ClaimField& field,
                   std::vector<std::string>& values) const {
        const std::string text = is_open(value) ? std::string(open_value) : value.text;
        if (text.empty()) // an object, or ""
            json_.fail_expecting(value, fmt::format("a value for {}", field.name));
        if (const auto expected = expected_instead(field, text))
            json_.fail_expecting(value, *expected);
        values.push_back(text);
    }

    Claims& claims_;
    JsonReader json_;
    std::size_t line_ = 1;
    std::size_t counted_to_ = 0; ///< offset up to which lines have been counted
};

} // namespace

const ClaimedField* Claim::find(std::string_view field) const {
    const auto found =
        std::find_if(fields.begin(), fields.end(),
                     [field](const ClaimedField& claimed) { return claimed.name == field; });
    return found == fields.end() ? nullptr : &*found;
}

std::optional<Problem> Claims::problem() const {
    std::vector<Problem> problems;
    for (const Claim& claim : claims)
        if (claim.problem)
            problems.push_back(*claim.problem);
    return problems.empty() ? std::nullopt : std::optional(first_of(std::move(problems)));
}

Result<Claims> read_claims(Source source) {
    Claims claims{.source = std::move(source), .scene = {}, .claims = {}};
    try {
        if (const auto problem = zero_byte_in(claims.source))
            return *problem;
        const char first = first_character(claims.source.text);
        claims.is_table = first != '{' && first != '[';
        if (claims.is_table)
            read_claims_table(claims);
        else
            JsonClaimsReader(claims).read();
    } catch (const Problem& problem) {
        return problem;
    }
    const auto is_understood = [](const Claim& claim) { return !claim.problem; };
    if (!claims.claims.empty() &&
        std::none_of(claims.claims.begin(), claims.claims.end(), is_understood)) {
        constexpr std::size_t most_told = 3;
        if (claims.claims.size() > most_told)
            claims.claims.resize(1); // it is something else
        return *claims.problem();
    }
    return claims;
}

bool is_claims(const Source& source) {
    const char first = first_character(source.view());
    if (first != '{')
        return first != '[' && first != '\0' && !is_foreign_scene(source);
    if (is_trace(source))
        return false;
    std::string_view document = source.view();
    document.remove_prefix(document.find('{'));
    JsonScanner fields(document);
    while (fields.next_field())
        if (fields.key() == "claims")
            return true;
    return false;
}

} // namespace rastertrace
