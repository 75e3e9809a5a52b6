// The run with which an exploration shows that something fails, as a table in a panel. A click at a step
// goes there in the debugger, and the table follows the debugger. Its view is that of the page.
// Tested by test/package.test.ts and e2e/editor.spec.ts.

import { writeFile } from "node:fs/promises";
import { basename, dirname, join, parse } from "node:path";

import type { Interleaving } from "@oncard/engine";
import { commands, type DebugSession, type Disposable, type WebviewPanel, window } from "vscode";

import { execute, inConsole, startDebugging } from "./debug";
import type { Engines } from "./engines";
import type { FromView, ToView } from "./failing_run_messages";
import type { Follower } from "./sessions";
import { language, say } from "./texts";
import { openView } from "./views";

export interface FailingRun {
  /** The program or scenario that was explored. */
  main: string;
  /** A schedule file that repeats it. */
  schedule: string;
  interleaving: Interleaving;
}

/** Writes its schedule beside the program, where the debugger takes it from. */
export async function keepSchedule(main: string, schedule: string): Promise<string> {
  const path = scheduleOf(main);
  await writeFile(path, schedule);
  return path;
}

function scheduleOf(main: string): string {
  return join(dirname(main), `${parse(main).name}.schedule`);
}

export class FailingRunPanel implements Follower, Disposable {
  readonly #folder: string;
  #panel: WebviewPanel | undefined;
  #run: FailingRun | undefined;
  /** It follows the run. */
  #session: DebugSession | undefined;
  #now: number | null = null;

  constructor(engines: Engines) {
    this.#folder = engines.viewFolder;
  }

  dispose(): void {
    this.#panel?.dispose();
  }

  began(session: DebugSession): void {
    if (this.#run && session.configuration["program"] === scheduleOf(this.#run.main)) {
      this.#session = session;
    }
  }

  moved(session: DebugSession): void {
    void this.#follow(session);
  }

  ended(session: DebugSession): void {
    if (session !== this.#session) return;
    this.#session = undefined;
    this.#stand(null);
  }

  show(run: FailingRun): void {
    this.#run = run;
    // A session that is still open has the run of an exploration before.
    this.#session = undefined;
    this.#now = null;
    this.#panel ??= this.#opened();
    const name = basename(run.main);
    this.#panel.title = say({ en: `${name}: failing run`, zh: `${name}：失败的运行` });
    this.#panel.reveal(undefined, true);
    this.#send();
  }

  #opened(): WebviewPanel {
    const panel = openView(this.#folder, "failing_run");
    panel.webview.onDidReceiveMessage((message: FromView) => {
      if (message === "ready") {
        this.#send();
        return;
      }
      this.#goTo(message.step).catch((error: unknown) => {
        void window.showErrorMessage(error instanceof Error ? error.message : String(error));
      });
    });
    panel.onDidDispose(() => {
      this.#panel = undefined;
      this.#run = undefined;
      this.#session = undefined;
    });
    return panel;
  }

  #send(): void {
    if (!this.#run) return;
    this.#post({ run: this.#run.interleaving, language: language(), now: this.#now });
  }

  #post(message: ToView): void {
    void this.#panel?.webview.postMessage(message);
  }

  async #goTo(step: number): Promise<void> {
    const run = this.#run;
    if (!run) return;
    const statement = run.interleaving.skipped + step;
    // The debugger shows the program in the group that has the focus, and would cover the panel.
    await commands.executeCommand("workbench.action.focusFirstEditorGroup");
    if (this.#session) {
      await execute(`statement ${statement}`, this.#session);
    } else {
      const schedule = await keepSchedule(run.main, run.schedule);
      await startDebugging(schedule, { stopAtStatement: statement });
    }
  }

  async #follow(session: DebugSession): Promise<void> {
    if (session !== this.#session || !this.#run) return;
    const { skipped } = this.#run.interleaving;
    try {
      const now = Number(await inConsole(session, "statement")) - skipped;
      if (session === this.#session) this.#stand(now < 0 ? null : now);
    } catch {
      this.ended(session); // meanwhile
    }
  }

  #stand(now: number | null): void {
    this.#now = now;
    this.#post({ now });
  }
}
