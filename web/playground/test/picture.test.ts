import { expect, test } from "vitest";

import { partsOf, pointsOf } from "../src/lesson/picture.js";

test("a path goes upwards, with one scale for both axes", () => {
  const [from, to] = pointsOf([
    [0, 100],
    [0, 100],
  ]);
  expect([from, to]).toEqual([
    [39, 55],
    [89, 5],
  ]);
});

test("a path is drawn as fast as it was travelled, and not where it rested", () => {
  const path: [number, number][] = [
    [0, 0],
    [3, 4],
    [3, 4],
    [3, 19],
  ];
  expect(partsOf(path)).toEqual([0, 0.25, 0.25, 1]);
  expect(partsOf([[1, 1]])).toEqual([1]);
});
