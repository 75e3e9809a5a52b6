import { expect, test } from "vitest";

import {
  channelNames,
  csvOf,
  envelope,
  extremes,
  inDivisions,
  legendOf,
  readingAt,
  unitsOf,
  unitsPerDivision,
  valueAt,
  valueNow,
  valuesAtDivisions,
} from "../src/scope/channels.js";
import { cardWith } from "./card.js";

/** Four parts of 2 ms; the screen ends later. */
const velocity = { name: "v", least: [0, 10, -3, 40], largest: [0, 20, 50, 40] };
const sweep = { fromMs: 0, toMs: 10, endMs: 8, channels: [velocity] };

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
  [2, 20, 0, 40],
  [0, 20, -1, 20],
  [-4, 5, 1, -25],
  [1.52, 20, 0, 30], // a step is 1
  [1.53, 20, 0, 31],
  [0.15, 0.2, 0, 0.03],
  [-0.01, 20, 0, 0],
])("at %d, with %d per division and the zero at %d, is %d", (at, per, offset, value) => {
  expect(valueAt(at, per, offset)).toBe(value);
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
  const units = new Map([["v", "mm/s"]]);
  const rows = "0,0,0\n2,10,20\n4,-3,50\n6,40,40\n";
  expect(csvOf(sweep, units)).toBe(`time [ms],v [mm/s] min,v [mm/s] max\n${rows}`);
  expect(csvOf(sweep, new Map())).toBe(`time [ms],v min,v max\n${rows}`);
  expect(csvOf({ ...sweep, channels: [] }, units)).toBe("time [ms]\n");
});

test("the legend of the picture says what a division is", () => {
  const drawn = [
    { name: "v", offset: 0, isDigital: false },
    { name: "gone", offset: 0, isDigital: false },
  ];
  expect(legendOf(sweep, drawn, new Map([["v", "mm/s"]]))).toEqual(["v: 20 mm/s/div", "gone"]);
  expect(legendOf(sweep, drawn, new Map())).toEqual(["v: 20/div", "gone"]);
  const lane = { name: "v", offset: 0, isDigital: true };
  expect(legendOf(sweep, [lane], new Map())).toEqual(["v"]);
});

test("values of the card have the units that it says", () => {
  const values = [
    { name: "prfPos", path: "axis1.prfPos", value: 12.5, unit: "mm" },
    { name: "sts", path: "axis1.sts", value: 0 },
  ];
  const card = cardWith({ parts: [{ part: "axis", number: 1, values }] });
  expect(unitsOf(card)).toEqual(new Map([["axis1.prfPos", "mm"]]));
  expect(unitsOf(undefined).size).toBe(0);
});

test("channels are the values of the card, the variables, and pins", () => {
  const prfVel = { name: "prfVel", path: "axis1.prfVel", value: 0 };
  const card = cardWith({
    parts: [{ part: "axis", number: 1, values: [prfVel] }],
    words: [{ name: "mpg", kind: "input", value: 0, pins: 2 }],
  });
  const variables = [
    { name: "a", path: "a", type: "int", slot: 0, value: [1, 2] },
    { name: "x", path: "page0.x", type: "int", slot: 0, value: 1 },
  ];
  const others = ["a[0]", "a[1]", "page0.x", "axis1.prfVel"];
  expect(channelNames(card, variables)).toEqual([...others, "mpg[1]", "mpg[2]"]);
});

test.each([
  ["x", 7],
  ["a[1]", 5],
  ["page0.a[0]", 2],
  ["axis1.prfPos", 12.5],
  ["a", undefined],
  ["a[9]", undefined],
  ["gone", undefined],
  ["gpi[3]", 1],
  ["gpi[2]", 0],
])("the present value of %s", (name, value) => {
  const variable = { type: "int", slot: 0 };
  const variables = [
    { ...variable, name: "x", path: "x", value: 7 },
    { ...variable, name: "a", path: "a", value: [4, 5] },
    { ...variable, name: "a", path: "page0.a", value: [2] },
  ];
  const prfPos = { name: "prfPos", path: "axis1.prfPos", value: 12.5 };
  const gpi = { name: "gpi", kind: "input" as const, value: 0b101, pins: 16 };
  const parts = [{ part: "axis", number: 1, values: [prfPos] }];
  const card = cardWith({ parts, words: [gpi] });
  expect(valueNow(card, variables, name)).toBe(value);
});

test("every second division has its value", () => {
  const curve = { name: "v", perDivision: 20, isDigital: false };
  const at = (offset: number) => valuesAtDivisions(sweep, { ...curve, offset });
  expect(at(0)).toEqual(["-80", "", "-40", "", "0", "", "40", "", "80"]);
  expect(at(-2)).toEqual(["-40", "", "0", "", "40", "", "80", "", "120"]);
  expect(valuesAtDivisions(sweep, undefined).join("")).toBe("");
  expect(valuesAtDivisions(sweep, { ...curve, name: "gone", offset: 0 }).join("")).toBe("");
  expect(valuesAtDivisions(sweep, { ...curve, offset: 0, isDigital: true }).join("")).toBe("");
});

const curve = (name: string) => ({ name, offset: 0, isDigital: false });

test("the envelope goes through both ends of each part, in the direction of the curve", () => {
  // 50 / 4 = 12.5: 20 units per division.
  const [times, line] = envelope(sweep, [curve("v")]);
  expect(times).toEqual([0, 1, 2, 3, 4, 5, 6, 7]);
  expect(line).toEqual([0, 0, 0.5, 1, 2.5, -0.15, 2, 2]);
  expect(envelope(sweep, [curve("other")])[1]).toEqual(times.map(() => null));
});
