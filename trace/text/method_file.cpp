// SPDX-License-Identifier: MIT
#include "method_file.h"

#include "text.h"

#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

/// A word, or the elements of an array with spaces between.
std::string words_of(const JsonValue& value) {
    if (value.kind != JsonValue::Kind::array)
        return value.text;
    std::vector<std::string> words;
    for (const JsonValue& element : value.elements())
        words.push_back(element.text);
    return joined(words, " ");
}

} // namespace

std::string choice_in(const JsonReader& json, const MethodKey& key, const JsonValue& value) {
    const bool is_word = value.kind == JsonValue::Kind::string ||
                         (value.kind == JsonValue::Kind::number && key.takes_number()) ||
                         (value.kind == JsonValue::Kind::array && !key.more.empty());
    std::string words = is_word ? words_of(value) : "";
    if (Method scratch; !is_word || !key.set(scratch, words))
        json.fail_expecting(value, key.expected(), did_you_mean(value.text, key.values, "\""));
    return words;
}

MethodOverrides method_in(const Source& file) {
    const JsonReader json{file};
    const auto document = parse_json(json.source);
    if (!document)
        throw document.problem();
    std::vector<std::string_view> keys;
    for (const MethodKey& key : method_keys())
        keys.push_back(key.name);
    const JsonValue root = document.value().root();
    if (const auto method = root.find("method"); method)
        json.fail(*method, "expected the choices alone, found the \"method\" of a scene",
                  "a method file is what stands behind \"method\", like {\"fill\": \"top-left\"}");
    json.allow_keys(root, keys);
    MethodOverrides method;
    for (const auto& [name, value] : root.members())
        method.emplace_back(name.text, choice_in(json, *find_method_key(name.text), value));
    return method;
}

MethodOverrides read_method_file(const std::string& path, const InputLimits& limits) {
    const auto source = read_named_file(path, limits);
    if (!source)
        throw source.problem();
    return method_in(source.value());
}

} // namespace rastertrace
