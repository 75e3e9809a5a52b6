// How wide the reader has made the columns of each layout, how high its panels, which columns are
// closed, and which panel fills the page. It is kept in this browser.
// Tested by test/places.test.ts.

import { effect } from "@preact/signals";

import { type ColumnName, columns } from "./arrangement.js";
import { keep, kept } from "./keep.js";
import { isKeptPlaces, type KeptPlaces } from "./kept_schema.js";
import type { Panel } from "./layout.js";
import { salvaged } from "./salvaged.js";
import { slice } from "./slice.js";

export const sides = ["left", "right"] as const;
export type Side = (typeof sides)[number];

/** What is missing is as the layout wants it. */
export type Places = KeptPlaces[string];
/** A panel that can fill the page. */
export type WholePanel = NonNullable<Places["whole"]>;

/** What is closed until the reader opens it. */
const closedAtFirst: Record<string, readonly ColumnName[]> = { free: ["left"] };

const [{ places }, change] = slice<{ places: KeptPlaces }>({ places: {} });

export function placesOf(layout: string): Places {
  return places.value[layout] ?? {};
}

function put<Name extends keyof Places>(
  layout: string,
  name: Name,
  value: Places[Name] | undefined,
): void {
  const others = Object.entries(placesOf(layout)).filter(([each]) => each !== name);
  const own = value === undefined ? others : [...others, [name, value]];
  change({ places: { ...places.peek(), [layout]: Object.fromEntries(own) as Places } });
}

/** Gives a column a part of the page; undefined: as wide as the layout wants it. */
export function widen(layout: string, side: Side, part: number | undefined): void {
  put(layout, side, part);
}

/** Gives a panel a part of its column; undefined: as high as the layout wants it. */
export function heighten(layout: string, panel: Panel, part: number | undefined): void {
  const others = Object.entries(placesOf(layout).heights ?? {}).filter(([name]) => name !== panel);
  const heights: [string, number][] = part === undefined ? others : [...others, [panel, part]];
  put(layout, "heights", heights.length > 0 ? Object.fromEntries(heights) : undefined);
}

export function closedIn(layout: string): readonly ColumnName[] {
  return placesOf(layout).closed ?? closedAtFirst[layout] ?? [];
}

/** Closes a column, unless it is the last one that is open. */
export function closeColumn(layout: string, column: ColumnName): void {
  putClosed(layout, [...closedIn(layout), column]);
}

export function openColumn(layout: string, column: ColumnName): void {
  const closed = closedIn(layout);
  if (closed.includes(column))
    putClosed(
      layout,
      closed.filter((each) => each !== column),
    );
}

function putClosed(layout: string, wished: readonly ColumnName[]): void {
  const closed = columns.filter((each) => wished.includes(each));
  if (closed.length === columns.length) return;
  const isUsual = String(closed) === String(closedAtFirst[layout] ?? []);
  put(layout, "closed", isUsual ? undefined : closed);
}

/** Lets a panel fill the page; undefined: all are shown. */
export function fillWith(layout: string, whole: WholePanel | undefined): void {
  put(layout, "whole", whole);
}

/** Everything is where the layout wants it. */
export function resetPlaces(layout: string): void {
  const others = Object.entries(places.peek()).filter(([name]) => name !== layout);
  change({ places: Object.fromEntries(others) });
}

/** Takes the places that were kept, and keeps those that are chosen from now on. */
export function keepPlaces(): void {
  change({ places: salvaged(isKeptPlaces, kept("places")) ?? {} });
  effect(() => {
    keep("places", places.value);
  });
}
