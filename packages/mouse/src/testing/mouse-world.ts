/** A session with a simulated robot, and its transcript. */
import type { MazeDocument } from "@corridor/maze";
import type { Marks } from "@corridor/protocol";
import { onTestFinished } from "vitest";
import { MouseSession } from "../mouse-session.ts";
import type { GridWorld } from "./grid-world.ts";
import { ManualTimers } from "@corridor/protocol/testing";
import type { ProgramLines } from "./mouse-programs.ts";
import { SimulatedPort } from "./simulated-port.ts";

export interface MouseWorld {
  port: SimulatedPort;
  timers: ManualTimers;
  session: MouseSession;
  /** what the program sent (`> `) and received (`< `) */
  transcript: string[];
  reports: string[];
  marks: Marks[];
  ends: string[];
  lines: ProgramLines;
}

/** @param prepare called before the session starts */
export async function startMouse(
  maze: MazeDocument,
  prepare: (port: SimulatedPort) => void = () => undefined,
): Promise<MouseWorld> {
  const port = new SimulatedPort(maze);
  prepare(port);
  const timers = new ManualTimers();
  const transcript: string[] = [];
  const reports: string[] = [];
  const marks: Marks[] = [];
  const ends: string[] = [];
  let resolveAnswer: (line: string) => void = () => undefined;
  const session = await MouseSession.start({
    port,
    timers,
    respond: (line) => {
      transcript.push(`< ${line}`);
      resolveAnswer(line);
    },
    report: (sentence) => void reports.push(sentence),
    mark: (message) => void marks.push(message),
    onEnd: (error) => void ends.push(error.message),
  });
  onTestFinished(() => session.close());
  const say = (line: string): void => {
    transcript.push(`> ${line}`);
    void session.receive(`${line}\n`);
  };
  const ask = (line: string): Promise<string> =>
    new Promise((resolve) => {
      resolveAnswer = resolve;
      say(line);
    });
  return { port, timers, session, transcript, reports, marks, ends, lines: { ask, say } };
}

/** The same for a grid without a robot. */
export function gridLines(grid: GridWorld): { transcript: string[]; lines: ProgramLines } {
  const transcript: string[] = [];
  const say = (line: string): void => void transcript.push(`> ${line}`);
  const ask = async (line: string): Promise<string> => {
    say(line);
    const answer = grid.answer(line) ?? "";
    transcript.push(`< ${answer}`);
    return answer;
  };
  return { transcript, lines: { ask, say } };
}
