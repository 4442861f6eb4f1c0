/** The controls of the run, with its timeline and the controls of the past. */
import { TimelineBar } from "../features/timeline/TimelineBar.tsx";
import { Transport } from "../features/transport/Transport.tsx";
import { deferredPart } from "../ui/lazy-part.tsx";

const PastControls = deferredPart(async () => (await import("./PastControls.tsx")).PastControls);

export function RunControls() {
  return <Transport timeline={<TimelineBar />} past={<PastControls isWanted />} />;
}
