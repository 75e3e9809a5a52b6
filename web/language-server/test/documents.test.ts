import { join } from "node:path";

import { expect, test } from "vitest";

import { Documents, isExplored, type OpenDocument, programOf } from "../src/documents.js";
import { uriOf } from "../src/paths.js";
import { folderOf, sample } from "./support.js";

const open = (path: string, text: string, languageId = "c"): OpenDocument => ({
  uri: uriOf(path),
  languageId,
  getText: () => text,
});

function kindOf(document: OpenDocument, ...others: OpenDocument[]) {
  return new Documents(() => [document, ...others]).kind(document);
}

test("a C file is a motion program if a scenario in its folder names it", async () => {
  expect(await kindOf(open(sample("01_sum/sum.c"), ""))).toBe("program");
  expect(await kindOf(open(sample("01_sum/other.c"), ""))).toBeUndefined();
});

test("a C file is a motion program if an open scenario names it", async () => {
  const program = open("/nowhere/a/p.c", "");
  expect(await kindOf(program, open("/nowhere/s.toml", 'program = "a/p.c"'))).toBe("program");
  expect(await kindOf(program, open("/nowhere/s.toml", 'program = "p.c"'))).toBeUndefined();
});

test.each([
  ["//@ structured\nint f() {}", "program"],
  ["int sum;\n  //@ final: sum == 3\n", "program"],
  ["// @author somebody\nint main() {}\n", undefined],
  ['#include "gts.h"\nint main() { GT_Open(0, 1); }\n', undefined],
])("%j", async (text, kind) => {
  expect(await kindOf(open("/nowhere/p.c", text))).toBe(kind);
});

test("a file is a motion program if the user says so", async () => {
  expect(await kindOf(open("/nowhere/p.c", "", "motion-program"))).toBe("program");
  expect(await kindOf(open("/nowhere/p.txt", "", "motion-program"))).toBe("program");
});

test.each([
  ['program = "p.c"', "p.c"],
  ["# a\n  program='../p.c' # b\n", "../p.c"],
  ['title = "x"\nprogram = "p.bin"\n[[thread]]', "p.bin"],
  ['[tool]\nprogram = "p.c"', undefined],
  ['program = "p.py"', undefined],
  ["axes = 8", undefined],
])("the program of %j is %s", (text, program) => {
  expect(programOf(text)).toBe(program);
});

test.each([
  ['program = "p.c"\nexplore = "prove"\n', true],
  ['program = "p.c"\nexplore = { verdict = "FAILED" }\n[[thread]]\n', true],
  ['program = "p.c"\n[explore]\nengine = "dpor"\n', true],
  ['program = "p.c"\n# explore = "prove"\n', false],
  ['program = "p.c"\n[globals]\nexplore = 1\n', false],
  ['program = "p.c"\nexplored = 1\n', false],
])("a scenario is explored if it says so: %s", (text, is) => {
  expect(isExplored(text)).toBe(is);
});

test("a TOML file without a program is no scenario", async () => {
  expect(await kindOf(open("/nowhere/Cargo.toml", "[package]", "toml"))).toBeUndefined();
  expect(await kindOf(open("/nowhere/s.toml", 'program = "p.c"', "toml"))).toBe("scenario");
});

test("an open document counts as it is on the screen", async () => {
  const folder = folderOf({ "p.c": "on disk", "q.c": "on disk" });
  const documents = new Documents(() => [open(join(folder, "p.c"), "on the screen")]);
  expect(await documents.text(join(folder, "p.c"))).toBe("on the screen");
  expect(await documents.text(`${folder}/x/../p.c`)).toBe("on the screen");
  expect(await documents.text(join(folder, "q.c"))).toBe("on disk");
  expect(await documents.text(join(folder, "r.c"))).toBeUndefined();
});
