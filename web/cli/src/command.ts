// Runs the command of the module once: `oncard` with arguments, from its start to its exit code.

import { Exit, System } from "./system.js";

/** Those of isolation_wasi.cc that run tests (tests.ts). */
export interface TestImports {
  processors(): number;
  /** Whether this command was started to run tests. */
  runs_tests(): number;
  next_test(): number;
  give_outcome(test: number, outcome: Uint8Array): void;
  run_tests(tests: number, jobs: number, timeoutSeconds: number): void;
  outcome_size(test: number): number;
  outcome(test: number): Uint8Array;
}

/** What a command is started with. */
export interface CommandLine {
  args: string[];
  environment: Record<string, string>;
}

/**
 * @returns the exit code
 * @throws WebAssembly.RuntimeError, RangeError if the command crashes
 */
export function runCommand(
  module: WebAssembly.Module,
  line: CommandLine,
  tests: TestImports,
): number {
  const system = new System(["oncard", ...line.args], line.environment);
  const instance = new WebAssembly.Instance(module, {
    wasi_snapshot_preview1: system.imports,
    oncard: {
      processors: () => tests.processors(),
      runs_tests: () => tests.runs_tests(),
      next_test: () => tests.next_test(),
      give_outcome: (test: number, at: number, size: number) => {
        tests.give_outcome(test, system.bytes(at, size).slice());
      },
      run_tests: (count: number, jobs: number, timeoutSeconds: number) => {
        tests.run_tests(count, jobs, timeoutSeconds);
      },
      outcome_size: (test: number) => tests.outcome_size(test),
      take_outcome: (test: number, at: number) => {
        const outcome = tests.outcome(test);
        system.bytes(at, outcome.length).set(outcome);
      },
    },
  });
  const { memory, _start } = instance.exports as {
    memory: WebAssembly.Memory;
    _start: () => void;
  };
  system.memory = memory;
  try {
    _start();
    return 0;
  } catch (error) {
    if (error instanceof Exit) return error.exitCode;
    throw error;
  }
}
