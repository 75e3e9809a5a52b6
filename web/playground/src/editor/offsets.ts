// Places of the compiler, which counts bytes of UTF-8, in texts of JavaScript, which count units of
// UTF-16. Tested by test/offsets.test.ts.

import type { Fixit } from "@oncard/engine";

function unitsOfBytes(text: string, bytes: number): number {
  let units = 0;
  let left = bytes;
  for (const character of text) {
    const code = character.codePointAt(0) ?? 0;
    left -= code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
    if (left < 0) break;
    units += character.length;
  }
  return units;
}

/** The index of a place: line and column from 1, the column in bytes. Places outside are at the end. */
export function indexOfPlace(text: string, line: number, column: number): number {
  let begin = 0;
  for (let left = line; left > 1; --left) {
    const end = text.indexOf("\n", begin);
    if (end < 0) return text.length;
    begin = end + 1;
  }
  const end = text.indexOf("\n", begin);
  const whole = text.slice(begin, end < 0 ? text.length : end);
  return begin + unitsOfBytes(whole, column - 1);
}

/** A text with all replacements of a message. */
export function withFixes(text: string, fixes: Fixit[]): string {
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
