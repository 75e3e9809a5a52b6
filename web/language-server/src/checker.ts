// Asks the engine what is wrong with a program or a scenario, and places it in the editor.
// Tested by test/server.test.ts.

import {
  type Compiled,
  type Diagnostic as EngineDiagnostic,
  type Engine,
  type Project,
  RefusedError,
} from "@oncard/engine";
import {
  type Diagnostic,
  type DiagnosticRelatedInformation,
  DiagnosticSeverity,
} from "vscode-languageserver";

import type { Documents, Kind } from "./documents.js";
import { beside, normal, uriOf } from "./paths.js";
import { Lines, type PlaceRange } from "./positions.js";
import { placedMistakes } from "./refusals.js";

/** What is kept with a diagnostic for the time when fixes are asked for. */
export interface DiagnosticData {
  fixits: EngineDiagnostic["fixits"];
}

const severities = {
  error: DiagnosticSeverity.Error,
  warning: DiagnosticSeverity.Warning,
};

/** Diagnostics by the file that they are in. */
export type Findings = Map<string, Diagnostic[]>;

export class Checker {
  readonly #documents: Documents;
  readonly #lines = new Map<string, Lines>();

  constructor(documents: Documents) {
    this.#documents = documents;
  }

  /** Checks a file as it is now. */
  async check(engine: Engine, path: string, kind: Kind): Promise<Findings> {
    this.#lines.clear();
    const findings: Findings = new Map([[path, []]]);
    const files = this.#documents.openTexts();
    try {
      const compiled =
        kind === "scenario"
          ? await engine.load({ main: path, files })
          : await this.#checkProgram(engine, path, files);
      for (const each of compiled.diagnostics) await this.#add(findings, path, each);
    } catch (error) {
      if (!(error instanceof RefusedError)) throw error;
      await this.#addRefusal(findings, path, error.message);
    }
    return findings;
  }

  /** Options of a program are in its scenario. One that has mistakes does not hide the program's. */
  async #checkProgram(
    engine: Engine,
    path: string,
    files: NonNullable<Project["files"]>,
  ): Promise<Compiled> {
    const scenario = await this.#documents.scenarioOf(path);
    if (scenario !== undefined) {
      try {
        return await engine.check({ main: scenario, files });
      } catch (error) {
        if (!(error instanceof RefusedError)) throw error;
      }
    }
    return engine.check({ main: path, files });
  }

  async #add(findings: Findings, main: string, found: EngineDiagnostic): Promise<void> {
    const file = beside(main, found.file);
    const related: DiagnosticRelatedInformation[] = [];
    for (const { message, ...at } of found.notes) {
      const { file: noted = found.file, line, column, end_line, end_column } = at;
      const place = { line, column, end_line, end_column };
      const range = hasPlace(place) ? place : found;
      const notedFile = beside(main, noted);
      const location = { uri: uriOf(notedFile), range: (await this.#of(notedFile)).range(range) };
      related.push({ location, message });
    }
    const data: DiagnosticData = { fixits: found.fixits };
    const diagnostic: Diagnostic = {
      range: (await this.#of(file)).range(found),
      severity: severities[found.severity],
      code: found.code,
      source: "oncard",
      message: found.message,
      data,
    };
    if (related.length > 0) diagnostic.relatedInformation = related;
    push(findings, file, diagnostic);
  }

  /** A refusal that is about no place is shown at the beginning. */
  async #addRefusal(findings: Findings, main: string, refusal: string): Promise<void> {
    const common = { severity: DiagnosticSeverity.Error, source: "oncard" };
    const mistakes = placedMistakes(refusal);
    if (mistakes.length === 0) {
      const start = { line: 0, character: 0 };
      push(findings, main, { ...common, range: { start, end: start }, message: refusal });
    }
    for (const { file, message, ...range } of mistakes) {
      const path = beside(main, file);
      push(findings, path, { ...common, range: (await this.#of(path)).range(range), message });
    }
  }

  async #of(path: string): Promise<Lines> {
    const key = normal(path);
    const known = this.#lines.get(key);
    if (known) return known;
    const lines = new Lines((await this.#documents.text(key)) ?? "");
    this.#lines.set(key, lines);
    return lines;
  }
}

function push(findings: Findings, path: string, diagnostic: Diagnostic): void {
  const list = findings.get(path) ?? [];
  list.push(diagnostic);
  findings.set(path, list);
}

function hasPlace(place: { [Key in keyof PlaceRange]: number | undefined }): place is PlaceRange {
  return place.line !== undefined && place.end_line !== undefined;
}
