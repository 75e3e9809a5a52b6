// What the reader has set at the scope, and the sweep that follows from it.

import type { Engine } from "@oncard/engine";
import { computed, effect } from "@preact/signals";

import { bench, present, session } from "../session/bench.js";
import { record } from "../session/record.js";
import { slice } from "../store/slice.js";
import { source } from "../store/source.js";
import type { Drawn, Setting } from "./channels.js";
import { isDigital } from "./digital.js";
import { type Edge, type Sweep, triggerTime, type TimeWindow, windowAround } from "./trigger.js";

export const modes = ["whole", "auto", "single", "roll"] as const;
export type Mode = (typeof modes)[number];
/** Widths of the screen in ms. */
export const spans = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000];

/** What is set with the knobs of the scope. */
interface Knobs {
  mode: Mode;
  spanMs: number;
  /** The channel of the trigger. */
  source: string;
  level: number;
  edge: Edge;
  /** Part of the screen before the trigger. */
  before: number;
}

interface Scope extends Knobs {
  channels: Setting[];
  /** The name of the channel whose knobs and scale are shown. */
  chosen: string;
  /** A single sweep takes the first trigger from this time on. */
  armedAt: number;
  /** Times of the cursors A and B in ms. */
  cursors: [number, number] | undefined;
  /** The scale of a channel that stays as it is, whatever is on the screen. */
  heldScale: HeldScale | undefined;
}

interface HeldScale {
  name: string;
  perDivision: number;
}

const [scope, change] = slice<Scope>({
  mode: "whole",
  spanMs: 1000,
  source: "",
  level: 0,
  edge: "rising",
  before: 0.25,
  channels: [],
  chosen: "",
  armedAt: 0,
  cursors: undefined,
  heldScale: undefined,
});
export { scope };

/** Whether the sweep waits for a trigger. */
export const triggers = computed(() => ["auto", "single"].includes(scope.mode.value));

/** The names of the digital channels, as one text: it stays equal while the card goes on. */
const digitalNames = computed(() => {
  const card = present.card.value;
  const variables = present.globals.value;
  const names = scope.channels.value.map(({ name }) => name);
  return JSON.stringify(names.filter((name) => isDigital(name, card, variables)));
});

/** The channels as they are drawn. */
export const drawn = computed<Drawn[]>(() => {
  const { value: held } = scope.heldScale;
  const digital = JSON.parse(digitalNames.value) as string[];
  return scope.channels.value.map((setting) => ({
    ...setting,
    ...(setting.name === held?.name && { perDivision: held.perDivision }),
    isDigital: digital.includes(setting.name),
  }));
});

/** The source of the trigger. */
export const drawnSource = computed(() =>
  drawn.value.find(({ name }) => name === scope.source.value),
);

/** A digital source crosses no other level. */
const digitalLevel = 0.5;

/** At most this many parts are searched for a trigger. */
const searchParts = 20_000;

/** Of a record, the velocities of so many axes are shown. */
const axesOfRecord = 4;

/** A lesson brings its own channels, a record those of its axes. */
effect(() => {
  const { value: opened } = record;
  const names = opened
    ? Array.from(
        { length: Math.min(opened.axes, axesOfRecord) },
        (_, index) => `axis${index + 1}.prfVel`,
      )
    : (source.lesson.value.scope ?? []);
  change({
    channels: names.map((name) => ({ name, offset: 0 })),
    chosen: names[0] ?? "",
    source: names[0] ?? "",
    cursors: undefined,
    armedAt: 0,
  });
});

export function turnKnobs(knobs: Partial<Knobs>): void {
  change(knobs);
}

/** A single sweep begins at the present. */
export function arm(): void {
  change({ armedAt: present.state.peek()?.time_ms ?? 0 });
}

export function putCursors(cursors: [number, number] | undefined): void {
  change({ cursors });
}

export function addChannel(name: string): void {
  const before = scope.channels.peek();
  if (before.some((each) => each.name === name)) return;
  change({
    channels: [...before, { name, offset: 0 }],
    chosen: name,
    source: scope.source.peek() || name,
  });
}

export function removeChannel(name: string): void {
  const channels = scope.channels.peek().filter((each) => each.name !== name);
  const first = channels[0]?.name ?? "";
  const trigger = scope.source.peek();
  const chosen = scope.chosen.peek();
  change({
    channels,
    source: trigger === name ? first : trigger,
    chosen: chosen === name ? first : chosen,
  });
}

export function chooseChannel(name: string): void {
  change({ chosen: name });
}

export function setChannel(setting: Setting): void {
  const channels = scope.channels.peek();
  change({ channels: channels.map((each) => (each.name === setting.name ? setting : each)) });
}

/**
 * A level that is dragged leads to another trigger, and so to other values. The scale under the pointer is
 * held meanwhile: otherwise each would move the other.
 */
export function holdScale(heldScale: HeldScale | undefined): void {
  change({ heldScale });
}

export function putZero(name: string, offset: number): void {
  const channels = scope.channels.peek();
  change({ channels: channels.map((each) => (each.name === name ? { ...each, offset } : each)) });
}

export interface Shown {
  sweep: Sweep;
  trigger?: number;
}

/** Everything that the sweep depends on. */
export function sweepKey(parts: number): string {
  const { time_ms: time = 0 } = present.state.value ?? {};
  return JSON.stringify([
    time,
    session.history.value,
    scope.channels.value.map(({ name }) => name),
    scope.mode.value,
    scope.spanMs.value,
    scope.source.value,
    scope.level.value,
    scope.edge.value,
    scope.before.value,
    scope.armedAt.value,
    parts,
  ]);
}

/** The values that are on the screen now. */
export async function sweepNow(parts: number): Promise<Shown> {
  const now = present.state.peek()?.time_ms ?? 0;
  const names = scope.channels.peek().map(({ name }) => name);
  const width = scope.spanMs.peek();
  const engine = await bench.engine();
  const last = { fromMs: Math.max(0, now - width), toMs: Math.max(now, width) };
  if (now === 0) return { sweep: { fromMs: 0, toMs: width, endMs: 0, channels: [] } };
  const sweepIn = (window: TimeWindow) => sweepOf(engine, names, window, now, parts);
  switch (scope.mode.peek()) {
    case "whole":
      return { sweep: await sweepIn({ fromMs: 0, toMs: now }) };
    case "roll":
      return { sweep: await sweepIn(last) };
    case "auto":
    case "single": {
      const trigger = await findTrigger(engine, now);
      if (trigger === undefined) return { sweep: await sweepIn(last) };
      const window = windowAround(trigger, width, scope.before.peek());
      return { sweep: await sweepIn(window), trigger };
    }
  }
}

/** The values in a window end at the present; so many parts would fill all of it. */
async function sweepOf(
  engine: Engine,
  names: string[],
  window: TimeWindow,
  now: number,
  parts: number,
): Promise<Sweep> {
  const { fromMs, toMs } = window;
  const endMs = Math.min(toMs, now);
  const filled = Math.max(1, Math.round((parts * (endMs - fromMs)) / (toMs - fromMs)));
  const channels = names.length === 0 ? [] : await engine.trace(names, fromMs, endMs, filled);
  return { ...window, endMs, channels };
}

/** Single: the first trigger since it was armed. Auto: the last one. */
async function findTrigger(engine: Engine, now: number): Promise<number | undefined> {
  if (scope.source.peek() === "") return undefined;
  const isSingle = scope.mode.peek() === "single";
  const fromMs = isSingle ? Math.min(scope.armedAt.peek(), now) : 0;
  const [channel] = await engine.trace([scope.source.peek()], fromMs, now, searchParts);
  if (!channel) return undefined;
  const sweep = { fromMs, toMs: now, endMs: now, channels: [channel] };
  const trigger = {
    source: scope.source.peek(),
    level: drawnSource.peek()?.isDigital ? digitalLevel : scope.level.peek(),
    edge: scope.edge.peek(),
  };
  const first = triggerTime(sweep, trigger, fromMs);
  if (isSingle || first === undefined) return first;
  let found: number = first;
  for (;;) {
    const next = triggerTime(sweep, trigger, found + scope.spanMs.peek());
    if (next === undefined) return found;
    found = next;
  }
}
