import type { ListedFunction, SourceFile } from "@oncard/engine";
import { type Disposable } from "vscode";
import type { Engines } from "./engines";
export declare const listingScheme = "oncard-listing";
export declare function registerListing(engines: Engines): Disposable[];
/** Each line of a function with the card statements that it became. */
export declare function listingText(files: readonly SourceFile[], functions: readonly ListedFunction[]): string;
