import { expect, test } from "vitest";

import { triggerTime, windowAround } from "../src/scope/trigger.js";

/** Ten parts of a millisecond each. */
const sweep = {
  fromMs: 100,
  toMs: 120,
  endMs: 110,
  channels: [
    {
      name: "ramp",
      least: [0, 1, 2, 3, 4, 5, 4, 3, 2, 1],
      largest: [0, 1, 2, 3, 4, 5, 4, 3, 2, 1],
    },
    { name: "spike", least: Array(10).fill(0), largest: [0, 0, 0, 9, 0, 0, 0, 0, 0, 0] },
    { name: "flat", least: Array(10).fill(7), largest: Array(10).fill(7) },
  ],
};

test.each([
  ["ramp", 2.5, "rising", 103],
  ["ramp", 2.5, "falling", 108],
  ["ramp", 2.5, "either", 103],
  ["ramp", 5, "rising", 105],
  ["ramp", 5, "falling", undefined], // it only touches the level
  ["ramp", 6, "either", undefined],
  ["spike", 5, "rising", 103], // within one part
  ["flat", 7, "either", undefined],
  ["nothing", 0, "either", undefined],
] as const)("%s at %d, %s", (source, level, edge, time) => {
  expect(triggerTime(sweep, { source, level, edge })).toBe(time);
});

test("a later trigger is found from a time on", () => {
  const trigger = { source: "ramp", level: 2.5, edge: "either" } as const;
  expect(triggerTime(sweep, trigger, 104)).toBe(108);
  expect(triggerTime(sweep, trigger, 109)).toBeUndefined();
});

test("a part of the window lies before the trigger", () => {
  expect(windowAround(500, 200, 0.25)).toEqual({ fromMs: 450, toMs: 650 });
  expect(windowAround(10, 200, 0.25)).toEqual({ fromMs: 0, toMs: 200 });
});
