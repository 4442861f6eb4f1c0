/** The address at which the student's page plays the last seconds of a failed run. */
import { isProgram } from "@corridor/challenge";
import { encodeLink } from "@corridor/link";
import type { WrittenRun } from "@corridor/recording";
import { replayAddress } from "../../model/address/replay-start.ts";
import { failureStart } from "../../model/check/failure-start.ts";
import type { RunToRecord } from "../../simulator/protocol/pool-messages.ts";

/**
 * @returns an address of the page; of the maze and the program alone if the run does not fit into a
 *   link; null if those do not fit either
 */
export function failureAddress(
  { maze, attempt, ticks }: RunToRecord,
  written: WrittenRun | null,
): string | null {
  const link = written?.ok === true ? encodeLink({ run: written.run }) : null;
  if (link?.ok === true) return replayAddress(link.text, failureStart(ticks));
  if (!isProgram(attempt)) return null;
  const plain = encodeLink({ maze, program: attempt });
  return plain.ok ? `/#${plain.text}` : null;
}
