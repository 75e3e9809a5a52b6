// A module, oncard.wasm or oncard-full.wasm, as a class, for Node 18 or later, pages and Web
// Workers. It imports nothing: its answers depend on its requests alone. web/README.md describes
// requests and answers.
// Tested by tests/web/module_test.mjs.

const utf8Encoder = new TextEncoder();
const utf8Decoder = new TextDecoder();

/** The module ended within a request, or was given one that it cannot hold. */
export class ModuleError extends Error {}

export class EngineModule {
  /** @type {WebAssembly.Module} */
  #module;
  /** @type {WebAssembly.Exports} */
  #functions;

  /**
   * @param {WebAssembly.Module} module
   * @param {WebAssembly.Instance} instance
   */
  constructor(module, instance) {
    this.#module = module;
    this.#functions = started(instance);
  }

  /**
   * @param {BufferSource} bytes the content of the module's file
   * @returns {Promise<EngineModule>}
   */
  static async create(bytes) {
    const { module, instance } = await WebAssembly.instantiate(bytes);
    return new EngineModule(module, instance);
  }

  /** The version of oncard. */
  get version() {
    const bytes = new Uint8Array(this.#functions.memory.buffer, this.#functions.oncard_version());
    return utf8Decoder.decode(bytes.subarray(0, bytes.indexOf(0)));
  }

  /**
   * Answers a request. When the module ends within it (its memory or its stack is full), everything
   * that it knew is lost: it has started anew when the error arrives.
   * @param {string | Uint8Array} request JSON, as text or as its bytes in UTF-8
   * @returns {string} JSON lines
   * @throws {ModuleError}
   */
  handle(request) {
    const bytes = typeof request === "string" ? utf8Encoder.encode(request) : request;
    try {
      return this.#exchange(bytes);
    } catch (error) {
      if (!(error instanceof WebAssembly.RuntimeError) && !(error instanceof RangeError))
        throw error;
      this.#functions = started(new WebAssembly.Instance(this.#module));
      throw new ModuleError(`the module ended and has started anew: ${error.message}`);
    }
  }

  /** @param {Uint8Array} bytes */
  #exchange(bytes) {
    const { memory, oncard_request, oncard_handle, oncard_answer } = this.#functions;
    const place = oncard_request(bytes.length) >>> 0;
    if (place === 0) throw new ModuleError(`a request of ${bytes.length} bytes is too large`);
    new Uint8Array(memory.buffer, place, bytes.length).set(bytes);
    const size = oncard_handle() >>> 0;
    // The memory may have grown, which replaces its buffer.
    return utf8Decoder.decode(new Uint8Array(memory.buffer, oncard_answer() >>> 0, size));
  }
}

/** @param {WebAssembly.Instance} instance */
function started(instance) {
  instance.exports._initialize();
  return instance.exports;
}
