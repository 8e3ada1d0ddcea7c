#!/usr/bin/env node
// SPDX-License-Identifier: MIT
// Steps of traces as Parquet: FOLDER/trace=NAME/part.parquet for each, which engines read as one table with a column
// `trace`. docs/big-traces.md has queries.
//
//     npm install @duckdb/node-api
//     node scripts/to-parquet.cjs FOLDER TRACE...
//
// A TRACE is a file that `rastertrace convert` reads; its NAME is that of the file without endings. The program is
// RASTERTRACE, or else `rastertrace`. An older file of that name is replaced.
"use strict";
const {spawnSync} = require("node:child_process");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");

const program = process.env.RASTERTRACE || "rastertrace";
const [folder, ...traces] = process.argv.slice(2);

class Failure extends Error {
  constructor(message, status) {
    super(message);
    this.status = status;
  }
}

/** What the program prints, unless it goes to a file; it has told what is wrong if it fails. */
function run(words, output = "pipe") {
  const {status, stdout, error} = spawnSync(program, words, {encoding: "utf8", stdio: ["ignore", output, "inherit"]});
  if (error) throw new Failure(`${program} could not be started: ${error.message}; RASTERTRACE names another one`, 3);
  if (status !== 0) throw new Failure("", status ?? 3);
  return stdout;
}

/** `floor` of `traces/floor.jsonl.zst`. */
const name_of = trace => path.basename(trace).replace(/\.(gz|zst)$/, "").replace(/\.jsonl?$/, "");
const quoted = text => `'${text.replaceAll("'", "''")}'`;

/** The columns of flat steps, with their types. */
function columns() {
  const rows = run(["convert", "--columns"]).trim().split(/\r?\n/).slice(1).map(line => line.split(","));
  return `{${rows.map(([name, type]) => `${quoted(name)}: ${quoted(type)}`).join(", ")}}`;
}

async function main() {
  if (!folder || traces.length === 0) throw new Failure("expected FOLDER TRACE..., found fewer words", 2);
  const names = traces.map(name_of);
  const twice = names.find((name, i) => names.indexOf(name) < i);
  if (twice !== undefined) throw new Failure(`expected traces of different names, found two of ${twice}`, 2);

  const {DuckDBInstance} = require(require.resolve("@duckdb/node-api", {paths: [process.cwd(), __dirname]}));
  const connection = await (await DuckDBInstance.create(":memory:")).connect();
  const types = columns();
  for (const [i, trace] of traces.entries()) {
    const part = path.join(folder, `trace=${encodeURIComponent(names[i])}`, "part.parquet");
    fs.mkdirSync(path.dirname(part), {recursive: true});
    const steps = `${part}.jsonl`, unfinished = `${part}.new`;
    try {
      const output = fs.openSync(steps, "w");
      run(["convert", trace, "--to", "flat"], output);
      fs.closeSync(output);
      const is_small = fs.statSync(steps).size < 10_000_000; // it would only wait for other threads
      await connection.run(`SET threads = ${is_small ? 1 : os.availableParallelism()}`);
      await connection.run(`COPY (FROM read_json(${quoted(steps)}, format = 'newline_delimited', columns = ${types}))
                            TO ${quoted(unfinished)} (FORMAT parquet, COMPRESSION zstd)`);
      fs.renameSync(unfinished, part);
    } finally {
      fs.rmSync(steps, {force: true});
      fs.rmSync(unfinished, {force: true});
    }
  }
}

main().catch(({message, status}) => {
  if (message) console.error(`to-parquet: ${message}`);
  process.exitCode = status ?? 3;
});
