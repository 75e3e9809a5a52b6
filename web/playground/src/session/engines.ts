// Engines of this page. The module is fetched and compiled once, and each engine that it makes has
// a worker; if the page comes from `oncard serve`, its sessions are there instead.

import { Engine, HttpTransport, WorkerTransport } from "@oncard/engine";

import { hasEngineHere } from "../share/address.js";

let module: Promise<WebAssembly.Module> | undefined;

async function fetchModule(): Promise<WebAssembly.Module> {
  const response = await fetch(new URL("oncard.wasm", document.baseURI));
  if (!response.ok) throw new Error(`oncard.wasm: ${response.status} ${response.statusText}`);
  // Not compileStreaming: that refuses a server that does not know the type of the file.
  return WebAssembly.compile(await response.arrayBuffer());
}

/**
 * A new engine in a worker of its own. Whatever it computes, closing it ends that at once.
 * @throws the module cannot be fetched or compiled
 */
export async function startModule(): Promise<Engine> {
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

/**
 * A new engine for the session of the page: that of `oncard serve` if the page comes from there,
 * otherwise the module.
 * @throws the module cannot be fetched or compiled
 */
export async function startEngine(): Promise<Engine> {
  if (!hasEngineHere(location.href)) return startModule();
  const engine = new Engine(new HttpTransport(document.baseURI));
  addEventListener("pagehide", ({ persisted }) => {
    // A page that is kept may be shown again.
    if (!persisted) engine.close();
  });
  return engine;
}
