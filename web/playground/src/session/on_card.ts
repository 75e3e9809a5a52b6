// What of the source is on the card, and how it gets there.

import type { Completion, Description, Hint, SourcePlace } from "@oncard/engine";
import { computed } from "@preact/signals";

import { source } from "../store/source.js";
import { bench, present, session } from "./bench.js";
import { record, reopenRecord } from "./record.js";

/** The texts are others than those that were put onto the card. */
export const isEdited = computed(
  () => !record.value && session.project.value !== source.project.value,
);

/** What is edited is loaded before anything runs. */
export async function ready(): Promise<boolean> {
  if (!isEdited.peek() && present.state.peek()) return true;
  if (record.peek()) return reopenRecord();
  return bench.loadEdited(source.project.peek());
}

/** Sets a breakpoint at a line of the program, or removes it. */
export function toggleBreakpoint(line: number): void {
  if (record.peek()) return; // its lines are not shown
  const before = session.breakpoints.peek();
  const next = before.includes(line)
    ? before.filter((each) => each !== line)
    : [...before, line].sort((a, b) => a - b);
  // What was edited has other lines; it is loaded with its breakpoints.
  if (isEdited.peek() || !present.state.peek()) bench.wishStops(next);
  else void bench.stopAt(next);
}

/** What is at a place of the open file. */
export async function describe(line: number, column: number): Promise<Description | null> {
  const engine = await bench.engine();
  return engine.describe(placeOf(line, column));
}

/** What can stand at a place of the open file. */
export async function complete(line: number, column: number): Promise<Completion> {
  const engine = await bench.engine();
  return engine.complete(placeOf(line, column));
}

/** What a reader of the open file would have to look up. */
export async function hints(): Promise<Hint[]> {
  const engine = await bench.engine();
  return engine.hints({ ...source.project.peek(), file: source.file.peek() });
}

function placeOf(line: number, column: number): SourcePlace {
  return { ...source.project.peek(), file: source.file.peek(), line, column };
}
