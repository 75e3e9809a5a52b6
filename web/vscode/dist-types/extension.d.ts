import type { ExtensionContext } from "vscode";
export declare function activate({ extensionPath, subscriptions }: ExtensionContext): Promise<void>;
