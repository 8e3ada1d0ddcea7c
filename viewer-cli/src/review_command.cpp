// SPDX-License-Identifier: MIT
// `rastertrace review`: the goldens that have changed, one by one.

#include "command.h"
#include "commands.h"
#include "diff_report.h"
#include "load.h"

#include <rastertrace/trace/compare/diff.h>
#include <rastertrace/trace/compare/diff_rules.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// A trace that waits to become its golden.
struct WaitingGolden {
    std::string golden;
    std::string trace;
};

std::vector<WaitingGolden> waiting_below(const std::string& folder) {
    std::vector<WaitingGolden> waiting;
    std::error_code error;
    for (std::filesystem::recursive_directory_iterator file(folder, error), end;
         !error && file != end; file.increment(error)) {
        const std::string path = file->path().string();
        if (auto golden = golden_of_new_one(path); golden && file->is_regular_file())
            waiting.push_back({*std::move(golden), path});
    }
    if (error)
        throw problem_of_system(folder, "the folder could not be read", error.value());
    std::ranges::sort(waiting, {}, &WaitingGolden::golden);
    return waiting;
}

enum class Answer : std::uint8_t { accept, leave, see, quit };
constexpr std::array<std::string_view, 4> answers{"accept", "leave", "see", "quit"};

/// Asks until one of the letters is typed; the end of the input means to quit.
Answer ask(bool may_accept) {
    for (;;) {
        print(may_accept ? "accept, leave, see, quit? [a/l/s/q] " : "leave, see, quit? [l/s/q] ");
        std::string line;
        if (!std::getline(std::cin, line)) {
            print("\n");
            return Answer::quit;
        }
        for (std::size_t i = may_accept ? 0 : 1; i < answers.size(); ++i)
            if (line == answers[i] || line == answers[i].substr(0, 1))
                return static_cast<Answer>(i);
    }
}

/// What is new about a golden; or why it cannot be accepted.
struct Reviewed {
    std::string summary;
    std::string whole;
    bool may_accept = true;
};

Reviewed reviewed(const WaitingGolden& waiting) {
    const auto text_of = [](const std::string& path) {
        return trace_text(open_trace(path, {}), path, {});
    };
    try {
        const TraceText now = text_of(waiting.trace);
        std::error_code error;
        if (!std::filesystem::exists(waiting.golden, error)) {
            if (const TraceDiff itself = diff(now, now, {}); !itself.damage.empty())
                throw itself.damage.front();
            return {"a golden that is new\n", "a golden that is new\n"};
        }
        DiffOptions options;
        if (const auto rules = rules_beside(waiting.golden, {}))
            options = rules->options;
        const TraceDiff found = diff(text_of(waiting.golden), now, options);
        if (!found.damage.empty())
            throw found.damage.front();
        const std::string whole = diff_text(found);
        return {without_kinds(whole), whole};
    } catch (const Problem& problem) {
        if (problem.cause == Problem::Cause::system)
            throw;
        const std::string text = "cannot be accepted: " + to_text(problem) + "\n";
        return {text, text, false};
    }
}

class ReviewCommandLine final : public Command {
public:
    CommandAbout about() const override {
        return {"review", "Go through changed goldens one by one: accept, leave, see",
                "RASTERTRACE_RENEW=review ctest; rastertrace review tests\n\n"
                "With RASTERTRACE_RENEW=review in the environment, a test of a golden that fails "
                "writes\n"
                "NAME.golden.new.jsonl beside it. What breaks off is never accepted."};
    }

    void add_to(OptionList& options) override {
        options.option("folders", folders_, "Where to look; . if not given", "FOLDER");
    }

    void read() override {
        if (folders_.empty())
            folders_.emplace_back(".");
    }

    int run() override {
        std::vector<WaitingGolden> waiting;
        for (const std::string& folder : folders_)
            std::ranges::move(waiting_below(folder), std::back_inserter(waiting));
        std::size_t left = waiting.size();
        for (std::size_t i = 0; i < waiting.size(); ++i) {
            const Reviewed one = reviewed(waiting[i]);
            print(fmt::format("\n{} of {}: {}\n{}", i + 1, waiting.size(),
                              printable(waiting[i].golden), one.summary));
            Answer answer = ask(one.may_accept);
            for (; answer == Answer::see; answer = ask(one.may_accept))
                print(one.whole);
            if (answer == Answer::quit)
                break;
            if (answer != Answer::accept)
                continue;
            std::filesystem::rename(waiting[i].trace, waiting[i].golden);
            --left;
        }
        print(waiting.empty() ? "no golden has changed\n"
                              : fmt::format("accepted {}, left {}\n", waiting.size() - left, left));
        return left == 0 ? exit_fine : exit_difference;
    }

private:
    std::vector<std::string> folders_;
};

} // namespace

std::unique_ptr<Command> review_command() {
    return std::make_unique<ReviewCommandLine>();
}

} // namespace rastertrace
