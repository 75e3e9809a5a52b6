// What of the page the reader looks at: the panel in front, the tab of the values, the chosen line.
// Tested by test/layout.test.ts.

import { slice } from "./slice.js";

export const panels = [
  "lesson",
  "program",
  "interleaving",
  "machine",
  "timeline",
  "scope",
  "values",
] as const;
export type Panel = (typeof panels)[number];

export const tabs = ["variables", "threads", "listing", "columns", "warnings"] as const;
export type Tab = (typeof tabs)[number];

interface Layout {
  /** The only panel that narrow screens show. */
  front: Panel;
  /** Of the values. */
  tab: Tab;
  /** The line of the program that the reader has chosen, in the editor or among the statements. */
  chosenLine: number;
  /** The line of a file that the pointer is at, in its text or in a list of what it becomes. */
  pointed: { file: string; line: number; isInText: boolean } | undefined;
  /** A line that the editor is to show; another object with each wish. */
  wishedLine: { line: number; file?: string } | undefined;
  /** Grows with each wish to go on in the list of values with the keyboard. */
  listWishes: number;
}

const [layout, change] = slice<Layout>({
  front: "lesson",
  tab: "variables",
  chosenLine: 0,
  pointed: undefined,
  wishedLine: undefined,
  listWishes: 0,
});
export { layout };

export function showPanel(front: Panel): void {
  change({ front });
}

/** On narrow screens: a run is watched at the machine, wherever the card is not in sight. */
export function showRun(): void {
  const front = layout.front.peek();
  if (front === "lesson" || front === "program") change({ front: "machine" });
}

export function showTab(tab: Tab): void {
  change({ tab });
}

/** The cursor of the editor is in another line of the program. */
export function chooseLine(line: number): void {
  change({ chosenLine: line });
}

/** The pointer is at a line of a file, or no longer at one. */
export function pointAt(pointed: Layout["pointed"]): void {
  const before = layout.pointed.peek();
  // It moves within a line most of the time.
  if (JSON.stringify(pointed) !== JSON.stringify(before)) change({ pointed });
}

/** True if the pointer is at a line, wherever that is shown. */
export function isPointed(file: string, line: number): boolean {
  const pointed = layout.pointed.value;
  return pointed?.file === file && pointed.line === line;
}

/** Shows a line of the program in the editor, or of another file. */
export function showLine(line: number, file?: string): void {
  if (file === undefined) change({ front: "program", chosenLine: line, wishedLine: { line } });
  else change({ front: "program", wishedLine: { line, file } });
}

/** Shows the warnings of the card, and leads the keyboard to them. */
export function showWarnings(): void {
  change({ front: "values", tab: "warnings", listWishes: layout.listWishes.peek() + 1 });
}
