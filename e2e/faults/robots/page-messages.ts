/** Messages between the runner and a process of pages. */
import type {
  RemoteSession,
  RemoteStatus,
} from "../../../apps/web/src/simulator/protocol/worker-messages.ts";
import type { CommandState } from "@corridor/protocol";

/** transports to the relay that a client tries */
export type Transports = "both" | "websocket" | "https";

export type ToPages =
  | {
      type: "open";
      /** unique number of the page */
      page: number;
      /** address at which the page reaches its relay */
      origin: string;
      session: RemoteSession;
      transports: Transports;
    }
  /** Closes the tab. */
  | { type: "close"; page: number };

/** times `at` are by `machineNow` */
export type FromPages =
  | { type: "ready" }
  | { type: "state"; page: number; seq: number; state: CommandState; at: number }
  | { type: "status"; page: number; status: RemoteStatus; at: number }
  /** The relay delivered a command, with the deadline for its start by the relay's clock. */
  | { type: "delivered"; page: number; seq: number; deadline: number }
  /** The relay assigned the robot to this page. */
  | { type: "acquired"; page: number; at: number }
  /** session that the tab stores across a reload */
  | { type: "session"; page: number; session: RemoteSession }
  /** The robot started to move, or stopped. */
  | { type: "motion"; page: number; isMoving: boolean; at: number };
