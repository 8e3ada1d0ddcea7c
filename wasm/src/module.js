// SPDX-License-Identifier: MIT
// What a page calls. Emscripten puts this behind its own code; `rastertrace()` gives a promise of the module:
//
//     const module = await rastertrace();
//     module.trace('{"vertices": ...}')   // the text of the trace
//     module.page_data('{"vertices": ...}')   // what the page shows of it, as JSON; page_data_in_motion: less, sooner
//     module.tell_steps_in('pt')              // the language of sentences, from then on
//
// Where the program would print an error, the function throws an Error with that text.

function with_text(text, use) {
  const size = lengthBytesUTF8(text) + 1;
  const at = _malloc(size);
  stringToUTF8(text, at, size);
  const result = use(at);
  _free(at);
  return result;
}

function ask_of_scene(answer_of) {
  return (scene) => {
    const answer = with_text(scene, (at) => UTF8ToString(answer_of(at)));
    if (_rastertrace_is_message()) throw new Error(answer);
    return answer;
  };
}

Module['trace'] = ask_of_scene((scene) => _rastertrace_trace(scene));
Module['page_data'] = ask_of_scene((scene) => _rastertrace_page_data(scene));
Module['tell_steps_in'] = (code) => with_text(code, (at) => _rastertrace_tell_steps_in(at));
Module['page_data_in_motion'] = ask_of_scene((scene) => _rastertrace_page_data_in_motion(scene));
