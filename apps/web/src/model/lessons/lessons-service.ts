/** The parts of the lessons, which load together when a mission opens. */
import { createWorkerPool } from "../../simulator/worker-pool.ts";
import { pageAddressBar, type AddressBar } from "../address/lesson-address.ts";
import { Attempt } from "./attempt.ts";
import { BonusChecker } from "./bonus-checker.ts";
import { RunWatcher } from "./run-watcher.ts";
import { LessonsNavigation } from "./lessons-navigation.ts";
import type { LessonsPorts } from "./lessons-ports.ts";
import { LessonsProgress } from "./lessons-progress.ts";
import { ProgramCheck } from "./program-check.ts";
import { SolvedTrails } from "./solved-trails.ts";
import { StoredLessons } from "./stored-lessons.ts";

export class LessonsService {
  readonly progress: LessonsProgress;
  readonly trails: SolvedTrails;
  /** the open bonus mission, checked whenever it changes */
  readonly bonus: BonusChecker;
  /** the check of the program in all mazes of the open task */
  readonly check: ProgramCheck;
  readonly attempt: Attempt;
  readonly navigation: LessonsNavigation;
  readonly watcher: RunWatcher;

  constructor(
    ports: LessonsPorts,
    check: ProgramCheck = new ProgramCheck(
      ports.own?.pool ?? createWorkerPool(),
      (action, milliseconds) => setTimeout(action, milliseconds),
    ),
    bar: AddressBar = ports.own?.bar ?? pageAddressBar(),
  ) {
    this.progress = new LessonsProgress(ports);
    this.trails = new SolvedTrails(ports);
    this.bonus = new BonusChecker(ports, this.progress);
    const lessons = new StoredLessons(ports.device);
    lessons.sweep();
    this.check = check;
    this.attempt = new Attempt(ports, this.progress, lessons, check);
    this.navigation = new LessonsNavigation(ports, this.attempt, lessons, bar);
    this.watcher = new RunWatcher(ports, check.pool, this.navigation);
  }
}
