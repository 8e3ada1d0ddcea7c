// SPDX-License-Identifier: MIT
// <raster-trace> on pages of others: ten on one page with one module, events, attributes, scenes that are wrong or hostile,
// without JavaScript, on paper, on a telephone, on a site of mkdocs, as a widget of a notebook.
//
//     check_element.cjs ELEMENT_FOLDER MODULE_FOLDER SOURCE_FOLDER
//
// raster-trace.js lies in the first folder, rastertrace.mjs and rastertrace.wasm in the second.
"use strict";

const {launch, axe} = require("./browser.cjs");
const {execFileSync} = require("child_process");
const fs = require("fs"), http = require("http"), os = require("os"), path = require("path");

const [elementFolder, moduleFolder, source] = process.argv.slice(2).map(name => path.resolve(name));
const site = fs.mkdtempSync(path.join(os.tmpdir(), "element-"));
const failures = [], counted = {};
let doing = "";
const fail = message => failures.push(`${doing}: ${message}`);
const count = what => counted[what] = (counted[what] ?? 0) + 1;
const expectSame = (found, expected, what) => {
  count("comparisons");
  if (JSON.stringify(found) !== JSON.stringify(expected))
    fail(`${what}: expected ${JSON.stringify(expected)}, found ${JSON.stringify(found)}`);
};

// --- a site of the files, the examples, and the page of a check --------------------------------------------------------

const types = {".html": "text/html", ".js": "text/javascript", ".mjs": "text/javascript", ".wasm": "application/wasm", ".json": "application/json"};
const files = {}; // "/page.html" and what else a check has put there
const asked = [];
const server = http.createServer((request, answer) => {
  asked.push(request.url);
  const name = decodeURI(request.url), file = [elementFolder, moduleFolder, source, site].map(folder => folder + name).find(fs.existsSync);
  if (name === "/favicon.ico") return answer.writeHead(204).end();
  if (name in files) return answer.writeHead(200, {"content-type": types[path.extname(name)] ?? "text/html"}).end(files[name]);
  if (!file) return answer.writeHead(404).end();
  answer.writeHead(200, {"content-type": types[path.extname(name)] ?? "text/plain"}).end(fs.readFileSync(file));
});

let browser, address;
const triangle = "/examples/t0-fill/first-triangle.json", cube = "/examples/t0-hidden/cube-inverse-z.json";

/** Opens a page with elements, and waits until each shows what it has to. */
async function open(elements, {javaScriptEnabled = true, expectErrors = false, ...options} = {}) {
  files["/page.html"] = `<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>Page</title>
<script type="module" src="raster-trace.js"></script><body><main><h1>Page</h1>${elements}</main>`;
  asked.length = 0;
  const context = await browser.newContext({viewport: {width: 1280, height: 800}, javaScriptEnabled, ...options}), page = await context.newPage();
  page.on("console", message => { if (!expectErrors) fail(`the console says ${message.type()}: ${message.text()}`); });
  page.on("pageerror", error => fail(`an error: ${error.message}`));
  page.on("dialog", dialog => { fail(`a dialog: ${dialog.message()}`); dialog.dismiss(); });
  await page.goto(address + "/page.html");
  if (javaScriptEnabled) await page.waitForFunction(() => [...document.querySelectorAll("raster-trace")].every(one => one.dataset.ready));
  count("pages");
  return page;
}
const close = page => page.context().close();
const sentencesOf = page => page.$$eval("#sentence", all => all.map(one => one.textContent));

// --- what is checked -------------------------------------------------------------------------------------------------

async function checkTen() {
  const page = await open(Array.from({length: 10}, (_, i) => `<raster-trace src="${i % 2 ? cube : triangle}" step="${i}"></raster-trace>`).join(""));
  expectSame(asked.filter(name => /wasm|mjs/.test(name)).sort(), ["/rastertrace.mjs", "/rastertrace.wasm"], "what is loaded");
  expectSame(await page.$$eval("#slider", all => all.map(one => Number(one.value))), [0, 1, 2, 3, 4, 5, 6, 7, 8, 9], "their steps");
  // Keys are those of the element that has the focus.
  await page.locator("#slider").nth(4).focus();
  await page.keyboard.press("l");
  expectSame(await page.$$eval("#slider", all => all.map(one => Number(one.value))), [0, 1, 2, 3, 5, 5, 6, 7, 8, 9], "a key");
  await page.evaluate(axe);
  const {violations} = await page.evaluate(() => axe.run());
  for (const one of violations) fail(`axe: ${one.id}: ${one.help}: ${one.nodes.map(node => node.html).join(" ").slice(0, 300)}`);
  await close(page);
}

async function checkChanges() {
  const page = await open(`<raster-trace src="${triangle}" step="14" language="pt"></raster-trace>`);
  expectSame((await sentencesOf(page))[0].includes("y=2"), true, "the step");
  expectSame(await page.$eval("#all", one => one.lang), "pt", "the language");
  const told = await page.evaluate(() => {
    const element = document.querySelector("raster-trace"), told = [];
    document.addEventListener("step", event => told.push([event.target.localName, event.detail.step, event.detail.count, event.detail.kind]));
    element.step = 15;
    element.setAttribute("step", "last");
    element.setAttribute("view", "writes");
    return told;
  });
  expectSame(told, [["raster-trace", 15, 62, "pixel"], ["raster-trace", 62, 62, "pixel"]], "events");
  expectSame(await page.inputValue("#view"), "writes", "the view");
  const scene = JSON.parse(fs.readFileSync(path.join(source, triangle), "utf8"));
  scene.vertices.A = [0, 4];
  await page.evaluate(scene => { document.querySelector("raster-trace").scene = scene; }, scene);
  await page.waitForFunction(() => document.querySelector("raster-trace").shadowRoot.getElementById("last").textContent !== "62");
  expectSame(await page.$eval("[data-vertex=A]", one => one.getAttribute("aria-label")), "Vértice A em (0, 4): as setas o movem", "the scene that was set");
  // Taken out and put back, it starts again; a resize after that is nobody's.
  await page.evaluate(() => { const one = document.querySelector("raster-trace"); one.remove(); document.body.append(one); });
  await page.waitForSelector("raster-trace[data-ready]");
  await page.focus("#slider");
  await page.keyboard.press("Home");
  expectSame((await sentencesOf(page))[0], "nada desenhado ainda", "a key once it is put back");
  await page.setViewportSize({width: 700, height: 800});
  expectSame(await page.isVisible("#raster"), true, "put back");
  await close(page);
}

/** All that stands around a picture, and around what a pixel tells, is in the element's language. */
async function checkLanguages() {
  const names = "#title, #view, #in-force, #conventions, #numbers label:nth-child(n + 3), kbd, code, svg, .who"; // of scenes, options and commands
  const wordsIn = async language => {
    const page = await open(`<raster-trace src="${cube}" step="300" language="${language}"></raster-trace>`), raster = await page.locator("#raster").boundingBox();
    await page.mouse.click(raster.x + raster.width / 2, raster.y + raster.height / 2);
    const words = await page.$eval("#all", (all, names) => [...all.querySelectorAll("*")].filter(one => !one.closest(names)).flatMap(one =>
      [one.ariaLabel ?? "", ...[...one.childNodes].filter(node => node.nodeType === Node.TEXT_NODE).map(node => node.data.trim())]), names);
    await close(page);
    return words.filter(text => /[a-z]{2}/.test(text));
  };
  const english = new Set(await wordsIn("en"));
  expectSame((await wordsIn("pt")).filter(text => english.has(text) && !/^pixel\b/i.test(text)), [], "what is English in Portuguese");
  expectSame([...english].length > 40, true, "there are words");
  expectSame(await wordsIn("fr"), await wordsIn("en"), "of a language that there is not");
}

async function checkWrong() {
  files["/broken.json"] = '{"vertices": {"A": [0, 0]},\n "triangles": ["ABC"]}';
  const hostile = "</script><img src=x onerror=alert(1)>&lt;";
  files["/hostile.json"] = JSON.stringify({title: hostile, canvas: {width: 9, height: 9}, vertices: {[hostile]: [-3, -3], B: [3, -2], C: [0, 3]},
                                           triangles: [{vertices: [hostile, "B", "C"], name: hostile}]});
  const page = await open(["broken.json", "nothing.json", "", "hostile.json"].map(name => `<raster-trace ${name && `src="${name}"`}></raster-trace>`).join(""),
                          {expectErrors: true});
  const notes = await page.$$eval("#notes", all => all.map(one => one.textContent));
  expectSame(/^scene:2:\d+: expected .*\n.*\n +\^/.test(notes[0]), true, `where the scene is wrong: ${notes[0]}`);
  expectSame(notes[1], "nothing.json: 404 Not Found", "a scene that is not there");
  expectSame(notes[2], "<raster-trace>: expected src, the address of a scene, or the property scene, found neither", "no scene");
  expectSame(await page.$$eval("#slider", all => all.map(one => one.checkVisibility())), [false, false, false, true], "what is shown");
  expectSame(await page.$$eval("#title", all => all.at(-1).textContent), hostile, "a title that is text");
  expectSame(await page.$$eval("img", all => all.length), 0, "no image of a name");
  await close(page);
}

async function checkPlaces() {
  const elements = `<raster-trace src="${triangle}"><p id="first">The first picture</p></raster-trace>`;
  let page = await open(elements, {javaScriptEnabled: false});
  expectSame(await page.isVisible("#first"), true, "without JavaScript");
  await close(page);
  for (const colorScheme of ["light", "dark"])
    for (const width of [360, 1400]) {
      page = await open(elements, {colorScheme, viewport: {width, height: 800}});
      expectSame(await page.isVisible("#first"), false, "with JavaScript");
      expectSame(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true, `${width} wide: nothing is cut off`);
      expectSame(await page.$eval("raster-trace", one => getComputedStyle(one).backgroundColor !== "rgb(255, 255, 255)"), colorScheme === "dark", colorScheme);
      await close(page);
    }
  page = await open(elements.replace("<raster-trace", "<raster-trace step=14"));
  await page.emulateMedia({media: "print"});
  expectSame(await page.isVisible("#raster"), true, "on paper, the picture");
  expectSame(await page.isVisible("#sentence"), true, "on paper, the step");
  expectSame(await page.isVisible("#buttons") || await page.isVisible("#steps") || await page.isVisible("#view"), false, "on paper, nothing to operate");
  await close(page);
}

/** T0's cube, turned by the mouse: its picture follows, and its steps when it rests. */
async function checkTurning() {
  const scene = JSON.parse(fs.readFileSync(path.join(source, cube), "utf8"));
  files["/cube64.json"] = JSON.stringify({...scene, canvas: {width: 64, height: 64}, method: {...scene.method, snap: "none", scalar: "double"}});
  const page = await open('<raster-trace src="cube64.json" view="faces"></raster-trace>');
  const pictureOf = () => page.$eval("#raster", canvas => Array.from(canvas.getContext("2d").getImageData(0, 0, 64, 64).data).join());
  const stepsOf = async () => Number(await page.textContent("#last")), spaceOf = () => page.innerHTML("#space");
  const [before, steps, space] = [await pictureOf(), await stepsOf(), await spaceOf()];
  expectSame([steps > 3000, await page.$$eval("#working li", all => all.length)], [true, 5], "a working that is asked for");
  const drag = () => page.evaluate(async () => {
    const host = document.querySelector("raster-trace"), sheet = host.shadowRoot.getElementById("sheet"), box = sheet.getBoundingClientRect(), times = [];
    const send = (type, x, y) => sheet.dispatchEvent(new PointerEvent(type, {bubbles: true, pointerId: 1, pointerType: "mouse", button: 0, buttons: type === "pointerup" ? 0 : 1, clientX: box.x + x, clientY: box.y + y}));
    sheet.setPointerCapture = () => {}; // there is no such pointer
    send("pointerdown", 50, 50);
    for (let i = 1; i <= 100; ++i) {
      const shown = new Promise(done => host.addEventListener("frame", done, {once: true})), begin = performance.now();
      send("pointermove", 50 + 2 * i, 60 + i);
      await shown;
      times.push(performance.now() - begin);
    }
    send("pointerup", 250, 160);
    return times.sort((a, b) => a - b);
  });
  const times = await drag();
  console.log(`turning: T0's cube, 64 x 64: median of 100 moves ${times[50].toFixed(0)} ms, 95 of them within ${times[95].toFixed(0)} ms`);
  const inMotion = await pictureOf();
  expectSame(inMotion !== before, true, "another picture");
  await page.waitForFunction(steps => Number(document.querySelector("raster-trace").shadowRoot.getElementById("last").textContent) !== steps, steps, {timeout: 60000});
  expectSame(await pictureOf(), inMotion, "at rest, the picture that was in motion");
  expectSame(await page.$$eval("#numbers output", all => all.map(one => one.value).slice(0, 2)), ["55", "100"], "how far it is turned");
  expectSame(await page.textContent("#sentence") !== "...", true, "its steps");
  expectSame([space, await spaceOf()].map(one => one.includes('class="line ')), [true, true], "the picture in space");
  expectSame(await spaceOf() !== space, true, "that of the cube as it is turned");
  const again = await drag(); // now the scene is another one at every move
  console.log(`turning it again: ${again[50].toFixed(0)} ms`);
  await page.waitForFunction(() => document.querySelector("raster-trace").shadowRoot.getElementById("sentence").textContent !== "...", undefined, {timeout: 60000});
  await page.click("#back");
  await page.waitForFunction(steps => Number(document.querySelector("raster-trace").shadowRoot.getElementById("last").textContent) === steps, steps, {timeout: 60000});
  expectSame(await pictureOf(), before, "back");
  // In motion too, the view of depths shows depths.
  await page.selectOption("#view", "depth");
  const depths = await pictureOf();
  await page.evaluate(() => {
    const host = document.querySelector("raster-trace"), slider = host.shadowRoot.querySelector("#numbers input");
    const shown = new Promise(done => host.addEventListener("frame", done, {once: true}));
    slider.value = 1;
    slider.dispatchEvent(new Event("input"));
    slider.value = 0;
    slider.dispatchEvent(new Event("input"));
    return shown;
  });
  expectSame(await pictureOf(), depths, "depths in motion");
  // By keyboard.
  await page.click("#numbers-section summary");
  await page.focus("#numbers input");
  await page.keyboard.press("ArrowRight");
  await page.waitForSelector("#back:not([hidden])");
  expectSame(await page.$eval("#numbers output", one => one.value), "1", "by keyboard");
  await close(page);
  const other = await open('<raster-trace src="examples/t4-pipeline/six-spaces.json"></raster-trace>');
  const places = ["position", "look_at", "up"].flatMap(name => ["x", "y", "z"].map(axis => `camera ${name} ${axis}`));
  expectSame(await other.$$eval("#numbers label", all => all.map(one => one.firstChild.textContent)),
             ["turn about x", "turn about y", ...places, "projection distance"], "the numbers of the scene");
  await other.$eval("#numbers label:last-child input", slider => { slider.value = 2; slider.dispatchEvent(new Event("change")); });
  await other.waitForSelector("#back:not([hidden])");
  expectSame(await other.textContent("#problem"), "", "the distance that it is changed to");
  await close(other);
}

/** A page in Markdown, made by Debian's mkdocs. */
async function checkSite() {
  fs.mkdirSync(path.join(site, "docs"));
  fs.writeFileSync(path.join(site, "mkdocs.yml"), "site_name: Site\nuse_directory_urls: false\ntheme: {name: null, custom_dir: theme}\n");
  fs.mkdirSync(path.join(site, "theme"));
  fs.writeFileSync(path.join(site, "theme/main.html"), "<!doctype html><html lang=\"en\"><title>Site</title><main>{{ page.content }}</main>");
  fs.copyFileSync(path.join(elementFolder, "raster-trace.js"), path.join(site, "docs/raster-trace.js"));
  for (const name of ["rastertrace.mjs", "rastertrace.wasm"]) fs.copyFileSync(path.join(moduleFolder, name), path.join(site, "docs", name));
  fs.copyFileSync(path.join(source, triangle), path.join(site, "docs/first.json"));
  fs.writeFileSync(path.join(site, "docs/index.md"), "# A row\n\nText.\n\n<raster-trace src=\"first.json\" step=\"14\"></raster-trace>\n\n" +
                   "<script type=\"module\" src=\"raster-trace.js\"></script>\n");
  execFileSync("mkdocs", ["build", "--quiet"], {cwd: site});
  const page = await browser.newPage();
  page.on("pageerror", error => fail(`an error: ${error.message}`));
  await page.goto(address + "/site/index.html");
  await page.waitForSelector("raster-trace[data-ready]");
  expectSame((await sentencesOf(page))[0].startsWith("scanline y=2"), true, "the step");
  await page.close();
}

/** As anywidget calls it, with a model that is a stub. */
async function checkWidget() {
  const page = await open("");
  const told = await page.evaluate(async scene => {
    const {default: widget} = await import("/raster-trace.js");
    const values = {scene, step: null}, listeners = {}, saved = [];
    const model = {get: key => values[key], set: (key, value) => values[key] = value, save_changes: () => saved.push(values.step),
                   on: (what, listen) => listeners[what] = listen};
    widget.render({model, el: document.querySelector("main")});
    const element = document.querySelector("raster-trace");
    const end = performance.now() + 20000;
    const until = async holds => { while (!holds() && performance.now() < end) await new Promise(done => setTimeout(done, 20)); };
    await until(() => values.step === 62);
    values.step = 3;
    listeners["change:step"]();
    const shown = element.shadowRoot.getElementById("slider").value;
    element.shadowRoot.querySelector("[data-action=next]").click();
    return {shown, saved};
  }, fs.readFileSync(path.join(source, triangle), "utf8"));
  expectSame(told, {shown: "3", saved: [62, 4]}, "what the model gets");
  await close(page);
}

async function main() {
  await new Promise(done => server.listen(0, "localhost", done));
  address = `http://localhost:${server.address().port}`;
  browser = await launch();
  const wanted = process.argv[5] ?? "";
  for (const check of [checkTen, checkChanges, checkLanguages, checkWrong, checkPlaces, checkTurning, checkSite, checkWidget].filter(check => check.name.includes(wanted))) {
    doing = check.name;
    try {
      await check();
    } catch (error) {
      fail(error.stack);
    }
  }
  await browser.close();
  server.close();
  fs.rmSync(site, {recursive: true});
  console.log(Object.entries(counted).map(([what, number]) => `${number} ${what}`).join(", "));
  for (const message of failures) console.log(message);
  process.exitCode = failures.length ? 1 : 0;
}

main();
