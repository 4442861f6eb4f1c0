/**
 * Shows whether an opened contest maze can be solved, the rules that it breaks, and why a wall
 * follower cannot solve it. Loaded with the first contest maze.
 */
import { checkContest, contestMazeOf, isSameLayout, type MazeDocument } from "@corridor/maze";
import type { i18n } from "i18next";
import { showMessage } from "../../../model/screen/screen-store.ts";
import type { Services } from "../../../model/services.ts";
import { checkText } from "./contest-text.ts";

type Ports = Pick<Services, "screen" | "camera" | "workspace">;

export async function showCheck(
  services: Ports,
  words: Pick<i18n, "t" | "loadNamespaces">,
  maze: MazeDocument,
): Promise<void> {
  const contest = contestMazeOf(maze);
  if (!contest.ok) return;
  await words.loadNamespaces("contest");
  const check = checkContest(contest.value);
  const miss = check.wallFollowerMiss;
  showMessage(services.screen, {
    tone: "info",
    stays: true,
    isOfProject: true,
    text: checkText(words, contest.value, check),
    action:
      miss === null
        ? undefined
        : {
            label: words.t("contest:show"),
            run: () => {
              const now = services.workspace.getState().maze;
              // An edit can change the answer. A file that is opened again has equal blocks.
              const isEdited = !isSameLayout(now, maze);
              if (isEdited) void showCheck(services, words, now);
              else showMiss(services, words, { maze: now, ...miss });
            },
          },
  });
}

type Marks = NonNullable<ReturnType<Services["screen"]["getState"]>["wallMarks"]>;

/** Marks the island and the loop in the maze, and describes them. */
function showMiss({ screen, camera }: Ports, words: Pick<i18n, "t">, marks: Marks): void {
  screen.setState({ wallMarks: marks });
  // The camera of a phone shows only a part of the maze.
  camera.setState({ isWhole: true });
  const id = showMessage(screen, {
    tone: "info",
    stays: true,
    isOfProject: true,
    text: words.t(marks.island.length === 0 ? "contest:why.free" : "contest:why.island"),
    action: { label: words.t("contest:hide"), run: () => screen.setState({ wallMarks: null }) },
  });
  const stop = screen.subscribe(({ messages }) => {
    if (messages.some((each) => each.id === id)) return;
    stop();
    if (screen.getState().wallMarks === marks) screen.setState({ wallMarks: null });
  });
}
