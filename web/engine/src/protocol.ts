// Written by `npm run protocol` from the schema of the session protocol.

/**
 * The language of texts for people.
 */
export type Language = "en" | "zh";
/**
 * What a thread does.
 */
export type ThreadState = "finished" | "running" | "paused" | "faulted";
/**
 * Of a variable; a list of an array's.
 */
export type Value = number | number[];
/**
 * What `load` answers; no more than messages if the program does not compile.
 */
export type Loaded =
  | {
      compiled: false;
      diagnostics: Diagnostic[];
    }
  | {
      compiled: true;
      diagnostics: Diagnostic[];
      files: SourceFile[];
      /**
       * Of the record of a host.
       */
      cards?: RecordedCard[];
      /**
       * As of a whole run: the first case is loaded.
       */
      choice?: string;
      state: State;
    };
/**
 * How far a walk goes forward.
 */
export type ForwardWalk =
  | {
      goal: "step" | "cycle" | "stop" | "rest" | "call";
      /**
       * So many steps at most; 1000000 without it.
       */
      budget?: number;
    }
  | {
      goal: "statement" | "line";
      thread: number;
      /**
       * So many steps at most; 1000000 without it.
       */
      budget?: number;
    }
  | {
      goal: "time";
      ms: number;
      /**
       * So many steps at most; 1000000 without it.
       */
      budget?: number;
    }
  | {
      goal: "end";
      /**
       * So long at most.
       */
      ms?: number;
      /**
       * So many steps at most; 1000000 without it.
       */
      budget?: number;
    };
/**
 * Why a walk has ended.
 */
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
/**
 * How far a walk goes back.
 */
export type BackWalk =
  | {
      goal: "step" | "cycle" | "stop" | "call";
      /**
       * So many steps at most; 1000000 without it.
       */
      budget?: number;
    }
  | {
      goal: "statement" | "line";
      thread: number;
      /**
       * So many steps at most; 1000000 without it.
       */
      budget?: number;
    }
  | {
      goal: "change";
      name: string;
      /**
       * So many steps at most; 1000000 without it.
       */
      budget?: number;
    };
/**
 * A line, or a card statement of a function.
 */
export type LineStop =
  | {
      line: number;
      /**
       * As the threads of the state name it.
       */
      file?: string;
      /**
       * Only this one.
       */
      thread?: number;
      condition?: string;
      /**
       * Only from this arrival on.
       */
      hits?: number;
      /**
       * Is logged instead of a stop.
       */
      log?: string;
    }
  | {
      function: string;
      position?: number;
      /**
       * Only this one.
       */
      thread?: number;
      condition?: string;
      /**
       * Only from this arrival on.
       */
      hits?: number;
      /**
       * Is logged instead of a stop.
       */
      log?: string;
    };
/**
 * The value of a name, or whether a condition holds.
 */
export type Evaluation =
  | {
      value: Value;
      /**
       * The whole name.
       */
      path: string;
    }
  | {
      holds: boolean;
    };
/**
 * What a name is.
 */
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
  | "struct"
  | "typedef"
  | "command"
  | "member";
/**
 * The last line of an answer.
 */
export type Answer =
  | {
      /**
       * Of the request.
       */
      id: number | string | null;
      ok: true;
      result: unknown;
      /**
       * Files that the request needs and that do not exist.
       */
      missing?: string[];
    }
  | {
      /**
       * Of the request.
       */
      id: number | string | null;
      ok: false;
      /**
       * What was wrong.
       */
      error: string;
      /**
       * Files that the request needs and that do not exist.
       */
      missing?: string[];
    };

/**
 * The session protocol; docs/session-protocol.md explains it.
 */
export interface Protocol {
  requests: Requests;
  answer: Answer;
  event: LogEvent;
}
/**
 * What each request takes and answers.
 */
export interface Requests {
  hello: {
    arguments: {
      protocol?: 1;
      /**
       * Of all texts from now on.
       */
      language?: Language;
    };
    result: Hello;
  };
  check: {
    arguments: Project;
    result: Compiled;
  };
  run: {
    arguments: {
      /**
       * A scenario, a recording or a program.
       */
      main: string;
      /**
       * The text of each file by its path.
       */
      files?: {
        [k: string]: string;
      };
      /**
       * The program is structured C.
       */
      structured?: boolean;
      /**
       * Names of values for the result.
       */
      show?: string[];
      /**
       * Names of the supervisor's warnings that are left out.
       */
      silent?: string[];
    };
    result: RunAnswer;
  };
  load: {
    arguments: {
      /**
       * A scenario, a recording or a program.
       */
      main: string;
      /**
       * The text of each file by its path.
       */
      files?: {
        [k: string]: string;
      };
      /**
       * The program is structured C.
       */
      structured?: boolean;
      /**
       * Which card of the record of a host.
       */
      card?: number;
      /**
       * Which of its openings, from 1.
       */
      opening?: number;
      /**
       * Names of the supervisor's warnings that are left out.
       */
      silent?: string[];
    };
    result: Loaded;
  };
  state: {
    arguments: {};
    result: State;
  };
  forward: {
    arguments: ForwardWalk;
    result: WalkResult;
  };
  back: {
    arguments: BackWalk;
    result: WalkResult;
  };
  step_thread: {
    arguments: {
      thread: number;
    };
    result: WalkResult;
  };
  go_to: {
    arguments:
      | {
          moment: number;
        }
      | {
          ms: number;
        };
    result: State;
  };
  set_stops: {
    arguments: StopWishes;
    result: {
      /**
       * Where the stops at lines are.
       */
      lines: number[];
    };
  };
  variables: {
    arguments: {
      /**
       * Without it the global variables.
       */
      page?: number;
    };
    result: Variable[];
  };
  slots: {
    arguments: {
      page: number;
    };
    result: number[];
  };
  card: {
    arguments: {};
    result: Card;
  };
  evaluate: {
    arguments: {
      text: string;
      /**
       * Names are meant as in its function: its locals first.
       */
      thread?: number;
    };
    result: Evaluation;
  };
  write: {
    arguments: {
      name: string;
      value: number;
    };
    result: State;
  };
  set_input: {
    arguments: {
      type: string;
      index: number;
      /**
       * 0 or 1.
       */
      level: number;
    };
    result: State;
  };
  set_voltage: {
    arguments: {
      channel: number;
      volts: number;
    };
    result: State;
  };
  move_switch: {
    arguments: {
      /**
       * From 1.
       */
      switch: number;
      /**
       * In pulses, or in the unit of its axis.
       */
      from?: number;
      to?: number;
    };
    result: State;
  };
  trace: {
    arguments: {
      names: string[];
      from_ms: number;
      to_ms: number;
      points: number;
    };
    result: Channel[];
  };
  turns: {
    arguments: {
      /**
       * A moment.
       */
      from: number;
      to: number;
      /**
       * So many at most.
       */
      most?: number;
    };
    result: Turn[];
  };
  spans: {
    arguments: {
      /**
       * A moment.
       */
      from?: number;
      to?: number;
      /**
       * So many at most.
       */
      most?: number;
    };
    result: ThreadSpan[];
  };
  written: {
    arguments: {
      /**
       * 1000 without it.
       */
      statements?: number;
    };
    result: LineWrites[];
  };
  listing: {
    arguments: {};
    result: ListedFunction[];
  };
  record: {
    arguments: {
      /**
       * The file in which a client keeps one of them.
       */
      path?: string;
    };
    result: {
      /**
       * The text of a schedule file.
       */
      schedule: string;
      /**
       * That of its scenario, with the changes.
       */
      scenario: string;
    };
  };
  describe: {
    arguments: SourcePlace;
    result: Description | null;
  };
  signature: {
    arguments: SourcePlace;
    result: Signature | null;
  };
  complete: {
    arguments: SourcePlace;
    result: Completion;
  };
  outline: {
    arguments: SourceProject;
    result: OutlineEntry[];
  };
  definition: {
    arguments: SourcePlace;
    result: FileRange[];
  };
  references: {
    arguments: {
      /**
       * A scenario, a recording or a program.
       */
      main: string;
      /**
       * The text of each file by its path.
       */
      files?: {
        [k: string]: string;
      };
      /**
       * The program is structured C.
       */
      structured?: boolean;
      /**
       * A file of the program; without it the program.
       */
      file?: string;
      line: number;
      column: number;
      /**
       * False: without declarations.
       */
      declaration?: boolean;
    };
    result: Reference[];
  };
  rename: {
    arguments: {
      /**
       * A scenario, a recording or a program.
       */
      main: string;
      /**
       * The text of each file by its path.
       */
      files?: {
        [k: string]: string;
      };
      /**
       * The program is structured C.
       */
      structured?: boolean;
      /**
       * A file of the program; without it the program.
       */
      file?: string;
      line: number;
      column: number;
      name: string;
    };
    result: Edit[];
  };
  tokens: {
    arguments: SourceProject;
    result: Word[];
  };
  folds: {
    arguments: SourceProject;
    result: Fold[];
  };
  hints: {
    arguments: SourceProject;
    result: Hint[];
  };
  fixes: {
    arguments: Project;
    result: Fixes;
  };
  lower: {
    arguments: Project;
    result: Lowered;
  };
  two_columns: {
    arguments: Project;
    result: TwoColumns;
  };
}
/**
 * Who answers.
 */
export interface Hello {
  protocol: 1;
  /**
   * All requests with their arguments.
   */
  requests: {
    [k: string]: string;
  };
}
/**
 * A program that is to be compiled.
 */
export interface Project {
  /**
   * A scenario, a recording or a program.
   */
  main: string;
  /**
   * The text of each file by its path.
   */
  files?: {
    [k: string]: string;
  };
  /**
   * The program is structured C.
   */
  structured?: boolean;
}
/**
 * What the compiler says.
 */
export interface Compiled {
  compiled: boolean;
  diagnostics: Diagnostic[];
}
/**
 * A message of the compiler.
 */
export interface Diagnostic {
  code: string;
  severity: "error" | "warning";
  /**
   * The name of the code.
   */
  slug: string;
  /**
   * In the language of the session.
   */
  message: string;
  message_en: string;
  message_zh: string;
  file: string;
  line: number;
  column: number;
  end_line: number;
  end_column: number;
  notes: Note[];
  fixits: Fixit[];
}
/**
 * More about a message; without a place if it is about none.
 */
export interface Note {
  /**
   * In the language of the session.
   */
  message: string;
  message_en: string;
  message_zh: string;
  file?: string;
  line?: number;
  column?: number;
  end_line?: number;
  end_column?: number;
}
/**
 * A text that replaces what is between two places.
 */
export interface Fixit {
  file: string;
  line: number;
  column: number;
  end_line: number;
  end_column: number;
  /**
   * In bytes.
   */
  begin_offset: number;
  end_offset: number;
  text: string;
}
/**
 * What `run` answers.
 */
export interface RunAnswer {
  compiled: boolean;
  diagnostics: Diagnostic[];
  /**
   * Missing if the program does not compile.
   */
  run?: Run;
}
/**
 * The result of a whole run, as `oncard run --format=json` writes it.
 */
export interface Run {
  /**
   * What was chosen, if the scenario leaves something open.
   */
  choice?: string;
  passed: boolean;
  end: "quiet" | "until" | "time-limit" | "deadlock" | "schedule-end" | "diverged" | "interrupted";
  time_ms: number;
  statements: number;
  program_hash: string;
  state_hash: string;
  threads: ThreadResult[];
  values: {
    [k: string]: Value;
  };
  failures: {
    expectation: string;
    message: string;
  }[];
  warnings: string[];
}
/**
 * How a thread has ended.
 */
export interface ThreadResult {
  thread: number;
  function: string;
  page: number;
  state: ThreadState;
  result: number | null;
  error: number;
  place: string;
  statements: number;
  /**
   * In words.
   */
  status: string;
}
/**
 * A file with its text.
 */
export interface SourceFile {
  path: string;
  text: string;
}
/**
 * One of the records in the file of a host.
 */
export interface RecordedCard {
  card: number;
  opening: number;
  calls: number;
}
/**
 * The present of a session.
 */
export interface State {
  moment: number;
  /**
   * The last moment that the session can go to.
   */
  head: number;
  cycle: number;
  time_ms: number;
  statements: number;
  /**
   * That the threads may still execute in this cycle.
   */
  statements_left: number;
  next: "host" | "cycle" | "statement";
  next_thread?: number;
  /**
   * Why the run of the scenario is over.
   */
  over?: "quiet" | "until" | "time-limit" | "deadlock" | "host-end";
  follows_schedule: boolean;
  host?: HostState;
  hash: string;
  threads: Thread[];
  /**
   * Up to this moment.
   */
  warnings: CardWarning[];
}
/**
 * The calls of a recorded host.
 */
export interface HostState {
  /**
   * With the end.
   */
  calls: number;
  made: number;
  /**
   * The hash of the card's program.
   */
  program?: string;
  last?: string;
  next?: string;
  next_ms?: number;
}
/**
 * A bound thread.
 */
export interface Thread {
  thread: number;
  function: string;
  page: number;
  state: ThreadState;
  file: string;
  line: number;
  /**
   * Of its statement in the function.
   */
  position: number;
  statements: number;
  error: number;
  /**
   * In words.
   */
  status: string;
  /**
   * It can execute a statement now.
   */
  ready: boolean;
  waits?: Wait;
  next_start_ms?: number;
  result?: number;
  /**
   * Its last command, if that was refused.
   */
  refused?: string;
}
/**
 * Until a time, or until a variable has a value.
 */
export interface Wait {
  until_ms?: number;
  name?: string;
  value?: number;
}
/**
 * What the card's supervisor warns of; its place in the program, or the call of the host.
 */
export interface CardWarning {
  name: string;
  text: string;
  /**
   * Of its first occurrence.
   */
  time_ms: number;
  thread?: number;
  file?: string;
  line?: number;
  call?: string;
}
/**
 * Where a walk has ended.
 */
export interface WalkResult {
  stop: Stop;
  state: State;
}
/**
 * The end of a walk.
 */
export interface Stop {
  reason: StopReason;
  thread?: number;
  /**
   * Which of the wishes, from 0.
   */
  number?: number;
  text?: string;
  /**
   * At the end: expectations and final requirements that do not hold.
   */
  failed?: string[];
}
/**
 * Where walks are to stop.
 */
export interface StopWishes {
  lines?: LineStop[];
  /**
   * Names of values.
   */
  changes?: string[];
  conditions?: string[];
  faults?: boolean;
  refusals?: boolean;
  requirements?: boolean;
  races?: boolean;
  warnings?: boolean;
}
/**
 * A variable with its value.
 */
export interface Variable {
  name: string;
  /**
   * Its name for `evaluate` and `write`.
   */
  path: string;
  type: string;
  slot: number;
  value: Value;
}
/**
 * The card with its surroundings.
 */
export interface Card {
  parts: CardPart[];
  words: CardWord[];
  switches: CardSwitch[];
  paths: CardPath[];
  view: MachineLook;
}
/**
 * An axis, a profile, an encoder, ...
 */
export interface CardPart {
  part: string;
  number: number;
  values: {
    name: string;
    path: string;
    value: number;
    unit?: string;
    /**
     * It can only be 0 or 1.
     */
    flag?: boolean;
  }[];
}
/**
 * Inputs or outputs.
 */
export interface CardWord {
  name: string;
  kind: "input" | "output";
  value: number;
  /**
   * How many there are, from bit 0.
   */
  pins: number;
}
/**
 * A switch as `[[world.switch]]` describes it.
 */
export interface CardSwitch {
  axis: number;
  type: string;
  index: number;
  from?: number;
  to?: number;
  active_low: boolean;
  connected: boolean;
}
/**
 * A coordinate system that is set up, with the path that lies ahead of it.
 */
export interface CardPath {
  crd: number;
  /**
   * By their coordinates X, Y, Z, A.
   */
  axes: number[];
  /**
   * Positions of `axes` in their units, from where they are; empty if nothing waits.
   */
  points: number[][];
  /**
   * `false`: the path goes on after the last point.
   */
  whole: boolean;
}
/**
 * How the machine looks, as `[view]` of the scenario describes it.
 */
export interface MachineLook {
  /**
   * In the language of the session; may be empty.
   */
  title: string;
  kind: "auto" | "stages" | "xy" | "rotary" | "gripper" | "conveyor";
  /**
   * An axis, as all three.
   */
  x: number;
  y: number;
  /**
   * 0: none.
   */
  z: number;
  turn: number;
  pins: {
    /**
     * The name of a word.
     */
    type: string;
    index: number;
    name: string;
  }[];
}
/**
 * A value over time: its extremes in each part of the time.
 */
export interface Channel {
  name: string;
  least: number[];
  largest: number[];
}
/**
 * Statements of one thread in a row.
 */
export interface Turn {
  moment: number;
  time_ms: number;
  thread: number;
  statements: number;
}
/**
 * A time in which a thread was in one state.
 */
export interface ThreadSpan {
  thread: number;
  state: ThreadState;
  line: number;
  /**
   * A moment.
   */
  from: number;
  to: number;
  from_ms: number;
  to_ms: number;
  waits?: Wait;
  /**
   * Why the thread has faulted.
   */
  text?: string;
}
/**
 * What a thread wrote in a line when it executed the line last.
 */
export interface LineWrites {
  thread: number;
  file: string;
  line: number;
  /**
   * Before the last of its statements.
   */
  moment: number;
  values: {
    /**
     * Of a local: without its page.
     */
    name: string;
    value: number;
  }[];
  /**
   * Of the thread, if it has returned one here.
   */
  result?: number;
}
/**
 * The card statements of a function.
 */
export interface ListedFunction {
  name: string;
  file: string;
  statements: {
    line: number;
    text: string;
    /**
     * Of the object file.
     */
    words: number[];
  }[];
}
/**
 * A place in it. Lines and columns count from 1, columns in characters.
 */
export interface SourcePlace {
  /**
   * A scenario, a recording or a program.
   */
  main: string;
  /**
   * The text of each file by its path.
   */
  files?: {
    [k: string]: string;
  };
  /**
   * The program is structured C.
   */
  structured?: boolean;
  /**
   * A file of the program; without it the program.
   */
  file?: string;
  line: number;
  column: number;
}
/**
 * What the name or number at a place is.
 */
export interface Description {
  kind: SymbolKind | ("number" | "key" | "table");
  /**
   * For people.
   */
  markdown: string;
  range: FileRange;
  name?: string;
  declaration?: string;
  /**
   * What a command does, in one line.
   */
  brief?: string;
  /**
   * Whose command it is.
   */
  callers?: string;
  /**
   * Of a command.
   */
  number?: number;
  /**
   * The manual that describes a command.
   */
  source?: string;
  parameters?: Parameter[];
  type?: string;
  /**
   * The function that the name belongs to.
   */
  function?: string;
  /**
   * Of the data page, or among the globals.
   */
  slot?: number;
  /**
   * Of a number or constant.
   */
  value?: string;
  /**
   * Threads begin with it.
   */
  thread_function?: boolean;
  hex?: string;
  /**
   * 65536 times the value.
   */
  raw?: number;
}
/**
 * A part of a file.
 */
export interface FileRange {
  file: string;
  line: number;
  column: number;
  end_line: number;
  end_column: number;
}
/**
 * A parameter of a command, or of a function or macro, which has only a name and a label.
 */
export interface Parameter {
  name: string;
  /**
   * Its declaration.
   */
  label: string;
  type?: string;
  passing?: "input" | "output" | "unused";
  unit?: string;
  range?: string;
  default?: string;
  /**
   * Unit, range and default in a line for people.
   */
  note?: string;
}
/**
 * The call around a place.
 */
export interface Signature {
  kind: "command" | "function" | "macro";
  name: string;
  label: string;
  parameters: Parameter[];
  brief?: string;
  /**
   * The parameter that the place belongs to, from 0.
   */
  active?: number;
  /**
   * The name.
   */
  range: FileRange;
}
/**
 * The candidates for a place.
 */
export interface Completion {
  /**
   * The word that a candidate replaces.
   */
  range: FileRange;
  /**
   * The most likely first.
   */
  items: Candidate[];
  /**
   * The parameter of the command whose parentheses are around the place.
   */
  argument?: {
    name: string;
    /**
     * Its declaration.
     */
    label: string;
    type?: string;
    passing?: "input" | "output" | "unused";
    unit?: string;
    range?: string;
    default?: string;
    /**
     * Unit, range and default in a line for people.
     */
    note?: string;
    command: string;
    index: number;
  };
}
/**
 * What can be written at a place.
 */
export interface Candidate {
  label: string;
  kind: SymbolKind | ("value" | "type" | "keyword" | "directive" | "key" | "table");
  /**
   * Its declaration.
   */
  detail?: string;
  documentation?: string;
  /**
   * The text instead of the label.
   */
  insert?: string;
}
/**
 * A file of a program.
 */
export interface SourceProject {
  /**
   * A scenario, a recording or a program.
   */
  main: string;
  /**
   * The text of each file by its path.
   */
  files?: {
    [k: string]: string;
  };
  /**
   * The program is structured C.
   */
  structured?: boolean;
  /**
   * A file of the program; without it the program.
   */
  file?: string;
}
/**
 * What a file declares.
 */
export interface OutlineEntry {
  kind: SymbolKind;
  name: string;
  detail: string;
  range: FileRange;
  name_range: FileRange;
  thread_function?: boolean;
  /**
   * False for a prototype.
   */
  definition?: boolean;
  /**
   * The parameters, variables and labels of a function.
   */
  children?: OutlineEntry[];
}
/**
 * Where a name is used.
 */
export interface Reference {
  file: string;
  line: number;
  column: number;
  end_line: number;
  end_column: number;
  access: "declaration" | "read" | "write" | "read-write" | "call";
}
/**
 * A text that a part of a file gets.
 */
export interface Edit {
  file: string;
  line: number;
  column: number;
  end_line: number;
  end_column: number;
  text: string;
}
/**
 * A word of a file.
 */
export interface Word {
  kind:
    | SymbolKind
    | ("thread-function" | "number" | "string" | "comment" | "type" | "keyword" | "directive");
  line: number;
  column: number;
  end_line: number;
  end_column: number;
  declaration?: true;
  write?: true;
}
/**
 * Lines that can be folded.
 */
export interface Fold {
  kind: "function" | "block" | "comment" | "directive";
  line: number;
  end_line: number;
}
/**
 * What a reader would have to look up, at a range without length.
 */
export interface Hint {
  file: string;
  line: number;
  column: number;
  end_line: number;
  end_column: number;
  kind: "argument" | "member" | "slot";
  name?: string;
  unit?: string;
  slot?: number;
  label: string;
}
/**
 * A program after all fix-its, and what is left to be corrected.
 */
export interface Fixes {
  compiled: boolean;
  diagnostics: Diagnostic[];
  count: number;
  /**
   * Those that change.
   */
  files: SourceFile[];
}
/**
 * What structured C becomes on the card; without a text if it does not compile.
 */
export interface Lowered {
  compiled: boolean;
  diagnostics: Diagnostic[];
  text?: string;
  /**
   * Where each line of the text comes from.
   */
  origins?: ({
    file: string;
    line: number;
  } | null)[];
}
/**
 * Structured C beside what it becomes; without rows if it does not compile, or is none.
 */
export interface TwoColumns {
  compiled: boolean;
  diagnostics: Diagnostic[];
  rows?: TwoColumnsRow[];
}
/**
 * A line of C, a line of the card's program without comments, or both.
 */
export interface TwoColumnsRow {
  /**
   * Of the line of C.
   */
  file?: string;
  line?: number;
  /**
   * What stands in it.
   */
  text?: string;
  /**
   * The line is in an earlier row, too.
   */
  again?: true;
  card?: string;
  /**
   * Where `card` stands.
   */
  card_line?: number;
}
/**
 * A line that a stop logs.
 */
export interface LogEvent {
  event: "log";
  moment: number;
  thread: number;
  text: string;
}
