/** The page of a robot as its session sees it: somebody who can be told things and sent away. */
import type { CloseReason, RelayToPage } from "@corridor/protocol";

export interface PageLink {
  /** false once the page is gone or was sent away */
  readonly isOpen: boolean;
  /** Several go together, in order. */
  send(...messages: RelayToPage[]): void;
  close(reason: CloseReason): void;
}
