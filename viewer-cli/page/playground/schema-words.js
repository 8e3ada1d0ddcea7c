// SPDX-License-Identifier: MIT
// What the schema of scenes offers at a place of a text: keys and values, and what they mean. The text may be unfinished.

/** The schemas that a reference, or one of several, leads to. */
function alternatives(schema, root) {
  if (!schema || typeof schema !== "object") return [];
  if (schema.$ref) return alternatives(root.definitions[schema.$ref.split("/").at(-1)], root);
  const among = [...schema.allOf ?? [], ...schema.anyOf ?? [], ...schema.oneOf ?? []];
  return [schema, ...among.flatMap(one => alternatives(one, root))];
}

/** The schemas of what stands behind a path of keys and places. */
function schemasAt(path, root) {
  return path.reduce((schemas, key) => schemas.flatMap(schema => alternatives(
    typeof key === "number" ? Array.isArray(schema.items) ? schema.items[key] : schema.items
                            : schema.properties?.[key] ?? schema.additionalProperties, root)), alternatives(root, root));
}

/** Where a text ends: the keys and places around it, whether a key comes, and where the word begins that it ends in. */
function endOf(text) {
  const around = []; // {key, comesKey} of an object, {place} of an array
  let from;
  for (const {0: token, index} of text.matchAll(/"(?:[^"\\\n]|\\.)*("?)|[{}[\],:]/g)) {
    const inner = around.at(-1);
    if (token === "{") around.push({key: undefined, comesKey: true});
    else if (token === "[") around.push({place: 0});
    else if (token === "}" || token === "]") around.pop();
    else if (token === ":" && inner) inner.comesKey = false;
    else if (token === "," && inner) { if ("place" in inner) ++inner.place; else inner.comesKey = true; }
    else if (token.length < 2 || !token.endsWith("\"")) { if (index + token.length === text.length) from = index; }
    else if (inner?.comesKey) inner.key = token.slice(1, -1);
  }
  const inner = around.at(-1), isKey = inner?.comesKey ?? false;
  const path = around.slice(0, isKey ? -1 : undefined).map(one => one.place ?? one.key);
  return {path, isKey, from};
}

/** [[word, meaning], ...] of what may stand there. */
function wordsAt({path, isKey}, root) {
  const words = new Map();
  for (const schema of schemasAt(path, root)) {
    if (isKey)
      for (const [key, one] of Object.entries(schema.properties ?? {}))
        words.set(key, words.get(key) || alternatives(one, root).find(other => other.description)?.description || "");
    else
      (schema.enum ?? []).forEach((value, i) => words.set(value, words.get(value) || schema.enumDescriptions?.[i] || ""));
  }
  return [...words].filter(([word]) => typeof word === "string");
}

/** A source of completions for CodeMirror. */
export const completions = root => ({state, pos, explicit}) => {
  const end = endOf(state.sliceDoc(0, pos)), isWord = end.from !== undefined;
  if (!isWord && !explicit) return null;
  const colon = end.isKey && !/^"?\s*:/.test(state.sliceDoc(pos, pos + 10)) ? ": " : "";
  const to = state.sliceDoc(pos, pos + 1) === "\"" ? pos + 1 : pos; // the quote that the editor has closed by itself
  const options = wordsAt(end, root).map(([word, meaning]) => ({
    label: JSON.stringify(word), info: meaning || undefined, type: end.isKey ? "property" : "enum",
    apply: (view, completion, from) => view.dispatch({changes: {from, to: Math.max(to, view.state.selection.main.head), insert: completion.label + colon},
                                                      selection: {anchor: from + completion.label.length + colon.length}})}));
  return options.length ? {from: end.from ?? pos, options, filter: true} : null;
};

/** What the key or the value around a place means; undefined if the schema does not tell. */
export function meaningAt(state, position, root) {
  const line = state.doc.lineAt(position);
  for (const {0: token, index} of line.text.matchAll(/"(?:[^"\\]|\\.)*"/g)) {
    const from = line.from + index, to = from + token.length;
    if (position < from || to < position) continue;
    const found = wordsAt(endOf(state.sliceDoc(0, from)), root).find(([word]) => word === token.slice(1, -1));
    return found?.[1] ? {from, to, meaning: found[1]} : undefined;
  }
  return undefined;
}
