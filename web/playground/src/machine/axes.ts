// What of the card the machine view shows: the axes that are used, and how far their stages reach.
// Tested by test/axes.test.ts.

import type { Card, CardPart, CardPath, Channel } from "@oncard/engine";

import { number } from "../texts/number.js";

export interface AxisView {
  axis: number;
  /** Where the profile is: what is commanded. */
  position: number;
  /** Where the encoder says that the axis is; without one, where it is commanded to be. */
  actual: number;
  velocity: number;
  positionUnit: string;
  velocityUnit: string;
  servoOn: boolean;
  moving: boolean;
  alarm: boolean;
  followingError: boolean;
  positiveLimit: boolean;
  negativeLimit: boolean;
  home: boolean;
  /** Those that the scenario has, at their places. */
  switches: AxisSwitch[];
  /** That of an axis on the bus. */
  drive?: Drive | undefined;
}

/** A drive as CiA 402 numbers its states and modes. */
export interface Drive {
  state: number;
  mode: number;
}

export interface AxisSwitch {
  type: string;
  /** Its pin in the word of that type, from 1 on. */
  index: number;
  /** In the unit of the axis. */
  place: number;
  on: boolean;
}

/** The ends of a stage, in the unit of its axis. */
export interface Reach {
  least: number;
  largest: number;
}

/** More axes than these have a row each. */
export const mostStages = 4;

function valueOf(part: CardPart, name: string): number {
  return part.values.find((value) => value.name === name)?.value ?? 0;
}

function hasValue(part: CardPart, name: string): boolean {
  return part.values.some((value) => value.name === name);
}

function unitOf(part: CardPart, name: string): string {
  return part.values.find((value) => value.name === name)?.unit ?? "";
}

/** Whether a pin of an input or output word is set; pins count from 1. */
export function pin(card: Card, word: string, number: number): boolean {
  const value = card.words.find(({ name }) => name === word)?.value ?? 0;
  return ((value >> (number - 1)) & 1) === 1;
}

export function axesOf(card: Card): AxisView[] {
  return card.parts
    .filter(({ part }) => part === "axis")
    .map((part) => ({
      axis: part.number,
      position: valueOf(part, "prfPos"),
      actual: valueOf(part, hasValue(part, "encPos") ? "encPos" : "prfPos"),
      velocity: valueOf(part, "prfVel"),
      positionUnit: unitOf(part, "prfPos"),
      velocityUnit: unitOf(part, "prfVel"),
      servoOn: valueOf(part, "servoOn") !== 0,
      moving: valueOf(part, "moving") !== 0,
      alarm: valueOf(part, "alarm") !== 0,
      followingError: valueOf(part, "followingError") !== 0,
      positiveLimit: pin(card, "limit_positive", part.number),
      negativeLimit: pin(card, "limit_negative", part.number),
      home: pin(card, "home", part.number),
      switches: switchesOf(card, part.number),
      drive: driveOf(card, part.number),
    }));
}

function driveOf(card: Card, axis: number): Drive | undefined {
  const drive = card.parts.find(({ part, number }) => part === "drive" && number === axis);
  return drive && { state: valueOf(drive, "state"), mode: valueOf(drive, "mode") };
}

function switchesOf(card: Card, axis: number): AxisSwitch[] {
  return card.switches.flatMap(({ axis: its, type, index, from, to }) => {
    const place = from ?? to;
    if (its !== axis || place === undefined) return [];
    return [{ type, index, place, on: pin(card, type, index) }];
  });
}

/** Whether a program has done something with an axis. */
export function isUsed({ position, velocity, servoOn, moving }: AxisView): boolean {
  return servoOn || moving || position !== 0 || velocity !== 0;
}

/** Axes that are named by channels such as `axis2.prfVel`. */
export function axesNamed(channels: string[]): number[] {
  return channels.flatMap((name) => {
    const axis = /^axis(\d+)\./.exec(name)?.[1];
    return axis === undefined ? [] : [Number(axis)];
  });
}

/** 1, 2 or 5 times a power of ten that is not less. */
export function roundUp(value: number): number {
  if (!(value > 0) || !Number.isFinite(value)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  const factor = [1, 2, 5, 10].find((each) => each * power >= value * (1 - 1e-9)) ?? 10;
  return factor * power;
}

/** How far a stage reaches at first, in the unit of its axis. */
export function firstReach(unit: string): Reach {
  return { least: 0, largest: unit === "pulse" ? 10_000 : 100 };
}

/** The reach that also contains some positions: stages grow, they never shrink. */
export function grownTo(
  reach: Reach | undefined,
  positions: readonly number[],
  unit: string,
): Reach {
  const first = reach ?? firstReach(unit);
  const least = Math.min(...positions);
  const largest = Math.max(...positions);
  return {
    least: least < first.least ? -roundUp(-least) : first.least,
    largest: largest > first.largest ? roundUp(largest) : first.largest,
  };
}

/** Both reaches as long as the longer one, so that a figure is not distorted. */
export function sameScale(x: Reach, y: Reach): [Reach, Reach] {
  const length = Math.max(x.largest - x.least, y.largest - y.least);
  const longer = ({ least }: Reach) => ({ least, largest: least + length });
  return [longer(x), longer(y)];
}

/** Axes that move a table together. */
export interface TableAxes {
  x: AxisView;
  y: AxisView;
  z?: AxisView | undefined;
}

/** Those that the scenario names or a coordinate system has; otherwise the first two. */
export function tableAxes(card: Card, axes: readonly AxisView[]): TableAxes | undefined {
  const [x, y, z] = numbersOfTable(card, axes).map((wanted) =>
    axes.find(({ axis }) => axis === wanted),
  );
  return x && y && { x, y, z };
}

function numbersOfTable({ view, paths }: Card, axes: readonly AxisView[]): number[] {
  if (view.kind === "xy") return [view.x, view.y, view.z];
  return pathOf(paths)?.axes.slice(0, 3) ?? axes.slice(0, 2).map(({ axis }) => axis);
}

function pathOf(paths: readonly CardPath[]): CardPath | undefined {
  return paths.find(({ axes }) => axes.length > 1);
}

/** Whether the machine is a table as long as its reader has not chosen. */
export function isTable({ view, paths }: Card, axes: readonly AxisView[]): boolean {
  if (view.kind !== "auto") return view.kind === "xy";
  // Two axes with switches of their own are rather two stages than a table.
  const isPair = axes.length === 2 && axes.every(({ switches }) => switches.length === 0);
  return pathOf(paths) !== undefined || isPair;
}

/** Where the coordinate system of a table goes on. */
export function aheadOf(paths: readonly CardPath[], { x, y }: TableAxes): Place[] {
  const path = paths.find(({ axes }) => axes.includes(x.axis) && axes.includes(y.axis));
  if (!path) return [];
  const [indexX, indexY] = [x, y].map(({ axis }) => path.axes.indexOf(axis));
  return path.points.map((point) => [point[indexX ?? 0] ?? 0, point[indexY ?? 0] ?? 0]);
}

/** A position without its unit: of pulses, a tenth is enough. */
export function positionNumber({
  position,
  positionUnit,
}: Pick<AxisView, "position" | "positionUnit">): string {
  return number(position, positionUnit === "pulse" ? 1 : 3);
}

export function positionText(axis: AxisView): string {
  return `${positionNumber(axis)} ${axis.positionUnit}`;
}

/** Of each part of a trace the least and the largest value. */
type Range = Pick<Channel, "least" | "largest">;

/** A place on the table of two axes. */
export type Place = readonly [x: number, y: number];

/** The way of two axes, one place for each part of their traces. */
export function wayOf([x, y]: readonly Range[]): Place[] {
  if (!x || !y) return [];
  const tops = endsOf(y);
  return endsOf(x).map((value, index) => [value, tops[index] ?? 0]);
}

/**
 * The values at the ends of the parts of a trace: of each part the one further away from where it began.
 * Both axes of a table then are where they were at the same time, and straight lines are straight.
 */
export function endsOf({ least, largest }: Range): number[] {
  const [first = 0, second = first] = least;
  let before = second < first ? (largest[0] ?? first) : first;
  return largest.map((high, index) => {
    const low = least[index] ?? high;
    before = high - before >= before - low ? high : low;
    return before;
  });
}

/** A trail has so many shades, from the oldest one, which is the palest, to ink. */
const shades = 8;
const palest = 0.28;

/** The parts of a way, each with how dark it is; a part begins where the one before ends. */
export function trailOf<Point>(way: readonly Point[]): { part: Point[]; opacity: number }[] {
  const lines = way.length - 1;
  const count = Math.min(shades, lines);
  return Array.from({ length: Math.max(0, count) }, (_, index) => ({
    part: way.slice(
      Math.round((index * lines) / count),
      Math.round(((index + 1) * lines) / count) + 1,
    ),
    opacity: 1 - ((1 - palest) * (count - 1 - index)) / Math.max(1, count - 1),
  }));
}

/** Where a position is on its stage, from 0 to 1. */
export function placeOn({ least, largest }: Reach, position: number): number {
  return (position - least) / (largest - least);
}
