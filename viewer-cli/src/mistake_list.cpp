// SPDX-License-Identifier: MIT
#include "mistake_list.h"

#include "load.h"

#include <rastertrace/core/draw/model/mistakes.h>
#include <rastertrace/trace/diagnose/rule.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

/// A small scene of a gallery, and its right picture.
struct GalleryScene {
    std::string path;
    Source source;
    Scene scene;
    Image asked;
};

/// The small scenes in a folder and those in it that the model draws, small canvases first.
std::vector<GalleryScene> scenes_in(const std::string& folder) {
    constexpr int most_columns = 40;
    constexpr int most_rows = 24;
    std::vector<std::string> paths;
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored))
        throw problem_of(folder, "expected a folder of scenes, found none");
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().extension() == ".json")
            paths.push_back(entry.path().generic_string());
    std::ranges::sort(paths);
    std::vector<GalleryScene> scenes;
    for (const std::string& path : paths) {
        auto source = read_source(path, {});
        auto read = source && is_scene(source.value())
                        ? read_scene(source.value(), {{"scalar", "exact"}})
                        : Result<PlannedScene>(Problem{});
        if (!read || !has_model(read.value().scene))
            continue;
        const Canvas& canvas = read.value().scene.canvas;
        auto asked = canvas.width <= most_columns && canvas.height <= most_rows
                         ? drawn_by({}, source.value())
                         : std::nullopt;
        if (asked)
            scenes.push_back({path, std::move(source.value()), std::move(read.value().scene),
                              std::move(*asked)});
    }
    std::ranges::stable_sort(scenes, {}, [](const GalleryScene& one) {
        return one.asked.canvas().width * one.asked.canvas().height;
    });
    return scenes;
}

/// What a mistake makes of a picture, from its first row to its last: `+` is too much, `-` missing, `*` of another color.
std::string marked_picture(const Image& asked, const Image& drawn) {
    std::string text;
    const auto width = static_cast<std::size_t>(asked.canvas().width);
    for (std::size_t i = 0; i < asked.colors().size(); ++i) {
        const Color a = asked.colors()[i];
        const Color b = drawn.colors()[i];
        text += a == b          ? a == no_color ? '.' : '#'
                : a == no_color ? '+'
                : b == no_color ? '-'
                                : '*';
        if ((i + 1) % width == 0)
            text += '\n';
    }
    const std::size_t begin =
        text.rfind('\n', text.find_first_not_of(".\n")) + 1; // 0 in the first row
    return text.substr(begin, text.find('\n', text.find_last_not_of(".\n")) + 1 - begin);
}

/// A mistake on the page of all of them, in the smallest scene in which it changes a few pixels.
std::string gallery_entry(const Mistake& mistake, const std::vector<GalleryScene>& scenes) {
    constexpr std::ptrdiff_t few = 3;
    std::string symptom(mistake.symptom);
    symptom[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(symptom[0])));
    std::string text = fmt::format(
        "\n## {}\n\n{} ({}).\n\n```text\nit says   {}\n{}", mistake.name, symptom, mistake.source,
        mistake.says, mistake.is_rule() ? "" : fmt::format("should    {}\n", mistake.should));
    if (!mistake.setting.empty())
        text += fmt::format("the same  {}\n", mistake.setting);
    for (const std::ptrdiff_t least : {few, std::ptrdiff_t{1}})
        for (const GalleryScene& scene : scenes) {
            const auto drawn = mistake.concerns(scene.scene)
                                   ? drawn_by({{}, {&mistake}}, scene.source)
                                   : std::nullopt;
            if (!drawn)
                continue;
            std::ptrdiff_t changed = 0;
            for (std::size_t i = 0; i < drawn->colors().size(); ++i)
                changed += drawn->colors()[i] != scene.asked.colors()[i];
            if (changed >= least)
                return text + fmt::format("scene     {}\n\n{}```\n", scene.path,
                                          marked_picture(scene.asked, *drawn));
        }
    return text + "```\n";
}

} // namespace

std::string mistakes_text() {
    std::string text;
    for (const Mistake& mistake : mistakes())
        text += fmt::format("{:<30} {}\n", mistake.name, mistake.symptom);
    return text;
}

std::string mistake_text(const Mistake& mistake) {
    std::string text = fmt::format("{}{}\n  it says   {}\n", mistake.name,
                                   mistake.is_rule() ? ", a rule of others" : "", mistake.says);
    if (!mistake.is_rule())
        text += fmt::format("  should    {}\n", mistake.should);
    text += fmt::format("  changes   {}\n  symptom   {}\n  source    {}\n", mistake.step,
                        mistake.symptom, mistake.source);
    if (!mistake.setting.empty())
        text += fmt::format("  the same  {}\n", mistake.setting);
    return text;
}

std::string mistakes_json() {
    std::string text = "{\"mistakes\":[";
    std::string_view separator = "\n";
    for (const Mistake& mistake : mistakes()) {
        text += fmt::format(
            R"({}{{"name":"{}","says":{},"should":{},"step":"{}","symptom":{},"source":{},"setting":"{}"}})",
            separator, mistake.name, json_quoted(mistake.says), json_quoted(mistake.should),
            mistake.step, json_quoted(mistake.symptom), json_quoted(mistake.source),
            mistake.setting);
        separator = ",\n";
    }
    return text + "\n]}\n";
}

std::string mistake_gallery(const std::string& folder) {
    const std::vector<GalleryScene> scenes = scenes_in(folder);
    std::string text =
        "# Known mistakes\n\n"
        "What a rasterizer says that makes the mistake, what it should say, and a "
        "small scene\n"
        "drawn with the mistake: `+` is too much, `-` is missing, `*` has another color. "
        "`rastertrace show SCENE --mistake NAME` draws it;\n"
        "[`rastertrace diagnose`](diagnose.md) finds which of them yours makes.\n";
    for (const Mistake& mistake : mistakes())
        text += gallery_entry(mistake, scenes);
    return text;
}

} // namespace rastertrace
