/** The remaining lifetime of a robot's address, requested from the service periodically. */
import { useEffect, useState } from "react";
import type { RemoteSession } from "../../simulator/protocol/worker-messages.ts";
import { secondsLeft } from "./owner-calls.ts";

const ASK_EVERY_MS = 60_000;

/** Whole minutes; null while the time is unavailable. */
export function useMinutesLeft(session: RemoteSession): number | null {
  const [minutes, setMinutes] = useState<number | null>(null);
  const { id, ownerKey } = session;
  useEffect(() => {
    let isOver = false;
    const look = async (): Promise<void> => {
      const seconds = await secondsLeft(fetch, { id, ownerKey });
      if (!isOver) setMinutes(seconds === null ? null : Math.floor(seconds / 60));
    };
    void look();
    const timer = setInterval(() => void look(), ASK_EVERY_MS);
    return () => {
      isOver = true;
      clearInterval(timer);
    };
  }, [id, ownerKey]);
  return minutes;
}
