/** French. */
import type { Words } from "../en/words.ts";

export const files = import.meta.glob<Words>(
  [
    "./*.json",
    "!./check.json",
    "!./code.json",
    "!./connect.json",
    "!./contest.json",
    "!./diagnosis.json",
    "!./embed.json",
    "!./missions.json",
    "!./other-mazes.json",
    "!./run-details.json",
    "!./print.json",
    "!./race.json",
    "!./report.json",
    "!./daily.json",
    "!./dashboard.json",
    "!./sound.json",
    "!./join.json",
    "!./names.json",
    "!./lesson-editor.json",
    "!./teach.json",
    "!./watch.json",
  ],
  {
    eager: true,
    import: "default",
  },
);
