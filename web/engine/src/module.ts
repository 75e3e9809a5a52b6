// An engine in the same thread: the WebAssembly module, or whatever answers a line with lines.
// Tested by test/module.test.ts.

import type { Receiver, Transport } from "./transport.js";

/** Answers a request with lines of JSON: `EngineModule` of engine_module.js is one. */
export interface RequestHandler {
  /** Throws if it has lost its session. */
  handle(request: string): string;
}

export class ModuleTransport implements Transport {
  #handler: RequestHandler | undefined;
  #receiver: Receiver | undefined;

  constructor(handler: RequestHandler) {
    this.#handler = handler;
  }

  connect(receiver: Receiver): void {
    this.#receiver = receiver;
  }

  send(line: string): void {
    // Answers come after the call, as they do from everywhere else.
    queueMicrotask(() => {
      this.#answer(line);
    });
  }

  close(): void {
    this.#handler = undefined;
  }

  #answer(request: string): void {
    let answer: string;
    try {
      answer = this.#handler?.handle(request) ?? "";
    } catch (error) {
      this.close();
      this.#receiver?.ended(error instanceof Error ? error : new Error(String(error)));
      return;
    }
    for (const line of answer.split("\n")) if (line !== "") this.#receiver?.line(line);
  }
}
