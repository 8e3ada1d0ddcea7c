// SPDX-License-Identifier: MIT
#include "variations.h"

#include "scene_keys.h"

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

/// A number as an author would type it: a decimal if that ends, else a fraction in quotes.
std::string token_of(const mpq_class& value) {
    mpz_class rest = value.get_den();
    const auto factors = [&rest](unsigned long prime) {
        const mpz_class divisor = prime;
        return mpz_remove(rest.get_mpz_t(), rest.get_mpz_t(), divisor.get_mpz_t());
    };
    const std::size_t places = std::max(factors(2), factors(5));
    if (rest != 1)
        return '"' + value.get_str() + '"';
    if (places == 0)
        return value.get_str();

    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, places);
    std::string digits = mpz_class(abs(value.get_num()) * (power / value.get_den())).get_str();
    if (digits.size() <= places)
        digits.insert(0, places + 1 - digits.size(), '0');
    digits.insert(digits.size() - places, ".");
    return (sgn(value) < 0 ? "-" : "") + digits;
}

/// A number as the label of a frame has it.
std::string short_text(const mpq_class& value) {
    std::string text = token_of(value);
    std::erase(text, '"');
    constexpr std::size_t width = 24;
    return shortened(text, width);
}

/// An index of an array as a pointer writes it: without zeros in front.
std::optional<std::size_t> index_in(std::string_view word) {
    std::size_t index = 0;
    const auto read = std::from_chars(word.data(), word.data() + word.size(), index);
    const bool has_zeros = word.size() > 1 && word.front() == '0';
    if (read.ec != std::errc{} || read.ptr != word.data() + word.size() || has_zeros)
        return std::nullopt;
    return index;
}

/// The last key of a pointer, and the indices behind it: `degrees`, `position/2`.
std::string_view short_name(std::string_view pointer) {
    std::size_t begin = pointer.size();
    do
        begin = pointer.find_last_of('/', begin - 1);
    while (begin > 0 && index_in(split_at(pointer.substr(begin + 1), '/').front()));
    return pointer.substr(begin + 1);
}

/// From one number to another, both included; one value is `from`.
std::vector<mpq_class> evenly_spaced(const mpq_class& from, const mpq_class& to,
                                     std::size_t steps) {
    std::vector<mpq_class> values{from};
    for (std::size_t i = 1; i < steps; ++i)
        values.emplace_back(from + (to - from) * mpz_class(i) / mpz_class(steps - 1));
    return values;
}

/// One variation while it is read: it knows whom to blame.
class VariationReader {
public:
    /// `key` is the pointer in the scene's "vary"; none for one of the command line.
    VariationReader(const JsonReader& json, std::string pointer, const JsonValue* key)
        : json_(json), pointer_(std::move(pointer)), key_(key) {}

    [[noreturn]] void fail(std::string message, std::string hint = {}) const {
        if (key_ != nullptr)
            json_.fail(*key_, std::move(message), std::move(hint));
        throw problem_of("", fmt::format("--vary: {}", message), std::move(hint));
    }

    /// The number that the pointer leads to.
    JsonValue target_in(const JsonValue& root) const {
        constexpr const char* example = "like /camera/position/2";
        if (!pointer_.starts_with('/'))
            fail(fmt::format("expected a JSON Pointer, which begins with '/', found \"{}\"",
                             shown(pointer_)),
                 example);
        JsonValue target = root;
        std::string way;
        for (const std::string& word : split_at(std::string_view(pointer_).substr(1), '/')) {
            if (way.empty() && word == "vary")
                fail("expected a number that is drawn by, found one of \"vary\"", example);
            target = inside(target, way, word);
            way += '/' + word;
        }
        const bool is_number = target.kind == JsonValue::Kind::number ||
                               (target.kind == JsonValue::Kind::string &&
                                std::holds_alternative<Number>(parse_number(target.text)));
        if (!is_number)
            fail(fmt::format("expected a number at {}, found {}", shown(way), described(target)),
                 inside_of(target));
        return target;
    }

    /// FROM:TO:STEPS, or a list.
    std::vector<mpq_class> values_in(const std::string& text) const {
        if (text.find(':') == std::string::npos) {
            std::vector<mpq_class> list;
            for (const std::string& word : split_at(text, ','))
                list.push_back(number_in(word));
            if (list.size() > most_frames)
                fail(fmt::format("expected at most {} values, found {}", most_frames, list.size()));
            return list;
        }
        const auto words = split_at(text, ':');
        if (words.size() != 3)
            fail(fmt::format("expected FROM:TO:STEPS or a list of values, found \"{}\"",
                             shown(text)),
                 "like 4:1:7, or 4,3,2");
        const auto steps = index_in(words[2]);
        if (!steps || *steps < 1 || *steps > most_frames)
            fail(fmt::format("expected a whole number of steps from 1 to {}, found \"{}\"",
                             most_frames, shown(words[2])));
        return evenly_spaced(number_in(words[0]), number_in(words[1]), *steps);
    }

    /// {"from", "to", "steps"}, or a list.
    std::vector<mpq_class> values_in(const JsonValue& value) const {
        if (value.kind == JsonValue::Kind::array && !value.elements().empty()) {
            std::vector<mpq_class> list;
            for (const JsonValue& item : value.elements()) {
                if (list.size() == most_frames)
                    json_.fail(item,
                               fmt::format("expected at most {} values, found more", most_frames));
                list.push_back(json_.number_in(item).exact());
            }
            return list;
        }
        if (value.kind != JsonValue::Kind::object)
            json_.fail_expecting(value,
                                 R"({"from": 0, "to": 345, "steps": 24} or a list of numbers)");
        json_.allow_keys(value, range_keys);
        const JsonValue steps_value = json_.member(value, "steps");
        const auto steps = json_.number_in(steps_value).numerator_over(1);
        if (!steps || *steps < 1 || *steps > static_cast<std::int64_t>(most_frames))
            json_.fail_expecting(steps_value,
                                 fmt::format("a whole number of steps from 1 to {}", most_frames));
        return evenly_spaced(json_.number_in(json_.member(value, "from")).exact(),
                             json_.number_in(json_.member(value, "to")).exact(),
                             static_cast<std::size_t>(*steps));
    }

private:
    static std::string_view shown(std::string_view text) { return first_characters(text, 60); }

    /// The keys of an object.
    static std::vector<std::string> keys_of(const JsonValue& object) {
        std::vector<std::string> keys;
        for (const auto& [key, value] : object.members())
            keys.push_back(key.text);
        return keys;
    }

    /// The keys of an object, if they can be listed in a message.
    static std::string listed(const std::vector<std::string>& keys) {
        constexpr std::size_t most_listed = 16;
        return keys.size() > most_listed ? "" : joined(keys, ", ");
    }

    /// What the pointer may go on with behind a value that is no number.
    static std::string inside_of(const JsonValue& value) {
        if (const auto keys = listed(keys_of(value)); !keys.empty())
            return fmt::format("inside are {}", keys);
        if (const auto elements = value.elements(); !elements.empty())
            return fmt::format("inside are 0 to {}", elements.size() - 1);
        return {};
    }

    /// The value that a word of the pointer names inside of the one that `way` leads to.
    JsonValue inside(const JsonValue& value, const std::string& way,
                     const std::string& word) const {
        const std::string place = way.empty() ? "the scene" : std::string(shown(way));
        if (value.kind == JsonValue::Kind::object) {
            const std::string key = unescaped(word);
            if (const auto found = value.find(key))
                return *found;
            const auto keys = keys_of(value);
            const std::string list = listed(keys);
            fail(fmt::format("expected a key of {}{}{}, found \"{}\"", place,
                             list.empty() ? "" : ": ", list, shown(key)),
                 did_you_mean(key, {keys.begin(), keys.end()}));
        }
        if (value.kind == JsonValue::Kind::array) {
            const JsonElements elements = value.elements();
            const std::size_t size = elements.size();
            if (const auto index = index_in(word); index && *index < size)
                return elements[*index];
            fail(size == 0 ? fmt::format("expected the pointer to end at {}, which is empty, found "
                                         "\"{}\" behind it",
                                         place, shown(word))
                           : fmt::format("expected an index of {}: 0 to {}, found \"{}\"", place,
                                         size - 1, shown(word)));
        }
        fail(fmt::format("expected the pointer to end at {}, which is {}, found \"{}\" behind it",
                         place, described(value), shown(word)));
    }

    /// A word of a pointer as the key that it stands for: ~1 is a slash, ~0 a tilde.
    std::string unescaped(const std::string& word) const {
        std::string key;
        for (std::size_t i = 0; i < word.size(); ++i) {
            if (word[i] != '~') {
                key += word[i];
                continue;
            }
            const char escaped = ++i < word.size() ? word[i] : '\0';
            if (escaped != '0' && escaped != '1')
                fail(fmt::format("expected ~0 or ~1 (a tilde or a slash in a key), found \"{}\"",
                                 shown(word)));
            key += escaped == '0' ? '~' : '/';
        }
        return key;
    }

    mpq_class number_in(const std::string& word) const {
        const auto parsed = parse_number(word);
        if (const auto* number = std::get_if<Number>(&parsed))
            return number->exact();
        fail(fmt::format("expected a number from -1.797e308 to 1.797e308, found \"{}\"",
                         shown(word)));
    }

    const JsonReader& json_;
    std::string pointer_;
    const JsonValue* key_;
};

} // namespace

Variations::Variations(const JsonReader& json, const JsonValue& root,
                       const std::vector<Variation>& given) {
    const auto add = [&](const std::string& pointer, const JsonValue* key, const auto& values) {
        const VariationReader reader(json, pointer, key);
        varying_.push_back({pointer, reader.target_in(root).node(), reader.values_in(values)});
        const std::size_t found = varying_.back().values.size();
        if (found != count())
            reader.fail(fmt::format("expected as many values as {} has, {}; found {}",
                                    varying_.front().pointer, count(), found));
    };

    // The scene's own, but for those that the command line says otherwise.
    if (const auto vary = root.find("vary")) {
        if (vary->kind != JsonValue::Kind::object)
            json.fail_expecting(*vary,
                                R"(pointers to numbers, like {"/camera/position/2": [4, 2, 1]})");
        for (const auto& member : vary->members()) {
            const std::string& pointer = member.key.text;
            if (std::none_of(given.begin(), given.end(), [&pointer](const Variation& other) {
                    return other.pointer == pointer;
                }))
                add(pointer, &member.key, member.value);
        }
    }
    for (const Variation& one : given) {
        if (std::any_of(varying_.begin(), varying_.end(),
                        [&one](const Varying& other) { return other.pointer == one.pointer; }))
            VariationReader(json, one.pointer, nullptr)
                .fail(fmt::format("expected each number once, found {} again", one.pointer));
        add(one.pointer, nullptr, one.values);
    }
}

std::string Variations::label(std::size_t frame, Language language) const {
    // Two numbers of one short name are told by their pointers.
    const auto name_of = [this](const Varying& one) {
        const std::string_view name = short_name(one.pointer);
        const auto alike = [name](const Varying& other) {
            return short_name(other.pointer) == name;
        };
        return std::count_if(varying_.begin(), varying_.end(), alike) > 1 ? one.pointer
                                                                          : std::string(name);
    };
    std::vector<std::string> numbers;
    for (const Varying& one : varying_)
        numbers.push_back(fmt::format("{} {}", name_of(one), short_text(one.values[frame - 1])));
    return fmt::format("{} {} {}: {}", frame, Words("of").in(language), count(),
                       joined(numbers, ", "));
}

void Variations::put_into(JsonDocument& document, std::size_t frame) const {
    for (const Varying& one : varying_)
        document.replace(one.node, token_of(one.values[frame - 1]));
}

} // namespace rastertrace
