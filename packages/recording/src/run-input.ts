/** External inputs of a run, each at the end of a tick. They are sufficient to replay the run. */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { Command, DriverName } from "@corridor/protocol";

export type RunInput =
  /** another driver acquires the robot, which stops */
  | { do: "driver"; driver: DriverName }
  /** a manual command, or a script's command with its number `seq` */
  | { do: "command"; command: Command; seq?: number | undefined }
  /** cancels the running command; `superseded` if a newer command replaces it */
  | { do: "cancel"; superseded?: true | undefined }
  | { do: "program"; program: ProgramDocument }
  | { do: "maze"; maze: MazeDocument };

/** An input and the tick at whose end it occurs. It applies from the next tick on. */
export type TimedInput = { tick: number } & RunInput;
