// A whole session as it goes over the wire: requests, responses and notifications in their order.
// transcript.txt is the expected text.

import { join } from "node:path";

import { expect, test } from "vitest";
import type { CodeAction } from "vscode-languageserver";

import { uriOf } from "../src/paths.js";
import { type Editor, folderOf, openEditor } from "./support.js";

/** What goes in and out, as lines of text. */
class Transcript {
  readonly lines: string[] = [];
  readonly #editor: Editor;

  constructor(editor: Editor) {
    this.#editor = editor;
  }

  async ask<Result>(method: string, params: object): Promise<Result> {
    this.#write(`request ${method}`, params);
    const result = await this.#editor.request<Result>(method, params);
    this.#write(`response ${method}`, result);
    return result;
  }

  async tell(method: string, params: object): Promise<void> {
    this.#write(`notification ${method}`, params);
    await this.#editor.connection.sendNotification(method, params);
  }

  /** What the server says next about a document. */
  async hear(uri: string): Promise<void> {
    const diagnostics = await this.#editor.nextDiagnostics(uri);
    this.#write("notification textDocument/publishDiagnostics", { uri, diagnostics });
  }

  #write(title: string, body: unknown): void {
    this.lines.push(`${title} ${JSON.stringify(body)}`);
  }
}

test("a session", async () => {
  const folder = folderOf({ "s.toml": 'program = "p.c"\n' });
  const uri = uriOf(join(folder, "p.c"));
  const editor = await openEditor(undefined, undefined, false);
  const wire = new Transcript(editor);
  await wire.ask("initialize", { processId: null, rootUri: null, capabilities: {}, locale: "en" });
  await wire.tell("initialized", {});
  const text = "int sum\nint f()\n{\n  sum = 3;\n}\n";
  const textDocument = { uri, languageId: "c", version: 1, text };
  await wire.tell("textDocument/didOpen", { textDocument });
  await wire.hear(uri);
  const range = { start: { line: 0, character: 0 }, end: { line: 0, character: 7 } };
  const [fix] = await wire.ask<CodeAction[]>("textDocument/codeAction", {
    textDocument: { uri },
    range,
    context: { diagnostics: [], only: ["quickfix"] },
  });
  const contentChanges = [{ range: fix?.edit?.changes?.[uri]?.[0]?.range, text: ";" }];
  await wire.tell("textDocument/didChange", { textDocument: { uri, version: 2 }, contentChanges });
  await wire.hear(uri);
  await wire.tell("textDocument/didClose", { textDocument: { uri } });
  await wire.hear(uri);
  await wire.ask("shutdown", {});
  await expect(
    `${wire.lines.join("\n").replaceAll(uriOf(folder), "FOLDER").replaceAll(folder, "FOLDER")}\n`,
  ).toMatchFileSnapshot("transcript.txt");
});
