/**
 * Name of the reason why a connection ended, for translated texts; loads with the client library.
 */
import { closeReasons, type CloseReason } from "@corridor/protocol";
import type { RemoteTrouble } from "../protocol/worker-messages.ts";

export function troubleOf({ code }: CloseReason): RemoteTrouble {
  const names = Object.keys(closeReasons) as (keyof typeof closeReasons)[];
  return names.find((name) => closeReasons[name].code === code) ?? "connectionLost";
}
