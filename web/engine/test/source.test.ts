import { expect, test } from "vitest";

import { startEngine } from "./support.js";

const main = "p.c";
const files = {
  [main]: '#include "h.h"\nint f(int k)\n{\n  x = k;\n  GT_SetVel(AXIS, 2.5);\n  return x;\n}\n',
  "h.h": "#define AXIS 2\nint x;\n",
};
const x = { main, files, line: 4, column: 3 };

test("what stands at a place, and what can", async () => {
  const engine = startEngine();
  const velocity = { main, files, line: 5, column: 19 };
  expect(await engine.describe(x)).toMatchObject({ kind: "global", declaration: "int x", slot: 0 });
  expect(await engine.describe({ ...x, column: 1 })).toBeNull();
  expect(await engine.signature(velocity)).toMatchObject({ name: "GT_SetVel", active: 1 });
  const { items, argument } = await engine.complete(velocity);
  expect(items.map(({ label }) => label)).toEqual(expect.arrayContaining(["k", "x", "AXIS"]));
  expect(argument).toMatchObject({ name: "vel", unit: "pulse/ms" });
});

test("names in all files", async () => {
  const engine = startEngine();
  const declared = { file: "h.h", line: 2, column: 5 };
  expect(await engine.definition(x)).toMatchObject([declared]);
  const used = [
    { file: main, line: 4, access: "write" },
    { file: main, line: 6, access: "read" },
  ];
  expect(await engine.references(x)).toMatchObject([...used, { ...declared }]);
  expect(await engine.references(x, false)).toMatchObject(used);
  expect(await engine.rename(x, "y")).toMatchObject([{}, {}, { ...declared, text: "y" }]);
  await expect(engine.rename(x, "k")).rejects.toThrow("choose another");
});

test("whole files", async () => {
  const engine = startEngine();
  const header = { main, files, file: "h.h" };
  expect(await engine.outline(header)).toMatchObject([{ name: "AXIS" }, { name: "x" }]);
  expect(await engine.tokens(header)).toContainEqual(
    expect.objectContaining({ kind: "global", line: 2, declaration: true }),
  );
  expect(await engine.folds({ main, files })).toEqual([{ kind: "function", line: 3, end_line: 7 }]);
  expect(await engine.hints({ main, files })).toContainEqual(
    expect.objectContaining({ kind: "argument", label: "vel [pulse/ms]:", line: 5 }),
  );
});

test("corrections of a whole program", async () => {
  const wrong = { main, files: { [main]: "int x;\nint f()\n{\n  x = 1 + 2 + 3\n}\n" } };
  const { compiled, count, files: changed } = await startEngine().fixes(wrong);
  expect({ compiled, count }).toEqual({ compiled: true, count: 2 });
  expect(changed).toMatchObject([{ path: main }]);
});

test("structured C as the card's language", async () => {
  const structured = "//@ structured\nint x;\nint f()\n{\n  x = x + 1;\n}\n";
  const lowered = await startEngine().lower({ main, files: { [main]: structured } });
  const line = lowered.text?.split("\n").findIndex((text) => text.includes("x = x + 1;")) ?? -1;
  expect(lowered.origins?.[line]).toEqual({ file: main, line: 5 });
});

test("structured C beside what it becomes", async () => {
  const structured = "//@ structured\nint x;\nint f()\n{\n  ++x;\n}\n";
  const { compiled, rows } = await startEngine().twoColumns({
    main,
    files: { [main]: structured },
  });
  expect(compiled).toBe(true);
  expect(rows).toContainEqual({
    file: main,
    line: 5,
    text: "  ++x;",
    card: "  x = x + 1;",
    card_line: expect.any(Number) as number,
  });
});
