// Types of engine_module.js.

/** The module ended within a request, or was given one that it cannot hold. */
export class ModuleError extends Error {}

export class EngineModule {
  /** @param instance one of the module, which has not been used yet */
  constructor(module: WebAssembly.Module, instance: WebAssembly.Instance);
  /** @param bytes the content of the module's file */
  static create(bytes: Uint8Array | ArrayBuffer): Promise<EngineModule>;
  /** The version of oncard. */
  get version(): string;
  /**
   * Answers a request, JSON as text or as its bytes, with lines of JSON.
   * @throws ModuleError: it has lost everything that it knew, and has started anew
   */
  handle(request: string | Uint8Array): string;
}
