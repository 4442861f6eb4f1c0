/** Trails of the student's own programs, for the picture at the end of the path. */
import { CELL } from "@corridor/maze";
import type { SolvedTrail } from "../../simulator/protocol/bonus-request.ts";
import { askWorker, type AskBonus } from "./ask-bonus.ts";
import type { LessonsPorts } from "./lessons-ports.ts";
import { missionDocument } from "./mission-document.ts";
import { BONUS_SECONDS } from "./missions/bonus-missions.ts";
import { missions } from "./missions/missions.ts";

type Ports = Pick<LessonsPorts, "projects" | "storage" | "words">;

export class SolvedTrails {
  readonly #ports: Ports;
  readonly #ask: AskBonus;

  constructor(ports: Ports, ask: AskBonus = askWorker) {
    this.#ports = ports;
    this.#ask = ask;
  }

  /**
   * The trail of the last mission whose stored program reaches the goal. If none does, the result
   * has no points.
   * @throws if the worker fails to load
   */
  async last(): Promise<SolvedTrail> {
    const { projects, storage, words } = this.#ports;
    const stored = projects.list();
    const attempts = missions.toReversed().flatMap((mission) => {
      const project = stored.find(({ id }) => id === storage.record.works[mission.id]);
      const [maze] = missionDocument(mission, words).mazes;
      const isReach = mission.challenge.goal.kind === "reach";
      return project === undefined || maze === undefined || !isReach
        ? []
        : [{ maze, program: project.program }];
    });
    const answer = await this.#ask({ kind: "trail", attempts, seconds: BONUS_SECONDS });
    if (answer.kind === "trail" && answer.value !== null) return answer.value;
    const [last] = missions.slice(-1).flatMap((mission) => missionDocument(mission, words).mazes);
    if (last === undefined) throw new Error("There is no mission.");
    const { column, row } = last.start;
    const pose = { x: (column + 0.5) * CELL, y: (row + 0.5) * CELL, heading: 90 };
    return { maze: last, pose, points: [] };
  }
}
