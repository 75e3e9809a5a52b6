import { type Disposable } from "vscode";
import type { Engines } from "./engines";
export declare function registerDebug(engines: Engines): Disposable[];
export declare function startDebugging(program: string): Thenable<boolean>;
