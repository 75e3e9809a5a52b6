// Where the zeros of the channels are on the screen: handles at its right edge, which the pointer drags
// and the arrow keys move.

import type { TargetedKeyboardEvent } from "preact";

import { texts } from "../texts/texts.js";
import { divisions, type Setting } from "./channels.js";
import { screenPadding } from "./plot.js";
import { chooseChannel, scope, setChannel } from "./settings.js";

/** How far an arrow key moves a zero, in divisions. */
const step = 0.5;

export function Zeros() {
  const { value: channels } = scope.channels;
  return (
    <>
      {channels.map((setting, index) => (
        <Zero
          key={setting.name}
          setting={setting}
          index={index}
          // Those at the same height stand beside each other.
          beside={channels.slice(0, index).filter(({ offset }) => offset === setting.offset).length}
        />
      ))}
    </>
  );
}

function Zero(props: { setting: Setting; index: number; beside: number }) {
  const { setting, index, beside } = props;
  const { scope: t } = texts.value;
  const put = (offset: number) => {
    const inside = Math.min(divisions, Math.max(-divisions, offset));
    setChannel({ ...setting, offset: Number(inside.toFixed(1)) });
  };
  const walk = (event: TargetedKeyboardEvent<HTMLDivElement>) => {
    const wishes: Record<string, number> = {
      ArrowUp: setting.offset + step,
      ArrowDown: setting.offset - step,
      Home: -divisions,
      End: divisions,
    };
    const wished = wishes[event.key];
    if (wished === undefined) return;
    event.preventDefault();
    put(wished);
  };
  return (
    <div
      class={`zero of${index % 8}`}
      role="slider"
      tabIndex={0}
      aria-orientation="vertical"
      aria-label={t.offset(setting.name)}
      aria-valuemin={-divisions}
      aria-valuemax={divisions}
      aria-valuenow={setting.offset}
      title={t.offset(setting.name)}
      ref={(element) => {
        element?.style.setProperty("--at", String((divisions - setting.offset) / (2 * divisions)));
        element?.style.setProperty("--beside", String(beside));
      }}
      onKeyDown={walk}
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        chooseChannel(setting.name);
      }}
      onPointerMove={(event) => {
        if (!event.currentTarget.hasPointerCapture(event.pointerId)) return;
        const box = event.currentTarget.parentElement?.getBoundingClientRect();
        if (!box) return;
        const height = box.height - screenPadding.top - screenPadding.bottom;
        const part = (event.clientY - box.top - screenPadding.top) / height;
        put(divisions - 2 * divisions * part);
      }}
      onDblClick={() => {
        put(0);
      }}
    >
      <span>{index + 1}</span>
    </div>
  );
}
