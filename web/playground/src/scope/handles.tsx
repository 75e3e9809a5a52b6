// The handles at the right edge of the screen: where the zeros of the channels are.

import { divisions } from "./channels.js";
import { columnsOf } from "./columns.js";
import { handleSize } from "./handle.js";
import { scope } from "./settings.js";
import { Zero } from "./zero.js";

/** @param height of all divisions, in pixels */
export function Handles({ height }: { height: number }) {
  const { value: channels } = scope.channels;
  const columns = columnsOf(
    channels.map(({ offset }) => offset),
    (handleSize / height) * 2 * divisions,
  );
  return (
    <>
      {channels.map((setting, index) => (
        <Zero key={setting.name} setting={setting} index={index} beside={columns[index] ?? 0} />
      ))}
    </>
  );
}
