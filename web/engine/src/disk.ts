// Files for an engine that has none: the module.
// Tested by test/module_process.test.ts.

import { readFile } from "node:fs/promises";

/** The text of a file on disk, for `Engine.supply`; nothing if it cannot be read. */
export async function textOnDisk(path: string): Promise<string | undefined> {
  try {
    return await readFile(path, "utf8");
  } catch {
    return undefined;
  }
}
