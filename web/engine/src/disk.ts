// The module for Node, with the files of the disk.
// Tested by test/module_process.test.ts.

import { readFile } from "node:fs/promises";

import { EngineModule } from "../engine_module.js";
import { Engine } from "./engine.js";
import { ModuleTransport } from "./module.js";

/** The text of a file on disk, for `Engine.supply`; nothing if it cannot be read. */
export async function textOnDisk(path: string): Promise<string | undefined> {
  try {
    return await readFile(path, "utf8");
  } catch {
    return undefined;
  }
}

/** An engine in this process. @param path of a module */
export async function openModule(path: string): Promise<Engine> {
  const engine = new Engine(new ModuleTransport(await EngineModule.create(await readFile(path))));
  engine.supply = textOnDisk;
  return engine;
}
