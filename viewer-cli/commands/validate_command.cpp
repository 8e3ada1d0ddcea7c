// SPDX-License-Identifier: MIT
// `rastertrace validate`: whether files are scenes, traces or claims that can be used.

#include "app/command.h"
#include "app/json_text.h"
#include "app/load.h"
#include "app/option_values.h"
#include "app/shared_options.h"

#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/trace/audit/redo.h>
#include <rastertrace/trace/audit/stats_needs.h>
#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/check/claims.h>
#include <rastertrace/trace/check/schema.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/tell/unknown_names.h>
#include <rastertrace/trace/text/byte_order_mark.h>
#include <rastertrace/trace/text/primitive_name.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// The most problems of a file that are told one by one.
constexpr std::size_t most_problems = 100;

/// What was found about a file.
struct ValidatedFile {
    std::string name;
    std::optional<SchemaKind> kind = {}; ///< none: it is none of them
    std::string about = {};              ///< of a valid one: `a scene, 1 triangle, 17 x 14 pixels`
    std::vector<Problem> problems = {};
    std::vector<Problem> remarks = {}; ///< what may be meant so

    bool is_valid() const { return problems.empty(); }

    /// False if there may be more problems than those that are told.
    bool all_told() const { return problems.size() < most_problems; }

    void add(std::vector<Problem> found) {
        for (Problem& problem : found)
            if (problems.size() < most_problems)
                problems.push_back(std::move(problem));
    }
};

std::string about_scene(const Scene& scene, std::size_t frames) {
    std::string about = frames > 1 ? fmt::format("a scene of {} frames", frames) : "a scene";
    for (const PrimitiveKind kind : all_primitives) {
        const auto count =
            std::count_if(scene.primitives.begin(), scene.primitives.end(),
                          [kind](const ScenePrimitive& one) { return one.kind == kind; });
        if (count > 0)
            about += ", " + counted(static_cast<std::uint64_t>(count), name_of(kind));
    }
    return about + fmt::format(", {} x {} pixels", scene.canvas.width, scene.canvas.height);
}

/// Reads every frame, as far as the first that cannot be drawn.
void validate_scene(const Source& source, const InputLimits& limits, ValidatedFile& file) {
    SceneSequence scenes(source, {}, limits, {});
    for (std::size_t frame = 1; frame <= scenes.count(); ++frame) {
        PlannedScene planned = scenes.frame(frame);
        if (frame > 1)
            continue;
        file.remarks = std::move(planned.remarks);
        file.about = about_scene(planned.scene, scenes.count());
    }
}

/// What is found out about the steps of a trace, one after the other.
struct StepsSeen {
    explicit StepsSeen(const Trace& header) : needs(header) {}

    void add(const Trace& trace, std::size_t n) {
        const auto kind = trace.kind_of(n);
        if (!trace.is_plain(n))
            unknown.add(trace.step(n), kind);
        if (kind == StepKind::primitive)
            needs.begin(trace.step(n).as<PrimitiveStep>(), n);
        else if (kind)
            needs.add(*kind, n);
    }

    UnknownNames unknown = {};
    StatsNeeds needs;
};

/// Behind the last step: what is wrong with the whole, what this program does not know, and what
/// can be judged.
void finish_trace(const Trace& trace, StepsSeen& seen, ValidatedFile& file) {
    file.add(trace.passed_over);
    file.add(trace.damage);
    std::stable_sort(file.problems.begin(), file.problems.end(),
                     [](const Problem& a, const Problem& b) { return a.line < b.line; });
    const auto add_remark = [&file](const std::string& remark) {
        file.remarks.push_back(problem_of(file.name, "remark: " + remark));
    };
    for (const std::string& remark : seen.unknown.remarks())
        add_remark(remark);
    if (auto remark = trace.not_finite.remark())
        file.remarks.push_back(*std::move(remark));

    seen.needs.close();
    std::vector<StatsFinding> judged(stats_findings.begin(), stats_findings.end());
    for (const auto& [findings, lacks] : seen.needs.unjudged()) {
        std::erase_if(judged, [&findings = findings](StatsFinding finding) {
            return std::find(findings.begin(), findings.end(), finding) != findings.end();
        });
        if (!trace.is_partial)
            add_remark(fmt::format("stats cannot judge {}: {}", names_of(findings), lacks));
    }
    file.about = fmt::format("a trace of version {}, {}{}, complete; stats can judge {}",
                             trace.version, counted(trace.size(), "step"),
                             trace.is_partial ? " (others were left out)" : "",
                             judged.empty() ? "nothing of it" : names_of(judged));
}

/// Does every step of a trace again, if none has been left out.
void validate_decisions(const Trace& trace, ValidatedFile& file) {
    if (trace.is_partial)
        throw problem_of(file.name, "--redo: expected a trace with all its steps, found one that "
                                    "steps were left out of");
    const Redone redone = redo(trace);
    if (redone.wrong > 0)
        file.add({problem_of(redone, trace)});
    else if (redone.values() == 0)
        throw problem_of(file.name, "--redo: " + nothing_redone());
    file.about += fmt::format("; {} done again", counted(redone.values(), "number"));
}

/// Claims, or a Problem that says why the file was taken for some, if it does not look like it.
Claims claims_in(Source source) {
    const std::size_t first = source.text.find_first_not_of(blanks_and_mark);
    const bool is_table = source.text[first] != '{' && source.text[first] != '[';
    const bool may_be_anything = is_table && source.text.find("scene:") == std::string::npos;
    Result<Claims> claims = read_claims(std::move(source));
    const std::optional<Problem> unread = claims ? claims.value().problem() : claims.problem();
    if (!unread)
        return std::move(claims.value());
    Problem problem = *unread;
    if (may_be_anything)
        problem.message = "taken for claims, since it is no JSON: " + problem.message;
    throw problem;
}

/// Claims can be read; and what they are about is there, if they name their scene.
void validate_claims(Source source, const InputLimits& limits, ValidatedFile& file) {
    const Claims claims = claims_in(std::move(source));
    file.about = counted(claims.claims.size(), "claim");
    if (claims.scene.empty()) {
        file.about += ", which name no scene";
        return;
    }
    file.about += " about " + printable(claims.scene);
    Source scene = load_scene_of_claims(claims, limits);
    const Truth truth = is_trace(scene)
                            ? Truth(value_or_throw(read_trace(std::move(scene), limits.steps)))
                            : Truth(std::move(scene), {}, limits);
    file.add(truth.decided().damage);
    const Checked all = check(truth, claims);
    if (const auto problem = all.problem())
        throw *problem;
    for (const CheckedClaim& checked : all.claims) {
        const Claim& claim = claims.claims[checked.claim];
        const bool has_step = checked.step > 0 || claim.step == "pixel" || claim.step == "picture";
        if (!has_step && !checked.remarks.empty())
            file.remarks.push_back(
                problem_at(claims.source, claim.offset, "remark: " + checked.remarks.front()));
    }
}

std::string_view with_article(SchemaKind kind) {
    switch (kind) {
    case SchemaKind::scene:
        return "a scene";
    case SchemaKind::trace:
        return "a trace";
    case SchemaKind::claims:
        break;
    }
    return "claims";
}

/// What a source is, by its content.
std::optional<SchemaKind> kind_by_content(const Source& source) {
    if (is_trace(source))
        return SchemaKind::trace;
    if (is_claims(source))
        return SchemaKind::claims;
    return is_scene(source) ? std::optional(SchemaKind::scene) : std::nullopt;
}

/// Throws a Problem if a file cannot be of the kind that was asked for.
void refuse_other_kind(const ValidatedFile& file, std::optional<SchemaKind> wanted) {
    if (file.kind && wanted && *file.kind != *wanted)
        throw problem_of(file.name, fmt::format("expected {}, found {}", with_article(*wanted),
                                                with_article(*file.kind)));
}

void print_text(const ValidatedFile& file) {
    for (const std::vector<Problem>& list : {file.problems, file.remarks})
        for (const Problem& problem : list)
            print_error(problem);
    if (!file.all_told())
        print_error(fmt::format("rastertrace: {}: only the first {} problems are told\n",
                                printable(file.name), most_problems));
    if (file.is_valid())
        print(fmt::format("{}: {}\n", printable(file.name), file.about));
}

JsonText json_of(const Problem& problem) {
    const auto number = [](std::size_t value) {
        return value == 0 ? std::nullopt : std::optional(value);
    };
    return {{"file", problem.file},
            {"line", number(problem.line)},
            {"column", number(problem.column)},
            {"message", problem.message},
            {"hint", problem.hint}};
}

JsonText json_of(const ValidatedFile& file) {
    const auto problem_json = [](const Problem& problem) { return json_of(problem); };
    return {{"file", file.name},
            {"kind", file.kind ? JsonText(name_of(*file.kind)) : nullptr},
            {"valid", file.is_valid()},
            {"about", file.is_valid() ? file.about : ""},
            {"problems", JsonText::list(file.problems, problem_json)},
            {"all_told", file.all_told()},
            {"remarks", JsonText::list(file.remarks, problem_json)}};
}

class ValidateCommand final : public Command {
public:
    CommandAbout about() const override {
        return {
            "validate", "Say whether files are scenes, traces or claims that can be used",
            "rastertrace validate examples/t0-fill/first-triangle.json\n\n"
            "What a file is, is found by its content. Exit status 2: one of them is not valid.\n"
            "--schema prints the JSON Schema of a kind of file, for an editor:\n"
            "  rastertrace validate --schema scene > scene.schema.json"};
    }

    void add_to(OptionList& options) override {
        options.option("file", files_, "The files; - for standard input", "FILE");
        options.option("--kind", kind_name_, "What each file has to be", "NAME")
            .values(schema_kind_names());
        options.flag("--redo", redo_,
                     "Do every step of a trace again, and tell the first decision that its numbers "
                     "do not give");
        options.option("--format", format_, "How to print", "NAME").values({"text", "json"});
        options.flag("--json", is_json_, "Short for --format json");
        options.option("--schema", schema_name_, "Print a schema instead", "NAME")
            .values(schema_kind_names());
        input_.add_to(options, Holds::steps);
    }

    void read() override {
        kind_ = value_of("--kind", kind_name_, schema_kind_names(), schema_kind_named);
        schema_ = value_of("--schema", schema_name_, schema_kind_names(), schema_kind_named);
        if (schema_ && !files_.empty())
            refuse_value("--schema", "no file beside it", files_.front());
        if (!schema_ && files_.empty())
            throw problem_of("", "validate: expected a file, found none",
                             "- is standard input; --schema NAME prints a schema");
        if (std::count(files_.begin(), files_.end(), "-") > 1)
            refuse_value("validate", "standard input once", "-");
        if (is_json_ && !format_.empty())
            refuse_value("--json", "no --format beside it", format_);
        is_json_ = is_json(format_, is_json_);
        limits_ = input_.limits();
    }

    int run() override {
        if (schema_) {
            print(schema_of(*schema_));
            return exit_fine;
        }
        bool all_valid = true;
        std::vector<JsonText> reports;
        for (const std::string& path : files_) {
            const ValidatedFile file = validated(path);
            all_valid = all_valid && file.is_valid();
            if (is_json_)
                reports.push_back(json_of(file));
            else
                print_text(file);
        }
        if (is_json_)
            print(JsonText::lines(reports).line());
        return all_valid ? exit_fine : exit_bad_input;
    }

private:
    void validate_trace(Source source, ValidatedFile& file) const {
        const Trace trace = value_or_throw(read_trace_to_tell(std::move(source), limits_.steps));
        StepsSeen seen(trace);
        for (std::size_t n = 1; n <= trace.size(); ++n) {
            if (file.all_told())
                file.add(trace.faults_in_step(n));
            seen.add(trace, n);
        }
        finish_trace(trace, seen, file);
        if (redo_ && file.is_valid())
            validate_decisions(trace, file);
    }

    void validate_source(Source source, ValidatedFile& file) const {
        const std::string_view text = source.view();
        const std::size_t first = text.find_first_not_of(blanks_and_mark);
        const std::string expected =
            kind_ ? std::string(with_article(*kind_)) : "a scene, a trace or claims";
        if (first == std::string::npos)
            throw problem_of(file.name, fmt::format("expected {}, found an empty file", expected));
        file.kind = kind_by_content(source);
        // What is no JSON object could be anything: its reader says what it lacks.
        if (text[first] == '{')
            refuse_other_kind(file, kind_);
        if (kind_)
            file.kind = kind_;
        if (!file.kind)
            throw problem_of(file.name, fmt::format("expected {}, found none of them", expected),
                             R"(a scene has "vertices" or "meshes", a trace begins with )"
                             R"("rastertrace", claims are lines or have "claims")");
        switch (*file.kind) {
        case SchemaKind::scene:
            return validate_scene(source, limits_, file);
        case SchemaKind::trace:
            return validate_trace(std::move(source), file);
        case SchemaKind::claims:
            return validate_claims(std::move(source), limits_, file);
        }
    }

    /// Only what the system cannot do is thrown.
    ValidatedFile validated(const std::string& path) const {
        ValidatedFile file{.name = path == "-" ? "standard input" : path};
        try {
            validate_source(value_or_throw(read_source_or_claims(path, limits_)), file);
        } catch (const Problem& problem) {
            if (problem.cause == Problem::Cause::system)
                throw;
            Problem first = problem;
            const std::vector<Problem> further = std::exchange(first.further, {});
            file.add({first});
            file.add(further);
        }
        return file;
    }

    std::vector<std::string> files_;
    std::string kind_name_;
    std::optional<SchemaKind> kind_; ///< what all of them have to be; none: found by content
    std::string schema_name_;
    std::optional<SchemaKind> schema_; ///< print this one instead
    bool redo_ = false;                ///< do every step of a trace again
    std::string format_;
    bool is_json_ = false;
    InputOptions input_;
    InputLimits limits_;
};

} // namespace

std::unique_ptr<Command> validate_command() {
    return std::make_unique<ValidateCommand>();
}

} // namespace rastertrace
