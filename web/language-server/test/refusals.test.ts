import { RefusedError } from "@oncard/engine";
import { expect, test } from "vitest";

import { startEngine } from "../../engine/test/support.js";
import { placedMistakes } from "../src/refusals.js";

async function refusal(scenario: string, language: "en" | "zh" = "en"): Promise<string> {
  const engine = startEngine();
  await engine.hello(language);
  const files = { "s.toml": scenario, "p.c": "int sum;\nint f()\n{\n  sum = 1;\n}\n" };
  const why: unknown = await engine
    .load({ main: "s.toml", files })
    .catch((error: unknown) => error);
  if (why instanceof RefusedError) return why.message;
  throw new Error("the scenario was not refused");
}

test("every mistake of a scenario has its place", async () => {
  const text = 'program = "p.c"\nexpec = ["sum == 3"]\nuntil_ms = "x"\n';
  expect(placedMistakes(await refusal(text))).toEqual([
    {
      file: "s.toml",
      line: 2,
      column: 1,
      end_line: 2,
      end_column: 6,
      message: "unknown key 'expec'; did you mean 'expect'?",
    },
    {
      file: "s.toml",
      line: 3,
      column: 12,
      end_line: 3,
      end_column: 15,
      message: "'until_ms' must be a time in ms, from 0 to 1000000000",
    },
  ]);
});

test("what does not fit the program has its place", async () => {
  const [first, ...others] = placedMistakes(
    await refusal('program = "p.c"\nexpect = ["sum == 1", "total == 1"]\n', "zh"),
  );
  expect(first).toMatchObject({ line: 2, column: 23, end_column: 35 });
  expect(others).toEqual([]);
});

test("a text about no place has none", () => {
  expect(placedMistakes("there is no file 'p.c': give it with the request")).toEqual([]);
  expect(placedMistakes("")).toEqual([]);
});

test("a line of the scenario that looks like a place is none", () => {
  const text = "s.toml:1:1: unknown key 'x'\n    1 | x:1:1: y\n      | ^";
  expect(placedMistakes(text)).toMatchObject([{ file: "s.toml", end_column: 2 }]);
});
