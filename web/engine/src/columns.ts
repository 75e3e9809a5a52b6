// Columns of the engine, which count characters from 1, as indices of texts of JavaScript, which
// count units of UTF-16: a character is one or two of them.
// Tested by test/columns.test.ts.

/** The index at which a column of a line begins; a column behind the end is there. */
export function indexOfColumn(line: string, column: number): number {
  let index = 0;
  for (let left = column - 1; left > 0 && index < line.length; --left) {
    index += unitsAt(line, index);
  }
  return index;
}

/** The column of the character at an index of a line, which may be its end. */
export function columnOfIndex(line: string, index: number): number {
  let column = 1;
  for (let at = 0; at < index && at < line.length; at += unitsAt(line, at)) ++column;
  return column;
}

/** Units of the character that begins there. */
function unitsAt(line: string, index: number): number {
  return (line.codePointAt(index) ?? 0) > 0xffff ? 2 : 1;
}
