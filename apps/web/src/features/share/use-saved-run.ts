import { useEffect, useState } from "react";
import type { RunDocument, WrittenRun } from "@corridor/recording";
import { useServices } from "../../model/use-services.ts";
import { saveRun } from "../../model/run/run-requests.ts";

/**
 * The run so far as a document. The hook requests it from the simulator on demand.
 * @param isWanted false: requests nothing and discards the last answer
 * @returns null until the document arrives
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
