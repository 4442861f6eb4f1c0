/** The race in a file of its own, with the reader of completion codes. */
import { lazyPart } from "../../ui/lazy-part.tsx";

export const LazyRaceView = lazyPart(async () => (await import("./RaceView.tsx")).RaceView);
