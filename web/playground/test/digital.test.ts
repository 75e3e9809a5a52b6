// Which channels are digital, as the engine has it: what its traces write as wires of one bit.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import type { Variable } from "@oncard/engine";
import { expect, onTestFinished, test } from "vitest";

import { engineOf, oncard } from "../../engine/test/support.js";
import { isDigital, levelOfPin, pinNames } from "../src/scope/digital.js";
import { cardWith } from "./card.js";

const program = "int main()\n{\n  GT_AxisOn(1);\n}\n";

/** The names that a trace of the engine writes as wires of one bit. */
function wiresOf(names: string[]): string[] {
  const folder = mkdtempSync(join(tmpdir(), "oncard-"));
  onTestFinished(() => {
    rmSync(folder, { recursive: true });
  });
  const file = (name: string) => join(folder, name);
  writeFileSync(file("p.c"), program);
  writeFileSync(file("s.toml"), `program = "p.c"\ntrace = ${JSON.stringify(names)}\n`);
  execFileSync(oncard, ["run", file("s.toml"), "--trace", file("t.vcd")]);
  const scopes: string[] = [];
  const wires: string[] = [];
  for (const line of readFileSync(file("t.vcd"), "utf8").split("\n")) {
    const [word, , third = "", , name = ""] = line.split(" ");
    if (word === "$scope") scopes.push(third);
    else if (word === "$upscope") scopes.pop();
    // The first scope is the card.
    else if (word === "$var" && third === "1") wires.push([...scopes.slice(1), name].join("."));
  }
  return wires;
}

test("flags and pins are digital, and nothing else that a card has", async () => {
  const card = await (await engineOf(program)).card();
  const values = card.parts.flatMap((part) => part.values.map(({ path }) => path));
  const words = card.words.map(({ name }) => name);
  const names = [...values, ...words, ...pinNames(card, [])];
  const digital = names.filter((name) => isDigital(name, card, []));
  expect(digital).toEqual(expect.arrayContaining(["axis1.moving", "hsio0", "gpo[16]", "home[8]"]));
  expect(digital.sort()).toEqual(wiresOf(names).sort());
});

test("a word has no more pins than its names", async () => {
  const engine = await engineOf(program);
  const { words } = await engine.card();
  for (const word of words) {
    const pins = pinNames(cardWith({ words: [word] }), []).length;
    expect(await engine.evaluate(`${word.name}[${pins}]`)).toMatchObject({ value: 0 });
    await expect(engine.evaluate(`${word.name}[${pins + 1}]`)).rejects.toThrow(String(pins));
  }
});

const card = cardWith({
  parts: [
    {
      part: "axis",
      number: 1,
      values: [{ name: "moving", path: "axis1.moving", value: 1, flag: true }],
    },
  ],
  words: [{ name: "gpo", kind: "output", value: 0b1000_0000_0000_0010, pins: 16 }],
});
const variable = { name: "", type: "int", slot: 0, value: 1 };

test.each<[string, Variable[]]>([
  ["gpo[2]", [{ ...variable, path: "gpo", value: [0, 0, 7] }]],
  ["axis1.moving", [{ ...variable, path: "axis1.moving" }]],
])("%s is a variable where one hides it", (name, variables) => {
  expect(isDigital(name, card, [])).toBe(true);
  expect(isDigital(name, card, variables)).toBe(false);
});

test.each([
  ["gpo[1]", 0],
  ["gpo[2]", 1],
  ["gpo[16]", 1],
  ["gpo", undefined],
  ["home[1]", undefined],
])("the level of %s", (name, level) => {
  expect(levelOfPin(name, card, [])).toBe(level);
});

test("without a card nothing is digital", () => {
  expect(isDigital("gpo[1]", undefined, [])).toBe(false);
  expect(pinNames(undefined, [])).toEqual([]);
});
