// SPDX-License-Identifier: MIT
// What a page may ask of the module. Each function takes a scene as a text, and gives a text.

#include <rastertrace/trace/output.h>
#include <rastertrace/trace/scene_file.h>
#include <rastertrace/trace/write_trace.h>

#include <exception>
#include <string>

namespace {
using namespace rastertrace;

std::string answer;
bool is_answered = false;

/// Keeps what `ask` gives of a scene, or what is wrong with it.
template <typename Ask> const char* answer_of(const char* scene_text, Ask ask) {
    is_answered = false;
    try {
        const Source source{.name = "scene", .text = scene_text};
        const auto read = read_scene(source);
        if (read) {
            answer = ask(read.value());
            is_answered = true;
        } else {
            answer = to_text(read.problem());
        }
    } catch (const Problem& problem) {
        answer = to_text(problem);
    } catch (const std::exception& exception) {
        answer = exception.what();
    }
    return answer.c_str();
}

} // namespace

extern "C" {

/// True if the last text is what was asked for, false if it is a message.
bool rastertrace_is_answered() {
    return is_answered;
}

/// The trace of a scene, as `rastertrace trace scene.json` writes it.
const char* rastertrace_trace(const char* scene_text) {
    return answer_of(scene_text, [](const PlannedScene& planned) {
        std::string text;
        StringOutput output(text);
        write_trace(planned.scene, planned.plan, {}, output);
        return text;
    });
}
}
