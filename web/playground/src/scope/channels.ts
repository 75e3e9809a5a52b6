// The channels of the scope: which values can be shown, how they are scaled, and what is read at
// cursors. Tested by test/channels.test.ts.

import type { Card, Channel, Variable } from "@oncard/engine";

import { roundUp } from "../machine/axes.js";
import { number } from "../texts/number.js";
import { levelOfPin, pinNames } from "./digital.js";
import { partWidth, type Sweep } from "./trigger.js";

/** A channel as the reader has set it. */
export interface Setting {
  name: string;
  /** Units per division; undefined: as large as fits. */
  perDivision?: number;
  /** Divisions upwards. */
  offset: number;
}

/** A channel as it is drawn. */
export interface Drawn extends Setting {
  /** Only 0 and 1: it has a lane instead of a scale. */
  isDigital: boolean;
}

/** Divisions above and below the middle. */
export const divisions = 4;

/** Names that `trace` understands: variables, values of the card, and pins of its words. */
export function channelNames(card: Card | undefined, variables: Variable[]): string[] {
  return [
    ...variables.flatMap(({ path, value }) =>
      Array.isArray(value) ? value.slice(0, 16).map((_, index) => `${path}[${index}]`) : [path],
    ),
    ...(card?.parts ?? []).flatMap(({ values }) => values.map(({ path }) => path)),
    ...pinNames(card, variables),
  ];
}

/** The present value of a channel. */
export function valueNow(
  card: Card | undefined,
  variables: Variable[],
  name: string,
): number | undefined {
  const values = [...variables, ...(card?.parts ?? []).flatMap((part) => part.values)];
  const valueOf = (wanted: string) => values.find(({ path }) => path === wanted)?.value;
  const element = /^(.*)\[(\d+)\]$/.exec(name);
  const value = valueOf(element?.[1] ?? name);
  if (value === undefined) return levelOfPin(name, card, variables);
  return typeof value === "object" ? value[Number(element?.[2])] : value;
}

/** In what the values of the card are measured, by the names of their channels. */
export type Units = ReadonlyMap<string, string>;

export function unitsOf(card: Card | undefined): Units {
  const values = (card?.parts ?? []).flatMap((part) => part.values);
  return new Map(values.flatMap(({ path, unit }) => (unit === undefined ? [] : [[path, unit]])));
}

/** A channel with its unit, as traces name it: `axis1.prfPos [mm]`. */
export function titleOf(name: string, units: Units): string {
  const unit = units.get(name);
  return unit === undefined ? name : `${name} [${unit}]`;
}

export function extremes({ least, largest }: Channel): { least: number; largest: number } {
  let low = Infinity;
  let high = -Infinity;
  for (const value of least) low = Math.min(low, value);
  for (const value of largest) high = Math.max(high, value);
  return Number.isFinite(low) ? { least: low, largest: high } : { least: 0, largest: 0 };
}

/** Units per division: those that are set, or with which the channel fits. */
export function unitsPerDivision(setting: Setting, channel: Channel): number {
  if (setting.perDivision !== undefined && setting.perDivision > 0) return setting.perDivision;
  const { least, largest } = extremes(channel);
  const room = divisions - Math.min(Math.abs(setting.offset), divisions - 1);
  return roundUp(Math.max(Math.abs(least), Math.abs(largest)) / room);
}

/** Where a value is drawn, in divisions from the middle. */
export function inDivisions(value: number, perDivision: number, offset: number): number {
  return value / perDivision + offset;
}

/** A level is set in steps of this part of a division. */
const levelStep = 1 / 20;

/** The value at a place of the screen, in divisions from the middle, to the nearest step of a level. */
export function valueAt(at: number, perDivision: number, offset: number): number {
  const steps = Math.round((at - offset) / levelStep);
  return Number((steps * levelStep * perDivision).toPrecision(12));
}

/** The values of a channel at every second division, from below; the others stay empty for room. */
export function valuesAtDivisions(sweep: Sweep, setting: Drawn | undefined): string[] {
  const channel = sweep.channels.find(({ name }) => name === setting?.name);
  return Array.from({ length: 2 * divisions + 1 }, (_, index) => {
    if (!setting || setting.isDigital || !channel || index % 2 !== 0) return "";
    return number((index - divisions - setting.offset) * unitsPerDivision(setting, channel));
  });
}

/**
 * The lines of the screen: times, and for each channel its places in divisions. At the time of each part
 * there are its least and its largest value, so that no spike is lost. Lanes have none.
 */
export function envelope(sweep: Sweep, drawn: Drawn[]): [number[], ...(number | null)[][]] {
  const parts = sweep.channels[0]?.least.length ?? 0;
  const width = partWidth(sweep, parts);
  const times: number[] = [];
  for (let index = 0; index < parts; ++index) {
    const begin = sweep.fromMs + index * width;
    times.push(begin, begin + width / 2);
  }
  const lines = drawn.map((setting) => {
    const channel = sweep.channels.find(({ name }) => name === setting.name);
    if (!channel || setting.isDigital) return times.map(() => null);
    const per = unitsPerDivision(setting, channel);
    return channel.least.flatMap((low, index) => {
      const high = channel.largest[index] ?? low;
      const rises = (channel.least[index - 1] ?? low) <= low;
      const pair = rises ? [low, high] : [high, low];
      return pair.map((value) => inDivisions(value, per, setting.offset));
    });
  });
  return [times, ...lines];
}

/** What the picture says of each channel: its name and, of a curve, how much a division is. */
export function legendOf(sweep: Sweep, drawn: Drawn[], units: Units): string[] {
  return drawn.map((setting) => {
    const channel = sweep.channels.find(({ name }) => name === setting.name);
    if (!channel || setting.isDigital) return setting.name;
    const unit = units.get(setting.name);
    const per = number(unitsPerDivision(setting, channel), 6);
    return `${setting.name}: ${per}${unit === undefined ? "" : ` ${unit}`}/div`;
  });
}

/** The values of a channel in the part of the sweep that contains a time. */
export function readingAt(
  sweep: Sweep,
  name: string,
  timeMs: number,
): { least: number; largest: number } | undefined {
  const channel = sweep.channels.find((each) => each.name === name);
  if (!channel || timeMs < sweep.fromMs || timeMs > sweep.endMs) return undefined;
  const parts = channel.least.length;
  const part = Math.floor((timeMs - sweep.fromMs) / partWidth(sweep, parts));
  const index = Math.min(parts - 1, part);
  const low = channel.least[index];
  const high = channel.largest[index];
  return low === undefined || high === undefined ? undefined : { least: low, largest: high };
}

/** The values as a table: a row for each part, with the least and the largest value of each channel. */
export function csvOf(sweep: Sweep, units: Units): string {
  const titles = sweep.channels.map(({ name }) => titleOf(name, units));
  const head = titles.flatMap((title) => [`${title} min`, `${title} max`]);
  const parts = sweep.channels[0]?.least.length ?? 0;
  const width = partWidth(sweep, parts);
  const rows = Array.from({ length: parts }, (_, index) => [
    Number((sweep.fromMs + index * width).toFixed(6)),
    ...sweep.channels.flatMap(({ least, largest }) => [least[index] ?? "", largest[index] ?? ""]),
  ]);
  return [["time [ms]", ...head], ...rows].map((row) => `${row.join(",")}\n`).join("");
}
