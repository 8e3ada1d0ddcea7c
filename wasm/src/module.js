// SPDX-License-Identifier: MIT
// What a page calls. Emscripten puts this behind its own code; `rastertrace()` gives a promise of the module:
//
//     const module = await rastertrace();
//     module.trace('{"vertices": ...}')   // the text of the trace
//     module.page_data('{"vertices": ...}')   // what the page shows of it, as JSON; page_data_in_motion: less, sooner
//
// Where the program would print an error, the function throws an Error with that text.

function ask_of_scene(answer_of) {
  return (scene) => {
    const size = lengthBytesUTF8(scene) + 1;
    const at = _malloc(size);
    stringToUTF8(scene, at, size);
    const answer = UTF8ToString(answer_of(at));
    _free(at);
    if (_rastertrace_is_message()) throw new Error(answer);
    return answer;
  };
}

Module['trace'] = ask_of_scene((scene) => _rastertrace_trace(scene));
Module['page_data'] = ask_of_scene((scene) => _rastertrace_page_data(scene));
Module['page_data_in_motion'] = ask_of_scene((scene) => _rastertrace_page_data_in_motion(scene));
