// The compiler's messages with their lines, a caret, and a button for each fix.

import type { Diagnostic } from "@oncard/engine";

import { messages } from "../session/messages.js";
import { source } from "../store/source.js";
import { texts } from "../texts/texts.js";
import { indexOfPlace } from "./offsets.js";

/** The line of a message, and its caret below it. */
function excerpt({ file, line, column, end_line, end_column }: Diagnostic): string {
  const text = source.files.value[file] ?? "";
  const begin = indexOfPlace(text, line, 1);
  const whole = text.slice(begin).split("\n", 1)[0] ?? "";
  const from = indexOfPlace(text, line, column) - begin;
  const to = end_line === line ? indexOfPlace(text, end_line, end_column) - begin : whole.length;
  const before = whole.slice(0, from).replace(/[^\t]/g, " ");
  return `${whole}\n${before}^${"~".repeat(Math.max(0, to - from - 1))}`;
}

export function Problems(props: {
  onShow: (diagnostic: Diagnostic) => void;
  onFix: (diagnostic: Diagnostic) => void;
}) {
  const { editor: t } = texts.value;
  const found = messages.diagnostics.value;
  const complaint = messages.complaint.value;
  return (
    <section class="problems" aria-label={t.problems} aria-live="polite" tabIndex={0}>
      {complaint !== "" && <pre class="problem error complaint">{complaint}</pre>}
      {found.length === 0 && complaint === "" && <p class="muted small">{t.none}</p>}
      <ul>
        {found.map((diagnostic, index) => (
          <li key={index} class={`problem ${diagnostic.severity}`}>
            <div class="row">
              <button
                type="button"
                class="link"
                onClick={() => {
                  props.onShow(diagnostic);
                }}
              >
                {diagnostic.file}:{t.place(diagnostic.line, diagnostic.column)}
              </button>
              <span class="severity">
                {t[diagnostic.severity]} {diagnostic.code}
              </span>
              {diagnostic.fixits.length > 0 && (
                <button
                  type="button"
                  class="fix"
                  aria-label={t.fixThis(diagnostic.message)}
                  onClick={() => {
                    props.onFix(diagnostic);
                  }}
                >
                  {t.fix}
                </button>
              )}
            </div>
            <p>{diagnostic.message}</p>
            {Object.hasOwn(source.files.value, diagnostic.file) && <pre>{excerpt(diagnostic)}</pre>}
            {diagnostic.notes.map((note, at) => (
              <p key={at} class="muted">
                {note.file !== undefined && `${note.file}:${note.line ?? 1}: `}
                {note.message}
              </p>
            ))}
          </li>
        ))}
      </ul>
    </section>
  );
}
