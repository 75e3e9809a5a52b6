// Panels below each other, and the borders between them: what lies above a border is as high as the
// reader makes it, and the last panel of the column takes what is left.

import type { ComponentChildren } from "preact";
import { Fragment } from "preact";

import type { ColumnName } from "../store/arrangement.js";
import type { Panel } from "../store/layout.js";
import { heighten } from "../store/places.js";
import { texts } from "../texts/texts.js";
import { arrangement, layoutName } from "./current.js";
import { type Measured, Splitter } from "./splitter.js";

/** The head of a panel, which stays, in pixels. */
const head = 40;
/** So much of the column stays for what lies below. */
const rest = 104;

function measure(splitter: HTMLElement): Measured | undefined {
  const whole = splitter.parentElement?.clientHeight ?? 0;
  const own = splitter.previousElementSibling?.getBoundingClientRect().height ?? 0;
  return own > 0 ? { own, least: head, most: Math.max(own, whole - rest), whole } : undefined;
}

export interface Panels {
  titleOf: (panel: Panel) => string;
  boxOf: (panel: Panel) => ComponentChildren;
}

export function Column({ name, titleOf, boxOf }: Panels & { name: ColumnName }) {
  const { frame: t } = texts.value;
  const { value: layout } = layoutName;
  const panels = arrangement.value[name];
  return (
    <div class={`column ${name}`}>
      {panels.map((panel, index) => (
        <Fragment key={panel}>
          {boxOf(panel)}
          {index + 1 < panels.length && (
            <Splitter
              key={layout}
              class="below"
              label={t.height(titleOf(panel))}
              axis="y"
              measure={measure}
              onPut={(part) => {
                heighten(layout, panel, part);
              }}
            />
          )}
        </Fragment>
      ))}
    </div>
  );
}
