import { expect, test } from "vitest";

import { columnOfIndex, indexOfColumn } from "../src/columns.js";

// 轴 is one character and one unit, the emoji one character and two units.
const line = "/* 轴 😀 */ b";

test.each([
  [1, 0],
  [4, 3], // 轴
  [5, 4],
  [6, 5], // the emoji
  [7, 7],
  [11, 11], // b
  [12, 12], // the end
])("column %i begins at %i", (column, index) => {
  expect(indexOfColumn(line, column)).toBe(index);
  expect(columnOfIndex(line, index)).toBe(column);
});

test("what is behind the end is at the end", () => {
  expect(indexOfColumn(line, 99)).toBe(12);
  expect(columnOfIndex(line, 99)).toBe(12);
});
