import lzString from "lz-string";
import { expect, test } from "vitest";

import { unpackedLength } from "../src/share/unpacked_length.js";
import { packedRun } from "./packed_run.js";

const pack = (text: string): string => lzString.compressToEncodedURIComponent(text);

/** Texts of few different characters, some beyond eight bits. */
function randomTexts(count: number): string[] {
  let state = 1;
  const next = (below: number): number => {
    state = (Math.imul(state, 1_103_515_245) + 12_345) & 0x7fffffff;
    return (state >> 8) % below;
  };
  return Array.from({ length: count }, () => {
    const kinds = 2 + next(40);
    const characters = Array.from({ length: next(300) }, () =>
      String.fromCharCode(next(8) === 0 ? 0x4e00 + next(kinds) : 97 + next(kinds)),
    );
    return characters.join("");
  });
}

test.each(["", "a", "ab", "aaaa", "位置 x\n", "abcabcabcabcabc", "a".repeat(5000)])(
  "the length of %.20j is known before it is unpacked",
  (text) => {
    expect(unpackedLength(pack(text), 10_000)).toBe(text.length);
  },
);

test("the length of any text is that of lz-string", () => {
  for (const text of randomTexts(500)) expect(unpackedLength(pack(text), 1000)).toBe(text.length);
});

test("a text may be as long as the limit, and no longer", () => {
  const packed = packedRun(100);
  expect(lzString.decompressFromEncodedURIComponent(packed)).toBe("a".repeat(5050));
  expect(unpackedLength(packed, 5050)).toBe(5050);
  expect(unpackedLength(packed, 5049)).toBeUndefined();
});

test.each(["", "%", "A", "AAA", "_QQ"])("the damaged text %j has no length", (packed) => {
  expect(unpackedLength(packed, 1000)).toBeUndefined();
});
