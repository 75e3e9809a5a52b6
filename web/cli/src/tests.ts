// Tests in commands of their own, several at a time, as tools/isolation_wasi.cc describes it: each
// worker thread starts the command again, which takes one test after the other.

import { availableParallelism } from "node:os";
import {
  MessageChannel,
  type MessagePort,
  receiveMessageOnPort,
  Worker,
  workerData,
} from "node:worker_threads";

import { type CommandLine, runCommand, type TestImports } from "./command.js";

/** In place of the size of an outcome: see isolation_wasi.cc. */
const End = { crashed: -1, tookTooLong: -2, exited: -16 } as const;

/** Numbers that all threads share. */
const Shared = { next: 0, count: 1, news: 2, first: 3 } as const;
const none = -1;

/** How often the time limit is looked at. */
const lookMs = 100;

interface WorkerTask {
  module: WebAssembly.Module;
  line: CommandLine;
  shared: Int32Array;
  /**
   * Where the worker says in `shared` which test it runs. Who clears it says how the test ended.
   */
  slot: number;
  port: MessagePort;
}

/** What became of a test, or that a worker has nothing more to do. */
type News = { test: number; outcome: Uint8Array | number } | { over: true };

interface Running {
  worker: Worker;
  port: MessagePort;
  slot: number;
  /** The test that it was seen to run, and since when. */
  test: number;
  since: number;
}

/** For the command that was called: it has its tests run by others. */
export class TestRunner implements TestImports {
  readonly #module: WebAssembly.Module;
  readonly #line: CommandLine;
  readonly #script: URL;
  #outcomes: (Uint8Array | number)[] = [];
  #done = 0;

  /** @param script that a worker runs: it calls runTests() */
  constructor(module: WebAssembly.Module, line: CommandLine, script: URL) {
    this.#module = module;
    this.#line = line;
    this.#script = script;
  }

  processors(): number {
    return availableParallelism();
  }

  runs_tests(): number {
    return 0;
  }

  next_test(): number {
    return none;
  }

  give_outcome(): void {
    throw new Error("only a command that runs tests has outcomes");
  }

  outcome_size(test: number): number {
    const outcome = this.#outcomes[test];
    return typeof outcome === "object" ? outcome.length : (outcome ?? End.crashed);
  }

  outcome(test: number): Uint8Array {
    const outcome = this.#outcomes[test];
    return typeof outcome === "object" ? outcome : new Uint8Array();
  }

  run_tests(count: number, jobs: number, timeoutSeconds: number): void {
    this.#outcomes = new Array<number>(count).fill(End.crashed);
    this.#done = 0;
    const workers = Math.max(1, Math.min(jobs, count));
    const shared = new Int32Array(new SharedArrayBuffer(4 * (Shared.first + workers)));
    shared[Shared.count] = count;
    const running = Array.from({ length: workers }, (_, i) =>
      this.#start(shared, Shared.first + i),
    );
    while (this.#done < count && running.length > 0) {
      const seen = Atomics.load(shared, Shared.news);
      const before = this.#done;
      for (const each of [...running]) {
        if (this.#hear(each)) running.splice(running.indexOf(each), 1);
      }
      if (timeoutSeconds > 0) this.#hurry(running, shared, timeoutSeconds);
      if (this.#done === before) Atomics.wait(shared, Shared.news, seen, lookMs);
    }
    for (const { worker } of running) void worker.terminate();
  }

  #start(shared: Int32Array, slot: number): Running {
    const { port1, port2 } = new MessageChannel();
    shared[slot] = none;
    const task: WorkerTask = { module: this.#module, line: this.#line, shared, slot, port: port2 };
    const worker = new Worker(this.#script, { workerData: task, transferList: [port2] });
    worker.unref();
    return { worker, port: port1, slot, test: none, since: 0 };
  }

  /** Takes the news of a worker. True if it has ended. */
  #hear(from: Running): boolean {
    for (;;) {
      const received = receiveMessageOnPort(from.port) as { message: News } | undefined;
      if (received === undefined) return false;
      const news = received.message;
      if ("over" in news) return true;
      this.#outcomes[news.test] = news.outcome;
      ++this.#done;
    }
  }

  /** Replaces workers whose test takes too long. */
  #hurry(running: Running[], shared: Int32Array, timeoutSeconds: number): void {
    running.forEach((each, i) => {
      const test = Atomics.load(shared, each.slot);
      if (test !== each.test) {
        each.test = test;
        each.since = performance.now();
      }
      if (test === none || performance.now() - each.since < timeoutSeconds * 1000) return;
      // It may just end in time: then the worker is first.
      if (Atomics.compareExchange(shared, each.slot, test, none) !== test) return;
      void each.worker.terminate();
      this.#outcomes[test] = End.tookTooLong;
      ++this.#done;
      running[i] = this.#start(shared, each.slot);
    });
  }
}

/** For a command in a worker. */
class TestWorker implements TestImports {
  readonly #task: WorkerTask;
  #test: number = none;
  /** Another worker goes on, as a test took too long. */
  #replaced = false;

  constructor(task: WorkerTask) {
    this.#task = task;
  }

  /** The test that is run; -1: none. */
  get test(): number {
    return this.#test;
  }

  processors(): number {
    return availableParallelism();
  }

  runs_tests(): number {
    return 1;
  }

  next_test(): number {
    const { shared, slot } = this.#task;
    if (this.#replaced) return none;
    const test = Atomics.add(shared, Shared.next, 1);
    if (test >= Atomics.load(shared, Shared.count)) return none;
    Atomics.store(shared, slot, test);
    return (this.#test = test);
  }

  give_outcome(_test: number, outcome: Uint8Array): void {
    this.end(outcome);
  }

  run_tests(): void {
    throw new Error("tests are not run within tests");
  }

  outcome_size(): number {
    return End.crashed;
  }

  outcome(): Uint8Array {
    return new Uint8Array();
  }

  /** The test that is run has ended. */
  end(outcome: Uint8Array | number): void {
    const { shared, slot } = this.#task;
    const test = this.#test;
    this.#test = none;
    this.#replaced = Atomics.compareExchange(shared, slot, test, none) !== test;
    if (!this.#replaced) this.tell({ test, outcome });
  }

  tell(news: News): void {
    const { port, shared } = this.#task;
    port.postMessage(news);
    Atomics.add(shared, Shared.news, 1);
    Atomics.notify(shared, Shared.news);
  }
}

/** In a worker thread: runs tests until none is left, in a new command after each that ends one. */
export function runTests(): void {
  const task = workerData as WorkerTask;
  const tests = new TestWorker(task);
  for (;;) {
    let end: number = End.crashed;
    try {
      end = End.exited - runCommand(task.module, task.line, tests);
    } catch {
      // Whatever it is: who waits for this thread hears of no error that ends it.
    }
    if (tests.test === none) break;
    tests.end(end);
  }
  tests.tell({ over: true });
}
