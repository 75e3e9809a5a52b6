// Which engine works for the extension: the `oncard` command if there is one, otherwise the module
// that the extension contains, in a process of its own so that the editor goes on meanwhile.
// Tested by test/engines.test.ts.

import { accessSync, constants, statSync } from "node:fs";
import { delimiter, join } from "node:path";

import { Engine } from "@oncard/engine";
import { ChildProcessTransport } from "@oncard/engine/child-process";
import { textOnDisk } from "@oncard/engine/disk";
import { workspace } from "vscode";

import { language } from "./texts";

type Environment = Readonly<Record<string, string | undefined>>;

/** A program of this name in the folders of `PATH`. */
export function findInPath(
  environment: Environment,
  platform = process.platform,
): string | undefined {
  const names = platform === "win32" ? ["oncard.exe"] : ["oncard"];
  const path = environment["PATH"] ?? environment["Path"] ?? "";
  for (const folder of path.split(delimiter)) {
    for (const name of names) {
      const file = join(folder, name);
      if (folder !== "" && isProgram(file)) return file;
    }
  }
  return undefined;
}

function isProgram(file: string): boolean {
  try {
    accessSync(file, constants.X_OK);
    return statSync(file).isFile();
  } catch {
    return false;
  }
}

export class Engines {
  readonly #folder: string;

  /** @param folder of the extension */
  constructor(folder: string) {
    this.#folder = folder;
  }

  /** Path of the command: that of the setting, or in `PATH`. */
  command(): string | undefined {
    const set = workspace.getConfiguration("oncard").get<string>("path");
    return set === undefined || set === "" ? findInPath(process.env) : set;
  }

  get module(): string {
    return this.#file("oncard.wasm");
  }

  get server(): string {
    return this.#file("server.js");
  }

  get adapter(): string {
    return this.#file("adapter.js");
  }

  /** Where the pages are that panels show. */
  get viewFolder(): string {
    return this.#file("");
  }

  /** An engine that says everything in the language of the editor. Whoever opens it closes it. */
  async open(): Promise<Engine> {
    const command = this.command();
    const engine =
      command === undefined ? this.#moduleEngine() : new Engine(new ChildProcessTransport(command));
    return this.#greeted(engine);
  }

  /** The module, also if there is a command: only it answers `explore`. */
  async openModule(): Promise<Engine> {
    return this.#greeted(this.#moduleEngine());
  }

  #moduleEngine(): Engine {
    // The editor's own Node: there may be no other.
    const environment = { ...process.env, ELECTRON_RUN_AS_NODE: "1" };
    const args = [this.#file("engine.js"), this.module];
    const engine = new Engine(new ChildProcessTransport(process.execPath, args, environment));
    engine.supply = textOnDisk;
    return engine;
  }

  async #greeted(engine: Engine): Promise<Engine> {
    try {
      await engine.hello(language());
      return engine;
    } catch (error) {
      engine.close();
      throw error;
    }
  }

  #file(name: string): string {
    return join(this.#folder, "dist", name);
  }
}
