import type { DebugProtocol } from "@vscode/debugprotocol";
import { describe, expect, test } from "vitest";

import { type Editor, named, openEditor, programOf, sample } from "./support.js";

const program = `int total;
int gpi;
double list[12];
int f(int start)
{
  int i;
  int cells[2];
  i = start;
  cells[1] = i;
  total = i;
  list[1] = 2.5;
  return i;
}
`;

type Item = DebugProtocol.CompletionItem;

/** What is offered behind a text: the cursor is at `|`, or at its end. */
async function offered(editor: Editor, text: string, args: object = {}): Promise<Item[]> {
  const at = text.includes("|") ? text.indexOf("|") : text.length;
  const request = { text: text.replace("|", ""), column: at + 1, frameId: 1, ...args };
  const { targets } = await editor.request<{ targets: Item[] }>("completions", request);
  return targets;
}

const labels = (items: readonly Item[]) => items.map(({ label }) => label);

async function atTheBeginning(path = programOf(program)): Promise<Editor> {
  const editor = await openEditor();
  await editor.enter(path);
  return editor;
}

describe("names are offered", () => {
  test.each([
    ["locals of the frame", "1 + sta", ["start", "statements"]],
    ["locals of pages", "page0.", ["page0.start", "page0.i", "page0.cells"]],
    ["globals", "lis", ["list"]],
    ["elements behind a bracket", "cells[", ["cells[0]", "cells[1]"]],
    ["elements that begin with digits", "list[1", ["list[1]", "list[10]", "list[11]"]],
    ["elements of arrays on pages", "page0.cells[", ["page0.cells[0]", "page0.cells[1]"]],
    ["values of the card", "axis2.prf", ["axis2.prfPos", "axis2.prfVel", "axis2.prfAcc"]],
    ["bits of inputs, from 1", "home[", [1, 2, 3, 4, 5, 6, 7, 8].map((bit) => `home[${bit}]`)],
    ["values of threads", "thread0.r", ["thread0.result", "thread0.run"]],
    ["the time", "1 < clo", ["clock"]],
    ["without regard to case", "AXIS1.PRFP", ["axis1.prfPos"]],
    ["behind an operator without a blank", "total>lis", ["list"]],
    ["up to the cursor", "lis| == 3", ["list"]],
    ["nothing that is hidden by a global", "gpi[", []],
    ["nothing in a number", "0x1", []],
  ])("%s: %s", async (_, text, expected) => {
    expect(labels(await offered(await atTheBeginning(), text))).toEqual(expected);
  });

  test("of the selected frame", async () => {
    const editor = await atTheBeginning(sample("01_sum/two_threads.toml"));
    expect(labels(await offered(editor, "1 + beg", { frameId: 2 }))).toEqual(["begin"]);
    expect(labels(await offered(editor, "1 + beg", { frameId: undefined }))).toEqual([]);
    expect(labels(await offered(editor, "page1.be"))).toEqual(["page1.begin"]);
  });

  test("in the line that is asked for", async () => {
    const editor = await atTheBeginning();
    expect(labels(await offered(editor, "total\nlis", { line: 2, column: 4 }))).toEqual(["list"]);
  });

  test("and each of them can be evaluated", async () => {
    const editor = await atTheBeginning();
    const items = [...(await offered(editor, "1 + ")), ...(await offered(editor, "home["))];
    expect(items.length).toBeGreaterThan(100);
    for (const { label } of items) await editor.value(label, 1);
  });
});

describe("commands are offered", () => {
  test.each([
    ["at the beginning of a line", "cy", ["cycle"]],
    ["behind blanks", "  cy", ["cycle"]],
    ["the threads that can run", "thread ", ["thread 0"]],
    ["what follows", "back c", ["back change"]],
    ["names behind it", "back change tot", ["total"]],
    ["no locals for going back without a page", "back change star", []],
    ["no names as files", "record to", []],
    ["not behind something else", "1 + cy", []],
  ])("%s: %s", async (_, text, expected) => {
    expect(labels(await offered(await atTheBeginning(), text))).toEqual(expected);
  });

  test("with a blank if something must follow", async () => {
    const [item] = await offered(await atTheBeginning(), " back");
    expect(item).toMatchObject({ text: "back change ", start: 2, length: 4, type: "keyword" });
  });
});

describe("what was typed is replaced", () => {
  test("from the beginning of the name to the cursor", async () => {
    const [item] = await offered(await atTheBeginning(), "total == lis| + 1");
    expect(item).toMatchObject({ label: "list", start: 10, length: 3, detail: "double" });
  });

  test("in the columns of the editor", async () => {
    const editor = await openEditor();
    await editor.initialize({ columnsStartAt1: false });
    const initialized = editor.client.waitForEvent("initialized");
    await editor.request("launch", { program: programOf(program), stopOnEntry: true });
    await initialized;
    const [item] = await offered(editor, "1 + lis", { column: 7 });
    expect(item).toMatchObject({ label: "list", start: 4, length: 3 });
  });
});

test("locals come first, then globals, commands, other pages and the card", async () => {
  const editor = await atTheBeginning();
  const sorted = (await offered(editor, "")).sort((a, b) =>
    (a.sortText ?? a.label) < (b.sortText ?? b.label) ? -1 : 1,
  );
  const order = ["start", "i", "cells", "total", "gpi", "list", "cycle", "page0.start"];
  const wanted = labels(sorted).filter((label) => [...order, "axis1.prfPos"].includes(label));
  expect(wanted).toEqual([...order, "axis1.prfPos"]);
  expect(
    named(
      sorted.map((item) => ({ ...item, name: item.label })),
      "i",
    ).detail,
  ).toBe("int");
});
