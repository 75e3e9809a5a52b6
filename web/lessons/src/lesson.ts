// What a lesson is, and how one is read from JSON. A link can carry a lesson of a teacher's own, so
// nothing that comes in is trusted. Runs in pages and in Node.
// Tested by test/lesson.test.ts.

/** A text in both languages. */
export interface Localized {
  en: string;
  zh: string;
}

/** One idea, with a task that a scenario checks. */
export interface Lesson {
  version: 1;
  /** Lower-case letters, digits and hyphens; progress is kept by it. */
  id: string;
  title: Localized;
  /** Markdown. HTML in it is text. */
  text: Localized;
  /** They open one by one. Markdown. */
  hints: Localized[];
  /** The text of each file by its name: the starting program and the scenario of the task. */
  files: Record<string, string>;
  /** The file that the student edits: a name of `files`. */
  program: string;
  /** The scenario of the task: a name of `files`. */
  main: string;
  /** `run`: it holds in one run. `explore`: it is proved for all interleavings. */
  task: "run" | "explore";
  /** The program is structured C. */
  structured?: boolean;
  /** The channels that the scope shows first, by the names of scenarios. */
  scope?: string[];
}

/** Why a value is not a lesson. */
export interface Mistake {
  /** The place, for example `hints[1].en`; empty for the whole. */
  where: string;
  message: Localized;
}

export type ParsedLesson = { lesson: Lesson } | { mistakes: Mistake[] };

/** The largest sizes; texts in characters of UTF-16. */
export const limits = {
  id: 64,
  title: 120,
  text: 20_000,
  hints: 10,
  hint: 2_000,
  files: 16,
  fileName: 64,
  file: 65_536,
  scope: 16,
  channel: 64,
  /** Mistakes that are reported. */
  mistakes: 20,
} as const;

type Table = Record<string, unknown>;

const keys = [
  ...["version", "id", "title", "text", "hints", "files", "program", "main", "task"],
  ...["structured", "scope"],
];
const fileName = /^[A-Za-z0-9_-]+(\.[A-Za-z0-9_-]+)+$/;
// Control characters, and marks that turn the direction of writing, would hide what a file contains.
const unprintable = /[^\P{Cc}\t\n\r]|[\u200e\u200f\u202a-\u202e\u2066-\u2069]/u;

/**
 * Reads a lesson from a value of JSON. A text may be given in one language only; it then stands for
 * both. All mistakes are reported at once, up to a limit.
 */
export function parseLesson(value: unknown): ParsedLesson {
  const reader = new Reader();
  const lesson = reader.lesson(value);
  return reader.mistakes.length === 0 && lesson ? { lesson } : { mistakes: reader.mistakes };
}

/** Goes through a value and notes what is wrong. What it returns counts only without mistakes. */
class Reader {
  readonly mistakes: Mistake[] = [];

  lesson(value: unknown): Lesson | undefined {
    const table = this.table("", value);
    if (!table) return undefined;
    this.unknownKeys("", table, keys);
    if (table["version"] !== 1) {
      this.note("version", "expected 1, the version of lessons", "应为 1（课程的版本）");
    }
    const lesson: Lesson = {
      version: 1,
      id: this.matching("id", table["id"], limits.id, /^[a-z0-9][a-z0-9-]*$/, {
        en: "expected lower-case letters, digits and hyphens",
        zh: "应由小写字母、数字和连字符组成",
      }),
      title: this.localized("title", table["title"], limits.title),
      text: this.localized("text", table["text"], limits.text),
      hints: this.list("hints", table["hints"], limits.hints, (where, hint) =>
        this.localized(where, hint, limits.hint),
      ),
      files: this.files(table["files"]),
      program: this.nameOfFile("program", table, [".c"]),
      main: this.nameOfFile("main", table, [".toml"]),
      task: this.task(table["task"]),
    };
    const { structured, scope } = table;
    if (structured !== undefined) {
      if (typeof structured === "boolean") lesson.structured = structured;
      else this.note("structured", "expected true or false", "应为 true 或 false");
    }
    if (scope !== undefined) {
      lesson.scope = this.list("scope", scope, limits.scope, (where, name) =>
        this.text(where, name, limits.channel),
      );
    }
    return lesson;
  }

  private note(where: string, en: string, zh: string): void {
    if (this.mistakes.length < limits.mistakes) this.mistakes.push({ where, message: { en, zh } });
  }

  private table(where: string, value: unknown): Table | undefined {
    if (typeof value === "object" && value !== null && !Array.isArray(value)) return value as Table;
    this.note(where, "expected an object", "应为对象");
    return undefined;
  }

  private unknownKeys(where: string, table: Table, known: string[]): void {
    for (const key of Object.keys(table)) {
      if (known.includes(key)) continue;
      const shown = key.slice(0, limits.fileName);
      this.note(
        where,
        `unknown key '${shown}'; expected ${known.join(", ")}`,
        `未知的键“${shown}”；可用的键为 ${known.join("、")}`,
      );
    }
  }

  private text(where: string, value: unknown, most: number): string {
    if (typeof value !== "string") this.note(where, "expected a text", "应为文本");
    else if (value.trim() === "") this.note(where, "the text is empty", "文本为空");
    else if (value.length > most) {
      this.note(
        where,
        `the text has ${value.length} characters; at most ${most} are allowed`,
        `文本有 ${value.length} 个字符，最多允许 ${most} 个`,
      );
    } else if (unprintable.test(value)) {
      this.note(where, "the text contains a control character", "文本含有控制字符");
    } else return value;
    return "";
  }

  private matching(
    where: string,
    value: unknown,
    most: number,
    form: RegExp,
    expected: Localized,
  ): string {
    const text = this.text(where, value, most);
    if (text !== "" && !form.test(text)) this.note(where, expected.en, expected.zh);
    return text;
  }

  private localized(where: string, value: unknown, most: number): Localized {
    const table = this.table(where, value);
    if (!table) return { en: "", zh: "" };
    this.unknownKeys(where, table, ["en", "zh"]);
    const { en, zh } = table;
    if (en === undefined && zh === undefined) {
      this.note(where, "expected a text 'en' or 'zh', or both", "应有文本 en 或 zh，或两者都有");
      return { en: "", zh: "" };
    }
    const texts = {
      en: en === undefined ? "" : this.text(`${where}.en`, en, most),
      zh: zh === undefined ? "" : this.text(`${where}.zh`, zh, most),
    };
    return { en: texts.en || texts.zh, zh: texts.zh || texts.en };
  }

  private list<Item>(
    where: string,
    value: unknown,
    most: number,
    item: (where: string, value: unknown) => Item,
  ): Item[] {
    if (!Array.isArray(value)) {
      this.note(where, "expected a list", "应为列表");
      return [];
    }
    if (value.length > most) {
      this.note(
        where,
        `the list has ${value.length} elements; at most ${most} are allowed`,
        `列表有 ${value.length} 个元素，最多允许 ${most} 个`,
      );
      return [];
    }
    return value.map((each, index) => item(`${where}[${index}]`, each));
  }

  private files(value: unknown): Record<string, string> {
    const table = this.table("files", value);
    if (!table) return {};
    const names = Object.keys(table);
    if (names.length > limits.files) {
      this.note(
        "files",
        `there are ${names.length} files; at most ${limits.files} are allowed`,
        `共有 ${names.length} 个文件，最多允许 ${limits.files} 个`,
      );
      return {};
    }
    const files: Record<string, string> = {};
    for (const name of names) {
      const shown = name.slice(0, limits.fileName);
      if (name.length > limits.fileName || !fileName.test(name)) {
        this.note(
          "files",
          `'${shown}' is not a file name such as 'task.toml': letters, digits, '_', '-', without folders`,
          `“${shown}”不是像 task.toml 这样的文件名：只能有字母、数字、“_”和“-”，不带目录`,
        );
      } else {
        files[name] = this.text(`files.${name}`, table[name], limits.file);
      }
    }
    return files;
  }

  private nameOfFile(key: string, table: Table, endings: string[]): string {
    const name = this.text(key, table[key], limits.fileName);
    if (name === "") return name;
    const { files } = table;
    const exists = typeof files === "object" && files !== null && Object.hasOwn(files, name);
    if (!exists) this.note(key, `there is no '${name}' in 'files'`, `files 中没有“${name}”`);
    else if (!endings.some((ending) => name.endsWith(ending))) {
      this.note(
        key,
        `expected a name with the ending ${endings.join(" or ")}`,
        `文件名应以 ${endings.join(" 或 ")} 结尾`,
      );
    }
    return name;
  }

  private task(value: unknown): Lesson["task"] {
    if (value === "run" || value === "explore") return value;
    this.note("task", "expected 'run' or 'explore'", "应为 run 或 explore");
    return "run";
  }
}
