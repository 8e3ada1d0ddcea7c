// SPDX-License-Identifier: MIT
// rastertrace scene: a scene in another form, as a scene of ours.

#include "command.h"
#include "load.h"

#include <rastertrace/trace/scene/course_text.h>
#include <rastertrace/trace/text/json_document.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <memory>
#include <string>
#include <utility>

namespace rastertrace {

namespace {

class SceneCommandLine final : public Command {
public:
    CommandAbout about() const override {
        return {"scene",
                "Print a scene in the text of a course, an SVG or an OBJ file as a scene of "
                "rastertrace",
                "rastertrace scene examples/conventions/two-triangles.txt"};
    }

    void add_to(OptionList& options) override {
        options
            .option(
                "scene", path_,
                "A text of UIUC CS418 or UCR CS130, an SVG or an OBJ file; - for standard input",
                "FILE")
            .required();
    }

    void read() override {}

    int run() override {
        Source source = load_scene_source(path_);
        if (is_foreign_scene(source)) {
            auto scene = scene_of_foreign(source);
            if (!scene)
                throw scene.problem();
            source = std::move(scene.value());
        } else if (const auto json = parse_json(source); !json) {
            throw json.problem();
        }
        print(source.view());
        return exit_fine;
    }

private:
    std::string path_;
};

} // namespace

std::unique_ptr<Command> scene_command() {
    return std::make_unique<SceneCommandLine>();
}

} // namespace rastertrace
