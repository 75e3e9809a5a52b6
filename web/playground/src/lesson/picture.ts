// The small picture of a sample: what tools/record_samples.js has recorded, and where it is drawn.
// Tested by test/picture.test.ts.

/** In hundredths of what there is, in equal steps of time. */
export type Picture =
  | { kind: "path" | "axes"; axes: number[][] }
  /** Thread, from, to. */
  | { kind: "threads"; turns: [number, number, number][] };

export const width = 128;
export const height = 60;

/** Where a hundredth is drawn on a rail or a lane. */
export function across(value: number): number {
  return 14 + value;
}

/** The points of a path: one scale for both axes, upwards as on the table. */
export function pointsOf([xs = [], ys = []]: number[][]): [number, number][] {
  return xs.map((x, index) => [39 + x / 2, 55 - (ys[index] ?? 0) / 2]);
}

/** Which part of its length a path has at each of its points. */
export function partsOf(points: [number, number][]): number[] {
  let length = 0;
  const lengths = points.map(([x, y], index) => {
    const [beforeX, beforeY] = points[index - 1] ?? [x, y];
    length += Math.hypot(x - beforeX, y - beforeY);
    return length;
  });
  return lengths.map((each) => (length > 0 ? each / length : 1));
}
