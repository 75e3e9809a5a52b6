// The program: its files, its editor, and the compiler's messages under the text.

import type { Description } from "@oncard/engine";
import { useLayoutEffect, useRef, useState } from "preact/hooks";

import { Tabs } from "../controls/tabs.js";
import { Dialog } from "../panel/dialog.js";
import { htmlOf } from "../lesson/markdown.js";
import { useAsked } from "../session/asked.js";
import { bench, present, session } from "../session/bench.js";
import { messages } from "../session/messages.js";
import { complete, describe, hints, isEdited, toggleBreakpoint } from "../session/on_card.js";
import { chooseLine, layout, pointAt } from "../store/layout.js";
import { settings } from "../store/settings.js";
import {
  copyProgram,
  edit,
  openProgram,
  removeProgram,
  resetProgram,
  showFile,
  source,
} from "../store/source.js";
import { texts } from "../texts/texts.js";
import { type Beside, unitsBeside, valuesBeside } from "./beside.js";
import { CodeEditor, type MarkedLines } from "./code.js";
import { indexOfPlace, placeOfIndex, withFixes } from "./offsets.js";
import { Problems } from "./problems.js";

let editor: CodeEditor | undefined;
/** What is to be done as soon as the editor shows the file that was asked for. */
let awaited: ((shown: CodeEditor) => void) | undefined;

/** Does something in the editor when it shows this file. */
function inFile(name: string, work: (shown: CodeEditor) => void): void {
  if (source.file.value === name) {
    if (editor) work(editor);
    return;
  }
  awaited = work;
  showFile(name);
}

/** Lines of the statements that the threads execute next, the chosen line, and one pointed at in a list. */
function markedLines(): MarkedLines {
  const isLoaded = !isEdited.value && source.file.value === source.lesson.value.program;
  const next = isLoaded
    ? (present.state.value?.threads ?? []).filter(({ state }) => state === "running")
    : [];
  // Where several threads stand at a line, it has the colours of the first one.
  const lines = new Map<number, number>();
  for (const { line, thread } of next) if (!lines.has(line)) lines.set(line, thread);
  const marked = [...lines].map(([line, thread]) => ({ line, class: `cm-next t${thread % 8}` }));
  if (isLoaded && !lines.has(layout.chosenLine.value)) {
    marked.push({ line: layout.chosenLine.value, class: "cm-linked" });
  }
  const pointed = layout.pointed.value;
  if (pointed && !pointed.isInText && pointed.file === source.file.value) {
    marked.push({ line: pointed.line, class: "cm-pointed" });
  }
  return marked;
}

export function ProgramPanel() {
  return (
    <>
      <ProgramBar />
      <Code />
      <Breakpoints />
      <Problems
        onShow={({ file: name, line, column }) => {
          inFile(name, (shown) => {
            shown.select(indexOfPlace(shown.text, line, column), true);
          });
        }}
        onFix={({ file: name, fixits }) => {
          inFile(name, (shown) => {
            shown.replace(withFixes(shown.text, fixits));
          });
        }}
      />
    </>
  );
}

function ProgramBar() {
  const { editor: t } = texts.value;
  const [asks, setAsks] = useState<"reset" | "remove" | undefined>(undefined);
  const { programs, open } = source.shelf.value;
  return (
    <div class="bar">
      <Tabs
        label={t.files}
        values={Object.keys(source.files.value)}
        chosen={source.file.value}
        nameOf={(name) => name}
        onChoose={showFile}
      />
      {source.lesson.value.structured && <span class="tag">{t.structured}</span>}
      <div class="row end grow">
        {programs.length > 1 && (
          <select
            aria-label={t.programs}
            value={open}
            onChange={({ currentTarget }) => {
              openProgram(Number(currentTarget.value));
            }}
          >
            {programs.map((_, index) => (
              <option key={index} value={index}>
                {t.program(index + 1)}
              </option>
            ))}
          </select>
        )}
        <button type="button" class="quiet" onClick={copyProgram}>
          {t.copy}
        </button>
        <button
          type="button"
          class="quiet"
          onClick={() => {
            setAsks("reset");
          }}
        >
          {t.reset}
        </button>
        {programs.length > 1 && (
          <button
            type="button"
            class="quiet"
            onClick={() => {
              setAsks("remove");
            }}
          >
            {t.remove}
          </button>
        )}
      </div>
      {asks && (
        <Dialog
          title={asks === "reset" ? t.resetTitle : t.removeTitle}
          onClose={() => {
            setAsks(undefined);
          }}
          answer={{
            text: asks === "reset" ? t.reset : t.remove,
            onChosen: asks === "reset" ? resetProgram : removeProgram,
          }}
        >
          <p>{asks === "reset" ? t.resetText : t.removeText}</p>
        </Dialog>
      )}
    </div>
  );
}

/** The breakpoints in words, for those who do not see or click beside the lines. */
function Breakpoints() {
  const { editor: t } = texts.value;
  const lines = session.breakpoints.value;
  if (lines.length === 0) return null;
  return (
    <div class="breakpoints" role="group" aria-label={t.breakpoints}>
      <span class="small muted">{t.breakpoints}:</span>
      {lines.map((line) => (
        <button
          key={line}
          type="button"
          class="quiet"
          aria-label={t.removeBreakpoint(line)}
          title={t.removeBreakpoint(line)}
          onClick={() => {
            toggleBreakpoint(line);
          }}
        >
          {line} ×
        </button>
      ))}
    </div>
  );
}

/** What the engine answers about a place in the editor, and where in the text that it was asked about. */
async function answered<Answer extends { range: Description["range"] }>(
  asking: CodeEditor,
  index: number,
  ask: (line: number, column: number) => Promise<Answer | null>,
): Promise<{ answer: Answer; text: string; from: number; to: number } | undefined> {
  const { text } = asking;
  const { line, column } = placeOfIndex(text, index);
  const answer = await ask(line, column).catch(() => null);
  if (!answer) return undefined;
  const { range } = answer;
  return {
    answer,
    text,
    from: indexOfPlace(text, range.line, range.column),
    to: indexOfPlace(text, range.end_line, range.end_column),
  };
}

const nothing: readonly Beside[] = [];

/** Units of arguments; those of the text before until the engine has answered. */
function useUnits(name: string): readonly Beside[] {
  const isProgram = name.endsWith(".c");
  const units = useAsked(
    `${name} ${source.files.value[name]}`,
    async () => (isProgram ? unitsBeside(await hints()) : nothing),
    session.running.value,
  );
  return isProgram && units ? units : nothing;
}

/** What the lines have made, while the card stands still with this text on it. */
function useValues(name: string): readonly Beside[] {
  const { value: state } = present.state;
  const { history, running } = session;
  const isShown =
    state !== undefined &&
    !running.value &&
    !isEdited.value &&
    name === source.lesson.value.program;
  const moment = isShown ? state.moment : -1;
  const now = { history: history.value, name };
  const asked = useAsked(
    `${now.history} ${name} ${moment}`,
    async () => {
      if (moment < 0) return { ...now, values: nothing };
      const written = await (await bench.engine()).written();
      const lines = (source.files.peek()[name] ?? "").split("\n");
      return { ...now, values: valuesBeside(written, { file: name, lines, moment }) };
    },
    running.value,
  );
  // Until the engine has answered, those of the moment before stay, but not those of another run.
  const isOfNow = isShown && asked?.history === now.history && asked.name === name;
  return isOfNow ? asked.values : nothing;
}

// Every effect is a layout effect: what the page shows around the editor is in the editor, too, before
// the next key is pressed. A breakpoint that came later would miss an edit, and stand at another line.
function Code() {
  const host = useRef<HTMLDivElement>(null);
  const name = source.file.value;
  const number = source.opened.value;
  useLayoutEffect(() => {
    if (!host.current) return undefined;
    const created: CodeEditor = new CodeEditor(host.current, {
      edit: (text) => {
        edit(source.file.value, text);
      },
      line: (line) => {
        if (source.file.value === source.lesson.value.program) chooseLine(line);
      },
      point: (line) => {
        const file = source.file.value;
        pointAt(line === undefined ? undefined : { file, line, isInText: true });
      },
      toggle: (line) => {
        if (source.file.value === source.lesson.value.program) toggleBreakpoint(line);
      },
      moved: (lines) => {
        bench.wishStops(lines);
      },
      describe: async (index) => {
        const found = await answered(created, index, describe);
        // Of another text than is shown by now it would stand at a wrong place.
        if (found?.text !== created.text) return undefined;
        return { from: found.from, to: found.to, html: htmlOf(found.answer.markdown) };
      },
      complete: async (index) => {
        // The editor itself fits the words to what has been typed meanwhile.
        const found = await answered(created, index, complete);
        return (
          found && {
            from: found.from,
            to: found.to,
            words: found.answer.items.map(({ documentation, ...word }) =>
              documentation === undefined ? word : { ...word, html: htmlOf(documentation) },
            ),
          }
        );
      },
    });
    editor = created;
    return () => {
      created.destroy();
      editor = undefined;
    };
  }, []);
  useLayoutEffect(() => {
    const work = awaited;
    awaited = undefined;
    editor?.show(name, source.files.peek()[name] ?? "");
    if (editor) work?.(editor);
  }, [name, number]);
  useLayoutEffect(() => {
    editor?.label(texts.value.editor.label(name));
  }, [name, number, settings.language.value]);
  useLayoutEffect(() => {
    const text = source.files.peek()[name] ?? "";
    const here = messages.diagnostics.value.filter((each) => each.file === name);
    editor?.underline(
      here.map((each) => ({
        from: indexOfPlace(text, each.line, each.column),
        to: indexOfPlace(text, each.end_line, each.end_column),
        severity: each.severity,
        message: each.message,
      })),
    );
  }, [messages.diagnostics.value, name, number, settings.language.value]);
  const breakpoints = name === source.lesson.value.program ? session.breakpoints.value : [];
  useLayoutEffect(() => {
    editor?.breakpoints(breakpoints);
  }, [breakpoints, name, number]);
  const marked = markedLines();
  const shownLine = marked.find(({ class: kind }) => kind.startsWith("cm-next"))?.line ?? 0;
  useLayoutEffect(() => {
    editor?.mark(marked);
  }, [JSON.stringify(marked), name, number]);
  const values = useValues(name);
  const units = useUnits(name);
  useLayoutEffect(() => {
    editor?.beside([...values, ...units]);
  }, [values, units, name, number]);
  const wish = layout.wishedLine.value;
  useLayoutEffect(() => {
    if (!wish) return;
    inFile(wish.file ?? source.lesson.peek().program, (shown) => {
      shown.reveal(wish.line);
    });
  }, [wish]);
  useLayoutEffect(() => {
    // Before anything has run, a program is read from its top.
    const hasBegun = (present.state.peek()?.head ?? 0) > 0;
    const isRunning = session.notice.peek().kind === "running";
    if (shownLine > 0 && hasBegun && !isRunning) editor?.reveal(shownLine);
  }, [shownLine]);
  return <div class="code" ref={host} />;
}
