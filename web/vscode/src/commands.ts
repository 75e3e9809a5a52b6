// Run, debug and explore: for the palette and for the lenses above a file.
// Tested by test/commands.test.ts.

import { writeFile } from "node:fs/promises";
import { dirname, join, parse } from "node:path";

import {
  commands,
  type Disposable,
  type OutputChannel,
  ProgressLocation,
  type TextDocument,
  Uri,
  window,
  workspace,
} from "vscode";

import { startDebugging } from "./debug";
import { mainOf } from "./documents";
import type { Engines } from "./engines";
import { explored, type Outcome, ran } from "./runs";
import { language, say } from "./texts";

/** Where counterexamples are kept. */
type Folder = string;

export function registerCommands(engines: Engines, output: OutputChannel): Disposable[] {
  type Work = (main: string, argument: unknown) => Promise<unknown>;
  const onFile = (name: string, work: Work) =>
    commands.registerCommand(name, async (uri?: Uri, argument?: unknown) => {
      const document = await documentOf(uri);
      // The engine reads what is not open from the disk.
      if (document && (!document.isDirty || (await document.save()))) {
        await work(await mainOf(document), argument);
      }
    });
  return [
    onFile("oncard.run", (main) => run(engines, output, main)),
    // Menus give other arguments than the lens of a function.
    onFile("oncard.debug", async (main, name) =>
      startDebugging(main, typeof name === "string" ? name : undefined),
    ),
    onFile("oncard.explore", (main) => explore(engines, output, main)),
  ];
}

/** The document of a lens, or the one that is open. */
async function documentOf(uri?: Uri): Promise<TextDocument | undefined> {
  return uri ? workspace.openTextDocument(uri) : window.activeTextEditor?.document;
}

async function run(engines: Engines, output: OutputChannel, main: string): Promise<void> {
  const engine = await engines.open();
  try {
    show(output, main, await ran(engine, main));
  } finally {
    engine.close();
  }
}

/** Shows the verdict; a counterexample is opened in the debugger if the user wishes. */
async function explore(engines: Engines, output: OutputChannel, main: string): Promise<void> {
  const engine = await engines.openModule();
  const title = say({ en: "oncard: exploring every interleaving", zh: "oncard：正在探索所有交错" });
  const outcome = await window.withProgress(
    { location: ProgressLocation.Notification, title, cancellable: true },
    async (_, cancelled) => {
      cancelled.onCancellationRequested(() => {
        engine.close();
      });
      try {
        return await explored(engine, main, language());
      } catch (error) {
        if (cancelled.isCancellationRequested) return undefined;
        throw error;
      } finally {
        engine.close();
      }
    },
  );
  if (!outcome) return;
  show(output, main, outcome);
  if (outcome.schedule !== undefined) await offer(main, outcome.schedule);
}

async function offer(main: string, schedule: string): Promise<void> {
  const step = say({ en: "Step through it", zh: "单步查看" });
  const found = say({
    en: "there is an interleaving that fails",
    zh: "存在不成立的交错",
  });
  if ((await window.showWarningMessage(found, step)) !== step) return;
  const path: Folder = join(dirname(main), `${parse(main).name}.schedule`);
  await writeFile(path, schedule);
  await startDebugging(path);
}

function show(output: OutputChannel, main: string, { lines }: Outcome): void {
  output.clear();
  output.appendLine(main);
  for (const line of lines) output.appendLine(line);
  output.show(true);
}
