// Which corner of the screen has the most room. Tested by test/corner.test.ts.

import { divisions, type Drawn, inDivisions, unitsPerDivision } from "./channels.js";
import { partWidth, type Sweep } from "./trigger.js";

/** In this order where they have the same room. */
const corners = ["top right", "top left", "bottom right", "bottom left"] as const;
export type Corner = (typeof corners)[number];

/** As parts of the screen's width, and of the height of its divisions. */
interface Size {
  width: number;
  height: number;
}

/** Where a curve is in a part of the time: from the left edge, and from the upper one. */
interface Piece {
  at: number;
  top: number;
  bottom: number;
}

function piecesOf(sweep: Sweep, curve: Drawn): Piece[] {
  const channel = sweep.channels.find(({ name }) => name === curve.name);
  if (!channel) return [];
  const per = unitsPerDivision(curve, channel);
  const fromTop = (value: number) =>
    (divisions - inDivisions(value, per, curve.offset)) / (2 * divisions);
  const width = partWidth(sweep, channel.least.length) / (sweep.toMs - sweep.fromMs);
  return channel.least.map((low, index) => ({
    at: (index + 0.5) * width,
    top: fromTop(channel.largest[index] ?? low),
    bottom: fromTop(low),
  }));
}

function isIn(corner: Corner, { at, top, bottom }: Piece, { width, height }: Size): boolean {
  const isBeside = corner.endsWith("left") ? at < width : at > 1 - width;
  return isBeside && (corner.startsWith("top") ? top < height : bottom > 1 - height);
}

/**
 * The corner in which something of this size covers the least of the curves.
 * @param before where it stands: it goes elsewhere only for more room
 */
export function emptiestCorner(
  sweep: Sweep,
  drawn: Drawn[],
  size: Size,
  before: Corner = corners[0],
): Corner {
  const pieces = drawn
    .filter(({ isDigital }) => !isDigital)
    .flatMap((curve) => piecesOf(sweep, curve));
  const covered = (corner: Corner) => pieces.filter((piece) => isIn(corner, piece, size)).length;
  return corners.reduce(
    (best, corner) => (covered(corner) < covered(best) ? corner : best),
    before,
  );
}
