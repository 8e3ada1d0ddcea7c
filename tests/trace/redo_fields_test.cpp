// SPDX-License-Identifier: MIT
// A trace with one field changed is found by whoever does it again, unless docs/validate.md says that nothing determines
// the field: every field of every kind of step, in every fill, line and way to find depths.

#include "traces.h"

#include <rastertrace/trace/audit/redo.h>
#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {
namespace {

const std::string flat_shapes =
    R"({"canvas":{"width":9,"height":8,"origin":"top-left"},"vertices":{"A":[1.25,0.5],"B":[7.5,2],
       "C":[2.75,6.5],"D":[-2,3.25],"E":[6,7.5]})";
const std::string triangle = flat_shapes + R"(,"triangles":["ABC","BEC"],"method":{)";
const std::string colored =
    flat_shapes + R"(,"colors":{"A":"red","B":"lime","C":"blue"},"triangles":["ABC"],"method":{)";
const std::string line_scene = flat_shapes + R"(,"lines":["AB","DE","CA"],"method":{)";
const std::string outline = flat_shapes + R"(,"outlines":["ABC"],"method":{)";
const std::string polygon = flat_shapes + R"(,"polygons":["ABEDC","ABCBE"],"method":{)";
const std::string deep =
    R"({"canvas":{"width":8,"height":8,"origin":"top-left"},"vertices":{"A":[0,0.5,3],"B":[7,1,5],
       "C":[1,6.5,4],"D":[6,7,2],"E":[0,4,6]},"triangles":["ABC","ADE"],"lines":["AD","EB"],
       "points":["C"],"keep":["depth"],"method":{"depth":"linear-z",)";
const std::string seen_scene =
    R"({"canvas":{"width":14,"height":12},"meshes":[{"name":"m","vertices":{"A":[-1,-1,0],"B":[1,-1,0.5],
       "C":[0,1,0],"D":[0.25,0,2]},"faces":["ABC","ABD","BCD","CAD"],"color":"#8090a0",
       "model":[{"rotate":{"axis":"x","degrees":30}},{"scale":[1,2,1]}],"draw":")";
const std::string camera =
    R"("}],"camera":{"position":[1,2,5],"look_at":[0,0.5,0]},"light":{"direction":[1,2,3]},
       "projection":{"type":"frustum","fov_y":50,"near":1,"far":9},"method":{)";

const std::vector<std::string> scenes{
    triangle + R"("fill":"scanline"}})",
    triangle + R"("fill":"scanline","lerp":"incremental","rounding":"inside","scalar":"exact"}})",
    triangle + R"("fill":"two-halves","rounding":"half-open","sample":"center","scalar":"float"}})",
    triangle + R"("fill":"top-left"}})",
    triangle + R"("fill":"top-left","scalar":"exact"}})",
    triangle + R"("fill":"top-left","scalar":"fixed"}})",
    triangle + R"("fill":"barycentric","scalar":"float"}})",
    triangle + R"("fill":"fan","fan_passes":2}})",
    colored + R"("fill":"scanline","scalar":"fixed"}})",
    colored + R"("fill":"barycentric","scalar":"exact"}})",
    colored + R"("fill":"fan"}})",
    line_scene + R"("line":"bresenham"}})",
    line_scene + R"("line":"bresenham","ties":"step","ends":"first"}})",
    line_scene + R"("line":"naive"}})",
    line_scene + R"("line":"dda","scalar":"exact"}})",
    line_scene + R"("line":"diamond-exit","sample":"center","scalar":"float"}})",
    outline + R"("line":"bresenham"}})",
    outline + R"("line":"naive","scalar":"fixed"}})",
    polygon + R"("scalar":"exact"}})",
    polygon + R"("fill_rule":"non-zero","lerp":"incremental"}})",
    flat_shapes + R"(,"circles":[{"center":"A","radius":4}],"points":["B","D"]})",
    deep + R"("fill":"scanline","scalar":"exact"}})",
    deep + R"("fill":"two-halves","depth_at":"rounded-ends","line":"dda"}})",
    deep + R"("fill":"top-left","scalar":"float","line":"naive"}})",
    deep + R"("fill":"barycentric","scalar":"fixed","line":"diamond-exit"}})",
    R"({"canvas":{"width":8,"height":8},"vertices":{"A":[-3,-2.5,3],"B":[3,-2,5],"C":[0.25,3.5,4],
       "D":[3,3,2]},"triangles":["ABC","BCD"],"keep":["depth"],"method":{"depth":"linear-z",
       "fill":"top-left","scalar":"adaptive","depth_compare":"greater"}})",
    seen_scene + "triangles" + camera + R"("cull":"back","shade":"lambert","scalar":"exact"}})",
    seen_scene + "triangles" + camera + R"("cull":"front","shade":"lambert","fill":"top-left"}})",
    seen_scene + "triangles" + camera + R"("cull":"light","scalar":"adaptive"}})",
    seen_scene + "triangles" + camera + R"("depth":"painter","snap":"nearest","scalar":"float"}})",
    seen_scene + "hidden-lines" + camera + R"("cull":"none","scalar":"exact"}})",
    seen_scene + "hidden-lines" + camera + R"("line":"naive"}})",
    R"({"canvas":{"width":9,"height":9},"vertices":{"A":[-1,-1,-3],"B":[1,-1,-3],"C":[0,1,0.5]},
       "triangles":["ABC"],"outlines":["ACB"],"projection":{"type":"frustum","fov_y":90,"near":1,"far":9},
       "method":{"depth":"none","scalar":"exact"}})",
    R"({"canvas":{"width":9,"height":9},"vertices":{"A":[-4,-4,-0.5],"B":[4,-4,-3],"C":[0,4,-3]},
       "colors":{"A":"#f0000080","B":"#00f00090","C":"#0000f0a0"},"triangles":["ABC"],
       "projection":{"type":"orthographic","left":-4.5,"right":4.5,"bottom":-4.5,"top":4.5,"near":1,"far":9},
       "method":{"scalar":"exact"}})",
    R"({"canvas":{"width":12,"height":12,"origin":"top-left"},"meshes":[{"vertices":{"A":[0,0],"B":[10,0],
       "C":[10,10],"D":[5,3],"E":[0,10]},"faces":["ABCDE"]}]})",
    R"({"canvas":{"width":12,"height":12,"origin":"top-left"},"meshes":[{"vertices":{"A":[0,0],"B":[10,0],
       "C":[10,10],"E":[0,10]},"faces":["ABCE"]}]})",
    R"({"canvas":{"width":6,"height":6,"origin":"top-left"},"vertices":{"A":["9007199254740991/18014398509481984",
       "9007199254740991/18014398509481984"],"B":["4503599627370498/9007199254740992",
       "4503599627370497/9007199254740992"],"C":[5.25,"4503599627370497/9007199254740992"],"D":[1,1e20]},
       "triangles":["ABC"],"lines":["BD"],"method":{"scalar":"adaptive","fill":"top-left","line":"naive"}})",
};

/// Other values for one: of a list, with its first and with its last element changed.
std::vector<std::string> others_of(std::string_view json, FieldType type, bool is_color) {
    if (json.starts_with('[')) {
        const auto elements = elements_of(json);
        std::vector<std::string> lists;
        for (const std::size_t i :
             std::set<std::size_t>{0, elements.empty() ? 0 : elements.size() - 1}) {
            if (elements.empty())
                break;
            for (const std::string& other : others_of(elements[i], type, is_color)) {
                std::vector<std::string> list(elements.begin(), elements.end());
                list[i] = other;
                lists.push_back("[" + joined(list, ",") + "]");
            }
        }
        return lists;
    }
    if (json == "true" || json == "false")
        return {json == "true" ? "false" : "true"};
    if (is_color)
        return {R"("#123456")"};
    if (json == "null")
        return {"1"};
    if (const auto number = TracedNumber(json).exact();
        number && (type == FieldType::quantity || type == FieldType::whole)) {
        const Rational other = *number + 1;
        return {json.starts_with('"') ? '"' + other.get_str() + '"'
                : json.find_first_of(".e") == std::string_view::npos
                    ? other.get_str()
                    : fmt::format("{}", nearest_double(other))};
    }
    // Another word of the same kind, where there is one.
    constexpr std::array words{"E",       "NE",      "lower",     "upper",  "object", "world",
                               "camera",  "clip",    "canonical", "screen", "line",   "triangle",
                               "outline", "polygon", "point",     "circle"};
    for (std::size_t i = 0; i < words.size(); ++i)
        if (TracedText(json) == words[i])
            return {'"' + std::string(words[i ^ 1]) + '"'};
    return {'"' + TracedText(json).text() + "x\""};
}

/// The fields that docs/validate.md lists: `kind.field`.
std::set<std::string> listed() {
    std::ifstream file(std::string(RASTERTRACE_EXAMPLES) + "/../docs/validate.md");
    std::ostringstream text;
    text << file.rdbuf();
    const std::string page = text.str();
    const std::size_t begin = page.find("Nothing determines");
    std::set<std::string> fields;
    if (begin == std::string::npos)
        return fields;
    const auto parts = split_at(page.substr(begin, page.find("\n## ", begin) - begin), '`');
    for (std::size_t i = 1; i < parts.size(); i += 2)
        if (parts[i].find('.') != std::string::npos)
            fields.insert(parts[i]);
    return fields;
}

TEST(RedoFields, EachThatIsChangedIsFoundOrListed) {
    std::map<std::string, int> missed;
    std::set<std::string> changed;
    for (const std::string& scene : scenes) {
        const std::string text = trace_text(scene_in(scene), in_lines);
        const Trace right = sound_trace(text);
        if (const Redone redone = redo(right); redone.wrong > 0)
            ADD_FAILURE() << scene << "\n" << to_text(problem_of(redone, right));
        const auto lines = split_at(text, '\n');
        std::map<std::string, int> counts;
        for (std::size_t i = 1; i + 2 < lines.size(); ++i) {
            const StepView step = right.step(i);
            for (const StepField& field : fields_of(*step.kind())) {
                const auto value = step.field(field.name);
                const std::string name =
                    std::string(name_of(*step.kind())) + "." + std::string(field.name);
                if (!value || ++counts[name] % 7 != 1)
                    continue;
                changed.insert(name);
                const FieldType type = field.type == FieldType::list ? field.element : field.type;
                for (const std::string& other : others_of(*value, type, field.is_color)) {
                    if (other == *value)
                        continue;
                    auto copy = lines;
                    const std::string key = fmt::format("\"{}\":", field.name);
                    copy[i].replace(copy[i].find(key + *value) + key.size(), value->size(), other);
                    const auto trace = read_trace({"trace.json", joined(copy, "\n")});
                    if (trace && trace.value().damage.empty() && redo(trace.value()).wrong == 0) {
                        ++missed[name];
                        if (!listed().contains(name))
                            ADD_FAILURE()
                                << name << ": " << *value << " changed to " << other << "\n"
                                << lines[i] << "\n"
                                << scene;
                    }
                }
            }
        }
    }
    for (std::size_t kind = 0; kind < step_kinds; ++kind)
        for (const StepField& field : fields_of(static_cast<StepKind>(kind)))
            EXPECT_TRUE(
                changed.contains(std::string(step_names[kind]) + "." + std::string(field.name)))
                << step_names[kind] << "." << field.name;
    for (const std::string& name : listed())
        EXPECT_GT(missed[name], 0) << name << " is always found";
}

} // namespace
} // namespace rastertrace
