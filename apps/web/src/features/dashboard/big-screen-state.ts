import type { LessonDocument } from "@corridor/challenge/document";
import type { ScreenContent } from "@corridor/protocol";

export interface BigScreenState {
  status: "connecting" | "connected" | "lost" | "over";
  /** null before the first connection */
  code: string | null;
  lesson: LessonDocument | null;
  /** null: no dashboard has sent any yet */
  content: ScreenContent | null;
  /** whether this page can read the newest lesson and content: other parts may be newer or older */
  isLessonReadable: boolean;
  isContentReadable: boolean;
}
