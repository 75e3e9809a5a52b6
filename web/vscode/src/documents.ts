// Which documents are oncard's: the same as for the language server.

import { Documents, type Kind, pathOf } from "@oncard/language-server/documents";
import { type TextDocument, workspace } from "vscode";

const documents = new Documents(() =>
  workspace.textDocuments
    .filter(({ uri }) => uri.scheme === "file")
    .map((document) => ({
      uri: document.uri.toString(),
      languageId: document.languageId,
      getText: () => document.getText(),
    })),
);

/** Nothing if a document is none of oncard's business. */
export async function kindOf(document: TextDocument): Promise<Kind | undefined> {
  return document.uri.scheme === "file"
    ? documents.kind({
        uri: document.uri.toString(),
        languageId: document.languageId,
        getText: () => document.getText(),
      })
    : undefined;
}

/** The text of all open files, and the path that the engine has for a document. */
export function projectOf(document: TextDocument): { main: string; files: Record<string, string> } {
  return { main: pathOf(document.uri.toString()), files: documents.openTexts() };
}

/** The scenario with which a program runs, or the document itself. */
export async function mainOf(document: TextDocument): Promise<string> {
  const path = pathOf(document.uri.toString());
  return (await documents.scenarioOf(path)) ?? path;
}
