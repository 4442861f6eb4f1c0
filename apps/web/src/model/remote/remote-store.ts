/**
 * What the Remote panel shows: the connection, the address with its key, the scripts and the
 * commands.
 */
import { createStore } from "zustand/vanilla";
import type { RemoteView } from "../../simulator/protocol/worker-messages.ts";

export function createRemoteStore() {
  return createStore<RemoteView>()(() => ({
    status: { kind: "off" },
    session: null,
    commands: [],
    scripts: [],
    isPaused: false,
    mayReset: true,
  }));
}
export type RemoteStore = ReturnType<typeof createRemoteStore>;
