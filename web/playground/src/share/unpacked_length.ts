// How long a text is that lz-string has compressed for an address, without unpacking it: a link of
// 69 KB can hold a gigabyte. A code stands for an earlier piece of the text; to add the lengths of
// the pieces, their characters are not needed.
// Tested by test/unpacked_length.test.ts.

/** The characters of `compressToEncodedURIComponent`, six bits each, the highest first. */
const alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+-$";
const bitsOfCharacter = 6;

/** Codes that are no pieces: a new character of 8 or 16 bits follows, or the text ends. */
const newByte = 0;
const newWord = 1;
const end = 2;

/** The number of characters; undefined if the text is damaged or has more than `most`. */
export function unpackedLength(packed: string, most: number): number | undefined {
  let bit = 0;
  /** A number whose lowest bit comes first; undefined behind the end. */
  const read = (count: number): number | undefined => {
    if (bit + count > packed.length * bitsOfCharacter) return undefined;
    let value = 0;
    for (let i = 0; i < count; i += 1, bit += 1) {
      const six = alphabet.indexOf(packed.charAt(Math.floor(bit / bitsOfCharacter)));
      if (six < 0) return undefined;
      value |= ((six >> (bitsOfCharacter - 1 - (bit % bitsOfCharacter))) & 1) << i;
    }
    return value;
  };
  /** The lengths of the pieces by their codes; the first three are no pieces. */
  const lengths = [0, 0, 0];
  let width = 2;
  let untilWider = 1;
  const countPiece = (): void => {
    untilWider -= 1;
    if (untilWider > 0) return;
    untilWider = 2 ** width;
    width += 1;
  };
  let last = 0;
  let total = 0;
  for (;;) {
    let code = read(width);
    if (code === undefined) return undefined;
    if (code === end) return total;
    if (code === newByte || code === newWord) {
      if (read(code === newByte ? 8 : 16) === undefined) return undefined;
      code = lengths.push(1) - 1;
      countPiece();
    }
    // A piece may be the one that it completes: the last one and its own first character.
    const length = code === lengths.length ? last + 1 : lengths[code];
    if (length === undefined || (code === lengths.length && last === 0)) return undefined;
    total += length;
    if (total > most) return undefined;
    if (last > 0) {
      lengths.push(last + 1);
      countPiece();
    }
    last = length;
  }
}
