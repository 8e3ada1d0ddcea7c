// SPDX-License-Identifier: MIT
// The commands and queries of docs/big-traces.md, as a user runs them: what SQL answers about traces is what `stats` and
// `diff` say. Then the same queries about every example, drawn in doubles and in fractions.
//
//     check_big_traces.cjs PROGRAM SOURCE_FOLDER TOOLS_FOLDER
//
// DuckDB comes from npm, into TOOLS_FOLDER.
"use strict";
const {execFileSync, spawnSync} = require("node:child_process");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");

const [program, source, tools] = process.argv.slice(2).map(name => path.resolve(name));
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "big-traces-"));
process.on("exit", () => fs.rmSync(folder, {recursive: true}));
const failures = [];
let checks = 0;
function expect_same(what, found, expected) {
  ++checks;
  if (JSON.stringify(found) !== JSON.stringify(expected))
    failures.push(`${what}: expected ${JSON.stringify(expected)?.slice(0, 300)}, found ${JSON.stringify(found)?.slice(0, 300)}`);
}

const duckdb = path.join(tools, "node_modules/@duckdb/node-api");
if (!fs.existsSync(duckdb))
  execFileSync("npm", ["install", "--prefix", tools, "--no-audit", "--no-fund", "--silent", "@duckdb/node-api@1.5.6-r.1"], {stdio: "inherit"});
const environment = {...process.env, PATH: `${path.dirname(program)}:${process.env.PATH}`};

const page = fs.readFileSync(path.join(source, "docs/big-traces.md"), "utf8");
const blocks = language => [...page.matchAll(new RegExp("```" + language + "\\n([^]*?)```", "g"))].map(([, text]) => text);
const [view, ...others] = blocks("sql");
/** The queries by the names in their first lines. */
const queries = new Map(others.map(sql => [sql.match(/^-- (\w+)\n/)[1], sql]));

/** What the program says of traces, as JSON. A difference is no failure. */
const said = (...words) => JSON.parse(spawnSync(program, [...words, "--json"], {cwd: folder, encoding: "utf8", maxBuffer: 1 << 28}).stdout);
const by_name = list => list.sort(([a], [b]) => (a < b ? -1 : 1));
const place = ({x, y}) => [Number(x), Number(y)];

/** What each query is to answer. */
const checks_of = {
  totals(rows, traces) {
    expect_same("the traces", rows.map(row => row.trace), Object.keys(traces).sort());
    for (const {trace, ...row} of rows) {
      const {steps, writes, pixels} = traces[trace];
      expect_same(`totals of ${trace}`, Object.values(row).map(Number), [steps, writes, pixels]);
    }
  },
  overdraw(rows, {writes, pixels, primitives}, trace) {
    expect_same(`pixels of ${trace}`, rows.length, pixels);
    expect_same(`writes of ${trace}`, rows.reduce((sum, row) => sum + Number(row.writes), 0), writes);
    const writes_of = new Map();
    for (const name of rows.flatMap(row => row.by)) writes_of.set(name, (writes_of.get(name) ?? 0) + 1);
    const told = new Map();
    for (const {name, writes} of primitives) if (writes) told.set(name, (told.get(name) ?? 0) + writes);
    expect_same(`who wrote in ${trace}`, by_name([...writes_of]), by_name([...told]));
  },
  fights(rows, {depth_ties}, trace) {
    const sorted = pixels => pixels.sort(([x1, y1], [x2, y2]) => y2 - y1 || x1 - x2);
    const {count, pixels} = depth_ties ?? {count: 0, pixels: []};
    expect_same(`number of depth ties of ${trace}`, rows.length, count);
    if (pixels.length === count) // stats lists the first 1000
      expect_same(`depth ties of ${trace}`, sorted(rows.map(place)), sorted(pixels));
  },
  rows(rows, difference) {
    const {changed, only_a, only_b} = difference.kinds.find(({kind}) => kind === "scanline");
    expect_same("rows that differ", rows.length, changed + only_a + only_b);
    const {a, b} = difference.first;
    const first = rows.find(row => Number(row.y) === a.step.y);
    expect_same("the first row that differs", [first.from_a, first.from_b, first.to_a, first.to_b].map(Number),
      [a.step.from, b.step.from, a.step.to, b.step.to]);
  }
};

async function database() {
  const {DuckDBInstance} = require(duckdb);
  const connection = await (await DuckDBInstance.create(":memory:")).connect();
  await connection.run(`SET file_search_path = '${folder}'`);
  const rows_of = async sql => (await connection.runAndReadAll(sql)).getRowObjectsJson();
  return {run: sql => connection.run(sql), rows_of};
}

async function main() {
  // As on the page.
  fs.symlinkSync(path.join(source, "examples"), path.join(folder, "examples"));
  execFileSync("sh", ["-ec", blocks("sh")[0]], {cwd: folder, env: environment, stdio: "inherit"});
  const triangle = "examples/t0-fill/first-triangle.json";
  const traces = {
    floor: said("stats", triangle), truncate: said("stats", triangle, "--rounding", "truncate"),
    cubes: said("stats", "examples/t0-hidden/two-cubes.json")
  };
  const {run, rows_of} = await database();
  await run(view);
  const answers = {
    totals: traces, overdraw: traces.cubes, fights: traces.cubes, rows: said("diff", triangle, "--against", "rounding=truncate")
  };
  expect_same("queries on the page", [...queries.keys()], Object.keys(answers));
  for (const [name, sql] of queries) checks_of[name](await rows_of(sql), answers[name], "cubes");

  // Every example that is a scene.
  fs.mkdirSync(path.join(folder, "all"));
  const examples = {};
  for (const file of fs.readdirSync(path.join(source, "examples"), {recursive: true}).filter(name => name.endsWith(".json")))
    for (const scalar of ["double", "exact"]) {
      const name = `${file.slice(0, -5).replaceAll("/", ", ")}, ${scalar}`;
      const words = [path.join("examples", file), "--scalar", scalar, "--frame", "1"];
      if (spawnSync(program, ["trace", ...words, "--flat", "-o", `all/${name}.jsonl`], {cwd: folder}).status === 0)
        examples[name] = said("stats", ...words);
    }
  if (Object.keys(examples).length < 100) failures.push(`only ${Object.keys(examples).length} traces`);
  const all = view.replace("CREATE", "CREATE OR REPLACE");
  await run(all.replace("*.jsonl", "all/*.jsonl"));
  checks_of.totals(await rows_of(queries.get("totals")), examples);
  for (const [name, stats] of Object.entries(examples)) {
    await run(all.replace("*.jsonl", `all/${name}.jsonl`)); // faster
    // A table has the columns of its steps alone.
    for (const [query, kind] of [["overdraw", "pixel"], ["fights", "depth"]]) if (stats.count[kind])
      checks_of[query](await rows_of(queries.get(query).replace("'cubes'", `'${name}'`)), stats, name);
  }

  for (const failure of failures) console.error(failure);
  console.log(`${checks} checks of ${Object.keys(examples).length} traces, ${failures.length} failures`);
  process.exitCode = failures.length > 0 ? 1 : 0;
}

main();
