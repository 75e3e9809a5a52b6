// The program: its files, its editor, and the compiler's messages under the text.

import { signal } from "@preact/signals";
import { useLayoutEffect, useRef, useState } from "preact/hooks";

import { Dialog } from "../panel/dialog.js";
import { front } from "../panels.js";
import { language } from "../store/settings.js";
import { texts } from "../texts/texts.js";
import {
  bench,
  copyProgram,
  describe,
  diagnostics,
  edit,
  edited,
  file,
  files,
  lesson,
  opened,
  openProgram,
  removeProgram,
  resetProgram,
  shelf,
  toggleBreakpoint,
} from "../workspace.js";
import { CodeEditor, type MarkedLines } from "./code.js";
import { htmlOf } from "../lesson/markdown.js";
import { indexOfPlace, placeOfIndex, withFixes } from "./offsets.js";
import { Problems } from "./problems.js";

/** The line of the program that the reader has chosen, in the editor or among the statements. */
export const chosenLine = signal(0);

let editor: CodeEditor | undefined;
/** What is to be done as soon as the editor shows the file that was asked for. */
let awaited: ((shown: CodeEditor) => void) | undefined;

/** Does something in the editor when it shows this file. */
function inFile(name: string, work: (shown: CodeEditor) => void): void {
  if (file.value === name) {
    if (editor) work(editor);
    return;
  }
  awaited = work;
  file.value = name;
}

/** Shows a line of the program in the editor. */
export function showLine(line: number): void {
  front.value = "program";
  chosenLine.value = line;
  inFile(lesson.value.program, (shown) => {
    shown.reveal(line);
  });
}

/** Lines of the statements that the threads execute next, and the chosen line. */
function markedLines(): MarkedLines {
  const isLoaded = !edited.value && file.value === lesson.value.program;
  const next = isLoaded
    ? (bench.state.value?.threads ?? []).filter(({ state }) => state === "running")
    : [];
  const lines = new Set(next.map(({ line }) => line));
  const marked = [...lines].map((line) => ({ line, class: "cm-next" }));
  if (isLoaded && !lines.has(chosenLine.value)) {
    marked.push({ line: chosenLine.value, class: "cm-linked" });
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
  const { programs, open } = shelf.value;
  return (
    <div class="bar">
      <div class="tabs" role="group" aria-label={t.files}>
        {Object.keys(files.value).map((name) => (
          <button
            key={name}
            type="button"
            class="tab"
            aria-pressed={name === file.value}
            onClick={() => (file.value = name)}
          >
            {name}
          </button>
        ))}
      </div>
      {lesson.value.structured && <span class="tag">{t.structured}</span>}
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
  const lines = bench.breakpoints.value;
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

// Every effect is a layout effect: what the page shows around the editor is in the editor, too, before
// the next key is pressed. A breakpoint that came later would miss an edit, and stand at another line.
function Code() {
  const host = useRef<HTMLDivElement>(null);
  const name = file.value;
  const number = opened.value;
  useLayoutEffect(() => {
    if (!host.current) return undefined;
    const created: CodeEditor = new CodeEditor(host.current, {
      edit: (text) => {
        edit(file.value, text);
      },
      line: (line) => {
        if (file.value === lesson.value.program) chosenLine.value = line;
      },
      toggle: (line) => {
        if (file.value === lesson.value.program) toggleBreakpoint(line);
      },
      moved: (lines) => {
        bench.breakpoints.value = lines;
      },
      describe: async (index) => {
        const { text } = created;
        const { line, column } = placeOfIndex(text, index);
        const found = await describe(line, column).catch(() => null);
        if (!found || text !== created.text) return undefined;
        const { range, markdown } = found;
        return {
          from: indexOfPlace(text, range.line, range.column),
          to: indexOfPlace(text, range.end_line, range.end_column),
          html: htmlOf(markdown),
        };
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
    editor?.show(name, files.peek()[name] ?? "");
    if (editor) work?.(editor);
  }, [name, number]);
  useLayoutEffect(() => {
    editor?.label(texts.value.editor.label(name));
  }, [name, number, language.value]);
  useLayoutEffect(() => {
    const text = files.peek()[name] ?? "";
    const here = diagnostics.value.filter((each) => each.file === name);
    editor?.underline(
      here.map((each) => ({
        from: indexOfPlace(text, each.line, each.column),
        to: indexOfPlace(text, each.end_line, each.end_column),
        severity: each.severity,
        message: each.message,
      })),
    );
  }, [diagnostics.value, name, number, language.value]);
  const breakpoints = name === lesson.value.program ? bench.breakpoints.value : [];
  useLayoutEffect(() => {
    editor?.breakpoints(breakpoints);
  }, [breakpoints, name, number]);
  const marked = markedLines();
  const shownLine = marked.find(({ class: kind }) => kind === "cm-next")?.line ?? 0;
  useLayoutEffect(() => {
    editor?.mark(marked);
  }, [JSON.stringify(marked), name, number]);
  useLayoutEffect(() => {
    if (shownLine > 0 && bench.notice.peek().kind !== "running") editor?.reveal(shownLine);
  }, [shownLine]);
  return <div class="code" ref={host} />;
}
