// The letter a, repeated, as lz-string packs it best: each code is a piece that is one letter longer
// than the last one, so that n codes hold n (n + 1) / 2 letters.

const alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+-$";

export function packedRun(codes: number): string {
  const bits: number[] = [];
  const put = (value: number, count: number): void => {
    for (let i = 0; i < count; i += 1) bits.push((value >> i) & 1);
  };
  put(0, 2);
  put("a".charCodeAt(0), 8);
  // The first piece that is not a single letter has the code 4, in three bits.
  let width = 3;
  let untilWider = 4;
  const countPiece = (): void => {
    untilWider -= 1;
    if (untilWider > 0) return;
    untilWider = 2 ** width;
    width += 1;
  };
  for (let code = 4; code < codes + 3; code += 1) {
    put(code, width);
    countPiece();
  }
  put(2, width);
  let text = "";
  for (let at = 0; at < bits.length; at += 6) {
    const six = [0, 1, 2, 3, 4, 5].reduce((sum, i) => 2 * sum + (bits[at + i] ?? 0), 0);
    text += alphabet.charAt(six);
  }
  return text;
}
