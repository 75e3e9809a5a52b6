// The Web Worker of an engine: it gets the compiled module first, then requests.

import { type MessageEnd, serveWorker } from "@oncard/engine";
import { EngineModule } from "@oncard/engine/engine_module.js";

serveWorker(self as unknown as MessageEnd, async (start) => {
  const module = start as WebAssembly.Module;
  return new EngineModule(module, await WebAssembly.instantiate(module));
});
