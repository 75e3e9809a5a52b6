// The channels that are shown: a card for each with its present value and its scale, the knobs of the
// one that is chosen, and a field to add one.

import { useState } from "preact/hooks";

import { present } from "../session/bench.js";
import { number } from "../texts/number.js";
import { texts } from "../texts/texts.js";
import { channelNames, type Drawn, unitsOf, unitsPerDivision, valueNow } from "./channels.js";
import { addChannel, chooseChannel, drawn, removeChannel, scope, setChannel } from "./settings.js";
import type { Sweep } from "./trigger.js";

function variables() {
  return [...present.globals.value, ...[...present.locals.value.values()].flat()];
}

export function ChannelList({ sweep }: { sweep: Sweep }) {
  const { scope: t } = texts.value;
  return (
    <div class="channels">
      {drawn.value.map((setting, index) => (
        <Channel key={setting.name} setting={setting} index={index} sweep={sweep} />
      ))}
      <AddChannel label={t.add} />
    </div>
  );
}

function Channel(props: { setting: Drawn; index: number; sweep: Sweep }) {
  const { setting, index, sweep } = props;
  const { scope: t } = texts.value;
  const values = sweep.channels.find(({ name }) => name === setting.name);
  const scale = values ? number(unitsPerDivision(setting, values), 6) : "";
  const now = values && valueNow(present.card.value, variables(), setting.name);
  const isChosen = scope.chosen.value === setting.name;
  return (
    <div class={`channel of${index % 8}`} role="group" aria-label={setting.name}>
      <button
        type="button"
        class="quiet channel-head"
        aria-pressed={isChosen}
        onClick={() => {
          chooseChannel(setting.name);
        }}
      >
        <span class="channel-name">{setting.name}</span>
        <strong>{now === undefined ? "" : number(now)}</strong>
        <span class="small muted">
          {setting.isDigital ? t.digital : scale === "" ? "" : t.scaleOf(scale)}
        </span>
        <span class="unit small muted">{unitsOf(present.card.value).get(setting.name)}</span>
      </button>
      {isChosen && <Knobs setting={setting} scale={scale} />}
    </div>
  );
}

function Knobs({ setting, scale }: { setting: Drawn; scale: string }) {
  const { scope: t } = texts.value;
  return (
    <div class="channel-knobs">
      {!setting.isDigital && (
        <label class="small muted">
          {t.scale}{" "}
          <input
            type="number"
            min="0"
            step="any"
            class="narrow"
            placeholder={scale}
            aria-label={t.perDivision(setting.name)}
            value={setting.perDivision ?? ""}
            onChange={({ currentTarget }) => {
              const units = currentTarget.valueAsNumber;
              const { name, offset } = setting;
              setChannel(units > 0 ? { name, offset, perDivision: units } : { name, offset });
            }}
          />
        </label>
      )}
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
  const names = channelNames(present.card.value, variables());
  const free = names.filter((name) => !scope.channels.value.some((each) => each.name === name));
  return (
    <div class="channel-field">
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
