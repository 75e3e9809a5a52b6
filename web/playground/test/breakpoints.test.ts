import { EditorState } from "@codemirror/state";
import { expect, test } from "vitest";

import { breakpointGutter, breakpointLines, setBreakpoints } from "../src/editor/breakpoints.js";

const begun = EditorState.create({
  doc: "int x;\nint main()\n{\n  x = 1;\n}\n",
  extensions: breakpointGutter(() => undefined),
});
const withLines = (lines: number[]) => begun.update({ effects: setBreakpoints.of(lines) }).state;

test("breakpoints are replaced, and stand at lines of the text", () => {
  expect(breakpointLines(begun)).toEqual([]);
  const set = withLines([4, 2]);
  expect(breakpointLines(set)).toEqual([2, 4]);
  expect(breakpointLines(set.update({ effects: setBreakpoints.of([3]) }).state)).toEqual([3]);
  expect(breakpointLines(withLines([0, 7, 1]))).toEqual([1]);
});

test("they move with their lines", () => {
  const before = withLines([2, 4]);
  const added = before.update({ changes: { from: 0, insert: "int y;\n" } }).state;
  expect(breakpointLines(added)).toEqual([3, 5]);
  const removed = added.update({ changes: { from: 0, to: 7 } }).state;
  expect(breakpointLines(removed)).toEqual([2, 4]);
});

test("two that come into one line are one", () => {
  const before = withLines([3, 4]);
  const { from } = before.doc.line(3);
  const joined = before.update({ changes: { from, to: before.doc.line(4).from } }).state;
  expect(breakpointLines(joined)).toEqual([3]);
});
