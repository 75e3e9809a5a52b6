// The lenses "run · debug · explore" above scenarios and motion programs.
// Tested by test/lenses.test.ts.

import { CodeLens, type Disposable, languages, Range, type TextDocument, workspace } from "vscode";

import { kindOf } from "./documents";
import { say } from "./texts";

export const selector = [
  { scheme: "file", language: "c" },
  { scheme: "file", language: "motion-program" },
  { scheme: "file", language: "toml" },
];

export function registerLenses(): Disposable {
  return languages.registerCodeLensProvider(selector, { provideCodeLenses: lensesOf });
}

export async function lensesOf(document: TextDocument): Promise<CodeLens[]> {
  const wanted = workspace.getConfiguration("oncard").get<boolean>("codeLens") ?? true;
  if (!wanted || (await kindOf(document)) === undefined) return [];
  const top = new Range(0, 0, 0, 0);
  const lens = (command: string, title: string) =>
    new CodeLens(top, { command, title, arguments: [document.uri] });
  return [
    lens("oncard.run", say({ en: "run", zh: "运行" })),
    lens("oncard.debug", say({ en: "debug", zh: "调试" })),
    lens("oncard.explore", say({ en: "explore", zh: "探索" })),
  ];
}
