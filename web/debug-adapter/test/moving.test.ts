import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";

import type { DebugProtocol } from "@vscode/debugprotocol";
import { describe, expect, test } from "vitest";

import { folderOf, named, openEditor, programOf, sample, type Editor } from "./support.js";

const twoOnALine = "int x;\nint f()\n{\n  x = 1; x = 2;\n  x = 3;\n  return x;\n}\n";
const endless = "int x;\nint f()\n{\nagain:\n  x = x + 1;\n  goto again;\n}\n";
const twoThreads = sample("01_sum/two_threads.toml");
const sum = sample("01_sum/sum.c");
const instruction = { granularity: "instruction" };

async function enter(program: string): Promise<Editor> {
  const editor = await openEditor();
  await editor.enter(program);
  return editor;
}

/** A member of the state, as the scope of the card shows it. */
async function fact(editor: Editor, name: string): Promise<string> {
  return named(await editor.variables(await editor.scope("Card")), name).value;
}

async function targets(editor: Editor, line: number): Promise<DebugProtocol.GotoTarget[]> {
  const args = { source: { path: sum }, line };
  return (await editor.request<{ targets: DebugProtocol.GotoTarget[] }>("gotoTargets", args))
    .targets;
}

describe("steps", () => {
  test("next goes to the beginning of a line", async () => {
    const editor = await enter(programOf(twoOnALine));
    expect(await editor.move("next")).toMatchObject({ reason: "step", threadId: 1 });
    const lines = [await editor.line()];
    for (let i = 0; i < 2; ++i) {
      await editor.move("next");
      lines.push(await editor.line());
    }
    expect(lines).toEqual([4, 5, 6]);
  });

  test("stepIn executes one statement", async () => {
    const editor = await enter(programOf(twoOnALine));
    await editor.move("stepIn");
    expect([await editor.line(), await editor.value("x")]).toEqual([4, "1"]);
    await editor.move("stepIn");
    expect([await editor.line(), await editor.value("x")]).toEqual([5, "2"]);
  });

  test("next in the disassembly executes one statement", async () => {
    const editor = await enter(programOf(twoOnALine));
    await editor.move("next", 0, instruction);
    expect([await editor.line(), await editor.value("x")]).toEqual([4, "1"]);
  });

  test("stepOut goes to the end of the cycle", async () => {
    const editor = await enter(programOf(endless));
    for (const cycle of ["1", "2"]) {
      expect(await editor.move("stepOut")).toMatchObject({ reason: "step" });
      expect(await fact(editor, "cycle")).toBe(cycle);
      expect(await fact(editor, "statements_left")).toBe("0");
    }
  });

  test("the other threads take their turns", async () => {
    const editor = await enter(twoThreads);
    expect(await editor.move("stepIn", 1)).toMatchObject({ threadId: 2 });
    expect([await editor.line(0), await editor.line(1)]).toEqual([15, 15]);
  });

  test("a thread that has ended cannot be stepped", async () => {
    const editor = await enter(programOf(twoOnALine));
    await editor.move("continue");
    await expect(editor.move("next")).rejects.toThrow("thread 0 does not run");
  });
});

describe("back", () => {
  test("stepBack goes to the line before, or the statement before", async () => {
    const editor = await enter(programOf(twoOnALine));
    await editor.move("continue");
    await editor.move("stepBack");
    expect(await editor.line()).toBe(6);
    await editor.move("stepBack");
    expect([await editor.line(), await editor.value("x")]).toEqual([5, "2"]);
    await editor.move("stepBack", 0, instruction);
    expect([await editor.line(), await editor.value("x")]).toEqual([4, "1"]);
  });

  test("stepBack at the beginning stays there", async () => {
    const editor = await enter(programOf(twoOnALine));
    expect(await editor.move("stepBack")).toMatchObject({
      reason: "entry",
      text: "this is the beginning",
    });
  });

  test("reverseContinue goes to the breakpoint before, then to the beginning", async () => {
    const path = programOf(twoOnALine);
    const editor = await enter(path);
    await editor.breakpoints(path, [{ line: 5 }]);
    await editor.move("continue"); // to the breakpoint
    await editor.move("continue"); // to the end
    expect(await editor.move("reverseContinue")).toMatchObject({ reason: "breakpoint" });
    expect([await editor.line(), await editor.value("x")]).toEqual([5, "2"]);
    expect(await editor.move("reverseContinue")).toMatchObject({ reason: "entry" });
    expect(await editor.value("x")).toBe("0");
  });

  test("a choice is remembered", async () => {
    const editor = await enter(twoThreads);
    await editor.console("thread 1");
    await editor.stopped();
    const after = await fact(editor, "hash");
    await editor.move("stepBack", 1, instruction);
    expect(await fact(editor, "statements")).toBe("0");
    // The policy would let thread 0 go first.
    await editor.move("stepIn", 1);
    expect(await fact(editor, "statements")).toBe("1");
    expect(await fact(editor, "hash")).toBe(after);
  });
});

describe("goto lets a thread execute its next statement", () => {
  test("of the threads that stand at a line", async () => {
    const editor = await enter(twoThreads);
    await editor.move("next"); // into the first cycle
    expect((await targets(editor, 13)).map(({ id }) => id)).toEqual([0, 1]);
    expect(await targets(editor, 15)).toEqual([]);
    await editor.request("goto", { threadId: 1, targetId: 1 });
    expect(await editor.stopped()).toMatchObject({ reason: "goto", threadId: 2 });
    expect([await editor.line(0), await editor.line(1)]).toEqual([13, 15]);
    expect((await targets(editor, 13)).map(({ id }) => id)).toEqual([0]);
  });

  test("only if it can", async () => {
    const editor = await enter(programOf(twoOnALine));
    await editor.move("continue");
    await expect(editor.request("goto", { threadId: 1, targetId: 0 })).rejects.toThrow("thread 0");
  });
});

describe("a program without an end", () => {
  test("can be paused, and goes on", async () => {
    const editor = await openEditor();
    await editor.launch(programOf(endless));
    await editor.client.configurationDoneRequest();
    await editor.request("pause", { threadId: 1 });
    expect(await editor.stopped()).toMatchObject({ reason: "pause", threadId: 1 });
    const first = Number(await fact(editor, "moment"));
    await editor.request("continue", { threadId: 1 });
    await editor.request("pause", { threadId: 1 });
    await editor.stopped();
    expect(Number(await fact(editor, "moment"))).toBeGreaterThan(first);
  });

  test("cannot be moved while it runs, but can be looked at", async () => {
    const editor = await openEditor();
    await editor.launch(programOf(endless));
    await editor.client.configurationDoneRequest();
    await expect(editor.move("next")).rejects.toThrow("the card is running");
    await expect(editor.console("cycle")).rejects.toThrow("the card is running");
    expect(Number(await editor.value("x"))).toBeGreaterThan(0);
    await editor.request("pause", { threadId: 1 });
    await editor.stopped();
  });
});

test("32 threads", async () => {
  const threads = Array.from(
    { length: 32 },
    (_, i) => `[[thread]]\nthread = ${i}\nfunction = "f"\n`,
  );
  const folder = folderOf({
    "all.toml": `program = "p.c"\n${threads.join("")}`,
    "p.c": "int x;\nint f()\n{\n  int i;\n  i = x;\n  x = i + 1;\n  return i;\n}\n",
  });
  const editor = await enter(join(folder, "all.toml"));
  const { body } = await editor.client.threadsRequest();
  expect(body.threads).toEqual(
    Array.from({ length: 32 }, (_, i) => ({ id: i + 1, name: `${i} f` })),
  );
  expect(await editor.move("next", 31)).toMatchObject({ threadId: 32 });
  for (let i = 0; i < 3; ++i) {
    await editor.console("thread 31");
    await editor.stopped();
  }
  expect(await editor.value("x")).toBe("1");
  expect(await editor.move("continue")).toMatchObject({ text: /every thread has ended/ });
  // All of the others have read the sum before one of them wrote it.
  expect(await editor.value("x")).toBe("2");
});

describe("the console", () => {
  test("cycle", async () => {
    const editor = await enter(programOf(endless));
    await editor.console("cycle");
    expect(await editor.stopped()).toMatchObject({ reason: "step" });
    expect(await fact(editor, "cycle")).toBe("1");
  });

  test("rest waits until no axis moves", async () => {
    const editor = await enter(sample("10_trap/trap.toml"));
    await editor.console("rest");
    await editor.stopped();
    expect(await editor.value("axis1.moving")).toBe("0");
    expect(await editor.value("axis1.prfPos")).toBe("50000");
  });

  test("rest tells the editor that the card moves", async () => {
    const editor = await enter(programOf(endless));
    const continued = editor.client.waitForEvent("continued");
    await editor.console("rest");
    expect((await continued).body).toMatchObject({ allThreadsContinued: true });
    await editor.request("pause", { threadId: 1 });
    expect(await editor.stopped()).toMatchObject({ reason: "pause" });
  });

  test("thread N", async () => {
    const editor = await enter(twoThreads);
    await editor.console("thread 1");
    expect(await editor.stopped()).toMatchObject({ reason: "goto", threadId: 2 });
    await expect(editor.console("thread 5")).rejects.toThrow("thread 5");
  });

  test("statement N goes to after a statement of the run, forward and back", async () => {
    const editor = await enter(programOf("int x;\nint f()\n{\n  x = 1;\n  x = 2;\n  x = 3;\n}\n"));
    for (const [number, x] of [
      [2, "2"],
      [3, "3"],
      [1, "1"],
      [0, "0"],
    ] as const) {
      await editor.console(`statement ${number}`);
      expect(await editor.stopped()).toMatchObject({ reason: "step" });
      expect([await editor.value("x"), await editor.console("statement")]).toEqual([
        x,
        String(number),
      ]);
    }
    await editor.console("statement 99");
    expect(await editor.stopped()).toMatchObject({ text: /every thread has ended/ });
    expect(await editor.value("x")).toBe("3");
  });

  test("back change NAME", async () => {
    const editor = await enter(twoThreads);
    await editor.move("continue");
    await editor.console("back change sum");
    await editor.stopped();
    expect(await editor.value("sum")).toBe("4950");
    await expect(editor.console("back change nothing")).rejects.toThrow("nothing");
  });

  test("record FILE writes a recording beside the program", async () => {
    const path = programOf(twoOnALine);
    const editor = await enter(path);
    await editor.move("next");
    await editor.move("next");
    const file = join(dirname(path), "a.schedule");
    expect(await editor.console("record a.schedule")).toBe(file);
    expect(readFileSync(file, "utf8")).toMatch(/^oncard-schedule 1\n/);
    await expect(editor.console("record ../a.schedule")).rejects.toThrow("without a folder");
  });

  test("help", async () => {
    const help = await (await enter(programOf(endless))).console("help");
    for (const command of ["cycle", "rest", "thread", "statement", "back change", "record"]) {
      expect(help).toContain(command);
    }
  });

  test("anything else is evaluated", async () => {
    const editor = await enter(twoThreads);
    expect(await editor.console("sum")).toBe("0");
    expect(await editor.console("sum == 1")).toBe("false");
    await expect(editor.console("rests")).rejects.toThrow("rests");
  });
});
