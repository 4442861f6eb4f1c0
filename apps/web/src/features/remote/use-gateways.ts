/** The gateways that the service offers, requested once for a robot. */
import { useEffect, useState } from "react";
import type { RemoteSession } from "../../simulator/protocol/worker-messages.ts";
import { offeredGateways } from "./owner-calls.ts";

/** Their names; empty until the service has responded. */
export function useGateways({ id, ownerKey }: RemoteSession): readonly string[] {
  const [gateways, setGateways] = useState<readonly string[]>([]);
  useEffect(() => {
    let isOver = false;
    const look = async (): Promise<void> => {
      const found = await offeredGateways(fetch, { id, ownerKey });
      if (!isOver && found !== null) setGateways(found);
    };
    void look();
    return () => {
      isOver = true;
    };
  }, [id, ownerKey]);
  return gateways;
}
