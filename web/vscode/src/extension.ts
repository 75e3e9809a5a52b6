// The extension for Visual Studio Code: activation.

import type { ExtensionContext } from "vscode";

import { startClient } from "./client";
import { Engines } from "./engines";
import { registerFeatures } from "./features";

export async function activate({ extensionPath, subscriptions }: ExtensionContext): Promise<void> {
  const engines = new Engines(extensionPath);
  subscriptions.push(...registerFeatures(engines));
  subscriptions.push(await startClient(engines));
}
