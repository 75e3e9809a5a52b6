// The session protocol, version 1: what requests take and answer. docs/session-protocol.md says what
// the members mean; this file follows it name by name.

export const protocolVersion = 1;

export type Language = "en" | "zh";

/** A program that is to be compiled: `main` names a scenario, a recording or a program. */
export interface Project {
  main: string;
  /** The text of each file by its path; others are read by the engine if it can. */
  files?: Record<string, string>;
  /** The program is structured C. */
  structured?: boolean;
}

/** How a project is loaded. */
export interface LoadOptions {
  /** Which record of a host. */
  card?: number;
  opening?: number;
  /** Names of warnings of the card that are left out. */
  silent?: readonly string[];
}

export interface Hello {
  protocol: number;
  /** All requests with their arguments. */
  requests: Record<string, string>;
}

/** A message of the compiler; lines count from 1, columns from 1. */
export interface Diagnostic {
  code: string;
  slug: string;
  severity: "error" | "warning" | "note";
  message: string;
  file: string;
  line: number;
  column: number;
  end_line: number;
  end_column: number;
  notes: Note[];
  fixits: Fixit[];
}

/** More about a message; without a place if it is about none. */
export interface Note {
  message: string;
  file?: string;
  line?: number;
  column?: number;
  end_line?: number;
  end_column?: number;
}

/** A text that replaces what is between two places. */
export interface Fixit {
  file: string;
  line: number;
  column: number;
  end_line: number;
  end_column: number;
  text: string;
}

export interface Compiled {
  compiled: boolean;
  diagnostics: Diagnostic[];
}

export interface SourceFile {
  path: string;
  text: string;
}

export type Loaded =
  | { compiled: false; diagnostics: Diagnostic[] }
  | {
      compiled: true;
      diagnostics: Diagnostic[];
      files: SourceFile[];
      cards?: RecordedCard[];
      state: State;
    };

/** One of the records in the file of a host. */
export interface RecordedCard {
  card: number;
  opening: number;
  calls: number;
}

/** The calls of a recorded host. */
export interface HostState {
  /** With the end. */
  calls: number;
  made: number;
  last?: string;
  next?: string;
  next_ms?: number;
  /** The hash of the card's program. */
  program?: string;
}

/** The result of a whole run, as `oncard run --format=json` writes it. */
export interface Run {
  passed: boolean;
  end: string;
  time_ms: number;
  statements: number;
  state_hash: string;
  values: Record<string, Value>;
  failures: { expectation: string; message: string }[];
  warnings: string[];
}

export interface RunAnswer extends Compiled {
  /** Missing if the program was not compiled. */
  run?: Run;
}

export interface ExploreAnswer extends Compiled {
  /** What `oncard explore --format=json` prints; missing if the program was not compiled. */
  report?: { verdict: "PROVED" | "PASSED" | "FAILED" | "INCOMPLETE"; culprit?: string };
  /** The report for people. */
  text?: string;
  /** If something fails: a schedule file beside `main` that repeats it. */
  schedule?: string;
}

/** Until a time, or until a variable has a value. */
export interface Wait {
  until_ms?: number;
  name?: string;
  value?: number;
}

export interface Thread {
  thread: number;
  function: string;
  page: number;
  state: "finished" | "running" | "paused" | "faulted";
  file: string;
  line: number;
  position: number;
  statements: number;
  error: number;
  status: string;
  ready: boolean;
  waits?: Wait;
  next_start_ms?: number;
  result?: number;
  refused?: string;
}

/** What the card's supervisor warns of; its place in the program, or the call of the host. */
export interface CardWarning {
  name: string;
  text: string;
  /** Of its first occurrence. */
  time_ms: number;
  thread?: number;
  file?: string;
  line?: number;
  call?: string;
}

export interface State {
  moment: number;
  head: number;
  cycle: number;
  time_ms: number;
  statements: number;
  statements_left: number;
  next: "host" | "cycle" | "statement";
  next_thread?: number;
  over?: "quiet" | "until" | "time-limit" | "deadlock" | "host-end";
  follows_schedule: boolean;
  host?: HostState;
  hash: string;
  threads: Thread[];
  /** Up to this moment. */
  warnings: CardWarning[];
}

export type StopReason =
  | "goal"
  | "line"
  | "change"
  | "condition"
  | "fault"
  | "refusal"
  | "race"
  | "warning"
  | "requirement"
  | "deviation"
  | "schedule-end"
  | "end"
  | "start"
  | "budget";

export interface Stop {
  reason: StopReason;
  thread?: number;
  /** Which of the wishes, from 0. */
  number?: number;
  text?: string;
  /** At the end: expectations and final requirements that do not hold. */
  failed?: string[];
}

export interface WalkResult {
  stop: Stop;
  state: State;
}

interface ThreadGoal {
  goal: "statement" | "line";
  thread: number;
}

export type ForwardWalk =
  | { goal: "step" | "cycle" | "stop" | "rest" | "call" }
  | ThreadGoal
  | { goal: "time"; ms: number };

export type BackWalk =
  | { goal: "step" | "cycle" | "stop" | "call" }
  | ThreadGoal
  | { goal: "change"; name: string };

/** A line, or a card statement of a function. */
export type StopPlace =
  | {
      line: number;
      /** As the threads of the state name it. */
      file?: string;
    }
  | { function: string; position?: number };

export interface StopOptions {
  thread?: number;
  condition?: string;
  hits?: number;
  log?: string;
}

export type LineStop = StopPlace & StopOptions;

export interface StopWishes {
  lines?: LineStop[];
  changes?: string[];
  conditions?: string[];
  faults?: boolean;
  refusals?: boolean;
  requirements?: boolean;
  races?: boolean;
  warnings?: boolean;
}

export type Value = number | number[];

export interface Variable {
  name: string;
  /** Its name for `evaluate` and `write`. */
  path: string;
  type: string;
  slot: number;
  value: Value;
}

export interface CardPart {
  part: string;
  number: number;
  values: { name: string; path: string; value: number; unit?: string }[];
}

export interface CardWord {
  name: string;
  kind: "input" | "output";
  value: number;
  /** Inputs only: how many pins it has, from bit 0. */
  pins?: number;
}

/** As `[[world.switch]]` describes it. */
export interface CardSwitch {
  axis: number;
  type: string;
  index: number;
  from?: number;
  to?: number;
  active_low: boolean;
  connected: boolean;
}

export interface Card {
  parts: CardPart[];
  words: CardWord[];
  switches: CardSwitch[];
}

/** `path` is the whole name. */
export type Evaluation = { value: Value; path: string } | { holds: boolean };

export interface Channel {
  name: string;
  least: number[];
  largest: number[];
}

export interface Turn {
  moment: number;
  time_ms: number;
  thread: number;
  statements: number;
}

/** A time in which a thread was in one state. */
export interface ThreadSpan {
  thread: number;
  state: Thread["state"];
  line: number;
  /** Moments. */
  from: number;
  to: number;
  from_ms: number;
  to_ms: number;
  waits?: Wait;
  /** Why the thread has faulted. */
  text?: string;
}

export interface ListedFunction {
  name: string;
  file: string;
  /** With the words of the object file. */
  statements: { line: number; text: string; words: number[] }[];
}

export interface LogEvent {
  event: "log";
  moment: number;
  thread: number;
  text: string;
}

// --- Sources -------------------------------------------------------------------------------------

/** A file of a program; without `file` the program itself. */
export interface SourceProject extends Project {
  file?: string;
}

/** Lines and columns count from 1, columns in characters. */
export interface SourcePlace extends SourceProject {
  line: number;
  column: number;
}

export interface Range {
  line: number;
  column: number;
  end_line: number;
  end_column: number;
}

export interface FileRange extends Range {
  file: string;
}

export type SymbolKind =
  | "function"
  | "global"
  | "local"
  | "parameter"
  | "label"
  | "macro"
  | "macro-parameter"
  | "constant"
  | "enum"
  | "command"
  | "member";

/** A parameter of a command, or of a function or macro, which has only a name and a label. */
export interface Parameter {
  name: string;
  label: string;
  type?: string;
  passing?: "input" | "output" | "unused";
  unit?: string;
  range?: string;
  default?: string;
  note?: string;
}

export interface Description {
  kind: SymbolKind | "number" | "key" | "table";
  markdown: string;
  range: FileRange;
  name?: string;
  declaration?: string;
  brief?: string;
  callers?: string;
  number?: number;
  source?: string;
  parameters?: Parameter[];
  type?: string;
  function?: string;
  slot?: number;
  value?: string;
  thread_function?: boolean;
  hex?: string;
  raw?: number;
}

export interface Signature {
  kind: "command" | "function" | "macro";
  name: string;
  label: string;
  parameters: Parameter[];
  brief?: string;
  active?: number;
  range: FileRange;
}

export interface Candidate {
  label: string;
  kind: SymbolKind | "value" | "type" | "keyword" | "directive" | "key" | "table";
  detail?: string;
  documentation?: string;
  /** The text instead of the label. */
  insert?: string;
}

export interface Completion {
  range: FileRange;
  items: Candidate[];
  argument?: Parameter & { command: string; index: number };
}

export interface OutlineEntry {
  kind: SymbolKind;
  name: string;
  detail: string;
  range: FileRange;
  name_range: FileRange;
  thread_function?: boolean;
  definition?: boolean;
  children?: OutlineEntry[];
}

export interface Reference extends FileRange {
  access: "declaration" | "read" | "write" | "read-write" | "call";
}

export interface Edit extends FileRange {
  text: string;
}

export interface Word extends Range {
  kind:
    | SymbolKind
    | "thread-function"
    | "number"
    | "string"
    | "comment"
    | "type"
    | "keyword"
    | "directive";
  declaration?: boolean;
  write?: boolean;
}

export interface Fold {
  kind: "function" | "block" | "comment" | "directive";
  line: number;
  end_line: number;
}

export interface Hint extends FileRange {
  kind: "argument" | "slot";
  label: string;
  name?: string;
  unit?: string;
  slot?: number;
}

/** A program after all fix-its, and what is left to be corrected. */
export interface Fixes extends Compiled {
  count: number;
  /** Those that change. */
  files: SourceFile[];
}

/** What structured C becomes on the card. */
export interface Lowered extends Compiled {
  text?: string;
  /** For each line of the text. */
  origins?: ({ file: string; line: number } | null)[];
}
