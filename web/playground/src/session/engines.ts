// Engines of this page. A module is fetched and compiled once, and each engine that it makes has a
// worker; if the page comes from `oncard serve`, its sessions are there instead.

import { Engine, HttpTransport, WorkerTransport } from "@oncard/engine";

import { hasEngineHere } from "../share/address.js";

/**
 * What an engine is for. Programs are what everybody begins with; the module for them is smaller.
 * The other one explores them, too, and reads records of all families of cards.
 */
export type Purpose = "programs" | "explorations" | "records";

const files: Record<Purpose, string> = {
  programs: "oncard.wasm",
  explorations: "oncard-full.wasm",
  records: "oncard-full.wasm",
};

const modules = new Map<string, Promise<WebAssembly.Module>>();

async function fetchModule(file: string): Promise<WebAssembly.Module> {
  const response = await fetch(new URL(file, document.baseURI));
  if (!response.ok) throw new Error(`${file}: ${response.status} ${response.statusText}`);
  // While it comes; that refuses the answer of a server that does not know the type of the file.
  const isKnown = response.headers.get("Content-Type") === "application/wasm";
  return isKnown
    ? WebAssembly.compileStreaming(response)
    : WebAssembly.compile(await response.arrayBuffer());
}

async function compiledModule(purpose: Purpose): Promise<WebAssembly.Module> {
  const file = files[purpose];
  const module = modules.get(file) ?? fetchModule(file);
  modules.set(file, module);
  try {
    return await module;
  } catch (error) {
    modules.delete(file); // the next attempt fetches it again
    throw error;
  }
}

/**
 * A new engine in a worker of its own. Whatever it computes, closing it ends that at once.
 * @throws the module cannot be fetched or compiled
 */
export async function startModule(purpose: Purpose): Promise<Engine> {
  // Its script comes beside the module.
  const worker = new Worker(new URL("worker.js", document.baseURI));
  const failed = new Promise<never>((_, reject) => {
    worker.addEventListener("error", ({ message }) => {
      reject(new Error(message || "worker.js cannot be fetched"));
    });
  });
  try {
    const compiled = await Promise.race([compiledModule(purpose), failed]);
    return new Engine(new WorkerTransport(worker, compiled));
  } catch (error) {
    worker.terminate();
    throw error;
  }
}

/**
 * Fetches what an engine for records needs beside one for programs. False if it needs nothing,
 * because they are the same.
 * @throws the module cannot be fetched or compiled
 */
export async function fetchForRecords(): Promise<boolean> {
  if (hasEngineHere(location.href)) return false;
  await compiledModule("records");
  return true;
}

/**
 * A new engine for the session of the page: that of `oncard serve` if the page comes from there,
 * otherwise a module.
 * @throws the module cannot be fetched or compiled
 */
export async function startEngine(purpose: Purpose): Promise<Engine> {
  if (!hasEngineHere(location.href)) return startModule(purpose);
  const engine = new Engine(new HttpTransport(document.baseURI));
  addEventListener("pagehide", ({ persisted }) => {
    // A page that is kept may be shown again.
    if (!persisted) engine.close();
  });
  return engine;
}
