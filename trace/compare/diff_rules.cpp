// SPDX-License-Identifier: MIT
#include "diff_rules.h"

#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/text/conventions.h>
#include <rastertrace/trace/text/json_reader.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

constexpr const char* rules_name = "rastertrace-rules.json";

constexpr std::array rules_keys{
    schema_key,
    JsonKey{"ignore", "texts", "What is not compared: header, end, a kind of step, or a field"},
    JsonKey{"tolerance", "texts", "How far apart numbers may be: scanline.left=1e-9, 4ulp"},
    JsonKey{"key", "keys", "Of each kind of one's own: the fields that a step is found by"},
    JsonKey{"only", "texts", "The kinds of step that are compared"},
    JsonKey{"common", "boolean", "Only kinds and fields that both traces have are compared"},
    JsonKey{"any_order", "boolean", "Steps may come in another order"},
    JsonKey{"convention", "convention", "The named set that scenes are drawn by"},
};

class RulesReader {
public:
    explicit RulesReader(const Source& source) : json_{source} {}

    DiffRules read() const {
        auto document = parse_json(json_.source);
        if (!document)
            throw document.problem();
        const JsonValue root = document.value().root();
        if (root.kind != JsonValue::Kind::object)
            json_.fail_expecting(root, R"(rules, like {"ignore": ["header"]})");
        json_.allow_keys(root, rules_keys);
        DiffRules rules;
        rules.options.ignored = texts_in(root, "ignore");
        rules.options.only = texts_in(root, "only");
        rules.options.compares_common = is_true(root, "common");
        rules.options.compares_order = !is_true(root, "any_order");
        for (const JsonValue& one : list_in(root, "tolerance"))
            at(one, [&] { rules.options.tolerances.push_back(parse_tolerance(one.text)); });
        if (const auto keys = root.find("key"))
            for (const auto& [kind, fields] : keys->members())
                at(fields, [&, &kind = kind, &fields = fields] {
                    add_step_key(rules.options,
                                 fmt::format("{}={}", kind.text, joined(text_list(fields), ",")));
                });
        if (const auto convention = root.find("convention")) {
            rules.convention = json_.string_in(*convention, "the name of a convention");
            check_convention(*convention);
        }
        return rules;
    }

private:
    /// Points what `read` finds wrong to a value.
    template <typename Read> void at(const JsonValue& value, const Read& read) const {
        try {
            read();
        } catch (const Problem& problem) {
            json_.fail(value, problem.message, problem.hint);
        }
    }

    bool is_true(const JsonValue& root, std::string_view key) const {
        const auto value = root.find(key);
        if (value && value->kind != JsonValue::Kind::boolean)
            json_.fail_expecting(*value, "true or false");
        return value && value->text == "true";
    }

    std::vector<JsonValue> list_in(const JsonValue& root, std::string_view key) const {
        std::vector<JsonValue> list;
        if (const auto value = root.find(key))
            for (const JsonValue& one : json_.array_in(*value, "a list of texts"))
                list.push_back(one);
        return list;
    }

    std::vector<std::string> text_list(const JsonValue& value) const {
        std::vector<std::string> texts;
        for (const JsonValue& one : json_.array_in(value, "a list of texts"))
            texts.push_back(json_.string_in(one, "a text"));
        return texts;
    }
    std::vector<std::string> texts_in(const JsonValue& root, std::string_view key) const {
        const auto value = root.find(key);
        return value ? text_list(*value) : std::vector<std::string>{};
    }

    void check_convention(const JsonValue& value) const {
        std::vector<std::string_view> names;
        for (const ConventionRow& row : convention_rows())
            names.push_back(row.name);
        if (std::find(names.begin(), names.end(), value.text) == names.end())
            json_.fail_expecting(value, fmt::format("a convention ({})", joined(names, ", ")),
                                 did_you_mean(value.text, names, "\""));
    }

    JsonReader json_;
};

} // namespace

DiffRules read_rules(const std::string& path, const InputLimits& limits) {
    const auto source = read_named_file(path, limits);
    if (!source)
        throw source.problem();
    return RulesReader(source.value()).read();
}

std::optional<DiffRules> rules_beside(const std::string& golden, const InputLimits& limits) {
    const std::filesystem::path path = std::filesystem::path(golden).parent_path() / rules_name;
    std::error_code error;
    if (golden == "-" || !std::filesystem::exists(path, error))
        return std::nullopt;
    return read_rules(path.string(), limits);
}

namespace {

constexpr std::string_view mark_of_golden = ".golden";
constexpr std::string_view mark_of_new = ".golden.new";

/// A file's name in front of its last dot, and the ending from there.
std::pair<std::string, std::string> stem_and_ending(const std::filesystem::path& path) {
    return {path.stem().string(), path.extension().string()};
}

} // namespace

std::vector<std::string> other_goldens(const std::string& golden) {
    const std::filesystem::path path = golden;
    auto [stem, ending] = stem_and_ending(path);
    std::vector<std::string> others;
    if (!stem.ends_with(mark_of_golden))
        return others;
    stem.erase(stem.size() - mark_of_golden.size());
    const std::filesystem::path folder = path.parent_path();
    std::error_code error;
    for (std::filesystem::directory_iterator file(folder.empty() ? "." : folder, error), end;
         !error && file != end; file.increment(error)) {
        const auto [other, other_ending] = stem_and_ending(file->path());
        if (other.starts_with(stem + ".") && other.ends_with(mark_of_golden) &&
            other.size() > stem.size() + 1 + mark_of_golden.size() && other_ending == ending)
            others.push_back((folder / file->path().filename()).string());
    }
    std::sort(others.begin(), others.end());
    return others;
}

std::optional<std::string> golden_of_new_one(const std::string& path) {
    auto [stem, ending] = stem_and_ending(path);
    if (!stem.ends_with(mark_of_new))
        return std::nullopt;
    stem.erase(stem.size() - mark_of_new.size());
    return (std::filesystem::path(path).parent_path() /
            (stem + std::string(mark_of_golden) + ending))
        .string();
}

std::string new_one_of_golden(const std::string& golden) {
    auto [stem, ending] = stem_and_ending(golden);
    if (stem.ends_with(mark_of_golden))
        stem.erase(stem.size() - mark_of_golden.size());
    return (std::filesystem::path(golden).parent_path() /
            (stem + std::string(mark_of_new) + ending))
        .string();
}

DiffOptions joined_options(DiffOptions rules, const DiffOptions& asked) {
    const auto append = [](auto& list, const auto& more) {
        list.insert(list.end(), more.begin(), more.end());
    };
    append(rules.tolerances, asked.tolerances);
    append(rules.ignored, asked.ignored);
    for (const auto& [kind, fields] : asked.keys)
        rules.keys[kind] = fields;
    if (!asked.only.empty())
        rules.only = asked.only;
    rules.compares_order = rules.compares_order && asked.compares_order;
    rules.compares_names = asked.compares_names;
    rules.compares_common = rules.compares_common || asked.compares_common;
    return rules;
}

void add_step_key(DiffOptions& options, const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::string kind = text.substr(0, equals);
    std::vector<std::string> fields;
    if (equals != std::string::npos)
        fields = split_at(text.substr(equals + 1), ',');
    if (kind.empty() || fields.empty() ||
        std::find(fields.begin(), fields.end(), "") != fields.end())
        throw problem_of(
            "", fmt::format("--key: expected KIND=FIELD,..., like tile=tx,ty, found \"{}\"",
                            printable(text)));
    if (step_kind_named(kind))
        throw problem_of("", fmt::format("--key: expected a kind of step of your own, found {}, "
                                         "whose steps are found by fields of their own",
                                         kind));
    options.keys[kind] = std::move(fields);
}

} // namespace rastertrace
