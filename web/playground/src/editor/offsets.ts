// Places of the compiler in the text of the editor. Tested by test/offsets.test.ts.

import { columnOfIndex, type Edit, indexOfColumn } from "@oncard/engine";

/** The index of a place: line and column from 1. Places outside are at the end. */
export function indexOfPlace(text: string, line: number, column: number): number {
  let begin = 0;
  for (let left = line; left > 1; --left) {
    const end = text.indexOf("\n", begin);
    if (end < 0) return text.length;
    begin = end + 1;
  }
  const end = text.indexOf("\n", begin);
  const whole = text.slice(begin, end < 0 ? text.length : end);
  return begin + indexOfColumn(whole, column);
}

/** The place of an index, as the compiler counts. */
export function placeOfIndex(text: string, index: number): { line: number; column: number } {
  const lines = text.slice(0, index).split("\n");
  const before = lines.at(-1) ?? "";
  return { line: lines.length, column: columnOfIndex(before, before.length) };
}

/** A text with all replacements of a message. */
export function withFixes(text: string, fixes: Edit[]): string {
  const places = fixes
    .map(({ line, column, end_line, end_column, text: put }) => ({
      begin: indexOfPlace(text, line, column),
      end: indexOfPlace(text, end_line, end_column),
      put,
    }))
    .sort((a, b) => b.begin - a.begin || b.end - a.end);
  let result = text;
  for (const { begin, end, put } of places) {
    result = result.slice(0, begin) + put + result.slice(end);
  }
  return result;
}
