/** The time for words such as "heard 0.3 s ago". */
import { useEffect, useState } from "react";

const TICK_MS = 200;

/** Milliseconds since 1970, renewed five times a second while `isRunning`. */
export function useNow(isRunning: boolean): number {
  const [now, setNow] = useState(() => Date.now());
  useEffect(() => {
    if (!isRunning) return;
    const timer = setInterval(() => setNow(Date.now()), TICK_MS);
    return () => clearInterval(timer);
  }, [isRunning]);
  return now;
}
