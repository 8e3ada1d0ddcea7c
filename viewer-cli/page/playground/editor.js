// SPDX-License-Identifier: MIT
// The editor of the playground: CodeMirror, with what the schema of scenes offers. It is loaded behind the first picture.

import {basicSetup, EditorView} from "codemirror";
import {autocompletion} from "@codemirror/autocomplete";
import {json} from "@codemirror/lang-json";
import {HighlightStyle, syntaxHighlighting} from "@codemirror/language";
import {setDiagnostics} from "@codemirror/lint";
import {hoverTooltip} from "@codemirror/view";
import {tags} from "@lezer/highlight";
import {completions, meaningAt} from "./schema-words.js";

// Colors of the editor: those of the page, light or dark.
const inks = syntaxHighlighting(HighlightStyle.define([
  {tag: tags.propertyName, color: "var(--link)"}, {tag: tags.string, color: "var(--right)"},
  {tag: [tags.number, tags.bool, tags.null], color: "var(--wrong)"}]));
const look = EditorView.theme({
  "&": {color: "var(--text)"},
  ".cm-content": {caretColor: "var(--text)"},
  ".cm-cursor": {borderLeftColor: "var(--text)"},
  ".cm-gutters": {backgroundColor: "var(--shelf)", color: "var(--quiet)", border: "none"},
  ".cm-activeLine, .cm-activeLineGutter": {backgroundColor: "var(--shelf)"},
  "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground": {backgroundColor: "var(--line)"},
  ".cm-matchingBracket": {backgroundColor: "var(--line) !important"},
  ".cm-tooltip": {backgroundColor: "var(--shelf)", color: "var(--text)", border: "1px solid var(--quiet)", padding: "0.1rem 0.4rem", maxWidth: "24rem"},
  ".cm-tooltip-autocomplete > ul > li[aria-selected]": {backgroundColor: "var(--link)", color: "var(--paper)"},
});

/** An editor in an element, with a text. `changed` is called whenever the text is another one. */
export function editorOf(parent, doc, schema, changed) {
  return new EditorView({doc, parent, extensions: [
    basicSetup, inks, look, json(), EditorView.lineWrapping, autocompletion({override: [completions(schema)]}),
    EditorView.contentAttributes.of({"aria-label": "The scene"}),
    EditorView.updateListener.of(update => { if (update.docChanged) changed(); }),
    hoverTooltip((view, position) => {
      const told = meaningAt(view.state, position, schema);
      return told ? {pos: told.from, end: told.to, create: () => ({dom: Object.assign(document.createElement("div"), {textContent: told.meaning})})} : null;
    })]});
}

/** Marks what is wrong at its place; nothing, if there is no problem, or it has no place. */
export function mark(view, problem) {
  const {doc} = view.state, diagnostics = [];
  if (problem?.line) {
    const line = doc.line(Math.min(problem.line, doc.lines)), from = Math.min(line.from + problem.column - 1, line.to);
    const word = /^("(?:[^"\\]|\\.)*"|[-\w.]+)/.exec(doc.sliceString(from, line.to))?.[0].length ?? 1;
    diagnostics.push({from: Math.min(from, doc.length), to: Math.min(from + word, doc.length), severity: "error", message: problem.message});
  }
  view.dispatch(setDiagnostics(view.state, diagnostics));
}
