// Where the parts of a frame are, in its pixels.
// Tested by test/frame_layout.test.ts.

import { mostStages, type Reach } from "../machine/axes.js";

export interface Box {
  left: number;
  top: number;
  width: number;
  height: number;
}

export const frameWidth = 1280;
export const frameHeight = 720;

/** From the edges of the frame to its panels, and of these to what they hold. */
export const margin = 24;
export const padding = 20;
const gap = 8;
export const headHeight = 76;
export const footHeight = 40;

const stageHeight = 88;
const rowHeight = 28;
const lampHeight = 24;
/** The lamps stand so far from the edge of their panel, and take so much of what it holds. */
const lampMargin = 8;
const lampsTake = lampHeight + lampMargin - padding;
const columnGap = 32;
/** The machine leaves this height for the scope. */
const leastScope = 224;

export interface FrameLayout {
  machine: Box;
  /** Only if the scope shows channels. */
  scope?: Box;
}

/** The machine is as high as its axes and its lamps need, the scope takes the rest. */
export function layoutOf(
  axes: number,
  isTable: boolean,
  lamps: number,
  curves: number,
): FrameLayout {
  const all = {
    left: margin,
    top: headHeight,
    width: frameWidth - 2 * margin,
    height: frameHeight - headHeight - footHeight,
  };
  if (curves === 0) return { machine: all };
  const most = all.height - gap - leastScope;
  const needed = axes > mostStages ? Math.ceil(axes / 2) * rowHeight : axes * stageHeight;
  const below = lamps > 0 ? lampsTake : 0;
  const height = isTable ? most : Math.min(most, needed + below + 2 * padding);
  const top = all.top + height + gap;
  const scope = { ...all, top, height: all.top + all.height - top };
  return { machine: { ...all, height }, scope };
}

/** The inner part of a panel. */
export function inside({ left, top, width, height }: Box): Box {
  return {
    left: left + padding,
    top: top + padding,
    width: width - 2 * padding,
    height: height - 2 * padding,
  };
}

/** Few lamps stand as close as so many. */
const leastLamps = 4;

/** What is left for the axes in the machine's panel, and a box for each lamp in a row below. */
export function layoutOfMachine(lamps: number, panel: Box): { axes: Box; lamps: Box[] } {
  const all = inside(panel);
  if (lamps === 0) return { axes: all, lamps: [] };
  const height = all.height - lampsTake;
  const width = all.width / Math.max(lamps, leastLamps);
  return {
    axes: { ...all, height },
    lamps: Array.from({ length: lamps }, (_, index) => ({
      left: all.left + index * width,
      top: all.top + height,
      width,
      height: lampHeight,
    })),
  };
}

/** Whether each axis has a stage; otherwise a row. */
export function hasStages(axes: number): boolean {
  return axes <= mostStages;
}

/** The boxes of the axes, below each other in the middle of a box; many stand in columns. */
export function boxesOfAxes(axes: number, { left, top, width, height }: Box): Box[] {
  const wanted = hasStages(axes) ? stageHeight : rowHeight;
  const inColumn = hasStages(axes) ? axes : Math.max(1, Math.floor(height / wanted));
  const columns = Math.ceil(axes / inColumn);
  const rows = Math.ceil(axes / columns);
  const each = Math.min(wanted, height / rows);
  const first = top + (height - rows * each) / 2;
  const columnWidth = (width - (columns - 1) * columnGap) / columns;
  return Array.from({ length: axes }, (_, index) => ({
    left: left + Math.floor(index / rows) * (columnWidth + columnGap),
    top: first + (index % rows) * each,
    width: columnWidth,
    height: each,
  }));
}

/** A table whose sides differ more is drawn wider on its short side, not distorted. */
const longestSide = 3;
/** The most of the width of the machine that the table takes. */
const tablePart = 0.5;
/** The tool does not reach the edge of the bed. */
const bedEdge = 12;

export interface TableLayout {
  bed: Box;
  /** What the tool reaches. */
  field: Box;
  /** Pixels for each unit of both axes. */
  scale: number;
  /** What is left for the axes. */
  rest: Box;
}

/** The table at the left of a box: both axes have one scale. */
export function layoutOfTable(x: Reach, y: Reach, box: Box): TableLayout {
  const [spanX, spanY] = [x.largest - x.least, y.largest - y.least];
  const sideX = Math.max(spanX, spanY / longestSide);
  const sideY = Math.max(spanY, spanX / longestSide);
  const room = [box.width * tablePart - 2 * bedEdge, box.height - 2 * bedEdge] as const;
  const scale = Math.min(room[0] / sideX, room[1] / sideY);
  const [width, height] = [sideX * scale, sideY * scale];
  const field = {
    left: box.left + bedEdge,
    top: box.top + (box.height - height) / 2,
    width,
    height,
  };
  const bed = {
    left: box.left,
    top: field.top - bedEdge,
    width: width + 2 * bedEdge,
    height: height + 2 * bedEdge,
  };
  const taken = bed.width + columnGap;
  return {
    bed,
    field,
    scale,
    rest: { ...box, left: box.left + taken, width: box.width - taken },
  };
}

/** The list of the channels, with so much place for each, and the screen with its scale below. */
export interface ScopeLayout {
  cards: Box[];
  screen: Box;
}

const listWidth = 290;
const cardHeight = 44;
const leastCard = 18;
const scaleHeight = 22;
/** At the right there is room for half of the last time. */
const scaleEdge = 16;

/** Channels for which there is no place have no card, but their curves. */
export function layoutOfScope(curves: number, box: Box): ScopeLayout {
  const place = Math.min(curves, Math.floor(box.height / leastCard));
  const height = Math.min(cardHeight, box.height / Math.max(1, place));
  const cards = Array.from({ length: place }, (_, index) => ({
    left: box.left,
    top: box.top + index * height,
    width: listWidth,
    height,
  }));
  const left = box.left + listWidth + columnGap;
  const width = box.left + box.width - scaleEdge - left;
  return { cards, screen: { left, top: box.top, width, height: box.height - scaleHeight } };
}
