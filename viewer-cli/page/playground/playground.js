// SPDX-License-Identifier: MIT
// The playground: a scene is typed, drawn and asked about, all in the browser.

const by = id => document.getElementById(id);
const examples = [["First triangle", "t0-fill/first-triangle"], ["Cube, depth buffer of 1/z", "t0-hidden/cube-inverse-z"], ["A Bresenham line", "t2-lines/bresenham"],
                  ["Barycentric", "t3-sweep-and-box/barycentric"], ["Top-left rule", "t3-sweep-and-box/top-left"], ["A clipped triangle", "t4-pipeline/behind-the-eye"],
                  ["Hidden lines", "t1-hidden/hidden-lines"], ["Light", "t3-light/lambert"]];
const delay = 250; // milliseconds after a key before the scene is drawn

let program, editor, view, drawsSoon, checksSoon, isTaking = false, scene = ""; // the text that is drawn
let shown = ""; // what the picture was given last

// --- what is typed ---------------------------------------------------------------------------------------------------

const text = () => view.state.doc.toString();

/** The scene with the chosen convention, and perhaps a mistake. */
function sceneWith(mistake) {
  const convention = by("convention").value;
  if (!convention && !mistake) return scene;
  const changed = JSON.parse(scene);
  if (convention) changed.convention = convention;
  if (mistake) changed.method = {...changed.method, mistake};
  return JSON.stringify(changed);
}

function tellProblem(problem) {
  editor.mark(view, problem);
  by("problem").hidden = !problem;
  by("problem").textContent = problem ? [problem.line ? `line ${problem.line}, column ${problem.column}: ${problem.message}` : problem.message,
                                         ...problem.hint ? [`hint: ${problem.hint}`] : []].join("\n") : "";
}

/** Gives the picture a scene, if it is another one. */
function show(words) {
  if (words !== shown) by("picture").scene = shown = words;
}

/** Draws what is typed, if it is a scene; else tells what is wrong, and leaves the picture. */
function draw() {
  const before = scene, problem = program.problem(text());
  tellProblem(problem && JSON.parse(problem));
  if (problem) return;
  scene = text();
  const withConvention = program.problem(sceneWith(""));
  if (withConvention) {
    scene = before;
    return tellProblem({...JSON.parse(withConvention), line: 0}); // a place of another text
  }
  show(sceneWith(""));
  listMistakes();
  drawMistake();
  check();
}

function listMistakes() {
  const chosen = by("mistake").value, mistakes = JSON.parse(program.mistakes(sceneWith("")));
  by("mistake").replaceChildren(new Option("none", ""), ...mistakes.map(({name, symptom}) => Object.assign(new Option(name), {title: symptom})));
  by("mistake").value = mistakes.some(one => one.name === chosen) ? chosen : "";
}

function drawMistake() {
  const name = by("mistake").value;
  by("beside").hidden = !name;
  by("pictures").classList.toggle("two", name !== "");
  if (!name) return;
  const {says, should, symptom} = JSON.parse(program.mistakes(sceneWith(""))).find(one => one.name === name);
  by("mistake-heading").textContent = `With the mistake ${name}`;
  by("mistake-told").textContent = `${says}${should ? `, in place of ${should}` : ""}: ${symptom}`;
  const withMistake = sceneWith(name), problem = program.problem(withMistake);
  by("wrong-picture").hidden = problem !== "";
  if (problem) by("mistake-told").textContent = JSON.parse(problem).message;
  else by("wrong-picture").scene = withMistake;
}

/** A scene as a text: what fits into a line stands in one. */
function written(value, indent = "") {
  const line = JSON.stringify(value).replace(/("(?:[^"\\]|\\.)*")|([,:])/g, (whole, word) => word ?? whole + " ");
  if (typeof value !== "object" || indent.length + line.length < 90) return line;
  const within = indent + " ", [open, close] = Array.isArray(value) ? "[]" : "{}";
  const rows = Array.isArray(value) ? value.map(one => written(one, within))
                                    : Object.entries(value).map(([key, one]) => `${JSON.stringify(key)}: ${written(one, within)}`);
  return `${open}\n${rows.map(row => within + row).join(",\n")}\n${indent}${close}`;
}

/** The place of each vertex in a text, and its name. */
function* verticesIn(words) {
  const begin = words.indexOf("\"vertices\"");
  for (const {0: whole, 1: name, 2: place, index} of words.slice(begin).matchAll(/("(?:[^"\\]|\\.)*")\s*:\s*(\[[^\]{}]*\])/g))
    yield {name: JSON.parse(name), to: begin + index + whole.length, length: place.length};
}

/** Writes what was moved in the picture into the text. If only vertices were, the rest of it stays as it is. */
function takeMoved(moved) {
  const before = text(), now = JSON.parse(moved), changes = [];
  if (before !== scene) return; // what is typed is drawn next, or is wrong: it is not written over
  if (by("convention").value) now.convention = JSON.parse(before).convention; // the chosen one is not the scene's
  for (const {name, to, length} of verticesIn(before))
    if (now.vertices?.[name]) changes.push({from: to - length, to, insert: `[${now.vertices[name].map(x => JSON.stringify(x)).join(", ")}]`});
  const changed = view.state.changes(changes), same = JSON.parse(changed.apply(view.state.doc).toString());
  shown = ""; // the picture has changed it
  isTaking = true; // the picture shows it already
  if (JSON.stringify(same) === JSON.stringify(now)) view.dispatch({changes: changed});
  else setText(written(now));
  isTaking = false;
  scene = text();
  listMistakes();
  drawMistake();
  check();
}

/** Marks the lines that somebody has worked out. */
function check() {
  const claims = by("claims").value;
  let told = [];
  try {
    told = claims.trim() ? JSON.parse(program.check(sceneWith(""), claims)) : [];
  } catch (problem) {
    const item = document.createElement("li");
    item.append(Object.assign(document.createElement("pre"), {textContent: problem.message}));
    by("checked").replaceChildren(item);
    return;
  }
  by("checked").replaceChildren(...told.map(({line, claim, verdict, fields, slips, remarks, working}) => {
    const item = document.createElement("li");
    item.append(Object.assign(document.createElement("span"), {className: `verdict ${verdict}`, textContent: verdict}), ` ${line}: ${claim}`);
    const lines = [...fields, ...slips.map(slip => `likely: ${slip}`),
                   ...remarks, ...verdict === "right" ? [] : working];
    if (lines.length) item.append(Object.assign(document.createElement("pre"), {textContent: lines.join("\n")}));
    return item;
  }));
}

// --- links -----------------------------------------------------------------------------------------------------------

async function through(stream, bytes) { return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer()); }

/** A text as a part of an address: deflated, in base64 of addresses. */
async function packed(words) {
  const bytes = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(words));
  return btoa(Array.from(bytes, byte => String.fromCharCode(byte)).join("")).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}
async function unpacked(code) {
  const bytes = Uint8Array.from(atob(code.replaceAll("-", "+").replaceAll("_", "/")), c => c.charCodeAt(0));
  return new TextDecoder().decode(await through(new DecompressionStream("deflate-raw"), bytes));
}

/** The address holds what is shown no longer. */
function forgetLink() {
  if (location.hash) history.replaceState(null, "", location.pathname);
}

/** What the address holds: {scene, convention, mistake, claims}; {} if it holds nothing, or what is no link of ours. */
async function heldByAddress() {
  try {
    return location.hash.length > 1 ? {...JSON.parse(await unpacked(location.hash.slice(1)))} : {};
  } catch {
    say("This link is damaged.");
    return {};
  }
}

async function share() {
  const held = {scene: text(), convention: by("convention").value, mistake: by("mistake").value, claims: by("claims").value};
  history.replaceState(null, "", "#" + await packed(JSON.stringify(held)));
  await navigator.clipboard?.writeText(location.href).catch(() => {});
  say("The address holds the scene.");
}

function say(words) { by("said").textContent = words; }

// --- meshes ----------------------------------------------------------------------------------------------------------

/** A mesh of a scene from an OBJ file: its vertices and faces. */
function meshOf(name, obj) {
  const vertices = {}, faces = [];
  let count = 0;
  for (const line of obj.split(/\r?\n/)) {
    const [statement, ...words] = line.trim().split(/\s+/);
    if (statement === "v") vertices[++count] = words.slice(0, 3).map(Number);
    if (statement === "f") faces.push(words.map(word => { const n = parseInt(word, 10); return String(n < 0 ? count + 1 + n : n); }));
  }
  return {name, vertices, faces};
}

async function drop(event) {
  const file = event.dataTransfer.files[0];
  if (!file) return; // text that is moved within the editor
  event.preventDefault();
  by("editor").classList.remove("over");
  const content = await file.text();
  if (!/\.obj$/i.test(file.name)) return setText(content);
  let before = {};
  try { before = JSON.parse(text()); } catch { /* what is typed is no scene: the mesh makes one */ }
  const {canvas = {width: 60, height: 40}, camera = {position: [0, 0, 5]}, projection = {type: "frustum", fov_y: 50, near: 1, far: "infinity"}, method = {depth: "inverse-z"}} = before;
  const isInSpace = "projection" in before;
  setText(written({...isInSpace ? before : {}, canvas, camera, projection, method, meshes: [meshOf(file.name.replace(/\.obj$/i, ""), content)]}));
}

function setText(words) {
  view.dispatch({changes: {from: 0, to: view.state.doc.length, insert: words}});
}

// --- examples --------------------------------------------------------------------------------------------------------

async function textAt(address) {
  const answer = await fetch(address);
  if (!answer.ok) throw Error(`${address}: ${answer.status} ${answer.statusText}`);
  return answer.text();
}

/** An example. A mesh that it has from a file stands in its text, which is all that is drawn. */
async function exampleOf(name) {
  const address = new URL(`examples/${name}.json`, import.meta.url), words = await textAt(address), {meshes = [], ...rest} = JSON.parse(words);
  if (!meshes.some(({obj}) => obj)) return words;
  const inText = async ({obj, ...mesh}) => obj ? {...meshOf(/([^/]*)\.obj$/.exec(obj)[1], await textAt(new URL(obj, address))), ...mesh} : mesh;
  return written({...rest, meshes: await Promise.all(meshes.map(inText))});
}

// --- begin -----------------------------------------------------------------------------------------------------------

async function begin() {
  const module = import(new URL("raster-trace.js", import.meta.url)).then(({RasterTrace}) => RasterTrace.module());
  const held = await heldByAddress();
  const first = held.scene ?? await exampleOf(examples[0][1]);
  program = await module;
  if (!held.convention && !program.problem(first)) show(first); // it does not wait for the editor
  const loaded = await Promise.all([import("./editor.js"), fetch("scene.schema.json").then(answer => answer.json())]);
  const schema = loaded[1];
  editor = loaded[0];
  const {enum: conventions, enumDescriptions: whose} = schema.definitions.convention;
  by("convention").append(new Option("the scene's", ""), ...conventions.map((name, i) => Object.assign(new Option(name), {title: whose[i]})));
  by("example").append(new Option("", ""), ...examples.map(([title, name]) => new Option(title, name)));
  view = editor.editorOf(by("editor"), first, schema, () => {
    forgetLink();
    if (!isTaking) { clearTimeout(drawsSoon); drawsSoon = setTimeout(draw, delay); }
  });
  by("claims").value = held.claims ?? "";
  by("convention").value = held.convention ?? "";
  draw();
  by("mistake").value = held.mistake ?? "";
  drawMistake();
  by("convention").addEventListener("change", () => { forgetLink(); draw(); });
  by("mistake").addEventListener("change", () => { forgetLink(); drawMistake(); });
  addEventListener("hashchange", () => location.reload());
  by("claims").addEventListener("input", () => { forgetLink(); clearTimeout(checksSoon); checksSoon = setTimeout(check, delay); });
  by("picture").addEventListener("scene", event => takeMoved(event.detail.scene));
  by("share").addEventListener("click", share);
  by("example").addEventListener("change", async event => {
    if (event.target.value) await exampleOf(event.target.value).then(setText, problem => tellProblem({message: problem.message}));
  });
  by("editor").addEventListener("dragover", event => {
    if (!event.dataTransfer.types.includes("Files")) return;
    event.preventDefault();
    by("editor").classList.add("over");
  });
  by("editor").addEventListener("dragleave", () => by("editor").classList.remove("over"));
  by("editor").addEventListener("drop", drop, {capture: true});
  document.documentElement.dataset.ready = "true";
}

begin().catch(problem => {
  by("problem").hidden = false;
  by("problem").textContent = `The playground cannot begin: ${problem.message}`;
});
