import type { Card } from "@oncard/engine";
import { expect, test } from "vitest";

import { axesShown, seenOf } from "../src/machine/seen.js";
import { cardWith } from "./card.js";

/** A card whose axes are at these positions. */
function cardAt(...positions: number[]): Card {
  const parts = positions.map((value, index) => {
    const name = "prfPos";
    const path = `axis${index + 1}.${name}`;
    return { part: "axis", number: index + 1, values: [{ name, path, value, unit: "pulse" }] };
  });
  return cardWith({ parts });
}

function shown(...args: Parameters<typeof axesShown>): number[] {
  return axesShown(...args).map(({ axis }) => axis);
}

test("an axis that has been used stays, also where it is at zero again", () => {
  const home = cardAt(0, 0, 0);
  const seen = seenOf(home, seenOf(cardAt(0, 500, 0)));
  expect(shown(home, seen)).toEqual([2]);
  expect(shown(home, seenOf(home))).toEqual([1]); // nothing is used: the first
});

test("the axes of a table belong to the machine from the start", () => {
  const card = cardAt(0, 0, 0, 0);
  const view = { ...card.view, kind: "xy", x: 3, y: 1 } as const;
  expect(shown({ ...card, view }, seenOf(card))).toEqual([1, 3]);
  expect(shown({ ...card, view: { ...view, z: 4 } }, seenOf(card))).toEqual([1, 3, 4]);
});

test("axes that are named are shown from the start", () => {
  const card = cardAt(0, 7, 0);
  expect(shown(card, seenOf(card), [3])).toEqual([2, 3]);
});

test("a stage reaches as far as its axis has ever been", () => {
  const far = seenOf(cardAt(-30, 40_000));
  const back = seenOf(cardAt(0, 0), far);
  expect(back.reaches).toEqual({
    1: { least: -50, largest: 10_000 },
    2: { least: 0, largest: 50_000 },
  });
});

test("what has been seen can be sent", () => {
  const seen = seenOf(cardAt(1, 2));
  expect(JSON.parse(JSON.stringify(seen))).toEqual(seen);
});
