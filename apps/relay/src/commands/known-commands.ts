/**
 * Interns commands, because robots receive the same few commands repeatedly. Equal commands share
 * one immutable object.
 */
import type { Command } from "@corridor/protocol";

export interface KnownCommand {
  readonly command: Command;
  /** the command as JSON */
  readonly text: string;
}

const MOST = 512;
const known = new Map<string, KnownCommand>();

/** @param text a command as JSON @throws SyntaxError if it is not JSON */
export function commandIn(text: string): KnownCommand {
  const before = known.get(text);
  if (before !== undefined) return before;
  if (known.size >= MOST) known.clear();
  const made = { command: Object.freeze(JSON.parse(text) as Command), text };
  known.set(text, made);
  return made;
}
