// The scope of a frame: the curves of the whole run, the line of now, and the channels by name.

import { roundUp } from "../machine/axes.js";
import { divisions } from "../scope/channels.js";
import { number } from "../texts/number.js";
import { type Box, inside, layoutOfScope } from "./layout.js";
import { channelOf } from "./look.js";
import type { Pen } from "./pen.js";
import { type Curve, partAt, type ShownRun } from "./run.js";

/** How much is seen of what comes after now. */
const laterOpacity = 0.38;
/** The amber of now is as wide, so that it is seen in light colours, too. */
const nowWidth = 6;
/** At most so many marks of the time. */
const mostMarks = 8;
/** Cards from this height on have a second line. */
const twoLines = 36;

export function paintScope(pen: Pen, run: ShownRun, timeMs: number, panel: Box): void {
  const { curves, endMs } = run;
  const { cards, screen } = layoutOfScope(curves.length, inside(panel));
  cards.forEach((box, index) => {
    const curve = curves[index];
    if (curve) paintCard(pen, curve, partAt(timeMs, endMs, curve.values.length), box);
  });
  paintGrid(pen, endMs, screen);
  const now = screen.left + (timeMs / endMs) * screen.width;
  const right = screen.left + screen.width;
  paintCurves(pen, run, screen, [screen.left, now], 1);
  paintCurves(pen, run, screen, [now, right], laterOpacity);
  const [top, bottom] = [screen.top - 6, screen.top + screen.height];
  pen.line([now, top], [now, bottom], pen.look.now, nowWidth);
  pen.line([now, top], [now, bottom], pen.look["now-line"], 1.5);
  pen.dot([now, top], 5, pen.look.now);
}

function paintGrid(pen: Pen, endMs: number, { left, top, width, height }: Box): void {
  const { look } = pen;
  const [right, bottom] = [left + width, top + height];
  for (let index = 0; index <= 2 * divisions; ++index) {
    const y = top + (index / (2 * divisions)) * height;
    pen.line([left, y], [right, y], look.line);
  }
  const step = roundUp(endMs / mostMarks);
  for (let mark = 0; mark * step <= endMs; ++mark) {
    const x = left + ((mark * step) / endMs) * width;
    pen.line([x, top], [x, bottom], look.line);
    const text = mark === 0 ? "0 ms" : number(mark * step, 6);
    pen.write(text, [x, bottom + 14], { size: 13, colour: look.muted, align: "center" });
  }
}

/** The curves between two places of the screen. */
function paintCurves(
  pen: Pen,
  { curves, endMs }: ShownRun,
  { left, top, width, height }: Box,
  [from, to]: readonly [number, number],
  opacity: number,
): void {
  const { context } = pen;
  const place = ([time, division]: readonly [number, number]) =>
    [
      left + (time / endMs) * width,
      top + ((divisions - division) / (2 * divisions)) * height,
    ] as const;
  context.save();
  context.beginPath();
  context.rect(from, top, to - from, height);
  context.clip();
  context.globalAlpha = opacity;
  for (const { line, place: its } of curves) {
    pen.polyline(line.map(place), channelOf(pen.look, its), 2);
  }
  context.restore();
}

/** The colour of a channel, its name, its value at a time and what a division is. */
function paintCard(pen: Pen, curve: Curve, part: number, box: Box): void {
  const { look } = pen;
  const { left, top, width, height } = box;
  const hasTwo = height >= twoLines;
  const colour = channelOf(look, curve.place);
  pen.fill({ left, top: top + 2, width: 4, height: height - 6 }, colour, 2);
  const first = top + (hasTwo ? height / 3 - 1 : height / 2 - 1);
  const size = Math.min(15, height * 0.75);
  const right = left + width;
  const value = number(curve.values[part] ?? 0);
  const taken = pen.write(value, [right, first], { size, weight: 700, colour, align: "right" });
  const text = left + 14;
  pen.write(curve.name, [text, first], { size, weight: 600, most: right - taken - 10 - text });
  if (!hasTwo) return;
  const second = top + (height * 2) / 3 + 1;
  const small = { size: 12, colour: look.muted, most: right - text };
  pen.write(curve.scale, [text, second], small);
}
