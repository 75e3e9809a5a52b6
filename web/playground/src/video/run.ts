// What the frames of a run show, from traces of it.
// Tested by test/run_shown.test.ts.

import type { Card, Channel, MachineLook } from "@oncard/engine";

import { type AxisView, endsOf, grownTo, type Reach } from "../machine/axes.js";
import { envelope, type Setting, type Units, unitsPerDivision } from "../scope/channels.js";
import { terminalOf } from "../machine/pins.js";
import { pinName } from "../scope/digital.js";
import { number } from "../texts/number.js";

/** From the start of the run to the present. */
export interface ShownRun {
  title: string;
  endMs: number;
  /** Those that the machine view shows. */
  axes: readonly ShownAxis[];
  /** The first two axes move a table. */
  isTable: boolean;
  /** Below the axes. */
  lamps: readonly Lamp[];
  curves: readonly Curve[];
}

/** What can only be on or off, and whether it is at the end of each part of the run. */
export interface Lamp {
  name: string;
  on: readonly boolean[];
}

export interface ShownAxis {
  axis: number;
  name: string;
  unit: string;
  /** Where it is at the end of each part of the run; the parts are equally long. */
  positions: readonly number[];
  /** At the end of the run. */
  moving: boolean;
  /** Those that the scenario has, at their places. */
  switches: readonly { place: number; on: readonly boolean[] }[];
  reach: Reach;
}

/** A channel of the scope. */
export interface Curve {
  /** Among the channels; it has the colour of its place. */
  place: number;
  name: string;
  /** What a division is. */
  scale: string;
  /** At the ends of the parts. */
  values: readonly number[];
  /** Times in ms, and divisions from the middle. */
  line: readonly (readonly [timeMs: number, division: number])[];
}

/** The channel of a trace with what a carriage shows: where the encoder is, if the axis has one. */
export function carriageOf(axis: number, names: ReadonlySet<string>): string {
  const encoder = `axis${axis}.encPos`;
  return names.has(encoder) ? encoder : `axis${axis}.prfPos`;
}

/** An axis with the trace of its position, and those of its switches by their names. */
export function shownAxis(
  { axis, positionUnit: unit, moving, switches: its }: AxisView,
  name: string,
  trace: Channel,
  pins: ReadonlyMap<string, Channel> = new Map(),
): ShownAxis {
  const positions = endsOf(trace);
  const switches = its.map(({ type, index, place }) => ({ place, on: onOf(pins, type, index) }));
  const places = [...positions, ...switches.map(({ place }) => place)];
  return { axis, name, unit, positions, moving, switches, reach: grownTo(undefined, places, unit) };
}

/** Nothing of a pin without a trace: it is off. */
function onOf(pins: ReadonlyMap<string, Channel>, type: string, index: number): boolean[] {
  const trace = pins.get(pinName(type, index));
  return trace ? endsOf(trace).map((level) => level !== 0) : [];
}

/** The pins that may become lamps: those that the machine names, without such its general outputs. */
export function lampPins({ view, words }: Pick<Card, "view" | "words">): MachineLook["pins"] {
  if (view.pins.length > 0) return view.pins;
  const outputs = words.find(({ name }) => name === "gpo")?.pins ?? 0;
  return Array.from({ length: outputs }, (_, index) => {
    const pin = { type: "gpo", index: index + 1 };
    return { ...pin, name: terminalOf(pin.type, pin.index) };
  });
}

/** More lamps have no room beside each other. */
const mostLamps = 8;

/** Outputs without a name of their own are lamps if they were on at a time. */
export function lampsOf(
  card: Pick<Card, "view" | "words">,
  pins: ReadonlyMap<string, Channel>,
): Lamp[] {
  const areNamed = card.view.pins.length > 0;
  return lampPins(card)
    .map(({ type, index, name }) => ({ name, on: onOf(pins, type, index) }))
    .filter(({ on }) => areNamed || on.includes(true))
    .slice(0, mostLamps);
}

/** Whether it moves at the end of a part. */
export function isMoving({ positions, moving }: ShownAxis, part: number): boolean {
  return part + 1 < positions.length ? positions[part + 1] !== positions[part] : moving;
}

/** The curves of the channels that have traces, as the scope draws its whole run. */
export function curvesOf(
  traces: Channel[],
  settings: Setting[],
  units: Units,
  endMs: number,
  scaleText: (units: string) => string,
): Curve[] {
  const sweep = { fromMs: 0, toMs: endMs, endMs, channels: traces };
  // Digital channels are curves among the others.
  const drawn = settings.map((setting) => ({ ...setting, isDigital: false }));
  const [times, ...lines] = envelope(sweep, drawn);
  return settings.flatMap((setting, index) => {
    const trace = traces.find(({ name }) => name === setting.name);
    if (!trace) return [];
    const unit = units.get(setting.name) ?? "";
    const per = `${number(unitsPerDivision(setting, trace), 6)} ${unit}`.trim();
    const line = times.map((time, at) => [time, lines[index]?.[at] ?? 0] as const);
    const { name } = setting;
    return [{ place: index, name, scale: scaleText(per), values: endsOf(trace), line }];
  });
}

/** Which of so many parts a time lies in. */
export function partAt(timeMs: number, endMs: number, parts: number): number {
  return Math.min(parts, Math.max(1, Math.ceil((timeMs / endMs) * parts))) - 1;
}
