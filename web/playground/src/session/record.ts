// The record of a host program that the reader has opened (`oncard exec --record`): it is on the
// card instead of the open program. It owns its slice.
// Tested by test/session.test.ts.

import type { Loaded, LoadOptions, Project } from "@oncard/engine";

import { slice } from "../store/slice.js";
import { source } from "../store/source.js";
import { bench, present } from "./bench.js";

type Answer = Extract<Loaded, { compiled: true }>;
type Cards = NonNullable<Answer["cards"]>;

/** A record that is on the card. */
export interface OpenRecord {
  name: string;
  project: Project;
  /** The openings of cards in it. */
  cards: Cards;
  /** The one that is on the card; its index. */
  chosen: number;
  /** Sources of motion programs that were found when the host was recorded. */
  sources: Answer["files"];
  /** Axes of the card. */
  axes: number;
}

const [{ record }, change] = slice<{ record: OpenRecord | undefined }>({ record: undefined });
export { record };

/** Puts the record of a file onto the card; the status line says why that is not possible. */
export async function openRecord(name: string, text: string): Promise<void> {
  // Paths end with the name that says what a file is.
  const main = name.endsWith(".calls") ? name : `${name}.calls`;
  await show({ main, files: { [main]: text } }, name, 0);
}

/** Puts another opening of the record onto the card. */
export async function chooseOpening(index: number): Promise<void> {
  const { value } = record;
  const chosen = value?.cards[index];
  if (!value || !chosen) return;
  const { card, opening } = chosen;
  await show(value.project, value.name, index, { card, opening });
}

async function show(
  project: Project,
  name: string,
  chosen: number,
  options: LoadOptions = {},
): Promise<void> {
  const answer = await bench.loadRecord(project, options);
  if (!answer) return;
  const { parts = [] } = present.card.peek() ?? {};
  change({
    record: {
      name,
      project,
      cards: answer.cards ?? [],
      chosen,
      sources: answer.files,
      axes: parts.filter(({ part }) => part === "axis").length,
    },
  });
}

/** The record after the engine has failed. */
export async function reopenRecord(): Promise<boolean> {
  const { value } = record;
  if (!value) return false;
  await chooseOpening(value.chosen);
  return present.state.peek() !== undefined;
}

/** The open program shall be on the card again; whoever calls this loads it. */
export function forgetRecord(): void {
  change({ record: undefined });
}

/** Puts the open program onto the card again. */
export async function closeRecord(): Promise<void> {
  forgetRecord();
  await bench.load(source.project.peek());
}
