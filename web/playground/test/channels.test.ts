import { expect, test } from "vitest";

import {
  channelNames,
  csvOf,
  extremes,
  inDivisions,
  readingAt,
  unitsPerDivision,
} from "../src/scope/channels.js";

const velocity = { name: "v", least: [0, 10, -3, 40], largest: [0, 20, 50, 40] };
const sweep = { fromMs: 0, toMs: 8, channels: [velocity] };

test("extremes are those of both ends", () => {
  expect(extremes(velocity)).toEqual({ least: -3, largest: 50 });
  expect(extremes({ name: "none", least: [], largest: [] })).toEqual({ least: 0, largest: 0 });
});

test("a channel fits into four divisions by itself", () => {
  expect(unitsPerDivision({ name: "v", offset: 0 }, velocity)).toBe(20); // 50 / 4 = 12.5
  expect(unitsPerDivision({ name: "v", offset: -2 }, velocity)).toBe(50); // 50 / 2 = 25
  expect(unitsPerDivision({ name: "v", offset: 0, perDivision: 7 }, velocity)).toBe(7);
});

test("a value in divisions", () => {
  expect(inDivisions(50, 20, -1)).toBe(1.5);
});

test.each([
  [0, { least: 0, largest: 0 }],
  [3.9, { least: 10, largest: 20 }],
  [4, { least: -3, largest: 50 }],
  [8, { least: 40, largest: 40 }],
  [8.1, undefined],
  [-0.1, undefined],
])("the reading at %d ms", (time, reading) => {
  expect(readingAt(sweep, "v", time)).toEqual(reading);
});

test("there is no reading of a channel that is not shown", () => {
  expect(readingAt(sweep, "x", 1)).toBeUndefined();
});

test("CSV has a row for each part", () => {
  expect(csvOf(sweep)).toBe("time_ms,v.min,v.max\n0,0,0\n2,10,20\n4,-3,50\n6,40,40\n");
  expect(csvOf({ ...sweep, channels: [] })).toBe("time_ms\n");
});

test("channels are the values of the card and the variables", () => {
  const card = {
    parts: [
      { part: "axis", number: 1, values: [{ name: "prfVel", path: "axis1.prfVel", value: 0 }] },
    ],
    words: [],
    switches: [],
  };
  const variables = [
    { name: "a", path: "a", type: "int", slot: 0, value: [1, 2] },
    { name: "x", path: "page0.x", type: "int", slot: 0, value: 1 },
  ];
  expect(channelNames(card, variables)).toEqual(["a[0]", "a[1]", "page0.x", "axis1.prfVel"]);
});
