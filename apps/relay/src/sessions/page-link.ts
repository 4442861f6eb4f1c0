/** The page of a robot as its session sees it: somebody who can be told things and sent away. */
import type { CloseReason, RelayToPage } from "@corridor/protocol";

export interface PageLink {
  send(message: RelayToPage): void;
  close(reason: CloseReason): void;
}
