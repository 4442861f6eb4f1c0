/** Violations of the layers in apps/web that the restructuring has still to remove. */
export const webExceptions = {
  imports: [
    "features/cards -> features/race",
    "features/cards -> features/share",
    "features/files -> features/race",
    "features/maze-editor -> features/cards",
    "features/maze-editor -> features/lessons",
    "features/maze-editor -> features/race",
    "features/maze-editor -> features/sound",
    "features/maze-editor -> features/speech",
    "features/presets -> features/program-editor",
    "features/program-editor -> features/other-mazes",
    "features/projects -> features/files",
    "features/timeline -> features/race",
    "features/transport -> features/program-editor",
    "features/transport -> features/timeline",
    "features/watch -> features/drive",
    "features/watch -> features/language",
    "features/watch -> features/theme",
  ],
  circles: [],
};
