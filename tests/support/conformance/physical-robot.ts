/** The example of a physical robot in its own process, unchanged or with injected faults. */
import { cpSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { startHost } from "./robot-server.ts";
import { editedFiles, EXAMPLE, type Edit } from "./source-edits.ts";

/** The pen of docs/conformance.md: 2 m wide and 5 m long, with the goal in the far right corner. */
export const PEN = "####,#.G#,#..#,#..#,#..#,#.S#,####";

interface RobotOptions {
  room: string;
  /** speed factor of the motors; leases and ttls are unchanged */
  speedup?: number;
  /** whether the robot measures its pose, and can put itself at its start */
  isTracked?: boolean;
  edits?: readonly Edit[];
}

export interface RunningRobot {
  address: string;
  stop: () => void;
}

export async function startPhysicalRobot(options: RobotOptions): Promise<RunningRobot> {
  const { room, speedup = 4, isTracked = false, edits = [] } = options;
  const folder = edits.length > 0 ? copyWith(edits) : null;
  const args = ["--port", "0", "--speedup", String(speedup), "--room", room];
  if (isTracked) args.push("--tracked", "--reset");
  const removeFolder = (): void => {
    if (folder !== null) rmSync(folder, { recursive: true, force: true });
  };
  try {
    const host = await startHost(join(folder ?? EXAMPLE, "robot_host.py"), args);
    let isRunning = true;
    const stop = (): void => {
      if (isRunning) host.stop();
      isRunning = false;
      removeFolder();
    };
    return { address: host.address, stop };
  } catch (error) {
    removeFolder();
    throw error;
  }
}

/** A copy of the example with the edits. @throws Error unless each text occurs exactly once */
function copyWith(edits: readonly Edit[]): string {
  const files = editedFiles(edits);
  const folder = mkdtempSync(join(tmpdir(), "corridor-robot-"));
  cpSync(EXAMPLE, folder, { recursive: true });
  for (const [file, text] of files) writeFileSync(join(folder, file), text);
  return folder;
}
