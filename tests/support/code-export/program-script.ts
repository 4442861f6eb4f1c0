/**
 * A program as code. The script drives a robot through lost connections, and its path is compared
 * with that of the program in a simulation.
 */
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { setTimeout as sleep } from "node:timers/promises";
import { generateMaze, type MazeDocument } from "@corridor/maze";
import { codeFiles, programCode, type CodeLanguage, type ProgramDocument } from "@corridor/program";
import type { CommandRecord, Pose } from "@corridor/protocol";
import { SeededRandom } from "../../../apps/relay/src/testing/faults/seeded-random.ts";
import { FaultProxy } from "../../../e2e/faults/net/fault-proxy.ts";
import { recordsAfter } from "../client/command-records.ts";
import { lineOf, ProgramPath } from "./program-path.ts";
import { DECISIONS, GOAL, runScript, runtimes, type ScriptRun } from "./script-run.ts";

/** The network is cut once in this number of decisions. */
const DECISIONS_PER_CUT = 4;
/** A cut follows its decision by at most this time, in ms, if the script is connected then. */
const MAX_CUT_DELAY = 60;

const maze = (kind: "tree" | "loops" | "rooms"): MazeDocument =>
  generateMaze({ kind, columns: 7, rows: 7, seed: 5, name: kind });

/** mazes for the programs of the thesis */
export const thesisMazes = {
  tree: maze("tree"),
  loops: maze("loops"),
  rooms: maze("rooms"),
};

export interface Comparison {
  /** how the script differs from its program; null: in nothing */
  difference: string | null;
  /** the last printed line if the script ended by itself; null: it was ended */
  sentence: string | null;
}

export class ProgramScript {
  readonly #address: string;
  readonly #program: ProgramDocument;
  readonly #command: string[];
  readonly #folder: string;
  readonly #random: SeededRandom;
  readonly #network: FaultProxy;
  /** the newest command of the robot that has been read */
  #seq = 0;

  private constructor(
    address: string,
    program: ProgramDocument,
    script: { command: string[]; folder: string },
    network: { proxy: FaultProxy; random: SeededRandom },
  ) {
    this.#address = address;
    this.#program = program;
    this.#command = script.command;
    this.#folder = script.folder;
    this.#random = network.random;
    this.#network = network.proxy;
  }

  /** Writes and compiles a script. @param address of the robot, with its key */
  static async write(
    language: CodeLanguage,
    address: string,
    program: ProgramDocument,
  ): Promise<ProgramScript> {
    const { origin, port } = new URL(address);
    const random = new SeededRandom(1);
    const proxy = await FaultProxy.start({ target: () => Number(port), random });
    const code = programCode(program, language, address.replace(origin, proxy.origin));
    if (!code.ok) throw new Error(`no code for ${program.name}`);
    const folder = await mkdtemp(join(tmpdir(), "corridor-code-"));
    const file = join(folder, codeFiles[language].file);
    await writeFile(file, code.text);
    const command = await runtimes[language].start(file);
    return new ProgramScript(address, program, { command, folder }, { proxy, random });
  }

  /** number of connections that were cut */
  get cuts(): number {
    return this.#network.cuts;
  }

  /** Runs the script. @param maze of the robot */
  async compareIn(maze: MazeDocument): Promise<Comparison> {
    await this.#newRecords();
    let isRunning = true;
    const run = await runScript(this.#command, (count) => {
      if (count % DECISIONS_PER_CUT === 1) void this.#cutNextConnection(() => isRunning);
    });
    isRunning = false;
    const path = new ProgramPath(maze, this.#program);
    const difference = differenceOf(run, await this.#newRecords(), path);
    return { difference, sentence: run.end?.sentence ?? null };
  }

  async close(): Promise<void> {
    await this.#network.close();
    await rm(this.#folder, { recursive: true });
  }

  /** Cuts the connections of the script after a delay, as soon as it has one. */
  async #cutNextConnection(isRunning: () => boolean): Promise<void> {
    await sleep(this.#random.between(0, MAX_CUT_DELAY));
    while (isRunning() && this.#network.cut() === 0) await sleep(1);
  }

  async #newRecords(): Promise<CommandRecord[]> {
    const records = await recordsAfter(this.#address, this.#seq);
    this.#seq = records.at(-1)?.seq ?? this.#seq;
    return records;
  }
}

/** How a script's decisions and its end differ from the path of its program; null: in nothing. */
function differenceOf(
  { lines, end }: ScriptRun,
  records: readonly CommandRecord[],
  path: ProgramPath,
): string | null {
  const ended = records.filter(({ state }) => /completed|collided/.test(state));
  // The script begins with a reset, and each decision starts at the end of the one before.
  const poses = ended.map(({ pose }) => pose as Pose);
  if (ended[0]?.action !== "reset") return `no reset: ${end?.sentence}`;
  const decisions = lines
    .slice(0, poses.length)
    .map((label, at) => ({ line: lineOf(label), pose: poses[at] as Pose }));
  if (decisions.length === 0) return "no decision";
  const first = path.firstDifference(decisions);
  if (first !== null) return `another decision: ${JSON.stringify(first)}`;
  if (end === null)
    return decisions.length < DECISIONS - 1 ? `only ${decisions.length} decisions` : null;
  if (end.sentence.includes("against a wall"))
    return path.endsAt(poses.at(-1) as Pose) ? null : "ends elsewhere";
  return end.sentence === GOAL && end.code === 0 ? null : `exit code ${end.code}: ${end.sentence}`;
}
