// The words of instructions, as docs/object-format.md and `oncard dump` show them.

import { recordText } from "@oncard/engine";
import { expect, test } from "vitest";

import { sample, startEngine } from "./support.js";

test("the words of a program in hexadecimal, the link words apart", async () => {
  const engine = startEngine();
  await engine.load({ main: sample("01_sum/sum.c") });
  const [add] = await engine.listing();
  expect(add?.statements.map(({ words }) => recordText(words))).toEqual([
    "0005 5041 0001 0000 0001 0002  0003 000A 0001 0001",
    "0006 5040 000B 0002 0001 0001 0003  0004 0016 0001 0001 0001",
    "0003 5080 0003 0004  0002 0001 0001",
    "0006 5040 0001 0000 0002 0001 0000  0004 0016 0003 0001 0003",
    "0008 5040 0001 0002 0001 0000 0000 0001 0002  0003 0012 0001 0001",
    "0003 5080 0001 FFFC  0001 0000",
    "0003 5081 0001 0000  0002 0002 0003",
  ]);
});
