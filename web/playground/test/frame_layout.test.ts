import { expect, test } from "vitest";

import {
  type Box,
  boxesOfAxes,
  inside,
  layoutOf,
  layoutOfMachine,
  layoutOfScope,
  layoutOfTable,
} from "../src/video/layout.js";

const frame = { left: 0, top: 0, width: 1280, height: 720 };

function isIn(inner: Box, outer: Box): boolean {
  const tolerance = 1e-9;
  return (
    inner.left >= outer.left - tolerance &&
    inner.top >= outer.top - tolerance &&
    inner.left + inner.width <= outer.left + outer.width + tolerance &&
    inner.top + inner.height <= outer.top + outer.height + tolerance
  );
}

function isApart(one: Box, other: Box): boolean {
  const tolerance = 1e-9;
  return (
    one.left + one.width <= other.left + tolerance ||
    other.left + other.width <= one.left + tolerance ||
    one.top + one.height <= other.top + tolerance ||
    other.top + other.height <= one.top + tolerance
  );
}

const counts = [1, 2, 4, 5, 8, 16, 32];

test.each(counts.flatMap((axes) => [0, 1, 3, 16, 40].map((curves) => [axes, curves] as const)))(
  "everything has its place: %d axes, %d curves",
  (axes, curves) => {
    const { machine, scope } = layoutOf(axes, false, 8, curves);
    expect(isIn(machine, frame)).toBe(true);
    const { axes: box, lamps } = layoutOfMachine(8, machine);
    expect(isIn(box, inside(machine))).toBe(true);
    for (const [index, lamp] of lamps.entries()) {
      expect(isIn(lamp, machine)).toBe(true);
      for (const other of [box, ...lamps.slice(index + 1)]) expect(isApart(lamp, other)).toBe(true);
    }
    const boxes = boxesOfAxes(axes, box);
    expect(boxes).toHaveLength(axes);
    for (const [index, its] of boxes.entries()) {
      expect(isIn(its, box)).toBe(true);
      expect(its.height).toBeGreaterThanOrEqual(axes > 4 ? 20 : 80);
      for (const other of boxes.slice(index + 1)) expect(isApart(its, other)).toBe(true);
    }
    expect(scope === undefined).toBe(curves === 0);
    if (!scope) return;
    expect(isIn(scope, frame)).toBe(true);
    expect(isApart(machine, scope)).toBe(true);
    const { cards, screen } = layoutOfScope(curves, inside(scope));
    expect(screen.height).toBeGreaterThan(150);
    for (const card of cards) {
      expect(isIn(card, inside(scope))).toBe(true);
      expect(isApart(card, screen)).toBe(true);
      expect(card.height).toBeGreaterThanOrEqual(12);
    }
    expect(cards.length).toBeGreaterThanOrEqual(Math.min(curves, 10));
  },
);

test("a table has one scale for both axes, and a bed in which a thin figure has room", () => {
  const box = { left: 0, top: 0, width: 1048, height: 324 };
  const square = layoutOfTable({ least: 0, largest: 100 }, { least: -50, largest: 50 }, box);
  expect(square).toMatchObject({
    scale: 3,
    bed: { left: 0, top: 0, width: 324, height: 324 },
    field: { left: 12, top: 12, width: 300, height: 300 },
    rest: { left: 356, width: 692 },
  });
  // 500 pixels for 200 units.
  const wide = layoutOfTable({ least: 0, largest: 200 }, { least: 0, largest: 100 }, box);
  expect(wide).toMatchObject({ scale: 2.5, field: { width: 500, height: 250, top: 37 } });
  const thin = layoutOfTable({ least: 0, largest: 900 }, { least: 0, largest: 10 }, box);
  expect(thin.field.height / thin.field.width).toBeCloseTo(1 / 3);
  expect(thin.scale).toBeCloseTo(500 / 900);
});
