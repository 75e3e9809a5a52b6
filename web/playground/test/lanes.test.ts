import { expect, test } from "vitest";

import { runsOf } from "../src/scope/lanes.js";

test.each([
  { least: [], largest: [], runs: [] },
  { least: [0, 0, 0], largest: [0, 0, 0], runs: [[0, 3, 0]] },
  {
    least: [0, 1, 1, 0],
    largest: [0, 1, 1, 0],
    runs: [
      [0, 1, 0],
      [1, 3, 1],
      [3, 4, 0],
    ],
  },
  // A pulse that is shorter than a part, and then a level that falls within one.
  {
    least: [0, 0, 0, 1, 0, 0],
    largest: [0, 1, 0, 1, 1, 1],
    runs: [
      [0, 1, 0],
      [1, 2, "both"],
      [2, 3, 0],
      [3, 4, 1],
      [4, 6, "both"],
    ],
  },
])("values from $least to $largest", ({ least, largest, runs }) => {
  const found = runsOf({ name: "gpo[1]", least, largest });
  expect(found.map(({ begin, end, level }) => [begin, end, level])).toEqual(runs);
});
