// The thread functions of a program, as it is on the screen. The engine that knows them stays open:
// they are asked for while the user types.
// Tested by test/features.test.ts.

import type { Engine, OutlineEntry } from "@oncard/engine";
import type { Disposable, TextDocument } from "vscode";

import { mainOf, projectOf } from "./documents";
import type { Engines } from "./engines";

export class Outlines implements Disposable {
  readonly #engines: Engines;
  #engine: Promise<Engine> | undefined;

  constructor(engines: Engines) {
    this.#engines = engines;
  }

  /** Where threads can begin; nothing if the engine does not work. */
  async threadFunctions(document: TextDocument): Promise<OutlineEntry[]> {
    const opened = (this.#engine ??= this.#engines.open());
    try {
      const engine = await opened;
      const { main: file, files } = projectOf(document);
      const outline = await engine.outline({ main: await mainOf(document), files, file });
      return outline.filter((entry) => entry.thread_function && entry.definition);
    } catch {
      // Whoever needs the engine for more says what is wrong with it.
      if (this.#engine === opened) this.dispose();
      return [];
    }
  }

  dispose(): void {
    this.#engine?.then((engine) => {
      engine.close();
    }, ignore);
    this.#engine = undefined;
  }
}

function ignore(): void {
  // An engine that did not start need not be closed.
}
