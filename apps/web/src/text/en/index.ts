/** English: the catalogue that every other language is checked against. One file a feature. */
import cards from "./cards.json" with { type: "json" };
import drive from "./drive.json" with { type: "json" };
import files from "./files.json" with { type: "json" };
import language from "./language.json" with { type: "json" };
import lessons from "./lessons.json" with { type: "json" };
import offline from "./offline.json" with { type: "json" };
import phone from "./phone.json" with { type: "json" };
import presets from "./presets.json" with { type: "json" };
import program from "./program.json" with { type: "json" };
import projects from "./projects.json" with { type: "json" };
import remote from "./remote.json" with { type: "json" };
import share from "./share.json" with { type: "json" };
import shell from "./shell.json" with { type: "json" };
import speech from "./speech.json" with { type: "json" };
import stage from "./stage.json" with { type: "json" };
import theme from "./theme.json" with { type: "json" };
import timeline from "./timeline.json" with { type: "json" };

export const en = {
  cards,
  drive,
  files,
  language,
  lessons,
  offline,
  phone,
  presets,
  program,
  projects,
  remote,
  share,
  shell,
  speech,
  stage,
  theme,
  timeline,
};
