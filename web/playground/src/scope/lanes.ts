// The lanes of digital channels, below the curves.
// Tested by test/lanes.test.ts.

import type { Channel } from "@oncard/engine";

/** How high a lane is, in pixels. */
export const laneHeight = 22;
/** Above the higher level and below the lower one. */
const laneRoom = { above: 5, below: 3 };

/** How much colour there is below the higher level. */
const tint = 0.15;

/** Parts in a row in which a channel is the same: low, high, or both of them. */
export interface Run {
  begin: number;
  end: number;
  level: 0 | 1 | "both";
}

export function runsOf({ least, largest }: Channel): Run[] {
  const runs: Run[] = [];
  least.forEach((low, index) => {
    const level = low !== largest[index] ? "both" : low === 0 ? 0 : 1;
    const last = runs.at(-1);
    if (last?.level === level) last.end = index + 1;
    else runs.push({ begin: index, end: index + 1, level });
  });
  return runs;
}

/**
 * Draws a lane: a step from level to level, tinted where it is high. Parts with both levels are filled, so
 * that no pulse is lost.
 * @param top of the lane
 * @param xOf where a part begins
 * @param ratio pixels of the canvas in one of the page
 */
export function drawLane(
  context: CanvasRenderingContext2D,
  runs: Run[],
  top: number,
  xOf: (part: number) => number,
  ratio: number,
  colour: string,
): void {
  const high = top + laneRoom.above * ratio;
  const low = top + (laneHeight - laneRoom.below) * ratio;
  context.save();
  context.strokeStyle = colour;
  context.fillStyle = colour;
  context.lineWidth = 1.5 * ratio;
  const line = new Path2D();
  runs.forEach(({ begin, end, level }, index) => {
    const from = xOf(begin);
    const to = xOf(end);
    if (level !== 0) {
      context.globalAlpha = level === 1 ? tint : 1;
      context.fillRect(from, high, to - from, low - high);
    }
    const y = level === 0 ? low : high;
    if (index === 0) line.moveTo(from, y);
    else line.lineTo(from, y);
    line.lineTo(to, y);
  });
  context.globalAlpha = 1;
  context.stroke(line);
  context.restore();
}
