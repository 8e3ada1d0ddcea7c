// SPDX-License-Identifier: MIT
#pragma once

// JSON that commands print: a value is its text, made of values of C++. Values of a trace stand in it as they do there,
// 1e+05 and all, which the values of a library would not keep.
//
//     JsonText pixel{{"at", Pixel{3, 2}}, {"owner", nullptr}};
//     pixel.add("is_told", true);
//     print(pixel.line());  // {"at":[3,2],"owner":null,"is_told":true}

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

class JsonText {
public:
    struct Member;

    JsonText(std::initializer_list<Member> members); ///< an object
    JsonText(std::nullptr_t) : text_("null") {}
    JsonText(const char* text) : text_(json_quoted(text)) {}
    JsonText(std::string_view text) : text_(json_quoted(text)) {}
    JsonText(const std::string& text) : text_(json_quoted(text)) {}
    JsonText(const Pixel& pixel) : text_(fmt::format("[{},{}]", pixel.x, pixel.y)) {}

    /// `true`, `12`, `0.25` in its shortest form; `null` of what is not finite.
    template <typename Number>
    requires std::integral<Number> || std::floating_point<Number> JsonText(Number number)
        : text_(fmt::format("{}", number)) {
        if constexpr (std::floating_point<Number>)
            if (!std::isfinite(number))
                text_ = "null";
    }

    template <typename Value>
    JsonText(const std::optional<Value>& value)
        : JsonText(value ? JsonText(*value) : JsonText(nullptr)) {}

    template <typename Item> JsonText(const std::vector<Item>& items) : JsonText(list(items)) {}

    /// A text that is JSON already.
    static JsonText of(std::string json) {
        JsonText value(nullptr);
        value.text_ = std::move(json);
        return value;
    }

    /// A list: of each item what a function makes of it.
    template <typename Items, typename MakeJson = std::identity>
    static JsonText list(const Items& items, const MakeJson& make = {},
                         std::string_view line_end = "") {
        std::string text = "[";
        for (const auto& item : items) {
            text += fmt::format("{}{}", text.size() > 1 ? "," : "", line_end);
            text += JsonText(make(item)).text_;
        }
        return of(text.append(text.size() > 1 ? line_end : "") + "]");
    }

    /// The same with each item on a line.
    template <typename Items, typename MakeJson = std::identity>
    static JsonText lines(const Items& items, const MakeJson& make = {}) {
        return list(items, make, "\n");
    }

    /// A further member of an object.
    JsonText& add(std::string_view key, const JsonText& value) {
        text_.erase(text_.find_last_of('}'));
        text_ += (text_.ends_with('{') ? "" : ",") + json_quoted(key) + ":" + value.text_ + "}";
        return *this;
    }

    const std::string& json() const { return text_; }
    std::string line() const { return text_ + "\n"; }

private:
    std::string text_;
};

struct JsonText::Member {
    std::string_view key;
    JsonText value;
};

inline JsonText::JsonText(std::initializer_list<Member> members) : text_("{}") {
    for (const Member& member : members)
        add(member.key, member.value);
}

} // namespace rastertrace
