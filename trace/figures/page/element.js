// <raster-trace>: the player as an element of any page. RESOURCES (page.cpp) has its content, its style sheet and the
// keys.
//
//     <raster-trace src="scene.json" step="14" view="depth"><img src="first.svg" alt="..."></raster-trace>
//
// src       a scene, which is drawn here by the program compiled to WebAssembly (rastertrace.mjs, beside this file)
// step      the step that is shown; the last one if it is not given
// view      what the color of a pixel means
// language  of the sentences: en, pt
// theme     light or dark; what the reader has set if it is not given
//
// The property `scene` takes a scene as a text or an object. Of each step that is shown an event "step" tells
// {step, count, kind, sentence}. What the element holds is shown where there is no JavaScript.
// A page that the program has written has its data within the element, and the attribute whole-page.

let sharedProgram; // many elements have one; a promise

/** The program: what it would have written into a page, and why a pixel is as it is. An Error tells why it cannot. */
function programOf(begin) {
  sharedProgram ??= begin().then(module => ({
    module,
    async draw(scene, language, detail) {
      module.tell_steps_in(language);
      return JSON.parse(await (detail === "all" ? module.page_data(scene) : module.page_data_in_motion(scene)));
    },
    frame: scene => JSON.parse(module.frame(scene)),
    step(scene, language, n) {
      module.tell_steps_in(language);
      return JSON.parse(module.step(scene, n));
    },
    explain(scene, language, x, y) {
      module.tell_steps_in(language);
      return JSON.parse(module.explain_pixel(scene, x, y));
    },
  }));
  sharedProgram.catch(() => { sharedProgram = undefined; }); // another element tries again
  return sharedProgram;
}

const load = () => import(new URL("rastertrace.mjs", import.meta.url)).then(module => module.default());

/** What a page was made with: deflated, in base64. */
async function inflated(text) {
  const bytes = Uint8Array.from(atob(text.trim()), c => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return JSON.parse(await new Response(stream).text());
}

let sharedSheet;
function styleSheet() {
  if (!sharedSheet) {
    sharedSheet = new CSSStyleSheet();
    sharedSheet.replaceSync(RESOURCES.css);
  }
  return sharedSheet;
}

/** True of a scene in the plane whose vertices can be moved: of few primitives, and with a canvas that stays. */
function canBeMoved(scene) {
  const lists = ["points", "lines", "triangles", "outlines"], others = ["$schema", "title", "canvas", "background", "vertices", "colors", "method", "convention"];
  const primitives = lists.reduce((sum, list) => sum + (scene[list]?.length ?? 0), 0);
  return Object.keys(scene).every(key => lists.includes(key) || others.includes(key)) && primitives <= 10 && scene.canvas?.width &&
    Object.values(scene.vertices ?? {}).every(vertex => vertex.length === 2);
}

class RasterTrace extends HTMLElement {
  static observedAttributes = ["src", "step", "view", "language", "theme"];

  /** The program that the elements share: a promise of its functions (viewer-cli/page/src/module.js). */
  static async module() { return (await programOf(load)).module; }

  #player;
  #isDark = matchMedia("(prefers-color-scheme: dark)");
  #setTheme = () => {
    const theme = this.getAttribute("theme");
    this.toggleAttribute("data-dark", theme === "dark" || (theme === null || theme === "auto") && this.#isDark.matches);
    this.#player?.repaint();
  };
  #given;      // the scene that was set
  #loading = 0; // of several loads, the last one counts

  connectedCallback() {
    this.#setTheme();
    this.#isDark.addEventListener("change", this.#setTheme);
    if (!this.shadowRoot) {
      this.attachShadow({mode: "open"}).adoptedStyleSheets = [styleSheet()];
      this.shadowRoot.innerHTML = "<slot></slot>"; // what the element holds, until the scene is drawn
    }
    if (Object.hasOwn(this, "scene")) { // set before this script ran
      const {scene} = this;
      delete this.scene;
      this.scene = scene;
    } else {
      this.#load();
    }
  }

  disconnectedCallback() {
    this.#isDark.removeEventListener("change", this.#setTheme);
    ++this.#loading;
    this.#player?.end();
    this.#player = undefined;
  }

  attributeChangedCallback(name, before, now) {
    if (!this.shadowRoot) return;
    if (name === "step") return this.#player?.goTo(this.step);
    if (before === now) return;
    if (name === "theme") return this.#setTheme();
    if (name === "src") this.#given = undefined;
    if (name === "view") this.#player?.setView(now);
    else this.#load();
  }

  get step() {
    const step = this.getAttribute("step");
    return step === null || step === "last" ? Infinity : Math.floor(Number(step)) || 0;
  }
  set step(n) { this.setAttribute("step", n); }

  get scene() { return this.#given; }
  set scene(scene) {
    this.#given = typeof scene === "string" ? scene : JSON.stringify(scene);
    if (this.isConnected) this.#load();
  }

  async #load() {
    const load = ++this.#loading;
    delete this.dataset.ready;
    let begin;
    try {
      begin = await this.#read();
    } catch (problem) {
      begin = {problem: problem.message};
    }
    if (load !== this.#loading) return;
    this.#player?.end();
    this.#player = undefined;
    const {options, frames, program, problem} = begin, by = id => this.shadowRoot.getElementById(id);
    this.shadowRoot.innerHTML = RESOURCES.html; // with nothing of the player before
    by("all").setAttribute("role", this.hasAttribute("whole-page") ? "main" : "group");
    by("all").classList.toggle("failed", !frames);
    if (frames) this.#player = startPlayer(this, {...RESOURCES, ...options}, frames, program);
    else Object.assign(by("notes"), {textContent: problem, hidden: false});
    this.dataset.ready = "true";
  }

  /** Options, frames and program of the player. */
  async #read() {
    const within = type => this.querySelector(`:scope > script[type="${type}"]`)?.textContent;
    const data = within("text/plain");
    if (data) {
      const options = JSON.parse(within("application/json"));
      // A page whose browser cannot run the program has its data all the same.
      const program = typeof rastertrace === "function" ? await programOf(rastertrace).catch(() => undefined) : undefined;
      return {options, program, frames: await inflated(data)};
    }
    const source = this.getAttribute("src"), asked = this.getAttribute("language"), language = asked in RESOURCES.words ? asked : "en";
    if (!source && !this.#given) return {problem: "<raster-trace>: expected src, the address of a scene, or the property scene, found neither"};
    const [text, program] = await Promise.all([
      this.#given ?? fetch(source).then(answer => answer.ok ? answer.text() : Promise.reject(Error(`${source}: ${answer.status} ${answer.statusText}`))),
      programOf(load)]);
    const frame = await program.draw(text, language, "all"), scene = JSON.parse(text);
    const options = {language, title: frame.title, scene: text, movable: canBeMoved(scene), view: this.getAttribute("view") ?? undefined, step: this.step};
    return {options, program, frames: [{label: "", file: "", data: frame}]};
  }
}
if (!customElements.get("raster-trace")) customElements.define("raster-trace", RasterTrace);

/** For notebooks: a widget of anywidget, whose model has a scene, and gets the step. */
function render({model, el}) {
  const element = document.createElement("raster-trace");
  element.scene = model.get("scene");
  if (Number.isInteger(model.get("step"))) element.step = model.get("step");
  model.on("change:scene", () => element.scene = model.get("scene"));
  model.on("change:step", () => element.step = model.get("step"));
  element.addEventListener("step", ({detail}) => {
    if (detail.step === model.get("step")) return;
    model.set("step", detail.step);
    model.save_changes();
  });
  el.append(element);
}
export {RasterTrace};
export default {render};
