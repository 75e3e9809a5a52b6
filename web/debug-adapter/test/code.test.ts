import type { DebugProtocol } from "@vscode/debugprotocol";
import { join } from "node:path";
import { describe, expect, test } from "vitest";

import { type Editor, folderOf, only, openEditor, programOf, sample } from "./support.js";

const sum = sample("01_sum/sum.c");

async function enter(program: string): Promise<Editor> {
  const editor = await openEditor();
  await editor.enter(program);
  return editor;
}

describe("sources", () => {
  test("are listed with what they include", async () => {
    const folder = folderOf({
      "main.c": '#include "part.c"\nint x;\nint f()\n{\n  x = 1;\n  return x;\n}\n',
      "part.c": "int y;\nint g()\n{\n  y = 2;\n  return y;\n}\n",
      "both.toml": 'program = "main.c"\n[[thread]]\nfunction = "g"\n',
    });
    const editor = await enter(join(folder, "both.toml"));
    const { sources } = await editor.request<{ sources: DebugProtocol.Source[] }>("loadedSources");
    const paths = ["main.c", "part.c"].map((name) => join(folder, name));
    expect(sources.map(({ path }) => path).sort()).toEqual(paths);
    expect((await editor.frame()).source).toMatchObject({ name: "part.c", path: paths[1] });
    const points = await editor.breakpoints(join(folder, "part.c"), [{ line: 5 }]);
    expect(points).toMatchObject([{ verified: true, line: 5 }]);
    expect(await editor.move("continue")).toMatchObject({ reason: "breakpoint" });
    expect(await editor.line()).toBe(5);
  });

  test("can be read", async () => {
    const program = "// 求和\nint f()\n{\n}\n";
    const path = programOf(program);
    const editor = await enter(path);
    const read = (wanted: string) =>
      editor.request<{ content: string }>("source", { source: { path: wanted } });
    expect((await read(path)).content).toBe(program);
    await expect(read("/elsewhere/p.c")).rejects.toThrow("no file of the program");
  });
});

describe("the disassembly", () => {
  async function disassemble(
    editor: Editor,
    instructionOffset: number,
    instructionCount: number,
  ): Promise<DebugProtocol.DisassembledInstruction[]> {
    const memoryReference = (await editor.frame()).instructionPointerReference;
    const args = { memoryReference, instructionOffset, instructionCount };
    return (
      await editor.request<{ instructions: DebugProtocol.DisassembledInstruction[] }>(
        "disassemble",
        args,
      )
    ).instructions;
  }

  test("has the statements of the card with their lines", async () => {
    const editor = await enter(sample("01_sum/two_threads.toml"));
    const rows = await disassemble(editor, 0, 7);
    expect(rows.map(({ instruction, line }) => `${line ?? ""} ${instruction}`)).toEqual([
      "13 i := begin",
      "15 cc := i > end",
      "16 if cc goto 6",
      "17 sum := sum + i",
      "18 i := i + 1",
      "19 goto 1",
      "21 return sum",
    ]);
    expect(rows[0]).toMatchObject({ symbol: "add", location: { path: sum } });
    expect(rows[1]?.symbol).toBeUndefined();
  });

  test("follows the thread", async () => {
    const editor = await enter(sample("01_sum/two_threads.toml"));
    await editor.move("next", 0, { granularity: "instruction" });
    await editor.move("next", 0, { granularity: "instruction" });
    expect(only(await disassemble(editor, 0, 1)).instruction).toBe("if cc goto 6");
    expect(only(await disassemble(editor, 2, 1)).instruction).toBe("i := i + 1");
  });

  test("has as many rows as wanted, also outside of the program", async () => {
    const editor = await enter(sample("01_sum/two_threads.toml"));
    const rows = await disassemble(editor, -50, 100);
    expect(rows).toHaveLength(100);
    expect(new Set(rows.map(({ address }) => address)).size).toBe(100);
    expect(rows.map(({ presentationHint }) => presentationHint)).toEqual([
      ...Array<string>(50).fill("invalid"),
      ...Array<undefined>(7).fill(undefined),
      ...Array<string>(43).fill("invalid"),
    ]);
  });
});

describe("the memory of a data page", () => {
  interface Memory {
    address: string;
    data: string;
    unreadableBytes: number;
  }

  async function read(editor: Editor, memoryReference: string, offset: number, count: number) {
    const args = { memoryReference, offset, count };
    const { data, ...rest } = await editor.request<Memory>("readMemory", args);
    return { ...rest, bytes: [...Buffer.from(data, "base64")] };
  }

  test("has the slots, 8 bytes each", async () => {
    const editor = await enter(sample("01_sum/two_threads.toml"));
    expect(await read(editor, "page1", 0, 20)).toEqual({
      address: "0x0",
      unreadableBytes: 0,
      bytes: [51, 0, 0, 0, 0, 0, 0, 0, 100, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
    });
  });

  test("negative numbers are two's complements", async () => {
    const path = programOf("int f()\n{\n  int i;\n  i = -2;\n  return i;\n}\n");
    const editor = await enter(path);
    await editor.move("continue");
    expect((await read(editor, "page0", 0, 8)).bytes).toEqual([
      254, 255, 255, 255, 255, 255, 255, 255,
    ]);
  });

  test("begins at a variable when asked from there", async () => {
    const editor = await enter(sample("01_sum/two_threads.toml"));
    const locals = await editor.variables(await editor.scope("Locals"));
    const end = locals.find(({ name }) => name === "end");
    expect(end?.memoryReference).toBe("page0:1");
    expect(await read(editor, "page0:1", 0, 1)).toMatchObject({ address: "0x8", bytes: [50] });
  });

  test("ends with its 1024 slots", async () => {
    const editor = await enter(sample("01_sum/two_threads.toml"));
    expect(await read(editor, "page0", 8190, 10)).toMatchObject({
      bytes: [0, 0],
      unreadableBytes: 8,
    });
    expect(await read(editor, "page0", -8, 8)).toMatchObject({ bytes: [], unreadableBytes: 8 });
  });

  test("is that of a page", async () => {
    const editor = await enter(sample("01_sum/two_threads.toml"));
    await expect(read(editor, "heap", 0, 8)).rejects.toThrow("'heap' is no data page");
    await expect(read(editor, "page32", 0, 8)).rejects.toThrow("page");
  });
});
