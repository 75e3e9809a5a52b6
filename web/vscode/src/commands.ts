// Run, debug and explore: for the palette and for the lenses above a file.
// Tested by test/commands.test.ts.

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
import { type FailingRunPanel, keepSchedule } from "./failing_run";
import { explored, type Outcome, ran } from "./runs";
import { language, say } from "./texts";

export function registerCommands(
  engines: Engines,
  output: OutputChannel,
  failingRun: FailingRunPanel,
): Disposable[] {
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
      startDebugging(main, typeof name === "string" ? { stopAtFunction: name } : {}),
    ),
    onFile("oncard.explore", (main) => explore(engines, output, failingRun, main)),
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

/** Shows the verdict, and a run that fails; it is opened in the debugger if the user wishes. */
async function explore(
  engines: Engines,
  output: OutputChannel,
  failingRun: FailingRunPanel,
  main: string,
): Promise<void> {
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
  const { schedule, interleaving } = outcome;
  if (schedule === undefined) return;
  if (interleaving) failingRun.show({ main, schedule, interleaving });
  await offer(main, schedule);
}

async function offer(main: string, schedule: string): Promise<void> {
  const step = say({ en: "Step through it", zh: "单步查看" });
  const found = say({
    en: "there is an interleaving that fails",
    zh: "存在不成立的交错",
  });
  if ((await window.showWarningMessage(found, step)) !== step) return;
  await startDebugging(await keepSchedule(main, schedule));
}

function show(output: OutputChannel, main: string, { lines }: Outcome): void {
  output.clear();
  output.appendLine(main);
  for (const line of lines) output.appendLine(line);
  output.show(true);
}
