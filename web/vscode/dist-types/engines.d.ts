import { Engine } from "@oncard/engine";
type Environment = Readonly<Record<string, string | undefined>>;
/** A program of this name in the folders of `PATH`. */
export declare function findInPath(environment: Environment, platform?: NodeJS.Platform): string | undefined;
export declare class Engines {
    #private;
    /** @param folder of the extension */
    constructor(folder: string);
    /** Path of the command: that of the setting, or in `PATH`. */
    command(): string | undefined;
    get module(): string;
    get server(): string;
    get adapter(): string;
    /** An engine that says everything in the language of the editor. Whoever opens it closes it. */
    open(): Promise<Engine>;
    /** The module, also if there is a command: only it answers `explore`. */
    openModule(): Promise<Engine>;
}
export {};
