// The engine of a launch: the command or the module.
// Tested by test/launch.test.ts.

import { Engine } from "@oncard/engine";
import { ChildProcessTransport } from "@oncard/engine/child-process";
import { openModule } from "@oncard/engine/disk";

import type { LaunchConfig } from "./launch.js";

export async function startEngine({ oncard, module }: LaunchConfig): Promise<Engine> {
  return module === undefined ? new Engine(new ChildProcessTransport(oncard)) : openModule(module);
}
