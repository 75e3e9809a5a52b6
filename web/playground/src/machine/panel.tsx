// The machine of the session.

import type { Card } from "@oncard/engine";
import { computed, effect, signal } from "@preact/signals";

import { useAsked } from "../session/asked.js";
import { bench, present, session } from "../session/bench.js";
import { record } from "../session/record.js";
import { source } from "../store/source.js";
import { texts } from "../texts/texts.js";
import { axesNamed, type Place, wayOf } from "./axes.js";
import { axesShown, type Seen, seenOf } from "./seen.js";
import { MachineView, tableOf } from "./view.js";

/** So many points of the way are shown. */
const wayPoints = 300;

/** Since the program was loaded. */
const seen = signal<Seen | undefined>(undefined);

effect(() => {
  const { value: card } = present.card;
  if (!card) return;
  const isStart = present.state.peek()?.head === 0;
  seen.value = seenOf(card, isStart ? undefined : seen.peek());
});

/** Those that the lesson speaks of. */
const named = computed(() => (record.value ? [] : axesNamed(source.lesson.value.scope ?? [])));

export function MachinePanel() {
  const { value: card } = present.card;
  if (!card) {
    const { machine, status } = texts.value;
    const isStarting = session.notice.value.kind === "starting";
    return <p class="muted empty">{isStarting ? status.starting : machine.idle}</p>;
  }
  return <Machine card={card} seen={seen.value ?? seenOf(card)} />;
}

function Machine(props: { card: Card; seen: Seen }) {
  const axes = axesShown(props.card, props.seen, named.value);
  const table = tableOf(props.card, axes);
  const way = useWay(table?.x.axis, table?.y.axis);
  return (
    <MachineView
      {...props}
      axes={axes}
      way={way}
      words={texts.value.machine}
      onInput={(word, pin, level) => void bench.setInput(word, pin, level)}
    />
  );
}

/** Where two axes have been up to now. */
function useWay(x: number | undefined, y: number | undefined): readonly Place[] {
  const isTable = x !== undefined && y !== undefined;
  const time = present.state.value?.time_ms ?? 0;
  const key = isTable ? `${x} ${y} ${time} ${session.history.value}` : "";
  const ask = async () => {
    if (!isTable || time === 0) return [];
    const engine = await bench.engine();
    const names = [`axis${x}.prfPos`, `axis${y}.prfPos`];
    return wayOf(await engine.trace(names, 0, time, wayPoints));
  };
  return useAsked(key, ask, session.running.value) ?? [];
}
