// SPDX-License-Identifier: MIT
// Pages as a browser shows them: forward and back, a pixel's story, by keyboard alone, with hostile names, on a phone,
// for who cannot see them, and with a hundred thousand steps.
//
//     check_page.cjs PROGRAM SOURCE_FOLDER
"use strict";

const {launch, axe} = require("./browser.cjs");
const {execFileSync} = require("child_process");
const fs = require("fs"), os = require("os"), path = require("path"), zlib = require("zlib");

const [program, source] = process.argv.slice(2).map(name => path.resolve(name));
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "page-"));
const example = name => path.join(source, "examples", name + ".json");
const failures = [], counted = {};
let doing = "";
const fail = message => failures.push(`${doing}: ${message.slice(0, 2000)}`);
const count = (what, number = 1) => counted[what] = (counted[what] ?? 0) + number;
const expectSame = (found, expected, what) => {
  count("comparisons");
  if (JSON.stringify(found) !== JSON.stringify(expected))
    fail(`${what}: expected ${JSON.stringify(expected)}, found ${JSON.stringify(found)}`);
};
const expectThat = (holds, what) => { count("comparisons"); if (!holds) fail(what); };

/** What the program prints, whatever its exit status. */
function rastertrace(...words) {
  try {
    return execFileSync(program, words, {encoding: "utf8", maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "pipe"], cwd: folder});
  } catch (error) {
    return error.stdout ?? "";
  }
}

let pages = 0;
function pageOf(input, ...words) {
  const file = path.join(folder, `page-${++pages}.html`);
  rastertrace("figure", input, "-o", file, ...words);
  return file;
}

/** Each step's sentence, as `show` tells it. */
function sentencesOf(input) {
  const sentences = ["nothing drawn yet"];
  const trace = rastertrace("trace", input, "--format", "jsonl").trim().split("\n").slice(1, -1).map(line => JSON.parse(line));
  for (const kind of new Set(trace.map(step => step.step)))
    for (const line of rastertrace("show", input, "--every", kind, "--format", "table").split("\n").slice(2)) {
      const told = /^ *(\d+)  (.*)$/.exec(line);
      if (told) sentences[Number(told[1])] = told[2];
    }
  return sentences;
}

let browser;
/** Opens a page, and sees to it that it makes no error and asks for nothing. */
async function open(file, {hash = "", ...options} = {}) {
  const page = await browser.newPage({viewport: {width: 1280, height: 800}, ...options});
  page.on("console", message => fail(`the console says ${message.type()}: ${message.text()}`));
  page.on("pageerror", error => fail(`an error: ${error.message}`));
  page.on("request", request => { if (!request.url().startsWith("file:") || !request.url().includes(path.basename(file))) fail(`it asks for ${request.url()}`); });
  page.on("dialog", dialog => { fail(`a dialog: ${dialog.message()}`); dialog.dismiss(); });
  await page.goto("file://" + file + hash);
  await page.waitForSelector("raster-trace[data-ready]", {timeout: 30000});
  count("pages");
  return page;
}

const stepOf = page => page.$eval("#slider", slider => Number(slider.value));
const sentenceOf = page => page.$eval("#sentence", element => element.textContent);

/** The colors of all pixels, as one text. */
const pictureOf = page => page.$eval("#raster", canvas =>
  Array.from(canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data).join());

/** Which pixels are drawn, as `show --bare` prints it. */
const bareOf = page => page.$eval("#raster", canvas => {
  const {data} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  let text = "";
  for (let i = 0; i < canvas.width * canvas.height; ++i)
    text += (data[4 * i + 3] ? "#" : ".") + ((i + 1) % canvas.width ? "" : "\n");
  return text;
});

async function clickPixel(page, column, row) {
  const box = await page.locator("#raster").boundingBox();
  const [columns, rows] = await page.$eval("#raster", canvas => [canvas.width, canvas.height]);
  await page.mouse.click(box.x + (column + 0.5) / columns * box.width, box.y + (row + 0.5) / rows * box.height);
}

// --- what is checked -------------------------------------------------------------------------------------------------

/** All steps forward and back: the program's sentences and pixels, and the same pictures both ways. */
async function checkSteps(name) {
  const page = await open(pageOf(example(name)), {hash: "#0"});
  const sentences = sentencesOf(example(name));
  expectSame(await page.$eval("#last", last => Number(last.textContent)), sentences.length - 1, "how many steps");
  await page.selectOption("#view", "plotted");
  const pictures = [];
  const every = Math.max(1, Math.floor(sentences.length / 12));
  for (let n = 0; n < sentences.length; ++n) {
    if (n > 0) await page.keyboard.press(n % 2 ? "ArrowRight" : "l");
    expectSame(await sentenceOf(page), sentences[n], `step ${n}`);
    expectSame(await page.$eval("#steps [aria-current] .said", said => said.textContent), sentences[n], `step ${n} in the list`);
    pictures.push(await pictureOf(page));
    if (n % every === 0 && n > 0)
      expectSame(await bareOf(page), rastertrace("show", example(name), "--step", String(n), "--bare", "--view", "plotted").replace(/[@#]/g, "#"), `the pixels of step ${n}`);
    count("steps");
  }
  for (let n = sentences.length - 2; n >= 0; --n) {
    await page.keyboard.press(n % 2 ? "ArrowLeft" : "h");
    expectSame(await sentenceOf(page), sentences[n], `back to step ${n}`);
    if (await pictureOf(page) !== pictures[n]) fail(`back to step ${n}: another picture`);
  }
  // Far jumps, in all views.
  for (const view of await page.$$eval("#view option", options => options.map(option => option.value))) {
    await page.selectOption("#view", view);
    await page.$eval("#slider", slider => slider.focus());
    await page.keyboard.press("End");
    const last = await pictureOf(page);
    await page.keyboard.press("Home");
    const first = await pictureOf(page);
    for (const [key, picture] of [["End", last], ["Home", first], ["End", last]]) {
      await page.keyboard.press(key);
      if (await pictureOf(page) !== picture) fail(`view ${view}, ${key}: another picture`);
    }
  }
  await page.close();
}

/** Pixels as `explain` tells them. */
async function checkPixels(file, every) {
  const page = await open(pageOf(file));
  const [columns, rows] = await page.$eval("#raster", canvas => [canvas.width, canvas.height]);
  for (let i = 0; i < columns * rows; i += every) {
    await clickPixel(page, i % columns, Math.floor(i / columns));
    const told = await page.evaluate(() => {
      const root = document.querySelector("raster-trace").shadowRoot;
      const texts = selector => Array.from(root.querySelectorAll("#pixel-told " + selector), element => element.textContent);
      return {heading: root.getElementById("pixel-heading").textContent, answer: texts(".answer")[0],
              tries: Array.from(root.querySelectorAll("#pixel-told ol li"), item => [Number(item.querySelector("button").textContent), item.querySelector(".said").textContent]),
              names: texts(".who"), reasons: texts(".reason"), sentences: texts(".why-not .sentence")};
    });
    const [, x, y] = /\((-?\d+), (-?\d+)\)/.exec(told.heading);
    const expected = JSON.parse(rastertrace("explain", file, "--pixel", `${x},${y}`, "--json"));
    const near = one => [one.reason === "hidden" ? 0 : 1, one.distance ?? Infinity];
    const whyNot = expected.why_not.length <= 12 ? expected.why_not
                 : expected.why_not.toSorted((a, b) => near(a)[0] - near(b)[0] || near(a)[1] - near(b)[1]).slice(0, 12);
    expectSame(told.answer, expected.answer, told.heading);
    expectSame(told.tries, expected.tries.map(one => [one.number, one.sentence]), told.heading);
    expectSame(told.names, whyNot.map(one => one.primitive), told.heading);
    expectSame(told.reasons, whyNot.map(one => one.reason), told.heading);
    expectSame(told.sentences, whyNot.map(one => one.sentence), told.heading);
    count("pixels");
  }
  await page.close();
}

/** The cube on a canvas that is so large that the page has no answers; with a module it asks for them. */
async function checkAsked() {
  const scene = JSON.parse(fs.readFileSync(example("t0-hidden/cube-inverse-z"), "utf8")), file = path.join(folder, "large-cube.json");
  fs.writeFileSync(file, JSON.stringify({...scene, canvas: {...scene.canvas, width: 64, height: 64}}));
  const html = fs.readFileSync(pageOf(file), "utf8");
  if (!html.includes("var rastertrace =")) return;
  expectSame(dataIn(path.join(folder, `page-${pages}.html`))[0].data.answers, null, "the page has no answers");
  await checkPixels(file, 131);
}

/** By keyboard alone. */
async function checkKeys() {
  const page = await open(pageOf(example("t0-hidden/two-depths")), {hash: "#0"});
  const press = async keys => { for (const key of keys.split(" ")) await page.keyboard.press(key); };
  const kinds = rastertrace("trace", example("t0-hidden/two-depths"), "--format", "jsonl").trim().split("\n").slice(1, -1).map(line => JSON.parse(line));
  const first = kind => kinds.findIndex(step => step.step === kind) + 1;
  const expectStep = async (expected, what) => expectSame(await stepOf(page), expected, what);
  await press("j");
  await expectStep(first("scanline"), "j goes to the first row");
  await press("]");
  await expectStep(kinds.findIndex((step, i) => step.step === "scanline" && i + 1 > first("scanline")) + 1, "] goes to the next of its kind");
  await press("[");
  await expectStep(first("scanline"), "[ goes back");
  await press("g } }");
  await expectStep(kinds.findLastIndex(step => step.step === "primitive") + 1, "} goes to the second primitive");
  await press("{");
  await expectStep(first("primitive"), "{ goes back");
  await press("1 4 G");
  await expectStep(14, "14G");
  await press("2 0 Enter");
  await expectStep(20, "20 Enter");
  await press("G");
  await expectStep(kinds.length, "G");
  await press("Home");
  await expectStep(0, "Home");
  await press("Space");
  for (let i = 0; i < 100 && await stepOf(page) < 2; ++i) await page.waitForTimeout(100);
  expectThat(await stepOf(page) >= 2, "Space plays");
  expectSame(await page.getAttribute("#play", "aria-label"), "Pause", "the button while it plays");
  await press("Space");
  const stopped = await stepOf(page);
  await page.waitForTimeout(600);
  await expectStep(stopped, "Space pauses");
  // The cursor: to the pixel of a step, about, to the steps that touch it, away.
  await press("g 4 1 Enter c");
  expectSame(await page.textContent("#pixel-heading"), `Pixel (${kinds[40].x}, ${kinds[40].y})`, "c");
  await press("Shift+ArrowRight L K J H");
  expectSame(await page.textContent("#pixel-heading"), `Pixel (${kinds[40].x + 1}, ${kinds[40].y})`, "Shift+Right, L, K, J, H");
  await press("g .");
  const touched = kinds.findIndex(step => step.x === kinds[40].x + 1 && step.y === kinds[40].y) + 1;
  await expectStep(touched, ". goes to the first step about the cursor's pixel");
  expectThat((await page.textContent("#announcement")).startsWith(`pixel (${kinds[40].x + 1}, ${kinds[40].y}): `), "the cursor's pixel is announced");
  await press("Escape");
  expectSame(await page.textContent("#pixel-heading"), "Pixel", "Escape");
  // Views, working, larger cells, help.
  const view = await page.inputValue("#view");
  await press("v");
  expectThat(await page.inputValue("#view") !== view, "v is another view");
  await press("V");
  expectSame(await page.inputValue("#view"), view, "V");
  await press("4 1 Enter");
  const lines = await page.$$eval("#working li", items => items.length);
  expectThat(lines > 0, "a step has its working");
  await press("w");
  expectSame(await page.$$eval("#working li", items => items.length), 0, "w");
  const size = (await page.locator("#raster").boundingBox()).width;
  await press("w z z");
  expectThat((await page.locator("#raster").boundingBox()).width > size, "z makes cells larger");
  await press("Z Z");
  await press("?");
  expectThat(await page.$eval("#help", dialog => dialog.open), "? opens help");
  const table = rastertrace("figure", "--help");
  expectThat(table.includes(".html"), "help of the program has the page");
  await press("Escape");
  expectThat(!await page.$eval("#help", dialog => dialog.open), "Escape closes help");
  // Every button, select and link is reached by Tab, and shows that it has the focus.
  const seen = new Set();
  for (let i = 0; i < 40; ++i) {
    await page.keyboard.press("Tab");
    const at = await page.evaluate(() => {
      const one = document.activeElement.shadowRoot?.activeElement ?? document.activeElement, style = getComputedStyle(one);
      return one === document.body ? null : {name: one.id || one.dataset.action || one.tagName + (one.dataset.step ? "-step" : ""), outline: style.outlineStyle !== "none" && parseFloat(style.outlineWidth) > 0};
    });
    if (!at) continue;
    seen.add(at.name);
    expectThat(at.outline, `${at.name} shows that it has the focus`);
  }
  for (const name of ["view", "help-button", "scroller", "slider", "first", "previous-row", "previous", "play", "next", "next-row", "last", "number", "BUTTON-step", "SUMMARY"])
    expectThat(seen.has(name), `${name} is reached by Tab`);
  // Keys of letters can be turned off, as they are in the way of some who speak to their computer.
  await press("?");
  await page.setChecked("#letters", false);
  await press("Escape g");
  expectThat(await stepOf(page) !== 0, "letters are off");
  await press("ArrowLeft");
  await page.close();
}

/** Every key of the table does something: the page takes it, and leaves it to nobody else. */
async function checkKeyTable() {
  const page = await open(pageOf(example("t0-hidden/two-depths")), {hash: "#0"});
  const keys = await page.$eval("#keys tbody", body => Array.from(body.rows, row => [0, 0, ...Array.from(row.querySelectorAll("kbd"), key => key.textContent.replace(/[\u2190-\u2193]/, sign => ["Left", "Up", "Right", "Down"][sign.charCodeAt() - 0x2190]))]).flatMap(([, , ...keys]) => keys));
  expectThat(keys.length > 30, "the page has a table of keys");
  for (const name of keys) {
    const isTaken = await page.evaluate(name => {
      const key = name.replace(/^Shift\+/, "").replace(/^(Left|Right|Up|Down)$/, "Arrow$1").replace("Space", " ");
      const isTaken = !document.body.dispatchEvent(new KeyboardEvent("keydown", {key, shiftKey: name.startsWith("Shift+"), bubbles: true, cancelable: true}));
      document.querySelector("raster-trace").shadowRoot.getElementById("help").close();
      return isTaken;
    }, name);
    expectThat(isTaken, `${name} does something`);
  }
  await page.close();
}

/** Names and titles that would do something if they were obeyed. */
async function checkHostile() {
  const hostile = "</script><img src=x onerror=\"alert(1)\"><script>alert(2)</script>{{data}}\u001b]0;x\u0007\u202e";
  const scene = path.join(folder, "hostile <b>&'.json");
  fs.writeFileSync(scene, JSON.stringify({title: hostile, canvas: {width: 9, height: 9}, vertices: {[hostile]: [-3, -3], B: [3, -2], C: [0, 3]},
                                          triangles: [{vertices: [hostile, "B", "C"], name: hostile}]}));
  const page = await open(pageOf(scene));
  const shown = hostile.replace("\u001b", "<U+001B>").replace("\u0007", "<U+0007>").replace("\u202e", "<U+202E>");
  expectSame(await page.textContent("#title"), shown, "the title");
  expectSame(await page.title(), shown, "the title of the tab");
  await page.keyboard.press("g");
  await page.keyboard.press("l");
  expectThat((await sentenceOf(page)).startsWith(`triangle ${shown}   ${shown} (-3, -3)`), "the sentence");
  await clickPixel(page, 0, 0);
  expectSame(await page.textContent("#pixel .who"), shown, "the name in a reason");
  expectThat((await page.textContent("#pixel code")).includes("rastertrace explain 'hostile <b>&'\\''.json' --pixel"), "the command");
  expectSame(await page.$$eval("img", images => images.length), 0, "no image");
  await page.close();
}

/** Traces that are cut short, or of a later program. */
async function checkDamaged() {
  const lines = rastertrace("trace", example("t0-fill/first-triangle"), "--format", "jsonl").split("\n");
  const cut = path.join(folder, "cut.jsonl");
  fs.writeFileSync(cut, lines.slice(0, 20).join("\n") + "\n" + lines[20].slice(0, 15));
  let page = await open(pageOf(cut));
  expectThat((await page.textContent("#notes")).includes("the trace is truncated after 19 whole steps"), "it says that the trace is truncated");
  expectSame(await page.textContent("#last"), "19", "the whole steps are there");
  await clickPixel(page, 0, 13);
  expectThat((await page.textContent("#pixel")).includes("no step of the trace draws it, but not all steps are there"), "nothing is guessed");
  await page.close();
  const later = path.join(folder, "later.jsonl");
  fs.writeFileSync(later, [lines[0], lines[1].replace("{", "{\"mood\":\"calm\","), "{\"step\":\"blur\",\"x\":0,\"y\":0}", ...lines.slice(2, -2),
                           lines.at(-2).replace("62", "63")].join("\n") + "\n");
  page = await open(pageOf(later), {hash: "#2"});
  expectSame(await sentenceOf(page), "{\"step\":\"blur\",\"x\":0,\"y\":0}", "a step that we do not know");
  await page.close();
}

/** For who cannot see it, in light and dark, on a desk and on a phone. */
async function checkAccess(name) {
  const file = pageOf(example(name));
  for (const colorScheme of ["light", "dark"])
    for (const viewport of [{width: 1280, height: 800}, {width: 390, height: 844}]) {
      const page = await open(file, {colorScheme, viewport, hash: "#3", hasTouch: viewport.width < 500});
      // A pixel in the middle: its steps come later.
      await clickPixel(page, ...await page.$eval("#raster", canvas => [canvas.width >> 1, canvas.height >> 1]));
      expectThat(await page.$(".later") !== null, "a step that comes later");
      await page.$$eval("details", all => all.forEach(one => one.open = true));
      for (const isHelp of [false, true]) {
        if (isHelp) await page.click("#help-button");
        await page.evaluate(axe);
        const {violations, incomplete} = await page.evaluate(() => axe.run());
        for (const one of violations) fail(`axe, ${colorScheme}, ${viewport.width}: ${one.id}: ${one.help}: ${one.nodes.map(node => node.html).join(" ").slice(0, 300)}`);
        expectThat(!incomplete.some(one => one.id === "color-contrast" && one.nodes.some(node => !/overlay|canvas|svg/.test(node.html) && node.any.some(check => check.data?.contrastRatio))), "contrasts are known");
        count("pages looked at by axe");
      }
      expectThat(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${viewport.width} wide: nothing is cut off`);
      await page.close();
    }
  const page = await open(file, {viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true});
  const box = await page.locator("#raster").boundingBox();
  await page.touchscreen.tap(box.x + box.width / 2, box.y + box.height / 2);
  expectThat(/^Pixel \(/.test(await page.textContent("#pixel-heading")), "a tap asks about a pixel");
  for (const button of await page.$$("#buttons button")) {
    const {width, height} = await button.boundingBox();
    expectThat(width >= 40 && height >= 40, "buttons are large enough for a finger");
  }
  await page.close();
}

/** Each pixel of a face has the color that stands beside its name. */
async function checkFaces() {
  const page = await open(pageOf(example("t0-hidden/two-cubes"), "--view", "faces"));
  await page.keyboard.press("End");
  const found = await page.evaluate(() => {
    const host = document.querySelector("raster-trace"), root = host.shadowRoot;
    const {width, height} = root.getElementById("raster"), context = root.getElementById("raster").getContext("2d");
    const {data} = context.getImageData(0, 0, width, height), pixels = new Set();
    for (let i = 0; i < data.length; i += 4)
      if (data[i + 3] > 0) pixels.add("#" + Array.from(data.slice(i, i + 3)).map(byte => byte.toString(16).padStart(2, "0")).join(""));
    const style = getComputedStyle(host);
    const legend = [...root.querySelectorAll("#legend li")].map(item => style.getPropertyValue(/--face-\d/.exec(item.innerHTML)[0]).trim());
    return {pixels: [...pixels], legend};
  });
  expectSame(found.pixels.sort(), [...new Set(found.legend)].sort(), "colors of pixels, and of the legend");
  await page.close();
}

/** The picture in space follows the steps; a scene typed in pixels has none. */
async function checkSpace() {
  const page = await open(pageOf(example("t4-pipeline/six-spaces")));
  const texts = () => page.$$eval("#space > g text", all => all.map(text => text.textContent));
  const goTo = async n => { await page.fill("#number", String(n)); await page.keyboard.press("Enter"); };
  expectSame(await page.isVisible("#space"), true, "the picture in space is there");
  await goTo(6); // vertex A in world space
  expectSame((await texts()).includes("(0, 2, 1)"), true, "the numbers of the step, found " + await texts());
  const height = await page.$eval("#space text", text => text.getBoundingClientRect().height);
  expectSame(height >= 8, true, "letters that can be read, found " + height);
  await goTo(0);
  expectSame((await texts()).length, 0, "nothing of a step before the first");
  await page.close();
  const flat = await open(pageOf(example("t0-fill/first-triangle")));
  expectSame(await flat.isVisible("#space"), false, "no picture in space of a scene typed in pixels");
  await flat.close();
}

/** The frames of a scene whose numbers vary. */
async function checkFrames() {
  const page = await open(pageOf(example("t0-fill/first-triangle"), "--vary", "/vertices/A/0=2:3:4"));
  expectSame(await page.$$eval("#frame option", options => options.map(option => option.textContent)),
             ["1 of 4: A/0 2", "2 of 4: A/0 7/3", "3 of 4: A/0 8/3", "4 of 4: A/0 3"], "the frames");
  await page.keyboard.press("f");
  await page.keyboard.press("1");
  await page.keyboard.press("Enter");
  expectSame(await sentenceOf(page), "triangle ABC   A (7/3, 5)   B (-4, -3)   C (5, -3)", "the second frame");
  await page.selectOption("#frame", "3");
  expectSame(await sentenceOf(page), "triangle ABC   A (3, 5)   B (-4, -3)   C (5, -3)", "the fourth frame");
  await page.close();
}

/** Sentences in another language are said to be in it, for who has them read aloud. */
async function checkLanguage() {
  const page = await open(pageOf(example("t0-fill/first-triangle"), "--language", "pt"), {hash: "#3"});
  expectSame(await sentenceOf(page), "aresta BC: horizontal, não tem dx/dy", "in Portuguese");
  expectSame(await page.$eval("#all", one => one.lang), "pt", "the language");
  expectSame(await page.textContent("#keys tbody td + td"), "o próximo passo", "what a key does");
  await page.close();
}

/** What the program puts into a page, as the page reads it. */
const dataIn = file => JSON.parse(zlib.inflateSync(Buffer.from(/<script type="text\/plain">([^<]*)</.exec(fs.readFileSync(file, "utf8"))[1], "base64")));

/** The same with words in place of their numbers, and without the answers, which a page of a module asks for. */
function inWords({words, answers, ...data}) {
  const said = list => list.map(one => Array.isArray(one) ? said(one) : words[one]);
  return {...data, conventions: said(data.conventions), groups: said(data.groups), fills: said(data.fills), working: said(data.working),
          pixels: said(data.pixels), primitives: data.primitives.map((one, i) => [1, 2, 3, 6].includes(i % 7) ? said([one].flat()) : one),
          rows: data.rows.map((one, i) => i % 7 > 4 ? words[one] : one)};
}

/** Vertices that are moved. A program that was built without its module is asked in the place of it. */
async function checkMoving() {
  const name = example("t0-fill/first-triangle"), file = pageOf(name), moved = path.join(folder, "moved.json");
  const scene = JSON.parse(fs.readFileSync(name, "utf8"));
  let html = fs.readFileSync(file, "utf8");
  const hasModule = html.includes("var rastertrace =");
  if (!hasModule) {
    html = html.replace("<script type=\"module\">", "<script>globalThis.rastertrace = async () => ({tell_steps_in() {}, page_data: askProgram, page_data_in_motion: askProgram, explain_pixel: () => 'null'});</script>\n$&");
    fs.writeFileSync(file, html);
  }
  const context = await browser.newContext({viewport: {width: 1280, height: 800}});
  await context.exposeFunction("askProgram", text => {
    fs.writeFileSync(moved, text);
    const told = pageOf(moved);
    if (!fs.existsSync(told)) throw new Error("expected a scene, found none");
    return JSON.stringify(dataIn(told)[0].data);
  });
  const page = await context.newPage();
  page.on("pageerror", error => fail(`an error: ${error.message}`));
  await page.goto("file://" + file + "#14");
  await page.waitForSelector("raster-trace[data-ready]");
  const labelOf = vertex => page.getAttribute(`[data-vertex=${vertex}]`, "aria-label");
  const settle = async label => {
    for (let i = 0; i < 100 && !((await labelOf("A")).includes(label) && await page.$eval("#back", back => !back.hidden) === (label !== "(2, 5)")); ++i)
      await page.waitForTimeout(50);
    await page.waitForTimeout(500);
  };
  expectSame(await page.$$eval(".handle", all => all.map(one => one.dataset.vertex)), ["A", "B", "C"], "the vertices");
  const expectScene = async (vertices, what) => {
    fs.writeFileSync(moved, JSON.stringify({...scene, vertices}));
    const sentences = sentencesOf(moved), step = await stepOf(page);
    expectSame(await page.textContent("#last"), String(sentences.length - 1), `${what}: how many steps`);
    expectSame(await sentenceOf(page), sentences[step], what);
    expectThat(sentences[step].startsWith("scanline y=2"), `${what}: it stays in its row`);
    await page.keyboard.press("G");
    expectSame(await bareOf(page), rastertrace("show", moved, "--step", "last", "--bare").replace(/[@#]/g, "#"), `${what}: the pixels`);
    await page.keyboard.type(`${step}G`);
  };
  // By mouse: two pixels to the left, one down.
  const box = await page.locator("#raster").boundingBox(), cell = box.width / 17;
  const handle = await page.locator("[data-vertex=A]").boundingBox();
  const [x, y] = [handle.x + handle.width / 2, handle.y + handle.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= 8; ++i) await page.mouse.move(x - 2 * cell * i / 8, y + cell * i / 8);
  await page.mouse.up();
  await settle("(0, 4)");
  await expectScene({...scene.vertices, A: [0, 4]}, "dragged");
  expectThat(!(await page.textContent("#told")).includes("rastertrace explain"), "no command about a file that is another scene");
  // By keyboard: a quarter to the right, a whole pixel up.
  await page.focus("[data-vertex=A]");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Shift+ArrowUp");
  await settle("(0.25, 5)");
  expectSame(await labelOf("A"), "Vertex A at (0.25, 5): arrow keys move it", "by keyboard");
  await expectScene({...scene.vertices, A: [0.25, 5]}, "by keyboard");
  await page.click("#back");
  await settle("(2, 5)");
  await expectScene(scene.vertices, "back");
  if (hasModule) {
    // What the module says of a scene is what the program says.
    let seed = 7;
    const random = () => { seed = (seed * 48271) % 2147483647; return (seed % 33) / 4 - 4; };
    for (let i = 0; i < 12; ++i) {
      const text = JSON.stringify({...scene, vertices: Object.fromEntries(["A", "B", "C"].map(vertex => [vertex, [random(), random()]])),
                                   method: {...scene.method, fill: ["scanline", "top-left", "barycentric", "two-halves"][i % 4]}});
      fs.writeFileSync(moved, text);
      const told = await page.evaluate(async text => JSON.parse((await rastertrace()).page_data(text)), text);
      expectSame(inWords(told), inWords(dataIn(pageOf(moved))[0].data), text);
    }
    const portuguese = await page.evaluate(async text => {
      const program = await rastertrace();
      program.tell_steps_in("pt");
      return JSON.parse(program.page_data(text));
    }, JSON.stringify(scene));
    expectSame(inWords(portuguese), inWords(dataIn(pageOf(name, "--language", "pt"))[0].data), "in Portuguese");
    // Ten triangles on the largest canvas.
    const vertices = {}, triangles = [];
    for (let i = 0; i < 10; ++i) {
      [[0, 0], [40, 10], [10, 40]].forEach(([dx, dy], k) => vertices["abc"[k] + i] = [8 * i + dx, 7 * i + dy]);
      triangles.push(["a", "b", "c"].map(corner => corner + i));
    }
    const large = JSON.stringify({canvas: {width: 128, height: 128, origin: "top-left"}, vertices, triangles});
    const times = await page.evaluate(async ([small, large]) => {
      const program = await rastertrace(), time = (draw, text) => { const begin = performance.now(); draw(text); return performance.now() - begin; };
      time(program.page_data_in_motion, small);
      return {small: time(program.page_data_in_motion, small), large: time(program.page_data_in_motion, large), whole: time(program.page_data, large)};
    }, [JSON.stringify(scene), large]);
    console.log(`moving: first-triangle ${times.small.toFixed(0)} ms; ten triangles, 128 x 128: ${times.large.toFixed(0)} ms, at rest ${times.whole.toFixed(0)} ms`);
    const ten = path.join(folder, "ten.json");
    fs.writeFileSync(ten, large);
    expectThat(fs.readFileSync(pageOf(ten), "utf8").includes("\"movable\":true"), "ten triangles can be moved");
    expectThat(!fs.readFileSync(pageOf(example("t0-hidden/cube-inverse-z")), "utf8").includes("\"movable\":true"), "a cube in space cannot be moved");
  }
  count("pages");
  await context.close();
}

/** Without the module, who tries to move a vertex is told why it stays. */
async function checkFixed() {
  const html = fs.readFileSync(pageOf(example("t0-fill/first-triangle")), "utf8"), script = html.lastIndexOf("<script type=\"module\">");
  const page = await browser.newPage({viewport: {width: 1280, height: 800}}), file = path.join(folder, "fixed.html");
  fs.writeFileSync(file, html.slice(0, html.indexOf("</raster-trace>") + 16) + html.slice(script));
  const told = () => page.$eval("#problem", problem => problem.hidden ? "" : problem.textContent);
  const expectTold = async what => {
    expectSame(await told(), "Vertices stay where they are: the rastertrace that wrote this page found no module that draws. It was built without one " +
               "(cmake -D RASTERTRACE_WASM=ON builds it), RASTERTRACE_MODULE did not name its file, and there was no " +
               "share/rastertrace/rastertrace.js beside the program, where a package has it.", what);
    expectSame(await page.getAttribute("[data-vertex=A]", "aria-label"), "Vertex A at (2, 5)", `${what}: the vertex`);
  };
  page.on("pageerror", error => fail(`an error: ${error.message}`));
  for (const way of ["by mouse", "by keyboard"]) {
    await page.goto("file://" + file);
    await page.waitForSelector("raster-trace[data-ready]");
    expectSame(await told(), "", "before");
    const handle = await page.locator("[data-vertex=A]").boundingBox();
    const [x, y] = [handle.x + handle.width / 2, handle.y + handle.height / 2];
    if (way === "by mouse") {
      await page.mouse.click(x, y);
      expectSame(await told(), "", "a click");
      expectThat((await page.textContent("#pixel-told")).includes("(2, 5)"), "a click on a vertex that is fixed is one on its pixel");
      await page.mouse.down();
      await page.mouse.move(x + 20, y);
      await page.mouse.up();
    } else {
      await page.focus("[data-vertex=A]");
      await page.keyboard.press("ArrowRight");
    }
    await expectTold(way);
  }
  count("pages");
  await page.close();
}

/** A hundred thousand steps on 512 x 512 pixels: how large, how fast. */
async function checkLarge() {
  const vertices = {}, triangles = [];
  let seed = 1;
  const random = (low, high) => { seed = (seed * 48271) % 2147483647; return low + seed % (high - low); };
  for (let i = 0; i < 16; ++i) {
    const x = random(0, 330), y = random(0, 330);
    [[0, 0], [random(70, 110), random(0, 40)], [random(0, 40), random(70, 110)]].forEach(([dx, dy], k) =>
      vertices[`T${i}${"abc"[k]}`] = [x + dx, y + dy, random(1, 40)]);
    triangles.push(["a", "b", "c"].map(corner => `T${i}${corner}`));
  }
  const scene = path.join(folder, "large.json");
  fs.writeFileSync(scene, JSON.stringify({canvas: {width: 512, height: 512, origin: "top-left"}, vertices, triangles,
                                          method: {depth: "linear-z", scalar: "exact"}}));
  const file = pageOf(scene), size = fs.statSync(file).size;
  expectThat(size < 5e6, `it has ${size} bytes, 5,000,000 at most`);
  const page = await open(file);
  const steps = Number(await page.textContent("#last"));
  expectThat(steps >= 100000, `it has ${steps} steps`);
  const {median, slowest, jump} = await page.evaluate(async () => {
    const slider = document.querySelector("raster-trace").shadowRoot.getElementById("slider"), last = Number(slider.max), times = [];
    const time = to => {
      const begin = performance.now();
      slider.value = to;
      slider.dispatchEvent(new Event("input"));
      document.body.offsetHeight; // with the layout that it needs
      return performance.now() - begin;
    };
    for (const from of [1000, last >> 1, last - 300])
      for (let i = 0; i < 100; ++i) times.push(time(from + i));
    for (let i = 0; i < 300; ++i) times.push(time(last - i));
    times.sort((a, b) => a - b);
    return {median: times[times.length >> 1], slowest: times[Math.floor(times.length * 0.95)], jump: time(0)};
  });
  expectThat(median < 16, `a step takes ${median} ms, 16 at most`);
  expectThat(jump < 1000, `a jump over all steps takes ${jump} ms`);
  console.log(`large: ${steps} steps, ${size} bytes, a step ${median.toFixed(1)} ms (19 of 20: ${slowest.toFixed(1)}), all of them ${jump.toFixed(0)} ms`);
  await clickPixel(page, 300, 300);
  // (A pixel is hardly larger than one of the screen.)
  expectThat(/^rastertrace explain large.json --pixel (299|300),(299|300)$/.test(await page.textContent("#pixel code")), "a large canvas tells the command");
  await page.close();
}

async function main() {
  browser = await launch();
  const checks = [
    ...["t0-fill/first-triangle", "t0-hidden/two-depths", "t2-lines/bresenham", "t3-sweep-and-box/barycentric", "t3-sweep-and-box/top-left", "t4-fan/fan", "t0-hidden/cube-culled"].map(name => [name, () => checkSteps(name)]),
    ...[["t0-fill/first-triangle", 1], ["t2-lines/bresenham", 1], ["t2-lines/octants", 7], ["t3-sweep-and-box/barycentric", 5], ["t3-sweep-and-box/top-left", 2], ["t0-hidden/two-depths", 2], ["t0-hidden/cube-inverse-z", 3]].map(([name, every]) => [`pixels of ${name}`, () => checkPixels(example(name), every)]),
    ["pixels that are asked about", checkAsked],
    ["keys", checkKeys], ["key table", checkKeyTable], ["hostile", checkHostile], ["damaged", checkDamaged], ["faces", checkFaces], ["space", checkSpace], ["frames", checkFrames], ["language", checkLanguage], ["moving", checkMoving], ["fixed", checkFixed], ["large", checkLarge],
    ["access", () => checkAccess("t0-fill/first-triangle")], ["access of a cube", () => checkAccess("t0-hidden/cube-inverse-z")],
  ];
  const wanted = process.argv[4] ?? ""; // a part of a name
  for (const [name, check] of checks.filter(([name]) => name.includes(wanted))) {
    doing = name;
    try {
      await check();
    } catch (error) {
      fail(error.stack);
    }
  }
  await browser.close();
  fs.rmSync(folder, {recursive: true});
  console.log(Object.entries(counted).map(([what, number]) => `${number} ${what}`).join(", "));
  for (const message of failures.slice(0, 40)) console.log(message);
  if (failures.length > 40) console.log(`and ${failures.length - 40} more`);
  process.exitCode = failures.length ? 1 : 0;
}

main();
