import { expect, test } from "vitest";

import { indexOfPlace, placeOfIndex, withFixes } from "../src/editor/offsets.js";

const text = "int a;\n/* 轴 😀 */ b = 1;\nend";

test.each([
  [1, 1, 0],
  [1, 5, 4],
  [2, 1, 7],
  [2, 4, 10], // before 轴
  [2, 5, 11], // behind it
  [2, 7, 14], // behind the emoji, which has two units
  [2, 11, 18], // before b
  [3, 4, text.length],
  [1, 99, 6], // at most the end of the line
  [9, 1, text.length],
])("line %i, column %i", (line, column, index) => {
  expect(indexOfPlace(text, line, column)).toBe(index);
});

test.each([
  [0, 1, 1],
  [6, 1, 7],
  [7, 2, 1],
  [14, 2, 7], // behind the emoji, which has two units
  [text.length, 3, 4],
])("index %i", (index, line, column) => {
  expect(placeOfIndex(text, index)).toEqual({ line, column });
  expect(indexOfPlace(text, line, column)).toBe(index);
});

test("all fixes of a message are made at once", () => {
  const at = (line: number, column: number, end: number, put: string) => ({
    ...{ file: "p.c", line, column, end_line: line, end_column: end, text: put },
  });
  const fixed = withFixes(text, [at(1, 5, 6, "longer"), at(2, 11, 12, "c"), at(1, 1, 1, "// ")]);
  expect(fixed).toBe("// int longer;\n/* 轴 😀 */ c = 1;\nend");
});
