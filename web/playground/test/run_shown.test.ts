import { expect, test } from "vitest";

import type { AxisView } from "../src/machine/axes.js";
import { carriageOf, curvesOf, isMoving, lampsOf, partAt, shownAxis } from "../src/video/run.js";

const view: AxisView = {
  axis: 2,
  position: 12_000,
  actual: 12_000,
  velocity: 0,
  positionUnit: "pulse",
  velocityUnit: "pulse/ms",
  servoOn: true,
  moving: false,
  alarm: false,
  followingError: false,
  positiveLimit: false,
  negativeLimit: false,
  home: false,
  switches: [],
};
const trace = { name: "axis2.prfPos", least: [0, 0, 4000], largest: [0, 4000, 12_000] };

test("an axis is where it was at the ends of the parts, on a stage that reaches as far", () => {
  const axis = shownAxis(view, "Axis 2", trace);
  expect(axis.positions).toEqual([0, 4000, 12_000]);
  expect(axis.reach).toEqual({ least: 0, largest: 20_000 });
});

test("an axis moves where the next part ends elsewhere, and at the end as the card says", () => {
  const axis = shownAxis(view, "Axis 2", { ...trace, least: [0, 0, 0], largest: [0, 0, 9] });
  expect([0, 1, 2].map((part) => isMoving(axis, part))).toEqual([false, true, false]);
  expect(isMoving({ ...axis, moving: true }, 2)).toBe(true);
});

const pins = new Map(
  [
    { name: "limit_positive[2]", least: [0, 0, 1], largest: [0, 1, 1] },
    { name: "gpo[3]", least: [0, 0, 0], largest: [0, 1, 1] },
    { name: "gpo[4]", least: [0, 0, 0], largest: [0, 0, 0] },
  ].map((each) => [each.name, each]),
);

test("a stage reaches as far as its switches, which are what they were at the ends of the parts", () => {
  const limit = { type: "limit_positive", index: 2, place: 30_000, on: true };
  const home = { type: "home", index: 2, place: -500, on: false };
  const axis = shownAxis({ ...view, switches: [limit, home] }, "Axis 2", trace, pins);
  expect(axis.switches).toEqual([
    { place: 30_000, on: [false, true, true] },
    { place: -500, on: [] },
  ]);
  expect(axis.reach.least).toBeLessThanOrEqual(-500);
  expect(axis.reach.largest).toBeGreaterThanOrEqual(30_000);
});

test("lamps are the pins that the machine names, or the outputs that were on", () => {
  const gpo = { name: "gpo", value: 0, pins: 16, kind: "output" as const };
  const look = { title: "", kind: "auto" as const, x: 0, y: 0, z: 0, turn: 0, pins: [] };
  const valve = { type: "gpo", index: 4, name: "Valve" };
  expect(lampsOf({ view: { ...look, pins: [valve] }, words: [gpo] }, pins)).toEqual([
    { name: "Valve", on: [false, false, false] },
  ]);
  expect(lampsOf({ view: look, words: [gpo] }, pins)).toEqual([
    { name: "DO 3", on: [false, true, false] },
  ]);
});

test("a carriage shows the encoder of its axis, if there is one", () => {
  const names = new Set(["axis1.prfPos", "axis2.prfPos", "axis2.encPos"]);
  expect([1, 2].map((axis) => carriageOf(axis, names))).toEqual(["axis1.prfPos", "axis2.encPos"]);
});

test("curves are those of the scope, with their values and what a division is", () => {
  const settings = [
    { name: "gone", offset: 0 },
    { name: "axis2.prfPos", offset: -1 },
  ];
  const units = new Map([["axis2.prfPos", "pulse"]]);
  const curves = curvesOf([trace], settings, units, 6, (each) => `${each} per division`);
  expect(curves).toHaveLength(1);
  // Three divisions are left for 12 000.
  expect(curves[0]).toMatchObject({
    place: 1,
    name: "axis2.prfPos",
    scale: "5000 pulse per division",
    values: [0, 4000, 12_000],
  });
  expect(curves[0]?.line.map(([time]) => time)).toEqual([0, 1, 2, 3, 4, 5]);
  const divisions = [-1, -1, -1, -0.2, -0.2, 1.4];
  curves[0]?.line.forEach(([, at], index) => {
    expect(at).toBeCloseTo(divisions[index] ?? NaN, 9);
  });
});

test.each([
  [0, 0],
  [0.1, 0],
  [2.5, 0],
  [2.6, 1],
  [10, 3],
])("at %d of 10 ms in four parts it is part %d", (timeMs, part) => {
  expect(partAt(timeMs, 10, 4)).toBe(part);
});
