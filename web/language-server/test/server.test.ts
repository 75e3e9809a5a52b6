import { chmodSync, readFileSync } from "node:fs";
import { join } from "node:path";

import { describe, expect, test } from "vitest";
import { type CodeAction, DiagnosticSeverity } from "vscode-languageserver";

import { uriOf } from "../src/paths.js";
import {
  changesOf,
  edited,
  folderOf,
  oncard,
  openEditor,
  sample,
  wasm,
  withoutModule,
} from "./support.js";

const scenario = 'program = "p.c"\n';

describe.each([
  ["the command", { ONCARD: oncard }, false],
  ["the module", { ONCARD_MODULE: wasm }, withoutModule],
])("diagnostics by %s", (_, environment, cannot) => {
  test.skipIf(cannot)("come while one types", async () => {
    const folder = folderOf({ "s.toml": scenario, "p.c": "" });
    const uri = uriOf(join(folder, "p.c"));
    const editor = await openEditor(environment);
    await editor.open(uri, "int sum;\nint f()\n{\n  /* 🙂 */ sum = total;\n}\n");
    const [undeclared] = await editor.diagnostics(uri, (list) => list.length === 1);
    expect(undeclared).toMatchObject({
      code: "MP027",
      severity: DiagnosticSeverity.Error,
      source: "oncard",
      range: { start: { line: 3, character: 17 }, end: { line: 3, character: 22 } },
    });
    await editor.change(uri, "1", {
      start: { line: 3, character: 17 },
      end: { line: 3, character: 22 },
    });
    await editor.diagnostics(uri, (list) => list.length === 0);
  });

  test.skipIf(cannot)("are in the file that has the mistake, as it is on the screen", async () => {
    const folder = folderOf({ "s.toml": scenario, "p.c": "", "h.h": "int a;\n" });
    const [program, header] = [uriOf(join(folder, "p.c")), uriOf(join(folder, "h.h"))];
    const editor = await openEditor(environment);
    await editor.open(program, '#include "h.h"\nint f()\n{\n  a = 1;\n}\n');
    await editor.diagnostics(program, (list) => list.length === 0);
    await editor.open(header, "int a\n");
    await editor.diagnostics(header, ([first]) => first?.code === "MP041");
    await editor.close(header);
    await editor.change(program, '#include "h.h"\nint f()\n{\n  a = 2;\n}\n');
    await editor.diagnostics(header, (list) => list.length === 0);
  });

  test.skipIf(cannot)("of a scenario are at their place", async () => {
    const folder = folderOf({ "p.c": "int n;\nint f()\n{\n  n = 1;\n}\n" });
    const uri = uriOf(join(folder, "s.toml"));
    const editor = await openEditor(environment);
    await editor.open(uri, 'program = "p.c"\nexpect = ["n == 1", "m == 1"]\n', "toml");
    const [unknown] = await editor.diagnostics(uri, (list) => list.length === 1);
    expect(unknown).toMatchObject({
      range: { start: { line: 1, character: 20 }, end: { line: 1, character: 28 } },
      message: expect.stringContaining("nothing is named 'm'") as string,
    });
  });
});

test("notes of a message are shown with their place", async () => {
  const uri = uriOf("/nowhere/p.c");
  const editor = await openEditor();
  await editor.open(uri, "//@ final: a == 0\nint a;\nint a;\n");
  const list = await editor.diagnostics(uri, (found) => found.some(({ code }) => code === "MP013"));
  expect(list.find(({ code }) => code === "MP013")?.relatedInformation).toEqual([
    {
      location: {
        uri,
        range: { start: { line: 1, character: 4 }, end: { line: 1, character: 5 } },
      },
      message: "the first definition is here",
    },
  ]);
});

test("the scenario says that a program is structured C", async () => {
  const text = "int n;\nint f()\n{\n  while (n < 3) n = n + 1;\n}\n";
  const folder = folderOf({ "s.toml": `${scenario}structured = true\n` });
  const uri = uriOf(join(folder, "p.c"));
  const editor = await openEditor();
  await editor.open(uri, text);
  expect(await editor.diagnostics(uri, () => true)).toEqual([]);
});

test("a scenario with mistakes does not hide those of its program", async () => {
  const folder = folderOf({ "s.toml": `${scenario}axis = 8\n` });
  const uri = uriOf(join(folder, "p.c"));
  const editor = await openEditor();
  await editor.open(uri, "int n\nint f()\n{\n}\n");
  const list = await editor.diagnostics(uri, (found) => found.length > 0);
  expect(list[0]).toMatchObject({ code: "MP041" });
});

test("C files of hosts are left alone", async () => {
  const folder = folderOf({ "s.toml": scenario });
  const [host, program] = [uriOf(join(folder, "host.c")), uriOf(join(folder, "p.c"))];
  const editor = await openEditor();
  await editor.open(host, "#include <stdio.h>\nint main() { return x; }\n");
  await editor.open(program, "int n\n");
  await editor.diagnostics(program, (list) => list.length > 0);
  expect(
    await editor.request("textDocument/codeAction", {
      textDocument: { uri: host },
      range: { start: { line: 0, character: 0 }, end: { line: 1, character: 0 } },
      context: { diagnostics: [] },
    }),
  ).toEqual([]);
});

test("every sample is without errors", async () => {
  const editor = await openEditor();
  for (const name of ["01_sum/sum.c", "10_trap/trap.toml", "26_lost_update/bounds.toml"]) {
    const uri = uriOf(sample(name));
    await editor.open(uri, readFileSync(sample(name), "utf8"));
    expect(await editor.diagnostics(uri, () => true)).toEqual([]);
  }
});

test("texts are in the language of the editor", async () => {
  const uri = uriOf("/nowhere/p.c");
  const editor = await openEditor({ ONCARD: oncard }, { locale: "zh-cn" });
  await editor.open(uri, "//@ structured\nint n\n");
  const [first] = await editor.diagnostics(uri, (list) => list.length > 0);
  expect(first?.message).toMatch(/[\u4e00-\u9fff]/);
});

test("quick fixes are the compiler's", async () => {
  const folder = folderOf({ "s.toml": scenario });
  const uri = uriOf(join(folder, "p.c"));
  const text = "int n\nint f()\n{\n  n = 1;\n}\n";
  const editor = await openEditor();
  await editor.open(uri, text);
  const [first] = await editor.diagnostics(uri, (list) => list.length > 0);
  const actionsFor = (range: unknown, diagnostics: unknown[]) =>
    editor.request<CodeAction[]>("textDocument/codeAction", {
      textDocument: { uri },
      range,
      context: { diagnostics, only: ["quickfix"] },
    });
  const start = { line: 0, character: 0 };
  expect(await actionsFor({ start, end: start }, [])).toEqual([]);
  const actions = await actionsFor(first?.range, []);
  // Some editors ask for what is in the line.
  expect(await actionsFor({ start, end: start }, [first])).toEqual(actions);
  expect(actions).toMatchObject([{ title: "change to ';'", kind: "quickfix", isPreferred: true }]);
  expect(edited(text, changesOf(actions[0]?.edit, uri))).toBe(text.replace("int n", "int n;"));
});

test("fix all corrects what can be corrected, again and again", async () => {
  const folder = folderOf({ "s.toml": scenario });
  const uri = uriOf(join(folder, "p.c"));
  const text = "int n\nint f()\n{\n  n = 1\n  return n\n}\n";
  const editor = await openEditor();
  await editor.open(uri, text);
  const start = { line: 0, character: 0 };
  const [all, ...others] = await editor.request<CodeAction[]>("textDocument/codeAction", {
    textDocument: { uri },
    range: { start, end: start },
    context: { diagnostics: [], only: ["source.fixAll"] },
  });
  expect(others).toEqual([]);
  const corrected = text.replaceAll(/(int n|= 1|return n)/g, "$1;");
  expect(edited(text, changesOf(all?.edit, uri))).toBe(corrected);
  await editor.change(uri, corrected);
  const none = await editor.request<CodeAction[]>("textDocument/codeAction", {
    textDocument: { uri },
    range: { start, end: start },
    context: { diagnostics: [], only: ["source.fixAll"] },
  });
  expect(none).toEqual([]);
});

test("an engine that ends is started again", async () => {
  const folder = folderOf({
    "s.toml": scenario,
    "oncard.sh": `#!/bin/sh\nif mkdir "$0.begun" 2>/dev/null; then exit 1; fi\nexec "${oncard}" "$@"\n`,
  });
  const uri = uriOf(join(folder, "p.c"));
  const command = join(folder, "oncard.sh");
  chmodSync(command, 0o755);
  const editor = await openEditor({ ONCARD: command });
  const warned = new Promise((resolve) => {
    editor.connection.onNotification("window/logMessage", resolve);
  });
  await editor.open(uri, "int n\n");
  expect(await warned).toMatchObject({
    message: expect.stringContaining("has ended with exit code 1") as string,
  });
  await editor.change(uri, "int m\n");
  await editor.diagnostics(uri, (list) => list.length > 0);
});
