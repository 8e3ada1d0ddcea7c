// SPDX-License-Identifier: MIT
// Makes what pages and sites take of Emscripten's two files:
//
//     node pack.js glue.js glue.wasm rastertrace
//
//     rastertrace.js      one script for a page without other files: the WebAssembly is within it, compressed
//     rastertrace.mjs     a module for a site; it loads rastertrace.wasm, which lies beside it
//     rastertrace.wasm

'use strict';
const fs = require('fs');
const zlib = require('zlib');

const [glue_file, binary_file, packed] = process.argv.slice(2);
const binary = fs.readFileSync(binary_file);
const glue = `const module = undefined, exports = undefined, define = undefined; // what follows exports itself else
${fs.readFileSync(glue_file, 'utf8').trim()}`;
const heading = `// SPDX-License-Identifier: MIT
// rastertrace as WebAssembly: \`rastertrace()\` gives a promise of the module.`;

fs.writeFileSync(`${packed}.js`, `${heading} Nothing is fetched.
var rastertrace = (() => {
  ${glue}
  return async () => {
    const bytes = Uint8Array.from(atob('${zlib.deflateSync(binary, {level: 9}).toString('base64')}'), (c) => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
    return rastertrace_of_binary({wasmBinary: await new Response(stream).arrayBuffer()});
  };
})();
if (typeof module === 'object') module.exports = rastertrace;
`);
fs.writeFileSync(`${packed}.mjs`, `${heading}
${glue}
export default async function rastertrace() {
  const answer = await fetch(new URL('rastertrace.wasm', import.meta.url));
  if (!answer.ok) throw new Error(\`rastertrace.wasm: \${answer.status} \${answer.statusText}\`);
  const isStream = answer.headers.get('content-type') === 'application/wasm'; // compiled while it is loaded
  const compiled = await (isStream && WebAssembly.compileStreaming ? WebAssembly.compileStreaming(answer)
                                                                   : WebAssembly.compile(await answer.arrayBuffer()));
  return new Promise((resolve, reject) => {
    const instantiateWasm = (imports, done) => { WebAssembly.instantiate(compiled, imports).then(done).catch(reject); return {}; };
    rastertrace_of_binary({instantiateWasm}).then(resolve, reject);
  });
}
`);
fs.writeFileSync(`${packed}.wasm`, binary);
