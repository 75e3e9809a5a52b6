// The colours and the indentation of motion programs in the editor.

import { getIndentation } from "@codemirror/language";
import { EditorState } from "@codemirror/state";
import { highlightTree, tagHighlighter, tags } from "@lezer/highlight";
import { expect, test } from "vitest";

import { motionProgram } from "../src/editor/motion_program.js";

const kinds = tagHighlighter(
  ["comment", "keyword", "labelName", "number", "processingInstruction", "string", "typeName"].map(
    (name) => ({ tag: tags[name as "comment"], class: name }),
  ),
);

/** The words that have a colour, each with its kind. */
function coloured(text: string): string[] {
  const found: string[] = [];
  highlightTree(motionProgram.parser.parse(text), kinds, (from, to, kind) => {
    found.push(`${kind} ${text.slice(from, to)}`);
  });
  return found;
}

test.each([
  ["// a = 1", ["comment // a = 1"]],
  ["a = b; /* 1\n for */ 2;", ["comment /* 1", "comment  for */", "number 2"]],
  ["int total = 0x1F;", ["typeName int", "number 0x1F"]],
  ["double v = .5 + 1.5e3;", ["typeName double", "number .5", "number 1.5e3"]],
  ["if (form1 == 2) return 1;", ["keyword if", "number 2", "keyword return", "number 1"]],
  ["again: goto again;", ["labelName again", "keyword goto", "labelName again"]],
  ["default: x = 1;", ["keyword default", "number 1"]],
  ["#define LIMIT 5", ["processingInstruction #define", "number 5"]],
  ['#include "a.h"', ["processingInstruction #include", 'string "a.h"']],
  ["  #include <a.h>", ["processingInstruction   #include", "string <a.h>"]],
  ["const int a = 'x';", ["keyword const", "typeName int", "string 'x'"]],
])("the words of %j", (text, expected) => {
  expect(coloured(text)).toEqual(expected);
});

test.each([
  ["void main(void)\n{\n", 2],
  ["void main(void)\n{\n  if (a) {\n", 4],
  ["void main(void)\n{\n  if (a) {\n    b = 1;\n  }\n", 2],
  ["void main(void)\n{\n  /* { { */\n", 2],
])("the indentation after %j", (text, expected) => {
  expect(
    getIndentation(EditorState.create({ doc: text, extensions: motionProgram }), text.length),
  ).toBe(expected);
});
