/** Placeholder until the relay client lands. */
import type { Delivery, Ending, RemoteDriverEvents } from "../drivers/remote-driver.ts";
import type { Snapshot } from "@corridor/protocol";
import type { RemoteSession, RemoteView } from "./worker-messages.ts";

export interface RemoteHostOptions {
  origin: string;
  onView(view: RemoteView): void;
  onDelivery(delivery: Delivery): void;
  onStop(): void;
}

export class RemoteHost implements RemoteDriverEvents {
  readonly #options: RemoteHostOptions;
  constructor(options: RemoteHostOptions) {
    this.#options = options;
  }
  get isOpen(): boolean {
    return false;
  }
  open(_session: RemoteSession | null, _fresh: boolean): void {
    this.#options.onView({ status: { kind: "connecting" }, session: null, commands: [] });
  }
  close(): void {}
  clearCommands(): void {}
  sendSnapshot(_snapshot: Snapshot): void {}
  started(_seq: number): void {}
  ended(_seq: number, _ending: Ending): void {}
}
