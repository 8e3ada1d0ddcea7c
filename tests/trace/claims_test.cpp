// SPDX-License-Identifier: MIT
// Claims files: a line of a table says what its JSON says, and what is wrong with a file is told.

#include "claims_support.h"
#include "told_problem.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// The message about a text that has a fault.
std::string complaint(const std::string& text) {
    const auto claims = read_claims({"claims.txt", text});
    if (!claims)
        return to_text(claims.problem());
    const auto problem = claims.value().problem();
    return problem ? to_text(*problem) : "";
}

std::string repeated(std::string_view text, std::size_t count) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i)
        all += text;
    return all;
}

/// What claims say, whichever layout they were written in.
std::string content_of(const std::vector<Claim>& claims) {
    std::string text;
    for (const Claim& claim : claims) {
        text += claim.step;
        for (const ClaimedField& field : claim.fields) {
            text += " " + field.name + (field.is_list ? "=[" : "=");
            for (const std::string& value : field.values)
                text += "<" + value + ">";
        }
        for (const std::string& row : claim.picture)
            text += "\n" + row;
        text += "\n";
    }
    return text;
}

/// The texts between lines of dashes, without the comment before the first.
std::vector<std::string> split_by_rules(const std::string& text) {
    std::vector<std::string> parts{""};
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (line == "----")
            parts.emplace_back();
        else if (!line.starts_with("# "))
            parts.back() += line + "\n";
    return parts;
}

/// A text, the message about it, and the hint.
struct Fault {
    std::string text, message, hint = {};
};

/// A line of a table, and the claim that it stands for.
using Form = std::pair<std::string, std::string>;

const std::vector<Form> forms{
    {"y=2: -1/4, 25/8 -> -1..3",
     R"({"step":"scanline","y":2,"left":"-1/4","right":"25/8","from":-1,"to":3})"},
    {"y = -3 : -4.0 , 5->-4 .. 5",
     R"({"step":"scanline","y":-3,"left":-4.0,"right":5,"from":-4,"to":5})"},
    {"ABC y=2: -0.25, 3.125", R"({"step":"scanline","in":"ABC","y":2,"left":-0.25,"right":3.125})"},
    {"y=2: -> -1..3", R"({"step":"scanline","y":2,"from":-1,"to":3})"},
    {"y=2: -1..3", R"({"step":"scanline","y":2,"from":-1,"to":3})"},
    {"y=2: ?, ? -> ?..?",
     R"({"step":"scanline","y":2,"left":null,"right":"?","from":null,"to":null})"},
    {"y=2 depth: 1/3, 1/5", R"({"step":"scanline","y":2,"left_depth":"1/3","right_depth":"1/5"})"},
    {"large.ABC y=2 depth: ?, 0.2",
     R"({"step":"scanline","in":"large.ABC","y":2,"left_depth":null,"right_depth":0.2})"},
    {"(3,2): on", R"({"step":"pixel","x":3,"y":2,"plotted":true})"},
    {"( -3, 2 ): off", R"({"step":"pixel","x":-3,"y":2,"plotted":false})"},
    {"(3,2): ?", R"({"step":"pixel","x":3,"y":2,"plotted":null})"},
    {"(3,2): z 10/3", R"({"step":"pixel","x":3,"y":2,"z":"10/3"})"},
    {"(3,2): 1/z 3/10", R"({"step":"pixel","x":3,"y":2,"inverse_z":"3/10"})"},
    {"(3,2): color #808080", R"({"step":"pixel","x":3,"y":2,"color":"#808080"})"},
    {"(3,2): on, z ?, color gray # as seen",
     R"({"step":"pixel","x":3,"y":2,"plotted":true,"z":null,"color":"gray"})"},
    {"(3,2): outside", R"({"step":"pixel","x":3,"y":2,"inside":false})"},
    {"(3,2) ABC: inside", R"({"step":"pixel","x":3,"y":2,"in":"ABC","inside":true})"},
    {"A screen: 2, 5", R"({"step":"vertex","name":"A","space":"screen","at":[2,5]})"},
    {"A screen: -10/3, 10/3 -> -4, 3",
     R"({"step":"vertex","name":"A","space":"screen","at":["-10/3","10/3"],"snapped":[-4,3]})"},
    {"A screen: ? -> ?",
     R"({"step":"vertex","name":"A","space":"screen","at":null,"snapped":"?"})"},
    {"A object: 1, 2, 3", R"({"step":"vertex","name":"A","space":"object","at":[1,2,3]})"},
    {"A world: 1, 2, 3", R"({"step":"vertex","name":"A","space":"world","at":[1,2,3]})"},
    {"A camera: 1, 2, 3", R"({"step":"vertex","name":"A","space":"camera","at":[1,2,3]})"},
    {"A clip: 1, 2, 3, 4", R"({"step":"vertex","name":"A","space":"clip","at":[1,2,3,4]})"},
    {"A canonical: 1, ?, 3", R"({"step":"vertex","name":"A","space":"canonical","at":[1,null,3]})"},
    {"normal ABC: 0, 0, -4", R"({"step":"face","name":"ABC","normal":[0,0,-4]})"},
    {"centroid ABC: 1/3, 1/3, 3", R"({"step":"face","name":"ABC","centroid":["1/3","1/3",3]})"},
    {"view ABC: -1/3, -1/3, -3", R"({"step":"face","name":"ABC","view":["-1/3","-1/3",-3]})"},
    {"plane AED: 4, 0, 0, 4", R"({"step":"face","name":"AED","plane":[4,0,0,4]})"},
    {"cosine ABC: -0.9879", R"({"step":"face","name":"ABC","cosine":-0.9879})"},
    {"dot ABC: -12", R"({"step":"face","name":"ABC","dot":-12})"},
    {"dot ABC: -12 culled", R"({"step":"face","name":"ABC","dot":-12,"culled":true})"},
    {"dot ABC: 12 drawn", R"({"step":"face","name":"ABC","dot":12,"culled":false})"},
    {"dot ABC: ? ?", R"({"step":"face","name":"ABC","dot":null,"culled":null})"},
    {"ABC: culled", R"({"step":"face","name":"ABC","culled":true})"},
    {"light ABC: 0, 0, 1", R"({"step":"light","name":"ABC","light":[0,0,1]})"},
    {"intensity ABC: 0.5", R"({"step":"light","name":"ABC","intensity":0.5})"},
    {"AB: -1 3 -3 1 -5", R"({"step":"decide","in":"AB","d":[-1,3,-3,1,-5]})"},
    {"AB: -1, 3, ?", R"({"step":"decide","in":"AB","d":[-1,3,null]})"},
    {"edge AB: 3/4", R"({"step":"edge","edge":"AB","dx_dy":"3/4"})"},
    {"ABC edge P1-P2: ?", R"({"step":"edge","in":"ABC","edge":"P1-P2","dx_dy":null})"},
    {"depth ACD (3,2): fails", R"({"step":"depth","in":"ACD","x":3,"y":2,"pass":false})"},
    {"depth ACD (3,2): 1/3 passes",
     R"({"step":"depth","in":"ACD","x":3,"y":2,"depth":"1/3","pass":true})"},
    {"depth (3,2): ? ?", R"({"step":"depth","x":3,"y":2,"depth":null,"pass":null})"},
    {"order: ABC, ACD", R"({"step":"order","names":["ABC","ACD"]})"},
    {"order: ?", R"({"step":"order","names":null})"},
    // As people write it.
    {"y=2: -0,25, 3,125", R"({"step":"scanline","y":2,"left":-0.25,"right":3.125})"},
    {"y=2: -0,25; 3,125", R"({"step":"scanline","y":2,"left":-0.25,"right":3.125})"},
    {"Y = 2: \u2212\u00BC, 3\u215B", R"({"step":"scanline","y":2,"left":"-1/4","right":"25/8"})"},
    {"row y=2: - 1 / 4, 25\u20448", R"({"step":"scanline","y":2,"left":"-1/4","right":"25/8"})"},
    {"2: [-.25; +3 1/8 px]", R"({"step":"scanline","y":2,"left":-0.25,"right":"25/8"})"},
    {"row 2: x from -1/4 to 25/8.", R"({"step":"scanline","y":2,"left":"-1/4","right":"25/8"})"},
    {"1. y=2: (-1/4 ... 25/8)", R"({"step":"scanline","y":2,"left":"-1/4","right":"25/8"})"},
    {"- y=2: xl = -1/4, xr = 5/2 + 5/8",
     R"({"step":"scanline","y":2,"left":"-1/4","right":"25/8"})"},
    {"y=2: 2 + 3/4 (2 - 5), 2 - 3/8 * (2-5) => -1 to 3",
     R"({"step":"scanline","y":2,"left":"-1/4","right":"25/8","from":-1,"to":3})"},
    {"y=2: -1/4|25/8 \u2192 -1, 0, 1, 2, 3",
     R"({"step":"scanline","y":2,"left":"-1/4","right":"25/8","from":-1,"to":3})"},
    {"y=5: 2, 2 -> 2", R"({"step":"scanline","y":5,"left":2,"right":2,"from":2,"to":2})"},
    {"y=2: pixels -1\u20263", R"({"step":"scanline","y":2,"from":-1,"to":3})"},
    {"y=2: 1\u20133", R"({"step":"scanline","y":2,"from":1,"to":3})"},
    {"y=2: -1/4\u00A025/8", R"({"step":"scanline","y":2,"left":"-1/4","right":"25/8"})"},
    {"y=2: left -1/4 right 25/8", R"({"step":"scanline","y":2,"left":"-1/4","right":"25/8"})"},
    {"y=2: left: -1/4, right: 25/8, pixels -1 to 3",
     R"({"step":"scanline","y":2,"left":"-1/4","right":"25/8","from":-1,"to":3})"},
    {"y=2 -> -1..3", R"({"step":"scanline","y":2,"from":-1,"to":3})"},
    {"(3,2) is on", R"({"step":"pixel","x":3,"y":2,"plotted":true})"},
    {"slope of AB: 3/4", R"({"step":"edge","edge":"AB","dx_dy":"3/4"})"},
    {"dx/dy AB = 3/4", R"({"step":"edge","edge":"AB","dx_dy":"3/4"})"},
    {"A(2, 5)", R"({"step":"decide","in":"A","d":[2,5]})"},
    {"(3|2): yes", R"({"step":"pixel","x":3,"y":2,"plotted":true})"},
    {"pixel (3; 2) not drawn", R"({"step":"pixel","x":3,"y":2,"plotted":false})"},
    {"(3,2): z 3,33", R"({"step":"pixel","x":3,"y":2,"z":3.33})"},
    {"slope AB = 3 : 4", R"({"step":"edge","edge":"AB","dx_dy":"3/4"})"},
    {"edge AB: dx/dy = 6 / 8", R"({"step":"edge","edge":"AB","dx_dy":"6/8"})"},
    {"A screen = (2; 5)", R"({"step":"vertex","name":"A","space":"screen","at":[2,5]})"},
    {"A screen: 2 5", R"({"step":"vertex","name":"A","space":"screen","at":[2,5]})"},
    {"AB: [-1, 3, -3]", R"({"step":"decide","in":"AB","d":[-1,3,-3]})"},
    {"angle ABC: 161.6\u00B0", R"({"step":"face","name":"ABC","angle":161.6})"},
    {"weights (3,2): 5/8, 1/72, 13/36",
     R"({"step":"sample","x":3,"y":2,"weights":["5/8","1/72","13/36"]})"},
    {"weights ABC (3,2): (1/2 1/4 1/4)",
     R"({"step":"sample","in":"ABC","x":3,"y":2,"weights":["1/2","1/4","1/4"]})"},
    {"matrix model: [1 0 0 0], [0 1 0 0], [0 0 1 4], [0 0 0 1]",
     R"({"step":"matrix","name":"model","rows":[[1,0,0,0],[0,1,0,0],[0,0,1,4],[0,0,0,1]]})"},
    {"AB x=3: 9/4 -> 2", R"({"step":"along","in":"AB","x":3,"value":"9/4","pixel":2})"},
    {"AB y=3: 2.25", R"({"step":"along","in":"AB","y":3,"value":2.25})"},
    {"the slope of AB is 3/4", R"({"step":"edge","edge":"AB","dx_dy":"3/4"})"},
    {"AB: slope 3/4", R"({"step":"edge","edge":"AB","dx_dy":"3/4"})"},
    {"at y=2 x goes from -1/4 to 25/8",
     R"({"step":"scanline","y":2,"left":"-1/4","right":"25/8"})"},
    {"y=2, left -1/4, right 25/8", R"({"step":"scanline","y":2,"left":"-1/4","right":"25/8"})"},
    {"y=2 -> -1/4, 25/8", R"({"step":"scanline","y":2,"left":"-1/4","right":"25/8"})"},
    {"left edge at y=2: -1/4", R"({"step":"scanline","y":2,"left":"-1/4"})"},
    {"y=2 right: 25/8", R"({"step":"scanline","y":2,"right":"25/8"})"},
    {"row 2 has 5 pixels", R"({"step":"scanline","y":2,"pixel_count":5})"},
    {"ABC has 9 rows", R"({"step":"primitive","name":"ABC","row_count":9})"},
    {"3,2: on", R"({"step":"pixel","x":3,"y":2,"plotted":true})"},
    {"pixel 3, 2 is off", R"({"step":"pixel","x":3,"y":2,"plotted":false})"},
    {"A world: 2, 5", R"({"step":"vertex","name":"A","space":"world","at":[2,5]})"},
    {"AB: y = 4/3 x + 7/3", R"({"step":"edge","edge":"AB","y_form":["4/3","7/3"]})"},
    {"line AB: y=4/3x+7/3", R"({"step":"edge","edge":"AB","y_form":["4/3","7/3"]})"},
    {"edge AB: x = -y - 2", R"({"step":"edge","edge":"AB","x_form":[-1,-2]})"},
    {"AB: y = 7/3 + 4/3 x", R"({"step":"edge","edge":"AB","y_form":["4/3","7/3"]})"},
    {"AB: y = 14 - x", R"({"step":"edge","edge":"AB","y_form":[-1,14]})"},
    {"AB: m = 4/3, b = 7/3", R"({"step":"edge","edge":"AB","y_form":["4/3","7/3"]})"},
    {"slope AC = (2-5)/(5+3) = -3/8", R"({"step":"edge","edge":"AC","dx_dy":"-3/8"})"},
    {"normal ABC: 0,0,-4", R"({"step":"face","name":"ABC","normal":[0,0,-4]})"},
    {"y=2: -1..3, 5 pixels", R"({"step":"scanline","y":2,"pixel_count":5,"from":-1,"to":3})"},
    {"AB: y = 3", R"({"step":"edge","edge":"AB","y_form":[0,3]})"},
    {"edge AB dx/dy 3/4", R"({"step":"edge","edge":"AB","dx_dy":"3/4"})"},
    {"AB pixels: (0,0) (1, 0), (2;1)",
     R"({"step":"primitive","name":"AB","pixels":[0,0,1,0,2,1]})"},
    {"AB: (0,0) -> (1,0)", R"({"step":"primitive","name":"AB","pixels":[0,0,1,0]})"},
    {"ABC: 9 rows, 49 pixels",
     R"({"step":"primitive","name":"ABC","row_count":9,"pixel_count":49})"},
    {"ABC rows: 9", R"({"step":"primitive","name":"ABC","row_count":9})"},
    {"ABC: hidden", R"({"step":"primitive","name":"ABC","visible":false})"},
    {"(3,2) ABC: visible", R"({"step":"pixel","x":3,"y":2,"in":"ABC","visible":true})"},
    {"(3,2): share 3/5", R"({"step":"pixel","x":3,"y":2,"share":"3/5"})"},
    {"y=2: 5 pixels", R"({"step":"scanline","y":2,"pixel_count":5})"},
    {"y=2: 1, 3 -> 1, 2, 4", R"({"step":"scanline","y":2,"left":1,"right":3,"pixels":[1,2,4]})"},
    {"order: ABC -> ACD", R"({"step":"order","names":["ABC","ACD"]})"},
    {R"("A\u2212B" screen: 2, 5)",
     R"({"step":"vertex","name":"A\u2212B","space":"screen","at":[2,5]})"},
    {R"("face 1, upper" y=2: -1..3)",
     R"({"step":"scanline","in":"face 1, upper","y":2,"from":-1,"to":3})"},
    {R"("edge" screen: 2, 5)", R"({"step":"vertex","name":"edge","space":"screen","at":[2,5]})"},
    {R"(normal "screen": 2, 5, 1)", R"({"step":"face","name":"screen","normal":[2,5,1]})"},
    {R"(order: "a \"b\"" #1
     )",
     R"({"step":"order","names":["a \"b\""]})"},
};

TEST(Claims, ALineSaysWhatItsJsonSays) {
    for (const auto& [line, json] : forms)
        EXPECT_EQ(content_of(claims_in(line).claims),
                  content_of(claims_in(R"({"claims":[)" + json + "]}").claims))
            << line;
}

TEST(Claims, APictureIsItsRowsToABlankLine) {
    const Claims table = claims_in("picture:\n  ..#..\n  .###.\n\ny=2: -1..3\n");
    EXPECT_EQ(content_of(table.claims), "picture\n..#..\n.###.\nscanline y=<2> from=<-1> to=<3>\n");
    EXPECT_EQ(content_of(table.claims),
              content_of(claims_in(R"({"claims":[{"picture":["..#..",".###."]},
                  {"step":"scanline","y":2,"from":-1,"to":3}]})")
                             .claims));
    EXPECT_EQ(content_of(claims_in("picture:\n#?.").claims), "picture\n#?.\n");
}

TEST(Claims, AFileSaysItsSceneAndHowItRounds) {
    for (const std::string text :
         {"# by hand\n\nscene: folder/first triangle.json # the worked one\nround: truncate\n",
          "\xEF\xBB\xBFscene: \"folder/first triangle.json\"\r\nround: truncate\r\n",
          R"({"scene":"folder/first triangle.json","round":"truncate","claims":[]})"}) {
        const Claims claims = claims_in(text);
        EXPECT_EQ(claims.scene, "folder/first triangle.json");
        EXPECT_FALSE(claims.only_rounds);
        EXPECT_TRUE(claims.claims.empty());
    }
    EXPECT_TRUE(claims_in("round: nearest").only_rounds);
    EXPECT_EQ(claims_in("y=2: 0..1").scene, "");
}

TEST(Claims, AClaimKnowsWhereItStands) {
    const std::string table = "# rows\n\n  y=2: -1/4, 25/8   # by hand\ny=1: -1..3\n";
    const Claims of_table = claims_in(table);
    ASSERT_EQ(of_table.claims.size(), 2u);
    EXPECT_EQ(of_table.claims[0].line, 3u);
    EXPECT_EQ(of_table.claims[0].text, "y=2: -1/4, 25/8");
    EXPECT_EQ(table.substr(of_table.claims[0].offset, 4), "y=2:");
    EXPECT_EQ(table.substr(of_table.claims[0].find("right")->offset, 4), "25/8");
    EXPECT_EQ(of_table.claims[1].line, 4u);
    EXPECT_EQ(of_table.claims[1].find("left"), nullptr);

    const std::string json = "{\"claims\": [\n{\"step\": \"edge\",\n \"edge\": \"AB\", "
                             "\"dx_dy\": 1},\n{\"picture\": [\"#\"]}]}";
    const Claims of_json = claims_in(json);
    ASSERT_EQ(of_json.claims.size(), 2u);
    EXPECT_EQ(of_json.claims[0].line, 2u);
    EXPECT_EQ(of_json.claims[0].text, R"({"step": "edge", "edge": "AB", "dx_dy": 1})");
    EXPECT_EQ(json.substr(of_json.claims[0].find("edge")->offset, 4), "\"AB\"");
    EXPECT_EQ(of_json.claims[1].line, 4u);
}

TEST(Claims, AreToldFromScenesAndTraces) {
    EXPECT_TRUE(is_claims({"", "# nothing yet\n"}));
    EXPECT_TRUE(is_claims({"", "y=2: 0..1"}));
    EXPECT_TRUE(is_claims({"", R"( {"scene":"a.json","claims":[]})"}));
    EXPECT_FALSE(is_claims({"", R"({"vertices":{"A":[1,2]},"points":["A"]})"}));
    EXPECT_FALSE(is_claims({"", R"({"rastertrace":1,"canvas":{},"steps":[]})"}));
    EXPECT_FALSE(is_claims({"", ""}));
}

TEST(Claims, FaultsOfATableArePointedAt) {
    const std::vector<Fault> faults{
        {"edge AB: 0,75\n\ny=2: -1,3",
         "claims.txt:3:6: expected 2 numbers, found -1,3, which is -1.3, or -1 and 3",
         "this file has decimal commas: a comma with a blank behind it, or a `;`, stands between "
         "two numbers"},
        {"A screen: 2 1/2", "claims.txt:1:11: expected commas between numbers, found 2 1/2, which "
                            "is 5/2, or 2 and 1/2"},
        {"cosine ABC: cos 45", "claims.txt:1:13: expected a number, like 3.125 or 25/8, found cos"},
        {"edge AB: 3 : 0", "claims.txt:1:14: expected a denominator other than 0, found 0"},
        {"y=2: x, 3", "claims.txt:1:6: expected a number, like 3.125 or 25/8, found x"},
        {"y=2: 1/0, 3", "claims.txt:1:6: expected a denominator other than 0, found 1/0"},
        {"y=2: 1, 1e400", "claims.txt:1:9: expected a number up to 1.797e308, found 1e400"},
        {"y=1e-400: 1, 3",
         "claims.txt:1:3: expected 0 or a number from 4.941e-324 on, found 1e-400"},
        {"scene: a.json\n\nscene: b.json",
         "claims.txt:3:1: expected one line `scene:`, found another"},
        {"round: nearest\n round: truncate",
         "claims.txt:2:2: expected one line `round:`, found another"},
        {"y=?: 1, 3", "claims.txt:1:3: expected a whole number, found ?"},
        {"y=2: -> 1..2.5", "claims.txt:1:12: expected a whole number, found 2.5"},
        {"y=2: 1, 2 ->",
         "claims.txt:1:13: expected a number, like 3.125 or 25/8, found the end of the line"},
        {"y=2", "claims.txt:1:4: expected `:`, found the end of the line"},
        {"A scren: 2, 5",
         "claims.txt:1:3: expected a space (object, world, camera, clip, canonical, screen), found "
         "scren",
         "did you mean screen?"},
        {"norml ABC: 0, 0, 4",
         "claims.txt:1:7: expected a space (object, world, camera, clip, canonical, screen), found "
         "ABC",
         "did you mean normal?"},
        {"A clip: 2, 5", "claims.txt:1:13: expected 4 numbers in all, found the end of the line"},
        {"normal ABC: 0, 0, 4, 1", "claims.txt:1:20: expected the end of the line, found ,"},
        {"dot ABC: -12 gone", "claims.txt:1:14: expected culled or drawn, found gone"},
        {"(3,2): onn",
         "claims.txt:1:8: expected on, off, inside, outside, z, 1/z, share or color, found onn",
         "did you mean on?"},
        {"(3,2): color blau", "claims.txt:1:14: expected a color, like #ff8000 or red, found blau"},
        {"(3 2): on", "claims.txt:1:4: expected a comma between x and y, found 2"},
        {"\"AB: 1", "claims.txt:1:1: expected a closing quote, found none"},
        {"round: up", "claims.txt:1:8: expected nearest or truncate, found up"},
        {"scene:", "claims.txt:1:7: expected the name of a scene file, found the end of the line"},
        {"picture:\n..#\n.x.", "claims.txt:3:1: expected a row of ., # and ?, found 'x'",
         "a picture ends with a blank line"},
        {"picture:\n..#\n....",
         "claims.txt:3:1: expected a row of 3 pixels like the first one, found 4",
         "a picture ends with a blank line"},
        {"picture:\n", "claims.txt:2:1: expected the rows of a picture, found none"}};
    for (const auto& [text, message, hint] : faults) {
        EXPECT_THAT(complaint(text), StartsWith(told_problem(text, message, hint)));
        EXPECT_THAT(complaint(text), HasSubstr("\nhint: "));
    }
}

const std::string two_rows =
    "scanline y=<2> left=<-1/4> right=<25/8>\nscanline y=<1> left=<-1> right=<7/2>\n";

TEST(Claims, ColumnsSayWhatTheirHeadsSay) {
    const std::vector<Form> tables{
        {"y,left,right\n2,-1/4,25/8\n1,-1,7/2\n", two_rows},
        {"y;x_L;x_R\r\n2;-1/4;25/8\r\n1;-1;7/2\r\n", two_rows},
        {"Row\tXL\tXR\n2\t-1/4\t3 1/8\n1\t-1\t3 1/2\n", two_rows},
        {"| y | left | right |\n|---|-----:|:------|\n| 2 | \u2212\u00BC | 3\u215B |\n| 1 | -1 | "
         "3\u00BD |\n",
         two_rows},
        {"\\begin{tabular}{rrr}\n$y$ & $x_L$ & $x_R$ \\\\ \\hline\n"
         "2 & $-\\frac{1}{4}$ & $\\frac{25}{8}$ \\\\\n1 & $-1$ & $\\frac72$ \\\\\n\\end{tabular}\n",
         two_rows},
        {"\\begin{tabular}{rrr}\n$y$ & $x_L$ & $x_R$ \\\\ \\hline\n"
         "2 & $-\\frac{1}{4}$ & $\\frac{25}{8}$ \\\\\n1 & $-1$ & $\\dfrac{7}{2}$ "
         "\\\\\n\\end{tabular}\n",
         two_rows},
        {"y;left;right\n2;-0,25;3,125\n", "scanline y=<2> left=<-0.25> right=<3.125>\n"},
        {"y,left,right\n2,\"-0,25\",?\n", "scanline y=<2> left=<-0.25> right=<?>\n"},
        {"k | p_k | (x, y)\n0 | 4 | (2,5)\n1 | 0 | (1,4)\n",
         "decide k=<0> d=<4> place=[<2><5>\ndecide k=<1> d=<0> place=[<1><4>\n"},
        {"## AB\n\nk,d\n0,4\n1,0\n2,\n",
         "decide k=<0> in=<AB> d=<4>\ndecide k=<1> in=<AB> d=<0>\ndecide k=<2> in=<AB> d=<?>\n"},
        {"ABC\ny,pixels\n2,-1..3\n\nACD:\ny,pixels\n2,3\n",
         "scanline in=<ABC> y=<2> from=<-1> to=<3>\nscanline in=<ACD> y=<2> from=<3> to=<3>\n"},
        {"vertex,space,x,y\nA,screen,2,5\n", "vertex name=<A> space=<screen> at=[<2><5>\n"},
        {"world\nvertex,x,y,z\nA,2,5,1\n", "vertex space=<world> name=<A> at=[<2><5><1>\n"},
        {"edge,slope\nAB,3/4\nBC,none\n\nedge AC: -3/8\n",
         "edge edge=<AB> dx_dy=<3/4>\nedge edge=<BC> dx_dy=<none>\nedge edge=<AC> dx_dy=<-3/8>\n"},
        {"face,normal,dot,culled\nABC,\"(0, 0, -4)\",-12,culled\n",
         "face name=<ABC> normal=[<0><0><-4> dot=<-12> culled=<true>\n"},
        {"x,y,drawn\n3,2,yes\n4,2,no\n",
         "pixel x=<3> y=<2> plotted=<true>\npixel x=<4> y=<2> plotted=<false>\n"}};
    for (const auto& [table, content] : tables)
        EXPECT_EQ(content_of(claims_in(table).claims), content) << table;
}

TEST(Claims, FaultsOfColumnsArePointedAt) {
    const std::vector<Fault> faults{
        {"y,k\n2,1\n", "claims.txt:1:1: expected columns that say what was worked out, like `y, "
                       "left, right`, `k, p_k, (x, y)` or `vertex, x, y`, found others"},
    };
    for (const auto& [text, message, hint] : faults)
        EXPECT_THAT(complaint(text), StartsWith(told_problem(text, message, hint)));
    EXPECT_EQ(complaint("y,lefft,right\n2,1,2\n3,1,2\n\ny=2: x, 1\n"),
              "claims.txt:1:3: expected what the column holds, like y, left, right, p_k or (x, y), "
              "found lefft\n"
              "y,lefft,right\n  ^\nhint: did you mean left?\n"
              "claims.txt:5:6: expected a number, like 3.125 or 25/8, found x\ny=2: x, 1\n     ^\n"
              "hint: a line looks like `y=2: -1/4, 25/8 -> -1..3`, `y=2 depth: 1/3, 1/5`");
    const std::string of_cells =
        "\nhint: a cell holds a number, like 25/8 or -0.25, or ? if it is open";
    EXPECT_EQ(complaint("y,left\n2,1,2\n3,x\n"),
              "claims.txt:2:1: expected 2 cells, as the head of the table has, found 3\n"
              "2,1,2\n^" +
                  of_cells +
                  "\nclaims.txt:3:3: expected a number, like 3.125 or 25/8, found x\n3,x\n  ^" +
                  of_cells);
    EXPECT_EQ(complaint(std::string("PK\x03\x04\0\0", 6)),
              "claims.txt: expected text, found a file of a spreadsheet, or an archive\n"
              "hint: in the spreadsheet, save it as CSV");
}

TEST(Claims, ALineThatCannotBeReadCostsNoOther) {
    const Claims claims = claims_in("y=2: 1, 2 -> x\ny=1: -1, 7/2\n\u2192 2: \u2014\n");
    ASSERT_EQ(claims.claims.size(), 3U);
    EXPECT_EQ(claims.claims[0].problem->message, "expected a number, like 3.125 or 25/8, found x");
    EXPECT_EQ(claims.claims[0].problem->column, 14U);
    EXPECT_FALSE(claims.claims[1].problem);
    EXPECT_EQ(claims.claims[2].problem->message, "expected a claim, found ->");
    EXPECT_EQ(claims.claims[2].line, 3U);
    EXPECT_EQ(claims.problem()->further.size(), 1U);
}

TEST(Claims, ADecimalCommaIsThatOfTheWholeFile) {
    // The first line could have two numbers in place of each.
    EXPECT_EQ(
        content_of(claims_in("normal ABC: 1,5, 2,5, 0\ny=2: -0,25, 3,125\n(3,2): on\n").claims),
        "face name=<ABC> normal=[<1.5><2.5><0>\n"
        "scanline y=<2> left=<-0.25> right=<3.125>\n"
        "pixel x=<3> y=<2> plotted=<true>\n");
    EXPECT_FALSE(claims_in("y=2: -1,3\nA screen: 2,5\n").has_decimal_comma);
}

/// A number as somebody types it, and as it is read.
TEST(Claims, NumbersAreReadAsPeopleWriteThem) {
    const std::vector<std::pair<std::string, std::string>> spellings{{"+3/4", "3/4"},
                                                                     {"-3 1/8", "-25/8"},
                                                                     {"3\u00BD", "7/2"},
                                                                     {"-.25", "-0.25"},
                                                                     {"6/8", "6/8"},
                                                                     {"-4e-1", "-4e-1"},
                                                                     {"(2 - 5)/(-4)", "3/4"},
                                                                     {"0.5 / 2", "1/4"},
                                                                     {"2 * 3", "6"},
                                                                     {"2\u00B73", "6"},
                                                                     {"\u2248 0.33", "~0.33"},
                                                                     {"~= 3", "~3"},
                                                                     {"0.33...", "0.33.."},
                                                                     {"0.33 px", "0.33"},
                                                                     {"45\u00B0", "45"},
                                                                     {"sqrt(9/4)", "3/2"},
                                                                     {"\u221A2/2", "sqrt 2/2"},
                                                                     {"3\u03C0/4", "3pi/4"},
                                                                     {"2 sqrt(2)", "2 sqrt(2)"},
                                                                     {"-(1 + 2 (3 + 1))", "-9"}};
    for (const auto& [typed, read] : spellings)
        EXPECT_EQ(claims_in("edge AB: " + typed).claims.at(0).find("dx_dy")->values.at(0), read)
            << typed;
    for (const std::string typed :
         {"1,2,3", "--", "1/", "sqrt(-1)", "sqrt", "(1", "2 +", "1e", "tan 90\u00B0", "x", "3x"})
        EXPECT_NE(complaint("edge AB: " + typed), "") << typed;
    // Brackets within brackets, and a sum of many terms, end.
    EXPECT_NE(complaint("edge AB: " + repeated("(", 10'000) + "1" + repeated(")", 10'000)), "");
    EXPECT_NE(complaint("edge AB: 1" + repeated(" * 1e300", 10'000)), "");
}

TEST(Claims, OfALongLineTheFirstWordTooManyIsRefused) {
    // Twice Bresenham's d, with commas, of the longest line: a canvas is up to 16384 pixels wide.
    const std::size_t most = 65536;
    EXPECT_EQ(claims_in("AB:" + repeated(" 1", most - 2)).claims[0].find("d")->values.size(),
              most - 2);
    for (const std::string word : {" 1", "(", " \"a\""}) {
        const std::string long_line = "AB:" + repeated(word, most);
        const auto claims = read_claims({"claims.txt", long_line});
        ASSERT_FALSE(static_cast<bool>(claims));
        EXPECT_EQ(claims.problem().message, "expected at most 65536 words in a line, found more");
        EXPECT_EQ(claims.problem().column,
                  3 + (most - 2) * word.size() + word.find_first_not_of(' ') + 1);
    }
    // A row of a picture has no words.
    EXPECT_EQ(claims_in("picture:\n" + repeated("..", most + 1)).claims[0].picture[0].size(),
              2 * (most + 1));
}

TEST(Claims, ANumberThatIsTooLongIsRefused) {
    const std::string digits(10'000, '7');
    const auto claims = read_claims({"claims.txt", "y=2: 1, " + digits});
    ASSERT_FALSE(static_cast<bool>(claims));
    EXPECT_EQ(claims.problem().message, "expected a number of at most 1200 characters, found " +
                                            digits.substr(0, 37) + "...");
}

TEST(Claims, ALineOfNoFormIsShownTheForms) {
    for (const std::string text : {"-> 3", "ABC", "= 2", "A, B: 3"})
        EXPECT_NE(complaint(text).find("\nhint: a line looks like `y=2: -1/4, 25/8 -> -1..3`, "),
                  std::string::npos)
            << complaint(text);
}

/// A file of tests/claims.
std::string text_of(const std::string& name) {
    return example_text("../tests/claims/" + name);
}

/// True if all of a sheet is right; false if it cannot be read, which is said with a hint.
bool is_right(const std::string& scene, const std::string& sheet) {
    auto claims = read_claims({"sheet", sheet});
    if (claims) {
        const Checked checked = check(Truth({"scene.json", scene}, {}), std::move(claims.value()));
        return !checked.has_faults();
    }
    EXPECT_THAT(to_text(claims.problem()), HasSubstr("\nhint: ")) << sheet;
    return false;
}

TEST(Claims, ARightSheetIsReadAsPeopleWriteIt) {
    const std::string triangle = example_text("t0-fill/first-triangle.json");
    for (const std::string& sheet : split_by_rules(text_of("spellings.txt")))
        EXPECT_TRUE(is_right(triangle, sheet)) << sheet;
    // Of commas that may be those of decimals, some are refused; none is read as something else.
    const auto second = nlohmann::json::parse(text_of("spellings-second.json"));
    std::size_t read = 0;
    for (const auto& one : second["spellings"]) {
        const std::string scene = second["scenes"][one["scene"].get<std::string>()].dump();
        const auto claims = read_claims({"sheet", one["text"]});
        if (!claims) {
            EXPECT_THAT(to_text(claims.problem()), HasSubstr("`;` between two numbers"));
            continue;
        }
        ++read;
        const Checked checked = check(Truth({"scene.json", scene}, {}), claims.value());
        EXPECT_EQ(!checked.has_faults(), one["right"].get<bool>()) << one["text"];
        EXPECT_EQ(checked.claims.size(), one["claims"].get<std::size_t>()) << one["text"];
    }
    EXPECT_GE(read, 40U);
}

TEST(Claims, SheetsFromTheFieldAreRight) {
    for (const auto& [scene, sheet] : std::vector<std::pair<std::string, std::string>>{
             {"edge-table-y-up", "edge-table-y-up.claims"},
             {"edge-table-y-up", "edge-table-y-up.csv"},
             {"view-matrix", "view-matrix.claims"},
             {"behind-the-eye", "behind-the-eye.claims"}})
        EXPECT_TRUE(is_right(text_of(scene + ".json"), text_of(sheet))) << sheet;
    const Checked unknown = check_claims(example_text("t0-fill/first-triangle.json"),
                                         text_of("one-line-unknown.claims"));
    EXPECT_EQ(unknown.right, 2U);
    EXPECT_EQ(unknown.not_understood, 1U);
}

TEST(Claims, WhatCanBeReadInTwoWaysIsNotGuessed) {
    const std::string triangle = example_text("t0-fill/first-triangle.json");
    for (const std::string sheet : {"y=2: -1/4; 25/8; -1..3", "y=2: -1/4,25/8; -1..3",
                                    "y=2: -1/4, 25/8, -1..3", "y=4: 1,25 | 2,375"})
        EXPECT_TRUE(is_right(triangle, sheet)) << sheet;
    for (const std::string sheet : {"y=2: -0,25 3,125", "y=4: 1,25 / 2,375", "A = 2,0 5,0"})
        EXPECT_THAT(complaint(sheet), HasSubstr("`;` between two numbers")) << sheet;
    EXPECT_THAT(problem_of_claims(triangle, "y=2: -1/4, 25/8, -1, 3"),
                HasSubstr("which is -1/4, 25/8 -> -1, 3, or the ends of spans"));
}

TEST(Claims, FaultsOfJsonArePointedAt) {
    const std::string kinds =
        "triangulate, matrix, vertex, order, primitive, face, light, clip, "
        "edge, half, crossings, scanline, along, decide, sample, depth, pixel, reject, "
        "skip, undecided";
    const std::vector<Fault> faults{
        {R"({"claims": [{"step":"skanline","y":2}]})",
         "claims.txt:1:21: expected a kind of step (" + kinds + "), found \"skanline\"",
         "did you mean \"scanline\"?"},
        {R"({"claims": [{"step":"edge","edge":"AB","dxdy":2}]})",
         "claims.txt:1:40: expected a field of edge (edge, dx_dy, a, b, top_left, octant, y_form, "
         "x_form, m, y_min, y_max, x_start, in), found \"dxdy\"",
         "did you mean \"dx_dy\"?"},
        {R"({"claims": [{"step":"pixel","x":3,"y":2}]})",
         "claims.txt:1:13: expected what is claimed of the pixel, found only which one it is"},
        {R"({"claims": [{"step":"scanline","y":null,"left":1}]})",
         "claims.txt:1:36: expected a whole number, found null"},
        {R"({"claims": [{"step":"scanline","y":2,"left":"1/0"}]})",
         "claims.txt:1:45: expected a denominator other than 0, found \"1/0\""},
        {R"({"claims": [{"step":"scanline","y":2,"left":[1]}]})",
         "claims.txt:1:45: expected one value for left, found an array of 1"},
        {R"({"claims": [{"step":"face","normal":4}]})",
         "claims.txt:1:37: expected a list for normal, found 4"},
        {R"({"claims": [{"picture":["#.","#"]}]})",
         "claims.txt:1:30: expected a row of 2 pixels like the first one, found 1"},
        {R"({"claims": [], "rounded": true})",
         "claims.txt:1:16: expected a key out of scene, round, claims, found \"rounded\"",
         "did you mean \"round\"?"},
        {R"({"claims": [], "round": "up"})",
         "claims.txt:1:25: expected \"nearest\" or \"truncate\", found \"up\""},
        {R"({"vertices": {}})", "claims.txt:1:1: expected claims, found a scene",
         "claims come behind the scene: check SCENE CLAIMS"},
        {R"({"rastertrace": 1})", "claims.txt:1:1: expected claims, found a trace",
         "claims come behind the scene: check SCENE CLAIMS"},
        {R"([])", "claims.txt:1:1: expected claims, found none",
         "claims are a table, or {\"claims\": [...]}"}};
    for (const auto& [text, message, hint] : faults)
        EXPECT_EQ(complaint(text), told_problem(text, message, hint));
}

} // namespace
} // namespace rastertrace
