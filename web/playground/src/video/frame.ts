// One frame: the title, the clock, the machine at a time, and below it the whole run in the scope.

import { footHeight, frameHeight, frameWidth, headHeight, layoutOf, margin } from "./layout.js";
import type { Look } from "./look.js";
import { paintMachine } from "./paint_machine.js";
import { paintScope } from "./paint_scope.js";
import { Pen } from "./pen.js";
import type { ShownRun } from "./run.js";

const panelRadius = 12;
const titleSize = 28;
const clockSize = 28;
/** What the clock takes of the head. */
const clockWidth = 240;

/**
 * @param note of the whole video, in the corner below
 */
export function paintFrame(
  context: CanvasRenderingContext2D,
  run: ShownRun,
  timeMs: number,
  look: Look,
  note = "",
): void {
  const pen = new Pen(context, look);
  pen.fill({ left: 0, top: 0, width: frameWidth, height: frameHeight }, look.ground);
  paintHead(pen, run, timeMs);
  const { machine, scope } = layoutOf(
    run.axes.length,
    run.isTable,
    run.lamps.length,
    run.curves.length,
  );
  pen.fill(machine, look.surface, panelRadius);
  paintMachine(pen, run, timeMs, machine);
  if (scope) {
    pen.fill(scope, look.surface, panelRadius);
    paintScope(pen, run, timeMs, scope);
  }
  const foot = frameHeight - footHeight / 2;
  pen.write(note, [margin, foot], { size: 14, colour: look.muted });
  pen.write("oncard", [frameWidth - margin, foot], { size: 16, weight: 700, align: "right" });
}

function paintHead(pen: Pen, { title }: ShownRun, timeMs: number): void {
  const middle = headHeight / 2;
  const right = frameWidth - margin;
  const most = right - margin - clockWidth;
  pen.write(title, [margin, middle], { size: titleSize, weight: 700, most });
  const unit = pen.write("ms", [right, middle + 3], {
    size: 16,
    colour: pen.look.muted,
    align: "right",
  });
  const time = [right - unit - 6, middle] as const;
  const width = pen.write(timeMs.toFixed(2), time, {
    size: clockSize,
    weight: 700,
    align: "right",
  });
  pen.dot([time[0] - width - 16, middle], 6, pen.look.now);
}
