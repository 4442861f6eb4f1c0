/** The connection of a robot's page, as the robot uses it. */
import type { CloseReason, RelayToPage } from "@corridor/protocol";

export interface PageLink {
  /** false once the page disconnected or was closed */
  readonly isOpen: boolean;
  /** Sends the messages together, in order. */
  send(...messages: RelayToPage[]): void;
  close(reason: CloseReason): void;
}
