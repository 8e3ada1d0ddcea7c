// A trace, to be clicked through. The sentences are the program's: this script fills numbers into them, remembers which
// step drew which pixel, and paints. It draws nothing by itself: every pixel of every frame is a step of the trace, or, while
// a scene is turned, one of the picture that the program has drawn.

// --- what was told -------------------------------------------------------------------------------------------------

const PASSES = 1, STORED = 2;         // flags of depth tests
const ROWS = ["scanline", "along", "decide", "ray"]; // kinds that begin a row
const LEVELS = {edge: 1, half: 1, ray: 1, crossings: 1, scanline: 1, along: 1, decide: 1, sample: 1, face: 1, light: 1, clip: 1,
                skip: 1, undecided: 1, depth: 2, pixel: 2, reject: 2};

/** A trace as lists that a step, a pixel or a primitive is looked up in. Steps count from 1; 0 is before the first. */
function readTrace(data) {
  const count = data.step_kinds.length, {width, height} = data.canvas, pixels = width * height;
  const ints = () => new Int32Array(count + 1);
  const kindNames = data.kinds.map(kind => kind[0]);
  const placeOf = Object.fromEntries(kindNames.map((name, i) => [name, i]));
  const trace = {
    data, count, width, height, pixels, kindNames, words: data.words,
    pieces: data.kinds.map(kind => kind.slice(1)),
    kind: ints(), fills: ints(), at: ints().fill(-1), own: ints().fill(-1), primitive: ints().fill(-1),
    over: ints(),        // the step that a pixel step draws over, or whose depth a test replaces
    scanline: ints(),    // the last one of the primitive
    touches: [],         // of each pixel the steps about it
    primitives: [], rejects: [], answers: null,
    areas: [],           // of a step, if it is about more than a pixel
  };
  for (let i = 0; i < data.primitives.length; i += 7) {
    const [step, name, kind, color, group, corners, names] = data.primitives.slice(i, i + 7);
    const points = [];
    for (let k = 0; k < corners.length; k += 2) points.push({x: corners[k], y: corners[k + 1]});
    trace.primitives.push({step, name: data.words[name], kind: data.words[kind], color: data.words[color], group, points,
                           names: names.map(word => data.words[word])});
  }
  // Which step is which: `own` is its place in the list of its kind.
  const places = {};
  const drawn = new Int32Array(pixels), stored = new Int32Array(pixels);
  let fill = 0, primitive = -1, scanline = 0;
  for (let n = 1; n <= count; ++n) {
    const kind = trace.kind[n] = data.step_kinds[n - 1];
    trace.fills[n] = fill;
    fill += trace.pieces[kind].length - 1;
    const at = trace.at[n] = data.at[n - 1];
    const name = kindNames[kind];
    const own = trace.own[n] = places[name] = (places[name] ?? -1) + 1;
    if (name === "primitive") { ++primitive; scanline = 0; }
    if (name === "scanline") scanline = n;
    trace.primitive[n] = primitive;
    trace.scanline[n] = scanline;
    if (at >= 0) {
      (trace.touches[at] ??= []).push(n);
      if (name === "pixel") { trace.over[n] = drawn[at]; drawn[at] = n; }
      if (name === "depth" && data.depths[3 * own] & STORED) { trace.over[n] = stored[at]; stored[at] = n; }
    }
  }
  for (let i = 0; i < data.areas.length; i += 5) {
    const [n, left, right, top, bottom] = data.areas.slice(i, i + 5);
    trace.areas[n] = {step: n, left, right, top, bottom};
    if (kindNames[trace.kind[n]] === "reject") trace.rejects.push(trace.areas[n]);
  }
  for (let i = 0; i < data.about.length; i += 2)
    trace.primitive[data.about[i]] = trace.primitives.findIndex(one => one.step === data.about[i + 1]);
  trace.placeOf = placeOf;
  if (data.answers) trace.answers = findAnswers(data.answers, pixels);
  return trace;
}

/** Where the answer about each pixel begins: they are of different lengths. */
function findAnswers({patterns, pixels: list}, pixels) {
  const starts = new Int32Array(pixels);
  const length = place => patterns[list[place]].length; // of a sentence: its pattern and its fills
  let place = 0;
  for (let i = 0; i < pixels; ++i) {
    starts[i] = place;
    place += length(place) + 1;
    const told = list[place++];
    for (let k = 0; k < told; ++k) place += 2 + length(place + 2);
    place += 1 + list[place];
  }
  return {patterns, list, starts};
}

/** The pieces of a sentence with its fills between them. */
function filled(pieces, fill) {
  let text = pieces[0];
  for (let i = 1; i < pieces.length; ++i) text += fill(i - 1) + pieces[i];
  return text;
}

/** What a step says, with a mark if its numbers give something else. */
function sentenceOf(trace, n) {
  const sentence = filled(trace.pieces[trace.kind[n]], i => trace.words[trace.data.fills[trace.fills[n] + i]]);
  const marks = trace.data.marks ?? [];
  const mark = marks.findIndex((step, i) => i % 2 === 0 && step === n);
  return mark < 0 ? sentence : sentence + trace.words[marks[mark + 1]];
}

/** What is told of a pixel: the answer, why others have not drawn it, how many these are, what is not told. */
function answerOf(trace, pixel) {
  const {patterns, list, starts} = trace.answers;
  let place = starts[pixel];
  const sentence = () => {
    const pieces = patterns[list[place++]];
    return filled(pieces, () => trace.words[list[place++]]);
  };
  const word = () => trace.words[list[place++]];
  const result = {answer: sentence(), count: list[place++], whyNot: [], lacks: []};
  for (let told = list[place++]; told > 0; --told)
    result.whyNot.push({primitive: word(), reason: word(), sentence: sentence()});
  for (let lines = list[place++]; lines > 0; --lines) result.lacks.push(word());
  return result;
}

// --- elements --------------------------------------------------------------------------------------------------------

/** #rrggbb or #rrggbbaa as a word of an ImageData. */
function wordOf(color) {
  const digits = color.trim().slice(1), byte = i => parseInt(digits.slice(2 * i, 2 * i + 2), 16);
  return (byte(0) | byte(1) << 8 | byte(2) << 16 | (digits.length > 6 ? byte(3) : 255) << 24) >>> 0;
}
const gray = level => (level | level << 8 | level << 16 | 255 << 24) >>> 0;

const svgNames = "http://www.w3.org/2000/svg";
function shape(name, attributes, text) {
  const element = document.createElementNS(svgNames, name);
  for (const key in attributes) element.setAttribute(key, attributes[key]);
  if (text !== undefined) element.textContent = text;
  return element;
}

/** The sides of a primitive. */
function sidesOf({points}) {
  const count = points.length === 2 ? 1 : points.length;
  return points.length < 2 ? [] : Array.from({length: count}, (_, i) => [points[i], points[(i + 1) % points.length]]);
}

function swatch(color) {
  const box = document.createElement("span");
  box.className = "swatch";
  box.style.background = color;
  return box;
}

function element(name, className, text) {
  const one = document.createElement(name);
  if (className) one.className = className;
  if (text !== undefined) one.textContent = text;
  return one;
}

/** A sentence: several blanks stand between its parts, which are not broken if there is room. */
function parts(text) {
  return text.split(/( {2,})/).map((part, i) => element("span", i % 2 ? "gap" : "part", part));
}

const numberIn = text => { const [above, below = 1] = String(text).split("/").map(Number); return above / below; };

// --- the player ------------------------------------------------------------------------------------------------------

/**
 * Shows frames in the root of an element, and lets a reader go through them.
 *
 * options: keys and words in each language (page.cpp), language, title; view, step, scene and whether it is movable, if given. `program`
 * draws a changed scene; none if undefined. What it returns is what the element does: goTo(step), setView(name), repaint() in other colors, end().
 */
function startPlayer(host, options, frames, program) {
const root = host.shadowRoot, by = id => root.getElementById(id);
const isPage = host.hasAttribute("whole-page"); // keys and the address are the player's
const gone = new AbortController(), until = {signal: gone.signal};

/** Words around the picture in the language of steps, with values for their {}; as they are if the table has none. */
function say(text, ...values) {
  return (options.words[options.language]?.[text] ?? text).replace(/\{\}/g, () => values.shift());
}
const saidOf = n => n === 0 ? say("nothing drawn yet") : sentenceOf(trace, n);

let frame = 0, trace, step = 0, view = "plotted";
let told, toldOf;                      // the step that listeners were told of, and its trace
let drawnBy, storedBy, writes;         // of each pixel: the step that drew it, that its depth is of, how often
let seen;                              // how many pixels show each group of faces
let cursor = -1, hovered = -1;         // pixels
let zoom = 1, hasWorking = true, typed = "", rate = 4, timer = 0;
const nameOf = n => n === 0 ? "" : trace.kindNames[trace.kind[n]];
const xOf = pixel => trace.data.canvas.left + pixel % trace.width;
const yOf = pixel => trace.data.canvas.top + trace.data.canvas.down * Math.floor(pixel / trace.width);

const groupOf = n => trace.primitive[n] < 0 ? -1 : trace.primitives[trace.primitive[n]].group;
function see(n, more) { if (n > 0 && groupOf(n) >= 0) seen[groupOf(n)] += more; }

/** What commands call the input. A scene whose vertices were moved has no file. */
const fileOf = () => hasMoved ? null : frames[frame].file || "FILE";

/** Plays the steps between here and there, forward or back, and returns the pixels that have changed. */
function play(to) {
  const changed = [];
  const {data, at, over, own, kind, placeOf} = trace, PIXEL = placeOf.pixel, DEPTH = placeOf.depth;
  while (step < to) {
    const n = ++step, pixel = at[n];
    if (pixel < 0) continue;
    if (kind[n] === PIXEL) { see(drawnBy[pixel], -1); see(n, 1); drawnBy[pixel] = n; ++writes[pixel]; changed.push(pixel); }
    else if (kind[n] === DEPTH && data.depths[3 * own[n]] & STORED) { storedBy[pixel] = n; changed.push(pixel); }
  }
  while (step > to) {
    const n = step--, pixel = at[n];
    if (pixel < 0) continue;
    if (kind[n] === PIXEL) { see(over[n], 1); see(n, -1); drawnBy[pixel] = over[n]; --writes[pixel]; changed.push(pixel); }
    else if (kind[n] === DEPTH && data.depths[3 * own[n]] & STORED) { storedBy[pixel] = over[n]; changed.push(pixel); }
  }
  return changed;
}

// --- the picture -----------------------------------------------------------------------------------------------------

const raster = by("raster"), overlay = by("overlay"), sheet = by("sheet"), scroller = by("scroller");
const brush = raster.getContext("2d", {willReadFrequently: true}); // pixels are put one by one
let image, shades, layout;

/** The colors in force: those of the style sheet, light or dark. */
function readColors() {
  const style = getComputedStyle(host), color = name => wordOf(style.getPropertyValue("--" + name));
  shades = {
    plotted: color("plotted"), current: color("current"),
    faces: Array.from({length: 8}, (_, i) => color("face-" + (i + 1))),
    own: new Map(),
  };
}

function ownColor(n) {
  const word = trace.data.pixels[trace.own[n]];
  if (!shades.own.has(word)) shades.own.set(word, wordOf(trace.words[word]));
  return shades.own.get(word);
}

const emptyColor = () => view === "shade" && trace.data.canvas.background ? wordOf(trace.data.canvas.background) : 0;

function colorOf(pixel) {
  const n = drawnBy[pixel];
  if (view === "depth") return storedBy[pixel] ? gray(trace.data.depths[3 * trace.own[storedBy[pixel]] + 1]) : 0;
  if (n === 0) return emptyColor();
  if (view === "plotted") return n === step ? shades.current : shades.plotted;
  if (view === "faces") return groupOf(n) < 0 ? shades.plotted : shades.faces[groupOf(n) % 8];
  if (view === "shade") return ownColor(n);
  const grays = trace.data.write_grays;
  return gray(grays[Math.min(writes[pixel], grays.length) - 1]);
}

/** Paints pixels, or all of them. */
function paint(pixels) {
  const words = new Uint32Array(image.data.buffer), empty = emptyColor();
  if (!pixels || pixels.length > 4000) {
    for (let i = 0; i < trace.pixels; ++i) words[i] = drawnBy[i] || storedBy[i] ? colorOf(i) : empty;
    brush.putImageData(image, 0, 0);
  } else {
    for (const pixel of pixels) {
      words[pixel] = colorOf(pixel);
      brush.putImageData(image, 0, 0, pixel % trace.width, Math.floor(pixel / trace.width), 1, 1);
    }
  }
}

/** How large pixels are, and where the picture is on its sheet. */
function lay() {
  const {width, height} = trace, {left, top, down} = trace.data.canvas;
  const bottom = top + down * (height - 1);
  const digits = Math.max(String(top).length, String(bottom).length);
  const margin = {left: 10 + 7 * digits, bottom: 20, top: 8, right: 12};
  const isNarrow = host.clientWidth < 900;
  const room = {width: scroller.clientWidth - margin.left - margin.right,
                height: (!isPage ? 420 : isNarrow ? innerHeight * 0.58 : innerHeight - 235) - margin.top - margin.bottom};
  let cell = Math.min(room.width / width, Math.max(room.height, 160) / height, 60) * zoom;
  cell = cell >= 2 ? Math.floor(cell * 2) / 2 : Math.max(cell, 1 / 16);
  layout = {cell, margin, left: margin.left, top: margin.top,
            width: width * cell, height: height * cell};
  sheet.style.width = `${layout.width + margin.left + margin.right}px`;
  sheet.style.height = `${layout.height + margin.top + margin.bottom}px`;
  raster.width = width;
  raster.height = height;
  Object.assign(raster.style, {left: `${margin.left}px`, top: `${margin.top}px`, width: `${layout.width}px`,
                               height: `${layout.height}px`});
  image = brush.createImageData(width, height);
  overlay.replaceChildren(backdrop(), shape("g", {id: "cells"}), shape("g", {id: "marks"}));
  paint();
  drawCells();
  drawMarks();
  if (options.movable && scene) placeHandles();
}

/** The middle of a pixel, and a place of the scene, on the sheet. A pixel is a square around its sample. */
const middleOf = pixel => ({x: layout.left + (pixel % trace.width + 0.5) * layout.cell,
                            y: layout.top + (Math.floor(pixel / trace.width) + 0.5) * layout.cell});
function placeOf({x, y}) {
  const {left, top, down, sample} = trace.data.canvas;
  return {x: layout.left + (x - left - sample + 0.5) * layout.cell,
          y: layout.top + ((y - sample - top) * down + 0.5) * layout.cell};
}
const squareOf = (pixel, grown) => ({
  x: layout.left + pixel % trace.width * layout.cell - grown,
  y: layout.top + Math.floor(pixel / trace.width) * layout.cell - grown,
  width: layout.cell + 2 * grown, height: layout.cell + 2 * grown, fill: "none"});

/** What no step changes: grid, axes and their numbers, samples. */
function backdrop() {
  const group = shape("g", {}), {left, top, width, height, cell} = layout, canvas = trace.data.canvas;
  let grid = "";
  if (cell >= 5) {
    for (let i = 1; i < trace.width; ++i) grid += `M${left + i * cell} ${top}v${height}`;
    for (let i = 1; i < trace.height; ++i) grid += `M${left} ${top + i * cell}h${width}`;
  }
  group.append(shape("path", {class: "grid", d: grid}));
  if (canvas.tests_samples && cell >= 14) {
    const dots = shape("pattern", {id: "samples", x: left, y: top, width: cell, height: cell, patternUnits: "userSpaceOnUse"});
    dots.append(shape("circle", {class: "sample", cx: cell / 2, cy: cell / 2, r: 1.4}));
    group.append(dots, shape("rect", {x: left, y: top, width, height, fill: "url(#samples)"}));
  }
  const zero = placeOf({x: 0, y: 0});
  let axes = "";
  if (left < zero.x && zero.x < left + width) axes += `M${zero.x} ${top}v${height}`;
  if (top < zero.y && zero.y < top + height) axes += `M${left} ${zero.y}h${width}`;
  group.append(shape("path", {class: "axis", d: axes}), shape("rect", {class: "border", x: left, y: top, width, height}));
  const every = room => [1, 2, 5, 10, 20, 50, 100, 200, 500].find(step => step * cell >= room) ?? 1000;
  const widest = Math.max(String(canvas.left).length, String(canvas.left + trace.width - 1).length);
  const columns = every(7 * widest + 5), rows = every(14);
  for (let i = 0; i < trace.width; ++i)
    if ((canvas.left + i) % columns === 0)
      group.append(shape("text", {x: left + (i + 0.5) * cell, y: top + height + 14, "text-anchor": "middle"}, canvas.left + i));
  for (let i = 0; i < trace.height; ++i)
    if ((canvas.top + canvas.down * i) % rows === 0)
      group.append(shape("text", {x: left - 5, y: top + (i + 0.5) * cell + 4, "text-anchor": "end"},
                         canvas.top + canvas.down * i));
  return group;
}

/** Numbers in the pixels: how often they were written, or their depths. */
function drawCells(pixels) {
  const group = by("cells");
  const longest = view === "depth" ? 6 : 1;
  const hasRoom = layout.cell >= 6 * longest + 6 && trace.pixels <= 4000;
  if (!pixels || !hasRoom) group.replaceChildren();
  if (!hasRoom || (view !== "depth" && view !== "writes")) return;
  for (const pixel of pixels ?? Array(trace.pixels).keys()) {
    const text = view === "writes" ? writes[pixel] || ""
               : storedBy[pixel] ? trace.words[trace.data.depths[3 * trace.own[storedBy[pixel]] + 2]] : "";
    const old = by("cell-" + pixel);
    if (old) { old.textContent = text; continue; }
    const {x, y} = middleOf(pixel);
    if (text !== "") group.append(shape("text", {id: "cell-" + pixel, class: "cell", x, y: y + 3.5}, text));
  }
}

/** The part of a line that lies within the picture. */
function clip(a, b) {
  const low = {x: layout.left, y: layout.top}, high = {x: layout.left + layout.width, y: layout.top + layout.height};
  let from = 0, to = 1;
  for (const axis of ["x", "y"]) {
    const d = b[axis] - a[axis];
    for (const [p, q] of [[-d, a[axis] - low[axis]], [d, high[axis] - a[axis]]]) {
      if (p === 0 && q < 0) return null;
      if (p < 0) from = Math.max(from, q / p);
      if (p > 0) to = Math.min(to, q / p);
    }
  }
  if (from > to) return null;
  const at = t => ({x: a.x + t * (b.x - a.x), y: a.y + t * (b.y - a.y)});
  return [at(from), at(to)];
}

function line(name, a, b) {
  const part = clip(a, b);
  if (!part) return [];
  const ends = {x1: part[0].x, y1: part[0].y, x2: part[1].x, y2: part[1].y};
  return [shape("line", {class: "line-rim", ...ends}), shape("line", {class: name, ...ends})];
}

const isInside = ({x, y}) => layout.left <= x && x <= layout.left + layout.width &&
                             layout.top <= y && y <= layout.top + layout.height;

/** What the step is about: true edges, vertices, the row and its ends, the pixel. */
function drawMarks() {
  const marks = [], labels = [], current = trace.primitives[trace.primitive[step]];
  const few = trace.primitives.length <= 6;
  if (few)
    for (const one of trace.primitives)
      if (one !== current && one.step <= step)
        for (const [a, b] of sidesOf(one)) marks.push(...line("other-edge", placeOf(a), placeOf(b)));
  if (current) {
    for (const [a, b] of sidesOf(current)) marks.push(...line("true-edge", placeOf(a), placeOf(b)));
    if (nameOf(step) === "edge") {
      const [i, j] = trace.data.edges.slice(2 * trace.own[step], 2 * trace.own[step] + 2);
      if (i >= 0 && current.points[i] && current.points[j])
        marks.push(...line("this-edge", placeOf(current.points[i]), placeOf(current.points[j])));
    }
  }
  drawRow(marks, labels);
  if (current) drawVertices(current, marks, labels);
  const at = trace.at[step];
  if (at >= 0) {
    const own = trace.own[step], name = nameOf(step);
    const fails = name === "sample" && !trace.data.samples[own] || name === "depth" && !(trace.data.depths[3 * own] & PASSES) ||
                  name === "reject";
    if (fails) {
      const {x, y} = middleOf(at), arm = Math.max(0.32 * layout.cell, 3);
      marks.push(shape("path", {class: "rejected", d: `M${x - arm} ${y - arm}l${2 * arm} ${2 * arm}m0 ${-2 * arm}l${-2 * arm} ${2 * arm}`}));
    }
    marks.push(shape("rect", {class: "current", ...squareOf(at, layout.cell < 8 ? 2 : 0)}));
  }
  if (trace.areas[step]) {
    const {left, right, top, bottom} = trace.areas[step], {x, y} = squareOf(top * trace.width + left, 0);
    marks.push(shape("rect", {class: "current", x, y, width: (right - left + 1) * layout.cell, height: (bottom - top + 1) * layout.cell}));
  }
  for (const [pointed, name] of [[hovered, "hovered"], [cursor, "cursor"]]) {
    if (pointed < 0) continue;
    const square = squareOf(pointed, layout.cell < 8 ? 3 : 1);
    marks.push(shape("rect", {class: "cursor-rim", ...square}), shape("rect", {class: name, ...square}));
  }
  by("marks").replaceChildren(...marks, ...labels.map(label => label.shape));
}

/** Puts a label at the first of some places where it lies on no other; nowhere if there is none. */
function putLabel(labels, name, text, places) {
  const width = (name === "end" ? 6.5 : 7.2) * text.length, height = 12, right = layout.left + layout.width + layout.margin.right;
  for (const {x, y, anchor} of places) {
    const left = anchor === "start" ? x : anchor === "end" ? x - width : x - width / 2;
    const box = {left, right: left + width, top: y - height, bottom: y + 2};
    const isFree = box.left >= 0 && box.right <= right && box.top >= -4 && box.bottom <= layout.top + layout.height + 18 &&
      labels.every(({box: other}) => box.right < other.left || other.right < box.left || box.bottom < other.top || other.bottom < box.top);
    if (!isFree) continue;
    labels.push({box, shape: shape("text", {class: `${name} rim`, x, y, "text-anchor": anchor}, text)});
    return;
  }
}

/** Dots and names, away from the middle of their primitive. */
function drawVertices({points, names}, marks, labels) {
  if (points.length === 0) return;
  const middle = placeOf({x: points.reduce((sum, p) => sum + p.x, 0) / points.length,
                          y: points.reduce((sum, p) => sum + p.y, 0) / points.length});
  const hasCoordinates = layout.width >= 240;
  points.forEach((point, i) => {
    const {x, y} = placeOf(point);
    if (!isInside({x, y})) return;
    marks.push(shape("circle", {class: "vertex", cx: x, cy: y, r: 3.5}));
    const text = ((names[2 * i] ?? "") + (hasCoordinates ? " " + (names[2 * i + 1] ?? "") : "")).trim();
    const beside = y < middle.y - 4 ? y - 3 : y > middle.y + 4 ? y + 12 : y + 4;
    const right = {x: x + 8, y: beside, anchor: "start"}, left = {x: x - 8, y: beside, anchor: "end"};
    const above = {x, y: y - 9, anchor: "middle"}, below = {x, y: y + 18, anchor: "middle"};
    putLabel(labels, "name", text, [...(x >= middle.x ? [right, left] : [left, right]),
                                    ...(y <= middle.y ? [above, below] : [below, above]),
                                    {x: x + 8, y: y - 9, anchor: "start"}, {x: x - 8, y: y - 9, anchor: "end"},
                                    {x: x + 8, y: y + 18, anchor: "start"}, {x: x - 8, y: y + 18, anchor: "end"}]);
  });
}

/** The row of a scanline, its exact ends, and the pixels that they are rounded to. */
function drawRow(marks, labels) {
  const n = trace.scanline[step];
  if (n === 0 || !["scanline", "pixel", "depth"].includes(nameOf(step))) return;
  const [row, left, right, from, to, leftText, rightText] = trace.data.rows.slice(7 * trace.own[n], 7 * trace.own[n] + 7);
  if (row < 0) return;
  const {down, top} = trace.data.canvas, y = layout.top + (row + 0.5) * layout.cell;
  marks.push(shape("line", {class: "row", x1: layout.left, y1: y, x2: layout.left + layout.width, y2: y}));
  [[left, from, leftText, true], [right, to, rightText, false]].forEach(([end, pixel, text, isLeft]) => {
    const x = placeOf({x: end, y: top + down * row}).x;
    if (x < layout.left || x > layout.left + layout.width) return;
    const target = layout.left + (pixel + 0.5) * layout.cell, below = y + 0.3 * layout.cell, head = Math.min(6, 0.4 * layout.cell);
    if (Math.abs(target - x) > 0.01 && 0 <= pixel && pixel < trace.width && layout.cell >= 8) {
      const sign = Math.sign(target - x);
      marks.push(shape("path", {class: "rounding", d: `M${x} ${y}V${below}H${target - sign * Math.min(head, Math.abs(target - x))}`}));
      marks.push(shape("path", {class: "rounding-head", d: `M${target} ${below}l${-sign * head} ${-head / 2}v${head}z`}));
    }
    marks.push(shape("circle", {class: "row-end", cx: x, cy: y, r: 3}));
    const side = isLeft ? {x: x - 7, anchor: "end"} : {x: x + 7, anchor: "start"};
    if (layout.cell >= 8 && (isLeft || left !== right))
      putLabel(labels, "end", trace.words[text], [{...side, y: y - 6}, {...side, y: y + 16}]);
  });
}

let legendOf = ""; // what it tells now: it is made again only if that changes
function drawLegend() {
  const tells = JSON.stringify([view, frame, view === "faces" ? Array.from(seen, count => count > 0) : 0]);
  if (tells === legendOf) return;
  legendOf = tells;
  const entries = [], entry = (color, text) => entries.push({color, text});
  if (view === "plotted") { entry("var(--plotted)", say("drawn")); entry("var(--current)", say("by this step")); }
  if (view === "faces") {
    const groups = [...trace.data.groups.keys()].filter(group => seen[group] > 0);
    if (trace.data.heading) entry("", trace.data.heading);
    groups.slice(0, 24).forEach(i => entry(`var(--face-${i % 8 + 1})`, trace.words[trace.data.groups[i]]));
    if (groups.length > 24) entry("", say("and {} more", groups.length - 24));
  }
  if (view === "shade") entry("", say("pixels in their own colors"));
  if (view === "depth") { entry("rgb(250 250 250)", say("nearest")); entry("rgb(120 120 120)", say("farthest")); }
  if (view === "writes")
    trace.data.write_grays.forEach((level, i, all) =>
      entry(`rgb(${level} ${level} ${level})`, i + 1 === all.length ? say("{} or more writes", i + 1) : i + 1));
  by("legend").replaceChildren(...entries.map(({color, text}) => {
    const item = document.createElement("li");
    if (color) item.append(swatch(color));
    item.append(text);
    return item;
  }));
}

// --- the words -------------------------------------------------------------------------------------------------------

function tellStep() {
  const sentence = saidOf(step);
  if (step !== told || trace !== toldOf) {
    [told, toldOf] = [step, trace];
    host.dispatchEvent(new CustomEvent("step", {bubbles: true, detail: {step, count: trace.count, kind: nameOf(step), sentence}}));
  }
  by("sentence").replaceChildren(...parts(sentence));
  by("working").replaceChildren(...(hasWorking && step > 0 ? workingOf(step) : []).map(line => element("li", "", line)));
  const slider = by("slider");
  slider.value = step;
  slider.setAttribute("aria-valuetext", say("step {} of {}", step, trace.count) + (step ? ": " + nameOf(step) : ""));
  if (root.activeElement !== by("number")) by("number").value = step;
  raster.setAttribute("aria-label", say("The picture after step {} of {}", step, trace.count));
  if (by("as-text").open) tellAsText();
}

let inSpaceOf; // the trace whose picture in space is there

/** The picture in space: what all steps have, and over it what this one adds. */
function drawSpace() {
  const {space} = trace.data;
  by("space-section").hidden = !space;
  if (!space) return;
  if (inSpaceOf !== trace) {
    inSpaceOf = trace;
    by("space").setAttribute("viewBox", `0 0 ${space.width} ${space.height}`);
    by("space").innerHTML = space.all + "<g></g>";
  }
  by("space").lastElementChild.innerHTML = step > 0 ? trace.words[space.steps[step - 1]] : "";
  for (const one of by("space").querySelectorAll('[class*=" "]')) one.style.color = `var(--${one.classList[1]})`; // its role
}

/** The steps around this one. */
function tellSteps() {
  const shown = 15, before = 6;
  const first = Math.max(0, Math.min(step - before, trace.count - shown + 1)), last = Math.min(trace.count, first + shown - 1);
  const list = by("steps"), hadFocus = list.contains(root.activeElement);
  while (list.children.length > last - first + 1) list.lastChild.remove();
  while (list.children.length < last - first + 1) {
    const button = element("button");
    button.type = "button";
    button.append(element("span", "number"), element("span", "said"));
    const item = element("li");
    item.append(button);
    list.append(item);
  }
  for (let n = first; n <= last; ++n) {
    const item = list.children[n - first], button = item.firstChild, [number, said] = button.children;
    item.className = `level-${LEVELS[nameOf(n)] ?? 0}`;
    button.dataset.step = n;
    button.tabIndex = n === step ? 0 : -1;
    if (n === step) button.setAttribute("aria-current", "step"); else button.removeAttribute("aria-current");
    number.textContent = n;
    said.textContent = saidOf(n);
    if (n === step && hadFocus) button.focus({preventScroll: true});
  }
}

/** The steps that are about a pixel; none, of no pixel. */
function stepsAt(pixel) {
  if (pixel < 0) return [];
  const column = pixel % trace.width, row = Math.floor(pixel / trace.width);
  const dropped = trace.rejects.filter(one => one.left <= column && column <= one.right && one.top <= row && row <= one.bottom);
  return [...trace.touches[pixel] ?? [], ...dropped.map(one => one.step)].sort((a, b) => a - b);
}

/** Those that have tried to write it. */
const triesOf = pixel => stepsAt(pixel).filter(n => ["pixel", "depth", "reject"].includes(nameOf(n)));

function tellPixel() {
  const pixel = hovered >= 0 ? hovered : cursor;
  const about = by("pixel-told");
  if (pixel < 0) {
    by("pixel-heading").textContent = say("Pixel");
    about.replaceChildren(element("p", "", say("Point at a pixel, or tap it, to see who drew it, and why the others did not.")));
    return;
  }
  by("pixel-heading").textContent = say("Pixel ({}, {})", xOf(pixel), yOf(pixel));
  const all = answerAbout(pixel), lines = [];
  if (all) lines.push(element("p", "answer", all.answer));
  for (const line of all?.lacks ?? []) lines.push(element("p", "note", line));
  const tries = triesOf(pixel);
  if (tries.length > 0) {
    lines.push(element("h3", "", say("Steps that tried to write it")));
    const list = element("ol");
    list.append(...tries.slice(0, 60).map(tryItem));
    lines.push(list);
    if (tries.length > 60) lines.push(element("p", "", say("and {} more", tries.length - 60)));
  }
  if (all && all.whyNot.length > 0) {
    lines.push(element("h3", "", say("Not drawn by")));
    const list = element("ul");
    list.append(...all.whyNot.map(whyNotItem));
    lines.push(list);
    if (all.count > all.whyNot.length) lines.push(element("p", "", say("and {} more", all.count - all.whyNot.length)));
  }
  if (fileOf()) {
    const more = element("p", "", say(all ? "The working:" : "Who did not draw it, and why:"));
    more.append(" ", element("code", "", `rastertrace explain ${fileOf()} --pixel ${xOf(pixel)},${yOf(pixel)}`));
    lines.push(more);
  } else if (!all) {
    lines.push(element("p", "", say("It would take too long here to say why others did not draw it.")));
  }
  about.replaceChildren(...lines);
}

function tryItem(n) {
  const item = element("li", n > step ? "later" : ""), button = element("button", "", n);
  button.type = "button";
  button.dataset.step = n;
  button.setAttribute("aria-label", say("Go to step {}", n));
  const said = element("span", "said");
  if (nameOf(n) === "pixel") said.append(swatch(trace.words[trace.data.pixels[trace.own[n]]]));
  said.append(...parts(saidOf(n)));
  item.append(button, said);
  return item;
}

function whyNotItem({primitive, reason, sentence}) {
  const item = element("li", "why-not"), who = element("span");
  who.append(element("span", "who", primitive), " ", element("span", "reason", reason));
  item.append(who, element("span", "sentence", sentence));
  return item;
}

/** True if the program can be asked about the scene that is shown. */
const canAsk = () => program && options.scene && trace.count <= options.steps_with_working;

/** The working of a step: from the data, or asked of the program, or the command that tells it. */
function workingOf(n) {
  const {working} = trace.data;
  if (working) return working[n - 1].map(word => trace.words[word]);
  if (canAsk() && !isMoving) {
    try {
      return program.step(drawnScene, options.language, n).working;
    } catch { /* then only the command tells it */ }
  }
  return fileOf() ? [`rastertrace explain ${fileOf()} --step ${n}`] : [];
}

/** The answer about a pixel: from the data, or asked of the program; null if neither has it. */
function answerAbout(pixel) {
  if (trace.answers) return answerOf(trace, pixel);
  if (!canAsk()) return null;
  return program.explain(drawnScene, options.language, xOf(pixel), yOf(pixel));
}

/** The pixels as rows of characters: @ is what this step has drawn. */
function tellAsText() {
  let text = "";
  for (let i = 0; i < trace.pixels; ++i) {
    text += drawnBy[i] === 0 ? "." : drawnBy[i] === step ? "@" : "#";
    text += (i + 1) % trace.width === 0 ? "\n" : " ";
  }
  by("text-picture").textContent = text;
}

function tellConventions() {
  const {conventions} = trace.data, lines = [];
  for (let i = 0; i < conventions.length; i += 3) {
    const [key, value, meaning] = conventions.slice(i, i + 3).map(word => trace.words[word]);
    const told = element("dd", "", value);
    if (meaning) told.append(element("span", "", meaning));
    lines.push(element("dt", "", key), told);
  }
  by("conventions").replaceChildren(...lines);
  const inForce = [];
  for (let i = 0; i < conventions.length; i += 3)
    if (trace.words[conventions[i]] !== "canvas") inForce.push(`${trace.words[conventions[i]]} ${trace.words[conventions[i + 1]]}`);
  by("in-force").textContent = inForce.join(", ");
  const notes = trace.data.notes.map(word => element("p", "", trace.words[word]));
  by("notes").replaceChildren(...notes);
  by("notes").hidden = notes.length === 0;
}

// --- going about -----------------------------------------------------------------------------------------------------

function goTo(n) {
  const target = Math.max(0, Math.min(n, trace.count));
  const marked = [step, target].map(one => trace.at[one]).filter(pixel => pixel >= 0);
  const changed = [...play(target), ...marked];
  paint(changed);
  if (view === "depth" || view === "writes") drawCells(changed.length > 1000 ? undefined : changed);
  drawLegend();
  drawMarks();
  drawSpace();
  tellStep();
  tellSteps();
  if (hovered >= 0 || cursor >= 0) tellPixel();
}

/** The next step that a test holds for; -1: there is none. */
function find(direction, test) {
  for (let n = step + direction; 0 < n && n <= trace.count; n += direction) if (test(n)) return n;
  return -1;
}
function goToNext(direction, test) {
  const n = find(direction, test);
  if (n > 0) goTo(n);
}

function setCursor(pixel) {
  cursor = pixel;
  hovered = -1;
  drawMarks();
  tellPixel();
  if (pixel < 0) return;
  announce(say("pixel ({}, {}): {}", xOf(pixel), yOf(pixel), answerAbout(pixel)?.answer ?? say("{} tries", triesOf(pixel).length)));
  const {x, y} = middleOf(pixel), box = scroller;
  if (x < box.scrollLeft + 20 || x > box.scrollLeft + box.clientWidth - 20) box.scrollLeft = x - box.clientWidth / 2;
  if (y < box.scrollTop + 20 || y > box.scrollTop + box.clientHeight - 20) box.scrollTop = y - box.clientHeight / 2;
}

function announce(text) { by("announcement").textContent = text; }

/** Moves the cursor; without one, it comes to the pixel of this step, or to the middle. */
function moveCursor(columns, rows) {
  if (cursor < 0) {
    const at = trace.at[step];
    return setCursor(at >= 0 ? at : Math.floor(trace.height / 2) * trace.width + Math.floor(trace.width / 2));
  }
  const column = cursor % trace.width + columns, row = Math.floor(cursor / trace.width) + rows;
  if (0 <= column && column < trace.width && 0 <= row && row < trace.height) setCursor(row * trace.width + column);
}

function setView(name) {
  view = trace.data.views.includes(name) ? name : trace.data.view;
  by("view").value = view;
  paint();
  drawCells();
  drawLegend();
}

function nextView(direction) {
  const {views} = trace.data;
  setView(views[(views.indexOf(view) + direction + views.length) % views.length]);
  announce(say("view {}", view));
}

function setZoom(factor) {
  zoom = Math.max(0.25, Math.min(zoom * factor, 16));
  lay();
}

function stop() {
  clearTimeout(timer);
  timer = 0;
  by("sentence").setAttribute("aria-live", "polite");
  by("play").setAttribute("aria-pressed", "false");
  by("play").setAttribute("aria-label", say("Play"));
}

function tick() {
  const shortest = 1000 / 30; // more steps at once make it faster
  const steps = Math.max(1, Math.round(rate * shortest / 1000));
  goTo(step + steps);
  if (step >= trace.count) return stop();
  timer = setTimeout(tick, Math.max(shortest, 1000 / rate));
}

function togglePlay() {
  if (timer) return stop();
  if (step >= trace.count) goTo(0);
  by("sentence").setAttribute("aria-live", "off"); // nobody can listen that fast
  by("play").setAttribute("aria-pressed", "true");
  by("play").setAttribute("aria-label", say("Pause"));
  timer = setTimeout(tick, 1000 / rate);
}

function setRate(factor) {
  rate = Math.max(0.25, Math.min(rate * factor, 4096));
  announce(say("{} steps a second", rate));
}

/** What keys and buttons do, by the names of the player's actions. */
const actions = {
  "next": () => goTo(step + 1),
  "previous": () => goTo(step - 1),
  "next-row": () => goToNext(1, n => ROWS.includes(nameOf(n))),
  "previous-row": () => goToNext(-1, n => ROWS.includes(nameOf(n))),
  "next-of-kind": () => goToNext(1, n => trace.kind[n] === trace.kind[step]),
  "previous-of-kind": () => goToNext(-1, n => trace.kind[n] === trace.kind[step]),
  "next-of-primitive": () => goToNext(1, n => trace.primitive[n] === trace.primitive[step]),
  "previous-of-primitive": () => goToNext(-1, n => trace.primitive[n] === trace.primitive[step]),
  "next-primitive": () => goToNext(1, n => nameOf(n) === "primitive"),
  "previous-primitive": () => goToNext(-1, n => nameOf(n) === "primitive"),
  "next-at-cursor": () => goTo(stepsAt(cursor).find(n => n > step) ?? step),
  "previous-at-cursor": () => goTo(stepsAt(cursor).findLast(n => n < step) ?? step),
  "first": () => goTo(0),
  "last": () => goTo(typed === "" ? trace.count : Number(typed)),
  "play": togglePlay,
  "faster": () => setRate(2),
  "slower": () => setRate(0.5),
  "cursor-left": () => moveCursor(-1, 0),
  "cursor-right": () => moveCursor(1, 0),
  "cursor-up": () => moveCursor(0, -1),
  "cursor-down": () => moveCursor(0, 1),
  "cursor-to-step": () => { if (trace.at[step] >= 0) setCursor(cursor === trace.at[step] ? -1 : trace.at[step]); },
  "next-view": () => nextView(1),
  "previous-view": () => nextView(-1),
  "larger-cells": () => setZoom(1.25),
  "smaller-cells": () => setZoom(0.8),
  "working": () => { hasWorking = !hasWorking; tellStep(); },
  "next-frame": () => setFrame((frame + 1) % frames.length),
  "previous-frame": () => setFrame((frame + frames.length - 1) % frames.length),
  "help": () => by("help").open ? by("help").close() : by("help").showModal(),
};

function act(name) {
  if (name !== "play") stop();
  actions[name]();
  typed = "";
}

// --- keys and the pointer ---------------------------------------------------------------------------------------------

/** The name that the table of keys has for a key. */
function keyName(event) {
  const names = {" ": "Space", ArrowLeft: "Left", ArrowRight: "Right", ArrowUp: "Up", ArrowDown: "Down"};
  const name = names[event.key] ?? event.key;
  return event.shiftKey && event.key.startsWith("Arrow") ? "Shift+" + name : name;
}

const actionOfKey = new Map(options.keys.flatMap(([action, , ...keys]) => keys.map(key => [key, action])));

function onKey(event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const at = event.composedPath()[0], name = keyName(event), isCharacter = event.key.length === 1 && event.key !== " ";
  if (isCharacter && !by("letters").checked) return;
  if (by("help").open) {
    if (actionOfKey.get(name) === "help") { event.preventDefault(); by("help").close(); }
    return;
  }
  // What is operated has keys of its own.
  if (at.closest("select, #numbers")) return;
  if (at === by("number") && (name !== "Enter")) return;
  if (at.closest('button, summary, input[type="checkbox"]') && (name === "Space" || name === "Enter")) return;
  if (at === by("text-picture") && event.key.startsWith("Arrow") && !event.shiftKey) return;
  if (isCharacter && "0" <= event.key && event.key <= "9") { typed = (typed + event.key).slice(0, 9); return; }
  if (name === "Enter") {
    if (typed !== "") { event.preventDefault(); act("last"); }
    return;
  }
  if (name === "Escape") { typed = ""; if (cursor >= 0) setCursor(-1); return; }
  const action = actionOfKey.get(name);
  if (!action || !(action in actions)) return;
  event.preventDefault();
  act(action);
}

/** The pixel below a pointer; -1: none. */
function pixelAt(event) {
  const box = raster.getBoundingClientRect();
  const column = Math.floor((event.clientX - box.left) / layout.cell), row = Math.floor((event.clientY - box.top) / layout.cell);
  return 0 <= column && column < trace.width && 0 <= row && row < trace.height ? row * trace.width + column : -1;
}

function hover(pixel) {
  if (pixel === hovered) return;
  hovered = pixel;
  drawMarks();
  tellPixel();
}

// --- vertices that can be moved --------------------------------------------------------------------------------------

// The program itself, compiled for browsers, draws a changed scene (element.js).
// Without the program vertices are fixed, and who tries to move one is told so.
const whyFixed = "Vertices stay where they are: the rastertrace that wrote this page found no module that draws. " +
  "It was built without one (cmake -D RASTERTRACE_WASM=ON builds it), RASTERTRACE_MODULE did not name its file, and there was no " +
  "share/rastertrace/rastertrace.js beside the program, where a package has it.";
let drawnScene = options.scene, scene, hasMoved = false, hasTurned = false, wanted = "", isDrawing = false, isMoving = false;
const grain = 4; // vertices go to quarters of a pixel

function prepareMoving() {
  if (!options.scene) return;
  scene = JSON.parse(options.scene);
  by("back").addEventListener("click", () => {
    scene = JSON.parse(options.scene);
    placeHandles();
    for (const {slider, told, first} of numbers) slider.value = told.value = first;
    drawAgain("all");
  });
  if (program && (scene.projection || scene.camera) && scene.projection?.type !== "clip-space") prepareNumbers();
  if (!options.movable) return;
  for (const name of Object.keys(scene.vertices)) {
    const handle = element("button", program ? "handle" : "handle fixed");
    handle.type = "button";
    handle.dataset.vertex = name;
    handle.addEventListener("pointerdown", event => { handle.setPointerCapture(event.pointerId); handle.dataset.held = JSON.stringify(scene.vertices[name]); });
    handle.addEventListener("pointermove", event => { if (handle.dataset.held) moveTo(name, placeUnder(event), "in motion"); });
    for (const end of ["pointerup", "pointercancel"])
      handle.addEventListener(end, () => { if (!handle.dataset.held) return;
        const isMoved = handle.dataset.held !== JSON.stringify(scene.vertices[name]);
        delete handle.dataset.held;
        if (isMoved) drawAgain("all");
      });
    handle.addEventListener("keydown", event => {
      const way = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[event.key];
      if (!way || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      event.stopPropagation();
      const {x, y} = vertexAt(name), far = event.shiftKey ? 1 : 1 / grain;
      moveTo(name, {x: x + far * way[0], y: y + far * way[1] * trace.data.canvas.down}, "all");
    });
    by("handles").append(handle);
  }
  placeHandles();
}

const vertexAt = name => ({x: numberIn(scene.vertices[name][0]), y: numberIn(scene.vertices[name][1])});

/** The place of the scene below a pointer. */
function placeUnder(event) {
  const box = raster.getBoundingClientRect(), {left, top, down, sample} = trace.data.canvas;
  return {x: (event.clientX - box.left) / layout.cell - 0.5 + left + sample,
          y: ((event.clientY - box.top) / layout.cell - 0.5) * down + top + sample};
}

function placeHandles() {
  for (const handle of by("handles").children) {
    const {x, y} = vertexAt(handle.dataset.vertex), place = placeOf({x, y});
    handle.style.left = `${place.x}px`;
    handle.style.top = `${place.y}px`;
    handle.hidden = !isInside(place);
    handle.setAttribute("aria-label", say("Vertex {} at ({}, {})", handle.dataset.vertex, x, y) + (program ? `: ${say("arrow keys move it")}` : ""));
  }
}

function tellProblem(text) {
  by("problem").textContent = text;
  by("problem").hidden = false;
}

function moveTo(name, {x, y}, detail) {
  if (!program) return tellProblem(whyFixed);
  const {left, top, down} = trace.data.canvas, ends = [top, top + down * (trace.height - 1)];
  const held = (value, low, high) => Math.round(Math.max(low, Math.min(value, high)) * grain) / grain;
  const place = [held(x, left, left + trace.width - 1), held(y, Math.min(...ends), Math.max(...ends))];
  const old = vertexAt(name);
  if (place[0] === old.x && place[1] === old.y) return;
  scene.vertices[name] = place;
  placeHandles();
  drawAgain(detail);
}

/** Has the scene drawn; what has changed meanwhile is drawn next. */
async function drawAgain(detail) {
  if (!program) return;
  stop();
  wanted = detail;
  if (isDrawing) return;
  isDrawing = true;
  while (wanted) {
    const detail = wanted;
    wanted = "";
    await new Promise(done => requestAnimationFrame(done));
    if (gone.signal.aborted) return;
    try {
      const text = JSON.stringify(scene);
      if (detail === "frame") { showFrame(program.frame(text)); continue; }
      hasMoved = text !== JSON.stringify(JSON.parse(options.scene));
      const data = hasMoved ? await program.draw(text, options.language, detail) : frames[frame].data;
      if (gone.signal.aborted) return;
      isMoving = detail !== "all";
      by("back").hidden = !hasMoved;
      by("problem").hidden = true;
      drawnScene = text;
      const drawn = readTrace(data);
      show(drawn, stepLike(drawn));
      if (detail === "all") host.dispatchEvent(new CustomEvent("scene", {bubbles: true, detail: {scene: text}}));
    } catch (problem) {
      tellProblem(problem.message);
      paint(); // what was in motion
    }
  }
  isDrawing = false;
}

// --- numbers that are changed --------------------------------------------------------------------------------------

// What is in space is turned by dragging the picture, and its camera and light are moved by sliders. Meanwhile its last
// picture is drawn, and all of its steps once it rests.
const numbers = []; // {slider, told, first, unmoved, put}: `put` puts the slider's number into a scene
const mostNumbers = 24;
let turning = []; // those of numbers that turn the scene

/** Meshes and vertices turned about their own centers, before all that the scene does with them. */
function turned(scene, axis, degrees) {
  const turn = (model, points) => {
    const center = [0, 1, 2].map(k => points.reduce((sum, point) => sum + numberIn(point[k] ?? 0), 0) / points.length);
    const moved = way => center.some(x => x) ? [{translate: center.map(x => way * x)}] : [];
    return [...moved(-1), {rotate: {axis, degrees}}, ...moved(1), ...model ?? []];
  };
  for (const mesh of scene.meshes ?? []) if (mesh.vertices) mesh.model = turn(mesh.model, Object.values(mesh.vertices));
  if (scene.vertices) scene.model = turn(scene.model, Object.values(scene.vertices));
}

function prepareNumbers() {
  const add = (label, first, low, high, step, put) => {
    const row = element("label", "", label), slider = element("input"), told = element("output", "", first);
    Object.assign(slider, {type: "range", min: low, max: high, step, value: first});
    slider.addEventListener("input", () => { told.value = slider.value; changeNumbers("frame"); });
    slider.addEventListener("change", () => changeNumbers("all"));
    row.append(slider, told);
    by("numbers").append(row);
    numbers.push({slider, told, first, put, unmoved: slider.value});
    return numbers.at(-1);
  };
  turning = ["x", "y"].map(axis => add(say("turn about {}", axis), 0, -180, 180, 1, (scene, degrees) => turned(scene, axis, degrees)));
  const addNumbersOf = (label, value, holderIn, key) => { // all that the value has
    if (typeof value === "object")
      for (const [name, one] of Object.entries(value ?? {}))
        addNumbersOf(`${label} ${Array.isArray(value) && typeof one !== "object" ? "xyz"[name] : name}`, one, scene => holderIn(scene)[key], name);
    const first = typeof value === "object" ? NaN : numberIn(value);
    if (!Number.isFinite(first) || numbers.length === mostNumbers) return;
    const isAngle = /^(degrees|fov_y)$/.test(key), far = isAngle ? 60 : Math.max(5, 2 * Math.abs(first));
    add(label, first, first - far, first + far, isAngle ? 1 : 0.1, (scene, value) => { holderIn(scene)[key] = value; });
  };
  for (const key of ["camera", "light", "projection", "model"]) addNumbersOf(key, scene[key], scene => scene, key);
  by("numbers-section").hidden = false;
  sheet.classList.add("turns");
  let from = null;
  sheet.addEventListener("pointerdown", event => {
    hasTurned = false;
    if (event.pointerType !== "touch" && event.button === 0) from = {x: event.clientX, y: event.clientY, angles: turning.map(({slider}) => Number(slider.value)), moves: false};
  });
  sheet.addEventListener("pointermove", event => {
    if (!(event.buttons & 1)) from = null; // it was let go elsewhere
    if (!from) return;
    const [right, down] = [event.clientX - from.x, event.clientY - from.y];
    if (!from.moves && Math.hypot(right, down) < 4) return;
    if (!from.moves) { from.moves = true; sheet.setPointerCapture(event.pointerId); sheet.dataset.held = "true"; hover(-1); }
    const sides = [down, right].map((way, k) => (from.angles[k] + Math.round(way / 2) + 540) % 360 - 180);
    turning.forEach(({slider, told}, k) => { slider.value = told.value = sides[k]; });
    changeNumbers("frame");
  });
  for (const end of ["pointerup", "pointercancel"])
    sheet.addEventListener(end, () => {
      if (from?.moves) { delete sheet.dataset.held; hasTurned = true; changeNumbers("all"); }
      from = null;
    });
}

function changeNumbers(detail) {
  scene = JSON.parse(options.scene);
  const inOrder = [...numbers.filter(one => !turning.includes(one)), ...turning]; // a turn adds to the model
  for (const {slider, put, unmoved} of inOrder) if (slider.value !== unmoved) put(scene, Number(slider.value));
  drawAgain(detail);
}

/** The last picture of a scene in motion. */
function showFrame({names, owners, colors, pixels, depths}) {
  const words = new Uint32Array(image.data.buffer), own = colors.map(color => wordOf(color)), empty = emptyColor();
  const groups = new Map(trace.primitives.map(one => [one.name, one.group]));
  for (let i = 0; i < trace.pixels; ++i)
    words[i] = view === "depth" ? (depths[i] ? gray(depths[i]) : 0)
             : owners[i] < 0 ? empty
             : view === "faces" && groups.get(names[owners[i]]) >= 0 ? shades.faces[groups.get(names[owners[i]]) % 8]
             : view === "plotted" ? shades.plotted : own[pixels[i]];
  brush.putImageData(image, 0, 0);
  for (const over of ["cells", "marks"]) by(over).replaceChildren();
  by("sentence").textContent = "...";
  host.dispatchEvent(new CustomEvent("frame"));
}

/** The step of another trace that is most like this one: of the same kind and primitive, in the same row or pixel. */
function stepLike(other) {
  if (step === trace.count) return Infinity;
  if (step === 0) return 0;
  const kind = trace.kind[step], primitive = trace.primitive[step];
  const rowOf = (one, n) => one.kindNames[one.kind[n]] === "scanline" ? one.data.rows[7 * one.own[n]] : one.at[n];
  let alike = 0;
  for (let n = 1; n <= other.count; ++n) {
    if (other.kind[n] !== kind || other.primitive[n] !== primitive) continue;
    if (rowOf(other, n) === rowOf(trace, step)) return n;
    if (alike === 0 || Math.abs(n - step) < Math.abs(alike - step)) alike = n;
  }
  return alike || Math.min(step, other.count);
}

// --- the page --------------------------------------------------------------------------------------------------------

/** Shows a trace: that of a frame, or of a scene that was changed. */
function show(shown, atStep) {
  trace = shown;
  const {data} = trace;
  drawnBy = new Int32Array(trace.pixels);
  storedBy = new Int32Array(trace.pixels);
  writes = new Int32Array(trace.pixels);
  seen = new Int32Array(data.groups.length);
  legendOf = "";
  step = 0;
  if (cursor >= trace.pixels) cursor = -1;
  hovered = -1;
  if (!data.views.includes(view)) view = data.view;
  by("view").replaceChildren(...data.views.map(name => element("option", "", name)));
  by("view").value = view;
  by("slider").max = by("number").max = trace.count;
  by("last").textContent = trace.count;
  play(Math.max(0, Math.min(atStep, trace.count)));
  readColors();
  lay();
  drawLegend();
  tellConventions();
  drawSpace();
  tellStep();
  tellSteps();
  tellPixel();
}

function setFrame(place) {
  stop();
  const wasAtEnd = step === trace.count;
  frame = place;
  by("frame").value = place;
  show(readTrace(frames[frame].data), wasAtEnd ? Infinity : step);
}

/** The step that the address asks for: page.html#14. */
function stepOfAddress() {
  const asked = /^#(?:step=)?(\d+)$/.exec(location.hash);
  return asked ? Number(asked[1]) : null;
}

function listen() {
  (isPage ? document : root).addEventListener("keydown", onKey, until);
  by("slider").addEventListener("input", event => { stop(); goTo(Number(event.target.value)); });
  by("number").addEventListener("change", event => { stop(); goTo(Math.floor(Number(event.target.value)) || 0); event.target.value = step; });
  by("view").addEventListener("change", event => setView(event.target.value));
  by("frame").addEventListener("change", event => setFrame(Number(event.target.value)));
  by("help-button").addEventListener("click", () => by("help").showModal());
  by("as-text").addEventListener("toggle", tellAsText);
  by("all").addEventListener("click", event => {
    const button = event.target.closest("button");
    if (button?.dataset.action) act(button.dataset.action);
    if (button?.dataset.step) { stop(); goTo(Number(button.dataset.step)); }
  });
  sheet.addEventListener("pointermove", event => { if (event.pointerType === "mouse" && event.buttons === 0) hover(pixelAt(event)); });
  sheet.addEventListener("pointerleave", () => hover(-1));
  sheet.addEventListener("click", event => {
    if (hasTurned) { hasTurned = false; return; } // the end of a drag
    if (event.target.closest(".handle:not(.fixed)")) return;
    const pixel = pixelAt(event);
    setCursor(pixel === cursor ? -1 : pixel);
  });
  let width = host.clientWidth;
  const resized = new ResizeObserver(() => { if (host.clientWidth !== width) { width = host.clientWidth; lay(); } });
  resized.observe(host);
  gone.signal.addEventListener("abort", () => resized.disconnect());
  if (isPage) {
    addEventListener("resize", lay, until);
    addEventListener("hashchange", () => { const asked = stepOfAddress(); if (asked !== null) goTo(asked); }, until);
  }
}

/** The words of element.html and its labels, in the language of steps. */
function translate() {
  for (const one of root.querySelectorAll("*")) {
    const label = one.getAttribute("aria-label");
    if (label) one.setAttribute("aria-label", say(label));
    for (const node of one.childNodes)
      if (node.nodeType === Node.TEXT_NODE) node.data = node.data.replace(/\S.*\S|\S/s, words => say(words));
  }
}

function tellKeys() {
  const signs = {Right: "\u2192", Left: "\u2190", Up: "\u2191", Down: "\u2193"};
  const shown = key => say(key.replace(/(Right|Left|Up|Down)$/, word => signs[word]));
  by("keys").tBodies[0].replaceChildren(...options.keys.filter(([action]) => frames.length > 1 || !action.endsWith("-frame"))
    .map(([, does, ...keys]) => {
      const row = element("tr"), cell = element("td");
      keys.forEach((key, i) => cell.append(i ? " " : "", element("kbd", "", shown(key))));
      row.append(cell, element("td", "", does[options.language]));
      return row;
    }));
}

by("all").lang = options.language;
translate();
by("title").textContent = options.title;
by("frame").replaceChildren(...frames.map(({label}, i) => Object.assign(element("option", "", label), {value: i})));
by("frame-choice").hidden = frames.length < 2;
view = options.view ?? frames[0].data.view;
tellKeys();
show(readTrace(frames[0].data), (isPage ? stepOfAddress() : null) ?? options.step ?? Infinity);
listen();
prepareMoving();

return {
  goTo: n => { stop(); goTo(n); },
  setView,
  repaint: () => { readColors(); paint(); },
  end: () => { stop(); gone.abort(); },
};
}
