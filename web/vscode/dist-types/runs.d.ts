import type { Diagnostic, Engine, RunAnswer } from "@oncard/engine";
/** A diagnostic as `oncard check` prints its first line. */
export declare function headline({ file, line, column, severity, code, message, slug, }: Diagnostic): string;
/** What an engine says, and whether all is well. */
export interface Outcome {
    passed: boolean;
    lines: string[];
    /** A schedule file that repeats a failure of an exploration. */
    schedule?: string;
}
export declare function checked(engine: Engine, main: string): Promise<Outcome>;
export declare function ran(engine: Engine, main: string): Promise<Outcome>;
/** The lines of a run: what does not hold, and the values at the end. */
export declare function described({ diagnostics, run }: RunAnswer): Outcome;
export declare function explored(engine: Engine, main: string, language: "en" | "zh"): Promise<Outcome>;
