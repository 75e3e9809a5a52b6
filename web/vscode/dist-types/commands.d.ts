import { type Disposable, type OutputChannel } from "vscode";
import type { Engines } from "./engines";
export declare function registerCommands(engines: Engines, output: OutputChannel): Disposable[];
