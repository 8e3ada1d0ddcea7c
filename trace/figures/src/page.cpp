// SPDX-License-Identifier: MIT
#include <rastertrace/figures/page.h>

#include "page_parts.h"

#include <rastertrace/figures/player_keys.h>
#include <rastertrace/figures/svg.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>
#include <zlib.h>

#include <array>
#include <cstdint>
#include <new>
#include <utility>

namespace rastertrace {

namespace {

/// JSON that can stand in a page: nothing in it ends its script element.
std::string in_script(std::string_view json) {
    std::string text;
    for (const char c : json)
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    return text;
}

/// Of `deflate` as browsers know it, in base64.
std::string compressed(std::string_view text) {
    uLongf size = compressBound(text.size());
    std::string bytes(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(bytes.data()), &size,
                  reinterpret_cast<const Bytef*>(text.data()), text.size(),
                  Z_BEST_COMPRESSION) != Z_OK)
        throw std::bad_alloc(); // it has no other reason: there is room for whatever it makes
    bytes.resize(size);

    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string base64;
    base64.reserve((size + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group =
                group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            base64 += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
    return base64;
}

/// A style sheet's variables: the color of each role; of the dark theme, where it differs from the light one.
std::string variables_in(Theme theme) {
    std::string text;
    for (const Role role : roles())
        if (const Color color = paint_of(role, theme).color;
            theme == Theme::light || color != paint_of(role, Theme::light).color)
            text += fmt::format("--{}:{};", name_of(role), to_text(color));
    return text;
}

std::string_view word_of(Theme theme) {
    return theme_names()[static_cast<std::size_t>(theme)];
}

/// The colors of the element: element.js sets data-dark as the reader has it, or as the attribute `theme` says.
std::string colors_of_themes() {
    return fmt::format(
        ":host{{color-scheme:light;{}}}\n:host([data-dark]){{color-scheme:dark;{}}}\n",
        variables_in(Theme::light), variables_in(Theme::dark));
}

/// HTML without indentation and ends of lines.
std::string squeezed(std::string_view html) {
    std::string text;
    for (const std::string& line : split_at(html, '\n'))
        text += without_blanks(line);
    return text;
}

/// A style sheet without comments, which are lines by themselves, and blanks that only its writer needs.
std::string squeezed_css(std::string_view css) {
    std::string text;
    for (const std::string& line : split_at(css, '\n')) {
        const std::string_view words = without_blanks(line);
        if (words.starts_with("/*"))
            continue;
        for (std::size_t i = 0; i < words.size(); ++i) {
            constexpr std::string_view signs = ":;{},";
            const bool is_beside_sign =
                (i > 0 && signs.find(words[i - 1]) != signs.npos) ||
                (i + 1 < words.size() && (words[i + 1] == '{' || words[i + 1] == '}'));
            if (words[i] != ' ' || !is_beside_sign)
                text += words[i];
        }
    }
    return text;
}

/// The background of a page.
std::string paper_of(Theme theme) {
    const auto rule = [](Theme one) {
        return fmt::format("html{{background:{}}}", to_text(paint_of(Role::paper, one).color));
    };
    if (theme != Theme::automatic)
        return rule(theme);
    return fmt::format("{}\n@media (prefers-color-scheme:dark){{{}}}", rule(Theme::light),
                       rule(Theme::dark));
}

/// The keys that pages have: of each action its name, what it does in each language, and its keys.
std::string keys_text() {
    std::string text = "[";
    for (const PlayerKey& row : player_keys()) {
        if (!row.is_on_pages)
            continue;
        text += fmt::format(R"({}[{},{{"en":{},"pt":{}}})", text.size() > 1 ? "," : "",
                            json_quoted(row.name), json_quoted(row.does.in(Language::english)),
                            json_quoted(row.does.in(Language::portuguese)));
        for (const std::string_view key : row.keys)
            text += "," + json_quoted(key);
        text += "]";
    }
    return text + "]";
}

std::string options_text(const PageOptions& options) {
    std::string text =
        fmt::format("{{\"language\":{},\"title\":{}", json_quoted(code_of(language_of_steps())),
                    json_quoted(printable(options.title.empty() ? "rastertrace" : options.title)));
    if (options.view)
        text += fmt::format(",\"view\":{}", json_quoted(name_of(*options.view)));
    if (options.step)
        text += fmt::format(",\"step\":{}", *options.step);
    if (!options.scene.text.empty())
        text += fmt::format(",\"scene\":{},\"movable\":{}", json_quoted(options.scene.text),
                            options.scene.is_movable);
    return text + "}";
}

std::string data_text(std::span<const PageFrame> frames) {
    std::string text = "[";
    for (const PageFrame& frame : frames)
        text += fmt::format("{}{{\"label\":{},\"file\":{},\"data\":{}}}",
                            text.size() > 1 ? ",\n" : "", json_quoted(printable(frame.label)),
                            json_quoted(printable(frame.file)), frame.data);
    return text + "]";
}

} // namespace

std::string page_element() {
    const std::string resources = fmt::format(
        R"({{"steps_with_working":{},"keys":{},"words":{},"html":{},"css":{}}})",
        most_steps_with_working, keys_text(), words_json(), json_quoted(squeezed(element_html())),
        json_quoted(squeezed_css(colors_of_themes() + element_css() + rules_of_roles("in-space"))));
    return fmt::format(
        "// SPDX-License-Identifier: MIT\n\"use strict\";\nconst RESOURCES = {};\n{}\n{}",
        in_script(resources), player_js(), element_js());
}

std::string page_of(std::span<const PageFrame> frames, const PageOptions& options) {
    const std::string title = escaped(options.title.empty() ? "rastertrace" : options.title);
    const std::array<std::pair<std::string_view, std::string>, 8> parts{
        {{"title", title},
         {"colors", paper_of(options.theme)},
         {"theme", options.theme == Theme::automatic
                       ? std::string()
                       : fmt::format(" theme=\"{}\"", word_of(options.theme))},
         {"picture", options.picture},
         {"options", in_script(options_text(options))},
         {"data", compressed(data_text(frames))},
         {"module", options.module.empty() || options.scene.text.empty()
                        ? std::string()
                        : fmt::format("<script>\n{}\n</script>\n", options.module)},
         {"element", page_element()}}};

    // Once through the template, so that what is put in is not looked at again.
    const std::string page = page_html();
    std::string text;
    std::size_t done = 0;
    for (std::size_t open = page.find("{{"); open != std::string::npos;
         open = page.find("{{", done)) {
        const std::size_t close = page.find("}}", open);
        const std::string_view name = std::string_view(page).substr(open + 2, close - open - 2);
        text.append(page, done, open - done);
        for (const auto& [part, content] : parts)
            if (part == name)
                text += content;
        done = close + 2;
    }
    return text.append(page, done);
}

} // namespace rastertrace
