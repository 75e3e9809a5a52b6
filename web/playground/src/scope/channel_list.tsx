// The channels that are shown, each with its scale and its offset, and a field to add one.

import { useState } from "preact/hooks";

import { present } from "../session/bench.js";
import { number, texts } from "../texts/texts.js";
import { channelNames, type Setting, unitsOf, unitsPerDivision } from "./channels.js";
import { addChannel, removeChannel, scope, setChannel } from "./settings.js";
import type { Sweep } from "./trigger.js";

export function ChannelList({ sweep }: { sweep: Sweep }) {
  const { scope: t } = texts.value;
  return (
    <div class="channels">
      {scope.channels.value.map((setting, index) => (
        <Channel key={setting.name} setting={setting} index={index} sweep={sweep} />
      ))}
      <AddChannel label={t.add} />
    </div>
  );
}

function Channel(props: { setting: Setting; index: number; sweep: Sweep }) {
  const { setting, index, sweep } = props;
  const { scope: t } = texts.value;
  const values = sweep.channels.find(({ name }) => name === setting.name);
  const shown = values ? number(unitsPerDivision(setting, values), 6) : "";
  return (
    <div class="channel" role="group" aria-label={setting.name}>
      <span class={`dot c${index % 8}`} aria-hidden="true" />
      <span class="channel-name">{setting.name}</span>
      <label class="small muted">
        {t.scale}{" "}
        <input
          type="number"
          min="0"
          step="any"
          class="narrow"
          placeholder={shown}
          aria-label={t.perDivision(setting.name)}
          value={setting.perDivision ?? ""}
          onChange={({ currentTarget }) => {
            const units = currentTarget.valueAsNumber;
            const { name, offset } = setting;
            setChannel(units > 0 ? { name, offset, perDivision: units } : { name, offset });
          }}
        />{" "}
        <span class="unit">{unitsOf(present.card.value).get(setting.name)}</span>
      </label>
      <label class="small muted">
        {t.position}{" "}
        <input
          type="number"
          step="0.5"
          min="-4"
          max="4"
          class="narrow"
          aria-label={t.offset(setting.name)}
          value={setting.offset}
          onInput={({ currentTarget }) => {
            const offset = currentTarget.valueAsNumber;
            if (Number.isFinite(offset)) setChannel({ ...setting, offset });
          }}
        />
      </label>
      <button
        type="button"
        class="quiet"
        aria-label={t.remove(setting.name)}
        onClick={() => {
          removeChannel(setting.name);
        }}
      >
        ×
      </button>
    </div>
  );
}

function AddChannel({ label }: { label: string }) {
  const [text, setText] = useState("");
  const locals = [...present.locals.value.values()].flat();
  const names = channelNames(present.card.value, [...present.globals.value, ...locals]);
  const free = names.filter((name) => !scope.channels.value.some((each) => each.name === name));
  return (
    <div class="channel">
      <input
        type="text"
        list="channel-names"
        aria-label={label}
        placeholder={label}
        value={text}
        onInput={({ currentTarget }) => {
          const name = currentTarget.value.trim();
          if (free.includes(name)) {
            addChannel(name);
            setText("");
          } else {
            setText(currentTarget.value);
          }
        }}
      />
      <datalist id="channel-names">
        {free.map((name) => (
          <option key={name} value={name} />
        ))}
      </datalist>
    </div>
  );
}
