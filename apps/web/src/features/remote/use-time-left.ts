/** Whole seconds until a time, updated once a second. */
import { useEffect, useState } from "react";

/** @param endsAt ms by `performance.now()` */
export function useTimeLeft(endsAt: number): number {
  const [left, setLeft] = useState(() => secondsUntil(endsAt));
  useEffect(() => {
    const look = (): void => setLeft(secondsUntil(endsAt));
    look();
    const timer = setInterval(look, 1_000);
    return () => clearInterval(timer);
  }, [endsAt]);
  return left;
}

function secondsUntil(endsAt: number): number {
  return Math.max(0, Math.ceil((endsAt - performance.now()) / 1_000));
}
