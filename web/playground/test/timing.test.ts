import { expect, test } from "vitest";

import { speedOf, timeShown, videoLength } from "../src/video/timing.js";

test.each([
  ["a cycle", 0.25, 3000],
  ["one that just needs no stretching", 1900, 3000],
  ["one as fast as the card", 6122.5, 7222.5],
  ["one that just needs no compressing", 8900, 10_000],
  ["an hour", 3_600_000, 10_000],
])("the video of a run is 3 to 10 s long: %s", (_, runMs, lengthMs) => {
  expect(videoLength(runMs)).toBe(lengthMs);
});

test.each([
  [950, 0.5],
  [1900, 1],
  [6122.5, 1],
  [89_000, 10],
])("the video of %d ms is %d times as fast as the card", (runMs, speed) => {
  expect(speedOf(runMs)).toBeCloseTo(speed, 9);
});

test("a video holds the start of the run for 0.4 s, and its end for 0.7 s", () => {
  expect(timeShown(0, 89_000)).toBe(0);
  expect(timeShown(400, 89_000)).toBe(0);
  expect(timeShown(4850, 89_000)).toBeCloseTo(44_500, 6);
  expect(timeShown(9299, 89_000)).toBeLessThan(89_000);
  expect(timeShown(9301, 89_000)).toBe(89_000);
  expect(timeShown(10_000, 89_000)).toBe(89_000);
});
