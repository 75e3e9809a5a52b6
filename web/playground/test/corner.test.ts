import { expect, test } from "vitest";

import { emptiestCorner } from "../src/scope/corner.js";

/** A scale of one unit a division, so that the screen reaches from -4 to 4. */
const v = { name: "v", perDivision: 1, offset: 0, isDigital: false };
/** A fifth of the screen, each way. */
const size = { width: 0.2, height: 0.2 };
/** Ten parts of the time, over all of the screen. */
const of = (values: number[], toMs = 10) => ({
  fromMs: 0,
  toMs,
  endMs: 10,
  channels: [{ name: "v", least: values, largest: values }],
});

test.each([
  { values: [0, 0, 0, 0, 0, 0, 0, 0, 0, 0], corner: "top right" },
  { values: [-4, -3, -2, -1, 0, 1, 2, 3, 4, 4], corner: "top left" },
  { values: [4, 4, 3, 2, 1, 0, -1, -2, -3, -4], corner: "top right" },
  { values: [3, 3, 3, 3, 3, 3, 3, 3, 3, 3], corner: "bottom right" },
  { values: [3, 3, 3, 3, 3, 3, 3, 3, 3, -3], corner: "bottom left" },
  // One part is covered there, and two everywhere else.
  { values: [-3, -3, 0, 0, 0, 0, 0, 0, 3, -3], corner: "top left" },
])("beside a curve of $values stands $corner", ({ values, corner }) => {
  expect(emptiestCorner(of(values), [v], size)).toBe(corner);
});

test("the extremes of a part count, and so does the zero of a channel", () => {
  const spike = { name: "v", least: Array(10).fill(0), largest: [0, 0, 0, 0, 0, 0, 0, 0, 0, 4] };
  const sweep = { ...of([]), channels: [spike] };
  expect(emptiestCorner(sweep, [v], size)).toBe("top left");
  expect(emptiestCorner(sweep, [{ ...v, offset: -2 }], size)).toBe("top right");
});

test("behind the present there is nothing to cover", () => {
  const high = [3, 3, 3, 3, 3, 3, 3, 3, 3, 3];
  expect(emptiestCorner(of(high, 20), [v], size, "top left")).toBe("top right");
});

test("lanes and channels without values cover nothing", () => {
  const high = of([3, 3, 3, 3, 3, 3, 3, 3, 3, 3]);
  expect(emptiestCorner(high, [{ ...v, isDigital: true }], size)).toBe("top right");
  expect(emptiestCorner(high, [{ ...v, name: "gone" }], size)).toBe("top right");
});

test("it stays where it is until another corner has more room", () => {
  const flat = of([0, 0, 0, 0, 0, 0, 0, 0, 0, 0]);
  expect(emptiestCorner(flat, [v], size, "bottom left")).toBe("bottom left");
  const falls = of([0, 0, 0, 0, 0, 0, 0, 0, 0, -4]);
  expect(emptiestCorner(falls, [v], size, "bottom right")).toBe("top right");
});
