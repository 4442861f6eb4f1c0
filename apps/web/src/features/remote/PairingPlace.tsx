/** Where a script's question comes up. Only a page whose robot scripts can reach has it. */
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { lazyPart } from "../../ui/lazy-part.tsx";

const PairingCall = lazyPart(async () => (await import("./PairingCall.tsx")).PairingCall);

export function PairingPlace() {
  const session = useStore(useServices().remote, (state) => state.session);
  return session && <PairingCall session={session} />;
}
