// SPDX-License-Identifier: MIT
// rastertrace conventions: whose rules a scene can be drawn by, side by side.

#include "command.h"
#include "load.h"
#include "option_values.h"

#include <rastertrace/trace/text/conventions.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

using Rows = std::span<const ConventionRow>;

/// What a row sets of a key; "" if it does not.
std::string_view value_in(const ConventionRow& row, std::string_view key) {
    for (const auto& [name, value] : row.method)
        if (name == key)
            return value;
    return {};
}

/// The settings as they stand in a scene: `rows half-open, rounding half-open`.
std::string other_settings(const ConventionRow& row) {
    std::vector<std::string> all;
    for (const auto& [name, value] : row.method)
        if (name != "fill" && name != "sample" && name != "line" && name != "depth")
            all.push_back(fmt::format("{} {}", name, value));
    return all.empty() ? "-" : joined(all, ", ");
}

std::string as_text(Rows rows) {
    std::string text = fmt::format("{:<13} {:<12} {:<8} {:<13} {:<10} {}\n", "convention", "fill",
                                   "sample", "line", "depth", "other keys");
    const auto or_dash = [](std::string_view value) { return value.empty() ? "-" : value; };
    for (const ConventionRow& row : rows)
        text += fmt::format("{:<13} {:<12} {:<8} {:<13} {:<10} {}\n", row.name,
                            or_dash(value_in(row, "fill")), or_dash(value_in(row, "sample")),
                            or_dash(value_in(row, "line")), or_dash(value_in(row, "depth")),
                            other_settings(row));
    for (const ConventionRow& row : rows)
        text += fmt::format("\n{}: {}\n  viewport  {}\n  source    {}\n  unusual   {}\n", row.name,
                            row.what, name_of_view(row), row.source, row.unusual);
    return text;
}

std::string as_json(Rows rows) {
    std::string text = "{\"conventions\":[";
    std::string_view separator = "\n";
    for (const ConventionRow& row : rows) {
        std::string method;
        for (const auto& [name, value] : row.method)
            method += fmt::format("{}\"{}\":\"{}\"", method.empty() ? "" : ",", name, value);
        text += fmt::format(R"({}{{"convention":"{}","what":{},"method":{{{}}},"viewport":{},)"
                            R"("source":{},"unusual":{}}})",
                            separator, row.name, json_quoted(row.what), method,
                            json_quoted(name_of_view(row)), json_quoted(row.source),
                            json_quoted(row.unusual));
        separator = ",\n";
    }
    return text + "\n]}\n";
}

class ConventionsCommandLine final : public Command {
public:
    CommandAbout about() const override {
        return {"conventions", "List whose rules a scene can be drawn by, and what they set",
                "rastertrace conventions opengl"};
    }

    void add_to(OptionList& options) override {
        options.option("name", name_, "Only this one", "NAME").values(names());
        options.flag("--json", json_, "Print JSON");
    }

    void read() override {
        if (const auto place = value_of<std::size_t>("conventions", name_, names()))
            rows_ = rows_.subspan(*place, 1);
    }

    int run() override {
        print(json_ ? as_json(rows_) : as_text(rows_));
        return exit_fine;
    }

private:
    static std::vector<std::string_view> names() {
        std::vector<std::string_view> all;
        for (const ConventionRow& row : convention_rows())
            all.push_back(row.name);
        return all;
    }

    std::string name_;
    Rows rows_ = convention_rows();
    bool json_ = false;
};

} // namespace

std::unique_ptr<Command> conventions_command() {
    return std::make_unique<ConventionsCommandLine>();
}

} // namespace rastertrace
