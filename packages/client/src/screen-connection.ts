import {
  MAX_DISPLAY_LENGTH,
  relayToScreenSchema,
  type RelayToScreen,
  type ScreenToRelay,
} from "@corridor/protocol";
import { ClassConnection, type ClassConnectionOptions } from "./class-connection.ts";

/** The fields around the content. */
const ENVELOPE = 1_024;

/** A message for the big screen. */
export type ScreenMessage = Exclude<RelayToScreen, { type: "heartbeat" }>;

/** `key` is the key of a big screen. */
export type ScreenConnectionOptions = ClassConnectionOptions<ScreenMessage>;

/** The connection of a big screen to a class. It can run in a worker. */
export class ScreenConnection extends ClassConnection<RelayToScreen, ScreenToRelay> {
  /** Connects at once. */
  constructor(options: ScreenConnectionOptions) {
    const { onMessage } = options;
    const acknowledge = (message: ScreenMessage): void => {
      if (message.type === "display") super.send({ type: "seen", seq: message.seq });
      onMessage(message);
    };
    super(
      { ...options, onMessage: acknowledge },
      { role: "show", schema: relayToScreenSchema, maxLength: MAX_DISPLAY_LENGTH + ENVELOPE },
    );
  }
}
