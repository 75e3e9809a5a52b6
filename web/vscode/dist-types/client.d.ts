import { type Disposable } from "vscode";
import type { Engines } from "./engines";
/** The server has the module: it must know the same requests as the server. */
export declare function startClient(engines: Engines): Promise<Disposable>;
