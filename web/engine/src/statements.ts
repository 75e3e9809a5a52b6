// Where the statements of a run are among its moments. Tested by test/statements.test.ts.

import type { Turn } from "./protocol.js";

/** A statement that was executed. */
export interface Executed {
  thread: number;
  /** That after it. */
  moment: number;
}

/** The statements of the turns, in their order. */
export function statementsOf(turns: readonly Turn[]): Executed[] {
  return turns.flatMap(({ moment, thread, statements }) =>
    Array.from({ length: statements }, (_, index) => ({ thread, moment: moment + index + 1 })),
  );
}

/** How many statements were executed at a moment. */
export function executedAt(statements: readonly Executed[], moment: number): number {
  let from = 0;
  let to = statements.length;
  while (from < to) {
    const middle = (from + to) >> 1;
    if ((statements[middle]?.moment ?? 0) <= moment) from = middle + 1;
    else to = middle;
  }
  return from;
}
