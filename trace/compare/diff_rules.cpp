// SPDX-License-Identifier: MIT
#include "diff_rules.h"

#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/text/json_reader.h>
#include <rastertrace/trace/text/method_file.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

constexpr std::array rules_keys{
    schema_key,
    JsonKey{"ignore", "texts", "What is not compared: header, end, a kind of step, or a field"},
    JsonKey{"tolerance", "texts", "How far apart numbers may be: scanline.left=1e-9, 4ulp"},
    JsonKey{"key", "keys", "Of each kind of one's own: the fields that a step is found by"},
    JsonKey{"only", "texts", "The kinds of step that are compared"},
    JsonKey{"common", "boolean", "Only kinds and fields that both traces have are compared"},
    JsonKey{"any_order", "boolean", "Steps may come in another order"},
    JsonKey{"method", "text", "The file with the method that scenes are drawn by"},
    JsonKey{"convention", "convention", "The named set that scenes are drawn by"},
};

class RulesReader {
public:
    explicit RulesReader(const Source& source) : json_{source} {}

    DiffRules read(const InputLimits& limits) const {
        auto document = parse_json(json_.source);
        if (!document)
            throw document.problem();
        const JsonValue root = document.value().root();
        if (root.kind != JsonValue::Kind::object)
            json_.fail_expecting(root, R"(rules, like {"ignore": ["header"]})");
        json_.allow_keys(root, rules_keys);
        DiffRules rules;
        rules.options.ignored = texts_in(root.find("ignore"));
        rules.options.only = texts_in(root.find("only"));
        rules.options.compares_common = is_true(root, "common");
        rules.options.compares_order = !is_true(root, "any_order");
        if (const auto tolerances = root.find("tolerance"))
            for (const JsonValue& one : json_.array_in(*tolerances, "a list of texts"))
                at(one, [&] { rules.options.tolerances.push_back(parse_tolerance(one.text)); });
        if (const auto keys = root.find("key"))
            for (const auto& [kind, fields] : keys->members())
                at(fields, [&, &kind = kind, &fields = fields] {
                    add_step_key(rules.options,
                                 fmt::format("{}={}", kind.text, joined(texts_in(fields), ",")));
                });
        if (const auto method = root.find("method"))
            rules.method =
                read_method_file((std::filesystem::path(json_.source.name).parent_path() /
                                  json_.string_in(*method, "the name of a file with a method"))
                                     .string(),
                                 limits);
        if (const auto convention = root.find("convention"))
            rules.method.emplace_back(
                "convention", choice_in(json_, *find_method_key("convention"), *convention));
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

    std::vector<std::string> texts_in(const std::optional<JsonValue>& value) const {
        std::vector<std::string> texts;
        if (value)
            for (const JsonValue& one : json_.array_in(*value, "a list of texts"))
                texts.push_back(json_.string_in(one, "a text"));
        return texts;
    }

    JsonReader json_;
};

} // namespace

DiffRules read_rules(const std::string& path, const InputLimits& limits) {
    const auto source = read_named_file(path, limits);
    if (!source)
        throw source.problem();
    return RulesReader(source.value()).read(limits);
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

} // namespace

std::vector<std::string> other_goldens(const std::string& golden) {
    const std::filesystem::path path = golden;
    std::string front = path.stem().string();
    std::vector<std::string> others;
    if (!front.ends_with(mark_of_golden))
        return others;
    front.resize(front.size() - mark_of_golden.size() + 1); // to the point
    const std::string end = std::string(mark_of_golden) + path.extension().string();
    const std::filesystem::path folder = path.parent_path();
    std::error_code error;
    for (std::filesystem::directory_iterator file(folder.empty() ? "." : folder, error), behind;
         !error && file != behind; file.increment(error)) {
        const std::string other = file->path().filename().string();
        if (other.starts_with(front) && other.ends_with(end) &&
            other.size() > front.size() + end.size())
            others.push_back((folder / other).string());
    }
    std::sort(others.begin(), others.end());
    return others;
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
