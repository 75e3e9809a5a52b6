// A form with which a teacher makes a lesson of the open program, and gets its link.

import { useState } from "preact/hooks";

import { Dialog } from "../panel/dialog.js";
import { keep, kept } from "../store/keep.js";
import { settings } from "../store/settings.js";
import { source } from "../store/source.js";
import { texts } from "../texts/texts.js";
import { CopyableLink } from "./copyable_link.js";
import { type Draft, lessonOf, readDraft } from "./draft.js";
import { linkOfLesson } from "./project_link.js";

export function LessonDialog({ onClose }: { onClose: () => void }) {
  const { teach: t, lessons } = texts.value;
  const [draft, setDraft] = useState(() => readDraft(kept("draft")));
  const change = (part: Partial<Draft>) => {
    const next = { ...draft, ...part };
    setDraft(next);
    keep("draft", next);
  };
  const { main, files = {}, structured } = source.project.value;
  const start = { files, main, program: source.lesson.value.program, structured };
  const { language } = settings;
  const parsed = lessonOf(draft, start, language.value);
  return (
    <Dialog title={t.title} onClose={onClose}>
      <p>{t.text}</p>
      <label>
        {t.name}
        <input
          value={draft.title}
          onInput={({ currentTarget }) => {
            change({ title: currentTarget.value });
          }}
        />
      </label>
      <label>
        {t.id}
        <input
          value={draft.id}
          onInput={({ currentTarget }) => {
            change({ id: currentTarget.value });
          }}
        />
      </label>
      <label>
        {t.body}
        <textarea
          rows={6}
          value={draft.text}
          onInput={({ currentTarget }) => {
            change({ text: currentTarget.value });
          }}
        />
      </label>
      {draft.hints.map((hint, index) => (
        <label key={index}>
          {lessons.hints(index + 1, draft.hints.length)}
          <textarea
            rows={2}
            value={hint}
            onInput={({ currentTarget }) => {
              const { value } = currentTarget;
              change({ hints: draft.hints.map((each, at) => (at === index ? value : each)) });
            }}
          />
        </label>
      ))}
      <div>
        <button
          type="button"
          onClick={() => {
            change({ hints: [...draft.hints, ""] });
          }}
        >
          {t.addHint}
        </button>
      </div>
      <label>
        {t.task}
        <select
          value={draft.task}
          onChange={({ currentTarget }) => {
            change({ task: currentTarget.value === "explore" ? "explore" : "run" });
          }}
        >
          <option value="run">{lessons.task.run}</option>
          <option value="explore">{lessons.task.explore}</option>
        </select>
      </label>
      {"lesson" in parsed ? (
        <CopyableLink label={texts.value.share.link} link={linkOfLesson(parsed.lesson)} />
      ) : (
        <div role="status">
          {t.missing}
          <ul>
            {parsed.mistakes.map(({ where, message }) => (
              <li key={where + message.en}>
                <code>{where}</code> {message[language.value]}
              </li>
            ))}
          </ul>
        </div>
      )}
    </Dialog>
  );
}
