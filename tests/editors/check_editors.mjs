// SPDX-License-Identifier: MIT
// What an editor makes of our files: the JSON language server of VS Code with our schemas, and the messages of the
// program with the problem matchers and the errorformat of docs/editors.md.
//
//     check_editors.mjs PROGRAM SOURCE_FOLDER TOOLS_FOLDER
//
// The language server comes from npm, into TOOLS_FOLDER.
import {execFileSync, spawn, spawnSync} from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import {pathToFileURL} from "node:url";

const [program, source, tools] = process.argv.slice(2).map(name => path.resolve(name));
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "editors-"));
process.on("exit", () => fs.rmSync(folder, {recursive: true}));
const failures = [], counted = {};
const expect = (what, holds, message) => { counted[what] = (counted[what] ?? 0) + 1; if (!holds) failures.push(`${what}: ${message}`); };
const read = (...names) => fs.readFileSync(path.join(source, ...names), "utf8");
const page = read("docs", "editors.md");
/** The JSON on the page that begins so. */
const on_page = begin => JSON.parse(page.slice(page.indexOf("```jsonc\n" + begin) + 9).split("```", 1)[0]);
const write = (name, text) => fs.writeFileSync(path.join(folder, name), text);
/** What the program prints in the folder, messages first. */
const run = (...words) => { const {stdout, stderr} = spawnSync(program, words, {cwd: folder, encoding: "utf8", maxBuffer: 1 << 26}); return stderr + stdout; };

// --- the language server ---------------------------------------------------------------------------------------------

const server_file = path.join(tools, "node_modules/vscode-langservers-extracted/bin/vscode-json-language-server");
if (!fs.existsSync(server_file))
  execFileSync("npm", ["install", "--prefix", tools, "--no-audit", "--no-fund", "--silent", "vscode-langservers-extracted@4.10.0"], {stdio: "inherit"});
const server = spawn(process.execPath, [server_file, "--stdio"], {stdio: ["pipe", "pipe", "inherit"]});
const waiting = new Map();
let bytes = Buffer.alloc(0), next_id = 0;
server.stdout.on("data", more => {
  bytes = Buffer.concat([bytes, more]);
  for (let head; (head = bytes.indexOf("\r\n\r\n")) >= 0;) {
    const end = head + 4 + Number(/Content-Length: (\d+)/.exec(bytes.subarray(0, head))[1]);
    if (bytes.length < end) return;
    const message = JSON.parse(bytes.subarray(head + 4, end));
    bytes = bytes.subarray(end);
    if (message.error) failures.push(`the server says: ${message.error.message}`);
    if (!message.method) waiting.get(message.id)(message.result);
  }
});
function send(message) {
  const text = JSON.stringify({jsonrpc: "2.0", ...message});
  server.stdin.write(`Content-Length: ${Buffer.byteLength(text)}\r\n\r\n${text}`);
}
const notify = (method, params) => send({method, params});
const ask = (method, params) => new Promise(done => { waiting.set(++next_id, done); send({id: next_id, method, params}); });

let documents = 0;
/** A document that is open in the editor. Positions are offsets of one line of text. */
function opened(text, name) {
  const uri = pathToFileURL(path.join(folder, `${++documents}.${name}`)).href;
  notify("textDocument/didOpen", {textDocument: {uri, languageId: "json", version: 1, text}});
  const at = offset => ({textDocument: {uri}, position: {line: 0, character: offset}});
  return {
    hover: async offset => ((await ask("textDocument/hover", at(offset)))?.contents ?? []).join(" ").replace(/\\(.)/g, "$1"),
    complete: async offset => (await ask("textDocument/completion", at(offset))).items,
    faults: async () => (await ask("textDocument/diagnostic", {textDocument: {uri}})).items
  };
}

// --- what a schema says ----------------------------------------------------------------------------------------------

/** The schemas that a value may have to meet, without references and cases. */
function* forms_of(schema, root) {
  if (schema.$ref) return yield* forms_of(schema.$ref.split("/").slice(1).reduce((at, key) => at[key], root), root);
  yield schema;
  for (const part of [...schema.allOf ?? [], ...schema.anyOf ?? []]) yield* forms_of(part, root);
  if (schema.then) for (const form of forms_of(schema.then, root)) yield {...form, beside: {...schema.if.properties, ...form.beside}};
  if (schema.else) yield* forms_of(schema.else, root);
}

/** A value that a schema takes. */
function sample(schema, root) {
  const forms = [...forms_of(schema, root)];
  for (const form of forms) {
    if (form.enum) return form.enum[0];
    if (form.type === "object" && form.properties) {
      const needed = new Set(forms.flatMap(({required}) => required ?? []));
      if (form.minProperties) needed.add(Object.keys(form.properties)[0]);
      return Object.fromEntries([...needed].filter(key => form.properties[key]).map(key => [key, sample(form.properties[key], root)]));
    }
    if (form.type === "array") return Array(form.minItems ?? 1).fill(sample(form.items, root));
    if ([form.type].flat().some(type => type === "number" || type === "integer")) return Math.min(1, form.maximum ?? 1);
    if (form.type === "boolean") return true;
    if (form.type === "string") return ["A".repeat(form.minLength ?? 1), "#", "1"].find(text => new RegExp(form.pattern ?? "").test(text));
  }
  return {};
}

/** Every key that a file may have: the text in front of it and behind its value, what it is, what stands beside it. */
function* keys_of(schema, root, before = "", after = "", name = "", seen = []) {
  if (seen.includes(schema)) return; // lists of lists
  const deeper = [...seen, schema];
  for (const form of forms_of(schema, root)) {
    if (form.items) yield* keys_of(form.items, root, before + "[", "]" + after, name, deeper);
    if (typeof form.additionalProperties === "object")
      yield* keys_of(form.additionalProperties, root, before + '{"/A":', "}" + after, name, deeper);
    for (const [key, value] of Object.entries(form.properties ?? {})) {
      const is_condition = value === false || value.const || form.additionalProperties !== false;
      if (is_condition && !value.description) continue; // on a key that is told elsewhere
      const others = Object.fromEntries([...Object.keys(form.beside ?? {}), ...form.required ?? []].map(other => [other, form.beside?.[other]?.const ?? sample(form.properties[other], root)]));
      delete others[key];
      const beside = JSON.stringify(others).slice(1, -1);
      const one = {key, value, name: `${name}/${key}`, before: before + "{" + beside + (beside && ","), after: "}" + after};
      yield one;
      yield* keys_of(value, root, one.before + `"${key}":`, one.after, one.name, deeper);
    }
  }
}

const labels_of = items => items.map(item => item.label.replace(/^"|"$/g, ""));
const is_at = (fault, begin, end) => fault.range.start.character >= begin && fault.range.end.character <= end;

/** Every key: its hover, the completion of its name and of its values, and what is marked if its value is wrong. */
async function check_keys(kind, associate) {
  const root = JSON.parse(run("validate", "--schema", kind));
  const keys = [...keys_of(root, root)].filter(({name}) => name !== "/$schema");
  expect(`kinds of file`, keys.length > (kind === "scene" ? 120 : 15), `${kind}: only ${keys.length} keys`);
  const done = new Set();
  for (const {key, value, name, before, after} of keys) {
    if (done.has(before + name)) continue;
    done.add(before + name);
    const head = associate(before) + `"${key}":`, good = JSON.stringify(sample(value, root));
    const document = opened(head + good + after, `${kind}.json`);
    const hover = await document.hover(head.length - 3);
    expect("hovers", hover.includes(value.description), `${kind} ${name}: ${hover || "nothing"}`);
    expect("values that are right", !(await document.faults()).some(fault => is_at(fault, head.length, head.length + good.length)), `${kind} ${name}: ${good}`);

    if (kind === "trace") continue; // which programs write
    const without = head.slice(0, -key.length - 3);
    const items = await opened(without + '""' + after, `${kind}.json`).complete(without.length + 1);
    const item = items.find(item => item.label === key);
    expect("keys offered", item?.documentation, `${kind} ${name}: ${JSON.stringify(item)}`);

    for (const form of forms_of(value, root)) {
      if (!form.enum) continue;
      const values = await opened(head + '""' + after, `${kind}.json`).complete(head.length + 1);
      for (const word of form.enum.filter(word => word !== null)) {
        const found = values.find(item => item.label === JSON.stringify(word));
        const described = kind !== "scene" || (found?.documentation && found.documentation !== value.description);
        expect("values offered", found && described, `${kind} ${name}: ${word}: ${JSON.stringify(found)}`);
      }
    }
    if (kind !== "scene") continue;
    const wrong = await opened(head + "true" + after, "scene.json").faults();
    expect("values that are wrong", wrong.some(fault => is_at(fault, head.length, head.length + 4)), `${name}: ${JSON.stringify(wrong)}`);
    const mistyped = head + good + ',"mistyped"';
    const faults = await opened(mistyped + ":1" + after, "scene.json").faults();
    expect("keys that are wrong", faults.some(fault => is_at(fault, mistyped.length - 10, mistyped.length)), `${name}: ${JSON.stringify(faults)}`);
  }
  return keys;
}

/** What the program lists as an option's values is what the editor offers. */
async function check_values_of_method(keys) {
  const help = run("trace", "--help").split(/\n\n/).find(part => part.startsWith("Method")).replace(/\n {3,}/g, " ");
  let options = 0;
  for (const [, option, listed] of help.matchAll(/^ +--([a-z-]+) NAME .*\(([^()]*)\)$/gm)) {
    const {before, key, after} = keys.find(({key}) => key === option.replaceAll("-", "_"));
    const head = before.replace("{", '{"$schema":"scene.schema.json",') + `"${key}":`;
    const offered = labels_of(await opened(head + '""' + after, "json").complete(head.length + 1));
    expect("values of the method", listed.split(", ").every(word => offered.includes(word)) && new Set(offered).size === listed.split(", ").length, `${key}: ${listed}: ${offered}`);
    ++options;
  }
  expect("options", options > 20, `only ${options}`);
}

async function check_files() {
  const files = fs.readdirSync(path.join(source, "examples"), {recursive: true}).map(name => path.join(source, "examples", name)).filter(name => fs.statSync(name).isFile() && !/\.obj$/.test(name));
  for (const {file, kind, valid} of JSON.parse(spawnSync(program, ["validate", "--json", ...files], {encoding: "utf8", maxBuffer: 1 << 26}).stdout)) {
    const text = fs.readFileSync(file, "utf8");
    if (!valid || !text.startsWith("{") || file.endsWith("l")) continue;
    const faults = await opened(text, `${kind}.json`).faults();
    expect(`${kind}: examples`, faults.length === 0, `${file}: ${JSON.stringify(faults)}`);
  }
  const trace = run("trace", path.join(source, "examples/t0-fill/first-triangle.json"), "--format", "json");
  for (const [text, count] of [[trace, 0], [trace.replace('"step"', '"stop"'), 1]]) {
    const faults = await opened(text, "trace.json").faults();
    expect("traces", faults.length === count, `expected ${count} faults, found ${JSON.stringify(faults)}`);
  }
}

// --- messages --------------------------------------------------------------------------------------------------------

/** The problems that VS Code finds in some output: the first matcher that fits takes its lines. */
function problems_in(output, matchers) {
  const lines = output.split("\n"), problems = [];
  for (let i = 0; i < lines.length; ++i)
    matchers.some(({severity, pattern}) => {
      const patterns = [pattern].flat(), last = patterns.at(-1), problem = {severity};
      const take = (part, line) => {
        const found = new RegExp(part.regexp).exec(line ?? "");
        for (const field of found ? ["file", "line", "column", "message"] : [])
          if (part[field]) problem[field] = found[part[field]];
        return found;
      };
      if (!patterns.every((part, k) => take(part, lines[i + k]))) return false;
      problems.push({...problem});
      i += patterns.length - 1;
      while (last.loop && take(last, lines[i + 1])) { problems.push({...problem}); ++i; }
      return true;
    });
  return problems;
}

const bad_files = [ // kind, name, text, line, column, words of the command
  ["a scene", "bad.json", '{"vertices": {"A": [2, 5]},\n "lines": ["AB"]}', 2, 14, ["validate"]],
  ["a scene that is no JSON", "cut.json", '{"vertices": {"A": [2, 5]', 1, 26, ["show"]],
  ["an OBJ file", "bad.obj", "v 0 0 0\nf 1 2 3\n", 2, 5, ["show"]],
  ["a mesh of a scene", "bad.obj", "", 2, 5, ["validate", "mesh.json"]],
  ["a lost mesh", "mesh2.json", '{"meshes": [{"obj": "none.obj"}]}', 1, 21, ["validate"]],
  ["a trace", "bad.jsonl", '{"rastertrace":1,"canvas":{"width":9,"height":9}}\n{"step":5}\n{"end":{"steps":1}}\n', 2, 1, ["validate"]],
  ["a trace in one document", "trace.json", '{"rastertrace":1,"canvas":{"width":0}}', 1, 36, ["validate"]],
  ["claims", "bad.claims", "y=2: 1/4\n", 1, 9, ["check", "scene.json"]],
  ["claims in JSON", "claims.json", '{"claims": [{"step": "scanline", "z": 2}]}', 1, 34, ["check", "scene.json"]],
  ["claims of a lost scene", "lost.claims", "scene: none.json\ny=2: 1, 2\n", 1, 8, ["check"]],
  ["a sheet", "sheet.csv", "y;xL;xR\n2;a;3\n", 2, 3, ["check", "scene.json"]],
  ["a sheet with a space in its name", "my sheet.csv", "y;xL;xR\n2;a;3\n", 2, 3, ["check", "scene.json"]],
  ["a picture", "picture.txt", ".#\n.##\n", 2, 3, ["diagnose", "scene.json"]],
  ["a page", "page.md", "\n```console\n$ rastertrace show none.json\n```\n", 3, 1, ["renew", "--check"]],
];

function check_messages() {
  const [validate, check] = on_page('{\n  "version"').tasks;
  const formats = /errorformat=(.*)/.exec(page)[1].split(",").map(format => new RegExp("^" + format.replaceAll("\\ ", " ")
    .replace("%f", "(?<file>.+?)").replace("%l", "(?<line>\\d+)").replace("%c", "(?<column>\\d+)").replace("%m", "(?<message>.+)") + "$"));
  write("scene.json", read("examples", "t0-fill", "first-triangle.json"));
  write("mesh.json", '{"meshes": [{"obj": "bad.obj"}]}');
  for (const [kind, file, text, line, column, words] of bad_files) {
    if (text) write(file, text);
    const output = run(...words, ...text ? [file] : []);
    const place = {file, line: String(line), column: String(column)};
    for (const [by, found] of [["VS Code", problems_in(output, validate.problemMatcher)], ["VS Code, check", problems_in(output, check.problemMatcher)],
                               ["Vim", [{severity: "error", ...formats[0].exec(output.split("\n", 1)[0])?.groups}]]]) {
      const {message, ...rest} = found[0] ?? {};
      expect("messages", found.length === 1 && /^expected ./.test(message) && JSON.stringify(rest) === JSON.stringify({severity: "error", ...place}), `${kind}, ${by}: ${JSON.stringify(found)} in\n${output}`);
    }
  }
  const same = (words, task, problems) => {
    const found = problems_in(run(...words), task.problemMatcher);
    expect("messages", JSON.stringify(found) === JSON.stringify(problems), `${words}: expected ${JSON.stringify(problems)}, found ${JSON.stringify(found)}`);
  };
  write("empty.json", "");
  same(["validate", "empty.json", "scene.json"], validate, [{severity: "error", file: "empty.json", message: "expected a scene, a trace or claims, found an empty file"}]);
  write("rows.claims", "scene: scene.json\ny=99: 1, 2\n");
  const [remark] = problems_in(run("validate", "rows.claims"), validate.problemMatcher);
  expect("messages", remark?.severity === "info" && remark.line === "2" && remark.column === "1", `a remark: ${JSON.stringify(remark)}`);
  write("wrong.claims", "scene: scene.json\ny=2: 1/4, 7\ny=1: -1, 7/2\n(3,2): off\npicture:\n" + run("show", "scene.json", "--bare").replace(".", "#"));
  const wrong = (line, message) => ({severity: "warning", file: "wrong.claims", line, message});
  same(["check", "wrong.claims"], check, [wrong("2", "left end: expected -1/4, found 1/4"), wrong("2", "right end: expected 25/8, found 7"),
    wrong("4", "pixel: expected on, found off"), wrong("5", "picture: 1 too many, 0 missing")]);
  write("faults.txt", read("examples", "sheets", "faults.txt"));
  const faults = problems_in(run("check", "scene.json", "faults.txt"), check.problemMatcher);
  expect("messages", faults.map(({severity, file, line, column}) => [severity, file, line, column].join(" ")).join(", ") === "error faults.txt 2 13, error faults.txt 3 3, error faults.txt 5 6", JSON.stringify(faults));
  expect("messages", formats[2].exec("wrong.claims:4: (3,2): off")?.groups.line === "4", "Vim: a wrong claim");
}

// --- all of it -------------------------------------------------------------------------------------------------------

await ask("initialize", {processId: process.pid, rootUri: pathToFileURL(folder).href,
  capabilities: {textDocument: {hover: {contentFormat: ["markdown"]}, completion: {completionItem: {documentationFormat: ["plaintext"]}}, diagnostic: {}}}});
notify("initialized", {});
for (const kind of ["scene", "claims", "trace"]) write(`${kind}.schema.json`, run("validate", "--schema", kind));
// By "$schema" in the file; then by the settings, as VS Code hands them on.
const keys = await check_keys("scene", before => before.replace("{", '{"$schema":"scene.schema.json",'));
await check_values_of_method(keys);
const {"json.schemas": schemas} = on_page('{\n  "json.schemas"');
notify("workspace/didChangeConfiguration", {settings: {json: {validate: {enable: true},
  schemas: schemas.map(({fileMatch, url}) => ({fileMatch, url: pathToFileURL(path.join(folder, path.basename(url))).href}))}}});
for (const kind of ["scene", "claims", "trace"]) await check_keys(kind, before => before);
await check_files();
server.kill();
check_messages();
for (const [what, count] of Object.entries(counted)) console.log(`${count} ${what}`);
failures.slice(0, 40).forEach(message => console.log(message));
if (failures.length > 0) console.log(`${failures.length} failures`);
process.exit(failures.length > 0 ? 1 : 0);
