/** The parts of the lessons, which load together when a mission opens. */
import { pageAddressBar, type AddressBar } from "../address/lesson-address.ts";
import { Attempt } from "./attempt.ts";
import { BonusChecker } from "./bonus-checker.ts";
import { startChecker, type ChallengeChecker } from "./challenge-checker.ts";
import { LessonsNavigation } from "./lessons-navigation.ts";
import type { LessonsPorts } from "./lessons-ports.ts";
import { LessonsProgress } from "./lessons-progress.ts";
import { SolvedTrails } from "./solved-trails.ts";
import { StoredLessons } from "./stored-lessons.ts";

export class LessonsService {
  readonly progress: LessonsProgress;
  readonly trails: SolvedTrails;
  /** the open bonus mission, checked whenever it changes */
  readonly bonus: BonusChecker;
  readonly attempt: Attempt;
  readonly navigation: LessonsNavigation;

  constructor(
    ports: LessonsPorts,
    checker: ChallengeChecker = ports.own?.checker ?? startChecker(),
    bar: AddressBar = ports.own?.bar ?? pageAddressBar(),
  ) {
    this.progress = new LessonsProgress(ports);
    this.trails = new SolvedTrails(ports);
    this.bonus = new BonusChecker(ports, this.progress);
    const lessons = new StoredLessons(ports.device);
    lessons.sweep();
    this.attempt = new Attempt(ports, this.progress, lessons, checker);
    this.navigation = new LessonsNavigation(ports, this.attempt, lessons, bar);
  }
}
