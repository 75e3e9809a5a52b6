import { spawnSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";

import { expect, test } from "vitest";

import { matchers } from "../src/tasks";
import { manifest, newFolder, oncard } from "./support.js";

/** What each matcher finds in an output. */
function matched(output: string): Record<string, Record<string, string>[]> {
  const found: Record<string, Record<string, string>[]> = {};
  for (const { name, pattern } of manifest.contributes.problemMatchers) {
    const { regexp, ...groups } = pattern;
    found[name] = output.split("\n").flatMap((line) => {
      const match = new RegExp(regexp).exec(line);
      if (!match) return [];
      const parts = Object.entries(groups).map(([part, group]) => [part, match[group]]);
      return [Object.fromEntries(parts) as Record<string, string>];
    });
  }
  return found;
}

function outputOf(files: Record<string, string>, ...args: string[]): string {
  const folder = newFolder();
  for (const [name, text] of Object.entries(files)) writeFileSync(join(folder, name), text);
  return spawnSync(oncard, args, { cwd: folder, encoding: "utf8" }).stderr;
}

const broken = "int a;\nint a;\nint f()\n{\n  int i;\n  i = 1;\n  return 0;\n}\n";

test("the output of check", () => {
  const { oncard: problems, ...others } = matched(
    outputOf({ "p.c": broken }, "--lang=en", "check", "p.c"),
  );
  expect(Object.values(others).flat()).toEqual([]);
  expect(problems).toEqual([
    {
      file: "p.c",
      line: "2",
      column: "5",
      severity: "error",
      code: "MP013",
      message: "'a' is defined twice; choose another name",
    },
  ]);
});

test("a warning of check", () => {
  const text = broken.replace("int a;\n", "");
  const { oncard: problems } = matched(outputOf({ "p.c": text }, "--lang=en", "check", "p.c"));
  expect(problems).toMatchObject([{ line: "5", severity: "warning", code: "MP137" }]);
});

test("the output of check in Chinese", () => {
  const errors = matched(outputOf({ "p.c": broken }, "--lang=zh", "check", "p.c"));
  expect(errors).toMatchObject({
    oncard: [],
    "oncard-error-zh": [{ line: "2", code: "MP013", message: "'a' 重复定义；请换一个名称" }],
    "oncard-warning-zh": [],
    "oncard-scenario": [],
  });
  const text = broken.replace("int a;\n", "");
  const warnings = matched(outputOf({ "p.c": text }, "--lang=zh", "check", "p.c"));
  expect(warnings).toMatchObject({
    "oncard-error-zh": [],
    "oncard-warning-zh": [{ line: "5", code: "MP137" }],
  });
});

test("tasks use all matchers", () => {
  const contributed = manifest.contributes.problemMatchers.map(({ name }) => `$${name}`);
  expect(matchers).toEqual(contributed);
});

test("the mistakes of a scenario", () => {
  const files = { "p.c": broken, "s.toml": 'program = "p.c"\nexpec = []\naxes = 5\n' };
  const output = outputOf(files, "--lang=en", "run", "s.toml");
  const { "oncard-scenario": problems, ...others } = matched(output);
  expect(Object.values(others).flat()).toEqual([]);
  expect(problems?.map(({ file, line, column }) => [file, line, column].join(" "))).toEqual([
    "s.toml 2 1",
    "s.toml 3 8",
  ]);
  expect(problems?.[0]?.["message"]).toBe("unknown key 'expec'; did you mean 'expect'?");
});
