/** What crosses between the runner and a process of pages. */
import type { RemoteSession, RemoteStatus } from "../../../apps/web/src/worker/worker-messages.ts";
import type { CommandState } from "@corridor/protocol";

/** Which ways to the relay a client tries. */
export type Doors = "both" | "websocket" | "https";

export type ToPages =
  | {
      do: "open";
      /** a number that no other page has */
      page: number;
      /** through which the page reaches its relay */
      origin: string;
      session: RemoteSession;
      doors: Doors;
    }
  /** The tab is closed. */
  | { do: "leave"; page: number };

/** `at` is by `machineNow`. */
export type FromPages =
  | { tells: "ready" }
  | { tells: "deed"; page: number; seq: number; what: CommandState; at: number }
  | { tells: "status"; page: number; status: RemoteStatus; at: number }
  /** Its relay has given it a command, to be begun by then, by the relay's clock. */
  | { tells: "given"; page: number; seq: number; deadline: number }
  /** Its relay has given it the robot. */
  | { tells: "taken"; page: number; at: number }
  /** what the tab keeps over a reload */
  | { tells: "session"; page: number; session: RemoteSession }
  /** The robot has begun to move, or stands. */
  | { tells: "motion"; page: number; isMoving: boolean; at: number };
