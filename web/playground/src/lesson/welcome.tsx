// What stands beside the opening: one line, the first lesson, a program of the reader's own.

import { lessons } from "../store/lessons.js";
import { ownProgram } from "../store/own_program.js";
import { openLesson } from "../store/source.js";
import { texts } from "../texts/texts.js";
import { Gallery } from "./gallery.js";
import { VerdictBox } from "./verdict.js";

export function Welcome() {
  const { welcome: t } = texts.value;
  const [first] = lessons.offered.value;
  return (
    <div class="welcome scroll" tabIndex={0} role="group" aria-label={t.label}>
      <h2>
        {t.lines.map((line) => (
          <span key={line}>{line} </span>
        ))}
      </h2>
      <p class="muted">{t.text}</p>
      <div class="welcome-ways">
        {first && (
          <button
            type="button"
            class="primary"
            onClick={() => {
              openLesson(first);
            }}
          >
            {t.first}
          </button>
        )}
        <button
          type="button"
          onClick={() => {
            openLesson(ownProgram);
          }}
        >
          {t.own}
        </button>
      </div>
      <VerdictBox />
      <h3>{t.samples}</h3>
      <Gallery />
    </div>
  );
}
