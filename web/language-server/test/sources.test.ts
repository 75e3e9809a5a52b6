// One test for each capability, over the streams of the server.

import { join } from "node:path";

import { expect, test } from "vitest";
import type {
  CompletionItem,
  DocumentSymbol,
  FoldingRange,
  Hover,
  InlayHint,
  Location,
  Range,
  SemanticTokens,
  SignatureHelp,
  WorkspaceEdit,
} from "vscode-languageserver";

import { uriOf } from "../src/paths.js";
import { changesOf, type Editor, edited, folderOf, openEditor } from "./support.js";

const text = `int speed;
/* 线程 🙂
   two lines */
int run(int axis)
{
  /* 🙂 */ speed = axis;
  GT_SetVel(axis, 50);
again:
  speed = speed + 1;
  if (speed) goto again;
  return speed;
}
`;

/** The position of the `nth` occurrence of a word. */
function at(word: string, nth = 0): { line: number; character: number } {
  let offset = -1;
  for (let count = 0; count <= nth; ++count) offset = text.indexOf(word, offset + 1);
  const before = text.slice(0, offset).split("\n");
  return { line: before.length - 1, character: before.at(-1)?.length ?? 0 };
}

function rangeOf(word: string, nth = 0): Range {
  const start = at(word, nth);
  return { start, end: { ...start, character: start.character + word.length } };
}

async function opened(): Promise<{ editor: Editor; uri: string }> {
  const folder = folderOf({ "s.toml": 'program = "p.c"\n' });
  const uri = uriOf(join(folder, "p.c"));
  const editor = await openEditor();
  await editor.open(uri, text);
  return { editor, uri };
}

async function ask<Result>(method: string, more: object = {}): Promise<[Result, string]> {
  const { editor, uri } = await opened();
  const params = { textDocument: { uri }, ...more };
  return [await editor.request<Result>(`textDocument/${method}`, params), uri];
}

test("hover shows what a command's parameters are", async () => {
  const [hover] = await ask<Hover>("hover", { position: at("GT_SetVel") });
  expect(hover.range).toEqual(rangeOf("GT_SetVel"));
  expect(hover.contents).toMatchObject({ kind: "markdown" });
  expect(JSON.stringify(hover.contents)).toMatch(/pulse\/ms/);
  const [nothing] = await ask<Hover | null>("hover", { position: at("{") });
  expect(nothing).toBeNull();
});

test("hover counts positions as the editor does", async () => {
  const [hover] = await ask<Hover>("hover", { position: at("speed", 1) });
  expect(hover.range).toEqual(rangeOf("speed", 1));
});

test("signature help marks the argument", async () => {
  const [help] = await ask<SignatureHelp>("signatureHelp", { position: at("50") });
  expect(help).toMatchObject({ activeSignature: 0, activeParameter: 1 });
  expect(help.signatures[0]?.label).toContain("GT_SetVel");
  expect(help.signatures[0]?.parameters).toHaveLength(2);
});

test("completion offers variables and commands", async () => {
  const [items] = await ask<CompletionItem[]>("completion", {
    position: rangeOf("speed", 2).end,
  });
  const labels = items.map(({ label }) => label);
  expect(labels).toEqual(expect.arrayContaining(["speed", "axis", "GT_Update"]));
  const speed = items.find(({ label }) => label === "speed");
  expect(speed?.textEdit).toEqual({ range: rangeOf("speed", 2), newText: "speed" });
});

test("definition", async () => {
  const [found, uri] = await ask<Location[]>("definition", { position: at("again", 1) });
  expect(found).toEqual([{ uri, range: rangeOf("again") }]);
});

test("references, with the declaration or without", async () => {
  const references = async (includeDeclaration: boolean) => {
    const more = { position: at("axis"), context: { includeDeclaration } };
    const [found] = await ask<Location[]>("references", more);
    return found.map(({ range }) => range);
  };
  const uses = [rangeOf("axis", 1), rangeOf("axis", 2)];
  expect(await references(false)).toEqual(uses);
  expect(await references(true)).toEqual([rangeOf("axis"), ...uses]);
});

test("rename, and what cannot be renamed", async () => {
  const [range] = await ask<Range>("prepareRename", { position: at("axis", 2) });
  expect(range).toEqual(rangeOf("axis", 2));
  const [command] = await ask<Range | null>("prepareRename", { position: at("GT_SetVel") });
  expect(command).toBeNull();
  const [edit, uri] = await ask<WorkspaceEdit>("rename", {
    position: at("axis"),
    newName: "number",
  });
  expect(edited(text, changesOf(edit, uri))).toBe(text.replaceAll("axis", "number"));
  await expect(ask("rename", { position: at("axis"), newName: "speed" })).rejects.toThrow("speed");
});

test("outline", async () => {
  const [symbols] = await ask<DocumentSymbol[]>("documentSymbol");
  expect(symbols.map(({ name }) => name)).toEqual(["speed", "run"]);
  expect(symbols[1]?.selectionRange).toEqual(rangeOf("run"));
  expect(symbols[1]?.children?.map(({ name }) => name)).toEqual(["axis", "again"]);
});

test("folding", async () => {
  const [folds] = await ask<FoldingRange[]>("foldingRange");
  expect(folds).toContainEqual({ startLine: 1, endLine: 2, kind: "comment" });
  expect(folds).toContainEqual({ startLine: at("{").line, endLine: at("}").line });
});

test("semantic tokens distinguish commands and globals", async () => {
  const { editor, uri } = await opened();
  const { data }: SemanticTokens = await editor.request("textDocument/semanticTokens/full", {
    textDocument: { uri },
  });
  const found = new Map<string, number>();
  let [line, character] = [0, 0];
  const rows = text.split("\n");
  for (let index = 0; index < data.length; index += 5) {
    const [down = 0, right = 0, length = 0, , bits = 0] = data.slice(index);
    character = down > 0 ? right : character + right;
    line += down;
    found.set(rows[line]?.slice(character, character + length) ?? "", bits);
  }
  const [modification, library, global] = [2, 4, 8];
  expect(found.get("GT_SetVel")).toBe(library);
  expect((found.get("speed") ?? 0) & global).toBe(global);
  expect((found.get("axis") ?? 0) & (global | modification)).toBe(0);
});

test("inlay hints of the lines that are seen", async () => {
  const hints = async (line: number) => {
    const range = { start: { line, character: 0 }, end: { line, character: 99 } };
    const [found] = await ask<InlayHint[]>("inlayHint", { range });
    return found.map(({ label }) => label);
  };
  expect(await hints(at("GT_SetVel").line)).not.toEqual([]);
  expect(await hints(at("again").line)).toEqual([]);
});

test("documents of others have no answers", async () => {
  const folder = folderOf({});
  const editor = await openEditor();
  const uri = uriOf(join(folder, "host.c"));
  await editor.open(uri, text);
  const textDocument = { uri };
  expect(await editor.request("textDocument/documentSymbol", { textDocument })).toEqual([]);
  const position = at("GT_SetVel");
  expect(await editor.request("textDocument/hover", { textDocument, position })).toBeNull();
});

test("hover and completion help with the keys of a scenario", async () => {
  const folder = folderOf({ "p.c": text });
  const uri = uriOf(join(folder, "s.toml"));
  const editor = await openEditor();
  await editor.open(uri, 'program = "p.c"\nuntil_ms = 5\n', "toml");
  const hover = await editor.request<Hover>("textDocument/hover", {
    textDocument: { uri },
    position: { line: 1, character: 3 },
  });
  expect(JSON.stringify(hover.contents)).toMatch(/the run ends exactly at this time/);
  const items = await editor.request<CompletionItem[]>("textDocument/completion", {
    textDocument: { uri },
    position: { line: 2, character: 0 },
  });
  expect(items.map(({ label }) => label)).toContain("limit_ms");
});
