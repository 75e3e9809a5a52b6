import { type Kind } from "@oncard/language-server/documents";
import { type TextDocument } from "vscode";
/** Nothing if a document is none of oncard's business. */
export declare function kindOf(document: TextDocument): Promise<Kind | undefined>;
/** The text of all open files, and the path that the engine has for a document. */
export declare function projectOf(document: TextDocument): {
    main: string;
    files: Record<string, string>;
};
/** The scenario with which a program runs, or the document itself. */
export declare function mainOf(document: TextDocument): Promise<string>;
