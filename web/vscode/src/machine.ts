// The machine of the program that is debugged, in a panel: where it stands, and inputs that can be
// switched. Its view is that of the page.
// Tested by test/package.test.ts and e2e/editor.spec.ts.

import type { Card, Channel, State } from "@oncard/engine";
import { type Place, tableAxes, wayOf } from "@oncard/playground/machine/axes";
import { axesShown, type Seen, seenOf } from "@oncard/playground/machine/seen";
import {
  commands,
  debug,
  type DebugSession,
  type Disposable,
  type WebviewPanel,
  window,
} from "vscode";

import { oneAtATime } from "./asking";
import type { Engines } from "./engines";
import type { FromView, MachineNow, ToView } from "./machine_messages";
import { type Follower, request } from "./sessions";
import { language, say } from "./texts";
import { openView } from "./views";

/** So many points of a way are shown. */
const wayPoints = 300;

export class MachinePanel implements Follower {
  readonly #folder: string;
  #panel: WebviewPanel | undefined;
  /** The one that has moved last. */
  #session: DebugSession | undefined;
  /** Of its run. */
  #seen: Seen | undefined;
  #now: MachineNow | null = null;
  readonly #ask = oneAtATime(() => this.#askOnce());

  constructor(engines: Engines) {
    this.#folder = engines.viewFolder;
  }

  register(): Disposable[] {
    return [
      {
        dispose: () => {
          this.#panel?.dispose();
        },
      },
      commands.registerCommand("oncard.showMachine", () => {
        this.#show();
      }),
    ];
  }

  moved(session: DebugSession): void {
    if (session !== this.#session) this.#seen = undefined;
    this.#session = session;
    this.#ask();
  }

  ended(session: DebugSession): void {
    if (session !== this.#session) return;
    this.#session = undefined;
    this.#seen = undefined;
    this.#send(null);
  }

  #show(): void {
    this.#panel ??= this.#opened();
    this.#panel.reveal(undefined, true);
    const session = debug.activeDebugSession;
    if (session?.type === "oncard") this.moved(session);
  }

  #opened(): WebviewPanel {
    const panel = openView(this.#folder, "machine", say({ en: "Machine", zh: "机器" }));
    panel.webview.onDidReceiveMessage((message: FromView) => {
      if (message === "ready") this.#send(this.#now);
      else void this.#setInput(message);
    });
    panel.onDidDispose(() => {
      this.#panel = undefined;
    });
    return panel;
  }

  #send(now: MachineNow | null): void {
    this.#now = now;
    const idle = say({
      en: "Debug a program: its axes are shown here.",
      zh: "调试程序后，此处显示它的轴。",
    });
    this.#post({ machine: now, language: language(), idle });
  }

  #post(message: ToView): void {
    void this.#panel?.webview.postMessage(message);
  }

  async #askOnce(): Promise<void> {
    const session = this.#session;
    if (!session || !this.#panel) return;
    try {
      const { card, state } = await request<{ card: Card; state: State }>(session, "oncard.card");
      const isStart = state.head === 0;
      const seen = seenOf(card, isStart ? undefined : this.#seen);
      const way = await wayIn(session, card, seen, state.time_ms);
      if (session !== this.#session) return;
      this.#seen = seen;
      this.#send({ card, seen, way });
    } catch {
      this.ended(session); // meanwhile
    }
  }

  /** The debugger tells that something has changed. */
  async #setInput({ word, pin, level }: Exclude<FromView, "ready">): Promise<void> {
    if (!this.#session) return;
    try {
      await request(this.#session, "oncard.setInput", { type: word, index: pin, level });
    } catch (error) {
      void window.showErrorMessage(error instanceof Error ? error.message : String(error));
    }
  }
}

/** Where the axes of a table have been up to now. */
async function wayIn(
  session: DebugSession,
  card: Card,
  seen: Seen,
  time: number,
): Promise<Place[]> {
  const table = tableAxes(card, axesShown(card, seen));
  if (!table || time === 0) return [];
  const names = [table.x, table.y].map(({ axis }) => `axis${axis}.prfPos`);
  const args = { names, from_ms: 0, to_ms: time, points: wayPoints };
  return wayOf((await request<{ channels: Channel[] }>(session, "oncard.trace", args)).channels);
}
