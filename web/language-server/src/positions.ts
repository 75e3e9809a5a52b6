// Places of the engine (lines and columns from 1, columns in characters) as positions of an editor
// (from 0, in UTF-16 code units).
// Tested by test/positions.test.ts.

import { columnOfIndex, indexOfColumn } from "@oncard/engine";
import type { Position, Range } from "vscode-languageserver";

/** A place as the engine gives it. */
export interface Place {
  line: number;
  column: number;
}

export interface PlaceRange extends Place {
  end_line: number;
  end_column: number;
}

/** The lines of a file. */
export class Lines {
  readonly #lines: readonly string[];

  constructor(text: string) {
    this.#lines = text.split(/\r\n|\n|\r/);
  }

  /** A place after the end of its line, or of the file, is there. */
  position({ line, column }: Place): Position {
    const text = this.#lines[line - 1];
    if (text === undefined) {
      const last = this.#lines.length - 1;
      return { line: last, character: this.#lines[last]?.length ?? 0 };
    }
    return { line: line - 1, character: indexOfColumn(text, column) };
  }

  /** All of them. */
  whole(): Range {
    const end = this.position({ line: this.#lines.length + 1, column: 1 });
    return { start: { line: 0, character: 0 }, end };
  }

  range(range: PlaceRange): Range {
    const end = { line: range.end_line, column: range.end_column };
    return { start: this.position(range), end: this.position(end) };
  }

  place({ line, character }: Position): Place {
    return { line: line + 1, column: columnOfIndex(this.#lines[line] ?? "", character) };
  }
}
