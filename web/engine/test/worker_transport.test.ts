import {
  Engine,
  type MessageEnd,
  serveWorker,
  type WorkerEnd,
  WorkerTransport,
} from "@oncard/engine";
import { MessageChannel } from "node:worker_threads";
import { expect, onTestFinished, test } from "vitest";

/** Both ends of a worker that runs in this thread. */
function workerOf(serve: (end: MessageEnd) => void): WorkerEnd & { fail(message: string): void } {
  const { port1, port2 } = new MessageChannel();
  onTestFinished(() => {
    port1.close();
  });
  serve(port2 as unknown as MessageEnd);
  port1.start();
  port2.start();
  let failed: (event: { message?: string }) => void = () => undefined;
  return {
    postMessage: (message: unknown) => {
      port1.postMessage(message);
    },
    addEventListener: (type: "message" | "error", listener: (event: never) => void) => {
      if (type === "error") failed = listener as typeof failed;
      else port1.addEventListener(type, listener as never);
    },
    terminate: () => {
      port1.close();
    },
    fail: (message) => {
      failed({ message });
    },
  };
}

/** Answers each request with its name and with what the worker was started with. */
const echo = (start: unknown) =>
  Promise.resolve({
    handle: (text: string) => {
      const { id, request } = JSON.parse(text) as { id: number; request: string };
      const log = { event: "log", moment: 1, thread: 0, text: "event" };
      const answer = { id, ok: true, result: { request, start } };
      return `${JSON.stringify(log)}\n${JSON.stringify(answer)}\n`;
    },
  });

test("requests go to the worker, answers and events come back", async () => {
  const worker = workerOf((end) => {
    serveWorker(end, echo);
  });
  const engine = new Engine(new WorkerTransport(worker, "module"));
  const log: string[] = [];
  engine.onLog = ({ text }) => log.push(text);
  const both = await Promise.all([engine.state(), engine.card()]);
  expect(both).toEqual([
    { request: "state", start: "module" },
    { request: "card", start: "module" },
  ]);
  expect(log).toEqual(["event", "event"]);
});

test("an engine that cannot be started fails all its requests", async () => {
  const worker = workerOf((end) => {
    serveWorker(end, () => Promise.reject(new Error("this is no module")));
  });
  const engine = new Engine(new WorkerTransport(worker, "text"));
  await expect(engine.state()).rejects.toThrow("this is no module");
  await expect(engine.state()).rejects.toThrow("this is no module");
});

test("an engine that ends within a request", async () => {
  const worker = workerOf((end) => {
    serveWorker(end, () =>
      Promise.resolve({
        handle: () => {
          throw new Error("the memory is full");
        },
      }),
    );
  });
  const engine = new Engine(new WorkerTransport(worker, 0));
  const ended: string[] = [];
  engine.onEnded = ({ message }) => ended.push(message);
  await expect(engine.state()).rejects.toThrow("the memory is full");
  expect(ended).toEqual(["the memory is full"]);
});

test("a worker whose script cannot be had", async () => {
  const worker = workerOf(() => undefined);
  const engine = new Engine(new WorkerTransport(worker, 0));
  const state = engine.state();
  worker.fail("404");
  await expect(state).rejects.toThrow("404");
});
