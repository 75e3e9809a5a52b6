// How wide the reader has made the columns of each layout. It is kept in this browser.
// Tested by test/places.test.ts.

import { effect } from "@preact/signals";

import { keep, kept } from "./keep.js";
import { isKeptPlaces, type KeptPlaces } from "./kept_schema.js";
import { salvaged } from "./salvaged.js";
import { slice } from "./slice.js";

export const sides = ["left", "right"] as const;
export type Side = (typeof sides)[number];

/** Parts of the page that the columns have; one that is missing is as wide as the layout wants it. */
export type Widths = Partial<Record<Side, number>>;

const [{ places }, change] = slice<{ places: KeptPlaces }>({ places: {} });

export function widthsOf(layout: string): Widths {
  return places.value[layout] ?? {};
}

export function widen(layout: string, side: Side, part: number): void {
  change({ places: { ...places.peek(), [layout]: { ...widthsOf(layout), [side]: part } } });
}

/** The column is as wide as the layout wants it. */
export function resetWidth(layout: string, side: Side): void {
  const widths = Object.entries(widthsOf(layout)).filter(([name]) => name !== side);
  change({ places: { ...places.peek(), [layout]: Object.fromEntries(widths) } });
}

/** All columns of the layout are. */
export function resetWidths(layout: string): void {
  const others = Object.entries(places.peek()).filter(([name]) => name !== layout);
  change({ places: Object.fromEntries(others) });
}

/** Takes the widths that were kept, and keeps those that are chosen from now on. */
export function keepPlaces(): void {
  change({ places: salvaged(isKeptPlaces, kept("places")) ?? {} });
  effect(() => {
    keep("places", places.value);
  });
}
