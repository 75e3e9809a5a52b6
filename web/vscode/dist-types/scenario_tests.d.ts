import { type Disposable } from "vscode";
import type { Engines } from "./engines";
export declare function registerTests(engines: Engines): Disposable[];
