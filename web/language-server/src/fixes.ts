// The compiler's corrections as code actions.
// Tested by test/server.test.ts.

import type { Engine, Fixit } from "@oncard/engine";
import {
  type CodeAction,
  CodeActionKind,
  type Diagnostic,
  type TextEdit,
  type WorkspaceEdit,
} from "vscode-languageserver";

import type { DiagnosticData } from "./checker.js";
import type { Documents } from "./documents.js";
import { beside, uriOf } from "./paths.js";
import { Lines } from "./positions.js";
import type { Words } from "./words.js";

/** A correction for each diagnostic that has one. */
export async function quickFixes(
  documents: Documents,
  main: string,
  diagnostics: readonly Diagnostic[],
  words: Words,
): Promise<CodeAction[]> {
  const actions: CodeAction[] = [];
  for (const diagnostic of diagnostics) {
    const { fixits } = (diagnostic.data ?? { fixits: [] }) as DiagnosticData;
    if (fixits.length === 0) continue;
    actions.push({
      title: words.fix(fixits.map(({ text }) => text)),
      kind: CodeActionKind.QuickFix,
      diagnostics: [diagnostic],
      isPreferred: true,
      edit: await editOf(documents, main, fixits),
    });
  }
  return actions;
}

/** One edit for everything that the compiler can correct; nothing if there is nothing. */
export async function fixAll(
  documents: Documents,
  engine: Engine,
  main: string,
  words: Words,
): Promise<CodeAction[]> {
  const project = (await documents.scenarioOf(main)) ?? main;
  const { count, files } = await engine.fixes({ main: project, files: documents.openTexts() });
  if (count === 0) return [];
  const changes: Record<string, TextEdit[]> = {};
  for (const { path, text } of files) {
    const file = beside(project, path);
    const before = (await documents.text(file)) ?? "";
    changes[uriOf(file)] = [{ range: new Lines(before).whole(), newText: text }];
  }
  return [{ title: words.fixAll, kind: CodeActionKind.SourceFixAll, edit: { changes } }];
}

async function editOf(
  documents: Documents,
  main: string,
  fixits: readonly Fixit[],
): Promise<WorkspaceEdit> {
  const changes: Record<string, TextEdit[]> = {};
  for (const fixit of fixits) {
    const path = beside(main, fixit.file);
    const lines = new Lines((await documents.text(path)) ?? "");
    (changes[uriOf(path)] ??= []).push({ range: lines.range(fixit), newText: fixit.text });
  }
  return { changes };
}
