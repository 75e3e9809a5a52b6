// What can be typed next in the console: names that can be evaluated there, and commands.
// Tested by test/completions.test.ts.

import type { Card, State, Variable } from "@oncard/engine";
import type { DebugProtocol } from "@vscode/debugprotocol";

import { commandsIn, isCommandOnly } from "./console.js";
import { type Launched, threadOf } from "./launched.js";

/** What has been typed; lines and columns count from 1. */
export interface Typed {
  text: string;
  line: number;
  column: number;
  frameId: number | undefined;
}

interface Offer {
  /** Its place in the list: 0 is the first. */
  rank: number;
  label: string;
  detail: string | undefined;
}

/** Columns of the answer count from 1. */
export async function complete(
  launched: Launched,
  { text, line, column, frameId }: Typed,
): Promise<DebugProtocol.CompletionItem[]> {
  const before = (text.split("\n")[line - 1] ?? "").slice(0, column - 1);
  const items = commandsIn(before, launched.state).map((command, i) =>
    itemOf(command.trimEnd(), command, "keyword", `${ranks.command}${padded(i)}`, {
      start: before.length - before.trimStart().length + 1,
      length: before.trimStart().length,
    }),
  );
  const typed = nameAtEnd(before);
  if (typed === undefined || isCommandOnly(before.slice(0, before.length - typed.length))) {
    return items;
  }
  const place = { start: before.length - typed.length + 1, length: typed.length };
  // The engine goes back to the change of a name without knowing of a frame.
  const frame = /^\s*back\s+change\s/.test(before) ? undefined : frameId;
  const offers = (await allNames(launched, frame)).filter(({ label }) => fits(label, typed));
  for (const [i, { rank, label, detail }] of offers.entries()) {
    const item = itemOf(label, label, "variable", `${rank}${padded(i)}`, place);
    items.push(detail === undefined ? item : { ...item, detail });
  }
  return items;
}

const ranks = { local: 0, global: 1, command: 2, page: 3, card: 4 };

/** The values of a thread that have names (docs/scenarios.md). */
const threadValues = ["result", "run", "error", "line", "page", "statements"];

/** All names in the order in which they are offered; globals hide parts of the card. */
async function allNames(launched: Launched, frameId: number | undefined): Promise<Offer[]> {
  const { engine, state } = launched;
  const offers: Offer[] = [];
  const page = frameId === undefined ? -1 : threadOf(launched, frameId).page;
  if (page >= 0) {
    const locals = await engine.variables(page);
    offers.push(...locals.flatMap((each) => variable(each, each.name, ranks.local)));
  }
  const globals = (await engine.variables()).flatMap((each) =>
    variable(each, each.path, ranks.global),
  );
  offers.push(...globals);
  for (const page of new Set(state.threads.map((thread) => thread.page))) {
    const locals = await engine.variables(page);
    offers.push(...locals.flatMap((each) => variable(each, each.path, ranks.page)));
  }
  const roots = new Set(globals.map(({ label }) => rootOf(label)));
  const names = [...cardNames(await engine.card()), ...runNames(state)];
  return [...offers, ...names.filter(({ label }) => !roots.has(rootOf(label)))];
}

/** A variable and, if it is an array, its elements. */
function variable({ type, value }: Variable, label: string, rank: number): Offer[] {
  const elements = Array.isArray(value) ? value.map((_, i) => `${label}[${i}]`) : [];
  return [label, ...elements].map((each) => ({ rank, label: each, detail: type }));
}

function cardNames({ parts, words }: Card): Offer[] {
  const rank = ranks.card;
  return [
    ...parts.flatMap(({ values }) =>
      values.map(({ path, unit }) => ({ rank, label: path, detail: unit })),
    ),
    ...words.flatMap(({ name, kind, pins }) =>
      [name, ...Array.from({ length: pins }, (_, bit) => `${name}[${bit + 1}]`)].map((label) => ({
        rank,
        label,
        detail: kind,
      })),
    ),
  ];
}

function runNames({ threads }: State): Offer[] {
  const ofThreads = threads.flatMap(({ thread }) =>
    threadValues.map((value) => `thread${thread}.${value}`),
  );
  return [...ofThreads, "clock", "statements"].map((label) => ({
    rank: ranks.card,
    label,
    detail: undefined,
  }));
}

/** The beginning of a name before the cursor, or nothing where no name can be: in a number. */
function nameAtEnd(before: string): string | undefined {
  const typed = /[\w.[\]]*$/.exec(before)?.[0] ?? "";
  return typed === "" || /^[A-Za-z_]/.test(typed) ? typed : undefined;
}

/** Elements and bits are offered behind a bracket: there are too many of them otherwise. */
function fits(label: string, typed: string): boolean {
  return (
    label.toLowerCase().startsWith(typed.toLowerCase()) &&
    (typed.includes("[") || !label.endsWith("]"))
  );
}

/** The name of what a name is a part of. */
function rootOf(name: string): string {
  return name.replace(/[.[].*/, "");
}

/** Numbers of one length: texts are sorted by their characters. */
function padded(number: number): string {
  return String(number).padStart(6, "0");
}

function itemOf(
  label: string,
  text: string,
  type: DebugProtocol.CompletionItemType,
  sortText: string,
  place: { start: number; length: number },
): DebugProtocol.CompletionItem {
  return { label, ...(text === label ? {} : { text }), type, sortText, ...place };
}
