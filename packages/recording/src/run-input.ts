/** What comes to a run from outside, each at the end of a tick: all that has to be kept to repeat it. */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { Command, DriverName } from "@corridor/protocol";

export type RunInput =
  /** somebody else takes the robot, which stops */
  | { do: "driver"; driver: DriverName }
  /** a command of the hand, or with its number `seq` a script's */
  | { do: "command"; command: Command; seq?: number | undefined }
  /** what the script's command does is over before its end; `superseded` where a newer one takes its place */
  | { do: "cancel"; superseded?: true | undefined }
  | { do: "program"; program: ProgramDocument }
  | { do: "maze"; maze: MazeDocument };

/** An input with the tick at whose end it comes; it counts from the next tick on. */
export type TimedInput = { tick: number } & RunInput;
