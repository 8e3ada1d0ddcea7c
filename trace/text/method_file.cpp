// SPDX-License-Identifier: MIT
#include "method_file.h"

#include "text.h"

#include <string_view>
#include <vector>

namespace rastertrace {

std::string choice_in(const JsonReader& json, const MethodKey& key, const JsonValue& value) {
    const bool is_word = value.kind == JsonValue::Kind::string ||
                         (value.kind == JsonValue::Kind::number && key.is_number());
    if (Method scratch; !is_word || !key.set(scratch, value.text))
        json.fail_expecting(value, key.expected(), did_you_mean(value.text, key.values, "\""));
    return std::string(value.text);
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
