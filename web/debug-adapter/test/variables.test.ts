import { readFileSync } from "node:fs";
import { join } from "node:path";

import { describe, expect, test } from "vitest";

import { type Editor, folderOf, named, openEditor, programOf, sample } from "./support.js";

const program = `int total;
double list[3];
int f(int start)
{
  int i;
  i = start;
  list[1] = 2.5;
  total = i;
  return i;
}
`;

async function atTheEnd(path = programOf(program)): Promise<Editor> {
  const editor = await openEditor();
  await editor.launch(path);
  await editor.run();
  return editor;
}

async function set(editor: Editor, variablesReference: number, name: string, value: string) {
  const args = { variablesReference, name, value };
  return (await editor.request<{ value: string }>("setVariable", args)).value;
}

test("the scopes", async () => {
  const editor = await atTheEnd();
  const { scopes } = await editor.request<{ scopes: { name: string }[] }>("scopes", { frameId: 1 });
  expect(scopes.map(({ name }) => name)).toEqual([
    "Locals",
    "Globals",
    "Axes",
    "Inputs and outputs",
    "Card",
  ]);
});

describe("are shown", () => {
  test("locals of each thread", async () => {
    const editor = await atTheEnd(sample("01_sum/two_threads.toml"));
    for (const [thread, end] of [
      [0, "50"],
      [1, "100"],
    ] as const) {
      const locals = await editor.variables(await editor.scope("Locals", thread));
      expect(locals.map(({ name }) => name)).toEqual(["begin", "end", "i", "cc"]);
      expect(named(locals, "end")).toMatchObject({
        value: end,
        type: "int",
        evaluateName: `page${thread}.end`,
      });
    }
  });

  test("globals and the elements of arrays", async () => {
    const editor = await atTheEnd();
    const globals = await editor.variables(await editor.scope("Globals"));
    const list = named(globals, "list");
    expect(list).toMatchObject({ value: "[0, 2.5, 0]", type: "double", indexedVariables: 3 });
    const elements = await editor.variables(list.variablesReference);
    expect(named(elements, "[1]")).toMatchObject({ value: "2.5", evaluateName: "list[1]" });
    const args = { variablesReference: list.variablesReference, start: 1, count: 1 };
    const part = await editor.request<{ variables: unknown[] }>("variables", args);
    expect(part.variables).toEqual([elements[1]]);
  });

  test("axes with units", async () => {
    const editor = await atTheEnd(sample("10_trap/trap.toml"));
    const axes = await editor.variables(await editor.scope("Axes"));
    expect(axes.map(({ name }) => name)).toEqual([1, 2, 3, 4, 5, 6, 7, 8].map((i) => `axis${i}`));
    const first = await editor.variables(named(axes, "axis1").variablesReference);
    expect(named(first, "prfPos")).toMatchObject({
      value: "50000 pulse",
      evaluateName: "axis1.prfPos",
    });
  });

  test("an axis in the unit that its scenario gives it", async () => {
    const path = join(
      folderOf({
        "p.c": readFileSync(sample("10_trap/trap.c"), "utf8"),
        "mm.toml":
          'program = "p.c"\nuntil_ms = 1400\n' +
          '[[thread]]\nfunction = "move"\ninit = { distance = 50000 }\n' +
          '[[world.axis]]\naxis = 1\nunit = "mm"\npulses_per_unit = 1000\n',
      }),
      "mm.toml",
    );
    const editor = await atTheEnd(path);
    const axes = await editor.variables(await editor.scope("Axes"));
    expect(named(axes, "axis1")).toMatchObject({ value: "prfPos 50 mm" });
    const first = await editor.variables(named(axes, "axis1").variablesReference);
    expect(named(first, "prfVel")).toMatchObject({ value: "0 mm/s" });
    expect(named(axes, "axis2")).toMatchObject({ value: "prfPos 0 pulse" });
  });

  test("inputs and outputs", async () => {
    const editor = await atTheEnd();
    const all = await editor.variables(await editor.scope("Inputs and outputs"));
    expect(named(all, "gpi")).toMatchObject({ type: "input", evaluateName: "gpi" });
    expect(await editor.variables(named(all, "gpi").variablesReference)).toHaveLength(16);
    expect(named(all, "gpo")).toMatchObject({ type: "output", variablesReference: 0 });
    const adc = await editor.variables(named(all, "adc1").variablesReference);
    expect(adc.map(({ name }) => name)).toEqual(["value", "volts"]);
  });

  test("the card", async () => {
    const editor = await atTheEnd();
    const card = await editor.variables(await editor.scope("Card"));
    expect(named(card, "statements").value).toBe("4");
    expect(named(card, "over").value).toBe("quiet");
    const profile = await editor.variables(named(card, "profile1").variablesReference);
    expect(named(profile, "pos").evaluateName).toBe("profile1.pos");
  });
});

describe("are changed", () => {
  test("variables", async () => {
    const editor = await openEditor();
    await editor.enter(programOf(program));
    await editor.move("next");
    expect(await set(editor, await editor.scope("Locals"), "start", "7")).toBe("7");
    const globals = await editor.scope("Globals");
    expect(await set(editor, globals, "total", "-3")).toBe("-3");
    const { variablesReference } = named(await editor.variables(globals), "list");
    expect(await set(editor, variablesReference, "[2]", "1.25")).toBe("1.25");
    expect(await editor.value("list")).toBe("[0, 0, 1.25]");
    await editor.move("continue");
    expect(await editor.value("total")).toBe("7"); // copied from `start`
  });

  test("a double to a value that the card has", async () => {
    const editor = await openEditor();
    await editor.enter(programOf(program));
    const { variablesReference } = named(
      await editor.variables(await editor.scope("Globals")),
      "list",
    );
    // Fixed point with 16 bits after the point.
    expect(await set(editor, variablesReference, "[0]", "0.1")).toBe(String(6553 / 65536));
  });

  test("input pins and voltages", async () => {
    const editor = await openEditor();
    await editor.enter(programOf("int x;\nint f()\n{\nagain:\n  goto again;\n}\n"));
    const all = await editor.variables(await editor.scope("Inputs and outputs"));
    expect(await set(editor, named(all, "gpi").variablesReference, "3", "1")).toBe("1");
    expect(await set(editor, named(all, "adc2").variablesReference, "volts", "5")).toBe("5");
    for (let cycle = 0; cycle < 5; ++cycle) await editor.move("stepOut");
    expect(await editor.value("gpi")).toBe("4");
    expect(Number(await editor.value("adc2.volts"))).toBeCloseTo(5, 2);
  });

  test.each([
    ["Globals", "total", "many", "'many' is no number"],
    ["Globals", "total", "", "'' is no number"],
    ["Globals", "nothing", "1", "nothing"],
    ["Card", "moment", "1", "can be changed"],
    ["Inputs and outputs", "gpo", "1", "can be changed"],
  ])("%s: %s = '%s' is refused", async (scope, name, value, why) => {
    const editor = await atTheEnd();
    await expect(set(editor, await editor.scope(scope), name, value)).rejects.toThrow(why);
  });

  test("what an earlier stop has shown can no longer be changed", async () => {
    const editor = await openEditor();
    await editor.enter(programOf(program));
    const globals = await editor.scope("Globals");
    await editor.move("next");
    await expect(set(editor, globals, "total", "1")).rejects.toThrow("look again");
  });

  test("expressions", async () => {
    const editor = await openEditor();
    await editor.enter(programOf(program));
    const change = async (expression: string, value: string) => {
      const args = { expression, value, frameId: 1 };
      return (await editor.request<{ value: string }>("setExpression", args)).value;
    };
    expect(await change("i", "4")).toBe("4");
    expect(await editor.value("page0.i")).toBe("4");
    expect(await change("list[2]", "0.5")).toBe("0.5");
    await expect(change("axis1.prfPos", "1")).rejects.toThrow("axis1.prfPos");
  });
});

describe("are evaluated", () => {
  test("locals of the frame first", async () => {
    const editor = await atTheEnd(sample("01_sum/two_threads.toml"));
    expect(await editor.value("end", 1)).toBe("50");
    expect(await editor.value("end", 2)).toBe("100");
    expect(await editor.value("sum", 2)).toBe("5050");
    await expect(editor.value("end")).rejects.toThrow("end");
  });

  test("arrays, which can be opened", async () => {
    const editor = await atTheEnd();
    const args = { expression: "list", context: "hover", frameId: 1 };
    const { result, variablesReference } = await editor.request<{
      result: string;
      variablesReference: number;
    }>("evaluate", args);
    expect(result).toBe("[0, 2.5, 0]");
    expect(await editor.variables(variablesReference)).toHaveLength(3);
    expect(await editor.value("list[1]", 1)).toBe("2.5");
  });

  test("conditions", async () => {
    const editor = await atTheEnd();
    expect(await editor.value("total == 0 && axis1.moving == 0")).toBe("true");
    await expect(editor.value("total ==")).rejects.toThrow();
  });
});
