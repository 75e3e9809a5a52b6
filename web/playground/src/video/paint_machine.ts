// The machine of a frame: a table with its trail and its axes, or a stage or row for each axis; below
// them its lamps.

import { placeOn, positionNumber, trailOf } from "../machine/axes.js";
import { number } from "../texts/number.js";
import { type Box, boxesOfAxes, hasStages, layoutOfMachine, layoutOfTable } from "./layout.js";
import { channelOf } from "./look.js";
import type { Pen } from "./pen.js";
import { isMoving, partAt, type ShownAxis, type ShownRun } from "./run.js";

export function paintMachine(pen: Pen, run: ShownRun, timeMs: number, panel: Box): void {
  const { axes, endMs, isTable } = run;
  const part = partAt(timeMs, endMs, axes[0]?.positions.length ?? 1);
  const places = layoutOfMachine(run.lamps.length, panel);
  const [x, y] = axes;
  const box = isTable && x && y ? paintTable(pen, [x, y], part, places.axes) : places.axes;
  const boxes = boxesOfAxes(axes.length, box);
  axes.forEach((axis, index) => {
    const its = boxes[index];
    if (!its) return;
    if (hasStages(axes.length)) paintStage(pen, axis, part, its);
    else paintRow(pen, axis, part, its);
  });
  run.lamps.forEach(({ name, on }, index) => {
    const its = places.lamps[index];
    if (its) paintLamp(pen, name, on[part] ?? false, its);
  });
}

const lampRadius = 6;

function paintLamp(pen: Pen, name: string, isOn: boolean, box: Box): void {
  const { look } = pen;
  const middle = box.top + box.height - 2 * lampRadius;
  const at = [box.left + lampRadius, middle] as const;
  pen.dot(at, lampRadius, isOn ? look["now-line"] : look["metal-3"]);
  pen.dot(at, lampRadius - 1.5, isOn ? look.now : look.surface);
  const text = [box.left + 3 * lampRadius, middle] as const;
  pen.write(name, text, { size: 14, most: box.width - 4 * lampRadius });
}

const quarters = [0, 0.25, 0.5, 0.75, 1];
const toolRadius = 7;

/** Returns what is left of the box. */
function paintTable(pen: Pen, axes: [ShownAxis, ShownAxis], part: number, box: Box): Box {
  const { look } = pen;
  const [x, y] = axes;
  const { bed, field, scale, rest } = layoutOfTable(x.reach, y.reach, box);
  const bottom = bed.top + bed.height;
  const right = bed.left + bed.width;
  pen.fill(bed, look["metal-2"]);
  pen.fill(
    { left: bed.left + 1, top: bed.top + 1, width: bed.width - 2, height: bed.height - 2 },
    look.bed,
  );
  for (const each of quarters) {
    const [across, down] = [field.left + each * field.width, field.top + each * field.height];
    pen.line([across, bed.top], [across, bottom], look.line);
    pen.line([bed.left, down], [right, down], look.line);
  }
  const way = x.positions
    .slice(0, part + 1)
    .map(
      (at, index) =>
        [
          field.left + (at - x.reach.least) * scale,
          field.top + field.height - ((y.positions[index] ?? 0) - y.reach.least) * scale,
        ] as const,
    );
  const tool = way.at(-1) ?? ([bed.left, bottom] as const);
  pen.line([tool[0], bed.top], [tool[0], bottom], look["metal-2"], 5);
  for (const { part: piece, opacity } of trailOf(way)) {
    pen.context.globalAlpha = opacity;
    pen.polyline(piece, look.ink, 2);
  }
  pen.context.globalAlpha = 1;
  if (isMoving(x, part) || isMoving(y, part)) {
    pen.dot(tool, toolRadius + 1.5, look["now-line"]);
    pen.dot(tool, toolRadius, look.now);
  } else {
    pen.dot(tool, toolRadius, look.ink);
  }
  return rest;
}

function colourOf(pen: Pen, { axis }: ShownAxis): string {
  return channelOf(pen.look, axis - 1);
}

/** Its position; its unit ends there. */
function writePosition(
  pen: Pen,
  { positions, unit }: ShownAxis,
  part: number,
  [right, middle]: readonly [number, number],
  size: number,
): void {
  const small = Math.round(size * 0.7);
  const width = pen.write(unit, [right, middle + (size - small) / 3], {
    size: small,
    colour: pen.look.muted,
    align: "right",
  });
  const text = positionNumber({ position: positions[part] ?? 0, positionUnit: unit });
  pen.write(text, [right - width - 5, middle], { size, weight: 700, align: "right" });
}

/** Of a stage: what stands left and right of the places of the carriage. */
const stageLeft = 56;
const stageRight = 46;
const marks = Array.from({ length: 11 }, (_, index) => index / 10);

/** Name and position, and below them the carriage on its rail with a scale. */
function paintStage(pen: Pen, axis: ShownAxis, part: number, box: Box): void {
  const { look } = pen;
  const { left, top, width } = box;
  const right = left + width;
  pen.write(axis.name, [left, top + 12], { size: 16, weight: 600 });
  writePosition(pen, axis, part, [right, top + 12], 18);
  const rail = top + 44;
  const onRail = (place: number) => left + stageLeft + place * (width - stageLeft - stageRight);
  const at = onRail(placeOn(axis.reach, axis.positions[part] ?? 0));
  pen.fill({ left, top: rail - 15, width: 26, height: 26 }, look["metal-3"], 4);
  const { context } = pen;
  // The screw turns with the position.
  context.setLineDash([2, 2]);
  context.lineDashOffset = -(at % 4);
  pen.line([left + 26, rail - 2], [right - 6, rail - 2], look["metal-3"], 7);
  context.setLineDash([]);
  pen.fill({ left: left + 26, top: rail + 5, width: width - 26, height: 8 }, look["metal-2"]);
  pen.fill({ left: right - 6, top: rail - 16, width: 6, height: 29 }, look["metal-2"], 1);
  marks.forEach((place, index) => {
    const x = onRail(place);
    const isLong = index % 2 === 0;
    pen.line([x, rail + 16], [x, rail + (isLong ? 22 : 19)], look["metal-3"]);
    if (!isLong) return;
    const { least, largest } = axis.reach;
    const text = number(least + place * (largest - least), 1);
    pen.write(text, [x, rail + 31], { size: 12, colour: look.muted, align: "center" });
  });
  for (const { place, on } of axis.switches) {
    paintSwitch(pen, onRail(placeOn(axis.reach, place)), rail, on[part] ?? false);
  }
  const colour = colourOf(pen, axis);
  pen.line([at, rail + 10], [at, rail + 22], colour, 2);
  pen.fill({ left: at - 22, top: rail - 17, width: 44, height: 28 }, colour, 4);
  context.globalAlpha = 0.5;
  pen.line([at - 14, rail - 7], [at + 14, rail - 7], look.surface);
  pen.line([at - 14, rail + 1], [at + 14, rail + 1], look.surface);
  context.globalAlpha = 1;
}

function paintSwitch(pen: Pen, at: number, rail: number, isOn: boolean): void {
  const { look } = pen;
  const edge = isOn ? look["now-line"] : look["metal-3"];
  pen.line([at, rail - 17], [at, rail + 5], look["metal-3"]);
  pen.fill({ left: at - 5, top: rail - 26, width: 10, height: 9 }, edge, 2);
  pen.fill(
    { left: at - 3.5, top: rail - 24.5, width: 7, height: 6 },
    isOn ? look.now : look.surface,
    1,
  );
}

/** Of a row: its name and its position stand at its ends. */
const nameWidth = 84;
const positionWidth = 150;

function paintRow(pen: Pen, axis: ShownAxis, part: number, box: Box): void {
  const { look } = pen;
  const { left, top, width, height } = box;
  const middle = top + height / 2;
  const size = Math.min(15, height * 0.8);
  pen.write(axis.name, [left, middle], { size, weight: 600, most: nameWidth });
  writePosition(pen, axis, part, [left + width, middle], size);
  const rail = { left: left + nameWidth, width: width - nameWidth - positionWidth };
  pen.fill({ ...rail, top: middle - 2, height: 4 }, look["metal-2"], 2);
  const at = rail.left + 7 + placeOn(axis.reach, axis.positions[part] ?? 0) * (rail.width - 14);
  const carriage = Math.min(16, height * 0.7);
  const its = { left: at - 7, top: middle - carriage / 2, width: 14, height: carriage };
  pen.fill(its, colourOf(pen, axis), 3);
}
