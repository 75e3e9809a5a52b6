// A map of the lessons: a point for each, filled if it is solved; the open one has its number.

import { lessons } from "../store/lessons.js";
import { settings } from "../store/settings.js";
import { openLesson, source } from "../store/source.js";
import { texts } from "../texts/texts.js";

export function LessonMap() {
  const { lessons: t } = texts.value;
  const { solved } = lessons;
  const open = source.lesson.value.id;
  const list = lessons.listed.value;
  // One of them is reached with Tab, the others from there with the arrows.
  const reached = Math.max(
    0,
    list.findIndex(({ id }) => id === open),
  );
  return (
    <div
      class="lesson-map"
      role="group"
      aria-label={t.list}
      onKeyDown={(event) => {
        const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
        if (by === undefined) return;
        const points = [...event.currentTarget.querySelectorAll("button")];
        const at = points.indexOf(document.activeElement as HTMLButtonElement);
        points[at + by]?.focus();
        event.preventDefault();
      }}
    >
      {list.map((lesson, index) => {
        const isOpen = lesson.id === open;
        const isSolved = solved.value.has(lesson.id);
        const name = `${index + 1}. ${lesson.title[settings.language.value]}`;
        const title = isSolved ? `${name} (${t.solved})` : name;
        return (
          <button
            key={lesson.id}
            type="button"
            class={`map-point ${isSolved ? "solved" : ""}`}
            tabIndex={index === reached ? 0 : -1}
            aria-current={isOpen ? "page" : undefined}
            aria-label={title}
            title={title}
            onClick={() => {
              openLesson(lesson);
            }}
          >
            <span>{isOpen ? index + 1 : ""}</span>
          </button>
        );
      })}
    </div>
  );
}
