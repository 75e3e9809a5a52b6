import { join } from "node:path";

import type { DebugProtocol } from "@vscode/debugprotocol";
import { describe, expect, test } from "vitest";

import {
  type Editor,
  folderOf,
  only,
  openEditor,
  programOf,
  sample,
  unpowered,
} from "./support.js";

const loop = `int x;
int f()
{
  int c;

again:
  x = x + 1;
  c = x < 10;
  if (c) goto again;
  return x;
}
`;

async function launch(program: string): Promise<Editor> {
  const editor = await openEditor();
  await editor.launch(program);
  return editor;
}

async function dataId(editor: Editor, args: object): Promise<string | null> {
  return (await editor.request<{ dataId: string | null }>("dataBreakpointInfo", args)).dataId;
}

describe("of lines", () => {
  test("stop before the line", async () => {
    const path = programOf(loop);
    const editor = await launch(path);
    const { id } = only(await editor.breakpoints(path, [{ line: 8 }]));
    expect(await editor.run()).toMatchObject({
      reason: "breakpoint",
      threadId: 1,
      hitBreakpointIds: [id],
    });
    expect([await editor.line(), await editor.value("x")]).toEqual([8, "1"]);
  });

  test("are moved to the next statement", async () => {
    const path = programOf(loop);
    const editor = await launch(path);
    expect(await editor.breakpoints(path, [{ line: 4 }, { line: 8 }])).toMatchObject([
      { verified: true, line: 7 },
      { verified: true, line: 8 },
    ]);
  });

  test("are replaced", async () => {
    const path = programOf(loop);
    const editor = await launch(path);
    await editor.breakpoints(path, [{ line: 7 }]);
    await editor.breakpoints(path, []);
    expect(await editor.run()).toMatchObject({ reason: "pause" });
  });

  test("can be set while the card runs", async () => {
    const path = programOf("int x;\nint f()\n{\nagain:\n  x = x + 1;\n  goto again;\n}\n");
    const editor = await launch(path);
    await editor.client.configurationDoneRequest();
    await editor.breakpoints(path, [{ line: 6 }]);
    expect(await editor.stopped()).toMatchObject({ reason: "breakpoint" });
    expect(await editor.line()).toBe(6);
  });

  test("stop if their condition holds", async () => {
    const path = programOf(loop);
    const editor = await launch(path);
    await editor.breakpoints(path, [{ line: 8, condition: "x == 4" }]);
    await editor.run();
    expect(await editor.value("x")).toBe("4");
  });

  test.each(["3", ">= 3"])("stop from an arrival on: %s", async (hitCondition) => {
    const path = programOf(loop);
    const editor = await launch(path);
    await editor.breakpoints(path, [{ line: 8, hitCondition }]);
    await editor.run();
    expect(await editor.value("x")).toBe("3");
    await editor.move("continue");
    expect(await editor.value("x")).toBe("4");
  });

  test("log a text instead", async () => {
    const path = programOf(loop);
    const editor = await launch(path);
    await editor.breakpoints(path, [{ line: 8, condition: "x < 3", logMessage: "x = {x}" }]);
    expect(await editor.run()).toMatchObject({ reason: "pause" });
    expect(editor.output).toMatch(/^\[0\] x = 1\n\[0\] x = 2\npassed\n/);
  });

  test.each([
    ["no statement", { line: 50 }, "no statement of p.c is on line 50"],
    ["a condition that is none", { line: 7, condition: "y >" }, "y"],
    ["a hit condition that is none", { line: 7, hitCondition: "% 2" }, "must be a number"],
    ["a log text that is none", { line: 7, logMessage: "{x" }, "is not closed"],
  ])("%s: is refused, and the others stay", async (_, bad, why) => {
    const path = programOf(loop);
    const editor = await launch(path);
    const answers = await editor.breakpoints(path, [bad, { line: 10 }]);
    const refused = expect.stringContaining(why) as string;
    expect(answers).toMatchObject([
      { verified: false, message: refused },
      { verified: true, line: 10 },
    ]);
    expect(await editor.run()).toMatchObject({ hitBreakpointIds: [answers[1]?.id] });
    expect(await editor.line()).toBe(10);
  });

  test("of another file are refused", async () => {
    const editor = await launch(programOf(loop));
    expect(await editor.breakpoints("/elsewhere/p.c", [{ line: 7 }])).toMatchObject([
      { verified: false, message: "no statement of the program is in this file" },
    ]);
  });
});

test("of functions", async () => {
  const path = programOf(loop);
  const editor = await launch(path);
  const args = { breakpoints: [{ name: "g" }, { name: "f", condition: "x == 2" }] };
  const { breakpoints } = await editor.request<{ breakpoints: DebugProtocol.Breakpoint[] }>(
    "setFunctionBreakpoints",
    args,
  );
  expect(breakpoints).toMatchObject([
    { verified: false, message: "there is no function 'g'" },
    { verified: true },
  ]);
  expect(await editor.run()).toMatchObject({ hitBreakpointIds: [breakpoints[1]?.id] });
  expect([await editor.line(), await editor.value("x")]).toEqual([7, "2"]);
});

describe("of the disassembly", () => {
  const line = "int x;\nint f()\n{\n  x = 1; x = 2; x = 3;\n  return x;\n}\n";

  /** The references of the first statements. */
  async function references(editor: Editor, count: number): Promise<string[]> {
    const memoryReference = (await editor.frame()).instructionPointerReference;
    const { instructions } = await editor.request<{
      instructions: DebugProtocol.DisassembledInstruction[];
    }>("disassemble", { memoryReference, instructionCount: count });
    return instructions.map(({ address }) => address);
  }

  async function set(
    editor: Editor,
    breakpoints: DebugProtocol.InstructionBreakpoint[],
  ): Promise<DebugProtocol.Breakpoint[]> {
    const body = await editor.request<{ breakpoints: DebugProtocol.Breakpoint[] }>(
      "setInstructionBreakpoints",
      { breakpoints },
    );
    return body.breakpoints;
  }

  test("stop before a card statement within a line", async () => {
    const editor = await launch(programOf(line));
    const [first = "", , third = ""] = await references(editor, 3);
    const answers = await set(editor, [
      { instructionReference: first, offset: 1 },
      { instructionReference: third },
    ]);
    expect(answers).toMatchObject([
      { verified: true, line: 4 },
      { verified: true, line: 4 },
    ]);
    expect(await editor.run()).toMatchObject({
      reason: "instruction breakpoint",
      hitBreakpointIds: [answers[0]?.id],
    });
    expect(await editor.value("x")).toBe("1");
    expect(await editor.move("continue")).toMatchObject({ hitBreakpointIds: [answers[1]?.id] });
    expect(await editor.value("x")).toBe("2");
    expect(await editor.move("reverseContinue")).toMatchObject({
      reason: "instruction breakpoint",
      hitBreakpointIds: [answers[0]?.id],
    });
  });

  test("stop if their condition holds, from an arrival on", async () => {
    const editor = await launch(programOf(loop));
    const [, second = ""] = await references(editor, 2);
    const at = { instructionReference: second };
    await set(editor, [{ ...at, condition: "x != 2", hitCondition: ">= 3" }]);
    await editor.run();
    expect(await editor.value("x")).toBe("4");
  });

  test("are refused where no statement is, and the others stay", async () => {
    const editor = await launch(programOf(loop));
    const [first = ""] = await references(editor, 1);
    const answers = await set(editor, [
      { instructionReference: first, offset: -1 },
      { instructionReference: "main" },
      { instructionReference: first, condition: "y >" },
      { instructionReference: first, hitCondition: "% 2" },
      { instructionReference: first },
    ]);
    const message = "no statement of the program is at this address";
    expect(answers).toMatchObject([
      { verified: false, message },
      { verified: false, message },
      { verified: false },
      { verified: false, message: expect.stringContaining("must be a number") as string },
      { verified: true },
    ]);
    expect(await editor.run()).toMatchObject({ hitBreakpointIds: [answers[4]?.id] });
  });

  test("are replaced, and stay when the program is launched again", async () => {
    const editor = await launch(programOf(loop));
    const [, second = "", third = ""] = await references(editor, 3);
    await set(editor, [{ instructionReference: second }]);
    const [point] = await set(editor, [{ instructionReference: third }]);
    expect(await editor.run()).toMatchObject({ hitBreakpointIds: [point?.id] });
    await editor.request("restart");
    expect(await editor.stopped()).toMatchObject({ hitBreakpointIds: [point?.id] });
  });
});

describe("of data", () => {
  test("stop after a change", async () => {
    const editor = await launch(sample("01_sum/two_threads.toml"));
    const globals = await editor.scope("Globals");
    expect(await dataId(editor, { name: "sum", variablesReference: globals })).toBe("sum");
    const locals = await editor.scope("Locals", 1);
    const local = await dataId(editor, { name: "i", variablesReference: locals });
    expect(local).toBe("page1.i");
    const args = { breakpoints: [{ dataId: local }] };
    const { breakpoints } = await editor.request<{ breakpoints: DebugProtocol.Breakpoint[] }>(
      "setDataBreakpoints",
      args,
    );
    expect(await editor.run()).toMatchObject({
      reason: "data breakpoint",
      threadId: 2,
      hitBreakpointIds: [only(breakpoints).id],
    });
    expect(await editor.value("page1.i")).toBe("51");
  });

  test("of anything with a name", async () => {
    const editor = await launch(sample("10_trap/trap.toml"));
    const moving = await dataId(editor, { name: "axis1.moving" });
    await editor.request("setDataBreakpoints", { breakpoints: [{ dataId: moving }] });
    await editor.run();
    expect(await editor.value("axis1.moving")).toBe("1");
    expect(await dataId(editor, { name: "axis1.moving == 1" })).toBeNull();
  });
});

describe("exceptions", () => {
  // There is no axis 9.
  const refused = "int f()\n{\n  GT_AxisOn(9);\n  return 0;\n}\n";

  async function stopWith(program: string, filters: string[]): Promise<[string, string]> {
    const editor = await launch(program);
    await editor.request("setExceptionBreakpoints", { filters });
    const { reason } = await editor.run();
    const args = { threadId: 1 };
    const info = await editor.request<{ exceptionId: string }>("exceptionInfo", args);
    return [reason, info.exceptionId];
  }

  const unordered = "int x;\nint f()\n{\n  x = 1;\n}\nint g()\n{\n  x = 2;\n}\n";
  const both =
    'program = "p.c"\n[[thread]]\nfunction = "f"\n[[thread]]\nfunction = "g"\nthread = 1\n';
  const always = 'program = "p.c"\nalways = ["x < 3"]\n[[thread]]\nfunction = "f"\n';
  test.each([
    ["fault", () => sample("05_arrays/out_of_bounds.toml")],
    ["refusal", () => programOf(refused)],
    ["requirement", () => join(folderOf({ "p.c": loop, "a.toml": always }), "a.toml")],
    ["race", () => join(folderOf({ "p.c": unordered, "a.toml": both }), "a.toml")],
    ["warning", () => programOf(unpowered)],
  ])("%s", async (filter, program) => {
    expect(await stopWith(program(), [filter])).toEqual(["exception", filter]);
    const all = ["fault", "refusal", "requirement", "race", "warning"];
    const others = all.filter((other) => other !== filter);
    expect(await stopWith(program(), others)).toEqual(["pause", "end"]);
  });

  test("say what was wrong", async () => {
    const editor = await launch(programOf(refused));
    const { text } = await editor.run();
    expect(text).toMatch(/^a command was refused: GT_AxisOn\(9\) = 7: /);
    const info = await editor.request<{ description: string }>("exceptionInfo", { threadId: 1 });
    expect(info.description).toBe(text);
  });
});
