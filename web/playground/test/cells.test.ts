import type { Interleaving, InterleavingRow } from "@oncard/engine";
import { expect, test } from "vitest";

import {
  emptyPart,
  inMemory,
  isLostWrite,
  isStatementRow,
  madeBy,
  numberOf,
  rowOf,
  sharedNames,
  touchesShared,
} from "../src/interleaving/cells.js";

const sum = (value: string) => ({ name: "sum", value, shared: true });
const step = (number: number, thread: number, more: object = {}): InterleavingRow => ({
  kind: "step",
  step: number,
  last: number,
  thread,
  line: 1,
  ...more,
});
const gap = (from: number, last: number, thread: number): InterleavingRow => ({
  kind: "gap",
  step: from,
  last,
  thread,
});
const time: InterleavingRow = { kind: "time", ms: 0.25 };

const read = step(1, 0, {
  reads: [sum("0")],
  writes: [{ name: "copy", before: "0", after: "7", shared: false }],
});
const write = step(6, 0, {
  reads: [sum("1"), { name: "copy", value: "7", shared: false }],
  writes: [{ name: "sum", before: "1", after: "2", shared: true }],
});
const rows = [read, step(2, 1, { fatal: true }), gap(3, 5, 1), time, write];

test("a step has the row that stands for it", () => {
  expect(rowOf(rows, 1)).toBe(read);
  expect(rowOf(rows, 4)).toBe(rows[2]);
  expect(rowOf(rows, 7)).toBeUndefined();
});

test("rows have the numbers of their steps", () => {
  expect(rows.filter(isStatementRow).map(numberOf)).toEqual(["1", "2", "3–5", "6"]);
});

test("a write says more than the read before it", () => {
  expect(inMemory(read)).toEqual({ writes: [], reads: [sum("0")] });
  expect(inMemory(write)).toEqual({
    writes: [{ name: "sum", before: "1", after: "2", shared: true }],
    reads: [],
  });
});

test("what a statement made of its own variables stands beside it", () => {
  expect(madeBy(read).map(({ name }) => name)).toEqual(["copy"]);
  expect(madeBy(write)).toEqual([]);
});

test("shared variables are named once", () => {
  expect(sharedNames(rows)).toEqual(["sum"]);
  expect(rows.map(touchesShared)).toEqual([true, false, false, false, true]);
});

test("only a write over what was not seen is lost", () => {
  const stale = { name: "sum", value: "0", changed: "1", read: 1, write: 4, use: 6 };
  const run = (kind: "overwrites" | "computes"): Interleaving => ({
    reason: "",
    threads: [],
    skipped: 0,
    rows,
    stale: { ...stale, kind },
  });
  expect(isLostWrite(run("overwrites"), 6)).toBe(true);
  expect(isLostWrite(run("overwrites"), 1)).toBe(false);
  expect(isLostWrite(run("computes"), 6)).toBe(false);
});

test("words go where the column is empty: no band, and no statement of the thread", () => {
  const long = [read, ...[2, 3, 4].map((each) => step(each, 1)), time, gap(5, 5, 1), write];
  expect(emptyPart(long, 0, 0, 6)).toEqual([1, 4]);
  expect(emptyPart(rows, 0, 0, 4)).toEqual([2, 3]);
  expect(emptyPart([read, write], 0, 0, 1)).toBeUndefined();
});
