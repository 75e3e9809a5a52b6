// A handle at the right edge of the screen, which the pointer drags and the arrow keys move up and down.

import type { ComponentChildren, TargetedKeyboardEvent } from "preact";

import { divisions } from "./channels.js";
import { screenPadding } from "./plot.js";

/** Its width and height in pixels, as the style has them. */
export const handleSize = 24;

/** How far an arrow key moves a handle, in divisions. */
const step = 0.5;

interface Props {
  class: string;
  label: string;
  /** Where it is, in divisions from the middle. Outside of the screen it stands at the edge. */
  at: number;
  /** How high the divisions are together, in pixels. */
  height: number;
  /** How many handles stand to the right of it. */
  beside: number;
  /** What it sets, with the values at the lower and the upper edge. */
  value: number;
  least: number;
  largest: number;
  /** The value as it is read out, unless the number says it. */
  valueText?: string;
  /** Puts it elsewhere on the screen, in divisions from the middle. */
  onPut: (at: number) => void;
  /** The pointer takes it, and lets it go. */
  onTake?: () => void;
  onLeave?: () => void;
  onDblClick?: () => void;
  children: ComponentChildren;
}

export function onScreen(at: number): number {
  return Math.min(divisions, Math.max(-divisions, at));
}

export function Handle(props: Props) {
  const { at, height, beside, onPut } = props;
  const walk = (event: TargetedKeyboardEvent<HTMLDivElement>) => {
    const wishes: Record<string, number> = {
      // What is outside of the screen already does not come back against the arrow.
      ArrowUp: Math.max(at, onScreen(at + step)),
      ArrowDown: Math.min(at, onScreen(at - step)),
      Home: -divisions,
      End: divisions,
    };
    const wished = wishes[event.key];
    if (wished === undefined) return;
    event.preventDefault();
    onPut(wished);
  };
  const place = (element: HTMLElement | null) => {
    const part = (divisions - onScreen(at)) / (2 * divisions);
    element?.style.setProperty("--top", `${screenPadding.top + height * part}px`);
    element?.style.setProperty("--beside", String(beside));
  };
  return (
    <>
      <div
        class={`handle ${props.class}`}
        role="slider"
        tabIndex={0}
        aria-orientation="vertical"
        aria-label={props.label}
        aria-valuemin={props.least}
        aria-valuemax={props.largest}
        aria-valuenow={props.value}
        aria-valuetext={props.valueText}
        title={props.label}
        ref={place}
        onKeyDown={walk}
        onPointerDown={(event) => {
          event.currentTarget.setPointerCapture(event.pointerId);
          props.onTake?.();
        }}
        onPointerMove={(event) => {
          if (!event.currentTarget.hasPointerCapture(event.pointerId)) return;
          const box = event.currentTarget.parentElement?.getBoundingClientRect();
          if (!box) return;
          const part = (event.clientY - box.top - screenPadding.top) / height;
          onPut(onScreen(divisions - 2 * divisions * part));
        }}
        onLostPointerCapture={props.onLeave}
        onDblClick={props.onDblClick}
      >
        <span>{props.children}</span>
      </div>
      <div class={`handle-line ${props.class}`} ref={place} />
    </>
  );
}
