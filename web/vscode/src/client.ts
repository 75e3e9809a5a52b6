// The language server, in a process of its own.

import { workspace, type Disposable } from "vscode";
import { LanguageClient, TransportKind } from "vscode-languageclient/node";

import type { Engines } from "./engines";
import { selector } from "./lenses";

/** The server has the module: it must know the same requests as the server. */
export async function startClient(engines: Engines): Promise<Disposable> {
  const env = { ...process.env, ONCARD: undefined, ONCARD_MODULE: engines.module };
  const server = { module: engines.server, transport: TransportKind.ipc, options: { env } };
  const watcher = workspace.createFileSystemWatcher("**/*.{c,h,toml}");
  const client = new LanguageClient("oncard", "oncard", server, {
    documentSelector: selector,
    synchronize: { fileEvents: watcher },
  });
  await client.start();
  return {
    dispose: () => {
      watcher.dispose();
      void client.stop();
    },
  };
}
