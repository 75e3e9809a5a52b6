// Where the zeros of the channels are on the screen: a handle for each.

import { texts } from "../texts/texts.js";
import { divisions, type Setting } from "./channels.js";
import { Handle } from "./handle.js";
import { chooseChannel, scope, setChannel } from "./settings.js";

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
    setChannel({ ...setting, offset: Number(offset.toFixed(1)) });
  };
  return (
    <Handle
      class={`of${index % 8}`}
      label={t.offset(setting.name)}
      at={setting.offset}
      beside={beside}
      value={setting.offset}
      least={-divisions}
      largest={divisions}
      onPut={put}
      onTake={() => {
        chooseChannel(setting.name);
      }}
      onDblClick={() => {
        put(0);
      }}
    >
      {index + 1}
    </Handle>
  );
}
