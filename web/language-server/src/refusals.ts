// Mistakes of a scenario, which the engine reports in one text: the headline of each begins with its
// place, and is followed by the line and a row of carets under what is wrong.
// Tested by test/refusals.test.ts.

import type { PlaceRange } from "./positions.js";

export interface PlacedMistake extends PlaceRange {
  file: string;
  message: string;
}

const headline = /^(.+?):(\d+):(\d+): (.*)$/;
const carets = /^ *\| *(\^~*)$/;

/** Nothing if the text is about no place. */
export function placedMistakes(refusal: string): PlacedMistake[] {
  const mistakes: PlacedMistake[] = [];
  for (const row of refusal.split("\n")) {
    const last = mistakes.at(-1);
    const width = carets.exec(row)?.[1]?.length;
    if (last && width !== undefined) {
      last.end_column = last.column + width;
      continue;
    }
    const [, file, line, column, message] = headline.exec(row) ?? [];
    if (file === undefined || message === undefined || /^\s*\d+ \|/.test(row)) continue;
    const place = { line: Number(line), column: Number(column) };
    mistakes.push({
      file,
      message,
      ...place,
      end_line: place.line,
      end_column: place.column + 1,
    });
  }
  return mistakes;
}
