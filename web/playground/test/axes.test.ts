import type { CardPath } from "@oncard/engine";
import { expect, test } from "vitest";

import {
  aheadOf,
  axesNamed,
  axesOf,
  grownTo,
  isTable,
  isUsed,
  pin,
  placeOn,
  positionText,
  roundUp,
  sameScale,
  tableAxes,
  trailOf,
  wayOf,
} from "../src/machine/axes.js";
import { cardWith } from "./card.js";

const card = cardWith({
  parts: [1, 2].map((number) => ({
    part: "axis",
    number,
    values: [
      { name: "prfPos", path: `axis${number}.prfPos`, value: number === 2 ? 500 : 0 },
      { name: "moving", path: `axis${number}.moving`, value: number === 2 ? 1 : 0 },
    ],
  })),
  words: [
    { name: "limit_positive", kind: "input", value: 0b10, pins: 8 },
    { name: "gpo", kind: "output", value: 0x8000, pins: 16 },
  ],
});

test("axes have the switches of their number", () => {
  const [first, second] = axesOf(card);
  expect(first).toMatchObject({ axis: 1, position: 0, moving: false, positiveLimit: false });
  expect(second).toMatchObject({ axis: 2, position: 500, moving: true, positiveLimit: true });
  expect(axesOf(card).map(isUsed)).toEqual([false, true]);
  expect(second?.actual).toBe(500); // without an encoder
});

test("axes have what they are commanded, where they are, and the switches of the scenario", () => {
  const values = [
    { name: "prfPos", path: "axis2.prfPos", value: 500 },
    { name: "encPos", path: "axis2.encPos", value: 480 },
  ];
  const at = { index: 2, active_low: false, connected: true };
  const [axis] = axesOf({
    ...card,
    parts: [{ part: "axis", number: 2, values }],
    switches: [
      { axis: 2, type: "limit_positive", from: 450, ...at },
      { axis: 2, type: "limit_negative", to: -20, ...at },
      { axis: 1, type: "home", from: 0, to: 10, ...at },
      { axis: 2, type: "home", ...at },
    ],
  });
  expect(axis).toMatchObject({ position: 500, actual: 480 });
  expect(axis?.switches).toEqual([
    { type: "limit_positive", index: 2, place: 450, on: true },
    { type: "limit_negative", index: 2, place: -20, on: false },
  ]);
});

test("axes are shown in their units", () => {
  const values = [
    { name: "prfPos", path: "axis1.prfPos", value: 12.5, unit: "mm" },
    { name: "prfVel", path: "axis1.prfVel", value: 20, unit: "mm/s" },
  ];
  const [axis] = axesOf({ ...card, parts: [{ part: "axis", number: 1, values }] });
  expect(axis).toMatchObject({ positionUnit: "mm", velocityUnit: "mm/s" });
  expect(axis && positionText(axis)).toBe("12.5 mm");
});

test("pins count from 1", () => {
  expect(pin(card, "gpo", 16)).toBe(true);
  expect(pin(card, "gpo", 15)).toBe(false);
  expect(pin(card, "nothing", 1)).toBe(false);
});

test("axes that channels name", () => {
  expect(axesNamed(["axis3.prfVel", "x", "axis12.prfPos", "crd1.x"])).toEqual([3, 12]);
});

test.each([
  [0, 1],
  [0.7, 1],
  [1, 1],
  [1.1, 2],
  [30_000, 50_000],
  [50_000, 50_000],
  [51_000, 100_000],
])("%d is rounded up to %d", (value, rounded) => {
  expect(roundUp(value)).toBeCloseTo(rounded, 9);
});

test("a stage grows and never shrinks", () => {
  const grownOnce = grownTo(undefined, [30_000], "pulse");
  expect(grownOnce).toEqual({ least: 0, largest: 50_000 });
  expect(grownTo(grownOnce, [10, 400], "pulse")).toEqual(grownOnce);
  expect(grownTo(grownOnce, [10, -1500], "pulse")).toEqual({ least: -2000, largest: 50_000 });
  expect(placeOn(grownOnce, 25_000)).toBe(0.5);
});

test("a stage of an axis that has a unit reaches as far as machines do", () => {
  expect(grownTo(undefined, [12.5], "mm")).toEqual({ least: 0, largest: 100 });
  expect(grownTo(undefined, [330, -40], "mm")).toEqual({ least: -50, largest: 500 });
  expect(grownTo(undefined, [], "mm")).toEqual({ least: 0, largest: 100 });
});

test("a way goes on in the direction in which its axes travel, and turns where they turned", () => {
  // Up from 0 to 30, at rest, down to -10, in parts of a trace.
  const x = { least: [0, 10, 20, 30, 10, -10], largest: [10, 20, 30, 30, 30, 10] };
  const y = { least: [5, 5, 5, 5, 5, 5], largest: [5, 5, 5, 5, 5, 5] };
  expect(wayOf([x, y]).map(([at]) => at)).toEqual([10, 20, 30, 30, 10, -10]);
  expect(wayOf([y, x])[4]).toEqual([5, 10]);
  expect(wayOf([x])).toEqual([]);
});

test("two axes on a straight line in opposite directions stay on it", () => {
  const x = { least: [0, 10, 20], largest: [10, 20, 30] };
  const y = { least: [20, 10, 0], largest: [30, 20, 10] };
  expect(wayOf([x, y]).map(([left, top]) => left + top)).toEqual([30, 30, 30]);
});

test("a trail is one way in parts, which are the darker the younger they are", () => {
  const way = Array.from({ length: 301 }, (_, index) => index);
  const trail = trailOf(way);
  expect(trail).toHaveLength(8);
  expect(trail[0]?.part[0]).toBe(0);
  expect(trail.at(-1)?.part.at(-1)).toBe(300);
  for (const [index, { part }] of trail.slice(1).entries()) {
    expect(part[0]).toBe(trail[index]?.part.at(-1));
  }
  const shades = trail.map(({ opacity }) => opacity);
  expect(shades[0]).toBeCloseTo(0.28);
  expect(shades.at(-1)).toBe(1);
  expect(shades).toEqual([...shades].sort((a, b) => a - b));
});

test("a short way has fewer parts, and a single place has none", () => {
  expect(trailOf(["a", "b", "c"]).map(({ part }) => part.join(""))).toEqual(["ab", "bc"]);
  expect(trailOf(["a", "b"])).toEqual([{ part: ["a", "b"], opacity: 1 }]);
  expect(trailOf(["a"])).toEqual([]);
});

// --- Tables --------------------------------------------------------------------------------------

/** A card of four axes; a switch at one of them. */
const four = cardWith({
  parts: [1, 2, 3, 4].map((number) => ({ part: "axis", number, values: [] })),
});
const contact = { axis: 1, type: "home", index: 1, from: 0, active_low: false, connected: true };
const path: CardPath = {
  crd: 1,
  axes: [3, 1, 2],
  points: [
    [30, 10, 20],
    [33, 11, 22],
  ],
  whole: true,
};

test.each([
  ["two axes", four, 2, true],
  ["two axes, one with a switch", { ...four, switches: [contact] }, 2, false],
  ["three axes", four, 3, false],
  ["axes of a coordinate system", { ...four, switches: [contact], paths: [path] }, 4, true],
  ["a path of one axis", { ...four, paths: [{ ...path, axes: [1] }] }, 4, false],
  [
    "a scenario that wants a table",
    { ...four, view: { ...four.view, kind: "xy" as const } },
    4,
    true,
  ],
  [
    "a scenario that wants stages",
    { ...four, view: { ...four.view, kind: "stages" as const } },
    2,
    false,
  ],
])("%s: is it a table", (_, shown, count, expected) => {
  expect(isTable(shown, axesOf(shown).slice(0, count))).toBe(expected);
});

test.each([
  ["the first two", four, [1, 2, undefined]],
  ["those of a coordinate system", { ...four, paths: [path] }, [3, 1, 2]],
  [
    "those that the scenario names",
    { ...four, paths: [path], view: { ...four.view, kind: "xy" as const, x: 4, y: 3 } },
    [4, 3, undefined],
  ],
])("the axes of a table are %s", (_, shown, expected) => {
  const { x, y, z } = tableAxes(shown, axesOf(shown)) ?? {};
  expect([x?.axis, y?.axis, z?.axis]).toEqual(expected);
});

test("there is no table of one axis", () => {
  expect(tableAxes(four, axesOf(four).slice(0, 1))).toBeUndefined();
});

test("the path of a coordinate system leads a table on", () => {
  const [one, two, three] = axesOf(four);
  if (!one || !two || !three) throw new Error("the card has four axes");
  expect(aheadOf([path], { x: one, y: three })).toEqual([
    [10, 30],
    [11, 33],
  ]);
  expect(aheadOf([{ ...path, axes: [3, 4] }], { x: one, y: two })).toEqual([]);
});

test("both axes of a table have the scale of the longer one", () => {
  expect(sameScale({ least: -5, largest: 5 }, { least: 0, largest: 40 })).toEqual([
    { least: -5, largest: 35 },
    { least: 0, largest: 40 },
  ]);
});

test("an axis on the bus has its drive", () => {
  const values = [
    { name: "state", path: "drive2.state", value: 4 },
    { name: "mode", path: "drive2.mode", value: 8 },
  ];
  const parts = [...four.parts, { part: "drive", number: 2, values }];
  expect(axesOf({ ...four, parts }).map(({ drive }) => drive)).toEqual([
    undefined,
    { state: 4, mode: 8 },
    undefined,
    undefined,
  ]);
});
