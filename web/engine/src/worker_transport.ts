// An engine in a Web Worker, so that a page stays alive while the engine computes: `serveWorker` is
// the side of the worker, `WorkerTransport` that of the page.
// Tested by test/worker_transport.test.ts.

import type { RequestHandler } from "./module.js";
import { ModuleTransport } from "./module.js";
import type { Receiver, Transport } from "./transport.js";

/** What both sides need of a worker, of the global object in it, and of a port. */
export interface MessageEnd {
  postMessage(message: unknown): void;
  addEventListener(type: "message", listener: (event: { data: unknown }) => void): void;
}

/** A worker as the page sees it. */
export interface WorkerEnd extends MessageEnd {
  addEventListener(type: "message", listener: (event: { data: unknown }) => void): void;
  addEventListener(type: "error", listener: (event: { message?: string }) => void): void;
  terminate(): void;
}

/** What a worker says: a line, or why it has ended. */
type Said = { line: string } | { ended: string };

export class WorkerTransport implements Transport {
  readonly #worker: WorkerEnd;

  /**
   * @param worker runs `serveWorker`
   * @param start what its `create` gets
   */
  constructor(worker: WorkerEnd, start: unknown) {
    this.#worker = worker;
    worker.postMessage(start);
  }

  connect(receiver: Receiver): void {
    this.#worker.addEventListener("message", ({ data }) => {
      const said = data as Said;
      if ("line" in said) receiver.line(said.line);
      else receiver.ended(new Error(said.ended));
    });
    this.#worker.addEventListener("error", ({ message }) => {
      receiver.ended(new Error(message ?? "the worker could not be started"));
    });
  }

  send(line: string): void {
    this.#worker.postMessage(line);
  }

  close(): void {
    this.#worker.terminate();
  }
}

/**
 * Answers the lines that a worker receives.
 * @param end the global object of the worker
 * @param create makes the engine from the first message that the worker receives
 */
export function serveWorker(
  end: MessageEnd,
  create: (start: unknown) => Promise<RequestHandler>,
): void {
  let engine: Promise<ModuleTransport> | undefined;
  const say = (said: Said) => {
    end.postMessage(said);
  };
  const ended = (why: unknown) => {
    say({ ended: why instanceof Error ? why.message : String(why) });
  };
  const started = async (start: unknown) => {
    const transport = new ModuleTransport(await create(start));
    transport.connect({
      line: (line) => {
        say({ line });
      },
      ended,
    });
    return transport;
  };
  end.addEventListener("message", ({ data }) => {
    if (!engine) {
      engine = started(data);
      engine.catch(ended);
      return;
    }
    const line = data as string;
    engine.then(
      (transport) => {
        transport.send(line);
      },
      () => undefined, // its end has been told
    );
  });
}
