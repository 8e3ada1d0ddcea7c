// SPDX-License-Identifier: MIT
// What a page calls. Emscripten puts this behind its own code; `rastertrace()` gives a promise of the module. Its functions
// take a scene as a text and give a text, most of them JSON (module.cpp says what is in it):
//
//     const module = await rastertrace();
//     module.problem(scene)               // what is wrong with it; '' if nothing is
//     module.page_data(scene)             // what a page shows of it; page_data_in_motion: less, sooner
//     module.frame(scene)                 // its last picture alone
//     module.step(scene, 14)              // a step's sentence and working
//     module.explain_pixel(scene, 4, 2)   // why a pixel is as it is
//     module.check(scene, 'y=2: 0..3')    // what is wrong of what was worked out by hand
//     module.mistakes(scene)              // those that may change it
//     module.trace(scene)                 // the text of its trace
//     module.tell_steps_in('pt')          // the language of sentences, from then on
//
// Where the program would print an error, the function throws an Error with that text.

function with_text(text, use) {
  const size = lengthBytesUTF8(text) + 1;
  const at = _malloc(size);
  stringToUTF8(text, at, size);
  try {
    return use(at);
  } finally {
    _free(at);
  }
}

function ask_of_scene(answer_of) {
  return (scene, ...more) => {
    const answer = with_text(scene, (at) => UTF8ToString(answer_of(at, ...more)));
    if (_rastertrace_is_message()) throw new Error(answer);
    return answer;
  };
}

Module['problem'] = ask_of_scene((scene) => _rastertrace_problem(scene));
Module['trace'] = ask_of_scene((scene) => _rastertrace_trace(scene));
Module['page_data'] = ask_of_scene((scene) => _rastertrace_page_data(scene));
Module['page_data_in_motion'] = ask_of_scene((scene) => _rastertrace_page_data_in_motion(scene));
Module['frame'] = ask_of_scene((scene) => _rastertrace_frame(scene));
Module['step'] = ask_of_scene((scene, n) => _rastertrace_step(scene, n));
Module['explain_pixel'] = ask_of_scene((scene, x, y) => _rastertrace_explain_pixel(scene, x, y));
Module['check'] = ask_of_scene((scene, claims) => with_text(claims, (at) => _rastertrace_check(scene, at)));
Module['mistakes'] = ask_of_scene((scene) => _rastertrace_mistakes(scene));
Module['tell_steps_in'] = (code) => with_text(code, (at) => _rastertrace_tell_steps_in(at));
