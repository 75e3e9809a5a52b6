import { readFileSync } from "node:fs";
import { join } from "node:path";

import { expect, test } from "vitest";

import { startEngine } from "../../engine/test/support.js";
import { folder } from "./support.js";

type Snippets = Record<string, { prefix: string; body: string[] }>;

/** A snippet as it is before the user changes anything. */
function bodiesOf(file: string): Record<string, string> {
  const snippets = JSON.parse(readFileSync(join(folder, "snippets", file), "utf8")) as Snippets;
  const expanded = (body: string[]) =>
    body
      .join("\n")
      .replace(/\$\{\d+:([^}]*)\}/g, "$1")
      .replace(/\$\d+/g, "");
  return Object.fromEntries(
    Object.entries(snippets).map(([name, { body }]) => [name, `${expanded(body)}\n`]),
  );
}

test.each(Object.entries(bodiesOf("program.json")))("%s compiles", async (_, text) => {
  const { diagnostics } = await startEngine().check({ main: "p.c", files: { "p.c": text } });
  expect(diagnostics).toEqual([]);
});

test("the snippets of a scenario fit together", async () => {
  const bodies = bodiesOf("scenario.json");
  const { "oncard scenario": scenario, "oncard proof": proof, ...tables } = bodies;
  const text = [proof, scenario, ...Object.values(tables)].join("");
  const program = "int sum;\nint run(int times)\n{\n  sum = times;\n  return 0;\n}\n";
  const files = { "s.toml": text, "program.c": program };
  expect(await startEngine().run({ main: "s.toml", files })).toMatchObject({
    compiled: true,
    run: { passed: true },
  });
});
