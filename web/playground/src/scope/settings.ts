// What the reader has set at the scope, and the sweep that follows from it.

import type { Engine } from "@oncard/engine";
import { effect, signal } from "@preact/signals";

import { bench, lesson } from "../workspace.js";
import type { Setting } from "./channels.js";
import { type Edge, type Sweep, triggerTime, windowAround } from "./trigger.js";

export const modes = ["whole", "auto", "single", "roll"] as const;
export type Mode = (typeof modes)[number];
/** Widths of the screen in ms. */
export const spans = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000];

export const channels = signal<Setting[]>([]);
export const mode = signal<Mode>("whole");
export const spanMs = signal(1000);
export const source = signal("");
export const level = signal(0);
export const edge = signal<Edge>("rising");
/** Part of the screen before the trigger. */
export const before = signal(0.25);
/** A single sweep takes the first trigger from this time on. */
export const armedAt = signal(0);
/** Times of the cursors A and B in ms. */
export const cursors = signal<[number, number] | undefined>(undefined);

/** At most this many parts are searched for a trigger. */
const searchParts = 20_000;

/** A lesson brings its own channels. */
effect(() => {
  const names = lesson.value.scope ?? [];
  channels.value = names.map((name) => ({ name, offset: 0 }));
  source.value = names[0] ?? "";
  cursors.value = undefined;
  armedAt.value = 0;
});

export function addChannel(name: string): void {
  if (channels.value.some((each) => each.name === name)) return;
  channels.value = [...channels.value, { name, offset: 0 }];
  if (source.value === "") source.value = name;
}

export function removeChannel(name: string): void {
  channels.value = channels.value.filter((each) => each.name !== name);
  if (source.value === name) source.value = channels.value[0]?.name ?? "";
}

export function setChannel(setting: Setting): void {
  channels.value = channels.value.map((each) => (each.name === setting.name ? setting : each));
}

export interface Shown {
  sweep: Sweep;
  trigger?: number;
}

/** Everything that the sweep depends on. */
export function sweepKey(parts: number): string {
  const { time_ms: time = 0 } = bench.state.value ?? {};
  return JSON.stringify([
    time,
    bench.history.value,
    channels.value.map(({ name }) => name),
    mode.value,
    spanMs.value,
    source.value,
    level.value,
    edge.value,
    before.value,
    armedAt.value,
    parts,
  ]);
}

/** The values that are on the screen now. */
export async function sweepNow(parts: number): Promise<Shown> {
  const now = bench.state.peek()?.time_ms ?? 0;
  const names = channels.peek().map(({ name }) => name);
  const width = spanMs.peek();
  const engine = await bench.engine();
  const last = { fromMs: Math.max(0, now - width), toMs: Math.max(now, width) };
  if (now === 0) return { sweep: { fromMs: 0, toMs: width, channels: [] } };
  switch (mode.peek()) {
    case "whole":
      return { sweep: await sweepOf(engine, names, { fromMs: 0, toMs: now }, parts) };
    case "roll":
      return { sweep: await sweepOf(engine, names, last, parts) };
    case "auto":
    case "single": {
      const trigger = await findTrigger(engine, now);
      if (trigger === undefined) return { sweep: await sweepOf(engine, names, last, parts) };
      const window = windowAround(trigger, width, before.peek());
      return { sweep: await sweepOf(engine, names, window, parts), trigger };
    }
  }
}

/** A sweep ends at the present: what lies behind it has no values yet. */
async function sweepOf(
  engine: Engine,
  names: string[],
  window: { fromMs: number; toMs: number },
  parts: number,
): Promise<Sweep> {
  const known =
    names.length === 0 ? [] : await engine.trace(names, window.fromMs, window.toMs, parts);
  return { ...window, channels: known };
}

/** Single: the first trigger since it was armed. Auto: the last one. */
async function findTrigger(engine: Engine, now: number): Promise<number | undefined> {
  if (source.peek() === "") return undefined;
  const isSingle = mode.peek() === "single";
  const fromMs = isSingle ? Math.min(armedAt.peek(), now) : 0;
  const [channel] = await engine.trace([source.peek()], fromMs, now, searchParts);
  if (!channel) return undefined;
  const sweep = { fromMs, toMs: now, channels: [channel] };
  const trigger = { source: source.peek(), level: level.peek(), edge: edge.peek() };
  const first = triggerTime(sweep, trigger, fromMs);
  if (isSingle || first === undefined) return first;
  let found: number = first;
  for (;;) {
    const next = triggerTime(sweep, trigger, found + spanMs.peek());
    if (next === undefined) return found;
    found = next;
  }
}
