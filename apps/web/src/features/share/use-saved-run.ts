/** The run so far as a document, asked of the simulator when somebody wants it. */
import { useEffect, useState } from "react";
import type { RunDocument, WrittenRun } from "@corridor/recording";
import { useServices } from "../../app/services.ts";
import { saveRun } from "../../app/run-requests.ts";

/**
 * @param isWanted false: nothing is asked, and what was asked before is forgotten
 * @returns null until it is there
 */
export function useSavedRun(isWanted: boolean): WrittenRun | null {
  const { simulator } = useServices();
  const [saved, setSaved] = useState<WrittenRun | null>(null);
  useEffect(() => {
    if (!isWanted) return;
    const end = saveRun(simulator, (answer) =>
      setSaved(answer.ok ? { ...answer, run: JSON.parse(answer.text) as RunDocument } : answer),
    );
    return () => {
      end();
      setSaved(null);
    };
  }, [simulator, isWanted]);
  return saved;
}
