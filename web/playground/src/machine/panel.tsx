// The machine of the session.

import { useAsked } from "../session/asked.js";
import { bench, present, session } from "../session/bench.js";
import { texts } from "../texts/texts.js";
import { type Place, wayOf } from "./axes.js";
import { machine, type MachineNow } from "./now.js";
import { MachineView, tableOf } from "./view.js";

/** So many points of the way are shown. */
const wayPoints = 300;

export function MachinePanel() {
  const { value: now } = machine;
  if (!now) {
    const { machine: t, status } = texts.value;
    const isStarting = session.notice.value.kind === "starting";
    return <p class="muted empty">{isStarting ? status.starting : t.idle}</p>;
  }
  return <Machine {...now} />;
}

function Machine(now: MachineNow) {
  const table = tableOf(now.card, now.axes);
  const way = useWay(table?.x.axis, table?.y.axis);
  return (
    <MachineView
      {...now}
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
