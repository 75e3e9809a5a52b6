// What stands behind the lines of the program: what each thread made in a line when it executed the line
// last, and the units of arguments of commands and members of their structures.
// The page and the extension for Visual Studio Code show it.
// Tested by test/beside.test.ts.

import type { Hint, LineWrites } from "@oncard/engine";

/** Behind a line of the text, from 1 on. */
export type Beside = { line: number; text: string } & (
  | { kind: "unit" }
  | {
      kind: "made";
      thread: number;
      /** Of several threads each has its number. */
      isNumbered: boolean;
      /** By the statement before the present moment. */
      isNew: boolean;
    }
);

interface Shown {
  /** As `LineWrites` names it. */
  file: string;
  lines: readonly string[];
  /** The present moment. */
  moment: number;
}

/** In the order of the lines, and in a line of the threads. */
export function valuesBeside(written: readonly LineWrites[], shown: Shown): Beside[] {
  const isNumbered = new Set(written.map(({ thread }) => thread)).size > 1;
  const made = written.flatMap((each): Beside[] => {
    const { thread, line, moment } = each;
    const text = each.file === shown.file ? textOf(each, shown.lines[line - 1] ?? "") : "";
    const isNew = moment === shown.moment - 1;
    return text === "" ? [] : [{ line, text, kind: "made", thread, isNumbered, isNew }];
  });
  return made.sort((a, b) => a.line - b.line || threadOf(a) - threadOf(b));
}

function threadOf(beside: Beside): number {
  return beside.kind === "made" ? beside.thread : -1;
}

/** Without what stands in the line already, and what the translation of structured C needs for itself. */
function textOf({ values, result }: LineWrites, line: string): string {
  const names = new Set(line.match(/[A-Za-z_]\w*/g));
  const its = values.filter(({ name }) => names.has(/^\w+/.exec(name)?.[0] ?? ""));
  const said = line.replace(/\s+/g, "").split(";");
  const texts = its
    .filter(({ name, value }) => !said.includes(`${name}=${value}`))
    .map(({ name, value }) => `${name} = ${value}`);
  if (result !== undefined && !said.includes(`return${result}`)) texts.push(`→ ${result}`);
  return texts.join(", ");
}

/** Each unit of a line once. */
export function unitsBeside(hints: readonly Hint[]): Beside[] {
  const units = new Map<number, Set<string>>();
  for (const { line, unit } of hints) {
    if (unit === undefined) continue;
    units.set(line, (units.get(line) ?? new Set()).add(unit));
  }
  return [...units].map(([line, its]) => ({ line, text: [...its].join(", "), kind: "unit" }));
}
