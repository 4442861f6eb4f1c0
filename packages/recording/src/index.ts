export type { RunDocument } from "./run-document.ts";
export { type RunInput, type TimedInput } from "./run-input.ts";
export {
  Timeline,
  turnNames,
  type TimelineEvent,
  type TimelineNews,
  type TurnName,
  type Who,
} from "./timeline.ts";
