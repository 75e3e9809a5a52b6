import { expect, test } from "vitest";

import { perMs, readingOf } from "../src/scope/readings.js";

/** Four parts of 10 ms; the last ones are behind the present. */
const sweep = {
  fromMs: 0,
  toMs: 60,
  endMs: 40,
  channels: [
    { name: "v", least: [0, 5, 10, 10], largest: [5, 10, 20, 10] },
    { name: "gpo[1]", least: [0, 0, 1, 1], largest: [0, 1, 1, 1] },
  ],
};
const curve = { name: "v", offset: 0, isDigital: false };
const lane = { name: "gpo[1]", offset: 0, isDigital: true };

test.each([
  { channel: curve, cursors: [5, 25], reading: { texts: ["5", "20"], gain: 15, slope: 0.75 } },
  { channel: curve, cursors: [25, 5], reading: { texts: ["20", "5"], gain: -15, slope: 0.75 } },
  { channel: curve, cursors: [5, 5], reading: { texts: ["5", "5"], gain: 0 } },
  { channel: curve, cursors: [5, 50], reading: { texts: ["5", ""] } },
  { channel: lane, cursors: [5, 25], reading: { texts: ["0", "1"] } },
  { channel: lane, cursors: [15, 50], reading: { texts: ["0…1", ""] } },
])("of $channel.name at $cursors", ({ channel, cursors, reading }) => {
  const [a = 0, b = 0] = cursors;
  expect(readingOf(sweep, channel, [a, b])).toEqual(reading);
});

test.each([
  ["pulse", "pulse/ms"],
  ["pulse/ms", "pulse/ms²"],
  ["pulse/ms²", "pulse/ms³"],
  ["mm/s", "mm/s/ms"],
  [undefined, "1/ms"],
])("%s in a millisecond is %s", (unit, slope) => {
  expect(perMs(unit)).toBe(slope);
});
