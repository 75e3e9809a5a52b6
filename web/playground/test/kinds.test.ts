// Where the parts of rotary tables and conveyors are.

import { expect, test } from "vitest";

import { placesOnBelt } from "../src/machine/conveyor.js";
import { degreesOf } from "../src/machine/rotary.js";

test.each([
  [0, 0],
  [2500, 90],
  [10_000, 0],
  [12_500, 90],
  [-2500, 270],
])("a table that turns once in 10 000 is, at %d, at %d degrees", (position, degrees) => {
  expect(degreesOf(position, 10_000)).toBe(degrees);
});

test.each([
  [0, [0, 40, 80]],
  [10, [10, 50, 90]],
  [25, [25, 65]],
  [85, [5, 45, 85]],
  [-10, [30, 70]],
])("things 40 apart on a belt of 100 that has gone %d", (gone, places) => {
  expect(placesOnBelt(gone, 40, 100)).toEqual(places);
});
