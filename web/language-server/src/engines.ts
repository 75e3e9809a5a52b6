// Which engine a server has: the module beside it, or the one that its environment names.
// Tested by test/server.test.ts.

import { existsSync } from "node:fs";
import { dirname, join } from "node:path";

import { Engine } from "@oncard/engine";
import { ChildProcessTransport } from "@oncard/engine/child-process";
import { openModule } from "@oncard/engine/disk";

type Environment = Readonly<Record<string, string | undefined>>;

/** `ONCARD` names the command, `ONCARD_MODULE` the module. */
export async function openEngine(environment: Environment, program: string): Promise<Engine> {
  const command = environment["ONCARD"];
  const bundled = join(dirname(program), "oncard.wasm");
  const module = environment["ONCARD_MODULE"] ?? (existsSync(bundled) ? bundled : undefined);
  if (command === undefined && module !== undefined) return openModule(module);
  return new Engine(new ChildProcessTransport(command ?? "oncard"));
}
