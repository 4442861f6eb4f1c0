/**
 * Parses the English sentences of a diagnosis and checks each one against the run: lines, times,
 * readings, distances. A sentence without a claim is reported as unknown.
 */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { SensorName } from "@corridor/protocol";
import { choiceClaims } from "./choice-claims.ts";
import { conditionClaims } from "./condition-claims.ts";
import { eventClaims } from "./event-claims.ts";
import {
  conditionOf,
  isRead,
  isTrueAt,
  lineOf,
  ticksAt,
  type Evidence,
  type Found,
} from "./evidence.ts";
import { plainDrive } from "./plain-drive.ts";

const claims = [...eventClaims, ...choiceClaims, ...conditionClaims];

const readers = claims.map(([sentence, holds]) => ({
  sentence: new RegExp(`^${sentence}(?: |$)`, "u"),
  holds,
}));

/**
 * @param text in English, without the number of a maze
 * @param end tick of the failure
 * @returns the sentences that the run contradicts, and the text from the first unknown sentence on
 */
export function falseSentences(
  maze: MazeDocument,
  program: ProgramDocument,
  text: string,
  end: number,
): string[] {
  const evidence = { maze, program, moments: plainDrive(maze, program, end), end };
  const wrong: string[] = [];
  let rest = text;
  while (rest !== "") {
    const reader = readers.find(({ sentence }) => sentence.test(rest));
    const match = reader?.sentence.exec(rest);
    if (reader === undefined || match === null || match === undefined)
      return [...wrong, `unknown: ${rest}`];
    const found = match.groups ?? {};
    const isFalse = !reader.holds(evidence, found) || contradictsLine(evidence, found);
    if (isFalse) wrong.push(match[0].trim());
    rest = rest.slice(match[0].length);
  }
  return wrong;
}

/**
 * Whether the numbers of the sentence contradict the condition of a line that it names. Example:
 * "right was 50 cm" for a `right > 50` that was true.
 */
function contradictsLine({ program, moments }: Evidence, found: Found): boolean {
  const ticks = ticksAt(found["at"]).filter((tick) => isRead(moments[tick], found));
  return [found["who"], found["inner"]].some((name) => {
    const when = name === undefined ? null : conditionOf(program, lineOf(name));
    if (when === null) return false;
    const read = (sensor: SensorName) =>
      found["sensor"] === sensor ? found["reading"] : sensor === "back" ? undefined : found[sensor];
    const left = read(when.sensor);
    const other = when.than === "right" ? read("right") : "0";
    if (left === undefined || other === undefined) return false;
    const right = when.than === "right" ? Number(other) + when.plus : when.than;
    const reads = when.is === ">" ? Number(left) > right : Number(left) < right;
    return ticks.every((tick) => isTrueAt(program, lineOf(name), moments[tick]) !== reads);
  });
}
