/** The private parts of a client that its port uses. They are not part of the library's interface. */
import type {
  CommandRecord,
  Marks,
  Obstacle,
  Order,
  RelayToDriver,
  Snapshot,
} from "@corridor/protocol";
import type { ApiOptions } from "./api-request.ts";
import type { ClientError } from "./client-error.ts";

export interface ClientParts {
  api: ApiOptions;
  /** the newest snapshot; null before the first */
  newest(): Snapshot | null;
  /** why the robot does not continue; null: it does, or it has never reported */
  obstacle(): Obstacle | null;
  /** why the client has ended; null: it has not */
  end(): ClientError | null;
  /** Sends a valid command. @returns the record, once it is stored */
  send(order: Order, key: string | undefined): Promise<CommandRecord>;
  /** Marks cells of the maze. While there is no connection, nothing is sent. */
  mark(marks: Marks): void;
  observers: Set<ClientObserver>;
}

export interface ClientObserver {
  /** called with each message of the relay */
  received(message: RelayToDriver): void;
  /** called once */
  ended(error: ClientError): void;
}

/** The parts of each client. */
export const clientParts = new WeakMap<object, ClientParts>();
