// Panels below each other, and the borders between them: what lies above a border is as high as the
// reader makes it, and the last panel of the column takes what is left. A closed column is a rail.

import type { ComponentChildren } from "preact";
import { Fragment } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";

import type { ColumnName } from "../store/arrangement.js";
import type { Panel } from "../store/layout.js";
import { heighten } from "../store/places.js";
import { texts } from "../texts/texts.js";
import { arrangement, closedColumns, layoutName } from "./current.js";
import { Rail } from "./rail.js";
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

/** What has the focus is hidden now: the rail has it, or the panel that was opened from there. */
function keepFocus(column: HTMLElement, isClosed: boolean): void {
  const { activeElement: focused } = document;
  if (!focused || !column.contains(focused)) return;
  const opened = focused.getAttribute("aria-controls") ?? "";
  const next = isClosed ? ".column-rail button" : `[id="${opened}"] button`;
  column.querySelector<HTMLElement>(next)?.focus();
}

export interface Panels {
  titleOf: (panel: Panel) => string;
  boxOf: (panel: Panel) => ComponentChildren;
}

export function Column({ name, titleOf, boxOf }: Panels & { name: ColumnName }) {
  const { frame: t } = texts.value;
  const { value: layout } = layoutName;
  const panels = arrangement.value[name];
  const isClosed = closedColumns.value.includes(name);
  const element = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    if (element.current) keepFocus(element.current, isClosed);
  }, [isClosed]);
  return (
    <div ref={element} class={`column ${name} ${isClosed ? "closed" : ""}`}>
      <Rail name={name} titleOf={titleOf} />
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
