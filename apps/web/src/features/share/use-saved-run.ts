/** The run so far as a document, asked of the simulator when somebody wants it. */
import { useEffect, useState } from "react";
import type { WrittenRun } from "@corridor/recording";
import { useServices } from "../../app/services.ts";

/**
 * @param isWanted false: nothing is asked, and what was asked before is forgotten
 * @returns null until it is there
 */
export function useSavedRun(isWanted: boolean): WrittenRun | null {
  const { simulator } = useServices();
  const [saved, setSaved] = useState<WrittenRun | null>(null);
  useEffect(() => {
    if (!isWanted) return;
    const end = simulator.listen((message) => {
      if (message.type === "run-saved") setSaved(message.saved);
    });
    simulator.send({ type: "save-run" });
    return () => {
      end();
      setSaved(null);
    };
  }, [simulator, isWanted]);
  return saved;
}
