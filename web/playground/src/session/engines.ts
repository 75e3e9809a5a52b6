// Engines of this page: the module is fetched and compiled once, and each engine has a worker.

import { Engine, WorkerTransport } from "@oncard/engine";

let module: Promise<WebAssembly.Module> | undefined;

async function fetchModule(): Promise<WebAssembly.Module> {
  const response = await fetch(new URL("oncard.wasm", document.baseURI));
  if (!response.ok) throw new Error(`oncard.wasm: ${response.status} ${response.statusText}`);
  // Not compileStreaming: that refuses a server that does not know the type of the file.
  return WebAssembly.compile(await response.arrayBuffer());
}

/**
 * A new engine in a worker of its own.
 * @throws the module cannot be fetched or compiled
 */
export async function startEngine(): Promise<Engine> {
  module ??= fetchModule();
  try {
    const compiled = await module;
    const worker = new Worker(new URL("worker.js", document.baseURI));
    return new Engine(new WorkerTransport(worker, compiled));
  } catch (error) {
    module = undefined; // the next attempt fetches it again
    throw error;
  }
}
