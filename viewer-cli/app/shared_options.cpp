// SPDX-License-Identifier: MIT
#include "app/shared_options.h"

#include "app/command_words.h"
#include "app/environment.h"
#include "app/option_values.h"

#include <rastertrace/trace/tell/view.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/method_file.h>
#include <rastertrace/trace/text/stage_name.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <utility>

namespace rastertrace {

void choose_language(const std::string& option) {
    constexpr const char* variable = "RASTERTRACE_LANGUAGE";
    const bool is_option = !option.empty();
    const auto language = value_of(is_option ? "--language" : variable,
                                   is_option ? option : std::string(environment_variable(variable)),
                                   language_codes(), language_with_code);
    if (language)
        tell_steps_in(*language);
}

void add_view_to(OptionList& options, std::string& view) {
    options
        .option("--view", view, "What a cell shows; if none is given, what the scene is about",
                "NAME")
        .values(view_names());
}

std::string option_named(std::string_view key) {
    std::string option = "--" + std::string(key);
    std::replace(option.begin(), option.end(), '_', '-');
    return option;
}

void MethodOptions::add_to(OptionList& options) {
    const std::string title = "Method, instead of what the scene says";
    options
        .option("--method", file_,
                "The choices in this file, JSON like {\"fill\": \"top-left\"}; other options count "
                "more",
                "FILE")
        .shared(title);
    for (const MethodKey& key : method_keys())
        options
            .option(option_named(key.name), values_[std::string(key.name)],
                    key.name == "mistake" ? fmt::format("{}: {}", key.meaning, key.listed())
                                          : std::string(key.meaning),
                    key.name == "mistake" ? "MISTAKE" : "NAME")
            .values(key.name == "mistake" ? std::vector<std::string_view>() : key.values)
            .names_of(key.name == "mistake" ? NamesOf::mistakes : NamesOf::nothing)
            .shared(title);
    options
        .option("--keep", keep_, "Run these stages even if the scene does not need them",
                "STAGE,...")
        .values(stage_names())
        .shared(title);
    options.flag("--full", full_, "Run every stage that the method has").shared(title);
}

MethodOverrides MethodOptions::overrides() const {
    MethodOverrides overrides;
    if (file_.find('=') != std::string::npos && !std::filesystem::exists(file_))
        refuse_value("--method", "a file", file_,
                     "a choice is an option by itself, like --fill top-left");
    if (!file_.empty())
        overrides = read_method_file(file_, InputLimits{});
    for (const MethodKey& key : method_keys()) {
        const std::string& value = values_.at(std::string(key.name));
        if (value.empty())
            continue;
        Method scratch;
        if (!key.set(scratch, value))
            refuse_value(option_named(key.name), key.expected(), value,
                         did_you_mean(value, key.values));
        std::erase_if(overrides, [&key](const auto& one) { return one.first == key.name; });
        overrides.emplace_back(key.name, value);
    }
    if (!keep_.empty())
        for (const Stage stage : values_of("--keep", "stages", keep_, stage_names(), stage_named))
            overrides.emplace_back("keep", name_of(stage));
    if (full_)
        std::ranges::copy(every_stage_kept(), std::back_inserter(overrides));
    return overrides;
}

namespace {

const std::string of_input = "What is read";

std::size_t bytes_in(const std::string& text) {
    constexpr std::array<std::pair<std::string_view, std::size_t>, 3> units{
        {{"kB", 1'000}, {"MB", 1'000'000}, {"GB", 1'000'000'000}}};
    for (const auto& [unit, bytes] : units) {
        if (!text.ends_with(unit))
            continue;
        const auto count = whole_number<std::size_t>(text.substr(0, text.size() - unit.size()));
        if (count && *count > 0 && *count <= std::numeric_limits<std::size_t>::max() / bytes)
            return *count * bytes;
    }
    refuse_value("--max-input", "a size in kB, MB or GB, like 512MB", text);
}

std::size_t steps_in(const std::string& text) {
    if (const auto count = whole_number<std::size_t>(text); count && *count > 0)
        return *count;
    refuse_value("--max-steps", "a number of steps, from 1", text);
}

} // namespace

void InputOptions::add_to(OptionList& options, Holds holds) {
    options
        .option("--max-input", max_input_,
                "The largest scene or OBJ file to read, in kB, MB or GB; 256MB if not "
                "given. A trace may have any size",
                "SIZE")
        .shared(of_input);
    options
        .flag("--allow-outside", limits_.allow_outside,
              "Read OBJ files that lie outside of the scene's folder too")
        .shared(of_input);
    if (holds == Holds::no_steps)
        return;
    options
        .option("--max-steps", max_steps_,
                "The most steps of a trace to hold; 10 million if not given. Pixels of a "
                "row that follow one another count as one",
                "N")
        .shared(of_input);
}

InputLimits InputOptions::limits() const {
    InputLimits limits = limits_;
    if (!max_input_.empty())
        limits.bytes = bytes_in(max_input_);
    if (!max_steps_.empty())
        limits.steps = steps_in(max_steps_);
    return limits;
}

void FrameOptions::add_to(OptionList& options, std::string_view without) {
    options
        .option("--vary", vary_,
                "Let a number of the scene vary from frame to frame, like "
                "/camera/position/2=4:1:7 (from 4 to 1 in 7 steps) or =4,3,1; may be "
                "given again",
                "POINTER=VALUES")
        .repeatable()
        .shared(of_input);
    options
        .option("--frame", frame_,
                fmt::format("The frame of a scene that varies, from 1; {}", without), "N")
        .shared(of_input);
}

FrameChoice FrameOptions::choice() const {
    FrameChoice choice;
    for (const std::string& one : vary_) {
        const std::size_t equals = one.find_last_of('=');
        if (equals == std::string::npos)
            refuse_value("--vary", "POINTER=FROM:TO:STEPS or a list of values", one,
                         "like /camera/position/2=4:1:7");
        choice.vary.push_back({one.substr(0, equals), one.substr(equals + 1)});
    }
    if (!frame_.empty()) {
        choice.frame = whole_number<std::size_t>(frame_);
        if (choice.frame.value_or(0) < 1)
            refuse_value("--frame", "the number of a frame, from 1", frame_);
    }
    return choice;
}

void ComparisonOptions::add_to(OptionList& options) {
    options
        .option("--tolerance", tolerances_,
                "How far apart numbers may be: scanline.left=1e-9, depth=4ulp, or 4ulp for "
                "all; a list, and may be given again",
                "KIND.FIELD=AMOUNT")
        .repeatable();
    options.option("--ignore", ignored_,
                   "Leave out kinds of steps, fields, or header: sample,pixel.color,header",
                   "NAMES");
    options.option("--only", only_, "Compare these kinds of steps alone", "KINDS");
    options
        .option("--key", keys_,
                "The fields that a step of a kind of your own is found by: tile=tx,ty; may be "
                "given again",
                "KIND=FIELDS")
        .repeatable();
    options.option("--background", background_,
                   "The color of a picture where nothing is drawn, if it has one", "COLOR");
    options.flag("--any-order", is_any_order_,
                 "Steps of a primitive, and primitives, may come in another order");
    options.flag("--common", options_.compares_common,
                 "Compare only the kinds and fields that both traces have");
}

DiffOptions ComparisonOptions::options() const {
    DiffOptions options = options_;
    for (const std::string& list : tolerances_)
        for (const std::string& one : split_at(list, ','))
            options.tolerances.push_back(parse_tolerance(one));
    if (!ignored_.empty())
        options.ignored = split_at(ignored_, ',');
    if (!only_.empty())
        options.only = split_at(only_, ',');
    for (const std::string& one : keys_)
        add_step_key(options, one);
    options.compares_order = !is_any_order_;
    return options;
}

std::optional<Color> ComparisonOptions::background() const {
    if (background_.empty())
        return std::nullopt;
    const auto color = parse_color(background_);
    if (!color)
        refuse_value("--background", "a color like #ff8000", background_);
    return color;
}

std::string ComparisonOptions::words(const std::string& ignored) const {
    std::string words =
        "--ignore " + shell_word(ignored_.empty() ? ignored : ignored + "," + ignored_);
    const auto add = [&words](std::string_view option, const std::string& value) {
        if (!value.empty())
            words += fmt::format(" {} {}", option, shell_word(value));
    };
    for (const std::string& tolerance : tolerances_)
        add("--tolerance", tolerance);
    for (const std::string& key : keys_)
        add("--key", key);
    add("--only", only_);
    add("--background", background_);
    return words;
}

} // namespace rastertrace
