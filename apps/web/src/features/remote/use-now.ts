/** The current time, for texts such as "0.3 s ago". */
import { useEffect, useState } from "react";

const TICK_MS = 200;

/** ms since 1970, updated five times a second while `isRunning`. */
export function useNow(isRunning: boolean): number {
  const [now, setNow] = useState(() => Date.now());
  useEffect(() => {
    if (!isRunning) return;
    const timer = setInterval(() => setNow(Date.now()), TICK_MS);
    return () => clearInterval(timer);
  }, [isRunning]);
  return now;
}
