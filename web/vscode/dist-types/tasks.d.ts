import { type Disposable, Task } from "vscode";
import type { Engines } from "./engines";
export declare const taskCommands: readonly ["build", "check", "run", "explore", "test"];
type Command = (typeof taskCommands)[number];
interface OncardTask {
    type: string;
    command: Command;
    file: string;
}
export declare const matchers: string[];
export declare function registerTasks(engines: Engines): Disposable;
/** A task for a file; its definition stays as it is written. */
export declare function taskOf(engines: Engines, definition: OncardTask): Task;
export {};
