// What is shown of a program beside what it becomes: the rows of its last good text, if it has mistakes.
// Tested by test/two_columns.test.ts.

import type { TwoColumns, TwoColumnsRow } from "@oncard/engine";

export interface Shown {
  /** Another one has nothing to do with the rows. */
  program: string;
  rows: readonly TwoColumnsRow[];
  /** As the card's own C, a program becomes nothing else. */
  state: "fresh" | "broken" | "plain";
}

/** @param answer undefined if the engine has refused to look at the program */
export function shownAfter(
  before: Shown | undefined,
  program: string,
  answer: TwoColumns | undefined,
): Shown {
  if (answer?.rows) return { program, rows: answer.rows, state: "fresh" };
  if (answer?.compiled) return { program, rows: [], state: "plain" };
  return { program, rows: before?.program === program ? before.rows : [], state: "broken" };
}
