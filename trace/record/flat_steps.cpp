// SPDX-License-Identifier: MIT
#include "flat_steps.h"

#include "field_type.h"
#include "step_decoder.h"
#include "trace.h"
#include "traced_steps.h"

#include <rastertrace/trace/text/csv.h>
#include <rastertrace/trace/text/format_number.h>
#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <variant>

namespace rastertrace {

namespace {

FlatType flat_type_of(FieldType type) {
    switch (type) {
    case FieldType::whole:
        return FlatType::whole;
    case FieldType::quantity:
        return FlatType::number;
    case FieldType::boolean:
        return FlatType::boolean;
    case FieldType::string:
    case FieldType::list: // as JSON
        break;
    }
    return FlatType::text;
}

/// The columns in front, which are no fields but `step`.
enum FrontColumn : std::size_t { version_column, number_column, in_column, step_column };

/// Which columns there are, and where the value of a field goes.
class FlatTable {
public:
    /// The column of a field; if it has numbers, their exact text goes to the one behind it.
    struct Place {
        std::size_t column;
        StepField field;
        bool is_list() const { return field.type == FieldType::list; }
        bool has_numbers() const { return field.element == FieldType::quantity; }
    };

    FlatTable()
        : columns{{"flat", FlatType::whole, {}},
                  {"n", FlatType::whole, {}},
                  {"in", FlatType::text, {}},
                  {"step", FlatType::text, {}}} {
        for (std::size_t i = 0; i < step_kinds; ++i)
            for (const StepField& field : fields_of(static_cast<StepKind>(i)))
                by_kind[i].push_back(add(field, step_names[i]));
        add({.name = key_of_code,
             .type = FieldType::string,
             .element = FieldType::string,
             .is_color = false,
             .role = FieldRole::told,
             .need = FieldNeed::none},
            "");
        other_column = columns.size();
        columns.push_back({"other", FlatType::text, {}});
        name_column = place_for("name", R"("")")->column;
    }

    /// The place of a field that has this value, in a step of whatever kind; nullptr if there is none.
    const Place* place_for(std::string_view name, std::string_view json) const {
        const auto [begin, end] = by_name_.equal_range(name);
        const auto found = std::find_if(begin, end, [json](const auto& entry) {
            const StepField& field = entry.second.field;
            return (field.type == FieldType::quantity && json == "null") ||
                   has_type_of(json, field);
        });
        return found == end ? nullptr : &found->second;
    }

    std::vector<FlatColumn> columns;
    std::array<std::vector<Place>, step_kinds> by_kind; ///< of the fields of each kind, in order
    std::size_t name_column = 0;
    std::size_t other_column = 0; ///< of the fields that have no place

private:
    /// The place of a field. Fields of the same name and type share one.
    Place add(StepField field, std::string_view kind) {
        field.is_color = false; // a text like any other
        const bool is_list = field.type == FieldType::list;
        const auto [begin, end] = by_name_.equal_range(field.name);
        auto entry = std::find_if(
            begin, end, [is_list](const auto& one) { return one.second.is_list() == is_list; });
        if (entry == end) {
            entry = by_name_.emplace(field.name, Place{columns.size(), field});
            const std::string name = std::string(field.name) + (is_list ? "_list" : "");
            columns.push_back({name, flat_type_of(field.type), {}});
            if (entry->second.has_numbers())
                columns.push_back({name + "_exact", FlatType::text, {}});
        }
        const Place& place = entry->second;
        assert(place.field.type == field.type && place.field.element == field.element);
        if (!kind.empty())
            for (std::size_t one = 0; one <= std::size_t{place.has_numbers()}; ++one)
                columns[place.column + one].kinds.push_back(kind);
        return place;
    }

    std::multimap<std::string_view, Place, std::less<>> by_name_;
};

const FlatTable& flat_table() {
    static const FlatTable table;
    return table;
}

/// Adds the nearest double of a number, if it has one.
bool add_double(std::string& text, std::string_view number) {
    const auto value = TracedNumber(number).nearest_double();
    if (!value || !std::isfinite(*value))
        return false;
    std::array<char, room_for(0.0)> digits;
    text.append(digits.data(), format_number(digits.data(), *value));
    return true;
}

/// A list whose numbers are doubles.
std::string list_of_doubles(std::string_view json) {
    std::string text;
    while (!json.empty()) {
        const std::size_t quote = std::min(json.find('"'), json.size());
        text += json.substr(0, quote);
        json.remove_prefix(quote);
        if (json.empty())
            break;
        const std::size_t size = json.find('"', 1) + 1; // a number has no escape
        if (!add_double(text, json.substr(0, size)))
            text += "null";
        json.remove_prefix(size);
    }
    return text;
}

} // namespace

std::string_view sql_name(FlatType type) {
    constexpr std::array<std::string_view, 4> names{"BIGINT", "DOUBLE", "BOOLEAN", "VARCHAR"};
    return names[static_cast<std::size_t>(type)];
}

const std::vector<FlatColumn>& flat_columns() {
    return flat_table().columns;
}

/// A row as it is put together: the values of columns as JSON.
class FlatSteps::Row {
public:
    Row() : values_(flat_columns().size()) {}

    /// Takes a step of a trace, and forgets the one before.
    void take(std::string_view json, std::int64_t number) {
        for (const std::size_t column : used_)
            values_[column].clear();
        used_.clear();
        put_whole(version_column, flat_version);
        put_whole(number_column, number);
        AnyStep step;
        std::string_view rest = json;
        if (take_step(rest, step) && rest.empty())
            std::visit([this](const auto& plain) { take_plain(plain); }, step);
        else
            take_fields(json);
        if (values_[step_column] == R"("primitive")")
            in_ = values_[flat_table().name_column];
        if (!in_.empty())
            value_of(in_column) = in_;
        std::sort(used_.begin(), used_.end());
    }

    void add_to(std::string& text, FlatForm form) const {
        if (form == FlatForm::lines)
            add_object_to(text);
        else
            add_csv_to(text);
    }

private:
    /// The value of a column that has one.
    std::string& value_of(std::size_t column) {
        used_.push_back(column);
        return values_[column];
    }

    template <typename Step> void take_plain(const Step& step) {
        const auto kind = static_cast<std::size_t>(Step::step_kind);
        value_of(step_column).append("\"").append(step_names[kind]).append("\"");
        take_table(step, flat_table().by_kind[kind].data(), typename Step::Fields{});
    }

    template <typename Step, typename... Rows>
    void take_table(const Step& step, const FlatTable::Place* place, FieldTable<Rows...> /*all*/) {
        (put(*place++, Rows::in(step)), ...);
    }

    /// The same for a step whatever it has and looks like.
    void take_fields(std::string_view json) {
        std::string others;
        JsonScanner fields(json);
        while (fields.next_field()) {
            if (fields.key() == "step")
                value_of(step_column) = fields.value();
            else if (const auto* place = flat_table().place_for(fields.key(), fields.value()))
                put(*place, fields.value());
            else
                others.append(others.empty() ? "{\"" : ",\"")
                    .append(fields.key())
                    .append("\":")
                    .append(fields.value());
        }
        if (!others.empty())
            value_of(flat_table().other_column) = json_quoted(others + "}");
    }

    void put_whole(std::size_t column, std::int64_t whole) {
        std::array<char, room_for(std::int64_t{})> digits;
        value_of(column).assign(digits.data(), format_number(digits.data(), whole));
    }
    void put(const FlatTable::Place& place, Index whole) { put_whole(place.column, whole); }
    void put(const FlatTable::Place& place, const std::optional<Index>& whole) {
        if (whole)
            put_whole(place.column, *whole);
    }
    void put(const FlatTable::Place& place, const TracedValue& value) {
        if (value)
            put(place, value.json());
    }

    /// A value as it stands in a trace.
    void put(const FlatTable::Place& place, std::string_view json) {
        const auto as_text = [&](std::string_view value) {
            return place.is_list() || value == "null" ? json_quoted(value) : std::string(value);
        };
        // Neither a string nor null.
        const bool is_number =
            std::none_of(json.begin(), json.end(), [](char c) { return c == '"' || c == 'n'; });
        if (!place.has_numbers() || is_number) {
            value_of(place.column) = as_text(json);
            return;
        }
        value_of(place.column + 1) = as_text(json);
        std::string number;
        if (place.is_list())
            value_of(place.column) = json_quoted(list_of_doubles(json));
        else if (add_double(number, json))
            value_of(place.column) = number;
    }

    void add_object_to(std::string& text) const {
        char separator = '{';
        for (const std::size_t column : used_) {
            text += separator;
            text.append("\"").append(flat_columns()[column].name).append("\":");
            text += values_[column];
            separator = ',';
        }
        text += "}\n";
    }

    void add_csv_to(std::string& text) const {
        std::size_t before = 0;
        for (const std::size_t column : used_) {
            text.append(column - before, ',');
            before = column;
            const std::string& value = values_[column];
            text += value.starts_with('"') ? csv_field(plain_text(value)) : value;
        }
        text.append(values_.size() - 1 - before, ',');
        text += "\r\n";
    }

    std::vector<std::string> values_; ///< of each column
    std::vector<std::size_t> used_;   ///< the columns that have a value, in order
    std::string in_;                  ///< the name of the primitive that has begun; "": none yet
};

FlatSteps::FlatSteps(Output& to, FlatForm form)
    : to_(to), form_(form), row_(std::make_unique<Row>()) {
    if (form != FlatForm::csv)
        return;
    std::vector<std::string> names;
    for (const FlatColumn& column : flat_columns())
        names.push_back(column.name);
    put_csv_line(text_, names);
}

FlatSteps::~FlatSteps() = default;

void FlatSteps::write(std::string_view bytes) {
    for (std::size_t end = 0; (end = bytes.find('\n')) != std::string_view::npos;) {
        if (line_.empty()) {
            take_line(bytes.substr(0, end));
        } else {
            line_ += bytes.substr(0, end);
            take_line(line_);
            line_.clear();
        }
        bytes.remove_prefix(end + 1);
    }
    line_ += bytes;
}

void FlatSteps::take_line(std::string_view line) {
    constexpr std::size_t enough_to_write = 1 << 16; // bytes
    const bool is_header = !std::exchange(is_behind_header_, true);
    if (is_header || (!line.starts_with(front_of_step) && is_end_line(line)))
        return;
    row_->take(line, ++steps_);
    row_->add_to(text_, form_);
    if (text_.size() > enough_to_write)
        finish();
}

void FlatSteps::finish() {
    to_.write(text_);
    text_.clear();
}

} // namespace rastertrace
