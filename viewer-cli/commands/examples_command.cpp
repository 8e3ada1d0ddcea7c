// SPDX-License-Identifier: MIT
// rastertrace examples: the examples that the program came with.

#include "app/command.h"
#include "app/installed_files.h"
#include "app/load.h"

#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/json_document.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace rastertrace {

namespace {

/// The files below the folder of the examples, by their names relative to it.
std::vector<std::string> names_of_examples(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (is_file(entry))
            names.push_back(entry.path().lexically_relative(folder).generic_string());
    std::ranges::sort(names);
    return names;
}

Source bytes_of(const std::filesystem::path& file) {
    return value_or_throw(read_bytes(file.string(), {}));
}

/// True if a text has a word, in capitals or not.
bool has(const std::string& text, const std::string& word) {
    const auto is_same = [](unsigned char a, unsigned char b) {
        return std::tolower(a) == std::tolower(b);
    };
    return word.empty() ||
           std::search(text.begin(), text.end(), word.begin(), word.end(), is_same) != text.end();
}

/// The title of a scene, or what the first line of claims says.
std::string title_of(const Source& file) {
    const std::string_view text = file.view();
    if (text.starts_with("# ") && file.name.ends_with(".claims"))
        return std::string(text.substr(2, text.find('\n') - 2));
    const auto json = parse_json(file);
    const auto root = json ? std::optional(json.value().root()) : std::nullopt;
    const auto title =
        root && root->kind == JsonValue::Kind::object ? root->find("title") : std::nullopt;
    return title ? title->text : "";
}

class ExamplesCommand final : public Command {
public:
    CommandAbout about() const override {
        return {"examples", "List the examples that the program came with, or copy them",
                "rastertrace examples cube\n"
                "rastertrace examples -o examples\n\n"
                "Once they are copied, every command of the help and of the documentation runs as "
                "it is printed."};
    }

    void add_to(OptionList& options) override {
        options.option("word", word_, "Only those whose name or title has this word", "WORD");
        options.option("-o,--output", folder_,
                       "Copy them all to this folder, which is made; a file that is there stays",
                       "FOLDER");
    }

    void read() override {
        if (!word_.empty() && !folder_.empty())
            throw problem_of("", "-o: expected no WORD with it, as it copies all examples",
                             "they need one another: a scene may name a model");
    }

    int run() override {
        const std::filesystem::path examples = examples_folder();
        std::string listed;
        std::size_t copied = 0;
        const std::vector<std::string> names = names_of_examples(examples);
        for (const std::string& name : names) {
            if (!folder_.empty()) {
                copied += copy(examples / name, std::filesystem::path(folder_) / name);
                continue;
            }
            const std::string title = title_of(bytes_of(examples / name));
            if (has(name, word_) || has(title, word_))
                listed +=
                    fmt::format("{}\n", without_blanks(fmt::format("{:<44} {}", name, title)));
        }
        if (!folder_.empty())
            listed = fmt::format("{} of {} files copied to {}{}\n", copied, names.size(),
                                 printable(folder_),
                                 copied == names.size() ? "" : "; the others are there already");
        else if (listed.empty())
            throw problem_of("",
                             fmt::format("expected a word of the name or the title of an "
                                         "example, found \"{}\"",
                                         printable(word_)),
                             "without a word all of them are listed");
        print(listed);
        return exit_fine;
    }

private:
    /// Copies a file; false if it is there already.
    static bool copy(const std::filesystem::path& from, const std::filesystem::path& to) {
        if (std::filesystem::exists(to))
            return false;
        make_folder(to.parent_path().string());
        write_file(to.string(), bytes_of(from).view());
        return true;
    }

    std::string word_;
    std::string folder_;
};

} // namespace

std::unique_ptr<Command> examples_command() {
    return std::make_unique<ExamplesCommand>();
}

} // namespace rastertrace
