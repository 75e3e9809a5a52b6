import { expect, test } from "vitest";

import { Lines } from "../src/positions.js";

// A character beyond the first 65536 is two code units of an editor and one character of the engine.
const lines = new Lines("int a;\n// 线程 🙂 x\r\n\tb\n");

const same: [{ line: number; column: number }, { line: number; character: number }][] = [
  [
    { line: 1, column: 1 },
    { line: 0, character: 0 },
  ],
  [
    { line: 1, column: 7 },
    { line: 0, character: 6 },
  ],
  [
    { line: 2, column: 6 },
    { line: 1, character: 5 },
  ],
  [
    { line: 2, column: 7 },
    { line: 1, character: 6 },
  ],
  [
    { line: 2, column: 8 },
    { line: 1, character: 8 },
  ],
  [
    { line: 2, column: 9 },
    { line: 1, character: 9 },
  ],
  [
    { line: 3, column: 2 },
    { line: 2, character: 1 },
  ],
  [
    { line: 4, column: 1 },
    { line: 3, character: 0 },
  ],
];

test.each(same)("%j is %j", (place, position) => {
  expect(lines.position(place)).toEqual(position);
  expect(lines.place(position)).toEqual(place);
});

test("what is after the end is at the end", () => {
  expect(lines.position({ line: 1, column: 99 })).toEqual({ line: 0, character: 6 });
  expect(lines.position({ line: 99, column: 1 })).toEqual({ line: 3, character: 0 });
});
