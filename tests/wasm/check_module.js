// SPDX-License-Identifier: MIT
// The module for pages must say of a scene what the program says: the same trace, byte for byte, or the same message.
//
//     node check_module.js rastertrace.js PROGRAM RANDOM_SCENES EXAMPLES [COUNT]

'use strict';
const {execFileSync, spawnSync} = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');
const zlib = require('zlib');

// About half of the random scenes lie in the plane: 2,300 make more than a thousand.
const [module_file, program, random_scenes, examples, count = '2300'] = process.argv.slice(2);

/// The scenes of a folder and those below it, as [name, text], in the order of their names.
function scenes_in(folder) {
  return fs.readdirSync(folder, {withFileTypes: true})
      .sort((a, b) => (a.name < b.name ? -1 : 1))
      .flatMap((entry) => {
        const file = path.join(folder, entry.name);
        if (entry.isDirectory()) return scenes_in(file);
        return entry.name.endsWith('.json') ? [[file, fs.readFileSync(file, 'utf8')]] : [];
      });
}

/// True for the scenes whose vertices a page lets its reader drag: in the plane, with at most ten triangles.
function can_be_dragged([, text]) {
  const scene = JSON.parse(text);
  const has = (key) => scene[key] !== undefined;
  return has('vertices') && !has('projection') && !has('camera') && !has('model') && !has('vary') &&
      (scene.triangles ?? []).length <= 10 && !(scene.meshes ?? []).some((mesh) => mesh.obj !== undefined);
}

/// Scenes as a page makes them: vertices on whole pixels or on quarters of one, on a canvas of up to 128 x 128, for
/// every fill and kind of number.
function dragged_scenes() {
  const scenes = [];
  let state = 20261123;
  const random = (below) => {
    state = (state * 48271) % 2147483647;
    return state % below;
  };
  for (const fill of ['scanline', 'two-halves', 'barycentric', 'top-left', 'fan'])
    for (const scalar of ['float', 'double', 'fixed', 'adaptive', 'exact'])
      for (const step of [1, 4])
        for (const size of [17, 128]) {
          const place = () => [0, 1].map(() => (random((size + 8) * step) - 4 * step) / step);
          const names = 'ABCDEFGHIJKL'.slice(0, 3 + random(10));
          const corners = () => [0, 1, 2].map(() => names[random(names.length)]);
          const scene = {
            canvas: {width: size, height: size, origin: ['center', 'bottom-left', 'top-left'][random(3)]},
            vertices: Object.fromEntries([...names].map((name) => [name, place()])),
            triangles: [],
            lines: [names.slice(0, 2)],
            method: {fill, scalar, line: ['bresenham', 'dda', 'naive'][random(3)]},
          };
          for (let i = random(10); i >= 0; --i) {
            const three = corners();
            if (new Set(three).size === 3) scene.triangles.push({vertices: three.join(''), name: `t${i}`});
          }
          scenes.push([`dragged ${fill} ${scalar} 1/${step} ${size}`, JSON.stringify(scene)]);
        }
  return scenes;
}

/// What the program says: a trace, or a message that calls the scene "scene", as the module does.
function asked_of_program(text) {
  const run = spawnSync(program, ['trace', '-', '-o', '-'], {input: text, encoding: 'utf8', maxBuffer: 1 << 30});
  if (run.error) throw run.error;
  return run.status === 0 ? {trace: run.stdout} :
                            {message: run.stderr.replace(/^rastertrace: standard input/, 'scene').trimEnd()};
}

function asked_of_module(module, text) {
  try {
    return {trace: module.trace(text)};
  } catch (error) {
    return {message: error.message};
  }
}

/// The picture in motion has the pixels and depths of the steps of the same scene in doubles. Returns how many were compared.
function check_frames(module, scenes) {
  let count = 0;
  for (const [name, text] of scenes) {
    let frame;
    try {
      frame = JSON.parse(module.frame(text));
    } catch {
      continue; // a scene that names files, or that is wrong
    }
    const scene = JSON.parse(text);
    const in_doubles = JSON.stringify({...scene, method: {...scene.method, scalar: 'double'}});
    const data = JSON.parse(module.page_data_in_motion(in_doubles)), {width, height, left, top, down} = data.canvas;
    if (width * height > 5000) continue; // takes long
    const trace = JSON.parse(module.trace(in_doubles));
    const owners = new Array(width * height).fill(-1);
    let primitive = -1;
    for (const step of trace.steps) {
      if (step.step === 'primitive') ++primitive;
      if (step.step === 'pixel') owners[(step.y - top) * down * width + step.x - left] = primitive;
    }
    ++count;
    const depths = frame.depths.map(() => 0), tests = data.step_kinds.map((kind, n) => data.kinds[kind][0] === 'depth' ? data.at[n] : -1);
    tests.filter((at) => at >= 0).forEach((at, i) => { if (data.depths[3 * i] & 2) depths[at] = data.depths[3 * i + 1]; });
    for (const [told, expected, found] of [['pixel', owners, frame.owners], ['depth', depths, frame.depths]]) {
      const wrong = expected.findIndex((one, i) => one !== found[i]);
      if (wrong >= 0) throw new Error(`${name}: ${told} ${wrong} of the frame: expected ${expected[wrong]}, found ${found[wrong]}`);
    }
  }
  return count;
}

/// The picture in space is that of the program's own page: the widths of letters are the same.
function check_space(module) {
  for (const name of ['t0-projection/cube', 't0-hidden/cube-culled', 't4-pipeline/six-spaces', 't3-light/concave-depth']) {
    const file = path.join(examples, `${name}.json`);
    const page = execFileSync(program, ['figure', file, '--format', 'html', '-o', '-'], {encoding: 'utf8', maxBuffer: 1 << 28});
    const [, packed] = /<script type="text\/plain">([^<]*)</.exec(page);
    const [{data}] = JSON.parse(zlib.inflateSync(Buffer.from(packed, 'base64')).toString());
    const found = JSON.parse(module.page_data(fs.readFileSync(file, 'utf8')));
    const told = ({space, words}) => [space.all, ...space.steps.map((word) => words[word])];
    const wrong = told(data).findIndex((shapes, i) => shapes !== told(found)[i]);
    if (wrong >= 0 || data.space.steps.length !== found.space.steps.length)
      throw new Error(`${name}: the picture in space of step ${wrong} is not the program's`);
  }
}

/// Each question, about the triangle of the worked example.
function check_questions(module) {
  const scene = JSON.stringify({canvas: {width: 17, height: 14}, vertices: {A: [2, 5], B: [-4, -3], C: [5, -3]}, triangles: ['ABC'], method: {scalar: 'exact'}});
  const expect = (found, expected) => {
    if (JSON.stringify(found) !== JSON.stringify(expected)) throw new Error(`expected ${JSON.stringify(expected)}, found ${JSON.stringify(found)}`);
  };
  const message_of = (ask) => { try { ask(); return ''; } catch (error) { return error.message.split('\n')[0]; } };
  expect(module.problem(scene), '');
  const {line, column} = JSON.parse(module.problem(scene.replace('"ABC"', '\n "ABD"')));
  expect([line, column], [2, 5]); // the D
  expect(JSON.parse(module.step(scene, 7)).working.at(-1), 'x = 1 to 2: 2 - 1 + 1 = 2 pixels'); // row y=4
  expect(message_of(() => module.step(scene, 0)).startsWith('expected a step of 1 to '), true);
  expect(JSON.parse(module.explain_pixel(scene, 4, 2)).whyNot[0].sentence, 'AC ends row y=2 at x = 25/8 -> floor -> 3; x = 4 lies beyond it by 7/8');
  expect(message_of(() => module.explain_pixel(scene, 400, 2)), 'expected a pixel of the canvas, found 400,2');
  expect(JSON.parse(module.check(scene, 'y=2: -1/4, 25/8 -> -1..3\ny=1: 0, 7/2 -> -1..3')).map((one) => [one.verdict, one.fields]),
         [['right', []], ['wrong', ['left end: expected -1, found 0']]]);
  expect(JSON.parse(module.check(scene, '(4,2): on'))[0].fields, ['pixel: expected off, found on']);
  expect(message_of(() => module.check(scene, 'y=2 what')).startsWith('claims:1:'), true);
  expect(JSON.parse(module.mistakes(scene)).some(({name}) => name === 'dx-dy-inverted'), true);
  expect(JSON.parse(module.mistakes(scene)).some(({name}) => name === 'factor-2-dropped'), false); // one of lines
}

async function main() {
  const size = zlib.deflateSync(fs.readFileSync(module_file.replace(/js$/, 'wasm')), {level: 9}).length;
  if (size > 2 ** 20) throw new Error(`expected a module of at most 1,048,576 bytes deflated, found ${size}`);
  const module = await require(path.resolve(module_file))();
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'rastertrace-'));
  execFileSync(random_scenes, [count, folder]);
  const all = {
    'examples': scenes_in(examples).filter(can_be_dragged),
    'random scenes': scenes_in(folder).filter(can_be_dragged),
    'dragged scenes': dragged_scenes(),
  };
  if (all['random scenes'].length < 1000) throw new Error('expected 1,000 random scenes in the plane');
  fs.rmSync(folder, {recursive: true});

  const frames = check_frames(module, scenes_in(examples));
  if (frames < 100) throw new Error(`expected 100 frames of examples, found ${frames}`);
  console.log(`${frames} frames of examples; ${size} bytes deflated`);
  check_questions(module);
  check_space(module);
  const without_file = asked_of_module(module, '{"meshes": [{"obj": "cube.obj"}]}');
  if (!/^cube.obj: expected a file that can be read/.test(without_file.message))
    throw new Error(`expected a message that there is no file, found ${JSON.stringify(without_file)}`);

  let differences = 0;
  for (const [kind, scenes] of Object.entries(all)) {
    let traces = 0;
    let seconds = 0;
    let longest = 0;
    for (const [name, text] of scenes) {
      const expected = asked_of_program(text);
      const begin = process.hrtime.bigint();
      const found = asked_of_module(module, text);
      const took = Number(process.hrtime.bigint() - begin) / 1e9;
      seconds += took;
      longest = Math.max(longest, took);
      traces += found.trace !== undefined ? 1 : 0;
      if (found.trace === expected.trace && found.message === expected.message) continue;
      ++differences;
      if (differences > 5) continue;
      const lines = [expected, found].map((said) => (said.trace ?? said.message).split('\n'));
      const line = lines[0].findIndex((text, i) => text !== lines[1][i]);
      console.error(`${name}\n${text}\nline ${line + 1} of the program: ${lines[0][line]}\n` +
                    `line ${line + 1} of the module:  ${lines[1][line]}`);
    }
    console.log(`${kind}: ${traces} traces, ${scenes.length - traces} messages; the module took ` +
                `${(1000 * seconds / scenes.length).toFixed(1)} ms on average, ${longest.toFixed(2)} s at most`);
    if (traces === 0) throw new Error(`no ${kind} were drawn`);
  }
  console.log(`${differences} differences`);
  process.exitCode = differences === 0 ? 0 : 1;
}

main();
