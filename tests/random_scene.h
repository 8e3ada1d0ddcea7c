// SPDX-License-Identifier: MIT
#pragma once

// Random scenes, the same on every machine: every fill, line, rule of depth, way to shade and scalar, in
// the plane and in space.
//
//     RandomScene(17).text();  // JSON

#include "random_choice.h"

#include <cstdint>
#include <initializer_list>
#include <iomanip>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

class RandomScene {
public:
    explicit RandomScene(std::uint64_t seed)
        : random_(seed), of_mesh_(~seed), of_polygons_(seed * 31 + 7) {}

    std::string text() {
        const int size = random_.pick({8, 16, 24, 40});
        const std::string_view origin =
            random_.pick<std::string_view>({"center", "top-left", "bottom-left"});
        is_in_space_ = random_.chance(2);
        out_ << R"({"canvas":{"width":)" << size << R"(,"height":)" << size << R"(,"origin":")"
             << origin << R"("})";
        put_vertices(origin == "center" ? -size / 2 : 0, size);
        put_primitives();
        if (is_in_space_)
            put_view();
        if (!has_model_ && of_mesh_.chance(6))
            put_concave_face();
        put_method();
        if (random_.chance(8))
            out_ << R"(,"keep":["model","view","clip","divide","canvas","depth","colors"])";
        out_ << "}\n";
        return out_.str();
    }

private:
    /// A number between two whole ones: whole, a decimal, a fraction, or far away.
    std::string number(int low, int high) {
        const std::string base = std::to_string(random_.whole(low, high));
        switch (style_) {
        case 0:
            return base;
        case 1:
            return base + random_.pick<const char*>({"", ".5", ".25", ".75"});
        case 2:
            return base + "." + std::to_string(random_.whole(0, 999999));
        case 3:
            return '"' + std::to_string(random_.whole(low * 7, high * 7)) +
                   random_.pick<const char*>({"/3", "/7", "/11"}) + '"';
        default:
            return random_.chance(4) ? base + random_.pick<const char*>({"e3", "e6", "e9"})
                                     : base + ".5";
        }
    }

    std::string color() {
        std::ostringstream text;
        text << "\"#" << std::hex << std::setfill('0') << std::setw(6) << random_.whole(0, 0xFFFFFF)
             << '"';
        return text.str();
    }

    void put_vertices(int low, int size) {
        count_ = random_.whole(3, 7);
        style_ = random_.whole(0, 4);
        // Some vertices stand on others, or on their rows and columns.
        std::vector<std::string> xs;
        std::vector<std::string> ys;
        const auto among = [this](std::vector<std::string>& known, std::string fresh) {
            if (!known.empty() && random_.chance(5))
                return known[static_cast<std::size_t>(
                    random_.whole(0, static_cast<int>(known.size()) - 1))];
            known.push_back(fresh);
            return fresh;
        };
        out_ << R"(,"vertices":{)";
        for (int i = 0; i < count_; ++i) {
            const int from = is_in_space_ ? -4 : low - 3;
            const int to = is_in_space_ ? 4 : low + size + 3;
            const std::string x = among(xs, number(from, to));
            const std::string y = among(ys, number(from, to));
            out_ << (i == 0 ? "" : ",") << '"' << name(i) << R"(":[)" << x << ',' << y;
            if (is_in_space_ || random_.chance(2))
                out_ << ',' << number(is_in_space_ ? -3 : 1, is_in_space_ ? 3 : 9);
            out_ << ']';
        }
        out_ << '}';
        if (random_.chance(3)) {
            out_ << R"(,"colors":{)";
            for (int i = 0; i < count_; ++i)
                out_ << (i == 0 ? "" : ",") << '"' << name(i) << R"(":)" << color();
            out_ << '}';
        }
    }

    static char name(int i) { return static_cast<char>('A' + i); }

    /// Different vertices for a primitive.
    std::string corners(int count) {
        std::string text;
        while (static_cast<int>(text.size()) < count) {
            const char corner = name(random_.whole(0, count_ - 1));
            if (text.find(corner) == std::string::npos)
                text += corner;
        }
        return text;
    }

    void put_list(std::string_view key, int corner_count, int length) {
        out_ << ",\"" << key << R"(":[)";
        for (int i = 0; i < length; ++i)
            out_ << (i == 0 ? "" : ",") << R"({"vertices":")" << corners(corner_count)
                 << R"(","name":")" << key << i << R"(","color":)" << color() << '}';
        out_ << ']';
    }

    void put_primitives() {
        put_list("triangles", 3, random_.whole(1, 4));
        has_polygons_ = of_polygons_.chance(6);
        if (has_polygons_)
            put_polygon();
        if (random_.chance(3))
            put_list("outlines", 3, 1);
        if (random_.chance(2))
            put_list("lines", 2, random_.whole(1, 3));
        if (random_.chance(6))
            put_list("points", 1, 2);
    }

    /// A polygon, most of which cross themselves.
    void put_polygon() {
        std::string ring;
        for (int i = of_polygons_.whole(3, 7); i > 0; --i)
            ring += name(of_polygons_.whole(0, count_ - 1));
        out_ << R"(,"polygons":[{"vertices":")" << ring << R"(","name":"ring"}])";
    }

    /// An arrow head, its notch more or less deep, from any of its corners on; filled, or its sides.
    void put_concave_face() {
        out_ << R"(,"meshes":[{"name":"head","vertices":{"a":[-3,-2,1],"b":[0,)"
             << of_mesh_.pick<const char*>({"-1", "0.1", R"("1/3")"})
             << R"(,1],"c":[3,-2,1],"d":[0,4,1]},"faces":[")"
             << of_mesh_.pick<const char*>({"abcd", "bcda", "cdab", "dabc", "dcba"}) << R"("])"
             << (is_in_space_ ? of_mesh_.pick<const char*>(
                                    {"", R"(,"draw":"outlines")", R"(,"draw":"hidden-lines")"})
                              : "")
             << "}]";
    }

    void put_view() {
        const std::string_view type = random_.pick<std::string_view>(
            {"frustum", "frustum", "pinhole", "view-plane", "orthographic"});
        const bool looks_up = type == "pinhole";
        has_model_ = random_.chance(2);
        if (has_model_)
            out_ << R"(,"model":[{"rotate":{"axis":)"
                 << random_.pick<const char*>({R"("x")", R"("y")", R"("z")", "[1,2,3]"})
                 << R"(,"degrees":)" << random_.pick({30, 90, 45, 37}) << R"(}},{"translate":[0,0,)"
                 << (looks_up ? 5 : -1) << R"(]}])";
        if (!looks_up && !random_.chance(4))
            out_ << R"(,"camera":{"position":[)" << random_.whole(-1, 1) << ','
                 << random_.whole(-1, 1) << ',' << random_.pick({4, 6, 9})
                 << R"(],"look_at":[0,0,0],"up":[0,1,0]})";
        out_ << R"(,"projection":{"type":")" << type << '"';
        if (type == "frustum")
            out_ << R"(,"fov_y":)" << random_.pick({40, 90}) << R"(,"near":1,"far":)"
                 << random_.pick<const char*>({"17", "9", "\"infinity\""});
        else if (type == "orthographic")
            out_ << R"(,"left":-4,"right":4,"bottom":-4,"top":4,"near":1,"far":20)";
        else
            out_ << R"(,"distance":)" << random_.pick({1, 2});
        out_ << '}';
        if (random_.chance(2))
            out_ << R"(,"viewport":)"
                 << random_.pick<const char*>({R"("fit")", R"({"pixels_per_unit":4})"});
        has_light_ = random_.chance(4);
        if (has_light_)
            out_ << R"(,"light":)"
                 << random_.pick<const char*>(
                        {R"({"direction":[1,2,3]})", R"({"position":[3,4,8]})"});
    }

    void put_choice(std::string_view key, std::initializer_list<std::string_view> values,
                    int of = 1) {
        if (!random_.chance(of))
            return;
        const std::string_view value = random_.pick(values);
        // Polygons stand beside triangles that are filled by rows, and beside no depth buffer.
        if (!has_polygons_ || !(key == "fill" || key == "sample" || key.starts_with("depth")))
            out_ << ",\"" << key << R"(":")" << value << '"';
    }

    void put_method() {
        out_ << R"(,"method":{"scalar":")"
             << random_.pick<std::string_view>({"float", "double", "fixed", "adaptive", "exact"})
             << '"';
        put_choice("fill", {"scanline", "two-halves", "barycentric", "top-left", "fan"});
        if (has_polygons_)
            out_ << R"(,"fill":")" << of_polygons_.pick<const char*>({"scanline", "two-halves"})
                 << R"(","fill_rule":")" << of_polygons_.pick<const char*>({"even-odd", "non-zero"})
                 << R"(","polygon_vertices":")"
                 << of_polygons_.pick<const char*>({"half-open", "turning"}) << R"(","depth":")"
                 << of_polygons_.pick<const char*>({"none", "painter"}) << '"';
        put_choice("line", {"naive", "dda", "bresenham"}, 2);
        put_choice("from", {"first", "low"}, 4);
        put_choice("rounding", {"floor", "nearest", "truncate", "inside", "half-open"}, 2);
        put_choice("ties", {"start", "up", "away", "even", "step"}, 4);
        put_choice("ends", {"both", "first"}, 4);
        put_choice("sample", {"integer", "center"}, 3);
        put_choice("lerp", {"direct", "incremental"}, 3);
        put_choice("snap", {"none", "floor", "truncate", "nearest"}, 6);
        put_choice("depth", {"none", "painter", "linear-z", "inverse-z", "ndc-z"}, 2);
        put_choice("depth_compare", {"less", "greater"}, 6);
        put_choice("depth_at", {"pixel", "rounded-ends"}, 3);
        if (is_in_space_)
            put_choice("cull", {"none", "back", "front", "both"}, 3);
        if (has_light_)
            out_ << R"(,"shade":"lambert")";
        else
            put_choice("shade", {"flat", "faces", "interpolate", "affine"}, 2);
        put_choice("color_lerp", {"axis", "distance", "space"}, 4);
        put_choice("color_rounding", {"nearest", "truncate"}, 4);
        out_ << '}';
    }

    Random random_;
    Random of_mesh_;     ///< by itself: all else is what it is without a mesh
    Random of_polygons_; ///< the same
    bool has_polygons_ = false;
    std::ostringstream out_;
    bool is_in_space_ = false;
    bool has_model_ = false;
    bool has_light_ = false;
    int count_ = 0;
    int style_ = 0;
};

} // namespace rastertrace
