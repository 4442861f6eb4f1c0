/** Why a connection ended, by the name that the page has words for; comes with the client library. */
import { closeReasons, type CloseReason } from "@corridor/protocol";
import type { RemoteTrouble } from "./worker-messages.ts";

export function troubleOf({ code }: CloseReason): RemoteTrouble {
  const names = Object.keys(closeReasons) as (keyof typeof closeReasons)[];
  return names.find((name) => closeReasons[name].code === code) ?? "lineLost";
}
