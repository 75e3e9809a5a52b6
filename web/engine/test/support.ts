// Engines for tests: the real one in a process of its own, and one that says what a test wants.

import { existsSync } from "node:fs";
import { resolve } from "node:path";
import { fileURLToPath } from "node:url";

import { Engine, type Receiver, type Transport } from "@oncard/engine";
import { ChildProcessTransport } from "@oncard/engine/child-process";
import { onTestFinished } from "vitest";

export const top = fileURLToPath(new URL("../../../", import.meta.url));

/** The `oncard` that is tested: ONCARD, or that of the last build. */
export const oncard = resolve(process.env["ONCARD"] ?? `${top}/build/bin/oncard`);
if (!existsSync(oncard)) throw new Error(`there is no ${oncard}: build it, or set ONCARD`);

/** What `./x wasm` builds; without it the module is not tested here. */
export const wasm = `${top}/build/web/oncard-full.wasm`;
export const withoutModule = !existsSync(wasm);

export function sample(path: string): string {
  return resolve(top, "samples", path);
}

/** An engine that ends with the test. */
export function startEngine(executable = oncard): Engine {
  const engine = new Engine(new ChildProcessTransport(executable));
  onTestFinished(() => {
    engine.close();
  });
  return engine;
}

/** An engine that has loaded a program that runs by itself. */
export async function engineOf(program: string): Promise<Engine> {
  const engine = startEngine();
  await engine.load({ main: "p.c", files: { "p.c": program } });
  return engine;
}

/** Answers requests with lines that a test supplies, and keeps the requests. */
export class ScriptedTransport implements Transport {
  readonly sent: string[] = [];
  readonly #answers: string[];
  #receiver: Receiver | undefined;

  constructor(answers: string[]) {
    this.#answers = answers;
  }

  connect(receiver: Receiver): void {
    this.#receiver = receiver;
  }

  send(line: string): void {
    this.sent.push(line);
    for (const text of this.#answers.shift()?.split("\n") ?? []) this.#receiver?.line(text);
  }

  close(): void {
    this.#receiver = undefined;
  }
}
