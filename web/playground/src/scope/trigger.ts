// The trigger of the scope: the first place where a channel crosses a level.
// Tested by test/trigger.test.ts.

import type { Channel } from "@oncard/engine";

export type Edge = "rising" | "falling" | "either";

/** The time that the screen shows. */
export interface TimeWindow {
  fromMs: number;
  toMs: number;
}

/** Values in equal parts of the time from the beginning of the screen to `endMs`. */
export interface Sweep extends TimeWindow {
  /** The present, where it lies within the screen. */
  endMs: number;
  channels: Channel[];
}

export interface Trigger {
  source: string;
  level: number;
  edge: Edge;
}

/** How long each of so many parts of the sweep is, in ms. */
export function partWidth({ fromMs, endMs }: Sweep, parts: number): number {
  return (endMs - fromMs) / Math.max(1, parts);
}

/**
 * When the source first crosses the level at or after a time; undefined if it does not. A spike within
 * one part crosses it, too.
 */
export function triggerTime(
  sweep: Sweep,
  trigger: Trigger,
  afterMs = -Infinity,
): number | undefined {
  const channel = sweep.channels.find(({ name }) => name === trigger.source);
  if (!channel) return undefined;
  const { least, largest } = channel;
  const { level, edge } = trigger;
  const parts = least.length;
  const width = partWidth(sweep, parts);
  for (let index = 0; index < parts; ++index) {
    const begin = sweep.fromMs + index * width;
    if (begin < afterMs) continue;
    const low = least[index] ?? 0;
    const high = largest[index] ?? 0;
    const lowBefore = least[index - 1] ?? low;
    const highBefore = largest[index - 1] ?? high;
    const rises = high >= level && Math.min(lowBefore, low) < level;
    const falls = low <= level && Math.max(highBefore, high) > level;
    if ((edge !== "falling" && rises) || (edge !== "rising" && falls)) return begin;
  }
  return undefined;
}

/** The window of a triggered sweep: `before` of it, from 0 to 1, lies before the trigger. */
export function windowAround(timeMs: number, spanMs: number, before: number): TimeWindow {
  const fromMs = Math.max(0, timeMs - spanMs * before);
  return { fromMs, toMs: fromMs + spanMs };
}
