import { expect, test } from "vitest";

import { columnsOf } from "../src/scope/columns.js";

test.each([
  { heights: [], columns: [] },
  { heights: [2, 0, -1], columns: [0, 0, 0] },
  { heights: [0, 0, 0], columns: [0, 1, 2] },
  { heights: [0, 0.9, 1.8], columns: [0, 1, 0] },
  { heights: [0, 1.8, 0.9], columns: [0, 0, 1] },
  { heights: [0, -1], columns: [0, 0] },
])("handles at $heights stand in the columns $columns", ({ heights, columns }) => {
  expect(columnsOf(heights, 1)).toEqual(columns);
});
