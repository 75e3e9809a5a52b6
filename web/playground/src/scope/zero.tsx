// The handle of a channel's zero.

import { texts } from "../texts/texts.js";
import { divisions, type Setting } from "./channels.js";
import { Handle } from "./handle.js";
import { chooseChannel, putZero } from "./settings.js";

export function Zero(props: { setting: Setting; index: number; height: number; beside: number }) {
  const { setting, index, height, beside } = props;
  const { scope: t } = texts.value;
  const put = (offset: number) => {
    putZero(setting.name, Number(offset.toFixed(1)));
  };
  return (
    <Handle
      class={`of${index % 8}`}
      label={t.offset(setting.name)}
      at={setting.offset}
      height={height}
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
