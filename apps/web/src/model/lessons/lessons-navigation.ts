/**
 * Opens missions, shared challenges and their mazes, and returns to the maze from before. Each
 * challenge has its own project, so that other projects stay unchanged.
 */
import { rightsOf, startingProgram, type ChallengeDocument } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import { MissionAddress, type AddressBar } from "../address/mission-address.ts";
import { noChallenge } from "../challenge/challenge-store.ts";
import { firstProject } from "../projects/first-visit.ts";
import { showMessage } from "../screen/screen-store.ts";
import { setMaze } from "../workspace/workspace-store.ts";
import type { Attempt } from "./attempt.ts";
import { readChallengeText, writeChallengeText } from "./challenge-text.ts";
import type { LessonsPorts } from "./lessons-ports.ts";
import { mazeIndex } from "./maze-index.ts";
import { missionDocument } from "./mission-document.ts";
import { bonusMissions } from "./missions/bonus-missions.ts";
import { missions } from "./missions/missions.ts";
import { reportUnlessStored } from "./report-unless-stored.ts";

/** Everything that an address can name. */
const tasks = [...missions, ...bonusMissions];

export class LessonsNavigation {
  readonly #ports: LessonsPorts;
  readonly #attempt: Pick<Attempt, "begin">;
  readonly #address: MissionAddress;
  /** id of the project with the open challenge */
  #projectId: string | null = null;
  /** reopens what was open before the first mission, even if it was never stored */
  #backAction: (() => void) | null = null;

  constructor(ports: LessonsPorts, attempt: Pick<Attempt, "begin">, bar: AddressBar) {
    this.#ports = ports;
    this.#attempt = attempt;
    this.#address = new MissionAddress(ports.challenge, bar, () => this.goHome());
    ports.workspace.subscribe((next, before) => {
      if (next.maze !== before.maze) this.#followMaze(next.maze);
    });
  }

  /**
   * Opens the mission that an address names. A mission that is already open stays as it is, with
   * its run.
   * @returns whether the mission exists
   */
  follow(id: string): boolean {
    const { storage, projects } = this.#ports;
    if (storage.missionOf(projects.currentId()) !== id) return this.openMission(id);
    this.sync();
    return true;
  }

  /**
   * Opens a mission where the student left it, or from its start.
   * @returns whether the mission exists
   */
  openMission(id: string): boolean {
    const mission = tasks.find((each) => each.id === id);
    if (mission === undefined) return false;
    this.#address.opening();
    const { storage, projects } = this.#ports;
    const challenge = missionDocument(mission, this.#ports.words);
    const attempt = projects.list().find((project) => project.id === storage.record.works[id]);
    this.#leaveHome();
    const [maze] = challenge.mazes;
    if (attempt !== undefined) projects.open(attempt);
    else if (maze !== undefined) {
      projects.beginNew(maze, startingProgram(challenge));
      reportUnlessStored(this.#ports, storage.add({ works: { [id]: projects.currentId() } }));
    }
    this.#start(challenge, id);
    return true;
  }

  /** Opens a shared challenge in its own project. */
  openShared(challenge: ChallengeDocument, program: ProgramDocument | null): void {
    const { projects, storage } = this.#ports;
    const [maze] = challenge.mazes;
    if (maze === undefined) return;
    this.#leaveHome();
    projects.beginNew(maze, program ?? startingProgram(challenge));
    const text = writeChallengeText(challenge);
    const isStored = text !== null && storage.storeChallenge(projects.currentId(), text);
    reportUnlessStored(this.#ports, isStored);
    this.#start(challenge, null);
  }

  /** Loads the challenge of the open project, if it has one. The robot stays where it is. */
  sync(): void {
    const { projects, storage } = this.#ports;
    const id = storage.missionOf(projects.currentId());
    const mission = tasks.find((each) => each.id === id);
    if (mission !== undefined) {
      this.#show(missionDocument(mission, this.#ports.words), mission.id);
      return;
    }
    const text = storage.challengeOf(projects.currentId());
    const challenge = text === null ? null : readChallengeText(text);
    if (challenge !== null) this.#show(challenge, null);
  }

  /** Offers control to the driver of the open challenge, unless a run has already started. */
  handOver(): void {
    const { challenge, simulator } = this.#ports;
    const driver = challenge.getState().challenge?.allowed.drivers[0];
    if (driver !== undefined) simulator.send({ type: "offer-driver", driver });
  }

  /** Shows another maze of the challenge. The program stays. */
  showMaze(index: number): void {
    const { challenge, workspace, simulator } = this.#ports;
    const maze = challenge.getState().challenge?.mazes[index];
    if (maze === undefined) return;
    // The run of the other maze ends first: this maze must not be judged by it.
    simulator.send({ type: "reset" });
    setMaze(workspace, { ...maze, name: workspace.getState().maze.name });
  }

  /** Reopens what was open before the first mission. The missions stay on the device. */
  goHome(): void {
    const { projects, storage, words } = this.#ports;
    const home = projects.list().find((project) => project.id === storage.record.home);
    const goBack = this.#backAction;
    this.#backAction = null;
    // `#backAction` also restores edits that were never stored.
    if (goBack !== null) goBack();
    else if (home !== undefined) projects.open(home);
    else {
      const { maze, program } = firstProject(words);
      projects.begin(maze, program);
    }
    this.#ports.simulator.send({ type: "driver", driver: "program" });
  }

  /** Records the student's own project before the first mission opens. */
  #leaveHome(): void {
    const { projects, challenge, storage } = this.#ports;
    if (challenge.getState().challenge !== null) return;
    this.#backAction = projects.backAction();
    reportUnlessStored(this.#ports, storage.add({ home: projects.currentId() }));
  }

  #start(challenge: ChallengeDocument, mission: string | null): void {
    const { simulator } = this.#ports;
    const [driver = "program"] = challenge.allowed.drivers;
    simulator.send({ type: "driver", driver });
    this.#show(challenge, mission);
  }

  #show(challenge: ChallengeDocument, mission: string | null): void {
    const { challenge: store, workspace } = this.#ports;
    const index = mazeIndex(challenge, workspace.getState().maze);
    // If the maze is editable, it may match none of the challenge's mazes.
    const maze = index ?? (challenge.allowed.maze ? 0 : null);
    if (maze === null) {
      this.#detach();
      return;
    }
    this.#projectId = this.#ports.projects.currentId();
    this.#attempt.begin(challenge, maze, mission);
    const rights = rightsOf(challenge);
    store.setState({ ...noChallenge, challenge, mission, maze, rights, isInvited: false });
  }

  /**
   * Handles a maze change: another maze of the challenge, or an edit that makes the project
   * something else.
   */
  #followMaze(maze: MazeDocument): void {
    const { challenge: store, projects, screen, words } = this.#ports;
    const { challenge, maze: shown } = store.getState();
    if (challenge === null || projects.currentId() !== this.#projectId) return;
    const index = mazeIndex(challenge, maze);
    if (index === null && challenge.allowed.maze) return;
    if (index === null) {
      this.#detach();
      showMessage(screen, { tone: "info", text: words.t("missions:card.replaced") });
    } else if (index !== shown) {
      this.#attempt.begin(challenge, index, store.getState().mission);
      store.setState({ maze: index, failedRun: null, result: { state: "open" } });
    }
  }

  /** Removes the challenge from the open project. */
  #detach(): void {
    const { projects, storage, challenge } = this.#ports;
    const id = projects.currentId();
    reportUnlessStored(this.#ports, storage.removeAttempt(id));
    storage.deleteChallenge(id);
    challenge.setState(noChallenge);
  }
}
