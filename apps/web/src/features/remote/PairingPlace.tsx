/** The place of a script's question. Only a page with a remote session renders it. */
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { deferredPart } from "../../ui/lazy-part.tsx";

const PairingCall = deferredPart(async () => (await import("./PairingCall.tsx")).PairingCall);

export function PairingPlace() {
  const session = useStore(useServices().remote, (state) => state.session);
  return session && <PairingCall isWanted session={session} />;
}
