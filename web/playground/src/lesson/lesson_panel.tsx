// The lesson: the list with its progress, the text, hints that open one by one, and the check.

import { actions } from "../controls/actions.js";
import { lessonNamed, lessons, openHints } from "../store/lessons.js";
import { ownProgram } from "../store/own_program.js";
import { settings } from "../store/settings.js";
import { openLesson, source } from "../store/source.js";
import { texts } from "../texts/texts.js";
import { isSolvedNow, verdict } from "./checks.js";
import { LessonMap } from "./map.js";
import { htmlOf } from "./markdown.js";
import { isOpening } from "./opening.js";
import { VerdictBox } from "./verdict.js";
import { Welcome } from "./welcome.js";

function Text({ text }: { text: string }) {
  // markdown.ts lets no HTML through.
  return <div class="prose" dangerouslySetInnerHTML={{ __html: htmlOf(text) }} />;
}

export function LessonPanel() {
  return isOpening.value ? <Welcome /> : <OpenLesson />;
}

function OpenLesson() {
  const { lessons: t } = texts.value;
  const open = source.lesson.value;
  const { solved } = lessons;
  const { language } = settings;
  const shown = Math.min(lessons.openHints.value[open.id] ?? 0, open.hints.length);
  const list = lessons.listed.value;
  const opening = lessons.opening.value;
  const at = list.findIndex(({ id }) => id === open.id);
  const next = at >= 0 ? list[at + 1] : undefined;
  return (
    <div class="lesson">
      <div class="lesson-head">
        {list.length > 0 && <LessonMap />}
        <label class="visually-hidden" for="lesson-choice">
          {t.open}
        </label>
        <select
          id="lesson-choice"
          value={open.id}
          onChange={({ currentTarget }) => {
            const chosen = lessonNamed(currentTarget.value);
            if (chosen) openLesson(chosen);
          }}
        >
          {list.map(({ id, title }, index) => (
            <option key={id} value={id}>
              {index + 1}. {title[language.value]}
              {solved.value.has(id) ? ` (${t.solved})` : ""}
            </option>
          ))}
          {opening && <option value={opening.id}>{t.opening}</option>}
          <option value={ownProgram.id}>{ownProgram.title[language.value]}</option>
        </select>
        {list.length > 0 && (
          <span class="small muted">
            {t.progress(list.filter(({ id }) => solved.value.has(id)).length, list.length)}
          </span>
        )}
      </div>
      <div
        class="lesson-body scroll"
        tabIndex={0}
        role="group"
        aria-label={open.title[language.value]}
      >
        <h2>{open.title[language.value]}</h2>
        <Text text={open.text[language.value]} />
        {open.hints.slice(0, shown).map((hint, index) => (
          <section key={index} class="hint">
            <h3>{t.hints(index + 1, open.hints.length)}</h3>
            <Text text={hint[language.value]} />
          </section>
        ))}
        {shown < open.hints.length && (
          <button
            type="button"
            class="quiet"
            onClick={() => {
              openHints(open.id, shown + 1);
            }}
          >
            {t.hint} ({shown}/{open.hints.length})
          </button>
        )}
      </div>
      <div class="lesson-check">
        <div class="row">
          <span class="small muted grow">{t.task[open.task]}</span>
          <button
            type="button"
            class="primary"
            disabled={verdict.value.kind === "busy"}
            onClick={actions.check}
          >
            {t.check}
          </button>
        </div>
        <VerdictBox />
        {isSolvedNow.value && next && (
          <button
            type="button"
            onClick={() => {
              openLesson(next);
            }}
          >
            {t.next}: {next.title[language.value]}
          </button>
        )}
      </div>
    </div>
  );
}
