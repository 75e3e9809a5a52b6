import { type Disposable } from "vscode";
import type { Engines } from "./engines";
export declare function registerFeatures(engines: Engines): Disposable[];
