// The editor at the other end: what it is told, in its language.

import { basename } from "node:path";

import type { CardWarning, Diagnostic, Language } from "@oncard/engine";
import { type Event, OutputEvent, Source } from "@vscode/debugadapter";
import type { DebugProtocol } from "@vscode/debugprotocol";

import { type Text, UserError } from "./texts.js";

/** What carries messages to the editor. */
export interface Wire {
  sendResponse: (response: DebugProtocol.Response) => void;
  sendEvent: (event: Event) => void;
  /** Sends that a request has failed. */
  sendFailure: (response: DebugProtocol.Response, why: string) => void;
}

export class Editor {
  language: Language = "en";
  /** It wants to know what has changed without its doing. */
  takesInvalidated = false;
  readonly #wire: Wire;

  constructor(wire: Wire) {
    this.#wire = wire;
  }

  say(text: Text): string {
    return text[this.language];
  }

  // --- Requests ----------------------------------------------------------------------------------

  /** Sends the response when the work is done. */
  answer(response: DebugProtocol.Response, work: () => Promise<void> | void): void {
    Promise.resolve()
      .then(work)
      .then(() => {
        this.send(response);
      })
      .catch((error: unknown) => {
        this.fail(response, error);
      });
  }

  send(response: DebugProtocol.Response): void {
    this.#wire.sendResponse(response);
  }

  fail(response: DebugProtocol.Response, error: unknown): void {
    const why =
      error instanceof UserError
        ? this.say(error.text)
        : error instanceof Error
          ? error.message
          : "";
    this.#wire.sendFailure(response, why);
  }

  // --- Events ------------------------------------------------------------------------------------

  tell(event: Event): void {
    this.#wire.sendEvent(event);
  }

  print(text: string, category: "console" | "stdout" | "stderr"): void {
    this.tell(new OutputEvent(text, category));
  }

  showDiagnostic({ file, line, column, severity, message }: Diagnostic): void {
    const place = `${file}:${line}:${column}`;
    const event: Event & DebugProtocol.OutputEvent = new OutputEvent(
      `${place}: ${severity}: ${message}\n`,
      severity === "error" ? "stderr" : "console",
    );
    event.body.source = new Source(basename(file), file);
    event.body.line = line;
    event.body.column = column;
    this.tell(event);
  }

  /** @param source the file of the warning, as far as it is known */
  showWarning({ name, text, file, line, call }: CardWarning, source?: Source): void {
    const place = file === undefined ? call : `${file}:${line ?? 0}`;
    const what = this.say({ en: `warning: ${text}`, zh: `警告：${text}` });
    const event: Event & DebugProtocol.OutputEvent = new OutputEvent(
      `${place === undefined ? "" : `${place}: `}${what} [${name}]\n`,
      "console",
    );
    if (source && line !== undefined) {
      event.body.source = source;
      event.body.line = line;
    }
    this.tell(event);
  }
}
