// Source and card statements side by side, as a document that follows its program.
// Tested by test/listing.test.ts.

import { type ListedFunction, recordText, type SourceFile } from "@oncard/engine";
import {
  commands,
  type Disposable,
  EventEmitter,
  Uri,
  ViewColumn,
  window,
  workspace,
} from "vscode";

import { mainOf } from "./documents";
import type { Engines } from "./engines";
import { say } from "./texts";

export const listingScheme = "oncard-listing";

export function registerListing(engines: Engines): Disposable[] {
  const changed = new EventEmitter<Uri>();
  return [
    changed,
    workspace.registerTextDocumentContentProvider(listingScheme, {
      onDidChange: changed.event,
      provideTextDocumentContent: (uri) => contentOf(engines, uri.query),
    }),
    workspace.onDidSaveTextDocument(() => {
      for (const { uri } of workspace.textDocuments) {
        if (uri.scheme === listingScheme) changed.fire(uri);
      }
    }),
    commands.registerCommand("oncard.showListing", async (uri?: Uri) => {
      const document = uri
        ? await workspace.openTextDocument(uri)
        : window.activeTextEditor?.document;
      if (!document) return;
      const main = await mainOf(document);
      const target = Uri.from({ scheme: listingScheme, path: `${main}.listing`, query: main });
      const listing = await workspace.openTextDocument(target);
      const options = { viewColumn: ViewColumn.Beside, preview: true, preserveFocus: true };
      await window.showTextDocument(listing, options);
    }),
  ];
}

async function contentOf(engines: Engines, main: string): Promise<string> {
  const engine = await engines.open();
  try {
    const loaded = await engine.load({ main });
    if (!loaded.compiled) {
      const [first] = loaded.diagnostics;
      const where = first ? `${first.file}:${first.line}: ${first.message}` : main;
      return say({ en: `not compiled: ${where}\n`, zh: `未能编译：${where}\n` });
    }
    return listingText(loaded.files, await engine.listing());
  } catch (error) {
    return `${error instanceof Error ? error.message : String(error)}\n`;
  } finally {
    engine.close();
  }
}

/** Each line of a function with the card statements that it became, and their words. */
export function listingText(
  files: readonly SourceFile[],
  functions: readonly ListedFunction[],
): string {
  const rows: string[] = [];
  for (const { name, file, statements } of functions) {
    rows.push(`${name} (${file})`);
    const lines = linesOf(files, file);
    const width = Math.max(0, ...statements.map(({ line }) => shown(lines, line).length));
    const textWidth = Math.max(0, ...statements.map(({ text }) => text.length));
    let last = 0;
    statements.forEach(({ line, text, words }, index) => {
      const source = line === last ? "" : `${String(line).padStart(5)} ${shown(lines, line)}`;
      const statement = `${String(index).padStart(4)} ${text.padEnd(textWidth)}`;
      rows.push(`${source.padEnd(width + 6)} │ ${statement} │ ${recordText(words)}`);
      last = line;
    });
    rows.push("");
  }
  return rows.join("\n");
}

function linesOf(files: readonly SourceFile[], name: string): string[] {
  const found = files.find(({ path }) => path === name || path.endsWith(`/${name}`));
  return found?.text.split(/\r?\n/) ?? [];
}

function shown(lines: readonly string[], line: number): string {
  return (lines[line - 1] ?? "").trimEnd().replaceAll("\t", "  ");
}
