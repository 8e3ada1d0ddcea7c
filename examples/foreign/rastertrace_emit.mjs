// SPDX-License-Identifier: MIT
// Writes the trace of a rasterizer. What is wrong, or cannot be written, is thrown.
//
//     const trace = new Trace("mine.jsonl", 17, 14, "center", {title: "Mine", method: {fill: "scanline"}});
//     trace.step("pixel", {x: -1, y: 2});
//     trace.end();
import fs from "node:fs";

const needed = new Map(`triangulate name,matrix name,vertex name space,face dot,primitive kind name,light intensity,
clip plane,edge edge,half half,ray x y,crossings y,skip why,pixel x y,sample x y,scanline y left right from to,
along value pixel,decide x y d move,depth x y depth,reject why`.split(",").map(row => row.trim().split(" ")).map(
    ([kind, ...keys]) => [kind, keys]));

const told = (key, value) => Number.isFinite(value) || typeof value !== "number" ? value : String(value).replace("Infinity", "inf");

export class Trace {
    constructor(path, width, height, origin, header) {
        Object.assign(this, {file: fs.openSync(path, "w"), text: "", count: {}});
        this.write({rastertrace: 1, canvas: {width, height, origin}, ...header}, 0);
    }
    write(line, most) {
        this.text += JSON.stringify(line, told) + "\n";
        if (this.text.length > most)
            [this.text] = ["", fs.writeFileSync(this.file, this.text)];
    }
    step(kind, fields) {
        const place = new Error().stack.split("\n")[2].match(/([^/\\]+:\d+):\d+\)?$/)[1];
        const missing = (needed.get(kind) ?? []).find(key => fields[key] === undefined);
        if (missing || this.file === null)
            throw new Error(`${kind} in ${place}: expected ${missing ?? "it before the end"}`);
        this.count[kind] = (this.count[kind] ?? 0) + 1;
        this.write({step: kind, ...fields, code: place}, 65536);
    }
    end() {
        this.write({end: {steps: Object.values(this.count).reduce((sum, one) => sum + one, 0), count: this.count}}, 0);
        this.file = fs.closeSync(this.file) ?? null;
    }
}
