// The program as the editor sees it: its files, and its card statements with made-up addresses.

import { basename, resolve } from "node:path";

import type { ListedFunction, SourceFile, Thread } from "@oncard/engine";
import { Source, StackFrame } from "@vscode/debugadapter";
import type { DebugProtocol } from "@vscode/debugprotocol";

interface Statement {
  function: string;
  /** In its function, from 0. */
  position: number;
  file: string;
  line: number;
  text: string;
}

/** The first statement's address: a disassembly view also asks for what is before it. */
const firstAddress = 0x100000;

export class Code {
  readonly #files: readonly SourceFile[];
  readonly #functions: readonly ListedFunction[];
  readonly #statements: Statement[] = [];
  /** Address of each function's first statement. */
  readonly #addresses = new Map<string, number>();

  constructor(files: readonly SourceFile[], functions: readonly ListedFunction[]) {
    this.#files = files;
    this.#functions = functions;
    for (const { name, file, statements } of functions) {
      this.#addresses.set(name, firstAddress + this.#statements.length);
      for (const [position, { line, text }] of statements.entries()) {
        this.#statements.push({ function: name, position, file, line, text });
      }
    }
  }

  /** The same files with the functions of another program. */
  with(functions: readonly ListedFunction[]): Code {
    return new Code(this.#files, functions);
  }

  // --- Files -------------------------------------------------------------------------------------

  sources(): Source[] {
    return this.#files.map(({ path }) => new Source(basename(path), resolve(path)));
  }

  /** The source with the name that threads and statements have for it. */
  source(file: string): Source | undefined {
    const found = this.#files.find(({ path }) => isNamed(path, file));
    return found && new Source(basename(found.path), resolve(found.path));
  }

  text(source: DebugProtocol.Source): string | undefined {
    return this.#find(source)?.text;
  }

  /** The name that threads and statements have for a source; it has statements of its own. */
  fileOf(source: DebugProtocol.Source): string | undefined {
    const found = this.#find(source);
    if (!found) return undefined;
    // It may belong to a program that a host has not downloaded yet.
    if (this.#functions.length === 0) return basename(found.path);
    return this.#functions.find(({ file }) => isNamed(found.path, file))?.file;
  }

  #find(source: DebugProtocol.Source): SourceFile | undefined {
    const path = source.path;
    return path === undefined
      ? undefined
      : this.#files.find((file) => resolve(file.path) === resolve(path));
  }

  /** Where a function begins. */
  beginning(name: string): { file: string; line: number } | undefined {
    const found = this.#functions.find((each) => each.name === name);
    const first = found?.statements[0];
    return found && first && { file: found.file, line: first.line };
  }

  /** Of all functions. */
  names(): string[] {
    return this.#functions.map(({ name }) => name);
  }

  // --- Statements --------------------------------------------------------------------------------

  /** The address of the statement that a thread executes next. */
  #addressOf(thread: Thread): string | undefined {
    const first = this.#addresses.get(thread.function);
    return first === undefined ? undefined : hexadecimal(first + thread.position);
  }

  /** The statement at an address of the disassembly. */
  statementAt(address: number): { function: string; position: number } | undefined {
    return this.#statements[address - firstAddress];
  }

  /** Where a thread stands. */
  frame(id: number, thread: Thread): StackFrame {
    const frame = new StackFrame(id, thread.function, this.source(thread.file), thread.line, 1);
    const address = this.#addressOf(thread);
    if (address !== undefined) frame.instructionPointerReference = address;
    return frame;
  }

  /** Exactly `count` rows, some of which may be outside of the program. */
  disassemble(address: number, count: number): DebugProtocol.DisassembledInstruction[] {
    return Array.from({ length: count }, (_, row) => this.#row(address + row));
  }

  #row(address: number): DebugProtocol.DisassembledInstruction {
    const at = { address: hexadecimal(Math.max(0, address)) };
    const statement = this.#statements[address - firstAddress];
    if (!statement) return { ...at, instruction: "", presentationHint: "invalid" };
    const row: DebugProtocol.DisassembledInstruction = {
      ...at,
      instruction: statement.text,
      line: statement.line,
    };
    const source = this.source(statement.file);
    if (source) row.location = source;
    if (this.#addresses.get(statement.function) === address) row.symbol = statement.function;
    return row;
  }
}

/** True if a path ends in the name. */
function isNamed(path: string, name: string): boolean {
  return path === name || path.endsWith(`/${name}`) || path.endsWith(`\\${name}`);
}

function hexadecimal(value: number): string {
  return `0x${value.toString(16)}`;
}
