// What the cells of the table say, and where its arrow is. Tested by test/cells.test.ts.

import type { Interleaving, InterleavingRow, ValueRead, ValueWritten } from "@oncard/engine";

/** A row that stands for statements. */
export type StatementRow = Extract<InterleavingRow, { step: number }>;

export function isStatementRow(row: InterleavingRow): row is StatementRow {
  return row.kind !== "time" && row.kind !== "host";
}

/** The row with a step; undefined where no row stands for it. */
export function rowOf(rows: readonly InterleavingRow[], step: number): StatementRow | undefined {
  return rows.filter(isStatementRow).find(({ step: first, last }) => first <= step && step <= last);
}

/** `5`, `5–7`. */
export function numberOf({ step, last }: StatementRow): string {
  return step === last ? String(step) : `${step}–${last}`;
}

/** The shared variables that the rows touch, in their order. */
export function sharedNames(rows: readonly InterleavingRow[]): string[] {
  const names = rows.flatMap((row) => [...readsOf(row), ...writesOf(row)]);
  return [...new Set(names.filter(({ shared }) => shared).map(({ name }) => name))];
}

export function readsOf(row: InterleavingRow): ValueRead[] {
  return row.kind === "step" ? (row.reads ?? []) : [];
}

export function writesOf(row: InterleavingRow): ValueWritten[] {
  return row.kind === "step" || row.kind === "repeat" ? (row.writes ?? []) : [];
}

/** What the statement made of its thread's own variables. */
export function madeBy(row: InterleavingRow): ValueWritten[] {
  return writesOf(row).filter(({ shared }) => !shared);
}

/** Whether it reads or writes a shared variable. */
export function touchesShared(row: InterleavingRow): boolean {
  return [...readsOf(row), ...writesOf(row)].some(({ shared }) => shared);
}

/** What happened to shared variables: writes, or where there is none, reads. */
export function inMemory(row: InterleavingRow): { writes: ValueWritten[]; reads: ValueRead[] } {
  const writes = writesOf(row).filter(({ shared }) => shared);
  const reads = writes.length > 0 ? [] : readsOf(row).filter(({ shared }) => shared);
  return { writes, reads };
}

/** Whether the step writes over a value that its thread has not seen. */
export function isLostWrite({ stale }: Interleaving, step: number): boolean {
  return stale?.kind === "overwrites" && stale.use === step;
}

/**
 * The longest part between two rows in which a thread's column is empty: the rows from one index up to
 * another, without that one. Undefined if there is none.
 */
export function emptyPart(
  rows: readonly InterleavingRow[],
  thread: number,
  from: number,
  to: number,
): [number, number] | undefined {
  let best: [number, number] | undefined;
  let begin = from + 1;
  for (let index = begin; index <= to; ++index) {
    const row = rows[index];
    const isEmpty =
      index < to &&
      row !== undefined &&
      isStatementRow(row) &&
      row.thread !== undefined &&
      row.thread !== thread &&
      !("fatal" in row);
    if (isEmpty) continue;
    if (index > begin && (!best || index - begin > best[1] - best[0])) best = [begin, index];
    begin = index + 1;
  }
  return best;
}
