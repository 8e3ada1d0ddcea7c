// SPDX-License-Identifier: MIT
// Puts Emscripten's two files into one, with the WebAssembly compressed: a third of its size as plain text.
//
//     node pack.js glue.js glue.wasm rastertrace.js

'use strict';
const fs = require('fs');
const zlib = require('zlib');

const [glue, binary, packed] = process.argv.slice(2);
const text = zlib.deflateSync(fs.readFileSync(binary), {level: 9}).toString('base64');
fs.writeFileSync(packed, `// SPDX-License-Identifier: MIT
// rastertrace as WebAssembly: \`rastertrace()\` gives a promise of the module. Nothing is fetched.
var rastertrace = (() => {
  const module = undefined, exports = undefined, define = undefined; // what follows exports itself else
${fs.readFileSync(glue, 'utf8').trim()}
  return async () => {
    const bytes = Uint8Array.from(atob('${text}'), (c) => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
    return rastertrace_of_binary({wasmBinary: await new Response(stream).arrayBuffer()});
  };
})();
if (typeof module === 'object') module.exports = rastertrace;
`);
