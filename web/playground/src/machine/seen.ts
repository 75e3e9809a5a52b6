// Which axes the machine view shows, and how far their stages reach: what has been seen of a run. It
// is a value without functions, so that it can be sent.
// Tested by test/seen.test.ts.

import type { Card } from "@oncard/engine";

import { axesOf, type AxisView, grownTo, isUsed, type Reach } from "./axes.js";

export interface Seen {
  used: readonly number[];
  /** By the numbers of axes. */
  reaches: Readonly<Record<number, Reach>>;
}

const nothing: Seen = { used: [], reaches: {} };

/** With the card as it is now; without what has been seen before, at the start of a run. */
export function seenOf(card: Card, before: Seen = nothing): Seen {
  const used = new Set(before.used);
  const reaches = { ...before.reaches };
  for (const axis of axesOf(card)) {
    if (isUsed(axis)) used.add(axis.axis);
    reaches[axis.axis] = grownTo(reaches[axis.axis], [axis.position], axis.positionUnit);
  }
  return { used: [...used], reaches };
}

/** Those that have been used, are `named` or belong to the machine; otherwise the first. */
export function axesShown(card: Card, { used }: Seen, named: readonly number[] = []): AxisView[] {
  const { kind, x, y, z } = card.view;
  const numbers = new Set([...used, ...named, ...(kind === "xy" ? [x, y, z] : [])]);
  if (numbers.size === 0) numbers.add(1);
  return axesOf(card).filter(({ axis }) => numbers.has(axis));
}
