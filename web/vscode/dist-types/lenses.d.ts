import { CodeLens, type Disposable, type TextDocument } from "vscode";
export declare const selector: {
    scheme: string;
    language: string;
}[];
export declare function registerLenses(): Disposable;
export declare function lensesOf(document: TextDocument): Promise<CodeLens[]>;
