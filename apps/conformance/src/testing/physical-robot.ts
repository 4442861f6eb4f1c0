/** The example of a physical robot in its own process, unchanged or with an injected fault. */
import { spawn } from "node:child_process";
import { once } from "node:events";
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";

const ROBOT = join(import.meta.dirname, "../../../../examples/physical-robot");
/** The pen of docs/conformance.md: 2 m wide and 5 m long, with the goal in the far right corner. */
export const PEN = "####,#.G#,#..#,#..#,#..#,#.S#,####";

/** A replacement in a Python file. The text must occur exactly once. */
export interface Edit {
  file: string;
  before: string;
  after: string;
}

export interface RobotOptions {
  room: string;
  /** speed factor of the motors; leases and ttls are unchanged */
  haste?: number;
  /** whether the robot measures its pose */
  isTracked?: boolean;
  edits?: readonly Edit[];
}

export interface RunningRobot {
  address: string;
  stop: () => void;
}

export async function startPhysicalRobot(options: RobotOptions): Promise<RunningRobot> {
  const { room, haste = 4, isTracked = false, edits = [] } = options;
  const folder = edits.length > 0 ? copyWith(edits) : null;
  const words = ["--port", "0", "--speedup", String(haste), "--room", room];
  if (isTracked) words.push("--tracked");
  const child = spawn("python3", [join(folder ?? ROBOT, "robot_host.py"), ...words], {
    stdio: ["ignore", "pipe", "pipe"],
    env: { ...process.env, PYTHONDONTWRITEBYTECODE: "1" },
  });
  let errors = "";
  child.stderr.on("data", (chunk) => (errors += chunk));
  const stop = (): void => {
    child.kill("SIGKILL");
    if (folder !== null) rmSync(folder, { recursive: true, force: true });
  };
  // The output stays open: the host ends when its output is closed.
  const line = once(createInterface({ input: child.stdout }), "line") as Promise<[string]>;
  const exit = once(child, "exit").then(() => {
    throw new Error(`The robot's host has ended: ${errors}`);
  });
  exit.catch(() => undefined);
  try {
    const [address] = await Promise.race([line, exit]);
    return { address, stop };
  } catch (error) {
    stop();
    throw error;
  }
}

/** A copy of the example with the edits. @throws Error unless each text occurs exactly once */
function copyWith(edits: readonly Edit[]): string {
  const folder = mkdtempSync(join(tmpdir(), "corridor-robot-"));
  cpSync(ROBOT, folder, { recursive: true });
  for (const { file, before, after } of edits) {
    const path = join(folder, file);
    const parts = readFileSync(path, "utf8").split(before);
    if (parts.length !== 2) {
      throw new Error(`${file} has ${parts.length - 1} of this text, not one: ${before}`);
    }
    writeFileSync(path, parts.join(after));
  }
  return folder;
}
