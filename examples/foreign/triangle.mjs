// SPDX-License-Identifier: MIT
// A rasterizer in JavaScript that tells what it decides: as triangle.c.
//
//     node examples/foreign/triangle.mjs triangle.jsonl
import {Trace} from "./rastertrace_emit.mjs";

const corners = [{name: "A", x: 2, y: 5}, {name: "B", x: -4, y: -3}, {name: "C", x: 5, y: -3}]; // y points up

/// The crossings of a row with the edges, the upper vertex first in an edge's name.
function endsOfRow(y) {
    const ends = [];
    for (let i = 0; i < 3; ++i) {
        const [lower, upper] = [corners[i], corners[(i + 1) % 3]].sort((a, b) => a.y - b.y);
        if (y < lower.y || y > upper.y || lower.y === upper.y)
            continue;
        const x = upper.x + (upper.x - lower.x) / (upper.y - lower.y) * (y - upper.y);
        ends.push({x, edge: upper.name + lower.name});
    }
    return ends.sort((a, b) => a.x - b.x || (a.edge < b.edge ? -1 : 1));
}

const method = {scalar: "double", fill: "scanline", rounding: "floor"};
const trace = new Trace(process.argv[2], 17, 14, "center", {title: "Mine", method});
trace.step("primitive", {kind: "triangle", name: "ABC", vertices: corners.map(corner => corner.name),
    at: corners.map(corner => [corner.x, corner.y]), color: "#000000"});
for (let y = 5; y >= -3; --y) {
    const [left, right] = endsOfRow(y);
    const [from, to] = [Math.floor(left.x), Math.floor(right.x)];
    trace.step("scanline", {y, left: left.x, right: right.x, from, to, left_edge: left.edge, right_edge: right.edge});
    for (let x = from; x <= to; ++x)
        trace.step("pixel", {x, y});
}
trace.end();
