// A client of the server that behaves like an editor, over the server's streams.

import { type ChildProcessWithoutNullStreams, spawn } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

import { onTestFinished } from "vitest";
import type {
  Diagnostic,
  InitializeParams,
  InitializeResult,
  Position,
  PublishDiagnosticsParams,
  Range,
  TextEdit,
  WorkspaceEdit,
} from "vscode-languageserver";
import {
  createMessageConnection,
  type MessageConnection,
  StreamMessageReader,
  StreamMessageWriter,
} from "vscode-languageserver/node.js";

import { oncard } from "../../engine/test/support.js";

export { oncard, sample, wasm, withoutModule } from "../../engine/test/support.js";

const server = fileURLToPath(new URL("../dist/server.js", import.meta.url));

/** A new folder with these files; it disappears with the test. */
export function folderOf(files: Record<string, string>): string {
  const folder = mkdtempSync(join(tmpdir(), "oncard-"));
  onTestFinished(() => {
    rmSync(folder, { recursive: true });
  });
  for (const [name, text] of Object.entries(files)) writeFileSync(join(folder, name), text);
  return folder;
}

export class Editor {
  readonly connection: MessageConnection;
  readonly child: ChildProcessWithoutNullStreams;
  /** What the server has last said about each document, and how often. */
  readonly #published = new Map<string, Diagnostic[]>();
  readonly #versions = new Map<string, number>();
  #onPublished: () => void = () => undefined;

  constructor(environment: NodeJS.ProcessEnv) {
    this.child = spawn("node", [server, "--stdio"], { env: environment });
    onTestFinished(() => {
      this.connection.dispose();
      this.child.kill();
    });
    this.connection = createMessageConnection(
      new StreamMessageReader(this.child.stdout),
      new StreamMessageWriter(this.child.stdin),
    );
    this.connection.onNotification(
      "textDocument/publishDiagnostics",
      ({ uri, diagnostics }: PublishDiagnosticsParams) => {
        this.#published.set(uri, diagnostics);
        this.#onPublished();
      },
    );
    this.connection.listen();
  }

  async initialize(params: Partial<InitializeParams> = {}): Promise<InitializeResult> {
    const all = { processId: null, rootUri: null, capabilities: {}, ...params };
    const result: InitializeResult = await this.connection.sendRequest("initialize", all);
    await this.connection.sendNotification("initialized", {});
    return result;
  }

  async open(uri: string, text: string, languageId = "c"): Promise<void> {
    this.#versions.set(uri, 1);
    const textDocument = { uri, languageId, version: 1, text };
    await this.connection.sendNotification("textDocument/didOpen", { textDocument });
  }

  /** Replaces a range, or everything. */
  async change(uri: string, text: string, range?: Range): Promise<void> {
    const version = (this.#versions.get(uri) ?? 1) + 1;
    this.#versions.set(uri, version);
    const contentChanges = [range ? { range, text } : { text }];
    const textDocument = { uri, version };
    await this.connection.sendNotification("textDocument/didChange", {
      textDocument,
      contentChanges,
    });
  }

  async close(uri: string): Promise<void> {
    await this.connection.sendNotification("textDocument/didClose", { textDocument: { uri } });
  }

  /** What the server says about a document, as soon as it is what a test expects. */
  async diagnostics(uri: string, are: (list: Diagnostic[]) => boolean): Promise<Diagnostic[]> {
    for (;;) {
      const list = this.#published.get(uri);
      if (list && are(list)) return list;
      await new Promise<void>((resolve) => {
        this.#onPublished = resolve;
      });
    }
  }

  /** What the server says next about a document. */
  nextDiagnostics(uri: string): Promise<Diagnostic[]> {
    this.#published.delete(uri);
    return this.diagnostics(uri, () => true);
  }

  request<Result>(method: string, params: object): Promise<Result> {
    return this.connection.sendRequest(method, params);
  }
}

/** The server with the command, unless the environment says otherwise. */
export async function openEditor(
  environment: NodeJS.ProcessEnv = { ONCARD: oncard },
  params: Partial<InitializeParams> = {},
  initialize = true,
): Promise<Editor> {
  const editor = new Editor({ PATH: process.env["PATH"], ...environment });
  if (initialize) await editor.initialize(params);
  return editor;
}

/** A text with edits, as an editor applies them. */
export function edited(text: string, edits: readonly TextEdit[]): string {
  const lines = text.split("\n");
  const offset = ({ line, character }: Position) =>
    lines.slice(0, line).reduce((sum, each) => sum + each.length + 1, 0) + character;
  let result = text;
  const fromLast = [...edits].sort((a, b) => offset(b.range.start) - offset(a.range.start));
  for (const { range, newText } of fromLast) {
    result = result.slice(0, offset(range.start)) + newText + result.slice(offset(range.end));
  }
  return result;
}

export function changesOf(edit: WorkspaceEdit | undefined, uri: string): TextEdit[] {
  return edit?.changes?.[uri] ?? [];
}
