// SPDX-License-Identifier: MIT
// The site as a browser shows it: no page is wider than its window, there are no barriers, the player in a chapter works,
// and without JavaScript the text is all there.
//
//     check_look.cjs SITE
"use strict";

const {launch, axe} = require("../page/browser.cjs");
const fs = require("fs"), path = require("path");

const site = path.resolve(process.argv[2]);
const chapter = "docs/tutorial/2-filling-a-triangle.html";
const failures = [], counted = {};
const fail = message => failures.push(message);
const count = what => counted[what] = (counted[what] ?? 0) + 1;

/** The pages that the navigation lists; the playground needs a server, see check_playground.cjs. */
const pages = [...new Set(Array.from(fs.readFileSync(path.join(site, "index.html"), "utf8").split("<main")[0].matchAll(/href="([^"#]*\.html)"/g),
                                     found => found[1]))]
    .filter(name => !name.startsWith("playground/"));

let browser;
async function open(name, options) {
  const page = await browser.newPage({viewport: {width: 1400, height: 900}, ...options});
  page.on("console", message => { // The button of a player's help, which a page from a disk has within it as a stranger.
    if (!message.text().startsWith("Blocked autofocusing")) fail(`${page.url()}: the console says ${message.type()}: ${message.text()}`);
  });
  page.on("pageerror", error => fail(`${page.url()}: an error: ${error.message}`));
  page.on("request", request => { if (!request.url().startsWith(`file://${site}/`)) fail(`${page.url()}: it asks for ${request.url()}`); });
  await page.goto(`file://${site}/${name}`);
  return page;
}

/** What is wide scrolls in a box of its own, which is within the window. */
async function checkWidths(page, what) {
  const told = await page.evaluate(() => {
    const wide = [...document.querySelectorAll("main *")].find(element => element.getBoundingClientRect().right > innerWidth + 1
        && !element.closest(".table, pre, figure"));
    return {scroll: document.documentElement.scrollWidth, window: innerWidth, wide: wide?.outerHTML.slice(0, 120)};
  });
  if (told.scroll > told.window) fail(`${what}: ${told.scroll} wide, in a window of ${told.window}`);
  if (told.wide) fail(`${what}: cut off: ${told.wide}`);
  count("pages measured");
}

async function checkBarriers(page, what) {
  await page.evaluate(axe);
  const {violations} = await page.evaluate(() => axe.run({iframes: false, preload: false}));
  for (const one of violations)
    if (["serious", "critical"].includes(one.impact))
      fail(`${what}: ${one.id}: ${one.help}: ${one.nodes.map(node => node.html).join(" ").slice(0, 300)}`);
  count("pages looked at by axe");
}

async function checkLook() {
  for (const viewport of [{width: 360, height: 740}, {width: 1400, height: 900}])
    for (const colorScheme of ["light", "dark"]) {
      const page = await open("index.html", {viewport, colorScheme});
      for (const name of pages) {
        const what = `${name}, ${viewport.width} wide, ${colorScheme}`;
        await page.goto(`file://${site}/${name}`);
        // On a telephone the navigation is opened and closed.
        const isVisible = await page.locator(".beside").isVisible();
        if (isVisible === await page.locator(".menu > summary").isVisible()) fail(`${what}: one navigation, not two or none`);
        await checkWidths(page, what);
        if (!isVisible) {
          await page.click(".menu > summary");
          await page.$$eval("details", all => all.forEach(one => one.open = true));
          await checkWidths(page, `${what}, navigation open`);
        }
        if (["index.html", chapter, "docs/stress.html", "docs/scene-format.html"].includes(name)) await checkBarriers(page, what);
      }
      await page.close();
    }
}

/** One step further with the button of the page within the page. */
async function checkPlayer() {
  const page = await open(chapter);
  const element = page.locator("iframe").first();
  await element.scrollIntoViewIfNeeded();
  const player = await (await element.elementHandle()).contentFrame();
  await player.waitForSelector("raster-trace[data-ready]", {timeout: 30000});
  const slider = player.locator("#slider"), sentence = player.locator("#sentence");
  if (!await slider.isVisible()) fail("the player: no slider");
  await slider.focus();
  await page.keyboard.press("Home"); // before the first step
  const [step, told] = [Number(await slider.inputValue()), await sentence.textContent()];
  await slider.focus();
  await page.keyboard.press("ArrowRight");
  if (Number(await slider.inputValue()) !== step + 1) fail(`the player: after step ${step} comes ${await slider.inputValue()}`);
  if (await sentence.textContent() === told) fail(`the player: the next step says the same: ${told}`);
  count("players");
  await page.close();
}

/** The same text, the same navigation, and a link to the player. */
async function checkWithoutScripts() {
  const texts = [];
  for (const javaScriptEnabled of [true, false]) {
    const context = await browser.newContext({javaScriptEnabled, viewport: {width: 360, height: 740}}), page = await context.newPage();
    await page.goto(`file://${site}/${chapter}`);
    await page.locator(".menu > summary").click();
    if (!await page.locator(".menu nav a").first().isVisible()) fail("without JavaScript: the navigation does not open");
    texts.push(await page.locator("body").innerText());
    if (!await page.locator(".player a").first().isVisible()) fail("without JavaScript: no link to the player");
    await context.close();
  }
  if (texts[0] !== texts[1] || texts[0].length < 5000) fail("without JavaScript: another text");
}

async function main() {
  browser = await launch();
  for (const check of [checkLook, checkPlayer, checkWithoutScripts]) {
    try {
      await check();
    } catch (error) {
      fail(error.stack);
    }
  }
  await browser.close();
  console.log(Object.entries(counted).map(([what, number]) => `${number} ${what}`).join(", "));
  for (const message of failures.slice(0, 40)) console.log(message);
  if (failures.length > 40) console.log(`and ${failures.length - 40} more`);
  process.exitCode = failures.length ? 1 : 0;
}

main();
