// SPDX-License-Identifier: MIT
// What the module can be asked for: each function takes a scene as a text, and gives a text. module.js makes
// functions of JavaScript of them.

#include <rastertrace/figures/page.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/problem.h>

#include <exception>
#include <new>
#include <string>

namespace {

using namespace rastertrace;

/// The last answer, which the page reads before it asks again.
std::string answer;
bool is_message = false;

/// Keeps what `ask` says of a scene, or why it says nothing.
template <typename Ask> const char* answer_of(const char* scene_text, Ask&& ask) {
    is_message = true;
    try {
        const auto read = read_scene({.name = "scene", .text = scene_text});
        if (!read) {
            answer = to_text(read.problem());
        } else {
            answer = ask(read.value());
            is_message = false;
        }
    } catch (const Problem& problem) {
        answer = to_text(problem);
    } catch (const std::bad_alloc&) {
        answer = "expected a scene that has room in the memory of a page, found a larger one\n"
                 "hint: draw it with the program";
    } catch (const std::exception& exception) {
        answer = exception.what();
    }
    return answer.c_str();
}

std::string trace_of(const PlannedScene& planned) {
    std::string text;
    StringOutput output(text);
    write_trace(planned.scene, planned.plan, {}, output);
    return text;
}

std::string page_data_of(const PlannedScene& planned, PageDetail detail) {
    const auto trace = read_written_trace({.name = "trace", .text = trace_of(planned)});
    if (!trace)
        throw trace.problem();
    return page_data(trace.value(), detail);
}

} // namespace

extern "C" {

/// True if the last answer is a message that tells why there is no other.
bool rastertrace_is_message() {
    return is_message;
}

/// Sets the language of sentences by its code; one that there is not changes nothing.
void rastertrace_tell_steps_in(const char* code) {
    if (const auto language = language_with_code(code))
        tell_steps_in(*language);
}

/// The trace of a scene, as `rastertrace trace scene.json -o -` writes it.
const char* rastertrace_trace(const char* scene) {
    return answer_of(scene, trace_of);
}

/// What a page shows of a scene: figures/page.h.
const char* rastertrace_page_data(const char* scene) {
    return answer_of(scene, [](const PlannedScene& planned) {
        return page_data_of(planned, PageDetail::at_rest);
    });
}

/// The same while a vertex is moved.
const char* rastertrace_page_data_in_motion(const char* scene) {
    return answer_of(scene, [](const PlannedScene& planned) {
        return page_data_of(planned, PageDetail::in_motion);
    });
}
}
