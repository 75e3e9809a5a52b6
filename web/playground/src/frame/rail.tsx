// A column that is closed: a rail with the names of its panels, each of which opens it, and the button
// that closes a column.

import { type ColumnName, columns } from "../store/arrangement.js";
import type { Panel } from "../store/layout.js";
import { closeColumn, openColumn } from "../store/places.js";
import { texts } from "../texts/texts.js";
import { arrangement, canClose, layoutName } from "./current.js";

/** Drawings of 16 × 16. */
const arrows = { left: "M10 4 6 8l4 4", right: "M6 4l4 4-4 4" };

function Arrow({ to }: { to: keyof typeof arrows }) {
  return (
    <svg viewBox="0 0 16 16" aria-hidden="true">
      <path d={arrows[to]} />
    </svg>
  );
}

interface Named {
  name: ColumnName;
  titleOf: (panel: Panel) => string;
}

export function Rail({ name, titleOf }: Named) {
  const { frame: t } = texts.value;
  return (
    <div class="column-rail">
      {arrangement.value[name].map((panel) => (
        <button
          key={panel}
          type="button"
          class="quiet"
          aria-expanded={false}
          aria-controls={panel}
          title={t.open}
          onClick={() => {
            openColumn(layoutName.peek(), name);
          }}
        >
          <Arrow to={name === "right" ? "left" : "right"} />
          {titleOf(panel)}
        </button>
      ))}
    </div>
  );
}

/** In the head of the first panel of a column. */
export function CloseButton({ panel, title }: { panel: Panel; title: string }) {
  const column = columns.find((each) => arrangement.value[each][0] === panel);
  if (!column || !canClose.value) return null;
  const { frame: t } = texts.value;
  return (
    <button
      type="button"
      class="quiet close-button"
      aria-label={`${t.close}: ${title}`}
      title={t.close}
      onClick={() => {
        closeColumn(layoutName.peek(), column);
      }}
    >
      <Arrow to={column === "right" ? "right" : "left"} />
    </button>
  );
}
