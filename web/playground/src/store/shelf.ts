// The programs of a reader: for each lesson a row of them, one of which is open. Nothing is thrown
// away: a reset or a link adds one.
// Tested by test/shelf.test.ts.

import { isKeptShelf } from "./kept_schema.js";
import { salvaged } from "./salvaged.js";

/** The texts of a project by their names. */
export type Files = Record<string, string>;

export interface Shelf {
  open: number;
  programs: Files[];
}

/** Reads a shelf from what the browser has kept; undefined if there is no program in it. */
export function readShelf(value: unknown): Shelf | undefined {
  const kept = salvaged(isKeptShelf, value);
  if (!kept) return undefined;
  const { open = 0, programs } = kept;
  return { open: Math.min(Math.max(open, 0), programs.length - 1), programs };
}

export function sameFiles(a: Files, b: Files): boolean {
  const names = Object.keys(a);
  return names.length === Object.keys(b).length && names.every((name) => a[name] === b[name]);
}

export function openFiles(shelf: Shelf): Files {
  return shelf.programs[shelf.open] ?? {};
}

export function withText(shelf: Shelf, name: string, text: string): Shelf {
  const programs = shelf.programs.map((files, index) =>
    index === shelf.open ? { ...files, [name]: text } : files,
  );
  return { ...shelf, programs };
}

/** Opens these files: a program that is already there, or a new one. */
export function withProgram(shelf: Shelf, files: Files): Shelf {
  const same = shelf.programs.findIndex((each) => sameFiles(each, files));
  if (same >= 0) return { ...shelf, open: same };
  return { open: shelf.programs.length, programs: [...shelf.programs, files] };
}

export function withoutOpen(shelf: Shelf): Shelf {
  const programs = shelf.programs.filter((_, index) => index !== shelf.open);
  return programs.length === 0 ? shelf : { open: Math.max(0, shelf.open - 1), programs };
}
