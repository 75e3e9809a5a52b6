// How handles share the edge of the screen: one that would cover another stands to the left of it.
// Tested by test/columns.test.ts.

/**
 * The column of each handle, from the edge: the first in which no earlier one is near.
 * @param heights where the handles stand
 * @param room how high a handle is
 */
export function columnsOf(heights: number[], room: number): number[] {
  const columns: number[] = [];
  heights.forEach((height, index) => {
    const near = columns.filter((_, other) => Math.abs((heights[other] ?? 0) - height) < room);
    // One of them is free.
    const choices = Array.from({ length: index + 1 }, (_, column) => column);
    columns.push(choices.find((column) => !near.includes(column)) ?? index);
  });
  return columns;
}
