// While the debugger stands, what each thread made in a line when it executed the line last, behind that
// line. The editor's setting "Debug: Inline Values" switches it off.
// Tested by test/features.test.ts and e2e/editor.spec.ts.

import type { LineWrites } from "@oncard/engine";
import { type Beside, valuesBeside } from "@oncard/playground/editor/beside";
import {
  debug,
  type Disposable,
  InlineValueText,
  languages,
  Range,
  type TextDocument,
} from "vscode";

import { selector } from "./lenses";
import { request } from "./sessions";

interface Written {
  lines: (LineWrites & { path?: string })[];
  moment: number;
}

export function registerInlineValues(): Disposable {
  const programs = selector.filter(({ language }) => language !== "toml");
  return languages.registerInlineValuesProvider(programs, { provideInlineValues: valuesIn });
}

async function valuesIn(document: TextDocument): Promise<InlineValueText[]> {
  const session = debug.activeDebugSession;
  if (session?.type !== "oncard") return [];
  const { lines, moment } = await request<Written>(session, "oncard.written");
  const its = lines.filter(({ path }) => path === document.uri.fsPath);
  const text = document.getText().split(/\r?\n/);
  const values = valuesBeside(its, { file: its[0]?.file ?? "", lines: text, moment });
  return values.map((value) => {
    const { length } = text[value.line - 1] ?? "";
    return new InlineValueText(new Range(value.line - 1, 0, value.line - 1, length), said(value));
  });
}

/** The editor has one colour for all. */
function said(value: Beside): string {
  const isNumbered = value.kind === "made" && value.isNumbered;
  return isNumbered ? `${value.thread}: ${value.text}` : value.text;
}
