/**
 * The namespaces of the texts. The compiler checks keys of `t` against the English files. "words"
 * contains the texts of the page itself. Texts that only some users need are separate namespaces,
 * loaded on first use: `useTranslation("missions")`.
 */
import type { en } from "./en/index.ts";
import type check from "./en/check.json";
import type code from "./en/code.json";
import type connect from "./en/connect.json";
import type contest from "./en/contest.json";
import type lessonEditor from "./en/lesson-editor.json";
import type dashboard from "./en/dashboard.json";
import type diagnosis from "./en/diagnosis.json";
import type embed from "./en/embed.json";
import type join from "./en/join.json";
import type missions from "./en/missions.json";
import type names from "./en/names.json";
import type otherMazes from "./en/other-mazes.json";
import type runDetails from "./en/run-details.json";
import type print from "./en/print.json";
import type race from "./en/race.json";
import type report from "./en/report.json";
import type daily from "./en/daily.json";
import type sound from "./en/sound.json";
import type teach from "./en/teach.json";
import type watch from "./en/watch.json";

export interface Namespaces {
  words: typeof en;
  /** checks of attempts in all mazes of a task */
  check: typeof check;
  /** the program as code */
  code: typeof code;
  /** programs that connect to the robot */
  connect: typeof connect;
  /** contest mazes */
  contest: typeof contest;
  /** the dashboard and the big screen of a class */
  dashboard: typeof dashboard;
  /** why a run failed */
  diagnosis: typeof diagnosis;
  /** the page in a frame of another site, and the code of the frame */
  embed: typeof embed;
  /** a student in a class: the page to join, and the class menu */
  join: typeof join;
  /** the lessons */
  missions: typeof missions;
  /** the words that students get as names in a class */
  names: typeof names;
  /** "Try it in other mazes" */
  otherMazes: typeof otherMazes;
  /** texts that the controls of a run need only in use: taking over, zoom, commands */
  runDetails: typeof runDetails;
  /** printing worksheets and mazes */
  print: typeof print;
  /** races against recorded runs */
  race: typeof race;
  /** the report of a class */
  report: typeof report;
  /** the maze of the day */
  daily: typeof daily;
  /** sounds of the run */
  sound: typeof sound;
  /** the lesson editor */
  lessonEditor: typeof lessonEditor;
  /** the pages for teachers */
  teach: typeof teach;
  /** the page of a viewer */
  watch: typeof watch;
}

export type Namespace = keyof Namespaces;
