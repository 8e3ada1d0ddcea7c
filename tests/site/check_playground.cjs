// SPDX-License-Identifier: MIT
// The playground as somebody uses it: a scene is typed, broken, mended, dragged, asked about, checked, shared and opened again.
//
//     check_playground.cjs FOLDER     with playground/, which needs nothing else of a site
"use strict";

const {launch, axe} = require("../page/browser.cjs");
const fs = require("fs"), http = require("http"), path = require("path"), zlib = require("zlib");

const folder = path.resolve(process.argv[2]);
const failures = [], counted = {};
let doing = "";
const fail = message => failures.push(`${doing}: ${message.slice(0, 1000)}`);
const expectSame = (found, expected, what) => {
  counted.comparisons = (counted.comparisons ?? 0) + 1;
  if (JSON.stringify(found) !== JSON.stringify(expected)) fail(`${what}: expected ${JSON.stringify(expected)}, found ${JSON.stringify(found)}`);
};

const types = {".html": "text/html", ".css": "text/css", ".js": "text/javascript", ".mjs": "text/javascript", ".wasm": "application/wasm", ".json": "application/json"};
const compressed = {}; // as a site keeps its files
const server = http.createServer((request, answer) => {
  const file = path.join(folder, decodeURI(request.url.split("?")[0]));
  if (!request.url.startsWith("/playground/") || !fs.existsSync(file)) return answer.writeHead(404).end("<h1>There is no such page</h1>");
  compressed[file] ??= zlib.gzipSync(fs.readFileSync(file), {level: 9});
  answer.writeHead(200, {"content-type": types[path.extname(file)] ?? "text/plain", "content-encoding": "gzip"}).end(compressed[file]);
});

/** Waits until something holds in the page. */
const until = (page, holds, argument) => page.waitForFunction(holds, argument, {timeout: 20000}).catch(() => fail(`it never became so: ${holds}`));
let browser, address;
async function open(hash, options) {
  const context = await browser.newContext({viewport: {width: 1400, height: 1000}, ...options}), page = await context.newPage();
  page.on("console", message => fail(`the console says ${message.type()}: ${message.text()}`));
  page.on("pageerror", error => fail(`an error: ${error.message}`));
  page.on("dialog", dialog => { fail(`a dialog: ${dialog.message()}`); dialog.dismiss(); });
  page.on("request", request => { if (!request.url().startsWith(address)) fail(`it asks for ${request.url()}`); });
  await page.goto(`${address}/playground/index.html${hash}`);
  await page.waitForSelector("html[data-ready]", {timeout: 20000});
  await until(page, () => Number(document.querySelector("#picture").shadowRoot.getElementById("last")?.textContent) > 0);
  return page;
}

/** Replaces the scene as a reader would: all of it is chosen, and typed over. */
async function type(page, words) {
  await page.click(".cm-content");
  await page.keyboard.press("Control+a");
  await page.keyboard.insertText(words);
}
const typed = page => page.$eval(".cm-content", content => Array.from(content.querySelectorAll(".cm-line"), line => line.textContent).join("\n"));
const titleOf = page => page.textContent("#picture #title");

const scene = title => JSON.stringify({title, canvas: {width: 17, height: 14}, vertices: {A: [2, 5], B: [-4, -3], C: [5, -3]}, triangles: ["ABC"], method: {scalar: "exact"}}, null, 1);

async function checkUse(options) {
  const page = await open("", options);
  expectSame(await titleOf(page), "First triangle", "the first picture");
  // Typed, broken, mended; names that would do something if they were obeyed.
  const hostile = "</script><img src=x onerror=alert(1)>&amp;";
  await type(page, scene(hostile));
  await until(page, title => document.querySelector("#picture").shadowRoot.getElementById("title").textContent === title, hostile);
  await type(page, scene("Broken").replace('"ABC"', '"ABD"'));
  await until(page, () => !document.getElementById("problem").hidden);
  expectSame(/^line 22, column 6: expected the name of a vertex, found "D"\n/.test(await page.textContent("#problem")), true, `the problem: ${await page.textContent("#problem")}`);
  expectSame(await page.$$eval(".cm-lintRange-error", all => all.length), 1, "the place is marked");
  expectSame(await titleOf(page), hostile, "the picture stays");
  await type(page, scene("Mended"));
  await until(page, () => document.querySelector("#picture").shadowRoot.getElementById("title").textContent === "Mended");
  expectSame(await page.isVisible("#problem"), false, "no problem");
  // A vertex is dragged, and the text follows.
  await page.locator("#picture #buttons").scrollIntoViewIfNeeded();
  await page.locator("#picture [data-vertex=A]").scrollIntoViewIfNeeded();
  const handle = await page.locator("#picture [data-vertex=A]").boundingBox(), cell = (await page.locator("#picture #raster").boundingBox()).width / 17;
  await page.mouse.move(handle.x + handle.width / 2, handle.y + handle.height / 2);
  await page.mouse.down();
  for (let i = 1; i <= 4; ++i) await page.mouse.move(handle.x + handle.width / 2 - i / 2 * cell, handle.y + handle.height / 2 + i / 4 * cell);
  await page.mouse.up();
  await until(page, () => /"A":\s*\[0, 4\]/.test(document.querySelector(".cm-content").textContent));
  // A pixel, a table, a mistake, a convention.
  const raster = await page.locator("#picture #raster").boundingBox();
  await page.mouse.click(raster.x + 1.5 * cell, raster.y + 1.5 * cell);
  expectSame((await page.textContent("#picture #pixel-told")).includes("not drawn: ABC does not cover it"), true, "why a pixel is not drawn");
  await page.fill("#claims", "y=4: 0, 0 -> 0..0\ny=3: 7, 8 -> 0..1\n");
  await until(page, () => document.querySelectorAll("#checked li").length === 2);
  expectSame(await page.$$eval("#checked .verdict", all => all.map(one => one.textContent)), ["right", "wrong"], "what was worked out");
  await page.fill("#claims", "(0,4): off\n");
  await until(page, () => document.querySelector("#checked pre")?.textContent.startsWith("pixel: expected on, found off\n"));
  await page.fill("#claims", "y=4: 0, 0 -> 0..0\ny=3: 7, 8 -> 0..1\n");
  await page.selectOption("#convention", "cgfs");
  await until(page, () => document.querySelector("#picture").shadowRoot.getElementById("in-force").textContent.includes("convention cgfs"));
  await page.selectOption("#mistake", "slope-of-zero");
  await until(page, () => Number(document.querySelector("#wrong-picture").shadowRoot.getElementById("last")?.textContent) > 0);
  const lastOf = id => page.textContent(`${id} #last`);
  expectSame(await lastOf("#picture") !== await lastOf("#wrong-picture"), true, "another picture with the mistake");
  // The link holds all of it.
  await page.click("#share");
  await until(page, () => location.hash.length > 20);
  const there = await open(new URL(page.url()).hash, options);
  expectSame(await typed(there), await typed(page), "the scene of the link");
  expectSame([await there.inputValue("#claims"), await there.inputValue("#mistake"), await there.inputValue("#convention")],
             ["y=4: 0, 0 -> 0..0\ny=3: 7, 8 -> 0..1\n", "slope-of-zero", "cgfs"], "the rest of the link");
  await there.context().close();
  expectSame(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true, "nothing is cut off");
  await page.evaluate(axe);
  const {violations} = await page.evaluate(() => axe.run());
  for (const one of violations) fail(`axe: ${one.id}: ${one.help}: ${one.nodes.map(node => node.html).join(" ").slice(0, 300)}`);
  await page.context().close();
}

/** Each example opens, and is drawn. */
async function checkExamples() {
  const page = await open(""), names = await page.$$eval("#example option", all => all.map(one => one.value).filter(name => name));
  expectSame(names.length, 8, "examples");
  for (const name of names) {
    const {title} = JSON.parse(fs.readFileSync(path.join(folder, "playground/examples", `${name}.json`), "utf8"));
    await page.selectOption("#example", name);
    await until(page, title => document.querySelector("#picture").shadowRoot.getElementById("title").textContent === title, title);
    expectSame([await page.isVisible("#problem"), Number(await page.textContent("#picture #last")) > 0], [false, true], name);
  }
  await page.context().close();
}

/** A cube is turned, and the text follows. */
async function checkTurning() {
  const page = await open("");
  await page.selectOption("#example", {label: "Cube, depth buffer of 1/z"});
  await until(page, () => document.querySelector("#picture").shadowRoot.getElementById("title").textContent.includes("cube"));
  const box = await page.locator("#picture #raster").boundingBox();
  await page.mouse.move(box.x + 50, box.y + 50);
  await page.mouse.down();
  for (let i = 1; i <= 5; ++i) await page.mouse.move(box.x + 50 + 12 * i, box.y + 50);
  await page.mouse.up();
  await until(page, () => document.querySelector(".cm-content").textContent.includes("\"degrees\": 30"));
  const scene = JSON.parse(await typed(page));
  expectSame([scene.meshes[0].model.length, scene.meshes[0].vertices.A], [2, [-1, 1, -1]], "the model of the mesh, and its vertices");
  await page.context().close();
}

/** Keys, values and their meanings come from the schema. */
async function checkWords() {
  const page = await open("");
  const offered = async before => {
    await type(page, before);
    await page.keyboard.press("Control+Space");
    await page.waitForSelector(".cm-tooltip-autocomplete li");
    const words = await page.$$eval(".cm-tooltip-autocomplete li .cm-completionLabel", all => all.map(one => one.textContent));
    await page.keyboard.press("Escape");
    return words;
  };
  expectSame((await offered('{"can')).includes('"canvas"'), true, "a key");
  expectSame(await offered('{"method": {"fill": "top'), ['"top-left"'], "a value");
  expectSame((await offered('{"method": {"')).includes('"rounding"'), true, "a key of the method");
  expectSame((await offered('{"meshes": [{"draw": "')).includes('"hidden-lines"'), true, "within an array");
  await page.context().close();
}

/** A link that is damaged, and an OBJ file that is dropped. */
async function checkInput() {
  let page = await open("#damaged");
  expectSame([await titleOf(page), await page.textContent("#said")], ["First triangle", "This link is damaged."], "a damaged link");
  const data = await page.evaluateHandle(() => {
    const transfer = new DataTransfer();
    transfer.items.add(new File(["v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1/1 2/2 -1\n"], "three.obj"));
    return transfer;
  });
  await page.dispatchEvent(".cm-content", "drop", {dataTransfer: data});
  await until(page, () => JSON.parse(document.querySelector("#picture").scene).meshes?.[0].name === "three");
  expectSame(JSON.parse(await typed(page)).meshes[0].faces, [["1", "2", "3"]], "the mesh");
  await page.context().close();
}

/** Milliseconds to the first picture from a cold cache at 9 Mbit/s and 60 ms; undefined, if there is none in 30 s. */
async function timeToFirstPicture() {
  const context = await browser.newContext(), page = await context.newPage(), protocol = await context.newCDPSession(page);
  const told = [];
  page.on("console", message => told.push(message.text()));
  page.on("requestfailed", request => told.push(`${request.url()}: ${request.failure().errorText}`));
  await protocol.send("Network.enable");
  await protocol.send("Network.emulateNetworkConditions", {offline: false, latency: 60, downloadThroughput: 9e6 / 8, uploadThroughput: 9e6 / 8});
  const begin = Date.now();
  await page.goto(`${address}/playground/index.html`, {waitUntil: "commit"});
  const time = await page.waitForFunction(() => Number(document.querySelector("#picture")?.shadowRoot?.getElementById("last")?.textContent) > 0, undefined, {timeout: 30000})
    .then(() => Date.now() - begin, () => undefined);
  if (time === undefined) {
    const state = await page.evaluate(() => [document.readyState, document.getElementById("problem")?.textContent,
      ...performance.getEntriesByType("resource").map(one => `${one.name} ${Math.round(one.startTime)}..${Math.round(one.responseEnd)}`)]);
    console.log(["no first picture in 30 s", ...state, ...told].join("\n  "));
  }
  await context.close();
  return time;
}

/** The browser's slow network has stalled once: a page without a picture is told, and tried again. */
async function measureFirstPicture() {
  const times = [];
  for (let i = 0; i < 3; ++i) times.push(await timeToFirstPicture() ?? await timeToFirstPicture() ?? fail("no first picture in 30 s, twice"));
  console.log(`first picture at 9 Mbit/s and 60 ms: ${times.sort((a, b) => a - b)[1]} ms`);
}

async function main() {
  await new Promise(done => server.listen(0, "localhost", done));
  address = `http://localhost:${server.address().port}`;
  browser = await launch();
  const checks = [["words", checkWords], ["input", checkInput], ["examples", checkExamples], ["turning", checkTurning], ["first picture", measureFirstPicture],
    ...["light", "dark"].flatMap(colorScheme => [360, 1400].map(width =>
      [`${colorScheme}, ${width} wide`, () => checkUse({colorScheme, viewport: {width, height: 1000}})]))];
  for (const [name, check] of checks.filter(([name]) => name.includes(process.argv[3] ?? ""))) {
    doing = name;
    try {
      await check();
    } catch (error) {
      fail(error.stack);
    }
  }
  await browser.close();
  server.close();
  console.log(Object.entries(counted).map(([what, number]) => `${number} ${what}`).join(", "));
  for (const message of failures) console.log(message);
  process.exitCode = failures.length ? 1 : 0;
}

main();
