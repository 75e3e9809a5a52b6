// The lenses "run · debug · explore" above scenarios and motion programs, and "debug" above each
// function of a program with which a thread can begin.
// Tested by test/features.test.ts.

import { CodeLens, type Disposable, languages, Range, type TextDocument, workspace } from "vscode";

import { kindOf } from "./documents";
import type { Engines } from "./engines";
import { Outlines } from "./outlines";
import { say } from "./texts";

export const selector = [
  { scheme: "file", language: "c" },
  { scheme: "file", language: "motion-program" },
  { scheme: "file", language: "toml" },
];

export function registerLenses(engines: Engines): Disposable[] {
  const outlines = new Outlines(engines);
  const provider = { provideCodeLenses: (document: TextDocument) => lensesOf(document, outlines) };
  return [outlines, languages.registerCodeLensProvider(selector, provider)];
}

async function lensesOf(document: TextDocument, outlines: Outlines): Promise<CodeLens[]> {
  const wanted = workspace.getConfiguration("oncard").get<boolean>("codeLens") ?? true;
  const kind = wanted ? await kindOf(document) : undefined;
  if (kind === undefined) return [];
  const functions = kind === "program" ? await outlines.threadFunctions(document) : [];
  const top = new Range(0, 0, 0, 0);
  const lens = (command: string, title: string) =>
    new CodeLens(top, { command, title, arguments: [document.uri] });
  return [
    lens("oncard.run", say({ en: "run", zh: "运行" })),
    lens("oncard.debug", say({ en: "debug", zh: "调试" })),
    lens("oncard.explore", say({ en: "explore", zh: "探索" })),
    ...functions.map(({ name, name_range: { line } }) => {
      const title = say({ en: `debug ${name}`, zh: `调试 ${name}` });
      const tooltip = say({
        en: `runs to the first statement of ${name}`,
        zh: `运行到 ${name} 的第一条语句`,
      });
      const args = [document.uri, name];
      const range = new Range(line - 1, 0, line - 1, 0);
      return new CodeLens(range, { command: "oncard.debug", title, tooltip, arguments: args });
    }),
  ];
}
