// C beside what it becomes on the card: a statement in the rows of those that it became. It knows
// neither the page nor its session; the extension for Visual Studio Code shows it, too.

import { Fragment } from "preact";
import { useEffect } from "preact/hooks";

import type { Shown } from "./shown.js";

export interface TwoColumnsWords {
  line: string;
  onCard: string;
  plain: string;
  broken: string;
  before: string;
}

interface TwoColumnsInputs {
  shown: Shown;
  words: TwoColumnsWords;
  /**
   * The class of what a line of C became: `next` for the threads' next line, `linked` for a chosen one,
   * `pointed` for one that the pointer is at.
   */
  mark: (file: string, line: number) => "next" | "linked" | "pointed" | "";
  /** The pointer is at what a line of C became, or no longer. */
  onPoint: (place: { file: string; line: number } | undefined) => void;
  /** The reader wants to see a line of C. */
  onShow: (file: string, line: number) => void;
}

export function TwoColumnsView(inputs: TwoColumnsInputs) {
  const { rows, state } = inputs.shown;
  const { words, onPoint } = inputs;
  const leave = () => {
    onPoint(undefined);
  };
  useEffect(() => leave, []);
  return (
    <>
      {state !== "fresh" && (
        <p class="muted empty">
          {state === "plain" ? words.plain : rows.length > 0 ? words.before : words.broken}
        </p>
      )}
      {rows.length > 0 && (
        <table class={`two-columns ${state}`} onPointerLeave={leave}>
          <thead>
            <tr>
              <th scope="col">{words.line}</th>
              <th scope="col">C</th>
              <th scope="col">{words.onCard}</th>
            </tr>
          </thead>
          <tbody>
            <Rows {...inputs} />
          </tbody>
        </table>
      )}
    </>
  );
}

function Rows({ shown: { rows }, mark, onPoint, onShow }: TwoColumnsInputs) {
  const isSeveral = rows.some(({ file }) => file !== undefined && file !== rows[0]?.file);
  // What has no line of C belongs to the statement above.
  let [file, line] = ["", 0];
  return rows.map((row, index) => {
    const isOther = row.file !== undefined && row.file !== file;
    ({ file = file, line = line } = row);
    const place = [file, line] as const;
    return (
      <Fragment key={index}>
        {isSeveral && isOther && (
          <tr>
            <th scope="rowgroup" colSpan={3}>
              {file.replace(/.*[\\/]/, "")}
            </th>
          </tr>
        )}
        <tr
          class={`${row.again ? "again" : ""} ${mark(...place)}`}
          onPointerEnter={() => {
            onPoint({ file: place[0], line: place[1] });
          }}
          onClick={() => {
            // Text that is selected is to be copied.
            if (getSelection()?.isCollapsed !== false) onShow(...place);
          }}
        >
          <td>
            {row.line && (
              <button type="button" class="link">
                {row.line}
              </button>
            )}
          </td>
          <td>
            <code>{row.text}</code>
          </td>
          <td>
            <code>{row.card}</code>
          </td>
        </tr>
      </Fragment>
    );
  });
}
