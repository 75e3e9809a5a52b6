// The handles at the right edge of the screen: where the zeros of the channels and the level of the
// trigger are.

import { divisions } from "./channels.js";
import { columnsOf } from "./columns.js";
import { handleSize, onScreen } from "./handle.js";
import { Level, placeOfLevel } from "./level.js";
import { scope } from "./settings.js";
import type { Sweep } from "./trigger.js";
import { Zero } from "./zero.js";

/** @param height of all divisions, in pixels */
export function Handles({ sweep, height }: { sweep: Sweep; height: number }) {
  const { value: channels } = scope.channels;
  const level = placeOfLevel(sweep);
  const heights = [...channels.map(({ offset }) => offset), ...(level ? [level.at] : [])];
  const columns = columnsOf(heights.map(onScreen), (handleSize / height) * 2 * divisions);
  return (
    <>
      {channels.map((setting, index) => (
        <Zero key={setting.name} setting={setting} index={index} beside={columns[index] ?? 0} />
      ))}
      {level && <Level place={level} beside={columns[channels.length] ?? 0} />}
    </>
  );
}
